// Meshes and curves, and how the library is given them.

import { isTyped } from "./library.js";
import { constants } from "./tables.js";

/** Coordinates as the library reads them: 32- or 64-bit floats; the same array where it can be. */
export function coordinates(values, what) {
  if (values instanceof Float32Array || values instanceof Float64Array) {
    return values;
  }
  if (typeof values !== "object" || typeof values?.length !== "number") {
    throw new TypeError(`${what} are ${values === undefined ? "missing" : typeof values}: pass an array`);
  }
  if (typeof values[0] !== "object") {
    return Float64Array.from(values);
  }
  const packed = new Float64Array(3 * values.length);
  for (let k = 0; k < values.length; k++) {
    // Three points of two numbers could be mistaken for two points of three.
    if (values[k]?.length !== 3) {
      throw new TypeError(`${what}: number ${k} has ${values[k]?.length ?? 0} entries, not x, y and z`);
    }
    packed.set(values[k], 3 * k);
  }
  return packed;
}

/** Whole numbers as 32-bit ones without a sign. */
export function indices(values, what) {
  if (values instanceof Uint32Array) {
    return values;
  }
  const given = Array.from(values);
  given.forEach((value, k) => {
    if (!Number.isInteger(value) || value < 0 || value > 0xffffffff) {
      throw new TypeError(`${what}: number ${k} is ${value}, not an index from 0 to 2^32 - 1`);
    }
  });
  return Uint32Array.from(given);
}

export function packedOf(values, what) {
  if (values.length % 3 !== 0) {
    throw new TypeError(`${what} are ${values.length} numbers: x, y, z of each belong together`);
  }
  return values;
}

/** A polygon mesh: face f has the corners offsets[f] to offsets[f + 1] - 1. */
export class Mesh {
  constructor(positions, faces, { merge = null } = {}) {
    this.positions = packedOf(coordinates(positions, "positions"), "positions");
    const isTriangles = isTyped(faces) || Array.isArray(faces) && !Array.isArray(faces[0]);
    if (isTriangles) {
      const corners = indices(faces, "faces");
      if (corners.length % 3 !== 0) {
        throw new TypeError(`faces are ${corners.length} corners: three of each triangle belong together`);
      }
      this.faces = { offsets: Uint32Array.from({ length: corners.length / 3 + 1 }, (_, f) => 3 * f), corners };
    } else if (Array.isArray(faces)) {
      let end = 0;
      this.faces = { offsets: Uint32Array.from([0, ...faces.map((face) => (end += face.length))]), corners: indices(faces.flat(), "faces") };
    } else {
      this.faces = { offsets: indices(faces.offsets, "offsets"), corners: indices(faces.corners, "corners") };
    }
    this.merge = merge === null || merge === undefined ? null : indices(merge, "merge");
  }

  /** Its arrays, unchanged. */
  static of(positions, offsets, corners) {
    return Object.assign(Object.create(Mesh.prototype), { positions, faces: { offsets, corners }, merge: null });
  }

  get vertexCount() {
    return this.positions.length / 3;
  }

  get faceCount() {
    return this.faces.offsets.length - 1;
  }

  /** The corners if all faces are triangles, else null: what libraries that draw take. */
  get triangles() {
    return this.faces.offsets.every((offset, f) => offset === 3 * f) ? this.faces.corners : null;
  }
}

/** Polylines: curve c has the points offsets[c] to offsets[c + 1] - 1. */
export class Curves {
  constructor(points, { offsets = null, closed = false } = {}) {
    const isList = Array.isArray(points) && points.length > 0 && (isTyped(points[0]) || Array.isArray(points[0]) && typeof points[0][0] === "object");
    if (isList && offsets === null) {
      const each = points.map((one) => packedOf(coordinates(one, "points"), "points"));
      let end = 0;
      this.offsets = Uint32Array.from([0, ...each.map((one) => (end += one.length / 3))]);
      this.points = new (each.every((one) => one instanceof Float32Array) ? Float32Array : Float64Array)(3 * end);
      each.forEach((one, c) => this.points.set(one, 3 * this.offsets[c]));
    } else {
      this.points = packedOf(coordinates(points, "points"), "points");
      this.offsets = offsets === null ? Uint32Array.of(0, this.points.length / 3) : indices(offsets, "offsets");
    }
    const count = this.offsets.length - 1;
    this.closed = typeof closed === "boolean" ? new Uint8Array(count).fill(Number(closed)) : Uint8Array.from(closed, Number);
    if (this.closed.length !== count) {
      throw new TypeError(`closed has ${this.closed.length} entries for ${count} curves: give one for each`);
    }
  }

  /** Its arrays, unchanged. */
  static of(points, offsets, closed) {
    return Object.assign(Object.create(Curves.prototype), { points, offsets, closed });
  }

  get length() {
    return this.offsets.length - 1;
  }

  /** The points of one curve. */
  curve(index) {
    return this.points.subarray(3 * this.offsets[index], 3 * this.offsets[index + 1]);
  }
}

/** Whether an argument is an input, not the parameters. */
export function isInput(one) {
  return Array.isArray(one) || isTyped(one) || one instanceof Mesh || one instanceof Curves || one?.positions !== undefined || one?.points !== undefined;
}

/** A mesh, or what is converted to one. */
export function meshOf(one) {
  if (one instanceof Mesh) {
    return one;
  }
  if (one?.positions === undefined || one.faces === undefined) {
    throw new TypeError(`the mesh lacks ${one?.positions === undefined ? "positions" : "faces"}: pass both`);
  }
  return new Mesh(one.positions, one.faces, one);
}

/** Curves, or what is converted to them. */
export function curvesOf(one) {
  if (one instanceof Curves) {
    return one;
  }
  return one?.points === undefined ? new Curves(one) : new Curves(one.points, one);
}

const scalar = (values) => (values instanceof Float32Array ? constants.PLUGIN_F32 : constants.PLUGIN_F64);

/** The structs of inputs, in the library's memory; and the meshes and curves that they became. */
export function given(library, room, inputs, kinds) {
  const size = room.struct("gusset_input").size;
  const first = room.cleared(size * Math.max(inputs.length, 1));
  const taken = inputs.map((one, k) => {
    const kind = kinds[Math.min(k, kinds.length - 1)] ?? "mesh";
    const isMesh = kind === "mesh", made = isMesh ? meshOf(one) : curvesOf(one);
    const view = room.struct(isMesh ? "gusset_plugin_mesh" : "gusset_plugin_curves");
    if (isMesh) {
      view.positions = room.array(made.positions);
      view.vertex_count = made.vertexCount;
      view.face_offsets = room.array(made.faces.offsets);
      view.face_corners = room.array(made.faces.corners);
      view.face_count = Math.max(made.faceCount, 0);
      view.scalar = scalar(made.positions);
      checkOffsets(made.faces.offsets, made.faces.corners.length, "corners");
      if (made.merge) {
        if (made.merge.length !== made.vertexCount) {
          throw new TypeError(`merge has ${made.merge.length} entries for ${made.vertexCount} vertices: give one for each`);
        }
        view.merge = room.array(made.merge);
      }
    } else {
      view.points = room.array(made.points);
      view.point_count = made.points.length / 3;
      view.offsets = room.array(made.offsets);
      view.closed = room.array(made.closed);
      view.curve_count = made.length;
      view.scalar = scalar(made.points);
    }
    const input = library.struct("gusset_input", first + k * size);
    input.struct_size = size;
    input.view = view.pointer;
    input.kind = isMesh ? constants.KIND_MESH : constants.KIND_CURVES;
    return made;
  });
  return { first, taken };
}

/** The library gets the start of the corners, and trusts that the last one exists. */
function checkOffsets(offsets, length, what) {
  if (offsets.length === 0 || offsets[offsets.length - 1] > length) {
    throw new TypeError(`offsets end at ${offsets[offsets.length - 1]}; they must end at ${length}, the number of ${what}, or before`);
  }
}
