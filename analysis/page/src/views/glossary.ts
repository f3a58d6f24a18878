// Every metric of the file: its unit, which way is better, and what it is.

import { h } from "../dom";
import type { Metric, Report } from "../report";
import { sortableTable, type SortableColumn } from "./sortable_table";

const WAYS = { low: "↓ lower", high: "↑ higher", neither: "neither", "": "not said" };

export function glossary({ glossary: metrics }: Report): HTMLElement {
  const columns: SortableColumn<Metric>[] = [
    { title: "metric", isText: true, value: ({ metric }) => metric, cell: ({ metric }) => [h("code", {}, metric)] },
    { title: "unit", isText: true, value: ({ unit }) => unit, cell: ({ unit }) => [unit || "1"] },
    { title: "better", isText: true, value: ({ better }) => better, cell: ({ better }) => [WAYS[better]] },
    { title: "what it is", isText: true, value: ({ words }) => words, cell: ({ words }) => [h("span", { class: "words" }, words || "The file does not say.")] },
    { title: "figures", value: ({ columns: own }) => own.length, cell: ({ columns: own }) => [h("span", { title: own.join("\n") }, String(own.length))] },
  ];
  return sortableTable("Glossary", columns, metrics, 0);
}
