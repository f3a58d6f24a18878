// What a chart says of the point under the pointer, or of the one that the arrow keys have come to.

import { h } from "../dom";

export interface Point {
  x: number; // in the drawing's px
  y: number;
  lines: string[]; // the first is its name
  choose?: () => void; // on a click, or Enter
}

const REACH = 24; // px

/** @param frame what the tooltip stands in: its position is relative */
export function hoverPoints(frame: HTMLElement, drawing: SVGSVGElement, points: Point[]): void {
  if (!points.length) return;
  const tip = h("div", { class: "tooltip", role: "status", hidden: true });
  const ring = document.createElementNS("http://www.w3.org/2000/svg", "circle");
  ring.setAttribute("r", "7");
  ring.setAttribute("class", "hover-ring");
  ring.setAttribute("visibility", "hidden");
  drawing.append(ring);
  frame.append(tip);
  let shown = -1;
  const hide = () => {
    shown = -1;
    tip.hidden = true;
    ring.setAttribute("visibility", "hidden");
  };
  const show = (place: number) => {
    const point = points[place];
    if (!point) return hide();
    shown = place;
    tip.replaceChildren(...point.lines.map((line, k) => h(k ? "div" : "strong", {}, line)));
    tip.hidden = false;
    ring.setAttribute("cx", String(point.x));
    ring.setAttribute("cy", String(point.y));
    ring.setAttribute("visibility", "visible");
    const scale = drawing.getBoundingClientRect().width / drawing.width.baseVal.value;
    const left = drawing.getBoundingClientRect().left - frame.getBoundingClientRect().left + point.x * scale;
    const top = drawing.getBoundingClientRect().top - frame.getBoundingClientRect().top + point.y * scale;
    const room = frame.clientWidth - tip.offsetWidth;
    tip.style.left = `${Math.max(0, Math.min(left + 12, room))}px`;
    tip.style.top = `${left + 12 > room ? top + 14 : top - tip.offsetHeight / 2}px`;
  };
  drawing.addEventListener("pointermove", (event) => show(nearest(drawing, points, event)));
  drawing.addEventListener("pointerleave", hide);
  drawing.addEventListener("click", (event) => points[nearest(drawing, points, event)]?.choose?.());
  drawing.addEventListener("keydown", (event) => {
    const by = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (by) show((shown + by + points.length) % points.length);
    else if (event.key === "Home") show(0);
    else if (event.key === "End") show(points.length - 1);
    else if (event.key === "Enter") points[shown]?.choose?.();
    else if (event.key === "Escape") hide();
    else return;
    event.preventDefault();
  });
  drawing.addEventListener("focus", () => drawing.matches(":focus-visible") && show(Math.max(shown, 0)));
  drawing.addEventListener("blur", hide);
  drawing.setAttribute("tabindex", "0");
  drawing.classList.toggle("has-choice", points.some(({ choose }) => choose));
}

function nearest(drawing: SVGSVGElement, points: Point[], event: MouseEvent): number {
  const box = drawing.getBoundingClientRect();
  const scale = drawing.width.baseVal.value / box.width;
  const x = (event.clientX - box.left) * scale;
  const y = (event.clientY - box.top) * scale;
  let best = -1;
  let least = REACH * REACH;
  points.forEach((point, place) => {
    const distance = (point.x - x) ** 2 + (point.y - y) ** 2;
    if (distance < least) [best, least] = [place, distance];
  });
  return best;
}
