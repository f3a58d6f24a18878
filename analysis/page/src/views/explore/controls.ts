// Which figure is shown, and how the charts are split.

import type { Cases } from "../../cases";
import { h } from "../../dom";
import { figuresOf, splitColumns, usualFigures, type ExploreState } from "./state";

export interface Controls {
  element: HTMLElement;
  update(state: ExploreState): void;
}

type Choice = "x" | "across" | "down" | "form" | "scale";

export function controls(cases: Cases, change: (part: Partial<ExploreState>) => void): Controls {
  const columns = ["", ...splitColumns(cases)];
  const named = (name: string): [string, string] => [name, name || "(nothing)"];
  const choices: [Choice, string, [string, string][]][] = [
    ["x", "along x", columns.map(named)],
    ["across", "panels across", columns.map(named)],
    ["down", "panels down", columns.map(named)],
    ["form", "show", [["medians", "medians and quartiles"], ["cases", "every case"]]],
    ["scale", "scale", [["linear", "linear"], ["log", "logarithmic"]]],
  ];
  const selects = choices.map(([name, title, options]) => {
    const select = h("select", {}, ...options.map(([value, text]) => h("option", { value }, text)));
    select.addEventListener("change", () => change({ [name]: select.value }));
    return { name, select, element: h("label", {}, title, select) };
  });
  const picker = figurePicker(cases, (figure) => change({ figure }));
  return {
    element: h("div", { class: "controls" }, picker.element, ...selects.map(({ element }) => element)),
    update(state) {
      picker.update(state.figure);
      for (const { name, select } of selects) select.value = state[name];
    },
  };
}

/** All figures, with search: names and what they are. */
function figurePicker(cases: Cases, change: (figure: string) => void) {
  const figures = figuresOf(cases);
  const words = (name: string) => cases.columns.get(name)!.longName;
  const list = h("datalist", { id: "figures" }, ...figures.map((name) => h("option", { value: name }, words(name))));
  const input = h("input", { type: "search", list: "figures", autocomplete: "off", spellcheck: "false", class: "figure-name" });
  const wrong = h("span", { class: "chart-warning", role: "alert" });
  let shown = "";
  const take = () => {
    const asked = input.value.trim();
    const found = figures.includes(asked) ? [asked] : figures.filter((name) => name.includes(asked) || words(name).includes(asked));
    if (found.length === 1 || found[0] === asked) return change(found[0]!);
    if (asked === "") return void (input.value = shown);
    wrong.textContent = found.length ? `${found.length} figures match: ${found.slice(0, 6).join(", ")}…` : `no figure is called ${asked}`;
  };
  input.addEventListener("change", take);
  input.addEventListener("input", () => figures.includes(input.value) && take());
  input.addEventListener("focus", () => input.select());
  const usual = usualFigures(cases).map((name) => {
    const button = h("button", { type: "button", class: "chip", title: words(name), click: () => change(name) }, name);
    return { name, button };
  });
  return {
    element: h(
      "div",
      { class: "figure-picker" },
      h("label", {}, `figure, of ${figures.length}`, input),
      list,
      h("div", { class: "chips" }, ...usual.map(({ button }) => button)),
      wrong,
    ),
    update(figure: string) {
      wrong.textContent = "";
      shown = input.value = figure;
      input.title = words(figure);
      for (const { name, button } of usual) button.setAttribute("aria-pressed", String(name === figure));
    },
  };
}
