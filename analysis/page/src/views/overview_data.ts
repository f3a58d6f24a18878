// What Python has worked out for the overview: the counterpart of analysis/trocar_analysis/report/overview.py.

import type { Better } from "../report";

/** A number in the stored unit. "inf" and "-inf": so many cases failed; null: there is none. */
export type Amount = number | "inf" | "-inf" | null;

/** A strategy by one figure, over the cases of those conditions under which each strategy has a value. */
export interface Row {
  label: string;
  cases: number;
  failed: number; // of these; each counts as the worst value there is
  median: Amount;
  low: Amount; // of its 95 % interval; null with too few seeds
  high: Amount;
  meanRank: number | null;
}

export interface Ranks {
  blocks: number;
  leftOut: number; // blocks in which a strategy has no value
  difference: number; // Nemenyi's: mean ranks that differ by less are not told apart
  p: string; // that all rank alike
  groups: string[][]; // largest ones that are not told apart, the best first
}

/** The strategies by one figure, the best first. */
export interface Comparison {
  name: string;
  title: string;
  short: string;
  unit: string; // that people read
  factor: number; // to it, from the stored one
  better: Better;
  rows: Row[]; // none: see `why`
  lacking: Record<string, number>; // complete cases without a value, by label
  ranks: Ranks | null;
  why: string; // they are not ranked
  notes: string[];
}

export interface Count {
  label: string;
  cases: number;
  complete: number;
  failed: Record<string, number>; // by status
}

export interface Axis {
  name: string;
  title: string;
  unit: string;
  factor: number;
  better: Better;
}

export interface FrontPoint {
  label: string;
  cases: number;
  failed: number;
  onFront: boolean;
  x: [Amount, Amount, Amount]; // median and the ends of its interval
  y: [Amount, Amount, Amount];
}

/** `why` there are no points, or the axes and notes. */
export type Front = { points: []; why: string } | { points: FrontPoint[]; why: ""; x: Axis; y: Axis; notes: string[] };

export interface ClaimVerdict {
  release: string; // "" of a claim that cannot be judged
  confirmation: boolean; // on the confirmation set
  word: string;
  text: string; // the word and of how many conditions
}

export interface Claim {
  id: string;
  place: string;
  says: string;
  pending: string; // why it cannot be judged yet
  verdicts: ClaimVerdict[];
  table: { columns: { title: string; isText: boolean }[]; rows: string[][] } | null; // its conditions
  notes: string[];
}

export interface Overview {
  question: string;
  answer: string[];
  counts: Count[];
  comparisons: Comparison[]; // the first is what strategies are ranked by
  front: Front;
  claims: { claims: Claim[]; about: string[]; legend: string[] };
  failures: { kinds: { status: string; reason: string; cases: number; labels: string; example: string }[]; more: number };
  cautions: string[];
}

/** As a number, in the unit that people read; NaN where there is none. */
export function amount(value: Amount, factor: number): number {
  return value === null ? NaN : Number(value === "inf" ? Infinity : value === "-inf" ? -Infinity : value) * factor;
}
