//! Choices of gusset/scene.h.
//!
//! Written by `gusset-interface headers`; do not edit.

use super::Choice;

#[rustfmt::skip]
pub(super) const CHOICES: &[Choice] = &[
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
