// The sweep by its conditions: three charts of one figure over the cases that the filters leave.

import "./explore/explore.css";
import { makeFrame } from "../chart/frame";
import { h } from "../dom";
import { matching } from "../filters";
import { counted } from "../numbers";
import type { Page, View } from "../view";
import { caseTable } from "./case_table";
import { controls } from "./explore/controls";
import { distribution } from "./explore/distribution";
import { filterBar } from "./explore/filter_bar";
import { multiples } from "./explore/multiples";
import { pairedChart } from "./explore/paired_chart";
import { shownOf } from "./explore/shown";
import { addressOf, figuresOf, readState, usualState, type ExploreState } from "./explore/state";

const TITLE = "Explore";

export function explore(page: Page): View {
  const { cases, report } = page;
  if (!cases.count || !figuresOf(cases).length) {
    const why = cases.count ? "The result file has no figures of its cases." : "The result file has no cases.";
    return { title: TITLE, element: h("section", { class: "explore" }, h("h1", {}, TITLE), h("p", { class: "empty" }, why)) };
  }
  const usual = usualState(cases, report.labels);
  const { state: start, wrong } = readState(location.hash, cases, report.labels);
  let state = start;
  let waiting: ReturnType<typeof setTimeout> | undefined;
  const [overConditions, overValues, ofPairs] = [makeFrame(), makeFrame(), makeFrame()];
  const chosen = h("section", { class: "chosen", "aria-live": "polite" });
  const choose = (rows: number[], what: string) => {
    chosen.replaceChildren(h("h2", {}, `${counted(rows.length, "case")}: ${what}`), caseTable(page, rows, [state.figure]));
    chosen.scrollIntoView({ block: "nearest" });
  };
  const change = (part: Partial<ExploreState>) => {
    state = { ...state, ...part };
    history.replaceState(null, "", addressOf(state, usual));
    update();
  };
  const bar = filterBar(cases, report.labels, (filters) => change({ filters }));
  const split = controls(cases, change);
  const two = pairPicker(report.labels, change);
  const update = () => {
    const rows = matching(cases, state.filters);
    const shown = shownOf(page, state, rows, choose);
    bar.update(state.filters, rows.length);
    split.update(state);
    two.update(state);
    chosen.replaceChildren();
    overConditions.show(multiples(shown));
    clearTimeout(waiting);
    waiting = setTimeout(() => {
      // the first chart is there before what is further down the page is worked out
      overValues.show(distribution(shown));
      ofPairs.show(pairedChart(shown));
    });
  };
  const unknown = wrong.length ? [h("p", { role: "alert", class: "chart-warning" }, `The address asks for what this report does not have: ${wrong.join(", ")}.`)] : [];
  const element = h(
    "section",
    { class: "explore" },
    h("h1", {}, TITLE),
    ...unknown,
    bar.element,
    split.element,
    overConditions.element,
    chosen,
    overValues.element,
    ...(report.labels.length > 1 ? [two.element, ofPairs.element] : []),
  );
  update();
  return { title: TITLE, element, dispose: () => clearTimeout(waiting) };
}

function pairPicker(labels: string[], change: (part: Partial<ExploreState>) => void) {
  const select = (name: "a" | "b") => {
    const made = h("select", {}, ...labels.map((label) => h("option", { value: label }, label)));
    made.addEventListener("change", () => change({ [name]: made.value }));
    return made;
  };
  const [a, b] = [select("a"), select("b")];
  const swap = h("button", { type: "button", class: "plain", click: () => change({ a: b.value, b: a.value }) }, "swap");
  return {
    element: h("div", { class: "controls pair-picker" }, h("label", {}, "pairs of strategy A", a), h("label", {}, "minus strategy B", b), swap),
    update(state: ExploreState) {
      a.value = state.a;
      b.value = state.b;
    },
  };
}
