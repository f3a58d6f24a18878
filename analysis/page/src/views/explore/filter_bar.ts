// The chips by which cases are chosen: one for each value of each column in which cases differ. None pressed: all values.

import type { Cases } from "../../cases";
import { swatch } from "../../chart/legend";
import { styleOfLabel } from "../../chart/palette";
import { h } from "../../dom";
import { differingColumns, toggled, type Filters } from "../../filters";
import { grouped } from "../../numbers";

export interface FilterBar {
  element: HTMLElement;
  update(filters: Filters, matching: number): void;
}

export function filterBar(cases: Cases, labels: string[], change: (filters: Filters) => void): FilterBar {
  let shown: Filters = new Map();
  const chips: { column: string; value: string; button: HTMLButtonElement }[] = [];
  const group = (column: string) => {
    const { levels } = cases.codes(column);
    const values = column === "label" ? [...labels].filter((label) => levels.includes(label)) : levels;
    const buttons = values.map((value) => {
      const button = h("button", { type: "button", class: "chip", "aria-pressed": "false", click: () => change(toggled(shown, column, value)) });
      if (column === "label") {
        const mark = swatch(styleOfLabel(labels, value));
        button.append(mark);
      }
      button.append(value || "(none)");
      chips.push({ column, value, button });
      return button;
    });
    const unit = cases.columns.get(column)!.unit;
    const name = column === "label" ? "strategy" : column;
    return h("fieldset", { class: "chips" }, h("legend", {}, unit ? `${name}, ${unit}` : name), ...buttons);
  };
  const count = h("strong", { role: "status", class: "filter-count" });
  const clear = h("button", { type: "button", class: "plain", click: () => change(new Map()) }, "Clear filters");
  const details = h(
    "details",
    { class: "filters", open: matchMedia("(min-width: 700px)").matches },
    h("summary", {}, "Filters ", count),
    h("div", { class: "filter-groups" }, ...differingColumns(cases).map(group)),
    clear,
  );
  return {
    element: details,
    update(filters, matching) {
      shown = filters;
      for (const { column, value, button } of chips) button.setAttribute("aria-pressed", String(filters.get(column)?.has(value) ?? false));
      count.textContent = `${grouped(matching)} of ${grouped(cases.count)} cases`;
      clear.hidden = filters.size === 0;
    },
  };
}
