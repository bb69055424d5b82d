// The jobs for both libraries: each filter of the table on the shapes of python/tests/test_filters.py, and some more.

import { Curves, Mesh } from "../gusset.js";
import { cap, part, rings, sheet, tube } from "./shapes.mjs";

const SHEET = sheet();
const BESIDE = sheet(7, 9, undefined, ([x, y, z]) => [x, y + 1.2, z]);
const STEEP = sheet(7, 9, undefined, ([x, y, z]) => [z + 0.5, y, x - 0.5 + 0.1]);
const box = (z) => new Mesh([-z, z].flatMap((h) => [[-1.5, -1.5, h], [1.5, -1.5, h], [-1.5, 1.5, h], [1.5, 1.5, h]]).flat(),
  [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]);
const RINGS = rings();
const PAIR = part(RINGS, 0, 1);
const ASIDE = rings(2, 20, (k) => [3 * k, 0, 0]);
const LINES = new Curves([0, 0.4, 0.7, 1].map((x) => [[x, 0, 0.3 * x], [x, 0.5, 0.1], [x, 1, 0]]));
const ACROSS = new Curves([0, 0.5, 1].map((y) => [[0, y, 0], [0.4, y, 0.1], [0.7, y, 0.2], [1, y, 0.3]]));
const CROSSING = new Curves([[[-2, 0.1, 0], [-1, 0.2, 0], [2, 0.1, 0]], [[0.3, -2, 0], [0.2, -1, 0], [0.1, 2, 0]]]);
const INPUTS = {
  stitch: [cap(), cap(-1)], join: [cap(), cap(-1)], align: [cap(), cap()], trim: [cap(), cap()], fill: [tube()], develop: [tube()],
  smooth_intersect: [SHEET, STEEP], net_join: [SHEET, BESIDE], net_analyse: [SHEET, BESIDE], smooth_distance: [SHEET, BESIDE],
  net_settle: [SHEET, BESIDE], morph: [SHEET, BESIDE], lattice: [SHEET, box(1), box(2)], unite: [box(1), box(2)],
  facing_arcs: [ASIDE], strip: [PAIR], curve_meet: [CROSSING], curve_nearest: [RINGS, LINES], loft: [RINGS], smooth_net: [ACROSS, LINES],
  smooth_curve: [SHEET, CROSSING], smooth_nearest: [SHEET, CROSSING], net_lathe: [part(LINES, 0)], curve_offset: [part(RINGS, 0)],
  curve_svg: [part(RINGS, 0)],
};
/** A mesh turned about z, bent a little and moved. */
function moved({ positions, faces }, angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)], points = positions.slice();
  for (let k = 0; k < points.length; k += 3) {
    const [x, y, z] = points.subarray(k, k + 3);
    points.set([c * x - s * y + 0.05, s * x + c * y + 0.03, c * z + 0.1 * s * x], k);
  }
  return new Mesh(points, faces);
}
const PARAMS = { smooth_net: { tolerance: 0.5 } };

/** Jobs on larger shapes, in single precision, with parameters, and some that fail. */
const MORE = [
  ["stitch", [cap(1, 6, 24, { reals: Float32Array }), cap(-1, 6, 24, { reals: Float32Array })]],
  ["stitch", [cap(1, 9, 40, { ripple: 0.07 }), cap(-1, 7, 31, { ripple: 0.11 })]],
  ["stitch", [cap(1, 9, 40, { ripple: 0.07 }), cap(-1, 7, 31)], { rows: "by_mean_edge", fairing: "fair" }],
  ["stitch", [cap(1, 9, 40), cap(-1, 7, 31)], { finish: "blend" }],
  ["stitch", [cap(1, 9, 40), cap(-1, 7, 31)], { meridians: "shortest_meridians" }],
  ["stitch", [cap(1, 9, 40), cap(-1, 7, 31)], { meridians: "least_bend" }],
  ["stitch", [tube()], { rows: "given_number", row_count: 3, cells: "quads" }],
  ["join", [cap(1, 9, 40), tube(6, 33), cap(-1, 7, 31)], { max_gap: 2 }],
  ["join", [cap(1, 12, 40, { ripple: 0.1 }), cap(1, 10, 37, { ripple: 0.1, end: 1.8 })], { align: true, overlaps: "trim" }],
  ["fill", [cap(1, 8, 30, { ripple: 0.2 })]],
  ["fill", [cap(1, 8, 30, { ripple: 0.2, end: 2.5 })], { finish: "refined" }],
  ["fill", [cap(1, 8, 30, { ripple: 0.2, end: 2.5 })], { finish: "blend" }],
  ["fill", [cap(1, 8, 30, { ripple: 0.2, end: 2.5 })], { finish: "blend", continuity: "curvature" }],
  ["weld", [sheet(40, 50)], { vertices: "all_vertices", tolerance: 0.03 }],
  ["align", [cap(1, 12, 40, { ripple: 0.1 }), cap(1, 10, 37, { ripple: 0.1, end: 1.8 })]],
  // The rotation of pieces must not depend on functions of the system.
  ...Array.from({ length: 20 }, (_, k) => ["align", [cap(1, 10, 36, { ripple: 0.05 + 0.005 * k, end: 1.4 + 0.04 * k }), moved(cap(1, 9, 31, { ripple: 0.15 - 0.005 * k, end: 2.2 - 0.04 * k }), 0.015 * k)], { start: "principal_axes" }]),
  ["trim", [cap(1, 12, 40, { ripple: 0.1 }), cap(1, 10, 37, { ripple: 0.1, end: 1.8 })]],
  ["develop", [cap(1, 12, 40, { ripple: 0.1 })]],
  ["develop", [sheet(15, 12)], { distortion: "angles" }],
  ["net_decimate", [sheet(40, 50)], { tolerance: 0.003 }],
  ["net_resample", [SHEET], { rows: 23, columns: 31 }],
  ["deform", [sheet(40, 50)], { field: "twist", amount: 1.3 }],
  ["project", [SHEET], { plane: [0.2, 0.3, 1, 0.1], along: "direction", direction: [0.1, 0.2, 1] }],
  ["curve_resample", [RINGS], { spacing: "step", step: 0.07 }],
  ["curve_offset", [part(RINGS, 0)], { distance: -0.3 }],
  ["smooth_isophotes", [SHEET], { number: 9, direction: [0.3, 0.1, 1] }],
  ["smooth_silhouette", [sheet(9, 11, (u, v) => 0.5 * Math.sin(6 * u) * Math.cos(5 * v))], { direction: [1, 0.2, 0.1] }],
  ["smooth_line", [SHEET], { point: [0.4, 0.3, 2], direction: [0.1, 0.05, -1] }],
  ["net_measures", [sheet(20, 30)]],
  ["section", [cap(1, 12, 40, { ripple: 0.1 })], { direction: [0.1, 0.2, 1], number: 30 }],
  ["section", [sheet(40, 50)], { cut: "faces", placement: "about_an_axis", tolerance: 0.002 }],
  ["weld", [new Mesh([0, 0, 0, 1, 0, 0, NaN, 1, 0], [0, 1, 2])]],
  ["weld", [new Mesh([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 7])]],
  ["weld", [SHEET], { tolerance: -3 }],
  ["stitch", [SHEET], { loop_a: 5 }],
];

/** All jobs, for filters of a table: each filter, each of the choices of its parameters, and more. */
export function jobsOf(filters) {
  const general = { mesh: SHEET, curves: RINGS };
  const inputsOf = (filter) => INPUTS[filter.scriptName] ?? filter.inputKinds.map((kind) => general[kind]);
  const job = (filter, inputs, params = {}) => ({ filter, inputs, params, name: `${filter.scriptName} ${JSON.stringify(params)}` });
  const all = Object.values(filters).flatMap((filter) => [
    job(filter, inputsOf(filter), PARAMS[filter.scriptName]),
    ...filter.params.flatMap(({ id, choices }) => choices.map(({ word }) => job(filter, inputsOf(filter), { ...PARAMS[filter.scriptName], [id]: word }))),
  ]);
  return [...all, ...MORE.map(([name, inputs, params]) => job(filters[name], inputs, params))];
}
