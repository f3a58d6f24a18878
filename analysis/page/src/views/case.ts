// One case: what was run, how it ended, its figures, its series, where it comes from and how to run it again.

import "./case/case.css";
import "./explore/explore.css";
import { swatch } from "../chart/legend";
import { styleOfLabel } from "../chart/palette";
import { saveFile } from "../chart/save";
import { h } from "../dom";
import { counted } from "../numbers";
import type { Page, View } from "../view";
import { caseList } from "./case/case_list";
import { rerunArguments, shellText, sweepFile, UNKNOWN } from "./case/command";
import { seriesPanel, type SeriesPanel } from "./case/series_panel";
import { siblingsOf } from "./case/siblings";
import { copyButton } from "./copyable";

/** @param asked the case's id or how it begins; "" for a list of all */
export function caseView(page: Page, asked: string): View {
  const { cases } = page;
  if (!asked) return { title: "Cases", element: caseList(page) };
  const exact = cases.row(asked);
  const found = exact !== undefined ? [exact] : rowsThatBegin(page, asked);
  if (found.length !== 1) {
    const note = found.length ? `${counted(found.length, "case")} begin with ${asked}: choose one.` : `This report has no case ${asked}: choose one.`;
    return { title: "Cases", element: caseList(page, note) };
  }
  return oneCase(page, found[0]!);
}

function rowsThatBegin({ cases }: Page, asked: string): number[] {
  return Array.from({ length: cases.count }, (_, row) => row).filter((row) => cases.text("case_id", row).startsWith(asked));
}

function oneCase(page: Page, row: number): View {
  const { cases, report } = page;
  const caseId = cases.text("case_id", row);
  const label = cases.text("label", row);
  const siblings = siblingsOf(cases, report.labels, row);
  const series = h("div", {});
  let panel: SeriesPanel | undefined;
  let isGone = false;
  const held = [caseId, ...siblings.map((other) => cases.text("case_id", other)).filter((other) => other !== caseId)].filter((one) => report.series.cases[one]);
  if (held[0] !== caseId) series.append(h("p", { class: "empty" }, whyNoSeries(page)));
  else
    void seriesPanel(page, held).then((made) => {
      if (isGone) return made.dispose();
      panel = made;
      series.replaceChildren(made.element);
    }, (error: unknown) => series.append(h("p", { role: "alert", class: "chart-warning" }, String(error))));
  const element = h(
    "section",
    { class: "explore case" },
    h("p", {}, h("a", { href: "#/case" }, "← all cases")),
    h("h1", {}, swatch(styleOfLabel(report.labels, label)), label),
    h("p", { class: "case-id" }, caseId),
    outcome(page, row),
    part("What was run", conditions(page, row)),
    part("Under the same conditions", siblingTable(page, row, siblings)),
    part("Run it again", command(page, row)),
    part("Series", series),
    part("Figures", figures(page, row)),
    part("Where it comes from", provenance(page, row)),
  );
  return {
    title: `${label} ${caseId.slice(0, 8)}`,
    element,
    dispose() {
      isGone = true;
      panel?.dispose();
    },
  };
}

function part(title: string, ...content: Node[]): HTMLElement {
  return h("section", {}, h("h2", {}, title), ...content);
}

function whyNoSeries({ report }: Page): string {
  const held = Object.keys(report.series.cases).length;
  if (!held) return "This report holds no series of cases.";
  return `The series of this case are not among those of ${counted(held, "case")} that this report holds: a larger --budget takes more.`;
}

function outcome({ cases }: Page, row: number): HTMLElement {
  const status = cases.text("status", row);
  const reason = cases.columns.has("reason") ? cases.text("reason", row) : "";
  const badge = h("strong", { class: status === "complete" ? "badge" : "badge failed" }, status);
  return h("p", {}, badge, reason ? ` ${reason}` : "");
}

const LONG = 60; // letters: what is longer has a line of its own

function list(entries: [string, string][]): HTMLElement {
  const entry = ([name, value]: [string, string]) => h("div", value.length > LONG ? { class: "long" } : {}, h("dt", {}, name), h("dd", {}, value.replaceAll(",", ",\u200b")));
  return h("dl", { class: "facts" }, ...entries.map(entry));
}

const ELSEWHERE = ["case_id", "label", "status", "reason", "options", "provenance_row"];

/** The conditions and the strategy with its options: what makes this case another one than the others. */
function conditions(page: Page, row: number): HTMLElement {
  const { cases } = page;
  const given = cases.columns.has("options") ? Object.entries(JSON.parse(cases.text("options", row) || "{}") as Record<string, unknown>) : [];
  const names = ["strategy", ...[...cases.columns.values()].filter(({ part }) => part === "condition").map(({ name }) => name)];
  const options = given.map(([name, value]): [string, string] => [`option ${name}`, typeof value === "string" ? value.split("\n")[0]! : JSON.stringify(value)]);
  return list([...names.filter((name) => cases.columns.has(name)).map((name) => fact(page, name, row)), ...options]);
}

function fact({ cases }: Page, name: string, row: number): [string, string] {
  const unit = cases.columns.get(name)!.unit;
  return [name, `${cases.text(name, row) || "–"}${unit ? ` ${unit}` : ""}`];
}

function siblingTable(page: Page, row: number, siblings: number[]): HTMLElement {
  const { cases, report } = page;
  if (siblings.length < 2) return h("p", {}, "No other case of this file has the same conditions.");
  const recorded = new Set(report.replays.map(({ caseId }) => caseId));
  const ids = siblings.map((other) => cases.text("case_id", other));
  const items = siblings.map((other, k) => {
    const label = cases.text("label", other);
    const status = cases.text("status", other);
    const name = other === row ? h("strong", {}, `${label} (this case)`) : h("a", { href: `#/case/${ids[k]}` }, label);
    const mark = swatch(styleOfLabel(report.labels, label));
    const notes = [status === "complete" ? "" : status, report.series.cases[ids[k]!] ? "" : "series not in this report"].filter(Boolean).join(", ");
    return h("li", {}, mark, name, ...(notes ? [h("span", { class: "chart-note" }, ` ${notes}`)] : []));
  });
  const replays = ids.filter((id) => recorded.has(id)).slice(0, 6);
  const link = replays.length ? [h("p", {}, h("a", { href: `#/replay/${replays.join()}` }, `Replay of ${counted(replays.length, "case")} side by side`))] : [];
  return h("div", {}, h("ul", { class: "siblings" }, ...items), ...link);
}

function command(page: Page, row: number): HTMLElement {
  const { report, cases } = page;
  const line = String(provenanceOf(page, row)?.argv ?? "");
  const text = shellText(rerunArguments(report, cases, row, line));
  const breaks = text.split(/ (?=-)/); // a line ends in front of an option, not within it
  const code = h("code", { class: "command" }, ...breaks.flatMap((word, k) => [k ? " " : "", h("span", { class: "word" }, word)]));
  const file = sweepFile(line);
  const save = () => saveFile((file ?? UNKNOWN).split("/").at(-1)!, "text/plain", report.sweepToml);
  const where = file
    ? `From the folder in which the sweep was run, where ${file} is. Another program, or a changed sweep file, may run another case: its case_id says so.`
    : `The cases are of no one sweep file (${line || "the result file does not say how they were run"}): put in place of ${UNKNOWN} the one that has this case.`;
  return h(
    "div",
    {},
    h("div", { class: "command-line" }, code, ...copyButton(text, code, "the command")),
    h("p", { class: "chart-note" }, `${where} Add --replay to record it. `, ...(report.sweepToml ? [h("button", { type: "button", class: "plain", click: save }, file ? "Save the sweep file" : "Save its sweeps")] : [])),
  );
}

function figures({ cases }: Page, row: number): HTMLElement {
  const rows = [...cases.columns.values()]
    .filter(({ role }) => role === "figure")
    .map(({ name, unit, better, longName }) => {
      const value = cases.number(name, row);
      const said = Number.isNaN(value) ? `none: ${cases.why(name, row) || "no reason recorded"}` : String(value);
      return h("tr", {}, h("th", { scope: "row" }, name), h("td", { class: "number" }, said), h("td", {}, unit), h("td", {}, better === "low" ? "↓ lower" : better === "high" ? "↑ higher" : ""), h("td", { class: "words" }, longName));
    });
  const head = h("thead", {}, h("tr", {}, ...["figure", "value", "unit", "better", "what it is"].map((name) => h("th", { scope: "col" }, name))));
  const body = h("tbody", {}, ...rows);
  const search = h("input", { type: "search", "aria-label": "search figures", placeholder: "search figures" });
  search.addEventListener("input", () => rows.forEach((line) => (line.hidden = !line.textContent!.includes(search.value))));
  const table = h("table", { class: "cases figures" }, head, body);
  return h("div", {}, h("div", { class: "controls" }, h("label", {}, search)), h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "figures" }, table));
}

function provenanceOf({ report, cases }: Page, row: number): Record<string, string | number> | undefined {
  return cases.columns.has("provenance_row") ? report.provenance[cases.number("provenance_row", row)] : undefined;
}

function provenance(page: Page, row: number): HTMLElement {
  const others = [...page.cases.columns.values()].filter(({ role, part, name }) => role !== "figure" && !part && name !== "strategy" && !ELSEWHERE.includes(name));
  const way = Object.entries(provenanceOf(page, row) ?? {}).filter(([name]) => name !== "case_id" && name !== "cases");
  const facts = list([...others.map(({ name }) => fact(page, name, row)), ...way.map(([name, value]): [string, string] => [name, String(value)])]);
  return way.length ? facts : h("div", {}, facts, h("p", {}, "The result file does not say which program on which machine ran this case."));
}
