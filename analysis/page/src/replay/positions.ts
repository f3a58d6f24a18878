// Positions as the report holds them: numbers of a lattice, each moment as its changes from the one before, the first from rest.
// The counterpart of analysis/trocar_analysis/report/lattice.py.

/** Lattice numbers of all moments, one after the other. In a change the lowest bit is the sign: 0, 1, 2, 3 are 0, −1, 1, −2. */
export function unpackMoments(changes: ArrayLike<number>, rest: ArrayLike<number>): Int32Array {
  const size = rest.length;
  const moments = new Int32Array(changes.length);
  for (let k = 0; k < changes.length; k++) {
    const change = changes[k]!;
    const before = k < size ? rest[k]! : moments[k - size]!;
    moments[k] = before + ((change >>> 1) ^ -(change & 1));
  }
  return moments;
}

/** The positions of one moment, mm, into `positions`. */
export function placeVertices(
  numbers: ArrayLike<number>,
  moment: number,
  origin: readonly number[],
  spacing: number,
  positions: Float32Array,
): void {
  const first = moment * positions.length;
  for (let k = 0; k < positions.length; k++) positions[k] = origin[k % 3]! + spacing * numbers[first + k]!;
}
