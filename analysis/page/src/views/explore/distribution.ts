// The second chart: of each strategy, the share of cases up to each value.

import * as Plot from "@observablehq/plot";
import type { ChartParts, Drawing } from "../../chart/frame";
import { csvText } from "../../chart/csv";
import { legendOf } from "../../chart/legend";
import { styleOfLabel } from "../../chart/palette";
import { h } from "../../dom";
import { grouped as groupsBy, leftOut, together, type Group } from "../../groups";
import { grouped, short } from "../../numbers";
import { exact, type Shown } from "./shown";

const HEIGHT = 280; // px
const SAID = 40; // places of a curve that say their value

export function distribution(shown: Shown): ChartParts {
  const { page, state, column } = shown;
  const groups = groupsBy(page.cases, shown.rows, ["label"], state.figure);
  const out = leftOut(together(groups));
  return {
    name: `${state.figure}-distribution`,
    title: `Distribution of ${state.figure} over the cases`,
    unit: shown.unit,
    better: column.better,
    note: "A curve rises at a value by the share of its strategy's complete cases that have it. All conditions that the filters leave are in it." + (state.scale === "log" ? " On a logarithmic scale it begins above 0, at the share that is at 0 or below." : ""),
    warning: out && `Not in any curve: ${out}.`,
    legend: legendOf(page.report.labels, shown.labels),
    draw: (width) => draw(shown, groups, width),
    csv: () =>
      csvText([
        ["strategy", "figure", "unit", "value", "share"],
        ...groups.flatMap(({ keys, values }) => Array.from(values, (value, k) => [keys[0]!, column.name, column.unit, value, (k + 1) / values.length])),
      ]),
  };
}

function draw(shown: Shown, groups: Group[], width: number): HTMLElement | Drawing {
  const isLog = shown.state.scale === "log";
  const withValues = groups.filter(({ values }) => values.length);
  if (!withValues.length) return h("p", { class: "empty" }, `No case here has a value of ${shown.state.figure}. ${leftOut(together(groups))}`);
  const curves = withValues.map((group) => ({ label: group.keys[0]!, group, points: steps(group.values, shown.factor).filter(({ value }) => !isLog || value > 0) }));
  const svg = Plot.plot({
    width,
    height: HEIGHT,
    marginLeft: 56,
    marginBottom: 36,
    marginTop: 10,
    marginRight: 12,
    style: { fontSize: "11px", fontFamily: "system-ui, sans-serif", color: "var(--chart-ink)", background: "transparent" },
    x: { type: isLog ? "log" : "linear", label: `${shown.state.figure}${shown.unit ? `, ${shown.unit}` : ""}`, labelAnchor: "center", labelArrow: "none", nice: true, ticks: Math.max(3, Math.floor(width / 90)), tickFormat: (value: number) => short(value) },
    y: { domain: [0, 100], label: null, grid: true, tickFormat: (share: number) => `${share} %` },
    marks: [
      Plot.ruleY([0], { stroke: "var(--chart-rule)" }),
      ...curves.map(({ label, points }) => {
        const { colour, dash } = styleOfLabel(shown.page.report.labels, label);
        return Plot.line(points, { x: "value", y: "share", curve: "step-after", stroke: colour, strokeDasharray: dash, strokeWidth: 1.6 });
      }),
    ],
  }) as SVGSVGElement & Plot.Plot;
  const [x, y] = [svg.scale("x")!, svg.scale("y")!];
  const points = curves.flatMap(({ label, group, points }) =>
    sample(points).map(({ value, share }) => ({
      x: x.apply(value),
      y: y.apply(share),
      lines: [label, `${short(share)} % of its cases have ${exact({ factor: 1, unit: shown.unit }, value)} or less`, `n = ${grouped(group.values.length)} of ${grouped(group.rows.length)} cases`, ...[leftOut(group)].filter(Boolean)],
      choose: () => shown.choose(group.rows, label),
    })),
  );
  return { svg, points };
}

/** The curve's corners: each different value with the share up to it, in percent. */
function steps(values: Float64Array, factor: number): { value: number; share: number }[] {
  const corners: { value: number; share: number }[] = [{ value: values[0]! * factor, share: 0 }];
  values.forEach((value, k) => {
    if (value !== values[k + 1]) corners.push({ value: value * factor, share: (100 * (k + 1)) / values.length });
  });
  return corners;
}

function sample<T>(all: T[]): T[] {
  const step = Math.max(1, Math.floor(all.length / SAID));
  return all.filter((_, k) => k > 0 && (k % step === 0 || k === all.length - 1));
}
