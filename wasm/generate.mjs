// Writes tables.js, layouts of structs and constants, from the description of the interface (`make build/interface.json`); and gusset.d.ts, the types,
// from types.d.ts and the plugin's table.
//
//     node generate.mjs tables | types [--check]      types: where gusset.wasm is; --check says whether the file is what it would write

import { existsSync, readFileSync, writeFileSync } from "node:fs";

const here = new URL(".", import.meta.url);
const read = (name) => readFileSync(new URL(name, here), "utf8");

/** Sizes, which are alignments too, and accessors of DataView, by types of C on 32 bits. */
const TYPES = {
  size_t: [4, "Uint32"], uint32_t: [4, "Uint32"], int32_t: [4, "Int32"], uint64_t: [8, "BigUint64"], double: [8, "Float64"], pointer: [4, "Uint32"],
};

function layout(given, kinds) {
  const fields = {};
  let size = 0, most = 1;
  for (const field of given) {
    const kind = kinds[field.type] ?? field.type;
    const [bytes, accessor] = TYPES[field.pointers || kind === "callback" ? "pointer" : kind];
    size = Math.ceil(size / bytes) * bytes;
    fields[field.name] = [size, accessor];
    size += bytes;
    most = Math.max(most, bytes);
  }
  return { size: Math.ceil(size / most) * most, fields };
}

function tables() {
  const library = JSON.parse(read("../build/interface.json")), plugin = library.plugin;
  const kinds = Object.fromEntries([...library.choices, ...plugin.choices].map((choice) => [choice.name, choice.type]));
  plugin.callbacks.forEach((callback) => { kinds[callback.name] = "callback"; });
  const word = (constant, prefix) => constant.name.slice(prefix.length).toLowerCase();
  const structs = Object.fromEntries(plugin.structs.map((struct) => [struct.name, layout(struct.fields, kinds)]));
  const value = (constant) => constant.value === "UINT32_MAX" ? 0xffffffff : constant.value;
  const constants = Object.fromEntries(plugin.constants.map((constant) => [constant.name.slice("GUSSET_".length), value(constant)]));
  const errors = library.enums.find((one) => one.name === "gusset_status").values.filter((one) => one.value !== 0);
  const statuses = Object.fromEntries(errors.map((one) => [one.value, word(one, "GUSSET_ERROR_")]));
  const counted = library.choices.find((one) => one.name === "gusset_element").values;
  const elements = Object.fromEntries(counted.map((one) => [one.value, word(one, "GUSSET_ELEMENT_")]));
  constants.ERROR_PANIC = Number(Object.keys(statuses).find((status) => statuses[status] === "panic"));
  const lines = (name, comment, of) => `\n/** ${comment} */\nexport const ${name} = {\n${Object.entries(of).map(([key, value]) => `  ${key}: ${JSON.stringify(value)},\n`).join("")}};\n`;
  return "// Layouts and constants of the plugin's table, on 32 bits. Written by generate.mjs; do not edit.\n"
    + lines("structs", "The size of each struct; the offset of each field, and how DataView reads it.", structs) + lines("constants", "Without GUSSET_.", constants)
    + lines("statuses", "Names of statuses.", statuses) + lines("elements", "Elements that failures name.", elements);
}

function wrapped(text, indent) {
  const lines = [];
  for (const one of text.split(/\s+/)) {
    if (lines.length > 0 && `${lines.at(-1)} ${one}`.length + indent.length <= 135) {
      lines[lines.length - 1] += ` ${one}`;
    } else {
      lines.push(one);
    }
  }
  return lines.map((line) => `${indent} * ${line}\n`).join("");
}

const comment = (text, indent) => `${indent}/**\n${wrapped(text.replaceAll("*/", "* /"), indent)}${indent} */\n`;

function typeOf(param, constants) {
  if (param.choices.length > 0) {
    return [...param.choices.map((choice) => JSON.stringify(choice.word)), "number"].join(" | ");
  }
  return param.arity > 1 ? "ArrayLike<number>" : param.kind === constants.PARAM_BOOL ? "boolean" : "number";
}

async function types() {
  const { load } = await import("./gusset.js"), { constants } = await import("./tables.js");
  const gives = { [constants.KIND_MESH]: "Mesh", [constants.KIND_CURVES]: "Curves", [constants.KIND_TEXT]: "Report" };
  const takes = { [constants.KIND_MESH]: "MeshLike", [constants.KIND_CURVES]: "CurvesLike" };
  const capital = (name) => name.split("_").map((part) => part[0].toUpperCase() + part.slice(1)).join("");
  let params = "", members = "";
  for (const one of Object.values((await load()).filters)) {
    const name = `${capital(one.scriptName)}Params`;
    const given = Array.from({ length: one.minInputs }, (_, k) => takes[one.inputKinds[Math.min(k, one.inputKinds.length - 1)]]);
    // With room for more, as [MeshLike, ...MeshLike[]] or [MeshLike] | [MeshLike, MeshLike]: after
    // [MeshLike, MeshLike?] there could be no parameters without a second mesh.
    const more = one.maxInputs - one.minInputs, last = takes[one.inputKinds.at(-1)];
    const inputs = more > 8 ? `[${[...given, `...${last}[]`].join(", ")}]`
      : Array.from({ length: more + 1 }, (_, k) => `[${[...given, ...Array(k).fill(last)].join(", ")}]`).join(" | ");
    const results = one.outputKinds.map((kind) => gives[kind]);
    params += `\n/** Parameters of \`${one.scriptName}\`; what is not given is what suits the inputs. */\nexport interface ${name} extends RunOptions {\n`
      + one.params.map((param) => `${comment(`${param.label}. ${param.help}${param.choices.length || param.kind === constants.PARAM_BOOL ? "" : ` From ${param.min} to ${param.max}.`}`, "  ")}  ${param.id}?: ${typeOf(param, constants)};\n`).join("") + "}\n";
    members += `${comment(`${one.help}${one.reference ? ` Source: ${one.reference}` : ""}`, "  ")}  readonly ${one.scriptName}: Filter<${inputs}, ${results.length === 1 ? results[0] : `[${results.join(", ")}]`}, ${name}>;\n`;
  }
  return `// Types of gusset-mesh. Written by generate.mjs; do not edit.\n\n${read("types.d.ts").replace(/^\/\/.*\n\n/, "")}${params}\n/** The filters of the table, by their names for scripts. */\nexport interface Filters {\n${members}}\n`;
}

const [, , what, flag] = process.argv;
const [file, made] = what === "tables" ? ["tables.js", tables()] : ["gusset.d.ts", await types()];
if (flag !== "--check") {
  writeFileSync(new URL(file, here), made);
} else if (!existsSync(new URL(file, here)) || read(file) !== made) {
  console.error(`${file} is not what generate.mjs writes`);
  process.exitCode = 1;
}
