// The keyboard of the replay.

import { h } from "../dom";
import type { Wishes } from "./controls";
import { MOMENTS } from "./replay_data";

export interface CameraWishes {
  turn(right: number, down: number): void; // pixels
  pan(right: number, down: number): void;
  zoom(factor: number): void;
}

const TURN = 25; // pixels of a mouse that do the same as a key
const PAN = 30;
const ZOOM = 1.15;

/** @param last number of the timeline's last step */
export function onKeys(wishes: Wishes, camera: CameraWishes, last: number, until: AbortSignal): void {
  const plain: Record<string, () => void> = {
    " ": () => wishes.play(),
    ArrowRight: () => wishes.go(1),
    ArrowLeft: () => wishes.go(-1),
    ArrowUp: () => wishes.go(5),
    ArrowDown: () => wishes.go(-5),
    Home: () => wishes.scrub(0),
    End: () => wishes.scrub(last),
    "1": () => wishes.change({ moment: MOMENTS[0]! }),
    "2": () => wishes.change({ moment: MOMENTS[1]! }),
    "3": () => wishes.change({ moment: MOMENTS[2]! }),
    r: () => wishes.resetCamera(),
    "+": () => camera.zoom(1 / ZOOM),
    "=": () => camera.zoom(1 / ZOOM),
    "-": () => camera.zoom(ZOOM),
    a: () => camera.pan(PAN, 0),
    d: () => camera.pan(-PAN, 0),
    w: () => camera.pan(0, PAN),
    s: () => camera.pan(0, -PAN),
    Escape: () => wishes.change({ vertex: null }),
  };
  const shifted: Record<string, () => void> = {
    ArrowRight: () => camera.turn(TURN, 0),
    ArrowLeft: () => camera.turn(-TURN, 0),
    ArrowUp: () => camera.turn(0, -TURN),
    ArrowDown: () => camera.turn(0, TURN),
  };
  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || isForControl(event)) return;
    const act = (event.shiftKey && shifted[event.key]) || (event.shiftKey && event.key.startsWith("Arrow") ? undefined : plain[event.key]);
    if (!act) return;
    event.preventDefault();
    act();
  }, { signal: until });
}

/** Whether the key means something to the control that has the focus. */
function isForControl(event: KeyboardEvent): boolean {
  const target = event.target instanceof Element ? event.target : null;
  if (target?.closest("input[type=range], select, input[type=radio]")) return event.key.startsWith("Arrow") || ["Home", "End", " "].includes(event.key);
  return event.key === " " && Boolean(target?.closest("button, input, summary, a"));
}

export function keysHelp(): HTMLElement {
  const rows: [string, string][] = [
    ["Space", "play, pause"],
    ["← →", "a step back, a step on"],
    ["↓ ↑", "five steps back, five steps on"],
    ["Home, End", "first, last step"],
    ["1, 2, 3", "before handling, after handling, after deformation"],
    ["Shift + arrows, or drag", "turn"],
    ["W A S D, or drag with Shift, the right button or two fingers", "move"],
    ["+ −, or wheel or pinch", "nearer, further"],
    ["R", "camera as it started"],
    ["click on the organ", "pin a vertex; Escape lets it go"],
  ];
  return h("details", { class: "replay-help" },
    h("summary", {}, "Keyboard and mouse"),
    h("dl", {}, ...rows.flatMap(([keys, does]) => [h("dt", {}, keys), h("dd", {}, does)])),
  );
}
