// The table of cases, as columns.

import { readBlock, type Values } from "./blocks";
import type { Column, Report } from "./report";

export interface Cases {
  count: number;
  columns: Map<string, Column>;
  number(column: string, row: number): number;
  text(column: string, row: number): string;
}

export async function readCases(report: Report): Promise<Cases> {
  const values = new Map<string, Values>();
  await Promise.all(report.columns.map(async (column) => values.set(column.name, await readBlock(column.values))));
  const columns = new Map(report.columns.map((column) => [column.name, column]));
  const number = (column: string, row: number) => values.get(column)?.[row] ?? NaN;
  return {
    count: report.cases,
    columns,
    number,
    text: (column, row) => {
      const levels = columns.get(column)?.levels;
      return levels ? (levels[number(column, row)] ?? "") : String(number(column, row));
    },
  };
}
