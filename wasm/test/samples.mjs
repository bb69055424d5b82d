// Files written by hand, and helpers to make more.

const encoder = new TextEncoder();

/** The bytes of a text. */
export const bytes = (text) => encoder.encode(text);

/** A tetrahedron of 4 vertices. Its volume is 1/6. */
export const CORNERS = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
const VERTICES = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];

const facet = (corners) => `facet normal 0 0 0\nouter loop\n${corners.map((corner) => `vertex ${VERTICES[corner].join(" ")}\n`).join("")}endloop\nendfacet\n`;

/** The tetrahedron as a text STL file. */
export const TEXT_STL = bytes(`solid t\n${CORNERS.map(facet).join("")}endsolid t\n`);

/** A binary STL file of facets of nine numbers. count: the count in its header. */
export function binaryStl(facets, count = facets.length) {
  const view = new DataView(new ArrayBuffer(84 + 50 * facets.length));
  view.setUint32(80, count, true);
  facets.forEach((numbers, k) => numbers.forEach((number, i) => view.setFloat32(84 + 50 * k + 12 + 4 * i, number, true)));
  return new Uint8Array(view.buffer);
}

export const BINARY_STL = binaryStl(CORNERS.map((corners) => corners.flatMap((corner) => VERTICES[corner])));

export const MTL = bytes("newmtl red\nKd 1 0 0\nmap_Kd red.png\n");

/** A square pyramid with a quad, texture coordinates, two materials and a polyline. */
export const OBJ = bytes(`mtllib a.mtl
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0.5 0.5 1
vt 0 0
vt 1 0
vt 0.5 1
o pyramid
f 4 3 2 1
usemtl red
f 1/1 2/2 5/3
f 2/1 3/2 5/3
f 3/1 4/2 5/3
f 4/1 1/2 5/3
l 1 3
`);

/** Two triangles with colours and a property, and a value of the whole file that means nothing. */
export const PLY = bytes(`ply
format ascii 1.0
comment by hand
element vertex 4
property float x
property float y
property float z
property uchar red
property uchar green
property uchar blue
property short depth
element face 2
property list uchar int vertex_indices
end_header
0 0 0 255 0 0 -7
1 0 0 0 255 0 8
1 1 0.1 0 0 255 9
0 1 0 255 255 255 10
3 0 1 2
3 0 2 3
`);

export const OFF = bytes("OFF\n# a cube without two sides\n8 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");

/** One triangle of a buffer beside the file, placed twice. */
export const GLTF = bytes(JSON.stringify({
  asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [0, 1] }],
  nodes: [{ mesh: 0, name: "left" }, { mesh: 0, name: "right", translation: [10, 0, 0] }],
  meshes: [{ name: "triangle", primitives: [{ attributes: { POSITION: 0 }, material: 0 }] }],
  materials: [{ name: "blue", pbrMetallicRoughness: { baseColorFactor: [0, 0, 1, 1] } }],
  accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: "VEC3", min: [0, 0, 0], max: [1, 1, 0] }],
  bufferViews: [{ buffer: 0, byteLength: 36 }], buffers: [{ uri: "a.bin", byteLength: 36 }],
}));
export const BUFFER = new Uint8Array(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0).buffer);

export const XYZ = bytes("0 0 0\n1 2 3\n-1.5 0.25 1e3\n");

/** Files beside the samples. */
export const FOLDER = { "a.mtl": MTL, "a.bin": BUFFER };

/** Samples by their names. */
export const SAMPLES = { "text.stl": TEXT_STL, "binary.stl": BINARY_STL, "a.obj": OBJ, "a.ply": PLY, "a.off": OFF, "a.gltf": GLTF, "a.xyz": XYZ, "a.csv": bytes("x,y,z\n0,0,0\n1,2,3\n") };

/** A generator of whole numbers below a bound; the same sequence for each seed. */
export function randomNumbers(seed) {
  let state = seed;
  return (bound) => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) % bound;
  };
}

/** A copy of a file with a few random changes: bytes set, cut, repeated or inserted. */
export function mutated(file, random) {
  let made = [...file];
  for (let k = random(4); k >= 0; k--) {
    const at = random(made.length + 1), count = random(2) ? random(4) + 1 : random(made.length + 1);
    const change = [
      () => (made[Math.min(at, made.length - 1)] = random(256)),
      () => (made[Math.min(at, made.length - 1)] ^= 1 << random(8)),
      () => made.splice(at, count),
      () => made.splice(at, 0, ...made.slice(at, at + Math.min(count, 200))),
      () => made.splice(at, 0, ...Array.from({ length: Math.min(count, 20) }, () => random(256))),
      () => made.splice(at, 0, ...bytes(["nan", "1e999", "-1", "4294967295", "99999999999999999999", "\n", " ", "{", "[", "\""][random(10)])),
    ][random(6)];
    change();
    if (made.length === 0) {
      made = [random(256)];
    }
  }
  return Uint8Array.from(made);
}
