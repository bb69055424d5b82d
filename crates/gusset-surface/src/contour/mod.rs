//! Tasks d) and b) of the paper: sections by planes, contours of scalar fields, and curves of
//! points whose normals make a given angle with a direction. All are zero sets of polynomials over
//! the cells.
//!
//! * `sections`: sections and contours; `isophote`: curves of equal angle, silhouettes among them;
//!   `nearest`: the angle nearest to a given one.
//! * `source`: the polynomials; `normals`, `projected_normals`: those of normals. `normal_frames`:
//!   points with their normals. `planes`, `cone_culling`: the blocks that they may vanish in, found
//!   by descent of the index.
//! * `contour_search`: block by block, cell by cell, level by level. `cell`: the arcs of a cell, by
//!   subdivision with proofs; `side`: where they cross its sides, by Descartes' rule;
//!   `corner_crossing`: those that the corners alone show. `contour_refinement`: the points between.
//! * `contour_chain`: arcs linked to paths; `paths`: those of all sheets joined; `creases`: sides that
//!   normals jump at. `contour_lattice`: numbers of cells and sides. `point_spacing`: the
//!   paper's approximation of a section.
//!
//! Points are computed on the interpolant: they are of its order, four; the order of chords between
//! them is two, whence the refinement. Invariant: the sign of a polynomial at a corner, and its
//! changes along a side, are decided once for all cells that share them, so that arcs join to the
//! bit. Cost: about O(blocks that a level may cross), and O(1) an arc.

mod cell;
mod cone_culling;
mod contour_chain;
mod contour_lattice;
mod contour_refinement;
mod contour_search;
mod corner_crossing;
mod creases;
mod isophote;
mod nearest;
mod normal_frames;
mod normals;
mod paths;
mod planes;
mod point_spacing;
mod projected_normals;
mod sections;
mod side;
mod source;

pub use nearest::NearestAngle;
pub use planes::Planes;
pub use point_spacing::PointSpacing;
