// The legend that all charts share: colour, dash and mark of each strategy.

import { h } from "../dom";
import * as Plot from "@observablehq/plot";
import { styleOfLabel, type SeriesStyle } from "./palette";

export interface LegendEntry {
  label: string;
  style: SeriesStyle;
}

export function legendOf(labels: string[], shown: string[]): LegendEntry[] {
  return labels.filter((label) => shown.includes(label)).map((label) => ({ label, style: styleOfLabel(labels, label) }));
}

const SWATCH = 26; // px, wide
const LINE = 18; // px, high
const LETTER = 6.6; // px

/** A line with its mark, as the charts draw it. */
export function swatch({ colour, dash, symbol }: SeriesStyle): SVGSVGElement {
  const shared = { x: [0], y: [0], symbol, stroke: colour, fill: colour, r: 3.5 };
  const drawn = Plot.plot({
    width: SWATCH,
    height: 12,
    margin: 0,
    axis: null,
    x: { domain: [-1, 1] },
    y: { domain: [-1, 1] },
    className: "swatch",
    marks: [
      Plot.ruleY([0], { stroke: colour, strokeWidth: 1.6, strokeDasharray: dash }),
      Plot.dot([0], shared),
    ],
  }) as SVGSVGElement;
  drawn.querySelector("style")?.remove(); // else it would be part of the name of a button
  for (const part of drawn.querySelectorAll("[aria-label]")) part.removeAttribute("aria-label");
  drawn.setAttribute("aria-hidden", "true"); // the label stands beside it
  return drawn;
}

export function legend(entries: LegendEntry[]): HTMLElement {
  const item = ({ label, style }: LegendEntry) => h("li", {}, swatch(style), label);
  return h("ul", { class: "legend", "aria-label": "strategies" }, ...entries.map(item));
}

/** The same inside a drawing. */
export function legendSvg(entries: LegendEntry[], width: number): SVGSVGElement {
  const namespace = "http://www.w3.org/2000/svg";
  const all = document.createElementNS(namespace, "svg");
  let x = 0;
  let y = 0;
  for (const { label, style } of entries) {
    const wide = SWATCH + 6 + label.length * LETTER + 14;
    if (x > 0 && x + wide > width) [x, y] = [0, y + LINE];
    const drawn = swatch(style);
    drawn.setAttribute("x", String(x));
    drawn.setAttribute("y", String(y + 3));
    const text = document.createElementNS(namespace, "text");
    text.setAttribute("x", String(x + SWATCH + 5));
    text.setAttribute("y", String(y + 13));
    text.setAttribute("style", "font: 12px system-ui, sans-serif; fill: var(--chart-ink)");
    text.textContent = label;
    all.append(drawn, text);
    x += wide;
  }
  all.setAttribute("width", String(width));
  all.setAttribute("height", String(entries.length ? y + LINE + 4 : 0));
  return all;
}
