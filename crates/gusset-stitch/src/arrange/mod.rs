//! Exact arrangements of triangles, and the union of solids.
//!
//! * `coordinate_grid`, `wide_int`, `exact_points`: given points are integers on a grid. Constructed points have
//!   homogeneous coordinates of wide integers, and rounded ones that decide most comparisons.
//! * `contacts`: the points and segments in which two triangles meet.
//! * `planar_mesh`, `clusters`: the triangles of one plane, split along points and segments.
//! * `exact_arrangement`: all triangles, split so that two parts meet in a common vertex or edge, or
//!   coincide.
//! * `face_groups`, `outer_cells`, `cells`: the winding numbers of the cells between triangles.
//! * `sheets`: the triangles between cells outside and inside, as a manifold mesh.
//! * `mend`, `solid`, `rounds`: rounds that also remove the intersections that rounding makes.
//! * [`unite()`], [`split_intersecting_faces`]: the operations.
//!
//! Decisions are exact, up to coordinates below 2^-67 of the largest, whose lowest bits may be rounded.
//! The arrangement takes O((n + k) log n) for n triangles, k intersecting pairs and their crossings.
//!
//! * Q. Zhou, E. Grinspun, D. Zorin, A. Jacobson, Mesh arrangements for solid geometry, ACM
//!   Transactions on Graphics 35, 2016.

mod cells;
mod clusters;
mod contacts;
mod exact_arrangement;
mod exact_points;
mod face_groups;
mod coordinate_grid;
mod mend;
mod outer_cells;
mod planar_mesh;
mod rounds;
mod sheets;
mod solid;
mod split;
mod unite;
mod wide_int;

pub use split::{SplitFaces, split_intersecting_faces};
pub use unite::{Options, Union, unite};
pub(crate) use unite::{find_unbalanced_face, unite_with_suspects};
