//! Choices of gusset/scene.h.
//!
//! Written by `gusset-interface headers`; do not edit.

use std::ffi::CStr;

/// The name of each choice, and its constants with their texts.
#[rustfmt::skip]
pub(super) const CHOICES: &[(&str, &[(u32, &CStr)])] = &[
    ("gusset_scene_entry_kind", &[
        (0, c"Net."),
        (1, c"Group of entries."),
    ]),
    ("gusset_visibility", &[
        (0, c"No change."),
        (1, c"Shows the entry."),
        (2, c"Hides the entry and its children."),
    ]),
];
