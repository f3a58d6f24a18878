import assert from "node:assert/strict";
import { test } from "node:test";
import type { Report } from "../src/report";
import { programNumber, rerunArguments, shellText, sweepFile } from "../src/views/case/command";
import { casesOfRows, twelve } from "./made_up_cases";

const cases = casesOfRows(twelve().map((row) => ({ ...row, label: row.label === "A" ? "it's, A" : "B" })));
const ofWhole = { planned: 12 } as Report;
const LINE = "build/trocar run my sweeps/one.toml -o out.h5 --metrics drag,strain";

test("of a whole sweep the conditions that differ choose the case", () => {
  const said = shellText(rerunArguments(ofWhole, cases, 0, "build/trocar run one.toml -o out.h5"));
  assert.equal(said, "trocar run one.toml --only 'label=it'\\''s, A' --only speed=400 --only seed=1 -o case-A4001.h5");
});

test("of a part of a sweep all conditions are said: others may differ in what these share", () => {
  const said = rerunArguments({ planned: 24 } as Report, cases, 0, LINE);
  assert.ok(said.includes("organ=liver"));
});

test("the metrics that were on are asked for again, and paths with spaces stay whole", () => {
  assert.match(shellText(rerunArguments(ofWhole, cases, 11, LINE)), /^trocar run 'my sweeps\/one.toml' .* --metrics drag,strain -o case-B203.h5$/);
});

test("the sweep file is found before and behind the options", () => {
  assert.equal(sweepFile("trocar run a.toml -o b.h5"), "a.toml");
  assert.equal(sweepFile("trocar run -o b.h5 --only speed=20 a.toml"), "a.toml");
  assert.equal(sweepFile("/home/a run/trocar run a.toml -o b.h5"), "a.toml");
});

test("where no sweep file is known its place is shown", () => {
  assert.equal(rerunArguments(ofWhole, cases, 0, "trocar reproduce -o x.h5")[2], "SWEEP.toml");
});

test("numbers are written as the program writes them", () => {
  assert.deepEqual([20, 31.6, 0.1, 1e-5, 2.5e-7, 1e16, 123456789].map(programNumber), ["20", "31.6", "0.1", "1e-05", "2.5e-07", "1e+16", "123456789"]);
});
