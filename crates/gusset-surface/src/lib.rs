//! Smooth surfaces through nets of curves, and queries about them.
//!
//! The crate follows V. A. Leus, *Carcasses on smooth surfaces* (1976). The paper describes a
//! surface by a net of coordinate curves, a *carcass*, and searches it by bounds of the diameters
//! of cells. Here a [`Surface`] is a list of sheets, each with its net and a hierarchical index.
//! The errata of the paper are in `docs/errata.md` and in [`mod@reference`].
//!
//! | subject | where | task of the paper |
//! |---|---|---|
//! | sheets: through a grid of nodes, or of Bézier patches | [`Sheet`], [`Grid`], [`Patches`] | |
//! | sheets from curves, splines, tangents, frames | [`construct`] | |
//! | sheets and their index | [`Surface`] | |
//! | points, derivatives, normals, curvatures | [`Patch`], [`Jet`], [`Normal`], [`Curvatures`] | |
//! | nearest points, minima, cells within a distance | [`Closest`], [`Minima`], [`CellsInBall`] | a |
//! | isophotes, silhouettes | [`contour`] | b |
//! | intersections with lines, rays and curves | [`line_intersection`] | c |
//! | plane sections, contours of functions | [`contour`] | d |
//! | intersections of two surfaces; self-intersections | [`surface_intersection`] | e |
//! | nearest points of a surface and a disjoint line, curve or surface | [`NearestPoints`] | c, e |
//! | curves on a surface | [`Paths`] | |
//! | meshes of sheets | [`SurfaceMesh`] | |
//! | the paper's own search, for comparison | [`mod@reference`] | |
//!
//! Results are proven for the surface as given: a search discards a cell only if bounds show that
//! the cell cannot contain a solution. If a proof would take too long, the result says so.

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
mod ranges;
pub mod reference;
mod sheet;
mod subdivision;
pub mod surface_intersection;
mod tangents;
mod weighted_sum_ranges;
mod widen_kernel;

pub use axis::Scheme;
pub use curve::curve_through;
pub use distance::NearestPoints;
pub use evaluate::{Curvatures, LocalGeometry};
pub use grid::Grid;
pub use index::NormalCone;
pub use mesh::{SurfaceMesh, SurfaceMeshOptions};
pub use model::{LARGEST_COORDINATE, Place, SMALLEST_COORDINATE, Surface};
pub use nearest::{CellsInBall, Closest, Minima};
pub use nodes::{MAX_NODES, Nodes};
pub use normal::{Normal, NormalKind};
pub use patch::{Jet, Patch};
pub use patches::{MAX_DEGREE, Patches};
pub use path::{Contact, ContactKind, Paths};
pub use sheet::Sheet;
pub(crate) use sheet::each_sheet;
