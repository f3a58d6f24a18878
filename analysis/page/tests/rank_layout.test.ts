import assert from "node:assert/strict";
import { test } from "node:test";
import { levels, nameRows } from "../src/views/overview/rank_layout";

test("bars that are clear of each other share a level", () => {
  const [first, second, third] = [
    { best: 300, worst: 200 },
    { best: 250, worst: 150 },
    { best: 100, worst: 50 },
  ];
  assert.deepEqual(levels([first, second, third], 20), [[first, third], [second]]);
});

test("the better half of the names is on the right, the outermost on top", () => {
  const names = ["a", "b", "c", "d", "e"].map((words) => ({ words }));
  const placed = nameRows(names, 400);
  assert.deepEqual(
    placed.map(({ words, level, onRight }) => [words, level, onRight]),
    [["a", 0, true], ["b", 1, true], ["e", 0, false], ["d", 1, false], ["c", 2, false]],
  );
});

test("names that would meet get levels of their own", () => {
  const names = ["a", "b", "c", "d"].map((letter) => ({ words: letter.repeat(30) }));
  const taken = nameRows(names, 300).map(({ level }) => level);
  assert.equal(new Set(taken).size, 4);
});
