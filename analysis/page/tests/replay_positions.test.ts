// The decoding of a replay: positions, lists, edges; and what is worked out from them.

import assert from "node:assert/strict";
import { test } from "node:test";
import { Plane, Vector3 } from "three";
import { DEFAULTS, readAddress, writeAddress } from "../src/replay/address";
import { labAt, mapColor } from "../src/replay/color_map";
import { columnsFor } from "../src/replay/figure";
import { next, nearestStep, stay } from "../src/replay/player";
import { placeVertices, unpackMoments } from "../src/replay/positions";
import { meshOf } from "../src/replay/recording";
import { sectionLine } from "../src/replay/section";

const TETRAHEDRON = new Uint32Array([0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2]);

test("a change of 0, 1, 2, 3, 4 is 0, -1, 1, -2, 2, from rest and then from the moment before", () => {
  const moments = unpackMoments(Uint16Array.of(0, 1, 2, 3, 4, 0), Int32Array.of(10, 20, 30));
  assert.deepEqual([...moments], [10, 19, 31, 8, 21, 31]);
});

test("changes of the largest size keep their sign", () => {
  assert.deepEqual([...unpackMoments(Uint32Array.of(0xffffffff, 0xfffffffe, 0), Int32Array.of(0, 0, 5))], [-2147483648, 2147483647, 5]);
});

test("positions are lattice numbers from the origin", () => {
  const positions = new Float32Array(3);
  placeVertices(Int32Array.of(9, 9, 9, 100, 0, -50), 1, [1, 2, 3], 0.01, positions);
  assert.deepEqual([...positions].map((value) => Number(value.toFixed(5))), [2, 2, 2.5]);
});

test("a tetrahedron has six edges and is closed; without a facet it is open", () => {
  assert.equal(meshOf(TETRAHEDRON).edges.length, 12);
  assert.equal(meshOf(TETRAHEDRON).closed, true);
  assert.equal(meshOf(TETRAHEDRON.subarray(3)).closed, false);
});

test("the section of a tetrahedron is a triangle on the plane", () => {
  const positions = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
  const line = sectionLine(positions, TETRAHEDRON, new Plane(new Vector3(0, 0, 1), -0.25));
  assert.equal(line.length, 18);
  for (let k = 2; k < line.length; k += 3) assert.ok(Math.abs(line[k]! - 0.25) < 1e-6);
});

test("an address that is written is read as the same", () => {
  const shown = {
    ...DEFAULTS, step: 12, moment: "deformed", color: "strain", surface: "wire", hidden: ["tool", "vectors"], cut: false, through: false,
    speed: 0.5, vertex: 7, camera: [1.5, -2, 3, 100, -30, 45],
  } as const;
  assert.deepEqual(readAddress(writeAddress(["aa", "bb"], { ...shown, hidden: [...shown.hidden], camera: [...shown.camera] })), shown);
  assert.equal(writeAddress(["aa", "bb"], DEFAULTS), "#/replay/aa,bb");
});

test("nonsense in an address is as if it were not there", () => {
  const address = "#/replay/aa?step=-1&moment=then&color=red&surface=x&hide=y&speed=9&vertex=a&camera=1,2";
  assert.deepEqual(readAddress(address), DEFAULTS);
});

test("the timeline goes through the moments, or from step to step, and ends", () => {
  const timeline = { steps: [0, 2, 3], seconds: [0, 0.2, 0.3] };
  assert.deepEqual(next(timeline, { at: 0, moment: "found" }, true), { at: 0, moment: "handled" });
  assert.deepEqual(next(timeline, { at: 0, moment: "deformed" }, true), { at: 1, moment: "found" });
  assert.deepEqual(next(timeline, { at: 0, moment: "handled" }, false), { at: 1, moment: "handled" });
  assert.equal(next(timeline, { at: 2, moment: "handled" }, false), null);
  assert.equal(next(timeline, { at: 2, moment: "deformed" }, true), null);
  assert.ok(Math.abs(stay(timeline, { at: 0, moment: "found" }, false, 0.1) - 2) < 1e-9);
  assert.equal(nearestStep(timeline, 1.9), 1);
});

test("equal steps along the colour map look equally large, and it gets lighter", () => {
  const lengths = Array.from({ length: 30 }, (_, k) => Math.hypot(...labAt((k + 1) / 30).map((value, i) => value - labAt(k / 30)[i]!)));
  assert.ok(Math.max(...lengths) / Math.min(...lengths) < 1.15, String(lengths));
  for (let k = 0; k < 30; k++) assert.ok(labAt((k + 1) / 30)[0] > labAt(k / 30)[0]);
  for (const share of [0, 0.3, 0.6, 1]) assert.ok(mapColor(share).every((value) => value >= 0 && value <= 1));
});

test("six wide views stand in three columns, two on a narrow screen in one", () => {
  assert.equal(columnsFor(6, 1200, 700, 1.15), 3);
  assert.equal(columnsFor(2, 380, 800, 1.15), 1);
});
