import { load } from "../../wasm/gusset.js"; // of the package: from "gusset-mesh"

const { filters } = await load();

// Two open pyramids, point up and point down, with a gap between their square rims.
const up = [[0, 0, 2], [1, 0, 1], [0, 1, 1], [-1, 0, 1], [0, -1, 1]];
const down = up.map(([x, y, z]) => [x, -y, -z]);
const faces = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]];

const [joined, report] = filters.stitch({ positions: up, faces }, { positions: down, faces }, { meridians: "least_area" });
console.log(joined.faceCount, joined.positions, joined.triangles);
console.log(report.text, report.values);

try {
  filters.weld({ positions: up.flat(), faces: Uint32Array.of(0, 1, 9) });
} catch (error) {
  console.log(error.message, error.code, error.element, error.index, error.value);
}
