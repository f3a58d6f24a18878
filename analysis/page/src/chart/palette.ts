// Colours, dashes and marks that tell strategies apart, as analysis/trocar_analysis/palette.py has them; palette.css has the
// colours of both themes. With more strategies than colours a colour comes back with other dashes and another mark.

const COLOURS = 7;
const DASHES = ["none", "7 2", "2 2", "7 2 2 2"];
export const SYMBOLS = ["circle", "square", "triangle", "diamond", "wye", "cross", "star"] as const;

export interface SeriesStyle {
  colour: string; // a CSS colour: it follows the theme
  dash: string; // of stroke-dasharray
  symbol: (typeof SYMBOLS)[number];
}

export function seriesStyle(number: number): SeriesStyle {
  const round = Math.floor(number / COLOURS);
  return {
    colour: `var(--series-${number % COLOURS})`,
    dash: DASHES[(number + round) % DASHES.length]!,
    symbol: SYMBOLS[(number + round) % SYMBOLS.length]!,
  };
}

/** Of a strategy by its label; `labels` are all of the report. */
export function styleOfLabel(labels: string[], label: string): SeriesStyle {
  return seriesStyle(Math.max(labels.indexOf(label), 0));
}

/** The colour that a CSS colour with variables has now. */
export function computedColour(colour: string): string {
  const probe = document.createElement("span");
  probe.style.color = colour;
  document.body.append(probe);
  const computed = getComputedStyle(probe).color;
  probe.remove();
  return computed;
}
