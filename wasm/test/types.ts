// Code that a TypeScript compiler must accept or refuse: `tsc --noEmit --strict --target es2022 --module nodenext
// types.ts`.

import { Curves, FileDocument, FileError, load, loadFiles, Mesh, Outputs, read, Report, InputError, write } from "../gusset.js";

const { filters } = await load();
const mesh = { positions: new Float32Array(9), faces: Uint32Array.of(0, 1, 2) };

const [welded, report]: [Mesh, Report] = filters.weld(mesh, { tolerance: 1e-3, vertices: "all_vertices", progress: (fraction) => fraction < 0.5 });
const count: number = report.values.vertices ?? welded.vertexCount;
const text: string = filters.check(mesh).text;
filters.stitch(mesh, mesh, { meridians: "least_area" });
filters.stitch(mesh);
filters.stitch(mesh, { meridians: "least_area" });
filters.smooth_net([[[0, 0, 0], [1, 0, 0]]], { tolerance: 0.5 });
filters.join(mesh, mesh, mesh, { max_gap: 1 });
const bent: Mesh = filters.deform(mesh, { field: "twist", axis: 1 });
const [loops]: [Curves, Report] = filters.outline(new Curves([mesh.positions], { closed: true }));
const made: Mesh = filters.net_shape({ rows: 9 })[0];
const outputs: Outputs = filters.stitch.run([mesh, mesh], { origins: true });
const colours: Uint8Array = outputs.carry([new Uint8Array(9), null], { rule: "linear" });
const at = (error: unknown) => (error instanceof InputError && error.element === "vertex" ? error.index : null);

const found: FileDocument = await read("a.obj", new Uint8Array(), { folder: { "a.mtl": new Uint8Array() }, scene: true });
filters.weld(found.meshes[0]);
const normals: Float64Array | undefined = found.meshes[0].normals?.values;
const { files, losses } = await write("a.ply", found, { text: true, folder: files => (files === "a.png" ? new Uint8Array() : null) });
await write("b.glb", { meshes: [{ ...mesh, name: "b", normals: { values: [0, 0, 1] } }], materials: [{ name: "red", colour: [1, 0, 0, 1] }] });
await write("c.stl", mesh);
await write("d.xyz", { positions: [0, 0, 0] });
const again: FileDocument = (await loadFiles()).read("a.obj", files.get("a.ply")!, { folder: files });
const isBad = (error: unknown) => error instanceof FileError && error.code === "bad_file";

// @ts-expect-error: the option does not exist
read("a.obj", new Uint8Array(), { folders: {} });
// @ts-expect-error: a text is not bytes
read("a.obj", "v 0 0 0");
// @ts-expect-error: the domain does not exist
write("a.ply", { meshes: [{ ...mesh, normals: { domain: "faces", values: [] } }] });
// @ts-expect-error: the parameter does not exist
filters.weld(mesh, { tolerances: 1 });
// @ts-expect-error: the choice does not exist
filters.weld(mesh, { vertices: "some" });
// @ts-expect-error: the rule does not exist
outputs.carry([new Uint8Array(9), null], { rule: "nearst" });
// @ts-expect-error: the element does not exist
const wrong = (error: InputError) => error.element === "vertices";
// @ts-expect-error: there is a mesh too many
filters.stitch(mesh, mesh, mesh);
// @ts-expect-error: a mesh is missing
filters.weld();

export { again, at, bent, colours, count, isBad, loops, losses, made, normals, text, wrong };
