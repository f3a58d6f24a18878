// What the explore view shows. It stands in the address, so that a link restores it.

import type { Cases } from "../../cases";
import { differingColumns, queryOf, readFilters, writeFilters, type Filters } from "../../filters";

export interface ExploreState {
  filters: Filters;
  figure: string;
  x: string; // a column; "" for none
  across: string;
  down: string;
  form: "medians" | "cases";
  scale: "linear" | "log";
  a: string; // the two strategies whose pairs are looked at, by label
  b: string;
}

const USUAL = ["tool_volume_inside_d_max", "depth_max_d_max", "facets_crossing_d_mean", "displacement_mean_mean", "time_handle_p99", "time_cycle_p50"];

export function figuresOf(cases: Cases): string[] {
  return [...cases.columns.values()].filter(({ role }) => role === "figure").map(({ name }) => name);
}

/** Those that are shown first of all, as far as the file has them. */
export function usualFigures(cases: Cases): string[] {
  const figures = figuresOf(cases);
  const usual = USUAL.filter((name) => figures.includes(name));
  return usual.length ? usual : figures.slice(0, 4);
}

/** By what charts can be split. */
export function splitColumns(cases: Cases): string[] {
  return differingColumns(cases).filter((name) => name !== "label" && name !== "status");
}

export function usualState(cases: Cases, labels: string[]): ExploreState {
  const columns = splitColumns(cases).filter((name) => name !== "seed" && cases.columns.get(name)!.part === "condition");
  const isNumber = (name: string) => !cases.columns.get(name)!.levels;
  const x = columns.find(isNumber) ?? columns[0] ?? "";
  const others = columns.filter((name) => name !== x);
  const size = (name: string) => cases.codes(name).levels.length;
  const [first = "", second = ""] = others;
  const [down, across] = second && size(first) > size(second) ? [second, first] : second ? [first, second] : ["", first];
  return {
    filters: new Map(),
    figure: usualFigures(cases)[0] ?? "",
    x,
    across,
    down,
    form: "medians",
    scale: "linear",
    a: labels[0] ?? "",
    b: labels[1] ?? labels[0] ?? "",
  };
}

/** The state that an address means, and what in it means nothing here. */
export function readState(hash: string, cases: Cases, labels: string[]): { state: ExploreState; wrong: string[] } {
  const query = queryOf(hash);
  const state = usualState(cases, labels);
  const { filters, wrong } = readFilters(query, cases);
  state.filters = filters;
  const take = (name: "figure" | "x" | "across" | "down" | "form" | "scale" | "a" | "b", known: string[]) => {
    const value = query.get(name);
    if (value === null) return;
    if (known.includes(value)) Object.assign(state, { [name]: value });
    else wrong.push(`${name}=${value}`);
  };
  const columns = ["", ...splitColumns(cases)];
  take("figure", figuresOf(cases));
  take("x", columns);
  take("across", columns);
  take("down", columns);
  take("form", ["medians", "cases"]);
  take("scale", ["linear", "log"]);
  take("a", labels);
  take("b", labels);
  return { state, wrong };
}

/** The address of a state: only what is not as usual stands in it. */
export function addressOf(state: ExploreState, usual: ExploreState): string {
  const query = new URLSearchParams();
  for (const name of ["figure", "x", "across", "down", "form", "scale", "a", "b"] as const) {
    if (state[name] !== usual[name]) query.set(name, state[name]);
  }
  writeFilters(state.filters, query);
  const text = query.toString();
  return `#/explore${text ? `?${text}` : ""}`;
}
