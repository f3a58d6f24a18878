// What an organ can be coloured by: one number a vertex.

import { verticesAt, type Recording } from "./recording";
import { MOMENTS, type Moment } from "./replay_data";

export type Field = "none" | "displacement" | "strain" | "depth";

/** `most`: where the colour bar ends at the latest; it has to tell ordinary values apart, whatever a torn facet does. */
export const FIELDS: Record<Field, { name: string; unit: string; percent?: boolean; most?: number }> = {
  none: { name: "nothing", unit: "" },
  displacement: { name: "displacement from rest", unit: "mm" },
  strain: { name: "strain, the largest of the vertex's edges", unit: "%", percent: true, most: 1 },
  depth: { name: "depth inside the tool", unit: "mm" },
};

/** Values at the vertices, whose positions are given, into `values`. Strain is |length over length at rest − 1|. */
export function fieldValues(
  recording: Recording,
  field: Field,
  frame: number,
  moment: Moment,
  positions: Float32Array,
  values: Float32Array,
): void {
  values.fill(0);
  if (field === "displacement") displacements(positions, recording.rest, values);
  else if (field === "strain") strains(positions, recording.rest, recording.organ.edges, values);
  else if (field === "depth") {
    const depths = recording.depths(frame, moment);
    recording.inside(frame, moment).forEach((vertex, k) => (values[vertex] = depths[k]!));
  }
}

function displacements(positions: Float32Array, rest: Float32Array, values: Float32Array): void {
  for (let v = 0; v < values.length; v++) values[v] = distance(positions, v, rest, v);
}

function strains(positions: Float32Array, rest: Float32Array, edges: Uint32Array, values: Float32Array): void {
  for (let e = 0; e < edges.length; e += 2) {
    const a = edges[e]!;
    const b = edges[e + 1]!;
    const atRest = distance(rest, a, rest, b);
    const strain = atRest > 0 ? Math.abs(distance(positions, a, positions, b) / atRest - 1) : 0;
    if (strain > values[a]!) values[a] = strain;
    if (strain > values[b]!) values[b] = strain;
  }
}

export function distance(a: Float32Array, i: number, b: Float32Array, j: number): number {
  const x = a[3 * i]! - b[3 * j]!;
  const y = a[3 * i + 1]! - b[3 * j + 1]!;
  const z = a[3 * i + 2]! - b[3 * j + 2]!;
  return Math.sqrt(x * x + y * y + z * z);
}

/** The end of the colour bar: the largest value in any frame and moment of the recordings, or what is most. */
export function endOfBar(recordings: Recording[], field: Field): number {
  let largest = 0;
  for (const recording of recordings) {
    const positions = new Float32Array(recording.rest.length);
    const values = new Float32Array(recording.rest.length / 3);
    for (let frame = 0; frame < recording.frames.length; frame++) {
      for (const moment of MOMENTS) {
        verticesAt(recording, frame, moment, positions);
        fieldValues(recording, field, frame, moment, positions, values);
        for (const value of values) if (value > largest) largest = value;
      }
    }
  }
  return Math.min(largest, FIELDS[field].most ?? Infinity);
}
