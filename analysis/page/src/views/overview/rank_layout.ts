// Where the bars and names of a critical-difference diagram stand.

export interface Bar {
  best: number; // px: the right end
  worst: number;
}

const LETTER = 6.6; // px, of a name

/** The bars level by level, so that those of a level are clear of each other by `gap`. @param bars the best first */
export function levels(bars: Bar[], gap: number): Bar[][] {
  const stacked: Bar[][] = [];
  for (const bar of bars) {
    const free = stacked.find((level) => level.at(-1)!.worst - bar.best > gap);
    if (free) free.push(bar);
    else stacked.push([bar]);
  }
  return stacked;
}

/** The better half on the right, the others on the left, the outermost on top: no two lines cross. Where two names of a
 * level would meet, each has a level of its own. @param names the best first */
export function nameRows<Name extends { words: string }>(names: Name[], width: number): (Name & { level: number; onRight: boolean })[] {
  const better = Math.floor(names.length / 2);
  const right = names.slice(0, better).map((name, place) => ({ ...name, level: place, onRight: true }));
  const left = names.slice(better).reverse().map((name, place) => ({ ...name, level: place, onRight: false }));
  const widest = Math.max(...left.map((one) => one.words.length + (right[one.level]?.words.length ?? 0)));
  if (widest * LETTER + 30 <= width) return [...right, ...left];
  return [...right.map((one) => ({ ...one, level: 2 * one.level })), ...left.map((one) => ({ ...one, level: 2 * one.level + 1 }))];
}
