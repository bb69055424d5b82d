// Files of meshes, curves and points, read and written in memory by a module of its own.
//
//     import { read, write } from "gusset-mesh";
//     const { meshes } = await read("part.obj", bytes, { folder: { "part.mtl": library } });
//     const { files, losses } = await write("part.glb", { meshes });

import { packedDocument, unpackedDocument } from "./documents.js";
import { errorFor, fileErrorFor, Stopped } from "./errors.js";
import { i32, isTyped, Module } from "./library.js";
import { compiled } from "./loading.js";
import { constants } from "./tables.js";

const utf8 = new TextDecoder();

/** The bytes of a file as an Uint8Array; the same memory. */
function bytesOf(given, name) {
  if (given instanceof ArrayBuffer) {
    return new Uint8Array(given);
  }
  if (ArrayBuffer.isView(given)) {
    return new Uint8Array(given.buffer, given.byteOffset, given.byteLength);
  }
  const hint = typeof given?.then === "function" ? ", but a promise: load it first" : "";
  throw new TypeError(`${name} is not bytes (Uint8Array or ArrayBuffer)${hint}`);
}

/** A function from names to bytes: a function, a map or an object. */
function folderOf(folder) {
  if (typeof folder === "function") {
    return folder;
  }
  if (typeof folder !== "object") {
    throw new TypeError("folder is not a function, a map or an object");
  }
  const find = folder instanceof Map ? (name) => folder.get(name) : (name) => (Object.hasOwn(folder, name) ? folder[name] : undefined);
  return (name) => find(name) ?? find(name.replaceAll("\\", "/").replace(/^(\.\/+)+/, ""));
}

function checkedOptions(given, names) {
  const options = given ?? {};
  for (const name of Object.keys(options)) {
    if (!names.includes(name)) {
      throw new TypeError(`there is no option ${name}: there are ${names.join(", ")}`);
    }
  }
  return options;
}

function checkedName(name) {
  if (typeof name !== "string" || name.includes("\0")) {
    throw new TypeError("the name of a file is a text without NUL");
  }
  return name;
}

/** The message of a failure: "name:line: message" or "name: message". */
const located = (name, message) => `${name}:${/^\d+: /.test(message) ? "" : " "}${message}`;

/** The module, with the folder of the running call. */
class FileLibrary extends Module {
  constructor(instance) {
    super(instance, "gusset_files_entry", constants.FILES_ABI, "gusset_files", "the module for files");
    this.load = this.placed([i32, i32, i32, i32], [i32], (_, name, bytes, size) => this.lend(name, bytes, size));
    this.running = null;
  }

  /** Lends the module a file of the folder until the next file. Exceptions wait for the end of the call, because the module's frames cannot unwind. */
  lend(name, bytes, size) {
    const { running } = this;
    if (running.thrown) {
      return 1;
    }
    try {
      this.takeBack();
      const text = this.text(name), found = running.find(text);
      if (found === undefined || found === null) {
        return 1;
      }
      const given = bytesOf(found, text), block = given.length && this.exports.gusset_memory_allocate(given.length) >>> 0;
      if (given.length && !block) {
        throw errorFor(constants.PLUGIN_OUT_OF_MEMORY, `there is no memory for ${given.length} bytes of ${text}`);
      }
      running.block = [block, given.length];
      new Uint8Array(this.memory.buffer, block, given.length).set(given);
      this.view.setUint32(bytes >>> 0, block, true);
      this.view.setUint32(size >>> 0, given.length, true);
      return 0;
    } catch (thrown) {
      running.thrown = { thrown };
      return 1;
    }
  }

  takeBack() {
    if (!this.stopped) {
      this.exports.gusset_memory_free(...this.running.block);
    }
    this.running.block = [0, 0];
  }

  /** Calls read or write, and `use` with the parts of its result. */
  partsOf(name, room, folder, run, use) {
    const out = room.cleared(4), outer = this.running;
    let lent = 0;
    if (folder) {
      const struct = room.struct("gusset_files_folder");
      struct.load = this.load;
      lent = struct.pointer;
    }
    const running = this.running = { find: folder && folderOf(folder), block: [0, 0], thrown: null };
    let status, result = 0;
    try {
      status = run(lent, out);
      result = this.view.getUint32(out, true);
      this.takeBack();
      if (running.thrown) {
        throw running.thrown.thrown;
      }
      if (status !== constants.FILES_DONE) {
        throw fileErrorFor(status, located(name, this.text(this.call(this.table.message, result))));
      }
      return use(result, room);
    } finally {
      this.running = outer;
      if (!this.stopped) {
        this.call(this.table.free, result);
      }
    }
  }

  /** A view of a part, which ends with the next call. */
  part(result, which, room) {
    const size = room.cleared(4), bytes = this.call(this.table.part_bytes, result, which, size) >>> 0;
    return new Uint8Array(this.memory.buffer, bytes, this.view.getUint32(size, true));
  }

  json(result, room) {
    return JSON.parse(utf8.decode(this.part(result, 0, room)));
  }
}

/** Copies arrays for JavaScript, which may lack the memory. */
function withoutRangeErrors(name, copy) {
  try {
    return copy();
  } catch (thrown) {
    throw thrown instanceof RangeError ? errorFor(constants.PLUGIN_OUT_OF_MEMORY, `${name}: there is no memory for the arrays of the result`) : thrown;
  }
}

function readWith(module, name, bytes, options) {
  const { folder, scene = false, merge = true } = checkedOptions(options, ["folder", "scene", "merge"]);
  const given = bytesOf(bytes, checkedName(name)), { table } = module;
  return module.withRoom((room) => {
    const text = room.text(name), content = room.array(given), flags = (scene ? 0 : constants.FILES_JOINED) | (merge ? 0 : constants.FILES_UNMERGED);
    return module.partsOf(name, room, folder, (lent, out) => module.call(table.read, text, content, given.length, lent, flags, out), (result) => {
      const described = module.json(result, room);
      return withoutRangeErrors(name, () => unpackedDocument(described, module.part(result, 1, room)));
    });
  });
}

function writeWith(module, name, document, options) {
  const { folder, text = false, lossy = false } = checkedOptions(options, ["folder", "text", "lossy"]);
  const packed = packedDocument(document), flags = (text ? constants.FILES_TEXT : 0) | (lossy ? constants.FILES_LOSSY : 0);
  checkedName(name);
  const { table } = module;
  return module.withRoom((room) => {
    const own = room.text(name), described = room.text(packed.text), arrays = room.allocate(packed.size);
    for (const [at, values] of packed.placed) {
      new values.constructor(module.memory.buffer, arrays + at, values.length).set(values);
    }
    return module.partsOf(name, room, folder, (lent, out) => module.call(table.write, own, described, arrays, packed.size, lent, flags, out), (result) => {
      const files = new Map(), count = module.call(table.part_count, result);
      for (let which = 1; which < count; which++) {
        const key = which === 1 ? name : module.text(module.call(table.part_name, result, which));
        files.set(key, withoutRangeErrors(name, () => module.part(result, which, room).slice()));
      }
      return { files, losses: module.json(result, room) };
    });
  });
}

/** Loads the module for files. Each call gives one with memory of its own. */
export async function loadFiles(source) {
  // Bundlers recognise these words, and bring the file along.
  const module = await compiled(await source || new URL("gusset_files.wasm", import.meta.url));
  const library = new FileLibrary(await WebAssembly.instantiate(module, {}));
  return {
    read: (name, bytes, options) => readWith(library, name, bytes, options),
    write: (name, document, options) => writeWith(library, name, document, options),
    memory: library.memory,
  };
}

/** The module that `read` and `write` share; none before the first call, and after a trap. */
let shared = null;

async function withShared(use) {
  const loading = shared ??= loadFiles();
  const forget = () => {
    if (shared === loading) {
      shared = null;
    }
  };
  let module;
  try {
    module = await loading;
  } catch (thrown) {
    forget();
    throw thrown;
  }
  try {
    return use(module);
  } catch (thrown) {
    if (thrown instanceof Stopped) {
      forget();
    }
    throw thrown;
  }
}

/** Reads a file, in the format of the extension of its name. */
export function read(name, bytes, options) {
  return withShared((module) => module.read(name, bytes, options));
}

/** Writes a document, mesh, curves or points, in the format of the extension of the name. */
export function write(name, document, options) {
  return withShared((module) => module.write(name, document, options));
}
