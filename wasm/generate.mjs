// Writes tables.js, layouts of structs, constants and words, from the description of the interface (`make build/interface.json`); and gusset.d.ts,
// the types, from types.d.ts, those words and the plugin's table.
//
// node generate.mjs tables | types [--check] types: where gusset.wasm is; --check compares the file with the text
// that it would write

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
  const library = JSON.parse(read("../build/interface.json")), { plugin, files } = library;
  const kinds = Object.fromEntries([...library.choices, ...plugin.choices].map((choice) => [choice.name, choice.type]));
  plugin.callbacks.forEach((callback) => { kinds[callback.name] = "callback"; });
  const word = (constant, prefix) => constant.name.slice(prefix.length).toLowerCase();
  const words = (constants, prefix) => constants.filter((one) => one.name.startsWith(prefix)).map((one) => [word(one, prefix), one.value]);
  const named = (constants, prefix) => Object.fromEntries(words(constants, prefix).map(([name, value]) => [value, name]));
  const valuesOf = (choice) => library.choices.find((one) => one.name === choice).values;
  const structs = Object.fromEntries([...plugin.structs, ...files.structs].map((struct) => [struct.name, layout(struct.fields, kinds)]));
  const value = (constant) => constant.value === "UINT32_MAX" ? 0xffffffff : constant.value;
  const constants = Object.fromEntries([...plugin.constants, ...files.constants].map((constant) => [constant.name.slice("GUSSET_".length), value(constant)]));
  const statuses = named(library.enums.find((one) => one.name === "gusset_status").values, "GUSSET_ERROR_");
  const fileStatuses = named(files.constants.filter((one) => one.type === "int32_t" && one.value !== 0), "GUSSET_FILES_");
  const elements = named(valuesOf("gusset_element"), "GUSSET_ELEMENT_");
  // The plugin's numbers are the library's.
  const domains = Object.fromEntries(words(valuesOf("gusset_domain"), "GUSSET_DOMAIN_"));
  const rules = Object.fromEntries(words(valuesOf("gusset_rule"), "GUSSET_RULE_"));
  constants.ERROR_PANIC = Number(Object.keys(statuses).find((status) => statuses[status] === "panic"));
  const lines = (name, comment, of) => `\n/** ${comment} */\nexport const ${name} = {\n${Object.entries(of).map(([key, value]) => `  ${key}: ${JSON.stringify(value)},\n`).join("")}};\n`;
  return "// Layouts and constants of the tables of filters and files, on 32 bits. Written by generate.mjs; do not edit.\n"
    + lines("structs", "The size of each struct; the offset of each field, and how DataView reads it.", structs) + lines("constants", "Without GUSSET_.", constants)
    + lines("statuses", "Names of statuses.", statuses)
    + lines("fileStatuses", "Names of statuses of the table of files.", fileStatuses) + lines("elements", "Elements that failures name.", elements)
    + lines("kinds", "Kinds of inputs and outputs.", named(plugin.constants, "GUSSET_KIND_"))
    + lines("paramKinds", "Kinds of parameters.", named(plugin.constants, "GUSSET_PARAM_"))
    + lines("domains", "Numbers of the domains of values.", domains) + lines("rules", "Numbers of the rules that combine values.", rules);
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

function typeOf(param) {
  if (param.choices.length > 0) {
    return [...param.choices.map((choice) => JSON.stringify(choice.word)), "number"].join(" | ");
  }
  return param.arity > 1 ? "ArrayLike<number>" : param.kind === "bool" ? "boolean" : "number";
}

async function types() {
  const { load } = await import("./gusset.js"), tables = await import("./tables.js");
  const gives = { mesh: "Mesh", curves: "Curves", text: "Report" }, takes = { mesh: "MeshLike", curves: "CurvesLike" };
  const union = (name, comment, words) => `\n/** ${comment} */\nexport type ${name} =\n${words.map((word) => `  | ${JSON.stringify(word)}`).join("\n")};\n`;
  const capital = (name) => name.split("_").map((part) => part[0].toUpperCase() + part.slice(1)).join("");
  let params = "", members = "";
  for (const one of Object.values((await load()).filters)) {
    const name = `${capital(one.scriptName)}Params`;
    const given = Array.from({ length: one.minInputs }, (_, k) => takes[one.inputKinds[Math.min(k, one.inputKinds.length - 1)]]);
    // With room for more, as [MeshLike, ...MeshLike[]] or [MeshLike] | [MeshLike, MeshLike]: after [MeshLike,
    // MeshLike?], parameters would require a second mesh.
    const more = one.maxInputs - one.minInputs, last = takes[one.inputKinds.at(-1)];
    const inputs = more > 8 ? `[${[...given, `...${last}[]`].join(", ")}]`
      : Array.from({ length: more + 1 }, (_, k) => `[${[...given, ...Array(k).fill(last)].join(", ")}]`).join(" | ");
    const results = one.outputKinds.map((kind) => gives[kind]);
    params += `\n/** Parameters of \`${one.scriptName}\`; what is not given is what suits the inputs. */\nexport interface ${name} extends RunOptions {\n`
      + one.params.map((param) => `${comment(`${param.label}. ${param.help}${param.choices.length || param.kind === "bool" ? "" : ` From ${param.min} to ${param.max}.`}`, "  ")}  ${param.id}?: ${typeOf(param)};\n`).join("") + "}\n";
    members += `${comment(`${one.help}${one.reference ? ` Source: ${one.reference}` : ""}`, "  ")}  readonly ${one.scriptName}: Filter<${inputs}, ${results.length === 1 ? results[0] : `[${results.join(", ")}]`}, ${name}>;\n`;
  }
  const fileCodes = Object.values(tables.fileStatuses).filter((code) => code.startsWith("bad_"));
  const words = union("ErrorCode", "The name of a status.", [...Object.values(tables.statuses), ...fileCodes])
    + union("ElementKind", "The kind of element that the index of an error counts.", Object.values(tables.elements))
    + union("Kind", "The kind of an input or output of a filter.", Object.values(tables.kinds)) + union("ParamKind", "The kind of a parameter.", Object.values(tables.paramKinds))
    + union("Domain", "The kind of elements with values.", Object.keys(tables.domains)) + union("Rule", "How the values of several sources become one.", Object.keys(tables.rules));
  return `// Types of gusset-mesh. Written by generate.mjs; do not edit.\n\n${read("types.d.ts").replace(/^\/\/.*\n\n/, "")}${words}${params}\n/** The filters of the table, by their names for scripts. */\nexport interface Filters {\n${members}}\n`;
}

const [, , what, flag] = process.argv;
const [file, made] = what === "tables" ? ["tables.js", tables()] : ["gusset.d.ts", await types()];
if (flag !== "--check") {
  writeFileSync(new URL(file, here), made);
} else if (!existsSync(new URL(file, here)) || read(file) !== made) {
  console.error(`${file} is not what generate.mjs writes`);
  process.exitCode = 1;
}
