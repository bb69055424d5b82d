//! Intersecting triangles: exact predicates over a tree of boxes.
//!
//! * `predicates`: two triangles, decided exactly by the signs of determinants (Shewchuk's
//!   adaptive arithmetic).
//! * `fans`: groups of triangles that share a corner.
//! * [`pairs`]: all intersecting pairs of new triangles with each other and with old ones.

mod fans;
mod pairs;
mod predicates;

pub(crate) use pairs::{Soup, intersecting_pairs, intersecting_pairs_where};
