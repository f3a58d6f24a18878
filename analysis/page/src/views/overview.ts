// The overview: the question and the answer in words, the strategies ranked, the paper's claims, what less penetration costs,
// and which strategies the ranks tell apart.

import "./overview/overview.css";
import { h } from "../dom";
import { counted, grouped } from "../numbers";
import type { Page, View } from "../view";
import type { Comparison } from "./overview_data";
import { claimsSection } from "./overview/claims_section";
import { criticalDifference } from "./overview/critical_difference";
import { frontChart } from "./overview/front_chart";
import { rankedTable } from "./overview/ranked_table";
import { chartFrame } from "../chart/frame";

export function overview(page: Page): View {
  const { report } = page;
  const { question, answer, comparisons, cautions } = report.overview;
  const element = h(
    "section",
    { class: "overview" },
    h("p", { class: "eyebrow" }, sizeWords(page)),
    h("h1", {}, question),
    answerElement(answer),
    ...cautions.map((caution) => h("p", { class: "notice" }, caution)),
    part("strategies", "The strategies", rankedTable(report), ...leftOut(page)),
    ...failures(page),
    part("claims", "The paper's claims", ...claimsSection(report.overview.claims)),
    part("front", "What less penetration costs in time", frontChart(report)),
    part(
      "ranks",
      "Which strategies the ranks tell apart",
      h("p", { class: "lead" }, "Strategies are ranked within blocks: a seed on an organ. A bar joins those whose mean ranks differ by less than the critical difference (CD): the file does not tell them apart."),
      h("div", { class: "diagrams" }, ...comparisons.filter(({ ranks }) => ranks).map((one) => chartFrame(criticalDifference(report, one)))),
      ...unranked(comparisons),
    ),
  );
  return { title: "Overview", element };
}

function part(id: string, title: string, ...content: (Node | string)[]): HTMLElement {
  return h("section", { class: "part", "aria-labelledby": `${id}-title` }, h("h2", { id: `${id}-title` }, title), ...content);
}

function sizeWords({ report }: Page): string {
  const { counts } = report.overview;
  const failed = counts.reduce((sum, one) => sum + one.cases - one.complete, 0);
  const held = report.planned !== null && report.planned > report.cases ? ` of the sweep's ${grouped(report.planned)}` : "";
  return `${counted(report.cases, "case")}${held} · ${report.labels.length} ${report.labels.length === 1 ? "strategy" : "strategies"} · ${failed ? `${grouped(failed)} failed` : "none failed"}`;
}

function answerElement([first, ...others]: string[]): HTMLElement {
  return h("div", { class: "answer" }, h("p", { class: "answer-first" }, first ?? ""), ...others.map((sentence) => h("p", {}, sentence)));
}

/** What each figure of the table is over, and what it leaves out. */
function leftOut({ report }: Page): HTMLElement[] {
  const entries = report.overview.comparisons.flatMap((one) => [
    h("dt", {}, one.title, " ", h("code", {}, one.name)),
    ...[one.why ? `Not ranked: ${one.why}.` : "", ...one.notes].filter(Boolean).map((note) => h("dd", {}, note)),
  ]);
  if (!entries.length) return [];
  return [h("details", { class: "more" }, h("summary", {}, "What each figure is over, and what is left out"), h("dl", {}, ...entries))];
}

/** For each reason the figures that have no diagram. */
function unranked(comparisons: Comparison[]): HTMLElement[] {
  if (!comparisons.length) return [h("p", { class: "empty" }, "The result file has none of the figures that strategies are ranked by.")];
  const without = comparisons.filter(({ ranks }) => !ranks);
  const reasons = [...new Set(without.map(({ why }) => why))];
  const figures = (reason: string) => without.filter(({ why }) => why === reason).map(({ short }) => short).join("; ");
  return reasons.map((reason) => h("p", { class: "empty" }, `No ranks by ${figures(reason)}: ${reason}.`));
}

function failures({ report }: Page): HTMLElement[] {
  const { kinds, more } = report.overview.failures;
  if (!kinds.length) return [];
  const rows = kinds.map(({ status, reason, cases, labels, example }) =>
    h("tr", {}, h("td", {}, h("span", { class: "tag bad" }, status)), h("td", { class: "number" }, grouped(cases)), h("td", { class: "words" }, reason || "–"),
      h("td", { class: "words" }, labels), h("td", {}, h("a", { href: `#/case/${example}` }, example.slice(0, 10)))),
  );
  const head = h("tr", {}, ...["ended as", "cases", "reason", "of which strategies", "example"].map((name) => h("th", { scope: "col", class: name === "cases" ? "number" : "" }, name)));
  const table = h("table", {}, h("thead", {}, head), h("tbody", {}, ...rows));
  const rest = more ? [h("p", {}, `${counted(more, "other kind")} of failure: trocar show --failures lists every case.`)] : [];
  return [part("failures", "Cases that did not complete", h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "failures" }, table), ...rest)];
}
