// gusset as WebAssembly: every filter of the plugin's table as a function on typed arrays.
//
//     import { load } from "gusset-mesh";
//     const { filters } = await load();
//     const [mesh, report] = filters.weld({ positions, faces }, { tolerance: 1e-6 });

import { errorFor } from "./errors.js";
import { given, isInput } from "./inputs.js";
import { Library } from "./library.js";
import { compiled } from "./loading.js";
import { failed, Outputs } from "./outputs.js";
import { constants, kinds, paramKinds } from "./tables.js";

export { Cancelled, FileError, GussetError, InputError, OutOfMemory, Stopped } from "./errors.js";
export { loadFiles, read, write } from "./files.js";
export { Curves, Mesh } from "./inputs.js";
export { Outputs, Report } from "./outputs.js";

/** Options of a run, beside the parameters of its filter; no filter has parameters of these names. */
const OPTIONS = ["progress", "log", "origins"];

/** A label of a menu as a word for scripts. */
function word(label) {
  return label.toLowerCase().split(/[^\p{L}\p{N}]+/u).filter(Boolean).join("_");
}

function paramOf(library, pointer) {
  const of = library.struct("gusset_param_info", pointer), choices = [];
  for (let k = 0; k < of.choice_count; k++) {
    const choice = library.struct("gusset_choice", of.choices + 8 * k);
    choices.push({ word: word(library.text(choice.label)), label: library.text(choice.label), help: library.text(choice.help) });
  }
  return {
    id: library.text(of.id), label: library.text(of.label), help: library.text(of.help), kind: paramKinds[of.kind], arity: of.arity, min: of.min, max: of.max,
    step: of.step, defaults: Array.from(library.copied(Float64Array, of.default_values, of.arity)), choices, first: of.first_value,
  };
}

/** The values of the parameters: given values, and suggestions for the others. */
function valuesOf(library, room, filter, struct, inputs, count, params) {
  const values = room.cleared(8 * Math.max(struct.value_count, 1));
  // For invalid inputs these are the plain defaults; run then reports the error.
  library.call(struct.suggest, struct.pointer, inputs, count, values);
  for (const [name, value] of Object.entries(params)) {
    if (OPTIONS.includes(name) || value === undefined) {
      continue;
    }
    const param = filter.params.find((one) => one.id === name);
    if (!param) {
      throw new TypeError(`${filter.scriptName} has no parameter ${name}: there are ${filter.params.map((one) => one.id).join(", ") || "none"}`);
    }
    let given = typeof value === "object" ? Array.from(value) : [value];
    if (typeof value === "string") {
      const words = param.choices.map((choice) => choice.word);
      if (!words.includes(value)) {
        throw new TypeError(`${name} is "${value}": there are ${words.join(", ") || "no words for it"}`);
      }
      given = [words.indexOf(value)];
    }
    if (given.length !== param.arity) {
      throw new TypeError(`${name} takes ${param.arity} numbers, not ${given.length}`);
    }
    given.forEach((number, k) => library.view.setFloat64(values + 8 * (param.first + k), Number(number), true));
  }
  return values;
}

let runs = 0;

/** Runs a filter. */
function run(library, filter, struct, inputs, params) {
  return library.withRoom((room) => {
    const { first, taken } = given(library, room, inputs, filter.inputKinds);
    const values = valuesOf(library, room, filter, struct, first, inputs.length, params);
    const host = room.struct("gusset_host"), user = (runs = (runs + 1) & 0x7fffffff), told = { progress: params.progress, log: params.log, thrown: null };
    host.user = user;
    host.progress = params.progress ? library.progress : 0;
    host.log = params.log ? library.log : 0;
    host.threads = 1;
    host.origins = params.origins ? 1 : 0;
    // Room for what may go wrong, as long as there is some.
    const failure = room.struct("gusset_failure"), made = room.cleared(4);
    library.told.set(user, told);
    let status, handle;
    try {
      status = library.call(struct.run, struct.pointer, host.pointer, first, inputs.length, values, struct.value_count, made);
      handle = library.view.getUint32(made, true);
    } finally {
      library.told.delete(user);
    }
    if (status === constants.PLUGIN_DONE && !told.thrown) {
      return new Outputs(library, handle, taken);
    }
    const isKnown = handle !== 0 && library.call(library.table.output_failure, handle, failure.pointer) === 0;
    const error = told.thrown ? told.thrown.thrown : (isKnown ? failed(library, status, failure) : errorFor(status, ""));
    library.call(library.table.output_free, handle);
    throw error;
  });
}

/** A filter of the table as a function: inputs, then parameters; `filter.run` gives all that a run left. */
function filterOf(library, pointer) {
  const struct = library.struct("gusset_filter", pointer), text = (field) => library.text(struct[field]);
  const kindsOf = (field, count) => Array.from(library.copied(Uint32Array, struct[field], count), (kind) => kinds[kind]);
  const filter = (...given) => {
    const params = given.length > 0 && !isInput(given.at(-1)) ? given.pop() : {};
    const outputs = run(library, filter, struct, given, params ?? {});
    const made = [...outputs];
    outputs.free();
    return made.length === 1 ? made[0] : made;
  };
  const params = Array.from({ length: struct.param_count }, (_, k) => paramOf(library, library.call(struct.param, pointer, k)));
  const described = {
    id: text("id"), name: text("name"), scriptName: text("script_name"), category: text("category"), help: text("help"), reference: text("reference"),
    inputKinds: kindsOf("input_kinds", struct.input_kind_count), outputKinds: kindsOf("output_kinds", struct.output_count),
    minInputs: struct.min_inputs, maxInputs: struct.max_inputs, hasOrigins: (struct.flags & constants.FILTER_ORIGINS) !== 0, params,
    run: (inputs, params = {}) => run(library, filter, struct, inputs, params),
  };
  for (const [name, value] of Object.entries(described)) {
    Object.defineProperty(filter, name, { value, enumerable: true });
  }
  return filter;
}

/** Loads the library. Each call gives one with memory of its own. */
export async function load(source) {
  // Bundlers recognise these words, and bring the file along.
  const module = await compiled(await source || new URL("gusset.wasm", import.meta.url));
  const library = new Library(await WebAssembly.instantiate(module, {}));
  const table = library.table, filters = {};
  for (let k = 0; k < table.filter_count; k++) {
    const filter = filterOf(library, library.call(table.filter, k));
    filters[filter.scriptName] = filter;
  }
  return { version: library.text(table.version), filters, memory: library.memory };
}
