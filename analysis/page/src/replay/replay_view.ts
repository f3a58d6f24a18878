import { h } from "../dom";
import type { Page, View } from "../view";

/** @param caseIds the cases that stand side by side; none: the view chooses */
export function replayView(page: Page, caseIds: string[]): View {
  return { title: "Replay", element: h("section", {}, page.report.title, caseIds.join()) };
}
