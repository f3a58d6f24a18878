import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "../src/view";
import { groupsCsv } from "../src/views/explore/multiples";
import { panelsOf } from "../src/views/explore/panels";
import type { Shown } from "../src/views/explore/shown";
import { addressOf, readState, usualState } from "../src/views/explore/state";
import { csvRows } from "../src/chart/csv";
import { casesOfRows, twelve } from "./made_up_cases";

function shownOf(rows: ReturnType<typeof twelve>, split: { x: string; across: string; down: string }): Shown {
  const cases = casesOfRows(rows);
  const state = { ...usualState(cases, ["A", "B"]), figure: "depth", ...split };
  const page = { cases, report: { labels: ["A", "B"] } } as unknown as Page;
  return { page, state, rows: rows.map((_, row) => row), column: cases.columns.get("depth")!, labels: ["A", "B"], unit: "", factor: 1, choose: () => {} };
}

test("a panel per value, its groups per place along x and strategy", () => {
  const { panels, xs, acrossCount } = panelsOf(shownOf(twelve(), { x: "seed", across: "speed", down: "" }));
  assert.deepEqual(panels.map(({ across }) => across), ["20", "400"]);
  assert.deepEqual(xs, ["1", "2", "3"]);
  assert.equal(acrossCount, 2);
  assert.deepEqual(panels[0]!.groups.filter(({ label }) => label === "B").map(({ place, median }) => [place, median]), [[0, 10], [1, 20], [2, 30]]);
});

test("a condition may stand in two places at once, or in none", () => {
  assert.equal(panelsOf(shownOf(twelve(), { x: "speed", across: "speed", down: "" })).panels.length, 2);
  const { panels } = panelsOf(shownOf(twelve(), { x: "", across: "", down: "" }));
  assert.deepEqual(panels.map(({ groups }) => groups.map(({ rows }) => rows.length)), [[6, 6]]);
});

test("a panel says what is in none of its medians", () => {
  const rows = twelve();
  rows[0]!.status = "crashed";
  const { panels } = panelsOf(shownOf(rows, { x: "seed", across: "speed", down: "" }));
  assert.deepEqual(panels.map(({ leftOut }) => leftOut), ["", "1 case failed (1 crashed)"]);
});

test("the CSV has the groups with counts, and values in full", () => {
  const rows = twelve();
  rows[9]!.depth = 0.1 + 0.2;
  const shown = shownOf(rows, { x: "seed", across: "speed", down: "" });
  const [head, ...lines] = csvRows(groupsCsv(shown, panelsOf(shown)));
  const line = lines.find((cells) => cells[0] === "20" && cells[1] === "1" && cells[2] === "B")!;
  const cell = (name: string) => line[head!.indexOf(name)];
  assert.equal(cell("median"), "0.30000000000000004");
  assert.equal(cell("cases"), "1");
  assert.equal(cell("failed"), "0");
});

test("the address restores what is shown; what is as usual is not in it", () => {
  const cases = casesOfRows(twelve());
  const labels = ["A", "B"];
  const usual = usualState(cases, labels);
  assert.equal(addressOf(usual, usual), "#/explore");
  const state = { ...usual, x: "seed", across: "", form: "cases" as const, filters: new Map([["label", new Set(["B"])]]) };
  const { state: again, wrong } = readState(addressOf(state, usual), cases, labels);
  assert.deepEqual(again, state);
  assert.deepEqual(wrong, []);
});

test("an address that asks for what is not there says so and shows the usual", () => {
  const cases = casesOfRows(twelve());
  const { state, wrong } = readState("#/explore?figure=nothing&x=organ", cases, ["A", "B"]);
  assert.deepEqual(wrong, ["figure=nothing", "x=organ"]);
  assert.equal(state.figure, "depth");
});
