/* Generated from src/capi; do not edit. See gusset.h. */

#ifndef GUSSET_MESH_H
#define GUSSET_MESH_H
#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Meshes: Polygon meshes in memory of the caller or of a result. An edge with one face is a boundary edge, with */
/* three or more a non-manifold edge. Memory is linear unless stated. */

/// Type of coordinates.
typedef uint32_t gusset_scalar;
/// 32-bit floats.
#define GUSSET_F32 1
/// 64-bit floats.
#define GUSSET_F64 2

/// Type of indices.
typedef uint32_t gusset_index;
/// 32-bit unsigned integers.
#define GUSSET_U32 0
/// Reserved: GUSSET_ERROR_UNKNOWN_VALUE.
#define GUSSET_U64 1

/// Array of indices.
typedef struct gusset_indices {
    /// First index; may be NULL if count is 0.
    const uint32_t *data;
    size_t count;
} gusset_indices;

/// Polygon mesh in arrays of the caller (input) or of a result (output). Input arrays must not change during the call;
/// their lengths are not checked. Counts are checked before elements. Outputs have packed positions, face_offsets, and
/// face_size 0. Inputs have
/// - a vertex and a face (EMPTY_MESH),
/// - at most 2^32 - 2 vertices, and as many corners (TOO_LARGE),
/// - at least 3 corners a face (FACE_TOO_SMALL),
/// - indices below vertex_count (INDEX_OUT_OF_RANGE),
/// - finite coordinates at vertices of faces (NOT_FINITE),
/// - a valid layout (BAD_STRIDE, BAD_FACE_LAYOUT, BAD_OFFSETS, BAD_MERGE).
typedef struct gusset_mesh_view {
    size_t struct_size;
    /// x, y, z at each stride.
    const void *positions;
    /// Bytes from one position to the next; 0 if packed.
    size_t position_stride;
    size_t vertex_count;
    /// face_count + 1 entries: face f has corners face_offsets[f] to face_offsets[f + 1] - 1. NULL with face_size.
    const void *face_offsets;
    /// Vertex of each corner, face by face. Corner h also names the half-edge that starts there.
    const void *face_corners;
    size_t face_count;
    /// GUSSET_F32 or GUSSET_F64; must be set, as 0 is invalid.
    gusset_scalar scalar;
    gusset_index index;
    /// Corners of every face, or 0 with face_offsets.
    uint32_t face_size;
    uint32_t reserved;
    /// Representative of each vertex, or NULL. Vertices with one representative are one vertex of the surface, so
    /// texture seams are not borders; see gusset_mesh_find_merge. A representative represents itself, and its position
    /// counts. Results list representatives; their faces keep the given vertices.
    const void *merge;
} gusset_mesh_view;

/* ---- Results: The mesh that an operation makes, with the report of the operation. */

/// Mesh made by an operation, and its report. Only the getter of this report accepts it; the others return
/// WRONG_HANDLE.
typedef struct gusset_result gusset_result;

/// Quality of new faces and the result.
typedef struct gusset_quality_report {
    size_t struct_size;
    /// Smallest angle of new triangles; 0 if one is degenerate.
    double min_angle;
    /// Largest aspect ratio of new triangles, longest side / (2 sqrt(3) inradius): 1 if equilateral, infinite if
    /// degenerate.
    double max_aspect;
    /// Longest edge of new faces.
    double max_edge;
    /// Area of new faces.
    double area;
    /// New triangles of area 0.
    uint32_t degenerate_faces;
    /// Boundary loops of the result.
    uint32_t loops_left;
    /// Non-manifold edges of the result.
    uint32_t non_manifold_edges;
    /// Edges whose two faces disagree in orientation.
    uint32_t orientation_conflicts;
} gusset_quality_report;

/// Destroys a result.
GUSSET_API void gusset_result_destroy(struct gusset_result *result);

/// Lends the mesh.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_mesh(const struct gusset_result *result,
    struct gusset_mesh_view *view);

/// Reports the quality of a stitch or filling.
/// @errors WRONG_HANDLE
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_quality(const struct gusset_result *result,
    struct gusset_quality_report *report);

struct gusset_origins;

/// Finds the sources of a result's vertices, corners and faces in the operation's meshes, pieces, net or sheet.
/// - A strip has two polylines; its corners and faces lack sources.
/// - A corner that gusset_sew added on an edge has the corners of its face at both ends.
/// - Corners and faces of a development are the surface's; each vertex has one source.
/// - In the mesh of a net, a vertex has its first node, a face its cell, a corner its own cell's node: both sides of a
///   seam differ.
/// - A sheet has (rows + 1) * (columns + 1) nodes, row by row. Vertices and corners have the nodes of their cell, by
///   parameters; faces have their cells. Where the sheet closes, corners have the nodes on their face's side.
/// @errors TOO_LARGE
/// @complexity O(H log n) for n corners of new faces; 16 bytes an element (sheet: 52 a vertex or corner), plus linear
///     in n.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_origins_create(const struct gusset_context *context,
    const struct gusset_result *result, struct gusset_origins **origins);

/* ---- Joining: Joins many open pieces to one mesh. */

struct gusset_join_options;

/// Joins open pieces into one mesh: sews coincident borders, orients components, joins facing loops by strips, fills
/// holes, and turns closed components outwards, as the options say.
/// The result has the vertices of pieces, strips, then patches; faces likewise. Positions have the first piece's scalar
/// type; old ones keep their bits. Strips enclose overlaps that are not trimmed.
/// Facing loops of different components are joined, by the best one-to-one choice:
/// - Whole loops, if the conormals (tangents off the surface) of each point to the other, without a much nearer loop
///   between.
/// - Whole loops, if 9/10 of the vertices of each are nearest to the other, at similar distances or once round it.
///   Similar: the ninth decile is at most 4 times the first, or the vertex spacing.
/// - Else runs of mutually nearest vertices, by open strips.
/// @param pieces at least one; struct_size of the first holds for all.
/// @errors as gusset_mesh_view, EMPTY_MESH, MIXED_SCALARS, OUT_OF_RANGE (a tolerance, max_gap, or an entry of pairs or
///     excluded: index is the entry, input its loop 0 or 1, value the missing piece, else the vertex. The piece or
///     vertex does not exist. In pairs, also: no vertex, no or several joinable loops at it, or a loop named before),
///     TOO_LARGE
/// @complexity O(H log d + V log V) for V vertices on loops, gusset_stitch for each strip, gusset_fill for each hole, a
///     pass over all faces for each strip faired or tested for intersections.
/// @source Nesterenko for a single gap.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_join(const struct gusset_context *context,
    const struct gusset_mesh_view *pieces, size_t piece_count, const struct gusset_join_options *options,
    struct gusset_result **result);

struct gusset_join_report;

/// Lends the report of a join.
/// @errors WRONG_HANDLE
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_join(const struct gusset_result *result,
    struct gusset_join_report *report);

/* ---- Options of stitching: How a strip is chosen, subdivided and smoothed. */

/// Rule for the meridians. A meridian is a strip's edge from rim A to rim B.
typedef uint32_t gusset_meridians;
/// Triangle strip that best continues both surfaces. It bends little, above all along the rims, and follows the tangent
/// planes there. The default search stays near the strip of least area, which gusset_strip makes.
#define GUSSET_MERIDIANS_CONTINUATION 0
/// Vertices paired in proportion to their indices, O(N + M); suits evenly spaced rims.
#define GUSSET_MERIDIANS_INDEX 1
/// Vertices paired in proportion to arc length, O(N + M). GUSSET_MERIDIANS_MIN_DIAGONAL applies if that repeats an
/// edge.
#define GUSSET_MERIDIANS_ARC_LENGTH 2
/// Always the shorter of the two next meridians, O(N + M). GUSSET_MERIDIANS_MIN_DIAGONAL applies if that repeats an
/// edge.
#define GUSSET_MERIDIANS_GREEDY 3
/// Triangle strip of least total meridian length.
#define GUSSET_MERIDIANS_MIN_DIAGONAL 4
/// Triangle strip of least bend: the sum, over its edges and rims, of length * (1 - cos(angle between normals)).
#define GUSSET_MERIDIANS_SMOOTH 5
/// Least sum of squared meridian lengths (dynamic time warping): quads where both rims advance, else triangles. Suits
/// interior rows.
#define GUSSET_MERIDIANS_QUAD 6
/// Triangle strip of least area through the first meridian.
#define GUSSET_MERIDIANS_MIN_AREA 7

/// Search effort.
typedef uint32_t gusset_strip_search;
/// Exact up to 2^21 pairs of vertices. Beyond, coarse to fine in nearly linear time and linear memory, usually within
/// 0.1 % of the optimum.
#define GUSSET_SEARCH_AUTO 0
/// Exact, in O(N M) time; gusset_stitch states the memory.
#define GUSSET_SEARCH_EXACT 1

/// First meridian of a closed strip.
typedef uint32_t gusset_strip_start;
/// The better strip from the closest pair of vertices, or from the closest after rotating rim B along rim A to the best
/// fit.
#define GUSSET_START_AUTO 0
/// The closest pair of vertices.
#define GUSSET_START_CLOSEST 1
/// The first points; gusset_strip only.
#define GUSSET_START_GIVEN 2

/// Positions of new vertices.
typedef uint32_t gusset_fairing;
/// New vertices divide the meridians of a strip evenly, or lie on the first triangulation of a patch.
#define GUSSET_FAIRING_NONE 0
/// The new surface bends like a thin plate and meets the old one smoothly: least sum of squared Laplacians over new
/// vertices and rims. Rims and ends of an open strip stay fixed.
#define GUSSET_FAIRING_THIN_PLATE 1

/// Treatment of intersecting faces.
typedef uint32_t gusset_intersections;
/// Finds intersections of the strip, and reduces them:
/// - A triangle strip without rows by GUSSET_MERIDIANS_CONTINUATION is rerouted; the best strip tried is kept. If the
///   mean meridian is longer than a radius, the strip of GUSSET_MERIDIANS_SMOOTH competes. It is kept if it has fewer
///   intersections, or as many and much smaller bends.
/// - Rows by GUSSET_MERIDIANS_CONTINUATION use the meridians of that strip if the gap is so wide, or if they would
///   intersect.
/// - Faired rows move back locally, at most 12 times; straight rows are kept if they intersect less.
/// - Blends move back likewise, then get less fairing. The best blend is kept, or the strip if every blend intersects
///   more.
#define GUSSET_INTERSECTIONS_AUTO 0
/// No search: rows are faired in full, and the first blend is kept.
#define GUSSET_INTERSECTIONS_IGNORE 1
/// As GUSSET_INTERSECTIONS_AUTO, but no strip is rerouted.
#define GUSSET_INTERSECTIONS_REPORT 2

/// Treatment of opposite orientations.
typedef uint32_t gusset_orientation;
/// If the component of rim B is oriented against rim A, it is reversed, whichever is inside out. Within one component
/// nothing is reversed. Whole rims are compared as curves. If both face one way, the sides of their surfaces decide. An
/// inconclusive comparison reverses nothing.
#define GUSSET_ORIENTATION_FIX 0
/// Opposite orientations return GUSSET_ERROR_ORIENTATION_CONFLICT.
#define GUSSET_ORIENTATION_REFUSE 1
/// Orientations are not compared.
#define GUSSET_ORIENTATION_KEEP 2

/// Part of the loops to join.
typedef uint32_t gusset_stitch_extent;
/// Whole loops, by a closed band.
#define GUSSET_EXTENT_WHOLE_LOOPS 0
/// Runs of facing vertices, as in gusset_facing_create; may return GUSSET_ERROR_PLANES_UNDECIDED.
#define GUSSET_EXTENT_OPEN_ARCS 1
/// Whole loops if their normals make less than 60 degrees with the line of centres (mean of cosines), or if the planes
/// are undecided. Else open arcs.
#define GUSSET_EXTENT_AUTO 2
/// The arcs arc_a and arc_b. A loop that is not given is indexed as by gusset_boundary_get_loop.
#define GUSSET_EXTENT_ARCS 3

/// Choice among runs of facing vertices.
typedef uint32_t gusset_facing_run;
/// On each loop the run with the closest pair.
#define GUSSET_RUN_CLOSEST 0
/// On each loop the run with the most vertices; of equal runs the first.
#define GUSSET_RUN_LONGEST 1

/// Centre of a loop.
typedef uint32_t gusset_centres;
/// Mean of the vertices.
#define GUSSET_CENTRES_VERTICES 0
/// Mean along the curve, independent of vertex spacing.
#define GUSSET_CENTRES_LENGTH 1

/// Number of interior rows.
typedef uint32_t gusset_row_rule;
/// 0: each meridian is one edge.
#define GUSSET_ROWS_NONE 0
/// max(0, round(mean meridian length / mean edge length of both meshes) - 1). At most about 50,000 new vertices, or 16
/// rows if those are more; a note says if this limit applies.
#define GUSSET_ROWS_MEAN_EDGE 1
/// row_count.
#define GUSSET_ROWS_COUNT 2

/// Faces of the strip.
typedef uint32_t gusset_strip_cells;
/// Triangles; quads are split by their shorter diagonals.
#define GUSSET_CELLS_TRIANGLES 0
/// Quads, and triangles where a rim repeats a vertex.
#define GUSSET_CELLS_QUADS 1

/// Surface between the rims, or in a hole. One word for the best-looking result: BLEND.
typedef uint32_t gusset_finish;
/// Strip of meridians, with interior rows. In a hole: the patch that the other options describe.
#define GUSSET_FINISH_STRIP 0
/// Smooth joint, tangent to both pieces. Triangles are about as fine as along the rims, graded between, without sharp
/// angles where the rims allow. It smooths the ridges of a strip without rows. A tube closes a gap in a tube, within
/// some per cent of the radius across a few radii. Across a gap wider than a radius the joint of two tubes bends as an
/// arc between their axes. Meridians and matrix describe the strip, not edges of the result. Ignores rows, cells and
/// fairing. In a hole: a patch with new vertices as dense as those around it, faired. In a join, for strips and holes.
/// - Not for machined parts and flat walls: it rounds what should be straight. Not for CAD tolerances, printing, or
///   volumes alone: a strip has far fewer faces.
/// The strip is kept if every blend intersects more, or exceeds about 50,000 new vertices, or 16 a rim vertex if more.
/// To meet that limit, edges grow up to twice as long.
#define GUSSET_FINISH_BLEND 1

/// Source of the tolerance.
typedef uint32_t gusset_tolerance_mode;
/// Uses the rounding error of the coordinates. For facing vertices: at most 2^-16 (32-bit) or 2^-45 (64-bit) times the
/// loops' largest coordinate. For welding, see gusset_weld_options.
#define GUSSET_TOLERANCE_AUTO 0
/// Uses the given tolerance.
#define GUSSET_TOLERANCE_GIVEN 1
/// Uses tolerance 0; welding then requires equal positions.
#define GUSSET_TOLERANCE_EXACT 2

/// Side that closed components face.
typedef uint32_t gusset_outward;
/// GUSSET_OUTWARD_CLOSED in gusset_join, else GUSSET_OUTWARD_KEEP.
#define GUSSET_OUTWARD_AUTO 0
/// Closed components stay unchanged; gusset_orient chooses the original side of most faces.
#define GUSSET_OUTWARD_KEEP 1
/// Closed components face outwards, and walls of cavities face into the cavities. A component is the wall of a cavity
/// if an odd number of closed components enclose it. Components that cross, or touch in more than vertices and edges,
/// do not enclose each other. If the volume is 0 up to rounding, GUSSET_OUTWARD_KEEP applies. Except in gusset_orient,
/// only components that are closed (two faces at every edge) and consistently oriented are reversed.
#define GUSSET_OUTWARD_CLOSED 2

/// Options of gusset_stitch.
typedef struct gusset_stitch_options {
    size_t struct_size;
    gusset_meridians meridians;
    gusset_orientation orientation;
    /// Shift of the first meridian along rim B from the closest pair that no edge joins. Counted in vertices in the
    /// direction of rim A, modulo rim B. If not 0, no other start is tried. 0 for arcs (OUT_OF_RANGE).
    int64_t twist;
    gusset_stitch_extent extent;
    gusset_facing_run run;
    gusset_row_rule rows;
    /// Interior rows.
    /// @when rows GUSSET_ROWS_COUNT
    uint32_t row_count;
    gusset_strip_cells cells;
    gusset_tolerance_mode tolerance_mode;
    /// Facing vertices are farther than this from the plane of their loop; finite, at least 0.
    /// @when tolerance_mode GUSSET_TOLERANCE_GIVEN
    double tolerance;
    /// First index on loop A as given, and number of vertices, 1 to the loop's length. The arc may pass the loop's end.
    /// @when extent GUSSET_EXTENT_ARCS
    uint32_t arc_a[2];
    /// As arc_a, for loop B.
    /// @when extent GUSSET_EXTENT_ARCS
    uint32_t arc_b[2];
    gusset_strip_search search;
    gusset_strip_start start;
    /// Positions of interior rows; ignored without rows.
    gusset_fairing fairing;
    gusset_intersections intersections;
    gusset_centres centres;
    gusset_outward outward;
    /// Surface between the rims.
    gusset_finish finish;
    uint32_t reserved;
} gusset_stitch_options;

/* ---- Options of joining: Which borders are joined. */

/// Treatment of coincident borders.
typedef uint32_t gusset_welding;
/// Sewn, with the tolerance of weld_options; edges are split where vertices do not match, as in gusset_sew.
#define GUSSET_WELDING_SEW 0
/// Nothing is welded.
#define GUSSET_WELDING_NONE 1
/// Sewn where they match vertex by vertex, as in gusset_weld.
#define GUSSET_WELDING_EDGE_TO_EDGE 2

/// Widest gap to close.
typedef uint32_t gusset_gap;
/// The width of a gap is the larger mean distance from either loop to the nearest points of the other.
/// - Whole loops: a fifth of the larger component's extent along an axis, or the smaller mean radius (mean distance
///   from the loop's centre) if more. The only two loops, on two pieces, are joined at any distance, unless they lie
///   beside each other.
/// - Runs of loops: half the smaller mean radius, and at most 4 mean edges of the coarser loop.
/// - Slits: one mean edge, and half the mean radius unless the slit is narrow.
/// - Gaps between borders that share vertices: the longest edge.
/// - Whole loops that coincide in part: as whole loops, before they are sewn.
/// - Trimmed pieces: 2.5 mean edges of the coarsest, or 4 if a part would be left alone.
#define GUSSET_GAP_AUTO 0
/// max_gap.
#define GUSSET_GAP_GIVEN 1

/// Parts of loops that are joined.
typedef uint32_t gusset_join_extent;
/// Whole loops, and parts of the other loops.
#define GUSSET_JOIN_LOOPS_AND_PARTS 0
/// Whole loops only.
#define GUSSET_JOIN_WHOLE_LOOPS 1
/// Runs of loops and slits only. Two sheets side by side never become a closed pocket.
#define GUSSET_JOIN_PARTS 2

/// Treatment of overlapping pieces.
typedef uint32_t gusset_overlaps;
/// Overlapping pieces stay unchanged.
#define GUSSET_OVERLAPS_KEEP 0
/// One piece of each overlap is kept, as by gusset_trim_create, and gaps are closed. Strips that would intersect other
/// faces are left to hole filling.
#define GUSSET_OVERLAPS_TRIM 1

/// Two loops of the pieces.
typedef struct gusset_loop_pair {
    /// Piece of each loop.
    uint32_t piece[2];
    /// Vertex of the piece on each loop. In exclusions, UINT32_MAX for all loops of the piece.
    uint32_t vertex[2];
} gusset_loop_pair;

struct gusset_fill_options;

struct gusset_trim_options;

struct gusset_weld_options;

/// Options of gusset_join.
typedef struct gusset_join_options {
    size_t struct_size;
    gusset_welding weld;
    /// GUSSET_ORIENTATION_FIX reverses the minority of faces in each component, then components against those that they
    /// face. GUSSET_ORIENTATION_KEEP reverses nothing, and ignores outward.
    /// @values GUSSET_ORIENTATION_FIX, GUSSET_ORIENTATION_KEEP
    gusset_orientation orientation;
    gusset_gap gap;
    /// Parts of loops to join.
    gusset_join_extent extent;
    /// 1 also joins loops of one component that pairs does not name. @flag
    uint32_t within_components;
    /// 1 fills the remaining holes. @flag
    uint32_t fill;
    /// Widest gap to close, finite, at least 0; 0 closes none.
    /// @when gap GUSSET_GAP_GIVEN
    double max_gap;
    /// Pairs of whole loops to join at any distance, or NULL. A pair is two loops, or a slit twice (see gusset_joint).
    /// No loop is in two pairs.
    const struct gusset_loop_pair *pairs;
    size_t pair_count;
    /// Pairs not to join, or NULL; pairs takes precedence. Vertices on no loop after welding exclude nothing.
    const struct gusset_loop_pair *excluded;
    size_t excluded_count;
    /// Options of welding.
    const struct gusset_weld_options *weld_options;
    /// Options of strips: only meridians, search, start, rows, row_count, cells, fairing, intersections and finish are
    /// used; all must be valid.
    const struct gusset_stitch_options *strip_options;
    /// Options of filling. Ignores groups, outward and plan_only; the last two must be valid. With
    /// GUSSET_OVERLAPS_TRIM, GUSSET_KEEP_AUTO acts as GUSSET_KEEP_OUTER_BORDERS.
    const struct gusset_fill_options *fill_options;
    /// Closed components face outwards by default. Others mostly keep the first piece's orientation.
    gusset_outward outward;
    gusset_overlaps overlaps;
    /// Options of trimming.
    /// @when overlaps GUSSET_OVERLAPS_TRIM
    const struct gusset_trim_options *trim_options;
} gusset_join_options;

/* ---- Joining: reports: Outcomes of joints and loops. */

/// Outcome of a joint.
typedef uint32_t gusset_joint_outcome;
/// A strip joins the two sides.
#define GUSSET_JOINT_JOINED 0
/// Left open: the surface would become one-sided.
#define GUSSET_JOINT_ORIENTATION_CONFLICT 1
/// Left open: the sides share a vertex.
#define GUSSET_JOINT_SHARE_VERTEX 2
/// Left open: every strip would repeat an edge of the mesh.
#define GUSSET_JOINT_NO_STRIP 3
/// Left to hole filling: the strip between trimmed pieces would intersect other faces.
#define GUSSET_JOINT_WOULD_CUT 4

/// Reason for the lack of a strip.
typedef uint32_t gusset_left_reason;
/// It is the only loop.
#define GUSSET_LEFT_ALONE 0
/// The loop is open, or its faces are non-manifold or not consistently oriented.
#define GUSSET_LEFT_NOT_SIMPLE 1
/// The loop has fewer than 3 vertices.
#define GUSSET_LEFT_TOO_SHORT 2
/// The loop faces another, but no strip could be made; see joints.
#define GUSSET_LEFT_NOT_JOINED 3
/// The nearest loop, or the other side of a slit, is farther than allowed_gap.
#define GUSSET_LEFT_TOO_FAR 4
/// All other loops are on its component, and within_components is 0.
#define GUSSET_LEFT_SAME_COMPONENT 5
/// The nearest loop is close enough, but they face each other too little.
#define GUSSET_LEFT_LOOKS_AWAY 6
/// The nearest loop is joined with another.
#define GUSSET_LEFT_TAKEN 7
/// The pair with the nearest loop is excluded.
#define GUSSET_LEFT_EXCLUDED 8

/// Indices of a piece's elements in the result, UINT32_MAX if removed.
typedef struct gusset_piece_map {
    /// Index of each vertex; several may share one.
    struct gusset_indices vertices;
    /// Index of each face; for a split triangle, of its first part, which the others follow.
    struct gusset_indices faces;
} gusset_piece_map;

/// Two loops, or runs of loops, that face each other. Indices are in the result.
/// If borders coincide in part, sewing leaves a slit: a loop along the rest of both. In a slit joined with itself, both
/// sides are on it, one with both ends; whole is 0, and the strip lacks interior rows.
typedef struct gusset_joint {
    /// Vertices of each side in order, before components are turned outwards. If joined, both run from the first
    /// meridian on.
    struct gusset_indices side[2];
    /// Mean width of the gap.
    double gap;
    /// First new vertex.
    size_t vertex_first;
    size_t vertex_count;
    /// First face of the strip.
    size_t face_first;
    size_t face_count;
    /// Pairs of intersecting faces, as in gusset_stitch_report.
    struct gusset_indices intersections;
    /// 1 if searched for. @flag
    uint32_t intersections_known;
    gusset_joint_outcome outcome;
    /// 1 if both sides are whole loops. @flag
    uint32_t whole;
    /// Surface made; a strip may replace a blend.
    gusset_finish finish;
} gusset_joint;

/// Boundary loop of the sewn pieces without a strip, even if filled later.
typedef struct gusset_left_loop {
    /// Vertices in the result, in order.
    struct gusset_indices vertices;
    /// Mean distance to the loop nearest to most vertices, on another component if any. Infinite without one, or if
    /// this loop cannot carry a strip. For a slit too wide: mean distance of its sides.
    double gap;
    /// Largest gap that could be joined; 0 without another loop.
    double allowed_gap;
    gusset_left_reason reason;
    /// 1 if hole filling closed the loop. @flag
    uint32_t filled;
} gusset_left_loop;

struct gusset_hole;

/// Report of a join.
typedef struct gusset_join_report {
    size_t struct_size;
    /// Indices of each piece in the result.
    const struct gusset_piece_map *pieces;
    size_t piece_count;
    /// Joints: given pairs in their order, then the others, nearest first.
    const struct gusset_joint *joints;
    size_t joint_count;
    /// Loops without a strip, by smallest vertex.
    const struct gusset_left_loop *left;
    size_t left_count;
    /// Holes considered for filling.
    const struct gusset_hole *holes;
    size_t hole_count;
    /// Rim vertices of holes, in the order before components are turned outwards.
    struct gusset_indices hole_rims;
    /// Old faces reversed against their pieces, by index in the result. New faces agree with the faces beside them.
    struct gusset_indices turned;
    /// A face of each non-orientable component.
    struct gusset_indices one_sided;
    /// A face of each closed component of volume 0 up to rounding. Empty with GUSSET_ORIENTATION_KEEP or
    /// GUSSET_OUTWARD_KEEP.
    struct gusset_indices zero_volume;
    /// Vertices merged into another.
    uint32_t welded_vertices;
    /// Edges made from two boundary edges.
    uint32_t sewn_edges;
    /// Boundary loops of the result.
    uint32_t loops_left;
    /// Non-manifold edges of the result.
    uint32_t non_manifold_edges;
    /// Points at which boundary edges were split.
    uint32_t splits;
    /// Loops left open by GUSSET_LEFT_LOOKS_AWAY, GUSSET_LEFT_TAKEN or GUSSET_LEFT_NOT_JOINED.
    uint32_t near_loops_left;
    /// Faces removed from overlaps.
    uint32_t trimmed_faces;
    /// Pairs of boundary edges that coincide only within near_tolerance, and are not sewn.
    uint32_t near_edge_pairs;
    /// Tolerance that sews these pairs, at most a tenth of the edges there; 0 without pairs.
    double near_tolerance;
    /// Trimmed faces that no kept face covers, piece and face of each, ascending. Kept faces are farther than
    /// max_distance of the trimming, or face another side.
    struct gusset_indices lost_faces;
    /// Piece and vertex of each loop in left: the first vertex on it that a piece has, UINT32_MAX twice without one.
    struct gusset_indices left_origins;
    /// Pairs of intersecting faces, as in gusset_fill_report.
    struct gusset_indices hole_intersections;
    /// Length of the segments in which the strip of each joint intersects faces.
    const double *joint_cut_lengths;
    /// Length of the segments in which the patch of each hole intersects faces.
    const double *hole_cut_lengths;
    /// For each joint, 1 if its strip intersects faces and a blend would not, else 0. Tried with
    /// GUSSET_INTERSECTIONS_AUTO on pieces that are not trimmed.
    const uint32_t *blend_avoids_cuts;
    /// 1 if intersections of patches were searched for. @flag
    uint32_t hole_intersections_known;
    /// Joints whose strips intersect faces.
    uint32_t cutting_joints;
} gusset_join_report;

/* ---- Stitching: Joins two loops by a strip of new faces. */

/// Parts of a stitch, by index in the result. Entry 0 is of the first mesh, 1 of the second.
typedef struct gusset_stitch_report {
    size_t struct_size;
    /// Index of each old vertex; empty for a missing second mesh.
    struct gusset_indices vertex_map[2];
    /// Index of each old face.
    struct gusset_indices face_map[2];
    /// Vertices of each rim, side by side from the first meridian on. The surface is left of rim 0 and right of rim 1,
    /// before components are turned outwards. The strip's mesh begins with rim 0, then rim 1.
    struct gusset_indices rim[2];
    /// Pairs (i, j) of rim indices, the matrix H; meridian k is (data[2 k], data[2 k + 1]). Whole rims of N and M
    /// vertices: from (0, 0) to (N, M), where index N is 0 again. Arcs: to (N - 1, M - 1). A step advances i or j by 1;
    /// with GUSSET_MERIDIANS_INDEX and GUSSET_MERIDIANS_QUAD also both.
    struct gusset_indices meridians;
    /// The matrix P: vertices row by row from rim 0 to rim 1, a column for each meridian.
    struct gusset_indices matrix;
    /// Three rim vertices for each new vertex; new vertices come last. In a row: the ends of the meridian, the one on
    /// rim 1 twice. In a blend: the corners of the strip triangle that holds the unfaired vertex.
    struct gusset_indices parents;
    /// Weights of the parents, at least 0, sum 1. In row k of r: 1 - k / (r + 1), k / (r + 1), 0.
    const double *weights;
    /// First face of the strip, which comes last.
    size_t strip_face_first;
    /// Faces of the strip: N + M triangles for whole rims without rows, except in a blend.
    size_t strip_face_count;
    /// Interior rows, two less than in the matrix; 0 for a blend.
    uint32_t row_count;
    /// 1 for a closed band, 0 for a strip between arcs. @flag
    uint32_t closed;
    /// 1 if the component of rim 1 was reversed to agree with rim 0; faces keep their first corners. @flag
    uint32_t turned;
    /// 1 if searched for. @flag
    uint32_t intersections_known;
    /// Pairs of intersecting faces: first a strip face, the larger one if both are. Any contact counts, by an exact
    /// test, except at shared or coincident vertices and edges. Faces are split as by gusset_triangulate. A
    /// self-intersecting polygon is paired with itself.
    struct gusset_indices intersections;
    /// Times that fairing of rows, or of the kept blend, was moved back.
    uint32_t back_off_count;
    /// Surface made; a strip may replace a blend.
    gusset_finish finish;
    /// Faces that GUSSET_OUTWARD_CLOSED reversed, ascending. Each keeps its first corner.
    struct gusset_indices turned_outwards;
} gusset_stitch_report;

/// Joins two boundary loops, of two meshes or of one, by a strip of new faces: a closed band between whole loops, or
/// open between facing arcs.
/// The result has the vertices of A, B, then new ones; all faces of A, B, then the strip. Positions have the scalar
/// type of A; old ones keep their bits. An arc of one vertex gets a fan, which touches its piece there only; two such
/// arcs get one meridian and no face.
/// @param loop_a vertices of each loop in order, in either direction, cyclically joined by boundary edges. If both
///     loops are NULL, the two nearest are joined; if one, the nearest to the other. Candidates are closed, of at least
///     3 vertices, manifold and consistently oriented; two of one mesh share no vertex.
/// @param mesh_b NULL if both loops are of mesh_a.
/// @param loop_b as loop_a, for mesh_b, or for mesh_a if mesh_b is NULL.
/// @errors as gusset_mesh_view, OUT_OF_RANGE, PLANES_UNDECIDED, NO_LOOP, LOOP_TOO_SHORT, LOOP_REPEATS_VERTEX,
///     LOOP_EDGE_NOT_FREE, LOOP_NOT_ORIENTED, LOOPS_SHARE_VERTEX, ORIENTATION_CONFLICT, NO_STRIP, MIXED_SCALARS,
///     TOO_LARGE
/// @complexity O(H log d). Meridians O(N M), above 2^21 pairs of vertices and for simple rules O((N + M) log M).
///     Fairing and intersections O(n log n), and a test for each pair of overlapping triangle boxes. Blend of n
///     vertices O(n^1.5), nearly linear in narrow gaps. Choice of loops: a box test a pair. GUSSET_SEARCH_EXACT adds 1
///     byte for each of up to 2^26 pairs, and 8 M bytes for each 2^26 pairs begun. GUSSET_MERIDIANS_CONTINUATION and
///     _SMOOTH take 2 bytes a pair, 8 if the best strip would repeat an edge. Several threads and two starts double
///     that.
/// @source Nesterenko, algorithm 2 and the intermediate mesh (H, P).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_stitch(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh_a, const struct gusset_indices *loop_a, const struct gusset_mesh_view *mesh_b,
    const struct gusset_indices *loop_b, const struct gusset_stitch_options *options, struct gusset_result **result);

/// Lends the strip alone: rim vertices, new vertices, new faces.
/// @errors WRONG_HANDLE
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_strip_mesh(const struct gusset_result *result,
    struct gusset_mesh_view *view);

/// Lends the report of a stitch.
/// @errors WRONG_HANDLE
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_stitch(const struct gusset_result *result,
    struct gusset_stitch_report *report);

/* ---- Holes: reports: Outcomes of loops. */

/// Weight that the triangulation of a hole minimises.
typedef uint32_t gusset_fill_weight;
/// Best continuation of the surface: the area if the rim is planar, else the sum of
/// - 2 sin(t / 2) over all edges, the rim included, for angles t between normals;
/// - the mean squared distance of triangles from the missing surface, estimated from tangent planes at the rim, in
///   units of 1/140 of its length.
#define GUSSET_WEIGHT_CONTINUATION 0
/// Sum of the areas and, over all edges, the rim included, of squared length * (1 - cos(angle between normals)).
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
/// Left open: the outer border of a sheet, or the longest loop; see keep.
#define GUSSET_HOLE_KEPT 1
/// Left open: it exceeds max_edges, max_length, max_diameter or max_area.
#define GUSSET_HOLE_TOO_LARGE 2
/// Left open: it is an open chain.
#define GUSSET_HOLE_OPEN 3
/// Left open: it runs along a non-manifold edge.
#define GUSSET_HOLE_NON_MANIFOLD 4
/// Left open: the faces along it disagree in orientation.
#define GUSSET_HOLE_NOT_ORIENTED 5
/// Left open: a given loop has fewer than three vertices, or passes a vertex twice.
#define GUSSET_HOLE_NOT_SIMPLE 6
/// Left open: an edge of a given loop is not a boundary edge, or belongs to an earlier loop.
#define GUSSET_HOLE_NOT_FREE 7
/// Left open: every triangulation joins two vertices of one old face, or no shared patch was found.
#define GUSSET_HOLE_NO_TRIANGULATION 8
/// Left open: loose faces; the loop passes all vertices of its component. See GUSSET_KEEP_AUTO.
#define GUSSET_HOLE_LOOSE 9
/// Left open: an edge coincides with another boundary edge, up to the rounding of positions. A patch would have no area
/// there, or lie on another. GUSSET_KEEP_NONE fills the loop.
#define GUSSET_HOLE_UNSEWN 10

/// Report on one loop.
typedef struct gusset_hole {
    /// First vertex of the loop in rims, surface on the left before components are turned outwards; as given if not
    /// simple, free or oriented.
    size_t rim_first;
    size_t rim_count;
    /// First face of the patch in the result; the same for loops that share a patch.
    size_t face_first;
    size_t face_count;
    /// First new vertex of the patch.
    size_t vertex_first;
    size_t vertex_count;
    /// Length of the loop.
    double length;
    /// Diagonal of the axis-aligned box of the loop.
    double diameter;
    /// Area of the triangles from the loop's edges to the mean of its vertices: exact for a planar convex hole, else
    /// more.
    double area;
    gusset_hole_status status;
    /// As requested, or one with fewer intersections.
    gusset_fill_weight weight;
    /// As requested, or simpler with fewer intersections.
    gusset_patch_finish finish;
    /// Patch number, in the order of faces; equal for loops that share it. UINT32_MAX: none, always with plan_only.
    uint32_t patch;
} gusset_hole;

/// Reports on all loops.
typedef struct gusset_fill_report {
    size_t struct_size;
    /// Given loops, or all as gusset_boundary_get_loop numbers them.
    const struct gusset_hole *holes;
    size_t hole_count;
    /// Vertices of all loops.
    struct gusset_indices rims;
    /// Three rim vertices for each new vertex.
    struct gusset_indices parents;
    /// Weights of the parents, at least 0, sum 1. They give the nearest point on the plain triangulation of the rims:
    /// the vertex itself in a flat patch, or without fairing and creases.
    const double *weights;
    /// Pairs of intersecting faces, ascending, as in gusset_stitch_report: first the larger index, a new face.
    struct gusset_indices intersections;
    /// Faces that GUSSET_OUTWARD_CLOSED reversed, ascending. Each keeps its first corner.
    struct gusset_indices turned_outwards;
    /// 1 if searched for. @flag
    uint32_t intersections_known;
    /// Boundary edges of the input that coincide with another. 0, and not looked for, for given loops.
    uint32_t coincident_edges;
} gusset_fill_report;

/* ---- Holes: Closes holes by new triangles. */

/// Loops that are not holes. Except with GUSSET_KEEP_NONE, a loop also stays open along a border that coincides with
/// another; see GUSSET_HOLE_UNSEWN.
typedef uint32_t gusset_fill_keep;
/// Outer borders of sheets, and borders of loose faces.
/// - A component is a sheet if the length of its area vector is at least 3/4 of its area. Its outer border is the loop
///   whose area vector reaches farthest along the component's. A bowl is not a sheet: a hemisphere has 1/2.
/// - A component is loose if one loop passes all its vertices, like a single face.
#define GUSSET_KEEP_AUTO 0
/// All loops are holes.
#define GUSSET_KEEP_NONE 1
/// The longest loop (the first of equals).
#define GUSSET_KEEP_LONGEST 2
/// Outer borders of sheets and shallow bowls: loops whose area vector has a positive dot product with their
/// component's, and a length of at least half the component's area.
#define GUSSET_KEEP_BORDERS 3

/// Loops that share a patch.
typedef uint32_t gusset_fill_together;
/// Each loop gets its own patch.
#define GUSSET_TOGETHER_APART 0
/// All filled loops share one patch of genus 0. Unless coplanar, at most about 160 loops.
#define GUSSET_TOGETHER_ONE 1
/// Loops share a patch where it weighs less than separate patches.
/// - Pairs are tried whose boxes, grown by half their diagonals, overlap: about 8 a loop and 256 in all (the log says
///   if exceeded).
/// - The largest relative gain comes first. A patch has at most 16 loops.
/// - With GUSSET_WEIGHT_AREA, the ends of a short tube share a patch along the tube.
#define GUSSET_TOGETHER_CHEAPEST 2

/// New vertices of patches.
typedef uint32_t gusset_fill_refinement;
/// No new vertices.
#define GUSSET_REFINE_NONE 0
/// New vertices as dense as those around the hole.
#define GUSSET_REFINE_RIM_DENSITY 1

/// Smoothness between faired patches and the old surface.
typedef uint32_t gusset_fill_continuity;
/// Tangent continuity: fairing minimises the squared Laplacian.
#define GUSSET_CONTINUITY_C1 0
/// Curvature continuity: fairing minimises the squared gradient of the Laplacian. Two rings of old faces at the rim,
/// with their noise, determine the curvature.
#define GUSSET_CONTINUITY_C2 1

/// Options of gusset_fill. Default: all holes, without new vertices. Outer borders of sheets are not holes.
typedef struct gusset_fill_options {
    size_t struct_size;
    gusset_fill_weight weight;
    gusset_fill_refinement refine;
    /// Fairing; ignored without new vertices.
    gusset_fairing fairing;
    /// Loops that stay open, if all loops are selected.
    gusset_fill_keep keep;
    /// Patch faces that intersect each other or old faces: AUTO avoids, REPORT reports, IGNORE ignores them.
    gusset_intersections intersections;
    /// 1: changes nothing, but reports which loops would be filled, by which weight and finish. Failed triangulations
    /// and shared patches are not predicted. @flag
    uint32_t plan_only;
    /// Approximate limit on a patch's new vertices, kept by larger triangles, exceeded at most twofold. 0: 50,000, or 4
    /// a rim vertex if more; twice that for sharp angles.
    uint32_t max_new_vertices;
    /// Most edges of a loop to fill. 0: no limit.
    uint32_t max_edges;
    /// Largest length of a loop to fill, at least 0. 0: no limit.
    double max_length;
    /// Largest diagonal of the loop's axis-aligned box, likewise.
    double max_diameter;
    /// Largest area, as in gusset_hole, likewise.
    double max_area;
    /// For closed components of the result, patches included.
    gusset_outward outward;
    /// Loops that share a patch, if groups is NULL.
    gusset_fill_together together;
    /// Group of each given loop, loop_count in all. Loops of a group share a patch of genus 0, without loops left open
    /// for their own reasons. NULL: see together.
    const uint32_t *groups;
    gusset_fill_continuity continuity;
    /// 1: creases of the old surface end at the rim. @flag
    uint32_t ignore_creases;
    /// GUSSET_FINISH_BLEND: patches with new vertices as dense as those around the hole, faired, regardless of refine
    /// and fairing.
    gusset_finish finish;
    uint32_t reserved;
} gusset_fill_options;

/// Fills holes: closes boundary loops by triangles, oriented like the surrounding surface.
/// Loops that cannot be filled stay open, and so do outer borders of sheets; see gusset_hole_status. The result has the
/// old vertices, bit for bit, then new ones; the old faces, then new triangles, hole by hole. gusset_join with fill 1
/// and max_gap 0 sews coincident borders first.
/// - No new edge joins two vertices of an old face: a closed result stays closed if its polygons are triangulated.
/// - With the default weight or GUSSET_WEIGHT_AREA, planar holes whose rims do not cross, even with islands, get no
///   overlapping triangles.
/// - In a patch of one loop, creases continue: matching pairs are joined, three or more meet in a new vertex. Without
///   new vertices, only straight pairs are joined. Other creases end at the rim.
/// - Loops of a shared patch stay open if two share a vertex, or the search, which is not exhaustive, fails.
///   GUSSET_TOGETHER_CHEAPEST gives them separate patches.
/// - A patch that intersects itself or other faces, by an exact test, is retried with less fairing, other weights and
///   no new vertices. The fewest intersections win.
/// - Faired vertices stay in the rims' box, grown on all sides by half its diagonal.
/// @param loops vertices of each loop in order, in either direction, cyclically joined by boundary edges. NULL with
///     loop_count 0: all loops.
/// @errors as gusset_mesh_view, INDEX_OUT_OF_RANGE (input is the loop, index the place in it), NULL_ARGUMENT (groups
///     without loops), OUT_OF_RANGE, TOO_LARGE
/// @complexity O(n^3) time, 30 n^2 bytes for a loop of n <= 128 vertices. Otherwise linear memory: O(n), coarse to
///     fine; planar O(n log n); shared patches O(n log n) for few loops, O(n^3) for many. Also O(H log d), O(m^1.5) for
///     m new vertices of a hole, and O(n log n), at worst O(n^2), for intersections with n faces near holes.
/// @source Barequet and Sharir 1995; Liepa 2003.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_fill(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_indices *loops, size_t loop_count,
    const struct gusset_fill_options *options, struct gusset_result **result);

/// Lends the report of a filling.
/// @errors WRONG_HANDLE
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_fill(const struct gusset_result *result,
    struct gusset_fill_report *report);

/* ---- Strips: Builds a strip between two polylines without a mesh. */

/// Options of gusset_strip.
typedef struct gusset_strip_options {
    size_t struct_size;
    gusset_meridians meridians;
    gusset_strip_search search;
    /// First meridian of closed polylines; open ones start at their first points.
    gusset_strip_start start;
    /// 1 if the polylines are closed. @flag
    uint32_t closed;
    /// Number of interior rows; mean edges are of both polylines.
    gusset_row_rule rows;
    /// Interior rows.
    /// @when rows GUSSET_ROWS_COUNT
    uint32_t row_count;
    gusset_strip_cells cells;
    uint32_t reserved;
} gusset_strip_options;

/// Parts of a strip.
typedef struct gusset_strip_report {
    size_t struct_size;
    /// Points of A and B that the first meridian joins.
    uint32_t start[2];
    /// Pairs (i, j) of indices from start on, as in gusset_stitch_report: to (N, M) if closed, else to (N - 1, M - 1).
    struct gusset_indices meridians;
    /// The matrix P: vertices row by row from A to B, a column for each meridian.
    struct gusset_indices matrix;
    /// Ends on A and B of each new vertex's meridian; new vertices come last.
    struct gusset_indices parents;
    /// Weight of each second parent, 0 to 1: k / (r + 1) in row k of r.
    const double *weights;
    /// Interior rows, two less than in the matrix; 0 without a face.
    uint32_t row_count;
    uint32_t reserved;
} gusset_strip_report;

/// Builds a strip, as gusset_stitch does between rims.
/// The mesh has the points of A, of B, then new ones row by row. Faces run A_i+1, A_i, B_j: against A, along B. If both
/// sides advance at once, the shorter diagonal splits a quad into triangles.
/// @param points_a count_a points in order, at least 1; if closed at least 3, the first not repeated.
/// @param points_b as points_a.
/// @errors LOOP_TOO_SHORT, TOO_LARGE, NOT_FINITE, NO_STRIP
/// @complexity Meridians as in gusset_stitch, plus linear in the mesh; likewise memory.
/// @source Nesterenko, the intermediate mesh (H, P); Fuchs, Kedem and Uselton (1977) for the best strips.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_strip(const struct gusset_context *context, const double *points_a,
    size_t count_a, const double *points_b, size_t count_b, const struct gusset_strip_options *options,
    struct gusset_result **result);

/// Lends the report of a strip.
/// @errors WRONG_HANDLE
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_strip(const struct gusset_result *result,
    struct gusset_strip_report *report);

/* ---- Welding: Merges coincident vertices. */

/// Vertices that are welded.
typedef uint32_t gusset_weld_vertices;
/// Ends of boundary edges: sews coincident borders edge to edge.
#define GUSSET_WELD_BOUNDARY 0
/// All used vertices, for triangle soups.
#define GUSSET_WELD_ALL 1

/// Treatment of coincident corners of one face.
typedef uint32_t gusset_collapse;
/// Corners of one face stay apart.
#define GUSSET_COLLAPSE_NEVER 0
/// Corners of one face may be merged. Faces left with fewer than three vertices are dropped.
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
    /// - GUSSET_TOLERANCE_EXACT: 0; -0 equals 0.
    /// - GUSSET_TOLERANCE_AUTO: at most 2^-19 (32-bit) or 2^-48 (64-bit) of the largest coordinate, or, if more, twice
    ///   the last decimal place that positions show. At each vertex at most a quarter of the shortest edge; with
    ///   GUSSET_COLLAPSE_ALLOW, edges within the first limit are not counted.
    /// - Last decimal place: let D be the largest power of ten up to the longest side of the vertices' box. The place
    ///   is the largest of 1e-5 D, 1e-6 D, ... that divides a third of certain numbers: coordinates of the largest
    ///   order of magnitude, or differences between consecutive vertices. Multiples of 1e-4 D are left out; at least
    ///   eight other numbers are needed.
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
    /// Index of each vertex in the result; UINT32_MAX if removed as unused.
    struct gusset_indices vertex_map;
    /// Index of each face in the result; UINT32_MAX if dropped.
    struct gusset_indices face_map;
    /// Half-edges of boundary edges that coincide with another edge but are not sewn.
    struct gusset_indices left_edges;
    /// Vertices that coincide with another but are not merged.
    struct gusset_indices left_vertices;
    /// Vertices merged into a smaller one.
    uint32_t welded_vertices;
    /// Edges made from two boundary edges.
    uint32_t sewn_edges;
    /// Dropped faces.
    uint32_t dropped_faces;
    /// Pairs of boundary edges that coincide only within near_tolerance, and are not sewn.
    uint32_t near_edge_pairs;
    /// Largest distance at which vertices coincide, except at short edges; 0 for equal positions.
    double tolerance;
    /// Tolerance that sews these pairs, at most a tenth of the edges there; 0 without pairs.
    double near_tolerance;
} gusset_weld_report;

/// Merges coincident vertices.
/// - By default, borders are sewn: where exactly two boundary edges coincide, in either direction, they become one.
/// - Edges stay apart, and are listed, where three or more coincide, or sewing would collapse a face or make a
///   non-manifold edge: a manifold stays a manifold.
/// - Coincident vertices without an edge to sew stay apart.
/// - GUSSET_WELD_ALL merges all coincident vertices.
/// - In ascending order, each unclaimed vertex claims the unclaimed vertices within the tolerance, nearest first,
///   without chains.
/// - The result has the old faces, each from its first corner, and the remaining vertices in order. The smallest of
///   merged vertices remains, bit for bit. A result without faces is not a valid input.
/// @errors as gusset_mesh_view, OUT_OF_RANGE (tolerance)
/// @complexity O(H log H), if valences are small and few corners of one face coincide.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_weld(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_weld_options *options, struct gusset_result **result);

/// Lends the report of a weld.
/// @errors WRONG_HANDLE
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_weld(const struct gusset_result *result,
    struct gusset_weld_report *report);

/* ---- Sewing: Joins coincident borders, also where their vertices do not match. */

/// Effects of sewing. Lists are ascending.
typedef struct gusset_sew_report {
    size_t struct_size;
    /// Index of each old vertex in the result, as in gusset_weld_report.
    struct gusset_indices vertex_map;
    /// Index of each old face's first part in the result; UINT32_MAX if dropped.
    struct gusset_indices face_map;
    /// Old face of each face of the result.
    struct gusset_indices face_origin;
    /// Old vertices that coincide with another, or lie inside a boundary edge, but are not sewn.
    struct gusset_indices left_vertices;
    /// Vertices merged into a smaller one.
    uint32_t welded_vertices;
    /// Edges made from boundary edges or their parts.
    uint32_t sewn_edges;
    /// Points at which boundary edges were split.
    uint32_t splits;
    /// Old faces that were cut or gained corners.
    uint32_t split_faces;
    /// Dropped old faces.
    uint32_t dropped_faces;
    /// Pairs of boundary edges that coincide only within near_tolerance, and are not sewn.
    uint32_t near_edge_pairs;
    /// Largest distance at which elements coincide, except at short edges; 0 for equal positions.
    double tolerance;
    /// Tolerance that sews these pairs, at most a tenth of the edges there; 0 without pairs.
    double near_tolerance;
} gusset_sew_report;

/// Sews coincident borders.
/// - Vertices are welded as by gusset_weld.
/// - Where a vertex of one border then lies inside a boundary edge of another (a T-junction), the edge is split if
///   exactly two pieces coincide. Triangles are cut into triangles, none turned over; larger faces gain corners.
/// - Borders are welded again.
/// - A vertex lies inside an edge, longer than twice the tolerance, if it is within the tolerance of the edge and not
///   of its ends.
/// - Splitting makes no non-manifold edges and no degenerate faces.
/// - The result has the old faces in order, or their parts in their places. The smallest of merged vertices remains,
///   bit for bit. New vertices have the position of an old one.
/// @param options as for gusset_weld. GUSSET_WELD_ALL welds all vertices before the splits, borders afterwards.
/// @errors as gusset_weld, TOO_LARGE (the result)
/// @complexity O(H log H), if valences are small and few vertices lie inside each edge.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sew(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_weld_options *options, struct gusset_result **result);

/// Lends the report of a sewing.
/// @errors WRONG_HANDLE
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_sew(const struct gusset_result *result,
    struct gusset_sew_report *report);

/* ---- Orientation: Turns faces over until neighbours agree. */

/// Options of gusset_orient.
typedef struct gusset_orient_options {
    size_t struct_size;
    /// For closed components.
    gusset_outward outward;
    uint32_t reserved;
} gusset_orient_options;

/// Faces that were turned over, and components that cannot be oriented.
typedef struct gusset_orient_report {
    size_t struct_size;
    /// For each face, 1 if it was turned over. @flag
    const uint8_t *turned;
    size_t face_count;
    /// Smallest face of each non-orientable component, ascending.
    struct gusset_indices one_sided_faces;
    /// For each of them, a half-edge at which its faces cannot agree.
    struct gusset_indices one_sided_half_edges;
    /// Faces turned over.
    uint32_t turned_faces;
    /// Components: faces connected across edges with two faces. A degenerate face is a component.
    uint32_t component_count;
    /// Closed components that face outwards only by GUSSET_OUTWARD_CLOSED.
    uint32_t inverted_components;
    uint32_t reserved;
} gusset_orient_report;

/// Turns faces over until the two faces of each edge run it in opposite directions.
/// In each component the fewest faces are turned; on a tie, its smallest face stays. Non-manifold edges connect
/// nothing. Non-orientable components stay unchanged and are listed. A turned face keeps its first corner. Vertices and
/// the order of faces do not change.
/// @errors as gusset_mesh_view
/// @complexity O(H log d).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_orient(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_orient_options *options, struct gusset_result **result);

/// Lends the report of an orientation.
/// @errors WRONG_HANDLE
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_orient(const struct gusset_result *result,
    struct gusset_orient_report *report);

/* ---- Repair: Makes a valid solid of any polygon mesh, and unites solids. */

/// Options of gusset_repair. By default every stage runs.
typedef struct gusset_repair_options {
    size_t struct_size;
    /// Distance at which borders coincide, as in gusset_weld_options.
    gusset_tolerance_mode tolerance_mode;
    /// 1: borders are not sewn. @flag
    uint32_t leave_borders;
    /// Largest distance of coincident borders, finite, at least 0.
    /// @when tolerance_mode GUSSET_TOLERANCE_GIVEN
    double tolerance;
    /// 1: faces without area stay. @flag
    uint32_t leave_flat_faces;
    /// 1: duplicate faces stay. @flag
    uint32_t leave_duplicates;
    /// 1: non-manifold edges and vertices stay, and faces within the solid. @flag
    uint32_t leave_non_manifold;
    /// 1: holes stay open. @flag
    uint32_t leave_holes;
    /// 1: open sheets stay that were attached to a closed component. @flag
    uint32_t leave_fins;
    /// 1: no component is oriented. @flag
    uint32_t leave_orientation;
    /// 1: faces that intersect stay. @flag
    uint32_t leave_intersections;
    uint32_t reserved;
    /// Options of filling. Ignores groups, outward and plan_only; the last two must be valid.
    const struct gusset_fill_options *fill_options;
} gusset_repair_options;

/// Makes a valid solid of a mesh, and changes only faces at its defects. Stages, in order:
/// - Borders that coincide are sewn, as by gusset_sew. Without a given tolerance, narrow gaps are closed.
/// - Faces without area are dropped; their neighbours meet in their place.
/// - Duplicate faces are dropped, except the first.
/// - Holes are filled, as by gusset_fill.
/// - Where edges have three or more faces, the faces divide space into cells. Faces with the solid on both sides are
///   dropped. The others are separated into sheets with their own vertices.
/// - Holes of separated sheets are filled. Open sheets that were attached to a closed component are dropped.
/// - Components are oriented, and closed ones turned outwards.
/// - Closed components with faces that intersect are replaced by their union: the border of the points with a winding
///   number of at least 1. Faces that no other meets stay as they are.
/// The solid consists of the cells with a winding number other than 0, if crossing faces from front to back adds 1
/// consistently; otherwise of all bounded cells. Old faces keep their order, and old vertices their bits. Unused
/// vertices are removed. Vertices merged by the mesh's merge map stay merged. Faces of open components that intersect
/// stay, and are listed. A second repair of a valid result changes nothing.
/// @errors as gusset_weld, OUT_OF_RANGE, TOO_LARGE (the result)
/// @complexity O(H log H), the time of gusset_fill for each hole, and the search for intersecting faces.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_repair(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_repair_options *options, struct gusset_result **result);

/// Unites closed pieces: returns the border of all points with a winding number of at least 1. Pieces may intersect,
/// touch, coincide or lie within each other, and intersect themselves. Walls of cavities look into the cavities.
/// Inverted parts outside vanish. Faces that no other meets stay as they are, and old vertices keep their bits. New
/// vertices are rounded to the first piece's scalar type. Border edges of two pieces may close each other.
/// gusset_result_get_repair lends the report. Old vertices and faces are numbered piece after piece. Dropped faces have
/// the reason GUSSET_DROP_OVERLAP. Intersecting pairs remain only where rounding makes them again and again.
/// @param pieces at least one; struct_size of the first holds for all.
/// @errors as gusset_mesh_view, EMPTY_MESH (also if nothing remains), MIXED_SCALARS, MESH_NOT_CLOSED (input and index
///     name a face at an open edge), TOO_LARGE
/// @complexity O((n + k) log n) for n triangles of which k pairs intersect.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_unite(const struct gusset_context *context,
    const struct gusset_mesh_view *pieces, size_t piece_count, struct gusset_result **result);

struct gusset_repair_report;

/// Lends the report of a repair or a union.
/// @errors WRONG_HANDLE
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_repair(const struct gusset_result *result,
    struct gusset_repair_report *report);

/* ---- Report of a repair: Lists the changes and the defects that remain. */

/// Reason why a face was dropped.
typedef uint32_t gusset_drop_reason;
/// Fewer than three different vertices remain.
#define GUSSET_DROP_DEGENERATE 0
/// The area is 0 up to rounding.
#define GUSSET_DROP_ZERO_AREA 1
/// An earlier face has the same vertices.
#define GUSSET_DROP_DUPLICATE 2
/// The solid lies on both sides.
#define GUSSET_DROP_INSIDE 3
/// Part of an open sheet that was attached to a closed component.
#define GUSSET_DROP_FIN 4
/// The face lies in an overlapping part, or on an inverted part.
#define GUSSET_DROP_OVERLAP 5

/// Effects of a repair, and the defects that remain.
typedef struct gusset_repair_report {
    size_t struct_size;
    /// 1 if the result bounds a solid: closed, manifold, oriented, without degenerate, duplicate or intersecting faces,
    /// and without faces of area 0. @flag
    uint32_t valid;
    /// Vertices merged into others.
    uint32_t welded_vertices;
    /// Edges made from boundary edges or their parts.
    uint32_t sewn_edges;
    /// Old faces that were split or gained corners when borders were sewn.
    uint32_t split_faces;
    /// Copies of vertices that separate sheets of faces.
    uint32_t split_vertices;
    /// Holes that were filled.
    uint32_t filled_holes;
    /// Boundary edges of the result.
    uint32_t boundary_edges_left;
    /// Non-manifold edges of the result.
    uint32_t non_manifold_edges_left;
    /// Non-manifold vertices of the result.
    uint32_t non_manifold_vertices_left;
    /// Edges of the result whose two faces disagree in orientation.
    uint32_t orientation_conflicts_left;
    /// Degenerate, duplicate and zero-area faces of the result.
    uint32_t bad_faces_left;
    uint32_t reserved;
    /// Largest distance at which vertices were merged; 0 without any.
    double tolerance;
    /// Old face of each face, or of which it is a part; UINT32_MAX for faces of patches, which come last.
    struct gusset_indices face_origin;
    /// Smallest old vertex that each vertex is; UINT32_MAX for new vertices, which come last.
    struct gusset_indices vertex_origin;
    /// For each face, 1 if it was turned over. @flag
    const uint8_t *turned;
    size_t face_count;
    /// Dropped old faces, ascending. Faces with a remaining part are not listed.
    struct gusset_indices dropped_faces;
    /// Reason for each of them.
    const gusset_drop_reason *drop_reasons;
    size_t dropped_count;
    /// Pairs of faces that intersect in the result, ascending, the smaller face first.
    struct gusset_indices intersecting_pairs;
} gusset_repair_report;

/* ---- Triangulation: Splits faces into triangles. */

/// Splits all faces into triangles of their own corners, in the order of the faces.
/// A face of n corners becomes n - 2 triangles that use all its corners: a closed mesh stays closed. Vertices keep
/// their indices and bits.
/// - A quad is split by its shorter diagonal, or by the diagonal inside if it is concave.
/// - A larger face becomes a fan from its first corner if this corner sees all others, as in a convex face. Otherwise
///   its ears are cut off, in projection along a coordinate axis. Edges that the face passes twice, to reach a hole,
///   are allowed.
/// - If triangles of a face of at most 40 corners overlap, because the face is warped or crosses itself, the split with
///   the least overlap replaces them.
/// gusset_result_origins_create gives the old face and corners of each triangle.
/// @errors as gusset_mesh_view
/// @complexity O(H); for a face of n corners that is not convex O(n log n), and at most 1000 tests a corner.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_triangulate(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, struct gusset_result **result);

/* ---- Alignment: Finds the rigid poses at which overlapping pieces fit. */

/// Initial poses.
typedef uint32_t gusset_alignment_start;
/// As given, moved by poses if any.
#define GUSSET_ALIGN_AS_GIVEN 0
/// Principal axes on the first piece's, in the one of four ways that puts most of the piece on it. For pieces that show
/// one object whole.
#define GUSSET_ALIGN_PRINCIPAL_AXES 1
/// Rims of like shape put together; they then hold the pieces. For parts of a cut or broken surface without overlap.
#define GUSSET_ALIGN_RIMS 2

/// Verdict on the pose of a piece.
typedef uint32_t gusset_aligned_reason;
/// Trusted: the piece fits trusted pieces, up to the first. The fit is judged to a mean edge: a slightly scaled or
/// mirrored smooth surface may pass. Pieces that could only slide together also pass.
#define GUSSET_ALIGNED_TRUSTED 0
/// The piece lacks faces with area, or overlaps others too little.
#define GUSSET_ALIGNED_NO_OVERLAP 1
/// Too much of the piece near others is off their surfaces.
#define GUSSET_ALIGNED_POOR_FIT 2
/// Up to the noise of normals, the piece is free to slide or turn.
#define GUSSET_ALIGNED_UNDETERMINED 3
/// Most of the overlap has opposite normals: the piece is inside out, or mirrored.
#define GUSSET_ALIGNED_FACES_OTHER_WAY 4
/// The piece overlaps nothing, and is over 50 times larger or smaller than the first: its unit probably differs.
#define GUSSET_ALIGNED_OTHER_SIZE 5
/// The piece fits untrusted pieces only.
#define GUSSET_ALIGNED_TRUSTED_BY_NONE 6

/// Options of gusset_alignment_create.
typedef struct gusset_alignment_options {
    size_t struct_size;
    gusset_alignment_start start;
    /// Points of a piece to match; 0: 2,000.
    uint32_t samples;
    /// Rigid motions of the pieces, or NULL.
    /// @when start GUSSET_ALIGN_AS_GIVEN
    const struct gusset_transform *poses;
    size_t pose_count;
    /// Largest distance of matched points, and about how far a piece may move; finite, at least 0. 0: a tenth of the
    /// largest piece's box diagonal.
    double max_distance;
    /// Rounds in each of two stages, at most; 0: 100.
    uint32_t max_rounds;
    uint32_t reserved;
} gusset_alignment_options;

/// Pose of one piece.
typedef struct gusset_aligned_piece {
    /// Rigid motion from the given positions.
    struct gusset_transform pose;
    /// How firmly overlaps hold the piece, 0 to 1; 1 for the first. RMS change of matched distances under the unit
    /// motion that changes them least, turns in radii of the piece.
    double hold;
    gusset_aligned_reason reason;
    uint32_t reserved;
} gusset_aligned_piece;

/// Overlap of two pieces in their final poses.
typedef struct gusset_overlap {
    /// The pieces, ascending.
    uint32_t pieces[2];
    /// Fraction of each piece's points on the other, within a mean edge; 0 to 1.
    double shares[2];
    /// Mean distance of these points from the other surface.
    double mean;
    /// RMS distance of these points.
    double rms;
    /// Fraction on the other piece of the points within 8 mean edges of it, 0 to 1.
    double fit;
    /// Points on the other piece.
    uint32_t count;
    /// 1 if count is at least 30 and fit at least 2/3. @flag
    uint32_t trusted;
} gusset_overlap;

/// Poses and overlaps.
typedef struct gusset_alignment_view {
    size_t struct_size;
    /// Pieces in order.
    const struct gusset_aligned_piece *pieces;
    size_t piece_count;
    /// Pairs of overlapping pieces.
    const struct gusset_overlap *overlaps;
    size_t overlap_count;
    /// Rounds done.
    uint32_t rounds;
    /// 1 if the pieces stopped moving before the rounds ran out. @flag
    uint32_t converged;
} gusset_alignment_view;

/// Poses of overlapping pieces.
typedef struct gusset_alignment gusset_alignment;

/// Finds rigid motions that fit overlapping pieces, all at once. The first piece stays.
/// Points match the nearest points of other pieces, except beyond borders, or if normals differ by over 45 degrees.
/// Distant matches weigh less. A piece without overlap stays at its start; an underdetermined piece may slide.
/// @param pieces as for gusset_join.
/// @errors as gusset_mesh_view, EMPTY_MESH, OUT_OF_RANGE (max_distance; a pose that is not rigid, by index),
///     COUNT_DIFFERS (fewer poses than pieces), TOO_LARGE
/// @complexity O(V log V) for V vertices of a piece, and in each of usually 10 to 30 rounds O(samples log V) a piece
///     and neighbour; GUSSET_ALIGN_RIMS: 512^2 for two pieces.
/// @source Besl and McKay 1992; Chen and Medioni 1992; Turk and Levoy 1994; Neugebauer 1997; Rusinkiewicz 2019.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_alignment_create(const struct gusset_context *context,
    const struct gusset_mesh_view *pieces, size_t piece_count, const struct gusset_alignment_options *options,
    struct gusset_alignment **alignment);

/// Destroys an alignment.
GUSSET_API void gusset_alignment_destroy(struct gusset_alignment *alignment);

/// Lends the poses and overlaps.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_alignment_get_view(const struct gusset_alignment *alignment,
    struct gusset_alignment_view *view);

/* ---- Trimming: Keeps one piece of each overlap. */

/// Options of gusset_trim_create.
typedef struct gusset_trim_options {
    size_t struct_size;
    /// Largest distance of surfaces that count as one, finite, at least 0. 0: 4 mean edges of the coarser piece.
    double max_distance;
    /// Largest angle between their normals, at least 0, below pi / 2; 0: 60 degrees.
    double max_angle;
    /// A point for each piece, or NULL. Parts seen at flat angles weigh less.
    const double *viewpoints;
    size_t viewpoint_count;
    /// Islands of fewer faces are removed; 0: 30. The limit is 20 times that for islands that other pieces also show.
    /// Holes below that limit are not made.
    uint32_t min_faces;
    uint32_t reserved;
} gusset_trim_options;

/// Kept faces of a piece.
typedef struct gusset_trimmed_piece {
    /// Indices of the faces, ascending.
    struct gusset_indices kept;
    /// Vertices that lie on another piece.
    size_t covered_vertices;
} gusset_trimmed_piece;

/// Result of trimming.
typedef struct gusset_trim_view {
    size_t struct_size;
    /// Kept faces of each piece.
    const struct gusset_trimmed_piece *pieces;
    size_t piece_count;
    /// Faces removed at last, with their neighbours, for intersecting an earlier piece.
    uint32_t crossings;
    uint32_t reserved;
} gusset_trim_view;

/// Result of trimming.
typedef struct gusset_trim gusset_trim;

/// Keeps one piece of each overlap, with a narrow gap that gusset_join closes; see GUSSET_OVERLAPS_TRIM.
/// Cuts run where two pieces are equally good; up to noise, the earlier piece is kept. A vertex is better farther from
/// its piece's borders, in mean edges, and seen less flat from its viewpoint. Loops of under 32 vertices are holes, not
/// borders. A vertex lies on another piece if the nearest point is close, faces the same way, and is not on a border.
/// No vertex moves, and no face is split. Parts thinner than two faces, small islands, faces attached by one vertex,
/// and faces that intersect an earlier piece are removed.
/// @param pieces as for gusset_join, in one coordinate system.
/// @errors as gusset_mesh_view, EMPTY_MESH, OUT_OF_RANGE (max_distance, max_angle), NOT_FINITE (a viewpoint),
///     COUNT_DIFFERS (fewer viewpoints than pieces), TOO_LARGE
/// @complexity O(V log F) for V vertices of a piece and F faces of each near piece, up to quadratic in the faces at one
///     place.
/// @source After Turk and Levoy 1994.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_trim_create(const struct gusset_context *context,
    const struct gusset_mesh_view *pieces, size_t piece_count, const struct gusset_trim_options *options,
    struct gusset_trim **trim);

/// Destroys a result of trimming.
GUSSET_API void gusset_trim_destroy(struct gusset_trim *trim);

/// Lends the kept faces.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_trim_get_view(const struct gusset_trim *trim,
    struct gusset_trim_view *view);

/* ---- Boundary loops: Finds boundary loops and defects. */

/// Treatment of non-manifold edges.
typedef uint32_t gusset_non_manifold;
/// Each face has its own border there; loops along it are always closed.
#define GUSSET_NON_MANIFOLD_CUT 0
/// Loops have boundary edges only, and end at non-manifold ones as open chains.
#define GUSSET_NON_MANIFOLD_STOP 1

/// Part of the mesh that is checked.
typedef uint32_t gusset_survey;
/// Every edge: all defects are reported, and flagged on the loops.
#define GUSSET_SURVEY_WHOLE_MESH 0
/// The boundary only, many times faster. Checks the whole mesh if the boundary is open, touches itself, is not oriented
/// or has edges with three faces.
/// Other defects are not reported. Edges with equal numbers of faces in both directions, two or more, do not cut loops.
/// The search relies on hashes. It fails with a probability below 2^-64, but a malicious mesh may hide a boundary: for
/// untrusted meshes, use GUSSET_SURVEY_WHOLE_MESH.
#define GUSSET_SURVEY_BOUNDARY_ONLY 1

/// Properties of a loop.
/// @bits
typedef uint32_t gusset_loop_flags;
/// The loop is an open chain, with one vertex more than edges.
#define GUSSET_LOOP_OPEN 1
/// The loop passes a vertex where the surface touches itself.
#define GUSSET_LOOP_BOW_TIE 2
/// The loop was cut from a longer walk that passes a vertex twice.
#define GUSSET_LOOP_SPLIT 4
/// The loop runs along, or ends at, a non-manifold edge.
#define GUSSET_LOOP_NON_MANIFOLD 8
/// The faces along the loop disagree in orientation.
#define GUSSET_LOOP_NOT_ORIENTED 16
/// The loop has an edge of length 0.
#define GUSSET_LOOP_ZERO_LENGTH 32

/// Properties of an edge of a loop.
/// @bits
typedef uint8_t gusset_edge_flags;
/// The loop runs this edge against its face.
#define GUSSET_EDGE_REVERSED 1
/// The edge is non-manifold.
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
/// The faces at a vertex (index) form more than one fan. Ends of non-manifold edges are listed too where a loop passes
/// them.
#define GUSSET_DEFECT_BOW_TIE 4

/// Boundary loops of a mesh.
typedef struct gusset_boundary gusset_boundary;

/// Options of gusset_boundary_create.
typedef struct gusset_boundary_options {
    size_t struct_size;
    gusset_non_manifold non_manifold;
    gusset_survey survey;
} gusset_boundary_options;

/// Boundary loop or open chain. Edge i runs from vertices[i] to vertices[i + 1], cyclically in a loop.
typedef struct gusset_loop_view {
    size_t struct_size;
    /// Vertices, each once. A closed loop starts at its smallest half-edge.
    struct gusset_indices vertices;
    /// Half-edge of each edge.
    struct gusset_indices half_edges;
    /// Face beside each edge.
    struct gusset_indices faces;
    /// Properties of each edge.
    const gusset_edge_flags *edge_flags;
    /// Sum of the edge lengths.
    double length;
    /// Properties of the loop; 0 if ordinary and closed.
    gusset_loop_flags flags;
    /// Walk that the loop was cut from.
    uint32_t walk;
} gusset_loop_view;

/// Defect of a mesh.
typedef struct gusset_defect {
    gusset_defect_kind kind;
    /// Face, half-edge or vertex.
    uint32_t index;
    /// Second element, or UINT32_MAX.
    uint32_t other;
    /// Half-edges for GUSSET_DEFECT_NON_MANIFOLD_EDGE; else 0.
    uint32_t count;
} gusset_defect;

/// Loop count and defects of a boundary.
typedef struct gusset_boundary_view {
    size_t struct_size;
    /// Loops and open chains; 0 if the mesh is closed.
    size_t loop_count;
    /// Walks that loops were cut from. Loops that touch share a walk if it passes from one to the other.
    size_t walk_count;
    /// Degenerate faces, orientation conflicts, non-manifold edges, and bow-ties on the boundary.
    const struct gusset_defect *defects;
    size_t defect_count;
} gusset_boundary_view;

/// Finds all boundary loops: chains of boundary edges.
/// Loops run as the faces along them: seen from outside, with counter-clockwise faces, the surface is on the left.
/// - Each loop passes a vertex once: a boundary that touches itself is cut. A loop may have only two vertices.
/// - Loops are in the order of their smallest half-edges.
/// - Walks along only non-manifold edges are left out, except loops cut from other walks.
/// - A face with fewer than three sides between different vertices lacks a border; its neighbours count as adjacent.
/// @errors as gusset_mesh_view
/// @complexity O(H log d); GUSSET_SURVEY_BOUNDARY_ONLY O(H + B log B) for B boundary edges.
/// @source Nesterenko, algorithm 1, corrected.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_boundary_create(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_boundary_options *options,
    struct gusset_boundary **boundary);

/// Destroys a boundary.
GUSSET_API void gusset_boundary_destroy(struct gusset_boundary *boundary);

/// Lends the counts and defects.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_boundary_get_view(const struct gusset_boundary *boundary,
    struct gusset_boundary_view *view);

/// Lends one loop.
/// @param index below loop_count of gusset_boundary_view.
/// @errors NO_SUCH_ELEMENT
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
/// The mesh is oriented, or would be after turning faces over.
#define GUSSET_MESH_ORIENTABLE 8

/// Findings of a check.
typedef struct gusset_check gusset_check;

/// Counts, properties and defects of a mesh. Lists are ascending. Degenerate faces have no edges.
typedef struct gusset_check_view {
    size_t struct_size;
    /// Vertices, also unused ones.
    uint32_t vertex_count;
    /// Distinct edges, between different vertices.
    uint32_t edge_count;
    /// Faces.
    uint32_t face_count;
    /// Components: faces connected by shared edges.
    uint32_t component_count;
    /// As walk_count of gusset_boundary_view.
    uint32_t boundary_walk_count;
    gusset_mesh_flags properties;
    /// Used vertices - edges + faces: the Euler characteristic without degenerate faces.
    int64_t euler;
    /// Handles of all components together; -1 if not manifold or orientable, or with a degenerate face.
    int64_t genus;
    /// Half-edges of boundary edges.
    struct gusset_indices boundary_edges;
    /// First half-edge of each non-manifold edge.
    struct gusset_indices non_manifold_edges;
    /// Ends of non-manifold edges, and bow-ties.
    struct gusset_indices non_manifold_vertices;
    /// Vertices whose faces form more than one fan; usually also ends of non-manifold edges.
    struct gusset_indices bow_ties;
    /// First half-edge of each edge whose two faces run it in the same direction.
    struct gusset_indices orientation_conflicts;
    /// Faces with the cycle of vertices of an earlier face, in either direction; none degenerate.
    struct gusset_indices duplicate_faces;
    /// Faces that repeat a vertex.
    struct gusset_indices degenerate_faces;
    /// Other faces whose vector area is 0 up to rounding.
    struct gusset_indices zero_area_faces;
    /// Vertices that no face uses.
    struct gusset_indices unused_vertices;
} gusset_check_view;

/// Checks the topology of a mesh.
/// @errors as gusset_mesh_view
/// @complexity O(H log d).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_check_create(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, struct gusset_check **check);

/// Destroys a check.
GUSSET_API void gusset_check_destroy(struct gusset_check *check);

/// Lends the findings.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_check_get_view(const struct gusset_check *check,
    struct gusset_check_view *view);

/* ---- Certificates: States facts about a result that a program without the library can check. */

/// Facts about a result and the meshes that it was made from.
typedef struct gusset_certificate gusset_certificate;

/// Facts about a result. Faces match if they have the same positions at their corners, from any corner; -0 equals 0.
/// Each result face matches at most one face of the pieces. Faces with fewer than three edges between different
/// vertices have no edges.
typedef struct gusset_certificate_view {
    size_t struct_size;
    /// Vertices that faces use.
    uint32_t vertex_count;
    /// Distinct edges, between different vertices.
    uint32_t edge_count;
    /// Faces.
    uint32_t face_count;
    /// Components: faces connected by shared edges.
    uint32_t component_count;
    /// 1 if there are edges, and each has exactly two faces. @flag
    uint32_t closed;
    /// 1 if closed and oriented without intersecting pairs, and each component faces outwards. A component that an odd
    /// number of others encloses has a negative volume, any other a positive one. @flag
    uint32_t outward;
    /// Edges with one face.
    uint32_t boundary_edges;
    /// Edges with three or more faces.
    uint32_t non_manifold_edges;
    /// Ends of non-manifold edges, and vertices whose faces form several fans.
    uint32_t non_manifold_vertices;
    /// Edges whose two faces run them in the same direction.
    uint32_t orientation_conflicts;
    /// Faces that repeat a vertex.
    uint32_t degenerate_faces;
    /// Faces with the cycle of vertices of an earlier face, in either direction; none degenerate.
    uint32_t duplicate_faces;
    /// Triangles whose three different vertices lie on one line, also triangles of polygons.
    uint32_t collinear_triangles;
    /// Faces of the result that match no face of the pieces.
    uint32_t new_faces;
    /// Pairs of faces with common points other than common vertices and edges.
    uint64_t intersecting_pairs;
    /// Faces of the pieces that the result has.
    uint64_t kept_faces;
    /// Faces of the pieces that the result has only reversed, as (piece, face), ascending.
    struct gusset_indices turned_faces;
    /// Faces of the pieces that the result lacks, as (piece, face), ascending.
    struct gusset_indices lost_faces;
    /// Largest distance of a vertex of the pieces from the nearest vertex of the result, where faces use both; 0 if all
    /// such vertices remain.
    double farthest_distance;
    /// Piece of the farthest vertex; UINT32_MAX without one.
    uint32_t farthest_piece;
    /// The farthest vertex; UINT32_MAX without one.
    uint32_t farthest_vertex;
    /// Vertex of the result nearest to it; UINT32_MAX without one.
    uint32_t nearest_vertex;
    uint32_t reserved;
    /// Triangles of the result's faces with more than three corners, as half-edges, face by face.
    struct gusset_indices polygon_triangles;
} gusset_certificate_view;

/// States facts about a result and the pieces that it was made from. The result may come from anywhere. verify.py
/// confirms or refutes them by exact arithmetic, without the library.
/// All facts are exact, except farthest_distance. outward is 0 also if undecided: if a volume is 0 up to rounding, or
/// if a component shares the positions of all its vertices with others.
/// @param pieces the meshes that the result was made from; may be NULL without any.
/// @errors as gusset_mesh_view, TOO_LARGE (vertices of all meshes)
/// @complexity O(n log n) for n corners of all meshes, and the search for intersecting faces.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_certificate_create(const struct gusset_context *context,
    const struct gusset_mesh_view *pieces, size_t piece_count, const struct gusset_mesh_view *result,
    struct gusset_certificate **certificate);

/// Destroys a certificate.
GUSSET_API void gusset_certificate_destroy(struct gusset_certificate *certificate);

/// Lends the facts.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_certificate_get_view(const struct gusset_certificate *certificate,
    struct gusset_certificate_view *view);

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
    /// Most darts: cuts from a chart's border to where it is curved.
    uint32_t max_darts;
    /// Vertices of the paths to cut along, path after path, connected by the shortest paths along edges. A path of one
    /// vertex cuts nothing.
    struct gusset_indices cuts;
    /// Start of each path in cuts, and the end of the last. Empty: one path.
    struct gusset_indices cut_offsets;
    /// Darts stop once no length changes by a larger factor; above 1, finite. 0: no limit.
    double max_stretch;
    /// Most steps of a descent; 0: 200. Charts whose border would meet itself, and GUSSET_DISTORTION_RIGID, need
    /// several descents.
    uint32_t max_iterations;
    uint32_t reserved;
} gusset_develop_options;

/// Flattens a surface with the least distortion.
/// The surface is cut along the given paths; components that are not discs are then opened along short paths. Each
/// connected component of the rest is a chart. The result has the surface's scalar type and z = 0; faces keep their
/// order and first corners, and are counter-clockwise.
/// - A chart that unfolds about its edges keeps their lengths. The error is at most 1e-10 of the length, or of 1e-3
///   mean edges if more, before rounding, which grows with the distance from the origin. The chart may overlap itself,
///   and rounding may turn over triangles without area.
/// - Other charts descend to the least distortion. The map is one-to-one: no triangle is turned over, and the border
///   does not meet itself. If this ends the descent early, finish is GUSSET_CHART_STALLED.
/// - Darts are made while they lower the distortion, from the border to the vertex with the worst conformal scale.
/// - Each chart's border has the greatest variance along x.
/// - A vertex on a cut becomes several. Merged vertices count as the smallest.
/// - Non-manifold edges, and edges whose faces disagree in orientation, are borders, not cuts.
/// - Polygons are measured by triangles. A triangle flatter than 1e-7 of its longest side, or smaller than 1e-7 of the
///   mean edge, counts as that large.
/// - A conformal map has the area of the surface.
/// @errors as gusset_mesh_view, OUT_OF_RANGE (max_stretch), BAD_OFFSETS (cut_offsets), INDEX_OUT_OF_RANGE (input is the
///     cut, index the place in it), CUT_NOT_CONNECTED (likewise), REPEATED_CORNER
/// @complexity O(H log H) if charts unfold; else O(n^1.5) for n vertices of a chart, each step and each dart; memory
///     O(n log n).
/// @source Rabinovich et al. 2017, for the descent; Levy et al., Least squares conformal maps, 2002; Erickson and
///     Whittlesey 2005, for opening cuts; Ben-Chen et al. 2008, for darts.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_develop(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_develop_options *options, struct gusset_result **result);

struct gusset_develop_report;

/// Lends the report of a development.
/// @errors WRONG_HANDLE
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_develop(const struct gusset_result *result,
    struct gusset_develop_report *report);

/* ---- Developments: reports: Charts, cuts and distortion. */

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
/// The map with the least symmetric distortion: the conformal map folds or overlaps.
#define GUSSET_CHART_NOT_CONFORMAL 4
/// Some triangles are turned over: no map without folds was found.
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
    /// First vertex in the result; the chart's vertices are consecutive.
    uint32_t first_vertex;
    uint32_t vertex_count;
    uint32_t face_count;
    gusset_chart_finish finish;
    /// Steps of all descents.
    uint32_t iterations;
    /// Pairs of border edges that meet in the plane, except neighbours. GUSSET_CHART_EXACT: crossings by more than 1e-8
    /// of the root of the area. GUSSET_CHART_FOLDED: all. Else 0.
    uint32_t overlaps;
    /// Triangles turned over; 0 unless finish is GUSSET_CHART_FOLDED.
    uint32_t folds;
    uint32_t reserved;
    /// Symmetric Dirichlet energy: the mean over the area of the sum of s^2 + 1 / s^2 for both singular values s of the
    /// map. An isometry has the least, 4.
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
    /// x, y of each vertex in the plane.
    const double *points;
    /// Vertex of the surface for each vertex; repeats on cuts.
    struct gusset_indices vertex_map;
    /// Chart of each face.
    struct gusset_indices face_charts;
    /// Largest and smallest factor by which lengths grow, for each face.
    const double *stretches;
    /// Charts in the order of their first faces, side by side along x.
    const struct gusset_chart *charts;
    size_t chart_count;
    /// Cut edges of the surface, two vertices each: given, opening, then dart cuts.
    struct gusset_indices cut_edges;
    /// GUSSET_CUT_... of each cut edge.
    struct gusset_indices cut_kinds;
    /// Darts.
    uint32_t darts;
    uint32_t reserved;
} gusset_develop_report;

/* ---- Facing arcs: Finds which vertices of two loops face each other. */

/// Facing vertices of two loops.
typedef struct gusset_facing gusset_facing;

/// Options of gusset_facing_create.
typedef struct gusset_facing_options {
    size_t struct_size;
    gusset_facing_run run;
    gusset_tolerance_mode tolerance_mode;
    /// As in gusset_stitch_options.
    /// @when tolerance_mode GUSSET_TOLERANCE_GIVEN
    double tolerance;
    gusset_centres centres;
    uint32_t reserved;
} gusset_facing_options;

/// Facing vertices; index 0 is loop A, 1 is loop B.
typedef struct gusset_facing_view {
    size_t struct_size;
    /// Centres C_1 and C_2, equation 5.
    double centre[2][3];
    /// Normals C_2 - C_1 and C_1 - C_2 of the planes, equations 6 and 7.
    double normal[2][3];
    /// Signed distance of each vertex from its plane, positive towards the other loop.
    const double *distances[2];
    /// First index and length of each run of facing vertices, alternating; a run may pass the loop's end.
    struct gusset_indices runs[2];
    /// The chosen run, as arc_a and arc_b of gusset_stitch_options.
    uint32_t taken[2][2];
    /// Vertices of each loop.
    size_t counts[2];
} gusset_facing_view;

/// Finds the vertices of two loops that face each other.
/// @param points_a count_a vertices in order, at least 1.
/// @param points_b as points_a.
/// @errors LOOP_TOO_SHORT, TOO_LARGE, NOT_FINITE, OUT_OF_RANGE, PLANES_UNDECIDED (the centres coincide, or no vertex of
///     a loop exceeds the tolerance)
/// @complexity O((N + M) log M).
/// @source Nesterenko, algorithm 2, equations 5-7.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_facing_create(const struct gusset_context *context,
    const double *points_a, size_t count_a, const double *points_b, size_t count_b,
    const struct gusset_facing_options *options, struct gusset_facing **facing);

/// Destroys facing vertices.
GUSSET_API void gusset_facing_destroy(struct gusset_facing *facing);

/// Lends the facing vertices.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_facing_get_view(const struct gusset_facing *facing,
    struct gusset_facing_view *view);

/// Computes GUSSET_MERIDIANS_INDEX. For each i = 0 .. n, j of 0 .. m makes |m i - n j| least; on ties the later one.
/// @param n segments of the longer polyline: N - 1 if open with N vertices, N if closed.
/// @param m segments of the other polyline, at most n (OUT_OF_RANGE).
/// @param j receives n + 1 numbers.
/// @param written receives the count.
/// @errors OUT_OF_RANGE, BUFFER_TOO_SMALL
/// @complexity O(n).
/// @source Nesterenko, the intermediate mesh: j = floor((2 m i + n) / (2 n)).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_meridians_index(uint32_t n, uint32_t m, uint32_t *j, size_t capacity,
    size_t *written);

/* ---- Mesh sections: Cuts meshes by planes into ordered polylines. */

/// The side of a plane to which vertices in the plane belong.
typedef uint32_t gusset_in_plane;
/// They count as above: the section is the limit of sections just below the plane.
#define GUSSET_IN_PLANE_ABOVE 0
/// They count as below: the section is the limit of sections just above the plane.
#define GUSSET_IN_PLANE_BELOW 1

/// How cutting planes are given.
typedef uint32_t gusset_cutting_kind;
/// Parallel planes with the normal `direction`, at the rising distances `values` from `point`.
#define GUSSET_CUTTING_STACK 0
/// Planes through `points`, each with its normal in `normals`.
#define GUSSET_CUTTING_PLANES 1
/// Planes that contain the axis through `point` along `direction`, turned from `reference` by the angles `values` about
/// the axis. Normals point to larger angles.
#define GUSSET_CUTTING_AXIS 2
/// Planes across the polyline `points`, at the distances `values` from its first point along it. They turn evenly from
/// the bisector at one vertex to the bisector at the next.
#define GUSSET_CUTTING_CURVE 3

/// Planes that cut a mesh. Only the fields of their kind are read.
typedef struct gusset_cutting_planes {
    size_t struct_size;
    gusset_cutting_kind kind;
    /// CURVE. 1: the polyline returns to its first point.
    uint32_t closed;
    /// STACK, AXIS: a point at distance 0, or of the axis.
    double point[3];
    /// STACK, AXIS: not 0.
    double direction[3];
    /// AXIS: not parallel to `direction`.
    double reference[3];
    /// STACK, AXIS, CURVE: distances or angles.
    const double *values;
    size_t value_count;
    /// PLANES, CURVE: x, y, z each.
    const double *points;
    /// PLANES: x, y, z each, not 0.
    const double *normals;
    /// Number of points, and of normals.
    size_t point_count;
} gusset_cutting_planes;

/// Options of gusset_mesh_sections_create.
typedef struct gusset_mesh_section_options {
    size_t struct_size;
    /// Leaves out points while no left-out point is farther than this from the polyline; finite. 0: keeps all points.
    /// Polylines with points left out may cross each other or themselves.
    double tolerance;
    gusset_in_plane in_plane;
    uint32_t reserved;
} gusset_mesh_section_options;

/// A polyline of a section.
typedef struct gusset_section_path {
    /// Index of the plane.
    uint32_t plane;
    /// 1: returns to its first point, which is not repeated. @flag
    uint32_t closed;
    /// Smallest closed path of the same plane around a closed path, or UINT32_MAX.
    uint32_t parent;
    /// Number of closed paths around a closed path; else 0.
    uint32_t depth;
    /// Length, with all points.
    double length;
    /// Area inside a closed path, with all points; positive if counter-clockwise seen against the plane's normal. Else
    /// 0.
    double area;
} gusset_section_path;

/// Sections of a mesh.
typedef struct gusset_mesh_sections gusset_mesh_sections;

/// Lent polylines, by plane, then by lowest face.
typedef struct gusset_mesh_sections_view {
    size_t struct_size;
    size_t plane_count;
    size_t path_count;
    size_t point_count;
    /// The polylines.
    const struct gusset_section_path *paths;
    /// Polyline k has the points starts[k] to starts[k + 1] - 1.
    struct gusset_indices starts;
    /// The points.
    const double *points;
    /// Ends of the edge of each point; equal at a vertex in the plane.
    const uint32_t *edges;
    /// Parameter of each point on its edge, 0 to 1.
    const double *parameters;
    /// Face of the segment after each point, the first of several after leaving out points; UINT32_MAX at the end of an
    /// open path.
    struct gusset_indices faces;
} gusset_mesh_sections_view;

/// Cuts a mesh by planes into ordered polylines, with their nesting and the source of each point.
/// A polyline runs along the plane's normal x the face's normal: around a solid, outer loops are counter-clockwise seen
/// against the plane's normal, holes clockwise.
/// Each vertex is on a side of each plane exactly. Vertices in a plane count as above it (GUSSET_IN_PLANE_BELOW:
/// below). A closed mesh therefore gives closed loops only, and
/// - an edge in the plane appears where a face beside it is below (above);
/// - a face in the plane is not drawn, only its edges by this rule;
/// - a ridge with both faces below (above) gives a loop there and back;
/// - a peak gives nothing.
/// At an edge with more than two faces, loops around the inside of solids touch but do not cross. A path ends at a
/// border. A face with fewer than three sides between different vertices is left out.
/// @errors OUT_OF_RANGE (vectors, values, tolerance, coordinates beyond 1e150), NOT_FINITE (point), EMPTY_CURVE
///     (polyline without length), TOO_LARGE, as gusset_mesh_view
/// @complexity O(V log n + H + s log s) for n planes of a stack and s crossed faces, parallel; else O(n (V + H) + s log
///     s). Nesting takes O(c log c) for c crossings of loops and lines: few lines pierce all loops, but many long loops
///     beside many small ones make c quadratic.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_mesh_sections_create(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_cutting_planes *planes,
    const struct gusset_mesh_section_options *options, struct gusset_mesh_sections **sections);

/// Destroys sections.
GUSSET_API void gusset_mesh_sections_destroy(struct gusset_mesh_sections *sections);

/// Lends the polylines.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_mesh_sections_get_view(const struct gusset_mesh_sections *sections,
    struct gusset_mesh_sections_view *view);

/// Finds the sources of the points of sections: the vertices of their edges, weighted by the parameter. The faces of
/// the origins are the segments, one for each point, with the mesh's faces as sources. Corners are empty.
/// @complexity O(points).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_mesh_sections_origins_create(const struct gusset_context *context,
    const struct gusset_mesh_sections *sections, struct gusset_origins **origins);

/* ---- Origins: Sources of elements. */

/// Kind of element.
typedef uint32_t gusset_domain;
/// Vertices, points of polylines, nodes of nets and sheets.
#define GUSSET_DOMAIN_VERTICES 0
/// Corners of faces, in the order of face_corners; nodes of nets and sheets.
#define GUSSET_DOMAIN_CORNERS 1
/// Faces, cells of nets and sheets.
#define GUSSET_DOMAIN_FACES 2

/// Sources of a result's vertices, corners and faces.
/// - An old element has itself, a merged vertex all its vertices in equal parts.
/// - A new vertex has the rim vertices around it, by its place on plain triangles between them, before fairing. A
///   vertex put on an edge has its ends.
/// - A new face has the face across the nearest rim edge (the first of equals). Its corners have the old corners there,
///   on its own side if it shares an edge with old faces.
typedef struct gusset_origins gusset_origins;

/// Origins of the elements of one domain.
typedef struct gusset_origins_view {
    size_t struct_size;
    /// Element k has the sources and weights offsets[k] to offsets[k + 1] - 1, if any.
    struct gusset_indices offsets;
    /// Sources, numbered through all inputs.
    struct gusset_indices sources;
    /// Weight of each source, above 0, sum 1.
    const double *weights;
    /// Input i has the sources starts[i] to starts[i + 1] - 1. Inputs are the meshes, pieces, polylines, net or sheet
    /// in order.
    struct gusset_indices starts;
} gusset_origins_view;

/// Destroys origins.
GUSSET_API void gusset_origins_destroy(struct gusset_origins *origins);

/// Lends the origins of one domain.
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

/// Rule that combines the values of several sources. A single source's value stays bit for bit.
typedef uint32_t gusset_rule;
/// Weighted mean; integers are rounded.
#define GUSSET_RULE_LINEAR 0
/// Directions of three floats: weighted mean on the sphere, of length 1. Faces that the operation turned over negate
/// theirs.
#define GUSSET_RULE_NORMAL 1
/// Bone weights, at least 0: weighted mean. The max_influences largest (the first of equals) are kept and scaled to the
/// sum 1, or to the largest value of an integer type.
#define GUSSET_RULE_SKIN_WEIGHTS 2
/// Value of the source with the largest weight (the first of equals).
#define GUSSET_RULE_NEAREST 3
/// Texture coordinates. Vertices and faces: weighted mean. Corners of new faces:
/// - Weighted mean where both sides are on one chart.
/// - Elsewhere each new face continues the unfolded chart of its old face, up to a seam in the middle.
/// - At the cut of a chart that closes on itself, values are shifted by the jump there. If the jump does not repeat the
///   texture, the face continues its own chart. No face runs back over the chart.
/// - A rim is on one chart as long as old faces have equal values at common vertices. The sides of a gap are on one
///   chart if most new faces agree: values from the far side deviate from the continued chart by less than half the
///   distance to the old edge and its length combined.
#define GUSSET_RULE_TEXTURE 4

/// Describes an attribute of elements.
typedef struct gusset_channel {
    size_t struct_size;
    /// Elements that have values.
    gusset_domain domain;
    /// Type of values; 0 is invalid.
    gusset_value_type value_type;
    /// Values of an element, 1 to 4096.
    uint32_t components;
    gusset_rule rule;
    /// Weights that GUSSET_RULE_SKIN_WEIGHTS keeps for elements with several sources; 0: all.
    uint32_t max_influences;
    uint32_t reserved;
} gusset_channel;

/// Values of the elements of one input.
typedef struct gusset_channel_values {
    /// Components of each element at every stride. NULL with count 0: the input lacks them; its elements get 0, and new
    /// elements the values of other sources.
    const void *values;
    /// Vertices, corners or faces of the input.
    size_t count;
    /// Bytes from one element to the next; 0 if packed.
    size_t stride;
} gusset_channel_values;

/// Transfers values from elements of inputs to a result's.
/// Elements without sources that have values get 0.
/// @param inputs values of each input of the origins, in order.
/// @param values receives the components of each element at every stride, at any alignment; bytes between do not
///     change. Must not overlap the inputs' values.
/// @param count room in elements, at least the elements of the result.
/// @param stride bytes from one element to the next; 0 if packed.
/// @errors OUT_OF_RANGE (components; value_type and components that the rule refuses; a negative skin weight, with
///     element and input), NOT_FINITE (with element and input, except for GUSSET_RULE_NEAREST), COUNT_DIFFERS (of
///     inputs, or of values, with the input), BAD_STRIDE, BUFFER_TOO_SMALL, OVERLAP
/// @complexity O(sources and elements), parallel; no memory, except for GUSSET_RULE_TEXTURE, linear in the corners of
///     new faces.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_attributes_apply(const struct gusset_context *context,
    const struct gusset_origins *origins, const struct gusset_channel *channel,
    const struct gusset_channel_values *inputs, size_t input_count, void *values, size_t count, size_t stride);

/// Finds which vertices are one, for merge of gusset_mesh_view.
/// Vertices with equal keys are one; without keys, vertices at equal finite positions, -0 equal to 0.
/// @param keys one for each vertex; NULL: positions.
/// @param merge receives for each vertex the smallest that it is one with; at any alignment.
/// @errors as gusset_mesh_view
/// @complexity O(V log V) for V vertices; 8 bytes for each, 12 with keys.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_mesh_find_merge(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const uint32_t *keys, uint32_t *merge);

#ifdef __cplusplus
}
#endif
#endif /* GUSSET_MESH_H */
