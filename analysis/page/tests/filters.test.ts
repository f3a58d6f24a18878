import assert from "node:assert/strict";
import { test } from "node:test";
import { differingColumns, matching, readFilters, toggled, writeFilters } from "../src/filters";
import { casesOfRows, twelve } from "./made_up_cases";

test("values of one column are alternatives, columns must all match", () => {
  const cases = casesOfRows(twelve());
  const filters = new Map([["label", new Set(["B"])], ["seed", new Set(["1", "3"])]]);
  assert.deepEqual(matching(cases, filters).map((row) => cases.text("case_id", row)), ["B4001", "B4003", "B201", "B203"]);
});

test("without filters all cases match", () => {
  assert.equal(matching(casesOfRows(twelve()), new Map()).length, 12);
});

test("a label with a comma and an equals sign comes back from the address", () => {
  const label = "fuzzy, case=penetration & more";
  const cases = casesOfRows(twelve().map((row) => ({ ...row, label })));
  const query = new URLSearchParams();
  writeFilters(new Map([["label", new Set([label])], ["speed", new Set(["20"])]]), query);
  const { filters, wrong } = readFilters(new URLSearchParams(query.toString()), cases);
  assert.deepEqual([...filters.get("label")!], [label]);
  assert.deepEqual([...filters.get("speed")!], ["20"]);
  assert.deepEqual(wrong, []);
});

test("what no case has is named, not obeyed", () => {
  const { filters, wrong } = readFilters(new URLSearchParams("only=speed=21&only=colour=red&only=speed=20"), casesOfRows(twelve()));
  assert.deepEqual(wrong, ["speed=21", "colour=red"]);
  assert.deepEqual([...filters.get("speed")!], ["20"]);
});

test("a value switched on and off leaves no filter", () => {
  const on = toggled(new Map(), "speed", "20");
  assert.deepEqual([...on.get("speed")!], ["20"]);
  assert.equal(toggled(on, "speed", "20").size, 0);
  const both = toggled(on, "speed", "400");
  assert.deepEqual([[...on.get("speed")!], [...both.get("speed")!]], [["20"], ["20", "400"]], "the filters that were given are as they were");
});

test("columns in which cases do not differ are no filter; the seed comes last of the conditions", () => {
  assert.deepEqual(differingColumns(casesOfRows(twelve())), ["label", "speed", "seed"]);
});
