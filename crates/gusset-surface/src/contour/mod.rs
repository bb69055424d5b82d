//! Tasks d) and b) of the paper: plane sections, contours of scalar fields, and isophotes. All of
//! them are zero sets of polynomials over the cells.
//!
//! - `sections`: sections and contours; `isophote`: isophotes and silhouettes; `nearest_angle`: the
//!   angle nearest to a given one.
//! - `contour_source`: the polynomials; `normal_fields`, `projected_normals`: the polynomials of
//!   normals. `normal_frames`: points with their normals. `planes`, `cone_culling`: the blocks in
//!   which the polynomials may vanish, found by descent of the index.
//! - `contour_search`: the search, block by block, cell by cell, level by level. `cell_arcs`: the
//!   arcs of a cell, by subdivision with proofs; `side_sign_changes`: their marks on the sides, by
//!   Descartes' rule; `corner_crossing`: arcs that follow from the corners alone; `side_roots`:
//!   their ends. `contour_refinement`: points between the marks.
//! - `contour_chain`: arcs linked to paths; `contour_paths`: paths joined across sheets; `creases`:
//!   sides at which normals jump. `contour_lattice`: indices of cells and sides. `point_spacing`:
//!   the paper's approximation of a section.
//!
//! Points are computed on the interpolant, so they are of fourth order. Chords between marks are of
//! second order, so arcs are refined. Invariant: the sign of a polynomial at a corner, and its
//! changes along a side, are decided once for all cells there. Arcs therefore join exactly. Cost:
//! about O(blocks that a level may cross), and O(1) for each arc.

mod cell_arcs;
mod cone_culling;
mod contour_chain;
mod contour_lattice;
mod contour_refinement;
mod contour_search;
mod corner_crossing;
mod creases;
mod isophote;
mod nearest_angle;
mod normal_frames;
mod normal_fields;
mod contour_paths;
mod planes;
mod point_spacing;
mod projected_normals;
mod sections;
mod side_sign_changes;
mod side_roots;
mod contour_source;

pub use nearest_angle::NearestAngle;
pub use planes::Planes;
pub use point_spacing::PointSpacing;
