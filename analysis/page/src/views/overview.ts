import { h } from "../dom";
import type { Page, View } from "../view";

export function overview(page: Page): View {
  return { title: "overview", element: h("section", {}, page.report.title) };
}
