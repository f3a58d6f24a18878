// A perceptually uniform colour map, from blue over teal to yellow: a way through OKLab (Ottosson, 2020) of straight lines, along
// which equal steps look equally large. It stays clear of black and white: it has to show on a light and on a dark ground.

type Triple = readonly [number, number, number];

const CORNERS: readonly Triple[] = [
  [0.4, 0.02, -0.15],
  [0.55, -0.05, -0.1],
  [0.72, -0.12, 0.03],
  [0.93, -0.03, 0.16],
];

/** Red, green and blue in linear light, each 0 to 1, of a share from 0 to 1 of the way. */
export function mapColor(share: number): Triple {
  return linearFromOklab(labAt(Math.min(1, Math.max(0, share))));
}

export function labAt(share: number): Triple {
  const lengths = CORNERS.slice(1).map((corner, k) => Math.hypot(...corner.map((value, i) => value - CORNERS[k]![i]!)));
  let left = share * lengths.reduce((a, b) => a + b);
  let k = 0;
  while (k < lengths.length - 1 && left > lengths[k]!) left -= lengths[k++]!;
  const part = left / lengths[k]!;
  const [a, b] = [CORNERS[k]!, CORNERS[k + 1]!];
  return [0, 1, 2].map((i) => a[i]! + part * (b[i]! - a[i]!)) as unknown as Triple;
}

function linearFromOklab([lightness, a, b]: Triple): Triple {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  const clip = (value: number) => Math.min(1, Math.max(0, value));
  return [
    clip(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    clip(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    clip(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
  ];
}

/** As CSS wants it. */
export function cssColor(share: number): string {
  const encode = (value: number) => (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055);
  return `rgb(${mapColor(share).map((value) => Math.round(255 * encode(value))).join(" ")})`;
}

/** The colours of all values of a byte: looked up per vertex. */
export const TABLE = Float32Array.from({ length: 256 * 3 }, (_, k) => mapColor(Math.floor(k / 3) / 255)[k % 3]!);
