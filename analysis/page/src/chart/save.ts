// Saving what a chart shows: its data as CSV, its drawing as an SVG file that needs nothing of the page.

import { legendSvg, type LegendEntry } from "./legend";

export function saveFile(name: string, type: string, text: string): void {
  const address = URL.createObjectURL(new Blob([text], { type }));
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

export interface Picture {
  lines: string[]; // above the drawing; the first is the title
  legend: LegendEntry[];
  drawing: SVGSVGElement;
  note: string;
}

const NAMESPACE = "http://www.w3.org/2000/svg";
const LINE = 18; // px
const MARGIN = 12; // px
const INHERITED = ["fill", "stroke", "color", "font-family", "font-size", "font-weight", "stroke-opacity", "fill-opacity"];

/** The text of an SVG file with title, legend and drawing, in the colours of the theme that is shown. */
export function svgText(picture: Picture): string {
  const width = picture.drawing.width.baseVal.value;
  const page = document.createElementNS(NAMESPACE, "svg");
  let top = MARGIN;
  const text = (line: string, size: number, colour: string) => {
    for (const part of wrapped(line, width, size)) {
      top += LINE;
      const element = document.createElementNS(NAMESPACE, "text");
      element.setAttribute("y", String(top - 4));
      element.setAttribute("style", `font: ${size}px system-ui, sans-serif; fill: ${colour}`);
      element.textContent = part;
      page.append(element);
    }
  };
  picture.lines.forEach((line, place) => text(line, place ? 12 : 15, place ? "var(--chart-faint)" : "var(--chart-ink)"));
  const legend = legendSvg(picture.legend, width);
  const drawing = picture.drawing.cloneNode(true) as SVGSVGElement;
  for (const part of [legend, drawing]) {
    part.setAttribute("y", String(top));
    top += Number(part.getAttribute("height"));
    page.append(part);
  }
  text(picture.note, 11, "var(--chart-faint)");
  const height = top + MARGIN;
  page.setAttribute("viewBox", `${-MARGIN} 0 ${width + 2 * MARGIN} ${height}`);
  page.setAttribute("width", String(width + 2 * MARGIN));
  page.setAttribute("height", String(height));
  const paper = document.createElementNS(NAMESPACE, "rect");
  for (const [name, value] of Object.entries({ x: -MARGIN, width: width + 2 * MARGIN, height })) paper.setAttribute(name, String(value));
  paper.setAttribute("style", "fill: var(--chart-background)");
  page.prepend(paper);
  return selfContained(page);
}

/** What the page's style sheets and variables make of each part is written into it. */
function selfContained(page: SVGSVGElement): string {
  const place = document.createElement("div");
  place.className = "chart-saving";
  place.append(page);
  document.body.append(place);
  for (const element of page.querySelectorAll<SVGElement>("*")) {
    const style = getComputedStyle(element);
    for (const name of INHERITED) {
      const value = style.getPropertyValue(name);
      const parent = element.parentElement && getComputedStyle(element.parentElement).getPropertyValue(name);
      if (value !== parent || element.hasAttribute(name)) element.setAttribute(name, value);
    }
    if (element.localName === "svg") element.setAttribute("overflow", "visible");
  }
  place.remove();
  for (const style of page.querySelectorAll("style")) style.remove();
  for (const element of page.querySelectorAll("*")) for (const name of ["style", "class"]) element.removeAttribute(name);
  return new XMLSerializer().serializeToString(page);
}

function wrapped(line: string, width: number, size: number): string[] {
  const most = Math.max(20, Math.floor(width / (size * 0.5)));
  const lines: string[] = [];
  for (const word of line.split(" ").filter(Boolean)) {
    const last = lines.at(-1);
    if (last !== undefined && last.length + word.length < most) lines[lines.length - 1] = `${last} ${word}`;
    else lines.push(word);
  }
  return lines;
}
