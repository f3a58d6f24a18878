// A chart as every view shows it: its title, unit and which way is better, the drawing, and buttons that save the drawing as
// SVG and its data as CSV. The drawing follows the width of its place.

import "./palette.css";
import "./chart.css";
import { h } from "../dom";
import { grouped } from "../numbers";
import type { Better } from "../report";
import { csvRows } from "./csv";
import { legend, type LegendEntry } from "./legend";
import { saveFile, svgText } from "./save";
import { hoverPoints, type Point } from "./tooltip";

export interface Drawing {
  svg: SVGSVGElement;
  points: Point[]; // what is said of each
}

export interface ChartParts {
  name: string; // of the saved files, without extension
  title: string;
  unit: string;
  better: Better;
  words?: string; // what the figure is
  note?: string; // such as what an interval means
  warning?: string; // what must not be missed, such as cases that are left out
  legend?: LegendEntry[];
  draw(width: number): SVGSVGElement | HTMLElement | Drawing; // an HTMLElement says why there is nothing to draw
  csv(): string;
}

export interface Frame {
  element: HTMLElement;
  show(parts: ChartParts): void;
}

const MOST_ROWS = 500; // of the table

export function chartFrame(parts: ChartParts): HTMLElement {
  const frame = makeFrame();
  frame.show(parts);
  return frame.element;
}

/** A frame whose chart can be replaced. */
export function makeFrame(): Frame {
  const heading = h("div", { class: "chart-heading" });
  const place = h("div", { class: "chart-drawing" });
  const below = h("div", { class: "chart-below" });
  const element = h("figure", { class: "chart" }, h("figcaption", {}, heading), place, below);
  let parts: ChartParts | undefined;
  let width = 0;
  const draw = () => {
    if (!parts || !width) return;
    const drawn = parts.draw(width);
    if (drawn instanceof HTMLElement) return place.replaceChildren(drawn);
    const { svg, points } = drawn instanceof SVGSVGElement ? { svg: drawn, points: [] } : drawn;
    for (const part of svg.querySelectorAll("[aria-label]")) part.removeAttribute("aria-label"); // the drawing is one picture
    svg.setAttribute("role", "img");
    const keys = points.length ? " Arrow keys go from point to point." : "";
    svg.setAttribute("aria-label", `${parts.title}, ${unitWords(parts)}.${keys}`);
    place.replaceChildren(svg);
    hoverPoints(place, svg, points);
  };
  new ResizeObserver(([entry]) => {
    const next = Math.floor(entry!.contentRect.width);
    if (next === width && place.childElementCount) return;
    width = next;
    draw();
  }).observe(place);
  return {
    element,
    show(next) {
      parts = next;
      heading.replaceChildren(...headingOf(next, () => place.querySelector("svg")));
      below.replaceChildren(...belowOf(next, below.querySelector("details")?.open ?? false));
      width = Math.floor(place.clientWidth);
      draw();
    },
  };
}

const WAYS = { low: "↓ lower is better", high: "↑ higher is better" };

export function unitWords({ unit, better }: Pick<ChartParts, "unit" | "better">): string {
  return `${unit || "a plain number"} · ${better ? WAYS[better] : "neither way is better"}`;
}

function headingOf(parts: ChartParts, drawing: () => SVGSVGElement | null): Node[] {
  const saveSvg = () => {
    const svg = drawing();
    if (!svg) return;
    const copy = svg.cloneNode(true) as SVGSVGElement;
    copy.querySelector(".hover-ring")?.remove();
    const note = [parts.warning, parts.note].filter(Boolean).join(" ");
    const picture = { lines: [parts.title, unitWords(parts), parts.words ?? ""], legend: parts.legend ?? [], drawing: copy, note };
    saveFile(`${parts.name}.svg`, "image/svg+xml", svgText(picture));
  };
  const saveCsv = () => saveFile(`${parts.name}.csv`, "text/csv", parts.csv());
  const words = h(
    "div",
    { class: "chart-words" },
    h("span", { class: "chart-title" }, parts.title),
    h("span", { class: "chart-unit" }, unitWords(parts)),
    ...(parts.words ? [h("span", { class: "chart-unit" }, parts.words)] : []),
  );
  const buttons = h(
    "div",
    { class: "chart-buttons" },
    h("button", { type: "button", click: saveSvg, "aria-label": `Save as SVG: ${parts.title}` }, "SVG"),
    h("button", { type: "button", click: saveCsv, "aria-label": `Save as CSV: ${parts.title}` }, "CSV"),
  );
  return [h("div", { class: "chart-top" }, words, buttons), ...(parts.legend?.length ? [legend(parts.legend)] : [])];
}

function belowOf(parts: ChartParts, isOpen: boolean): Node[] {
  const nodes: Node[] = [];
  if (parts.warning) nodes.push(h("p", { class: "chart-warning" }, parts.warning));
  if (parts.note) nodes.push(h("p", { class: "chart-note" }, parts.note));
  const table = h("div", { class: "chart-table", tabindex: 0, role: "region", "aria-label": `Table: ${parts.title}` });
  const details = h("details", {}, h("summary", {}, "As a table"), table);
  const fill = () => details.open && !table.childElementCount && table.append(tableOf(parts.csv()));
  details.addEventListener("toggle", fill);
  details.open = isOpen;
  nodes.push(details);
  return nodes;
}

function tableOf(csv: string): HTMLElement {
  const [head = [], ...rows] = csvRows(csv);
  const shown = rows.slice(0, MOST_ROWS);
  const cell = (text: string) => h("td", /^-?[\d.]+(e[+-]?\d+)?$/.test(text) ? { class: "number" } : {}, text);
  const table = h(
    "table",
    {},
    h("thead", {}, h("tr", {}, ...head.map((name) => h("th", { scope: "col" }, name)))),
    h("tbody", {}, ...shown.map((row) => h("tr", {}, ...row.map(cell)))),
  );
  if (shown.length === rows.length) return table;
  return h("div", {}, table, h("p", {}, `The first ${grouped(MOST_ROWS)} of ${grouped(rows.length)} rows; the CSV has all.`));
}
