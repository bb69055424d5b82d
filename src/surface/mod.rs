//! Surfaces: curve nets on smooth surfaces, and questions about the surfaces.
//!
//! After V. A. Leus, *Carcasses on smooth surfaces* (1976): a surface is known by a net of coordinate curves, and searches on it are cut
//! short by bounds of the diameters of cells.
//!
//! * [`Sheet`]: a piece of surface, a [`Grid`] of nodes or [`Patches`]. [`Patch`]: the surface over one cell.
//! * [`Surface`]: sheets and their index, which answers. [`Paths`]: curves on a surface.
//! * [`meet`]: where two surfaces intersect.

mod axis;
mod cells;
pub mod construct;
pub mod contour;
mod curve;
mod displacements;
mod estimate;
mod evaluate;
mod grid;
mod index;
pub mod line_intersection;
mod mesh;
mod model;
mod nearest;
mod nodes;
mod normal;
mod patch;
mod patches;
mod path;
mod ranges;
pub mod reference;
mod sheet;
mod subdivision;
pub mod surface_intersection;
mod sweep;
mod tangents;

pub use axis::Scheme;
pub use curve::curve_through;
pub use evaluate::{Curvatures, Local};
pub use grid::Grid;
pub use index::NormalCone;
pub use mesh::{SurfaceMesh, SurfaceMeshOptions};
pub use model::{LARGEST_COORDINATE, Place, SMALLEST_COORDINATE, Surface};
pub use nearest::{Closest, Minima, Region};
pub use nodes::{MAX_NODES, Nodes};
pub use normal::{Normal, NormalKind};
pub use patch::{Jet, Patch};
pub use patches::{MAX_DEGREE, Patches};
pub use path::Paths;
pub use sheet::Sheet;
pub(crate) use sheet::each_sheet;
