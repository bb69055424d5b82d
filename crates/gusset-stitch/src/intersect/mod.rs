//! Intersecting triangles: exact predicates over a tree of boxes.
//!
//! * `predicates`: two triangles, decided exactly by the signs of determinants (Shewchuk's
//!   adaptive arithmetic).
//! * `common_segment`: the length of the segment that two triangles have in common.
//! * `triangle_fans`: groups of triangles that share a corner.
//! * [`triangle_pairs`]: all intersecting pairs of new triangles with each other and with old ones.

mod common_segment;
mod predicates;
mod triangle_fans;
mod triangle_pairs;

pub(crate) use common_segment::common_segment_length;
pub(crate) use predicates::{are_collinear, is_on_triangle, ray_meets_triangle};
pub(crate) use triangle_pairs::{TriangleSoup, intersecting_pairs, intersecting_pairs_where};
