// The time of some jobs beside the native library on one thread: GUSSET_NATIVE=build/wasm/native node wasm/test/times.mjs [repeats]

import { load } from "../gusset.js";
import { natively } from "./native.mjs";
import { cap, sheet, tube } from "./shapes.mjs";

const repeats = Number(process.argv[2] ?? 5);
const { filters } = await load();
const jobs = [
  ["weld", [sheet(400, 400)], { vertices: "all_vertices", tolerance: 1e-5 }],
  ["stitch", [cap(1, 60, 1000, { ripple: 0.05 }), cap(-1, 60, 900, { ripple: 0.05 })], {}],
  ["join", [cap(1, 100, 400), tube(100, 400), cap(-1, 100, 400)], { max_gap: 2 }],
  ["fill", [cap(1, 40, 300, { end: 2.5, ripple: 0.1 })], { finish: "blend" }],
  ["align", [cap(1, 60, 200, { ripple: 0.1 }), cap(1, 50, 190, { ripple: 0.1, end: 1.8 })], {}],
  ["develop", [cap(1, 40, 120, { ripple: 0.1 })], {}],
  ["net_resample", [sheet(100, 100)], { rows: 600, columns: 600 }],
  ["smooth_surface", [sheet(40, 40)], {}],
].map(([name, inputs, params]) => ({ filter: filters[name], inputs, params }));

const median = (times) => times.sort((a, b) => a - b)[times.length >> 1];
const native = Array.from({ length: repeats }, () => natively(jobs).map((one) => one.seconds));
jobs.forEach(({ filter, inputs, params }, k) => {
  const times = Array.from({ length: repeats }, () => {
    const begin = performance.now();
    filter.run(inputs, params).free();
    return (performance.now() - begin) / 1000;
  });
  const [here, there] = [median(times), median(native.map((one) => one[k]))];
  console.log(`${filter.scriptName.padEnd(16)} ${(1000 * here).toFixed(1).padStart(8)} ms, natively ${(1000 * there).toFixed(1).padStart(8)} ms: ${(here / there).toFixed(2)}`);
});
