// The beginning of gusset.d.ts: types that do not follow from the table.

/** Coordinates: x, y, z of one point after the other, or points. */
export type Coordinates = Float32Array | Float64Array | ArrayLike<number> | readonly ArrayLike<number>[];

/** Whole numbers from 0. */
export type Indices = Uint32Array | ArrayLike<number>;

/** Faces: the corners of triangles; or face f has the corners `offsets[f]` to `offsets[f + 1] - 1`; or the corners of each. */
export type Faces = Indices | { offsets: Indices; corners: Indices } | readonly (readonly number[])[];

/** A mesh, or arrays that are converted to one. `merge`: for each vertex the one that it is one with. */
export type MeshLike = Mesh | { positions: Coordinates; faces: Faces; merge?: Indices | null };

/**
 * Polylines, or arrays that are converted to them. A list of typed arrays or of lists of points is a list of curves;
 * a list of x, y, z is one curve. `closed`, of
 * all or of each, says whether they go on to their first points.
 */
export type CurvesLike = Curves | { points: Coordinates | readonly Coordinates[]; offsets?: Indices | null; closed?: boolean | ArrayLike<number | boolean> } | readonly Coordinates[];

/** A polygon mesh. */
export class Mesh {
  constructor(positions: Coordinates, faces: Faces, options?: { merge?: Indices | null });
  /** x, y, z of one vertex after the other, in the precision of the input. */
  readonly positions: Float32Array | Float64Array;
  /** Face f has the corners `offsets[f]` to `offsets[f + 1] - 1`. */
  readonly faces: { readonly offsets: Uint32Array; readonly corners: Uint32Array };
  readonly merge: Uint32Array | null;
  readonly vertexCount: number;
  readonly faceCount: number;
  /** The corners if all faces are triangles, else null. */
  readonly triangles: Uint32Array | null;
}

/** Polylines: curve c has the points `offsets[c]` to `offsets[c + 1] - 1`. */
export class Curves {
  constructor(points: Coordinates | readonly Coordinates[], options?: { offsets?: Indices | null; closed?: boolean | ArrayLike<number | boolean> });
  readonly points: Float32Array | Float64Array;
  readonly offsets: Uint32Array;
  /** For each curve 0 or 1. */
  readonly closed: Uint8Array;
  /** The number of curves. */
  readonly length: number;
  /** The points of one curve: a part of `points`. */
  curve(index: number): Float32Array | Float64Array;
}

/** Lines of text, with the numbers in it by their names. Flags are booleans; angles are in radians. */
export class Report {
  readonly text: string;
  readonly values: Readonly<Record<string, number | boolean>>;
  toString(): string;
}

/** A call of the library failed; nothing has changed. */
export class GussetError extends Error {
  /** The number of the status, as in gusset.h. */
  readonly status: number;
  readonly code: ErrorCode;
  /** The kind of element of `index`. */
  readonly element: ElementKind;
  /** The first element at fault, or null. */
  readonly index: number | null;
  /** Its value where it has one, or null. */
  readonly value: number | null;
  /** The number of the input that is at fault, or null. */
  readonly input: number | null;
  /** The number of the parameter that is out of range, or null. */
  readonly param: number | null;
}
/** The input cannot be used; names its first offending element. */
export class InputError extends GussetError {}
/**
 * A file or document breaks a rule, or the format is unknown or cannot hold the document. The message names the file
 * and the line, byte or element. `code` is "bad_file" or "bad_argument".
 */
export class FileError extends GussetError {}
/** Memory ran out. */
export class OutOfMemory extends GussetError {}
/** The call was cancelled. */
export class Cancelled extends GussetError {}
/** The library stopped by a bug of its own: the loaded module cannot be used any more. */
export class Stopped extends GussetError {}

/** Options of each run, beside its parameters. */
export interface RunOptions {
  /** Called now and then during long work, with the part done, 0 to 1. Returning false cancels, and so does throwing, which is passed on. */
  progress?: (fraction: number, stage: string) => boolean | void;
  /** Receives remarks that are not failures. */
  log?: (message: string) => void;
  /** Whether outputs tell where their elements come from, for `carry`. */
  origins?: boolean;
}

/** Arrays of values that can be carried over. */
export type Values = Float32Array | Float64Array | Uint8Array | Uint16Array | Uint32Array;

/** All that a run left: a sequence of meshes, curves and reports. */
export class Outputs<Made = Mesh | Curves | Report> implements Iterable<Made> {
  readonly length: number;
  at(index: number): Made | undefined;
  [Symbol.iterator](): Iterator<Made>;
  /** Whether an output tells where its elements come from. */
  hasOrigins(index?: number): boolean;
  /** Values of the elements of an output, from values of the inputs: one array for each input, or null. */
  carry<V extends Values>(
    values: readonly (V | null)[],
    options?: {
      domain?: Domain;
      rule?: Rule;
      index?: number;
      maxInfluences?: number;
      /** How many values an element has; null: as many as the first array has of each. */
      components?: number | null;
    },
  ): V;
  /** Gives the library's memory back: meshes, curves and reports stay, `carry` is over. */
  free(): void;
}

/** A parameter of a filter. */
export interface Param {
  readonly id: string;
  readonly label: string;
  readonly help: string;
  readonly kind: ParamKind;
  readonly arity: number;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly defaults: readonly number[];
  readonly choices: readonly { readonly word: string; readonly label: string; readonly help: string }[];
}

/** A filter of the table; call it with its inputs and its parameters. */
export interface Filter<Inputs extends readonly unknown[] = readonly (MeshLike | CurvesLike)[], Result = unknown, Params = RunOptions> {
  (...given: [...inputs: Inputs, params?: Params]): Result;
  /** Runs it and gives all that it left; `free` it. */
  run(inputs: Inputs, params?: Params): Outputs;
  readonly id: string;
  readonly scriptName: string;
  readonly category: string;
  readonly help: string;
  readonly reference: string;
  /** The last holds for all further inputs. */
  readonly inputKinds: readonly Kind[];
  readonly outputKinds: readonly Kind[];
  readonly minInputs: number;
  readonly maxInputs: number;
  readonly hasOrigins: boolean;
  readonly params: readonly Param[];
}

/** The library, with memory of its own. */
export interface Gusset {
  /** "major.minor.patch". */
  readonly version: string;
  readonly filters: Filters;
  /** Bytes of the library's memory, which grows and never shrinks. */
  readonly memory: WebAssembly.Memory;
}

/** Loads the library from gusset.wasm beside this file, or from the argument. */
export function load(source?: string | URL | BufferSource | WebAssembly.Module | Response | PromiseLike<Response>): Promise<Gusset>;

/** Bytes of a file. */
export type FileBytes = ArrayBuffer | ArrayBufferView;

/** Files beside the one that is read or written, by the names in it: material libraries, buffers, images, scans. */
export type Folder = Readonly<Record<string, FileBytes>> | ReadonlyMap<string, FileBytes> | ((name: string) => FileBytes | null | undefined);

/** Vectors at vertices, or at corners face by face. A vector whose first number is NaN is missing. */
export interface Attribute {
  domain: "vertices" | "corners";
  values: Float64Array;
}

/** A named number for each vertex or face. */
export interface Property {
  name: string;
  domain: "vertices" | "faces";
  /** The type in a PLY file. */
  kind: "i8" | "u8" | "i16" | "u16" | "i32" | "u32" | "f32" | "f64";
  values: Float64Array;
}

/** Attributes of a mesh in a file. */
export interface MeshAttributes {
  /** The name of the object; may be empty. */
  name: string;
  /** x, y, z of each vector. */
  normals: Attribute | null;
  /** u, v of each vector; 0, 0 is the lower left of the image. */
  texcoords: Attribute | null;
  /** sRGB and opacity of each vertex, 0 to 1. */
  vertexColours: Float32Array | null;
  /** sRGB and opacity of each face, 0 to 1. */
  faceColours: Float32Array | null;
  /** For each face an index into the materials of the document, or 0xffffffff for none. */
  faceMaterials: Uint32Array | null;
  /** Further numbers. */
  properties: Property[];
}

/** A mesh of a file, which every filter accepts. */
export interface FileMesh extends Mesh, MeshAttributes {}

/** Points without faces. */
export interface Points {
  positions: Float32Array | Float64Array;
  normals: Float64Array | null;
  /** sRGB and opacity of each point, 0 to 1. */
  colours: Float32Array | null;
}

/** A mesh in the scene. */
export interface Placement {
  name: string;
  /** The index of the mesh. */
  mesh: number;
  /** The rows of the 3 x 4 matrix that takes the mesh into the scene. */
  transform: Float64Array;
}

/** A material of faces. */
export interface Material {
  name: string;
  /** Base colour: sRGB and opacity, 0 to 1. */
  colour: ArrayLike<number>;
  /** The index of the image of the base colour. */
  image: number | null;
  /** All that the format says: lines of an MTL library, or a glTF material as JSON text. */
  native: { mtl: string[] } | { gltf: string; textures: [sampler: string, image: number | null][] } | null;
}

/** An image: the name of a file, or its bytes. */
export interface FileImage {
  name: string;
  /** "image/png", "image/jpeg", or empty if unknown. */
  mediaType: string;
  file?: string;
  bytes?: Uint8Array;
}

/** The content of a file. */
export interface FileDocument {
  meshes: FileMesh[];
  placements: Placement[];
  /** All polylines. */
  curves: Curves | null;
  /** All points without faces. */
  points: Points | null;
  materials: Material[];
  images: FileImage[];
  /** Metres for each unit of length, if the file says so. */
  metresPerUnit: number | null;
  /** Deviations from the format that the reader accepted, and content that it left out. */
  notes: { text: string; line?: number; byte?: number }[];
}

/** An attribute to write; its domain is "vertices" by default. */
export interface AttributeLike {
  domain?: "vertices" | "corners";
  values: ArrayLike<number>;
}

/** A mesh to write. */
export type FileMeshLike = MeshLike & {
  name?: string;
  normals?: AttributeLike | null;
  texcoords?: AttributeLike | null;
  vertexColours?: ArrayLike<number> | null;
  faceColours?: ArrayLike<number> | null;
  faceMaterials?: ArrayLike<number> | null;
  properties?: readonly { name: string; domain?: "vertices" | "faces"; kind?: Property["kind"]; values: ArrayLike<number> }[];
};

/** A document to write. Absent members are empty. Without placements, each mesh is placed once, unmoved. */
export interface DocumentLike {
  meshes?: readonly FileMeshLike[];
  placements?: readonly { name?: string; mesh: number; transform: ArrayLike<number> }[] | null;
  curves?: CurvesLike | null;
  points?: PointsLike | null;
  materials?: readonly Partial<Material>[];
  images?: readonly Partial<FileImage>[];
  metresPerUnit?: number | null;
}

/** Points to write. */
export interface PointsLike {
  positions: Coordinates;
  normals?: ArrayLike<number> | null;
  colours?: ArrayLike<number> | null;
}

export interface ReadOptions {
  folder?: Folder | null;
  /** Keeps the meshes of a scene and their placements. Otherwise they are joined to one mesh. */
  scene?: boolean;
  /** Merges vertices of STL, DXF and glTF files at equal points; true if absent. */
  merge?: boolean;
}

export interface WriteOptions {
  /** Gives the images that the document names. */
  folder?: Folder | null;
  /** Writes PLY and STL files as text. */
  text?: boolean;
  /** Permits rounding that moves points by more than a thousandth of the mean edge. */
  lossy?: boolean;
}

/** A file and the files beside it by their names, and what the format does not hold. */
export interface Written {
  /** The file has the name that was given, and comes first. */
  files: Map<string, Uint8Array>;
  losses: string[];
}

/** The module for files, with memory of its own. */
export interface FileModule {
  read(name: string, bytes: FileBytes, options?: ReadOptions): FileDocument;
  write(name: string, document: DocumentLike | FileMeshLike | CurvesLike | PointsLike, options?: WriteOptions): Written;
  /** Bytes of the module's memory, which grows and never shrinks. */
  readonly memory: WebAssembly.Memory;
}

/** Loads the module for files from gusset_files.wasm beside this file, or from the argument. */
export function loadFiles(source?: string | URL | BufferSource | WebAssembly.Module | Response | PromiseLike<Response>): Promise<FileModule>;

/** Reads a file, in the format of the extension of its name. The first call of `read` or `write` loads the module. */
export function read(name: string, bytes: FileBytes, options?: ReadOptions): Promise<FileDocument>;

/** Writes a document, mesh, curves or points, in the format of the extension of the name. */
export function write(
  name: string,
  document: DocumentLike | FileMeshLike | CurvesLike | PointsLike,
  options?: WriteOptions,
): Promise<Written>;
