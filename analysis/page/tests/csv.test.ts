import assert from "node:assert/strict";
import { test } from "node:test";
import { csvRows, csvText } from "../src/chart/csv";

test("commas, quotes and empty cells come back as they were", () => {
  const rows = [["a,b", 'say "no"', "", "plain"], ["", "", "", ""]];
  assert.deepEqual(csvRows(csvText(rows)), rows);
});

test("a number is the shortest text that means it; what does not exist is an empty cell", () => {
  assert.equal(csvText([[1 / 3, NaN, -0.1, 1e-20]]), "0.3333333333333333,,-0.1,1e-20\n");
});
