// The pinned vertex: its displacement and depth under each strategy now, and its displacement over all steps.

import * as Plot from "@observablehq/plot";
import { h } from "../dom";
import { distance } from "./fields";
import { frameAt, verticesAt, type Recording } from "./recording";
import type { Moment } from "./replay_data";

/** Displacement of a vertex from rest at each frame, mm. */
export function pathOf(recording: Recording, vertex: number, moment: Moment): number[] {
  const positions = new Float32Array(recording.rest.length);
  return Array.from(recording.frames, (_, frame) => {
    verticesAt(recording, frame, moment, positions);
    return distance(positions, vertex, recording.rest, vertex);
  });
}

export function depthOf(recording: Recording, vertex: number, frame: number, moment: Moment): number {
  const k = recording.inside(frame, moment).indexOf(vertex);
  return k < 0 ? 0 : recording.depths(frame, moment)[k]!;
}

/** @param colors one a recording */
export function pinnedPanel(recordings: Recording[], vertex: number, step: number, moment: Moment, colors: string[], close: () => void): HTMLElement {
  const rows = recordings.map((recording, k) => {
    const frame = frameAt(recording, step);
    const path = pathOf(recording, vertex, moment);
    const depth = depthOf(recording, vertex, frame, moment);
    return h("tr", {},
      h("th", { scope: "row" }, h("i", { class: "replay-key", style: `background:${colors[k]!}` }), recording.replay.label),
      h("td", {}, path[frame]!.toFixed(2)),
      h("td", {}, depth.toFixed(2)),
    );
  });
  const cells = ["strategy", "displacement, mm", "depth in the tool, mm"].map((name) => h("th", { scope: "col" }, name));
  return h("section", { class: "replay-pinned", "aria-label": `Vertex ${vertex}` },
    h("h3", {}, `Vertex ${vertex}`),
    h("button", { type: "button", click: close }, "Unpin"),
    h("div", { class: "replay-pinned-parts" },
      h("table", {}, h("thead", {}, h("tr", {}, ...cells)), h("tbody", {}, ...rows)),
      plot(recordings, vertex, step, moment, colors),
    ),
    h("p", { class: "replay-note" }, "As drawn: within 0.02 mm. Displacement is from rest."),
  );
}

function plot(recordings: Recording[], vertex: number, step: number, moment: Moment, colors: string[]): Element {
  const points = recordings.flatMap((recording) =>
    pathOf(recording, vertex, moment).map((mm, frame) => ({ step: recording.frames[frame]!, mm, label: recording.replay.label })),
  );
  const labels = recordings.map((recording) => recording.replay.label);
  const drawing = Plot.plot({
    width: 520,
    height: 190,
    marginLeft: 44,
    ariaLabel: `Displacement of vertex ${vertex} over the steps`,
    x: { label: "step" },
    y: { label: "displacement, mm", grid: true, nice: true, zero: true },
    color: { domain: labels, range: colors },
    marks: [
      Plot.ruleX([step], { strokeOpacity: 0.5 }),
      Plot.line(points, { x: "step", y: "mm", stroke: "label", strokeWidth: 1.6 }),
    ],
  });
  drawing.setAttribute("role", "img");
  for (const group of drawing.querySelectorAll("g[aria-label]")) group.removeAttribute("aria-label"); // a group may not have one
  return drawing;
}
