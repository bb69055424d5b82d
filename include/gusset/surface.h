/* Generated from src/capi; see gusset.h. */

#ifndef GUSSET_SURFACE_H
#define GUSSET_SURFACE_H
#include "base.h"
#include "mesh.h"
#include "curve.h"

#ifdef __cplusplus
extern "C" {
#endif

/*** Surfaces. Coordinates of queries, lines and targets are -1e150 to 1e150. */

/// A smooth surface of sheets, indexed for queries.
typedef struct gusset_surface gusset_surface;

/// Size and numbering of a sheet.
typedef struct gusset_surface_sheet {
    /// Rows of cells: u runs from 0 to rows.
    size_t rows;
    /// Columns of cells, in v.
    size_t columns;
    /// Number of cell (0, 0) among all sheets' cells; cell (i, j) is first_cell + i * columns + j, its bit in region
    /// masks.
    uint64_t first_cell;
    /// Number of corner (0, 0) among all sheets' corners, (rows + 1) x (columns + 1) each: offset of values for
    /// GUSSET_CONTOUR_VALUES.
    uint64_t first_node;
    /// 1: closed in u.
    uint32_t closed_u;
    /// 1: closed in v.
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
    /// Parameter in the cell, 0 to 1; the sheet's is row + u.
    double u;
    /// Parameter in the cell, 0 to 1; the sheet's is column + v.
    double v;
} gusset_surface_place;

typedef uint32_t gusset_contact_kind;
/// They touch in a point, apart round it or overlapping within the tolerance.
#define GUSSET_CONTACT_POINT 1
/// Two branches cross, or pass each other within the tolerance.
#define GUSSET_CONTACT_CROSSING 2

/// A point where surfaces touch within the tolerance, with parallel normals.
typedef struct gusset_surface_contact {
    /// Place on the first surface.
    struct gusset_surface_place place;
    /// Place on the second surface.
    struct gusset_surface_place other;
    /// Height of the first above the second, along the first's normal.
    double gap;
    /// Near it, points within the tolerance of the other surface lie this near, except on crossing branches.
    double radius;
    gusset_contact_kind kind;
    uint32_t reserved;
} gusset_surface_contact;

typedef struct gusset_surface_options {
    size_t struct_size;
    /// Guaranteed accuracy of distances and positions. 0: 1e-9 of the surface's box diagonal.
    double tolerance;
    /// 1: builds cones of normals for GUSSET_CONTOUR_ANGLE and gusset_surface_nearest_angle; 0: the first such query
    /// does.
    uint32_t cones;
    uint32_t reserved;
} gusset_surface_options;

/// Curves on a surface: sections, contours or intersections.
typedef struct gusset_surface_paths gusset_surface_paths;

typedef struct gusset_surface_paths_view {
    size_t struct_size;
    size_t path_count;
    size_t point_count;
    /// Offsets into points, by curve.
    struct gusset_indices ends;
    /// By curve: 1 if closed; append the first point for gusset_curve_through_create.
    const uint32_t *closed;
    /// By curve: index of its plane, level or angle, or 0.
    const uint32_t *levels;
    /// On the surface.
    const double *points;
    /// Unit normals; 0 where undefined.
    const double *normals;
    /// Places of the points.
    const struct gusset_surface_place *places;
    /// Intersections: places on the second surface.
    const struct gusset_surface_place *others;
    /// Cells that may hold tangencies, coincidences, or pieces below the tolerance.
    const struct gusset_surface_place *unresolved;
    size_t unresolved_count;
    /// Intersections: points where surfaces touch.
    const struct gusset_surface_contact *contacts;
    size_t contact_count;
} gusset_surface_paths_view;

struct gusset_sheet;

/// Makes a surface of sheets.
/// Each sheet's greatest absolute coordinate, of controls also, is 0 or 1e-30 to 1e37.
/// @param sheets none NULL.
/// @errors EMPTY_MESH (no sheets), OUT_OF_RANGE (tolerance, coordinates)
/// @complexity O(nodes), parallel; about 7 bytes a node, and 0.7 for cones.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_create(const struct gusset_context *context,
    const struct gusset_sheet *const *sheets, size_t count, const struct gusset_surface_options *options,
    struct gusset_surface **surface);

GUSSET_API void gusset_surface_destroy(struct gusset_surface *surface);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_paths_get_view(const struct gusset_surface_paths *paths,
    struct gusset_surface_paths_view *view);

GUSSET_API void gusset_surface_paths_destroy(struct gusset_surface_paths *paths);

/*** Sheets */

/// Rows and columns of cells, each a Bézier patch.
typedef struct gusset_sheet gusset_sheet;

typedef uint32_t gusset_scheme;
/// Bicubic from 6 x 6 nodes round a cell: fourth order, constant 1/384, continuous tangents.
#define GUSSET_SCHEME_SIX_TAP 0
/// Leus's bicubic through 4 x 4 nodes: fourth order, constant 3/128, tangents jump at nodes.
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
/// S_v, u running from row to row: opposite to a net's.
typedef struct gusset_nodes {
    size_t struct_size;
    /// The first node.
    const void *nodes;
    /// At least 2; closed at least 4, the last repeating the first.
    size_t rows;
    /// Likewise; rows * columns at most INT32_MAX.
    size_t columns;
    size_t row_stride;
    /// Stride of nodes in a row.
    size_t column_stride;
    gusset_scalar scalar;
    /// Interpolation through nodes.
    gusset_scheme scheme;
    /// 1: closed in u.
    uint32_t closed_u;
    /// 1: closed in v.
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
/// Borrowed nodes are f64, address and strides multiples of 8. They stay unchanged until the sheet and all made of it
/// are destroyed.
/// @param nodes finite.
/// @param tangents NULL: the nodes' scheme applies. Else rows x columns vectors an array; a repeated closing line is
///     not used.
/// @param borrow 1: reads the caller's nodes; 0: copies them. With tangents, only patches are kept.
/// @errors NET_TOO_SMALL, BAD_STRIDE (borrowed nodes), NOT_FINITE (node, tangent or twist), SIDES_DIFFER (closed, but
///     ends differ: largest gap)
/// @complexity O(nodes); 24 bytes a node (0 if borrowed), with tangents 384 bytes a cell.
/// @source V. Leus.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_create(const struct gusset_context *context,
    const struct gusset_nodes *nodes, const struct gusset_tangents *tangents, uint32_t borrow,
    struct gusset_sheet **sheet);

GUSSET_API void gusset_sheet_destroy(struct gusset_sheet *sheet);

/*** Nearest points */

/// Properties of a nearest point.
/// @bits
typedef uint32_t gusset_nearest_flags;
/// A point was found. Else none is within the limit; distance and bound are infinite, the rest 0.
#define GUSSET_NEAREST_FOUND 1
/// `bound` is within the tolerance of the distance, or rounding. Else the proof takes too long, as near centres of
/// curvature; `bound` holds.
#define GUSSET_NEAREST_PROVEN 2
/// A point farther away than 1/100 of the distance is equally near within the tolerance.
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
    /// Lower bound of the distance from the surface (minima: from the piece round the point).
    double bound;
    gusset_nearest_flags flags;
    uint32_t reserved;
} gusset_surface_nearest_point;

/// Limits of a search for near points.
typedef struct gusset_nearest_options {
    size_t struct_size;
    /// Largest distance; 0 or INFINITY: no limit.
    double limit;
    /// Minima: most, nearest first; 0: all.
    size_t max_count;
} gusset_nearest_options;

/// Points of a surface.
typedef struct gusset_surface_points gusset_surface_points;

typedef struct gusset_surface_points_view {
    size_t struct_size;
    /// The points, nearest first.
    const struct gusset_surface_nearest_point *points;
    size_t count;
    /// No minimum below this distance is missing.
    double bound;
    /// 0 if the search stopped at `bound`.
    uint32_t complete;
    uint32_t reserved;
} gusset_surface_points_view;

/// Finds the nearest point for each query.
/// Gives the first of equally near points by sheet, row, column, independent of other queries.
/// @param queries points.
/// @param points count answers; after an error, none is found.
/// @errors NOT_FINITE (query), OUT_OF_RANGE (limit, query)
/// @complexity O(log nodes) a query, parallel; near centres of curvature more, but bounded.
/// @source Leus, task a.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_nearest(const struct gusset_context *context,
    const struct gusset_surface *surface, const double *queries, size_t count,
    const struct gusset_nearest_options *options, struct gusset_surface_nearest_point *points);

/// Finds the local minima of the distance from a query.
/// No minimum is missed. If the distance is constant, one point represents all touching cells, GUSSET_NEAREST_AMBIGUOUS
/// but not GUSSET_NEAREST_PROVEN. On borders and creases, no path leads nearer.
/// @param query a point.
/// @errors NOT_FINITE, OUT_OF_RANGE (limit, query)
/// @complexity O(cells within the limit, or up to the last of max_count minima).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_minima_create(const struct gusset_context *context,
    const struct gusset_surface *surface, const double *query, const struct gusset_nearest_options *options,
    struct gusset_surface_points **points);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_points_get_view(const struct gusset_surface_points *points,
    struct gusset_surface_points_view *view);

GUSSET_API void gusset_surface_points_destroy(struct gusset_surface_points *points);

/*** Points */

typedef uint32_t gusset_normal_kind;
/// Undefined: tangents are 0, or parallel along all lines to the point.
#define GUSSET_NORMAL_NONE 0
/// Normal of the tangent plane.
#define GUSSET_NORMAL_REGULAR 1
/// Limit along the coordinate line where tangents span no plane, as at poles.
#define GUSSET_NORMAL_LIMIT 2

/// Point, derivatives by the cell's parameters, normal and curvatures.
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
    /// GUSSET_NORMAL_LIMIT: largest angle to limits along other lines.
    double spread;
    /// Principal curvatures, greater first; positive if bent towards the normal.
    double principal[2];
    /// Principal directions: two unit tangents.
    double directions[6];
    /// Mean curvature.
    double mean;
    /// Gaussian curvature.
    double gaussian;
    gusset_normal_kind normal_kind;
    /// 0: not regular; curvatures are 0.
    uint32_t is_curved;
} gusset_surface_point;

/// Evaluates a surface at places.
/// @param results count points; 0 after an error.
/// @errors NO_SUCH_ELEMENT (place; also a parameter outside 0 to 1)
/// @complexity O(1) a place, at a pole O(cells round it); parallel.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_evaluate(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_surface_place *places, size_t count,
    struct gusset_surface_point *results);

/// Converts a sheet's parameters to places; node (i, j) has u = i, v = j.
/// Parameters wrap round closed directions, and are clamped to open sides.
/// @param sheet index.
/// @param parameters u, v of each place.
/// @param places count places; 0 after an error.
/// @errors NO_SUCH_ELEMENT (first pair that is not finite; pair 0: no such sheet)
/// @complexity O(1) a place.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_locate(const struct gusset_context *context,
    const struct gusset_surface *surface, uint32_t sheet, const double *parameters, size_t count,
    struct gusset_surface_place *places);

/*** Lines */

/// A line, ray or segment: origin + t * direction, `from` <= t <= `to`.
typedef struct gusset_line {
    /// Point at t = 0.
    double origin[3];
    /// Its squared length must not under- or overflow: 1e-150 to 1e150 is safe.
    double direction[3];
    /// Least t: -INFINITY for a line, 0 for a ray or segment.
    double from;
    /// Greatest t: INFINITY for a line or ray; at least `from`.
    double to;
} gusset_line;

typedef uint32_t gusset_hit_selection;
/// All hits, ordered along the line.
#define GUSSET_HITS_ALL 0
/// The first hit.
#define GUSSET_HITS_FIRST 1
/// Any one hit.
#define GUSSET_HITS_ANY 2

typedef uint32_t gusset_hit_kind;
/// No hit.
#define GUSSET_HIT_NONE 0
/// It passes through the surface. Proved, except at poles.
#define GUSSET_HIT_CROSSING 1
/// It touches within the tolerance, in one point, two close ones, or none.
#define GUSSET_HIT_TOUCH 2
/// It runs in the surface within the tolerance, over the whole span.
#define GUSSET_HIT_INSIDE 3

/// A common point of a surface and a line or curve.
typedef struct gusset_surface_hit {
    /// Parameter on the line; on a curve, segment + its parameter.
    double t;
    /// Parameters between which both agree within the tolerance; crossings: t twice.
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

typedef struct gusset_surface_hits_view {
    size_t struct_size;
    /// Lines, and the curve if given.
    size_t query_count;
    size_t hit_count;
    /// Offsets into hits, by query.
    const uint64_t *ends;
    /// The hits, by rising t in each query.
    const struct gusset_surface_hit *hits;
    /// Curve: for each hit, places of hit, start and end of span.
    const struct gusset_place *on_curve;
    /// Number of places on the curve.
    size_t on_curve_count;
} gusset_surface_hits_view;

/// Finds the hits of lines and a curve on a surface.
/// No hit is missed or repeated, also at sides of cells and sheets, joints and poles. A line's hits do not depend on
/// others.
/// @param lines NULL: none.
/// @param curve of degree 7 at most; NULL: none.
/// @errors OUT_OF_RANGE (line not finite, without direction, or ending before it begins; degree), EMPTY_CURVE
/// @complexity About O(log cells) a line and a cell near the curve, O(1) a hit, bounded in cells that a line runs in;
///     parallel.
/// @source Leus, task c.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_hits_create(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_line *lines, size_t count,
    const struct gusset_curve *curve, gusset_hit_selection selection, struct gusset_surface_hits **hits);

/// Finds each line's first hit, of least t.
/// @param hits count hits; GUSSET_HIT_NONE and 0 without one, or after an error.
/// @errors as gusset_surface_hits_create
/// @complexity About O(log cells) a line; parallel.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_first_hits(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_line *lines, size_t count,
    struct gusset_surface_hit *hits);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_hits_get_view(const struct gusset_surface_hits *hits,
    struct gusset_surface_hits_view *view);

GUSSET_API void gusset_surface_hits_destroy(struct gusset_surface_hits *hits);

/*** Sections */

/// Curve points between crossings with cell sides.
typedef uint32_t gusset_spacing_rule;
/// Points on the surface that keep chords within 1e-4 of its box diagonal.
#define GUSSET_POINT_SPACING_AUTO 0
/// Points on the surface that keep chords within `chord` at the middle and quarters; larger distances are possible
/// where nodes are far apart.
#define GUSSET_POINT_SPACING_CHORD 1
/// No points.
#define GUSSET_POINT_SPACING_CELL_EDGES 2
/// `points` points on the cubic through four crossings, near the surface, with the place of the crossing before. Fourth
/// order where crossings are evenly spaced.
#define GUSSET_POINT_SPACING_LEUS 3

/// Density of points on curves.
typedef struct gusset_contour_options {
    size_t struct_size;
    /// Above 0; at least the surface's tolerance applies.
    /// @when spacing GUSSET_POINT_SPACING_CHORD
    double chord;
    gusset_spacing_rule spacing;
    /// Points between two crossings, at most 1000.
    /// @when spacing GUSSET_POINT_SPACING_LEUS
    uint32_t points;
} gusset_contour_options;

/// The function whose contours are drawn.
typedef uint32_t gusset_contour_kind;
/// Signed distance from the plane through `point` with normal `direction`: sections by parallel planes.
#define GUSSET_CONTOUR_HEIGHT 0
/// Values at cell corners, interpolated like the surface.
#define GUSSET_CONTOUR_VALUES 1
/// Angle between the normal and `direction`: isophotes, at pi / 2 silhouettes seen along `direction`.
#define GUSSET_CONTOUR_ANGLE 2

/// A function on a surface. Fields name the kind that reads them, without prefix.
typedef struct gusset_contour_function {
    size_t struct_size;
    gusset_contour_kind kind;
    /// ANGLE. 1: opposite normals are equal.
    uint32_t unsigned_normals;
    /// HEIGHT: a point at height 0.
    double point[3];
    /// HEIGHT, ANGLE.
    double direction[3];
    /// VALUES: sheet after sheet, row after row, (rows + 1) x (columns + 1) each. A closing line is not read.
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
    /// Difference from the given angle; infinite, all else 0, if the surface lacks normals.
    double deviation;
    /// Lower bound of all deviations, within 1e-9 of it unless the proof fails.
    double bound;
} gusset_nearest_angle_report;

/// Draws contours of a function.
/// Curves are ordered by level, then lowest cell. Seen against the normals, the function increases to the left (angles
/// decrease): sections run along direction x normal.
/// Every curve is found, even within a cell; those within the tolerance in size are unresolved. On closed surfaces all
/// are closed.
/// Sections: corners on a plane count as above it.
/// - A plane that touches corners from below gives nothing.
/// - One that touches from above gives closed curves round the contact, however narrow: there and back along rows of
///   corners.
/// - Where one touches or contains the surface elsewhere within rounding, cells are unresolved.
/// Isophotes:
/// - At angles 0 and pi, paths are single points.
/// - Where normals jump between cells (patches, GUSSET_SCHEME_FOUR_POINT), curves follow sides.
/// - Poles that may have the angle are unresolved.
/// - Angles are third-order; GUSSET_CONTOUR_VALUES of cosines, fourth-order.
/// @param levels rising; angles 0 to pi, or pi/2 for unsigned normals.
/// @errors OUT_OF_RANGE (non-finite numbers, zero direction, levels, angle, chord, points), COUNT_DIFFERS (values),
///     TOO_LARGE (values; 2^32 points), NOT_FINITE (value)
/// @complexity About O(count + crossed cells), parallel; values: O(values); angles: O(cells) once.
/// @source Leus, tasks b and d.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_contours_create(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_contour_function *function, const double *levels,
    size_t count, const struct gusset_contour_options *options, struct gusset_surface_paths **paths);

/// Finds the normal with the angle to a direction nearest to a given one, proved to 1e-9.
/// @param direction where angles are 0.
/// @param angle 0 to pi, or pi/2 for unsigned normals.
/// @param unsigned_normals 1: opposite normals are equal.
/// @errors OUT_OF_RANGE
/// @complexity About O(cells with normals near the angle), parallel; O(cells) once.
/// @source Leus, task b.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_nearest_angle(const struct gusset_context *context,
    const struct gusset_surface *surface, const double *direction, double angle, uint32_t unsigned_normals,
    struct gusset_nearest_angle_report *report);

/*** Intersections of surfaces */

typedef struct gusset_intersection_options {
    size_t struct_size;
    /// Largest distance of the curve from its chords, above 0; rare chords exceed it by about 15 %. At least the
    /// smallest of `tolerance` and the surfaces' applies.
    /// @when spacing GUSSET_POINT_SPACING_CHORD
    double chord;
    /// Surfaces touch where their gap or overlap stays within it; 0: the surfaces' smaller tolerance.
    /// Self-intersections use at most the surface's. Branches shorter than all three may be lost.
    double tolerance;
    /// Not GUSSET_POINT_SPACING_LEUS; GUSSET_POINT_SPACING_AUTO refers to the smaller surface.
    gusset_spacing_rule spacing;
    uint32_t reserved;
} gusset_intersection_options;

/// Finds the curves in which two surfaces meet, or one meets itself.
/// Each curve is found once, and runs along N x N', the normals at `places` and `others`. Points and normals are the
/// first surface's; the second differs by rounding, at crossings within the tolerance.
/// Two surfaces: all branches are found, except
/// - branches shorter than the tolerance, or the surfaces' if smaller (near poles, four times that);
/// - branches within four times that length of another;
/// - parts within contacts and unresolved cells.
/// Open paths end at borders or in unresolved cells.
/// A point where surfaces touch or branches cross is a contact if proved:
/// - Near it, both surfaces are graphs over a plane.
/// - Their difference has definite (GUSSET_CONTACT_POINT) or indefinite (GUSSET_CONTACT_CROSSING) second derivatives.
/// - The gap is within the tolerance. A larger one leaves a loop, nothing, or two branches.
/// Within a contact's radius, at most about 4 sqrt(2 tolerance / c) for the least curvature c of the difference, loops
/// are omitted and paths run straight to its point. At a crossing, a path turns into the branch that closes it, if any.
/// Cells of the first surface are unresolved where
/// - surfaces coincide, or touch along a curve, at a pole or border, or to a higher order;
/// - the work limit is exceeded, as by branches 1e-4 of a cell apart, or nearly along cell sides of both.
/// There, curves may end, split or be missing, but join across a cell if a chord is as near to both surfaces as
/// elsewhere.
/// Self-intersections:
/// - Along a closed curve the pieces may swap: it ends at its first point with `places` and `others` exchanged. A seam
///   that turns the sheet over also reverses it.
/// - Common points of joined cells do not count. These share a side, corner or pole, or lie at opposite borders of a
///   sheet. Control points there are equal, in either order, to 64 roundings of the largest coordinate.
/// - Common borders of different sheets are intersections.
/// - Branches above the tolerance are found, except in unresolved cells: at pinches, creases and singular poles, and
///   where pieces touch or coincide.
/// - Curves stop before pinches, where pieces come within the tolerance (rough surfaces: tens of tolerances).
/// - Curves along cell sides may be in many parts.
/// - Contacts are not sought.
/// Exchanging the surfaces may change rounding and contacts proved.
/// @param other NULL: self-intersections; if `surface`, everything coincides.
/// @errors OUT_OF_RANGE (chord, tolerance), TOO_LARGE (above 2^26 pairs of cells)
/// @complexity Proportional to pairs of cells within the tolerance, and to points, about 1 / sqrt(chord); parallel. At
///     most 256 boxes of parameters for each pair, and 2^22 more in all. Self-intersections: also to cells, and n^2/2
///     for n cells round a pole.
/// @source Leus, task e.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_intersection_create(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_surface *other,
    const struct gusset_intersection_options *options, struct gusset_surface_paths **paths);

/*** Distances */

typedef uint32_t gusset_target_kind;
/// The line, ray or segment `line`.
#define GUSSET_TARGET_LINE 0
/// The plane through `point` with the normal `normal`.
#define GUSSET_TARGET_PLANE 1
/// The curve `curve`.
#define GUSSET_TARGET_CURVE 2
/// The surface `surface`.
#define GUSSET_TARGET_SURFACE 3

/// An object to measure from. Fields name the kind that reads them, without prefix.
typedef struct gusset_target {
    size_t struct_size;
    gusset_target_kind kind;
    uint32_t reserved;
    /// LINE.
    struct gusset_line line;
    /// PLANE.
    double point[3];
    /// PLANE.
    double normal[3];
    /// CURVE.
    const struct gusset_curve *curve;
    /// SURFACE.
    const struct gusset_surface *surface;
} gusset_target;

/// Properties of a distance.
/// @bits
typedef uint32_t gusset_distance_flags;
/// `bound` is within the tolerance of the distance, or 2^-45 of the greatest coordinate. Else the proof takes too long;
/// `bound` holds.
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
    /// Unit normal; at a pole its limit; 0 if undefined.
    double normal[3];
    /// The target's point.
    double other_point[3];
    /// Their distance.
    double distance;
    /// Proved lower bound of the distance.
    double bound;
    /// SURFACE: its place; else 0.
    struct gusset_surface_place other_place;
    /// CURVE: its place; else 0.
    struct gusset_place curve_place;
    /// LINE: its parameter. PLANE: signed distance, negative opposite to the normal. Else 0.
    double parameter;
    gusset_distance_flags flags;
    uint32_t reserved;
} gusset_distance_report;

/// Finds the nearest points of a surface and a target.
/// Among equally near pairs, the choice is deterministic. If much is equally near, the proof may fail. If a plane meets
/// the surface, the points lie on the section.
/// @param tolerance length to which the distance is proved; 0: the surface's, or the greater of two.
/// @errors OUT_OF_RANGE (tolerance; line; plane; curve too large), EMPTY_CURVE
/// @complexity About O(log cells), at most 50,000 pairs of pieces.
/// @source Leus, tasks c to e.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_distance(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_target *target, double tolerance,
    struct gusset_distance_report *report);

/*** Reports on surfaces */

/// Facts about a surface.
typedef struct gusset_surface_report {
    size_t struct_size;
    size_t sheet_count;
    /// Cells of all sheets.
    size_t cell_count;
    /// Corners of cells; nodes of sheets from nodes.
    size_t node_count;
    /// Bytes of the index, without nodes and cones.
    size_t index_bytes;
    /// Guaranteed accuracy, as in gusset_surface_options.
    double tolerance;
    /// Low corner of a box round surface and controls.
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

/*** Other sheets. Memory is 384 bytes a cell up to degree 3, else 1536. */

/// How a surface is made from a frame.
typedef uint32_t gusset_frame_surface;
/// The curves across. Between equal sections, one straight behind the other, the surface is their cylinder.
#define GUSSET_FRAME_SECTIONS 0
/// A grid through the nodes, or GUSSET_FRAME_CURVES if curves have corners.
#define GUSSET_FRAME_NODES 1
/// Gordon's surface, which contains all curves of the frame.
#define GUSSET_FRAME_CURVES 2

/// A tensor-product B-spline, rational (NURBS) if its weights differ.
/// Knots do not decrease; inner ones may repeat degree times.
/// - Open: control points + degree + 1 knots, clamped or not; defined from knot degree to knot count.
/// - Closed: control points + 1 knots, one period; control points are not repeated. Span k begins at knot k and uses
///   control points k - degree to k, cyclically.
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
    size_t knot_count_u;
    /// Knots in v.
    const double *knots_v;
    size_t knot_count_v;
    /// 1 to 7.
    uint32_t degree_u;
    /// 1 to 7.
    uint32_t degree_v;
    /// 1: closed in u.
    uint32_t closed_u;
    /// 1: closed in v.
    uint32_t closed_v;
    /// Above 0, at least 2^-900 of the greatest; NULL: all equal.
    const double *weights;
    /// Largest distance from a rational spline at equal parameters, at least about 1e-13 of the size. 0: 1e-12 of the
    /// controls' box diagonal, or more for rounding.
    double tolerance;
    /// Most cells of a rational spline; 0: 2^20.
    size_t max_cells;
} gusset_spline;

/// A net of curves: each row meets each column. Curves have any orientation, and are sorted by the places where they
/// meet unless in order.
typedef struct gusset_curve_net {
    size_t struct_size;
    /// Curves in v, of degree 7 at most; without columns, ordered by u. A curve of one point is a pole.
    const struct gusset_curve *const *rows;
    /// 0 (a skin of the columns), or at least 2, or 3 if closed_u.
    size_t row_count;
    /// Curves in u; without rows, ordered by v.
    const struct gusset_curve *const *columns;
    /// 0 (a skin of the rows), or at least 2, or 3 if closed_v.
    size_t column_count;
    /// Largest distance of curves that meet; both move to the middle. 0: 1e-6 of the box diagonal.
    double tolerance;
    /// 1: columns are closed; the first row follows the last.
    uint32_t closed_u;
    /// 1: rows are closed; the first column follows the last.
    uint32_t closed_v;
} gusset_curve_net;

/// Makes a sheet from Bézier patches.
/// Neighbours should share sides. Repeated points and poles are allowed.
/// @param points patch after patch, row after row; (degree_u + 1) x (degree_v + 1) each, v fastest.
/// @param degree_u 1 to 7.
/// @param degree_v 1 to 7.
/// @param rows at least 1.
/// @param columns at least 1.
/// @errors OUT_OF_RANGE (degree), EMPTY_MESH (no patches), NOT_FINITE
/// @complexity O(points).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_from_patches_create(const struct gusset_context *context,
    const double *points, uint32_t degree_u, uint32_t degree_v, size_t rows, size_t columns,
    struct gusset_sheet **sheet);

/// Makes a sheet from a B-spline surface. With equal weights, each non-empty knot span becomes an exact cell, up to
/// rounding.
/// gusset_sheet_get_report has the spline's parameters at 0, 1, 2, ... and the proved deviation.
/// If weights differ:
/// - Rows and columns of spans are divided into patches of degree 7 until the tolerance is proved.
/// - Values and first derivatives at cell corners are exact.
/// - Tangents are continuous across sides where the spline's are.
/// - A side of one point stays exactly one point.
/// @errors OUT_OF_RANGE (degree, tolerance, weight), NET_TOO_SMALL (too few control points), BAD_KNOTS (not finite,
///     decreasing, repeated too often, span too short to divide), TOO_LARGE (control points, cells), NOT_FINITE
/// @complexity O(spans x degree^3). Rational: O(cells x degree^2), parallel; 1536 bytes a cell, thrice during the call.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_from_spline_create(const struct gusset_context *context,
    const struct gusset_spline *spline, struct gusset_sheet **sheet);

/// Makes Gordon's surface of a net of curves, which contains them all.
/// Two rows and two columns give Coons's patch. Nodes are where a row and a column are nearest. If all rows have the
/// same number of segments between two nodes, these match in order; else all are cut at each joint, which adds cells.
/// Columns likewise.
/// It is C1 where curves are C1 over common knots without joints between nodes; elsewhere nearly (see
/// gusset_sheet_measure). Polylines keep creases.
/// @errors NET_TOO_SMALL, EMPTY_CURVE, OUT_OF_RANGE (degree, tolerance), CURVE_NOT_CLOSED, CURVES_APART (row, distance;
///     also out of order)
/// @complexity O(rows x columns x log segments + cells).
/// @source Gordon (1969).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_from_curves_create(const struct gusset_context *context,
    const struct gusset_curve_net *net, struct gusset_sheet **sheet);

/// Makes a grid through the corners of a sheet's cells, moved along their normals.
/// Normals point along S_u x S_v:
/// - Grids: from circles through neighbouring nodes; exact on planes, spheres, and round cylinders with rulings and
///   sections as grid lines.
/// - Patches: exact. The grid is smooth where patches had creases.
/// - A corner without a normal stays.
/// @param distances lengths of either sign.
/// @param distance_count 1: for all; rows + 1: for each line of corners along v; (rows + 1) x (columns + 1): for each
///     corner, row by row. A closing line counts, but moves with the first.
/// @param deviation largest deviation at cell middles from the sheet moved by the corners' mean distance, or NULL.
/// @errors COUNT_DIFFERS (distances), NOT_FINITE (distance or corner)
/// @complexity O(cells).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_offset_create(const struct gusset_context *context,
    const struct gusset_sheet *sheet, const double *distances, size_t distance_count, double *deviation,
    struct gusset_sheet **offset);

/// Makes the surface of a frame: u runs along the body, v round it, closed like the frame.
/// @errors NET_TOO_SMALL, OUT_OF_RANGE (degree above 7), CURVES_APART (nodes repeat or are out of order), NOT_FINITE
/// @complexity O(nodes).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_from_frame_create(const struct gusset_context *context,
    const struct gusset_frame *frame, gusset_frame_surface kind, struct gusset_sheet **sheet);

/*** Reports on sheets */

/// Facts about a sheet.
typedef struct gusset_sheet_report {
    size_t struct_size;
    /// Cells in u, which runs from 0 to rows.
    size_t rows;
    /// Cells in v, likewise.
    size_t columns;
    /// Degree of patches: 3 or 7.
    uint32_t degree;
    /// 1: stores nodes; 0: patches.
    uint32_t is_grid;
    /// 1: closed in u.
    uint32_t closed_u;
    /// 1: closed in v.
    uint32_t closed_v;
    /// 1: u = 0 is a pole, one point.
    uint32_t pole_u0;
    /// 1: u = rows is a pole.
    uint32_t pole_u1;
    /// 1: v = 0 is a pole.
    uint32_t pole_v0;
    /// 1: v = columns is a pole.
    uint32_t pole_v1;
    /// Bound of the distance from a rational spline at equal parameters, with rounding; else 0.
    double deviation;
    /// Spline: its rows + 1 rising parameters at u = 0, 1, ..., linear between.
    const double *knots_u;
    /// Spline: its columns + 1 parameters, likewise.
    const double *knots_v;
} gusset_sheet_report;

/// Reports on a sheet.
/// @complexity O(cells at sides).
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

/// Measures of a sheet (see gusset_cell_arrays); 0 unless requested.
typedef struct gusset_sheet_measures {
    size_t struct_size;
    /// Greatest of `diameters`.
    double diameter;
    /// Greatest of `intrinsic_diameters`.
    double intrinsic_diameter;
    /// Bound of absolute principal curvatures; infinite if not regular, as at poles.
    double curvature_bound;
    /// Largest angle between normals across cell sides; if smooth, 0 or rounding.
    double crease;
} gusset_sheet_measures;

/// Arrays of one number a cell; cell (i, j) has the index i * columns + j. NULL: not computed.
typedef struct gusset_cell_arrays {
    size_t struct_size;
    /// Length of each array, at least all cells.
    size_t capacity;
    /// Bounds of a cell's diameter.
    double *diameters;
    /// Bounds of the shortest curve in a cell between any two points.
    double *intrinsic_diameters;
    /// Estimates, not bounds, of the distance from the smooth surface that nodes sample, at equal parameters. Infinite
    /// below 5 nodes in a direction; 0 for patches.
    double *errors;
    /// Bounds of the distance from the bilinear patch of a cell's corners.
    double *bilinear;
    /// Bounds of the distance from a cell's two triangles, for either diagonal.
    double *triangles;
} gusset_cell_arrays;

/// Measures a sheet and its cells.
/// @param parts fields of `measures` to compute; 0: all.
/// @param cells NULL: none. Unchanged after an error.
/// @param measures NULL: none.
/// @errors BUFFER_TOO_SMALL (value: number of cells)
/// @complexity O(cells), parallel; 16 bytes a cell for each of diameters, errors and distances.
/// @source Leus, eqs. (1) and (7).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_measure(const struct gusset_context *context,
    const struct gusset_sheet *sheet, gusset_sheet_measure_flags parts, const struct gusset_cell_arrays *cells,
    struct gusset_sheet_measures *measures);

/*** Meshes of sheets */

/// Options of gusset_sheet_to_mesh. By default each cell becomes one quad.
typedef struct gusset_sheet_mesh_options {
    size_t struct_size;
    /// Largest distance of triangles from the surface, above 0; 0 or INFINITY: unlimited.
    double tolerance;
    /// Least parts of a cell in u; 0: 1.
    uint32_t min_u;
    /// Least parts of a cell in v; 0: 1.
    uint32_t min_v;
    /// 1: triangles only; 0: quads, with triangles at poles.
    uint32_t triangles;
    uint32_t reserved;
} gusset_sheet_mesh_options;

/// Places and normals of a sheet's mesh.
typedef struct gusset_sheet_mesh_report {
    size_t struct_size;
    size_t vertex_count;
    /// Place of each vertex, with sheet 0.
    const struct gusset_surface_place *places;
    /// Unit normal of each vertex; 0 if undefined.
    const double *normals;
    /// Bound of the distance between surface and triangles, for either diagonal of quads.
    double deviation;
} gusset_sheet_mesh_report;

/// Makes a sheet's mesh.
/// Cells of a row share the number of parts in u, cells of a column in v. Seams and poles are closed. Faces are
/// counter-clockwise seen against S_u x S_v. The mesh may lack faces.
/// @errors OUT_OF_RANGE (tolerance), TOO_LARGE (UINT32_MAX corners or more)
/// @complexity O(cells + vertices).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_to_mesh(const struct gusset_context *context,
    const struct gusset_sheet *sheet, const struct gusset_sheet_mesh_options *options, struct gusset_result **result);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_result_get_sheet_mesh(const struct gusset_result *result,
    struct gusset_sheet_mesh_report *report);

/*** Cells */

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

/// Lent cells. Regions lack `others`; pairs lack the fields below it.
typedef struct gusset_surface_cells_view {
    size_t struct_size;
    /// Cells by sheet, row, column. Pairs: cells of the first surface by both sheets, row, column.
    const struct gusset_surface_cell *cells;
    size_t cell_count;
    /// Cells of the second surface.
    const struct gusset_surface_cell *others;
    /// By cell: 1 if all of it is within the radius.
    const uint32_t *whole;
    /// A bit a cell, 1 in the region. Cell (i, j) of sheet k with c columns has bit b = first[k] + i * c + j: mask[b /
    /// 64] >> (b % 64) & 1.
    const uint64_t *mask;
    /// Words of the mask.
    size_t word_count;
    /// First bit of each sheet, then the number of bits.
    const uint64_t *first;
    size_t sheet_count;
} gusset_surface_cells_view;

/// Finds the cells with a point within a radius of a query.
/// No cell is missed; some lie outside by the tolerance, or more if bounded work cannot decide.
/// @param query a point.
/// @param radius at least 0; INFINITY: all cells.
/// @errors NOT_FINITE, OUT_OF_RANGE (radius, query)
/// @complexity O(cells found), and one bit a cell.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_region_create(const struct gusset_context *context,
    const struct gusset_surface *surface, const double *query, double radius, struct gusset_surface_cells **cells);

/// Finds the pairs of cells of two surfaces that may be within a distance.
/// No pair is missed; a few may be farther apart.
/// @param within 0: cells that may meet.
/// @errors OUT_OF_RANGE (within), TOO_LARGE (above 2^26 pairs)
/// @complexity Proportional to pairs and index levels; 24 bytes a pair.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_cell_pairs_create(const struct gusset_context *context,
    const struct gusset_surface *surface, const struct gusset_surface *other, double within,
    struct gusset_surface_cells **cells);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_surface_cells_get_view(const struct gusset_surface_cells *cells,
    struct gusset_surface_cells_view *view);

GUSSET_API void gusset_surface_cells_destroy(struct gusset_surface_cells *cells);

/*** Curves and surfaces */

/// Direction of a coordinate curve of a sheet.
typedef uint32_t gusset_sheet_direction;
/// Along rows: u is constant.
#define GUSSET_ALONG_ROWS 0
/// Along columns: v is constant.
#define GUSSET_ALONG_COLUMNS 1

/// Draws a curve through points, fourth-order, a cubic between neighbours.
/// @param nodes at least 2; closed at least 4, the last repeating the first.
/// @param closed 0 or 1.
/// @errors NET_TOO_SMALL (too few points), NOT_FINITE, CURVE_NOT_CLOSED
/// @complexity O(count).
/// @source V. Leus.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_through_create(const struct gusset_context *context,
    const double *nodes, size_t count, uint32_t closed, gusset_scheme scheme, struct gusset_curve **curve);

/// Makes an exact coordinate curve of a sheet, one segment a cell.
/// @param parameter the constant u or v, 0 to the cells in its direction.
/// @errors OUT_OF_RANGE (parameter)
/// @complexity O(cells along the curve).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_sheet_curve_create(const struct gusset_context *context,
    const struct gusset_sheet *sheet, gusset_sheet_direction along, double parameter, struct gusset_curve **curve);

/// Finds where a curve meets a line, or comes within a distance of it.
/// The result has minima of distance, or, if within is 0 and both lie in the plane z = 0, crossings and touches, each
/// once. `others` have segment 0 and the line's parameter as t.
/// @param within largest distance; in space raised to 1e-12 of the curve's size.
/// @param places overlaps stay within the distance or cannot be separated.
/// @errors EMPTY_CURVE, OUT_OF_RANGE (within; line not finite or without direction)
/// @complexity Bounded for segments whose boxes meet the line.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_intersect_line_create(const struct gusset_context *context,
    const struct gusset_curve *curve, const struct gusset_line *line, double within, struct gusset_places **places);

#ifdef __cplusplus
}
#endif
#endif
