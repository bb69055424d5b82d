/* Generated from src/capi; do not edit. See gusset.h. */

#ifndef GUSSET_MESH_H
#define GUSSET_MESH_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Meshes: Views of polygon meshes in memory of the caller or of a result. */

/// The type of coordinates.
typedef uint32_t gusset_scalar;
/// Coordinates are 32-bit floats.
#define GUSSET_F32 1
/// Coordinates are 64-bit floats.
#define GUSSET_F64 2

/// The type of indices.
typedef uint32_t gusset_index;
/// Indices and face offsets are 32-bit unsigned integers.
#define GUSSET_U32 0
/// Reserved: this version refuses it (GUSSET_ERROR_UNKNOWN_VALUE).
#define GUSSET_U64 1

/// Indices that a result lends, or that the caller gives.
typedef struct gusset_indices {
    /// The first one; may be NULL if count is 0.
    const uint32_t *data;
    /// How many.
    size_t count;
} gusset_indices;

/// A polygon mesh in memory: the caller's own arrays as input, or the arrays of a result. Nothing is copied on the way
/// in.
/// As input: at least one vertex and one face (EMPTY_MESH); at most 2^32 - 2 vertices and as many corners (TOO_LARGE);
/// at least three corners a face (FACE_TOO_SMALL); indices below vertex_count (INDEX_OUT_OF_RANGE); finite coordinates
/// at all vertices that faces use (NOT_FINITE), while unused ones may hold anything. The arrays may have any alignment.
/// They must be as long as the counts say, which the library cannot see, and must not change during a call. Also
/// NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE, UNKNOWN_VALUE, BAD_STRIDE, BAD_FACE_LAYOUT, BAD_OFFSETS
/// BAD_MERGE and SIZE_OVERFLOW; counts are held against the limits before any element is read.
/// As output: packed positions, face_offsets given, face_size 0.
typedef struct gusset_mesh_view {
    size_t struct_size;
    /// x, y, z at the start of every stride, of the type that scalar names.
    const void *positions;
    /// Bytes from one position to the next; 0 if they are packed.
    size_t position_stride;
    /// The number of vertices.
    size_t vertex_count;
    /// face_count + 1 entries: face f has the corners face_offsets[f] to face_offsets[f + 1] - 1. NULL if face_size is
    /// given.
    const void *face_offsets;
    /// The vertex at each corner, face after face. Corner h is also the name of the half-edge that starts there.
    const void *face_corners;
    /// The number of faces.
    size_t face_count;
    /// GUSSET_F32 or GUSSET_F64. Zero is no valid value: it must be said.
    gusset_scalar scalar;
    /// GUSSET_U32.
    gusset_index index;
    /// The number of corners of every face, or 0 if face_offsets is given.
    uint32_t face_size;
    uint32_t reserved;
    /// For each vertex the vertex that it is one with, of the type that index names: itself, or one that is one with
    /// itself; NULL if none is one with another. So can vertices be kept apart that carry different values, as at seams
    /// of texture coordinates, and the surface has no border there: see gusset_mesh_find_merge. Positions are those of
    /// the vertices that others are one with. Results name these in lists of vertices; their faces have the vertices
    /// that were given.
    const void *merge;
} gusset_mesh_view;

/* ---- Results: The mesh that an operation makes, with the report of the operation. */

/// A mesh that an operation made, with the report of that operation. Opaque and immutable; it keeps nothing of the
/// inputs.
/// gusset_join, gusset_stitch, gusset_strip, gusset_fill, gusset_weld, gusset_sew, gusset_orient, gusset_develop,
/// gusset_net_to_mesh and gusset_sheet_to_mesh make results. Each operation has a report of its own:
/// gusset_result_get_join and so on.
typedef struct gusset_result gusset_result;

/// Measures of the new faces of a stitch or of filled holes, and of the connectivity of the whole result.
typedef struct gusset_quality_report {
    size_t struct_size;
    /// The smallest angle of the new triangles, in radians; 0 if one is degenerate.
    double min_angle;
    /// The largest aspect ratio of the new triangles: longest side / (2 sqrt(3) inscribed radius), 1 for an equilateral
    /// triangle, infinite for a degenerate one.
    double max_aspect;
    /// The longest edge of the new faces, in the unit of the positions.
    double max_edge;
    /// Their area, in the square of that unit.
    double area;
    /// New triangles without area.
    uint32_t degenerate_faces;
    /// Boundary loops of the result; 0 if no edge has exactly one face.
    uint32_t loops_left;
    /// Edges of the result with three or more faces.
    uint32_t non_manifold_edges;
    /// Edges of the result whose two faces disagree in orientation.
    uint32_t orientation_conflicts;
} gusset_quality_report;

/// Destroys a result; NULL is allowed.
GUSSET_API void gusset_result_destroy(struct gusset_result *result);

/// Lends the mesh, valid until the result is destroyed.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_mesh(const struct gusset_result *result,
    struct gusset_mesh_view *view);

/// Gives measures of the new faces and of the result, for results of gusset_stitch and gusset_fill.
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_quality(const struct gusset_result *result,
    struct gusset_quality_report *quality);

struct gusset_origins;

/// Finds where the vertices, corners and faces of a result come from.
/// The inputs are the meshes or pieces of the operation in their order, or its one mesh, net or sheet:
/// - a strip has two polylines, which have neither corners nor faces; nor have its corners and faces any sources;
/// - a corner that gusset_sew added on an edge has the corners of its face at both ends of that edge;
/// - each vertex of a development comes from one vertex, and its corners and faces are those of the surface;
/// - a vertex of the mesh of a net has the first of its nodes, and a face its cell. A corner has the node of the cell
///   of its own face, which differs on either side of a seam: an image need not run back there;
/// - the nodes of a sheet are those between its cells, (rows + 1) * (columns + 1) of them, row after row. A vertex and
///   a corner have the nodes of their cell, by its parameters, and faces have their cells. On a line that closes the
///   sheet each corner has the nodes on the side of its own face.
/// @errors TOO_LARGE
/// @complexity O(H log n) for H corners, n of them of new faces; 16 bytes for each vertex, corner and face (of a sheet
///     52 for each vertex and corner), and linear in n.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_origins_create(const struct gusset_context *context,
    const struct gusset_result *result, struct gusset_origins **origins);

/* ---- Joining: Joins many open pieces to one mesh. */

struct gusset_join_options;

/// Joins open pieces into one mesh: coincident borders are sewn, components oriented alike, loops that face each other
/// across a gap stitched, holes filled, and closed components turned outwards, as the options say.
/// That two loops cannot be joined is no failure: each joint has its outcome.
/// Loops of different components face each other as wholes if nearly all vertices of each (9/10) are nearest to the
/// other loop, and from similar distances (the ninth decile is at most four times the first, or the spacing of the
/// vertices) or so that the nearest vertices go round the other loop once; else runs of neighbouring vertices that are
/// nearest to each other face each other, and are joined by open strips. What faces nothing is left alone. Pieces that
/// overlap are not cut unless overlaps says so: where two lie on each other, their borders face each other and enclose
/// what is between. Vertices of the result: those of the pieces in order, then those of the strips, then those of the
/// patches; faces in the same way. Positions are of the scalar type of the first piece, and old ones keep their bits.
/// @param pieces piece_count mesh views one after another, each as large as the first one's struct_size says, at least
///     one; each may have several components.
/// @param piece_count see pieces.
/// @errors as gusset_mesh_view (the report's input is the piece), EMPTY_MESH (without pieces), MIXED_SCALARS (a piece
///     has f64 positions and the first one f32), OUT_OF_RANGE (a tolerance, max_gap, or one of pairs or of excluded:
///     the report's index is its number, its input is 0 or 1 for the first or the second loop, its value the piece that
///     does not exist, else the vertex, and the message says what is wrong: there is no such piece, or no such vertex
///     of it; of pairs also: no vertex is named, no loop that can be joined passes it or several do, it is on the
///     pair's other loop, or its loop is in a pair before), TOO_LARGE
/// @complexity O(H log d) for H half-edges and at most d edges at a vertex, O(V log V) for V vertices on loops, the
///     time of each strip as for gusset_stitch, and of each hole as for gusset_fill; a pass over all faces for each
///     strip that is faired or tested for intersections. Extra memory is linear in the pieces and the result.
/// @source Nesterenko for a single gap; the rest is our own.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_join(const struct gusset_context *context,
    const struct gusset_mesh_view *pieces, size_t piece_count, const struct gusset_join_options *options,
    struct gusset_result **result);

struct gusset_join_report;

/// Lends the report on pieces, joints, loops and holes, for results of gusset_join.
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_join(const struct gusset_result *result,
    struct gusset_join_report *report);

/* ---- Options of stitching: How a strip is chosen, subdivided and smoothed. */

/// The rule that chooses meridians.
typedef uint32_t gusset_meridians;
/// The strip of triangles that best continues both surfaces, near the strip of least area: little turn between
/// neighbours, along the rims above all, and meridians that lie on the surface which the faces beside the rims suggest.
/// Between lines without faces (gusset_strip) the strip of least area.
#define GUSSET_MERIDIANS_CONTINUATION 0
/// The paper's rule by index, O(N + M): good for evenly spaced rims.
#define GUSSET_MERIDIANS_INDEX 1
/// Both rims walked at the same pace, by arc length, O(N + M).
#define GUSSET_MERIDIANS_ARC_LENGTH 2
/// Always on to the shorter of the two next meridians, O(N + M).
#define GUSSET_MERIDIANS_GREEDY 3
/// The strip of triangles whose meridians have the least total length.
#define GUSSET_MERIDIANS_MIN_DIAGONAL 4
/// The strip of triangles with the least bends: the sum over its edges, rims included, of length times (1 - cos of the
/// angle between the normals).
#define GUSSET_MERIDIANS_SMOOTH 5
/// The least sum of the meridians' squared lengths where steps on both rims at once are allowed (dynamic time warping):
/// quads where both sides advance, triangles elsewhere. Meant for strips with interior rows.
#define GUSSET_MERIDIANS_QUAD 6
/// The strip of triangles of least area through the first meridian.
#define GUSSET_MERIDIANS_MIN_AREA 7

/// The effort of the search for the best strip.
typedef uint32_t gusset_strip_search;
/// The best meridians are found exactly for up to 2^21 pairs of vertices, beyond that coarse to fine: nearly linear
/// time, linear memory, and a result within a few hundredths of a per cent of the best on all rims that were measured.
#define GUSSET_SEARCH_AUTO 0
/// Exactly: O(N M) time, and memory for each pair of vertices; see gusset_stitch.
#define GUSSET_SEARCH_EXACT 1

/// The first meridian of a closed strip.
typedef uint32_t gusset_strip_start;
/// The first meridian of a closed band joins the closest pair of vertices, or the closest pair after rim B has been
/// turned along rim A to where it fits best; the better strip of the two is kept.
#define GUSSET_START_AUTO 0
/// The closest pair.
#define GUSSET_START_CLOSEST 1
/// gusset_strip only: the first points.
#define GUSSET_START_GIVEN 2

/// The positions of new vertices.
typedef uint32_t gusset_fairing;
/// New vertices stay where they were first put: those of a strip divide their meridians evenly, as the paper has it,
/// those of a patch lie on the triangles of its first triangulation.
#define GUSSET_FAIRING_NONE 0
/// New vertices are moved so that the new surface bends as a thin plate does and meets the old one smoothly: the sum of
/// the squared Laplacians over them and the rims is least. The rims, and the ends of an open strip, stay where they
/// are.
#define GUSSET_FAIRING_THIN_PLATE 1

/// The treatment of faces that intersect each other.
typedef uint32_t gusset_intersections;
/// Faces of the strip that cut others are looked for, and what can be done about them is done:
/// - a strip of triangles without rows by GUSSET_MERIDIANS_CONTINUATION goes another way where it cuts, and of the
///   strips tried the one that cuts least is kept;
/// - faired rows are taken back in places, up to 12 times, until nothing cuts or nothing is left to take back; if the
///   straight rows cut less in the end, they are kept;
/// - blends are taken back likewise, and made with less fairing where they still cut; the one that cuts least is kept,
///   or the strip if that cuts less than every blend.
/// All other strips stay as they are: rows that are not faired, quads, and other meridians.
#define GUSSET_INTERSECTIONS_AUTO 0
/// They are not looked for: rows are faired in full, and the first blend is kept.
#define GUSSET_INTERSECTIONS_IGNORE 1
/// They are looked for. Faired rows and blends are taken back as with GUSSET_INTERSECTIONS_AUTO, and no strip goes
/// another way, nor does the strip that a blend follows.
#define GUSSET_INTERSECTIONS_REPORT 2

/// The treatment of pieces that are oriented against each other.
typedef uint32_t gusset_orientation;
/// A second piece that is oriented against the first is turned over: the component that rim B is on. Which of the two
/// is inside out is not asked: see GUSSET_OUTWARD_CLOSED for what is closed in the end. Two loops of one connected
/// piece are taken as they are. Whole rims are compared as curves, and by where their surfaces lie if both lead off
/// them to the same side, as at the ends of a U-bend; where nothing is clear, nothing is turned.
#define GUSSET_ORIENTATION_FIX 0
/// Such a piece is GUSSET_ERROR_ORIENTATION_CONFLICT.
#define GUSSET_ORIENTATION_REFUSE 1
/// The rims are not compared: the faces are taken to be right as they are.
#define GUSSET_ORIENTATION_KEEP 2

/// The part of the loops that is joined.
typedef uint32_t gusset_stitch_extent;
/// All of both loops, by a closed band.
#define GUSSET_EXTENT_WHOLE_LOOPS 0
/// The runs of vertices that face the other loop, as the paper has it: GUSSET_ERROR_PLANES_UNDECIDED where it cannot
/// tell.
#define GUSSET_EXTENT_OPEN_ARCS 1
/// Whole loops if their normals make less than 60 degrees, in the mean of cosines, with the line of their centres, or
/// if the planes cannot tell; else open arcs.
#define GUSSET_EXTENT_AUTO 2
/// The arcs given in arc_a and arc_b. Of a loop that is not given, place 0 is where gusset_boundary_get_loop has it.
#define GUSSET_EXTENT_ARCS 3

/// Which of several runs of facing vertices is joined.
typedef uint32_t gusset_facing_run;
/// Of several runs of facing vertices, on each loop the one with the closest pair.
#define GUSSET_RUN_CLOSEST 0
/// On each loop the one of the most vertices.
#define GUSSET_RUN_LONGEST 1

/// The definition of the centre of a loop.
typedef uint32_t gusset_centres;
/// The centre of a loop is the mean of its vertices, as the paper has it.
#define GUSSET_CENTRES_VERTICES 0
/// The mean of its points: vertices that lie close together do not draw it to them.
#define GUSSET_CENTRES_LENGTH 1

/// The number of interior rows.
typedef uint32_t gusset_row_rule;
/// No interior rows: every meridian is one edge.
#define GUSSET_ROWS_NONE 0
/// max(0, round(mean meridian / mean side of the faces of both meshes) - 1), as the paper suggests.
#define GUSSET_ROWS_MEAN_EDGE 1
/// As many as row_count says.
#define GUSSET_ROWS_COUNT 2

/// The faces of strips.
typedef uint32_t gusset_strip_cells;
/// Triangles throughout; quads are split by their shorter diagonals.
#define GUSSET_CELLS_TRIANGLES 0
/// Quads where four different neighbours meet, and triangles where a rim repeats a vertex.
#define GUSSET_CELLS_QUADS 1

/// The surface between the rims.
typedef uint32_t gusset_finish;
/// The strip of meridians, with its rows.
#define GUSSET_FINISH_STRIP 0
/// The best-looking joint: triangles about as fine as those round the rims, graded between them, without sharp angles
/// where the rims allow it, on a surface that leaves both pieces along their tangents. The strip, without rows, says
/// which way it goes: meridians and matrix are its own, and no edges of the result; rows, cells and fairing are not
/// read (the log says so if they are set). Where every blend would cut more faces than the strip does, the strip stays;
/// the log says so. The surface bends as the strip does as a whole, without its ridges: a gap in a tube is bridged by a
/// tube, to within some per cent of its radius across a few radii. Time and memory grow with the number of new
/// triangles. Where sides as short as those round the rims would take more than about 50,000 new vertices, or 16 for
/// each of the rims', the sides are up to twice as long; where that is not enough, the strip stays, and the log says
/// so.
#define GUSSET_FINISH_BLEND 1

/// The source of a tolerance.
typedef uint32_t gusset_tolerance_mode;
/// No tolerance is given, and what rounding can do to the coordinates is taken. For vertices that face another loop
/// that is at most 2^-16 of the loops' largest coordinate for 32-bit positions, 2^-45 for 64-bit ones; for vertices
/// that are welded see gusset_weld_options.
#define GUSSET_TOLERANCE_AUTO 0
/// The tolerance is the one given.
#define GUSSET_TOLERANCE_GIVEN 1
/// The tolerance is 0: of vertices that are welded, the positions are equal.
#define GUSSET_TOLERANCE_EXACT 2

/// The side that closed components of a result face.
typedef uint32_t gusset_outward;
/// As the operation does by default: gusset_join as GUSSET_OUTWARD_CLOSED, all others as GUSSET_OUTWARD_KEEP.
#define GUSSET_OUTWARD_AUTO 0
/// Closed components stay as they are; gusset_orient turns each to the side that most of its faces had.
#define GUSSET_OUTWARD_KEEP 1
/// Closed components face outwards, each by its own volume. A shell within another one encloses its own inside, and the
/// wall of a cavity is turned over too. A component whose volume is 0 up to rounding is as with GUSSET_OUTWARD_KEEP.
/// Except in gusset_orient, only components that are closed (every edge has two faces), consistently oriented and
/// inside out are turned over, each as a whole; all others stay as they are.
#define GUSSET_OUTWARD_CLOSED 2

/// How to stitch; all zero is the default.
typedef struct gusset_stitch_options {
    size_t struct_size;
    gusset_meridians meridians;
    gusset_orientation orientation;
    /// The first meridian joins the closest pair that is not joined by an edge already; with a twist, the vertex of rim
    /// B so many places later, counted in the direction in which rim A runs (negative: earlier), and no other start is
    /// tried. Any value; taken modulo the length of rim B. Must be 0 if arcs are joined (OUT_OF_RANGE), and with
    /// GUSSET_EXTENT_OPEN_ARCS also if there are none to join.
    int64_t twist;
    gusset_stitch_extent extent;
    gusset_facing_run run;
    gusset_row_rule rows;
    /// Interior rows, read for GUSSET_ROWS_COUNT.
    /// @when rows GUSSET_ROWS_COUNT
    uint32_t row_count;
    gusset_strip_cells cells;
    gusset_tolerance_mode tolerance_mode;
    /// How far a vertex must be from its loop's plane to face the other loop, in the unit of the positions, at least 0;
    /// read for GUSSET_TOLERANCE_GIVEN.
    /// @when tolerance_mode GUSSET_TOLERANCE_GIVEN
    double tolerance;
    /// Read for GUSSET_EXTENT_ARCS: the first place on loop A, below its length, and the number of vertices, 1 to its
    /// length. The arc runs along the loop as it was given, and may pass its end.
    uint32_t arc_a[2];
    /// The same on loop B.
    uint32_t arc_b[2];
    gusset_strip_search search;
    gusset_strip_start start;
    /// Read if interior rows are asked for; otherwise the log says that it is not.
    gusset_fairing fairing;
    gusset_intersections intersections;
    gusset_centres centres;
    /// What becomes of closed components of the result, the strip and all.
    gusset_outward outward;
    /// What lies between the rims in the end.
    gusset_finish finish;
    uint32_t reserved;
} gusset_stitch_options;

/* ---- Options of joining: Which borders are joined, and how. */

/// The treatment of coincident borders of pieces.
typedef uint32_t gusset_welding;
/// Coincident borders are sewn, by default up to what rounding can have done; see gusset_weld_options. Where their
/// vertices do not match, edges are split; see gusset_sew.
#define GUSSET_WELDING_SEW 0
/// Nothing is welded.
#define GUSSET_WELDING_NONE 1
/// Coincident borders are sewn where they match vertex by vertex; see gusset_weld.
#define GUSSET_WELDING_EDGE_TO_EDGE 2

/// The widest gap that is closed.
typedef uint32_t gusset_gap;
/// Whole loops are joined if the mean width of the gap is at most a fifth of the larger component's size along an axis,
/// or the mean radius of the smaller loop (the mean distance of its vertices from their centre) if that is more; two
/// loops that are the only ones, of two pieces, whatever it is. Runs of loops are joined where the gap is at most half
/// that radius wide, and four edges of the loop with the longer ones. The width is the mean distance from each loop to
/// the nearest points of the other, the larger of the two. Loops must look at each other, or lie round each other: of
/// all that do, the best one-to-one choice is joined. What sewing left of two borders is joined with itself if it is at
/// most one of its mean edges wide, and half its radius; wider it may be a hole that the seam crosses. Between pieces
/// whose overlaps are trimmed, the gap is at most two and a half mean edges of the coarsest wide, or four where a part
/// would be left alone.
#define GUSSET_GAP_AUTO 0
/// Gaps are closed up to max_gap.
#define GUSSET_GAP_GIVEN 1

/// The treatment of pieces that overlap.
typedef uint32_t gusset_overlaps;
/// Pieces that overlap stay as they are.
#define GUSSET_OVERLAPS_KEEP 0
/// Of each overlap one piece is kept, as gusset_trim_create chooses, and the gaps that this leaves are closed as others
/// are. Strips that would cut other faces are left to the holes.
#define GUSSET_OVERLAPS_TRIM 1

/// Two loops of the input.
typedef struct gusset_loop_pair {
    /// The piece of each.
    uint32_t piece[2];
    /// A vertex of each piece that the loop passes; UINT32_MAX for all loops of the piece, in exclusions only.
    uint32_t vertex[2];
} gusset_loop_pair;

struct gusset_fill_options;

struct gusset_trim_options;

struct gusset_weld_options;

/// How pieces are joined; all zero is the default.
typedef struct gusset_join_options {
    size_t struct_size;
    gusset_welding weld;
    /// GUSSET_ORIENTATION_FIX: within each component the minority of faces is turned over, and components that face
    /// each other are made to agree. GUSSET_ORIENTATION_KEEP: nothing is turned, nor in the end.
    gusset_orientation orientation;
    gusset_gap gap;
    /// 1: only whole loops are joined, no parts of them, nor what sewing left of two borders. 0 or 1.
    /// @flag
    uint32_t whole_loops_only;
    /// 1: loops of one component may be joined without being asked for. 0 or 1.
    /// @flag
    uint32_t within_components;
    /// 1: holes that are left in the end are filled. 0 or 1.
    /// @flag
    uint32_t fill;
    /// Read for GUSSET_GAP_GIVEN: the widest gap that is closed, in the unit of the positions, finite and at least 0; 0
    /// leaves all open.
    /// @when gap GUSSET_GAP_GIVEN
    double max_gap;
    /// Pairs of loops to be joined however wide the gap is, as wholes, or NULL. Each names two different loops, or the
    /// same one twice if sewing left it of two borders (see gusset_joint), and none is named in two pairs. Errors name
    /// a pair by its number from 0, and say what is wrong with it.
    const struct gusset_loop_pair *pairs;
    /// How many.
    size_t pair_count;
    /// Pairs that are not to be joined, or NULL. A pair that is given above is joined all the same, and a vertex that
    /// no loop passes, as it was welded, excludes nothing.
    const struct gusset_loop_pair *excluded;
    /// How many.
    size_t excluded_count;
    /// How to weld; NULL for the defaults.
    const struct gusset_weld_options *weld_options;
    /// The strips, NULL for the defaults: meridians, search, start, rows, row_count, cells, fairing, intersections and
    /// finish are read; the other fields must be valid too.
    const struct gusset_stitch_options *strip_options;
    /// How to fill, NULL for the defaults. groups, outward and plan_only are not read, but the last two must be valid
    /// too; intersections REPORT is as IGNORE.
    const struct gusset_fill_options *fill_options;
    /// The side that closed components of the result face; outwards by default. The wall of a cavity within another
    /// component is turned too. A result that is not turned is mostly as the first piece has it.
    gusset_outward outward;
    /// GUSSET_OVERLAPS_KEEP or GUSSET_OVERLAPS_TRIM.
    gusset_overlaps overlaps;
    /// Read for GUSSET_OVERLAPS_TRIM: how to trim; NULL for the defaults.
    /// @when overlaps GUSSET_OVERLAPS_TRIM
    const struct gusset_trim_options *trim_options;
} gusset_join_options;

/* ---- Joining: reports: What became of each joint and each loop. */

/// The outcome for two loops that face each other.
typedef uint32_t gusset_joint_outcome;
/// A strip joins them.
#define GUSSET_JOINT_JOINED 0
/// Left: joining them would make a one-sided surface with what is joined already.
#define GUSSET_JOINT_ORIENTATION_CONFLICT 1
/// Left: they pass the same vertex.
#define GUSSET_JOINT_SHARE_VERTEX 2
/// Left: every strip would repeat an edge that the mesh already has.
#define GUSSET_JOINT_NO_STRIP 3
/// Left: between pieces whose overlaps were trimmed, as every strip would cut other faces. It is a part of a hole then.
#define GUSSET_JOINT_WOULD_CUT 4

/// The reason why a loop has no strip.
typedef uint32_t gusset_left_reason;
/// There is no other loop.
#define GUSSET_LEFT_ALONE 0
/// It is open, or the faces along it disagree in orientation or are not manifold there.
#define GUSSET_LEFT_NOT_SIMPLE 1
/// It has fewer than three vertices.
#define GUSSET_LEFT_TOO_SHORT 2
/// It faces another loop, but no strip could be made: see the joints.
#define GUSSET_LEFT_NOT_JOINED 3
/// The nearest loop is farther away than is allowed; or the loop is what sewing left of two borders, and its two sides
/// are. See gap and allowed_gap.
#define GUSSET_LEFT_TOO_FAR 4
/// All other loops are of its own component, and within_components is not set.
#define GUSSET_LEFT_SAME_COMPONENT 5
/// The nearest loop is near enough, but they do not look at each other along enough of both.
#define GUSSET_LEFT_LOOKS_AWAY 6
/// The nearest loop is joined with another.
#define GUSSET_LEFT_TAKEN 7
/// It is not to be joined with the nearest loop.
#define GUSSET_LEFT_EXCLUDED 8

/// Where a piece went.
typedef struct gusset_piece_map {
    /// Per vertex of the piece, its index in the result; several may have the same. UINT32_MAX if it was left out.
    struct gusset_indices vertices;
    /// Per face, its index in the result, or UINT32_MAX; of a triangle that was cut, that of the first part, which the
    /// others follow.
    struct gusset_indices faces;
} gusset_piece_map;

/// Two loops, or runs of loops, that face each other across a gap.
/// Of two borders that coincide along a part only, sewing leaves loops that run along the rest of one and back along
/// the other; they turn at two vertices that sewing made of several. Such a loop may be joined with itself: both sides
/// are on it, one of them with both ends, whole is 0, and the strip has no interior rows whatever the options say.
typedef struct gusset_joint {
    /// The vertices of each side in the result, in order; if joined, side by side from the first meridian on. The order
    /// is that of before closed components were turned outwards.
    struct gusset_indices side[2];
    /// The mean width of the gap; of a loop that is joined with itself the mean distance of its sides.
    double gap;
    /// The strip's first new vertex in the result.
    size_t vertex_first;
    /// How many new vertices it has.
    size_t vertex_count;
    /// The strip's first face in the result.
    size_t face_first;
    /// How many faces it has.
    size_t face_count;
    /// Pairs of faces that cut each other, as in gusset_stitch_report.
    struct gusset_indices intersections;
    /// 1 if they were looked for.
    uint32_t intersections_known;
    gusset_joint_outcome outcome;
    /// 1 if both sides are whole loops.
    uint32_t whole;
    /// What the strip is. A blend that was asked for may have had to give way to the strip.
    gusset_finish finish;
} gusset_joint;

/// A boundary loop of the sewn pieces that no strip hangs on. It is listed even if it was filled afterwards: holes says
/// what became of it then.
typedef struct gusset_left_loop {
    /// Its vertices in the result, in order.
    struct gusset_indices vertices;
    /// The mean distance from its vertices to the nearest of the loop that is nearest to most of them, of another
    /// component where there is one; infinite if there is none, or if this loop cannot carry a strip. Of what sewing
    /// left of two borders, whose sides are too far from each other, the mean distance of these.
    double gap;
    /// How far that loop, or that side, may be to be joined; 0 if there is none.
    double allowed_gap;
    gusset_left_reason reason;
    uint32_t reserved;
} gusset_left_loop;

struct gusset_hole;

/// The report of a join. Pointers are valid until the result is destroyed.
typedef struct gusset_join_report {
    size_t struct_size;
    /// One for each piece.
    const struct gusset_piece_map *pieces;
    /// How many.
    size_t piece_count;
    /// The pairs that face each other: those that were given, in their order, then the others, nearest first.
    const struct gusset_joint *joints;
    /// How many.
    size_t joint_count;
    /// The loops that no strip hangs on, by their smallest vertices; those that were filled in the end are among them.
    /// loops_left counts what is open now.
    const struct gusset_left_loop *left;
    /// How many.
    size_t left_count;
    /// The holes that were looked at in the end.
    const struct gusset_hole *holes;
    /// How many.
    size_t hole_count;
    /// The vertices of their rims, in the order of before closed components were turned outwards.
    struct gusset_indices hole_rims;
    /// Faces of the pieces that run the other way than they did in their pieces, by their indices in the result: turned
    /// to agree with others, or with their component to face outwards, but not both. Faces of strips and patches were
    /// nothing before, and are not listed: they run as the faces of pieces beside them do.
    struct gusset_indices turned;
    /// A face of each component that cannot be oriented.
    struct gusset_indices one_sided;
    /// A face of each closed component of the result that encloses no volume up to rounding, as a piece does that is
    /// given twice. Empty with GUSSET_ORIENTATION_KEEP or GUSSET_OUTWARD_KEEP.
    struct gusset_indices zero_volume;
    /// Vertices that became one with another.
    uint32_t welded_vertices;
    /// Edges that were two free edges.
    uint32_t sewn_edges;
    /// Boundary loops of the result.
    uint32_t loops_left;
    /// Edges of the result with three or more faces.
    uint32_t non_manifold_edges;
    /// Points at which free edges were split for borders to match.
    uint32_t splits;
    /// Entries of left that have another loop within the gap that is allowed: those that look away, whose partner is
    /// taken, or that no strip could join.
    uint32_t near_loops_left;
    /// Faces that were trimmed from overlaps.
    uint32_t trimmed_faces;
    uint32_t reserved;
} gusset_join_report;

/* ---- Stitching: Joins two loops by a strip of new faces. */

/// The parts of a stitch. Pointers are valid until the result is destroyed. Index 0 is the first mesh, 1 the second.
typedef struct gusset_stitch_report {
    size_t struct_size;
    /// Per old vertex of each mesh, its index in the result; empty for the second if there was only one mesh.
    struct gusset_indices vertex_map[2];
    /// Per old face, its index in the result.
    struct gusset_indices face_map[2];
    /// The vertices of each rim, by their indices in the result, from the first meridian on, side by side: rim 0 has
    /// its surface on the left, rim 1 on the right, as they were before closed components were turned outwards. They
    /// are also the strip's own first vertices in order: rim 0, then rim 1.
    struct gusset_indices rim[2];
    /// The meridians as places on the rims, i and j by turns, the paper's matrix H: meridian k is (data[2 k], data[2 k
    /// + 1]). They go from (0, 0) to (N, M) for whole rims of N and M vertices, where place N is place 0 again, and to
    /// (N - 1, M - 1) for arcs; count is twice the number of meridians. From one to the next i advances by 1, or j, or
    /// both: by the rule by index and with GUSSET_MERIDIANS_QUAD.
    struct gusset_indices meridians;
    /// The paper's matrix P, row by row from rim 0 to rim 1, one column for each meridian: vertices of the result.
    struct gusset_indices matrix;
    /// Of each new vertex (they are the last ones of the result), three vertices of the rims that it lies between: in a
    /// row the ends of its meridian, that on rim 1 twice; of a blend the corners of the triangle of the strip that it
    /// would be on without fairing.
    struct gusset_indices parents;
    /// How much it has of each of them, three numbers a vertex, at least 0 with sum 1; in row k of r rows 1 - k / (r +
    /// 1), k / (r + 1) and 0. NULL without new vertices.
    const double *weights;
    /// The first of the strip's faces in the result; they are the last ones.
    size_t strip_face_first;
    /// How many there are; N + M triangles for whole rims without interior rows. A blend has as many as it needs, and
    /// meridians and matrix are those of the strip that it follows.
    size_t strip_face_count;
    /// Interior rows; the matrix has two rows more. 0 of a blend.
    uint32_t row_count;
    /// 1 if the strip is a closed band between whole loops, 0 if it joins arcs.
    uint32_t closed;
    /// 1 if the component that rim 1 is on was turned over to agree with the other, else 0: its faces run the other
    /// way, each from its own first corner. Other components stay as they are.
    uint32_t turned;
    /// 1 if faces that cut each other were looked for, else 0.
    uint32_t intersections_known;
    /// Pairs of faces of the result that cut each other, by turns: first one of the strip, the larger one if both are.
    /// What they share, a vertex or an edge, is no cut, nor are vertices and edges at the same place; any other touch
    /// is. Exact. Polygons are taken as triangles: quads split by their shorter diagonals, others as fans from their
    /// first corners; a polygon that cuts itself is paired with itself.
    struct gusset_indices intersections;
    /// How often the fairing, of rows or of the blend that was kept, had to be taken back in places.
    uint32_t back_off_count;
    /// What the strip is. A blend that was asked for may have had to give way to the strip.
    gusset_finish finish;
    /// Faces of the result, those of the strip too, that GUSSET_OUTWARD_CLOSED turned over in the end, ascending. Each
    /// keeps its first corner and has the others in reverse order.
    struct gusset_indices turned_outwards;
} gusset_stitch_report;

/// Joins two boundary loops, of two meshes or of one, by a strip of new faces: a closed band between whole loops, or a
/// strip between the arcs that face each other.
/// The result has the vertices of A, then of B, then new ones in the interior rows; the faces of A, then of B, then the
/// strip. Positions are of the scalar type of A, old ones keep their bits, and every old face is kept. An arc of one
/// vertex gets a fan, which touches its piece at that vertex only; two arcs of one vertex each get one meridian and no
/// face.
/// @param loop_a the vertices of each loop in order, in either direction, each consecutive pair (and the last with the
///     first) an edge with exactly one face. If both are NULL, the loops that lie nearest to each other are taken; if
///     one is, the loop of its mesh that is nearest to the one given. Those to choose from are not open, have three
///     vertices or more, and the faces along them agree in orientation and are manifold there; two of one mesh share no
///     vertex.
/// @param mesh_b NULL if both loops are of mesh_a.
/// @param loop_b see loop_a.
/// @errors as gusset_mesh_view, OUT_OF_RANGE, PLANES_UNDECIDED, NO_LOOP (of one mesh: it has no two that share no
///     vertex), LOOP_TOO_SHORT, LOOP_REPEATS_VERTEX, LOOP_EDGE_NOT_FREE, LOOP_NOT_ORIENTED, LOOPS_SHARE_VERTEX,
///     ORIENTATION_CONFLICT, NO_STRIP, MIXED_SCALARS (A has f32 and B f64 positions), TOO_LARGE
/// @complexity O(H log d) for H half-edges and at most d edges at a vertex; plus for the meridians O(N M) up to 2^21
///     pairs of vertices, beyond that and for the simple rules O((N + M) log M); plus the size of the strip, and
///     fairing and intersection tests where asked for (O(n log n) and a test for each pair of triangles whose boxes
///     overlap, which is all pairs in the worst case); plus, for a blend of n new vertices, O(n log n) and the solution
///     of up to five plates, O(n^1.5) each, nearly linear where the gap is narrow; plus a box test for each pair of
///     loops where the choice is left open. Extra memory is linear in the meshes and the strip; GUSSET_SEARCH_EXACT
///     takes one byte for each of up to 2^26 pairs of vertices and 8 M bytes for each 2^26 pairs begun, with
///     GUSSET_MERIDIANS_CONTINUATION or _SMOOTH 2 bytes for each pair, where the best strip would use an edge twice 8;
///     twice that with more than one thread and two starts.
/// @source Nesterenko, algorithm 2 and the intermediate mesh (H, P). Whole loops repeat their start: N + 1 and M + 1
///     points.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_stitch(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh_a, const struct gusset_indices *loop_a, const struct gusset_mesh_view *mesh_b,
    const struct gusset_indices *loop_b, const struct gusset_stitch_options *options, struct gusset_result **result);

/// Lends the strip of a stitch alone: the vertices of the two rims, the new ones, and the faces between them.
/// @errors as gusset_result_get_stitch
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_strip_mesh(const struct gusset_result *result,
    struct gusset_mesh_view *view);

/// Lends the maps, rims and meridians, for results of gusset_stitch.
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_stitch(const struct gusset_result *result,
    struct gusset_stitch_report *report);

/* ---- Holes: reports: The outcome for each loop. */

/// Weight that the triangulation of a hole minimises.
typedef uint32_t gusset_fill_weight;
/// Best continuation of the surrounding surface: the area if the rim is planar, otherwise the sum of
/// - 2 sin(t / 2) over all edges, the rim included, for angles t between normals;
/// - the mean squared distance of the triangles from the missing surface, estimated from the tangent planes at the rim,
///   in units of 1/140 of its length.
#define GUSSET_WEIGHT_CONTINUATION 0
/// Sum of the areas and, over all edges, the rim included, squared length times 1 - cosine of the angle between the
/// normals.
#define GUSSET_WEIGHT_AREA_AND_BEND 1
/// Largest angle between neighbouring faces, old faces at the rim included; then the area.
#define GUSSET_WEIGHT_BEND_THEN_AREA 2
/// Area, minimised exactly for a single loop of at most 128 vertices.
#define GUSSET_WEIGHT_AREA 3

/// Vertices of a patch.
typedef uint32_t gusset_patch_finish;
/// Rim vertices only.
#define GUSSET_PATCH_PLAIN 0
/// New vertices on the plain triangles, except beside creases that continue.
#define GUSSET_PATCH_REFINED 1
/// New vertices, faired.
#define GUSSET_PATCH_FAIRED 2

/// Outcome for one loop.
typedef uint32_t gusset_hole_status;
/// Filled; with plan_only, to be filled.
#define GUSSET_HOLE_FILLED 0
/// Left open: keep excludes it.
#define GUSSET_HOLE_KEPT 1
/// Left open: it exceeds max_edges, max_length, max_diameter or max_area.
#define GUSSET_HOLE_TOO_LARGE 2
/// Left open: it is an open chain.
#define GUSSET_HOLE_OPEN 3
/// Left open: it runs along an edge with three or more faces.
#define GUSSET_HOLE_NON_MANIFOLD 4
/// Left open: the faces along it disagree in orientation.
#define GUSSET_HOLE_NOT_ORIENTED 5
/// Left open: a given loop has fewer than three vertices, or passes a vertex twice.
#define GUSSET_HOLE_NOT_SIMPLE 6
/// Left open: an edge of a given loop does not have exactly one face, or belongs to an earlier loop.
#define GUSSET_HOLE_NOT_FREE 7
/// Left open: every triangulation has an edge between two vertices of one old face, or no shared patch was found.
#define GUSSET_HOLE_NO_TRIANGULATION 8

/// Report on one loop.
typedef struct gusset_hole {
    /// First vertex of the loop in rims, with the surface on the left before closed components were turned outwards. A
    /// given loop that is not simple, free or oriented is as given.
    size_t rim_first;
    /// Number of its vertices.
    size_t rim_count;
    /// First face of the patch in the result. Loops that share a patch have the same faces and vertices.
    size_t face_first;
    /// Number of its faces.
    size_t face_count;
    /// First new vertex of the patch in the result.
    size_t vertex_first;
    /// Number of these.
    size_t vertex_count;
    /// Length of the loop.
    double length;
    /// Diagonal of the axis-aligned box of the loop.
    double diameter;
    /// Area of the triangles from the edges of the loop to the mean of its vertices: the area of a planar convex hole,
    /// more for others.
    double area;
    gusset_hole_status status;
    /// Weight of the triangulation: as requested, or one with fewer intersections.
    gusset_fill_weight weight;
    /// Finish of the patch: as requested, or simpler with fewer intersections.
    gusset_patch_finish finish;
    /// Number of the patch, from 0, in the order of faces; equal for loops that share it. UINT32_MAX: no patch, always
    /// with plan_only.
    uint32_t patch;
} gusset_hole;

/// Reports on all loops.
typedef struct gusset_fill_report {
    size_t struct_size;
    /// Each given loop, or all loops as gusset_boundary_get_loop numbers them.
    const struct gusset_hole *holes;
    /// Number of loops.
    size_t hole_count;
    /// Vertices of all loops.
    struct gusset_indices rims;
    /// Three rim vertices for each new vertex, in the order of the new vertices.
    struct gusset_indices parents;
    /// Weights of the parents, at least 0, with sum 1 for each new vertex. They give its nearest point on the plain
    /// triangulation of the rims: the vertex itself if its patch is flat, or is not faired and not creased.
    const double *weights;
    /// Pairs of intersecting faces, ascending, the larger index first: a new face. Every contact counts, decided
    /// exactly, except at shared or coincident vertices and edges.
    struct gusset_indices intersections;
    /// Faces that GUSSET_OUTWARD_CLOSED turned over, ascending. Each keeps its first corner; the others are reversed.
    struct gusset_indices turned_outwards;
    /// 1 if intersections were looked for, otherwise 0.
    uint32_t intersections_known;
    uint32_t reserved;
} gusset_fill_report;

/* ---- Holes: Closes holes by new triangles. */

/// Loops that are not holes.
typedef uint32_t gusset_fill_keep;
/// All loops are holes.
#define GUSSET_KEEP_NONE 0
/// The longest loop (the first of equals), as the outline of a sheet.
#define GUSSET_KEEP_LONGEST 1
/// Outer borders of sheets, which a patch would cover: loops whose area vector has a positive dot product with their
/// component's, and a length of at least half the component's area.
#define GUSSET_KEEP_BORDERS 2

/// Loops that share a patch.
typedef uint32_t gusset_fill_together;
/// Each loop gets its own patch.
#define GUSSET_TOGETHER_APART 0
/// All filled loops share one patch of genus 0. If they are not coplanar, the limit is about 160 loops.
#define GUSSET_TOGETHER_ONE 1
/// Loops share a patch where it has less weight than separate patches.
/// - Tried are pairs whose boxes overlap after each grows on all sides by half its diagonal, about 8 for each loop and
///   256 in all (the log says if exceeded).
/// - The pair with the largest relative gain comes first. A patch has at most 16 loops.
/// - With GUSSET_WEIGHT_AREA, the ends of a short tube share a patch along the tube.
#define GUSSET_TOGETHER_CHEAPEST 2

/// New vertices of patches.
typedef uint32_t gusset_fill_refinement;
/// No new vertices.
#define GUSSET_REFINE_NONE 0
/// New vertices as dense as the vertices around the hole.
#define GUSSET_REFINE_RIM_DENSITY 1

/// Smoothness between faired patches and the old surface.
typedef uint32_t gusset_fill_continuity;
/// Tangent continuity: fairing minimises the squared Laplacian.
#define GUSSET_CONTINUITY_C1 0
/// Curvature continuity: fairing minimises the squared gradient of the Laplacian. Two rings of old faces around each
/// rim, with their noise, determine the curvature.
#define GUSSET_CONTINUITY_C2 1

/// Options of gusset_fill. Default: all holes, without new vertices.
typedef struct gusset_fill_options {
    size_t struct_size;
    gusset_fill_weight weight;
    gusset_fill_refinement refine;
    /// Fairing of new vertices. Without new vertices it is ignored, and the log says so.
    gusset_fairing fairing;
    /// Loops that stay open. Read only if all loops are selected.
    gusset_fill_keep keep;
    /// Treatment of patch faces that intersect each other or old faces: GUSSET_INTERSECTIONS_AUTO avoids them, REPORT
    /// reports them, IGNORE does not look for them.
    gusset_intersections intersections;
    /// If 1, fills and turns over nothing. The report says which loops would be filled, by which weight and finish. It
    /// does not predict failed triangulations or shared patches.
    /// @flag
    uint32_t plan_only;
    /// Approximate limit on the new vertices of a patch, kept by larger triangles, exceeded at most twofold. 0: 50,000,
    /// or 4 for each rim vertex if more, and as many again for sharp angles there.
    uint32_t max_new_vertices;
    /// Most edges of a loop to fill. 0: no limit.
    uint32_t max_edges;
    /// Largest length of a loop to fill, at least 0. 0: no limit.
    double max_length;
    /// Largest diagonal of the axis-aligned box of a loop to fill, at least 0. 0: no limit.
    double max_diameter;
    /// Largest area, as in gusset_hole, of a loop to fill, at least 0. 0: no limit.
    double max_area;
    /// Orientation of closed components of the result, patches included.
    gusset_outward outward;
    /// Choice of loops that share a patch. Read only without groups.
    gusset_fill_together together;
    /// Group number of each given loop, loop_count in all. Loops with equal numbers share a patch of genus 0, without
    /// loops left open for their own reasons. NULL: see together.
    const uint32_t *groups;
    gusset_fill_continuity continuity;
    /// If 1, creases of the old surface end at the rim.
    /// @flag
    uint32_t ignore_creases;
} gusset_fill_options;

/// Fills holes of a mesh: closes boundary loops by triangles, oriented like the surrounding surface.
/// Loops that cannot be filled stay open; gusset_hole gives the reason. The result has the old vertices, with their
/// bits, then the new ones; the old faces, then the new triangles, hole by hole.
/// - No new edge joins two vertices of one old face: a closed result stays closed when its polygons are triangulated.
/// - With the default weight or GUSSET_WEIGHT_AREA, a planar hole, even with islands, gets no overlapping triangles if
///   its rims do not cross.
/// - In a patch of one loop, creases of the old surface continue: matching pairs are joined, three or more meet in a
///   new vertex. Without new vertices, only straight pairs are joined. Other creases end at the rim.
/// - Loops of a shared patch stay open if two of them share a vertex or the search, which is not exhaustive, fails.
///   GUSSET_TOGETHER_CHEAPEST gives them separate patches.
/// - A patch that intersects itself or other faces, by an exact test, is retried with less fairing, other weights and
///   no new vertices. The one with the fewest intersections is kept.
/// - Faired vertices stay in the box of the rims, grown on all sides by half its diagonal.
/// @param loops vertices of each loop in order, in either direction. Consecutive vertices, and the last and the first,
///     form an edge with exactly one face. NULL with loop_count 0: all loops.
/// @errors as gusset_mesh_view, INDEX_OUT_OF_RANGE (input of the report is the loop, index the place in it),
///     NULL_ARGUMENT (groups without loops), OUT_OF_RANGE, TOO_LARGE
/// @complexity O(n^3) time, 30 n^2 bytes for a loop of n <= 128 vertices. Otherwise linear memory: O(n), coarse to
///     fine; planar O(n log n); shared patches O(n log n) for few loops, O(n^3) for many. Also O(H log d) for H
///     half-edges, at most d at a vertex, O(m^1.5) for m new vertices of a hole, and O(n log n), at worst O(n^2), for
///     intersections with n faces near holes.
/// @source Barequet and Sharir 1995; Liepa, Filling holes in meshes, 2003.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_fill(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_indices *loops, size_t loop_count,
    const struct gusset_fill_options *options, struct gusset_result **result);

/// Lends the report on each loop, for a result of gusset_fill.
/// @errors WRONG_HANDLE (a result of another operation)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_fill(const struct gusset_result *result,
    struct gusset_fill_report *report);

/* ---- Strips: Builds a strip of triangles between two polylines that belong to no mesh. */

/// How a strip is made; all zero is the default.
typedef struct gusset_strip_options {
    size_t struct_size;
    gusset_meridians meridians;
    gusset_strip_search search;
    /// For closed polylines; open ones begin at their first points.
    gusset_strip_start start;
    /// 1: the polylines are closed; 0: they are open.
    /// @flag
    uint32_t closed;
    /// The mean edge is the mean segment of both polylines.
    gusset_row_rule rows;
    /// Interior rows, read for GUSSET_ROWS_COUNT.
    /// @when rows GUSSET_ROWS_COUNT
    uint32_t row_count;
    gusset_strip_cells cells;
    uint32_t reserved;
} gusset_strip_options;

/// The parts of a strip. Pointers are valid until the result is destroyed.
typedef struct gusset_strip_report {
    size_t struct_size;
    /// The points of A and of B that the first meridian joins.
    uint32_t start[2];
    /// The meridians as places counted from there, i and j by turns: from (0, 0) to (N, M) for closed polylines of N
    /// and M points, where place N is place 0 again, and to (N - 1, M - 1) for open ones; count is twice the number of
    /// meridians.
    struct gusset_indices meridians;
    /// The paper's matrix P, row by row from A to B, one column for each meridian: vertices of the mesh.
    struct gusset_indices matrix;
    /// Of each new vertex (they are the last ones of the mesh), the two that it lies between, on A and on B, by turns:
    /// the ends of its meridian.
    struct gusset_indices parents;
    /// Of each new vertex, the weight of its second parent, 0 to 1: in row k of r rows k / (r + 1).
    const double *weights;
    /// Interior rows; the matrix has two rows more. 0 where there is one meridian alone, and no face.
    uint32_t row_count;
    uint32_t reserved;
} gusset_strip_report;

/// Makes a strip of faces between two polylines that run side by side, as gusset_stitch does between two rims: the
/// third, intermediate mesh alone.
/// The mesh has the points of A, 0 to N - 1, then those of B, then the new ones row by row. Faces run A_i+1, A_i, B_j:
/// against polyline A, and along B. Where both sides advance at once triangles split a quad by its shorter diagonal.
/// @param points_a x, y, z of the points in order, packed, count_a and count_b of them: at least 1 each, closed ones at
///     least 3, and the last point is not the first again.
/// @param count_a see points_a.
/// @param points_b see points_a.
/// @param count_b see points_a.
/// @param options NULL for the defaults (open polylines).
/// @errors LOOP_TOO_SHORT, TOO_LARGE, NOT_FINITE, NO_STRIP
/// @complexity Time and memory of the meridians of gusset_stitch, and linear in the mesh.
/// @source Nesterenko, the intermediate mesh (H, P); Fuchs, Kedem and Uselton (1977) for the best strips.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_strip(const struct gusset_context *context, const double *points_a,
    size_t count_a, const double *points_b, size_t count_b, const struct gusset_strip_options *options,
    struct gusset_result **result);

/// Lends the meridians and the matrix, for results of gusset_strip.
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_strip(const struct gusset_result *result,
    struct gusset_strip_report *report);

/* ---- Welding: Merges coincident vertices. */

/// Vertices that are welded.
typedef uint32_t gusset_weld_vertices;
/// Ends of boundary edges: coincident borders are sewn edge to edge.
#define GUSSET_WELD_BOUNDARY 0
/// All vertices that faces use, for triangle soups.
#define GUSSET_WELD_ALL 1

/// Treatment of coincident corners of one face.
typedef uint32_t gusset_collapse;
/// Corners of one face stay apart.
#define GUSSET_COLLAPSE_NEVER 0
/// Corners of one face may be merged. A face left with fewer than three different vertices is dropped.
#define GUSSET_COLLAPSE_ALLOW 1

/// Treatment of vertices that no face uses.
typedef uint32_t gusset_unused;
/// Unused vertices stay.
#define GUSSET_UNUSED_KEEP 0
/// Vertices that no face of the result uses are removed.
#define GUSSET_UNUSED_REMOVE 1

/// Options of gusset_weld and gusset_sew.
typedef struct gusset_weld_options {
    size_t struct_size;
    gusset_weld_vertices vertices;
    /// Distance at which vertices coincide.
    /// - GUSSET_TOLERANCE_GIVEN: at most tolerance.
    /// - GUSSET_TOLERANCE_EXACT: 0; -0 equals 0.
    /// - GUSSET_TOLERANCE_AUTO: at most 2^-19 of the largest coordinate for 32-bit positions, 2^-48 for 64-bit ones,
    ///   or, if more, twice the last decimal place that positions show. At each vertex it is at most a quarter of the
    ///   shortest edge, so that no edge collapses.
    /// - Last decimal place: let D be the largest power of ten up to the longest side of the box of the vertices. The
    ///   place is the largest of 1e-5 D, 1e-6 D, ... of which a third of the coordinates of the largest order of
    ///   magnitude, or of the differences between consecutive vertices, are multiples. Multiples of 1e-4 D are left
    ///   out; at least eight other numbers are needed.
    gusset_tolerance_mode tolerance_mode;
    /// Largest distance of coincident vertices, finite, at least 0.
    /// @when tolerance_mode GUSSET_TOLERANCE_GIVEN
    double tolerance;
    gusset_collapse collapse;
    gusset_unused unused;
} gusset_weld_options;

/// Effects of welding. Indices are of the old mesh, and lists ascending.
typedef struct gusset_weld_report {
    size_t struct_size;
    /// Index of each old vertex in the result; UINT32_MAX if removed as unused.
    struct gusset_indices vertex_map;
    /// Index of each old face in the result; UINT32_MAX if dropped.
    struct gusset_indices face_map;
    /// Half-edges of boundary edges that coincide with another edge and were not sewn to it. Three or more coincide, or
    /// sewing would collapse a face or put three or more faces at an edge.
    struct gusset_indices left_edges;
    /// Vertices that coincide with another and were not merged with it.
    struct gusset_indices left_vertices;
    /// Number of vertices merged into a smaller one.
    uint32_t welded_vertices;
    /// Number of edges with two faces made from two boundary edges.
    uint32_t sewn_edges;
    /// Number of dropped faces.
    uint32_t dropped_faces;
    uint32_t reserved;
    /// Largest distance at which vertices coincide, except at short edges; 0 for equal positions.
    double tolerance;
} gusset_weld_report;

/// Merges coincident vertices.
/// - By default, borders are sewn: where exactly two boundary edges coincide, in either direction, they and their ends
///   become one.
/// - Edges stay apart, and are listed, where three or more coincide or sewing would collapse a face or put three or
///   more faces at an edge: a manifold stays a manifold.
/// - Coincident vertices without an edge to sew stay apart, as where two holes touch.
/// - With GUSSET_WELD_ALL, all coincident vertices are merged, regardless of edges.
/// - In ascending order, each unclaimed vertex claims the unclaimed vertices within the tolerance, nearest first.
///   Merging does not chain.
/// - The result has the old faces in order, each from its own first corner, and the remaining vertices in order. Among
///   merged vertices the smallest remains, with its position bits. A result without faces is not a valid input.
/// @errors as gusset_mesh_view, OUT_OF_RANGE (the tolerance)
/// @complexity O(H log H) for H half-edges, if valences are small and few corners of one face coincide; linear memory.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_weld(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_weld_options *options, struct gusset_result **result);

/// Lends the maps, lists and counts, for a result of gusset_weld.
/// @errors WRONG_HANDLE (a result of another operation)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_weld(const struct gusset_result *result,
    struct gusset_weld_report *report);

/* ---- Sewing: Joins coincident borders, also where their vertices do not match. */

/// Effects of sewing. Lists are ascending.
typedef struct gusset_sew_report {
    size_t struct_size;
    /// Index of each old vertex in the result; UINT32_MAX if removed as unused.
    struct gusset_indices vertex_map;
    /// Index in the result of the first part of each old face; UINT32_MAX if dropped.
    struct gusset_indices face_map;
    /// Old face of each face of the result.
    struct gusset_indices face_origin;
    /// Old vertices that coincide with another, or lie inside a boundary edge, and were not sewn to it.
    struct gusset_indices left_vertices;
    /// Number of vertices merged into a smaller one.
    uint32_t welded_vertices;
    /// Number of edges with two faces made from boundary edges or parts of them.
    uint32_t sewn_edges;
    /// Number of points at which boundary edges were split.
    uint32_t splits;
    /// Number of old faces that were cut or gained corners.
    uint32_t split_faces;
    /// Number of dropped old faces.
    uint32_t dropped_faces;
    uint32_t reserved;
    /// Largest distance at which elements coincide, except at short edges; 0 for equal positions.
    double tolerance;
} gusset_sew_report;

/// Sews coincident borders, also where their vertices do not match.
/// - Vertices are welded as by gusset_weld.
/// - Where a vertex of one border then lies inside a boundary edge of another (a T-junction), the edge is split if
///   exactly two pieces coincide. Triangles with split edges are cut into triangles, none turned over; larger faces
///   gain corners.
/// - Borders are welded again.
/// - A vertex lies inside an edge if it is within the tolerance of the edge and not of its ends. The edge must be
///   longer than twice the tolerance; see gusset_weld_options for its default.
/// - Splitting makes no edges with three or more faces and no degenerate faces.
/// - The result has the old faces in order, or their parts in their places. Among merged vertices the smallest remains,
///   with its position bits. New vertices have the position of an old one.
/// @param options as for gusset_weld. GUSSET_WELD_ALL welds all vertices before edges are split, borders afterwards.
/// @errors as gusset_weld, TOO_LARGE (the result)
/// @complexity O(H log H) for H half-edges, if valences are small and few vertices lie inside each edge; linear memory.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sew(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_weld_options *options, struct gusset_result **result);

/// Lends the maps, lists and counts, for a result of gusset_sew.
/// @errors WRONG_HANDLE (a result of another operation)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_sew(const struct gusset_result *result,
    struct gusset_sew_report *report);

/* ---- Orientation: Turns faces over until neighbours agree. */

/// Options of gusset_orient.
typedef struct gusset_orient_options {
    size_t struct_size;
    /// Orientation of closed components.
    gusset_outward outward;
    uint32_t reserved;
} gusset_orient_options;

/// Faces that were turned over, and components that cannot be oriented.
typedef struct gusset_orient_report {
    size_t struct_size;
    /// For each face, 1 if it was turned over, otherwise 0.
    const uint8_t *turned;
    /// Number of faces.
    size_t face_count;
    /// Smallest face of each non-orientable component, ascending.
    struct gusset_indices one_sided_faces;
    /// For each non-orientable component, a half-edge at which its faces cannot agree.
    struct gusset_indices one_sided_half_edges;
    /// Number of faces turned over.
    uint32_t turned_faces;
    /// Number of components: faces connected across edges with two faces. A degenerate face is a component.
    uint32_t component_count;
    /// Number of closed components that face outwards only because of GUSSET_OUTWARD_CLOSED.
    uint32_t inverted_components;
    uint32_t reserved;
} gusset_orient_report;

/// Turns faces over until the two faces of each edge run it in opposite directions.
/// In each component the fewest faces are turned; on a tie, its smallest face stays. Edges with three or more faces
/// connect nothing. A non-orientable component, such as a Moebius strip, stays unchanged and is listed. A turned face
/// keeps its first corner; the others are reversed. Vertices and the order of faces do not change.
/// @errors as gusset_mesh_view
/// @complexity O(H log d) for H half-edges and at most d edges at a vertex; linear memory.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_orient(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_orient_options *options, struct gusset_result **result);

/// Lends the flags, lists and counts, for a result of gusset_orient.
/// @errors WRONG_HANDLE (a result of another operation)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_orient(const struct gusset_result *result,
    struct gusset_orient_report *report);

/* ---- Alignment: Finds the rigid poses at which overlapping pieces fit. */

/// The poses in which pieces begin.
typedef uint32_t gusset_alignment_start;
/// The pieces begin where their positions say, or where poses move them if these are given.
#define GUSSET_ALIGN_AS_GIVEN 0
/// Each piece begins with its principal axes on those of the first one, in the one of the four ways to do so after
/// which most of it lies on the first. For pieces that show the same object whole.
#define GUSSET_ALIGN_PRINCIPAL_AXES 1
/// The pieces are put together by rims that run alike, and it is their rims that hold them then: for pieces of one
/// surface that was cut or broken and do not overlap.
#define GUSSET_ALIGN_RIMS 2

/// Whether the pose of a piece can be trusted, and if not why.
typedef uint32_t gusset_aligned_reason;
/// It can be trusted to lie right: it fits pieces that can be trusted, up to the first one. What fits is judged by mean
/// edges: a smooth surface that lies within one of another, as a slightly scaled one or its mirror image may, passes
/// for it. The rms of its overlaps, and converged, say more. Pieces that hold each other fast, but could slide together
/// along the rest, pass, too.
#define GUSSET_ALIGNED_TRUSTED 0
/// It has no faces with an area, or too little of it lies on other pieces.
#define GUSSET_ALIGNED_NO_OVERLAP 1
/// Where it is near others, too much of it lies off them.
#define GUSSET_ALIGNED_POOR_FIT 2
/// The overlaps leave it free to slide or to turn, as planes, spheres or cylinders do.
#define GUSSET_ALIGNED_UNDETERMINED 3
/// Most of what lies on other pieces faces the other way: it is inside out, or mirrored.
#define GUSSET_ALIGNED_FACES_OTHER_WAY 4
/// It lies on no other piece, and is more than fifty times as large or small as the first one: its unit of length is
/// another, most likely.
#define GUSSET_ALIGNED_OTHER_SIZE 5
/// It fits pieces that cannot be trusted only.
#define GUSSET_ALIGNED_TRUSTED_BY_NONE 6

/// How pieces are aligned; all zero is the default.
typedef struct gusset_alignment_options {
    size_t struct_size;
    /// Where the pieces begin.
    gusset_alignment_start start;
    /// So many points of each piece are looked for on the others; 0: 2,000.
    uint32_t samples;
    /// Read for GUSSET_ALIGN_AS_GIVEN: motions of the pieces, rotations and translations, or NULL.
    const struct gusset_transform *poses;
    /// Their number: that of the pieces, or 0.
    size_t pose_count;
    /// Points that are farther than this from another piece are no pair with it, in the unit of the positions, finite
    /// and at least 0; 0: a tenth of the diagonal of the largest piece's box. Pieces may begin that far from where they
    /// belong, or a little less.
    double max_distance;
    /// Rounds at the most, in each of two stages; 0: 100.
    uint32_t max_rounds;
    uint32_t reserved;
} gusset_alignment_options;

/// One piece, aligned.
typedef struct gusset_aligned_piece {
    /// Takes the piece's positions to their new places: a rotation and a translation.
    struct gusset_transform pose;
    /// How well the overlaps hold it, from 0 to 1: by how much the motion of length 1 that changes the distances of
    /// pairs least changes them, as a root of a mean square; turns count in radii of the piece. Of the first piece 1.
    double hold;
    gusset_aligned_reason reason;
    uint32_t reserved;
} gusset_aligned_piece;

/// What two pieces have in common where they lie in the end.
typedef struct gusset_overlap {
    /// The pieces, the smaller number first.
    uint32_t pieces[2];
    /// The shares of their points that lie on the other, within a mean edge of it; 0 to 1.
    double shares[2];
    /// The mean distance of these from the other's surface, in the unit of the positions.
    double mean;
    /// The root of the mean square.
    double rms;
    /// The share of the points within eight mean edges of the other piece that lie on it, 0 to 1.
    double fit;
    /// Of how many points this is known.
    uint32_t count;
    /// 1: they fit, as at least 30 points lie on each other and fit is at least two thirds. 0 or 1.
    uint32_t trusted;
} gusset_overlap;

/// Where pieces lie. Pointers are valid until it is destroyed.
typedef struct gusset_alignment_view {
    size_t struct_size;
    /// The pieces, in their order.
    const struct gusset_aligned_piece *pieces;
    /// How many.
    size_t piece_count;
    /// The pairs with anything in common.
    const struct gusset_overlap *overlaps;
    /// How many.
    size_t overlap_count;
    /// Rounds that were done.
    uint32_t rounds;
    /// 1: nothing moved any more in the end; 0: the rounds were not enough.
    uint32_t converged;
} gusset_alignment_view;

/// Where pieces that overlap belong. Opaque and immutable; it keeps nothing of them.
typedef struct gusset_alignment gusset_alignment;

/// Finds where pieces that overlap belong: rigid motions after which they fit, all at once, so that no error adds up
/// round a ring of them. The first piece stays.
/// Points of each piece look for the nearest ones on the others, those beyond a border of the other apart and those
/// whose normals differ by more than 45 degrees; the motions that bring pairs onto the planes of their normals, with
/// less weight for those far off, are found in one system of equations; and so on until nothing moves. Pieces have to
/// begin within max_distance of where they belong, see start. A piece that lies on no other stays where it begins;
/// where overlaps leave it free it may slide.
/// What is not known is no failure, but said for each piece: a piece is trusted if it fits others, overlaps hold it in
/// all six directions by more than the noise of normals, and pieces lead from it to the first one by pairs that fit.
/// @param pieces piece_count mesh views one after another, each as large as the first one's struct_size says, at least
///     one.
/// @param piece_count see pieces.
/// @errors as gusset_mesh_view (the report's input is the piece), EMPTY_MESH (without pieces), OUT_OF_RANGE
///     (max_distance; or a pose that is no rotation and translation, whose number is the report's index), COUNT_DIFFERS
///     (fewer poses than pieces), TOO_LARGE
/// @complexity O(V log V) for V vertices of a piece, and O(samples log V) for each piece and each one near it in each
///     round, of which 10 to 30 are common; with GUSSET_ALIGN_RIMS 512^2 for each two pieces. Linear extra memory.
/// @source P. Besl and N. McKay (1992); Y. Chen and G. Medioni (1992); G. Turk and M. Levoy (1994); P. Neugebauer
///     (1997); S. Rusinkiewicz, A symmetric objective function for ICP (2019).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_alignment_create(const struct gusset_context *context,
    const struct gusset_mesh_view *pieces, size_t piece_count, const struct gusset_alignment_options *options,
    struct gusset_alignment **alignment);

/// Destroys an alignment; NULL is allowed.
GUSSET_API void gusset_alignment_destroy(struct gusset_alignment *alignment);

/// Lends the poses and what is known of them.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_alignment_get_view(const struct gusset_alignment *alignment,
    struct gusset_alignment_view *view);

/* ---- Trimming: Keeps one piece of each overlap. */

/// How pieces that overlap are trimmed; all zero is the default.
typedef struct gusset_trim_options {
    size_t struct_size;
    /// Surfaces that are no farther apart than this are one, in the unit of the positions, finite and at least 0; 0:
    /// four mean edges of the coarser of two pieces.
    double max_distance;
    /// Surfaces whose normals differ by more are two, in radians, from 0 and below pi / 2; 0: 60 degrees.
    double max_angle;
    /// x, y, z of the place that each piece was seen from, in the unit of the positions, or NULL: what was seen under a
    /// flat angle counts for less.
    const double *viewpoints;
    /// Their number: that of the pieces, or 0.
    size_t viewpoint_count;
    /// What has fewer faces is no surface; 0: 30. Parts of twenty times as many go where others show the same, and as
    /// small holes do not come about.
    uint32_t min_faces;
    uint32_t reserved;
} gusset_trim_options;

/// The faces of a piece that are kept.
typedef struct gusset_trimmed_piece {
    /// Ascending.
    struct gusset_indices kept;
    /// How many of the piece's vertices lie on another piece.
    size_t covered_vertices;
} gusset_trimmed_piece;

/// What is left of pieces. Pointers are valid until it is destroyed.
typedef struct gusset_trim_view {
    size_t struct_size;
    /// One for each piece.
    const struct gusset_trimmed_piece *pieces;
    /// How many.
    size_t piece_count;
    /// Faces that cut some of an earlier piece after all else; they went, with those round them.
    uint32_t crossings;
    uint32_t reserved;
} gusset_trim_view;

/// What is left of pieces that overlap. Opaque and immutable; it keeps nothing of them.
typedef struct gusset_trim gusset_trim;

/// Chooses what is kept of pieces that overlap: of each overlap one piece, with a narrow gap to the others, which
/// gusset_join closes; see GUSSET_OVERLAPS_TRIM there for both at once.
/// The pieces are cut along lines on which both are equally good. A vertex is the better the farther it is from the
/// borders of its piece, in mean edges of it, so that the finer of two pieces counts for more, and the less flat the
/// angle it was seen under, if viewpoints are given; loops of fewer than 32 vertices are small holes and no borders in
/// that sense. A vertex lies on another piece if the nearest place there is near, faces the same way, and is on no
/// border. Where two are equally good but for noise, the earlier one is kept. No vertex moves, and no face is cut. What
/// would be thinner than two faces goes, so do small islands, faces that hang on others by one vertex, and faces that
/// cut those of an earlier piece.
/// @param pieces piece_count mesh views one after another, each as large as the first one's struct_size says, at least
///     one, all in one coordinate system; see gusset_alignment_create.
/// @param piece_count see pieces.
/// @errors as gusset_mesh_view (the report's input is the piece), EMPTY_MESH (without pieces), OUT_OF_RANGE
///     (max_distance, max_angle), NOT_FINITE (a viewpoint), COUNT_DIFFERS (fewer viewpoints than pieces), TOO_LARGE
/// @complexity O(V log F) for V vertices of a piece and F faces of each piece near it, and up to the square of the
///     number of faces that lie in one place; linear extra memory.
/// @source The idea is that of G. Turk and M. Levoy, Zippered polygon meshes from range images (1994), who clip one
///     mesh at the other's border.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_trim_create(const struct gusset_context *context,
    const struct gusset_mesh_view *pieces, size_t piece_count, const struct gusset_trim_options *options,
    struct gusset_trim **trim);

/// Destroys what is left of pieces; NULL is allowed.
GUSSET_API void gusset_trim_destroy(struct gusset_trim *trim);

/// Lends which faces are kept.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_trim_get_view(const struct gusset_trim *trim,
    struct gusset_trim_view *view);

/* ---- Boundary loops: Finds the boundary loops of a mesh, and reports defects. */

/// Treatment of edges with three or more faces.
typedef uint32_t gusset_non_manifold;
/// Each face at the edge has its own border there; loops along it are always closed.
#define GUSSET_NON_MANIFOLD_CUT 0
/// Only edges with exactly one face belong to loops. At other edges loops end, as open chains.
#define GUSSET_NON_MANIFOLD_STOP 1

/// Part of the mesh that is checked.
typedef uint32_t gusset_survey;
/// Every edge: all defects are reported, and flagged on the loops.
#define GUSSET_SURVEY_WHOLE_MESH 0
/// The boundary only, many times faster. The whole mesh is checked only if the boundary is open, touches itself, is not
/// oriented or has edges with three faces.
/// Other defects are not reported. Edges with equally many faces in both directions, two or more, do not cut loops.
/// The search relies on hashes. It fails on ordinary meshes with a probability below 2^-64, but a malicious mesh may
/// hide a boundary: for untrusted meshes, use GUSSET_SURVEY_WHOLE_MESH.
#define GUSSET_SURVEY_BOUNDARY_ONLY 1

/// Properties of a loop.
/// @bits
typedef uint32_t gusset_loop_flags;
/// The loop is an open chain, with one vertex more than edges.
#define GUSSET_LOOP_OPEN 1
/// The loop passes a vertex where the surface touches itself.
#define GUSSET_LOOP_BOW_TIE 2
/// The loop was cut from a longer walk at a vertex that the walk passes twice.
#define GUSSET_LOOP_SPLIT 4
/// The loop runs along, or ends at, an edge with three or more faces.
#define GUSSET_LOOP_NON_MANIFOLD 8
/// The faces along the loop disagree in orientation.
#define GUSSET_LOOP_NOT_ORIENTED 16
/// The loop has an edge of length 0.
#define GUSSET_LOOP_ZERO_LENGTH 32

/// The loop runs this edge against its face.
#define GUSSET_EDGE_REVERSED 1
/// The edge has three or more faces.
#define GUSSET_EDGE_NON_MANIFOLD 2
/// The edge has length 0.
#define GUSSET_EDGE_ZERO_LENGTH 4

/// Kind of a defect.
typedef uint32_t gusset_defect_kind;
/// A face (index) repeats a vertex (other).
#define GUSSET_DEFECT_DEGENERATE_FACE 1
/// The two faces of an edge run it in the same direction: half-edges index and other.
#define GUSSET_DEFECT_ORIENTATION_CONFLICT 2
/// An edge has three or more half-edges: index is the first, count their number. A face may count twice.
#define GUSSET_DEFECT_NON_MANIFOLD_EDGE 3
/// The faces at a vertex (index) form more than one fan. Fans end at edges with three or more faces, whose ends are
/// listed too where a loop passes them.
#define GUSSET_DEFECT_BOW_TIE 4

/// Boundary loops of a mesh. It does not refer to the mesh.
typedef struct gusset_boundary gusset_boundary;

/// Options of gusset_boundary_create.
typedef struct gusset_boundary_options {
    size_t struct_size;
    gusset_non_manifold non_manifold;
    gusset_survey survey;
} gusset_boundary_options;

/// Boundary loop or open chain. Edge i runs from vertices[i] to vertices[i + 1], the last edge of a loop to
/// vertices[0].
typedef struct gusset_loop_view {
    size_t struct_size;
    /// Vertices, each once. A closed loop starts at its smallest half-edge.
    struct gusset_indices vertices;
    /// Half-edge (position in face_corners) of each edge.
    struct gusset_indices half_edges;
    /// Face beside each edge.
    struct gusset_indices faces;
    /// GUSSET_EDGE_... bits of each edge.
    const uint8_t *edge_flags;
    /// Sum of the edge lengths.
    double length;
    /// Properties of the loop; 0 if ordinary and closed.
    gusset_loop_flags flags;
    /// Number of the walk that the loop was cut from.
    uint32_t walk;
} gusset_loop_view;

/// Defect of a mesh.
typedef struct gusset_defect {
    gusset_defect_kind kind;
    /// Face, half-edge or vertex.
    uint32_t index;
    /// Second element, if kind has one; otherwise UINT32_MAX.
    uint32_t other;
    /// Number of half-edges for GUSSET_DEFECT_NON_MANIFOLD_EDGE; otherwise 0.
    uint32_t count;
} gusset_defect;

/// Loop count and defects of a boundary.
typedef struct gusset_boundary_view {
    size_t struct_size;
    /// Number of loops and open chains; 0 if the mesh is closed.
    size_t loop_count;
    /// Number of walks that loops were cut from. Loops that touch share a walk if it passes from one to the other.
    size_t walk_count;
    /// Degenerate faces, orientation conflicts and non-manifold edges of the mesh, and bow-ties on its boundary.
    const struct gusset_defect *defects;
    /// Number of defects.
    size_t defect_count;
} gusset_boundary_view;

/// Finds all boundary loops of a mesh: chains of edges with exactly one face.
/// Loops run as the faces along them: seen from outside, with counter-clockwise faces, the surface is on the left and
/// the hole on the right.
/// - Each loop passes a vertex once: a boundary that touches itself is cut. A loop may have two vertices.
/// - Loops are in the order of their smallest half-edges.
/// - Walks along only edges with three or more faces are left out, except loops cut from other walks.
/// - A face with fewer than three sides between different vertices lacks a border; its neighbours count as adjacent.
/// - Defects are not errors.
/// @errors as gusset_mesh_view
/// @complexity O(H log d) for H half-edges and at most d edges at a vertex; GUSSET_SURVEY_BOUNDARY_ONLY O(H + B log B)
///     for B boundary edges; linear memory.
/// @source Nesterenko, algorithm 1, as corrected: every loop, a stated direction, fan by fan round each vertex.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_boundary_create(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_boundary_options *options,
    struct gusset_boundary **boundary);

/// Destroys a boundary.
GUSSET_API void gusset_boundary_destroy(struct gusset_boundary *boundary);

/// Lends the counts and defects of a boundary.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_boundary_get_view(const struct gusset_boundary *boundary,
    struct gusset_boundary_view *view);

/// Lends one loop of a boundary.
/// @param index below loop_count of gusset_boundary_view.
/// @errors NO_SUCH_ELEMENT
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_boundary_get_loop(const struct gusset_boundary *boundary, size_t index,
    struct gusset_loop_view *view);

/* ---- Checks: Reports the properties and defects of a mesh. */

/// Properties of a mesh.
/// @bits
typedef uint32_t gusset_mesh_flags;
/// The mesh has edges, each with exactly two faces.
#define GUSSET_MESH_CLOSED 1
/// No edge or vertex is non-manifold.
#define GUSSET_MESH_MANIFOLD 2
/// The two faces of each edge run it in opposite directions.
#define GUSSET_MESH_ORIENTED 4
/// The mesh is oriented, or becomes so if faces are turned over.
#define GUSSET_MESH_ORIENTABLE 8

/// Findings of a check. It does not refer to the mesh.
typedef struct gusset_check gusset_check;

/// Counts, properties and defects of a mesh. Lists are ascending. Degenerate faces have no edges.
typedef struct gusset_check_view {
    size_t struct_size;
    /// Vertices, including unused ones.
    uint32_t vertex_count;
    /// Distinct edges: pairs of different vertices, consecutive in a face.
    uint32_t edge_count;
    /// Faces.
    uint32_t face_count;
    /// Components: faces connected by shared edges.
    uint32_t component_count;
    /// Walks along the boundary, as walk_count of gusset_boundary_view.
    uint32_t boundary_walk_count;
    gusset_mesh_flags properties;
    /// Used vertices - edges + all faces: the Euler characteristic if no face is degenerate.
    int64_t euler;
    /// Handles of all components together. -1 if the mesh is not manifold or not orientable, or has a degenerate face.
    int64_t genus;
    /// Half-edges of edges with exactly one face.
    struct gusset_indices boundary_edges;
    /// First half-edge of each edge with three or more faces.
    struct gusset_indices non_manifold_edges;
    /// Ends of non-manifold edges, and bow-ties.
    struct gusset_indices non_manifold_vertices;
    /// Vertices whose faces form more than one fan. Fans end at non-manifold edges, whose ends are usually included.
    struct gusset_indices bow_ties;
    /// First half-edge of each edge whose two faces run it in the same direction.
    struct gusset_indices orientation_conflicts;
    /// Faces with the same cycle of vertices, in either direction, as an earlier face; none degenerate.
    struct gusset_indices duplicate_faces;
    /// Faces that repeat a vertex.
    struct gusset_indices degenerate_faces;
    /// Other faces whose vector area is 0 up to rounding.
    struct gusset_indices zero_area_faces;
    /// Vertices that no face uses.
    struct gusset_indices unused_vertices;
} gusset_check_view;

/// Checks the topology of a mesh. Defects are not errors.
/// @errors as gusset_mesh_view
/// @complexity O(H log d) for H half-edges and at most d edges at a vertex; linear memory.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_check_create(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, struct gusset_check **check);

/// Destroys a check.
GUSSET_API void gusset_check_destroy(struct gusset_check *check);

/// Lends the findings of a check.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_check_get_view(const struct gusset_check *check,
    struct gusset_check_view *report);

/* ---- Developments: Cuts surfaces open and flattens them with little distortion. */

/// Distortion that a development minimises.
typedef uint32_t gusset_distortion;
/// Lengths and areas, stretch and compression alike: the symmetric Dirichlet energy.
#define GUSSET_DISTORTION_SYMMETRIC 0
/// Lengths: as rigid as possible.
#define GUSSET_DISTORTION_RIGID 1
/// Angles: the least-squares conformal map, which may stretch areas.
#define GUSSET_DISTORTION_CONFORMAL 2

/// Options of gusset_develop.
typedef struct gusset_develop_options {
    size_t struct_size;
    gusset_distortion distortion;
    /// Largest number of darts: cuts from the border of a chart to where it is curved.
    uint32_t max_darts;
    /// Vertices of the paths to cut along, path after path. Consecutive vertices are connected by the shortest path
    /// along edges. A path of one vertex cuts nothing.
    struct gusset_indices cuts;
    /// Start of each path in cuts, and the end of the last. Empty: one path.
    struct gusset_indices cut_offsets;
    /// Darts stop once no length changes by a larger factor, finite and above 1. 0: no limit.
    double max_stretch;
    /// Largest number of steps of a descent. Charts whose border would meet itself, and GUSSET_DISTORTION_RIGID, need
    /// several descents. 0: 200.
    uint32_t max_iterations;
    uint32_t reserved;
} gusset_develop_options;

/// Flattens a surface with the least distortion, as a pattern to cut it from.
/// The surface is cut along the given paths. Components that are not discs are then opened along short paths. Each
/// connected component of the rest is a chart. The result has the scalar type of the surface and z = 0; its faces keep
/// their order and first corners, and are counter-clockwise. For nets and sheets, see gusset_net_to_mesh and
/// gusset_sheet_to_mesh.
/// - A chart that unfolds about its edges keeps their lengths: cylinders, cones, tangent developables in plane strips.
///   The error is at most 1e-10 of the length, or of 1e-3 mean edges if more, before rounding, which grows with the
///   distance from the origin. The chart may overlap itself, and rounding may turn over triangles without area.
/// - Other charts descend to the least distortion. The map is one-to-one: no triangle is turned over, and the border
///   does not meet itself. If this ends the descent early, finish is GUSSET_CHART_STALLED.
/// - Darts are made while they lower the distortion, from the border to the vertex with the worst scale in a conformal
///   map.
/// - Each chart is turned so that its border has the greatest variance along x.
/// - A vertex on a cut becomes several. Merged vertices count as the smallest.
/// - Edges with three or more faces, or two that disagree in orientation, are borders, not cuts.
/// - Polygons are measured by triangles. A triangle flatter than 1e-7 of its longest side, or smaller than 1e-7 of the
///   mean edge, counts as that large.
/// - A conformal map has the area of the surface.
/// @errors as gusset_mesh_view, OUT_OF_RANGE (max_stretch), BAD_OFFSETS (cut_offsets), INDEX_OUT_OF_RANGE (input of the
///     report is the cut, index the place in it), CUT_NOT_CONNECTED (likewise), REPEATED_CORNER
/// @complexity O(H log H) for H half-edges if charts unfold; otherwise O(n^1.5) for n vertices of a chart, each step
///     and each dart; memory O(n log n).
/// @source M. Rabinovich et al., Scalable locally injective mappings (2017), for the descent; B. Levy et al., Least
///     squares conformal maps (2002); J. Erickson, K. Whittlesey, Greedy optimal homotopy and homology generators
///     (2005), for the cuts that open; M. Ben-Chen et al., Conformal flattening by curvature prescription and metric
///     scaling (2008), for darts.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_develop(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_develop_options *options, struct gusset_result **result);

struct gusset_develop_report;

/// Lends the flat points, charts and cuts, for a result of gusset_develop.
/// @errors WRONG_HANDLE (a result of another operation)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_develop(const struct gusset_result *result,
    struct gusset_develop_report *report);

/* ---- Developments: reports: Charts, cuts and distortion of a development. */

/// Outcome of the layout of a chart.
typedef uint32_t gusset_chart_finish;
/// Unfolded about edges: all edges keep their lengths.
#define GUSSET_CHART_EXACT 0
/// Descended until nothing was gained.
#define GUSSET_CHART_CONVERGED 1
/// Descended until max_iterations.
#define GUSSET_CHART_ITERATION_LIMIT 2
/// The requested conformal map.
#define GUSSET_CHART_CONFORMAL 3
/// The map with the least symmetric distortion, because the conformal map folds or overlaps.
#define GUSSET_CHART_NOT_CONFORMAL 4
/// Some triangles are turned over, because no map without folds was found.
#define GUSSET_CHART_FOLDED 5
/// Descended until no step gained: the border would meet itself, or rounding hides the gain. Cuts or darts may help.
#define GUSSET_CHART_STALLED 6

/// Reason for a cut.
typedef uint32_t gusset_cut_kind;
/// On a given path.
#define GUSSET_CUT_GIVEN 0
/// To open a component to a disc.
#define GUSSET_CUT_OPENING 1
/// For a dart.
#define GUSSET_CUT_DART 2

/// Connected component of a development.
typedef struct gusset_chart {
    /// First vertex of the chart in the result. Its vertices are consecutive.
    uint32_t first_vertex;
    /// Number of vertices.
    uint32_t vertex_count;
    /// Number of faces.
    uint32_t face_count;
    gusset_chart_finish finish;
    /// Steps of all descents.
    uint32_t iterations;
    /// Pairs of border edges that meet in the plane, except neighbours. With GUSSET_CHART_EXACT, only crossings by more
    /// than 1e-8 of the root of the area count. 0 unless finish is GUSSET_CHART_EXACT or GUSSET_CHART_FOLDED.
    uint32_t overlaps;
    /// Triangles that are turned over. 0 unless finish is GUSSET_CHART_FOLDED.
    uint32_t folds;
    uint32_t reserved;
    /// Symmetric Dirichlet energy: the mean over the area of s^2 + 1 / s^2, summed over both singular values s of the
    /// map to the plane. The least is 4, for an isometry.
    double energy;
    /// Largest factor by which a length grows.
    double max_stretch;
    /// Smallest factor by which a length grows.
    double min_stretch;
    /// Area of the surface.
    double area;
    /// Area in the plane.
    double flat_area;
} gusset_chart;

/// Points, charts and cuts of a development.
typedef struct gusset_develop_report {
    size_t struct_size;
    /// x, y of each vertex in the plane, always in double precision.
    const double *points;
    /// Vertex of the surface for each vertex. Vertices on cuts repeat.
    struct gusset_indices vertex_map;
    /// Chart of each face.
    struct gusset_indices face_charts;
    /// Largest and smallest factor by which lengths grow, two numbers for each face.
    const double *stretches;
    /// Charts in the order of their first faces, side by side along x.
    const struct gusset_chart *charts;
    /// Number of charts.
    size_t chart_count;
    /// Cut edges of the surface, two vertices each: first given, then opening, then dart cuts.
    struct gusset_indices cut_edges;
    /// GUSSET_CUT_... of each cut edge.
    struct gusset_indices cut_kinds;
    /// Number of darts.
    uint32_t darts;
    uint32_t reserved;
} gusset_develop_report;

/* ---- Facing arcs: Finds which vertices of two loops face each other. */

/// Which vertices of two loops face each other. Opaque and immutable; it keeps nothing of the points.
typedef struct gusset_facing gusset_facing;

/// How facing vertices are found; all zero is the default.
typedef struct gusset_facing_options {
    size_t struct_size;
    gusset_facing_run run;
    gusset_tolerance_mode tolerance_mode;
    /// How far a vertex must be from its loop's plane, in the unit of the points, at least 0; read for
    /// GUSSET_TOLERANCE_GIVEN.
    /// @when tolerance_mode GUSSET_TOLERANCE_GIVEN
    double tolerance;
    gusset_centres centres;
    uint32_t reserved;
} gusset_facing_options;

/// What algorithm 2 found. Index 0 is loop A, 1 is loop B. Pointers are valid until the handle is destroyed.
typedef struct gusset_facing_view {
    size_t struct_size;
    /// The centres C_1 and C_2 (5): x, y, z of each.
    double centre[2][3];
    /// The vectors C_2 - C_1 and C_1 - C_2 (6), the normals of the planes (7).
    double normal[2][3];
    /// The distance of each vertex from its loop's plane, positive on the side of the other loop; as many as the loop
    /// has.
    const double *distances[2];
    /// All runs of facing vertices: first place and number of vertices, by turns; a run may pass the loop's end.
    struct gusset_indices runs[2];
    /// The run taken: first place and number of vertices, as gusset_stitch_options takes them in arc_a and arc_b.
    uint32_t taken[2][2];
} gusset_facing_view;

/// Finds which vertices of two loops face each other.
/// @param points_a x, y, z of the vertices of each loop in order, packed, count_a and count_b of them, at least 1 each.
/// @param count_a see points_a.
/// @param points_b see points_a.
/// @param count_b see points_a.
/// @errors LOOP_TOO_SHORT, TOO_LARGE, NOT_FINITE, OUT_OF_RANGE, PLANES_UNDECIDED (no vertex of a loop is beyond the
///     tolerance, as with coaxial rims, or the centres coincide)
/// @complexity O((N + M) log M); linear extra memory.
/// @source Nesterenko, algorithm 2, equations 5-7, with a tolerance, and runs instead of subsets.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_facing_create(const struct gusset_context *context,
    const double *points_a, size_t count_a, const double *points_b, size_t count_b,
    const struct gusset_facing_options *options, struct gusset_facing **facing);

/// Destroys what gusset_facing_create made; NULL is allowed.
GUSSET_API void gusset_facing_destroy(struct gusset_facing *facing);

/// Lends what was found.
/// @param facing what was found.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_facing_get_view(const struct gusset_facing *facing,
    struct gusset_facing_view *view);

/// The paper's rule for meridians: for each i = 0 .. n the j = 0 .. m that makes |m i - n j| least, of two equal ones
/// the later.
/// @param n segments of the longer and of the other polyline, m <= n (OUT_OF_RANGE): an open one of N vertices has N -
///     1, a closed one N.
/// @param m see n.
/// @param j receives n + 1 numbers; NULL with capacity 0 asks for how many.
/// @param capacity of j.
/// @param written receives their number; may not be NULL.
/// @errors OUT_OF_RANGE, BUFFER_TOO_SMALL (nothing but the number is written)
/// @complexity O(n).
/// @source Nesterenko, the intermediate mesh: j = floor((2 m i + n) / (2 n)), without the products.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_meridians_index(uint32_t n, uint32_t m, uint32_t *j, size_t capacity,
    size_t *written);

/* ---- Origins: Gives the source elements of each vertex, corner and face of a result. */

/// Kind of element.
typedef uint32_t gusset_domain;
/// Vertices, points of polylines, nodes of nets and sheets.
#define GUSSET_DOMAIN_VERTICES 0
/// Corners of faces, in the order of face_corners; nodes of nets and sheets.
#define GUSSET_DOMAIN_CORNERS 1
/// Faces, cells of nets and sheets.
#define GUSSET_DOMAIN_FACES 2

/// Source elements of each vertex, corner and face of a result. It does not refer to the result.
/// - An old element has itself, a merged vertex all its vertices in equal parts.
/// - A new vertex has the rim vertices around it, by its place on plain triangles between them, without fairing. A
///   vertex put on an edge has the ends of the edge.
/// - A new face has the face across the nearest rim edge (the first of equals). Its corners have the old corners there,
///   on its own side if it shares an edge with old faces.
typedef struct gusset_origins gusset_origins;

/// Origins of the elements of one domain.
typedef struct gusset_origins_view {
    size_t struct_size;
    /// Element k has the entries offsets[k] to offsets[k + 1] - 1 of sources and weights, or none. One entry more than
    /// elements.
    struct gusset_indices offsets;
    /// Sources, numbered through all inputs.
    struct gusset_indices sources;
    /// Weight of each source, above 0, with sum 1 for each element.
    const double *weights;
    /// Input i has the sources starts[i] to starts[i + 1] - 1. One entry more than inputs. Inputs are the meshes,
    /// pieces or polylines in order, or the single mesh, net or sheet.
    struct gusset_indices starts;
} gusset_origins_view;

/// Destroys origins.
GUSSET_API void gusset_origins_destroy(struct gusset_origins *origins);

/// Lends the origins of the vertices, corners or faces of a result.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_origins_get_view(const struct gusset_origins *origins,
    gusset_domain domain, struct gusset_origins_view *view);

/* ---- Attributes: Transfers colours, normals, texture coordinates and other values to results. */

/// Type of values.
typedef uint32_t gusset_value_type;
/// 32-bit floats.
#define GUSSET_VALUE_F32 1
/// 64-bit floats.
#define GUSSET_VALUE_F64 2
/// 8-bit unsigned integers.
#define GUSSET_VALUE_U8 3
/// 16-bit unsigned integers.
#define GUSSET_VALUE_U16 4
/// 32-bit unsigned integers.
#define GUSSET_VALUE_U32 5

/// Rule that combines the values of several sources. An element with one source keeps its value bit for bit.
typedef uint32_t gusset_rule;
/// Weighted mean, as for colours; integers are rounded.
#define GUSSET_RULE_LINEAR 0
/// Directions of three floats: weighted mean on the sphere, of length 1. Directions of faces that the operation turned
/// over are negated.
#define GUSSET_RULE_NORMAL 1
/// Bone weights, at least 0: weighted mean. The max_influences largest (the first of equals) are kept and scaled to the
/// sum 1, or to the largest value of an integer type.
#define GUSSET_RULE_SKIN_WEIGHTS 2
/// Value of the source with the largest weight (the first of equals), as for materials.
#define GUSSET_RULE_NEAREST 3
/// Texture coordinates. For vertices and faces: the weighted mean. At corners of new faces:
/// - The weighted mean where both sides are on one chart.
/// - Elsewhere each new face continues the unfolded chart of its old face, up to a seam in the middle.
/// - At the cut of a chart that closes on itself, values are shifted by the jump at the cut. If the jump is not a
///   repeat of the texture, the face continues its own chart. No face runs back over the chart.
/// - A rim is on one chart as long as old faces have equal values at common vertices. The sides of a gap are on one
///   chart if most new faces agree: values from the far side deviate from the continued chart by less than half the
///   distance to the old edge and its length combined.
#define GUSSET_RULE_TEXTURE 4

/// Type of the values of elements, and the rule that combines them.
typedef struct gusset_channel {
    size_t struct_size;
    /// Elements that have values.
    gusset_domain domain;
    /// Type of the values; 0 is not valid.
    gusset_value_type value_type;
    /// Number of values of an element, 1 to 4096.
    uint32_t components;
    gusset_rule rule;
    /// Number of weights that GUSSET_RULE_SKIN_WEIGHTS keeps for elements with several sources; 0: all.
    uint32_t max_influences;
    uint32_t reserved;
} gusset_channel;

/// Values of the elements of one input.
typedef struct gusset_channel_values {
    /// Components of each element at the start of every stride, at any alignment. NULL with count 0: the input lacks
    /// them; its elements get 0, and new elements the values of other sources.
    const void *values;
    /// Number of vertices, corners or faces of the input.
    size_t count;
    /// Bytes from one element to the next; 0 if packed.
    size_t stride;
} gusset_channel_values;

/// Transfers values from the elements of inputs to the elements of a result.
/// Elements without sources, or whose sources all lack the values, get 0.
/// @param inputs values of each input of the origins, in order, at any alignment.
/// @param values receives the components of each element at the start of every stride, at any alignment; bytes between
///     do not change. Must not overlap the inputs' values.
/// @param count room in elements, at least the elements of the result.
/// @param stride bytes from one element to the next; 0 if packed.
/// @errors OUT_OF_RANGE (components; value_type and components that the rule refuses; a negative skin weight, with
///     element and input), NOT_FINITE (with element and input, except for GUSSET_RULE_NEAREST), COUNT_DIFFERS (of
///     inputs, or of values, with the input), BAD_STRIDE, BUFFER_TOO_SMALL, OVERLAP
/// @complexity O(sources and elements) on the context's threads; no memory, except for GUSSET_RULE_TEXTURE, linear in
///     the corners of new faces.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_attributes_apply(const struct gusset_context *context,
    const struct gusset_origins *origins, const struct gusset_channel *channel,
    const struct gusset_channel_values *inputs, size_t input_count, void *values, size_t count, size_t stride);

/// Finds which vertices of a mesh are one, for the field merge of gusset_mesh_view.
/// Vertices with equal keys are one, as after splits at seams of texture coordinates or normals. Without keys, vertices
/// at equal finite positions are one; -0 equals 0.
/// @param keys one for each vertex, at any alignment; NULL: positions.
/// @param merge receives for each vertex the smallest vertex that it is one with; at any alignment.
/// @errors as gusset_mesh_view
/// @complexity O(V log V) for V vertices; 8 bytes for each, 12 with keys.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_mesh_find_merge(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const uint32_t *keys, uint32_t *merge);

#ifdef __cplusplus
}
#endif

#endif /* GUSSET_MESH_H */
