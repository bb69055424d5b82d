// Types of gusset-mesh. Written by generate.mjs; do not edit.

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

/** The name of a status. */
export type ErrorCode =
  | "null_argument"
  | "misaligned_argument"
  | "bad_struct_size"
  | "unknown_value"
  | "out_of_range"
  | "buffer_too_small"
  | "context_busy"
  | "no_such_element"
  | "bad_stride"
  | "bad_face_layout"
  | "overlap"
  | "wrong_handle"
  | "count_differs"
  | "too_large"
  | "size_overflow"
  | "empty_mesh"
  | "bad_offsets"
  | "face_too_small"
  | "index_out_of_range"
  | "not_finite"
  | "mixed_scalars"
  | "bad_wings"
  | "bad_merge"
  | "repeated_corner"
  | "no_loop"
  | "loop_too_short"
  | "loop_repeats_vertex"
  | "loop_edge_not_free"
  | "loops_share_vertex"
  | "loop_not_oriented"
  | "orientation_conflict"
  | "no_strip"
  | "planes_undecided"
  | "cut_not_connected"
  | "curve_not_closed"
  | "curve_not_plane"
  | "empty_curve"
  | "sections_differ"
  | "no_node"
  | "net_too_small"
  | "crossing_cell"
  | "bad_seam"
  | "sides_differ"
  | "no_grid"
  | "bad_stream"
  | "scene_cycle"
  | "empty_scene"
  | "field_undefined"
  | "glued_inside"
  | "gluings_differ"
  | "bad_knots"
  | "curves_apart"
  | "out_of_memory"
  | "cancelled"
  | "panic"
  | "bad_argument"
  | "bad_file";

/** The kind of element that the index of an error counts. */
export type ElementKind =
  | "none"
  | "vertex"
  | "face"
  | "half_edge"
  | "offset"
  | "loop_place"
  | "count"
  | "point"
  | "constraint"
  | "place"
  | "section"
  | "node"
  | "link"
  | "cell"
  | "seam"
  | "bridge"
  | "entry"
  | "byte"
  | "side_place"
  | "item"
  | "knot"
  | "row"
  | "edge";

/** The kind of an input or output of a filter. */
export type Kind =
  | "mesh"
  | "curves"
  | "text";

/** The kind of a parameter. */
export type ParamKind =
  | "bool"
  | "int"
  | "real"
  | "choice"
  | "length"
  | "angle"
  | "point"
  | "direction"
  | "plane";

/** The kind of elements with values. */
export type Domain =
  | "vertices"
  | "corners"
  | "faces";

/** How the values of several sources become one. */
export type Rule =
  | "linear"
  | "normal"
  | "skin_weights"
  | "nearest"
  | "texture";

/** Parameters of `boundary_loops`; what is not given is what suits the inputs. */
export interface BoundaryLoopsParams extends RunOptions {
  /**
   * Edges with three or more faces. The course of a loop at an edge with three or more faces.
   */
  non_manifold?: "cut" | "stop" | number;
}

/** Parameters of `stitch`; what is not given is what suits the inputs. */
export interface StitchParams extends RunOptions {
  /**
   * Loop of the first mesh. The number of the loop in the output of the filter boundary_loops. -1 takes the nearest pair of loops. From
   * -1 to 4294967295.
   */
  loop_a?: number;
  /**
   * Loop of the second mesh. The number of the loop in the output of the filter boundary_loops. -1 takes the nearest pair of loops. From
   * -1 to 4294967295.
   */
  loop_b?: number;
  /**
   * Meridians. The rule that joins vertices of one loop to vertices of the other.
   */
  meridians?: "continuation" | "least_area" | "by_index" | "by_arc_length" | "greedy" | "shortest_meridians" | "least_bend" | "quads" | number;
  /**
   * Opposite orientation. The treatment of a second piece of opposite orientation.
   */
  orientation?: "reverse_it" | "refuse" | "ignore" | number;
  /**
   * Twist. The number of vertices by which the start on the second loop is shifted from the closest pair. From -4294967295 to 4294967295.
   */
  twist?: number;
  /**
   * Join. The parts of the loops that are joined.
   */
  extent?: "whole_loops" | "facing_arcs" | "automatic" | number;
  /**
   * Facing arc. The arc that is taken if several arcs face the other loop.
   */
  run?: "closest" | "longest" | number;
  /**
   * Facing tolerance. The smallest distance from the plane through the centre of its own loop at which a point faces the other loop. -1
   * takes the bound on rounding. From -1 to 1000000000000000.
   */
  tolerance?: number;
  /**
   * Rows. The rows of new vertices between the rims.
   */
  rows?: "none" | "by_mean_edge" | "given_number" | number;
  /**
   * Number of rows. The number of rows of new vertices, if it is given. From 0 to 10000.
   */
  row_count?: number;
  /**
   * Faces. The faces of the strip.
   */
  cells?: "triangles" | "quads" | number;
  /**
   * Shape of the rows. The positions of the new vertices.
   */
  fairing?: "straight" | "fair" | number;
  /**
   * Finish. The surface between the rims. A blend ignores the rows, their shape and the kind of face.
   */
  finish?: "strip" | "blend" | number;
  /**
   * Intersections. The search for faces that intersect each other.
   */
  intersections?: "automatic" | "ignore" | "report" | number;
  /**
   * Turn outwards. Reverses the faces of closed components that face the wrong side. Components face outwards; the walls of cavities face
   * into the cavities.
   */
  outward?: boolean;
}

/** Parameters of `weld`; what is not given is what suits the inputs. */
export interface WeldParams extends RunOptions {
  /**
   * Weld. The vertices that are welded.
   */
  vertices?: "borders" | "all_vertices" | number;
  /**
   * Tolerance. The largest distance at which vertices coincide, or a vertex and an edge if borders are sewn. 0 takes equal positions; -1
   * takes the rounding of the positions, judged by their type and digits. From -1 to 1000000000000000.
   */
  tolerance?: number;
  /**
   * Short edges. The treatment of coincident corners of one face.
   */
  collapse?: "keep" | "collapse" | number;
  /**
   * Unused vertices. The treatment of vertices that no face uses.
   */
  unused?: "keep" | "remove" | number;
}

/** Parameters of `orient`; what is not given is what suits the inputs. */
export interface OrientParams extends RunOptions {
  /**
   * Closed components. The orientation of closed components.
   */
  outward?: "majority" | "outwards" | number;
}

/** Parameters of `fill`; what is not given is what suits the inputs. */
export interface FillParams extends RunOptions {
  /**
   * Finish. The interior of the patches.
   */
  finish?: "rim_only" | "refined" | "blend" | number;
  /**
   * Best triangulation. The weight that the triangulation of a rim minimises.
   */
  weight?: "best_continuation" | "area_and_bend" | "largest_bend" | "area" | number;
  /**
   * Most edges. Loops of more edges stay open; 0 sets no limit. From 0 to 4294967295.
   */
  max_edges?: number;
  /**
   * Greatest length. Longer loops stay open; 0 sets no limit. From 0 to 1000000000000000.
   */
  max_length?: number;
  /**
   * Keep open. The loops that are not holes.
   */
  keep?: "automatic" | "none" | "the_longest" | "borders" | number;
  /**
   * Patches. The loops that share a patch.
   */
  together?: "each_by_itself" | "all_by_one_patch" | "where_it_costs_less" | number;
  /**
   * Greatest diameter. Loops whose bounding box has a longer diagonal stay open; 0 sets no limit. From 0 to 1000000000000000.
   */
  max_diameter?: number;
  /**
   * Greatest area. Loops with a larger area between them and their centre stay open; 0 sets no limit. The unit is the square of the
   * positions' unit. From 0 to 1000000000000000.
   */
  max_area?: number;
  /**
   * Intersections. The search for faces of patches that intersect others.
   */
  intersections?: "automatic" | "ignore" | "report" | number;
  /**
   * Plan only. Fills nothing. The report says what would be filled.
   */
  plan_only?: boolean;
  /**
   * Continuity. The continuity between fair patches and the surface around them.
   */
  continuity?: "tangents" | "curvature" | number;
  /**
   * Ignore creases. Ends creases of the surface at the rims of patches.
   */
  ignore_creases?: boolean;
  /**
   * Turn outwards. Reverses the faces of closed components that face the wrong side. Components face outwards; the walls of cavities face
   * into the cavities.
   */
  outward?: boolean;
  /**
   * Coincident borders. Borders that coincide with others.
   */
  sew?: "sew" | "leave" | number;
}

/** Parameters of `join`; what is not given is what suits the inputs. */
export interface JoinParams extends RunOptions {
  /**
   * Coincident borders. The treatment of coincident borders.
   */
  weld?: "sew" | "keep" | "edge_to_edge" | number;
  /**
   * Welding distance. The largest distance at which vertices coincide, or a vertex and an edge if borders are sewn. 0 takes equal
   * positions; -1 takes the rounding of the positions, judged by their type and digits. From -1 to 1000000000000000.
   */
  tolerance?: number;
  /**
   * Widest gap. The largest mean width of a gap that is closed. 0 closes none; -1 decides by the size of the loops. From -1 to
   * 1000000000000000.
   */
  max_gap?: number;
  /**
   * Join. The parts of the loops that are joined.
   */
  extent?: "loops_and_parts_of_them" | "whole_loops" | number;
  /**
   * Meridians. The rule that joins vertices of one loop to vertices of the other.
   */
  meridians?: "continuation" | "least_area" | "by_index" | "by_arc_length" | "greedy" | "shortest_meridians" | "least_bend" | "quads" | number;
  /**
   * Rows. The rows of new vertices between the rims.
   */
  rows?: "none" | "by_mean_edge" | number;
  /**
   * Shape of the rows. The positions of the new vertices.
   */
  fairing?: "straight" | "fair" | number;
  /**
   * Finish. The surface between the rims. A blend ignores the rows, their shape and the kind of face.
   */
  finish?: "strip" | "blend" | number;
  /**
   * Remaining holes. The treatment of holes that remain.
   */
  holes?: "leave" | "fill" | "fill_refined_and_fair" | number;
  /**
   * Turn outwards. Reverses the faces of closed components that face the wrong side. Components face outwards; the walls of cavities face
   * into the cavities.
   */
  outward?: boolean;
  /**
   * Overlaps. The treatment of pieces that overlap.
   */
  overlaps?: "keep" | "trim" | number;
  /**
   * Align first. First moves overlapping pieces to where they fit, as the filter align does from where they lie.
   */
  align?: boolean;
  /**
   * Keep open. The remaining loops that are not holes, if holes are filled. If overlaps are trimmed, Automatic acts as Borders.
   */
  keep?: "automatic" | "none" | "the_longest" | "borders" | number;
  /**
   * Most edges. Loops of more edges stay open; 0 sets no limit. From 0 to 4294967295.
   */
  max_edges?: number;
  /**
   * Greatest length. Longer loops stay open; 0 sets no limit. From 0 to 1000000000000000.
   */
  max_length?: number;
  /**
   * Greatest diameter. Loops whose bounding box has a longer diagonal stay open; 0 sets no limit. From 0 to 1000000000000000.
   */
  max_diameter?: number;
  /**
   * Greatest area. Loops with a larger area between them and their centre stay open; 0 sets no limit. The unit is the square of the
   * positions' unit. From 0 to 1000000000000000.
   */
  max_area?: number;
}

/** Parameters of `outline`; what is not given is what suits the inputs. */
export interface OutlineParams extends RunOptions {
  /**
   * Curve. The kind of curve that is drawn.
   */
  curve?: "composite" | "cubic_spline" | "blend" | "smooth_blend" | "single" | "chain" | number;
  /**
   * Method. The line that holds the control point of a section.
   */
  method?: "bisector" | "median" | "normal" | "symmedian" | number;
  /**
   * Constraint. The condition that fixes the section of a point.
   */
  lock?: "parameter" | "own_triangle" | "guide" | number;
  /**
   * Joints. The joints between the sections of a composite curve.
   */
  joint?: "halves" | "knots" | "curvature" | number;
  /**
   * Ends. The end conditions of open curves.
   */
  ends?: "free" | "perpendicular" | "level" | "upright" | "level_or_upright" | number;
  /**
   * Corners. Points where the polyline turns by more than this angle remain corners; pi makes all of them smooth. From 0 to
   * 3.141592653589793.
   */
  corner_angle?: number;
  /**
   * Merge. Neighbouring points closer than this become one, relative to the size of their polyline. The report counts crowded points,
   * which almost repeat a neighbour, and points in loops that the polyline lacks. From 0 to 0.5.
   */
  merge?: number;
  /**
   * Chord error. The largest distance of the polyline from the curve, relative to the size of the curve. From 1e-9 to 1.
   */
  chord_error?: number;
}

/** Parameters of `net_shape`; what is not given is what suits the inputs. */
export interface NetShapeParams extends RunOptions {
  /**
   * Shape. The shape, about the z axis.
   */
  shape?: "sphere" | "one_pole_sphere" | "plane" | "tube" | "cylinder" | "cone" | "torus" | "cube" | "moebius_strip" | "klein_bottle" | "prism" | "pyramid" | "projective_plane" | "pillow" | number;
  /**
   * Rows. The number of rows of nodes, from one pole or rim to the other. From 5 to 10001.
   */
  rows?: number;
  /**
   * Columns. The number of columns of nodes. In closed rows the last node repeats the first. From 5 to 10001.
   */
  columns?: number;
  /**
   * Radius. The radius; for a torus, the radius of its centre line. From 1e-15 to 1000000000000000.
   */
  radius?: number;
  /**
   * Minor radius. The radius of the tube of a torus, less than the radius. From 1e-15 to 1000000000000000.
   */
  minor_radius?: number;
  /**
   * Height. The height of tubes, cylinders, cones, prisms and pyramids. From 1e-15 to 1000000000000000.
   */
  height?: number;
  /**
   * Triangles. Cuts quads along their shorter diagonals.
   */
  triangles?: boolean;
  /**
   * Sides. The number of sides of the base of prisms and pyramids, less than the number of columns. From 3 to 10000.
   */
  sides?: number;
}

/** Parameters of `deform`; what is not given is what suits the inputs. */
export interface DeformParams extends RunOptions {
  /**
   * Field. The deformation field.
   */
  field?: "twist" | "taper" | "bend" | "shear" | "spherify" | "cylinder_wrap" | "cone_wrap" | "torus_wrap" | "sphere_wrap" | number;
  /**
   * Axis. The axis of the field, through the origin.
   */
  axis?: "z" | "x" | "y" | number;
  /**
   * Amount. The parameter of all fields except wraps; 0 leaves the mesh unchanged. The suggestion suits a twist. From -1000000000000000
   * to 1000000000000000.
   */
  amount?: number;
  /**
   * Strength. The fraction of the motion: 0 leaves the vertices unchanged, 1 moves them all the way. From 0 to 1.
   */
  strength?: number;
  /**
   * Radius. The radius of a wrap; for a torus, the radius of its centre line. A wrap about the z axis with the suggested radius takes the
   * extent of the mesh along x exactly once around. From 1e-15 to 1000000000000000.
   */
  radius?: number;
  /**
   * Minor radius. The radius of the tube of a torus. With the suggested radius, the extent along y goes exactly once around the tube.
   * From 1e-15 to 1000000000000000.
   */
  minor_radius?: number;
  /**
   * Lean. The angle by which the generators of a cone lean towards its axis. From -1.5707963267948966 to 1.5707963267948966.
   */
  lean?: number;
}

/** Parameters of `smooth_surface`; what is not given is what suits the inputs. */
export interface SmoothSurfaceParams extends RunOptions {
  /**
   * Surface. The interpolation of the vertices. The quads must form a grid of rows and columns.
   */
  scheme?: "smooth" | "four_points" | number;
  /**
   * Deviation. The largest distance of faces from the surface, relative to the diagonal of its box. From 1e-7 to 1.
   */
  deviation?: number;
  /**
   * Parts. The smallest number of parts of each side of a cell. From 1 to 1000.
   */
  parts?: number;
  /**
   * Triangles. Makes triangles instead of quads.
   */
  triangles?: boolean;
}

/** Parameters of `smooth_sections`; what is not given is what suits the inputs. */
export interface SmoothSectionsParams extends RunOptions {
  /**
   * Surface. The interpolation of the vertices. The quads must form a grid of rows and columns.
   */
  scheme?: "smooth" | "four_points" | number;
  /**
   * Direction. The normal of the planes. From -1000000000000000 to 1000000000000000.
   */
  direction?: ArrayLike<number>;
  /**
   * Planes. The placement of the planes.
   */
  placement?: "even" | "given" | number;
  /**
   * Number. The number of planes. From 1 to 10000.
   */
  number?: number;
  /**
   * Offset. The distance of the first plane from the origin along the direction, for given planes. From -1000000000000000 to
   * 1000000000000000.
   */
  offset?: number;
  /**
   * Distance. The spacing of the planes, for given planes. From 1e-15 to 1000000000000000.
   */
  distance?: number;
  /**
   * Chord error. The largest distance of the polylines from the curves, relative to the diagonal of the surface's box. From 1e-9 to 1.
   */
  chord_error?: number;
}

/** Parameters of `smooth_silhouette`; what is not given is what suits the inputs. */
export interface SmoothSilhouetteParams extends RunOptions {
  /**
   * Surface. The interpolation of the vertices. The quads must form a grid of rows and columns.
   */
  scheme?: "smooth" | "four_points" | number;
  /**
   * Direction. The direction of view. From -1000000000000000 to 1000000000000000.
   */
  direction?: ArrayLike<number>;
  /**
   * Angle. The angle between normals and the direction. From 0 to 3.141592653589793.
   */
  angle?: number;
  /**
   * Chord error. The largest distance of the polylines from the curves, relative to the diagonal of the surface's box. From 1e-9 to 1.
   */
  chord_error?: number;
}

/** Parameters of `smooth_distance`; what is not given is what suits the inputs. */
export interface SmoothDistanceParams extends RunOptions {
  /**
   * Surface. The interpolation of the vertices. The quads must form a grid of rows and columns.
   */
  scheme?: "smooth" | "four_points" | number;
  /**
   * Strength. The fraction of the motion: 0 leaves the vertices unchanged, 1 moves them all the way. From 0 to 1.
   */
  strength?: number;
}

/** Parameters of `check`; what is not given is what suits the inputs. */
export interface CheckParams extends RunOptions {
  /**
   * Elements listed. The largest number of elements listed for each kind of defect. From 0 to 1000000.
   */
  listed?: number;
  /**
   * Intersections. Also finds the pairs of faces that intersect or touch each other elsewhere than in common vertices and edges.
   */
  intersections?: boolean;
}

/** Parameters of `facing_arcs`; what is not given is what suits the inputs. */
export interface FacingArcsParams extends RunOptions {
  /**
   * First loop. The number of the curve, from 0 on. The filter boundary_loops gives suitable curves. From 0 to 4294967295.
   */
  curve_a?: number;
  /**
   * Second loop. The number of the curve, from 0 on. The filter boundary_loops gives suitable curves. From 0 to 4294967295.
   */
  curve_b?: number;
  /**
   * Facing arc. The arc that is taken if several arcs face the other loop.
   */
  run?: "closest" | "longest" | number;
  /**
   * Centres. The definition of a loop's centre.
   */
  centres?: "mean_of_the_points" | "mean_of_the_curve" | number;
  /**
   * Facing tolerance. The smallest distance from the plane through the centre of its own loop at which a point faces the other loop. -1
   * takes the bound on rounding. From -1 to 1000000000000000.
   */
  tolerance?: number;
}

/** Parameters of `strip`; what is not given is what suits the inputs. */
export interface StripParams extends RunOptions {
  /**
   * Meridians. The rule that joins points of one curve to points of the other.
   */
  meridians?: "continuation" | "least_area" | "by_index" | "by_arc_length" | "greedy" | "shortest_meridians" | "least_bend" | "quads" | number;
  /**
   * First meridian. The start of the strip between closed curves. Between open curves it starts at their first points.
   */
  start?: "automatic" | "closest_pair" | "first_points" | number;
  /**
   * Reversed. Reverses the second curve.
   */
  reversed?: boolean;
  /**
   * Rows. The rows of new vertices between the rims.
   */
  rows?: "none" | "by_mean_edge" | "given_number" | number;
  /**
   * Number of rows. The number of rows of new vertices, if it is given. From 0 to 10000.
   */
  row_count?: number;
  /**
   * Faces. The faces of the strip.
   */
  cells?: "triangles" | "quads" | number;
}

/** Parameters of `net_resample`; what is not given is what suits the inputs. */
export interface NetResampleParams extends RunOptions {
  /**
   * Rows. The number of rows of vertices. The suggestion keeps about the same number of vertices. From 2 to 100001.
   */
  rows?: number;
  /**
   * Columns. The number of columns of vertices. In closed rows the last vertex repeats the first. From 2 to 100001.
   */
  columns?: number;
  /**
   * Interpolation. The interpolation between the old vertices.
   */
  interpolation?: "cubic" | "bilinear" | number;
  /**
   * Triangles. Cuts quads along their shorter diagonals.
   */
  triangles?: boolean;
}

/** Parameters of `net_decimate`; what is not given is what suits the inputs. */
export interface NetDecimateParams extends RunOptions {
  /**
   * Tolerance. The largest distance of removed vertices from the segments that replace them. A thousandth of the size is suggested. From
   * 0 to 1000000000000000.
   */
  tolerance?: number;
  /**
   * Triangles. Cuts quads along their shorter diagonals.
   */
  triangles?: boolean;
}

/** Parameters of `net_join`; what is not given is what suits the inputs. */
export interface NetJoinParams extends RunOptions {
  /**
   * Direction. The direction from each grid to the next.
   */
  direction?: "below" | "right" | number;
  /**
   * Between them. The connection between two grids.
   */
  bridge?: "quads" | "nothing" | "weld" | number;
  /**
   * Welding distance. The largest distance of vertices that are welded; 0 for equal positions. From 0 to 1000000000000000.
   */
  tolerance?: number;
  /**
   * Different sizes. The treatment of sides with different numbers of vertices.
   */
  sizes?: "repeat_evenly" | "repeat_the_first" | "repeat_the_last" | "refuse" | number;
  /**
   * Twist. The number of vertices by which closed sides of all grids except the first are rotated before joining. From 0 to 4294967295.
   */
  twist?: number;
  /**
   * Flip. Flips grids of opposite orientation to the first along the side. Without it, the filter fails for such grids.
   */
  turn?: boolean;
  /**
   * Triangles. Cuts quads along their shorter diagonals.
   */
  triangles?: boolean;
}

/** Parameters of `net_measures`; what is not given is what suits the inputs. */
export interface NetMeasuresParams extends RunOptions {
  /**
   * Planarity limit. Counts the quads whose corners are farther than this from their mean plane, relative to the longer diagonal. From 0
   * to 1.
   */
  planarity?: number;
}

/** Parameters of `net_analyse`; what is not given is what suits the inputs. */
export interface NetAnalyseParams extends RunOptions {
  /**
   * Tolerance. The largest length that counts as 0. A billionth of the size is suggested. From 0 to 1000000000000000.
   */
  tolerance?: number;
  /**
   * Faces listed. The largest number of folded faces that are listed. From 0 to 1000000.
   */
  listed?: number;
}

/** Parameters of `net_lathe`; what is not given is what suits the inputs. */
export interface NetLatheParams extends RunOptions {
  /**
   * Point of the axis. A point on the axis of revolution. From -1000000000000000 to 1000000000000000.
   */
  point?: ArrayLike<number>;
  /**
   * Direction of the axis. The direction of the axis. The surface runs counter-clockwise about it. From -1000000000000000 to
   * 1000000000000000.
   */
  direction?: ArrayLike<number>;
  /**
   * Columns. The number of quads around the axis. From 3 to 100000.
   */
  columns?: number;
  /**
   * Rows. The number of rows at equal arc lengths of the curve; 0 takes the given points. From 0 to 100000.
   */
  rows?: number;
  /**
   * Between the points. The curves through the given points.
   */
  between?: "straight" | "smooth" | "cubic_spline" | number;
  /**
   * Triangles. Cuts quads along their shorter diagonals.
   */
  triangles?: boolean;
}

/** Parameters of `displace`; what is not given is what suits the inputs. */
export interface DisplaceParams extends RunOptions {
  /**
   * Distance. The displacement, outwards if positive and inwards if negative. A hundredth of the size is suggested. From
   * -1000000000000000 to 1000000000000000.
   */
  distance?: number;
  /**
   * Triangles. Cuts quads along their shorter diagonals.
   */
  triangles?: boolean;
}

/** Parameters of `project`; what is not given is what suits the inputs. */
export interface ProjectParams extends RunOptions {
  /**
   * Plane. The plane of projection. The plane below the mesh is suggested. From -1000000000000000 to 1000000000000000.
   */
  plane?: ArrayLike<number>;
  /**
   * Along. The lines of projection.
   */
  along?: "normal" | "direction" | "lines_through_a_point" | number;
  /**
   * Direction. The direction of projection, if it is given. From -1000000000000000 to 1000000000000000.
   */
  direction?: ArrayLike<number>;
  /**
   * Point. The centre of projection, if it is given. A point above the mesh is suggested. From -1000000000000000 to 1000000000000000.
   */
  eye?: ArrayLike<number>;
  /**
   * Strength. The fraction of the motion: 0 leaves the vertices unchanged, 1 moves them all the way. From 0 to 1.
   */
  strength?: number;
}

/** Parameters of `curve_measures`; what is not given is what suits the inputs. */
export interface CurveMeasuresParams extends RunOptions {
  /**
   * Between the points. The curves through the given points.
   */
  between?: "straight" | "smooth" | "cubic_spline" | number;
}

/** Parameters of `curve_resample`; what is not given is what suits the inputs. */
export interface CurveResampleParams extends RunOptions {
  /**
   * Between the points. The curves through the given points.
   */
  between?: "straight" | "smooth" | "cubic_spline" | number;
  /**
   * Spacing. The rule that places the new points.
   */
  spacing?: "number" | "step" | "chord_error" | number;
  /**
   * Number. The number of points of each curve, if it is given. Both ends of an open curve count. From 2 to 1000000.
   */
  number?: number;
  /**
   * Step. The spacing of points along the curve, if it is given. From 1e-15 to 1000000000000000.
   */
  step?: number;
  /**
   * Chord error. The largest distance of the resulting polylines from the curves, relative to the diagonal of the box of all curves. From
   * 1e-9 to 1.
   */
  chord_error?: number;
}

/** Parameters of `curve_offset`; what is not given is what suits the inputs. */
export interface CurveOffsetParams extends RunOptions {
  /**
   * Between the points. The curves through the given points.
   */
  between?: "straight" | "smooth" | "cubic_spline" | number;
  /**
   * Plane. The plane of the curves, up to a millionth of their size. The plane in which they enclose the largest area is suggested. From
   * -1000000000000000 to 1000000000000000.
   */
  plane?: ArrayLike<number>;
  /**
   * Distance. The signed distance of the offset: to the left if positive, to the right if negative. From -1000000000000000 to
   * 1000000000000000.
   */
  distance?: number;
  /**
   * Chord error. The largest distance of the resulting polylines from the curves, relative to the diagonal of the box of all curves. From
   * 1e-9 to 1.
   */
  chord_error?: number;
}

/** Parameters of `curve_meet`; what is not given is what suits the inputs. */
export interface CurveMeetParams extends RunOptions {
  /**
   * Between the points. The curves through the given points.
   */
  between?: "straight" | "smooth" | "cubic_spline" | number;
  /**
   * Distance. The largest distance at which curves count as meeting. 0 finds intersections up to rounding. From 0 to 1000000000000000.
   */
  within?: number;
}

/** Parameters of `curve_nearest`; what is not given is what suits the inputs. */
export interface CurveNearestParams extends RunOptions {
  /**
   * Between the points. The curves through the given points.
   */
  between?: "straight" | "smooth" | "cubic_spline" | number;
}

/** Parameters of `curve_svg`; what is not given is what suits the inputs. */
export interface CurveSvgParams extends RunOptions {
  /**
   * Between the points. The curves through the given points.
   */
  between?: "straight" | "smooth" | "cubic_spline" | number;
  /**
   * Plane. The plane of the curves, up to a millionth of their size. The plane in which they enclose the largest area is suggested. From
   * -1000000000000000 to 1000000000000000.
   */
  plane?: ArrayLike<number>;
  /**
   * y downwards. Negates the second coordinate, as y points down in SVG.
   */
  downwards?: boolean;
}

/** Parameters of `loft`; what is not given is what suits the inputs. */
export interface LoftParams extends RunOptions {
  /**
   * Nodes. The rule by which points of the sections correspond.
   */
  nodes?: "by_arc_length" | "by_number" | "by_angle" | number;
  /**
   * Columns. The number of nodes on each section; more if there are more corners. Ignored if the nodes are the given points. From 2 to
   * 100000.
   */
  columns?: number;
  /**
   * Corners. Points where a section turns by more than this angle are corners; pi makes all of them smooth. If negative, closed sections
   * of up to 6 points are polygons. So are sections whose points turn by more than 54 or less than 6 degrees. Other corners turn by 40
   * degrees and far more than usual. From -1 to 3.141592653589793.
   */
  corner_angle?: number;
  /**
   * Through. The elements that the surface contains.
   */
  through?: "sections" | "nodes" | "curves" | number;
  /**
   * Ring. The first section follows the last one.
   */
  ring?: boolean;
  /**
   * Point of the axis. A point on the axis of the angles. The centre of the sections is suggested. From -1000000000000000 to
   * 1000000000000000.
   */
  point?: ArrayLike<number>;
  /**
   * Direction of the axis. The direction of the axis of the angles. The direction from the first section to the last is suggested. From
   * -1000000000000000 to 1000000000000000.
   */
  direction?: ArrayLike<number>;
  /**
   * Deviation. The largest distance of faces from the surface, relative to the diagonal of its box. From 1e-7 to 1.
   */
  deviation?: number;
  /**
   * Parts. The smallest number of parts of each side of a cell. From 1 to 1000.
   */
  parts?: number;
  /**
   * Triangles. Makes triangles instead of quads.
   */
  triangles?: boolean;
}

/** Parameters of `smooth_net`; what is not given is what suits the inputs. */
export interface SmoothNetParams extends RunOptions {
  /**
   * Between the points. The curves through the given points.
   */
  between?: "straight" | "smooth" | "cubic_spline" | number;
  /**
   * Ring. The first curve across follows the last one. Ignored if there are curves along, which determine it.
   */
  ring?: boolean;
  /**
   * Tolerance. The largest distance of two curves where they meet. Both are moved to the middle. From 1e-15 to 1000000000000000.
   */
  tolerance?: number;
  /**
   * Deviation. The largest distance of faces from the surface, relative to the diagonal of its box. From 1e-7 to 1.
   */
  deviation?: number;
  /**
   * Parts. The smallest number of parts of each side of a cell. From 1 to 1000.
   */
  parts?: number;
  /**
   * Triangles. Makes triangles instead of quads.
   */
  triangles?: boolean;
}

/** Parameters of `smooth_isophotes`; what is not given is what suits the inputs. */
export interface SmoothIsophotesParams extends RunOptions {
  /**
   * Surface. The interpolation of the vertices. The quads must form a grid of rows and columns.
   */
  scheme?: "smooth" | "four_points" | number;
  /**
   * Direction. The direction that the light comes from. From -1000000000000000 to 1000000000000000.
   */
  direction?: ArrayLike<number>;
  /**
   * Number. The number of angles. From 1 to 10000.
   */
  number?: number;
  /**
   * Sides. The range of the angles.
   */
  sides?: "both" | "alike" | number;
  /**
   * Chord error. The largest distance of the polylines from the curves, relative to the diagonal of the surface's box. From 1e-9 to 1.
   */
  chord_error?: number;
}

/** Parameters of `smooth_intersect`; what is not given is what suits the inputs. */
export interface SmoothIntersectParams extends RunOptions {
  /**
   * Surface. The interpolation of the vertices. The quads must form a grid of rows and columns.
   */
  scheme?: "smooth" | "four_points" | number;
  /**
   * Chord error. The largest distance of the polylines from the curves, relative to the diagonal of the surface's box. From 1e-9 to 1.
   */
  chord_error?: number;
}

/** Parameters of `smooth_line`; what is not given is what suits the inputs. */
export interface SmoothLineParams extends RunOptions {
  /**
   * Surface. The interpolation of the vertices. The quads must form a grid of rows and columns.
   */
  scheme?: "smooth" | "four_points" | number;
  /**
   * Point. A point on the line, or the origin of a ray. A point below the centre of the mesh is suggested. From -1000000000000000 to
   * 1000000000000000.
   */
  point?: ArrayLike<number>;
  /**
   * Direction. The direction of the line. From -1000000000000000 to 1000000000000000.
   */
  direction?: ArrayLike<number>;
  /**
   * Hits. The intersections that are returned.
   */
  which?: "all_of_the_line" | "all_of_the_ray" | "first_of_the_ray" | number;
}

/** Parameters of `smooth_curve`; what is not given is what suits the inputs. */
export interface SmoothCurveParams extends RunOptions {
  /**
   * Surface. The interpolation of the vertices. The quads must form a grid of rows and columns.
   */
  scheme?: "smooth" | "four_points" | number;
  /**
   * Between the points. The curves through the given points.
   */
  between?: "straight" | "smooth" | "cubic_spline" | number;
}

/** Parameters of `smooth_nearest`; what is not given is what suits the inputs. */
export interface SmoothNearestParams extends RunOptions {
  /**
   * Surface. The interpolation of the vertices. The quads must form a grid of rows and columns.
   */
  scheme?: "smooth" | "four_points" | number;
}

/** Parameters of `sew`; what is not given is what suits the inputs. */
export interface SewParams extends RunOptions {
  /**
   * Tolerance. The largest distance at which vertices coincide, or a vertex and an edge if borders are sewn. 0 takes equal positions; -1
   * takes the rounding of the positions, judged by their type and digits. From -1 to 1000000000000000.
   */
  tolerance?: number;
  /**
   * Unused vertices. The treatment of vertices that no face uses.
   */
  unused?: "keep" | "remove" | number;
}

/** Parameters of `align`; what is not given is what suits the inputs. */
export interface AlignParams extends RunOptions {
  /**
   * Start. The positions that the pieces start from.
   */
  start?: "as_they_lie" | "principal_axes" | "rims" | "features" | number;
  /**
   * Greatest distance. Points farther than this from another piece form no pair with it, so the pieces must start this near to their
   * places. 0 and -1 take a tenth of the diagonal of the largest piece's box. From -1 to 1000000000000000.
   */
  max_distance?: number;
  /**
   * Points. The number of points of each piece for which the nearest points of the others are found. From 1 to 4294967295.
   */
  samples?: number;
  /**
   * Most rounds. The largest number of rounds in each of two stages. A stage ends early once nothing moves. From 1 to 1000000.
   */
  max_rounds?: number;
}

/** Parameters of `trim`; what is not given is what suits the inputs. */
export interface TrimParams extends RunOptions {
  /**
   * Greatest distance. Surfaces at most this far apart overlap. 0 takes surfaces that touch; -1 takes four mean edges of the coarser
   * piece. From -1 to 1000000000000000.
   */
  max_distance?: number;
  /**
   * Greatest angle. Surfaces whose normals differ by a larger angle do not overlap. From 0.001 to 1.57.
   */
  max_angle?: number;
  /**
   * Fewest faces. Remaining parts of fewer faces are dropped, unless they are whole components of a piece. From 1 to 4294967295.
   */
  min_faces?: number;
}

/** Parameters of `develop`; what is not given is what suits the inputs. */
export interface DevelopParams extends RunOptions {
  /**
   * Distortion. The kind of distortion to minimise.
   */
  distortion?: "lengths_and_areas" | "as_rigid_as_possible" | "angles" | number;
  /**
   * Darts. The largest number of darts: cuts from the border to places of large curvature. From 0 to 100.
   */
  darts?: number;
  /**
   * Largest stretch. Darts are cut until no length changes by a larger factor; 1 cuts all of them. From 1 to 100.
   */
  stretch?: number;
}

/** Parameters of `net_planarise`; what is not given is what suits the inputs. */
export interface NetPlanariseParams extends RunOptions {
  /**
   * Tolerance. The largest distance of the corners of a face from their mean plane, relative to the diagonal of the bounding box. 0 takes
   * 1e-10, or 4e-7 for positions in single precision. From 0 to 1.
   */
  tolerance?: number;
  /**
   * Keep the boundary. Vertices on the boundary keep their positions.
   */
  keep_boundary?: boolean;
  /**
   * Most steps. The largest number of steps. From 1 to 1000000.
   */
  max_steps?: number;
}

/** Parameters of `net_settle`; what is not given is what suits the inputs. */
export interface NetSettleParams extends RunOptions {
  /**
   * Direction. The direction from each grid to the next.
   */
  direction?: "below" | "right" | number;
  /**
   * Rows. The number of rows of new vertices in each bridge. From 1 to 10000.
   */
  rows?: number;
  /**
   * Tension. The force in each line across a ribbon, or the force per length in a tube. From 0 to 1000000000000000.
   */
  tension?: number;
  /**
   * Elasticity. The force that doubles the length of a line across a bridge. From 0 to 1000000000000000.
   */
  elasticity?: number;
  /**
   * Stiffness. The bending stiffness of each line across a bridge, as force times squared length. Stiff lines leave the grids without a
   * kink. From 0 to 1000000000000000.
   */
  stiffness?: number;
  /**
   * Rest length. The length of an unstressed bridge, as a multiple of its straight length. Only elastic bridges depend on it. From 0.001
   * to 1000.
   */
  rest_ratio?: number;
  /**
   * Different sizes. The treatment of sides with different numbers of vertices.
   */
  sizes?: "repeat_evenly" | "repeat_the_first" | "repeat_the_last" | "refuse" | number;
  /**
   * Twist. The number of vertices by which closed sides of all grids except the first are rotated before joining. From 0 to 4294967295.
   */
  twist?: number;
  /**
   * Flip. Flips grids of opposite orientation to the first along the side. Without it, the filter fails for such grids.
   */
  turn?: boolean;
  /**
   * Most steps. The largest number of steps. From 1 to 1000000.
   */
  max_steps?: number;
  /**
   * Triangles. Cuts quads along their shorter diagonals.
   */
  triangles?: boolean;
}

/** Parameters of `morph`; what is not given is what suits the inputs. */
export interface MorphParams extends RunOptions {
  /**
   * Ratio. The fraction of the way: 0 gives the first mesh, 1 gives the second. From 0 to 1.
   */
  ratio?: number;
  /**
   * Path. The path of the vertices.
   */
  path?: "straight" | "with_rotation" | number;
}

/** Parameters of `lattice`; what is not given is what suits the inputs. */
export interface LatticeParams extends RunOptions {
  /**
   * Strength. The fraction of the motion: 0 leaves the vertices unchanged, 1 moves them all the way. From 0 to 1.
   */
  strength?: number;
}

/** The filters of the table, by their names for scripts. */
export interface Filters {
  /**
   * Finds every boundary loop of a mesh as a polyline: a chain of edges with a face on one side only. The surface lies to the left of a
   * loop. Where the boundary touches itself, it is divided into simple loops. Source: S. Nesterenko, The algorithm for polygonal networks
   * of cross-linking, algorithm 1
   */
  readonly boundary_loops: Filter<[MeshLike], [Curves, Report], BoundaryLoopsParams>;
  /**
   * Joins two boundary loops, of two meshes or of one, by a closed band of new faces. On request a strip joins only the arcs that face
   * each other. All vertices keep their positions, and all faces stay. Source: S. Nesterenko, The algorithm for polygonal networks of
   * cross-linking
   */
  readonly stitch: Filter<[MeshLike] | [MeshLike, MeshLike], [Mesh, Report], StitchParams>;
  /**
   * Merges coincident vertices. Either coincident borders are welded edge to edge, whatever the orientation of their faces, or all
   * coincident vertices are merged, as a triangle soup requires. Source: Greedy clustering in the order of the vertices; edges are sewn
   * in pairs
   */
  readonly weld: Filter<[MeshLike], [Mesh, Report], WeldParams>;
  /**
   * Reverses the fewest faces of each component that make neighbours consistently oriented. One-sided components, such as a Moebius
   * strip, stay as they are. Source: Breadth-first search across edges of two faces
   */
  readonly orient: Filter<[MeshLike], [Mesh, Report], OrientParams>;
  /**
   * Closes boundary loops of a mesh by new triangles: the triangulation of least weight, on request refined to the density of the
   * surrounding mesh and faired. All vertices keep their positions, and all faces stay. Before that, borders that coincide with others
   * are sewn, as the filter join does. Source: P. Liepa, Filling holes in meshes (2003); G. Barequet, M. Sharir, Filling gaps in the
   * boundary of a polyhedron (1995)
   */
  readonly fill: Filter<[MeshLike], [Mesh, Report], FillParams>;
  /**
   * Joins many open pieces into one mesh. Overlaps are trimmed on request. Coincident borders are sewn, orientations are made consistent,
   * and loops that face each other across a gap are stitched. Holes are filled on request, and closed results are turned outwards. Loops
   * that face no other loop stay as they are. Source: S. Nesterenko, The algorithm for polygonal networks of cross-linking, for a single
   * gap
   */
  readonly join: Filter<[MeshLike, ...MeshLike[]], [Mesh, Report], JoinParams>;
  /**
   * Draws smooth Bezier curves through all points of polylines, and returns them as finer polylines. Each point is the middle of a
   * quadratic section, whose control point lies on the bisector, the median or the normal at the point. Source: T. Nadopta, Theoretical
   * foundations of the identification of outline curves, 2008
   */
  readonly outline: Filter<[CurvesLike], [Curves, Report], OutlineParams>;
  /**
   * Makes a standard shape as a quad grid. Rows and columns of faces continue across its seams, and a side contracted to a pole is one
   * vertex. Source: A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks
   */
  readonly net_shape: Filter<[], [Mesh, Report], NetShapeParams>;
  /**
   * Moves the vertices of a mesh by a deformation field: twist, taper, bend or shear about an axis, projection towards a sphere, or a
   * wrap, which rolls a sheet onto a cylinder, a cone, a torus or a sphere. Faces do not change, and coincident vertices stay coincident.
   * Source: A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks, deformation fields; A. Barr, Global and
   * local deformations of solid primitives (1984)
   */
  readonly deform: Filter<[MeshLike], Mesh, DeformParams>;
  /**
   * Draws a smooth surface through the vertices of a quad grid, and returns it as a finer mesh. Its vertices lie on the surface, and its
   * faces deviate from it at most as requested. Source: V. A. Leus, Carcasses on smooth surfaces, 1976
   */
  readonly smooth_surface: Filter<[MeshLike], [Mesh, Report], SmoothSurfaceParams>;
  /**
   * Cuts the smooth surface through the vertices of a quad grid by parallel planes, and returns the curves in order. No curve is missed.
   * Points lie on the surface, not on the quads. Source: V. A. Leus, Carcasses on smooth surfaces, 1976
   */
  readonly smooth_sections: Filter<[MeshLike], [Curves, Report], SmoothSectionsParams>;
  /**
   * Finds where the normals of the smooth surface through the vertices of a quad grid make a given angle with a direction. The angle pi /
   * 2 gives the silhouettes seen along the direction; other angles give lines of equal slope. Source: V. A. Leus, Carcasses on smooth
   * surfaces, 1976
   */
  readonly smooth_silhouette: Filter<[MeshLike], [Curves, Report], SmoothSilhouetteParams>;
  /**
   * Measures the distances of the vertices of a mesh from a smooth surface, and moves them towards their nearest points on it. The
   * surface passes through the vertices of a quad grid, the second mesh. Source: V. A. Leus, Carcasses on smooth surfaces, 1976
   */
  readonly smooth_distance: Filter<[MeshLike, MeshLike], [Mesh, Report], SmoothDistanceParams>;
  /**
   * Reports every defect of a mesh with the numbers of the elements: boundary edges, edges of three or more faces, non-manifold vertices,
   * inconsistently oriented, duplicate, degenerate and zero-area faces, unused vertices; and the number of components, the Euler
   * characteristic and the genus. On request it reports faces that intersect each other. Source: Counts on half-edges; genus by Euler's
   * formula; J. R. Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric predicates (1997), for intersections
   */
  readonly check: Filter<[MeshLike], Report, CheckParams>;
  /**
   * Finds the points of two loops that face each other. A point faces the other loop if it lies on that side of the plane through the
   * centre of its own loop. The arcs that stitching would join come first, then the other arcs. Source: S. Nesterenko, The algorithm for
   * polygonal networks of cross-linking, algorithm 2
   */
  readonly facing_arcs: Filter<[CurvesLike], [Curves, Report], FacingArcsParams>;
  /**
   * Spans a strip of faces between two polylines, both closed or both open, that run side by side in the same direction. Source: H.
   * Fuchs, Z. Kedem, S. Uselton, Optimal surface reconstruction from planar contours, 1977; S. Nesterenko for the rule by index
   */
  readonly strip: Filter<[CurvesLike], [Mesh, Report], StripParams>;
  /**
   * Resamples a quad grid to other numbers of rows and columns, evenly spaced over the old ones. Closed sides and poles are kept. Source:
   * A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks
   */
  readonly net_resample: Filter<[MeshLike], [Mesh, Report], NetResampleParams>;
  /**
   * Removes rows and columns of a quad grid, always the one with the least deviation, up to a tolerance. The remaining vertices keep
   * their positions. Source: A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks
   */
  readonly net_decimate: Filter<[MeshLike], [Mesh, Report], NetDecimateParams>;
  /**
   * Joins quad grids side by side into one. The rows or columns of each grid follow the grid before it, after a row of new quads or
   * welded. Rows of smaller grids are replicated to fit. Source: A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular
   * networks, concatenation
   */
  readonly net_join: Filter<[MeshLike, MeshLike, ...MeshLike[]], [Mesh, Report], NetJoinParams>;
  /**
   * Measures a quad grid as a surface of bilinear patches: area, bounding box, planarity of the quads and topology. A closed grid also
   * has volume, centroid and inertia tensor. Source: The divergence theorem on bilinear patches, with Gauss points
   */
  readonly net_measures: Filter<[MeshLike], Report, NetMeasuresParams>;
  /**
   * Compares a quad grid before a deformation with the same mesh after it. It returns the edges that were contracted or torn, as segments
   * of the original grid, and lists the quads that were folded. A deformation without any of these is soft. Source: A. A. Deryagin,
   * Modelling of 3D objects and scenes by tetragonal regular networks, soft and hard deformations
   */
  readonly net_analyse: Filter<[MeshLike, MeshLike], [Curves, Report], NetAnalyseParams>;
  /**
   * Revolves a curve about an axis. The result is a quad grid whose rows are circles, with a pole where the curve meets the axis. Only
   * the height of each point along the axis and its distance from the axis count. Source: A. A. Deryagin, Modelling of 3D objects and
   * scenes by tetragonal regular networks
   */
  readonly net_lathe: Filter<[CurvesLike], [Mesh, Report], NetLatheParams>;
  /**
   * Moves every vertex of a quad grid along the surface normal. Poles and seams stay closed. Source: A. A. Deryagin, Modelling of 3D
   * objects and scenes by tetragonal regular networks
   */
  readonly displace: Filter<[MeshLike], Mesh, DisplaceParams>;
  /**
   * Projects the vertices of a mesh onto a plane, along a direction or through a point, or moves them a fraction of the way. Faces do not
   * change. Source: A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks, projections
   */
  readonly project: Filter<[MeshLike], Mesh, ProjectParams>;
  /**
   * Measures curves: length, bounding box and enclosed area. A curve that is not plane has the area of its largest projection. An open
   * curve is closed by its chord. Source: T. Nadopta, Theoretical foundations of the identification of outline curves, 2008
   */
  readonly curve_measures: Filter<[CurvesLike], Report, CurveMeasuresParams>;
  /**
   * Resamples curves: a given number of points, points at a given spacing, or the fewest points that keep the polyline within the chord
   * error of the curve. Source: T. Nadopta, Theoretical foundations of the identification of outline curves, 2008
   */
  readonly curve_resample: Filter<[CurvesLike], Curves, CurveResampleParams>;
  /**
   * Draws the offset curves of plane curves, on their left as seen against the normal of the plane. Straight segments join the corners.
   * An offset intersects itself where the distance exceeds the radius of curvature. Source: Hermite interpolation of the exact offset,
   * halved until the deviation measured is small enough
   */
  readonly curve_offset: Filter<[CurvesLike], [Curves, Report], CurveOffsetParams>;
  /**
   * Finds where curves intersect, or pass each other within a distance. Each place is a curve of one point, midway between the two
   * curves. Self-intersections are found for curves in the plane z = 0. Source: Bezier clipping by convex hulls, and Newton's method
   */
  readonly curve_meet: Filter<[CurvesLike], [Curves, Report], CurveMeetParams>;
  /**
   * Finds the nearest point on any curve of the second input for each point of the first. It draws the segments between them and reports
   * their lengths. Source: T. Nadopta, Theoretical foundations of the identification of outline curves, 2008
   */
  readonly curve_nearest: Filter<[CurvesLike, CurvesLike], [Curves, Report], CurveNearestParams>;
  /**
   * Writes plane curves as the data of SVG paths, one line for each curve. Numbers keep every bit. Smooth curves become Bezier curves.
   * Source: T. Nadopta, Theoretical foundations of the identification of outline curves, 2008
   */
  readonly curve_svg: Filter<[CurvesLike], Report, CurveSvgParams>;
  /**
   * Draws a smooth surface through consecutive sections of a body, all closed or all open. A section of one point is a tip. Corners of
   * sections stay sharp. Between two equal sections, the surface is their cylinder. Sections that repeat the previous one are left out,
   * and the report names them. Source: T. Nadopta, Theoretical foundations of the identification of outline curves, 2008
   */
  readonly loft: Filter<[CurvesLike], [Mesh, Report], LoftParams>;
  /**
   * Draws the smooth surface that contains all curves of a network, as a mesh. The first input has the curves across, and a second input
   * may have curves along. Each curve along meets all curves across. The curves may be listed in any order. Curves across alone are
   * skinned in the given order. Source: W. J. Gordon, Spline-blended surface interpolation through curve networks, 1969
   */
  readonly smooth_net: Filter<[CurvesLike] | [CurvesLike, CurvesLike], [Mesh, Report], SmoothNetParams>;
  /**
   * Draws isophotes of the smooth surface through the vertices of a quad grid: curves on which the normals make one of several equally
   * spaced angles with a direction. Where isophotes are not smooth, the surface is not fair. Source: V. A. Leus, Carcasses on smooth
   * surfaces, 1976
   */
  readonly smooth_isophotes: Filter<[MeshLike], [Curves, Report], SmoothIsophotesParams>;
  /**
   * Finds the intersection curves of the smooth surfaces through the vertices of two quad grids. No branch is missed. Points where the
   * surfaces touch or branches cross are resolved. Cells where the surfaces touch along a curve or coincide count as unresolved. Source:
   * V. A. Leus, Carcasses on smooth surfaces, 1976
   */
  readonly smooth_intersect: Filter<[MeshLike, MeshLike], [Curves, Report], SmoothIntersectParams>;
  /**
   * Finds where a line or a ray intersects the smooth surface through the vertices of a quad grid. Each intersection is a curve of one
   * point; the report has its distance from the given point and the normal. No intersection is missed. Source: V. A. Leus, Carcasses on
   * smooth surfaces, 1976
   */
  readonly smooth_line: Filter<[MeshLike], [Curves, Report], SmoothLineParams>;
  /**
   * Finds where curves intersect the smooth surface through the vertices of a quad grid. Each intersection is a curve of one point. No
   * intersection is missed. Source: V. A. Leus, Carcasses on smooth surfaces, 1976
   */
  readonly smooth_curve: Filter<[MeshLike, CurvesLike], [Curves, Report], SmoothCurveParams>;
  /**
   * Finds the nearest point on the smooth surface through the vertices of a quad grid for each point of some curves. It draws the
   * segments between them and reports their lengths, and how many nearest points are not proven. Source: V. A. Leus, Carcasses on smooth
   * surfaces, 1976
   */
  readonly smooth_nearest: Filter<[MeshLike, CurvesLike], [Curves, Report], SmoothNearestParams>;
  /**
   * Welds coincident borders, even if their vertices do not match. An edge is split where a vertex of another border lies on it, if the
   * parts then coincide in pairs. Triangles with split edges are cut into triangles; larger faces gain corners. Source: Greedy clustering
   * in the order of the vertices; edges are sewn in pairs
   */
  readonly sew: Filter<[MeshLike], [Mesh, Report], SewParams>;
  /**
   * Moves all pieces rigidly to where they fit: pieces that overlap, or parts of one broken surface. The first piece stays. The result is
   * one mesh of all pieces, not joined. The report says whether the place of each piece, counted from 0, can be trusted. It gives the
   * motion of the piece as three rows of four numbers: a rotation and a translation. Normals that vertices carry keep their directions.
   * Source: P. Besl, N. McKay, A method for registration of 3-D shapes (1992); Y. Chen, G. Medioni, Object modelling by registration of
   * multiple range images (1992); P. Neugebauer, Reconstruction of real-world objects via simultaneous registration (1997); S.
   * Rusinkiewicz, A symmetric objective function for ICP (2019)
   */
  readonly align: Filter<[MeshLike, ...MeshLike[]], [Mesh, Report], AlignParams>;
  /**
   * Keeps one piece of each overlap, and leaves a narrow gap to the other pieces. The pieces must be in their final places. The result is
   * one mesh of all kept faces, not joined. No vertex moves, and no face is cut. The report counts pieces from 0. Source: G. Turk, M.
   * Levoy, Zippered polygon meshes from range images (1994), for the idea
   */
  readonly trim: Filter<[MeshLike, ...MeshLike[]], [Mesh, Report], TrimParams>;
  /**
   * Lays a surface out in the plane, as a pattern to cut it from. A surface that is not a disc is opened along short paths. A developable
   * surface keeps every length. Any other surface gets the least distortion, without folds or overlaps. Darts reduce the distortion
   * further. Source: Rabinovich, Poranne, Panozzo, Sorkine-Hornung 2017; Ben-Chen, Gotsman, Bunin 2008 for darts
   */
  readonly develop: Filter<[MeshLike], [Mesh, Report], DevelopParams>;
  /**
   * Moves the vertices of a quad grid as little as possible until all faces are planar, as panels of glass or sheet metal are. Failure to
   * converge is not an error; the report tells it. Source: A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular
   * networks, closures; Y. Liu et al., Geometric modeling with conical meshes and developable surfaces (2006)
   */
  readonly net_planarise: Filter<[MeshLike], [Mesh, Report], NetPlanariseParams>;
  /**
   * Joins quad grids side by side into one by bridges of several rows, and moves the rows of the bridges to the equilibrium of their
   * tension, elasticity and stiffness. The given grids keep their positions. A bridge between closed sides is a tube, whose tension acts
   * like a soap film. Failure to converge is not an error; the report tells it. Source: A. A. Deryagin, Modelling of 3D objects and
   * scenes by tetragonal regular networks, concatenation; H.-J. Schek, The force density method for form finding (1974)
   */
  readonly net_settle: Filter<[MeshLike, MeshLike, ...MeshLike[]], [Mesh, Report], NetSettleParams>;
  /**
   * Interpolates between two meshes with the same faces, such as a mesh and a deformed copy of it. Vertices correspond by their numbers.
   * Faces and attributes come from the first mesh. Source: A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular
   * networks, animation transformations; B. K. P. Horn (1987) for the rotation
   */
  readonly morph: Filter<[MeshLike, MeshLike], Mesh, MorphParams>;
  /**
   * Deforms a mesh by a lattice around it. The second mesh is the lattice at rest: its vertices lie on a uniform grid along the
   * coordinate axes, like the vertices of a box or of a subdivided cube. The third mesh is the lattice with its vertices moved. Vertices
   * of the first mesh inside the lattice follow; vertices outside stay. Grid points without a vertex follow the vertices around them.
   * Source: T. Sederberg, S. Parry, Free-form deformation of solid geometric models (1986)
   */
  readonly lattice: Filter<[MeshLike, MeshLike, MeshLike], Mesh, LatticeParams>;
}
