//! The paper's search with its logical scale, corrected: a documented reference, and the oracle of
//! tests. For questions use the index: [`crate::Surface`] answers the same, and its work
//! does not grow with the number of cells.
//!
//! V. A. Leus, *Carcasses on smooth surfaces* (1976): every cell begins with a 1 on a logical
//! scale, here a [`CellMask`]. A node A at a distance r from the object excludes the block of 2 J x
//! 2 J cells round it, if chains of J cells are shorter than r; their bits become 0 and their nodes
//! are not evaluated.
//!
//! **Theorems.** Let O be the object, d_c the diameter of cell c, d the greatest of them, and
//! B_J(A) the cells [i - J, i + J - 1] x [j - J, j + J - 1] round node A = (i, j), as far as they
//! exist.
//! * *T1, chains.* From a cell at A a chain of at most J cells leads to any cell of B_J(A), by the
//!   moves of the king, and consecutive cells have a point in common. So |x - A| <= R_J(A) = sum
//!   over k = 1..J of the greatest d_c in ring k, which is no more than J d, for all x in B_J(A).
//! * *T2, incidence.* If R_J(A) < dist(A, O) - tau, all x in B_J(A) have dist(x, O) > tau, as
//!   distance is 1-Lipschitz. The scan leaves every cell that has a point within tau.
//! * *T3, nearest.* With rho the least distance found so far, R_J(A) < dist(A, O) - rho excludes
//!   nothing that is as near as rho. The last record and the cells that are left hold the least.
//! * *T4, angles.* The same with normals for points: |angle(N, direction) - alpha| is 1-Lipschitz
//!   in N, and the variation of a cell's normals takes the part of its diameter.
//! * *Curves.* All of this holds for curves, whose points are the nodes and whose arcs, by their
//!   lengths, the cells: see [`Arcs`]. Distances are measured from curves and surfaces, too, see
//!   [`Figure`].
//! * *T5, hierarchy.* A block may be excluded by any set that contains it. Balls of radius J d
//!   round nodes are one choice; the index takes boxes.
//!
//! **Errata** of the paper, each with a test that shows it:
//! * *E1* A bit a node loses cells: nodes on the rim of a block belong to cells outside it. Here
//!   bits are the cells'.
//! * *E2* J = floor(r / d) lets the block touch O. Here J d < r - tau, strictly.
//! * *E3* The rule is a test of incidence; it excludes the nearest point if that is farther than d.
//!   Here the record is subtracted.
//! * *E4* The angle must be compared with |angle - alpha|, normals without sign with the nearer of
//!   both; K must bound both curvatures all over, and nothing is said where the surface is not
//!   regular.
//! * *E5* Lines may be dropped only if a block covers them from side to side and reaches an edge,
//!   else two surfaces are left.
//! * *E6* d cannot be found from a net of curves: see [`Diameters`].
//! * *E7* Signs at nodes miss loops within a cell, two crossings on a side, and touching; they pair
//!   four crossings wrongly. Parts of cells must be examined.
//! * *E8* The Euclidean diameter suffices for distances; the intrinsic one is needed for K d only.

mod arcs;
mod cell_chains;
mod cell_lattice;
mod cell_mask;
mod curvature;
mod diameter;
mod figure;
mod normal_variation;
mod object;
mod reference_search;
mod section_normal;
mod sizes;

pub use arcs::{Arcs, MAX_ARCS};
pub use cell_chains::{chain, euler_characteristic, integer_diameter};
pub use cell_lattice::Lattice;
pub use cell_mask::CellMask;
pub use curvature::curvature_bound;
pub use diameter::Diameters;
pub use figure::{Figure, figure_incidence};
pub use normal_variation::{AngleTarget, angle_incidence, normal_variation_by_cones, normal_variation_by_curvature};
pub use object::{Object, Target, incidence};
pub use reference_search::{Goal, SearchOptions, SearchOutcome, search};
pub use section_normal::normal_by_sections;
pub use sizes::{Sizes, Sum};
