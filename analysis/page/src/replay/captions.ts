// What is said of a view at a step: numbers of the result file, not of the drawing.

import type { Moment } from "./replay_data";
import type { Recording } from "./recording";

export const MOMENT_WORDS: Record<Moment, string> = {
  found: "before handling",
  handled: "after handling",
  deformed: "after deformation",
};

/** Such as "deepest 0.53 mm" and "37 facets cross": README.md beside this file says what they are. A value that the file does not have is left out. */
export function facts(recording: Recording, frame: number, moment: Moment): string[] {
  const value = (series: string) => recording.value(series, frame);
  const suffix = moment === "handled" ? "h" : "d";
  const said: [number, string][] =
    moment === "found"
      ? [[value("collided_vertices"), plural(value("collided_vertices"), "vertex", "vertices") + " in the tool"]]
      : [
          [value(`depth_max_${suffix}`), `deepest ${value(`depth_max_${suffix}`).toFixed(2)} mm`],
          [value(`facets_crossing_${suffix}`), plural(value(`facets_crossing_${suffix}`), "facet crosses", "facets cross")],
          [value(`tool_volume_inside_${suffix}`), `${value(`tool_volume_inside_${suffix}`).toFixed(0)} mm³ inside`],
        ];
  const words = said.filter(([number]) => Number.isFinite(number)).map(([, text]) => text);
  const moved = recording.moved(frame).length;
  return [...words, `${moved} moved`].map((fact) => fact.replaceAll(" ", "\u00a0")); // lines break between them
}

/** Why a view stands still: its case ended before this step. */
export function ending(recording: Recording, step: number): string {
  const last = recording.replay.steps - 1;
  return step > last ? `${recording.replay.status}: ended after step ${last}` : "";
}

function plural(count: number, one: string, several: string): string {
  return `${count} ${count === 1 ? one : several}`;
}
