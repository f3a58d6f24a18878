// What the replay shows, as the address says it: #/replay/ID,ID?step=12&moment=handled&color=strain. What is as it is without
// being said is not in the address.

import { FIELDS, type Field } from "./fields";
import { MOMENTS, type Moment } from "./replay_data";

export type Surface = "solid" | "wire" | "both";
export const SURFACES: readonly Surface[] = ["solid", "wire", "both"];

/** What can be shown or hidden. */
export const PARTS = ["tool", "moved", "vectors", "crossing"] as const;
export type Part = (typeof PARTS)[number];

export const SPEEDS = [0.05, 0.1, 0.25, 0.5, 1];

export interface Shown {
  step: number | null; // null: the deepest
  moment: Moment;
  color: Field;
  surface: Surface;
  hidden: Part[];
  cut: boolean; // the section through the tool's axis
  through: boolean; // playing goes through the three moments of each step
  speed: number; // of time
  vertex: number | null; // the pinned one
  camera: number[] | null; // where it looks at, x, y, z; from how far; from which side and height, degrees. null: as it starts
  bare: boolean; // without controls: for pictures
}

export const DEFAULTS: Shown = {
  step: null,
  moment: "handled",
  color: "none",
  surface: "both",
  hidden: [],
  cut: true,
  through: true,
  speed: 0.1,
  vertex: null,
  camera: null,
  bare: false,
};

export function readAddress(hash: string): Shown {
  const said = new URLSearchParams(hash.split("?")[1] ?? "");
  const oneOf = <T extends string>(name: string, allowed: readonly T[], otherwise: T): T =>
    allowed.find((value) => value === said.get(name)) ?? otherwise;
  const whole = (name: string) => (/^\d+$/.test(said.get(name) ?? "") ? Number(said.get(name)) : null);
  const camera = (said.get("camera") ?? "").split(",").map(Number);
  const speed = Number(said.get("speed"));
  return {
    step: whole("step"),
    moment: oneOf("moment", MOMENTS, DEFAULTS.moment),
    color: oneOf("color", Object.keys(FIELDS) as Field[], DEFAULTS.color),
    surface: oneOf("surface", SURFACES, DEFAULTS.surface),
    hidden: PARTS.filter((part) => (said.get("hide") ?? "").split(",").includes(part)),
    cut: said.get("cut") !== "0",
    through: said.get("through") !== "0",
    speed: SPEEDS.includes(speed) ? speed : DEFAULTS.speed,
    vertex: whole("vertex"),
    camera: camera.length === 6 && camera.every(Number.isFinite) ? camera : null,
    bare: said.get("bare") === "1",
  };
}

export function writeAddress(caseIds: string[], shown: Shown): string {
  const said: [string, string, boolean][] = [
    ["step", String(shown.step), shown.step !== null],
    ["moment", shown.moment, shown.moment !== DEFAULTS.moment],
    ["color", shown.color, shown.color !== DEFAULTS.color],
    ["surface", shown.surface, shown.surface !== DEFAULTS.surface],
    ["hide", shown.hidden.join(), shown.hidden.length > 0],
    ["cut", "0", !shown.cut],
    ["through", "0", !shown.through],
    ["speed", String(shown.speed), shown.speed !== DEFAULTS.speed],
    ["vertex", String(shown.vertex), shown.vertex !== null],
    ["camera", (shown.camera ?? []).join(), shown.camera !== null],
    ["bare", "1", shown.bare],
  ];
  const query = said.filter(([, , isSaid]) => isSaid).map(([name, value]) => `${name}=${value}`);
  return `#/replay/${caseIds.join()}${query.length ? `?${query.join("&")}` : ""}`;
}
