// For an address that names no view.

import { h } from "../dom";
import type { View } from "../view";

export function notFound(path: string): View {
  const element = h(
    "section",
    {},
    h("h1", {}, "There is no such view"),
    h("p", { class: "lead" }, "The address asks for ", h("code", {}, path), ", which this report does not have."),
    h("p", {}, h("a", { href: "#/" }, "Go to the overview")),
  );
  return { title: "Not found", element };
}
