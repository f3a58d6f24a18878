// Which series of which cases the report holds.

import { readBlock, type Block } from "../blocks";

export interface SeriesIndex {
  series: { name: string; unit: string; longName: string }[];
  sets: number[][]; // lists of series that cases have, as places in `series`
  reasons: string[]; // why there is no value
  cases: Record<string, CaseEntry>; // by case_id
}

export interface CaseEntry {
  set: number; // place in `sets`
  values: Block; // [series of the set, steps]; NaN where there is none
  missing: [reason: number, steps: [number, number][], series: number[]][]; // series as places in the set; both ends included
}

export interface Series {
  name: string;
  unit: string;
  longName: string;
  values: Float32Array;
  missing: { reason: string; steps: [number, number][] }[];
}

/** The series of a case; none where the report does not hold them. */
export async function readSeries(index: SeriesIndex, caseId: string): Promise<Series[]> {
  const entry = index.cases[caseId];
  if (!entry) return [];
  const values = (await readBlock(entry.values)) as Float32Array;
  const steps = entry.values.shape[1]!;
  return index.sets[entry.set]!.map((which, place) => ({
    ...index.series[which]!,
    values: values.subarray(place * steps, (place + 1) * steps),
    missing: entry.missing
      .filter(([, , series]) => series.includes(place))
      .map(([reason, ranges]) => ({ reason: index.reasons[reason]!, steps: ranges })),
  }));
}
