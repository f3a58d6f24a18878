// What every chart of the explore view is drawn from.

import type { Page } from "../../view";
import { quantile, readableUnit } from "../../numbers";
import type { Column } from "../../report";
import type { ExploreState } from "./state";

export interface Shown {
  page: Page;
  state: ExploreState;
  rows: number[]; // the cases that the filters leave
  column: Column; // of the figure
  labels: string[]; // of the strategies that the rows have, in the order of all charts
  unit: string; // in which values are shown
  factor: number; // from the stored unit to it
  choose(rows: number[], what: string): void; // lists these cases
}

export function shownOf(page: Page, state: ExploreState, rows: number[], choose: Shown["choose"]): Shown {
  const { cases, report } = page;
  const column = cases.columns.get(state.figure)!;
  const { levels, codes } = cases.codes("label");
  const present = levels.map(() => false);
  for (const row of rows) present[codes[row]!] = true;
  const values = Float64Array.from(rows, (row) => cases.number(state.figure, row)).filter(Number.isFinite).sort();
  const { unit, factor } = readableUnit(column.unit, quantile(values, 0.9));
  return { page, state, rows, column, labels: report.labels.filter((label) => present[levels.indexOf(label)]), unit, factor, choose };
}

/** A value in full, with its unit. */
export function exact({ factor, unit }: Pick<Shown, "factor" | "unit">, value: number): string {
  const number = factor === 1 ? String(value) : String(Number((value * factor).toPrecision(12)));
  return unit ? `${number} ${unit}` : number;
}

/** Such as "speed 100 mm/s". */
export function conditionWords(page: Page, column: string, value: string): string {
  const unit = page.cases.columns.get(column)?.unit;
  return `${column} ${value}${unit ? ` ${unit}` : ""}`;
}

/** What cases are pooled over that no chart tells apart: "2 values of release, 5 of seed". */
export function pooled(shown: Shown, apart: string[]): string {
  const { cases } = shown.page;
  const names = [...cases.columns.values()]
    .filter(({ part, name }) => part === "condition" && !apart.includes(name) && cases.codes(name).levels.length > 1)
    .map(({ name }) => name);
  const several = names
    .map((name) => {
      const { codes } = cases.codes(name);
      return { name, count: new Set(shown.rows.map((row) => codes[row]!)).size };
    })
    .filter(({ count }) => count > 1);
  return several.map(({ name, count }, k) => (k ? `${count} of ${name}` : `${count} values of ${name}`)).join(", ");
}
