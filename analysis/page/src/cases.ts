// The table of cases, as columns.

import { readBlock, type Values } from "./blocks";
import type { Column, Report } from "./report";

export interface Cases {
  count: number;
  columns: Map<string, Column>;
  number(column: string, row: number): number;
  text(column: string, row: number): string;
  /** Why a case has no value of a figure. */
  why(column: string, row: number): string;
  /** The row of a case; undefined when there is none. */
  row(caseId: string): number | undefined;
  /** The different values of a column as text, numbers ascending, texts as they come, and each row's place in them. */
  codes(column: string): Codes;
}

export interface Codes {
  levels: string[];
  codes: ArrayLike<number>;
}

export async function readCases(report: Report): Promise<Cases> {
  const values = new Map<string, Values>();
  const whys = new Map<string, Values>();
  await Promise.all(
    report.columns.map(async (column) => {
      values.set(column.name, await readBlock(column.values));
      if (column.why) whys.set(column.name, await readBlock(column.why.values));
    }),
  );
  return casesOf(report.cases, report.columns, values, whys);
}

export function casesOf(count: number, list: Column[], values: Map<string, Values>, whys: Map<string, Values>): Cases {
  const columns = new Map(list.map((column) => [column.name, column]));
  const known = new Map<string, Codes>();
  const number = (column: string, row: number) => values.get(column)?.[row] ?? NaN;
  const text = (column: string, row: number) => {
    const levels = columns.get(column)?.levels;
    return levels ? (levels[number(column, row)] ?? "") : String(number(column, row));
  };
  let rows: Map<string, number> | undefined;
  return {
    count,
    columns,
    number,
    text,
    why: (column, row) => columns.get(column)?.why?.levels[whys.get(column)?.[row] ?? 0] ?? "",
    row: (caseId) => {
      rows ??= new Map(Array.from({ length: count }, (_, row) => [text("case_id", row), row]));
      return rows.get(caseId);
    },
    codes: (column) => {
      let found = known.get(column);
      if (!found) known.set(column, (found = codesOf(columns.get(column)?.levels, values.get(column) ?? new Float64Array(count))));
      return found;
    },
  };
}

function codesOf(levels: string[] | undefined, values: Values): Codes {
  if (levels) return { levels, codes: values };
  const different = [...new Set<number>(values)].sort((a, b) => a - b);
  const places = new Map(different.map((value, place) => [value, place]));
  return { levels: different.map(String), codes: Uint32Array.from(values as ArrayLike<number>, (value) => places.get(value)!) };
}
