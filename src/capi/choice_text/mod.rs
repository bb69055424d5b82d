//! The text of each constant of a choice: the first sentence of its comment.
//!
//! Written by `gusset-interface headers`; do not edit.

use std::ffi::CStr;

mod base;
mod curve;
mod mesh;
mod net;
mod papers;
mod scene;
mod stream;
mod surface;

/// The name of a choice, and its constants with their texts.
type Choice = (&'static str, &'static [(u32, &'static CStr)]);

/// The choices of each header.
#[rustfmt::skip]
static TABLES: [&[Choice]; 8] = [
    base::CHOICES,
    curve::CHOICES,
    mesh::CHOICES,
    net::CHOICES,
    papers::CHOICES,
    scene::CHOICES,
    stream::CHOICES,
    surface::CHOICES,
];

/// The text of a constant of a choice; none if either is unknown.
pub(super) fn choice_text(choice: &str, value: u32) -> Option<&'static CStr> {
    let (_, texts) = TABLES.into_iter().flatten().find(|(name, _)| *name == choice)?;
    texts.iter().find(|(constant, _)| *constant == value).map(|(_, text)| *text)
}
