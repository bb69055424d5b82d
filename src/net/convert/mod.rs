//! Nets to polygon meshes and back, and nets from heights and range images.
//!
//! `mesh` makes meshes, `texture` their texture coordinates, `wires` what has no face; `grid` finds the rows and columns of a
//! mesh of quads; `heights` reads images; `hidden` sorts hidden cells.

mod grid;
mod heights;
mod mesh;
mod taken;
mod texture;
mod wires;

pub use grid::{GridNet, net_of_grid};
pub use heights::{Heights, net_of_heights, net_of_points};
pub use mesh::{Diagonal, MeshOptions, NetMesh};
pub use texture::Texture;
