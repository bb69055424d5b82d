/* Generated from src/capi; do not edit. See gusset.h. */

#ifndef GUSSET_SURFACE_H
#define GUSSET_SURFACE_H
#include "base.h"
#include "mesh.h"
#include "curve.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Surfaces: Smooth surfaces that answer queries from an index. */

/// A smooth surface of sheets, indexed for queries.
typedef struct gusset_surface gusset_surface;

/// Size and numbering of a sheet.
typedef struct gusset_surface_sheet {
    /// Rows of cells: u runs from 0 to rows.
    size_t rows;
    /// Columns of cells, in v.
    size_t columns;
    /// Number of cell (0, 0) among all sheets' cells. Cell (i, j) has the number first_cell + i * columns + j: its bit
    /// in masks of gusset_surface_cells_view.
    uint64_t first_cell;
    /// Number of corner (0, 0) among all sheets' corners, (rows + 1) x (columns + 1) each: offset of its values for
    /// GUSSET_CONTOUR_VALUES.
    uint64_t first_node;
    /// 1: closed in u. @flag
    uint32_t closed_u;
    /// 1: closed in v. @flag
    uint32_t closed_v;
} gusset_surface_sheet;

/// A place on a surface.
typedef struct gusset_surface_place {
    /// Index of the sheet.
    uint32_t sheet;
    /// Row of the cell.
    uint32_t row;
    /// Column of the cell.
    uint32_t column;
    uint32_t reserved;
    /// Parameter in the cell, 0 to 1; the sheet's parameter is row + u.
    double u;
    /// Parameter in the cell, 0 to 1; the sheet's parameter is column + v.
    double v;
} gusset_surface_place;

/// How two surfaces touch.
typedef uint32_t gusset_contact_kind;
/// They touch in a point. Round it they are apart, or overlap by at most the tolerance.
#define GUSSET_CONTACT_POINT 1
/// Two branches of the intersection cross, or pass each other within the tolerance.
#define GUSSET_CONTACT_CROSSING 2

/// A point where surfaces touch within the tolerance, with parallel normals.
typedef struct gusset_surface_contact {
    /// Place on the first surface.
    struct gusset_surface_place place;
    /// Place on the second surface.
    struct gusset_surface_place other;
    /// Height of the first surface above the second, along the first's normal.
    double gap;
    /// Near the contact, points within the tolerance of the other surface lie this near, except on crossing branches.
    double radius;
    gusset_contact_kind kind;
    uint32_t reserved;
} gusset_surface_contact;

/// Options of gusset_surface_create.
typedef struct gusset_surface_options {
    size_t struct_size;
    /// Guaranteed accuracy of distances and positions in answers, as a length, finite. 0: 1e-9 of the surface's box
    /// diagonal.
    double tolerance;
    /// 1: builds the cones of normals for GUSSET_CONTOUR_ANGLE and gusset_surface_nearest_angle; 0: the first such
    /// query builds them. @flag
    uint32_t cones;
    uint32_t reserved;
} gusset_surface_options;

/// Curves on a surface: sections, contours or intersections.
typedef struct gusset_surface_paths gusset_surface_paths;

/// Lent curves.
typedef struct gusset_surface_paths_view {
    size_t struct_size;
    size_t path_count;
    size_t point_count;
    /// Curve k has the points ends[k] to ends[k + 1] - 1.
    struct gusset_indices ends;
    /// By curve: 1 if closed. Append the first point for gusset_curve_through_create. @flag
    const uint32_t *closed;
    /// By curve: index of its plane, level or angle, or 0.
    const uint32_t *levels;
    /// The points, on the surface.
    const double *points;
    /// Unit normal at each point; 0 where undefined.
    const double *normals;
    /// Places of the points.
    const struct gusset_surface_place *places;
    /// Intersections: places on the second surface; else NULL.
    const struct gusset_surface_place *others;
    /// Cells that may contain a tangency, a coincidence, or pieces smaller than the tolerance.
    const struct gusset_surface_place *unresolved;
    size_t unresolved_count;
    /// Intersections: points where the surfaces touch.
    const struct gusset_surface_contact *contacts;
    size_t contact_count;
} gusset_surface_paths_view;

struct gusset_sheet;

/// Makes a surface of sheets, and its index.
/// Each sheet's greatest absolute coordinate, control points included, is 0 or from 1e-30 to 1e37.
/// @param sheets count handles, none NULL.
/// @errors EMPTY_MESH (no sheets), OUT_OF_RANGE (tolerance; coordinates of a sheet)
/// @complexity O(nodes), parallel; about 7 bytes a node, and 0.7 for cones.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_create(const struct gusset_context *context,
    const struct gusset_sheet *const *sheets, size_t count, const struct gusset_surface_options *options,
    struct gusset_surface **surface);

/// Frees a surface.
GUSSET_API void gusset_surface_destroy(struct gusset_surface *surface);

/// Lends the curves.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_paths_get_view(const struct gusset_surface_paths *paths,
    struct gusset_surface_paths_view *view);

/// Frees curves.
GUSSET_API void gusset_surface_paths_destroy(struct gusset_surface_paths *paths);

/* ---- Sheets: Smooth patches through a grid of nodes. */

/// A piece of surface: rows and columns of cells, each a Bézier patch.
typedef struct gusset_sheet gusset_sheet;

/// Interpolation through nodes.
typedef uint32_t gusset_scheme;
/// Bicubic from 6 x 6 nodes round a cell; fourth order, constant 1/384, continuous tangents.
#define GUSSET_SCHEME_SIX_TAP 0
/// Leus's bicubic through 4 x 4 nodes round a cell; fourth order, constant 3/128, tangents jump at nodes.
#define GUSSET_SCHEME_FOUR_POINT 1

/// Source of the twists S_uv at nodes.
typedef uint32_t gusset_twists;
/// Differences of tangents over five nodes: fourth order.
#define GUSSET_TWISTS_DIFFERENCES 0
/// Adini's twists, from adjacent nodes.
#define GUSSET_TWISTS_ADINI 1
/// 0: flat spots at nodes.
#define GUSSET_TWISTS_ZERO 2
/// The given twists.
#define GUSSET_TWISTS_GIVEN 3

/// Nodes of a surface. Node (i, j) is at nodes + i * row_stride + j * column_stride bytes. Normals point along S_u x
/// S_v, u running from row to row: opposite to a net of these nodes.
typedef struct gusset_nodes {
    size_t struct_size;
    /// The first node.
    const void *nodes;
    /// At least 2; if closed in u, at least 4, and the last repeats the first.
    size_t rows;
    /// Likewise in v. rows * columns is at most 2^31 - 1.
    size_t columns;
    /// Bytes from row to row; 0: no gaps.
    size_t row_stride;
    /// Bytes from node to node in a row; 0: no gaps.
    size_t column_stride;
    gusset_scalar scalar;
    /// Interpolation through nodes.
    gusset_scheme scheme;
    /// 1: closed in u. @flag
    uint32_t closed_u;
    /// 1: closed in v. @flag
    uint32_t closed_v;
} gusset_nodes;

/// Tangents at nodes, row after row. The parameter step between nodes is 1.
typedef struct gusset_tangents {
    size_t struct_size;
    /// S_u at each node, towards the next row.
    const double *u;
    /// S_v at each node, towards the next column.
    const double *v;
    /// For GUSSET_TWISTS_GIVEN: S_uv at each node.
    const double *twists;
    gusset_twists twist;
    uint32_t reserved;
} gusset_tangents;

/// Makes a sheet through nodes, or the C1 bicubic Hermite surface of given tangents.
/// Repeated nodes and poles are allowed.
/// Borrowed nodes are f64, with address and strides that are multiples of 8. They must stay valid and unchanged until
/// the sheet and everything made of it are destroyed.
/// @param nodes finite.
/// @param tangents NULL: the nodes' scheme applies. Else rows x columns finite vectors in each array; a repeated
///     closing line is not used.
/// @param borrow 1: reads the caller's nodes; 0: copies them. With tangents, the sheet keeps only patches.
/// @errors NET_TOO_SMALL, TOO_LARGE, BAD_STRIDE (borrowed nodes), NOT_FINITE (node, tangent or twist), SIDES_DIFFER
///     (closed, but the ends differ; with the largest gap)
/// @complexity O(nodes); 24 bytes a node (0 if borrowed), with tangents 384 bytes a cell.
/// @source V. Leus (see the README).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_create(const struct gusset_context *context,
    const struct gusset_nodes *nodes, const struct gusset_tangents *tangents, uint32_t borrow,
    struct gusset_sheet **sheet);

/// Frees a sheet.
GUSSET_API void gusset_sheet_destroy(struct gusset_sheet *sheet);

/* ---- Nearest points: Nearest points and local minima of the distance. */

/// Properties of a nearest point.
/// @bits
typedef uint32_t gusset_nearest_flags;
/// A point was found. Not set: no point within the limit; distance and bound are infinite, all else 0.
#define GUSSET_NEAREST_FOUND 1
/// `bound` is within the tolerance of the distance, or within rounding. Not set: the proof takes too long, as near
/// centres of curvature; `bound` holds.
#define GUSSET_NEAREST_PROVEN 2
/// Another point, farther away than 1/100 of the distance, is equally near within the tolerance.
#define GUSSET_NEAREST_AMBIGUOUS 4

/// A surface point near a query.
typedef struct gusset_surface_nearest_point {
    /// Place on the surface.
    struct gusset_surface_place place;
    /// x, y, z.
    double point[3];
    /// Unit normal; at a pole its limit; 0 if undefined. The query is on its side if (query - point) . normal > 0.
    double normal[3];
    /// Distance from the query.
    double distance;
    /// Lower bound of the distance from the surface; for minima, from the piece round the point.
    double bound;
    gusset_nearest_flags flags;
    uint32_t reserved;
} gusset_surface_nearest_point;

/// Limits of a search for near points.
typedef struct gusset_nearest_options {
    size_t struct_size;
    /// Largest distance of a point, at least 0; 0 or INFINITY: no limit.
    double limit;
    /// Minima: most, nearest first; 0: all.
    size_t max_count;
} gusset_nearest_options;

/// Points of a surface.
typedef struct gusset_surface_points gusset_surface_points;

/// Lent points.
typedef struct gusset_surface_points_view {
    size_t struct_size;
    /// The points, nearest first.
    const struct gusset_surface_nearest_point *points;
    size_t count;
    /// No minimum below this distance is missing.
    double bound;
    /// 0 if the search stopped at `bound`. @flag
    uint32_t complete;
    uint32_t reserved;
} gusset_surface_points_view;

/// Finds the nearest point for each query.
/// Among equally near points, the first by sheet, row and column is returned. Answers do not depend on other queries.
/// @param queries up to 1e150.
/// @param points receives count answers in order; after an error, none is found.
/// @errors TOO_LARGE, NOT_FINITE (query), OUT_OF_RANGE (limit, query)
/// @complexity O(log nodes) a query, parallel; more near centres of curvature, but bounded.
/// @source Leus, task a.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_nearest(const struct gusset_context *context,
    const struct gusset_surface *surface, const double *queries, size_t count,
    const struct gusset_nearest_options *options, struct gusset_surface_nearest_point *points);

/// Finds the local minima of the distance from a query.
/// No minimum is missed. If the distance is constant, one point represents all cells that touch there,
/// GUSSET_NEAREST_AMBIGUOUS but not GUSSET_NEAREST_PROVEN. On borders and creases, no path on the surface leads nearer.
/// @param query up to 1e150.
/// @param points receives the minima.
/// @errors NOT_FINITE, OUT_OF_RANGE (limit, query)
/// @complexity O(cells within the limit, or up to the last of max_count minima).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_minima_create(const struct gusset_context *context,
    const struct gusset_surface *surface, const double *query, const struct gusset_nearest_options *options,
    struct gusset_surface_points **points);

/// Lends the points.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_points_get_view(const struct gusset_surface_points *points,
    struct gusset_surface_points_view *view);

/// Frees points.
GUSSET_API void gusset_surface_points_destroy(struct gusset_surface_points *points);

/* ---- Points: Points, normals and curvatures at places of a surface. */

/// Kind of a normal.
typedef uint32_t gusset_normal_kind;
/// Undefined: tangents are 0, or parallel along all lines to the point.
#define GUSSET_NORMAL_NONE 0
/// Normal of the tangent plane.
#define GUSSET_NORMAL_REGULAR 1
/// Limit along the coordinate line where the tangents span no plane, as at poles.
#define GUSSET_NORMAL_LIMIT 2

/// Point, derivatives by the cell's parameters, normal and curvatures at a place.
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
    /// Unit normal along S_u x S_v; 0 if undefined.
    double normal[3];
    /// For GUSSET_NORMAL_LIMIT: largest angle to limits along other lines.
    double spread;
    /// Principal curvatures, the greater first; positive if bent towards the normal.
    double principal[2];
    /// Principal directions: two unit tangents.
    double directions[6];
    /// Mean curvature.
    double mean;
    /// Gaussian curvature.
    double gaussian;
    gusset_normal_kind normal_kind;
    /// 0: not regular; curvatures are 0. @flag
    uint32_t is_curved;
} gusset_surface_point;

/// Evaluates a surface at places.
/// @param results receives count points; all 0 after an error.
/// @errors NO_SUCH_ELEMENT (place: no such sheet or cell, or a parameter outside 0 to 1)
/// @complexity O(1) a place, at a pole O(cells round it); parallel.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_evaluate(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_surface_place *places, size_t count,
    struct gusset_surface_point *results);

/// Converts parameters of a sheet to places: node (i, j) has u = i and v = j.
/// Parameters wrap round in closed directions, and are clamped to open sides.
/// @param sheet index.
/// @param parameters u, v of each place.
/// @param places receives count places; all 0 after an error.
/// @errors NO_SUCH_ELEMENT (first pair that is not finite; first pair if no such sheet)
/// @complexity O(1) a place.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_locate(const struct gusset_context *context,
    const struct gusset_surface *surface, uint32_t sheet, const double *parameters, size_t count,
    struct gusset_surface_place *places);

/* ---- Lines: Hits of lines and curves on a surface. */

/// A line, ray or segment: origin + t * direction for t from `from` to `to`.
typedef struct gusset_line {
    /// Point at t = 0; -1e150 to 1e150.
    double origin[3];
    /// The squared length must not underflow or overflow: 1e-150 to 1e150 is safe.
    double direction[3];
    /// Least t: -INFINITY for a line, 0 for a ray or segment; not INFINITY.
    double from;
    /// Greatest t: INFINITY for a line or ray; at least `from`, not -INFINITY.
    double to;
} gusset_line;

/// The hits to return.
typedef uint32_t gusset_hit_selection;
/// All hits, ordered along the line.
#define GUSSET_HITS_ALL 0
/// The first hit.
#define GUSSET_HITS_FIRST 1
/// Any one hit.
#define GUSSET_HITS_ANY 2

/// Kind of a hit.
typedef uint32_t gusset_hit_kind;
/// No hit.
#define GUSSET_HIT_NONE 0
/// It passes through the surface. Proved, except at poles.
#define GUSSET_HIT_CROSSING 1
/// It touches within the tolerance, in one point, two close points, or none.
#define GUSSET_HIT_TOUCH 2
/// It runs in the surface within the tolerance, over the whole span.
#define GUSSET_HIT_INSIDE 3

/// A common point of a surface and a line or curve.
typedef struct gusset_surface_hit {
    /// Parameter on the line; for a curve, segment + parameter in it.
    double t;
    /// Parameters between which both agree within the tolerance; at a crossing, t twice.
    double span[2];
    /// Place on the surface.
    struct gusset_surface_place place;
    /// Point on the surface.
    double point[3];
    /// Unit normal; at a pole its limit; 0 if undefined.
    double normal[3];
    gusset_hit_kind kind;
    uint32_t reserved;
} gusset_surface_hit;

/// Hits on a surface.
typedef struct gusset_surface_hits gusset_surface_hits;

/// Lent hits.
typedef struct gusset_surface_hits_view {
    size_t struct_size;
    /// Queries: the lines, then the curve if given.
    size_t query_count;
    size_t hit_count;
    /// Query k has the hits ends[k] to ends[k + 1] - 1.
    const uint64_t *ends;
    /// The hits, by rising t in each query.
    const struct gusset_surface_hit *hits;
    /// For each hit of the curve, places of hit, start and end of span. Else NULL.
    const struct gusset_place *on_curve;
    /// Number of places on the curve.
    size_t on_curve_count;
} gusset_surface_hits_view;

/// Finds the hits of lines and a curve on a surface.
/// No hit is missed or repeated, also at sides of cells and sheets, joints of the curve and poles. Hits of a line do
/// not depend on others.
/// @param lines NULL: none.
/// @param curve of degree 7 at most; NULL: none.
/// @errors OUT_OF_RANGE (a line not finite, without direction, or ending before it begins; degree), EMPTY_CURVE
/// @complexity About O(log cells) a line and a cell near the curve, O(1) a hit; bounded in each cell that a line runs
///     in. Parallel.
/// @source Leus, task c.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_hits_create(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_line *lines, size_t count,
    const struct gusset_curve *curve, gusset_hit_selection selection, struct gusset_surface_hits **hits);

/// Finds the first hit, of least t, of each line.
/// @param hits receives count hits; without a hit, or after an error, GUSSET_HIT_NONE and 0.
/// @errors as gusset_surface_hits_create
/// @complexity About O(log cells) a line; parallel.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_first_hits(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_line *lines, size_t count,
    struct gusset_surface_hit *hits);

/// Lends the hits.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_hits_get_view(const struct gusset_surface_hits *hits,
    struct gusset_surface_hits_view *view);

/// Frees hits.
GUSSET_API void gusset_surface_hits_destroy(struct gusset_surface_hits *hits);

/* ---- Sections: Sections by planes, contours, isophotes and silhouettes. */

/// Curve points between crossings with cell sides.
typedef uint32_t gusset_spacing_rule;
/// Points on the surface that keep chords within 1e-4 of its box diagonal.
#define GUSSET_POINT_SPACING_AUTO 0
/// Points on the surface that keep chords within `chord`, sampled at the middle and quarters. Larger distances are
/// possible where nodes are far apart.
#define GUSSET_POINT_SPACING_CHORD 1
/// No points.
#define GUSSET_POINT_SPACING_CELL_EDGES 2
/// `points` points on the cubic through four crossings, near the surface. Each has the place of the crossing before.
/// Fourth order where crossings are evenly spaced.
#define GUSSET_POINT_SPACING_LEUS 3

/// Density of points on curves.
typedef struct gusset_contour_options {
    size_t struct_size;
    /// A length above 0, finite; at least the surface's tolerance applies.
    /// @when spacing GUSSET_POINT_SPACING_CHORD
    double chord;
    gusset_spacing_rule spacing;
    /// Points between two crossings, at most 1000.
    /// @when spacing GUSSET_POINT_SPACING_LEUS
    uint32_t points;
} gusset_contour_options;

/// The function whose contours are drawn.
typedef uint32_t gusset_contour_kind;
/// Signed distance from the plane through `point` with the normal `direction`: sections by parallel planes.
#define GUSSET_CONTOUR_HEIGHT 0
/// Values at cell corners, interpolated like the surface.
#define GUSSET_CONTOUR_VALUES 1
/// Angle between the normal and `direction`: isophotes, at pi / 2 silhouettes seen along `direction`.
#define GUSSET_CONTOUR_ANGLE 2

/// A function on a surface. Only the fields of its kind are read; they name it without prefix.
typedef struct gusset_contour_function {
    size_t struct_size;
    gusset_contour_kind kind;
    /// ANGLE. 1: a normal and its opposite are equal.
    uint32_t unsigned_normals;
    /// HEIGHT: a point at height 0.
    double point[3];
    /// HEIGHT, ANGLE: not 0.
    double direction[3];
    /// VALUES: finite, sheet after sheet, row after row, (rows + 1) x (columns + 1) a sheet. A closing line is not
    /// read.
    const double *values;
    size_t value_count;
} gusset_contour_function;

/// The normal nearest to a given angle.
typedef struct gusset_nearest_angle_report {
    size_t struct_size;
    /// Place of the normal.
    struct gusset_surface_place place;
    /// Point at the place.
    double point[3];
    /// The unit normal.
    double normal[3];
    /// Angle between normal and direction.
    double angle;
    /// Difference from the given angle; infinite, and all else 0, if the surface lacks normals.
    double deviation;
    /// Lower bound of all deviations, within 1e-9 of `deviation` unless the proof fails.
    double bound;
} gusset_nearest_angle_report;

/// Draws contours of a function.
/// Curves are ordered by level, then by lowest cell. Seen against the normals, the function increases to the left of a
/// curve (angles decrease): a section runs along direction x normal.
/// Every curve is found, even within one cell; curves up to the tolerance in size are unresolved. On a closed surface
/// all curves are closed.
/// Sections: a corner on a plane counts as above it.
/// - A plane that touches corners from below gives neither a curve nor an unresolved cell.
/// - A plane that touches from above gives closed curves round the contact, however narrow: there and back along a row
///   of corners.
/// - Where a plane touches or contains the surface elsewhere within rounding, cells are unresolved.
/// Isophotes:
/// - At the angles 0 and pi, paths are single points.
/// - Where normals jump between cells (patches, GUSSET_SCHEME_FOUR_POINT), curves follow the common side.
/// - Poles that may have the angle are unresolved.
/// - Angles are accurate to third order; GUSSET_CONTOUR_VALUES of their cosines, to fourth.
/// @param levels rising values; angles 0 to pi, or to pi / 2 for unsigned normals.
/// @errors OUT_OF_RANGE (non-finite numbers, zero direction, levels, angle, chord, points), COUNT_DIFFERS (too few
///     values), TOO_LARGE (too many values; 2^32 points), NOT_FINITE (value)
/// @complexity About O(count + crossed cells), parallel; O(values) for values; O(cells) once for angles.
/// @source Leus, tasks b and d.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_contours_create(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_contour_function *function, const double *levels,
    size_t count, const struct gusset_contour_options *options, struct gusset_surface_paths **paths);

/// Finds the normal whose angle with a direction is nearest to a given one, proved to 1e-9.
/// @param direction not 0.
/// @param angle 0 to pi, or to pi / 2 for unsigned normals.
/// @param unsigned_normals 1: a normal and its opposite are equal.
/// @errors OUT_OF_RANGE
/// @complexity About O(cells with normals near the angle), parallel; O(cells) once.
/// @source Leus, task b.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_nearest_angle(const struct gusset_context *context,
    const struct gusset_surface *surface, const double *direction, double angle, uint32_t unsigned_normals,
    struct gusset_nearest_angle_report *report);

/* ---- Intersections of surfaces: Curves in which two surfaces meet, or one meets itself. */

/// Options of gusset_surface_intersection_create.
typedef struct gusset_intersection_options {
    size_t struct_size;
    /// Largest distance of the curve from its chords, above 0, finite; rare chords exceed it by about 15 %. At least
    /// the smallest of `tolerance` and the surfaces' tolerances applies.
    /// @when spacing GUSSET_POINT_SPACING_CHORD
    double chord;
    /// Two surfaces touch where their gap or overlap stays within this length, finite; 0: the surfaces' smaller
    /// tolerance. Self-intersections use at most the surface's. Branches shorter than all three may be lost.
    double tolerance;
    /// Not GUSSET_POINT_SPACING_LEUS. GUSSET_POINT_SPACING_AUTO refers to the smaller surface.
    gusset_spacing_rule spacing;
    uint32_t reserved;
} gusset_intersection_options;

/// Finds the curves in which two surfaces meet, or one meets itself.
/// Each curve is returned once, and runs along N x N', the normals at `places` and `others`. Points and normals lie on
/// the first surface; the second differs by rounding, at crossings by up to the tolerance.
/// Two surfaces: all branches are found, except
/// - branches shorter than the tolerance, or the surfaces' if smaller (near poles, four times that);
/// - branches within four times that length of another branch;
/// - parts within contacts and unresolved cells.
/// Open paths end at borders of sheets or in unresolved cells.
/// A point where surfaces touch or branches cross is a contact if proved:
/// - Near it, both surfaces are graphs over a plane.
/// - Second derivatives of the difference are definite (GUSSET_CONTACT_POINT) or indefinite (GUSSET_CONTACT_CROSSING).
/// - The gap is within the tolerance. A larger gap leaves a loop, nothing, or two separate branches.
/// Within a contact's radius, loops are omitted and paths run straight to its point. The radius is at most about 4
/// sqrt(2 tolerance / c), c the least curvature of the difference. At a crossing, a path turns into the branch that
/// closes it, if any.
/// Cells of the first surface are unresolved where
/// - the surfaces coincide, or touch along a curve, at a pole, at a border or to a higher order;
/// - the work limit is exceeded, as by branches within 1e-4 of a cell of each other, or nearly along cell sides of both
///   surfaces.
/// There, curves may end, split or be missing, but are joined across a cell if a chord is as near to both surfaces as
/// elsewhere.
/// Self-intersections:
/// - Along a closed curve the pieces may swap: it ends at its first point with `places` and `others` exchanged. A seam
///   that turns the sheet over also reverses the direction.
/// - Common points of joined cells do not count. Joined cells share a side, corner or pole, or lie at opposite borders
///   of a sheet with equal control points, in either order, to 64 units of rounding of the largest coordinate.
/// - A common border of different sheets is an intersection.
/// - Branches longer than the tolerance are found, except in unresolved cells: at pinches, creases and singular poles,
///   and where pieces touch or coincide.
/// - A curve stops before a pinch, where its pieces come within the tolerance (on rough surfaces, tens of tolerances).
/// - Curves along cell sides may come in many parts.
/// - Contacts are not sought.
/// Exchanging the surfaces may change rounding and proved contacts.
/// @param other NULL: self-intersections; if `surface`, everything coincides.
/// @errors OUT_OF_RANGE (chord, tolerance), TOO_LARGE (above 2^26 pairs of cells)
/// @complexity Proportional to the pairs of cells within the tolerance, limited for each, and to the points, about 1 /
///     sqrt(chord); parallel. Self-intersections: also to the cells, and n^2 / 2 for n cells round a pole.
/// @source Leus, task e.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_intersection_create(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_surface *other,
    const struct gusset_intersection_options *options, struct gusset_surface_paths **paths);

/* ---- Distances: Nearest points of a surface and a line, plane, curve or surface. */

/// Kind of a target.
typedef uint32_t gusset_target_kind;
/// The line, ray or segment `line`.
#define GUSSET_TARGET_LINE 0
/// The plane through `point` with the normal `normal`.
#define GUSSET_TARGET_PLANE 1
/// The curve `curve`.
#define GUSSET_TARGET_CURVE 2
/// The surface `surface`.
#define GUSSET_TARGET_SURFACE 3

/// An object to measure from. Only the fields of its kind are read; they name it without prefix.
typedef struct gusset_target {
    size_t struct_size;
    gusset_target_kind kind;
    uint32_t reserved;
    /// LINE.
    struct gusset_line line;
    /// PLANE: -1e150 to 1e150.
    double point[3];
    /// PLANE: not 0.
    double normal[3];
    /// CURVE: any degree; coordinates -1e150 to 1e150.
    const struct gusset_curve *curve;
    /// SURFACE.
    const struct gusset_surface *surface;
} gusset_target;

/// Properties of a distance.
/// @bits
typedef uint32_t gusset_distance_flags;
/// `bound` is within the tolerance of the distance, or within 2^-45 of the greatest coordinate. Not set: the proof
/// takes too long; `bound` holds.
#define GUSSET_DISTANCE_PROVEN 1
/// Surface and target meet up to rounding; the distance is 0.
#define GUSSET_DISTANCE_MEETS 2

/// Nearest points of a surface and a target.
typedef struct gusset_distance_report {
    size_t struct_size;
    /// Place of the surface's point.
    struct gusset_surface_place place;
    /// The surface's point.
    double point[3];
    /// Unit normal at `point`; at a pole its limit; 0 if undefined.
    double normal[3];
    /// The target's point.
    double other_point[3];
    /// Their distance.
    double distance;
    /// Proved lower bound of the distance.
    double bound;
    /// SURFACE: place of its point; else 0.
    struct gusset_surface_place other_place;
    /// CURVE: place of its point; else 0.
    struct gusset_place curve_place;
    /// LINE: parameter of its point. PLANE: signed distance, negative opposite to its normal. Else 0.
    double parameter;
    gusset_distance_flags flags;
    uint32_t reserved;
} gusset_distance_report;

/// Finds the nearest points of a surface and a target.
/// Among equally near pairs, the choice is deterministic. If much of the surface is equally near, the proof may fail.
/// If a plane meets the surface, the points lie on the section.
/// @param tolerance length to which the distance is proved, finite; 0: the surface's, or the greater of two.
/// @errors OUT_OF_RANGE (tolerance; `line`; a plane not finite, too large or without direction; a curve too large),
///     EMPTY_CURVE
/// @complexity About O(log cells), at most 50,000 pairs of pieces.
/// @source Leus, tasks c to e.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_distance(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_target *target, double tolerance,
    struct gusset_distance_report *report);

/* ---- Reports on surfaces: Facts about a surface and its sheets. */

/// Facts about a surface.
typedef struct gusset_surface_report {
    size_t struct_size;
    size_t sheet_count;
    /// Cells of all sheets.
    size_t cell_count;
    /// Corners of cells; nodes of sheets from nodes.
    size_t node_count;
    /// Bytes of the index, without nodes and cones of normals.
    size_t index_bytes;
    /// Guaranteed accuracy, as in gusset_surface_options.
    double tolerance;
    /// Low corner of a box round surface and control nets.
    double low[3];
    /// High corner.
    double high[3];
    /// Bytes of the cones of normals; 0 if not built.
    size_t cone_bytes;
    /// The sheets.
    const struct gusset_surface_sheet *sheets;
} gusset_surface_report;

/// Reports on a surface and its sheets.
/// @complexity O(sheets).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_get_report(const struct gusset_surface *surface,
    struct gusset_surface_report *report);

/* ---- Other sheets: Sheets from patches, B-splines (NURBS included), nets of curves, frames, and offsets. */

/// How a surface is made from a frame.
typedef uint32_t gusset_frame_surface;
/// The curves across. Between two equal sections, one straight behind the other, the surface is their cylinder.
#define GUSSET_FRAME_SECTIONS 0
/// A grid through the frame's nodes, or GUSSET_FRAME_CURVES if its curves have corners.
#define GUSSET_FRAME_NODES 1
/// Gordon's surface, which contains all curves of the frame.
#define GUSSET_FRAME_CURVES 2

/// A tensor-product B-spline, rational (NURBS) if its weights differ.
/// Knots are finite and do not decrease. Inner knots may repeat degree times.
/// - Open direction: control points + degree + 1 knots, clamped or not; defined from knot degree to knot count.
/// - Closed direction: control points + 1 knots, one period; control points are not repeated. Span k begins at knot k
///   and uses control points k - degree to k, cyclically.
typedef struct gusset_spline {
    size_t struct_size;
    /// Control points, not multiplied by weights, row after row; rows follow in u.
    const double *points;
    /// Rows of control points, more than degree_u.
    size_t count_u;
    /// Control points in a row, more than degree_v.
    size_t count_v;
    /// Knots in u.
    const double *knots_u;
    /// Number of knots.
    size_t knot_count_u;
    /// Knots in v.
    const double *knots_v;
    /// Number of knots.
    size_t knot_count_v;
    /// 1 to 7.
    uint32_t degree_u;
    /// 1 to 7.
    uint32_t degree_v;
    /// 1: closed in u. @flag
    uint32_t closed_u;
    /// 1: closed in v. @flag
    uint32_t closed_v;
    /// Finite, above 0, at least 2^-900 of the greatest; NULL: all equal.
    const double *weights;
    /// Largest distance from a rational spline at equal parameters; rounding requires about 1e-13 of the size. 0: 1e-12
    /// of the control points' box diagonal, or more for rounding.
    double tolerance;
    /// Most cells of a rational spline; 0: 2^20.
    size_t max_cells;
} gusset_spline;

/// A net of curves: each row meets each column. Curves may have either orientation. If they do not meet in the given
/// order, they are sorted by the places where they meet.
typedef struct gusset_curve_net {
    size_t struct_size;
    /// Curves in v, of degree 7 at most; without columns, ordered by u. A curve that is one point is a pole.
    const struct gusset_curve *const *rows;
    /// 0 (a skin of the columns), or at least 2, or 3 if closed_u.
    size_t row_count;
    /// Curves in u; without rows, ordered by v.
    const struct gusset_curve *const *columns;
    /// 0 (a skin of the rows), or at least 2, or 3 if closed_v.
    size_t column_count;
    /// Largest distance of curves that meet, finite; both move to the middle. 0: 1e-6 of the box diagonal.
    double tolerance;
    /// 1: the columns are closed, and the first row follows the last. @flag
    uint32_t closed_u;
    /// 1: the rows are closed, and the first column follows the last. @flag
    uint32_t closed_v;
} gusset_curve_net;

/// Makes a sheet from Bézier patches.
/// Adjacent patches should share sides. Repeated points and poles are allowed.
/// @param points patch after patch, row after row; (degree_u + 1) x (degree_v + 1) points a patch, v fastest.
/// @param degree_u 1 to 7.
/// @param degree_v 1 to 7.
/// @param rows of patches, at least 1.
/// @param columns of patches, at least 1.
/// @errors OUT_OF_RANGE (degree), EMPTY_MESH (no patches), TOO_LARGE, NOT_FINITE
/// @complexity O(points); 384 bytes a patch up to degree 3, else 1536.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_from_patches_create(const struct gusset_context *context,
    const double *points, uint32_t degree_u, uint32_t degree_v, size_t rows, size_t columns,
    struct gusset_sheet **sheet);

/// Makes a sheet from a B-spline surface. If all weights are equal, each non-empty knot span becomes a cell, exact up
/// to rounding.
/// For the spline's parameters at 0, 1, 2, ... and the proved deviation, see gusset_sheet_get_report.
/// If weights differ:
/// - Rows and columns of spans are subdivided into patches of degree 7 until the tolerance is proved.
/// - Values and first derivatives at cell corners are exact.
/// - Tangents are continuous across sides where the rational surface's are.
/// - A side that is one point stays exactly one point.
/// @errors OUT_OF_RANGE (degree, tolerance, weight), NET_TOO_SMALL (too few control points), BAD_KNOTS (not finite,
///     decreasing, repeated too often, or a span too short to subdivide), TOO_LARGE (control points, cells), NOT_FINITE
/// @complexity O(spans x degree^3); 384 bytes a span up to degree 3, else 1536. Rational: O(cells x degree^2),
///     parallel; 1536 bytes a cell, three times that during the call.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_from_spline_create(const struct gusset_context *context,
    const struct gusset_spline *spline, struct gusset_sheet **sheet);

/// Makes Gordon's surface of a net of curves, which contains them all.
/// Two rows and two columns give Coons's patch. Nodes are where each row and each column are nearest. If all rows have
/// the same number of segments between two nodes, these are matched in order. Else all rows are cut at each joint,
/// which adds cells. Columns likewise.
/// The surface is C1 where the curves are C1 over common knots without joints between nodes; elsewhere nearly C1 (see
/// gusset_sheet_measure). Polylines keep their creases.
/// @errors NET_TOO_SMALL, EMPTY_CURVE, OUT_OF_RANGE (degree, tolerance), CURVE_NOT_CLOSED, CURVES_APART (with row and
///     distance; also out of order), TOO_LARGE
/// @complexity O(rows x columns x log segments + cells); 384 bytes a cell up to degree 3, else 1536.
/// @source Gordon (1969).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_from_curves_create(const struct gusset_context *context,
    const struct gusset_curve_net *net, struct gusset_sheet **sheet);

/// Makes a grid through the corners of a sheet's cells, each moved along its normal.
/// Normals point along S_u x S_v:
/// - Grid: from circles through neighbouring nodes; exact on planes, spheres, and round cylinders whose rulings and
///   sections are grid lines.
/// - Patches: exact. The grid is smooth where patches had creases.
/// - A corner without a normal stays.
/// @param distances lengths of either sign, finite.
/// @param distance_count 1: for all; rows + 1: for each line of corners along v; (rows + 1) x (columns + 1): for each
///     corner, row by row. A closing line counts, but moves with the first.
/// @param deviation receives the largest deviation at cell middles from the sheet moved by the corners' mean distance;
///     or NULL.
/// @errors COUNT_DIFFERS (distances), NOT_FINITE (distance or corner)
/// @complexity O(cells).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_offset_create(const struct gusset_context *context,
    const struct gusset_sheet *sheet, const double *distances, size_t distance_count, double *deviation,
    struct gusset_sheet **offset);

/// Makes the surface of a frame: u runs along the body, v round it, closed like the frame.
/// @errors NET_TOO_SMALL, OUT_OF_RANGE (degree above 7), CURVES_APART (nodes of a curve repeat or are out of order),
///     NOT_FINITE
/// @complexity O(nodes).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_from_frame_create(const struct gusset_context *context,
    const struct gusset_frame *frame, gusset_frame_surface kind, struct gusset_sheet **sheet);

/* ---- Reports on sheets: Sizes, estimates and bounds. */

/// Facts about a sheet.
typedef struct gusset_sheet_report {
    size_t struct_size;
    /// Cells in u: u runs from 0 to rows.
    size_t rows;
    /// Cells in v: v runs from 0 to columns.
    size_t columns;
    /// Degree of patches in both directions: 3 or 7.
    uint32_t degree;
    /// 1: stores nodes; 0: patches. @flag
    uint32_t is_grid;
    /// 1: closed in u. @flag
    uint32_t closed_u;
    /// 1: closed in v. @flag
    uint32_t closed_v;
    /// 1: the side u = 0 is a pole, one point. @flag
    uint32_t pole_u0;
    /// 1: the side u = rows is a pole. @flag
    uint32_t pole_u1;
    /// 1: the side v = 0 is a pole. @flag
    uint32_t pole_v0;
    /// 1: the side v = columns is a pole. @flag
    uint32_t pole_v1;
    /// Bound of the distance from a rational spline at equal parameters, rounding included; else 0.
    double deviation;
    /// Spline: its rows + 1 rising parameters at u = 0, 1, ..., linear between; else NULL.
    const double *knots_u;
    /// Spline: its columns + 1 parameters at v = 0, 1, ...; else NULL.
    const double *knots_v;
} gusset_sheet_report;

/// Reports on a sheet.
/// @complexity O(cells at the sides).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_get_report(const struct gusset_sheet *sheet,
    struct gusset_sheet_report *report);

/// Fields of gusset_sheet_measures to compute.
/// @bits
typedef uint32_t gusset_sheet_measure_flags;
/// `diameter` and `intrinsic_diameter`.
#define GUSSET_SHEET_MEASURE_DIAMETERS 1
/// `curvature_bound`.
#define GUSSET_SHEET_MEASURE_CURVATURE 2
/// `crease`.
#define GUSSET_SHEET_MEASURE_CREASE 4

/// Measures of a sheet (see gusset_cell_arrays); 0 if not requested.
typedef struct gusset_sheet_measures {
    size_t struct_size;
    /// Greatest of `diameters`.
    double diameter;
    /// Greatest of `intrinsic_diameters`.
    double intrinsic_diameter;
    /// Bound of absolute principal curvatures; infinite if not regular, as at poles.
    double curvature_bound;
    /// Largest angle between normals across cell sides; 0, or rounding, if smooth.
    double crease;
} gusset_sheet_measures;

/// Arrays of one number a cell; cell (i, j) has the index i * columns + j. NULL: not computed.
typedef struct gusset_cell_arrays {
    size_t struct_size;
    /// Length of each array, at least the number of cells.
    size_t capacity;
    /// Bounds of the distance of any two points of a cell.
    double *diameters;
    /// Bounds of the shortest curve in a cell between any two points.
    double *intrinsic_diameters;
    /// Estimates, not bounds, of the distance from the smooth surface that the nodes sample, at equal parameters.
    /// Infinite for fewer than 5 nodes in a direction; 0 for patches.
    double *errors;
    /// Bounds of the distance from the bilinear patch through a cell's corners.
    double *bilinear;
    /// Bounds of the distance from the two triangles of a cell, for either diagonal.
    double *triangles;
} gusset_cell_arrays;

/// Measures a sheet and its cells.
/// @param parts fields of `measures` to compute; 0: all.
/// @param cells NULL: none. After an error, the arrays are unchanged.
/// @param measures NULL: none.
/// @errors BUFFER_TOO_SMALL (value: number of cells)
/// @complexity O(cells), parallel; 16 bytes a cell for each of diameters, errors and distances.
/// @source Leus, eqs. (1) and (7).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_measure(const struct gusset_context *context,
    const struct gusset_sheet *sheet, gusset_sheet_measure_flags parts, const struct gusset_cell_arrays *cells,
    struct gusset_sheet_measures *measures);

/* ---- Meshes of sheets: Meshes of points of a sheet. */

/// Options of gusset_sheet_to_mesh. By default each cell becomes one quad.
typedef struct gusset_sheet_mesh_options {
    size_t struct_size;
    /// Largest distance of triangles from the surface, above 0; 0 or INFINITY: unlimited.
    double tolerance;
    /// Least parts of a cell in u; 0: 1.
    uint32_t min_u;
    /// Least parts of a cell in v; 0: 1.
    uint32_t min_v;
    /// 1: triangles only; 0: quads, with triangles at poles. @flag
    uint32_t triangles;
    uint32_t reserved;
} gusset_sheet_mesh_options;

/// Places and normals of the mesh of a sheet.
typedef struct gusset_sheet_mesh_report {
    size_t struct_size;
    size_t vertex_count;
    /// Place of each vertex; its sheet is 0.
    const struct gusset_surface_place *places;
    /// Unit normal of each vertex; 0 if undefined.
    const double *normals;
    /// Bound of the distance between surface and triangles, for quads divided by either diagonal.
    double deviation;
} gusset_sheet_mesh_report;

/// Makes a mesh of a sheet.
/// Cells of a row share the number of parts in u, cells of a column in v. Seams and poles are closed. Faces are
/// counter-clockwise seen from the side of S_u x S_v. The mesh may lack faces.
/// @errors OUT_OF_RANGE (tolerance), TOO_LARGE (2^32 - 1 corners or more)
/// @complexity O(cells + vertices).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_to_mesh(const struct gusset_context *context,
    const struct gusset_sheet *sheet, const struct gusset_sheet_mesh_options *options, struct gusset_result **result);

/// Lends the places and normals.
/// @errors WRONG_HANDLE
GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_sheet_mesh(const struct gusset_result *result,
    struct gusset_sheet_mesh_report *report);

/* ---- Cells: Pairs of near cells, and cells of a region. */

/// A cell of a surface.
typedef struct gusset_surface_cell {
    /// Index of the sheet.
    uint32_t sheet;
    /// Its row.
    uint32_t row;
    /// Its column.
    uint32_t column;
} gusset_surface_cell;

/// Cells, or pairs of cells.
typedef struct gusset_surface_cells gusset_surface_cells;

/// Lent cells. Region: `others` is NULL; pairs: the fields below it are NULL or 0.
typedef struct gusset_surface_cells_view {
    size_t struct_size;
    /// Cells by sheet, row, column. Pairs: cells of the first surface by both sheets, row, column.
    const struct gusset_surface_cell *cells;
    size_t cell_count;
    /// Cells of the second surface.
    const struct gusset_surface_cell *others;
    /// By cell: 1 if all of it is within the radius. @flag
    const uint32_t *whole;
    /// A bit for each cell, 1 in the region. Cell (i, j) of sheet k with c columns has bit b = first[k] + i * c + j:
    /// mask[b / 64] >> (b % 64) & 1.
    const uint64_t *mask;
    /// Words of the mask.
    size_t word_count;
    /// First bit of each sheet, then the number of bits.
    const uint64_t *first;
    size_t sheet_count;
} gusset_surface_cells_view;

/// Finds the cells that have a point within a radius of a query.
/// No cell is missed; a cell may lie outside by the tolerance, or more if bounded work cannot decide.
/// @param query up to 1e150.
/// @param radius at least 0; INFINITY: all cells.
/// @errors NOT_FINITE, OUT_OF_RANGE (radius, query)
/// @complexity O(cells found), and one bit a cell.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_region_create(const struct gusset_context *context,
    const struct gusset_surface *surface, const double *query, double radius, struct gusset_surface_cells **cells);

/// Finds the pairs of cells of two surfaces that may be within a distance of each other.
/// No pair is missed; a few may be farther apart.
/// @param within a length, finite; 0: cells that may meet.
/// @errors OUT_OF_RANGE (within), TOO_LARGE (above 2^26 pairs)
/// @complexity Proportional to the pairs and the index levels; 24 bytes a pair.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_cell_pairs_create(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_surface *other, double within,
    struct gusset_surface_cells **cells);

/// Lends the cells.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_cells_get_view(const struct gusset_surface_cells *cells,
    struct gusset_surface_cells_view *view);

/// Frees cells.
GUSSET_API void gusset_surface_cells_destroy(struct gusset_surface_cells *cells);

/* ---- Curves and surfaces: Curves through points, along sheets, and near lines. */

/// Direction of a coordinate curve of a sheet.
typedef uint32_t gusset_sheet_direction;
/// Along rows: u is constant.
#define GUSSET_ALONG_ROWS 0
/// Along columns: v is constant.
#define GUSSET_ALONG_COLUMNS 1

/// Draws a curve through points as sheets through nodes: fourth-order, a cubic between adjacent points.
/// @param nodes finite; at least 2. If closed: at least 4, and the last repeats the first.
/// @param closed 0 or 1.
/// @errors NET_TOO_SMALL (too few points), NOT_FINITE, CURVE_NOT_CLOSED, TOO_LARGE
/// @complexity O(count).
/// @source V. Leus (see the README).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_through_create(const struct gusset_context *context,
    const double *nodes, size_t count, uint32_t closed, gusset_scheme scheme, struct gusset_curve **curve);

/// Makes an exact coordinate curve of a sheet, one segment a cell.
/// @param parameter the constant u or v, 0 to the number of cells in its direction.
/// @errors OUT_OF_RANGE (parameter)
/// @complexity O(cells along the curve).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_curve_create(const struct gusset_context *context,
    const struct gusset_sheet *sheet, gusset_sheet_direction along, double parameter, struct gusset_curve **curve);

/// Finds where a curve meets a line, or comes within a distance of it.
/// If within is 0 and both lie in the plane z = 0, the result has crossings and touches, else the minima of distance,
/// each once. `others` have segment 0 and the line's parameter as t.
/// @param within a length, finite; in space raised to 1e-12 of the curve's size.
/// @param places overlaps are parts that stay within the distance or cannot be separated.
/// @errors EMPTY_CURVE, OUT_OF_RANGE (within; a line not finite or without direction)
/// @complexity Bounded for each segment whose box meets the line.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_intersect_line_create(const struct gusset_context *context,
    const struct gusset_curve *curve, const struct gusset_line *line, double within, struct gusset_places **places);

#ifdef __cplusplus
}
#endif
#endif /* GUSSET_SURFACE_H */
