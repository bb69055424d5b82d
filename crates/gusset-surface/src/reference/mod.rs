//! The paper's search with its logical scale, corrected: a documented reference, and an oracle for
//! tests. [`crate::Surface`] answers the same queries by its index, and its work does not grow with
//! the number of cells.
//!
//! V. A. Leus, *Carcasses on smooth surfaces* (1976): every cell begins with a 1 on a logical
//! scale, here a [`CellMask`]. A node A at distance r from the object excludes the block of 2 J x 2
//! J cells around it, if chains of J cells are shorter than r. Their bits become 0, and their nodes
//! are not evaluated.
//!
//! **Theorems.** Let O be the object, d_c the diameter of cell c, and d the largest diameter. Let
//! B_J(A) be the cells [i - J, i + J - 1] x [j - J, j + J - 1] around node A = (i, j) that exist.
//! - *T1, chains.* From a cell at A, a chain of at most J cells leads to any cell of B_J(A) by the
//!   moves of the king. Consecutive cells share a point. Let R_J(A) be the sum over k = 1..J of the
//!   largest d_c in ring k, which is at most J d. Then |x - A| <= R_J(A) for all x in B_J(A).
//! - *T2, incidence.* If R_J(A) < dist(A, O) - tau, all x in B_J(A) have dist(x, O) > tau, because
//!   distance is 1-Lipschitz. The scan keeps every cell with a point within tau.
//! - *T3, nearest.* Let rho be the smallest distance found so far. R_J(A) < dist(A, O) - rho
//!   excludes only points farther than rho. The last record and the remaining cells contain the
//!   minimum.
//! - *T4, angles.* Replace points by normals: |angle(N, direction) - alpha| is 1-Lipschitz in N,
//!   and the variation of a cell's normals takes the place of its diameter.
//! - *Curves.* All theorems hold for curves: their points are the nodes, their arcs the cells, and
//!   lengths of arcs the diameters. See [`CurveArcs`]. Distances are also measured from curves and
//!   surfaces: see [`Figure`].
//! - *T5, hierarchy.* A block may be excluded by any set that contains it. Balls of radius J d
//!   around nodes are one choice; the index uses boxes.
//!
//! **Errata** of the paper, each with a test that demonstrates it:
//! - *E1* One bit for each node loses cells: nodes on the rim of a block belong to cells outside
//!   it. Here, bits belong to cells.
//! - *E2* With J = floor(r / d), the block may touch O. Here, J d < r - tau, strictly.
//! - *E3* The rule is a test of incidence. It excludes the nearest point if that point is farther
//!   than d. Here, the record is subtracted.
//! - *E4* The angle must be compared with |angle - alpha|, and normals without sign with the nearer
//!   of both. K must bound both curvatures everywhere. Where the surface is not regular, the method
//!   proves nothing.
//! - *E5* Lines may be dropped only if a block covers them from side to side and reaches an edge.
//!   Otherwise two surfaces remain.
//! - *E6* A net of curves does not determine d: see [`Diameters`].
//! - *E7* Signs at nodes miss loops within a cell, two crossings on a side, and contacts; they pair
//!   four crossings wrongly. Parts of cells must be examined.
//! - *E8* The Euclidean diameter suffices for distances. Only K d requires the intrinsic one.

mod arcs;
mod cell_chains;
mod cell_grid_shape;
mod cell_mask;
mod curvature;
mod diameter;
mod figure;
mod normal_variation;
mod object;
mod reference_search;
mod section_normal;
mod cell_sizes;

pub use arcs::{CurveArcs, MAX_ARCS};
pub use cell_chains::{euler_characteristic, integer_diameter, shortest_chain};
pub use cell_grid_shape::CellGridShape;
pub use cell_mask::CellMask;
pub use cell_sizes::{CellBoundSum, CellSizeBounds};
pub use curvature::curvature_bound;
pub use diameter::Diameters;
pub use figure::{Figure, find_cells_near_figure};
pub use normal_variation::{
    AngleTarget, find_cells_with_angle, normal_variation_by_cones, normal_variation_by_curvature,
};
pub use object::{OrthonormalBox, PointPlaneOrLine, find_cells_near_object};
pub use reference_search::{SearchGoal, SearchOptions, SearchOutcome, search};
pub use section_normal::normal_by_sections;
