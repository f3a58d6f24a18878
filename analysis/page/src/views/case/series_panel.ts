// The series of a case: which are shown, whose lines lie over them, and the step that the cursor stands at.

import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { styleOfLabel } from "../../chart/palette";
import { swatch } from "../../chart/legend";
import { h } from "../../dom";
import { readableUnit, short } from "../../numbers";
import type { Page } from "../../view";
import { readSeries, type Series } from "../series_data";
import { drawSeries, type Line } from "./series_chart";

const CURSOR = "steps";
const FIRST = 6; // series shown before one asks for more

interface Member {
  caseId: string;
  label: string;
  series: Map<string, Series>;
}

export interface SeriesPanel {
  element: HTMLElement;
  dispose(): void;
}

/** @param caseIds the case, then its siblings whose series the report holds */
export async function seriesPanel(page: Page, caseIds: string[]): Promise<SeriesPanel> {
  const members = await Promise.all(
    caseIds.map(async (caseId): Promise<Member> => {
      const series = await readSeries(page.report.series, caseId);
      return { caseId, label: page.cases.text("label", page.cases.row(caseId)!), series: new Map(series.map((one) => [one.name, one])) };
    }),
  );
  const [own] = members;
  const all = [...own!.series.values()].filter(({ name }) => name !== "time" && name !== "window");
  const chosen = new Set(firstOf(all).map(({ name }) => name));
  const over = new Set(members.map(({ caseId }) => caseId));
  const charts = h("div", { class: "series-charts" });
  const plots: uPlot[] = [];
  const time = longestTime(members);
  const readout = h("output", { class: "step-readout" });
  const slider = h("input", { type: "range", min: 0, max: Math.max(time.length - 1, 0), value: 0, "aria-label": "step" });
  const draw = () => {
    plots.splice(0).forEach((plot) => plot.destroy());
    charts.replaceChildren();
    for (const series of all.filter(({ name }) => chosen.has(name))) {
      const lines = linesOf(page, members, over, series.name);
      const { unit, factor } = readableUnit(series.unit, largestOf(lines));
      const place = h("div", { class: "series-plot" });
      const title = h("h3", {}, series.name, h("small", {}, unit));
      charts.append(h("div", { class: "series-chart" }, title, h("p", { class: "chart-note" }, series.longName), place, ...missingWords(series, time)));
      plots.push(drawSeries(place, { unit, factor, time, lines, judged: judgedRanges(own!, time) }, CURSOR, Math.max(220, place.clientWidth)));
    }
    if (!chosen.size) charts.append(h("p", { class: "empty" }, "No series is chosen: choose some above."));
  };
  const point = () => {
    const step = Number(slider.value);
    readout.textContent = `step ${step}, ${short(time[step] ?? NaN)} s`;
    for (const plot of plots) plot.setCursor({ left: plot.valToPos(time[step]!, "x"), top: 10 });
  };
  slider.addEventListener("input", point);
  const resized = new ResizeObserver(() => {
    for (const plot of plots) {
      const width = plot.root.parentElement!.clientWidth;
      if (width && width !== plot.width) plot.setSize({ width, height: plot.height });
    }
  });
  resized.observe(charts);
  const stop = onTheme(draw);
  requestAnimationFrame(draw);
  const element = h(
    "div",
    {},
    ...(members.length > 1 ? [memberChips(page, members, over, draw)] : []),
    seriesChips(all, chosen, draw),
    h("label", { class: "step-slider" }, "cursor of all charts ", slider, readout),
    h("p", { class: "chart-note" }, "The band behind the lines is the window: the steps that the figures are taken over."),
    charts,
  );
  return {
    element,
    dispose() {
      stop();
      resized.disconnect();
      plots.splice(0).forEach((plot) => plot.destroy());
    },
  };
}

const FIRST_NAMES = ["tool_volume_inside_d", "depth_max_d", "facets_crossing_d", "displacement_mean", "collided_vertices", "time_handle"];

function firstOf(all: Series[]): Series[] {
  const isUsual = ({ name }: Series) => FIRST_NAMES.includes(name);
  return [...all.filter(isUsual), ...all.filter((series) => !isUsual(series))].slice(0, FIRST);
}

function largestOf(lines: Line[]): number {
  let largest = 0;
  for (const { values } of lines) for (const value of values) if (Math.abs(value) > largest) largest = Math.abs(value);
  return largest;
}

function linesOf(page: Page, members: Member[], over: Set<string>, name: string): Line[] {
  return members
    .filter(({ caseId, series }, place) => (place === 0 || over.has(caseId)) && series.has(name))
    .map(({ label, series }, place) => {
      const { colour, dash } = styleOfLabel(page.report.labels, label);
      return { label, colour, dash, values: series.get(name)!.values, isCase: place === 0 };
    })
    .reverse(); // the case itself lies on top
}

/** The end of each step; numbers of steps where the file has no times. */
function longestTime(members: Member[]): Float64Array {
  let longest = new Float64Array();
  for (const { series } of members) {
    const time = series.get("time")?.values ?? Float32Array.from([...series.values()][0]?.values ?? [], (_, step) => step);
    if (time.length > longest.length) longest = Float64Array.from(time);
  }
  return longest;
}

function judgedRanges(own: Member, time: Float64Array): [number, number][] {
  const window = own.series.get("window")?.values;
  if (!window) return [];
  const half = time.length > 1 ? (time[1]! - time[0]!) / 2 : 0;
  const ranges: [number, number][] = [];
  window.forEach((is, step) => {
    if (is !== 1) return;
    const last = ranges.at(-1);
    if (last && window[step - 1] === 1) last[1] = time[step]! + half;
    else ranges.push([time[step]! - half, time[step]! + half]);
  });
  return ranges;
}

/** Why steps have no value: "no value: no vertex collided in steps 0–3, 23–38 (of 91)". */
function missingWords(series: Series, time: Float64Array): HTMLElement[] {
  const ranges = (steps: [number, number][]) => steps.map(([a, b]) => (a === b ? String(a) : `${a}–${b}`)).join(", ");
  const said = series.missing.map(({ reason, steps }) => `${reason} in steps ${ranges(steps)}`);
  const without = series.values.reduce((sum, value) => sum + Number(Number.isNaN(value)), 0);
  if (!without) return [];
  return [h("p", { class: "chart-warning" }, `No value in ${without} of ${time.length} steps: ${said.join("; ") || "no reason recorded"}.`)];
}

function memberChips(page: Page, members: Member[], over: Set<string>, draw: () => void): HTMLElement {
  const chips = members.slice(1).map(({ caseId, label }) => {
    const mark = swatch(styleOfLabel(page.report.labels, label));
    return toggle([mark, label], over, caseId, draw);
  });
  return h("fieldset", { class: "chips" }, h("legend", {}, "beside it, under the same conditions"), ...chips);
}

function seriesChips(all: Series[], chosen: Set<string>, draw: () => void): HTMLElement {
  const chips = all.map(({ name, longName }) => toggle([name], chosen, name, draw, longName));
  const everything = h("button", { type: "button", class: "plain" }, "all");
  everything.addEventListener("click", () => {
    const isAll = chosen.size === all.length;
    chips.forEach((chip, k) => (isAll === chosen.has(all[k]!.name) ? (chosen[isAll ? "delete" : "add"](all[k]!.name), chip.setAttribute("aria-pressed", String(!isAll))) : undefined));
    draw();
  });
  return h("details", { class: "filters" }, h("summary", {}, `Series: choose from ${all.length}`), h("div", { class: "chips" }, ...chips, everything));
}

function toggle(content: (Node | string)[], set: Set<string>, name: string, draw: () => void, title = ""): HTMLButtonElement {
  const button = h("button", { type: "button", class: "chip", title, "aria-pressed": String(set.has(name)) }, ...content);
  button.addEventListener("click", () => {
    if (!set.delete(name)) set.add(name);
    button.setAttribute("aria-pressed", String(set.has(name)));
    draw();
  });
  return button;
}

/** Calls back when the page's colours change. */
function onTheme(change: () => void): () => void {
  const observer = new MutationObserver(change);
  observer.observe(document.documentElement, { attributes: true, attributeFilter: ["data-theme"] });
  const media = matchMedia("(prefers-color-scheme: dark)");
  media.addEventListener("change", change);
  return () => {
    observer.disconnect();
    media.removeEventListener("change", change);
  };
}
