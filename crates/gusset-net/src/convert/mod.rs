//! Conversion: nets to polygon meshes and back, and nets from height fields.
//!
//! `mesh` makes meshes and their texture coordinates. `glued_edges` lists the edges that diagonals
//! must avoid. `grid` finds the rows and columns of a quad mesh, `triangles` finds them in a mesh
//! of quads that are cut in two. `heights` builds nets from height fields.

mod glued_edges;
mod grid;
mod heights;
mod mesh;
mod triangles;

pub use grid::{RecognisedNet, net_of_grid};
pub use heights::{Heights, net_of_heights};
pub use mesh::{Diagonal, MeshOptions, NetMesh, TextureCoordinates};
pub use triangles::net_of_triangles;
