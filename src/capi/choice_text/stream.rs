//! Choices of gusset/stream.h.
//!
//! Written by `gusset-interface headers`; do not edit.

use std::ffi::CStr;

/// The name of each choice, and its constants with their texts.
#[rustfmt::skip]
pub(super) const CHOICES: &[(&str, &[(u32, &CStr)])] = &[
    ("gusset_stream_mode", &[
        (0, c"Compressed, rounded to a number of bits."),
        (1, c"Compressed bit for bit, including NaN."),
        (2, c"Uncompressed little-endian matrices, aligned to 64 bytes."),
    ]),
    ("gusset_stream_levels", &[
        (0, c"Levels of the net's box, or a coarser step that its coordinates already have."),
        (1, c"Levels of the box from low to high."),
    ]),
];
