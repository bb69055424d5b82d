// Files read and written from JavaScript.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { Curves, FileError, GussetError, load, loadFiles, Mesh, OutOfMemory, read, Stopped, write } from "../gusset.js";
import { structs } from "../tables.js";
import { BINARY_STL, BUFFER, binaryStl, bytes, DXF, FOLDER, GLTF, MTL, mutated, OBJ, OFF, PLY, randomNumbers, SAMPLES, SVG, TEXT_STL, XYZ } from "./samples.mjs";

const file = new URL("../gusset_files.wasm", import.meta.url);
const NO_MATERIAL = 0xffffffff;

/** The volume within a closed mesh, by its faces as fans. */
function volume({ positions, faces: { offsets, corners } }) {
  const at = (corner) => positions.subarray(3 * corners[corner], 3 * corners[corner] + 3);
  let sum = 0;
  for (let f = 0; f + 1 < offsets.length; f++) {
    for (let k = offsets[f] + 1; k + 1 < offsets[f + 1]; k++) {
      const [a, b, c] = [at(offsets[f]), at(k), at(k + 1)];
      sum += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
    }
  }
  return sum;
}

await test("the module is loaded by the first call, and anew after a trap", async () => {
  const { instantiate } = WebAssembly, instances = [];
  WebAssembly.instantiate = async (...given) => {
    const made = await instantiate(...given);
    if (made.exports.gusset_files_entry) {
      instances.push(made);
    }
    return made;
  };
  try {
    await Promise.all([read("a.stl", TEXT_STL), read("b.stl", BINARY_STL)]);
    await write("a.off", { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], faces: [0, 1, 2] });
    assert.equal(instances.length, 1);
    new Uint8Array(instances[0].exports.memory.buffer).fill(0xff);
    await assert.rejects(read("a.stl", TEXT_STL), (error) => error instanceof Stopped && error.code === "panic" && /module for files has stopped/.test(error.message));
    assert.equal((await read("a.stl", TEXT_STL)).meshes[0].faceCount, 4);
    assert.equal(instances.length, 2);
  } finally {
    WebAssembly.instantiate = instantiate;
  }
});

test("after a trap, a module of one's own says so at each call", async () => {
  const files = await loadFiles();
  new Uint8Array(files.memory.buffer).fill(0xff);
  assert.throws(() => files.read("a.stl", TEXT_STL), Stopped);
  assert.throws(() => files.read("a.stl", TEXT_STL), (error) => error instanceof Stopped && /load it again/.test(error.message));
  assert.throws(() => files.write("a.stl", { positions: [], faces: [] }), Stopped);
});

const files = await loadFiles();

test("the package has the module", async () => {
  const manifest = JSON.parse(await readFile(new URL("../package.json", import.meta.url), "utf8"));
  for (const name of ["files.js", "documents.js", "loading.js", "gusset_files.wasm"]) {
    assert.ok(manifest.files.includes(name), name);
  }
  const { exports } = await WebAssembly.instantiate(await WebAssembly.compile(await readFile(file)), {});
  const view = new DataView(exports.memory.buffer), table = exports.gusset_files_entry(1);
  assert.equal(view.getUint32(table, true), structs.gusset_files.size);
  assert.equal(exports.gusset_files_entry(99), 0);
});

test("it is loaded from bytes, a module, a response and an address", async () => {
  const given = await readFile(file);
  for (const source of [given, await WebAssembly.compile(given), Promise.resolve(new Response(given)), file, file.href, "gusset_files.wasm"]) {
    assert.equal((await loadFiles(source)).read("a.stl", TEXT_STL).meshes.length, 1);
  }
});

test("STL files are closed meshes, which filters take as they are", async () => {
  const { filters } = await load();
  for (const [name, content] of [["a.stl", TEXT_STL], ["A.STL", BINARY_STL], ["a.stl", BINARY_STL.buffer], ["a.stl", new DataView(TEXT_STL.slice().buffer)], ["a.stl", Buffer.from(TEXT_STL)]]) {
    const { meshes: [mesh], placements, curves, points } = files.read(name, content);
    assert.ok(mesh instanceof Mesh && mesh.positions instanceof (content === TEXT_STL ? Float64Array : mesh.positions.constructor));
    assert.deepEqual([mesh.vertexCount, mesh.faceCount, placements.length, curves, points], [4, 4, 1, null, null]);
    assert.ok(Math.abs(volume(mesh) - 1 / 6) < 1e-7);
    assert.equal(filters.boundary_loops(mesh)[0].length, 0);
    assert.equal(filters.check(mesh).values.vertices, 4);
  }
});

test("OBJ files have materials, texture coordinates and polylines", () => {
  const { meshes: [mesh], materials, images, curves } = files.read("a.obj", OBJ, { folder: FOLDER });
  assert.deepEqual([mesh.vertexCount, mesh.faceCount, mesh.triangles, mesh.name], [5, 5, null, "pyramid"]);
  assert.ok(Math.abs(volume(mesh) - 1 / 3) < 1e-12);
  assert.deepEqual([...mesh.faceMaterials], [NO_MATERIAL, 0, 0, 0, 0]);
  assert.equal(mesh.texcoords.domain, "corners");
  assert.deepEqual([...mesh.texcoords.values.subarray(0, 8)].map((value) => Number.isNaN(value)), Array(8).fill(true));
  assert.deepEqual([...mesh.texcoords.values.subarray(8, 14)], [0, 0, 1, 0, 0.5, 1]);
  assert.deepEqual([materials[0].name, [...materials[0].colour], images[materials[0].image].file], ["red", [1, 0, 0, 1], "red.png"]);
  assert.ok(curves instanceof Curves);
  assert.deepEqual([[...curves.points], [...curves.offsets], [...curves.closed]], [[0, 0, 0, 1, 1, 0], [0, 2], [0]]);
});

test("PLY files have colours and properties", () => {
  const { meshes: [mesh] } = files.read("a.ply", PLY);
  assert.deepEqual([...mesh.vertexColours], [1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 1, 1, 1]);
  const [{ name, domain, kind, values }] = mesh.properties;
  assert.deepEqual([name, domain, kind, [...values]], ["depth", "vertices", "i16", [-7, 8, 9, 10]]);
  assert.equal(mesh.positions[8], Math.fround(0.1));
});

test("OFF files have polygons, and XYZ files points", () => {
  const { meshes: [mesh] } = files.read("a.off", OFF), { points, meshes } = files.read("a.xyz", XYZ);
  assert.deepEqual([mesh.faceCount, mesh.faces.corners.length], [4, 16]);
  assert.deepEqual([[...points.positions], points.normals, points.colours, meshes.length], [[0, 0, 0, 1, 2, 3, -1.5, 0.25, 1000], null, null, 0]);
});

test("SVG and DXF files have curves", () => {
  const { curves: outline, meshes } = files.read("a.svg", SVG), { curves: line } = files.read("a.dxf", DXF);
  assert.deepEqual([meshes.length, outline.length, [...outline.closed], outline.points.length], [0, 1, [1], 9]);
  assert.deepEqual([line.length, [...line.closed], [...line.points]], [1, [0], [0, 0, 0, 1, 2, 3]]);
});

test("scenes are joined, or kept", () => {
  const joined = files.read("a.gltf", GLTF, { folder: FOLDER }), scene = files.read("a.gltf", GLTF, { folder: FOLDER, scene: true });
  assert.deepEqual([...joined.meshes[0].positions], [0, 0, 0, 1, 0, 0, 0, 1, 0, 10, 0, 0, 11, 0, 0, 10, 1, 0]);
  assert.deepEqual([scene.meshes.length, scene.meshes[0].vertexCount, scene.placements.map(({ name, mesh }) => [name, mesh])], [1, 3, [["left", 0], ["right", 0]]]);
  assert.deepEqual([...scene.placements[1].transform], [1, 0, 0, 10, 0, 1, 0, 0, 0, 0, 1, 0]);
  assert.deepEqual([...scene.materials[0].colour], [0, 0, 1, 1]);
  const { files: made } = files.write("b.gltf", scene);
  assert.deepEqual([...made.keys()][0], "b.gltf");
  const again = files.read("b.gltf", made.get("b.gltf"), { folder: made, scene: true });
  assert.deepEqual(again.placements, scene.placements);
  assert.deepEqual(again.meshes[0].positions, scene.meshes[0].positions);
});

test("a folder is an object, a map or a function", () => {
  for (const folder of [
    { "a.mtl": MTL }, { "a.mtl": MTL.buffer }, new Map([["a.mtl", MTL]]), (name) => (name === "a.mtl" ? MTL : null), Object.assign(Object.create(null), { "a.mtl": MTL }),
  ]) {
    assert.equal(files.read("a.obj", OBJ, { folder }).materials[0].native.mtl.length, 2);
  }
  const asked = [];
  const { materials, notes } = files.read("a.obj", OBJ, { folder: (name) => void asked.push(name) });
  assert.deepEqual([asked, [...materials[0].colour], materials[0].native], [["a.mtl"], [1, 1, 1, 1], null]);
  assert.ok(notes.some(({ text }) => text.includes("a.mtl")));
  assert.equal(files.read("a.obj", OBJ).notes.length, notes.length);
  // Names of other systems.
  for (const name of [".\\a.mtl", "./a.mtl"]) {
    assert.equal(files.read("a.obj", bytes(`mtllib ${name}\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3`), { folder: FOLDER }).materials[0].colour[1], 0);
  }
  // Members of all objects are not files.
  assert.equal(files.read("a.obj", bytes("mtllib constructor\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3"), { folder: {} }).meshes.length, 1);
  assert.throws(() => files.read("a.gltf", GLTF), (error) => error instanceof FileError && error.message.includes("a.bin"));
  // Empty files, and a file that is asked for within a call of its own.
  assert.throws(() => files.read("a.gltf", GLTF, { folder: { "a.bin": new Uint8Array() } }), FileError);
  let inner = null;
  files.read("a.obj", OBJ, { folder: (name) => (inner = files.read("a.gltf", GLTF, { folder: FOLDER }), FOLDER[name]) });
  assert.equal(inner.meshes[0].vertexCount, 6);
});

test("exceptions of a folder are passed on", () => {
  assert.throws(() => files.read("a.obj", OBJ, { folder: () => { throw new RangeError("of the host"); } }), { name: "RangeError", message: "of the host" });
  assert.throws(() => files.read("a.obj", OBJ, { folder: async () => MTL }), (error) => error instanceof TypeError && /promise/.test(error.message));
  assert.throws(() => files.read("a.obj", OBJ, { folder: { "a.mtl": "newmtl red" } }), TypeError);
  assert.equal(files.read("a.obj", OBJ, { folder: FOLDER }).materials.length, 1);
});

/** The start of an image. */
const PNG = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 1, 2, 3);
/** A mesh with each attribute. */
const RICH = {
  name: "rich \u{1f600}", positions: Float64Array.of(0.1, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5, 1 / 3), faces: [[0, 1, 2, 3], [0, 4, 1]],
  normals: { domain: "corners", values: [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, -1, 0, 0, -1, 0, 0, -1, 0] },
  texcoords: { values: [0, 0, 1, 0, 1, 1, 0, 1, 0.5, 0.5] },
  vertexColours: Array.from({ length: 20 }, (_, k) => (k % 4 === 3 ? 1 : (k % 3) / 2)), faceMaterials: [0, NO_MATERIAL],
  properties: [{ name: "quality", kind: "f32", values: [1, 2, 3, 4, 0.5] }, { name: "part", domain: "faces", kind: "u8", values: [7, 9] }],
};
const DOCUMENT = {
  meshes: [RICH], materials: [{ name: "red", colour: Float32Array.of(1, 0, 0, 1), image: 0 }], images: [{ name: "dot", mediaType: "image/png", bytes: PNG }],
};

test("what a format holds comes back", () => {
  const kept = (name, { folder, scene = true, ...options } = {}) => {
    const { files: made, losses } = files.write(name, DOCUMENT, options);
    return { ...files.read(name, made.get(name), { folder: made, scene }), losses, made };
  };
  const { meshes: [ply], losses } = kept("a.ply");
  assert.deepEqual([...ply.positions], [...RICH.positions]);
  assert.ok(losses.some((loss) => loss.includes("materials")), String(losses));
  assert.deepEqual(ply.properties.map(({ name, domain, kind, values }) => [name, domain, kind, [...values]]).sort(), [["part", "faces", "u8", [7, 9]], ["quality", "vertices", "f32", [1, 2, 3, 4, 0.5]]]);
  const obj = kept("dir/a.obj");
  assert.deepEqual([...obj.made.keys()].sort(), ["a.mtl", "a_red.png", "dir/a.obj"]);
  assert.deepEqual([...obj.meshes[0].positions], [...RICH.positions]);
  assert.deepEqual([obj.meshes[0].normals.domain, obj.materials[0].name, [...obj.meshes[0].faceMaterials]], ["corners", "red", [0, NO_MATERIAL]]);
  const glb = kept("a.glb");
  assert.deepEqual([glb.meshes[0].name, glb.meshes[0].faceCount, [...glb.images[0].bytes], glb.images[0].mediaType], ["rich \u{1f600}", 2, [...PNG], "image/png"]);
  assert.equal(kept("a.3mf").meshes[0].vertexCount, 5);
  assert.equal(kept("a.off").meshes[0].faceCount, 2);
  const text = kept("a.stl", { text: true });
  assert.ok(Buffer.from(text.made.get("a.stl")).toString().startsWith("solid"));
  assert.ok(kept("a.stl").made.get("a.stl").length === 84 + 50 * 3);
});

test("meshes, curves and points are written as they are", () => {
  const only = ({ files: made, losses }) => [...made.values(), losses.length].slice(0, 2);
  const mesh = new Mesh([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2]);
  const [stl] = only(files.write("a.stl", mesh));
  assert.equal(stl.length, 134);
  assert.deepEqual(only(files.write("a.stl", { positions: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], faces: [[0, 1, 2]] }))[0], stl);
  const [xyz] = only(files.write("a.xyz", { positions: Float32Array.of(0.1, 2, 3) }));
  assert.deepEqual([...files.read("a.xyz", xyz).points.positions].map(Math.fround), [Math.fround(0.1), 2, 3]);
  for (const curves of [[[[0, 0, 0], [1, 0, 0]]], { points: [0, 0, 0, 1, 0, 0] }, new Curves([0, 0, 0, 1, 0, 0])]) {
    const [obj] = only(files.write("a.obj", curves));
    assert.deepEqual([...files.read("a.obj", obj).curves.points], [0, 0, 0, 1, 0, 0]);
  }
  const far = { positions: Float64Array.of(1e9, 0, 0, 1e9 + 0.1, 0, 0, 1e9, 0.1, 0), faces: [0, 1, 2] };
  assert.throws(() => files.write("a.stl", far), (error) => error instanceof FileError && /permit the loss/.test(error.message));
  assert.ok(files.write("a.stl", far, { lossy: true }).losses.some((loss) => /rounded/.test(loss)));
});

test("failures name the file and the line or element", () => {
  const message = (call) => {
    try {
      call();
    } catch (error) {
      assert.ok(error instanceof FileError && error instanceof GussetError && error.code === "bad_file" && error.status === 2, String(error));
      return error.message;
    }
    return assert.fail("no failure");
  };
  assert.match(message(() => files.read("a.obj", bytes("v 0 0 0\nv 1 0 x\n"))), /^a\.obj:2: .*"x"/);
  assert.match(message(() => files.read("a.off", bytes("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"))), /^a\.off:.*7.*\b3\b/);
  assert.match(message(() => files.read("a.fbx", new Uint8Array(9))), /^a\.fbx: /);
  assert.match(message(() => files.read("stl", TEXT_STL)), /^stl: /);
  assert.match(message(() => files.write("a.ply", { meshes: [{ positions: [0, 0, 0], faces: [0, 1, 2] }] })), /face 0, corner 1: vertex 1 does not exist/);
  assert.match(message(() => files.write("a.ply", { meshes: [{ ...RICH, texcoords: { values: [0, 0] } }] })), /texture coordinates have 1 entries/);
  assert.match(message(() => files.write("a.ply", { meshes: [RICH] })), /material 0 does not exist/);
  assert.match(message(() => files.write("a.ply", { ...DOCUMENT, placements: [{ mesh: 3, transform: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0] }] })), /mesh 3 does not exist/);
  assert.match(message(() => files.write("a.conf", { positions: [0, 0, 0], faces: [] })), /^a\.conf: /);
});

test("mistakes in arguments are refused before the call", () => {
  const triangle = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], faces: [0, 1, 2] };
  for (const wrong of [
    () => files.read("a.stl"), () => files.read("a.stl", "solid"), () => files.read("a.stl", [1, 2]), () => files.read(7, TEXT_STL), () => files.read("a\0.stl", TEXT_STL),
    () => files.read("a.stl", TEXT_STL, { folders: {} }), () => files.read("a.stl", TEXT_STL, { text: true }), () => files.read("a.obj", OBJ, { folder: "." }),
    () => files.read("a.stl", Promise.resolve(TEXT_STL)), () => files.write("a.stl"), () => files.write("a.stl", {}), () => files.write("a.stl", triangle, { scene: true }),
    () => files.write("a.ply", { meshes: [{ ...triangle, normals: { domain: "faces", values: [] } }] }), () => files.write("a.ply", { meshes: [{ ...triangle, vertexColours: [1, 2] }] }),
    () => files.write("a.ply", { meshes: [{ ...triangle, normals: { values: 3 } }] }), () => files.write("a.ply", { meshes: [{ ...triangle, properties: [{ name: "a", kind: "u64", values: [] }] }] }),
    () => files.write("a.ply", { meshes: [triangle], placements: [{ mesh: 0, transform: [1, 2] }] }), () => files.write("a.ply", { meshes: [{}] }), () => files.write("a.ply", { points: {} }),
    () => files.write("a.ply", { points: { positions: [1, 2] } }), () => files.write("a.ply", "mesh"),
  ]) {
    assert.throws(wrong, TypeError, String(wrong));
  }
  // Texts that UTF-8 cannot hold.
  assert.equal(files.write("a.obj", { meshes: [{ ...triangle, name: "\ud800" }] }).files.size, 1);
});

test("hostile files cost no more than their size", async () => {
  const { memory, read: readFresh } = await loadFiles();
  const before = memory.buffer.byteLength, deep = "[".repeat(100_000);
  const header = "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n";
  const failures = [
    ["a.ply", bytes(`${header}property double x\nproperty double y\nproperty double z\nend_header\n`)],
    ["a.off", bytes("OFF\n4000000000 4000000000 0\n")], ["a.gltf", bytes(deep)], ["a.gltf", bytes(`{"a":${deep}`)], ["a.glb", bytes("glTF\x02\0\0\0\xff\xff\xff\xff")],
    ["a.3mf", bytes("PK\x03\x04")], ["a.obj", bytes("f 1 2 3\n")], ["a.gltf", bytes("{}")],
  ];
  for (const [name, content] of failures) {
    assert.throws(() => readFresh(name, content), FileError, name);
  }
  const nothing = Array.from({ length: 20_000 }, () => Array(9).fill(NaN));
  const start = performance.now();
  assert.equal(readFresh("a.stl", binaryStl(nothing)).meshes[0].faceCount, 20_000);
  assert.throws(() => readFresh("a.stl", binaryStl(nothing, 4_000_000_000)), FileError);
  assert.ok(performance.now() - start < 5000);
  assert.ok(memory.buffer.byteLength - before < 32 * 2 ** 20 + 32 * 1_000_084, `${memory.buffer.byteLength - before}`);
});

test("mutated files are read, or refused, and never trap", () => {
  const { files: glb } = files.write("m.glb", DOCUMENT), { files: threeMf } = files.write("m.3mf", DOCUMENT), { files: ply } = files.write("m.ply", DOCUMENT);
  const all = Object.entries({ ...SAMPLES, ...Object.fromEntries([...glb, ...threeMf, ...ply]) });
  const counts = { read: 0, refused: 0 }, random = randomNumbers(1);
  for (const [name, content] of all) {
    for (let k = 0; k < 400; k++) {
      const given = mutated(content, random);
      let document;
      try {
        document = files.read(name, given, { folder: (asked) => (random(2) ? mutated(FOLDER[asked] ?? MTL, random) : FOLDER[asked]), scene: random(2) === 0 });
      } catch (error) {
        assert.ok(error instanceof FileError || error instanceof OutOfMemory, `${name}, mutation ${k}: ${error.stack}`);
        counts.refused++;
        continue;
      }
      counts.read++;
      for (const { faces, vertexCount, faceMaterials } of document.meshes) {
        assert.ok(faces.corners.every((corner) => corner < vertexCount) && faces.offsets.at(-1) === faces.corners.length);
        assert.ok(faceMaterials?.every((material) => material === NO_MATERIAL || material < document.materials.length) ?? true);
      }
      for (const target of ["b.obj", "b.ply", "b.glb", "b.stl", "b.3mf"]) {
        try {
          files.write(target, document, { lossy: true });
        } catch (error) {
          assert.ok(error instanceof FileError, `${name}, mutation ${k}, written to ${target}: ${error.stack}`);
        }
      }
    }
  }
  assert.ok(counts.read > 500 && counts.refused > 500, JSON.stringify(counts));
});

test("memory is given back", () => {
  const positions = Float32Array.from({ length: 30_000 }, (_, k) => k % 97), faces = Uint32Array.from({ length: 30_000 }, (_, k) => (k * 7) % 10_000);
  const once = () => files.read("a.glb", files.write("a.glb", { positions, faces }).files.get("a.glb"));
  const wrong = () => assert.throws(() => files.write("a.glb", { positions: positions.subarray(3), faces }), FileError);
  const { slice } = Uint8Array.prototype, fail = () => { throw new RangeError("Array buffer allocation failed"); };
  const [content] = files.write("a.stl", { positions, faces }).files.values();
  const full = () => {
    try {
      Uint8Array.prototype.slice = fail;
      assert.throws(() => files.read("a.stl", content), OutOfMemory);
    } finally {
      Uint8Array.prototype.slice = slice;
    }
  };
  const all = () => [once, wrong, full].forEach((call) => call());
  all();
  const before = files.memory.buffer.byteLength;
  for (let k = 0; k < 40; k++) {
    all();
  }
  assert.equal(files.memory.buffer.byteLength, before);
});
