//! Sheets that are not given by a grid of nodes.
//!
//! - [`Tangents`]: nodes with given tangents; bicubic Hermite patches.
//! - [`Spline`]: tensor-product B-splines, converted to Bézier patches. Rational splines become
//!   polynomial patches of degree 7 within a proven distance.
//! - [`CurveNet`]: a net of curves across and along, or curves in one direction; the Gordon
//!   surface, which contains them.
//! - [`FrameSurface`]: a frame of outlines, by its sections, its nodes or its curves.
//! - [`Sheet::offset`](crate::Sheet::offset): the offset of a sheet, which is again a grid.
//!
//! Except for offsets, the results are Bézier patches whose neighbours agree exactly on their
//! common sides. Patches are never rational, because quotients lack the control nets from which
//! searches take bounds.

mod cardinal_pieces;
mod curve_net;
mod frame_surface;
mod hermite;
mod line_strips;
mod nearest_points;
mod net_curve;
mod net_order;
mod offset;
mod rational;
mod section_skin;
mod spline;
mod spline_sheet;

pub use curve_net::CurveNet;
pub use frame_surface::FrameSurface;
pub use hermite::{Tangents, Twists};
pub use spline::{Spline, SplineAxis, SplineOptions};
