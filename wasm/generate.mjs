// Writes what follows from the library: tables.js, the layouts of structs and the constants, from the headers; gusset.d.ts, the types,
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

function layout(body) {
  const fields = {};
  let size = 0, most = 1;
  for (const declaration of body.replace(/\/\*[^]*?\*\//g, "").split(";").map((text) => text.trim()).filter(Boolean)) {
    const called = /\(\*(\w+)\)/.exec(declaration), [, kind, star, plain] = /^(.*?)(\*?)(\w+)$/.exec(called ? `void *${called[1]}` : declaration);
    const [bytes, accessor] = TYPES[star ? "pointer" : kind.trim()];
    size = Math.ceil(size / bytes) * bytes;
    fields[plain] = [size, accessor];
    size += bytes;
    most = Math.max(most, bytes);
  }
  return { size: Math.ceil(size / most) * most, fields };
}

function tables() {
  const plugin = read("../include/gusset_plugin.h"), library = read("../include/gusset.h");
  const structs = {}, constants = {};
  for (const [, name, body] of plugin.matchAll(/typedef struct (\w+) \{\n([^]*?)\n\} \1;/g)) {
    structs[name] = layout(body);
  }
  for (const [, name, value] of plugin.matchAll(/#define GUSSET_(\w+) (\d+|UINT32_MAX)$/gm)) {
    constants[name] = value === "UINT32_MAX" ? 0xffffffff : Number(value);
  }
  const statuses = {}, elements = {};
  for (const [, name, value] of library.matchAll(/^ {4}GUSSET_ERROR_(\w+) = (\d+),$/gm)) {
    statuses[value] = name.toLowerCase();
  }
  for (const [, name, value] of library.matchAll(/^#define GUSSET_ELEMENT_(\w+) (\d+)$/gm)) {
    elements[value] = name.toLowerCase();
  }
  constants.ERROR_PANIC = Number(Object.keys(statuses).find((status) => statuses[status] === "panic"));
  const lines = (name, comment, of) => `\n/** ${comment} */\nexport const ${name} = {\n${Object.entries(of).map(([key, value]) => `  ${key}: ${JSON.stringify(value)},\n`).join("")}};\n`;
  return "// Of gusset_plugin.h and gusset.h, as they are laid out on 32 bits. Written by generate.mjs; do not edit.\n"
    + lines("structs", "Of each struct its size, and of each field its place and how DataView reads it.", structs) + lines("constants", "Without GUSSET_.", constants)
    + lines("statuses", "Names of statuses.", statuses) + lines("elements", "What failures count.", elements);
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
