import assert from "node:assert/strict";
import { test } from "node:test";
import { siblingsOf } from "../src/views/case/siblings";
import { pairsOf } from "../src/views/explore/pairs";
import { casesOfRows, twelve } from "./made_up_cases";

const all = (count: number) => Array.from({ length: count }, (_, row) => row);

test("a pair has equal conditions and seed; its difference is A minus B", () => {
  const cases = casesOfRows(twelve());
  const { pairs, leftOut } = pairsOf(cases, all(12), "depth", "A", "B");
  assert.equal(pairs.length, 6);
  assert.equal(leftOut.size, 0);
  for (const { a, b, difference } of pairs) {
    assert.equal(cases.text("case_id", a).slice(1), cases.text("case_id", b).slice(1));
    assert.equal(difference, -9 * cases.number("seed", a));
  }
});

test("what has no difference is counted with why", () => {
  const rows = twelve();
  rows[0]!.status = "diverged";
  rows[7]!.depth = NaN;
  const { pairs, leftOut } = pairsOf(casesOfRows(rows), all(11), "depth", "A", "B");
  assert.equal(pairs.length, 3);
  assert.deepEqual([...leftOut].sort(), [["in which a case failed", 1], ["in which a case has no value", 1], ["without a partner of B", 1]]);
});

test("cases of B without one of A are counted, too", () => {
  const { pairs, leftOut } = pairsOf(casesOfRows(twelve()), all(12).slice(5), "depth", "A", "B");
  assert.equal(pairs.length, 1);
  assert.deepEqual([...leftOut], [["without a partner of A", 5]]);
});

test("siblings differ in their strategy alone, in the order of the labels", () => {
  const cases = casesOfRows(twelve());
  assert.deepEqual(siblingsOf(cases, ["B", "A"], cases.row("A202")!).map((row) => cases.text("case_id", row)), ["B202", "A202"]);
});
