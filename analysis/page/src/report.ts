// What a report holds: the counterpart of analysis/trocar_analysis/report/. Units are those of the result file.

import type { Block } from "./blocks";
import type { Overview } from "./views/overview_data";
import type { SeriesIndex } from "./views/series_data";
import type { Replay } from "./replay/replay_data";

export type Better = "low" | "high" | null;

/** A column of /cases. Text is stored as codes into `levels`. */
export interface Column {
  name: string;
  unit: string; // "" for text and plain numbers
  longName: string; // what it is, in words
  role: "input" | "outcome" | "figure";
  better: Better; // which way is better, of figures that are judged
  part?: "condition" | "option"; // of the inputs: equal in cases that differ in their strategy alone; of the strategy
  caution?: string; // why the values of different cases may not be compared
  levels?: string[];
  values: Block; // one a case; NaN where there is none
  why?: { levels: string[]; values: Block }; // why a case has no value, "" where it has one; absent when all have one
}

export interface Metric {
  metric: string;
  unit: string;
  better: "low" | "high" | "neither" | ""; // "": the program did not say
  words: string;
  columns: string[];
}

export interface Report {
  title: string;
  file: string; // name of the result file
  schema: number;
  createdUtc: string;
  generator: string;
  sweepToml: string;
  planned: number | null; // cases of the whole sweep, of which the file may hold a part
  cases: number; // cases in the file
  labels: string[]; // of the strategies, in the order in which all charts and tables have them
  columns: Column[];
  provenance: Record<string, string | number>[]; // each way in which cases were run; column provenance_row numbers them
  glossary: Metric[];
  overview: Overview;
  series: SeriesIndex;
  replays: Replay[];
  notes: string[]; // what is not in the report, and why
}
