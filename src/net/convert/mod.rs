//! Conversion: nets to polygon meshes and back, and nets from height fields and range images.
//!
//! `mesh` makes meshes, `texture` their texture coordinates, `wires` the edges without faces,
//! `used_links` the edges that diagonals must avoid; `grid` finds the rows and columns of a mesh of
//! quads; `heights` reads images.

mod grid;
mod heights;
mod mesh;
mod texture;
mod used_links;
mod wires;

pub use grid::{GridNet, net_of_grid};
pub use heights::{Heights, net_of_heights, net_of_points};
pub use mesh::{Diagonal, MeshOptions, NetMesh};
pub use texture::Texture;
