//! Smooth surfaces and questions about them.
//!
//! After V. A. Leus, *Carcasses on smooth surfaces* (1976). The paper's carcass is a surface that
//! is known by a net of coordinate curves, whose searches bounds of the diameters of cells cut
//! short; here it is a [`Surface`]: sheets with their nets and a hierarchical index.
//!
//! * [`Sheet`]: a piece of surface, a [`Grid`] of nodes or [`Patches`]. [`Patch`]: the surface over
//!   one cell. [`Jet`], [`Normal`], [`Curvatures`]: its derivatives, normals and curvatures.
//! * [`Surface`]: sheets and their index, which answers: nearest points (task a), normals at an
//!   angle (task b), [`line_intersection`] (task c), plane sections and other contours
//!   ([`contour`], task d), [`surface_intersection`] (task e), [`Approach`], where things do not
//!   meet. [`Paths`]: curves on a surface.
//! * [`construct`]: sheets from curves, splines and tangents. [`SurfaceMesh`]: sheets as meshes.
//! * [`mod@reference`]: the paper's own search, to compare with.

mod axis;
mod cells;
mod checks;
pub mod construct;
pub mod contour;
mod curve;
mod displacements;
mod distance;
mod estimate;
mod evaluate;
mod frontier;
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
mod prelude;
mod ranges;
pub mod reference;
mod sheet;
mod subdivision;
pub mod surface_intersection;
mod sweep;
mod tangents;

pub use axis::Scheme;
pub use curve::curve_through;
pub use distance::Approach;
pub use evaluate::{Curvatures, LocalGeometry};
pub use grid::Grid;
pub use index::NormalCone;
pub use mesh::{SurfaceMesh, SurfaceMeshOptions};
pub use model::{LARGEST_COORDINATE, Place, SMALLEST_COORDINATE, Surface};
pub use nearest::{Closest, Minima, Region};
pub use nodes::{MAX_NODES, Nodes};
pub use normal::{Normal, NormalKind};
pub use patch::{Jet, Patch};
pub use patches::{MAX_DEGREE, Patches};
pub use path::{Contact, ContactKind, Paths};
pub use sheet::Sheet;
pub(crate) use sheet::each_sheet;
