// A recorded case as the report holds it: the counterpart of analysis/trocar_analysis/report/replays.py. Lengths in mm.

import type { Block } from "../blocks";

export type Moment = "found" | "handled" | "deformed";
export const MOMENTS: readonly Moment[] = ["found", "handled", "deformed"];

/** Lists of numbers, one after the other: list k is values[offsets[k] … offsets[k + 1]]. */
export interface Lists {
  offsets: Block;
  values: Block;
}

/** Where the camera starts: the plane through the tool's axis and `right` at the deepest step. World coordinates, unit vectors. */
export interface Sight {
  centre: number[];
  right: number[];
  axis: number[]; // from the tool's tip to its handle; upwards in the picture
  halfWidth: number; // of the picture
  halfHeight: number;
}

export interface Replay {
  caseId: string;
  label: string; // of the strategy
  status: string;
  set: number; // cases of one set ran under the same conditions
  conditions: string; // in words
  steps: number; // that the result file has; the report may hold fewer
  firstContact: number; // steps at which the strategies of the set
  deepest: number; //      first had to do something, and the tool was furthest in
  view: Sight;
  organ: { facets: Block; rest: Block; origin: number[]; spacing: number }; // `rest` in lattice numbers
  tool: { facets: Block; positions: Block }; // in the tool's frame
  frames: Block; // the number of the step of each frame
  time: Block; // of each frame, s
  poses: Block; // tool frame to world, 4 × 4 a frame, row by row
  positions: Block; // three moments a frame, as changes (positions.ts)
  moved: Lists; // per frame: vertices that the strategy displaced
  movedBy: Block; // of these: from where they were found
  crossing: Lists; // per moment of each frame: facets that cross the tool's surface or lie in it
  inside: Lists; // likewise: vertices inside the tool
  depths: Block; // of these: to the tool's surface
  series: string[]; // series of the result file, whose values at the frames follow
  values: Block; // one row a series
}
