// All cases, to search and to filter.

import { filterBar } from "../explore/filter_bar";
import "../explore/explore.css";
import { h } from "../../dom";
import { differingColumns, matching, queryOf, readFilters, writeFilters, type Filters } from "../../filters";
import { counted } from "../../numbers";
import type { Page } from "../../view";
import { usualFigures } from "../explore/state";
import { caseTable } from "../case_table";

export function caseList(page: Page, note = ""): HTMLElement {
  const { cases, report } = page;
  let { filters } = readFilters(queryOf(location.hash), cases);
  const words = ["case_id", ...differingColumns(cases), "reason"].filter((name) => cases.columns.has(name));
  const texts = Array.from({ length: cases.count }, (_, row) => words.map((name) => cases.text(name, row)).join(" ").toLowerCase());
  const search = h("input", { type: "search", placeholder: "id or words: liver 400 nearest-face", "aria-label": "search cases" });
  const found = h("p", { role: "status" });
  const place = h("div");
  const update = () => {
    const asked = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const rows = matching(cases, filters).filter((row) => asked.every((word) => texts[row]!.includes(word)));
    bar.update(filters, rows.length);
    found.textContent = rows.length ? counted(rows.length, "case") : "No case matches: change the search or the filters.";
    place.replaceChildren(...(rows.length ? [caseTable(page, rows, usualFigures(cases).slice(0, 2))] : []));
  };
  const bar = filterBar(cases, report.labels, (next: Filters) => {
    filters = next;
    const query = new URLSearchParams();
    writeFilters(filters, query);
    history.replaceState(null, "", `#/case${query.size ? `?${query}` : ""}`);
    update();
  });
  search.addEventListener("input", update);
  update();
  return h("section", { class: "explore" }, h("h1", {}, "Cases"), ...(note ? [h("p", { role: "alert", class: "chart-warning" }, note)] : []), bar.element, h("div", { class: "controls" }, h("label", {}, "search", search)), found, place);
}
