//! Carcasses: curve nets on smooth surfaces, and questions about the surfaces.
//!
//! After V. A. Leus, *Carcasses on smooth surfaces* (1976): a surface is known by a net of coordinate curves, and searches on it are cut
//! short by bounds of the diameters of cells.
//!
//! * [`Grid`]: the surface through a grid of nodes. [`Patch`]: the surface over one cell.

mod axis;
mod cells;
mod closest;
mod grid;
mod index;
mod model;
mod patch;

pub use axis::Scheme;
pub use grid::{Grid, MAX_NODES, Nodes};
pub use model::{Carcass, Closest, Place};
pub use patch::{Jet, Patch};
