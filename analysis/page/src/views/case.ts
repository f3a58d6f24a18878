import { h } from "../dom";
import type { Page, View } from "../view";

export function caseView(page: Page, caseId: string): View {
  return { title: caseId, element: h("section", {}, page.report.title) };
}
