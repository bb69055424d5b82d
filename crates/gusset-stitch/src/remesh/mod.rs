//! Remeshing of the triangles of a patch inside a fixed rim: splits, flips, and refinement to good
//! angles.
//!
//! | file | task |
//! |---|---|
//! | [`patch_mesh`](self) | the triangles with their neighbours, and edits of them |
//! | [`delaunay_flips`](self) | flips to the Delaunay criterion |
//! | [`even_sides`](self) | long sides are halved, short sides collapsed |
//! | [`insert_vertices`](self) | new vertices in large or sharp triangles |
//! | [`iron_creases`](self) | creases are smoothed out |
//! | [`sizing`](self) | the wanted lengths of sides |
//! | [`settle_vertices`](self) | vertices move within the surface to improve their triangles |

mod delaunay_flips;
mod even_sides;
mod insert_vertices;
mod iron_creases;
mod patch_mesh;
mod settle_vertices;
mod sizing;
#[cfg(test)]
mod tests;

/// Number of triangles or vertices between two progress reports.
const ELEMENTS_PER_REPORT: usize = 1 << 12;

pub(crate) use even_sides::even_out_side_lengths;
pub(crate) use insert_vertices::refine_by_insertion;
pub(crate) use patch_mesh::PatchMesh;
pub(crate) use sizing::{VertexSizes, estimate_new_vertices, size_growth_for_limit};
