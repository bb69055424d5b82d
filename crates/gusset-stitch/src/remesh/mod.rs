//! Triangles of a patch inside a rim that stays: splits, flips, and refinement to good angles.
//!
//! | file | what it does |
//! |---|---|
//! | [`patch_mesh`](self) | the triangles with their neighbours, and edits of them |
//! | [`delaunay`](self) | flips to Delaunay's rule |
//! | [`even`](mod@even) | long sides halved, short ones collapsed |
//! | [`insert`](self) | new vertices where triangles are large or sharp |
//! | [`iron`](self) | creases ironed out |
//! | [`sizing`](self) | how long sides should be |
//! | [`settle`](self) | vertices moved within the surface to where their triangles are better |

mod delaunay;
mod even;
mod insert;
mod iron;
mod patch_mesh;
mod settle;
mod sizing;
#[cfg(test)]
mod tests;

/// Triangles or vertices between two progress reports.
const REPORT_INTERVAL: usize = 1 << 12;

pub(crate) use even::even;
pub(crate) use insert::insert;
pub(crate) use patch_mesh::PatchMesh;
pub(crate) use sizing::{Sizing, growth, needed};
