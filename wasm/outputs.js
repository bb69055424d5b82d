// The outputs of a filter.

import { errorFor } from "./errors.js";
import { Curves, Mesh } from "./inputs.js";
import { constants, domains, rules } from "./tables.js";

/** Lines of text; `values` has the numbers in it by their names. */
export class Report {
  constructor(text, values) {
    this.text = text;
    this.values = values;
  }

  toString() {
    return this.text;
  }
}

const types = new Map([
  [Float32Array, constants.PLUGIN_VALUE_F32], [Float64Array, constants.PLUGIN_VALUE_F64], [Uint8Array, constants.PLUGIN_VALUE_U8],
  [Uint16Array, constants.PLUGIN_VALUE_U16], [Uint32Array, constants.PLUGIN_VALUE_U32],
]);

// Without free(), the engine releases an object when it collects it.
const forgotten = new FinalizationRegistry(({ library, handle }) => library.stopped || library.call(library.table.output_free, handle));

/** The failure that a struct tells of. */
export function failed(library, status, failure) {
  const none = constants.PLUGIN_NONE;
  return errorFor(status, library.text(failure.message), {
    element: failure.element, index: failure.index, value: failure.value,
    input: failure.input === none ? null : failure.input, param: failure.param === none ? null : failure.param,
  });
}

/** The number of a word. */
function numberOf(words, word, what) {
  if (!Object.hasOwn(words, word)) {
    throw new TypeError(`${what} is "${word}": there are ${Object.keys(words).join(", ")}`);
  }
  return words[word];
}

function counts(mesh) {
  return { vertices: mesh.vertexCount, corners: mesh.faces.corners.length, faces: mesh.faceCount };
}

/** A sequence of meshes, curves and reports; `carry` carries attributes of the inputs' elements over, if origins were
 *  requested. */
export class Outputs {
  #library;
  #handle;
  #inputs;
  #made;

  constructor(library, handle, inputs) {
    this.#library = library;
    this.#handle = handle;
    this.#inputs = inputs.map((one) => (one instanceof Mesh ? counts(one) : null));
    forgotten.register(this, { library, handle }, this);
    const count = library.call(library.table.output_count, handle);
    try {
      this.#made = Array.from({ length: count }, (_, k) => this.#read(k));
    } catch (thrown) {
      this.free();
      throw thrown;
    }
  }

  get length() {
    return this.#made.length;
  }

  at(index) {
    return this.#made.at(index);
  }

  [Symbol.iterator]() {
    return this.#made[Symbol.iterator]();
  }

  #read(k) {
    const library = this.#library, table = library.table;
    const kind = library.call(table.output_kind, this.#handle, k);
    if (kind === constants.KIND_TEXT) {
      return this.#report(k);
    }
    const isMesh = kind === constants.KIND_MESH;
    return library.withRoom((room) => {
      const view = room.struct(isMesh ? "gusset_plugin_mesh" : "gusset_plugin_curves");
      const status = library.call(isMesh ? table.output_mesh : table.output_curves, this.#handle, k, view.pointer);
      if (status !== constants.PLUGIN_DONE) {
        throw errorFor(status, "");
      }
      const reals = view.scalar === constants.PLUGIN_F32 ? Float32Array : Float64Array;
      if (isMesh) {
        const offsets = library.copied(Uint32Array, view.face_offsets, view.face_count + 1);
        const corners = library.copied(Uint32Array, view.face_corners, offsets.at(-1));
        return Mesh.of(library.copied(reals, view.positions, 3 * view.vertex_count), offsets, corners);
      }
      const offsets = library.copied(Uint32Array, view.offsets, view.curve_count + 1);
      return Curves.of(library.copied(reals, view.points, 3 * view.point_count), offsets, library.copied(Uint8Array, view.closed, view.curve_count));
    });
  }

  #report(k) {
    const library = this.#library, handle = this.#handle;
    const extension = library.withRoom((room) => library.call(library.table.extension, room.array(new TextEncoder().encode("values/1\0"))));
    const values = library.struct("gusset_plugin_values", extension), read = {};
    for (let n = 0; n < library.call(values.count, handle, k); n++) {
      const value = library.call(values.value, handle, k, n), isFlag = library.call(values.kind, handle, k, n) === constants.VALUE_FLAG;
      read[library.text(library.call(values.name, handle, k, n))] = isFlag ? value !== 0 : value;
    }
    return new Report(library.text(library.call(library.table.output_text, handle, k)), read);
  }

  #attributes(room) {
    if (this.#handle === null) {
      throw new Error("these outputs have been freed: read them before free()");
    }
    const extension = this.#library.call(this.#library.table.extension, room.array(new TextEncoder().encode("attributes/1\0")));
    return this.#library.struct("gusset_plugin_attributes", extension);
  }

  /** Whether an output tells where its elements come from. */
  hasOrigins(index = 0) {
    if (!Number.isInteger(index)) {
      throw new TypeError(`an output's place is a whole number, not ${String(index)}`);
    }
    return this.#library.withRoom((room) => this.#library.call(this.#attributes(room).has_origins, this.#handle, index) === 1);
  }

  /** Values of the elements of an output, from values of the inputs: one array for each input, or null. */
  carry(values, { domain = "vertices", rule = "linear", index = 0, maxInfluences = 0, components = null } = {}) {
    const library = this.#library, some = values.find((one) => one !== null && one !== undefined);
    const type = types.get(some?.constructor);
    if (type === undefined || values.some((one) => one && one.constructor !== some.constructor)) {
      throw new TypeError("values are arrays of one type: Float32Array, Float64Array, Uint8Array, Uint16Array or Uint32Array");
    }
    const from = Number.isInteger(index) ? this.#made[index] : null;
    if (!(from instanceof Mesh)) {
      throw new TypeError(`output ${String(index)} is not a mesh`);
    }
    const domainNumber = numberOf(domains, domain, "domain"), ruleNumber = numberOf(rules, rule, "rule");
    const count = counts(from)[domain], given = this.#inputs.map((one) => one?.[domain] ?? 0);
    const each = components ?? some.length / given[values.indexOf(some)];
    if (!Number.isInteger(each) || each < 1 || values.some((one) => one && one.length % each !== 0)) {
      throw new TypeError(`values are ${values.map((one) => one?.length ?? 0).join(", ")} numbers: each array needs ${each} numbers for each element`);
    }
    return library.withRoom((room) => {
      const attributes = this.#attributes(room), channel = room.struct("gusset_plugin_channel"), failure = room.struct("gusset_failure");
      channel.domain = domainNumber;
      channel.value_type = type;
      channel.components = each;
      channel.rule = ruleNumber;
      channel.max_influences = maxInfluences;
      const size = room.struct("gusset_plugin_channel_values").size, first = room.cleared(size * Math.max(values.length, 1));
      values.forEach((one, k) => {
        if (one) {
          const to = library.struct("gusset_plugin_channel_values", first + k * size);
          to.values = room.array(one);
          to.count = Math.floor(one.length / each);
        }
      });
      const length = count * each, out = room.cleared(length * some.BYTES_PER_ELEMENT);
      const status = library.call(attributes.apply, this.#handle, index, 0, channel.pointer, first, values.length, out, count, 0, failure.pointer);
      if (status !== constants.PLUGIN_DONE) {
        throw failed(library, status, failure);
      }
      return library.copied(some.constructor, out, length);
    });
  }

  /** Gives the library's memory back: meshes, curves and reports stay, `carry` is over. */
  free() {
    if (this.#handle !== null) {
      forgotten.unregister(this);
      this.#library.stopped || this.#library.call(this.#library.table.output_free, this.#handle);
      this.#handle = null;
    }
  }
}
if (Symbol.dispose) {
  Outputs.prototype[Symbol.dispose] = Outputs.prototype.free;
}
