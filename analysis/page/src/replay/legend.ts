// What the colours and marks of the views mean.

import { h } from "../dom";
import { PARTS, type Part, type Shown } from "./address";
import { cssColor } from "./color_map";
import { FIELDS } from "./fields";

const MARKS: Record<Part, string> = {
  tool: "tool",
  moved: "vertex moved by the strategy",
  vectors: "its displacement",
  crossing: "facet in or across the tool",
};

export function legend(shown: Shown, top: number, sectioned: boolean): HTMLElement {
  const marks = PARTS.filter((part) => !shown.hidden.includes(part)).map((part) => key(part, MARKS[part]));
  if (sectioned) marks.push(key("section", "section of the organ"), key("deep", "the same inside the tool"));
  return h("div", { class: "replay-legend" }, ...(shown.color === "none" ? [] : [colorBar(shown.color, top)]), ...marks);
}

function key(name: string, words: string): HTMLElement {
  return h("span", { class: "replay-mark" }, h("i", { class: `replay-sign replay-sign-${name}` }), words);
}

/** The same range in all views and at all steps. */
function colorBar(field: Exclude<Shown["color"], "none">, top: number): HTMLElement {
  const { name, unit, percent, most } = FIELDS[field];
  const stops = Array.from({ length: 17 }, (_, k) => cssColor(k / 16)).join();
  const ticks = [0, 0.5, 1].map((share) => number(share * top * (percent ? 100 : 1)));
  if (top === most) ticks[2] = `${ticks[2]!} and more`;
  return h("span", { class: "replay-bar", role: "img", "aria-label": `${name}: from ${ticks[0]!} to ${ticks[2]!} ${unit}` },
    h("span", { class: "replay-bar-name" }, `${name}, ${unit}`),
    h("span", { class: "replay-bar-colors", style: `background:linear-gradient(90deg,${stops})` }),
    h("span", { class: "replay-bar-ticks" }, ...ticks.map((tick) => h("span", {}, tick))),
  );
}

function number(value: number): string {
  return Number(value.toPrecision(3)).toString();
}
