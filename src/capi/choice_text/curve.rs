//! Choices of gusset/curve.h.
//!
//! Written by `gusset-interface headers`; do not edit.

use std::ffi::CStr;

/// The name of each choice, and its constants with their texts.
#[rustfmt::skip]
pub(super) const CHOICES: &[(&str, &[(u32, &CStr)])] = &[
    ("gusset_constraint_kind", &[
        (0, c"Direction `tangent`, not 0."),
        (1, c"A corner is allowed."),
        (2, c"Direction at the angle tangent[0], counter-clockwise from the x-axis in the xy plane."),
    ]),
    ("gusset_curve_kind", &[
        (0, c"Quadratic segments, G1, one control point for each point."),
        (1, c"One Bézier curve, for up to about 20 points."),
        (2, c"Cubic segments that blend adjacent sections linearly: C1 in the knots of the method's exponent, G1 with GUSSET_METHOD_NORMAL."),
        (3, c"Quintic segments that blend adjacent sections smoothly: C2, G2 with GUSSET_METHOD_NORMAL."),
        (4, c"Cubic spline, C2 in the knots of the method's exponent."),
        (5, c"Nadopta's chain: GUSSET_CURVE_KIND_COMPOSITE with GUSSET_LOCK_DATA_GUIDE, regardless of `lock`."),
    ]),
    ("gusset_section_method", &[
        (0, c"The bisector of the angle at the point; always defined."),
        (1, c"The median; always defined."),
        (2, c"The normal of the chord."),
        (3, c"The symmedian; always defined."),
        (4, c"Parameter a^alpha / (a^alpha + b^alpha) for the distances a, b from the neighbours: median at alpha = 0, bisector at 1/2, symmedian at 1."),
    ]),
    ("gusset_parameter_lock", &[
        (0, c"The method's parameter on the triangle of the given points."),
        (1, c"The method's parameter on the section's own triangle."),
        (2, c"Controls on the guides of the given points' triangles, where possible."),
    ]),
    ("gusset_joint_parameter", &[
        (0, c"Midpoints between control points."),
        (1, c"From chords to the power of the method's exponent: the quadratic B-spline in these knots, C1."),
        (2, c"Continuous curvature, by cubic segments in the triangles of the quadratics; 0 at inflections of the control polygon."),
    ]),
    ("gusset_outline_solver", &[
        (0, c"Closed forms and Newton's method."),
        (1, c"Nadopta's steps along the guide, refined where the deviation changes sign."),
    ]),
    ("gusset_outline_ends", &[
        (0, c"From the first and last sections."),
        (1, c"Perpendicular to the first chord (first to third point) and to the last."),
        (2, c"Parallel to the x-axis, in the sense of first and last legs."),
        (3, c"Parallel to the y-axis, likewise."),
        (4, c"Level or upright, whichever is nearer to GUSSET_ENDS_PERPENDICULAR."),
    ]),
    ("gusset_point_status", &[
        (0, c"All demands are met."),
        (1, c"The parameter was clamped to its limits."),
        (2, c"Omitted: it repeats an earlier point (or, at a closed outline's end, the first) within the tolerance."),
        (3, c"Too near an end of its section for the method; the median was used."),
        (4, c"Its triangle is flat and lacks a guide or a perpendicular."),
        (5, c"The normal's foot is outside the chord; the bisector was used."),
        (6, c"The normal's foot is an end of the chord; the bisector was used."),
        (7, c"The curve does not cross the guide."),
        (8, c"The tangent separates points that should be on one side."),
        (9, c"The curve would run backwards along the tangent."),
        (10, c"No quadratic reaches the tangent: the point is farther from it than the section's end."),
        (11, c"The tangent is outside the section's plane, or GUSSET_LOCK_DATA_GUIDE or GUSSET_JOINT_PARAMETER_G2 requires a planar outline."),
        (12, c"The tangent is zero and was omitted."),
        (13, c"The lock failed; GUSSET_LOCK_PARAMETER was used."),
        (14, c"The iteration did not converge."),
        (15, c"The curve misses it: too few distinct points, or equations without solution."),
        (16, c"An adjacent joint has the midpoint of its control points, or curvature 0 with GUSSET_JOINT_PARAMETER_G2."),
        (17, c"The single curve failed; a composite curve was used."),
        (18, c"A blended curve has a cusp here."),
        (19, c"The curve crosses itself here although the points do not."),
        (20, c"The distance to the next or previous point is below a hundredth of both distances beside it, or below a ten-thousandth of one."),
    ]),
    ("gusset_fit_status", &[
        (0, c"All demands are met."),
        (1, c"Some points have a status other than OK, merged, clamped, looped or crowded."),
        (2, c"The iteration did not converge."),
        (3, c"The iteration diverged, or control points overflow."),
        (4, c"The equations are nearly singular; control points lie far outside the outline."),
        (5, c"Fewer than 2 distinct points, or 3 if closed: the curve is empty or fits two points."),
        (6, c"A single curve would exceed degree 64; a composite curve was used."),
    ]),
    ("gusset_curve_measure_flags", &[
        (1, c"`length`."),
        (2, c"`low` and `high`; undefined without points."),
        (4, c"`centre`; undefined without points."),
        (8, c"`area_vector` and `area`."),
        (16, c"`centroid` and `second`; only for a curve with points in the plane z = 0, and unless they overflow."),
    ]),
    ("gusset_sample_rule", &[
        (0, c"`amount` points at equal arc lengths."),
        (1, c"A point every `amount` of arc length, and the end of an open curve."),
        (2, c"Chords within `amount` of the curve."),
    ]),
    ("gusset_curve_format", &[
        (0, c"SVG path data (M, L, Q, C, Z), for plane curves up to degree 3."),
        (1, c"TrueType contour, for closed plane curves up to degree 2: controls, and joints not midway between two."),
        (2, c"Clamped B-spline, for curves of one degree n."),
    ]),
    ("gusset_correspondence_rule", &[
        (0, c"By index; all sections have the same number of points."),
        (1, c"Equal arc lengths of each section, or between corners."),
        (2, c"Half-planes at equal angles round the axis; the farthest crossing of several."),
        (3, c"Landmarks of each section, and equal arc lengths between them."),
    ]),
    ("gusset_offset_direction", &[
        (0, c"Along normals of the body."),
        (1, c"In the planes of sections."),
    ]),
];
