// Documents of files: as JSON text and an array of bytes, and as objects with typed arrays.

import { Curves, curvesOf, Mesh, meshOf, packedOf, coordinates } from "./inputs.js";
import { isTyped } from "./library.js";

const TYPES = { u8: Uint8Array, u32: Uint32Array, f32: Float32Array, f64: Float64Array };
const NUMBER_KINDS = ["i8", "u8", "i16", "u16", "i32", "u32", "f32", "f64"];
/** Entries of a 3 x 4 matrix. */
const MATRIX_LENGTH = 12;
/** Offsets of arrays are multiples of this. */
const ALIGNMENT = 8;
const utf8 = new TextDecoder("utf-8", { ignoreBOM: true }), encoder = new TextEncoder();

/**
 * Makes a document of its description. arrays: the bytes of its arrays. Each typed array of the document is a copy.
 */
export function unpackedDocument(described, arrays) {
  const array = (one) => {
    if (!one) {
      return null;
    }
    const kind = TYPES[one.type], size = one.count * one.width * kind.BYTES_PER_ELEMENT;
    // The copy is aligned, wherever the array is.
    return new kind(arrays.slice(one.at, one.at + size).buffer);
  };
  const attribute = (one) => one && { domain: one.at_corners ? "corners" : "vertices", values: array(one.values) };
  const mesh = (one) => Object.assign(Mesh.of(array(one.positions), array(one.face_offsets), array(one.corners)), {
    name: one.name, merge: array(one.merge), normals: attribute(one.normals), texcoords: attribute(one.texcoords),
    vertexColours: array(one.vertex_colours), faceColours: array(one.face_colours), faceMaterials: array(one.face_materials),
    properties: one.properties.map(({ name, kind, at_faces, values }) => ({ name, domain: at_faces ? "faces" : "vertices", kind, values: array(values) })),
  });
  const transforms = array(described.transforms);
  const { curves, points } = described;
  return {
    meshes: described.meshes.map(mesh),
    placements: described.placements.map((one, k) => ({ ...one, transform: transforms.slice(MATRIX_LENGTH * k, MATRIX_LENGTH * (k + 1)) })),
    curves: curves.closed.count > 0 ? Curves.of(array(curves.positions), array(curves.offsets), array(curves.closed)) : null,
    points: points.positions.count > 0 ? { positions: array(points.positions), normals: array(points.normals), colours: array(points.colours) } : null,
    materials: described.materials,
    images: described.images.map(({ media_type, bytes, ...rest }) => ({ ...rest, mediaType: media_type, ...(bytes && { bytes: array(bytes) }) })),
    metresPerUnit: described.metres_per_unit,
    notes: described.notes,
  };
}

/** Makes a document of a document, mesh, curves or points. */
function documentOf(content) {
  if (typeof content !== "object" || content === null) {
    throw new TypeError("a document is an object with meshes, curves or points");
  }
  if (content.positions !== undefined) {
    return content.faces === undefined ? { points: content } : { meshes: [content] };
  }
  if (content instanceof Curves || Array.isArray(content) || Array.isArray(content.points) || isTyped(content.points)) {
    return { curves: content };
  }
  if (!content.meshes && !content.curves && !content.points) {
    throw new TypeError("the document has neither meshes, curves nor points: give at least one");
  }
  return content;
}

/** Gathers typed arrays, and describes them. */
class ArrayList {
  /** Arrays and their offsets. */
  placed = [];
  size = 0;

  add(values, type, width, name) {
    if (values === null || values === undefined) {
      return null;
    }
    const kind = TYPES[type];
    if (typeof values !== "object" || typeof values.length !== "number") {
      throw new TypeError(`${name} are not an array`);
    }
    const given = values instanceof kind ? values : kind.from(values);
    if (given.length % width !== 0) {
      throw new TypeError(`${name} are ${given.length} numbers, not a multiple of ${width}`);
    }
    const at = this.size;
    this.placed.push([at, given]);
    this.size = Math.ceil((at + given.byteLength) / ALIGNMENT) * ALIGNMENT;
    return { at, count: given.length / width, type, width };
  }

  positions(values, name) {
    const given = packedOf(coordinates(values, name), name);
    return this.add(given, given instanceof Float32Array ? "f32" : "f64", 3, name);
  }

  attribute(one, width, name) {
    return one ? { at_corners: domainOf(one, ["vertices", "corners"], name) === "corners", values: this.add(one.values, "f64", width, name) } : null;
  }
}

/** The domain of an attribute, which is one of two. */
function domainOf({ domain = "vertices" }, domains, name) {
  if (!domains.includes(domain)) {
    throw new TypeError(`the domain of ${name} is "${domain}": there are ${domains.join(", ")}`);
  }
  return domain;
}

function describedMesh(arrays, given) {
  const mesh = meshOf(given);
  const property = ({ name, kind = "f64", values, ...rest }) => {
    const what = `property ${name}`;
    if (!NUMBER_KINDS.includes(kind)) {
      throw new TypeError(`the kind of ${what} is "${kind}": there are ${NUMBER_KINDS.join(", ")}`);
    }
    return { name: String(name), kind, at_faces: domainOf(rest, ["vertices", "faces"], what) === "faces", values: arrays.add(values ?? [], "f64", 1, `values of ${what}`) };
  };
  return {
    name: given.name ?? "",
    positions: arrays.positions(mesh.positions, "positions"),
    face_offsets: arrays.add(mesh.faces.offsets, "u32", 1, "offsets"),
    corners: arrays.add(mesh.faces.corners, "u32", 1, "corners"),
    merge: arrays.add(mesh.merge, "u32", 1, "merge"),
    normals: arrays.attribute(given.normals, 3, "normals"),
    texcoords: arrays.attribute(given.texcoords, 2, "texcoords"),
    vertex_colours: arrays.add(given.vertexColours, "f32", 4, "vertexColours"),
    face_colours: arrays.add(given.faceColours, "f32", 4, "faceColours"),
    face_materials: arrays.add(given.faceMaterials, "u32", 1, "faceMaterials"),
    properties: (given.properties ?? []).map(property),
  };
}

function describedScene(arrays, placements) {
  if (!placements) {
    return {};
  }
  const transforms = new Float64Array(MATRIX_LENGTH * placements.length);
  placements.forEach(({ transform }, k) => {
    if (transform?.length !== MATRIX_LENGTH) {
      throw new TypeError(`placement ${k}: transform has ${transform?.length ?? 0} numbers, not ${MATRIX_LENGTH}, the rows of a 3 x 4 matrix`);
    }
    transforms.set(transform, MATRIX_LENGTH * k);
  });
  return {
    placements: placements.map(({ name = "", mesh }) => ({ name, mesh })),
    transforms: arrays.add(transforms, "f64", MATRIX_LENGTH, "transforms"),
  };
}

/** Describes a document, mesh, curves or points: the JSON text, typed arrays with their offsets, and the size of all. */
export function packedDocument(content) {
  const document = documentOf(content), arrays = new ArrayList();
  const curves = document.curves && curvesOf(document.curves), { points } = document;
  const described = {
    meshes: (document.meshes ?? []).map((mesh) => describedMesh(arrays, mesh)),
    ...describedScene(arrays, document.placements),
    curves: curves ? {
      positions: arrays.positions(curves.points, "points of curves"), offsets: arrays.add(curves.offsets, "u32", 1, "offsets of curves"),
      closed: arrays.add(curves.closed, "u8", 1, "closed"),
    } : null,
    points: points ? {
      positions: arrays.positions(points.positions, "points"), normals: arrays.add(points.normals, "f64", 3, "normals of points"),
      colours: arrays.add(points.colours, "f32", 4, "colours of points"),
    } : null,
    materials: (document.materials ?? []).map(({ colour, ...rest }) => ({ ...rest, colour: colour ? Array.from(colour) : null })),
    images: (document.images ?? []).map(({ name = "", mediaType = "", file, bytes }) => (
      { name, media_type: mediaType, ...(file === undefined ? { bytes: arrays.add(bytes ?? [], "u8", 1, "bytes of an image") } : { file }) }
    )),
    metres_per_unit: document.metresPerUnit ?? null,
  };
  // JSON escapes halves of surrogate pairs, which the module refuses.
  const text = JSON.stringify(described, (_, value) => (typeof value === "string" ? utf8.decode(encoder.encode(value)) : value));
  return { text, placed: arrays.placed, size: arrays.size };
}
