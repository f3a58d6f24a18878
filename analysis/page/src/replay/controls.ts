// The controls around the views. They say what the user wants; replay_view.ts does it.

import { h } from "../dom";
import { PARTS, SPEEDS, SURFACES, type Part, type Shown, type Surface } from "./address";
import { MOMENT_WORDS } from "./captions";
import { FIELDS, type Field } from "./fields";
import { MOMENTS, type Moment } from "./replay_data";

export interface Wishes {
  change(changes: Partial<Shown>): void;
  go(steps: number): void; // forwards or back, in kept steps
  scrub(at: number): void; // to one of the kept steps
  play(): void;
  resetCamera(): void;
  save(): void;
}

export interface Controls {
  transport: HTMLElement;
  options: HTMLElement;
  /** Shows what is. @param said the step in words */
  update(shown: Shown, at: number, playing: boolean, said: string): void;
}

const PART_WORDS: Record<Part, string> = { tool: "tool", moved: "moved vertices", vectors: "displacements", crossing: "crossing facets" };

export function makeControls(last: number, wishes: Wishes): Controls {
  const play = h("button", { type: "button", class: "replay-play", click: () => wishes.play() });
  const range = h("input", { type: "range", min: 0, max: last, step: 1, "aria-label": "step" });
  range.addEventListener("input", () => wishes.scrub(Number(range.value)));
  const words = h("output", { class: "replay-step" });
  const moments = choice<Moment>("Moment", MOMENTS, (moment) => MOMENT_WORDS[moment], (moment) => wishes.change({ moment }));
  const through = check("play all three moments", (on) => wishes.change({ through: on }));
  const speed = select("Speed", SPEEDS.map(String), (value) => `${value} × time`, (value) => wishes.change({ speed: Number(value) }));
  const color = select("Colour by", Object.keys(FIELDS) as Field[], (field) => FIELDS[field].name, (value) => wishes.change({ color: value }));
  const surface = choice<Surface>("Organ", SURFACES, (one) => one, (one) => wishes.change({ surface: one }));
  const cut = check("section", (on) => wishes.change({ cut: on }));
  let hidden: Part[] = [];
  const parts = PARTS.map((part) =>
    check(PART_WORDS[part], (on) => wishes.change({ hidden: PARTS.filter((one) => (one === part ? !on : hidden.includes(one))) })),
  );
  return {
    transport: h("div", { class: "replay-transport" },
      button("«", "first step", () => wishes.scrub(0)),
      button("‹", "step back", () => wishes.go(-1)),
      play,
      button("›", "step on", () => wishes.go(1)),
      button("»", "last step", () => wishes.scrub(last)),
      range, words, moments.element, through.element, speed.element,
    ),
    options: h("div", { class: "replay-options" },
      color.element, surface.element, cut.element, ...parts.map((part) => part.element),
      h("button", { type: "button", click: () => wishes.resetCamera() }, "Reset camera"),
      h("button", { type: "button", click: () => wishes.save() }, "Save picture"),
    ),
    update: (shown, at, playing, said) => {
      hidden = shown.hidden;
      play.textContent = playing ? "Pause" : "Play";
      range.value = String(at);
      range.setAttribute("aria-valuetext", said);
      words.textContent = said;
      moments.set(shown.moment);
      surface.set(shown.surface);
      speed.set(String(shown.speed));
      color.set(shown.color);
      through.set(shown.through);
      cut.set(shown.cut);
      PARTS.forEach((part, k) => parts[k]!.set(!shown.hidden.includes(part)));
    },
  };
}

function button(sign: string, name: string, click: () => void): HTMLElement {
  return h("button", { type: "button", title: name, "aria-label": name, click }, sign);
}

function check(words: string, changed: (on: boolean) => void) {
  const box = h("input", { type: "checkbox" });
  box.addEventListener("change", () => changed(box.checked));
  return { element: h("label", { class: "replay-check" }, box, words), set: (on: boolean) => void (box.checked = on) };
}

export function select<T extends string>(name: string, values: readonly T[], words: (value: T) => string, changed: (value: T) => void) {
  const box = h("select", {}, ...values.map((value) => h("option", { value }, words(value))));
  box.addEventListener("change", () => changed(box.value as T));
  return { element: h("label", { class: "replay-select" }, `${name} `, box), set: (value: T) => void (box.value = value) };
}

let groups = 0;

/** Of a few values one, all in sight. */
function choice<T extends string>(name: string, values: readonly T[], words: (value: T) => string, changed: (value: T) => void) {
  const group = `replay-choice-${groups++}`;
  const boxes = values.map((value) => h("input", { type: "radio", name: group, value, change: () => changed(value) }));
  const labels = values.map((value, k) => h("label", {}, boxes[k]!, h("span", {}, words(value))));
  return {
    element: h("fieldset", { class: "replay-choice" }, h("legend", {}, name), ...labels),
    set: (value: T) => boxes.forEach((box) => (box.checked = box.value === value)),
  };
}
