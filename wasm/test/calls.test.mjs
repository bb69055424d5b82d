// How the library is called from JavaScript.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { Cancelled, Curves, GussetError, InputError, load, Mesh, OutOfMemory, Outputs, Report, Stopped } from "../gusset.js";
import { Library } from "../library.js";
import { constants, structs } from "../tables.js";
import { cap, sheet, tube } from "./shapes.mjs";

const { filters, memory, version } = await load();
const file = new URL("../gusset.wasm", import.meta.url);

test("the package has the version of the library", async () => {
  const manifest = JSON.parse(await readFile(new URL("../package.json", import.meta.url), "utf8"));
  assert.equal(manifest.version, version);
  const all = new Set(manifest.files);
  for (const name of ["gusset.js", "library.js", "inputs.js", "outputs.js", "errors.js", "tables.js", "gusset.d.ts", "gusset.wasm"]) {
    assert.ok(all.has(name), name);
  }
});

test("structs are as long as the library says", async () => {
  const instance = await WebAssembly.instantiate(await WebAssembly.compile(await readFile(file)), {});
  const library = new Library(instance), filter = library.struct("gusset_filter", library.call(library.table.filter, 0));
  assert.equal(library.table.struct_size, structs.gusset_plugin.size);
  assert.equal(filter.struct_size, structs.gusset_filter.size);
  assert.equal(library.struct("gusset_param_info", library.call(filter.param, filter.pointer, 0)).struct_size, structs.gusset_param_info.size);
  const first = library.withRoom((room) => [room.allocate(1000), room.allocate(0)]);
  assert.deepEqual([first[0] % 16, first[1]], [0, 0]);
});

test("a mesh may be given in many ways", () => {
  const positions = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0];
  const rows = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], triangles = [0, 1, 2, 0, 2, 3];
  const expected = filters.check({ positions, faces: triangles });
  assert.ok(expected instanceof Report && expected.values.vertices === 4 && String(expected) === expected.text);
  for (const mesh of [
    { positions: Float64Array.from(positions), faces: Uint32Array.from(triangles) }, { positions: rows, faces: [[0, 1, 2], [0, 2, 3]] },
    { positions: Int8Array.from(positions), faces: { offsets: [0, 3, 6], corners: triangles } }, new Mesh(rows, triangles),
    { positions: Float32Array.from(positions), faces: Int32Array.from(triangles) },
    { positions: rows.map((row) => Float32Array.from(row)), faces: triangles },
  ]) {
    assert.equal(filters.check(mesh).text, expected.text);
  }
  const [welded] = filters.weld({ positions: Float32Array.from(positions), faces: triangles });
  assert.ok(welded.positions instanceof Float32Array && welded.triangles.length === 6 && welded.faceCount === 2 && welded.vertexCount === 4);
  assert.equal(new Mesh(rows, [[0, 1, 2, 3]]).triangles, null);
  const curves = [new Curves([rows]), new Curves(rows), new Curves([rows.map((row) => Float64Array.from(row))]), new Curves(positions)];
  curves.forEach((one) => assert.deepEqual([one.length, [...one.points]], [1, positions]));
  const seam = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0], faces: [0, 1, 2, 3, 5, 4] };
  const [apart] = filters.boundary_loops(seam), [together] = filters.boundary_loops({ ...seam, merge: [0, 1, 2, 1, 2, 5] });
  assert.deepEqual([apart.length, together.length], [2, 1]);
});

test("what is no mesh and no curve is refused", () => {
  const mesh = sheet();
  for (const wrong of [
    () => filters.weld(), () => filters.weld({ positions: [0, 0], faces: [] }), () => filters.weld({ positions: [0, 0, 0], faces: [0, 0] }),
    () => filters.weld({ positions: [0, 0, 0], faces: [0, 0, -1] }), () => filters.weld({ positions: [0, 0, 0], faces: { offsets: [0, 9], corners: [0, 0, 0] } }),
    () => filters.weld({ positions: [0, 0, 0], faces: { offsets: [], corners: [0, 0, 0] } }), () => filters.weld(mesh, { tolerances: 1 }),
    () => filters.weld(mesh, { vertices: "some" }), () => filters.deform(mesh, { axis: [1, 2] }), () => new Curves([0, 0, 0], { closed: [true, false] }),
    () => filters.weld({ positions: mesh.positions, faces: mesh.faces, merge: [0] }), () => filters.check({ positions: {}, faces: [] }),
    () => filters.check({ positions: [[0, 0], [1, 0], [0, 1], [1, 1], [2, 1], [2, 2]], faces: [0, 1, 2] }), () => new Curves(mesh),
    () => new Curves([[0, 0, 0, 1, 0, 0], [0, 1, 0, 1, 1, 0]]),
  ]) {
    assert.throws(wrong, (error) => error instanceof TypeError || error instanceof InputError);
  }
});

test("a failure names the element at fault", () => {
  assert.throws(() => filters.weld({ positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], faces: [0, 1, 7] }), (error) => {
    assert.ok(error instanceof InputError && error instanceof GussetError && error.name === "InputError");
    assert.deepEqual([error.code, error.element, error.index, error.value, error.input, error.param], ["index_out_of_range", "half_edge", 2, 7, 0, null]);
    return error.message.length > 10;
  });
  assert.throws(() => filters.weld(sheet(), { tolerance: -3 }), (error) => error.code === "out_of_range" && error.param === 1 && error.status === 5);
});

test("progress is told, and cancels by false and by what it throws", () => {
  const mesh = sheet(120, 120), parts = [];
  const progress = (fraction, stage) => {
    assert.ok(stage.length > 0);
    parts.push(fraction);
  };
  filters.weld(mesh, { progress });
  assert.ok(parts.length > 1 && parts.every((part, k) => part >= (parts[k - 1] ?? 0)) && parts.at(-1) === 1);
  assert.throws(() => filters.weld(mesh, { progress: () => false }), (error) => error instanceof Cancelled && error.code === "cancelled");
  let count = 0;
  assert.throws(() => filters.weld(mesh, { progress: () => { count++; throw new RangeError("of the host"); } }), { name: "RangeError", message: "of the host" });
  assert.equal(count, 1);
  assert.throws(() => filters.weld(mesh, { progress: () => { throw null; } }), (thrown) => thrown === null);
  // One run within another.
  let inner = null;
  filters.weld(mesh, { progress: () => void (inner ??= filters.check(tube())) });
  assert.equal(inner.text, filters.check(tube()).text);
  const said = [], turned = cap(-1);
  filters.stitch(cap(), new Mesh(turned.positions, turned.triangles.slice().reverse()), { log: (message) => said.push(message) });
  assert.ok(said.length > 0 && said[0].length > 0);
});

test("values are carried over to what came out", () => {
  const a = cap(), b = cap(-1), inputs = [a, b];
  const outputs = filters.stitch.run(inputs, { origins: true }), [mesh, report] = outputs;
  assert.ok(outputs instanceof Outputs && outputs.length === 2 && report instanceof Report && outputs.hasOrigins());
  const values = inputs.map((one) => Float32Array.from({ length: 2 * one.vertexCount }, (_, k) => k));
  const carried = outputs.carry(values);
  assert.equal(carried.constructor, Float32Array);
  assert.deepEqual(carried.subarray(0, values[0].length), values[0]);
  assert.equal(carried.length, 2 * mesh.vertexCount);
  const materials = outputs.carry([null, new Uint8Array(b.faceCount).fill(3)], { domain: "faces", rule: "nearest" });
  assert.ok(materials.length === mesh.faceCount && materials.includes(3) && materials.includes(0));
  assert.throws(() => outputs.carry([new Float32Array(2), null], { components: 1 }), InputError);
  for (const options of [
    { rule: "nearst" }, { domain: "edges" }, { components: 0 }, { components: -1 }, { components: 1.5 }, { components: 3 }, { index: 1 }, { index: 2 },
    { index: 0n }, { domain: "constructor" },
  ]) {
    assert.throws(() => outputs.carry(values, options), TypeError, JSON.stringify(Object.keys(options)));
  }
  assert.throws(() => outputs.carry([new Float32Array(a.vertexCount + 1), null]), TypeError);
  assert.throws(() => outputs.carry(values, { components: 2 ** 32 + 2 }), (error) => error instanceof TypeError || error instanceof OutOfMemory);
  // Refused before the library is called: what goes wrong within that stops it.
  assert.throws(() => outputs.hasOrigins(0n), TypeError);
  assert.deepEqual(outputs.carry(values), carried);
  outputs.free();
  outputs.free();
  assert.throws(() => outputs.carry(values));
  assert.equal(mesh.faceCount, outputs.at(0).faceCount);
});

test("memory is given back", () => {
  const a = cap(1, 30, 100), b = cap(-1, 30, 100);
  const once = () => filters.stitch(a, b);
  const wrong = () => assert.throws(() => filters.weld({ positions: a.positions, faces: [0, 1, 1 << 20] }));
  once();
  wrong();
  const before = memory.buffer.byteLength;
  for (let k = 0; k < 60; k++) {
    once();
    wrong();
  }
  assert.equal(memory.buffer.byteLength, before);
});

test("without memory there is no room for hosts, and again when there is", async () => {
  // Calls the library itself, because no filter reports other failures.
  const instance = await WebAssembly.instantiate(await WebAssembly.compile(await readFile(file)), {});
  const library = new Library(instance), blocks = [];
  library.withRoom(({ allocate }) => {
    for (let size = 2 ** 30; size >= 16; size /= 2) {
      assert.throws(() => { for (;;) blocks.push(allocate(size)); }, OutOfMemory);
    }
    assert.throws(() => allocate(2 ** 32 + 16), OutOfMemory);
    // Memory reserved for running calls is not given to hosts.
    assert.ok(blocks.every((block) => block >= instance.exports.__heap_base.value));
  });
  library.withRoom(({ allocate }) => allocate(2 ** 30));
});

test("what a run left is given back if JavaScript has no room for it", () => {
  const mesh = sheet(300, 300), { slice } = Float64Array.prototype, fail = () => { throw new RangeError("Array buffer allocation failed"); };
  filters.weld(mesh);
  const before = memory.buffer.byteLength;
  try {
    Float64Array.prototype.slice = fail;
    for (let k = 0; k < 60; k++) {
      assert.throws(() => filters.weld(mesh), OutOfMemory);
    }
  } finally {
    Float64Array.prototype.slice = slice;
  }
  assert.equal(memory.buffer.byteLength, before);
});

test("counts that 32 bits cannot hold are errors", () => {
  for (const [rows, columns] of [[100001, 100001], [65536, 65536], [60000, 60000], [40000, 30000], [30000, 30000], [20000, 10000]]) {
    const call = () => filters.net_resample(sheet(), { rows, columns });
    assert.throws(call, (error) => error instanceof OutOfMemory || error.code === "too_large", `${rows} x ${columns}`);
  }
  assert.equal(filters.check(sheet()).values.vertices, 63);
});

test("after a trap nothing is called any more", async () => {
  const instance = await WebAssembly.instantiate(await WebAssembly.compile(await readFile(file)), {});
  const library = new Library(instance);
  assert.throws(() => library.call(0xffff), Stopped);
  assert.throws(() => library.call(library.table.filter, 0), (error) => error instanceof Stopped && error.status === constants.ERROR_PANIC && error.code === "panic");
});

test("bundlers find what they must bring along, and nothing of node's", async () => {
  for (const [name, module] of [["gusset.js", "gusset.wasm"], ["files.js", "gusset_files.wasm"], ["loading.js", null]]) {
    const text = await readFile(new URL(`../${name}`, import.meta.url), "utf8");
    assert.ok(module === null || text.includes(`new URL("${module}", import.meta.url)`), name);
    assert.ok(!/(import\(|from )"node:/.test(text), name);
  }
});

test("it is loaded from bytes, a module and a response", async () => {
  const bytes = await readFile(file);
  for (const source of [
    bytes, await WebAssembly.compile(bytes), new Response(bytes), Promise.resolve(new Response(bytes)), file, file.href,
  ]) {
    assert.equal((await load(source)).version, version);
  }
});
