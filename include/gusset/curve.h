/* Generated from src/capi; see gusset.h. */

#ifndef GUSSET_CURVE_H
#define GUSSET_CURVE_H
#include "base.h"
#include "mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/*** Curves */

/// A curve of Bézier segments.
typedef struct gusset_curve gusset_curve;

/// A place on a curve.
typedef struct gusset_place {
    /// Index of the segment.
    uint32_t segment;
    uint32_t reserved;
    /// Parameter, from 0 at the segment's start to 1 at its end.
    double t;
} gusset_place;

typedef struct gusset_curve_view {
    size_t struct_size;
    /// Control points; z is 0 for a plane curve.
    const double *controls;
    size_t control_count;
    /// Segment k has the controls ends[k] to ends[k + 1].
    struct gusset_indices ends;
    /// 1 if closed.
    uint32_t closed;
    uint32_t reserved;
} gusset_curve_view;

/// Makes a curve from its control points.
/// Degrees are 1 to 64.
/// @param controls x, y or x, y, z of each.
/// @param control_count at most 2^30; 0: no segments, and ends is {0}.
/// @param dimension 2 or 3.
/// @param ends 0, then the rising index of each segment's last control point, up to control_count - 1.
/// @param end_count segments + 1.
/// @param closed 1: the last control point repeats the first.
/// @errors BAD_OFFSETS, OUT_OF_RANGE (dimension, degree), NOT_FINITE, CURVE_NOT_CLOSED
/// @complexity O(points).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_create(const struct gusset_context *context,
    const double *controls, size_t control_count, uint32_t dimension, const uint32_t *ends, size_t end_count,
    uint32_t closed, struct gusset_curve **curve);

GUSSET_API void gusset_curve_destroy(struct gusset_curve *curve);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_get_view(const struct gusset_curve *curve,
    struct gusset_curve_view *view);

/*** Options of outlines */

typedef uint32_t gusset_curve_kind;
/// Quadratic segments, G1, one control point for each point.
#define GUSSET_CURVE_KIND_COMPOSITE 0
/// One Bézier curve, for up to about 20 points. Its degree is n through n + 1 points, plus 1 an end tangent; closed, n
/// + 2 through n points, with a smooth seam. Above degree 64, it is composite.
#define GUSSET_CURVE_KIND_SINGLE 1
/// Cubic segments that blend adjacent sections linearly: C1 in the knots of the method's exponent, G1 with
/// GUSSET_METHOD_NORMAL. GUSSET_METHOD_BISECTOR gives the centripetal Catmull-Rom spline.
#define GUSSET_CURVE_KIND_BLEND_C1 2
/// Quintic segments that blend adjacent sections smoothly: C2, G2 with GUSSET_METHOD_NORMAL. At inner points with given
/// tangents only C1 or G1.
#define GUSSET_CURVE_KIND_BLEND_C2 3
/// Cubic spline, C2 in the knots of the method's exponent. At inner points with given tangents only C1.
#define GUSSET_CURVE_KIND_CUBIC_C2 4
/// Nadopta's chain: GUSSET_CURVE_KIND_COMPOSITE with GUSSET_LOCK_DATA_GUIDE, regardless of `lock`.
#define GUSSET_CURVE_KIND_CHAIN 5

/// Guide of a section's control point.
/// A section is the quadratic through a point and its neighbours; its guide is a line from the point to their chord.
/// With GUSSET_LOCK_DATA_GUIDE, and for separate sections, the control point lies on the guide. Other locks use only
/// its parameter.
typedef uint32_t gusset_section_method;
/// The bisector of the angle at the point; always defined.
#define GUSSET_METHOD_BISECTOR 0
/// The median; always defined.
#define GUSSET_METHOD_MEDIAN 1
/// The normal of the chord. If its foot is outside the chord, the bisector applies (GUSSET_LOCK_SELF_CONSISTENT: the
/// chord's nearer end).
#define GUSSET_METHOD_NORMAL 2
/// The symmedian; always defined.
#define GUSSET_METHOD_SYMMEDIAN 3
/// Parameter a^alpha / (a^alpha + b^alpha) for the distances a, b from the neighbours: median at alpha = 0, bisector at
/// 1/2, symmedian at 1.
#define GUSSET_METHOD_ALPHA 4

/// Rule for the parameters of points.
typedef uint32_t gusset_parameter_lock;
/// The method's parameter on the triangle of the given points. Always solvable, with control points near the guides.
#define GUSSET_LOCK_PARAMETER 0
/// The method's parameter on the section's own triangle. With the normal, solutions depend on the solver.
#define GUSSET_LOCK_SELF_CONSISTENT 1
/// Controls on the guides of the given points' triangles, where possible. In outlines that are not planar, points get
/// GUSSET_POINT_OUT_OF_PLANE and GUSSET_LOCK_PARAMETER.
#define GUSSET_LOCK_DATA_GUIDE 2

/// Positions of joints of composite curves.
typedef uint32_t gusset_joint_parameter;
/// Midpoints between control points.
#define GUSSET_JOINT_PARAMETER_HALF 0
/// From chords to the power of the method's exponent: the quadratic B-spline in these knots, C1.
#define GUSSET_JOINT_PARAMETER_KNOT 1
/// Continuous curvature, by cubic segments in the triangles of the quadratics; 0 at inflections of the control polygon.
/// In outlines that are not planar, only magnitudes agree, and points get GUSSET_POINT_OUT_OF_PLANE.
#define GUSSET_JOINT_PARAMETER_G2 2

typedef uint32_t gusset_outline_solver;
/// Closed forms and Newton's method.
#define GUSSET_SOLVER_FAST 0
/// Nadopta's steps along the guide, refined where the deviation changes sign.
#define GUSSET_SOLVER_STEP 1

typedef uint32_t gusset_outline_ends;
/// From the first and last sections.
#define GUSSET_ENDS_FREE 0
/// Perpendicular to the first chord (first to third point) and to the last.
#define GUSSET_ENDS_PERPENDICULAR 1
/// Parallel to the x-axis, in the sense of first and last legs.
#define GUSSET_ENDS_LEVEL 2
/// Parallel to the y-axis, likewise.
#define GUSSET_ENDS_UPRIGHT 3
/// Level or upright, whichever is nearer to GUSSET_ENDS_PERPENDICULAR.
#define GUSSET_ENDS_LEVEL_OR_UPRIGHT 4

/// Outcome at a point of an outline.
typedef uint32_t gusset_point_status;
/// All demands are met.
#define GUSSET_POINT_OK 0
/// The parameter was clamped to its limits.
#define GUSSET_POINT_CLAMPED_PARAMETER 1
/// Omitted: it repeats an earlier point (or, at a closed outline's end, the first) within the tolerance.
#define GUSSET_POINT_MERGED 2
/// Too near an end of its section for the method; the median was used.
#define GUSSET_POINT_REPEATED 3
/// Its triangle is flat and lacks a guide or a perpendicular.
#define GUSSET_POINT_COLLINEAR 4
/// The normal's foot is outside the chord; the bisector was used.
#define GUSSET_POINT_NORMAL_OUTSIDE 5
/// The normal's foot is an end of the chord; the bisector was used.
#define GUSSET_POINT_RIGHT_ANGLE 6
/// The curve does not cross the guide.
#define GUSSET_POINT_NO_CROSSING 7
/// The tangent separates points that should be on one side.
#define GUSSET_POINT_TANGENT_SEPARATES 8
/// The curve would run backwards along the tangent.
#define GUSSET_POINT_TANGENT_BACKWARD 9
/// No quadratic reaches the tangent: the point is farther from it than the section's end.
#define GUSSET_POINT_TANGENT_BEYOND 10
/// The tangent is outside the section's plane, or GUSSET_LOCK_DATA_GUIDE or GUSSET_JOINT_PARAMETER_G2 requires a planar
/// outline.
#define GUSSET_POINT_OUT_OF_PLANE 11
/// The tangent is zero and was omitted.
#define GUSSET_POINT_NO_TANGENT 12
/// The lock failed; GUSSET_LOCK_PARAMETER was used.
#define GUSSET_POINT_FELL_BACK 13
/// The iteration did not converge.
#define GUSSET_POINT_NOT_CONVERGED 14
/// The curve misses it: too few distinct points, or equations without solution.
#define GUSSET_POINT_MISSED 15
/// An adjacent joint has the midpoint of its control points, or curvature 0 with GUSSET_JOINT_PARAMETER_G2.
#define GUSSET_POINT_JOINT_FELL_BACK 16
/// The single curve failed; a composite curve was used.
#define GUSSET_POINT_COMPOSITE_INSTEAD 17
/// A blended curve has a cusp here.
#define GUSSET_POINT_CUSP 18
/// The curve crosses itself here although the points do not. A part between two points crosses itself (status at both),
/// the next part (at the point between), the one after (at both points between), or the parts around a run of close
/// points (at all of these). The last two do not count if the polygon turns by a half turn or more. Loops below a
/// twentieth of a part may be missed. In space, a loop's ends are at most a twentieth of its size apart. The bisector
/// avoids most loops, and repeat_tolerance merges close points.
#define GUSSET_POINT_LOOPED 19
/// The distance to the next or previous point is below a hundredth of both distances beside it, or below a
/// ten-thousandth of one. The curve may turn there in any way. `repeat_tolerance` merges such points.
#define GUSSET_POINT_CROWDED 20

typedef uint32_t gusset_fit_status;
/// All demands are met.
#define GUSSET_FIT_OK 0
/// Some points have a status other than OK, merged, clamped, looped or crowded.
#define GUSSET_FIT_PARTIAL 1
/// The iteration did not converge.
#define GUSSET_FIT_NOT_CONVERGED 2
/// The iteration diverged, or control points overflow.
#define GUSSET_FIT_DIVERGED 3
/// The equations are nearly singular; control points lie far outside the outline.
#define GUSSET_FIT_ILL_CONDITIONED 4
/// Fewer than 2 distinct points, or 3 if closed: the curve is empty or fits two points.
#define GUSSET_FIT_TOO_FEW_POINTS 5
/// A single curve would exceed degree 64; a composite curve was used.
#define GUSSET_FIT_DEGREE_TOO_HIGH 6

/// Options of curves through outlines. Lengths are relative to the longest side of the outline's box.
typedef struct gusset_outline_options {
    size_t struct_size;
    gusset_curve_kind curve;
    gusset_section_method method;
    /// For composite and single curves.
    gusset_parameter_lock lock;
    /// For composite curves and chains.
    gusset_joint_parameter joint;
    gusset_outline_solver solver;
    /// For open outlines and parts between corners, without constraints.
    gusset_outline_ends ends;
    /// 0 to 1.
    /// @when method GUSSET_METHOD_ALPHA
    double alpha;
    /// Composite parameters are clamped to this and 1 - this: at least 0.001, below 1/2; 0: 0.01, or 1/12 with
    /// GUSSET_JOINT_PARAMETER_G2.
    double parameter_limit;
    /// Largest distance of merged neighbours, below 1; 0: 1e-12. 1e-300 merges equal points only.
    double repeat_tolerance;
    /// Points where the polygon turns by more are corners; at least 0; 0, or pi and more: none.
    double corner_angle;
    /// Iterations end when moves are within it; below 1; 0: 1e-12.
    double tolerance;
    /// Most sweeps or iterations between corners; 0: 200. If they do not converge, their replacement iterates further.
    uint32_t max_sweeps;
    /// Most steps at a point in a sweep; 0: 20,000.
    uint32_t max_steps;
    /// 1: keeps the cycles for gusset_outline_get_history.
    uint32_t history;
    uint32_t reserved;
} gusset_outline_options;

/*** Outlines */

/// Demand on a curve at a point.
typedef uint32_t gusset_constraint_kind;
/// Direction `tangent`, not 0.
#define GUSSET_CONSTRAINT_TANGENT 0
/// A corner is allowed.
#define GUSSET_CONSTRAINT_CORNER 1
/// Direction at the angle tangent[0], counter-clockwise from the x-axis in the xy plane.
#define GUSSET_CONSTRAINT_TANGENT_ANGLE 2

/// A constraint at a point.
typedef struct gusset_constraint {
    /// Point, counted over all outlines.
    uint32_t point;
    gusset_constraint_kind kind;
    /// A vector (z = 0 in plane outlines), or angle, 0, 0.
    double tangent[3];
} gusset_constraint;

/// Outlines in the caller's arrays.
typedef struct gusset_outlines {
    size_t struct_size;
    /// Doubles x, y or x, y, z.
    const void *points;
    size_t point_stride;
    /// Points of all outlines, at most 2^30.
    size_t point_count;
    /// Offsets into points, by outline. NULL with outline_count 0: one outline.
    const uint32_t *offsets;
    size_t outline_count;
    /// Ascending by point, at most one each; or NULL. The first of merged points counts.
    const struct gusset_constraint *constraints;
    size_t constraint_count;
    /// 2 or 3.
    uint32_t dimension;
    /// 1: outlines return to their first points, which may be repeated at the end.
    uint32_t closed;
} gusset_outlines;

/// Curves through outlines.
typedef struct gusset_outline gusset_outline;

/// Lent curves.
/// Curve k has the controls starts[2k] to starts[2k + 2] - 1, and the ends starts[2k + 1] to starts[2k + 3] - 1. Its
/// segment s has controls ends[s] to ends[s + 1], counted from the curve's first. A closed curve repeats its first
/// control at the end.
typedef struct gusset_outline_view {
    size_t struct_size;
    size_t outline_count;
    size_t point_count;
    /// Control points; z = 0 for plane outlines.
    const double *controls;
    size_t control_count;
    /// Ends of segments.
    struct gusset_indices ends;
    /// Two offsets a curve, and two more.
    const size_t *starts;
    /// Segment of each point.
    struct gusset_indices segments;
    /// Parameter of each point, 0 to 1.
    const double *parameters;
    /// gusset_point_status of each point.
    const uint8_t *statuses;
} gusset_outline_view;

/// Outcome and accuracy of an outline. Lengths except `size` are relative to `size`.
typedef struct gusset_outline_report {
    size_t struct_size;
    gusset_fit_status fit;
    /// Most sweeps or iterations between corners, at most max_sweeps. A replacement of a solver that fails does not
    /// count.
    uint32_t iterations;
    /// Steps of GUSSET_SOLVER_STEP.
    uint64_t steps;
    /// Longest side of the outline's box.
    double size;
    /// Largest distance of a point from the curve at its parameter; merged points count as their originals.
    double max_residual;
    /// Largest sine of the angle between tangents at a smooth joint.
    double max_joint_sine;
    /// GUSSET_JOINT_PARAMETER_G2: largest difference of curvatures at a joint, relative to the larger, at least to 1 /
    /// size. Else 0.
    double max_curvature_gap;
    /// Largest move of a control point in the last iteration.
    double last_move;
    /// Points that are not GUSSET_POINT_OK.
    uint32_t not_ok_count;
    uint32_t reserved;
} gusset_outline_report;

/// A cycle of an iteration: a sweep over the points, or an iteration of Newton's method.
typedef struct gusset_outline_cycle {
    /// Largest move of a control point, relative to the size of the outline.
    double moved;
    /// Steps of GUSSET_SOLVER_STEP up to the end of this cycle.
    uint64_t steps;
    /// Number of control points of this cycle and all earlier ones.
    uint64_t control_end;
} gusset_outline_cycle;

/// Lent cycles of an outline, in order, from corner to corner. Cycles of a start or a replacement of the solver are
/// left out.
typedef struct gusset_outline_history {
    size_t struct_size;
    /// The cycles.
    const struct gusset_outline_cycle *cycles;
    /// Number of cycles; 0 unless the option history was 1. Without corners, at most the iterations of the report: an
    /// iteration that fails has no cycle.
    size_t cycle_count;
    /// Control points after each cycle. A single curve has all its own, also if a composite curve replaces it. A
    /// composite curve has one for each distinct point; at open ends, the point or the control point on the end's
    /// tangent.
    const double *controls;
    size_t control_count;
} gusset_outline_history;

/// Fits a Bézier curve through the points of each outline.
/// Constraints that cannot be met show in statuses; the curve still passes through the point if possible.
/// @errors OUT_OF_RANGE (option, dimension), BAD_STRIDE, BAD_OFFSETS, NOT_FINITE (point), NO_SUCH_ELEMENT (constraint:
///     no such point, or out of order)
/// @complexity O(points) for composite, blended and cubic curves. GUSSET_JOINT_PARAMETER_G2: about 1,500 bytes a point
///     of the largest outline.
/// @source T. Nadopta.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_outline_create(const struct gusset_context *context,
    const struct gusset_outlines *outlines, const struct gusset_outline_options *options,
    struct gusset_outline **outline);

GUSSET_API void gusset_outline_destroy(struct gusset_outline *outline);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_outline_get_view(const struct gusset_outline *outline,
    struct gusset_outline_view *view);

/// Reports on one outline.
/// @errors NO_SUCH_ELEMENT
GUSSET_API GUSSET_MUST_USE gusset_status gusset_outline_get_report(const struct gusset_outline *outline, size_t index,
    struct gusset_outline_report *report);

/// Lends the cycles of one outline.
/// @errors NO_SUCH_ELEMENT
GUSSET_API GUSSET_MUST_USE gusset_status gusset_outline_get_history(const struct gusset_outline *outline, size_t index,
    struct gusset_outline_history *history);

/// Copies the curve of one outline.
/// @errors NO_SUCH_ELEMENT
/// @complexity O(segments).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_outline_curve_create(const struct gusset_context *context,
    const struct gusset_outline *outline, size_t index, struct gusset_curve **curve);

/// Finds the section of each point, with its control point on the method's guide.
/// A tangent constraint sets the section's direction at its point; at an open end, the neighbour's section there. If it
/// fails, the method applies; if the normal fails, the bisector. The status says so. Outputs may be NULL.
/// @param options all valid; only method, alpha and solver are read, with GUSSET_SOLVER_STEP also tolerance and
///     max_steps.
/// @param controls control points; at open ends, the points.
/// @param parameters each point's parameter on its section; at open ends, 0 and 1.
/// @param statuses gusset_point_status of each point.
/// @param steps number of steps of GUSSET_SOLVER_STEP.
/// @errors as gusset_outline_create
/// @complexity O(n); no memory.
/// @source Nadopta; B = P + (P - S) / (2 sqrt(s (1 - s))) for the foot S = A + s (C - A) of the guide.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_outlines_find_sections(const struct gusset_context *context,
    const struct gusset_outlines *outlines, const struct gusset_outline_options *options, double *controls,
    double *parameters, uint8_t *statuses, uint64_t *steps);

/*** Measures of curves */

/// Nearest point of a curve.
typedef struct gusset_curve_nearest_point {
    /// Place on the curve.
    struct gusset_place place;
    /// x, y, z.
    double point[3];
    /// Distance; infinite if it overflows.
    double distance;
} gusset_curve_nearest_point;

/// Measures of a curve.
/// @bits
typedef uint32_t gusset_curve_measure_flags;
/// `length`.
#define GUSSET_CURVE_MEASURE_LENGTH 1
/// `low` and `high`; undefined without points.
#define GUSSET_CURVE_MEASURE_BOUNDS 2
/// `centre`; undefined without points.
#define GUSSET_CURVE_MEASURE_CENTRE 4
/// `area_vector` and `area`.
#define GUSSET_CURVE_MEASURE_AREA 8
/// `centroid` and `second`; only for a curve with points in the plane z = 0, and unless they overflow.
#define GUSSET_CURVE_MEASURE_MOMENTS 16

/// Measures of a curve. A chord closes open curves.
typedef struct gusset_curve_measures {
    size_t struct_size;
    /// Present measures; all else is 0.
    gusset_curve_measure_flags defined;
    uint32_t reserved;
    /// Arc length without the chord.
    double length;
    /// Low corner of the bounding box.
    double low[3];
    /// High corner.
    double high[3];
    /// Mean of the points by arc length.
    double centre[3];
    /// Half the integral of r x dr; in the plane z = 0, (0, 0, signed area), negative if clockwise.
    double area_vector[3];
    /// Length of area_vector: area of the largest shadow.
    double area;
    /// Centroid of the region, or the start if the area is 0.
    double centroid[2];
    /// Integrals of x x, x y and y y about it, with the area's sign.
    double second[3];
} gusset_curve_measures;

/// Computes points, derivatives, tangents and curvatures at places.
/// NULL outputs are not computed. After an error, nothing is written.
/// @param order highest derivative, 0 to 64, for `derivatives`.
/// @param derivatives 3 (order + 1) count numbers: for each place the point, then derivatives by t, 0 beyond the
///     degree.
/// @param tangents count unit tangents; 0 on a segment without extent.
/// @param curvatures count numbers, 1 / radius; positive if a plane segment turns from x to y, infinite where the first
///     derivative is 0.
/// @errors NO_SUCH_ELEMENT (place), OUT_OF_RANGE (order)
/// @complexity O(degree^2) a place and output.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_evaluate(const struct gusset_context *context,
    const struct gusset_curve *curve, const struct gusset_place *places, size_t count, uint32_t order,
    double *derivatives, double *tangents, double *curvatures);

/// Finds the nearest point for each query.
/// @param points x, y, z each.
/// @param out count answers.
/// @errors EMPTY_CURVE, NOT_FINITE
/// @complexity About O(log segments + degree^2) a point, parallel.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_nearest(const struct gusset_context *context,
    const struct gusset_curve *curve, const double *points, size_t count, struct gusset_curve_nearest_point *out);

/// Computes arc lengths from the start to places.
/// @param out count lengths.
/// @errors NO_SUCH_ELEMENT (place)
/// @complexity O(points) in all.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_lengths_at(const struct gusset_context *context,
    const struct gusset_curve *curve, const struct gusset_place *places, size_t count, double *out);

/// Finds the places at arc lengths from the start, clamped to the ends.
/// @param out count places.
/// @param lengths arc lengths.
/// @errors EMPTY_CURVE, OUT_OF_RANGE (NaN)
/// @complexity O(points + count log segments).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_places_at(const struct gusset_context *context,
    const struct gusset_curve *curve, const double *lengths, size_t count, struct gusset_place *out);

/// Measures a curve.
/// The length is accurate to 1e-13, the centre comes from 16 chords a segment. Else, and lengths up to degree 2,
/// measures are exact up to rounding.
/// @param flags 0: all.
/// @errors OUT_OF_RANGE (a measure overflows: the largest coordinate)
/// @complexity O(points) for length and bounds, else O(sum of degree^2).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_measure(const struct gusset_context *context,
    const struct gusset_curve *curve, gusset_curve_measure_flags flags, struct gusset_curve_measures *measures);

/*** Intersections of curves */

/// Places on one or two curves.
typedef struct gusset_places gusset_places;

typedef struct gusset_places_view {
    size_t struct_size;
    /// Places, ordered along the first curve.
    const struct gusset_place *places;
    size_t count;
    /// Points at the places.
    const double *points;
    /// Intersections: places on the second curve, or later on the same. Else NULL.
    const struct gusset_place *others;
    /// Common parts, four places each: start and end on the first curve, then on the second (tangent angles: the
    /// first).
    const struct gusset_place *overlaps;
    size_t overlap_count;
    /// Segments in the plane or line.
    struct gusset_indices inside;
    /// 1: segments that agree within rounding over long parts were not resolved.
    uint32_t undecided;
    uint32_t reserved;
} gusset_places_view;

typedef uint32_t gusset_sample_rule;
/// `amount` points at equal arc lengths.
#define GUSSET_SAMPLE_COUNT 0
/// A point every `amount` of arc length, and the end of an open curve.
#define GUSSET_SAMPLE_STEP 1
/// Chords within `amount` of the curve. Segments are halved at most 20 times, to 1e-12 of their size.
#define GUSSET_SAMPLE_CHORD 2

/// Finds where a curve crosses or touches a plane.
/// For a line along (x, y) in z = 0, the normal is (-y, x, 0).
/// @param point of the plane.
/// @param normal of the plane.
/// @errors OUT_OF_RANGE (normal), NOT_FINITE
/// @complexity O(points + degree^2 crossings).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_intersect_plane_create(const struct gusset_context *context,
    const struct gusset_curve *curve, const double *point, const double *normal, struct gusset_places **places);

/// Finds where two curves meet or come within a distance, or a plane curve meets itself.
/// The result has local minima of the distance, or, if within is 0 and both curves are plane, crossings and touches,
/// each once. Joints are not self-intersections.
/// @param other NULL: self-intersections.
/// @param within largest distance, 0 if other is NULL; in space raised to 1e-12 of the curves' size.
/// @param places overlaps stay within the distance, or cannot be separated.
/// @errors OUT_OF_RANGE (within), CURVE_NOT_PLANE (other is NULL), EMPTY_CURVE (in space, or within is not 0)
/// @complexity Bounded for pairs of segments whose boxes are within the distance.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_intersect_create(const struct gusset_context *context,
    const struct gusset_curve *curve, const struct gusset_curve *other, double within, struct gusset_places **places);

/// Finds where a curve's tangent makes an angle with a direction.
/// Each point is found once. At a cusp, tangents on both sides count, to 1e-6; at a joint, of both segments, not
/// between. Angles within 1e-7 of 0, pi/2 and pi snap to them; parallel and opposite tangents are so to 1e-9.
/// @param direction a vector.
/// @param angle 0 to pi.
/// @param places overlaps have a constant angle.
/// @errors OUT_OF_RANGE (direction, angle), NOT_FINITE (direction)
/// @complexity O(points + degree^2 places).
/// @source Leus, task b, for curves.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_tangent_angle_create(const struct gusset_context *context,
    const struct gusset_curve *curve, const double *direction, double angle, struct gusset_places **places);

/// Samples points along a curve. A closed curve's start is not repeated.
/// @param amount a whole number (at least 1, for an open curve 2), or a length above 0.
/// @errors EMPTY_CURVE, OUT_OF_RANGE (amount)
/// @complexity O(points + samples).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_sample_create(const struct gusset_context *context,
    const struct gusset_curve *curve, gusset_sample_rule rule, double amount, struct gusset_places **places);

GUSSET_API void gusset_places_destroy(struct gusset_places *places);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_places_get_view(const struct gusset_places *places,
    struct gusset_places_view *view);

/*** Curves from curves */

typedef struct gusset_offset_options {
    size_t struct_size;
    /// Wanted deviation, above 0.
    double tolerance;
    /// Halving stops at this many segments; 0: 65536.
    size_t max_segments;
    /// Degree of segments, 2 or 3; 0: 3.
    uint32_t degree;
    uint32_t reserved;
} gusset_offset_options;

/// Accuracy of an offset.
typedef struct gusset_offset_report {
    size_t struct_size;
    /// Largest distance from the true offset, at 16 places a segment.
    double deviation;
    /// Corners of the original, bridged straight.
    size_t corners;
    /// 1: the deviation is within the tolerance.
    uint32_t reached;
    /// 1: a radius of curvature is at most the distance: the offset has cusps or runs backwards.
    uint32_t tight;
} gusset_offset_report;

/// Cuts an open part out of a curve.
/// On a closed curve the part may pass the start; if from equals to, it is the whole. A curve ends at its last segment,
/// t = 1.
/// @errors NO_SUCH_ELEMENT (0: from, 1: to), OUT_OF_RANGE (to precedes from on an open curve)
/// @complexity O(points).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_part_create(const struct gusset_context *context,
    const struct gusset_curve *curve, struct gusset_place from, struct gusset_place to, struct gusset_curve **part);

/// Reverses a curve.
/// @complexity O(points).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_reverse_create(const struct gusset_context *context,
    const struct gusset_curve *curve, struct gusset_curve **reversed);

/// Raises and lowers degrees of segments.
/// Raising is exact. Lowering is a least-squares fit with fixed ends.
/// @param lowest least degree, 1 to 64.
/// @param highest greatest degree, lowest to 64.
/// @param tolerance largest deviation of lowered segments; at least 0, or INFINITY.
/// @param deviations a bound of each segment's deviation; if it is not lowered, the deviation lowering would cause. May
///     be NULL.
/// @errors OUT_OF_RANGE (degree, tolerance)
/// @complexity O(degree) a raised control point, O(degree^3) a lowered segment.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_change_degree_create(const struct gusset_context *context,
    const struct gusset_curve *curve, uint32_t lowest, uint32_t highest, double tolerance, double *deviations,
    struct gusset_curve **changed);

/// Fits the offset of a plane curve by segments with common tangents.
/// Self-intersections are not removed.
/// @param distance to the left; right if negative.
/// @param options required; its tolerance must be set.
/// @param report may be NULL.
/// @errors CURVE_NOT_PLANE, EMPTY_CURVE, OUT_OF_RANGE (distance, tolerance, degree)
/// @complexity O(degree) a measured place.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_offset_create(const struct gusset_context *context,
    const struct gusset_curve *curve, double distance, const struct gusset_offset_options *options,
    struct gusset_offset_report *report, struct gusset_curve **offset);

/*** Curves in other forms */

typedef uint32_t gusset_curve_format;
/// SVG path data (M, L, Q, C, Z), for plane curves up to degree 3. Numbers are exact; y is not flipped.
#define GUSSET_CURVE_FORMAT_SVG 0
/// TrueType contour, for closed plane curves up to degree 2: controls, and joints not midway between two.
#define GUSSET_CURVE_FORMAT_CONTOUR 1
/// Clamped B-spline, for curves of one degree n. Smooth joints become knots of multiplicity n - 1 without controls.
#define GUSSET_CURVE_FORMAT_SPLINE 2

/// An exported curve.
typedef struct gusset_curve_form gusset_curve_form;

/// Lent parts of an exported curve; other formats' are empty.
typedef struct gusset_curve_form_view {
    size_t struct_size;
    /// SVG path, zero-terminated.
    const char *text;
    /// Length without the final 0.
    size_t text_length;
    /// Points of a contour, controls of a spline.
    const double *points;
    size_t point_count;
    /// Contour: 1 for a point on the curve.
    const uint8_t *on_curve;
    /// Spline: point_count + degree + 1 knots.
    const double *knots;
    size_t knot_count;
    /// Spline: degree.
    size_t degree;
} gusset_curve_form_view;

/// Exports a curve.
/// @param tolerance for contours: omits joints within it of the middle, besides rounding; at least 0.
/// @errors CURVE_NOT_PLANE (not for splines), CURVE_NOT_CLOSED (contours), EMPTY_CURVE (not for SVG), OUT_OF_RANGE
///     (tolerance; degree, see gusset_curve_change_degree_create)
/// @complexity O(points).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_export_create(const struct gusset_context *context,
    const struct gusset_curve *curve, gusset_curve_format format, double tolerance, struct gusset_curve_form **form);

GUSSET_API void gusset_curve_form_destroy(struct gusset_curve_form *form);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_form_get_view(const struct gusset_curve_form *form,
    struct gusset_curve_form_view *view);

/*** Frames */

typedef uint32_t gusset_correspondence_rule;
/// By index; all sections have the same number of points.
#define GUSSET_CORRESPONDENCE_GIVEN 0
/// Equal arc lengths of each section, or between corners. A corner of one section has a node on all. Closed sections
/// start where the twist is least, and are reversed if opposite to the previous one; open ones run from first to last
/// point.
#define GUSSET_CORRESPONDENCE_ARC_LENGTH 1
/// Half-planes at equal angles round the axis; the farthest crossing of several.
#define GUSSET_CORRESPONDENCE_ANGLE 2
/// Landmarks of each section, and equal arc lengths between them.
#define GUSSET_CORRESPONDENCE_LANDMARKS 3

/// A grid of nodes on a body, with curves across its rows and along its columns.
typedef struct gusset_frame gusset_frame;

typedef uint32_t gusset_offset_direction;
/// Along normals of the body.
#define GUSSET_OFFSET_NORMAL 0
/// In the planes of sections.
#define GUSSET_OFFSET_IN_SECTION 1

/// Options of gusset_frame_create. By default the points are the nodes. Fields name values of `correspondence` without
/// prefix.
typedef struct gusset_frame_options {
    size_t struct_size;
    gusset_correspondence_rule correspondence;
    /// ANGLE: nodes in each section. ARC_LENGTH: likewise, more if sections have more corners. LANDMARKS: parts between
    /// two landmarks.
    uint32_t columns;
    /// 1: the first section follows the last.
    uint32_t ring;
    /// ARC_LENGTH. 1: closed sections start at their first points, or the corner after the first section's.
    uint32_t given_starts;
    /// 1: only constraints make corners. 0: sections also have corners where they turn by more than `corner_angle` of
    /// `across`. If this is pi (not with ANGLE), corners are all points of polygons, and points that turn by 40 degrees
    /// and far more than usual. Polygons are closed sections of at most 6 points, and sections that turn by more than
    /// 54 or less than 6 degrees at points.
    uint32_t smooth_corners;
    uint32_t reserved;
    /// ANGLE: a point of the axis.
    double axis_point[3];
    /// ANGLE: direction of the axis; angles are right-handed about it.
    double axis_direction[3];
    /// ANGLE: direction of column 0, not parallel to the axis (at its first point if bent).
    double reference[3];
    /// ANGLE: a point of a bent axis for each section, in place of axis_point and axis_direction. The axis follows
    /// circles through three points each; the reference does not rotate about it. NULL: straight.
    const double *axis_points;
    size_t axis_point_count;
    /// LANDMARKS: for each section the same number of indices of its points, in order.
    struct gusset_indices landmarks;
    /// Options of the curves across.
    const struct gusset_outline_options *across;
    /// Options of the curves along.
    const struct gusset_outline_options *along;
    /// GIVEN: indices of missing points over all sections, in any order; their coordinates are not read. A Catmull-Rom
    /// curve through up to two nodes before and after in the column fills each, with centripetal parameters from
    /// adjacent columns.
    struct gusset_indices missing;
} gusset_frame_options;

/// Lent nodes, row by row, and curves.
typedef struct gusset_frame_view {
    size_t struct_size;
    /// Sections.
    size_t rows;
    /// Nodes in a section.
    size_t columns;
    /// Nodes.
    const double *nodes;
    /// Unit tangents of the curves across; 0 if undefined.
    const double *across;
    /// Unit tangents of the curves along.
    const double *along;
    /// The frame's curve of each section. Node i of row k is its point k columns + i.
    const struct gusset_outline *curves_across;
    /// The frame's curve of each column. Node i of row k is its point i rows + k.
    const struct gusset_outline *curves_along;
    /// By section: 1 if it was reversed.
    const uint8_t *turned;
    /// Nodes whose half-plane meets the section several times.
    struct gusset_indices ambiguous;
    /// Nodes that are corners of the curve across, ascending.
    struct gusset_indices corners;
    /// Largest rotation of a closed section's nodes from the previous section; 0 for open ones.
    double max_twist;
    /// Largest distance between two curves at a node, relative to the nodes' box.
    double max_gap;
    /// Smallest sine of the angle between two curves at a node.
    double min_sine;
    /// Interpolated missing nodes, ascending.
    struct gusset_indices filled;
} gusset_frame_view;

/// Makes the frame of consecutive sections.
/// A section of one point, or coincident points, is a pole: all its nodes are there.
/// @param sections at least 2, for a ring 3.
/// @errors as gusset_outline_create, OUT_OF_RANGE (sections, columns, landmarks, axis; missing points without GIVEN),
///     NO_SUCH_ELEMENT (missing point), SECTIONS_DIFFER, NO_NODE (section and column: half-plane misses the section, no
///     curve, or no node before or after a missing one)
/// @complexity O(points), with ANGLE O(columns x points). Sections of n <= 128 corners take O(n^3); with more, all are
///     smooth.
/// @source Nadopta.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_frame_create(const struct gusset_context *context,
    const struct gusset_outlines *sections, const struct gusset_frame_options *options, struct gusset_frame **frame);

/// Makes the offset of a frame.
/// Directions come from circles through neighbouring nodes, exact on planes, spheres, and round cylinders with
/// perpendicular sections. Curves keep their options.
/// Each node moves by its distance:
/// - Closed sections: outwards, or inwards if negative.
/// - Open sections: along D x d, derivatives across and within sections; GUSSET_OFFSET_IN_SECTION: away from the ends'
///   chord.
/// - Nodes without a direction stay.
/// @param distances lengths.
/// @param distance_count 1: for all; rows: for each section; rows x columns: for each node, row by row.
/// @errors COUNT_DIFFERS (distances), NOT_FINITE (distance), as gusset_frame_create (new nodes)
/// @complexity O(nodes), plus curves.
/// @source Nadopta.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_frame_offset_create(const struct gusset_context *context,
    const struct gusset_frame *frame, const double *distances, size_t distance_count, gusset_offset_direction direction,
    struct gusset_frame **offset);

GUSSET_API void gusset_frame_destroy(struct gusset_frame *frame);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_frame_get_view(const struct gusset_frame *frame,
    struct gusset_frame_view *view);

/// Cuts the curves along by a plane, and makes a section through the crossings.
/// It has the options of the curves across; point i is the first crossing of column i.
/// @param point of the plane.
/// @param normal not 0.
/// @param section one outline.
/// @errors as gusset_outline_create, OUT_OF_RANGE (normal), NOT_FINITE, NO_NODE (value: column not crossed)
/// @complexity O(segments).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_frame_slice_create(const struct gusset_context *context,
    const struct gusset_frame *frame, const double *point, const double *normal, struct gusset_outline **section);

#ifdef __cplusplus
}
#endif
#endif
