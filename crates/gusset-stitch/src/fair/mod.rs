//! Thin-plate fairing: the free vertices of a triangle patch move to minimise its bending energy;
//! the others are fixed.
//!
//! Sources: M. Botsch, L. Kobbelt, *An intuitive framework for real-time freeform modeling* (2004),
//! and P. Liepa, *Filling holes in meshes* (2003), section 5. Both minimise the thin-plate energy,
//! the sum over vertices of the squared Laplacian. Its minimum solves the bi-Laplacian equation.
//! Two rows of vertices around the free ones are fixed: the rim, and the old vertices next to it.
//! The new surface then joins the old one without a crease.
//!
//! For curvature continuity, the energy is the sum over edges of the squared differences of
//! Laplacians. Its minimum solves the tri-Laplacian equation, with three rows of fixed vertices.
//!
//! A plate may have a rest shape. Its energy is then the sum of squared differences from given
//! Laplacians (M. Botsch, O. Sorkine, *On linear variational surface deformation methods*, 2008).
//! It keeps its shape where it is wide.
//!
//! | file | task |
//! |---|---|
//! | [`one_rings`](self) | the neighbours of each vertex and their weights |
//! | [`continuity`](self) | the continuity of a plate with its surroundings |
//! | [`exact_laplacian`](self) | a Laplacian that is exact for quadratic functions |
//! | [`curvature`](self) | the curvature of a patch, without the detail of its triangles |
//! | [`plate`](self) | the energy's normal equations, and the new positions |
//! | [`plate_couplings`](self) | the unknowns that the equations couple |

mod continuity;
mod plate_couplings;
mod curvature;
mod exact_laplacian;
mod plate;
mod one_rings;
#[cfg(test)]
mod tests;

pub use continuity::Continuity;
pub(crate) use curvature::mean_curvature;
pub(crate) use one_rings::LaplacianWeights;
pub(crate) use plate::{Plate, RestShape, minimise_plate_energy};
