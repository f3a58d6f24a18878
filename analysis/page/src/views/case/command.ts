// The command that runs just one case again.

import type { Cases } from "../../cases";
import type { Report } from "../../report";

// What `trocar run --only` chooses cases by. A label is one strategy's with its options, and belongs to no other of the sweep.
const KEYS = ["label", "organ", "tool", "scene", "speed", "rate", "release", "edge_stiffness", "rest_stiffness", "seed"];

/** What stands for a sweep file that is not known. */
export const UNKNOWN = "SWEEP.toml";

/** The arguments of the program. Conditions that all cases of the whole sweep share are left out. */
export function rerunArguments(report: Report, cases: Cases, row: number, commandLine: string): string[] {
  const isWhole = report.planned === cases.count;
  const known = KEYS.filter((key) => cases.columns.has(key));
  const wanted = known.filter((key) => !isWhole || cases.codes(key).levels.length > 1);
  const metrics = /\s--metrics[ =](\S+)/.exec(commandLine)?.[1];
  return [
    "trocar",
    "run",
    sweepFile(commandLine) ?? UNKNOWN,
    ...wanted.flatMap((key) => ["--only", `${key}=${valueOf(cases, key, row)}`]),
    ...(metrics ? ["--metrics", metrics] : []),
    "-o",
    `case-${cases.text("case_id", row).slice(0, 8)}.h5`,
  ];
}

/** As a shell takes it. */
export function shellText(words: string[]): string {
  return words.map((word) => (/^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", `'\\''`)}'`)).join(" ");
}

/** The sweep file that a recorded command line names; undefined where the cases are of no one file, as those of `reproduce`.
 * Words of the line have one space between them, and a file's name may have some: it stands in front of the options, or is a word. */
export function sweepFile(commandLine: string): string | undefined {
  const [, after] = /(?:^|\s)run\s+(.*)$/.exec(commandLine) ?? [];
  return /^([^-].*?\.toml)(?:\s|$)/.exec(after ?? "")?.[1] ?? /(?:^|\s)(\S+\.toml)(?:\s|$)/.exec(after ?? "")?.[1];
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
