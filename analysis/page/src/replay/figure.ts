// The picture part of the replay: a line of words above, a cell with a caption for each strategy, the legend below.

import { h } from "../dom";
import type { Shown } from "./address";
import { ending, facts } from "./captions";
import { legend } from "./legend";
import { frameAt, type Recording } from "./recording";

export interface Figure {
  element: HTMLElement;
  ground: HTMLElement; // under all cells; the canvas goes here
  places: HTMLElement[]; // of the views
  /** @param words conditions, step and moment */
  update(step: number, shown: Shown, top: number, words: string): void;
  arrange(): void; // the cells, after a change of size
}

/** @param colors one a recording */
export function makeFigure(recordings: Recording[], colors: string[]): Figure {
  const places = recordings.map(() => h("div", { class: "replay-place" }));
  const said = recordings.map(() => h("span", { class: "replay-facts" }));
  const cells = recordings.map((recording, k) =>
    h("div", { class: "replay-cell" },
      h("div", { class: "replay-caption" },
        h("strong", {}, h("i", { class: "replay-key", style: `background:${colors[k]!}` }), recording.replay.label), said[k]!),
      places[k]!),
  );
  const ground = h("div", { class: "replay-ground", tabindex: 0, role: "application", "aria-label": "Replay in 3D; the keys are listed below" }, ...cells);
  const head = h("div", { class: "replay-head" });
  const foot = h("div", { class: "replay-foot" });
  const { halfWidth, halfHeight } = recordings[0]!.replay.view;
  const closed = recordings[0]!.organ.closed;
  return {
    element: h("figure", { class: "replay-figure" }, head, ground, foot),
    ground,
    places,
    update: (step, shown, top, words) => {
      head.textContent = words;
      foot.replaceChildren(legend(shown, top, shown.cut && closed && shown.surface !== "wire"));
      recordings.forEach((recording, k) => {
        said[k]!.textContent = ending(recording, step) || facts(recording, frameAt(recording, step), shown.moment).join(" · ");
      });
    },
    arrange: () => {
      const columns = columnsFor(cells.length, ground.clientWidth, ground.clientHeight, halfWidth / halfHeight);
      ground.style.gridTemplateColumns = `repeat(${columns}, minmax(0, 1fr))`;
    },
  };
}

const CAPTION = 44; // pixels

/** In how many columns views of this shape become largest. */
export function columnsFor(views: number, width: number, height: number, aspect: number): number {
  let best = 1;
  let largest = 0;
  for (let columns = 1; columns <= views; columns++) {
    const tall = height / Math.ceil(views / columns) - CAPTION;
    const size = Math.min(width / columns / aspect, tall);
    if (size > largest * 1.001) [best, largest] = [columns, size];
  }
  return best;
}
