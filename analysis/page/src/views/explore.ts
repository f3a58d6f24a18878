import { h } from "../dom";
import type { Page, View } from "../view";

export function explore(page: Page): View {
  return { title: "explore", element: h("section", {}, page.report.title) };
}
