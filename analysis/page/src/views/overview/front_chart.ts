// What is left inside against time: each strategy's medians with their intervals, and the Pareto front joined.

import * as Plot from "@observablehq/plot";
import { csvText } from "../../chart/csv";
import { chartFrame, type Drawing } from "../../chart/frame";
import { legendOf } from "../../chart/legend";
import { styleOfLabel } from "../../chart/palette";
import { h } from "../../dom";
import { short } from "../../numbers";
import type { Report } from "../../report";
import { amount, type Axis, type Front, type FrontPoint } from "../overview_data";
import { placeNames } from "./name_places";
import { svg } from "./svg";

type Drawn = Extract<Front, { x: Axis }>;

const HEIGHT = 400; // px
const LEFT = 60; // where the axis of what is left inside stands
const WAYS = { low: "lower is better", high: "higher is better" };
const TEXT = "font: 12px system-ui, sans-serif; fill: var(--chart-ink); paint-order: stroke; stroke: var(--chart-background); stroke-width: 3px; stroke-linejoin: round";

export function frontChart(report: Report): HTMLElement {
  const { front } = report.overview;
  if (!("x" in front)) return h("p", { class: "empty" }, `There is no front: ${front.why}.`);
  const undrawn = front.points.filter((point) => !isDrawn(point)).map(({ label }) => label);
  return chartFrame({
    name: "front",
    title: `${front.y.title}, against the time of handling`,
    unit: `${front.y.unit || "1"}, against ${front.x.unit}`,
    better: front.y.better,
    note: front.notes.join(" "),
    ...(undrawn.length ? { warning: `Not drawn, since half of its cases or more failed: ${undrawn.join(", ")}.` } : {}),
    legend: legendOf(report.labels, front.points.map(({ label }) => label)),
    draw: (width) => draw(report, front, width),
    csv: () => csvOf(front),
  });
}

function isDrawn({ x, y }: FrontPoint): boolean {
  return Number.isFinite(amount(x[0], 1)) && Number.isFinite(amount(y[0], 1));
}

function draw(report: Report, front: Drawn, width: number): HTMLElement | Drawing {
  const points = front.points.filter(isDrawn).map((point) => ({ ...point, own: styleOfLabel(report.labels, point.label), ...placed(front, point) }));
  if (!points.length) return h("p", { class: "empty" }, "Half of the cases or more failed with every strategy: there is no median to draw.");
  const onFront = points.filter((point) => point.onFront);
  const chart = Plot.plot({
    width,
    height: HEIGHT,
    marginLeft: LEFT,
    marginBottom: 42,
    marginTop: 16,
    marginRight: 20,
    style: { fontSize: "12px", fontFamily: "system-ui, sans-serif", color: "var(--chart-ink)", background: "transparent" },
    x: axisOptions(front.x, points.flatMap(({ at, ends }) => [at.x, ...ends.x]), width),
    y: axisOptions(front.y, points.flatMap(({ at, ends }) => [at.y, ...ends.y]), HEIGHT),
    marks: [
      Plot.line(onFront, { x: ({ at }) => at.x, y: ({ at }) => at.y, stroke: "var(--chart-faint)", strokeDasharray: "5 4", strokeWidth: 1.5 }),
      ...points.flatMap(({ at, ends, own, onFront: isOn }) => [
        Plot.link([at], { x1: ends.x[0], x2: ends.x[1], y1: at.y, y2: at.y, stroke: own.colour, strokeWidth: 1.6 }),
        Plot.link([at], { x1: at.x, x2: at.x, y1: ends.y[0], y2: ends.y[1], stroke: own.colour, strokeWidth: 1.6 }),
        Plot.dot([at], { x: "x", y: "y", r: 6, symbol: own.symbol, stroke: own.colour, strokeWidth: 2, fill: isOn ? own.colour : "var(--chart-background)" }),
      ]),
    ],
  }) as SVGSVGElement & Plot.Plot;
  const [x, y] = [chart.scale("x")!, chart.scale("y")!];
  const spots = points.map(({ at, label, failed }) => ({ x: x.apply(at.x) as number, y: y.apply(at.y) as number, words: failed ? `${label} ×` : label }));
  for (const { x: left, y: middle, words } of placeNames(spots, { left: LEFT + 4, right: width - 4, top: 4, bottom: HEIGHT - 48 })) {
    chart.append(svg("text", { x: left, y: middle, "text-anchor": "start", "dominant-baseline": "central", style: TEXT }, words));
  }
  return { svg: chart, points: points.map((point, place) => ({ x: spots[place]!.x, y: spots[place]!.y, lines: said(front, point) })) };
}

/** In the units that people read; an interval that does not exist, or has no end, ends at the median. */
function placed(front: Drawn, { x, y }: FrontPoint): { at: { x: number; y: number }; ends: { x: [number, number]; y: [number, number] } } {
  const known = (value: number, median: number) => (Number.isFinite(value) ? value : median);
  const of = ([median, low, high]: FrontPoint["x"], factor: number) => {
    const middle = amount(median, factor);
    return { middle, ends: [known(amount(low, factor), middle), known(amount(high, factor), middle)] as [number, number] };
  };
  const [across, up] = [of(x, front.x.factor), of(y, front.y.factor)];
  return { at: { x: across.middle, y: up.middle }, ends: { x: across.ends, y: up.ends } };
}

function axisOptions({ title, unit, better }: Axis, values: number[], length: number): Plot.ScaleOptions {
  const way = better ? `, ${WAYS[better]}` : "";
  const words = `${title.length * 6.5 > length - 120 ? title.split(/[,:]/)[0] : title}${unit ? `, ${unit}` : ""}`;
  const room = `${words}${way}`.length * 6.2 < length ? `${words}${way}` : words;
  const low = Math.min(0, ...values);
  return { domain: [low, Math.max(...values) * 1.04 || 1], label: room, grid: true, labelAnchor: "center", labelArrow: "none", ticks: Math.max(3, Math.floor(length / 90)), tickFormat: (value: number) => short(value) };
}

function said(front: Drawn, point: FrontPoint): string[] {
  const words = ({ title, unit, factor }: Axis, [median, low, high]: FrontPoint["x"]) => {
    const interval = low === null ? "" : ` (${short(amount(low, factor))}–${short(amount(high, factor))})`;
    return `${title}: ${short(amount(median, factor))}${unit ? ` ${unit}` : ""}${interval}`;
  };
  const failed = point.failed ? [`${point.failed} of ${point.cases} cases failed`] : [`${point.cases} cases, none failed`];
  return [point.label, words(front.y, point.y), words(front.x, point.x), ...failed, point.onFront ? "on the front" : "not on the front"];
}

function csvOf(front: Drawn): string {
  const ends = ["median", "low", "high"];
  const head = ["strategy", ...ends.map((end) => `${front.y.name} ${end}`), ...ends.map((end) => `${front.x.name} ${end}`), "cases", "failed", "on_front"];
  return csvText([head, ...front.points.map(({ label, x, y, cases, failed, onFront }) => [label, ...[...y, ...x].map((value) => value ?? ""), cases, failed, onFront ? "yes" : "no"])]);
}
