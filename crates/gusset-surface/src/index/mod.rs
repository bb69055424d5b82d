//! The index of a sheet: a quad pyramid of bounding boxes over blocks of 4 x 4 cells.
//!
//! The pyramid does not need pointers: the children of block (r, c) are the blocks (2r, 2c), (2r,
//! 2c + 1), (2r + 1, 2c) and (2r + 1, 2c + 1) of the level below. It is built from the nodes,
//! without patches: a cell lies within its displacements (`displacements`) from the hull of its
//! corners. Cones of normals (`normal_cones`) are built on first use.
//!
//! Invariant, the study's theorem T5: a block may be excluded by any set that contains it. O(n) to
//! build, about 7 bytes for each node, on the job's threads.

mod boxes;
mod normal_cones;
mod pyramid;
mod schedule;
mod slab;

pub(crate) use boxes::OrientedBox;
pub(crate) use normal_cones::ConePyramid;
pub use normal_cones::NormalCone;
pub(crate) use pyramid::BoxPyramid;
pub(crate) use slab::LineSlabTest;
