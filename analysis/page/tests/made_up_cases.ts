// Cases for the tests, made of rows.

import { casesOf, type Cases } from "../src/cases";
import type { Values } from "../src/blocks";
import type { Column } from "../src/report";

type Row = Record<string, string | number>;

const CONDITIONS = ["scene", "organ", "tool", "speed", "release", "seed"];
const INPUTS = [...CONDITIONS, "case_id", "label", "options"];

/** Columns as the first row has them. `why` of a figure: the reason where a value is NaN. */
export function casesOfRows(rows: Row[], why: Record<string, string> = {}): Cases {
  const values = new Map<string, Values>();
  const whys = new Map<string, Values>();
  const columns: Column[] = Object.keys(rows[0]!).map((name) => {
    const cells = rows.map((row) => row[name]!);
    const isText = typeof cells[0] === "string";
    const levels = isText ? [...new Set(cells as string[])] : undefined;
    values.set(name, levels ? Uint16Array.from(cells, (cell) => levels.indexOf(cell as string)) : Float64Array.from(cells as number[]));
    if (why[name]) whys.set(name, Uint16Array.from(cells, (cell) => Number(Number.isNaN(cell))));
    const block = { block: name, kind: "f8" as const, shape: [rows.length] };
    return {
      name, unit: "", longName: "", values: block, better: null,
      role: INPUTS.includes(name) ? "input" : name === "status" ? "outcome" : "figure",
      ...(CONDITIONS.includes(name) ? { part: "condition" as const } : {}),
      ...(levels ? { levels } : {}),
      ...(why[name] ? { why: { levels: ["", why[name]], values: block } } : {}),
    };
  });
  return casesOf(rows.length, columns, values, whys);
}

/** Two strategies, two speeds, three seeds; the depth is the seed, ten times as deep with B. */
export function twelve(): Row[] {
  const rows: Row[] = [];
  for (const label of ["A", "B"])
    for (const speed of [400, 20])
      for (const seed of [1, 2, 3])
        rows.push({ case_id: `${label}${speed}${seed}`, label, organ: "liver", speed, seed, status: "complete", depth: seed * (label === "A" ? 1 : 10) });
  return rows;
}
