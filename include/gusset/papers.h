/* Generated from src/capi; do not edit. See gusset.h. */

#ifndef GUSSET_PAPERS_H
#define GUSSET_PAPERS_H

#include "base.h"
#include "mesh.h"
#include "curve.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------------------------------ */
/* Regions of cells: Masks of cells: chains, diameters, cells and nodes. */

/// Measures of a region of cells.
typedef struct gusset_mask_report {
    size_t struct_size;
    /// How many cells it has.
    uint64_t cells;
    /// The number of cells of the longest of the shortest chains between two of its cells; 0 for no cells, 2^64 - 1 if
    /// the region is in several parts.
    uint64_t integer_diameter;
    /// Vertices less edges plus cells: 1 for a region in one part without holes.
    int64_t euler;
    /// No two points of the region are farther apart: the integer diameter times the greatest Euclidean diameter of its
    /// cells; infinite if the region is in several parts.
    double diameter;
} gusset_mask_report;

struct gusset_sheet;

/// A shortest chain of cells of a region from one cell to another: consecutive ones have a node in common, across
/// corners too. The sum of their diameters bounds the distance between points of from and of to.
/// @param words the region, at any alignment, a bit for each cell: that of cell (i, j) is bit k % 64 of word k / 64, k
///     = i * columns + j, columns of cells; NULL with count 0 for all cells.
/// @param count the words, at least as many as the cells need.
/// @param from row and column of a cell of the region, two numbers, at any alignment.
/// @param to the same of the other cell.
/// @param cells receives row and column of each cell of the chain, from and to included, two numbers each; NULL with
///     capacity 0 to ask for the size.
/// @param capacity how many cells it has room for.
/// @param written receives the number of cells, the integer length; 0 if there is no chain.
/// @errors SIZE_OVERFLOW (too few words), NO_SUCH_ELEMENT (with the cell), BUFFER_TOO_SMALL
/// @complexity O(cells).
/// @source Leus, eq. (3).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_mask_chain(const struct gusset_context *context,
    const struct gusset_sheet *sheet, const uint64_t *words, size_t count, const uint32_t *from, const uint32_t *to,
    uint32_t *cells, size_t capacity, size_t *written);

/// Measures a region of cells: its integer diameter and with it a bound of its diameter, and its Euler characteristic.
/// @param words the region, as for gusset_sheet_mask_chain.
/// @param count the region, as for gusset_sheet_mask_chain.
/// @param report struct_size set by the caller; all else is overwritten.
/// @complexity O(cells) for compact regions; for the worst O(cells^2), which can be cancelled.
/// @source Leus, eqs. (4) to (6).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_mask_measure(const struct gusset_context *context,
    const struct gusset_sheet *sheet, const uint64_t *words, size_t count, struct gusset_mask_report *report);

/// Lists the cells or the nodes of a mask, row after row. Its nodes are the corners of its cells, each once; lines that
/// close the sheet count as the first ones.
/// @param words the mask, as for gusset_sheet_mask_chain.
/// @param count the mask, as for gusset_sheet_mask_chain.
/// @param domain faces are the cells, vertices and corners the nodes.
/// @param elements receives row and column of each, two numbers each; NULL with capacity 0 to ask for the size.
/// @param capacity how many elements it has room for.
/// @param written receives the number of elements.
/// @errors SIZE_OVERFLOW (too few words), BUFFER_TOO_SMALL
/// @complexity O(cells / 64), and the cells of the mask; O(nodes) for nodes.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_mask_elements(const struct gusset_context *context,
    const struct gusset_sheet *sheet, const uint64_t *words, size_t count, gusset_domain domain, uint32_t *elements,
    size_t capacity, size_t *written);

/* ------------------------------------------------------------------------------------------------------------------ */
/* The search of the paper: The search by the logical scale as printed, corrected: a documented reference. */

/// The object from which distances or angles are measured.
typedef uint32_t gusset_reference_object;
/// The point.
#define GUSSET_REFERENCE_POINT 0
/// The plane through the point, across the direction.
#define GUSSET_REFERENCE_PLANE 1
/// The line through the point, along the direction.
#define GUSSET_REFERENCE_LINE 2
/// The segment from the point to the point and the direction.
#define GUSSET_REFERENCE_SEGMENT 3
/// Normals at an angle to the direction; distances are deviations from the angle, in radians.
#define GUSSET_REFERENCE_ANGLE 4
/// The curve.
#define GUSSET_REFERENCE_CURVE 5
/// The surface.
#define GUSSET_REFERENCE_SURFACE 6
/// The ray from the point along the direction.
#define GUSSET_REFERENCE_RAY 7

struct gusset_surface;

/// The task of the paper's search, and its method.
typedef struct gusset_reference_task {
    size_t struct_size;
    gusset_reference_object object;
    /// 0: cells that may have something within `within`. 1: cells that may have the nearest.
    uint32_t find_nearest;
    /// A point of the object; not read for angles.
    double point[3];
    /// Its direction, of any length but 0; not read for points.
    double direction[3];
    /// A distance, 0 or more, in the unit of the nodes, for angles in radians; INFINITY: all cells; not read for the
    /// nearest.
    double within;
    /// For GUSSET_REFERENCE_ANGLE: the angle, 0 to pi.
    double angle;
    /// For GUSSET_REFERENCE_ANGLE: a bound of both principal curvatures all over the sheet, for the paper's K d, see
    /// gusset_sheet_measure; 0: cones of normals instead, which are tighter.
    double curvature;
    /// For GUSSET_REFERENCE_ANGLE: 1 if normals of the other side will do as well.
    uint32_t unsigned_normals;
    /// 1: blocks are bounded by sums of the greatest bound of each ring of cells, instead of J d.
    uint32_t by_rings;
    /// 1: nodes in the order of rows, as in the paper; 0: a few far apart first.
    uint32_t by_rows;
    /// 1: lines of nodes that a block covers from side to side are not left out at once.
    uint32_t keep_lines;
    /// For GUSSET_REFERENCE_CURVE: the curve; else not read.
    const struct gusset_curve *curve;
    /// For GUSSET_REFERENCE_SURFACE: the surface; else not read.
    const struct gusset_surface *surface;
} gusset_reference_task;

/// A report on the search.
typedef struct gusset_reference_report {
    size_t struct_size;
    /// How many cells are left.
    uint64_t cells;
    /// How many nodes were looked at.
    uint64_t evaluations;
    /// How many blocks of cells were excluded.
    uint64_t blocks;
    /// How many lines of cells were left out at once.
    uint64_t dropped;
    /// The least distance of the nodes that were looked at; of the nearest task: of all nodes.
    double min_distance;
    /// The row of that node.
    uint32_t row;
    /// Its column.
    uint32_t column;
} gusset_reference_report;

/// The paper's search with its logical scale, corrected: which cells of a sheet may have a point within a distance of
/// an object, or the nearest one, or a normal at an angle. None that has is missing. It is the documented reference and
/// looks at many nodes; a surface (gusset_surface_create) answers the same and more from its index, much faster.
/// @param task what is looked for.
/// @param words receives a bit for each cell, laid out as for gusset_sheet_mask_chain; NULL with capacity 0 for the
///     size and the report alone; all words are 0 on failure.
/// @param capacity how many words it has room for.
/// @param written receives the number of words.
/// @param report what was done; its struct_size set by the caller; may be NULL.
/// @errors UNKNOWN_VALUE (object, flags), OUT_OF_RANGE (what is not finite, no direction, a negative distance, an angle
///     outside 0 to pi), BUFFER_TOO_SMALL
/// @complexity O(cells) for the bounds of cells, with threads; O(cells / 64) and the nodes looked at for the search.
/// @source Leus; docs/errata.md lists its errata.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_reference_mask(const struct gusset_context *context,
    const struct gusset_sheet *sheet, const struct gusset_reference_task *task, uint64_t *words, size_t capacity,
    size_t *written, struct gusset_reference_report *report);

/// The same search over a curve's own points, with the lengths of its arcs for diameters: which arcs may have a point
/// within a distance of an object, or the nearest one, or a tangent at an angle. Each segment is divided into as many
/// arcs of equal length in the parameter; the cells of the mask are the arcs in the order of the curve, its nodes their
/// ends. No arc that has what is looked for is missing.
/// @param parts arcs of each segment, at least 1; 2^30 of all at most.
/// @param task what is looked for; angles are those of tangents, for which curvature and lines are not read, and
///     unsigned_normals counts tangents of either direction.
/// @param words receives a bit for each arc: that of arc k is bit k % 64 of word k / 64; NULL with capacity 0 for the
///     size and the report alone; all words are 0 on failure.
/// @param capacity how many words it has room for.
/// @param written receives the number of words.
/// @param report what was done: columns are points of the curve, rows 0; its struct_size set by the caller; may be
///     NULL.
/// @errors as gusset_sheet_reference_mask, EMPTY_CURVE, OUT_OF_RANGE (parts), TOO_LARGE
/// @complexity O(arcs degree^2) for the lengths; O(arcs / 64) and the nodes looked at for the search.
/// @source Leus, the last paragraph.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_reference_mask(const struct gusset_context *context,
    const struct gusset_curve *curve, size_t parts, const struct gusset_reference_task *task, uint64_t *words,
    size_t capacity, size_t *written, struct gusset_reference_report *report);

struct gusset_surface_place;

/// The paper's approximate normals: at each place two orthogonal planes, parallel to the mean of the normals at the
/// cell's corners, cut the lines of the net; cubics through four crossings each have tangents that span the tangent
/// plane. They are of third order in the size of cells; the exact normals of the surface are had from a surface.
/// @param places count places of the sheet, whose own number is not read, at any alignment; u and v 0 to 1.
/// @param count see places.
/// @param normals receives x, y, z of each; 0 where there is none, and everywhere on failure.
/// @errors UNKNOWN_VALUE (reserved), NO_SUCH_ELEMENT (with the first place that the sheet does not have: no such cell,
///     parameters that are not 0 to 1)
/// @complexity Bounded work for each.
/// @source Leus, fig. 1.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_normals_by_sections(const struct gusset_context *context,
    const struct gusset_sheet *sheet, const struct gusset_surface_place *places, size_t count, double *normals);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Winged-edge tables: The tables of the paper, and the loops found in them. */

/// The direction in which faces are read.
typedef uint32_t gusset_winding;
/// Faces are stored counter-clockwise seen from outside, as modern libraries have it; the tables take them backwards.
#define GUSSET_FACES_COUNTER_CLOCKWISE 0
/// Faces are stored clockwise seen from outside, as Baumgart has it.
#define GUSSET_FACES_CLOCKWISE 1

/// Bits that describe an edge of a table.
/// @bits
typedef uint32_t gusset_winged_flags;
/// One of several records of an edge with three or more faces; each has one face.
#define GUSSET_WINGED_NON_MANIFOLD 1
/// One of two records of an edge whose faces run it in the same direction; each has one face.
#define GUSSET_WINGED_NOT_ORIENTED 2
/// M = N, or the edge belongs to a face of fewer than three proper edges.
#define GUSSET_WINGED_DEGENERATE 4

/// The winged-edge tables of a mesh. Opaque and immutable; it keeps nothing of the mesh.
typedef struct gusset_winged gusset_winged;

/// The faces of a winged-edge table. Opaque and immutable; it keeps nothing of the table.
typedef struct gusset_winged_faces gusset_winged_faces;

/// How tables are made, and read; all zero is the default.
typedef struct gusset_winged_options {
    size_t struct_size;
    gusset_winding winding;
    uint32_t reserved;
} gusset_winged_options;

/// One edge: Baumgart's M, N, b, c, d, e, L, R, where UINT32_MAX is NULL. Faces run clockwise seen from outside.
typedef struct gusset_winged_edge {
    /// The vertex M, where it starts.
    uint32_t m;
    /// The vertex N, where it ends.
    uint32_t n;
    /// In R, the edge after this one; it leaves N.
    uint32_t b;
    /// In L, the edge before this one; it arrives at N.
    uint32_t c;
    /// In R, the edge before this one; it arrives at M.
    uint32_t d;
    /// In L, the edge after this one; it leaves M.
    uint32_t e;
    /// The face L: it runs N to M.
    uint32_t left;
    /// The face R: it runs M to N.
    uint32_t right;
    /// Bits; 0 for an ordinary edge.
    gusset_winged_flags marks;
} gusset_winged_edge;

/// The tables. Pointers are valid until the handle is destroyed.
typedef struct gusset_winged_view {
    size_t struct_size;
    /// The edges in the order of their first half-edges; M is the vertex where that half-edge starts.
    const struct gusset_winged_edge *edges;
    /// How many.
    size_t edge_count;
    /// Per half-edge (position in face_corners), its edge.
    struct gusset_indices edge_of_half_edge;
    /// Per face, its first edge.
    struct gusset_indices edge_of_face;
    /// Per vertex, an edge at it, or UINT32_MAX.
    struct gusset_indices edge_of_vertex;
    /// The vertices of all loops of free edges (exactly one of L, R is NULL), loop after loop, surface on the left.
    struct gusset_indices loop_vertices;
    /// The edges along them; edge i starts at vertex i.
    struct gusset_indices loop_edges;
    /// Where each loop starts in both; one entry more than there are loops.
    struct gusset_indices loop_offsets;
} gusset_winged_view;

/// The faces of a table. Pointers are valid until the handle is destroyed.
typedef struct gusset_winged_faces_view {
    size_t struct_size;
    /// For face_offsets of a gusset_mesh_view: one entry more than there are faces.
    struct gusset_indices face_offsets;
    /// For face_corners: the vertices of each face in order.
    struct gusset_indices face_corners;
    /// Per corner, the edge that leaves it.
    struct gusset_indices edge_of_half_edge;
} gusset_winged_faces_view;

/// Fills the winged-edge tables of a mesh, and runs the paper's algorithm 1 on them. An edge with three or more faces,
/// or with two that run it in the same direction, becomes several marked records of one face each. The mesh of a stitch
/// keeps the edge numbers of its first mesh: only NULL sides along the rim are filled.
/// @errors as gusset_mesh_view
/// @complexity O(H log d) for H half-edges and at most d edges at a vertex; linear extra memory.
/// @source Nesterenko, equations 1-3 and algorithm 1. Criterion 3 is taken as "exactly one of L, R is NULL", as the
///     text has it; the loops are those of gusset_boundary_create, except that an edge whose faces disagree has a
///     border on both sides.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_winged_create(const struct gusset_context *context,
    const struct gusset_mesh_view *mesh, const struct gusset_winged_options *options, struct gusset_winged **winged);

/// Destroys tables; NULL is allowed.
GUSSET_API void gusset_winged_destroy(struct gusset_winged *winged);

/// Lends the tables.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_winged_get_view(const struct gusset_winged *winged,
    struct gusset_winged_view *view);

/// Reads the faces off a winged-edge table: the way back from gusset_winged_create to a polygon mesh, whose positions
/// the caller has. The records are held against each other and nothing is put right: each face must be one cycle of
/// three sides or more from wing to wing, wings and faces exist, and a side without a face has no wings. The marks are
/// not read. From the edges and edge_of_face of gusset_winged_create come the faces that it was given, corner for
/// corner.
/// @param edges the records, edge_count of them, packed.
/// @param edge_count see edges; 0 is a table without faces.
/// @param vertex_count how many vertices there are; those of edges are below it.
/// @param first_edges per face the edge at which it begins, of two such places the one where it runs M to N; NULL: the
///     one of the smallest number.
/// @param options the winding of the faces to be made; NULL for the defaults.
/// @errors BAD_WINGS (with the edge), FACE_TOO_SMALL (a number below the largest that no side has, too), OUT_OF_RANGE
///     (not one first edge for each face), TOO_LARGE
/// @complexity Linear time and memory.
/// @source Nesterenko, equation 2, read backwards.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_winged_faces_create(const struct gusset_context *context,
    const struct gusset_winged_edge *edges, size_t edge_count, size_t vertex_count,
    const struct gusset_indices *first_edges, const struct gusset_winged_options *options,
    struct gusset_winged_faces **faces);

/// Destroys faces; NULL is allowed.
GUSSET_API void gusset_winged_faces_destroy(struct gusset_winged_faces *faces);

/// Lends the faces.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_winged_faces_get_view(const struct gusset_winged_faces *faces,
    struct gusset_winged_faces_view *view);

#ifdef __cplusplus
}
#endif

#endif /* GUSSET_PAPERS_H */
