//! Sections of polygon meshes by planes: ordered polylines with their nesting and their sources.
//!
//! - `section_request`: the options. `sections`: the polylines. `cut_mesh`: the cuts.
//! - `cutting_planes`: planes, stacks of parallel planes, planes about an axis, planes across a
//!   polyline. `exact_plane`: the side of a point, decided exactly.
//! - `cut_stack`: the vertices sorted between the planes of a stack, and the faces that each plane
//!   crosses, found by a counting sort.
//! - `face_crossings`: the segments of a plane in its faces. `crossing_nodes`: the points where
//!   segments meet, and the pairs of segments that continue each other. `section_tracer`: the
//!   segments linked to polylines.
//! - `nesting_levels`: the loops around a loop. `open_loops`: the set in which they are counted.
//!   `simplify_polyline`: fewer points within a tolerance.
//!
//! **The rule for vertices in a plane.** A vertex in the plane counts as above it, or as below it
//! if the caller says so ([`InPlane`]). Every edge thus crosses the plane or does not, and every
//! face has an even number of crossings. A closed manifold therefore gives closed loops only. The
//! section is the limit of the sections below the plane (or above it):
//!
//! - A face in the plane gives nothing itself. Its edges appear where the neighbouring face lies
//!   below (above).
//! - A ridge in the plane, with both faces below, gives a loop that runs there and back.
//! - A peak in the plane gives nothing, because its loop is a single point.

mod crossing_nodes;
mod cut_mesh;
mod cut_stack;
mod cutting_planes;
mod exact_plane;
mod face_crossings;
mod nesting_levels;
mod open_loops;
mod section_request;
mod section_tracer;
mod sections;
mod simplify_polyline;
#[cfg(test)]
mod section_tests;

pub use cut_mesh::{cut_by_planes, cut_by_stack};
pub use cutting_planes::{Plane, PlaneStack, planes_about_axis, planes_across_polyline};
pub use section_request::{InPlane, Options};
pub use sections::{SectionPath, Sections};
