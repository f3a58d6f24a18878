import assert from "node:assert/strict";
import { test } from "node:test";
import { grouped, leftOut, summarise, tally, together } from "../src/groups";
import { quantile } from "../src/numbers";
import { casesOfRows, twelve } from "./made_up_cases";

const all = (count: number) => Array.from({ length: count }, (_, row) => row);

test("groups stand column by column, numbers ascending, texts as they come", () => {
  const cases = casesOfRows(twelve());
  const groups = grouped(cases, all(12), ["label", "speed"], "depth");
  assert.deepEqual(groups.map(({ keys, median }) => [...keys, median]), [["A", "20", 2], ["A", "400", 2], ["B", "20", 20], ["B", "400", 20]]);
});

test("quantiles are those of numpy.percentile", () => {
  assert.equal(quantile([1, 2, 3, 4], 0.5), 2.5);
  assert.equal(quantile([1, 2, 3, 4], 0.25), 1.75);
  assert.equal(quantile([1, 2, 3, 4], 0.75), 3.25);
  assert.equal(quantile([7], 0.25), 7);
  assert.equal(quantile([1, Infinity], 0.5), Infinity);
  assert.ok(Number.isNaN(quantile([], 0.5)));
});

test("failed cases and missing values are in no median, and are counted with why", () => {
  const rows = twelve().slice(0, 6);
  Object.assign(rows[0]!, { status: "diverged", depth: 99 });
  Object.assign(rows[1]!, { status: "diverged", depth: NaN });
  Object.assign(rows[2]!, { depth: NaN });
  const summary = summarise(casesOfRows(rows, { depth: "no vertex inside" }), all(6), "depth");
  assert.deepEqual([...summary.values], [1, 2, 3]);
  assert.equal(summary.median, 2);
  assert.equal(leftOut(summary), "2 cases failed (2 diverged); 1 case without a value (1 no vertex inside)");
});

test("a missing value whose reason nobody recorded says so", () => {
  const rows = twelve().slice(0, 1);
  Object.assign(rows[0]!, { depth: NaN });
  assert.equal(leftOut(summarise(casesOfRows(rows), [0], "depth")), "1 case without a value (1 no reason recorded)");
});

test("counts of several groups add up, the most frequent first", () => {
  const group = (status: string, count: number) => ({ failed: new Map([[status, count]]), lacking: new Map() });
  assert.equal(tally(together([group("crashed", 1), group("diverged", 2), group("crashed", 3)]).failed), "4 crashed, 2 diverged");
});

test("nothing left out is not spoken of", () => {
  assert.equal(leftOut(summarise(casesOfRows(twelve()), all(12), "depth")), "");
});
