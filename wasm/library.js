// A module in memory of its own: structs by their fields, texts, room, and functions by their places in its table.

import { errorFor } from "./errors.js";
import { constants, structs } from "./tables.js";

const utf8 = new TextDecoder("utf-8", { ignoreBOM: true }), encoder = new TextEncoder();

/** Types of WebAssembly. */
export const i32 = 0x7f, f64 = 0x7c;

/**
 * A module that hands on one imported function. Only functions exported by WebAssembly may be in function tables.
 * parameters, results: types.
 */
function handedOn(parameters, results, called) {
  const type = [0x60, parameters.length, ...parameters, results.length, ...results];
  const bytes = [
    0x00, 0x61, 0x73, 0x6d, 0x01, 0x00, 0x00, 0x00, // the magic number, version 1
    0x01, type.length + 1, 0x01, ...type, // one type
    0x02, 0x07, 0x01, 0x01, 0x65, 0x01, 0x66, 0x00, 0x00, // one import, e.f
    0x07, 0x05, 0x01, 0x01, 0x66, 0x00, 0x00, // one export, f
  ];
  return new WebAssembly.Instance(new WebAssembly.Module(new Uint8Array(bytes)), { e: { f: called } }).exports.f;
}

export class Module {
  /**
   * entry: the exported function that leads to a table of functions, whose struct is `table`; abi: its version; name:
   * the module in messages.
   */
  constructor(instance, entry, abi, table, name) {
    const { memory, __indirect_function_table: functions } = instance.exports;
    this.exports = instance.exports;
    this.memory = memory;
    this.functions = functions;
    this.name = name;
    this.stopped = null;
    const pointer = this.guarded(() => instance.exports[entry](abi));
    if (!pointer) {
      throw new Error(`${name} has no table of this version`);
    }
    this.table = this.struct(table, pointer);
  }

  /** Adds a function to the table of functions. Returns its place. parameters, results: types. */
  placed(parameters, results, called) {
    const place = this.functions.grow(1);
    this.functions.set(place, handedOn(parameters, results, called));
    return place;
  }

  /** A call into the module. After a trap, the content of its memory is unknown. */
  guarded(call) {
    if (this.stopped) {
      throw errorFor(constants.ERROR_PANIC, `${this.name} has stopped: load it again`);
    }
    try {
      return call();
    } catch (thrown) {
      this.stopped = thrown;
      const error = errorFor(constants.ERROR_PANIC, `${this.name} has stopped: ${thrown.message}; please report it, and load it again`);
      error.cause = thrown;
      throw error;
    }
  }

  /** Calls the function at a place in the table. */
  call(place, ...values) {
    return this.guarded(() => this.functions.get(place)(...values));
  }

  /** Views of memory do not outlive its growth: each is made for one use. */
  get view() {
    return new DataView(this.memory.buffer);
  }

  /** The text at an address: nothing at none. */
  text(pointer) {
    const bytes = new Uint8Array(this.memory.buffer), start = pointer >>> 0;
    return start ? utf8.decode(bytes.subarray(start, bytes.indexOf(0, start))) : "";
  }

  /** A copy of an array of the module's. */
  copied(kind, pointer, length) {
    try {
      return pointer ? new kind(this.memory.buffer, pointer, length).slice() : new kind(length);
    } catch (thrown) {
      // The host lacks memory, or arrays of this length.
      throw thrown instanceof RangeError ? errorFor(constants.PLUGIN_OUT_OF_MEMORY, `there is no memory for an array of ${length} numbers`) : thrown;
    }
  }

  /** A struct at an address: its fields as properties. */
  struct(name, at) {
    const layout = structs[name], module = this, pointer = at >>> 0; // WebAssembly gives addresses above 2 GB as negative.
    const access = (field) => {
      const found = layout.fields[field];
      if (!found) {
        throw new Error(`${name} has no field ${field}`);
      }
      return found;
    };
    return new Proxy({ pointer, size: layout.size }, {
      get(own, field) {
        if (field in own || typeof field !== "string") {
          return own[field];
        }
        const [offset, kind] = access(field);
        return module.view[`get${kind}`](pointer + offset, true);
      },
      set(own, field, value) {
        const [offset, kind] = access(field);
        module.view[`set${kind}`](pointer + offset, value, true);
        return true;
      },
    });
  }

  /** Calls `use` with somewhere to allocate what lives as long as it runs. */
  withRoom(use) {
    const blocks = [], module = this;
    const allocate = (size) => {
      // A size beyond the address space would wrap modulo 2^32.
      const block = size && size < 2 ** 32 && this.guarded(() => this.exports.gusset_memory_allocate(size)) >>> 0;
      if (size && !block) {
        throw errorFor(constants.PLUGIN_OUT_OF_MEMORY, `there is no memory for ${size} bytes`);
      }
      blocks.push([block, size]);
      return block;
    };
    const room = {
      allocate,
      /** Zeros. */
      cleared(size) {
        const block = allocate(size);
        new Uint8Array(module.memory.buffer, block, size).fill(0);
        return block;
      },
      /** A struct of zeros that knows its size, if it begins with that. */
      struct(name) {
        const made = module.struct(name, room.cleared(structs[name].size));
        if (structs[name].fields.struct_size) {
          made.struct_size = structs[name].size;
        }
        return made;
      },
      /** A copy of a typed array. */
      array(values) {
        const block = allocate(values.byteLength);
        new values.constructor(module.memory.buffer, block, values.length).set(values);
        return block;
      },
      /** A text that ends with NUL. */
      text(text) {
        return room.array(encoder.encode(`${text}\0`));
      },
    };
    try {
      return use(room);
    } finally {
      if (!this.stopped) {
        blocks.forEach(([block, size]) => this.exports.gusset_memory_free(block, size));
      }
    }
  }
}

/** The library: filters, with callbacks for their runs. */
export class Library extends Module {
  constructor(instance) {
    super(instance, "gusset_plugin_entry", constants.PLUGIN_ABI, "gusset_plugin", "the library");
    this.told = new Map();
    this.progress = this.placed([i32, f64, i32], [i32], (user, fraction, stage) => this.tell(user, "progress", fraction, this.text(stage)));
    this.log = this.placed([i32, i32], [], (user, message) => void this.tell(user, "log", this.text(message)));
  }

  /** Calls what a run was given. Once that throws, or says stop, the run is cancelled. */
  tell(user, name, ...values) {
    const run = this.told.get(user);
    if (run.thrown) {
      return 1;
    }
    try {
      return run[name]?.(...values) === false ? 1 : 0;
    } catch (thrown) {
      run.thrown = { thrown };
      return 1;
    }
  }
}

/** Whether a value is an array of numbers of one type. */
export function isTyped(value) {
  return ArrayBuffer.isView(value) && !(value instanceof DataView);
}
