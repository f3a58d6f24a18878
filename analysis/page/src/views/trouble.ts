// What stands in place of a view, or of the page, that could not be made.

import { h } from "../dom";
import type { View } from "../view";

export function trouble(error: unknown): View {
  const said = error instanceof Error ? error.message : String(error);
  const element = h(
    "section",
    { role: "alert" },
    h("h1", {}, "This cannot be shown"),
    h("p", { class: "lead" }, said),
    h("p", {}, "The result file is as it was. Make the report again with ", h("code", {}, "trocar report"), "; if it stays, the lines in the browser's console say where it happened."),
  );
  return { title: "Error", element };
}
