//! Thin-plate fairing: some vertices of a triangle patch move so that the patch bends as little as
//! possible, the rest stay.
//!
//! Source: M. Botsch, L. Kobbelt, *An intuitive framework for real-time freeform modeling* (2004),
//! and P. Liepa, *Filling holes in meshes* (2003), section 5, which both minimise the thin-plate
//! energy, the sum over vertices of the squared Laplacian. Its minimum solves the bi-Laplacian
//! equation; with two rows of fixed vertices round the free ones, the rim and the old vertices next
//! to it, the new surface leaves the old one without a crease. The sum over edges of the squared
//! differences of Laplacians, whose minimum solves the tri-Laplacian equation, goes on with the
//! curvature as well, of three rows of fixed vertices. A plate that is bent by itself, whose
//! energy is the sum of squared differences from Laplacians that are given (M. Botsch, O. Sorkine,
//! *On linear variational surface deformation methods*, 2008), keeps its shape where it is wide.
//!
//! | file | what it does |
//! |---|---|
//! | [`rings`](self) | the neighbours of each vertex and their weights |
//! | [`continuity`](self) | what a plate has in common with what it is clamped to |
//! | [`exact_laplacian`](self) | a Laplacian that is exact for quadratic functions |
//! | [`curvature`](self) | how a patch bends, without the detail of its triangles |
//! | [`plate`](self) | the energy's normal equations, and the new places |
//! | [`couplings`](self) | the unknowns that the equations couple |

mod continuity;
mod couplings;
mod curvature;
mod exact_laplacian;
mod plate;
mod rings;
#[cfg(test)]
mod tests;

pub use continuity::Continuity;
pub(crate) use curvature::mean_curvature;
pub(crate) use plate::{Plate, Shape, thin_plate};
pub(crate) use rings::Weights;
