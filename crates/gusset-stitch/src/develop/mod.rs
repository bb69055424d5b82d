//! Developments: surfaces laid out in the plane with the least distortion, cut open where
//! necessary.
//!
//! Nadopta's outlines and frames serve one purpose, the upper of a shoe cut from flat leather. A
//! surface is cut along given curves, and opened where it is not a disc; each connected component
//! is a *chart*. A chart without curvature is unfolded about its edges, exactly. Any other chart
//! starts from a map without folds, and descends to the least distortion without folding. Darts
//! open it at places of high curvature.
//!
//! Sources: M. Rabinovich, R. Poranne, D. Panozzo, O. Sorkine-Hornung, *Scalable locally injective
//! mappings* (2017), for the descent. B. Lévy, S. Petitjean, N. Ray, J. Maillot, *Least squares
//! conformal maps* (2002), for conformal maps. W. Tutte, *How to draw a graph* (1963), for maps
//! without folds. J. Smith, S. Schaefer, *Bijective parameterization with free boundaries* (2015),
//! for the longest step without folds, and for charts without overlaps. J. Erickson, K. Whittlesey,
//! *Greedy optimal homotopy and homology generators* (2005), for the cuts.
//!
//! | file | subject |
//! |---|---|
//! | [`develop_request`](self) | options and results |
//! | [`cut_edges`](self) | cut edges; shortest paths |
//! | [`cut_to_discs`](self) | cuts that leave only discs |
//! | [`split_surface`](self) | the connected components of a cut surface |
//! | [`chart`](self) | one chart as triangles with their shapes |
//! | [`exact_unfolding`](self) | exact development about edges |
//! | [`chart_system`](self) | the linear system of one chart |
//! | [`start_maps`](self) | initial maps |
//! | [`energy`](self) | the distortion of one triangle |
//! | [`descend`](self) | least distortion |
//! | [`overlap`](self) | borders that cross in the plane |
//! | [`dart_tip`](self) | the best place for a dart |
//! | [`develop_run`](self) | from the mesh to the result |

mod chart;
mod chart_system;
mod split_surface;
mod cut_edges;
mod dart_tip;
mod descend;
mod develop_request;
mod develop_run;
mod energy;
mod exact_unfolding;
mod cut_to_discs;
mod overlap;
mod start_maps;
#[cfg(test)]
mod degenerate_tests;

pub use develop_request::{Chart, CutKind, Cuts, Developed, Distortion, Finish, Options};
pub use develop_run::develop;

/// The progress message.
const STAGE: &str = "developing";
/// Number of triangles that are added to a system between two progress reports.
const TRIANGLES_PER_REPORT: usize = 1 << 16;
