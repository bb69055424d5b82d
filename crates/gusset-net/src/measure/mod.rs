//! Area, volume, moments and bounding boxes of nets, and the planarity of their cells.
//!
//! A cell is the bilinear patch through its corners a, b, c, d. With N = (c - a) x (d - b):
//!
//! - its area vector is N / 2, as for any surface with the same boundary;
//! - its share of the volume, by the divergence theorem, is (a + b + c + d) . N / 24, which is
//!   exact for the patch;
//! - its area is |N| / 2: the midpoint rule, which is exact for plane cells, otherwise of second
//!   order in their size. [`bilinear_area`] computes the patch's area up to rounding.
//!
//! Cells with coincident corners need no other formulas: a triangle is a patch with a side of
//! length 0, and a line or a point adds 0. Invariant: sums are in double precision and in a fixed
//! order, for any number of threads and any vector width. O(nodes).

mod bilinear;
mod moments;
mod planarity;
mod sums;

pub use bilinear::{BilinearArea, bilinear_area};
pub use moments::{Moments, moments};
pub use planarity::{Planarity, planarity};
pub use sums::{Measures, measure};
