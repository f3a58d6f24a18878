// The command that runs just one case again.

import type { Cases } from "../../cases";
import type { Report } from "../../report";

// What `trocar run --only` chooses cases by. A label is one strategy's with its options, and belongs to no other of the sweep.
const KEYS = ["label", "organ", "tool", "scene", "speed", "rate", "release", "edge_stiffness", "rest_stiffness", "seed"];

/** The arguments of the program. Conditions that all cases of the whole sweep share are left out. */
export function rerunArguments(report: Report, cases: Cases, row: number, commandLine: string): string[] {
  const isWhole = report.planned === cases.count;
  const known = KEYS.filter((key) => cases.columns.has(key));
  const wanted = known.filter((key) => !isWhole || cases.codes(key).levels.length > 1);
  const given = words(commandLine);
  const metrics = given.indexOf("--metrics");
  return [
    "trocar",
    "run",
    sweepFile(given),
    ...wanted.flatMap((key) => ["--only", `${key}=${valueOf(cases, key, row)}`]),
    ...(metrics >= 0 ? ["--metrics", given[metrics + 1]!] : []),
    "-o",
    `case-${cases.text("case_id", row).slice(0, 8)}.h5`,
  ];
}

/** As a shell takes it. */
export function shellText(words: string[]): string {
  return words.map((word) => (/^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", `'\\''`)}'`)).join(" ");
}

/** The sweep file that the recorded command line names. */
export function sweepFile(words: string[]): string {
  const run = words.indexOf("run");
  return words.slice(run + 1).find((word) => word.endsWith(".toml")) ?? "sweep.toml";
}

/** The words of a recorded command line. */
export function words(line: string): string[] {
  return [...line.matchAll(/'((?:[^']|'\\'')*)'|(\S+)/g)].map(([, quoted, plain]) => quoted?.replaceAll(`'\\''`, "'") ?? plain!);
}

function valueOf(cases: Cases, key: string, row: number): string {
  return cases.columns.get(key)!.levels ? cases.text(key, row) : programNumber(cases.number(key, row));
}

/** A number as the program writes it: the shortest digits that mean it, with an exponent below 1e-4 and from 1e16 on. */
export function programNumber(value: number): string {
  const size = Math.abs(value);
  if (size === 0 || (size >= 1e-4 && size < 1e16)) return String(value);
  return value.toExponential().replace(/e([+-])(\d)$/, "e$10$2");
}
