// A table that its headings sort.

import { h } from "../dom";

export interface SortableColumn<Row> {
  title: string;
  note?: string; // below the title: unit and which way is better
  isText?: boolean;
  value(row: Row): number | string; // what it is sorted by; NaN comes last
  cell(row: Row): (Node | string)[];
  descendsFirst?: boolean; // where high is better
}

/** @param name what the table is called
 * @param sortedBy place of the column that `rows` are in the order of */
export function sortableTable<Row>(name: string, columns: SortableColumn<Row>[], rows: Row[], sortedBy: number): HTMLElement {
  const body = h("tbody");
  const heads = columns.map((column, place) => {
    const words = [h("span", { class: "sort-title" }, column.title), ...(column.note ? [h("small", {}, column.note)] : [])];
    const button = h("button", { type: "button", class: "sort", click: () => sort(place) }, ...words);
    return h("th", { scope: "col", class: column.isText ? "" : "number" }, button);
  });
  let by = sortedBy;
  let descends = columns[sortedBy]!.descendsFirst ?? false;
  const sort = (place: number) => {
    descends = place === by ? !descends : (columns[place]!.descendsFirst ?? false);
    by = place;
    show();
  };
  const show = () => {
    heads.forEach((head, place) => {
      if (place === by) head.setAttribute("aria-sort", descends ? "descending" : "ascending");
      else head.removeAttribute("aria-sort");
    });
    body.replaceChildren(...sorted(rows, columns[by]!, descends).map((row) => line(columns, row)));
  };
  show();
  const table = h("table", { class: "sortable" }, h("thead", {}, h("tr", {}, ...heads)), body);
  return h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": name }, table);
}

function line<Row>(columns: SortableColumn<Row>[], row: Row): HTMLElement {
  const cells = columns.map((column, place) =>
    place === 0 ? h("th", { scope: "row" }, ...column.cell(row)) : h("td", { class: column.isText ? "" : "number" }, ...column.cell(row)),
  );
  return h("tr", {}, ...cells);
}

function sorted<Row>(rows: Row[], column: SortableColumn<Row>, descends: boolean): Row[] {
  const isNone = (value: number | string) => typeof value === "number" && Number.isNaN(value);
  return [...rows].sort((one, other) => {
    const [a, b] = [column.value(one), column.value(other)];
    if (isNone(a) || isNone(b)) return Number(isNone(a)) - Number(isNone(b));
    const order = typeof a === "string" ? a.localeCompare(String(b)) : a === b ? 0 : a < Number(b) ? -1 : 1;
    return descends ? -order : order;
  });
}
