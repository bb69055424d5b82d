//! Choices of gusset/base.h.
//!
//! Written by `gusset-interface headers`; do not edit.

use std::ffi::CStr;

/// The name of each choice, and its constants with their texts.
#[rustfmt::skip]
pub(super) const CHOICES: &[(&str, &[(u32, &CStr)])] = &[
    ("gusset_element", &[
        (0, c"The index means nothing."),
        (1, c"Vertex of the input mesh."),
        (2, c"Face of the input mesh."),
        (3, c"Half-edge: a position in face_corners."),
        (4, c"Entry of an array of offsets."),
        (5, c"Position in a given loop."),
        (6, c"Number of elements or bytes."),
        (7, c"Point of an outline or a curve, over all outlines."),
        (8, c"Constraint on an outline: its place or tangent."),
        (9, c"Given place on a curve or a surface."),
        (12, c"Section of a frame, or plane."),
        (13, c"Node of a net, row after row."),
        (14, c"Link of a net: twice its first node, plus 1 if vertical."),
        (15, c"Cell of a net, row after row."),
        (16, c"Given seam."),
        (17, c"Bridge of a net."),
        (18, c"Entry of a scene."),
        (19, c"Byte of a stream."),
        (21, c"Given operation, field, gluing, line, loop, pair, piece, sheet or curve."),
        (20, c"Place along the side of a net; the value is a distance."),
        (30, c"Knot of a spline; the message names u or v."),
        (31, c"Row of a net of curves."),
        (32, c"Edge of a winged-edge table."),
    ]),
];
