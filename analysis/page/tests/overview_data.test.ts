import assert from "node:assert/strict";
import { test } from "node:test";
import { amount } from "../src/views/overview_data";

test("numbers in the unit that people read", () => {
  assert.equal(amount(2500, 1e-3), 2.5);
  assert.equal(amount("inf", 1e-3), Infinity);
  assert.equal(amount("-inf", 1), -Infinity);
  assert.ok(Number.isNaN(amount(null, 1)));
});
