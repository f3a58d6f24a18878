// A chart as every view shows it: its title, unit and which way is better, the drawing, and buttons that save the drawing as
// SVG and its data as CSV.

import { h } from "../dom";
import type { Better } from "../report";

export interface ChartParts {
  name: string; // of the saved files, without extension
  title: string;
  unit: string;
  better: Better;
  note?: string; // such as what an interval means
  draw(width: number): SVGSVGElement | HTMLElement;
  csv(): string;
}

export function chartFrame(parts: ChartParts): HTMLElement {
  const figure = h("figure", { class: "chart" }, h("figcaption", {}, parts.title));
  figure.append(parts.draw(600));
  return figure;
}
