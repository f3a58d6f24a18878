// A median and its interval as a small drawing inside a table.

import type { SeriesStyle } from "../../chart/palette";
import { amount, type Comparison } from "../overview_data";
import { svg } from "./svg";

const WIDTH = 150; // px
const HEIGHT = 22;
const SIDE = 6;

/** On a scale that all strategies of the comparison share, which begins at 0. */
export function intervalBar(comparison: Comparison, label: string, { colour }: SeriesStyle): (Node | string)[] {
  const numbers = (name: "median" | "low" | "high") => comparison.rows.map((row) => amount(row[name], 1)).filter(Number.isFinite);
  const all = [...numbers("median"), ...numbers("low"), ...numbers("high"), 0];
  const [least, most] = [Math.min(...all), Math.max(...all)];
  const row = comparison.rows.find((one) => one.label === label);
  if (!row || most === least || !Number.isFinite(amount(row.median, 1))) return ["–"];
  const x = (value: number) => SIDE + (Math.min(Math.max((value - least) / (most - least), 0), 1)) * (WIDTH - 2 * SIDE);
  const middle = HEIGHT / 2;
  const [low, high] = [amount(row.low, 1), amount(row.high, 1)];
  const bar = Number.isNaN(low) ? [] : [svg("line", { x1: x(low), x2: x(high), y1: middle, y2: middle, stroke: colour, "stroke-width": 5, "stroke-opacity": 0.45 })];
  return [
    svg(
      "svg",
      { width: WIDTH, height: HEIGHT, viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: "interval-bar", "aria-hidden": "true" },
      svg("line", { x1: SIDE, x2: WIDTH - SIDE, y1: middle, y2: middle, stroke: "var(--chart-rule)" }),
      ...bar,
      svg("line", { x1: x(amount(row.median, 1)), x2: x(amount(row.median, 1)), y1: 3, y2: HEIGHT - 3, stroke: colour, "stroke-width": 3 }),
    ),
  ];
}
