// The critical-difference diagram (Demšar 2006): strategies on an axis of mean ranks, the best on the right, and bars across
// those that the ranks do not tell apart. The counterpart of analysis/trocar_analysis/critical_difference.py.

import { csvText } from "../../chart/csv";
import type { ChartParts, Drawing } from "../../chart/frame";
import { styleOfLabel } from "../../chart/palette";
import type { Report } from "../../report";
import type { Comparison, Ranks, Row } from "../overview_data";
import { levels, nameRows } from "./rank_layout";
import { svg } from "./svg";

const SIDE = 14; // px, from the drawing's edge to the axis
const DIFFERENCE = 14; // heights, px
const AXIS = 52;
const FIRST_BAR = 10; // below the axis
const BAR_STEP = 9;
const OVERHANG = 5; // of a bar beyond the outermost ranks
const NAME_STEP = 22;
const TEXT = "font: 12px system-ui, sans-serif; fill: var(--chart-ink)";
const HALO = `${TEXT}; paint-order: stroke; stroke: var(--chart-background); stroke-width: 4px; stroke-linejoin: round`;
const FAINT = "font: 11px system-ui, sans-serif; fill: var(--chart-faint)";

/** Of strategies that are ranked. */
export function criticalDifference(report: Report, { ranks, rows, name, title, better, why }: Comparison): ChartParts {
  if (!ranks) throw new Error(`${name}: no ranks to draw (${why})`);
  const test = `${ranks.blocks} blocks${ranks.leftOut ? `; ${ranks.leftOut} left out, where one has no value` : ""}. That all rank alike: ${ranks.p} (Friedman, Iman and Davenport). CD: Nemenyi, α = 0.05.`;
  return {
    name: `ranks-${name.replaceAll("/", "-per-")}`,
    title,
    unit: "mean rank (1 is best)",
    better: "low",
    note: [`Ranked by ${name}, of which ${better === "high" ? "higher" : "lower"} is better.`, test].join(" "),
    draw: (width) => draw(report, rows, ranks, width),
    csv: () =>
      csvText([
        ["strategy", "figure", "mean_rank", "blocks", "critical_difference"],
        ...rows.map(({ label, meanRank }) => [label, name, meanRank ?? NaN, ranks.blocks, ranks.difference]),
      ]),
  };
}

function draw(report: Report, rows: Row[], ranks: Ranks, width: number): Drawing {
  const count = rows.length;
  const x = (rank: number) => SIDE + ((count - rank) / (count - 1)) * (width - 2 * SIDE);
  const rankOf = new Map(rows.map(({ label, meanRank }) => [label, meanRank ?? count]));
  const bars = levels(ranks.groups.map((group) => ({ best: x(rankOf.get(group[0]!)!), worst: x(rankOf.get(group.at(-1)!)!) })), 4 * OVERHANG);
  const top = AXIS + FIRST_BAR + bars.length * BAR_STEP + 18;
  const names = nameRows(rows.map((row) => ({ row, x: x(row.meanRank ?? count), words: words(row) })), width);
  const height = top + Math.max(...names.map(({ level }) => level)) * NAME_STEP + 12;
  const drawing = svg("svg", { width, height, viewBox: `0 0 ${width} ${height}` });
  drawing.append(...axis(count, x), ...difference(ranks.difference, count, x));
  const lines = names.map(({ row, x: at, level, onRight }) => {
    const { colour } = styleOfLabel(report.labels, row.label);
    return svg("path", { d: `M${at},${AXIS}V${top + level * NAME_STEP}H${onRight ? width - 2 : 2}`, fill: "none", stroke: colour, "stroke-width": 1.6 });
  });
  const texts = names.map(({ words: said, level, onRight }) =>
    svg("text", { x: onRight ? width - 2 : 2, y: top + level * NAME_STEP - 5, "text-anchor": onRight ? "end" : "start", style: HALO }, said),
  );
  drawing.append(...lines, ...texts); // no line through a name
  bars.forEach((level, number) => {
    const y = AXIS + FIRST_BAR + number * BAR_STEP;
    for (const { best, worst } of level) drawing.append(line(worst - OVERHANG, best + OVERHANG, y, y, 4));
  });
  const points = rows.map((row) => ({ x: x(row.meanRank ?? count), y: AXIS, lines: [row.label, `mean rank ${row.meanRank}`, `over ${ranks.blocks} blocks`, ...(row.failed ? [`${row.failed} of ${row.cases} cases failed`] : [])] }));
  return { svg: drawing, points };
}

function words(row: Row): string {
  return `${row.label}  ${row.meanRank?.toFixed(2) ?? "–"}${row.failed ? `, ${row.failed} failed` : ""}`;
}

function axis(count: number, x: (rank: number) => number): SVGElement[] {
  const ticks = Array.from({ length: count }, (_, place) => place + 1);
  return [
    line(x(count), x(1), AXIS, AXIS, 1.2),
    ...ticks.map((rank) => line(x(rank), x(rank), AXIS - 5, AXIS, 1.2)),
    ...ticks.map((rank) => svg("text", { x: x(rank), y: AXIS - 9, "text-anchor": "middle", style: FAINT }, String(rank))),
  ];
}

/** A line as long as it is; only its length in numbers where the axis is too short for it. */
function difference(length: number, count: number, x: (rank: number) => number): SVGElement[] {
  const said = `CD ${length.toFixed(2)}`;
  if (length > count - 1) return [svg("text", { x: x(count), y: DIFFERENCE + 4, style: FAINT }, `${said}, more than ranks can differ`)];
  const [left, right] = [x(count), x(count - length)];
  return [
    line(left, right, DIFFERENCE, DIFFERENCE, 2),
    ...[left, right].map((end) => line(end, end, DIFFERENCE - 4, DIFFERENCE + 4, 2)),
    svg("text", { x: right + 7, y: DIFFERENCE + 4, style: FAINT }, said),
  ];
}

function line(x1: number, x2: number, y1: number, y2: number, width: number): SVGElement {
  return svg("line", { x1, x2, y1, y2, stroke: "var(--chart-ink)", "stroke-width": width });
}
