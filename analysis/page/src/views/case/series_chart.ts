// One series of a case, and of its siblings, over time. All charts of a view share one cursor.

import uPlot from "uplot";
import { computedColour } from "../../chart/palette";
import { short } from "../../numbers";

export interface Line {
  label: string;
  colour: string; // a CSS colour
  dash: string;
  values: Float32Array;
  isCase: boolean; // the case that is looked at
}

export interface SeriesChart {
  unit: string; // in which values are shown
  factor: number; // from the stored unit to it
  time: Float64Array;
  lines: Line[];
  judged: [number, number][]; // ranges of time that the figures cover
}

const HEIGHT = 170; // px

export function drawSeries(place: HTMLElement, chart: SeriesChart, cursor: string, width: number): uPlot {
  const ink = computedColour("var(--chart-faint)");
  const rule = computedColour("var(--chart-rule)");
  const band = computedColour("var(--chart-panel)");
  const { unit, factor } = chart;
  const padded = ({ values }: Line) => Array.from(chart.time, (_, k) => (k < values.length && !Number.isNaN(values[k]!) ? values[k]! * factor : null));
  const axis = { stroke: ink, grid: { stroke: rule, width: 1 }, ticks: { stroke: rule, width: 1, size: 4 }, font: "11px system-ui, sans-serif" };
  return new uPlot(
    {
      width,
      height: HEIGHT,
      cursor: { sync: { key: cursor }, drag: { x: false, y: false }, points: { size: 6 } },
      legend: { live: true },
      scales: { x: { time: false } },
      axes: [
        { ...axis, size: 28 },
        { ...axis, size: 52, values: (_plot, ticks) => ticks.map((tick) => short(tick)) },
      ],
      series: [
        { label: "time, s", value: (_plot, value) => (value === null ? "–" : short(value)) },
        ...chart.lines.map((line) => ({
          label: line.label,
          stroke: computedColour(line.colour),
          width: line.isCase ? 2 : 1.2,
          dash: line.dash === "none" ? [] : line.dash.split(" ").map(Number),
          points: { show: line.isCase && chart.time.length <= 120, size: 4 },
          value: (_plot: uPlot, value: number | null) => (value === null ? "–" : `${short(value)}${unit ? ` ${unit}` : ""}`),
        })),
      ],
      hooks: {
        drawClear: [
          (plot) => {
            plot.ctx.fillStyle = band;
            for (const [from, to] of chart.judged) {
              const [a, b] = [plot.valToPos(from, "x", true), plot.valToPos(to, "x", true)];
              plot.ctx.fillRect(a, plot.bbox.top, Math.max(b - a, 1), plot.bbox.height);
            }
          },
        ],
      },
    },
    [chart.time as unknown as number[], ...chart.lines.map(padded)],
    place,
  );
}
