/* Generated from src/capi; see gusset.h. */

#ifndef GUSSET_MESH_H
#define GUSSET_MESH_H
#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/*** Meshes. Tolerances, gaps and distances in options are finite and at least 0. Results keep the bits of old */
/*** positions; developments flatten them. A reversed face keeps its first corner. Memory is linear unless stated. */

typedef uint32_t gusset_scalar;
/// 32-bit floats.
#define GUSSET_F32 1
/// 64-bit floats.
#define GUSSET_F64 2

typedef uint32_t gusset_index;
/// 32-bit unsigned integers.
#define GUSSET_U32 0
/// Reserved: GUSSET_ERROR_UNKNOWN_VALUE.
#define GUSSET_U64 1

/// Array of indices.
typedef struct gusset_indices {
    /// May be NULL if count is 0.
    const uint32_t *data;
    size_t count;
} gusset_indices;

/// Polygon mesh of the caller (input) or of a result (output). Input arrays must not change during the call; their
/// lengths are not checked. Counts are checked before elements. Outputs have packed positions, and face_size 0. Inputs
/// have
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
    /// Stride in bytes; 0 if packed.
    size_t position_stride;
    size_t vertex_count;
    /// Face f has corners face_offsets[f] to face_offsets[f + 1] - 1. NULL with face_size.
    const void *face_offsets;
    /// Vertex of each corner, face by face. Corner h also names the half-edge from it.
    const void *face_corners;
    size_t face_count;
    /// Must be set: 0 is invalid.
    gusset_scalar scalar;
    gusset_index index;
    /// Corners of every face, or 0 with face_offsets.
    uint32_t face_size;
    uint32_t reserved;
    /// Representative of each vertex, or NULL; see gusset_mesh_find_merge. Vertices with one representative are one, so
    /// texture seams are not borders. A representative represents itself, and its position counts. Results list
    /// representatives; faces keep the given vertices.
    const void *merge;
} gusset_mesh_view;

/*** Results */

/// Mesh and report of an operation. Getters of other reports return WRONG_HANDLE.
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
    /// Area of new faces. Infinite if it overflows.
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

GUSSET_API void gusset_result_destroy(struct gusset_result *result);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_mesh(const struct gusset_result *result,
    struct gusset_mesh_view *view);

/// Reports the quality of a stitch or filling.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_quality(const struct gusset_result *result,
    struct gusset_quality_report *report);

struct gusset_origins;

/// Finds the sources of a result's elements in the operation's inputs.
/// - A strip has two polylines; its corners and faces lack sources.
/// - A corner that gusset_sew added has its face's corners at both ends of the edge.
/// - Corners and faces of a development have the surface's; each vertex has one source.
/// - In a net's mesh, a vertex has its first node, a face its cell, a corner its own cell's node, which differs across
///   seams.
/// - A sheet has (rows + 1) * (columns + 1) nodes, row by row. Vertices and corners have the nodes of their cell, by
///   parameters; faces have their cells. Where sheets close, corners have nodes on their face's side.
/// @complexity O(H log n) for n corners of new faces; 16 bytes an element (sheet: 52 a vertex or corner), plus linear
///     in n.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_origins_create(const struct gusset_context *context,
    const struct gusset_result *result, struct gusset_origins **origins);

/*** Joining */

struct gusset_join_options;

/// Joins open pieces into one mesh: sews coincident borders, orients components, joins facing loops by strips, fills
/// holes, and turns closed components outwards.
/// Vertices and faces come from pieces, strips, then patches, in the first piece's scalar type. Strips enclose overlaps
/// that are not trimmed.
/// Facing loops of different components are joined, by the best matching:
/// - Whole loops, if the conormals (tangents off the surface) of each point to the other, without a much nearer loop.
/// - Whole loops, if 9/10 of each one's vertices are nearest to the other, once round it or at similar distances.
///   Similar: the ninth decile is at most 4 times the first, or the vertex spacing.
/// - Else runs of mutually nearest vertices, by open strips.
/// @param pieces at least one; struct_size of the first holds for all.
/// @errors EMPTY_MESH, MIXED_SCALARS, OUT_OF_RANGE (a tolerance, max_gap, or an entry of pairs or excluded: index is
///     the entry, input its loop 0 or 1, value the missing piece, else the vertex. It does not exist. In pairs, also:
///     no vertex, no or several joinable loops at it, or a loop named before)
/// @complexity O(H log d + V log V) for V vertices on loops. Also gusset_stitch for each strip, gusset_fill for each
///     hole, and a pass over all faces for each strip faired or tested for intersections.
/// @source Nesterenko for a single gap.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_join(const struct gusset_context *context,
    const struct gusset_mesh_view *pieces, size_t piece_count, const struct gusset_join_options *options,
    struct gusset_result **result);

struct gusset_join_report;

GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_join(const struct gusset_result *result,
    struct gusset_join_report *report);

/*** Options of stitching */

/// Rule for the meridians. A meridian is a strip's edge from rim A to rim B. INDEX, ARC_LENGTH and GREEDY take O(N +
/// M). If ARC_LENGTH or GREEDY would repeat an edge, MIN_DIAGONAL applies.
typedef uint32_t gusset_meridians;
/// Triangle strip that best continues both surfaces. It bends little, above all along the rims, and follows their
/// tangent planes. The default search stays near the strip of least area; gusset_strip makes that.
#define GUSSET_MERIDIANS_CONTINUATION 0
/// Vertices paired in proportion to their indices; suits evenly spaced rims.
#define GUSSET_MERIDIANS_INDEX 1
/// Vertices paired in proportion to arc length.
#define GUSSET_MERIDIANS_ARC_LENGTH 2
/// Always the shorter of the two next meridians.
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

typedef uint32_t gusset_strip_search;
/// Exact up to 2^21 vertex pairs. Beyond, coarse to fine in nearly linear time and linear memory, usually within 0.1 %
/// of the optimum.
#define GUSSET_SEARCH_AUTO 0
/// Exact, in O(N M) time; gusset_stitch states the memory.
#define GUSSET_SEARCH_EXACT 1

/// First meridian of a closed strip; open ones start at their first points.
typedef uint32_t gusset_strip_start;
/// The better strip from the closest pair of vertices, before or after rotating rim B along rim A to the best fit.
#define GUSSET_START_AUTO 0
/// The closest pair of vertices.
#define GUSSET_START_CLOSEST 1
/// The first points; gusset_strip only.
#define GUSSET_START_GIVEN 2

typedef uint32_t gusset_fairing;
/// New vertices divide the meridians of a strip evenly, or lie on the first triangulation of a patch.
#define GUSSET_FAIRING_NONE 0
/// A thin plate that meets the old surface smoothly: least sum of squared Laplacians over new vertices and rims. Rims
/// and ends of open strips stay fixed.
#define GUSSET_FAIRING_THIN_PLATE 1

typedef uint32_t gusset_intersections;
/// Finds intersections of the strip, and reduces them:
/// - With GUSSET_MERIDIANS_CONTINUATION, a triangle strip without rows is rerouted; the best one is kept. If the mean
///   meridian is longer than a radius, GUSSET_MERIDIANS_SMOOTH competes by fewer intersections, or as many and much
///   smaller bends. Rows use this strip's meridians if the gap is so wide, or they would intersect.
/// - Faired rows move back locally, at most 12 times. Straight rows that intersect less win.
/// - Blends move back likewise, then get less fairing. The best blend is kept, or a strip that intersects less.
#define GUSSET_INTERSECTIONS_AUTO 0
/// No search: rows are faired in full, and the first blend is kept.
#define GUSSET_INTERSECTIONS_IGNORE 1
/// As GUSSET_INTERSECTIONS_AUTO, but no strip is rerouted.
#define GUSSET_INTERSECTIONS_REPORT 2

typedef uint32_t gusset_orientation;
/// Reverses the component of rim B if it is oriented against rim A, whichever is inside out; nothing within one
/// component. Whole rims are compared as curves. If both face one way, the sides of their surfaces decide. An
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
/// Whole loops if their normals make less than 60 degrees with the line of centres (mean of cosines), or the planes are
/// undecided. Else open arcs.
#define GUSSET_EXTENT_AUTO 2
/// The arcs arc_a and arc_b. Loops not given are indexed as by gusset_boundary_get_loop.
#define GUSSET_EXTENT_ARCS 3

/// Choice among runs of facing vertices.
typedef uint32_t gusset_facing_run;
/// On each loop the run with the closest pair.
#define GUSSET_RUN_CLOSEST 0
/// On each loop the run with the most vertices; of equal runs the first.
#define GUSSET_RUN_LONGEST 1

typedef uint32_t gusset_centres;
/// Mean of the vertices.
#define GUSSET_CENTRES_VERTICES 0
/// Mean along the curve, independent of vertex spacing.
#define GUSSET_CENTRES_LENGTH 1

typedef uint32_t gusset_row_rule;
/// 0: each meridian is one edge.
#define GUSSET_ROWS_NONE 0
/// max(0, round(mean meridian length / mean edge length of both sides) - 1). At most about 50,000 new vertices, or 16
/// rows if more; the log says if so limited.
#define GUSSET_ROWS_MEAN_EDGE 1
/// row_count.
#define GUSSET_ROWS_COUNT 2

typedef uint32_t gusset_strip_cells;
/// Triangles; quads are split by their shorter diagonals.
#define GUSSET_CELLS_TRIANGLES 0
/// Quads, and triangles where a rim repeats a vertex.
#define GUSSET_CELLS_QUADS 1

/// Surface between the rims, or in a hole.
typedef uint32_t gusset_finish;
/// Strip of meridians, with interior rows. In a hole: the patch that other options describe.
#define GUSSET_FINISH_STRIP 0
/// Smooth joint, tangent to both pieces, which looks best. Triangles are about as fine as along the rims, graded
/// between, without sharp angles where the rims allow. Two tubes are joined by a tube, within some per cent of the
/// radius across a few radii. Across wider gaps than a radius it bends as an arc between the axes. Meridians and matrix
/// describe the strip, not edges of the result. Ignores rows, cells, fairing and refine. In a hole: a faired patch as
/// dense as its surroundings. In a join, for strips and holes.
/// - Not for machined parts and flat walls, which it rounds. For CAD tolerances, printing or volumes alone, a strip has
///   far fewer faces.
/// The strip is kept if every blend intersects more, or exceeds about 50,000 new vertices, or 16 a rim vertex if more.
/// Edges up to twice as long keep to that limit.
#define GUSSET_FINISH_BLEND 1

typedef uint32_t gusset_tolerance_mode;
/// Uses the rounding error of the coordinates. For facing vertices: at most 2^-16 (32-bit) or 2^-45 (64-bit) times the
/// loops' largest coordinate. For welding, see gusset_weld_options.
#define GUSSET_TOLERANCE_AUTO 0
/// Uses the given tolerance.
#define GUSSET_TOLERANCE_GIVEN 1
/// Uses tolerance 0; welding then requires equal positions.
#define GUSSET_TOLERANCE_EXACT 2

typedef uint32_t gusset_outward;
/// GUSSET_OUTWARD_CLOSED in gusset_join, else GUSSET_OUTWARD_KEEP.
#define GUSSET_OUTWARD_AUTO 0
/// Closed components stay unchanged; gusset_orient chooses the original side of most faces.
#define GUSSET_OUTWARD_KEEP 1
/// Closed components face outwards, and walls of cavities into the cavities. An odd number of closed components enclose
/// the wall of a cavity. Components that cross, or touch in more than vertices and edges, do not enclose each other. If
/// the volume is 0 up to rounding, GUSSET_OUTWARD_KEEP applies. Except in gusset_orient, only components with two faces
/// at every edge and consistent orientation are reversed.
#define GUSSET_OUTWARD_CLOSED 2

typedef struct gusset_stitch_options {
    size_t struct_size;
    gusset_meridians meridians;
    gusset_orientation orientation;
    /// Vertices to shift the first meridian along rim B, in the direction of rim A, modulo rim B. The shift begins at
    /// the closest pair that no edge joins. If not 0, no other start is tried. 0 for arcs (OUT_OF_RANGE).
    int64_t twist;
    gusset_stitch_extent extent;
    gusset_facing_run run;
    gusset_row_rule rows;
    /// Interior rows.
    /// @when rows GUSSET_ROWS_COUNT
    uint32_t row_count;
    gusset_strip_cells cells;
    gusset_tolerance_mode tolerance_mode;
    /// Facing vertices are farther than this from their loop's plane.
    /// @when tolerance_mode GUSSET_TOLERANCE_GIVEN
    double tolerance;
    /// First index on loop A as given, and number of vertices, 1 to the loop's length; may pass its end.
    /// @when extent GUSSET_EXTENT_ARCS
    uint32_t arc_a[2];
    /// As arc_a, for loop B.
    /// @when extent GUSSET_EXTENT_ARCS
    uint32_t arc_b[2];
    gusset_strip_search search;
    gusset_strip_start start;
    /// Positions of new vertices; ignored without rows.
    gusset_fairing fairing;
    gusset_intersections intersections;
    gusset_centres centres;
    gusset_outward outward;
    gusset_finish finish;
    uint32_t reserved;
} gusset_stitch_options;

/*** Options of joining */

typedef uint32_t gusset_welding;
/// Sewn as by gusset_sew, with weld_options; edges are split where vertices do not match.
#define GUSSET_WELDING_SEW 0
/// Nothing is welded.
#define GUSSET_WELDING_NONE 1
/// Sewn where vertices match, as by gusset_weld.
#define GUSSET_WELDING_EDGE_TO_EDGE 2

typedef uint32_t gusset_gap;
/// A gap's width is the larger mean distance from either loop to the other's nearest points.
/// - Whole loops: a fifth of the larger component's extent along an axis, or the smaller mean radius (mean distance
///   from the loop's centre) if more. Any gap between the only two loops, on two pieces, unless they lie beside each
///   other.
/// - Whole loops on two pieces that look at each other, with nobody else near: three times that. Among the loops
///   without a partner, each is nearest to three quarters of the other's vertices.
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
/// Runs of loops and slits only: two sheets side by side never become a closed pocket.
#define GUSSET_JOIN_PARTS 2

typedef uint32_t gusset_overlaps;
/// Overlapping pieces stay unchanged.
#define GUSSET_OVERLAPS_KEEP 0
/// One piece of each overlap is kept, as by gusset_trim_create, and gaps are closed. Hole filling replaces strips that
/// would intersect other faces.
#define GUSSET_OVERLAPS_TRIM 1

/// Two loops of the pieces.
typedef struct gusset_loop_pair {
    /// Piece of each loop.
    uint32_t piece[2];
    /// Vertex of the piece on each loop; UINT32_MAX excludes all loops of the piece.
    uint32_t vertex[2];
} gusset_loop_pair;

struct gusset_fill_options;

struct gusset_trim_options;

struct gusset_weld_options;

typedef struct gusset_join_options {
    size_t struct_size;
    gusset_welding weld;
    /// GUSSET_ORIENTATION_FIX reverses the minority of faces in each component, then components against those that they
    /// face. GUSSET_ORIENTATION_KEEP ignores outward and reverses nothing.
    /// @values GUSSET_ORIENTATION_FIX, GUSSET_ORIENTATION_KEEP
    gusset_orientation orientation;
    gusset_gap gap;
    gusset_join_extent extent;
    /// 1 also joins loops of one component that pairs does not name.
    uint32_t within_components;
    /// 1 fills the remaining holes.
    uint32_t fill;
    /// Widest gap to close; 0 closes none.
    /// @when gap GUSSET_GAP_GIVEN
    double max_gap;
    /// Pairs of whole loops to join at any distance, or NULL: two loops, or a slit twice (see gusset_joint). No loop is
    /// in two pairs.
    const struct gusset_loop_pair *pairs;
    size_t pair_count;
    /// Pairs not to join, or NULL; pairs takes precedence. Vertices on no loop after welding exclude nothing.
    const struct gusset_loop_pair *excluded;
    size_t excluded_count;
    /// Options of welding.
    const struct gusset_weld_options *weld_options;
    /// Uses meridians, search, start, rows, row_count, cells, fairing, intersections and finish; all options must be
    /// valid.
    const struct gusset_stitch_options *strip_options;
    /// Ignores groups, and outward and plan_only, which must be valid. With GUSSET_OVERLAPS_TRIM, GUSSET_KEEP_AUTO acts
    /// as GUSSET_KEEP_BORDERS.
    const struct gusset_fill_options *fill_options;
    /// Open components mostly keep the first piece's orientation.
    gusset_outward outward;
    gusset_overlaps overlaps;
    /// Options of trimming.
    /// @when overlaps GUSSET_OVERLAPS_TRIM
    const struct gusset_trim_options *trim_options;
} gusset_join_options;

/*** Joining */

typedef uint32_t gusset_joint_outcome;
/// A strip joins the two sides.
#define GUSSET_JOINT_JOINED 0
/// Left open: the surface would become one-sided.
#define GUSSET_JOINT_ORIENTATION_CONFLICT 1
/// Left open: the sides share a vertex.
#define GUSSET_JOINT_SHARE_VERTEX 2
/// Left open: every strip would repeat an edge of the mesh.
#define GUSSET_JOINT_NO_STRIP 3
/// Left to hole filling: between trimmed pieces, the strip would intersect other faces.
#define GUSSET_JOINT_WOULD_CUT 4

/// Reason for the lack of a strip.
typedef uint32_t gusset_left_reason;
/// It is the only loop.
#define GUSSET_LEFT_ALONE 0
/// The loop is open, non-manifold or not consistently oriented.
#define GUSSET_LEFT_NOT_SIMPLE 1
/// The loop has fewer than 3 vertices.
#define GUSSET_LEFT_TOO_SHORT 2
/// The loop faces another, but lacks a strip; see joints.
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
    /// Index of each face; a split triangle's first part, which the others follow.
    struct gusset_indices faces;
} gusset_piece_map;

/// Two loops, or runs of loops, that face each other. Indices are in the result.
/// If borders coincide in part, sewing leaves a slit: a loop along the rest of both. In a slit joined with itself, both
/// sides are on it, one with both ends; whole is 0, without rows.
typedef struct gusset_joint {
    /// Vertices of each side in order, before turning components outwards. If joined, both run from the first meridian
    /// on.
    struct gusset_indices side[2];
    /// Mean width of the gap.
    double gap;
    /// First new vertex.
    size_t vertex_first;
    size_t vertex_count;
    /// First face of the strip.
    size_t face_first;
    size_t face_count;
    /// As in gusset_stitch_report.
    struct gusset_indices intersections;
    /// 1 if searched for.
    uint32_t intersections_known;
    gusset_joint_outcome outcome;
    /// 1 if both sides are whole loops.
    uint32_t whole;
    gusset_finish finish;
} gusset_joint;

/// Boundary loop of the sewn pieces without a strip, even if filled.
typedef struct gusset_left_loop {
    /// Vertices in the result, in order.
    struct gusset_indices vertices;
    /// Mean distance to the loop nearest to most vertices, on another component if any; infinite without one, or if
    /// this loop cannot carry a strip. Too wide slit: mean distance of sides.
    double gap;
    /// Largest gap that could be joined; 0 without another loop.
    double allowed_gap;
    gusset_left_reason reason;
    /// 1 if hole filling closed the loop.
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
    /// Rim vertices of holes, in order, before turning components outwards.
    struct gusset_indices hole_rims;
    /// Old faces reversed against their pieces, by index in the result. New faces agree with the faces beside them.
    struct gusset_indices turned;
    /// A face of each non-orientable component.
    struct gusset_indices one_sided;
    /// A face of each closed component of volume 0 up to rounding; none with GUSSET_ORIENTATION_KEEP or
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
    /// As in gusset_weld_report.
    uint32_t near_edge_pairs;
    /// As in gusset_weld_report.
    double near_tolerance;
    /// Trimmed faces, as (piece, face), ascending, without a kept face within max_distance of the trimming that faces
    /// the same way.
    struct gusset_indices lost_faces;
    /// Piece and vertex for each loop in left: the first that a piece has, else UINT32_MAX twice.
    struct gusset_indices left_origins;
    /// As intersections of gusset_fill_report.
    struct gusset_indices hole_intersections;
    /// Length along which each joint's strip intersects faces.
    const double *joint_cut_lengths;
    /// Length along which each hole's patch intersects faces.
    const double *hole_cut_lengths;
    /// For each joint, 1 if its strip intersects faces and a blend would not, else 0. Tried with
    /// GUSSET_INTERSECTIONS_AUTO on untrimmed pieces.
    const uint32_t *blend_avoids_cuts;
    /// 1 if intersections of patches were searched for.
    uint32_t hole_intersections_known;
    /// Joints whose strips intersect faces.
    uint32_t cutting_joints;
} gusset_join_report;

/*** Stitching */

/// Parts of a stitch, by index in the result. Entry 0 is the first mesh's, 1 the second's.
typedef struct gusset_stitch_report {
    size_t struct_size;
    /// Index of each old vertex. Entry 1 is empty without a second mesh.
    struct gusset_indices vertex_map[2];
    /// Index of each old face.
    struct gusset_indices face_map[2];
    /// Vertices of each rim from the first meridian on. Before turning components outwards, the surface is left of rim
    /// 0 and right of rim 1.
    struct gusset_indices rim[2];
    /// Pairs (i, j) of rim indices, the matrix H. Whole rims of N and M vertices: from (0, 0) to (N, M), where index N
    /// is 0 again. Arcs: to (N - 1, M - 1). A step advances i or j by 1; with GUSSET_MERIDIANS_INDEX and
    /// GUSSET_MERIDIANS_QUAD, and between common points, also both.
    struct gusset_indices meridians;
    /// The matrix P: vertices row by row from rim 0 to rim 1, a column for each meridian.
    struct gusset_indices matrix;
    /// Three rim vertices for each new vertex. In a row: the meridian's ends, rim 1's twice. In a blend: the corners of
    /// the strip triangle around the unfaired vertex.
    struct gusset_indices parents;
    /// Weights of the parents, at least 0, sum 1. In row k of r: 1 - k / (r + 1), k / (r + 1), 0.
    const double *weights;
    /// First face of the strip.
    size_t strip_face_first;
    /// N + M triangles for whole rims without rows and common points, except in a blend.
    size_t strip_face_count;
    /// Interior rows, two less than in the matrix; 0 for a blend.
    uint32_t row_count;
    /// 1 for a closed band, 0 between arcs.
    uint32_t closed;
    /// 1 if rim 1's component was reversed.
    uint32_t turned;
    /// 1 if searched for.
    uint32_t intersections_known;
    /// Pairs of intersecting faces: first a strip face, the larger one if both are. Any contact counts, by an exact
    /// test, except at shared or coincident vertices and edges. Faces are split as by gusset_triangulate. A
    /// self-intersecting polygon is paired with itself.
    struct gusset_indices intersections;
    /// Times that faired rows, or the kept blend, moved back.
    uint32_t back_off_count;
    gusset_finish finish;
    /// Faces that GUSSET_OUTWARD_CLOSED reversed, ascending.
    struct gusset_indices turned_outwards;
} gusset_stitch_report;

/// Joins two boundary loops, of two meshes or of one, by a strip: a closed band between whole loops, or open between
/// facing arcs.
/// The result has the vertices of A, B, then new ones, in A's scalar type; the faces of A, B, then the strip. An arc of
/// one vertex gets a fan, which touches its piece there only; two get one meridian and no face. If vertices of both
/// rims coincide up to rounding, the vertex of rim 0 replaces the other, and strips without rows join the rims between
/// these points.
/// @param loop_a vertices in order, in either direction, cyclically joined by boundary edges. If both loops are NULL,
///     the two nearest are joined; if one, the nearest to the other. Candidates are closed, manifold, consistently
///     oriented, of at least 3 vertices; two of one mesh share no vertex.
/// @param mesh_b NULL if both loops are of mesh_a.
/// @param loop_b as loop_a, on mesh_b if given.
/// @errors OUT_OF_RANGE, PLANES_UNDECIDED, NO_LOOP, LOOP_TOO_SHORT, LOOP_REPEATS_VERTEX, LOOP_EDGE_NOT_FREE,
///     LOOP_NOT_ORIENTED, LOOPS_SHARE_VERTEX, ORIENTATION_CONFLICT, NO_STRIP, MIXED_SCALARS
/// @complexity O(H log d). Meridians O(N M), above 2^21 pairs of vertices and for simple rules O((N + M) log M).
///     Fairing and intersections O(n log n), and a test a pair of overlapping triangle boxes. Blend of n vertices
///     O(n^1.5), nearly linear in narrow gaps. Choice of loops: a box test a pair. GUSSET_SEARCH_EXACT adds 1 byte for
///     each of up to 2^26 pairs, and 8 M bytes per 2^26 pairs begun. GUSSET_MERIDIANS_CONTINUATION and _SMOOTH take 2
///     bytes a pair, 8 if the best strip would repeat an edge; several threads and two starts double that.
/// @source Nesterenko, algorithm 2 and the intermediate mesh (H, P).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_stitch(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh_a, const struct gusset_indices *loop_a, const struct gusset_mesh_view *mesh_b,
    const struct gusset_indices *loop_b, const struct gusset_stitch_options *options, struct gusset_result **result);

/// Lends the strip alone: vertices of rim 0, rim 1, new ones, and the new faces.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_strip_mesh(const struct gusset_result *result,
    struct gusset_mesh_view *view);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_stitch(const struct gusset_result *result,
    struct gusset_stitch_report *report);

/*** Holes */

/// Weight that the triangulation of a hole minimises.
typedef uint32_t gusset_fill_weight;
/// Best continuation: the area if the rim is planar, else the sum of
/// - 2 sin(t / 2) over all edges, the rim included, for angles t between normals;
/// - the mean squared distance from the missing surface, estimated from tangent planes at the rim, in units of 1/140 of
///   its length.
#define GUSSET_WEIGHT_CONTINUATION 0
/// Sum of the areas and, over all edges, the rim included, of squared length * (1 - cos(angle between normals)).
#define GUSSET_WEIGHT_AREA_AND_BEND 1
/// Largest angle between neighbouring faces, old faces at the rim included; then the area.
#define GUSSET_WEIGHT_BEND_THEN_AREA 2
/// Area, minimised exactly for a single loop of at most 128 vertices.
#define GUSSET_WEIGHT_AREA 3

typedef uint32_t gusset_patch_finish;
/// Rim vertices only.
#define GUSSET_PATCH_PLAIN 0
/// New vertices on the plain triangles, except beside creases that continue.
#define GUSSET_PATCH_REFINED 1
/// New vertices, faired.
#define GUSSET_PATCH_FAIRED 2

typedef uint32_t gusset_hole_status;
/// Filled; with plan_only, to be filled.
#define GUSSET_HOLE_FILLED 0
/// Left open: the outer border of a sheet, or the longest loop; see keep.
#define GUSSET_HOLE_KEPT 1
/// Left open: it exceeds max_edges, max_length, max_diameter or max_area.
#define GUSSET_HOLE_TOO_LARGE 2
/// Left open: an open chain.
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
/// Left open: an edge coincides with another boundary edge up to rounding, so that a patch would have no area there, or
/// lie on another. GUSSET_KEEP_NONE fills the loop.
#define GUSSET_HOLE_UNSEWN 10

/// Report on one loop.
typedef struct gusset_hole {
    /// First vertex of the loop in rims, surface on the left before turning components outwards; as given if not
    /// simple, free or oriented.
    size_t rim_first;
    size_t rim_count;
    /// First face of the patch in the result, equal for loops that share it.
    size_t face_first;
    size_t face_count;
    /// First new vertex of the patch.
    size_t vertex_first;
    size_t vertex_count;
    /// Length of the loop.
    double length;
    /// Diagonal of the loop's axis-aligned box.
    double diameter;
    /// Area of triangles from the loop's edges to the mean of its vertices: exact for a planar convex hole, else more.
    /// Infinite if it overflows.
    double area;
    gusset_hole_status status;
    gusset_fill_weight weight;
    gusset_patch_finish finish;
    /// Patch number, in the order of faces, equal for loops that share it; UINT32_MAX without a patch, always with
    /// plan_only.
    uint32_t patch;
} gusset_hole;

/// Reports on all loops.
typedef struct gusset_fill_report {
    size_t struct_size;
    /// Given loops, or all in the order of gusset_boundary_get_loop.
    const struct gusset_hole *holes;
    size_t hole_count;
    /// Vertices of all loops.
    struct gusset_indices rims;
    /// Three rim vertices for each new vertex.
    struct gusset_indices parents;
    /// Weights of the parents, at least 0, sum 1. They give the nearest point on the rims' plain triangulation: the
    /// vertex itself in a flat patch, or without fairing and creases.
    const double *weights;
    /// As in gusset_stitch_report, ascending: first the larger index, a new face.
    struct gusset_indices intersections;
    /// Faces that GUSSET_OUTWARD_CLOSED reversed, ascending.
    struct gusset_indices turned_outwards;
    /// 1 if searched for.
    uint32_t intersections_known;
    /// Boundary edges of the input that coincide with another; 0, without a search, for given loops.
    uint32_t coincident_edges;
} gusset_fill_report;

/*** Holes */

/// Loops that are not holes, if all loops are selected. Except with GUSSET_KEEP_NONE, loops also stay open by
/// GUSSET_HOLE_UNSEWN.
typedef uint32_t gusset_fill_keep;
/// Outer borders of sheets, and borders of loose faces.
/// - A component is a sheet if its area vector's length is at least 3/4 of its area. Its outer border is the loop whose
///   area vector reaches farthest along the component's.
/// - A component is loose if one loop passes all its vertices, like a single face.
#define GUSSET_KEEP_AUTO 0
/// All loops are holes.
#define GUSSET_KEEP_NONE 1
/// The longest loop (the first of equals).
#define GUSSET_KEEP_LONGEST 2
/// Outer borders of sheets and shallow bowls: loops whose area vector has a positive dot product with the component's.
/// Its length is at least half the component's area.
#define GUSSET_KEEP_BORDERS 3

typedef uint32_t gusset_fill_together;
/// Each loop gets its own patch.
#define GUSSET_TOGETHER_APART 0
/// All filled loops share one patch of genus 0. Unless coplanar, at most about 160 loops.
#define GUSSET_TOGETHER_ONE 1
/// Loops share a patch where it weighs less than separate patches.
/// - Pairs are tried whose boxes, grown by half their diagonals, overlap: about 8 a loop and 256 in all (the log says
///   if exceeded).
/// - The largest relative gain comes first. A patch has at most 16 loops.
/// - With GUSSET_WEIGHT_AREA, a short tube's ends share a patch along the tube.
#define GUSSET_TOGETHER_CHEAPEST 2

typedef uint32_t gusset_fill_refinement;
/// No new vertices.
#define GUSSET_REFINE_NONE 0
/// New vertices as dense as those around the hole.
#define GUSSET_REFINE_RIM_DENSITY 1

/// Smoothness between faired patches and the old surface.
typedef uint32_t gusset_fill_continuity;
/// Tangent continuity: fairing minimises the squared Laplacian.
#define GUSSET_CONTINUITY_C1 0
/// Curvature continuity: fairing minimises the squared gradient of the Laplacian. Two rings of old faces at the rim
/// determine it, with their noise.
#define GUSSET_CONTINUITY_C2 1

/// Options of gusset_fill. Default: all holes, without new vertices.
typedef struct gusset_fill_options {
    size_t struct_size;
    gusset_fill_weight weight;
    gusset_fill_refinement refine;
    /// Positions of new vertices; ignored without them.
    gusset_fairing fairing;
    gusset_fill_keep keep;
    /// Patch faces that intersect each other or old faces: AUTO avoids, REPORT reports, IGNORE ignores them.
    gusset_intersections intersections;
    /// 1: only reports which loops would be filled, by which weight and finish, without predicting failed
    /// triangulations and shared patches.
    uint32_t plan_only;
    /// Approximate limit on a patch's new vertices, kept by larger triangles, within a factor of 2. 0: 50,000, or 4 a
    /// rim vertex if more; twice that for sharp angles.
    uint32_t max_new_vertices;
    /// Most edges of a loop to fill; 0: any.
    uint32_t max_edges;
    /// Largest length of a loop to fill, at least 0; 0: any.
    double max_length;
    /// As max_length, for diameter of gusset_hole.
    double max_diameter;
    /// As max_length, for area of gusset_hole.
    double max_area;
    gusset_outward outward;
    gusset_fill_together together;
    /// Group of each given loop; the group's loops share a patch of genus 0, except loops left open for their own
    /// reasons. NULL: together decides.
    const uint32_t *groups;
    gusset_fill_continuity continuity;
    /// 1: creases of the old surface end at the rim.
    uint32_t ignore_creases;
    gusset_finish finish;
    uint32_t reserved;
} gusset_fill_options;

/// Fills holes by triangles, oriented like the surrounding surface.
/// Loops that cannot be filled, and outer borders of sheets, stay open; see gusset_hole_status. New vertices come after
/// the old; new triangles after the old faces, hole by hole. gusset_join with fill 1 and max_gap 0 sews coincident
/// borders first.
/// - No new edge joins two vertices of an old face: a closed result stays closed if its polygons are triangulated.
/// - With the default weight or GUSSET_WEIGHT_AREA, planar holes whose rims do not cross, even with islands, get no
///   overlapping triangles.
/// - In a patch of one loop, creases continue: matching pairs are joined, three or more meet in a new vertex. Without
///   new vertices, only straight pairs are joined. Other creases end at the rim.
/// - Loops of a shared patch stay open if two share a vertex, or the search (not exhaustive) fails.
///   GUSSET_TOGETHER_CHEAPEST gives them separate patches.
/// - A patch that intersects itself or other faces, by an exact test, is retried with less fairing, other weights and
///   no new vertices. The fewest intersections win; see gusset_hole.
/// - Faired vertices stay in the rims' box, grown on all sides by half its diagonal.
/// @param loops each as loop_a of gusset_stitch; NULL with loop_count 0: all loops.
/// @errors INDEX_OUT_OF_RANGE (input is the loop, index the place in it), NULL_ARGUMENT (groups without loops),
///     OUT_OF_RANGE
/// @complexity O(n^3) time, 30 n^2 bytes for a loop of n <= 128 vertices. Otherwise linear memory: O(n), coarse to
///     fine; planar O(n log n); shared patches O(n log n) for few loops, O(n^3) for many. Also O(H log d), O(m^1.5) for
///     m new vertices of a hole, and O(n log n), at worst O(n^2), for intersections with n faces near holes.
/// @source Barequet and Sharir 1995; Liepa 2003.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_fill(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_indices *loops, size_t loop_count,
    const struct gusset_fill_options *options, struct gusset_result **result);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_fill(const struct gusset_result *result,
    struct gusset_fill_report *report);

/*** Strips */

typedef struct gusset_strip_options {
    size_t struct_size;
    gusset_meridians meridians;
    gusset_strip_search search;
    gusset_strip_start start;
    /// 1 if the polylines are closed.
    uint32_t closed;
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
    /// As in gusset_stitch_report, from start on: to (N, M) if closed, else to (N - 1, M - 1).
    struct gusset_indices meridians;
    /// The matrix P, as in gusset_stitch_report.
    struct gusset_indices matrix;
    /// Ends on A and B of each new vertex's meridian.
    struct gusset_indices parents;
    /// Weight of each second parent, 0 to 1: k / (r + 1) in row k of r.
    const double *weights;
    /// As in gusset_stitch_report; 0 without a face.
    uint32_t row_count;
    uint32_t reserved;
} gusset_strip_report;

/// Builds a strip, as gusset_stitch does between rims.
/// The mesh has the points of A, of B, then new ones row by row. Faces run A_i+1, A_i, B_j: against A, along B.
/// @param points_a count_a points in order, at least 1; if closed at least 3, the first not repeated.
/// @param points_b as points_a.
/// @errors LOOP_TOO_SHORT, NOT_FINITE, NO_STRIP
/// @complexity Meridians as in gusset_stitch, plus linear in the mesh; likewise memory.
/// @source Nesterenko, the intermediate mesh (H, P); Fuchs, Kedem and Uselton (1977) for the best strips.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_strip(const struct gusset_context *context, const double *points_a,
    size_t count_a, const double *points_b, size_t count_b, const struct gusset_strip_options *options,
    struct gusset_result **result);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_strip(const struct gusset_result *result,
    struct gusset_strip_report *report);

/*** Welding */

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

typedef struct gusset_weld_options {
    size_t struct_size;
    gusset_weld_vertices vertices;
    /// Distance at which vertices coincide.
    /// - GUSSET_TOLERANCE_EXACT: 0; -0 equals 0.
    /// - GUSSET_TOLERANCE_AUTO: at most 2^-19 (32-bit) or 2^-48 (64-bit) of the largest coordinate, or, if more, twice
    ///   the last decimal place that positions show. At each vertex at most a quarter of the shortest edge;
    ///   GUSSET_COLLAPSE_ALLOW skips edges within the first limit.
    /// - Last decimal place: let D be the largest power of ten up to the longest side of the vertices' box. The place
    ///   is the largest of 1e-5 D, 1e-6 D, ... that divides a third of at least eight numbers. They are coordinates of
    ///   the largest order of magnitude, or differences of consecutive vertices, except multiples of 1e-4 D.
    gusset_tolerance_mode tolerance_mode;
    /// Largest distance of coincident vertices.
    /// @when tolerance_mode GUSSET_TOLERANCE_GIVEN
    double tolerance;
    gusset_collapse collapse;
    gusset_unused unused;
} gusset_weld_options;

/// Effects of welding. Indices are of the old mesh, and lists ascending.
typedef struct gusset_weld_report {
    size_t struct_size;
    /// Index of each vertex in the result; UINT32_MAX if removed.
    struct gusset_indices vertex_map;
    /// Index of each face in the result; UINT32_MAX if dropped.
    struct gusset_indices face_map;
    /// Half-edges of boundary edges that coincide with another edge but stay apart.
    struct gusset_indices left_edges;
    /// Vertices that coincide with another but are not merged.
    struct gusset_indices left_vertices;
    /// Vertices merged into a smaller one.
    uint32_t welded_vertices;
    /// Edges made from two boundary edges.
    uint32_t sewn_edges;
    /// Dropped faces.
    uint32_t dropped_faces;
    /// Pairs of boundary edges that coincide only within near_tolerance, not sewn.
    uint32_t near_edge_pairs;
    /// Largest distance at which vertices coincide, except at short edges; 0 for equal positions.
    double tolerance;
    /// Tolerance that sews near_edge_pairs, at most a tenth of the edges there; 0 without any.
    double near_tolerance;
} gusset_weld_report;

/// Merges coincident vertices.
/// - By default, borders are sewn: exactly two coincident boundary edges, in either direction, become one.
/// - Edges stay apart, and are listed, where three or more coincide, or sewing would collapse a face or make a
///   non-manifold edge.
/// - Coincident vertices without an edge to sew stay apart. GUSSET_WELD_ALL merges all coincident vertices.
/// - In ascending order, each unclaimed vertex claims the unclaimed vertices within the tolerance, nearest first,
///   without chains.
/// - The result has the old faces, each from its first corner, and in order the other vertices and the smallest of
///   merged ones. A result without faces is not a valid input.
/// @errors OUT_OF_RANGE (tolerance)
/// @complexity O(H log H), if valences are small and few corners of one face coincide.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_weld(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_weld_options *options, struct gusset_result **result);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_weld(const struct gusset_result *result,
    struct gusset_weld_report *report);

/*** Sewing */

/// Effects of sewing. Lists are ascending.
typedef struct gusset_sew_report {
    size_t struct_size;
    /// As in gusset_weld_report.
    struct gusset_indices vertex_map;
    /// Index of each old face's first part; UINT32_MAX if dropped.
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
    /// As in gusset_weld_report.
    uint32_t near_edge_pairs;
    /// As in gusset_weld_report.
    double tolerance;
    /// As in gusset_weld_report.
    double near_tolerance;
} gusset_sew_report;

/// Sews coincident borders.
/// - Vertices are welded as by gusset_weld, before and after the splits.
/// - Boundary edges are split at vertices of other borders inside them (T-junctions), if exactly two pieces coincide
///   there. Triangles are cut into triangles, none turned over; larger faces gain corners.
/// - A vertex lies inside an edge, longer than twice the tolerance, if it is within the tolerance of the edge and not
///   of its ends.
/// - Splitting makes no non-manifold edges or degenerate faces.
/// - The result has the old faces in order, or their parts in their places. The smallest of merged vertices remains.
///   New vertices have old positions.
/// @param options as for gusset_weld; GUSSET_WELD_ALL welds all vertices before the splits, borders afterwards.
/// @errors as gusset_weld, TOO_LARGE (the result)
/// @complexity O(H log H), if valences are small and few vertices lie inside each edge.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sew(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_weld_options *options, struct gusset_result **result);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_sew(const struct gusset_result *result,
    struct gusset_sew_report *report);

/*** Orientation */

typedef struct gusset_orient_options {
    size_t struct_size;
    gusset_outward outward;
    uint32_t reserved;
} gusset_orient_options;

/// Faces turned over, and components that cannot be oriented.
typedef struct gusset_orient_report {
    size_t struct_size;
    /// For each face, 1 if it was turned over.
    const uint8_t *turned;
    size_t face_count;
    /// Smallest face of each non-orientable component, ascending.
    struct gusset_indices one_sided_faces;
    /// For each of them, a half-edge where faces cannot agree.
    struct gusset_indices one_sided_half_edges;
    /// Faces turned over.
    uint32_t turned_faces;
    /// Components: faces connected by edges with two faces. A degenerate face is one.
    uint32_t component_count;
    /// Closed components that face outwards only by GUSSET_OUTWARD_CLOSED.
    uint32_t inverted_components;
    uint32_t reserved;
} gusset_orient_report;

/// Turns faces over until the two faces of each edge run it in opposite directions.
/// Each component turns the fewest faces; on a tie, its smallest face stays. Non-manifold edges connect nothing.
/// Non-orientable components stay unchanged and are listed. Vertices and the order of faces do not change.
/// @complexity O(H log d).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_orient(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_orient_options *options, struct gusset_result **result);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_orient(const struct gusset_result *result,
    struct gusset_orient_report *report);

/*** Repair */

/// Options of gusset_repair. By default every stage runs.
typedef struct gusset_repair_options {
    size_t struct_size;
    gusset_tolerance_mode tolerance_mode;
    /// 1: borders are not sewn.
    uint32_t leave_borders;
    /// Largest distance of coincident borders.
    /// @when tolerance_mode GUSSET_TOLERANCE_GIVEN
    double tolerance;
    /// 1: faces without area stay.
    uint32_t leave_flat_faces;
    /// 1: duplicate faces stay.
    uint32_t leave_duplicates;
    /// 1: non-manifold edges and vertices stay, and faces within the solid.
    uint32_t leave_non_manifold;
    /// 1: holes stay open.
    uint32_t leave_holes;
    /// 1: open sheets that were attached to closed components stay.
    uint32_t leave_fins;
    /// 1: no component is oriented.
    uint32_t leave_orientation;
    /// 1: intersecting faces stay.
    uint32_t leave_intersections;
    uint32_t reserved;
    /// Ignores groups, and outward and plan_only, which must be valid.
    const struct gusset_fill_options *fill_options;
} gusset_repair_options;

/// Removes the defects of a mesh, to get a valid solid where possible. Changes only faces at defects. Stages, in order:
/// - Coincident borders are sewn, as by gusset_sew. Without a given tolerance, narrow gaps are closed.
/// - Faces without area are dropped; their neighbours meet there.
/// - Duplicate faces are dropped, except the first.
/// - Holes are filled, as by gusset_fill.
/// - Around non-manifold edges, faces divide space into cells. Faces with the solid on both sides are dropped, others
///   separated into sheets with their own vertices.
/// - Holes of sheets are filled. Open sheets that were attached to closed components are dropped.
/// - Components are oriented, and closed ones turned outwards.
/// - Closed components with intersecting faces are united, as by gusset_unite.
/// The solid consists of the cells with a winding number other than 0, if crossing faces from front to back adds 1
/// consistently. Otherwise it consists of all bounded cells. Old faces keep their order. Unused vertices are removed.
/// Vertices merged by the merge map stay merged. Intersecting faces of open components stay, and are listed. Repairing
/// a valid result changes nothing.
/// @errors as gusset_weld, OUT_OF_RANGE, TOO_LARGE (the result)
/// @complexity O(H log H), the time of gusset_fill for each hole, and the search for intersecting faces.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_repair(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_repair_options *options, struct gusset_result **result);

/// Unites closed pieces: returns the border of all points with a winding number of at least 1. Pieces may intersect
/// themselves, and intersect, touch, coincide with or lie within others. Walls of cavities look into the cavities.
/// Inverted parts outside vanish. Faces that no other meets stay unchanged. New vertices are rounded to the first
/// piece's scalar type. Border edges of two pieces may close each other.
/// gusset_result_get_repair lends the report. It numbers old vertices and faces piece after piece; dropped faces have
/// GUSSET_DROP_OVERLAP. Intersecting pairs remain only where rounding keeps making them.
/// @param pieces as for gusset_join.
/// @errors EMPTY_MESH (also if nothing remains), MIXED_SCALARS, MESH_NOT_CLOSED (with input and face at an open edge)
/// @complexity O((n + k) log n) for n triangles of which k pairs intersect.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_unite(const struct gusset_context *context,
    const struct gusset_mesh_view *pieces, size_t piece_count, struct gusset_result **result);

struct gusset_repair_report;

/// Lends the report of a repair or union.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_repair(const struct gusset_result *result,
    struct gusset_repair_report *report);

/*** Report of a repair */

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
/// Part of an open sheet attached to a closed component.
#define GUSSET_DROP_FIN 4
/// The face is in an overlapping or inverted part.
#define GUSSET_DROP_OVERLAP 5

/// Changes, and defects that the result still has (_left).
typedef struct gusset_repair_report {
    size_t struct_size;
    /// 1 if the result bounds a solid: closed, manifold, oriented, without degenerate, duplicate, intersecting or
    /// zero-area faces.
    uint32_t valid;
    /// Vertices merged into others.
    uint32_t welded_vertices;
    /// Edges made from boundary edges or their parts.
    uint32_t sewn_edges;
    /// Old faces that sewing split or gave corners.
    uint32_t split_faces;
    /// Copies of vertices that separate sheets.
    uint32_t split_vertices;
    /// Holes that were filled.
    uint32_t filled_holes;
    /// Boundary edges.
    uint32_t boundary_edges_left;
    /// Non-manifold edges.
    uint32_t non_manifold_edges_left;
    /// Non-manifold vertices.
    uint32_t non_manifold_vertices_left;
    /// Edges whose two faces disagree in orientation.
    uint32_t orientation_conflicts_left;
    /// Degenerate, duplicate and zero-area faces.
    uint32_t bad_faces_left;
    uint32_t reserved;
    /// Largest move of a remaining vertex onto another; 0 without any.
    double tolerance;
    /// Old face that each face is or is part of; UINT32_MAX for patches, which come last.
    struct gusset_indices face_origin;
    /// Smallest old vertex that each vertex is; UINT32_MAX for new ones, which come last.
    struct gusset_indices vertex_origin;
    /// For each face, 1 if it was turned over.
    const uint8_t *turned;
    size_t face_count;
    /// Old faces without a remaining part, ascending.
    struct gusset_indices dropped_faces;
    /// Reason why a face was dropped.
    const gusset_drop_reason *drop_reasons;
    size_t dropped_count;
    /// Intersecting pairs in the result, ascending, smaller face first.
    struct gusset_indices intersecting_pairs;
} gusset_repair_report;

/*** Triangulation */

/// Splits faces into triangles of their corners, in order.
/// A face of n corners becomes n - 2 triangles with all its corners: a closed mesh stays closed. Vertices keep their
/// indices.
/// - A quad is split by its shorter diagonal, or, if concave, by the one inside.
/// - A larger face becomes a fan if its first corner sees all others. Otherwise its ears are cut off, in projection
///   along a coordinate axis. A face may pass edges twice to reach a hole.
/// - If triangles of a warped or self-crossing face of at most 40 corners overlap, the split with the least overlap
///   replaces them.
/// gusset_result_origins_create gives each triangle's face and corners.
/// @complexity O(H); for a face of n corners that is not convex O(n log n), and at most 1000 tests a corner.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_triangulate(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, struct gusset_result **result);

/*** Alignment */

typedef uint32_t gusset_alignment_start;
/// As given, moved by poses if any.
#define GUSSET_ALIGN_AS_GIVEN 0
/// Principal axes on the first piece's, in the best of four ways. For pieces that show one object whole.
#define GUSSET_ALIGN_PRINCIPAL_AXES 1
/// Rims of like shape put together, which then hold the pieces. For parts of a cut or broken surface without overlap.
#define GUSSET_ALIGN_RIMS 2
/// Like features of the surfaces put together, for overlapping pieces in any poses. A piece stays if its pose is
/// uncertain, with the verdict GUSSET_ALIGNED_UNDETERMINED.
#define GUSSET_ALIGN_FEATURES 3

/// Verdict on the pose of a piece.
typedef uint32_t gusset_aligned_reason;
/// Trusted: the piece fits trusted pieces, up to the first. It fits to a mean edge: slightly scaled or mirrored smooth
/// surfaces may pass, and pieces that could only slide together.
#define GUSSET_ALIGNED_TRUSTED 0
/// The piece lacks faces with area, or overlaps others too little.
#define GUSSET_ALIGNED_NO_OVERLAP 1
/// Too much of the piece near others is off their surfaces.
#define GUSSET_ALIGNED_POOR_FIT 2
/// Up to the noise of normals, the piece is free to slide or turn. With GUSSET_ALIGN_FEATURES also: the piece overlaps
/// too little, or fits in several ways.
#define GUSSET_ALIGNED_UNDETERMINED 3
/// Most of the overlap has opposite normals: the piece is inside out or mirrored.
#define GUSSET_ALIGNED_FACES_OTHER_WAY 4
/// The piece overlaps nothing, and is over 50 times larger or smaller than the first: probably in another unit.
#define GUSSET_ALIGNED_OTHER_SIZE 5
/// The piece fits untrusted pieces only.
#define GUSSET_ALIGNED_TRUSTED_BY_NONE 6

typedef struct gusset_alignment_options {
    size_t struct_size;
    gusset_alignment_start start;
    /// Points of a piece to match; 0: 2,000.
    uint32_t samples;
    /// Rigid motions of the pieces, or NULL.
    /// @when start GUSSET_ALIGN_AS_GIVEN
    const struct gusset_transform *poses;
    size_t pose_count;
    /// Largest distance of matched points, and about how far a piece may move. 0: a tenth of the largest piece's box
    /// diagonal.
    double max_distance;
    /// Most rounds in each of two stages; 0: 100.
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
    /// Fraction on the other piece of points within 8 mean edges of it, 0 to 1.
    double fit;
    uint32_t count;
    /// 1 if count is at least 30 and fit at least 2/3.
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
    /// 1 if pieces stopped before the rounds ran out.
    uint32_t converged;
} gusset_alignment_view;

/// Poses of overlapping pieces.
typedef struct gusset_alignment gusset_alignment;

/// Finds rigid motions that fit overlapping pieces, all at once. The first piece stays.
/// Points match the nearest points of other pieces, except beyond borders or if normals differ by over 45 degrees.
/// Distant matches weigh less. Pieces without overlap stay at their start; underdetermined pieces may slide.
/// @param pieces as for gusset_join.
/// @errors EMPTY_MESH, OUT_OF_RANGE (max_distance; a pose that is not rigid, by index), COUNT_DIFFERS (fewer poses than
///     pieces)
/// @complexity O(V log V) for V vertices of a piece, and in each of usually 10 to 30 rounds O(samples log V) a piece
///     and neighbour; GUSSET_ALIGN_RIMS: 512^2 for two pieces. GUSSET_ALIGN_FEATURES: O(F) and at most about 2,000^2
///     for two pieces.
/// @source Besl and McKay 1992; Chen and Medioni 1992; Turk and Levoy 1994; Neugebauer 1997; Rusinkiewicz 2019.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_alignment_create(const struct gusset_context *context,
    const struct gusset_mesh_view *pieces, size_t piece_count, const struct gusset_alignment_options *options,
    struct gusset_alignment **alignment);

GUSSET_API void gusset_alignment_destroy(struct gusset_alignment *alignment);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_alignment_get_view(const struct gusset_alignment *alignment,
    struct gusset_alignment_view *view);

/*** Trimming */

typedef struct gusset_trim_options {
    size_t struct_size;
    /// Largest distance of surfaces that count as one. 0: 4 mean edges of the coarser piece.
    double max_distance;
    /// Largest angle between their normals, at least 0, below pi / 2; 0: 60 degrees.
    double max_angle;
    /// A point for each piece, or NULL. Parts seen at flat angles weigh less.
    const double *viewpoints;
    size_t viewpoint_count;
    /// Islands of fewer faces are removed; 0: 30. The limit is 20 times that for islands that other pieces also show.
    /// Smaller holes are not made.
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
    /// Faces removed, with neighbours, for intersecting an earlier piece.
    uint32_t crossings;
    uint32_t reserved;
} gusset_trim_view;

/// Result of trimming.
typedef struct gusset_trim gusset_trim;

/// Keeps one piece of each overlap, with a narrow gap that gusset_join closes; see GUSSET_OVERLAPS_TRIM.
/// Cuts run where two pieces are equally good; up to noise, the earlier piece stays. Vertices are better farther from
/// borders, in mean edges, and seen less flat from the viewpoint. Loops of under 32 vertices are not borders. A vertex
/// lies on another piece if the nearest point is close, faces the same way, and is not on a border. No vertex moves,
/// and no face is split. Parts thinner than two faces, small islands, and faces attached by one vertex or intersecting
/// an earlier piece are removed.
/// @param pieces as for gusset_join, in one coordinate system.
/// @errors EMPTY_MESH, OUT_OF_RANGE (max_distance, max_angle), NOT_FINITE (a viewpoint), COUNT_DIFFERS (fewer
///     viewpoints than pieces)
/// @complexity O(V log F) for V vertices of a piece and F faces of each near piece, up to quadratic in the faces at one
///     place.
/// @source After Turk and Levoy 1994.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_trim_create(const struct gusset_context *context,
    const struct gusset_mesh_view *pieces, size_t piece_count, const struct gusset_trim_options *options,
    struct gusset_trim **trim);

GUSSET_API void gusset_trim_destroy(struct gusset_trim *trim);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_trim_get_view(const struct gusset_trim *trim,
    struct gusset_trim_view *view);

/*** Boundary loops */

typedef uint32_t gusset_non_manifold;
/// Each face has its own border there; loops along it are closed.
#define GUSSET_NON_MANIFOLD_CUT 0
/// Loops have boundary edges only, and end at non-manifold ones as open chains.
#define GUSSET_NON_MANIFOLD_STOP 1

/// Part of the mesh that is checked.
typedef uint32_t gusset_survey;
/// Every edge: all defects are reported, and flagged on loops.
#define GUSSET_SURVEY_WHOLE_MESH 0
/// The boundary only, many times faster. Checks the whole mesh if the boundary is open, touches itself, is not oriented
/// or has edges with three faces.
/// Other defects are not reported. Edges with equal numbers of faces in both directions, two or more, do not cut loops.
/// The search by hashes fails with a probability below 2^-64, but malicious meshes may hide a boundary: check untrusted
/// ones whole.
#define GUSSET_SURVEY_BOUNDARY_ONLY 1

/// Properties of a loop.
/// @bits
typedef uint32_t gusset_loop_flags;
/// An open chain, with one vertex more than edges.
#define GUSSET_LOOP_OPEN 1
/// Passes a vertex where the surface touches itself.
#define GUSSET_LOOP_BOW_TIE 2
/// Cut from a longer walk that passes a vertex twice.
#define GUSSET_LOOP_SPLIT 4
/// Runs along, or ends at, a non-manifold edge.
#define GUSSET_LOOP_NON_MANIFOLD 8
/// Faces along the loop disagree in orientation.
#define GUSSET_LOOP_NOT_ORIENTED 16
/// Has an edge of length 0.
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

typedef uint32_t gusset_defect_kind;
/// A face (index) repeats a vertex (other).
#define GUSSET_DEFECT_DEGENERATE_FACE 1
/// The two faces of an edge run it in one direction: half-edges index and other.
#define GUSSET_DEFECT_ORIENTATION_CONFLICT 2
/// An edge has three or more half-edges: index is the first, count their number. A face may count twice.
#define GUSSET_DEFECT_NON_MANIFOLD_EDGE 3
/// The faces at a vertex (index) form several fans. Ends of non-manifold edges count too where a loop passes.
#define GUSSET_DEFECT_BOW_TIE 4

/// Boundary loops of a mesh.
typedef struct gusset_boundary gusset_boundary;

typedef struct gusset_boundary_options {
    size_t struct_size;
    gusset_non_manifold non_manifold;
    gusset_survey survey;
} gusset_boundary_options;

/// Boundary loop or open chain. Edge i runs from vertices[i] to vertices[i + 1], cyclically in a loop.
typedef struct gusset_loop_view {
    size_t struct_size;
    /// Vertices, each once. Closed loops start at their smallest half-edge.
    struct gusset_indices vertices;
    /// Half-edge of each edge.
    struct gusset_indices half_edges;
    /// Face beside each edge.
    struct gusset_indices faces;
    /// Properties of each edge.
    const gusset_edge_flags *edge_flags;
    /// Sum of the edge lengths.
    double length;
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
    /// Half-edges of a non-manifold edge; else 0.
    uint32_t count;
} gusset_defect;

/// Loop count and defects of a boundary.
typedef struct gusset_boundary_view {
    size_t struct_size;
    /// Loops and open chains; 0 if the mesh is closed.
    size_t loop_count;
    /// Walks that loops were cut from. Touching loops share a walk that passes from one to the other.
    size_t walk_count;
    /// Degenerate faces, orientation conflicts, non-manifold edges, and bow-ties on the boundary.
    const struct gusset_defect *defects;
    size_t defect_count;
} gusset_boundary_view;

/// Finds all boundary loops: chains of boundary edges.
/// Loops run as the faces along them: if faces are counter-clockwise from outside, the surface is on the left.
/// - Each loop passes a vertex once: a boundary that touches itself is cut. Loops may have only two vertices.
/// - Loops are ordered by smallest half-edge.
/// - Walks along only non-manifold edges are left out, except loops cut from other walks.
/// - A face with fewer than three sides between different vertices lacks a border; its neighbours count as adjacent.
/// @complexity O(H log d); GUSSET_SURVEY_BOUNDARY_ONLY O(H + B log B) for B boundary edges.
/// @source Nesterenko, algorithm 1, corrected.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_boundary_create(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_boundary_options *options,
    struct gusset_boundary **boundary);

GUSSET_API void gusset_boundary_destroy(struct gusset_boundary *boundary);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_boundary_get_view(const struct gusset_boundary *boundary,
    struct gusset_boundary_view *view);

/// Lends one loop.
/// @param index below loop_count of gusset_boundary_view.
/// @errors NO_SUCH_ELEMENT
GUSSET_API GUSSET_MUST_USE gusset_status gusset_boundary_get_loop(const struct gusset_boundary *boundary, size_t index,
    struct gusset_loop_view *view);

/*** Checks */

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

/// Counts, properties and defects of a mesh. Lists are ascending. Degenerate faces lack edges.
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
    /// Vertices whose faces form several fans; usually also ends of non-manifold edges.
    struct gusset_indices bow_ties;
    /// First half-edge of each edge whose two faces run it in one direction.
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
/// @complexity O(H log d).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_check_create(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, struct gusset_check **check);

GUSSET_API void gusset_check_destroy(struct gusset_check *check);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_check_get_view(const struct gusset_check *check,
    struct gusset_check_view *view);

/*** Certificates */

/// Facts about a result.
typedef struct gusset_certificate gusset_certificate;

/// Facts about a result. Faces match by the positions of their corners, from any corner; -0 equals 0. Each result face
/// matches at most one face of the pieces. Edges connect different vertices; a face with fewer than three has none.
/// Shared edges connect components.
typedef struct gusset_certificate_view {
    size_t struct_size;
    /// Vertices that faces use.
    uint32_t vertex_count;
    uint32_t edge_count;
    /// Faces.
    uint32_t face_count;
    uint32_t component_count;
    /// 1 if there are edges, and each has exactly two faces.
    uint32_t closed;
    /// 1 if closed and oriented without intersecting pairs, and facing outwards. A component that an odd number of
    /// others encloses has a negative volume, any other a positive one.
    uint32_t outward;
    /// Edges with one face.
    uint32_t boundary_edges;
    /// Edges with three or more faces.
    uint32_t non_manifold_edges;
    /// Ends of non-manifold edges, and vertices with several fans.
    uint32_t non_manifold_vertices;
    /// Edges whose two faces run them in one direction.
    uint32_t orientation_conflicts;
    /// Faces that repeat a vertex.
    uint32_t degenerate_faces;
    /// As in gusset_check_view.
    uint32_t duplicate_faces;
    /// Triangles, also of polygons, with three different vertices on one line.
    uint32_t collinear_triangles;
    /// Faces that match no face of the pieces.
    uint32_t new_faces;
    /// Pairs of faces with common points beyond common vertices and edges.
    uint64_t intersecting_pairs;
    /// Faces of the pieces that the result has.
    uint64_t kept_faces;
    /// Faces that the result has only reversed, as (piece, face), ascending.
    struct gusset_indices turned_faces;
    /// Faces that the result lacks, as (piece, face), ascending.
    struct gusset_indices lost_faces;
    /// Largest distance of a used vertex of the pieces from the result's nearest used vertex; 0 if all remain.
    double farthest_distance;
    /// Piece of the farthest vertex; UINT32_MAX without one.
    uint32_t farthest_piece;
    /// The farthest vertex; UINT32_MAX without one.
    uint32_t farthest_vertex;
    /// Vertex of the result nearest to it; UINT32_MAX without one.
    uint32_t nearest_vertex;
    uint32_t reserved;
    /// Triangles of faces with more than three corners, as half-edges, face by face.
    struct gusset_indices polygon_triangles;
} gusset_certificate_view;

/// States facts about a result, from anywhere, and its pieces. verify.py confirms or refutes the facts by exact
/// arithmetic, without the library.
/// All facts are exact, except farthest_distance. outward is 0 also if undecided: a volume is 0 up to rounding, or a
/// component shares the positions of all its vertices with others.
/// @param pieces the meshes that the result was made from; may be NULL without any.
/// @errors TOO_LARGE (vertices of all meshes)
/// @complexity O(n log n) for n corners of all meshes, and the search for intersecting faces.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_certificate_create(const struct gusset_context *context,
    const struct gusset_mesh_view *pieces, size_t piece_count, const struct gusset_mesh_view *result,
    struct gusset_certificate **certificate);

GUSSET_API void gusset_certificate_destroy(struct gusset_certificate *certificate);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_certificate_get_view(const struct gusset_certificate *certificate,
    struct gusset_certificate_view *view);

/*** Developments */

typedef uint32_t gusset_distortion;
/// Lengths and areas, stretch and compression alike: the symmetric Dirichlet energy.
#define GUSSET_DISTORTION_SYMMETRIC 0
/// Lengths: as rigid as possible.
#define GUSSET_DISTORTION_RIGID 1
/// Angles: the least-squares conformal map, which may stretch areas.
#define GUSSET_DISTORTION_CONFORMAL 2

typedef struct gusset_develop_options {
    size_t struct_size;
    gusset_distortion distortion;
    /// Most darts: cuts from a chart's border to where it is curved.
    uint32_t max_darts;
    /// Vertices of paths to cut along, path after path, connected by shortest edge paths. A path of one vertex cuts
    /// nothing.
    struct gusset_indices cuts;
    /// Start of each path in cuts, and the end of the last. Empty: one path.
    struct gusset_indices cut_offsets;
    /// Darts stop once no length changes by a larger factor; above 1, finite; 0: none.
    double max_stretch;
    /// Most steps of a descent; 0: 200. Charts whose border would meet itself, and GUSSET_DISTORTION_RIGID, need
    /// several descents.
    uint32_t max_iterations;
    uint32_t reserved;
} gusset_develop_options;

/// Flattens a surface with the least distortion.
/// The surface is cut along the given paths, then into discs along short paths. Each component is then a chart. The
/// result has the surface's scalar type and z = 0; faces keep their order and first corners, counter-clockwise.
/// - A chart that unfolds about its edges keeps their lengths, to 1e-10 of the length, or of 1e-3 mean edges if more.
///   Rounding errors grow with the distance from the origin. The chart may overlap itself, and rounding may turn over
///   triangles without area.
/// - Other charts descend to the least distortion. The map is one-to-one: no triangle is turned over, and the border
///   does not meet itself. If this ends the descent early, finish is GUSSET_CHART_STALLED.
/// - Darts run from the border to the vertex with the worst conformal scale, while they lower the distortion.
/// - Each chart's border has the greatest variance along x.
/// - A vertex on a cut becomes several. Merged vertices count as the smallest.
/// - Non-manifold edges, and edges whose faces disagree in orientation, are borders, not cuts.
/// - Polygons are measured by triangles. Triangles count as at least 1e-7 of their longest side high, and 1e-7 of the
///   mean edge large.
/// - A conformal map has the area of the surface.
/// @errors OUT_OF_RANGE (max_stretch, coordinates beyond 1e150), BAD_OFFSETS (cut_offsets), INDEX_OUT_OF_RANGE (input
///     is the cut, index the place in it), CUT_NOT_CONNECTED (likewise), REPEATED_CORNER
/// @complexity O(H log H) if charts unfold; else O(n^1.5) for n vertices of a chart, each step and each dart; memory
///     O(n log n).
/// @source Rabinovich et al. 2017, for the descent; Levy et al., Least squares conformal maps, 2002; Erickson and
///     Whittlesey 2005, for opening cuts; Ben-Chen et al. 2008, for darts.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_develop(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_develop_options *options, struct gusset_result **result);

struct gusset_develop_report;

GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_develop(const struct gusset_result *result,
    struct gusset_develop_report *report);

/*** Developments */

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
    /// Pairs of border edges that meet in the plane, except neighbours. GUSSET_CHART_EXACT: crossings by over 1e-8 of
    /// the area's root. GUSSET_CHART_FOLDED: all. Else 0.
    uint32_t overlaps;
    /// Triangles turned over, by GUSSET_CHART_FOLDED only.
    uint32_t folds;
    uint32_t reserved;
    /// Symmetric Dirichlet energy: the area's mean of the sum of s^2 + 1 / s^2 over both singular values s of the map;
    /// 4 for an isometry, else more; infinite if a triangle is turned over or flat, up to rounding.
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
    /// Largest and smallest factor by which each face's lengths grow.
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

/*** Facing arcs */

/// Facing vertices of two loops.
typedef struct gusset_facing gusset_facing;

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
    /// First index and length of each run of facing vertices, alternating; runs may pass the loop's end.
    struct gusset_indices runs[2];
    /// The chosen run, as arc_a and arc_b of gusset_stitch_options.
    uint32_t taken[2][2];
    /// Vertices of each loop.
    size_t counts[2];
} gusset_facing_view;

/// Finds the vertices of two loops that face each other.
/// @param points_a count_a vertices in order, at least 1.
/// @param points_b as points_a.
/// @errors LOOP_TOO_SHORT, NOT_FINITE, OUT_OF_RANGE, PLANES_UNDECIDED (the centres coincide, or no vertex of a loop
///     exceeds the tolerance)
/// @complexity O((N + M) log M).
/// @source Nesterenko, algorithm 2, equations 5-7.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_facing_create(const struct gusset_context *context,
    const double *points_a, size_t count_a, const double *points_b, size_t count_b,
    const struct gusset_facing_options *options, struct gusset_facing **facing);

GUSSET_API void gusset_facing_destroy(struct gusset_facing *facing);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_facing_get_view(const struct gusset_facing *facing,
    struct gusset_facing_view *view);

/// Computes GUSSET_MERIDIANS_INDEX. For each i = 0 .. n, j of 0 .. m makes |m i - n j| least; on ties the later one.
/// @param n segments of the longer polyline: N - 1 if open with N vertices, N if closed.
/// @param m segments of the other polyline, at most n (OUT_OF_RANGE).
/// @param j n + 1 numbers.
/// @errors OUT_OF_RANGE
/// @complexity O(n).
/// @source Nesterenko, the intermediate mesh: j = floor((2 m i + n) / (2 n)).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_meridians_index(uint32_t n, uint32_t m, uint32_t *j, size_t capacity,
    size_t *written);

/*** Mesh sections */

/// Side of vertices in a plane.
typedef uint32_t gusset_in_plane;
/// They count as above: the section is the limit from just below the plane.
#define GUSSET_IN_PLANE_ABOVE 0
/// They count as below: the section is the limit from just above the plane.
#define GUSSET_IN_PLANE_BELOW 1

typedef uint32_t gusset_cutting_kind;
/// Parallel planes with the normal `direction`, at rising distances `values` from `point`.
#define GUSSET_CUTTING_STACK 0
/// Planes through `points`, each with its normal in `normals`.
#define GUSSET_CUTTING_PLANES 1
/// Planes through the axis at `point` along `direction`, turned from `reference` by the angles `values`. Normals point
/// to larger angles.
#define GUSSET_CUTTING_AXIS 2
/// Planes across the polyline `points`, at the distances `values` from its first point along it. They turn evenly from
/// each vertex's bisector to the next.
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

typedef struct gusset_mesh_section_options {
    size_t struct_size;
    /// Leaves out points up to this far from the polyline; 0: keeps all points. Polylines with points left out may
    /// cross each other or themselves.
    double tolerance;
    gusset_in_plane in_plane;
    uint32_t reserved;
} gusset_mesh_section_options;

/// A polyline of a section.
typedef struct gusset_section_path {
    /// Index of the plane.
    uint32_t plane;
    /// 1: returns to its first point, not repeated.
    uint32_t closed;
    /// Smallest closed path of the plane around a closed path, or UINT32_MAX.
    uint32_t parent;
    /// Number of closed paths around a closed path; else 0.
    uint32_t depth;
    /// Length, with all points.
    double length;
    /// Area inside a closed path, with all points, positive if counter-clockwise seen against the plane's normal; else
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
    /// Face of the segment after each point, the first if points were left out; UINT32_MAX at an open path's end.
    struct gusset_indices faces;
} gusset_mesh_sections_view;

/// Cuts a mesh by planes into ordered polylines, with nesting and sources.
/// A polyline runs along the plane's normal x the face's normal: around a solid, outer loops are counter-clockwise seen
/// against the plane's normal, holes clockwise.
/// Sides of planes are exact. Vertices in a plane count as above it (GUSSET_IN_PLANE_BELOW: below). A closed mesh
/// therefore gives closed loops only. An edge in the plane appears if a face beside it is below (above), or there and
/// back if both are. Faces in the plane and peaks give nothing.
/// At a non-manifold edge, loops around the inside of solids touch but do not cross. Paths end at borders. Faces with
/// fewer than three sides between different vertices are left out.
/// @errors OUT_OF_RANGE (vectors, values, tolerance, coordinates beyond 1e150), NOT_FINITE (point), EMPTY_CURVE
///     (polyline without length)
/// @complexity O(V log n + H + s log s) for n planes of a stack and s crossed faces, parallel. Otherwise O(n (V + H) +
///     s log s). Nesting takes O(c log c) for c crossings of loops and lines: few lines pierce all loops, but many long
///     loops beside many small ones make c quadratic.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_mesh_sections_create(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_cutting_planes *planes,
    const struct gusset_mesh_section_options *options, struct gusset_mesh_sections **sections);

GUSSET_API void gusset_mesh_sections_destroy(struct gusset_mesh_sections *sections);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_mesh_sections_get_view(const struct gusset_mesh_sections *sections,
    struct gusset_mesh_sections_view *view);

/// Finds the sources of section points: the ends of their edges, weighted by the parameter. Faces of the origins are
/// segments, one for each point, with the mesh's faces as sources. Corners are empty.
/// @complexity O(points).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_mesh_sections_origins_create(const struct gusset_context *context,
    const struct gusset_mesh_sections *sections, struct gusset_origins **origins);

/*** Origins */

typedef uint32_t gusset_domain;
/// Vertices, points of polylines, nodes of nets and sheets.
#define GUSSET_DOMAIN_VERTICES 0
/// Corners of faces, in the order of face_corners; nodes of nets and sheets.
#define GUSSET_DOMAIN_CORNERS 1
/// Faces, cells of nets and sheets.
#define GUSSET_DOMAIN_FACES 2

/// Sources of a result's elements.
/// - An old element has itself; a merged vertex all its vertices in equal parts.
/// - A new vertex has the rim vertices around it, by its place on plain triangles between them, before fairing; on an
///   edge, its ends.
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

GUSSET_API void gusset_origins_destroy(struct gusset_origins *origins);

/// Lends the origins of one domain.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_origins_get_view(const struct gusset_origins *origins,
    gusset_domain domain, struct gusset_origins_view *view);

/*** Attributes */

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
/// Directions of three floats: weighted mean on the sphere, of length 1. Reversed faces negate theirs.
#define GUSSET_RULE_NORMAL 1
/// Bone weights, at least 0: weighted mean. The max_influences largest (the first of equals) are scaled to the sum 1,
/// or an integer type's largest value.
#define GUSSET_RULE_SKIN_WEIGHTS 2
/// Value of the source with the largest weight (the first of equals).
#define GUSSET_RULE_NEAREST 3
/// Texture coordinates. Vertices and faces: weighted mean. Corners of new faces:
/// - Weighted mean where both sides are on one chart. Most new faces must agree: the far side's values deviate from the
///   continued chart by less than half the old edge's length and distance combined.
/// - Elsewhere each new face continues its old face's unfolded chart, up to a seam in the middle, never back over the
///   chart.
/// - At the cut of a chart that closes on itself, values shift by the jump there, if that repeats the texture.
/// - A rim is on one chart while old faces have equal values at common vertices.
#define GUSSET_RULE_TEXTURE 4

/// Attribute of elements.
typedef struct gusset_channel {
    size_t struct_size;
    gusset_domain domain;
    /// Must be set: 0 is invalid.
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
    /// Components of each element. NULL with count 0: the input lacks them; its elements get 0, and new elements other
    /// sources' values.
    const void *values;
    size_t count;
    /// Stride in bytes; 0 if packed.
    size_t stride;
} gusset_channel_values;

/// Transfers values from elements of inputs to a result's.
/// Elements without sources that have values get 0.
/// @param inputs values of each input of the origins, in order.
/// @param values components of each element, at any alignment; bytes between do not change. Must not overlap the
///     inputs' values.
/// @param count room in elements, at least the elements of the result.
/// @param stride in bytes; 0 if packed.
/// @errors OUT_OF_RANGE (components; value_type and components that the rule refuses; a negative skin weight, with
///     element and input), NOT_FINITE (with element and input, except for GUSSET_RULE_NEAREST), COUNT_DIFFERS (of
///     inputs, or of values, with the input), BAD_STRIDE, BUFFER_TOO_SMALL, OVERLAP
/// @complexity O(sources and elements), parallel; no memory, but GUSSET_RULE_TEXTURE linear in the corners of new
///     faces.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_attributes_apply(const struct gusset_context *context,
    const struct gusset_origins *origins, const struct gusset_channel *channel,
    const struct gusset_channel_values *inputs, size_t input_count, void *values, size_t count, size_t stride);

/// Finds which vertices are one, for merge of gusset_mesh_view: those with equal keys, or else with equal finite
/// positions, -0 equal to 0.
/// @param keys one for each vertex; NULL: positions.
/// @param merge for each vertex the smallest that it is one with, at any alignment.
/// @complexity O(V log V) for V vertices; 8 bytes for each, 12 with keys.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_mesh_find_merge(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const uint32_t *keys, uint32_t *merge);

#ifdef __cplusplus
}
#endif
#endif
