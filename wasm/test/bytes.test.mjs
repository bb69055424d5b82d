// Results equal the results of the native library byte for byte.

import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { Curves, GussetError, load, Mesh } from "../gusset.js";
import { elements } from "../tables.js";
import { jobsOf } from "./jobs.mjs";
import { natively, program } from "./native.mjs";

const { filters } = await load();
const jobs = jobsOf(filters);

function bytes(array) {
  return Buffer.from(array.buffer, array.byteOffset, array.byteLength);
}

function same(found, expected, what) {
  assert.equal(found.constructor, expected.constructor, what);
  assert.equal(found.length, expected.length, `${what}: length`);
  if (!bytes(found).equals(bytes(expected))) {
    const view = (array) => new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
    const at = Math.floor(view(found).findIndex((byte, k) => byte !== view(expected)[k]) / found.BYTES_PER_ELEMENT);
    const differ = found.reduce((count, value, k) => count + (value !== expected[k] ? 1 : 0), 0);
    assert.fail(`${what}: ${differ} of ${found.length} differ, the first is number ${at}: ${found[at]}, natively ${expected[at]}`);
  }
}

describe("bytes", { skip: program ? false : "GUSSET_NATIVE names no program: make wasm" }, () => {
  const answers = program ? natively(jobs) : [];
  jobs.forEach(({ filter, inputs, params, name }, k) => test(name, () => {
    const expected = answers[k];
    if (expected.status !== 0) {
      assert.throws(() => filter(...inputs, params), (error) => {
        assert.ok(error instanceof GussetError, error);
        const { status, message, element, index, value } = error;
        assert.equal(status, expected.status);
        assert.equal(message, expected.message);
        assert.equal(element, elements[expected.element]);
        assert.ok(expected.element === 0 || index === expected.index && Object.is(value, expected.value), `${index}, ${value}`);
        assert.equal(error.input ?? 0xffffffff, expected.input);
        assert.equal(error.param ?? 0xffffffff, expected.param);
        return true;
      });
      return;
    }
    const outputs = filter.run(inputs, params);
    assert.equal(outputs.length, expected.outputs.length);
    expected.outputs.forEach((one, n) => {
      const found = outputs.at(n);
      assert.equal(found.constructor, one.constructor);
      if (one instanceof Mesh) {
        same(found.positions, one.positions, "positions");
        same(found.faces.offsets, one.faces.offsets, "offsets");
        same(found.faces.corners, one.faces.corners, "corners");
      } else if (one instanceof Curves) {
        same(found.points, one.points, "points");
        same(found.offsets, one.offsets, "offsets");
        same(found.closed, one.closed, "closed");
      } else {
        assert.equal(found.text, one.text);
        assert.deepEqual(found.values, one.values);
      }
    });
    outputs.free();
  }));
  test("most succeed, and some fail", () => {
    const failed = answers.filter((one) => one.status !== 0).length;
    assert.ok(failed >= 3 && failed < jobs.length / 8, `${failed} of ${jobs.length}`);
  });
});
