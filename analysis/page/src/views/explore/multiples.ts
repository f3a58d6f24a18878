// The first chart: small multiples, a panel per value of one condition and a row of them per value of another.

import * as Plot from "@observablehq/plot";
import type { ChartParts, Drawing } from "../../chart/frame";
import { csvText } from "../../chart/csv";
import { legendOf } from "../../chart/legend";
import { styleOfLabel } from "../../chart/palette";
import type { Point } from "../../chart/tooltip";
import { h } from "../../dom";
import { leftOut, tally, together, total } from "../../groups";
import { grouped, short } from "../../numbers";
import { dotsAsPath } from "./dots";
import { panelsOf, type Panel, type PanelGroup, type Panels } from "./panels";
import { conditionWords, exact, pooled, type Shown } from "./shown";

const MOST_PANELS = 60;
const MARGIN = { left: 56, right: 8, top: 22 }; // px
const PANEL_HEIGHT = 150; // px
const LETTER = 6.2; // px

interface Layout {
  perLine: number;
  lines: number;
  turned: boolean; // the values along x stand at an angle
  stacked: boolean; // a panel's title takes two lines
  gap: number; // px between lines of panels
  height: number;
}

export function multiples(shown: Shown): ChartParts {
  const { page, state, column } = shown;
  const all = panelsOf(shown);
  const cut = all.panels.slice(MOST_PANELS);
  const panels = { ...all, panels: all.panels.slice(0, MOST_PANELS) };
  const split = [state.down, state.across, state.x].filter(Boolean);
  const over = pooled(shown, split);
  const log = state.scale === "log" ? " A logarithmic scale has no place for values of 0 and below: a panel says how many there are." : "";
  const how = state.form === "medians" ? "Points are medians over complete cases, bars their quartiles." : "A dot is a complete case, a bar its group's quartiles, the mark on it the median.";
  const out = leftOut(together(all.panels.flatMap(({ groups }) => groups)));
  return {
    name: `${state.figure}-by-${split.join("-") || "strategy"}`,
    title: `${state.figure}${state.x ? ` by ${state.x}` : ""}`,
    words: column.longName,
    unit: shown.unit,
    better: column.better,
    note: `${how}${over ? ` Over ${over}.` : ""}${log} A click on a point lists its cases.`,
    warning: [column.caution, out && `Not in any median: ${out}.`, cut.length && `${cut.length} more panels are not drawn: filter, or split by something else.`].filter(Boolean).join(" "),
    legend: legendOf(page.report.labels, shown.labels),
    draw: (width) => draw(shown, panels, width),
    csv: () => groupsCsv(shown, all),
  };
}

export function groupsCsv({ state, column }: Shown, { panels }: Panels): string {
  const split = [...new Set([state.down, state.across, state.x])].filter((name) => name && name !== "label");
  const value = (panel: Panel, group: PanelGroup, name: string) => (name === state.x ? group.x : name === state.across ? panel.across : panel.down);
  const head = [...split, "strategy", "figure", "unit", "cases", "failed", "without_value", "why", "median", "q1", "q3", "min", "max"];
  const rows = panels.flatMap((panel) =>
    panel.groups.map((group) => [
      ...split.map((name) => value(panel, group, name)),
      group.label, column.name, column.unit, group.rows.length, total(group.failed), total(group.lacking),
      tally(new Map([...group.failed, ...group.lacking])), group.median, group.q1, group.q3, group.values[0] ?? NaN, group.values.at(-1) ?? NaN,
    ]),
  );
  return csvText([head, ...rows]);
}

function layOut({ panels, xs, acrossCount }: Panels, width: number, labels: number): Layout {
  const least = Math.max(130, Math.min(xs.length * Math.max(20, labels * 5), 420));
  const perLine = Math.max(1, Math.min(acrossCount, Math.floor((width - MARGIN.left - MARGIN.right) / least)));
  const lines = Math.ceil(panels.length / perLine);
  const room = (width - MARGIN.left) / perLine / xs.length;
  const longest = Math.max(...xs.map((x) => x.length * LETTER));
  const turned = longest > room;
  const title = Math.max(...panels.map(({ across, down }) => (across.length + down.length + 3) * LETTER * 1.15));
  const stacked = title > (width - MARGIN.left) / perLine;
  const gap = (stacked ? 40 : 26) + (turned ? Math.min(longest, 90) * 0.6 + 10 : 18);
  return { perLine, lines, turned, stacked, gap, height: MARGIN.top + lines * (PANEL_HEIGHT + gap) - 8 };
}

function draw(shown: Shown, all: Panels, width: number): HTMLElement | Drawing {
  const { panels, xs } = all;
  if (!panels.some(({ groups }) => groups.some(({ values }) => values.length)))
    return h("p", { class: "empty" }, panels.length ? `No case here has a value of ${shown.state.figure}. ${leftOut(together(panels.flatMap(({ groups }) => groups)))}` : "No case matches the filters.");
  const layout = layOut(all, width, shown.labels.length);
  const place = panels.map((panel, k) => ({ panel, fx: k % layout.perLine, fy: Math.floor(k / layout.perLine) }));
  const svg = Plot.plot({
    width,
    height: layout.height,
    marginTop: MARGIN.top + (layout.stacked ? 14 : 0),
    marginLeft: MARGIN.left,
    marginRight: MARGIN.right,
    marginBottom: layout.gap - (layout.stacked ? 36 : 22),
    style: { fontSize: "11px", fontFamily: "system-ui, sans-serif", color: "var(--chart-ink)", background: "transparent" },
    fx: { axis: null, padding: 0.07, domain: range(layout.perLine) },
    fy: { axis: null, padding: layout.lines > 1 ? layout.gap / (PANEL_HEIGHT + layout.gap) : 0, domain: range(layout.lines), paddingOuter: 0 } as Plot.ScaleOptions,
    x: { domain: [-0.5, xs.length - 0.5], axis: null },
    y: { type: shown.state.scale === "log" ? "log" : "linear", label: null, nice: true, grid: true, zero: shown.state.scale !== "log", tickFormat: (value: number) => short(value) },
    marks: marksOf(shown, all, place, layout),
  }) as SVGSVGElement;
  return { svg, points: pointsOf(shown, place, svg, shown.labels) };
}

type Placed = { panel: Panel; fx: number; fy: number };

function marksOf(shown: Shown, { xs }: Panels, place: Placed[], { turned, stacked }: Layout): Plot.Markish[] {
  const { page, labels, factor, state } = shown;
  const isLog = state.scale === "log";
  const isOrdered = state.x !== "" && !page.cases.columns.get(state.x)!.levels;
  const title = ({ panel }: Placed) => [panel.across, panel.down].filter(Boolean).join(stacked ? "\n" : " · ");
  const marks: Plot.Markish[] = [
    Plot.frame({ stroke: "var(--chart-rule)" }),
    Plot.text(place, { fx: "fx", fy: "fy", text: title, frameAnchor: "top-left", dy: -7, lineAnchor: "bottom", fontWeight: 600, fill: "var(--chart-ink)" }),
    Plot.text(place.flatMap((at) => xs.map((x, k) => ({ ...at, x, k }))), {
      fx: "fx", fy: "fy", x: "k", text: "x", frameAnchor: "bottom", dy: 8, fill: "var(--chart-faint)",
      ...(turned ? { rotate: -38, textAnchor: "end" as const, lineAnchor: "middle" as const } : { lineAnchor: "top" as const }),
    }),
    Plot.text(place.filter(({ panel }) => counts(panel, isLog)), { fx: "fx", fy: "fy", text: ({ panel }: Placed) => counts(panel, isLog), frameAnchor: "top-right", dx: -4, dy: 5, lineAnchor: "top", fill: "var(--chart-warning)", stroke: "var(--chart-background)", strokeWidth: 3 }),
    Plot.text(place.filter(({ panel }) => !panel.groups.some(({ values }) => values.length)), { fx: "fx", fy: "fy", text: () => "no value", frameAnchor: "middle", fill: "var(--chart-faint)" }),
  ];
  labels.forEach((label, number) => {
    const { colour, dash, symbol } = styleOfLabel(page.report.labels, label);
    const dx = offset(number, labels.length);
    const points = place.flatMap(({ panel, fx, fy }) =>
      panel.groups.filter((group) => group.label === label && group.values.length && !(isLog && group.median <= 0)).map((group) => ({ fx, fy, group, x: group.place + dx })),
    );
    const at = { fx: "fx", fy: "fy", x: "x" } as const;
    const scaled = (name: "median" | "q1" | "q3") => (d: (typeof points)[number]) => Math.max(d.group[name] * factor, isLog ? Number.MIN_VALUE : -Infinity);
    if (state.form === "cases") {
      const cases = points.flatMap(({ fx, fy, group, x }) => casesOf(shown, group).map(({ value, row }) => ({ fx, fy, x: x + jitter(row) * (0.6 / labels.length), value: value * factor })));
      marks.push(dotsAsPath(isLog ? cases.filter(({ value }) => value > 0) : cases, colour));
    }
    marks.push(Plot.ruleX(points.filter(({ group }) => !(isLog && group.q1 <= 0)), { ...at, y1: scaled("q1"), y2: scaled("q3"), stroke: colour, strokeWidth: state.form === "cases" ? 3 : 1.4, strokeOpacity: state.form === "cases" ? 0.9 : 0.75 }));
    if (state.form === "medians" && isOrdered) marks.push(Plot.line(points, { ...at, y: scaled("median"), stroke: colour, strokeWidth: 1.4, strokeDasharray: dash }));
    marks.push(Plot.dot(points, { ...at, y: scaled("median"), symbol, r: 3.2, fill: colour, stroke: "var(--chart-background)", strokeWidth: 0.8 }));
  });
  return marks;
}

/** "2 failed, 3 no value" in the corner of a panel; the line below the chart says why. */
function counts(panel: Panel, isLog: boolean): string {
  const { failed, lacking } = together(panel.groups);
  const low = isLog ? panel.groups.reduce((sum, { values }) => sum + values.filter((value) => value <= 0).length, 0) : 0;
  return [failed.size && `${total(failed)} failed`, lacking.size && `${total(lacking)} no value`, low && `${low} at 0 or below`].filter(Boolean).join(", ");
}

function pointsOf(shown: Shown, place: Placed[], svg: SVGSVGElement, labels: string[]): Point[] {
  const at = pixels(svg);
  const points = place.flatMap(({ panel, fx, fy }) =>
    panel.groups
      .filter(({ values, median }) => values.length && !(shown.state.scale === "log" && median <= 0))
      .map((group) => {
        const x = group.place + offset(labels.indexOf(group.label), labels.length);
        return { ...at(fx, fy, x, group.median * shown.factor), lines: linesOf(shown, panel, group), choose: () => shown.choose(group.rows, nameOf(shown, panel, group)) };
      }),
  );
  return points;
}

function nameOf({ page, state }: Shown, panel: Panel, group: PanelGroup): string {
  const said = [[state.down, panel.down], [state.across, panel.across], [state.x, group.x]] as const;
  return [group.label, ...said.filter(([name]) => name).map(([name, value]) => conditionWords(page, name, value))].join(" · ");
}

function linesOf(shown: Shown, panel: Panel, group: PanelGroup): string[] {
  const lines = [
    nameOf(shown, panel, group),
    `median ${exact(shown, group.median)}`,
    `quartiles ${exact(shown, group.q1)} to ${exact(shown, group.q3)}`,
    `n = ${grouped(group.values.length)} of ${grouped(group.rows.length)} cases, ${total(group.failed)} failed`,
  ];
  const out = leftOut(group);
  return out ? [...lines, out] : lines;
}

/** Where a point of a panel lies in the drawing. */
export function pixels(svg: SVGSVGElement & Partial<Plot.Plot>): (fx: number, fy: number, x: number, y: number) => { x: number; y: number } {
  const scale = (name: Plot.ScaleName) => svg.scale!(name)!;
  const [fxs, fys, xs, ys] = [scale("fx"), scale("fy"), scale("x"), scale("y")];
  const left = Math.min(...(xs.range as number[]));
  const top = Math.min(...(ys.range as number[]));
  return (fx, fy, x, y) => ({ x: fxs.apply(fx) - left + xs.apply(x), y: fys.apply(fy) - top + ys.apply(y) });
}

/** The strategies of a place along x stand beside each other. */
export function offset(number: number, of: number): number {
  return of > 1 ? (number / (of - 1) - 0.5) * 0.66 : 0;
}

/** Between −0.5 and 0.5, the same for a case each time. */
export function jitter(row: number): number {
  return ((row * 0.6180339887) % 1) - 0.5;
}

function casesOf(shown: Shown, group: PanelGroup): { row: number; value: number }[] {
  const { cases } = shown.page;
  const status = cases.codes("status");
  const complete = status.levels.indexOf("complete");
  return group.rows
    .filter((row) => status.codes[row] === complete)
    .map((row) => ({ row, value: cases.number(shown.state.figure, row) }))
    .filter(({ value }) => Number.isFinite(value));
}

function range(count: number): number[] {
  return Array.from({ length: count }, (_, k) => k);
}
