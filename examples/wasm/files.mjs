import { load, read, write } from "../../wasm/gusset.js"; // of the package: from "gusset-mesh"

// A pyramid without its base. In a page: bytes = await file.arrayBuffer().
const bytes = new TextEncoder().encode(`
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0.5 0.5 1
f 1 2 5
f 2 3 5
f 3 4 5
f 4 1 5`);
const { meshes: [pyramid], notes } = await read("pyramid.obj", bytes);

const { filters } = await load();
const [closed] = filters.fill(pyramid);

const { files, losses } = await write("closed.glb", { meshes: [{ ...closed, name: "pyramid" }] });
console.log(closed.faceCount, [...files.keys()], files.get("closed.glb").length, losses, notes);

try {
  await read("broken.obj", new TextEncoder().encode("v 0 0 0\nf 1 2 3\n"));
} catch (error) {
  console.log(error.code, error.message);
}
