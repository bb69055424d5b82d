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

/// For each header, the name of each choice, and its constants with their texts.
#[rustfmt::skip]
static TABLES: [&[(&str, &[(u32, &CStr)])]; 8] = [
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
