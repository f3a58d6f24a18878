// The replay's colours, from the style sheet, so that they follow the theme.

import { Color } from "three";

const NAMES = ["ground", "organ", "section", "edge", "tool", "outline", "mark", "moved", "vector", "pin", "deep"] as const;

export type Colors = Record<(typeof NAMES)[number], Color>;

export function readColors(element: HTMLElement): Colors {
  const style = getComputedStyle(element);
  return Object.fromEntries(NAMES.map((name) => [name, new Color(style.getPropertyValue(`--replay-${name}`).trim())])) as Colors;
}

/** Calls when the theme may have changed, until the signal says to stop. */
export function onThemeChange(change: () => void, until: AbortSignal): void {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", change, { signal: until });
  const observer = new MutationObserver(change);
  observer.observe(document.documentElement, { attributes: true, attributeFilter: ["data-theme", "class"] });
  until.addEventListener("abort", () => observer.disconnect());
}
