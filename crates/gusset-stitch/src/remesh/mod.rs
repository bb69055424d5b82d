//! Remeshing of the triangles of a patch inside a fixed rim: splits, flips, and refinement to good
//! angles.
//!
//! | file | task |
//! |---|---|
//! | [`patch_mesh`](self) | the triangles with their neighbours, and edits of them |
//! | [`delaunay`](self) | flips to the Delaunay criterion |
//! | [`even`](mod@even) | long sides are halved, short sides collapsed |
//! | [`insert`](self) | new vertices in large or sharp triangles |
//! | [`iron`](self) | creases are smoothed out |
//! | [`sizing`](self) | the wanted lengths of sides |
//! | [`settle`](self) | vertices move within the surface to improve their triangles |

mod delaunay;
mod even;
mod insert;
mod iron;
mod patch_mesh;
mod settle;
mod sizing;
#[cfg(test)]
mod tests;

/// Number of triangles or vertices between two progress reports.
const REPORT_INTERVAL: usize = 1 << 12;

pub(crate) use even::even;
pub(crate) use insert::refine;
pub(crate) use patch_mesh::PatchMesh;
pub(crate) use sizing::{Sizing, size_growth, vertices_needed};
