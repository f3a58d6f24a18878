import assert from "node:assert/strict";
import { test } from "node:test";
import { placeNames } from "../src/views/overview/name_places";

const paper = { left: 0, right: 300, top: 0, bottom: 200 };

test("a name stands to the right of its point", () => {
  const [name] = placeNames([{ x: 50, y: 50, words: "alone" }], paper);
  assert.ok(name!.x > 50 && name!.y === 50);
});

test("a name stays on the paper", () => {
  const [name] = placeNames([{ x: 290, y: 100, words: "at the edge" }], paper);
  assert.ok(name!.x + 11 * 6 < 290);
});

test("names do not meet each other, nor other points", () => {
  const spots = [
    { x: 100, y: 100, words: "first" },
    { x: 118, y: 100, words: "second" },
    { x: 109, y: 112, words: "third" },
  ];
  const boxes = placeNames(spots, paper).map(({ x, y, words }) => ({ left: x, right: x + words.length * 6, top: y - 8, bottom: y + 8 }));
  for (const [k, one] of boxes.entries()) {
    for (const other of boxes.slice(k + 1)) {
      assert.ok(one.right < other.left || other.right < one.left || one.bottom <= other.top || other.bottom <= one.top);
    }
    for (const { x, y } of spots) assert.ok(x < one.left || x > one.right || y < one.top || y > one.bottom);
  }
});
