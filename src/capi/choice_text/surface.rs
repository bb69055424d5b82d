//! Choices of gusset/surface.h.
//!
//! Written by `gusset-interface headers`; do not edit.

use std::ffi::CStr;

/// The name of each choice, and its constants with their texts.
#[rustfmt::skip]
pub(super) const CHOICES: &[(&str, &[(u32, &CStr)])] = &[
    ("gusset_contact_kind", &[
        (1, c"They touch in a point, apart round it or overlapping within the tolerance."),
        (2, c"Two branches cross, or pass each other within the tolerance."),
    ]),
    ("gusset_scheme", &[
        (0, c"Bicubic from 6 x 6 nodes round a cell: fourth order, constant 1/384, continuous tangents."),
        (1, c"Leus's bicubic through 4 x 4 nodes: fourth order, constant 3/128, tangents jump at nodes."),
    ]),
    ("gusset_twists", &[
        (0, c"Differences of tangents over five nodes: fourth order."),
        (1, c"Adini's twists, from adjacent nodes."),
        (2, c"0: flat spots at nodes."),
        (3, c"The given twists."),
    ]),
    ("gusset_nearest_flags", &[
        (1, c"A point was found."),
        (2, c"`bound` is within the tolerance of the distance, or rounding."),
        (4, c"A point farther away than 1/100 of the distance is equally near within the tolerance."),
    ]),
    ("gusset_normal_kind", &[
        (0, c"Undefined: tangents are 0, or parallel along all lines to the point."),
        (1, c"Normal of the tangent plane."),
        (2, c"Limit along the coordinate line where tangents span no plane, as at poles."),
    ]),
    ("gusset_hit_selection", &[
        (0, c"All hits, ordered along the line."),
        (1, c"The first hit."),
        (2, c"Any one hit."),
    ]),
    ("gusset_hit_kind", &[
        (0, c"No hit."),
        (1, c"It passes through the surface."),
        (2, c"It touches within the tolerance, in one point, two close ones, or none."),
        (3, c"It runs in the surface within the tolerance, over the whole span."),
    ]),
    ("gusset_spacing_rule", &[
        (0, c"Points on the surface that keep chords within 1e-4 of its box diagonal."),
        (1, c"Points on the surface that keep chords within `chord` at the middle and quarters; larger distances are possible where nodes are far apart."),
        (2, c"No points."),
        (3, c"`points` points on the cubic through four crossings, near the surface, with the place of the crossing before."),
    ]),
    ("gusset_contour_kind", &[
        (0, c"Signed distance from the plane through `point` with normal `direction`: sections by parallel planes."),
        (1, c"Values at cell corners, interpolated like the surface."),
        (2, c"Angle between the normal and `direction`: isophotes, at pi / 2 silhouettes seen along `direction`."),
    ]),
    ("gusset_target_kind", &[
        (0, c"The line, ray or segment `line`."),
        (1, c"The plane through `point` with the normal `normal`."),
        (2, c"The curve `curve`."),
        (3, c"The surface `surface`."),
    ]),
    ("gusset_distance_flags", &[
        (1, c"`bound` is within the tolerance of the distance, or 2^-45 of the greatest coordinate."),
        (2, c"Surface and target meet up to rounding; the distance is 0."),
    ]),
    ("gusset_frame_surface", &[
        (0, c"The curves across."),
        (1, c"A grid through the nodes, or GUSSET_FRAME_CURVES if curves have corners."),
        (2, c"Gordon's surface, which contains all curves of the frame."),
    ]),
    ("gusset_sheet_measure_flags", &[
        (1, c"`diameter` and `intrinsic_diameter`."),
        (2, c"`curvature_bound`."),
        (4, c"`crease`."),
    ]),
    ("gusset_sheet_direction", &[
        (0, c"Along rows: u is constant."),
        (1, c"Along columns: v is constant."),
    ]),
];
