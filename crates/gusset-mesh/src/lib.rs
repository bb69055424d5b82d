//! Polygon meshes: a validated view of the host's own arrays, an owned mesh for results, and the
//! pairing of half-edges.
//!
//! - [`MeshView`] borrows positions and faces from the host's memory (any stride, any alignment,
//!   `f32` or `f64`, polygons of any degree). It validates them once, so that the algorithms need
//!   no checks.
//! - [`Mesh`] owns its arrays; the algorithms return it.
//! - [`concatenate`] puts many meshes into one.
//! - [`triangulate()`] splits faces into triangles.
//! - [`merge`] finds vertices that coincide but are kept apart for the values that they carry.
//! - [`Topology`] tells which half-edges share an edge.
//! - [`section`] cuts a mesh by planes.
//!
//! **Half-edges** have the indices of corners. Half-edge `h` starts at the vertex of corner `h` in
//! the corner array and ends at the vertex of the next corner of the face.

#[doc(hidden)]
pub mod concat;
mod defect;
mod face_triangles;
mod half_edge_pairing;
pub mod merge;
mod owned;
mod positions;
pub mod section;
mod topology;
mod view;

pub use concat::{PieceOffsets, concatenate};
pub use defect::Defect;
pub use face_triangles::{FaceTriangles, TriangulatedMesh, triangulate};
pub use gusset_base::NONE;
pub use half_edge_pairing::Topology;
pub use owned::{Mesh, PositionBuffer};
#[doc(hidden)]
pub use positions::check_size;
pub use positions::{MAX_ELEMENTS, Positions, Scalar};
pub use topology::{Opposite, half_edges, unordered, vertex_components};
#[doc(hidden)]
pub use view::FaceVisitor;
pub use view::{Faces, MeshView};
