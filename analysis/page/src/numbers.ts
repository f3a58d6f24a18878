// Numbers as people read them.

/** The unit to show values in, and the factor to it: times in ns become µs or ms. `size`, of a large value, decides which. */
export function readableUnit(unit: string, size: number): { unit: string; factor: number } {
  if (unit !== "ns") return { unit, factor: 1 };
  return size >= 1e6 ? { unit: "ms", factor: 1e-6 } : { unit: "µs", factor: 1e-3 };
}

/** Three significant digits of a fraction, whole numbers as they are. */
export function short(value: number): string {
  if (Number.isNaN(value)) return "–";
  if (Math.abs(value) < 1e-12) return "0";
  if (!Number.isFinite(value)) return String(value).replace("Infinity", "∞");
  if (Number.isInteger(value) || Math.abs(value) >= 1000) return grouped(Math.round(value));
  return String(Number(value.toPrecision(3)));
}

/** A whole number with its thousands apart. */
export function grouped(value: number): string {
  return value.toLocaleString("en");
}

/** A number of things, such as "1 case" and "2 cases". */
export function counted(count: number, what: string): string {
  return `${grouped(count)} ${what}${count === 1 ? "" : "s"}`;
}

/** The quantile of sorted values, interpolated as numpy.percentile does; NaN of none. */
export function quantile(sorted: ArrayLike<number>, share: number): number {
  const place = (sorted.length - 1) * share;
  const below = Math.floor(place);
  const low = sorted[below] ?? NaN;
  const high = sorted[Math.ceil(place)] ?? NaN;
  return low === high ? low : low + (high - low) * (place - below);
}
