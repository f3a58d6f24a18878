// Cases under equal conditions: they differ in their strategy alone.

import type { Cases } from "../../cases";

/** Their rows, in the order of the labels, with the case itself. */
export function siblingsOf(cases: Cases, labels: string[], row: number): number[] {
  const conditions = [...cases.columns.values()].filter(({ part }) => part === "condition").map(({ name }) => cases.codes(name).codes);
  const rows: number[] = [];
  for (let other = 0; other < cases.count; other++) if (conditions.every((codes) => codes[other] === codes[row])) rows.push(other);
  const place = (one: number) => labels.indexOf(cases.text("label", one));
  return rows.sort((a, b) => place(a) - place(b));
}
