// A text that a button copies.

import { h } from "../dom";

/** @param name what it is, for who cannot see it */
export function copyable(text: string, name: string): HTMLElement {
  const shown = h("pre", { tabindex: 0, role: "region", "aria-label": name }, text);
  return h("div", { class: "copyable" }, shown, h("div", { class: "copyable-side" }, ...copyButton(text, shown, name)));
}

/** The button, and beside it what became of it. @param shown where the text stands on the page */
export function copyButton(text: string, shown: Node, name: string): HTMLElement[] {
  const status = h("span", { class: "copied", role: "status" });
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(text);
      status.textContent = "copied";
    } catch {
      // Some browsers give a page that is a file no clipboard: what is to be copied is selected.
      getSelection()?.selectAllChildren(shown);
      status.textContent = "selected: press Ctrl+C";
    }
  };
  return [h("button", { type: "button", class: "plain", click: () => void copy(), "aria-label": `Copy ${name}` }, "Copy"), status];
}
