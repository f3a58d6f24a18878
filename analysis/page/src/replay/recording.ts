// A recorded case, unpacked.

import { readBlock, type Values } from "../blocks";
import { placeVertices, unpackMoments } from "./positions";
import { MOMENTS, type Lists, type Moment, type Replay } from "./replay_data";

export interface Mesh {
  facets: Uint32Array; // three vertices each
  edges: Uint32Array; // two vertices each, every edge once
  closed: boolean; // every edge is of two facets
}

export interface Recording {
  replay: Replay;
  organ: Mesh;
  rest: Float32Array; // mm, three a vertex
  numbers: Int32Array; // of the lattice, three a vertex, three moments a frame
  tool: Mesh;
  toolPositions: Float32Array; // in the tool's frame
  frames: Values; // their steps
  time: Values; // s
  poses: Values;
  moved: (frame: number) => Values;
  movedBy: (frame: number) => Values;
  crossing: (frame: number, moment: Moment) => Values;
  inside: (frame: number, moment: Moment) => Values;
  depths: (frame: number, moment: Moment) => Values;
  value: (series: string, frame: number) => number; // NaN where there is none
}

export async function readRecording(replay: Replay, meshes: Map<string, Mesh>): Promise<Recording> {
  const [rest, changes, frames, time, poses, toolPositions, values, movedBy, depths] = await Promise.all(
    [replay.organ.rest, replay.positions, replay.frames, replay.time, replay.poses, replay.tool.positions].concat(
      [replay.values, replay.movedBy, replay.depths]).map(readBlock),
  );
  const [moved, crossing, inside] = await Promise.all([replay.moved, replay.crossing, replay.inside].map(readLists));
  const place = new Float32Array(rest!.length);
  placeVertices(rest!, 0, replay.organ.origin, replay.organ.spacing, place);
  const row = (frame: number, moment: Moment) => 3 * frame + MOMENTS.indexOf(moment);
  return {
    replay,
    organ: await readMesh(replay.organ.facets, meshes),
    rest: place,
    numbers: unpackMoments(changes!, rest!),
    tool: await readMesh(replay.tool.facets, meshes),
    toolPositions: toolPositions as Float32Array,
    frames: frames!,
    time: time!,
    poses: poses!,
    moved: (frame) => moved!.list(frame, moved!.values, 1),
    movedBy: (frame) => moved!.list(frame, movedBy!, 3),
    crossing: (frame, moment) => crossing!.list(row(frame, moment), crossing!.values, 1),
    inside: (frame, moment) => inside!.list(row(frame, moment), inside!.values, 1),
    depths: (frame, moment) => inside!.list(row(frame, moment), depths!, 1),
    value: (series, frame) => {
      const at = replay.series.indexOf(series);
      return at < 0 ? NaN : values![at * frames!.length + frame]!;
    },
  };
}

/** The vertices of a moment, mm. */
export function verticesAt(recording: Recording, frame: number, moment: Moment, positions: Float32Array): void {
  const { origin, spacing } = recording.replay.organ;
  placeVertices(recording.numbers, 3 * frame + MOMENTS.indexOf(moment), origin, spacing, positions);
}

/** The last frame that is not after a step; a recording that ended earlier stays at its end. */
export function frameAt(recording: Recording, step: number): number {
  let frame = 0;
  while (frame + 1 < recording.frames.length && recording.frames[frame + 1]! <= step) frame++;
  return frame;
}

async function readLists(lists: Lists) {
  const [offsets, values] = await Promise.all([readBlock(lists.offsets), readBlock(lists.values)]);
  const list = (k: number, of: Values, width: number) => of.subarray(width * offsets![k]!, width * offsets![k + 1]!);
  return { values: values!, list };
}

async function readMesh(block: Replay["organ"]["facets"], meshes: Map<string, Mesh>): Promise<Mesh> {
  const known = meshes.get(block.block);
  if (known) return known;
  const mesh = meshOf((await readBlock(block)) as Uint32Array);
  meshes.set(block.block, mesh);
  return mesh;
}

export function meshOf(facets: Uint32Array): Mesh {
  const uses = new Map<number, number>(); // an edge, as one number → its facets
  const most = facets.reduce((a, b) => Math.max(a, b), 0) + 1;
  for (let k = 0; k < facets.length; k++) {
    const a = facets[k]!;
    const b = facets[k % 3 === 2 ? k - 2 : k + 1]!;
    const edge = Math.min(a, b) * most + Math.max(a, b);
    uses.set(edge, (uses.get(edge) ?? 0) + 1);
  }
  const edges = new Uint32Array(2 * uses.size);
  let at = 0;
  for (const edge of uses.keys()) {
    edges[at++] = Math.floor(edge / most);
    edges[at++] = edge % most;
  }
  return { facets, edges, closed: [...uses.values()].every((count) => count === 2) };
}
