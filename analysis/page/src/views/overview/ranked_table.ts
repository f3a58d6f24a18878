// The strategies, the best first: how their cases ended, their mean rank, and each main figure with its interval.

import { swatch } from "../../chart/legend";
import { styleOfLabel } from "../../chart/palette";
import { h } from "../../dom";
import { grouped, short } from "../../numbers";
import type { Report } from "../../report";
import { amount, type Comparison, type Count, type Row } from "../overview_data";
import { sortableTable, type SortableColumn } from "../sortable_table";
import { intervalBar } from "./interval_bar";

const WAYS = { low: "↓ lower is better", high: "↑ higher is better" };

export function rankedTable(report: Report): HTMLElement {
  const { counts, comparisons } = report.overview;
  const [main] = comparisons;
  const order = main?.rows.map(({ label }) => label) ?? [];
  const rows = [...counts].sort((one, other) => place(order, one.label) - place(order, other.label));
  const figures = comparisons.filter((one) => one.rows.length).map((one) => figureColumn(one, one === main));
  const rank = main?.ranks ? [rankColumn(main)] : [];
  const columns = [nameColumn(report), ...rank, ...figures.slice(0, 1), ...barColumn(report, main), ...figures.slice(1), ...countColumns(main)];
  const table = sortableTable("The strategies", columns, rows, rank.length || !figures.length ? Math.min(1, columns.length - 1) : 1);
  return h("div", {}, table, h("p", { class: "note" }, noteOf(main)));
}

function place(order: string[], label: string): number {
  const found = order.indexOf(label);
  return found < 0 ? order.length : found;
}

function noteOf(main: Comparison | undefined): string {
  const medians = "Medians, with their 95 % bootstrap intervals below, over the conditions under which every strategy has a value; a failed case counts as the worst value there is.";
  if (!main) return "The result file has none of the figures that strategies are compared by.";
  const rank = main.ranks ? ` Mean rank: by ${main.short}, over ${main.ranks.blocks} blocks (a seed on an organ).` : "";
  const isInfinite = main.rows.some(({ median }) => typeof median === "string");
  const infinite = isInfinite ? " ∞: half of the cases or more failed." : "";
  return `${medians}${infinite}${rank} “No value”: complete cases in which ${main.short} does not exist. A heading sorts the table.`;
}

function nameColumn({ labels }: Report): SortableColumn<Count> {
  const mark = (label: string) => {
    const drawn = swatch(styleOfLabel(labels, label));
    drawn.setAttribute("aria-hidden", "true");
    return drawn;
  };
  return { title: "strategy", isText: true, value: ({ label }) => label, cell: ({ label }) => [h("span", { class: "strategy" }, mark(label), label)] };
}

function rankColumn(main: Comparison): SortableColumn<Count> {
  const rank = ({ label }: Count) => rowOf(main, label)?.meanRank ?? NaN;
  const cell = (count: Count) => (Number.isNaN(rank(count)) ? "–" : rank(count).toFixed(2));
  return { title: "mean rank", note: `by ${main.short}`, value: rank, cell: (count) => [exact(rank(count), cell(count))] };
}

function figureColumn(comparison: Comparison, isMain: boolean): SortableColumn<Count> {
  const { factor, better, unit } = comparison;
  const value = ({ label }: Count) => amount(rowOf(comparison, label)?.median ?? null, factor);
  return {
    title: comparison.short,
    note: [unit, better ? WAYS[better] : ""].filter(Boolean).join(" · "),
    descendsFirst: better === "high",
    value,
    cell: (count) => {
      const row = rowOf(comparison, count.label);
      if (!row) return ["–"];
      const text = exact(amount(row.median, 1), short(value(count)));
      text.className = isMain ? "median main" : "median";
      return [text, h("small", { class: "interval" }, intervalWords(row, factor))];
    },
  };
}

/** The interval of the main figure, drawn; all on one scale. */
function barColumn(report: Report, main: Comparison | undefined): SortableColumn<Count>[] {
  if (!main || main.rows.length < 2) return [];
  const value = ({ label }: Count) => amount(rowOf(main, label)?.median ?? null, main.factor);
  return [{ title: "median and interval", note: "all on one scale", value, isText: true, cell: ({ label }) => intervalBar(main, label, styleOfLabel(report.labels, label)) }];
}

function countColumns(main: Comparison | undefined): SortableColumn<Count>[] {
  const failed = (count: Count) => Object.values(count.failed).reduce((sum, one) => sum + one, 0);
  const how = (count: Count) => Object.entries(count.failed).map(([status, cases]) => `${cases} ${status}`).join(", ");
  const lacking = ({ label }: Count) => main?.lacking[label] ?? 0;
  return [
    { title: "cases", value: (count) => count.cases, cell: (count) => [grouped(count.cases)] },
    { title: "failed", value: failed, cell: (count) => [grouped(failed(count)), ...(failed(count) ? [h("small", { class: "interval bad" }, how(count))] : [])] },
    { title: "no value", ...(main ? { note: `of ${main.short}` } : {}), value: lacking, cell: (count) => [grouped(lacking(count))] },
  ];
}

function intervalWords({ low, high }: Row, factor: number): string {
  return low === null || high === null ? "too few seeds" : `${short(amount(low, factor))}–${short(amount(high, factor))}`;
}

/** A number as it is shown, with all its digits in data-value, in the stored unit, and where the pointer rests. */
function exact(value: number, shown: string): HTMLElement {
  return h("span", Number.isNaN(value) ? {} : { "data-value": value, title: String(value) }, shown);
}

function rowOf(comparison: Comparison, label: string): Row | undefined {
  return comparison.rows.find((row) => row.label === label);
}
