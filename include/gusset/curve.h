/* Generated from src/capi; do not edit. See gusset.h. */

#ifndef GUSSET_CURVE_H
#define GUSSET_CURVE_H

#include "base.h"
#include "mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------------------------------ */
/* Curves: Curves of Bezier segments, and places on them. */

/// A curve of Bézier segments. Opaque and immutable; it owns its control points, and may be used from many threads.
typedef struct gusset_curve gusset_curve;

/// A place on a curve.
typedef struct gusset_place {
    /// Counted from 0.
    uint32_t segment;
    uint32_t reserved;
    /// The parameter: 0 at the segment's first control point, 1 at its last.
    double t;
} gusset_place;

/// The arrays of a curve. Pointers are valid until it is destroyed.
typedef struct gusset_curve_view {
    size_t struct_size;
    /// The control points: x, y, z of each; z is 0 for a plane curve.
    const double *controls;
    /// How many.
    size_t control_count;
    /// 0, then the index of the last control point of each segment: segment k has the control points ends[k] to ends[k
    /// + 1].
    struct gusset_indices ends;
    /// 1: the curve ends where it begins and goes on there.
    uint32_t closed;
    uint32_t reserved;
} gusset_curve_view;

/// Makes a curve from its control points. Degrees are 1 to 64; coordinates any finite numbers.
/// @param controls x, y of each control point, or x, y, z, packed.
/// @param control_count at most 2^30; 0 for a curve without segments, whose ends are 0 alone.
/// @param dimension 2 or 3.
/// @param ends 0, then the index of the last control point of each segment, rising; the last is control_count - 1.
/// @param end_count the number of segments and 1.
/// @param closed 1 if the last control point is the first one again, else 0.
/// @errors BAD_OFFSETS, OUT_OF_RANGE (dimension, degree), NOT_FINITE, CURVE_NOT_CLOSED, TOO_LARGE
/// @complexity O(points).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_create(const struct gusset_context *context,
    const double *controls, size_t control_count, uint32_t dimension, const uint32_t *ends, size_t end_count,
    uint32_t closed, struct gusset_curve **curve);

/// Destroys a curve; NULL is allowed.
GUSSET_API void gusset_curve_destroy(struct gusset_curve *curve);

/// Lends the control points, valid until the curve is destroyed.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_get_view(const struct gusset_curve *curve,
    struct gusset_curve_view *view);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Curves from curves: Parts, other degrees, offsets. */

/// How an offset is fitted.
typedef struct gusset_offset_options {
    size_t struct_size;
    /// The deviation aimed at, above 0, in the unit of the points.
    double tolerance;
    /// No segment is halved once there are so many; 0 for 65536.
    size_t max_segments;
    /// The degree of the segments, 2 or 3; 0 for 3.
    uint32_t degree;
    uint32_t reserved;
} gusset_offset_options;

/// What is said about an offset.
typedef struct gusset_offset_report {
    size_t struct_size;
    /// How far the curve is from the true offset, as measured at 16 places inside each segment.
    double deviation;
    /// The number of corners of the original, bridged by straight segments.
    size_t corners;
    /// 1 if the deviation is within the tolerance.
    uint32_t reached;
    /// 1 if somewhere the radius of curvature is at most the distance: the offset has cusps or runs backwards there.
    uint32_t tight;
} gusset_offset_report;

/// The part of a curve from one place to another, open. On a closed curve the part may run over the start, and from a
/// place to itself it goes round once. A curve of n segments ends at segment n - 1 and t = 1.
/// @param from where it begins.
/// @param to where it ends.
/// @param part receives the result, for gusset_curve_destroy, as for all functions of this group; NULL on failure.
/// @errors NO_SUCH_ELEMENT (place 0 is from, 1 is to), OUT_OF_RANGE (an open curve, and to before from), TOO_LARGE
/// @complexity O(points).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_part_create(const struct gusset_context *context,
    const struct gusset_curve *curve, struct gusset_place from, struct gusset_place to, struct gusset_curve **part);

/// The same curve run through from its end to its start.
/// @complexity O(points).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_reverse_create(const struct gusset_context *context,
    const struct gusset_curve *curve, struct gusset_curve **reversed);

/// Changes the degrees of a curve's segments: lower degrees are raised, higher ones lowered. A raised segment stays the
/// same curve. A lowered segment is fitted by least squares with fixed ends.
/// @param lowest segments of a lower degree are raised to this, 1 to 64; 1 raises none.
/// @param highest segments of a higher degree are lowered to this, lowest to 64; 64 lowers none.
/// @param tolerance segments that would deviate by more are not lowered; at least 0, in the unit of the points;
///     infinity is allowed.
/// @param deviations receives for each segment a bound on its deviation from the original. A segment that was kept has
///     the deviation that lowering would cost. NULL if it is not wanted.
/// @errors OUT_OF_RANGE (a degree, tolerance), TOO_LARGE
/// @complexity O(degree) for each new control point of a raised segment, O(degree^3) a lowered segment.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_change_degree_create(const struct gusset_context *context,
    const struct gusset_curve *curve, uint32_t lowest, uint32_t highest, double tolerance, double *deviations,
    struct gusset_curve **changed);

/// The curve beside a plane curve, re-fitted by segments with common tangents. Places where it crosses itself are not
/// removed.
/// @param distance how far to the left of it, to the right if negative; in the unit of the points, finite.
/// @param options its tolerance must be given.
/// @param report what became of it; NULL if it is not wanted.
/// @errors CURVE_NOT_PLANE, EMPTY_CURVE, OUT_OF_RANGE (distance, tolerance, degree), TOO_LARGE
/// @complexity O(degree) for each of the places measured.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_offset_create(const struct gusset_context *context,
    const struct gusset_curve *curve, double distance, const struct gusset_offset_options *options,
    struct gusset_offset_report *report, struct gusset_curve **offset);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Curves in other forms: SVG paths, TrueType contours, B-splines. */

/// A format that curves are exported to.
typedef uint32_t gusset_curve_format;
/// The data of an SVG path, of M, L, Q, C and Z, for plane curves of degrees up to 3. Numbers read back as the same
/// bits, and y is not turned over.
#define GUSSET_CURVE_FORMAT_SVG 0
/// The contour of a TrueType font, for closed plane curves of degrees up to 2: control points, and those joints that
/// are not in the middle between two of them.
#define GUSSET_CURVE_FORMAT_CONTOUR 1
/// A clamped B-spline, for curves whose segments have one degree n. A joint with one tangent becomes a knot of
/// multiplicity n - 1, and is not a control point.
#define GUSSET_CURVE_FORMAT_SPLINE 2

/// A curve in another form. Opaque and immutable; it keeps nothing of the curve.
typedef struct gusset_curve_form gusset_curve_form;

/// The parts of a form; those that it does not have are empty. Pointers are valid until it is destroyed.
typedef struct gusset_curve_form_view {
    size_t struct_size;
    /// The text of an SVG path, ended by a 0; empty for other forms.
    const char *text;
    /// Its length without the 0.
    size_t text_length;
    /// The points of a contour or the control points of a spline: x, y, z of each.
    const double *points;
    /// How many.
    size_t point_count;
    /// Of a contour, for each point: 1 on the curve, 0 off it.
    const uint8_t *on_curve;
    /// Of a spline: the knots, point_count + degree + 1 of them.
    const double *knots;
    /// How many.
    size_t knot_count;
    /// Of a spline: its degree.
    size_t degree;
} gusset_curve_form_view;

/// Exports a curve to another format.
/// @param tolerance for GUSSET_CURVE_FORMAT_CONTOUR: how far from the middle a joint still counts as there, at least 0,
///     in the unit of the points; rounding always does. Other formats do not read it.
/// @errors UNKNOWN_VALUE (format), CURVE_NOT_PLANE (not for splines), CURVE_NOT_CLOSED (contours), EMPTY_CURVE (not for
///     SVG), OUT_OF_RANGE (a degree that the format lacks: see gusset_curve_change_degree_create; tolerance)
/// @complexity O(points).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_export_create(const struct gusset_context *context,
    const struct gusset_curve *curve, gusset_curve_format format, double tolerance, struct gusset_curve_form **form);

/// Destroys a form; NULL is allowed.
GUSSET_API void gusset_curve_form_destroy(struct gusset_curve_form *form);

/// Lends the parts.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_form_get_view(const struct gusset_curve_form *form,
    struct gusset_curve_form_view *view);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Frames: Curves across and along a body, through a common grid of nodes. */

/// Which points of a section belong to which of the next.
typedef uint32_t gusset_correspondence_rule;
/// The points of the sections by their places: all sections have equally many.
#define GUSSET_CORRESPONDENCE_GIVEN 0
/// Equal parts of the arc length of each section, or of the lengths between corners that all sections have. Closed
/// sections start where they are turned least against each other, wherever their first points are; one that runs the
/// other way round than the first one is taken backwards. Open sections go from their first points to their last.
#define GUSSET_CORRESPONDENCE_ARC_LENGTH 1
/// Where half-planes at equal angles round the axis, straight or bent, meet each section; the farthest place where
/// there are several.
#define GUSSET_CORRESPONDENCE_ANGLE 2
/// Landmarks of each section, and equal parts of the arc length between them.
#define GUSSET_CORRESPONDENCE_LANDMARKS 3

/// Nodes, and curves across and along a body through them. Opaque and immutable; it keeps nothing of the points.
typedef struct gusset_frame gusset_frame;

/// Where the nodes of a frame move.
typedef uint32_t gusset_offset_direction;
/// Nodes move along the normals of the body.
#define GUSSET_OFFSET_NORMAL 0
/// Nodes move within the planes of their sections.
#define GUSSET_OFFSET_IN_SECTION 1

struct gusset_outline_options;

/// How a frame is made; all zero is the default: the points themselves are the nodes.
typedef struct gusset_frame_options {
    size_t struct_size;
    gusset_correspondence_rule correspondence;
    /// The number of nodes in a section, for ARC_LENGTH and ANGLE; for LANDMARKS the number of parts from each landmark
    /// to the next.
    uint32_t columns;
    /// 1: the last section is followed by the first one. 0 or 1.
    /// @flag
    uint32_t ring;
    /// 1: closed sections start at their first points, or at the corner after the first section's; read with
    /// ARC_LENGTH. 0 or 1.
    /// @flag
    uint32_t given_starts;
    /// 1: corners that only the points' polygon has are drawn smooth. 0: a point is a corner where that turns by 40
    /// degrees and far more than usual, or by the `corner_angle` of the curves across if that is less than pi; there
    /// they turn sharply. 0 or 1.
    /// @flag
    uint32_t smooth_corners;
    uint32_t reserved;
    /// For ANGLE: a point of the axis.
    double axis_point[3];
    /// For ANGLE: its direction; seen against it angles grow counter-clockwise.
    double axis_direction[3];
    /// For ANGLE: towards the nodes of column 0; any vector not along the axis, at its first point if it is bent.
    double reference[3];
    /// For ANGLE about a bent axis: a point of it for each section, x, y, z; axis_point and axis_direction are not read
    /// then. The axis passes them along the circles through three of them at a time, and the reference goes along
    /// without turning about it. NULL: the axis is straight.
    const double *axis_points;
    /// The number of these points: that of the sections.
    size_t axis_point_count;
    /// For LANDMARKS: for each section its landmarks in order, places among its own points; as many for each.
    struct gusset_indices landmarks;
    /// How the curves across are made; NULL for the defaults.
    const struct gusset_outline_options *across;
    /// How the curves along are made; NULL for the defaults.
    const struct gusset_outline_options *along;
    /// For GIVEN: points that are missing, counted over all sections, in any order. What stands in their places is not
    /// read, and may be NaN. Each is filled along the body: on the curve of Catmull and Rom through the nodes of its
    /// column before and behind it, two of each if there are as many, by the centripetal parameters of the columns next
    /// to it.
    struct gusset_indices missing;
} gusset_frame_options;

struct gusset_outline;

/// The nodes of a frame, row by row, and its curves. Pointers are valid until the frame is destroyed.
typedef struct gusset_frame_view {
    size_t struct_size;
    /// The number of sections.
    size_t rows;
    /// The number of nodes in a section.
    size_t columns;
    /// x, y, z of each node.
    const double *nodes;
    /// The direction of the curve across at each node: x, y, z, of length 1, or 0 where there is none.
    const double *across;
    /// The direction of the curve along.
    const double *along;
    /// The curves across, one for each section: node i of row k is its point k columns + i. The frame owns them.
    const struct gusset_outline *curves_across;
    /// The curves along, one for each column: node i of row k is its point i rows + k. The frame owns them.
    const struct gusset_outline *curves_along;
    /// For each section 1 if it was taken backwards.
    const uint8_t *turned;
    /// Nodes that could have been elsewhere, as a half-plane meets their section more than once.
    struct gusset_indices ambiguous;
    /// Nodes at which the curve across turns sharply, ascending.
    struct gusset_indices corners;
    /// The largest angle, in radians, by which the nodes of a closed section are turned against those of the section
    /// before it: a body that is not meant to be wrung has a small one. 0 of open ones.
    double max_twist;
    /// The largest distance between the two curves at a node, relative to the size of the nodes' box.
    double max_gap;
    /// The smallest sine of the angle at which two curves cross at a node.
    double min_sine;
    /// Nodes that were missing and are filled, ascending.
    struct gusset_indices filled;
} gusset_frame_view;

struct gusset_outlines;

/// Makes the frame of some sections, closed or open, one behind another: a grid of nodes, a curve across through each
/// row of it, and a curve along through each column.
/// @param sections at least 2, 3 of a ring.
/// @errors as gusset_outline_create, OUT_OF_RANGE (too few sections or columns; landmarks that are not as many for each
///     section, or not in order; an axis without direction, or points of it that are not as many as sections; missing
///     points of another correspondence than GIVEN), NO_SUCH_ELEMENT (a missing point), SECTIONS_DIFFER, NO_NODE (a
///     section that a half-plane does not meet, or that is no curve; with the section and the column, a missing node
///     with none before it, or none behind, in its column)
/// @complexity O(points), with ANGLE O(columns x points); with corners O(n^3) a section for n <= 128 of them, none are
///     shared by sections with more.
/// @source Nadopta, introduction; the correspondences are ours.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_frame_create(const struct gusset_context *context,
    const struct gusset_outlines *sections, const struct gusset_frame_options *options, struct gusset_frame **frame);

/// Makes the frame beside a frame: room for comfort round a body, more in some places than in others. Each node moves
/// by its distance: outwards, if sections are closed, inwards if it is negative; of open sections along the derivative
/// from section to section crossed with that along them, or, within sections, away from the chord between their ends.
/// Directions come from circles through neighbouring nodes, so that planes, round cylinders with sections square to
/// their axes, and spheres become such, exactly. Curves are drawn through the new nodes as through the old ones. Nodes
/// where nothing tells a direction stay.
/// @param frame may be destroyed afterwards.
/// @param distances in the unit of the points, finite.
/// @param distance_count 1: all nodes move by the same; the number of rows: each section by its own; rows x columns:
///     each node by its own, row by row.
/// @errors COUNT_DIFFERS (distances), NOT_FINITE (the index is the distance's), as gusset_frame_create (for the new
///     nodes)
/// @complexity O(nodes), and that of the curves.
/// @source Nadopta, introduction, for the aim; the directions are ours.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_frame_offset_create(const struct gusset_context *context,
    const struct gusset_frame *frame, const double *distances, size_t distance_count, gusset_offset_direction direction,
    struct gusset_frame **offset);

/// Destroys what gusset_frame_create or gusset_frame_offset_create made; NULL is allowed.
GUSSET_API void gusset_frame_destroy(struct gusset_frame *frame);

/// Lends the nodes and the curves, valid until the frame is destroyed.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_frame_get_view(const struct gusset_frame *frame,
    struct gusset_frame_view *view);

/// Cuts the curves along by the plane through a point across a normal, and draws a curve through the crossings as the
/// curves across were made: a new section.
/// @param point x, y, z.
/// @param normal x, y, z, of any length but 0.
/// @param section receives one outline, for gusset_outline_destroy; NULL on failure; point i of it is on the curve
///     along column i, at its first crossing.
/// @errors as gusset_outline_create, OUT_OF_RANGE (the normal), NOT_FINITE, NO_NODE (the value in the report is the
///     column that the plane does not cross)
/// @complexity O(segments).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_frame_slice_create(const struct gusset_context *context,
    const struct gusset_frame *frame, const double *point, const double *normal, struct gusset_outline **section);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Intersections of curves: Intersections, tangency points and samples. */

/// Crossings, intersections or samples. Opaque and immutable; it keeps nothing of the curves.
typedef struct gusset_places gusset_places;

/// What was found. Pointers are valid until the handle is destroyed.
typedef struct gusset_places_view {
    size_t struct_size;
    /// The places, in the order of the (first) curve.
    const struct gusset_place *places;
    /// How many.
    size_t count;
    /// The points there: x, y, z of each.
    const double *points;
    /// Of intersections: the places on the second curve, or the later ones on the same; else NULL.
    const struct gusset_place *others;
    /// Parts that two segments have in common: start and end on the first, the same start and end on the second; four
    /// places each. Of tangent angles: start and end of a part, twice.
    const struct gusset_place *overlaps;
    /// How many, each of four places.
    size_t overlap_count;
    /// Of crossings: the segments that lie in the line or plane altogether.
    struct gusset_indices inside;
    /// 1 if some pair of segments was given up: they run beside each other within rounding for a long way.
    uint32_t undecided;
    uint32_t reserved;
} gusset_places_view;

/// The rule by which samples are spread along a curve.
typedef uint32_t gusset_sample_rule;
/// As many points as `amount` says, at equal arc lengths.
#define GUSSET_SAMPLE_COUNT 0
/// A point every `amount` of arc length; an open curve's end is always the last.
#define GUSSET_SAMPLE_STEP 1
/// The curve is nowhere farther than `amount` from the chords between the points. Each segment is halved at most 20
/// times, which leaves 1e-12 of its size.
#define GUSSET_SAMPLE_CHORD 2

/// Finds the places where a curve crosses or touches a plane. A plane curve meets the line through `point` along (x, y)
/// where it meets the plane across (-y, x, 0).
/// @param point x, y, z of a point of the plane.
/// @param normal x, y, z across it, of any length but 0.
/// @param places receives the result, for gusset_places_destroy, as for all functions of this group; NULL on failure.
/// @errors OUT_OF_RANGE (normal), NOT_FINITE
/// @complexity O(points), and O(degree^2) a crossing.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_intersect_plane_create(const struct gusset_context *context,
    const struct gusset_curve *curve, const double *point, const double *normal, struct gusset_places **places);

/// Finds the places where two curves meet, or come as near to each other as `within`; or, if other is NULL, where a
/// plane curve meets itself. If within is 0 and both curves are plane, the places are crossings and touches. Otherwise
/// they are the places where the distance of the curves is least, each once. Joints of neighbouring segments do not
/// count where a curve meets itself.
/// @param other the other curve; NULL for the curve itself.
/// @param within a length, 0 or more and finite, 0 if other is NULL; in space at least 1e-12 of the curves' size is
///     taken.
/// @param places receives the result, for gusset_places_destroy; NULL on failure. Overlaps are parts in common, parts
///     that stay as near, and parts where no place can be told from the next.
/// @errors OUT_OF_RANGE (within), CURVE_NOT_PLANE (other is NULL), EMPTY_CURVE (in space, or within is not 0)
/// @complexity Bounded work for each pair of segments whose boxes meet or are as near as within.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_intersect_create(const struct gusset_context *context,
    const struct gusset_curve *curve, const struct gusset_curve *other, double within, struct gusset_places **places);

/// The points of a curve whose tangents make a given angle with a direction: all of them, each once. At a cusp, where
/// the derivative is 0, the tangents before and after it count, to 1e-6; at a joint those of both segments, but not
/// those between. Angles within 1e-7 of 0, pi / 2 and pi are taken for these; tangents count as along the direction, or
/// against it, to 1e-9.
/// @param curve the curve, of any dimension and degree.
/// @param direction x, y, z, of any length but 0, packed.
/// @param angle 0 to pi.
/// @param places receives the places; overlaps are parts all of whose tangents make the angle, as those of straight
///     segments: where each begins and ends, twice. NULL on failure.
/// @errors OUT_OF_RANGE (direction, angle), NOT_FINITE (direction)
/// @complexity O(points), and O(degree^2) for each place.
/// @source Leus, "Carcasses on smooth surfaces", task b, for curves.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_tangent_angle_create(const struct gusset_context *context,
    const struct gusset_curve *curve, const double *direction, double angle, struct gusset_places **places);

/// Points along a curve, in its order; of a closed curve the start is not repeated at the end.
/// @param amount a whole number (at least 1, for an open curve 2), or a length above 0.
/// @errors EMPTY_CURVE, OUT_OF_RANGE (amount), TOO_LARGE
/// @complexity O(points, and samples).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_sample_create(const struct gusset_context *context,
    const struct gusset_curve *curve, gusset_sample_rule rule, double amount, struct gusset_places **places);

/// Destroys what was found; NULL is allowed.
GUSSET_API void gusset_places_destroy(struct gusset_places *places);

/// Lends what was found.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_places_get_view(const struct gusset_places *places,
    struct gusset_places_view *view);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Measures of curves: Derivatives, lengths, nearest points, bounds and moments. */

/// The nearest point of a curve.
typedef struct gusset_curve_nearest_point {
    /// Where on the curve.
    struct gusset_place place;
    /// x, y, z.
    double point[3];
    /// The distance.
    double distance;
} gusset_curve_nearest_point;

/// The measures of a curve, as flags.
/// @bits
typedef uint32_t gusset_curve_measure_flags;
/// The arc length: `length`.
#define GUSSET_CURVE_MEASURE_LENGTH 1
/// The smallest box with sides along the axes: `low` and `high`. A curve without points lacks it.
#define GUSSET_CURVE_MEASURE_BOUNDS 2
/// The mean of the points by arc length: `centre`. A curve without points lacks it.
#define GUSSET_CURVE_MEASURE_CENTRE 4
/// The area that the curve encloses: `area_vector` and `area`.
#define GUSSET_CURVE_MEASURE_AREA 8
/// The moments of the enclosed region: `centroid` and `second`. Only a curve in the plane z = 0 with points has them.
#define GUSSET_CURVE_MEASURE_MOMENTS 16

/// The measures of a curve. A chord from its end to its start closes an open curve.
typedef struct gusset_curve_measures {
    size_t struct_size;
    /// Of the measures that this struct has; the fields of all others are 0.
    gusset_curve_measure_flags defined;
    uint32_t reserved;
    /// The arc length, without the chord.
    double length;
    /// The least x, y and z.
    double low[3];
    /// The greatest x, y and z.
    double high[3];
    /// The mean of the points by arc length.
    double centre[3];
    /// Half the integral of r x dr. A curve in the plane z = 0 has (0, 0, signed area): regions that it runs round
    /// clockwise count negative.
    double area_vector[3];
    /// The length of `area_vector`: the area of the largest shadow, never negative.
    double area;
    /// The centre of gravity of the enclosed region; the curve's start if its area is 0.
    double centroid[2];
    /// The integrals of x x, x y and y y about the centroid, with the sign of the area.
    double second[3];
} gusset_curve_measures;

/// Computes points, derivatives, tangents and curvatures at many places: only those that the caller gives room for.
/// @param places count of them, at any alignment.
/// @param count the number of places, at least 0.
/// @param order the highest derivative, 0 for the points alone, at most 64; read if derivatives is given.
/// @param derivatives receives 3 (order + 1) count numbers: for each place x, y, z of the point, then of the first
///     derivative by t, and so on; 0 beyond the degree. NULL: not wanted.
/// @param tangents receives 3 count numbers: x, y, z of each direction, of length 1; 0 on a segment without extent.
///     NULL: not wanted.
/// @param curvatures receives count numbers, 1 over the radius: on a plane segment positive where it turns from x to y;
///     infinite where the first derivative is 0. NULL: not wanted.
/// @errors NO_SUCH_ELEMENT (a place), OUT_OF_RANGE (order, CANCELLED. Nothing is written then)
/// @complexity O(degree^2) a place, for each of the outputs.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_evaluate(const struct gusset_context *context,
    const struct gusset_curve *curve, const struct gusset_place *places, size_t count, uint32_t order,
    double *derivatives, double *tangents, double *curvatures);

/// The nearest points of a curve to many points.
/// @param points x, y, z of each, packed, count of them; any finite numbers. A distance above the largest number is
///     infinite.
/// @param count see points.
/// @param out receives count results.
/// @errors EMPTY_CURVE, NOT_FINITE, TOO_LARGE
/// @complexity About O(log segments + degree^2) a point, on the context's threads.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_nearest(const struct gusset_context *context,
    const struct gusset_curve *curve, const double *points, size_t count, struct gusset_curve_nearest_point *out);

/// The arc lengths from the start to many places.
/// @param places count of them, at any alignment.
/// @param count see places.
/// @param out receives count numbers.
/// @errors as gusset_curve_evaluate (except OUT_OF_RANGE)
/// @complexity O(points) in all.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_lengths_at(const struct gusset_context *context,
    const struct gusset_curve *curve, const struct gusset_place *places, size_t count, double *out);

/// The places at many arc lengths from the start; beyond the ends, the ends.
/// @param lengths count numbers.
/// @param count see lengths.
/// @param out receives count places.
/// @errors EMPTY_CURVE, OUT_OF_RANGE (NaN)
/// @complexity O(points + count log segments).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_places_at(const struct gusset_context *context,
    const struct gusset_curve *curve, const double *lengths, size_t count, struct gusset_place *out);

/// Measures a curve: only what the flags ask for is computed. A measure that the curve lacks is not an error: `defined`
/// of the measures lacks its flag.
/// @param flags 0 for all that the curve has.
/// @errors UNKNOWN_VALUE (flags)
/// @complexity O(points) for length and bounds, O(sum of degree^2) for all others. The length is right to 1e-13, and
///     exact except for rounding up to degree 2; the centre is that of 16 chords a segment; all others are exact except
///     for rounding.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_curve_measure(const struct gusset_context *context,
    const struct gusset_curve *curve, gusset_curve_measure_flags flags, struct gusset_curve_measures *measures);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Options of outlines: How curves are chosen, and what became of each point. */

/// The kind of the curve of an outline.
typedef uint32_t gusset_curve_kind;
/// Quadratic segments, one control point for each point; smooth (G1) everywhere.
#define GUSSET_CURVE_KIND_COMPOSITE 0
/// One Bezier curve through all points: of degree n through n + 1 points, 1 more for each end tangent, and n + 2
/// through n points of a closed outline, whose seam is smooth. Above degree 64 a composite curve takes its place. Good
/// for up to some 20 points.
#define GUSSET_CURVE_KIND_SINGLE 1
/// Neighbouring sections blended linearly: cubic segments from point to point, C1 in the knots of the method's exponent
/// (G1 with the normal). With the bisector the centripetal Catmull-Rom spline.
#define GUSSET_CURVE_KIND_BLEND_C1 2
/// Neighbouring sections blended smoothly: quintic segments from point to point, C2 (G2 with the normal), but at inner
/// points whose tangent is given: C1 (G1) there.
#define GUSSET_CURVE_KIND_BLEND_C2 3
/// The cubic spline: cubic segments from point to point, C2 in the knots of the method's exponent, but at inner points
/// whose tangent is given: C1 there.
#define GUSSET_CURVE_KIND_CUBIC_C2 4
/// The paper's chain: GUSSET_CURVE_KIND_COMPOSITE with GUSSET_LOCK_DATA_GUIDE, whatever lock says. Each control point
/// lies on the guide of its point, the bisector, median or normal that the method names.
#define GUSSET_CURVE_KIND_CHAIN 5

/// The guide of the control point of a section.
typedef uint32_t gusset_section_method;
/// The bisector of the angle at the point. For all points. Sections by themselves and GUSSET_LOCK_DATA_GUIDE have their
/// control points on the line that the method names; the other locks take from it the parameter of the point, and
/// control points are near the line.
#define GUSSET_METHOD_BISECTOR 0
/// The median. For all points.
#define GUSSET_METHOD_MEDIAN 1
/// The normal of the chord; where its foot is outside the chord the bisector takes its place, but for
/// GUSSET_LOCK_SELF_CONSISTENT, where the foot counts as the nearer end of the chord.
#define GUSSET_METHOD_NORMAL 2
/// The symmedian. For all points.
#define GUSSET_METHOD_SYMMEDIAN 3
/// The parameter of the point is a^alpha / (a^alpha + b^alpha), a and b being the distances from its neighbours: the
/// median at alpha = 0, the bisector at 1/2, the symmedian at 1.
#define GUSSET_METHOD_ALPHA 4

/// The rule that fixes the parameters of points.
typedef uint32_t gusset_parameter_lock;
/// The parameter of a point is that of the method on the triangle of the data. Always solvable. The control point is
/// near the guide of that triangle but not on it.
#define GUSSET_LOCK_PARAMETER 0
/// The parameter is that of the method on the section's own triangle. With the normal there may be several solutions;
/// which one is found depends on the solver.
#define GUSSET_LOCK_SELF_CONSISTENT 1
/// The control point lies on the guide of the data's triangle, as the paper draws it, where that is possible. Outlines
/// must lie in a plane, any plane; points of others get GUSSET_POINT_OUT_OF_PLANE and the lock by parameter.
#define GUSSET_LOCK_DATA_GUIDE 2

/// The parameters of the joints of composite curves.
typedef uint32_t gusset_joint_parameter;
/// Sections join in the middle between their control points.
#define GUSSET_JOINT_PARAMETER_HALF 0
/// By the chords to the power of the method's exponent: the quadratic B-spline in those knots, C1.
#define GUSSET_JOINT_PARAMETER_KNOT 1
/// So that the curvature is continuous (G2): cubic segments in the triangles of the quadratics. 0 where the control
/// polygon turns the other way. Outlines in a plane; in space curvatures agree in magnitude, and points get
/// GUSSET_POINT_OUT_OF_PLANE.
#define GUSSET_JOINT_PARAMETER_G2 2

/// The method that solves for a curve.
typedef uint32_t gusset_outline_solver;
/// Closed forms and Newton's method.
#define GUSSET_SOLVER_FAST 0
/// The paper's: steps along the guide, refined where the deviation changes its sign.
#define GUSSET_SOLVER_STEP 1

/// The ends of open outlines.
typedef uint32_t gusset_outline_ends;
/// Open outlines begin and end as their first and last sections have it.
#define GUSSET_ENDS_FREE 0
/// Perpendicular to the first chord, from the first point to the third, and to the last one.
#define GUSSET_ENDS_PERPENDICULAR 1
/// Along the x-axis, in the sense of the first and the last leg.
#define GUSSET_ENDS_LEVEL 2
/// Along the y-axis, in the sense of the first and the last leg.
#define GUSSET_ENDS_UPRIGHT 3
/// Level or upright, whichever is nearer the perpendicular of the first or the last chord.
#define GUSSET_ENDS_LEVEL_OR_UPRIGHT 4

/// The outcome at a point of an outline.
typedef uint32_t gusset_point_status;
/// As asked.
#define GUSSET_POINT_OK 0
/// Its parameter was brought within the limits.
#define GUSSET_POINT_CLAMPED_PARAMETER 1
/// It repeats a point before it (or the first one, at the end of a closed outline), and was left out: the curve passes
/// that one, which is within the tolerance for repeats.
#define GUSSET_POINT_MERGED 2
/// It is so near the first or last point of its section that this has no control point by the method; the median took
/// its place.
#define GUSSET_POINT_REPEATED 3
/// Its triangle is flat: it has no guide, or no perpendicular.
#define GUSSET_POINT_COLLINEAR 4
/// The foot of the normal is outside the chord; the bisector took its place.
#define GUSSET_POINT_NORMAL_OUTSIDE 5
/// The foot of the normal is an end of the chord; the bisector took its place.
#define GUSSET_POINT_RIGHT_ANGLE 6
/// The curve does not cross the guide.
#define GUSSET_POINT_NO_CROSSING 7
/// The tangent runs between points that should be on one side of it.
#define GUSSET_POINT_TANGENT_SEPARATES 8
/// The curve would have to run backwards along the tangent.
#define GUSSET_POINT_TANGENT_BACKWARD 9
/// The tangent cannot be reached by a quadratic: the point is farther from it than the section's end.
#define GUSSET_POINT_TANGENT_BEYOND 10
/// The tangent is not in the plane of the section; or GUSSET_LOCK_DATA_GUIDE or GUSSET_JOINT_PARAMETER_G2 is asked of
/// an outline that is not plane.
#define GUSSET_POINT_OUT_OF_PLANE 11
/// The tangent has no direction, and was left out.
#define GUSSET_POINT_NO_TANGENT 12
/// The lock could not be kept: its parameter is that of GUSSET_LOCK_PARAMETER.
#define GUSSET_POINT_FELL_BACK 13
/// The iteration ended before it was still.
#define GUSSET_POINT_NOT_CONVERGED 14
/// The curve misses it: the outline has too few different points, or its equations have no solution.
#define GUSSET_POINT_MISSED 15
/// A joint beside it could not be where the option asks for it: it is in the middle between its control points, or, for
/// GUSSET_JOINT_PARAMETER_G2, the curvature there is 0.
#define GUSSET_POINT_JOINT_FELL_BACK 16
/// It is on a composite curve, as the single one failed.
#define GUSSET_POINT_COMPOSITE_INSTEAD 17
/// A blended curve turns back at it: it stands still there, or leaves the way it came.
#define GUSSET_POINT_CUSP 18

/// The outcome of an outline.
typedef uint32_t gusset_fit_status;
/// As asked.
#define GUSSET_FIT_OK 0
/// Some points are not as asked, in other ways than merged or clamped: see their status.
#define GUSSET_FIT_PARTIAL 1
/// The iteration ended before it was still.
#define GUSSET_FIT_NOT_CONVERGED 2
/// The iteration ran away, or control points are beyond the largest number.
#define GUSSET_FIT_DIVERGED 3
/// The equations are so nearly singular that control points lie far outside the outline.
#define GUSSET_FIT_ILL_CONDITIONED 4
/// Fewer than two different points, or three of a closed outline: there is no curve, or what two points give.
#define GUSSET_FIT_TOO_FEW_POINTS 5
/// A single curve would have a degree above 64; a composite one took its place.
#define GUSSET_FIT_DEGREE_TOO_HIGH 6

/// How outlines are identified; all zero is the default. Lengths are relative to the size of the outline, the longest
/// side of its box.
typedef struct gusset_outline_options {
    size_t struct_size;
    gusset_curve_kind curve;
    gusset_section_method method;
    /// For composite and single curves; a chain has its own.
    gusset_parameter_lock lock;
    /// For composite curves and chains.
    gusset_joint_parameter joint;
    gusset_outline_solver solver;
    /// For open outlines, and parts of them that end at corners; a tangent demanded there comes first.
    gusset_outline_ends ends;
    /// Read for GUSSET_METHOD_ALPHA; 0 to 1.
    /// @when method GUSSET_METHOD_ALPHA
    double alpha;
    /// Parameters of composite curves are kept within this and 1 less this: 0.001 to 1/2, or 0 for 1/6.
    double parameter_limit;
    /// Neighbours at most so far apart are one point; below 1. 0 for 1e-12. 1e-300 merges equal points only.
    double repeat_tolerance;
    /// Points where the polygon turns by more than this angle, in radians, are corners; at least 0, and 0, pi or more,
    /// also INFINITY, for none.
    double corner_angle;
    /// Iterations end when nothing moves farther, below 1; 0 for 1e-12.
    double tolerance;
    /// The most sweeps or iterations between two corners; 0 for 200.
    uint32_t max_sweeps;
    /// The most steps at a point in a sweep; 0 for 20,000.
    uint32_t max_steps;
} gusset_outline_options;

/* ------------------------------------------------------------------------------------------------------------------ */
/* Outlines: Passes curves through given points: the inverse problem of Bezier curves. */

/// The demand of a constraint.
typedef uint32_t gusset_constraint_kind;
/// The curve passes the point in the direction of the tangent, of any length but 0.
#define GUSSET_CONSTRAINT_TANGENT 0
/// The curve may turn sharply at the point.
#define GUSSET_CONSTRAINT_CORNER 1
/// The curve passes the point at the angle tangent[0], in radians counter-clockwise from the x-axis, in the plane of x
/// and y.
#define GUSSET_CONSTRAINT_TANGENT_ANGLE 2

/// What is demanded of a curve at a point.
typedef struct gusset_constraint {
    /// The point, counted over all outlines.
    uint32_t point;
    gusset_constraint_kind kind;
    /// x, y, z, for GUSSET_CONSTRAINT_TANGENT; z is 0 for plane outlines. For GUSSET_CONSTRAINT_TANGENT_ANGLE the angle
    /// and twice 0.
    double tangent[3];
} gusset_constraint;

/// Outlines in the caller's memory: all points one after another. Nothing is copied on the way in. The arrays may have
/// any alignment, must be as long as the counts say, and must not change during a call.
typedef struct gusset_outlines {
    size_t struct_size;
    /// The coordinates, doubles: x, y or x, y, z at the start of every point_stride bytes; finite.
    const void *points;
    /// In bytes; 0 for points without gaps.
    size_t point_stride;
    /// The number of points of all outlines, at most 2^30.
    size_t point_count;
    /// Where each outline begins, and where the last one ends: outline_count + 1 places, 0 first, never decreasing.
    /// NULL with outline_count 0 for a single outline of all points.
    const uint32_t *offsets;
    /// The number of outlines, or 0.
    size_t outline_count;
    /// In ascending order of their points, at most one for each; or NULL. Of points that are merged the first one's
    /// holds.
    const struct gusset_constraint *constraints;
    /// How many.
    size_t constraint_count;
    /// 2 or 3.
    uint32_t dimension;
    /// 1: from the last point of each outline back to its first one; a last point that repeats the first does no harm.
    /// 0: open.
    uint32_t closed;
} gusset_outlines;

/// The curves of outlines. Opaque and immutable; it keeps nothing of the points.
typedef struct gusset_outline gusset_outline;

/// All curves in one. Pointers are valid until the outline is destroyed. Curve k has the control points starts[2 k] to
/// starts[2 k + 2] - 1, x, y, z each (z = 0 for plane outlines), and the ends starts[2 k + 1] to starts[2 k + 3] - 1:
/// segment s of it is the Bezier curve of its control points ends[s] to ends[s + 1], both included, counted from the
/// curve's first one. A closed curve repeats its first control point at its end.
typedef struct gusset_outline_view {
    size_t struct_size;
    /// The number of outlines.
    size_t outline_count;
    /// The number of points of all outlines.
    size_t point_count;
    /// x, y, z of each control point.
    const double *controls;
    /// The number of control points.
    size_t control_count;
    /// The ends of the segments.
    struct gusset_indices ends;
    /// Two places for each curve, and two behind the last.
    const size_t *starts;
    /// For each point the segment of its curve that it lies on.
    struct gusset_indices segments;
    /// For each point its parameter there, 0 to 1.
    const double *parameters;
    /// For each point what became of it: GUSSET_POINT_...
    const uint8_t *statuses;
} gusset_outline_view;

/// The outcome of an outline. All lengths except `size` are relative to `size`.
typedef struct gusset_outline_report {
    size_t struct_size;
    gusset_fit_status fit;
    /// Sweeps or iterations, the most of any part between corners; 0 for what needs none. At most max_sweeps of the
    /// options.
    uint32_t iterations;
    /// Steps of GUSSET_SOLVER_STEP.
    uint64_t steps;
    /// The longest side of the outline's box, in the unit of the points.
    double size;
    /// The largest distance of a point from its place on the curve; merged points count as the one that they repeat.
    double max_residual;
    /// The largest sine of the angle by which the curve turns at a joint that is to be smooth.
    double max_joint_sine;
    /// The largest difference of the curvatures on both sides of a joint by GUSSET_JOINT_PARAMETER_G2, relative to the
    /// larger one, or to 1 / size where both are less; 0 for other joints.
    double max_curvature_gap;
    /// The farthest move of a control point in the last iteration.
    double last_move;
    /// How many points have another status than GUSSET_POINT_OK.
    uint32_t not_ok_count;
    uint32_t reserved;
} gusset_outline_report;

/// Finds the curves through the points of outlines: control points are sought such that each curve passes the points of
/// its outline. A point that cannot be treated as asked is no failure: its status says so, and the curve passes it all
/// the same if that is possible at all.
/// @param outlines any number of them.
/// @param options NULL for the defaults: smooth quadratic segments by the bisector, one control point for each point.
/// @errors OUT_OF_RANGE (an option, or the dimension), BAD_STRIDE, BAD_OFFSETS, TOO_LARGE, NOT_FINITE (the report has
///     the point), NO_SUCH_ELEMENT (a constraint whose point does not exist or is not behind the one before; the report
///     has the constraint)
/// @complexity Composite, blended and cubic curves take linear time; linear memory, none for each outline but for its
///     result, and about 1,500 bytes a point of the largest outline with GUSSET_JOINT_PARAMETER_G2.
/// @source Nadopta; the composite and blended readings are ours.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_outline_create(const struct gusset_context *context,
    const struct gusset_outlines *outlines, const struct gusset_outline_options *options,
    struct gusset_outline **outline);

/// Destroys what gusset_outline_create made; NULL is allowed.
GUSSET_API void gusset_outline_destroy(struct gusset_outline *outline);

/// Lends the curves, valid until the outline is destroyed.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_outline_get_view(const struct gusset_outline *outline,
    struct gusset_outline_view *view);

/// The account of outline `index`.
/// @param index its number, from 0.
/// @errors NO_SUCH_ELEMENT
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_outline_get_report(const struct gusset_outline *outline, size_t index,
    struct gusset_outline_report *report);

/// Copies the curve of outline `index`. gusset_curve_measure of the copy has girth, area and centre.
/// @param index its number, from 0.
/// @errors NO_SUCH_ELEMENT
/// @complexity O(segments).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_outline_curve_create(const struct gusset_context *context,
    const struct gusset_outline *outline, size_t index, struct gusset_curve **curve);

/// Finds the section of each point with its two neighbours: the quadratic through the three whose control point lies on
/// the guide of the method. A tangent demanded at a point makes its section pass in that direction; one at the first or
/// last point of an open outline is that of the neighbour's section there. Where it cannot be had, or the normal, the
/// method (the bisector) takes its place, and the status says so.
/// @param outlines the outlines.
/// @param options NULL for the defaults; method, alpha and solver are read, and by GUSSET_SOLVER_STEP tolerance and
///     max_steps; all must be valid.
/// @param controls receives x, y, z of each point's control point; the ends of open outlines, which have no section,
///     have themselves. NULL: not wanted. Unspecified on failure.
/// @param parameters receives the parameter of each point on its section; 0 and 1 at the ends of open outlines. NULL:
///     not wanted. Unspecified on failure.
/// @param statuses receives GUSSET_POINT_... of each point. NULL: not wanted. Unspecified on failure.
/// @param steps receives the steps of GUSSET_SOLVER_STEP, of all sections. NULL: not wanted.
/// @errors as gusset_outline_create
/// @complexity O(n); no memory.
/// @source Nadopta, the methods of the normal, tangent, bisector and median; closed forms: B = P + (P - S) / (2 sqrt(s
///     (1 - s))) for the foot S = A + s (C - A) of the guide.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_outlines_find_sections(const struct gusset_context *context,
    const struct gusset_outlines *outlines, const struct gusset_outline_options *options, double *controls,
    double *parameters, uint8_t *statuses, uint64_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* GUSSET_CURVE_H */
