/* Generated from src/capi; do not edit. See gusset.h. */

#ifndef GUSSET_SURFACE_H
#define GUSSET_SURFACE_H

#include "base.h"
#include "mesh.h"
#include "curve.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------------------------------ */
/* Surfaces: Sheets with an index: smooth surfaces that answer queries. */

/// A smooth surface of one or more sheets with an index, which answers. Opaque and immutable: all functions may use it
/// from any thread, and many at the same time, each with a context of its own; it is destroyed when none uses it any
/// more. It keeps what it needs of its sheets.
typedef struct gusset_surface gusset_surface;

/// A sheet of a surface.
typedef struct gusset_surface_sheet {
    /// Cells in u: u runs from 0 to this. There is one more row of corners.
    size_t rows;
    /// Cells in v.
    size_t columns;
    /// The number of its cell (0, 0) among the cells of all sheets, one sheet after the other, each row after row. Cell
    /// (i, j) has the number first_cell + i * columns + j, which is its bit in masks of gusset_surface_cells_view.
    uint64_t first_cell;
    /// The number of its corner (0, 0) among the corners of all sheets, rows + 1 by columns + 1 each: where its values
    /// begin for GUSSET_CONTOUR_VALUES.
    uint64_t first_node;
    /// 1: closed in u.
    uint32_t closed_u;
    /// 1: closed in v.
    uint32_t closed_v;
} gusset_surface_sheet;

/// A place on a surface.
typedef struct gusset_surface_place {
    /// The sheet, counted from 0 as they were given.
    uint32_t sheet;
    /// The row of the cell: between node rows row and row + 1.
    uint32_t row;
    /// Its column.
    uint32_t column;
    uint32_t reserved;
    /// The parameter within the cell, 0 to 1, from row to row; that of the sheet is row + u.
    double u;
    /// The same from column to column.
    double v;
} gusset_surface_place;

/// How two surfaces touch.
typedef uint32_t gusset_contact_kind;
/// Two surfaces touch in a point: all round it they are apart, or overlap by no more than the tolerance.
#define GUSSET_CONTACT_POINT 1
/// Two branches of an intersection cross in a point, or pass it within the tolerance.
#define GUSSET_CONTACT_CROSSING 2

/// A point where two surfaces touch, to the tolerance: their normals there are parallel.
typedef struct gusset_surface_contact {
    /// Where it is on the first surface.
    struct gusset_surface_place place;
    /// Where it is on the second one.
    struct gusset_surface_place other;
    /// A length: how far the first surface is above the second one, along the normal of the first.
    double gap;
    /// A length: near the contact, points of the one surface that are within the tolerance of the other one are within
    /// this distance of it, but for those on branches that cross there.
    double radius;
    gusset_contact_kind kind;
    uint32_t reserved;
} gusset_surface_contact;

/// How a surface is built.
typedef struct gusset_surface_options {
    size_t struct_size;
    /// A length, to which answers are proved, finite; 0: 1e-9 of the diagonal of the surface's box.
    double tolerance;
    /// 1: with the cones of normals that isophotes (GUSSET_CONTOUR_ANGLE) and gusset_surface_nearest_angle descend,
    /// about 0.7 bytes a node; 0: the first such question builds them.
    /// @flag
    uint32_t cones;
    uint32_t reserved;
} gusset_surface_options;

/// Curves on a surface: what sections, contours and intersections give. Opaque and immutable; it keeps nothing of the
/// surface.
typedef struct gusset_surface_paths gusset_surface_paths;

/// The curves. Pointers are valid until the handle is destroyed.
typedef struct gusset_surface_paths_view {
    size_t struct_size;
    /// How many curves.
    size_t path_count;
    /// How many points there are in all.
    size_t point_count;
    /// 0, then the end of each curve among the points: curve k has the points ends[k] to ends[k + 1] - 1.
    struct gusset_indices ends;
    /// By curve: 1 if it returns to its first point, which is not repeated. (Closed nodes and
    /// gusset_curve_through_create have it again at the end.)
    const uint32_t *closed;
    /// By curve: the number of the plane, level or angle that it belongs to; 0 if there was one.
    const uint32_t *levels;
    /// x, y, z of each point, on the surface.
    const double *points;
    /// The unit normals there, x, y, z of each; 0 where there is none.
    const double *normals;
    /// Where the points are on the surface.
    const struct gusset_surface_place *places;
    /// For intersections: where they are on the second; else NULL.
    const struct gusset_surface_place *others;
    /// Cells in which something may be that could not be resolved: tangency, coincidence, or pieces smaller than the
    /// tolerance.
    const struct gusset_surface_place *unresolved;
    /// How many.
    size_t unresolved_count;
    /// For intersections: points where they touch.
    const struct gusset_surface_contact *contacts;
    /// How many.
    size_t contact_count;
} gusset_surface_paths_view;

struct gusset_sheet;

/// Builds the index of one sheet or several, which together are one surface. The greatest absolute coordinate of each
/// is from 1e-30 to 1e37, or 0, control points included: boxes are in single precision.
/// @param sheets count handles, none NULL, the array at any alignment; they may be destroyed afterwards.
/// @param count see sheets.
/// @errors NULL_ARGUMENT (of a handle with its number, as GUSSET_ELEMENT_ITEM), EMPTY_MESH (without sheets),
///     OUT_OF_RANGE (with the sheet (as GUSSET_ELEMENT_ITEM) whose coordinates are too large or too small, for the
///     tolerance)
/// @complexity O(nodes), about 7 bytes a node, and 0.7 with cones; threads.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_create(const struct gusset_context *context,
    const struct gusset_sheet *const *sheets, size_t count, const struct gusset_surface_options *options,
    struct gusset_surface **surface);

/// Frees a surface; NULL is allowed. Results that were found with it stay.
GUSSET_API void gusset_surface_destroy(struct gusset_surface *surface);

/// The curves, lent until they are destroyed.
/// @param view struct_size set by the caller; all else is overwritten.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_paths_get_view(const struct gusset_surface_paths *paths,
    struct gusset_surface_paths_view *view);

/// Frees curves; NULL is allowed.
GUSSET_API void gusset_surface_paths_destroy(struct gusset_surface_paths *paths);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Cells: Pairs of near cells, and cells of a region. */

/// A cell of a surface.
typedef struct gusset_surface_cell {
    /// The sheet.
    uint32_t sheet;
    /// The row of the cell.
    uint32_t row;
    /// Its column.
    uint32_t column;
} gusset_surface_cell;

/// Cells of a surface, or pairs of cells of two surfaces. Opaque and immutable; it keeps nothing of the surfaces.
typedef struct gusset_surface_cells gusset_surface_cells;

/// The cells. Pointers are valid until the handle is destroyed.
typedef struct gusset_surface_cells_view {
    size_t struct_size;
    /// The cells, rising by sheet, row, column. For pairs: the cell of the first surface, by the sheets of both, then
    /// rising by row, column.
    const struct gusset_surface_cell *cells;
    /// How many cells or pairs.
    size_t cell_count;
    /// For pairs: the cell of the second surface; else NULL.
    const struct gusset_surface_cell *others;
    /// For a region, by cell: 1 if all of the cell is within the radius; else NULL.
    const uint32_t *whole;
    /// For a region: a bit for each cell of all sheets, 1 for those of the region; else NULL. The bit of cell (i, j) of
    /// sheet k, which has c columns, is b = first[k] + i * c + j: mask[b / 64] >> (b % 64) & 1.
    const uint64_t *mask;
    /// The number of words of the mask.
    size_t word_count;
    /// For a region, by sheet: its first bit; then the number of bits. Else NULL.
    const uint64_t *first;
    /// For a region: the number of sheets; else 0.
    size_t sheet_count;
} gusset_surface_cells_view;

/// Finds the cells that have a point within a radius of a query: the paper's region, with its logical scale.
/// @param query x, y, z, up to 1e150, at any alignment.
/// @param radius at least 0; INFINITY: all cells.
/// @param cells receives all cells that have such a point, and no others but such as come within the tolerance of the
///     radius or could not be decided in bounded work; for gusset_surface_cells_destroy; NULL on failure.
/// @errors NOT_FINITE, OUT_OF_RANGE (radius; a coordinate beyond 1e150)
/// @complexity O(cells found, and one bit a cell).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_region_create(const struct gusset_context *context,
    const struct gusset_surface *surface, const double *query, double radius, struct gusset_surface_cells **cells);

/// Finds the pairs of cells of two surfaces that may be as near to each other as `within`: all that are, and few
/// others.
/// @param within a length, finite; 0: cells that may meet.
/// @errors OUT_OF_RANGE (within), TOO_LARGE (above 2^26 pairs)
/// @complexity In proportion to the pairs, and some for each level of the indices; 24 bytes a pair.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_cell_pairs_create(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_surface *other, double within,
    struct gusset_surface_cells **cells);

/// Lends the cells until they are destroyed.
/// @param view struct_size set by the caller; all else is overwritten.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_cells_get_view(const struct gusset_surface_cells *cells,
    struct gusset_surface_cells_view *view);

/// Frees cells; NULL is allowed.
GUSSET_API void gusset_surface_cells_destroy(struct gusset_surface_cells *cells);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Sections: Sections by planes, contours, isophotes and silhouettes. */

/// The points of a curve between those where it crosses the lines of the surface.
typedef uint32_t gusset_spacing_rule;
/// As many points of the surface as keep the chords within 1e-4 of the diagonal of the surface's box.
#define GUSSET_POINT_SPACING_AUTO 0
/// As many points of the surface as keep the chords within `chord`, as the middle and the quarters of the curve beside
/// each show; where nodes are far apart for that length, it may be more elsewhere.
#define GUSSET_POINT_SPACING_CHORD 1
/// Nothing.
#define GUSSET_POINT_SPACING_CELL_EDGES 2
/// `points` points of the paper's approximation: on the cubic through four crossings. They are near the surface, not on
/// it, and have the place of the crossing before them. Order four where crossings are evenly spaced.
#define GUSSET_POINT_SPACING_LEUS 3

/// How curves of a surface are given.
typedef struct gusset_contour_options {
    size_t struct_size;
    /// With GUSSET_POINT_SPACING_CHORD: a length above 0 and finite; no smaller one counts than the tolerance of the
    /// surface. Otherwise not read.
    double chord;
    gusset_spacing_rule spacing;
    /// With GUSSET_POINT_SPACING_LEUS: how many, at most 1000. Otherwise not read.
    uint32_t points;
} gusset_contour_options;

/// The function on a surface whose contours are drawn.
typedef uint32_t gusset_contour_kind;
/// The distance from the plane through `point` across `direction`, negative below it. Its contours are sections of the
/// surface by parallel planes.
#define GUSSET_CONTOUR_HEIGHT 0
/// The values at the corners of the cells, interpolated as the surface is.
#define GUSSET_CONTOUR_VALUES 1
/// The angle between the normal and `direction`, in radians. Its contours are isophotes; at pi / 2 they are the
/// silhouettes of the surface seen along the direction.
#define GUSSET_CONTOUR_ANGLE 2

/// A function on a surface. Only the fields of its kind are read.
typedef struct gusset_contour_function {
    size_t struct_size;
    gusset_contour_kind kind;
    /// For GUSSET_CONTOUR_ANGLE. 1: a normal and its opposite are the same.
    uint32_t unsigned_normals;
    /// For GUSSET_CONTOUR_HEIGHT: x, y, z of a point where the height is 0.
    double point[3];
    /// For GUSSET_CONTOUR_HEIGHT and GUSSET_CONTOUR_ANGLE: x, y, z, of any length but 0.
    double direction[3];
    /// For GUSSET_CONTOUR_VALUES: finite numbers, at any alignment. Sheet follows sheet and row follows row; each sheet
    /// has one more row and one more column than cells. The last line of a closed direction repeats the first and is
    /// not read.
    const double *values;
    /// The number of values.
    size_t value_count;
} gusset_contour_function;

/// Where the angle of a normal is nearest to the one asked for.
typedef struct gusset_nearest_angle_report {
    size_t struct_size;
    /// Where it is.
    struct gusset_surface_place place;
    /// x, y, z.
    double point[3];
    /// The unit normal.
    double normal[3];
    /// Its angle with the direction, in radians.
    double angle;
    /// How far this is from the angle asked for; infinite if the surface has no normal anywhere, and all else is 0
    /// then.
    double deviation;
    /// No normal's angle is nearer than this: at most 1e-9 less than deviation, or more where that could not be proved.
    double bound;
} gusset_nearest_angle_report;

/// Draws the contours of a function on a surface: sections by planes, contours of values at nodes, or isophotes. The
/// curves come in the order of the levels and of their lowest cells. The function increases to the left of a curve,
/// seen from where the normals point to; angles decrease to the left. A section runs along the cross product of the
/// direction and the normal. Every curve is found, also one within a cell. On a closed surface all curves are closed.
/// Curves no larger than the tolerance are listed as unresolved. Sections: a corner on a plane counts as above it. So a
/// plane that touches the surface in corners of cells from below, by its direction, gives no curve there and nothing
/// unresolved. A plane that touches the surface from above gives closed curves round the contact, however narrow: along
/// a row of corners, a curve there and back. If a plane touches or contains the surface elsewhere, so that curves
/// cannot be told within rounding, the cells are listed as unresolved. Isophotes: at the angles 0 and pi there are
/// points in place of curves, each a path of one point. Where normals jump between cells (patches,
/// GUSSET_SCHEME_FOUR_POINT), curves run along the side between them. Poles that may have the angle are listed as
/// unresolved. Angles are of order three, as normals are; contours of the cosines at the nodes are of order four.
/// @param function the function; struct_size set by the caller.
/// @param levels count of them, rising, at any alignment: the values of the function on the curves. Angles are from 0
///     to pi, or to pi / 2 if normals are unsigned.
/// @param count see levels.
/// @errors OUT_OF_RANGE (numbers that are not finite, a direction of 0, levels that do not rise, angles, chord, points,
///     if there are too few values), TOO_LARGE (if there are too many), NOT_FINITE (with the number of the value)
/// @complexity About O(count + cells that are crossed); O(values) for values, and O(cells) once for angles, for the
///     cones of normals; threads.
/// @source Leus, "Carcasses on smooth surfaces", tasks b and d.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_contours_create(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_contour_function *function, const double *levels,
    size_t count, const struct gusset_contour_options *options, struct gusset_surface_paths **paths);

/// Finds the place whose normal makes the angle with a direction that is nearest to a given one, proved to 1e-9.
/// @param direction x, y, z, not 0, at any alignment.
/// @param angle in radians, 0 to pi, or to pi / 2 if normals are unsigned.
/// @param unsigned_normals 1: a normal and its opposite are the same; else 0.
/// @param report struct_size set by the caller; all else is overwritten.
/// @errors OUT_OF_RANGE
/// @complexity About O(cells that come near to the angle), and O(cells) once, for the cones of normals; threads.
/// @source Leus, task b.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_nearest_angle(const struct gusset_context *context,
    const struct gusset_surface *surface, const double *direction, double angle, uint32_t unsigned_normals,
    struct gusset_nearest_angle_report *report);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Sheets: Smooth patches through a grid of nodes. */

/// A piece of surface: rows and columns of cells, each a Bézier patch. Opaque and immutable: all functions may use it
/// from any thread, and many at the same time, each with a context of its own; it is destroyed when none uses it any
/// more.
typedef struct gusset_sheet gusset_sheet;

/// How the surface is drawn through nodes.
typedef uint32_t gusset_scheme;
/// Bicubic with continuous tangents, from the 6 x 6 nodes round a cell: fourth order, with the constant 1/384.
#define GUSSET_SCHEME_SIX_TAP 0
/// The paper's: the bicubic through the 4 x 4 nodes round a cell; fourth order with the constant 3/128, tangents jump
/// at nodes.
#define GUSSET_SCHEME_FOUR_POINT 1

/// How the mixed derivatives S_uv at nodes are found, which tangents leave open.
typedef uint32_t gusset_twists;
/// From differences of the tangents over five nodes: fourth order.
#define GUSSET_TWISTS_DIFFERENCES 0
/// Adini's: from the nodes next to each.
#define GUSSET_TWISTS_ADINI 1
/// None: flat spots at nodes.
#define GUSSET_TWISTS_ZERO 2
/// They are given.
#define GUSSET_TWISTS_GIVEN 3

/// Nodes of a surface: x, y, z of node (i, j) are at nodes + i * row_stride + j * column_stride bytes, one after the
/// other. Normals are those of u (from row to row) and then v: opposite to those of a net of the same nodes.
typedef struct gusset_nodes {
    size_t struct_size;
    /// The first node.
    const void *nodes;
    /// The number of rows, at least 2; of a surface closed in u at least 4, of which the last repeats the first.
    size_t rows;
    /// The number of columns, the same for v. rows * columns is at most 2^31 - 1.
    size_t columns;
    /// Bytes from row to row; 0 for rows without gaps.
    size_t row_stride;
    /// Bytes from node to node in a row; 0 for nodes without gaps.
    size_t column_stride;
    gusset_scalar scalar;
    gusset_scheme scheme;
    /// 1: closed in u, along columns: the last row is the first one again.
    uint32_t closed_u;
    /// 1: closed in v, along rows.
    uint32_t closed_v;
} gusset_nodes;

/// Tangents at the nodes of a surface, row after row, packed; the parameters are those of nodes: S_u is as long as the
/// step from row to row.
typedef struct gusset_tangents {
    size_t struct_size;
    /// S_u at each node: x, y, z; towards the next row.
    const double *u;
    /// S_v at each node: towards the next column.
    const double *v;
    /// For GUSSET_TWISTS_GIVEN: S_uv at each node; else not read.
    const double *twists;
    gusset_twists twist;
    uint32_t reserved;
} gusset_tangents;

/// Makes a surface through nodes: through a copy of them, through the caller's own memory, or the bicubic Hermite
/// surface with given tangents, which is C1. Borrowed nodes must stay valid and unchanged until the sheet and
/// everything made of it are destroyed. They are f64, aligned to 8 bytes, and their strides are multiples of 8.
/// @param nodes at any alignment, unless borrowed; finite. Repeated nodes and rows that are one point (poles) are
///     allowed. For a surface the greatest coordinate in absolute terms is from 1e-30 to 1e37, or 0; so it is for every
///     kind of sheet.
/// @param tangents NULL: the scheme of the nodes draws the surface. Else rows x columns vectors each, at any alignment,
///     and the scheme is not read. The vectors of the repeated line of a closed direction are not read as tangents, but
///     must be there.
/// @param borrow 1: the sheet reads the caller's memory; 0: it copies the nodes. With tangents the sheet keeps patches
///     in place of nodes, either way.
/// @errors MISALIGNED_ARGUMENT (the structs, sheet, borrowed nodes), NET_TOO_SMALL, TOO_LARGE, BAD_STRIDE (for borrowed
///     nodes that are f32 or have strides that are not multiples of 8), UNKNOWN_VALUE (also twist, reserved, borrow),
///     NOT_FINITE (with the node, of a node, a tangent or a twist), SIDES_DIFFER (if a closed direction does not end
///     where it begins, with the place of the largest gap)
/// @complexity O(nodes); 24 bytes a node, none if they are borrowed, and with tangents 384 bytes a cell.
/// @source Leus, "Carcasses on smooth surfaces"; the scheme of six taps is ours.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_create(const struct gusset_context *context,
    const struct gusset_nodes *nodes, const struct gusset_tangents *tangents, uint32_t borrow,
    struct gusset_sheet **sheet);

/// Frees a sheet; NULL is allowed. Results that were made of it keep what they need.
GUSSET_API void gusset_sheet_destroy(struct gusset_sheet *sheet);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Curves and surfaces: Curves through points, along surfaces, and near each other. */

/// The way in which a coordinate curve of a sheet runs.
typedef uint32_t gusset_sheet_direction;
/// Along rows: u stays and v runs.
#define GUSSET_ALONG_ROWS 0
/// Along columns: v stays and u runs.
#define GUSSET_ALONG_COLUMNS 1

/// Draws a curve through points as surfaces are drawn through their nodes: a cubic from each to the next, of fourth
/// order.
/// @param nodes x, y, z of count points, at any alignment, finite; at least 2, or if closed 4, of which the last is the
///     first one again: closed paths of a surface do not repeat it, and need it added.
/// @param count see nodes.
/// @param closed 0 or 1.
/// @errors MISALIGNED_ARGUMENT (curve), NET_TOO_SMALL (with too few points), NOT_FINITE (with the node),
///     CURVE_NOT_CLOSED, TOO_LARGE
/// @complexity O(count).
/// @source Leus, "Carcasses on smooth surfaces": points are the surface of a curve.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_through_create(const struct gusset_context *context,
    const double *nodes, size_t count, uint32_t closed, gusset_scheme scheme, struct gusset_curve **curve);

/// A coordinate curve of a sheet, exactly: a segment for each cell.
/// @param along along rows u is the parameter, along columns v is.
/// @param parameter 0 to the number of cells that way; whole numbers are lines of nodes.
/// @errors OUT_OF_RANGE (parameter)
/// @complexity O(cells along the curve).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_curve_create(const struct gusset_context *context,
    const struct gusset_sheet *sheet, gusset_sheet_direction along, double parameter, struct gusset_curve **curve);

struct gusset_line;

/// Finds the places where a curve meets a line, ray or segment in space, or comes as near to it as `within`. If within
/// is 0 and both lie in the plane z = 0, the places are crossings and touches. Otherwise they are the places where the
/// distance is least, each once. The others among the places have segment 0, and the line's own parameter as t.
/// @param line one, at any alignment.
/// @param within a length, 0 or more and finite; in space at least 1e-12 of the curve's size is taken.
/// @param places receives the result, for gusset_places_destroy; NULL on failure. Overlaps are parts that stay as near,
///     and parts where no place can be told from the next.
/// @errors EMPTY_CURVE, OUT_OF_RANGE (within; a line that is not finite or has no direction)
/// @complexity Bounded work for each segment whose box meets the line.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_intersect_line_create(const struct gusset_context *context,
    const struct gusset_curve *curve, const struct gusset_line *line, double within, struct gusset_places **places);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Lines: Intersections of lines, rays, segments and curves with a surface. */

/// A line, ray or segment: the points origin + t * direction for t from `from` to `to`.
typedef struct gusset_line {
    /// x, y, z of the point where t is 0; from -1e150 to 1e150.
    double origin[3];
    /// x, y, z of the direction; of a length whose square neither vanishes nor overflows, such as any from 1e-150 to
    /// 1e150. t counts lengths of it.
    double direction[3];
    /// The least t: -INFINITY for lines, 0 for rays and segments; not INFINITY.
    double from;
    /// The greatest t: INFINITY for lines and rays; not below `from`, and not -INFINITY.
    double to;
} gusset_line;

/// Which hits are wanted.
typedef uint32_t gusset_hit_selection;
/// All, in the order of the line.
#define GUSSET_HITS_ALL 0
/// The first one.
#define GUSSET_HITS_FIRST 1
/// Any one: whether there is one.
#define GUSSET_HITS_ANY 2

/// The kind of a hit.
typedef uint32_t gusset_hit_kind;
/// None.
#define GUSSET_HIT_NONE 0
/// It passes through the surface: proved, except at poles, where the surface is not regular.
#define GUSSET_HIT_CROSSING 1
/// It touches the surface within the tolerance: one point, two close to each other, or none.
#define GUSSET_HIT_TOUCH 2
/// It runs in the surface, within the tolerance, all over the span.
#define GUSSET_HIT_INSIDE 3

/// A point that a line or a curve and a surface have in common.
typedef struct gusset_surface_hit {
    /// Where on the line; of a curve the number of the segment and the parameter on it, added.
    double t;
    /// From where to where it cannot be told from the surface, within the tolerance; t twice at crossings.
    double span[2];
    /// Where on the surface.
    struct gusset_surface_place place;
    /// x, y, z of the point of the surface.
    double point[3];
    /// x, y, z of the unit normal there, its limit at a pole, or 0 if there is none.
    double normal[3];
    gusset_hit_kind kind;
    uint32_t reserved;
} gusset_surface_hit;

/// Where lines and a curve meet a surface. Opaque and immutable; it keeps nothing of the surface.
typedef struct gusset_surface_hits gusset_surface_hits;

/// The hits. Pointers are valid until the handle is destroyed.
typedef struct gusset_surface_hits_view {
    size_t struct_size;
    /// How many were asked about: the lines, and after them the curve, if there is one.
    size_t query_count;
    /// How many hits there are in all.
    size_t hit_count;
    /// 0, then the end of each query's hits among all: query k has the hits from ends[k] until ends[k + 1]. query_count
    /// + 1 numbers.
    const uint64_t *ends;
    /// The hits, query after query, each by rising t.
    const struct gusset_surface_hit *hits;
    /// For each hit of the curve three places on the curve: the hit, and where its span begins and ends. NULL without a
    /// curve.
    const struct gusset_place *on_curve;
    /// The number of places on the curve.
    size_t on_curve_count;
} gusset_surface_hits_view;

/// Finds where lines, rays, segments and a curve in space meet a surface; for each line what a call with it alone
/// gives. A point on a side between cells, on one that sheets share, at a joint of the curve's segments, or at a pole
/// is found once, and none is missed: where a line or the curve touches the surface or runs in it, a hit says from
/// where to where.
/// @param lines count of them, at any alignment; NULL for none.
/// @param count see lines.
/// @param curve of degree 7 at most; NULL for none. Its hits follow the hits of the lines, in the order of the curve.
/// @errors OUT_OF_RANGE (with the line that is not finite, has no direction, ends before it begins, for a degree),
///     EMPTY_CURVE
/// @complexity About O(log cells) a line and O(1) a hit; bounded in each cell that a line runs in. About O(log cells)
///     for each cell that the curve comes near to; bounded for each segment and cell that run in each other. Threads.
/// @source Leus, "Carcasses on smooth surfaces", task c.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_hits_create(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_line *lines, size_t count,
    const struct gusset_curve *curve, gusset_hit_selection selection, struct gusset_surface_hits **hits);

/// Finds the first hit of each of many lines, rays or segments: the hit of least t, which gusset_surface_hits_create
/// gives first.
/// @param lines count of them, at any alignment.
/// @param count see lines.
/// @param hits receives count results, one a line; kind is GUSSET_HIT_NONE, and all else 0, where there is none, and
///     everywhere on failure.
/// @errors as gusset_surface_hits_create, MISALIGNED_ARGUMENT (hits)
/// @complexity About O(log cells) a line; threads.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_first_hits(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_line *lines, size_t count,
    struct gusset_surface_hit *hits);

/// The hits, lent until they are destroyed.
/// @param view struct_size set by the caller; all else is overwritten.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_hits_get_view(const struct gusset_surface_hits *hits,
    struct gusset_surface_hits_view *view);

/// Frees hits; NULL is allowed.
GUSSET_API void gusset_surface_hits_destroy(struct gusset_surface_hits *hits);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Distances: Nearest points of a surface and a line, a plane, a curve or another surface. */

/// The object from which a distance is measured.
typedef uint32_t gusset_target_kind;
/// The line, ray or segment `line`.
#define GUSSET_TARGET_LINE 0
/// The plane through `point` across `normal`.
#define GUSSET_TARGET_PLANE 1
/// The curve in space `curve`.
#define GUSSET_TARGET_CURVE 2
/// The surface `surface`.
#define GUSSET_TARGET_SURFACE 3

/// An object in space. The function reads only the fields of its kind.
typedef struct gusset_target {
    size_t struct_size;
    gusset_target_kind kind;
    uint32_t reserved;
    /// For GUSSET_TARGET_LINE.
    struct gusset_line line;
    /// For GUSSET_TARGET_PLANE: x, y, z of a point of the plane, from -1e150 to 1e150.
    double point[3];
    /// For GUSSET_TARGET_PLANE: x, y, z across the plane, of any length but 0.
    double normal[3];
    /// For GUSSET_TARGET_CURVE: a curve of any degrees; coordinates from -1e150 to 1e150.
    const struct gusset_curve *curve;
    /// For GUSSET_TARGET_SURFACE.
    const struct gusset_surface *surface;
} gusset_target;

/// Bits of gusset_distance_report.
/// @bits
typedef uint32_t gusset_distance_flags;
/// The distance is proved: bound is within the tolerance of it, or within 2^-45 of the greatest coordinate. Not set:
/// the proof would take too long, as where much of the surface is equally near. `bound` is right nevertheless.
#define GUSSET_DISTANCE_PROVEN 1
/// The two meet at the points, except for rounding, and the distance is 0.
#define GUSSET_DISTANCE_MEETS 2

/// The nearest points of a surface and a target.
typedef struct gusset_distance_report {
    size_t struct_size;
    /// Where the nearest point of the surface is.
    struct gusset_surface_place place;
    /// x, y, z of it.
    double point[3];
    /// The unit normal there, or its limit at a pole; 0 where there is none.
    double normal[3];
    /// x, y, z of the nearest point of the target.
    double other_point[3];
    /// Their distance.
    double distance;
    /// No points of the two are nearer to each other than this.
    double bound;
    /// For a surface: where its nearest point is; else 0.
    struct gusset_surface_place other_place;
    /// For a curve: where its nearest point is; else 0.
    struct gusset_place curve_place;
    /// For a line: its parameter at the nearest point. For a plane: the distance, negative if the surface's point is
    /// not on the side that the normal points to. Else 0.
    double parameter;
    gusset_distance_flags flags;
    uint32_t reserved;
} gusset_distance_report;

/// Finds the nearest points of a surface and a line, a plane, a curve or another surface. If several pairs of points
/// are equally near, the result is always the same pair. Where much of the surface is equally near, as a tube is to its
/// axis, the search ends without a proof and says so. Where a plane meets the surface, the result is a point of the
/// section.
/// @param target the object; struct_size set by the caller.
/// @param tolerance a length, to which the distance is proved, finite; 0: the tolerance of the surface, or the greater
///     one of two surfaces.
/// @param report struct_size set by the caller; all else is overwritten.
/// @errors UNKNOWN_VALUE (kind, reserved), OUT_OF_RANGE (for a line that is not finite, has no direction or ends before
///     it begins, for a plane that is not finite, too large or without a direction, for a curve that is too large, for
///     the tolerance), EMPTY_CURVE
/// @complexity About O(log cells), and at most 50,000 pairs of pieces.
/// @source Ours; Leus, "Carcasses on smooth surfaces", tasks c to e, where there is no intersection.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_distance(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_target *target, double tolerance,
    struct gusset_distance_report *report);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Points: Points, normals and curvatures at places of a surface. */

/// The kind of a normal.
typedef uint32_t gusset_normal_kind;
/// There is no normal: the tangents are 0, or parallel all along the lines to the point.
#define GUSSET_NORMAL_NONE 0
/// The normal of the plane that the tangents span.
#define GUSSET_NORMAL_REGULAR 1
/// The limit along the coordinate line, where the tangents do not span a plane: at poles.
#define GUSSET_NORMAL_LIMIT 2

/// A point of a surface, with derivatives, normal and curvatures. Derivatives are by the parameters within the cell.
typedef struct gusset_surface_point {
    /// The point.
    double point[3];
    /// S_u.
    double u[3];
    /// S_v.
    double v[3];
    /// S_uu.
    double uu[3];
    /// S_uv.
    double uv[3];
    /// S_vv.
    double vv[3];
    /// The unit normal, to the side of S_u x S_v; 0 if there is none.
    double normal[3];
    /// For limits: the largest angle, in radians, to limits along other lines to the same point. Small at the pole of a
    /// smooth surface, large at the tip of a cone, which has no normal.
    double spread;
    /// The principal curvatures, the greater first: positive where the surface bends towards the normal.
    double principal[2];
    /// Their directions: two unit tangents, x, y, z each.
    double directions[6];
    /// The mean curvature.
    double mean;
    /// The Gaussian curvature.
    double gaussian;
    gusset_normal_kind normal_kind;
    /// 1: there are curvatures; 0: they are 0, as the surface is not regular there.
    uint32_t is_curved;
} gusset_surface_point;

/// Points, derivatives, normals and curvatures at places.
/// @param places count of them, at any alignment.
/// @param count see places.
/// @param results room for count; all 0 on failure.
/// @errors UNKNOWN_VALUE (reserved), NO_SUCH_ELEMENT (with the first place that the surface does not have: no such
///     sheet or cell, parameters that are not 0 to 1)
/// @complexity O(1) a place, at a pole O(cells round it); threads.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_evaluate(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_surface_place *places, size_t count,
    struct gusset_surface_point *results);

/// The places of parameters of a whole sheet: node (i, j) has u = i and v = j. Closed directions are counted round;
/// what is beyond an open side is on it. The other way the parameters of a place are row + u and column + v.
/// @param sheet its number, counted from 0.
/// @param parameters u, v of each, packed, at any alignment.
/// @param count see places.
/// @param places room for count; all 0 on failure.
/// @errors NO_SUCH_ELEMENT (with the first pair that is not finite, if there is no such sheet)
/// @complexity O(1) each.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_locate(const struct gusset_context *context,
    const struct gusset_surface *surface, uint32_t sheet, const double *parameters, size_t count,
    struct gusset_surface_place *places);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Nearest points: Nearest points, local minima of the distance, regions of cells. */

/// Bits of gusset_surface_nearest_point.
/// @bits
typedef uint32_t gusset_nearest_flags;
/// There is a point; else nothing is within the limit, all numbers are 0 and the distance is infinite.
#define GUSSET_NEAREST_FOUND 1
/// The distance is proved: bound is within the tolerance of it, or within the rounding of coordinates. Not set: the
/// proof would take too long, as it may next to a centre of curvature. `bound` is right nevertheless.
#define GUSSET_NEAREST_PROVEN 2
/// Another point, farther from this one than a hundredth of the distance, is as near within the tolerance.
#define GUSSET_NEAREST_AMBIGUOUS 4

/// A point of a surface that was found for a query.
typedef struct gusset_surface_nearest_point {
    /// Where it is on the surface.
    struct gusset_surface_place place;
    /// x, y, z.
    double point[3];
    /// The unit normal there, or its limit at a pole; 0 where there is none. The query is on its side if (query -
    /// point) . normal > 0.
    double normal[3];
    /// The distance from the query.
    double distance;
    /// No point of the surface is nearer than this; of minima: none of the piece of surface round the point.
    double bound;
    gusset_nearest_flags flags;
    uint32_t reserved;
} gusset_surface_nearest_point;

/// The points that are looked for.
typedef struct gusset_nearest_options {
    size_t struct_size;
    /// No point farther than this is looked for; a length, at least 0; 0 or INFINITY: no limit.
    double limit;
    /// For minima: the number of the nearest that are wanted; 0: all.
    size_t max_count;
} gusset_nearest_options;

/// Points of a surface. Opaque and immutable; it keeps nothing of the surface.
typedef struct gusset_surface_points gusset_surface_points;

/// The points that were found. Pointers are valid until the handle is destroyed.
typedef struct gusset_surface_points_view {
    size_t struct_size;
    /// The points, the nearest first.
    const struct gusset_surface_nearest_point *points;
    /// How many.
    size_t count;
    /// None is missing that is nearer than this.
    double bound;
    /// 1, or 0 if the search gave up at that distance, as it may where the distance is the same all over the surface.
    uint32_t complete;
    uint32_t reserved;
} gusset_surface_points_view;

/// The nearest points of a surface to queries, one or many. Each answer is the same to the bit whether it is asked for
/// alone or among others, in any order, on any number of threads; of several nearest points it is that of the first
/// sheet, row and column. Proofs are relative to the surface as declared: no point of it is nearer than bound.
/// @param queries x, y, z of each, packed, at any alignment.
/// @param count see queries.
/// @param options NULL for the defaults: no limit.
/// @param points room for count answers, in the order of the queries; none is found on failure: no flags, and infinite
///     distances.
/// @errors TOO_LARGE, NOT_FINITE (with the query), OUT_OF_RANGE (limit; a query with a coordinate beyond 1e150)
/// @complexity O(log nodes) a query but for queries near centres of curvature, which take bounded work; threads.
/// @source Leus, "Carcasses on smooth surfaces", task a, by branch and bound.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_nearest(const struct gusset_context *context,
    const struct gusset_surface *surface, const double *queries, size_t count,
    const struct gusset_nearest_options *options, struct gusset_surface_nearest_point *points);

/// The places where the distance from a query is locally least: all, those within a limit, or the nearest ones. None is
/// missed: where it cannot be proved whether there is one (the distance is the same all round, as at a focus), one
/// point is given for all cells that touch, without GUSSET_NEAREST_PROVEN and with GUSSET_NEAREST_AMBIGUOUS. On open
/// borders and creases, places count from which no way on the surface leads nearer.
/// @param query x, y, z, up to 1e150, at any alignment.
/// @param options NULL for the defaults: all.
/// @param points receives the result, the nearest first, for gusset_surface_points_destroy; NULL on failure.
/// @errors NOT_FINITE, OUT_OF_RANGE (limit; a coordinate beyond 1e150)
/// @complexity O(cells within the limit); with max_count, those no farther than the last.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_minima_create(const struct gusset_context *context,
    const struct gusset_surface *surface, const double *query, const struct gusset_nearest_options *options,
    struct gusset_surface_points **points);

/// The points, lent until they are destroyed.
/// @param view struct_size set by the caller; all else is overwritten.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_points_get_view(const struct gusset_surface_points *points,
    struct gusset_surface_points_view *view);

/// Frees points; NULL is allowed.
GUSSET_API void gusset_surface_points_destroy(struct gusset_surface_points *points);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Reports on surfaces: Facts about a surface and its sheets. */

/// Facts about a surface.
typedef struct gusset_surface_report {
    size_t struct_size;
    /// How many sheets.
    size_t sheet_count;
    /// How many cells, of all sheets.
    size_t cell_count;
    /// How many corners of cells: of sheets from nodes, the nodes.
    size_t node_count;
    /// Bytes of the index without the cones of normals; the nodes are not counted.
    size_t index_bytes;
    /// The length to which answers are proved.
    double tolerance;
    /// A corner of a box round the surface and the control nets of its cells, which may be larger than the surface: the
    /// least x, y, z.
    double low[3];
    /// The greatest.
    double high[3];
    /// Bytes of the cones of normals; 0 as long as there are none: see gusset_surface_options.
    size_t cone_bytes;
    /// The sheets, sheet_count of them, valid as long as the surface.
    const struct gusset_surface_sheet *sheets;
} gusset_surface_report;

/// Reports on a surface and its sheets.
/// @param report struct_size set by the caller; all else is overwritten.
/// @complexity O(sheets).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_get_report(const struct gusset_surface *surface,
    struct gusset_surface_report *report);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Other sheets: Sheets from tangents, nets of curves, frames, patches and B-splines, including rational ones */
/* (NURBS). */

/// The surface that is made of a frame.
typedef uint32_t gusset_frame_surface;
/// The surface through the nodes of a frame; the surface of its curves if some of them have corners, which would be
/// rounded.
#define GUSSET_FRAME_NODES 0
/// Gordon's surface of the curves of a frame, which contains them.
#define GUSSET_FRAME_CURVES 1

/// A tensor-product B-spline, rational (NURBS) if it has weights that differ. Knots of an open direction: as many as
/// control points and the degree and 1, not decreasing, finite, clamped or not; the surface is defined between knot
/// degree and knot count. Of a closed one: one more than control points, one period; the control points are not
/// repeated, and span k, from knot k to the next, is made by the control points k - degree to k, counted round. Inner
/// knots may be repeated degree times. The control points of a rational spline are points of space (Euclidean), not
/// multiplied by their weights. A Bézier patch is the spline whose knots are 0 and 1, degree + 1 times each; patches
/// that share sides and their weights are one spline with inner knots repeated degree times.
typedef struct gusset_spline {
    size_t struct_size;
    /// x, y, z of the control points, row after row, packed: rows follow each other in u.
    const double *points;
    /// The number of rows of control points, more than degree_u.
    size_t count_u;
    /// The number of control points in a row, more than degree_v.
    size_t count_v;
    /// The knots of u.
    const double *knots_u;
    /// How many.
    size_t knot_count_u;
    /// The knots of v.
    const double *knots_v;
    /// How many.
    size_t knot_count_v;
    /// The degree in u, 1 to 7.
    uint32_t degree_u;
    /// The degree in v, 1 to 7.
    uint32_t degree_v;
    /// 1: closed in u.
    uint32_t closed_u;
    /// 1: closed in v.
    uint32_t closed_v;
    /// The weights of the control points, in their order, finite and above 0, none less than 2^-900 of the greatest; a
    /// factor common to all changes nothing. NULL: all are 1.
    const double *weights;
    /// How far the sheet may be from a rational spline at equal parameters, a length; no less than rounding allows,
    /// some 1e-13 of the size. 0: 1e-12 of the diagonal of the control points' box, or more where rounding asks for it,
    /// far from the origin.
    double tolerance;
    /// The most cells that a rational spline may take; 0: 2^20.
    size_t max_cells;
} gusset_spline;

/// A net of curves: each row meets each column, in the order in which they are given; curves may run either way.
typedef struct gusset_curve_net {
    size_t struct_size;
    /// Curves in v, which follow each other in u. Segments of degree 7 at most; a curve that is one point is a pole.
    const struct gusset_curve *const *rows;
    /// How many: 0, or at least 2, or 3 if closed_u.
    size_t row_count;
    /// Curves in u, which follow each other in v.
    const struct gusset_curve *const *columns;
    /// How many: 0, or at least 2, or 3 if closed_v. Without columns, or without rows, the surface is the skin of the
    /// others.
    size_t column_count;
    /// How far apart curves may be where they meet, a length, finite; both are moved to the middle. 0: 1e-6 of the
    /// diagonal of their box.
    double tolerance;
    /// 1: the columns are closed curves, and the last row is followed by the first.
    uint32_t closed_u;
    /// 1: the rows are closed curves, and the last column is followed by the first.
    uint32_t closed_v;
} gusset_curve_net;

/// Makes a surface of Bézier patches in rows and columns, neighbours of which should share their sides. Repeated points
/// and sides that are one point are allowed.
/// @param points x, y, z of the control points, packed, at any alignment: patch after patch, row after row of patches;
///     in each patch degree_v + 1 points follow each other in v, degree_u + 1 times.
/// @param degree_u 1 to 7.
/// @param degree_v 1 to 7.
/// @param rows of patches, at least 1.
/// @param columns of patches, at least 1.
/// @errors MISALIGNED_ARGUMENT (sheet), OUT_OF_RANGE (degree), EMPTY_MESH (without patches), TOO_LARGE, NOT_FINITE
///     (with the control point (as a node))
/// @complexity O(points); 384 bytes a patch up to degree 3, else 1536.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_from_patches_create(const struct gusset_context *context,
    const double *points, uint32_t degree_u, uint32_t degree_v, size_t rows, size_t columns,
    struct gusset_sheet **sheet);

/// Makes the surface of a B-spline, cut into its Bézier patches, which is exact but for rounding: cells are its spans
/// that are not empty, so that knots become the whole numbers of rows and columns. If weights differ, spans are cut
/// further, whole rows and columns at a time, and the patch of each cell is the polynomial of degree 7 with the values
/// and the first derivatives of the rational surface at corners, and its values at points between. It is proven, not
/// sampled, that the sheet is within the tolerance of the rational surface at equal parameters: gusset_sheet_get_report
/// has the bound, rounding included, and the knots of rows and columns, between which parameters run evenly. Tangents
/// go on over sides where those of the rational surface do. Sides that are one point, as the poles of spheres, stay so
/// to the bit.
/// @param spline its arrays are at any alignment.
/// @errors OUT_OF_RANGE (degree; tolerance; a weight, with its control point as a node), NET_TOO_SMALL (too few control
///     points), BAD_KNOTS (with the first knot that is not finite, out of order or repeated too often, that begins a
///     span too short to be cut where that is needed), TOO_LARGE (control points, cells), NOT_FINITE (with the control
///     point (as a node))
/// @complexity O(spans x degree^3); 384 bytes a span up to degree 3, else 1536. Of rational splines O(cells x
///     degree^2), threads; 1536 bytes a cell, three times that while it is made.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_from_spline_create(const struct gusset_context *context,
    const struct gusset_spline *spline, struct gusset_sheet **sheet);

/// Makes Gordon's surface of a net of curves, which contains all of them; with two rows and two columns it is Coons's
/// patch. Nodes are where each row and each column are nearest. Between two nodes rows of equally many segments are
/// matched segment by segment; else all of them are cut where any one has a joint: there may be more cells than meshes
/// of the net. The surface is C1 where the curves are C1 in common knots and have no joints between nodes, else nearly
/// (gusset_sheet_measure tells). Polylines, segments of degree 1, are kept with their creases; for a smooth surface
/// draw curves through their points first, with gusset_outline_create.
/// @param net the curves may be destroyed afterwards; the arrays of handles are at any alignment.
/// @errors NULL_ARGUMENT (with the item), NET_TOO_SMALL, EMPTY_CURVE, OUT_OF_RANGE (degree, tolerance),
///     CURVE_NOT_CLOSED, CURVES_APART (with the row and the distance (the message has the column too), if they meet out
///     of order), TOO_LARGE
/// @complexity O(rows x columns x log segments) to find nodes, then O(cells); 384 bytes a cell up to degree 3, else
///     1536.
/// @source Gordon (1969).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_from_curves_create(const struct gusset_context *context,
    const struct gusset_curve_net *net, struct gusset_sheet **sheet);

/// Makes the surface beside a sheet: through the corners of its cells, each moved along the normal, the derivative in u
/// crossed with that in v. Normals at the nodes of a grid are those of circles through neighbouring nodes, exact on
/// planes, spheres, and round cylinders whose rulings and sections are lines of the grid; those of patches are their
/// own. Places without a normal stay. The result is a grid, smooth between its nodes where a sheet of patches had
/// creases.
/// @param sheet may be destroyed afterwards.
/// @param distances in the unit of the nodes, finite, of either sign.
/// @param distance_count 1: all corners move by the same; the number of lines of corners along v, rows + 1 for rows of
///     cells: each line by its own; (rows + 1) x (columns + 1): each corner by its own, row by row. A line that closes
///     the sheet counts, and moves with the first one.
/// @param deviation receives how far the result is, at most in the middles of the cells, from the place of this sheet
///     there, moved along its normal by the mean distance of the corners; NULL if it is not wanted.
/// @errors COUNT_DIFFERS (distances), NOT_FINITE (the index is the distance's or the corner's)
/// @complexity O(cells).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_offset_create(const struct gusset_context *context,
    const struct gusset_sheet *sheet, const double *distances, size_t distance_count, double *deviation,
    struct gusset_sheet **offset);

/// Makes the surface of a frame: u runs along the body, v round it, closed as the frame is.
/// @param frame may be destroyed afterwards.
/// @errors NET_TOO_SMALL (of curves OUT_OF_RANGE (a degree above 7)), CURVES_APART (if nodes repeat or are out of order
///     along a curve), NOT_FINITE
/// @complexity O(nodes).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_from_frame_create(const struct gusset_context *context,
    const struct gusset_frame *frame, gusset_frame_surface kind, struct gusset_sheet **sheet);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Meshes of sheets: Meshes of points of a sheet. */

/// How a sheet becomes a mesh. All zeros: quads, one a cell.
typedef struct gusset_sheet_mesh_options {
    size_t struct_size;
    /// How far triangles may be from the surface, a length more than 0; 0, or INFINITY: no demand.
    double tolerance;
    /// The fewest parts of each cell in u; 0 stands for 1.
    uint32_t min_u;
    /// The fewest parts of each cell in v; 0 stands for 1.
    uint32_t min_v;
    /// 1: triangles only; 0: quads, and triangles at poles.
    /// @flag
    uint32_t triangles;
    uint32_t reserved;
} gusset_sheet_mesh_options;

/// What belongs to the mesh of a sheet. Pointers are valid until the result is destroyed.
typedef struct gusset_sheet_mesh_report {
    size_t struct_size;
    /// The number of vertices.
    size_t vertex_count;
    /// For each vertex its place; the sheet is 0.
    const struct gusset_surface_place *places;
    /// For each vertex the unit normal: x, y, z; 0 where there is none.
    const double *normals;
    /// A bound of the distance between the surface and the triangles, or either pair of triangles of quads.
    double deviation;
} gusset_sheet_mesh_report;

/// Makes a mesh of points of a sheet. Cells of a row have equally many parts in u, those of a column in v, so that
/// neighbours fit; seams of closed directions and poles are closed. Faces are counter-clockwise seen from where S_u x
/// S_v points to. A mesh without faces is no failure.
/// @errors OUT_OF_RANGE (tolerance), TOO_LARGE (2^32 - 1 corners and more)
/// @complexity O(cells + vertices).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_to_mesh(const struct gusset_context *context,
    const struct gusset_sheet *sheet, const struct gusset_sheet_mesh_options *options, struct gusset_result **result);

/// Lends places and normals of the vertices, for results of gusset_sheet_to_mesh.
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_sheet_mesh(const struct gusset_result *result,
    struct gusset_sheet_mesh_report *report);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Reports on sheets: Sizes, estimates and bounds. */

/// Facts about a sheet.
typedef struct gusset_sheet_report {
    size_t struct_size;
    /// Cells in u: u runs from 0 to this.
    size_t rows;
    /// Cells in v.
    size_t columns;
    /// The degree of the patches in both directions as they are kept: 3 or 7.
    uint32_t degree;
    /// 1: the nodes are kept and patches are made when they are needed; 0: the patches are kept.
    uint32_t is_grid;
    /// 1: closed in u.
    uint32_t closed_u;
    /// 1: closed in v.
    uint32_t closed_v;
    /// 1: the side u = 0 is one point, a pole.
    uint32_t pole_u0;
    /// 1: the side u = rows is.
    uint32_t pole_u1;
    /// 1: the side v = 0 is.
    uint32_t pole_v0;
    /// 1: the side v = columns is.
    uint32_t pole_v1;
    /// For a rational spline, a bound of how far the sheet is from it at equal parameters, rounding included; 0 of any
    /// other sheet.
    double deviation;
    /// For a spline, the knots of rows: rows + 1 parameters that rise, between which the spline's parameter runs
    /// evenly; NULL of any other sheet. Valid as long as the sheet.
    const double *knots_u;
    /// The knots of columns: columns + 1.
    const double *knots_v;
} gusset_sheet_report;

/// Reports what a sheet is.
/// @param report struct_size set by the caller; all else is overwritten.
/// @complexity O(cells at the sides).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_get_report(const struct gusset_sheet *sheet,
    struct gusset_sheet_report *report);

/// The numbers of a whole sheet that are wanted.
/// @bits
typedef uint32_t gusset_sheet_measure_flags;
/// `diameter` and `intrinsic_diameter`.
#define GUSSET_SHEET_MEASURE_DIAMETERS 1
/// `curvature_bound`.
#define GUSSET_SHEET_MEASURE_CURVATURE 2
/// `crease`.
#define GUSSET_SHEET_MEASURE_CREASE 4

/// Numbers of a whole sheet; 0 if they were not asked for.
typedef struct gusset_sheet_measures {
    size_t struct_size;
    /// The greatest of the diameters of cells, the paper's d: a bound of the distance between any two points of a cell.
    double diameter;
    /// The greatest of the intrinsic diameters of cells.
    double intrinsic_diameter;
    /// A bound of the principal curvatures in absolute terms, from control nets: the paper's K. Infinite where the
    /// surface is not regular, as at poles.
    double curvature_bound;
    /// The largest angle between the normals on both sides of borders between cells, in radians: 0, or rounding, where
    /// the surface is smooth.
    double crease;
} gusset_sheet_measures;

/// Arrays that receive a number for each cell, row after row: number i * columns + j belongs to cell (i, j). NULL: the
/// number is not computed.
typedef struct gusset_cell_arrays {
    size_t struct_size;
    /// How many numbers each array has room for, at least the cells of the sheet.
    size_t capacity;
    /// Bounds of the distance between any two points of the cell, from its control net.
    double *diameters;
    /// Bounds of the length of the shortest curve within the cell between any two of its points.
    double *intrinsic_diameters;
    /// Estimates of how far a surface through nodes is from the smooth one that they were taken from, at equal
    /// parameters: C h^4 times the fourth derivatives, from differences of nodes. No bound; infinite for fewer than 5
    /// nodes in a direction; 0 if the patches were given.
    double *errors;
    /// Bounds of how far the surface is from the bilinear patch through the cell's corners.
    double *bilinear;
    /// Bounds of how far the surface is from the two triangles that either diagonal makes.
    double *triangles;
} gusset_cell_arrays;

/// Measures a sheet and its cells: diameters, estimates and bounds of their error, curvature, creases. Computes only
/// the numbers that are asked for.
/// @param parts added: what measures receives; 0: everything.
/// @param cells arrays of the caller that receive numbers by cell; NULL for none. Nothing is written to them on
///     failure.
/// @param measures struct_size set by the caller; all else is overwritten; NULL if only cells are wanted.
/// @errors UNKNOWN_VALUE (parts), BUFFER_TOO_SMALL (the value is the number of cells)
/// @complexity O(cells), 16 bytes a cell for each of diameters, errors and distances; threads; the same bits for any
///     number of them.
/// @source Leus, eqs. (1) and (7); the bounds are ours.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_measure(const struct gusset_context *context,
    const struct gusset_sheet *sheet, gusset_sheet_measure_flags parts, const struct gusset_cell_arrays *cells,
    struct gusset_sheet_measures *measures);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Intersections of surfaces: Curves in which two surfaces meet, or one meets itself. */

/// How intersections are wanted.
typedef struct gusset_intersection_options {
    size_t struct_size;
    /// With GUSSET_POINT_SPACING_CHORD: a length above 0 and finite, the greatest distance of the curve from the chords
    /// between its points, as their tangents and middles show it. (1.14 times as much was seen at one chord in 10,000.)
    /// A chord that is smaller than `tolerance` and than the surfaces' own tolerances counts as the smaller one of
    /// these. Otherwise not read.
    double chord;
    /// A length, finite: surfaces that are apart, or overlap, by no more than that all over touch there. 0: the smaller
    /// one of the tolerances of the two surfaces. Branches are found and told apart by that one, or by `tolerance` if
    /// it is smaller: shorter ones may be lost. A surface's intersections with itself take a greater one for the
    /// surface's own.
    double tolerance;
    /// All but GUSSET_POINT_SPACING_LEUS; for GUSSET_POINT_SPACING_AUTO the smaller surface's box counts.
    gusset_spacing_rule spacing;
    uint32_t reserved;
} gusset_intersection_options;

/// Finds the curves in which two surfaces meet, or in which a surface meets itself, with the places of their points on
/// both. Curves run along N x N', where N is the normal at `places` and N' the normal at `others`. Closed ones are
/// marked so. Points and normals are those of the first surface; the points at `others` are the same but for rounding,
/// and at crossings to the tolerance. Each curve is given once. Two surfaces: every branch is found, relative to the
/// surfaces as declared, that is longer than the tolerance, or the surfaces' own if that is smaller, or, next to a
/// pole, than four times that; farther than four times that from others; and not part of a contact or of a cell that is
/// listed as unresolved. A path that is not closed ends at the border of a sheet, or in such a cell. A point where the
/// surfaces touch, or where two branches cross, is a contact if it is proved to be alone: near it both are graphs over
/// a plane, and the second derivatives of their difference are a definite form (GUSSET_CONTACT_POINT) or an indefinite
/// one (GUSSET_CONTACT_CROSSING), and the gap is within the tolerance; if it is larger, there is a loop, or nothing, or
/// two branches that pass each other. All within a contact's radius, at most some four times the root of twice the
/// tolerance over the least curvature of that difference, is left out: loops, and how branches run that come nearer to
/// each other than that; a path goes straight to the contact's point from where it comes to it. A path that comes to a
/// crossing turns there, as N x N' points to it and away from it in turn, and goes back the way that closes it if there
/// is one: a figure of eight is two closed paths that have one point in common. Cells of the first surface where the
/// surfaces touch in another way (along a curve, at a pole, at a border, to a higher order) or coincide are listed as
/// unresolved, and curves may end there, or be in parts or missing within such cells. So are cells that take more work
/// than the limit, as where two branches run beside each other at 1e-4 of a cell and not along its sides, or one runs
/// nearly along the sides of cells of both surfaces, as where coaxial surfaces of revolution meet. Curves are joined
/// across such a place where a chord is as near to both surfaces as elsewhere. A surface with itself: along a closed
/// curve the two pieces may change places, as on a Klein bottle. The curve then ends where it begins in space, with
/// `places` and `others` exchanged. Where a sheet is turned over at a seam, as a Möbius band is, the direction turns
/// too. Cells of a sheet with a side or a corner in common, across a seam too, opposite borders of a sheet whose
/// control points are the same to 64 units of rounding of the largest coordinate, in either order, and cells round a
/// pole are joined: what they have in common so is no intersection, and that they have nothing else is proved, or they
/// are divided. Every branch longer than the tolerance is found, but for cells that are listed as unresolved: where
/// tangents are dependent, as where a curve ends in a pinch (Whitney's umbrella), at creases and singular poles, and
/// where pieces touch or coincide. A curve that ends in a pinch ends where its pieces are as near to each other as the
/// tolerance, some tens of tolerances from the pinch where the surface is rough; the unresolved place is there. A curve
/// that runs along sides of cells all its way may come in many parts. No contacts are looked for. A common part of
/// borders of different sheets is an intersection.
/// @param other the other surface; NULL: the surface with itself. For the handle of the surface everything is reported
///     as coincident.
/// @param options NULL for the defaults. For one surface they are those of two with it twice.
/// @errors UNKNOWN_VALUE (spacing, reserved), OUT_OF_RANGE (chord, tolerance), TOO_LARGE (above 2^26 pairs of cells)
/// @complexity In proportion to the pairs of cells that may be within the tolerance of each other, with a limit for
///     each, and to the points, as 1 / sqrt(chord); more where cells are within the tolerance of hundreds of others.
///     For one surface also in proportion to its cells; of n cells round a pole n^2 / 2 pairs are looked at, and held
///     only where the sheet is not proved to be regular there. Threads; the same bits for any number of them. With the
///     surfaces exchanged bits may differ, and which contacts are proved.
/// @source Leus, "Carcasses on smooth surfaces", task e; the proofs are ours.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_intersection_create(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_surface *other,
    const struct gusset_intersection_options *options, struct gusset_surface_paths **paths);

#ifdef __cplusplus
}
#endif

#endif /* GUSSET_SURFACE_H */
