// The small multiples: what is in each panel, before it is drawn.

import type { Cases } from "../../cases";
import { grouped, leftOut, together, type Group } from "../../groups";
import type { Shown } from "./shown";

export interface Panel {
  across: string;
  down: string;
  groups: PanelGroup[];
  leftOut: string; // what failed or has no value, in words
}

export interface PanelGroup extends Group {
  label: string;
  x: string;
  place: number; // of x, from 0
}

export interface Panels {
  panels: Panel[];
  xs: string[]; // values along x
  acrossCount: number; // panels side by side, where there is room
}

const NOTHING = "";

/** A panel for each pair of values that has cases. */
export function panelsOf({ page, state, rows }: Pick<Shown, "page" | "state" | "rows">): Panels {
  const { cases } = page;
  const wanted = [state.down, state.across, state.x, "label"];
  const columns = [...new Set(wanted)].filter(Boolean);
  const groups = grouped(cases, rows, columns, state.figure);
  const key = (group: Group, name: string) => (name ? group.keys[columns.indexOf(name)]! : NOTHING);
  const xs = present(cases, groups.map((group) => key(group, state.x)), state.x);
  const panels = new Map<string, Panel>();
  for (const group of groups) {
    const [down, across, x] = [key(group, state.down), key(group, state.across), key(group, state.x)];
    const name = JSON.stringify([down, across]);
    const panel = panels.get(name) ?? { across, down, groups: [], leftOut: "" };
    panel.groups.push({ ...group, label: key(group, "label"), x, place: xs.indexOf(x) });
    panels.set(name, panel);
  }
  for (const panel of panels.values()) panel.leftOut = leftOut(together(panel.groups));
  const acrossCount = new Set([...panels.values()].map(({ across }) => across)).size;
  return { panels: [...panels.values()], xs, acrossCount };
}

/** The values that occur, in the column's order. */
function present(cases: Cases, values: string[], column: string): string[] {
  const found = new Set(values);
  return column ? cases.codes(column).levels.filter((level) => found.has(level)) : [NOTHING];
}
