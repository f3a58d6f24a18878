// Filters that all charts share. They stand in the address as `trocar run --only` has them: ?only=speed=100&only=speed=400.

import type { Cases } from "./cases";

/** Of each column that is filtered the values allowed: alternatives; different columns must all match. */
export type Filters = Map<string, Set<string>>;

/** The part of the address after `?`. */
export function queryOf(hash: string): URLSearchParams {
  return new URLSearchParams(hash.split("?").slice(1).join("?"));
}

/** The filters of an address, and what is wrong with it: columns or values that no case has. */
export function readFilters(query: URLSearchParams, cases: Cases): { filters: Filters; wrong: string[] } {
  const filters: Filters = new Map();
  const wrong: string[] = [];
  for (const text of query.getAll("only")) {
    const [column = "", ...rest] = text.split("=");
    const value = rest.join("=");
    if (!cases.columns.has(column) || !cases.codes(column).levels.includes(value)) wrong.push(text);
    else filters.set(column, (filters.get(column) ?? new Set()).add(value));
  }
  return { filters, wrong };
}

export function writeFilters(filters: Filters, query: URLSearchParams): void {
  query.delete("only");
  for (const [column, values] of filters) for (const value of values) query.append("only", `${column}=${value}`);
}

/** The filters with this value switched on or off. */
export function toggled(filters: Filters, column: string, value: string): Filters {
  const next: Filters = new Map(filters);
  const values = new Set(next.get(column));
  if (!values.delete(value)) values.add(value);
  if (values.size) next.set(column, values);
  else next.delete(column);
  return next;
}

/** The rows that match. */
export function matching(cases: Cases, filters: Filters): number[] {
  const tests = [...filters].map(([column, values]) => {
    const { levels, codes } = cases.codes(column);
    return { codes, allowed: levels.map((level) => values.has(level)) };
  });
  const rows: number[] = [];
  for (let row = 0; row < cases.count; row++) {
    if (tests.every(({ codes, allowed }) => allowed[codes[row]!])) rows.push(row);
  }
  return rows;
}

/** The columns by which cases are chosen and grouped, those in which they differ: strategy, conditions, options, how they ended. */
export function differingColumns(cases: Cases): string[] {
  const all = [...cases.columns.values()];
  const order = ["scene", "organ", "tool", "speed", "release"];
  const place = (name: string) => (order.includes(name) ? order.indexOf(name) : order.length);
  const conditions = all.filter(({ part }) => part === "condition").map(({ name }) => name);
  const options = all.filter(({ part }) => part === "option").map(({ name }) => name);
  conditions.sort((a, b) => Number(a === "seed") - Number(b === "seed") || place(a) - place(b));
  return ["label", ...conditions, ...options, "status"].filter((name) => cases.columns.has(name) && cases.codes(name).levels.length > 1);
}
