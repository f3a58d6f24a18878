// Pairs of cases that differ in nothing but the strategy: equal conditions and seed.

import type { Cases } from "../../cases";
import { count } from "../../groups";

export interface Pair {
  a: number; // rows
  b: number;
  difference: number; // A − B, in the stored unit
}

export interface Pairing {
  pairs: Pair[];
  leftOut: Map<string, number>; // why → pairs without a difference
}

export function pairsOf(cases: Cases, rows: number[], figure: string, a: string, b: string): Pairing {
  const conditions = [...cases.columns.values()].filter(({ part }) => part === "condition").map(({ name }) => cases.codes(name));
  const differing = conditions.filter(({ levels }) => levels.length > 1);
  const place = (row: number) => differing.map(({ codes }) => codes[row]).join();
  const labels = cases.codes("label");
  const of = (label: string) => rows.filter((row) => labels.codes[row] === labels.levels.indexOf(label));
  const partners = new Map(of(b).map((row) => [place(row), row]));
  const pairing: Pairing = { pairs: [], leftOut: new Map() };
  const leave = (why: string) => count(pairing.leftOut, why);
  for (const row of of(a)) {
    const partner = partners.get(place(row));
    if (partner === undefined) {
      leave(`without a partner of ${b}`);
      continue;
    }
    partners.delete(place(row));
    const failed = [row, partner].filter((one) => cases.text("status", one) !== "complete");
    const difference = cases.number(figure, row) - cases.number(figure, partner);
    if (failed.length) leave("in which a case failed");
    else if (Number.isNaN(difference)) leave("in which a case has no value");
    else pairing.pairs.push({ a: row, b: partner, difference });
  }
  if (partners.size) count(pairing.leftOut, `without a partner of ${a}`, partners.size);
  return pairing;
}
