//! Sheets from other things than a bare grid of nodes.
//!
//! * [`Tangents`]: nodes with given tangents; bicubic Hermite patches.
//! * [`Spline`]: tensor-product B-splines, cut into their Bézier patches; rational ones become
//!   polynomial patches of degree 7 within a distance that is proven.
//! * [`CurveNet`]: curves across and along that meet, or curves across alone; Gordon's surface,
//!   which contains them.
//! * [`FrameSurface`]: a frame of outlines, its nodes or its curves.
//! * [`Sheet::offset`](crate::Sheet::offset): the surface beside another one, a grid again.
//!
//! All others give Bézier patches that share their sides to the bit. Patches themselves are never
//! rational: quotients have no control nets that the bounds of searches could be taken from.

mod blend;
mod curve_net;
mod frame_surface;
mod hermite;
mod nearest_points;
mod net_curve;
mod offset;
mod rational;
mod spline;
mod spline_sheet;

pub use curve_net::CurveNet;
pub use frame_surface::FrameSurface;
pub use hermite::{Tangents, Twists};
pub use spline::{Spline, SplineAxis, SplineOptions};
