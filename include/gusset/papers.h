/* Generated from src/capi; see gusset.h. */

#ifndef GUSSET_PAPERS_H
#define GUSSET_PAPERS_H
#include "base.h"
#include "mesh.h"
#include "curve.h"

#ifdef __cplusplus
extern "C" {
#endif

/*** Regions of cells */

/// Measures of a region of cells.
typedef struct gusset_mask_report {
    size_t struct_size;
    /// Number of cells.
    uint64_t cells;
    /// Most cells in a shortest chain; 0 without cells, UINT64_MAX if disconnected.
    uint64_t integer_diameter;
    /// Vertices - edges + cells: 1 for a connected region without holes.
    int64_t euler;
    /// Bound of the distance of two points: integer_diameter times a cell's greatest Euclidean diameter; infinite if
    /// disconnected.
    double diameter;
} gusset_mask_report;

struct gusset_sheet;

/// Finds a shortest chain of cells in a region, in which neighbours share a node.
/// The sum of their diameters bounds the distance of points of the end cells.
/// @param words a bit a cell: cell (i, j) is bit k % 64 of word k / 64, k = i * columns + j. NULL with count 0: all
///     cells.
/// @param count at least the words of all cells.
/// @param from row and column in the region.
/// @param to likewise.
/// @param cells row and column of each cell, from and to included.
/// @param capacity in cells.
/// @param written number of cells; 0 without a chain.
/// @errors COUNT_DIFFERS (too few words), NO_SUCH_ELEMENT (cell)
/// @complexity O(cells).
/// @source Leus, eq. (3).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_mask_chain(const struct gusset_context *context,
    const struct gusset_sheet *sheet, const uint64_t *words, size_t count, const uint32_t *from, const uint32_t *to,
    uint32_t *cells, size_t capacity, size_t *written);

/// Measures a region.
/// @param words as for gusset_sheet_mask_chain.
/// @complexity O(cells) for compact regions, at worst O(cells^2).
/// @source Leus, eqs. (4) to (6).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_mask_measure(const struct gusset_context *context,
    const struct gusset_sheet *sheet, const uint64_t *words, size_t count, struct gusset_mask_report *report);

/// Lists the cells or nodes of a region, row after row.
/// Each node is listed once; a closing line counts as the first.
/// @param words as for gusset_sheet_mask_chain.
/// @param domain faces: cells; vertices or corners: nodes.
/// @param elements row and column of each.
/// @param capacity in elements.
/// @errors COUNT_DIFFERS (too few words)
/// @complexity O(cells / 64 + cells listed); O(nodes) for nodes.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_mask_elements(const struct gusset_context *context,
    const struct gusset_sheet *sheet, const uint64_t *words, size_t count, gusset_domain domain, uint32_t *elements,
    size_t capacity, size_t *written);

/*** The search of the paper */

typedef uint32_t gusset_reference_object;
/// The point.
#define GUSSET_REFERENCE_POINT 0
/// The plane through `point` with the normal `direction`.
#define GUSSET_REFERENCE_PLANE 1
/// The line through `point` along `direction`.
#define GUSSET_REFERENCE_LINE 2
/// The segment from `point` to `point` + `direction`.
#define GUSSET_REFERENCE_SEGMENT 3
/// Normals at `angle` to `direction`. Distances are deviations from it.
#define GUSSET_REFERENCE_ANGLE 4
/// The curve.
#define GUSSET_REFERENCE_CURVE 5
/// The surface.
#define GUSSET_REFERENCE_SURFACE 6
/// The ray from `point` along `direction`.
#define GUSSET_REFERENCE_RAY 7

struct gusset_surface;

/// Task and method of Leus's search. Fields name their object without prefix.
typedef struct gusset_reference_task {
    size_t struct_size;
    gusset_reference_object object;
    /// Cells to find: 0: those that may have a point `within`; 1: the nearest point's.
    uint32_t find_nearest;
    /// Not read for angles.
    double point[3];
    /// Not read for points.
    double direction[3];
    /// Largest distance; INFINITY: all cells. Not read with find_nearest.
    double within;
    /// ANGLE: 0 to pi.
    double angle;
    /// ANGLE: bound of the sheet's absolute principal curvatures, as from gusset_sheet_measure. 0: cones of normals,
    /// which are tighter.
    double curvature;
    /// ANGLE. 1: a normal and its opposite are equal.
    uint32_t unsigned_normals;
    /// Bound of blocks. 1: sum of each ring's greatest bound; 0: integer diameter times the greatest.
    uint32_t by_rings;
    /// 1: visits nodes row by row, like Leus; 0: distant ones first.
    uint32_t by_rows;
    /// 0: removes rows and columns of cells at an edge that an excluded block covers; 1: keeps them.
    uint32_t keep_lines;
    /// CURVE.
    const struct gusset_curve *curve;
    /// SURFACE.
    const struct gusset_surface *surface;
} gusset_reference_task;

/// Result and work of Leus's search.
typedef struct gusset_reference_report {
    size_t struct_size;
    /// Cells that remain.
    uint64_t cells;
    /// Nodes evaluated.
    uint64_t evaluations;
    /// Blocks of cells excluded.
    uint64_t blocks;
    /// Lines of cells removed.
    uint64_t dropped;
    /// Least distance of evaluated nodes (find_nearest: of all).
    double min_distance;
    /// Row of its node.
    uint32_t row;
    /// Column of its node.
    uint32_t column;
} gusset_reference_report;

/// Finds the cells of a sheet that may satisfy a task, by Leus's search.
/// No qualifying cell is missing. gusset_surface answers faster.
/// @param words a bit a cell, as for gusset_sheet_mask_chain; 0 after an error.
/// @param report may be NULL.
/// @errors OUT_OF_RANGE (non-finite values, zero direction, within, angle)
/// @complexity O(cells), parallel, for bounds; O(cells / 64 + nodes evaluated) for the search.
/// @source Leus; docs/errata.md lists its errata.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_reference_mask(const struct gusset_context *context,
    const struct gusset_sheet *sheet, const struct gusset_reference_task *task, uint64_t *words, size_t capacity,
    size_t *written, struct gusset_reference_report *report);

/// Finds the arcs of a curve that may satisfy a task.
/// Each segment has `parts` arcs of equal parameter length, numbered along the curve. No qualifying arc is missing.
/// GUSSET_REFERENCE_ANGLE refers to tangents, unsigned_normals to both directions; curvature and keep_lines are not
/// read.
/// @param parts arcs of each segment, at least 1; at most 2^30 arcs in all.
/// @param words a bit an arc: k is bit k % 64 of word k / 64; 0 after an error.
/// @param report row is 0, column the point of the curve; may be NULL.
/// @errors as gusset_sheet_reference_mask, EMPTY_CURVE, OUT_OF_RANGE (parts)
/// @complexity O(arcs degree^2) for lengths; O(arcs / 64 + nodes evaluated) for the search.
/// @source Leus, the last paragraph.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_reference_mask(const struct gusset_context *context,
    const struct gusset_curve *curve, size_t parts, const struct gusset_reference_task *task, uint64_t *words,
    size_t capacity, size_t *written, struct gusset_reference_report *report);

struct gusset_surface_place;

/// Approximates normals by Leus's sections, to third order in the size of cells.
/// Two orthogonal planes parallel to the mean normal of the cell's corners cut the net's lines. In each, a cubic
/// through four crossings gives a tangent. gusset_surface_evaluate is exact.
/// @param places their sheet is not read.
/// @param normals count normals; 0 if undefined or after an error.
/// @errors NO_SUCH_ELEMENT (place; also a parameter outside 0 to 1)
/// @complexity O(1) a place.
/// @source Leus, fig. 1.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_normals_by_sections(const struct gusset_context *context,
    const struct gusset_sheet *sheet, const struct gusset_surface_place *places, size_t count, double *normals);

/*** Winged-edge tables */

/// Orientation of faces in a mesh.
typedef uint32_t gusset_winding;
/// Counter-clockwise seen from outside. The tables list them in reverse, as Baumgart does.
#define GUSSET_FACES_COUNTER_CLOCKWISE 0
/// Clockwise seen from outside, as Baumgart's.
#define GUSSET_FACES_CLOCKWISE 1

/// Marks of an edge.
/// @bits
typedef uint32_t gusset_winged_flags;
/// One face of a non-manifold edge.
#define GUSSET_WINGED_NON_MANIFOLD 1
/// One face of an edge that two faces traverse in one direction.
#define GUSSET_WINGED_NOT_ORIENTED 2
/// The ends are equal, or a face has fewer than three edges with different ends.
#define GUSSET_WINGED_DEGENERATE 4

/// Winged-edge tables of a mesh.
typedef struct gusset_winged gusset_winged;

/// Faces of a winged-edge table.
typedef struct gusset_winged_faces gusset_winged_faces;

/// Options of winged-edge tables.
typedef struct gusset_winged_options {
    size_t struct_size;
    gusset_winding winding;
    uint32_t reserved;
} gusset_winged_options;

/// An edge in Baumgart's notation, UINT32_MAX for NULL. Faces are clockwise seen from outside.
typedef struct gusset_winged_edge {
    /// Start vertex M.
    uint32_t m;
    /// End vertex N.
    uint32_t n;
    /// Next edge in R, at N.
    uint32_t b;
    /// Previous edge in L, at N.
    uint32_t c;
    /// Previous edge in R, at M.
    uint32_t d;
    /// Next edge in L, at M.
    uint32_t e;
    /// Face L, which traverses the edge from N to M.
    uint32_t left;
    /// Face R, which traverses the edge from M to N.
    uint32_t right;
    gusset_winged_flags marks;
} gusset_winged_edge;

typedef struct gusset_winged_view {
    size_t struct_size;
    /// Edges, ordered by their first half-edges, which start at M.
    const struct gusset_winged_edge *edges;
    size_t edge_count;
    /// Edge of each half-edge (position in face_corners).
    struct gusset_indices edge_of_half_edge;
    /// First edge of each face.
    struct gusset_indices edge_of_face;
    /// An edge at each vertex, or UINT32_MAX.
    struct gusset_indices edge_of_vertex;
    /// Vertices of all boundary loops, surface on the left. Exactly one of L and R of a boundary edge is NULL.
    struct gusset_indices loop_vertices;
    /// Edges of the loops; edge i starts at vertex i.
    struct gusset_indices loop_edges;
    /// Offsets into loop_vertices and loop_edges, by loop.
    struct gusset_indices loop_offsets;
} gusset_winged_view;

typedef struct gusset_winged_faces_view {
    size_t struct_size;
    /// As in gusset_mesh_view.
    struct gusset_indices face_offsets;
    /// As in gusset_mesh_view.
    struct gusset_indices face_corners;
    /// Edge that leaves each corner.
    struct gusset_indices edge_of_half_edge;
} gusset_winged_faces_view;

/// Makes the winged-edge tables of a mesh, and finds its boundary loops by Nesterenko's algorithm 1.
/// A non-manifold edge, or one with two faces in one direction, becomes marked records of one face each. A stitched
/// mesh keeps its first mesh's edge numbers. Loops are as in gusset_boundary_create, except that edges with
/// inconsistent faces are boundaries on both sides.
/// @complexity O(H log d); linear memory.
/// @source Nesterenko, equations 1-3 and algorithm 1; criterion 3 as "exactly one of L, R is NULL".
GUSSET_API GUSSET_MUST_USE gusset_status gusset_winged_create(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_winged_options *options, struct gusset_winged **winged);

GUSSET_API void gusset_winged_destroy(struct gusset_winged *winged);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_winged_get_view(const struct gusset_winged *winged,
    struct gusset_winged_view *view);

/// Reads the faces of a winged-edge table, and checks its records.
/// Each face must be one cycle of three or more sides along the wings. Wings and faces must exist; sides without a face
/// lack wings. Marks are not read. Edges and edge_of_face of gusset_winged_create give back its faces corner for
/// corner.
/// @param edge_count 0: no faces.
/// @param vertex_count exceeds every vertex of an edge.
/// @param first_edges for each face, the edge where it begins; from M to N if both sides are the face's. NULL: the
///     lowest.
/// @errors BAD_WINGS (edge), FACE_TOO_SMALL (also a face without sides), OUT_OF_RANGE (first_edges)
/// @complexity O(edges) time and memory.
/// @source Nesterenko, equation 2, read backwards.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_winged_faces_create(const struct gusset_context *context,
    const struct gusset_winged_edge *edges, size_t edge_count, size_t vertex_count,
    const struct gusset_indices *first_edges, const struct gusset_winged_options *options,
    struct gusset_winged_faces **faces);

GUSSET_API void gusset_winged_faces_destroy(struct gusset_winged_faces *faces);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_winged_faces_get_view(const struct gusset_winged_faces *faces,
    struct gusset_winged_faces_view *view);

#ifdef __cplusplus
}
#endif
#endif
