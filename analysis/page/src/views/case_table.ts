// Cases as a table with links, a page of them at a time.

import { h } from "../dom";
import { differingColumns } from "../filters";
import { grouped, short } from "../numbers";
import type { Page } from "../view";

const PAGE = 50; // rows

/** @param figures columns to show beside what cases differ in */
export function caseTable(page: Page, rows: number[], figures: string[] = []): HTMLElement {
  const { cases, report } = page;
  const columns = [...differingColumns(cases), ...figures.filter((name) => cases.columns.has(name))];
  const recorded = new Set(report.replays.map(({ caseId }) => caseId));
  const body = h("tbody");
  const place = h("span", { role: "status" });
  let first = 0;
  const cell = (column: string, row: number) => {
    const isText = cases.columns.get(column)!.levels !== undefined;
    return isText ? h("td", {}, cases.text(column, row)) : h("td", { class: "number" }, short(cases.number(column, row)));
  };
  const line = (row: number) => {
    const caseId = cases.text("case_id", row);
    const links = [h("a", { href: `#/case/${caseId}` }, caseId.slice(0, 10))];
    if (recorded.has(caseId)) links.push(h("a", { href: `#/replay/${caseId}` }, "replay"));
    const failed = cases.text("status", row) !== "complete";
    return h("tr", failed ? { class: "failed" } : {}, h("td", { class: "case-links" }, ...links), ...columns.map((column) => cell(column, row)));
  };
  const turn = (by: number) => {
    first = Math.min(Math.max(0, first + by), Math.max(0, Math.floor((rows.length - 1) / PAGE) * PAGE));
    body.replaceChildren(...rows.slice(first, first + PAGE).map(line));
    place.textContent = `${grouped(first + 1)}–${grouped(Math.min(first + PAGE, rows.length))} of ${grouped(rows.length)}`;
    back.disabled = first === 0;
    on.disabled = first + PAGE >= rows.length;
  };
  const back = h("button", { type: "button", class: "plain", click: () => turn(-PAGE) }, "← back");
  const on = h("button", { type: "button", class: "plain", click: () => turn(PAGE) }, "on →");
  turn(0);
  const unit = (name: string) => (cases.columns.get(name)!.unit ? `, ${cases.columns.get(name)!.unit}` : "");
  const title = (name: string) => h("th", { scope: "col", ...(cases.columns.get(name)!.levels ? {} : { class: "number" }) }, name === "label" ? "strategy" : name + unit(name));
  const head = [h("th", { scope: "col" }, "case"), ...columns.map(title)];
  const table = h("table", { class: "cases" }, h("thead", {}, h("tr", {}, ...head)), body);
  const scroll = h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "cases" }, table);
  return h("div", { class: "case-table" }, scroll, ...(rows.length > PAGE ? [h("p", { class: "pager" }, back, place, on)] : []));
}
