//! Developments: surfaces laid out in the plane with the least distortion, cut open where they must
//! be.
//!
//! Nadopta's outlines and frames serve one purpose, the upper of a shoe cut from flat leather. A
//! surface is cut along given curves, and where it would still be no disc; each connected component
//! of the rest, a *chart*, is laid out. A chart whose triangles meet without curvature is unfolded
//! about its edges, exactly. Any other starts from a map that folds nowhere, and descends to the
//! least distortion without ever folding; darts open it where the curvature is.
//!
//! Sources: M. Rabinovich, R. Poranne, D. Panozzo, O. Sorkine-Hornung, *Scalable locally injective
//! mappings* (2017), for the descent; B. Lévy, S. Petitjean, N. Ray, J. Maillot, *Least squares
//! conformal maps* (2002), for conformal maps; W. Tutte, *How to draw a graph* (1963), for maps
//! without folds; J. Smith, S. Schaefer, *Bijective parameterization with free boundaries* (2015),
//! for the longest step that folds nothing and for charts that do not overlap; J. Erickson,
//! K. Whittlesey, *Greedy optimal homotopy and homology generators* (2005), for the cuts.
//!
//! | file | subject |
//! |---|---|
//! | [`develop_request`](self) | what is asked for, and what is returned |
//! | [`cut_edges`](self) | edges along which the surface is cut; shortest paths |
//! | [`opening`](self) | cuts that leave discs only |
//! | [`charts`](self) | the connected components of the surface that was cut |
//! | [`chart`](self) | one chart as triangles with their shapes |
//! | [`exact_unfolding`](self) | exact development about edges |
//! | [`chart_system`](self) | the linear equations of one chart |
//! | [`start_maps`](self) | maps to begin with |
//! | [`energy`](self) | the distortion of one triangle |
//! | [`descend`](self) | least distortion |
//! | [`overlap`](self) | borders that cross in the plane |
//! | [`darts`](self) | where a dart reduces distortion most |
//! | [`develop_run`](self) | from the mesh to the result |

mod chart;
mod chart_system;
mod charts;
mod cut_edges;
mod darts;
mod descend;
mod develop_request;
mod develop_run;
mod energy;
mod exact_unfolding;
mod opening;
mod overlap;
mod start_maps;

pub use develop_request::{Chart, CutKind, Cuts, Developed, Distortion, Finish, Options};
pub use develop_run::develop;

/// The stage of progress.
const STAGE: &str = "developing";
/// Triangles that are entered into equations between two progress reports.
const TRIANGLES_PER_REPORT: usize = 1 << 16;
