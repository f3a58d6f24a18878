// The third chart: what strategy A does to a figure that B does not, pair by pair under equal conditions and seeds.

import * as Plot from "@observablehq/plot";
import type { ChartParts, Drawing } from "../../chart/frame";
import { csvText } from "../../chart/csv";
import type { Point } from "../../chart/tooltip";
import { h } from "../../dom";
import { tally } from "../../groups";
import { counted, grouped, quantile, short } from "../../numbers";
import { dotsAsPath } from "./dots";
import { jitter } from "./multiples";
import { pairsOf, type Pair } from "./pairs";
import { conditionWords, exact, type Shown } from "./shown";

const HEIGHT = 260; // px
const LETTER = 6.2; // px

interface Place {
  x: string;
  pairs: Pair[];
  median: number;
  q1: number;
  q3: number;
}

export function pairedChart(shown: Shown): ChartParts {
  const { state, column, page } = shown;
  const { pairs, leftOut } = pairsOf(page.cases, shown.rows, state.figure, state.a, state.b);
  const places = placesOf(shown, pairs);
  const below = pairs.filter(({ difference }) => difference < 0).length;
  const above = pairs.filter(({ difference }) => difference > 0).length;
  const side = column.better && `${column.better === "low" ? "Below" : "Above"} the zero line ${state.a} is better.`;
  const conditions = [...page.cases.columns.values()].filter(({ part }) => part === "condition").map(({ name }) => name);
  return {
    name: `${state.figure}-${state.a}-minus-${state.b}`.replaceAll(/[^\w.-]+/g, "-"),
    title: `${state.figure}: ${state.a} − ${state.b}`,
    unit: shown.unit,
    better: column.better,
    note: `A dot is a pair of cases with equal conditions and seed, a bar the quartiles, a point the median of the differences. ${counted(pairs.length, "pair")}: ${grouped(below)} below zero, ${grouped(above)} above, ${grouped(pairs.length - below - above)} equal. ${side ?? ""}`,
    warning: [column.caution, leftOut.size && `Pairs left out: ${tally(leftOut)}.`].filter(Boolean).join(" "),
    draw: (width) => draw(shown, places, width),
    csv: () =>
      csvText([
        [...conditions, "figure", "unit", "a", "b", "case_a", "case_b", "value_a", "value_b", "difference"],
        ...pairs.map(({ a, b, difference }) => [
          ...conditions.map((name) => page.cases.text(name, a)),
          column.name, column.unit, state.a, state.b, page.cases.text("case_id", a), page.cases.text("case_id", b),
          page.cases.number(state.figure, a), page.cases.number(state.figure, b), difference,
        ]),
      ]),
  };
}

function placesOf({ page, state }: Shown, pairs: Pair[]): Place[] {
  const levels = state.x ? page.cases.codes(state.x).levels : [""];
  const found = new Map(levels.map((x) => [x, [] as Pair[]]));
  for (const pair of pairs) found.get(state.x ? page.cases.text(state.x, pair.a) : "")!.push(pair);
  return [...found]
    .filter(([, members]) => members.length)
    .map(([x, members]) => {
      const sorted = Float64Array.from(members, ({ difference }) => difference).sort();
      return { x, pairs: members, median: quantile(sorted, 0.5), q1: quantile(sorted, 0.25), q3: quantile(sorted, 0.75) };
    });
}

function draw(shown: Shown, places: Place[], width: number): HTMLElement | Drawing {
  const { state, factor } = shown;
  if (state.a === state.b) return h("p", { class: "empty" }, "A and B are the same strategy: choose two.");
  if (!places.length) return h("p", { class: "empty" }, `No pair of ${state.a} and ${state.b} has a value of ${state.figure} under equal conditions among the cases that the filters leave.`);
  const longest = Math.max(...places.map(({ x }) => x.length * LETTER));
  const turned = longest > (width - 80) / places.length;
  const dots = places.flatMap(({ pairs }, place) => pairs.map((pair) => ({ x: place + jitter(pair.a) * 0.5 - 0.12, value: pair.difference * factor })));
  const numbered = places.map((place, k) => ({ ...place, k: k + 0.28 }));
  const svg = Plot.plot({
    width,
    height: HEIGHT,
    marginLeft: 60,
    marginTop: 12,
    marginRight: 12,
    marginBottom: turned ? Math.min(longest, 120) * 0.62 + 34 : 40,
    style: { fontSize: "11px", fontFamily: "system-ui, sans-serif", color: "var(--chart-ink)", background: "transparent" },
    x: {
      domain: [-0.5, places.length - 0.5], ticks: places.map((_, k) => k), tickFormat: (k: number) => places[k]?.x ?? "", tickSize: 0,
      tickRotate: turned ? -38 : 0, label: state.x ? conditionWords(shown.page, state.x, "").replace("  ", ", ").trim() : null, labelAnchor: "center", labelArrow: "none",
    },
    y: { label: null, nice: true, grid: true, tickFormat: (value: number) => short(value) },
    marks: [
      Plot.ruleY([0], { stroke: "var(--chart-ink)", strokeWidth: 1.2 }),
      dotsAsPath(dots, "var(--series-6)"),
      Plot.ruleX(numbered, { x: "k", y1: ({ q1 }: Place) => q1 * factor, y2: ({ q3 }: Place) => q3 * factor, stroke: "var(--series-0)", strokeWidth: 4 }),
      Plot.dot(numbered, { x: "k", y: ({ median }: Place) => median * factor, r: 4.5, fill: "var(--series-0)", stroke: "var(--chart-background)", strokeWidth: 1.2 }),
    ],
  }) as SVGSVGElement & Plot.Plot;
  return { svg, points: pointsOf(shown, places, svg) };
}

function pointsOf(shown: Shown, places: Place[], svg: SVGSVGElement & Plot.Plot): Point[] {
  const [x, y] = [svg.scale("x")!, svg.scale("y")!];
  const { state } = shown;
  return places.map((place, k) => ({
    x: x.apply(k + 0.28),
    y: y.apply(place.median * shown.factor),
    lines: [
      `${state.a} − ${state.b}${state.x ? ` · ${conditionWords(shown.page, state.x, place.x)}` : ""}`,
      `median ${exact(shown, place.median)}`,
      `quartiles ${exact(shown, place.q1)} to ${exact(shown, place.q3)}`,
      `n = ${counted(place.pairs.length, "pair")}`,
    ],
    choose: () => shown.choose(place.pairs.flatMap(({ a, b }) => [a, b]), `pairs of ${state.a} and ${state.b}${state.x ? `, ${state.x} ${place.x}` : ""}`),
  }));
}
