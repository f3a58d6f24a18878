// What stands above every view: the report's name, the ways to its views, and the theme.

import { h } from "./dom";
import type { Report } from "./report";

const VIEWS = [
  { address: "#/", words: "Overview" },
  { address: "#/explore", words: "Explore" },
  { address: "#/case", words: "Cases" },
  { address: "#/replay", words: "Replay" },
  { address: "#/data", words: "Data & provenance" },
];

export interface Header {
  elements: HTMLElement[];
  /** Marks the way to the view that is shown. */
  mark(path: string): void;
}

/** @param main where the skip link goes */
export function header(report: Report, main: HTMLElement): Header {
  const skip = (event: Event) => {
    event.preventDefault(); // the address is the view's
    main.focus();
  };
  const links = VIEWS.map(({ address, words }) => h("a", { href: address }, words));
  const bar = h(
    "header",
    { class: "page-header" },
    h(
      "div",
      { class: "page-header-inside" },
      h("p", { class: "page-title" }, h("strong", {}, report.title), " ", h("span", {}, report.file)),
      themeButton(),
      h("nav", { "aria-label": "views" }, ...links),
    ),
  );
  return {
    elements: [h("a", { class: "skip", href: "#main", click: skip }, "Skip to the content"), bar],
    mark(path) {
      const name = path.split("/")[1] ?? "";
      links.forEach((link, place) => {
        if (VIEWS[place]!.address === `#/${name}`) link.setAttribute("aria-current", "page");
        else link.removeAttribute("aria-current");
      });
    },
  };
}

const STORED = "trocar-theme";

function themeButton(): HTMLElement {
  const root = document.documentElement;
  const system = matchMedia("(prefers-color-scheme: dark)");
  const isDark = () => (root.dataset.theme ? root.dataset.theme === "dark" : system.matches);
  const button = h("button", { type: "button", class: "plain theme" });
  const say = () => (button.textContent = isDark() ? "Light theme" : "Dark theme");
  button.addEventListener("click", () => {
    root.dataset.theme = isDark() ? "light" : "dark";
    store(root.dataset.theme);
    say();
  });
  system.addEventListener("change", say);
  const before = stored();
  if (before) root.dataset.theme = before;
  say();
  return button;
}

// A browser may keep nothing for a page that is a file.
function store(theme: string): void {
  try {
    localStorage.setItem(STORED, theme);
  } catch {
    return;
  }
}

function stored(): string | null {
  try {
    const theme = localStorage.getItem(STORED);
    return theme === "dark" || theme === "light" ? theme : null;
  } catch {
    return null;
  }
}
