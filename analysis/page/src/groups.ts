// Cases in groups, and a figure over each: the median and quartiles of the complete cases that have a value. What failed and
// what has no value is counted.

import type { Cases } from "./cases";
import { counted, quantile } from "./numbers";

export interface Summary {
  rows: number[];
  values: Float64Array; // sorted, in the stored unit
  median: number; // NaN of no value, as are the quartiles
  q1: number;
  q3: number;
  failed: Map<string, number>; // status → cases
  lacking: Map<string, number>; // reason → complete cases without a value
}

export interface Group extends Summary {
  keys: string[]; // a value of each column that groups
}

export function summarise(cases: Cases, rows: number[], figure: string): Summary {
  const failed = new Map<string, number>();
  const lacking = new Map<string, number>();
  const values: number[] = [];
  const status = cases.codes("status");
  const complete = status.levels.indexOf("complete");
  for (const row of rows) {
    const value = cases.number(figure, row);
    if (status.codes[row] !== complete) count(failed, cases.text("status", row));
    else if (Number.isNaN(value)) count(lacking, cases.why(figure, row) || "no reason recorded");
    else values.push(value);
  }
  const sorted = Float64Array.from(values).sort();
  return { rows, values: sorted, median: quantile(sorted, 0.5), q1: quantile(sorted, 0.25), q3: quantile(sorted, 0.75), failed, lacking };
}

/** The groups that have cases, sorted column by column. */
export function grouped(cases: Cases, rows: number[], columns: string[], figure: string): Group[] {
  const all = columns.map((column) => cases.codes(column));
  const found = new Map<number, number[]>();
  for (const row of rows) {
    let place = 0;
    for (const { levels, codes } of all) place = place * levels.length + codes[row]!;
    const group = found.get(place);
    if (group) group.push(row);
    else found.set(place, [row]);
  }
  return [...found]
    .sort(([a], [b]) => a - b)
    .map(([, members]) => ({
      keys: all.map(({ levels, codes }) => levels[codes[members[0]!]!]!),
      ...summarise(cases, members, figure),
    }));
}

export function count(counts: Map<string, number>, what: string, by = 1): void {
  counts.set(what, (counts.get(what) ?? 0) + by);
}

export function total(counts: Map<string, number>): number {
  let sum = 0;
  for (const number of counts.values()) sum += number;
  return sum;
}

/** Such as "3 diverged, 1 crashed", the most frequent first. */
export function tally(counts: Map<string, number>): string {
  return [...counts].sort(([, a], [, b]) => b - a).map(([what, number]) => `${number} ${what}`).join(", ");
}

/** What is to be said of cases that are in no median: "2 failed (2 diverged) · 3 without a value (3 no vertex collided)"; "" of none. */
export function leftOut({ failed, lacking }: Pick<Summary, "failed" | "lacking">): string {
  const said: string[] = [];
  if (failed.size) said.push(`${counted(total(failed), "case")} failed (${tally(failed)})`);
  if (lacking.size) said.push(`${counted(total(lacking), "case")} without a value (${tally(lacking)})`);
  return said.join("; ");
}

/** The same of several groups together. */
export function together(groups: Pick<Summary, "failed" | "lacking">[]): Pick<Summary, "failed" | "lacking"> {
  const all = { failed: new Map<string, number>(), lacking: new Map<string, number>() };
  for (const group of groups) {
    for (const [what, number] of group.failed) count(all.failed, what, number);
    for (const [what, number] of group.lacking) count(all.lacking, what, number);
  }
  return all;
}
