// Where the names of points stand: beside their point, clear of other points and names.

export interface Spot {
  x: number; // px, of the point
  y: number;
  words: string;
}

export interface Box {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

const LETTER = 6.7; // px
const HALF = 9; // half a line
const AWAY = 11; // from the point
const OFF = 100; // what it costs to be a px off the paper, in px² that meet something
const POINT = 8; // half a point's size

/** The left end and the middle of each name. It takes the first place of eight in which it meets nothing, else the one in which
 * it meets least. */
export function placeNames(spots: Spot[], paper: Box): Spot[] {
  const taken: Box[] = spots.map(({ x, y }) => ({ left: x - POINT, right: x + POINT, top: y - POINT, bottom: y + POINT }));
  return spots.map(({ x, y, words }) => {
    const length = words.length * LETTER;
    const [right, left, middle] = [x + AWAY, x - AWAY - length, x - length / 2];
    const places = [
      [right, y], [left, y], [middle, y - 18], [middle, y + 18], [right, y - 16], [right, y + 16], [left, y - 16], [left, y + 16],
    ].map(([start, line]) => ({ x: start!, y: line! }));
    const boxes = places.map((place) => ({ left: place.x, right: place.x + length, top: place.y - HALF, bottom: place.y + HALF }));
    const costs = boxes.map((box) => taken.reduce((sum, other) => sum + shared(box, other), 0) + OFF * outside(box, paper));
    const best = costs.indexOf(Math.min(...costs));
    taken.push(boxes[best]!);
    return { ...places[best]!, words };
  });
}

/** The area that two boxes share, px². */
function shared(one: Box, other: Box): number {
  const across = Math.min(one.right, other.right) - Math.max(one.left, other.left);
  const down = Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top);
  return across > 0 && down > 0 ? across * down : 0;
}

/** How far a box is off the paper, px. */
function outside({ left, right, top, bottom }: Box, paper: Box): number {
  return Math.max(0, paper.left - left) + Math.max(0, right - paper.right) + Math.max(0, paper.top - top) + Math.max(0, bottom - paper.bottom);
}
