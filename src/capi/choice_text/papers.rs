//! Choices of gusset/papers.h.
//!
//! Written by `gusset-interface headers`; do not edit.

use std::ffi::CStr;

/// The name of each choice, and its constants with their texts.
#[rustfmt::skip]
pub(super) const CHOICES: &[(&str, &[(u32, &CStr)])] = &[
    ("gusset_reference_object", &[
        (0, c"The point."),
        (1, c"The plane through `point` with the normal `direction`."),
        (2, c"The line through `point` along `direction`."),
        (3, c"The segment from `point` to `point` + `direction`."),
        (4, c"Normals at `angle` to `direction`."),
        (5, c"The curve."),
        (6, c"The surface."),
        (7, c"The ray from `point` along `direction`."),
    ]),
    ("gusset_winding", &[
        (0, c"Counter-clockwise seen from outside."),
        (1, c"Clockwise seen from outside, as Baumgart's."),
    ]),
    ("gusset_winged_flags", &[
        (1, c"One face of a non-manifold edge."),
        (2, c"One face of an edge that two faces traverse in one direction."),
        (4, c"The ends are equal, or a face has fewer than three edges with different ends."),
    ]),
];
