//! Polygon meshes: a validated view of the host's own arrays, an owned mesh for results, and the
//! pairing of half-edges.
//!
//! * [`MeshView`] borrows positions and faces as they lie in the host's memory (any stride, any
//!   alignment, `f32` or `f64`, polygons of any degree) and holds them to the rules once, so that
//!   the algorithms need not.
//! * [`Mesh`] owns its arrays; it is what the algorithms return.
//! * [`concatenate`] puts many meshes side by side in one.
//! * [`merge`]: which vertices are one, of those that are kept apart for the values that they carry.
//! * [`Topology`] says which half-edges share an edge.
//!
//! **Half-edges** are numbered by corners: half-edge `h` starts at the vertex that corner `h` of
//! the corner array names and runs to the vertex of the next corner of the same face.

#[doc(hidden)]
pub mod concat;
mod defect;
mod half_edge_pairing;
pub mod merge;
mod owned;
mod positions;
mod topology;
mod view;

pub use concat::{Piece, concatenate};
pub use defect::Defect;
pub use gusset_base::NONE;
pub use half_edge_pairing::Topology;
pub use owned::{Mesh, PositionBuffer};
#[doc(hidden)]
pub use positions::check_size;
pub use positions::{MAX_ELEMENTS, Positions, Scalar};
pub use topology::{Across, half_edges, unordered, vertex_components};
#[doc(hidden)]
pub use view::Visitor;
pub use view::{Faces, MeshView};
