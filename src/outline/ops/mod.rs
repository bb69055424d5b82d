//! Operations on curves: what can be asked of a piecewise Bézier curve, and what can be made of it.
//!
//! They are methods of [`CurveView`], one file for each subject:
//!
//! * evaluate: points, derivatives, tangents and curvatures at places.
//! * split, degree: parts of a curve, its reverse, other degrees.
//! * nearest: the point nearest to a given one.
//! * length, [`Lengths`]: arc length and its inverse. area, [`Moments`]: integrals over what a curve encloses.
//! * bounds: the exact bounding box.
//! * cross: crossings with lines and planes.
//! * approach: where two curves in space come near to each other.
//! * meet, pair: common points of two plane curves, and of one with itself.
//! * offset: the curve at a distance.
//! * resample, [`Samples`]: points along a curve.
//! * export: SVG paths, TrueType contours, B-splines.
//!
//! What they stand on: frame (numbers near 1, whatever the unit), [`bernstein`](crate::geom::bernstein) (polynomials on 0 to 1 and where they
//! vanish), cubic (the closed form).
//!
//! Every operation measures in a frame in which the curve has about size 1, and is exact, or stops, at an error relative to
//! that size. Lengths of 1e200 and 1e-200 are as good as others; results that f64 cannot hold, such as an area of 1e400,
//! become infinite or 0.

mod approach;
mod area;
mod bounds;
mod cross;
mod cubic;
mod degree;
mod evaluate;
mod export;
mod frame;
mod length;
mod meet;
mod nearest;
mod offset;
mod pair;
mod resample;
mod split;

pub use approach::{Approach, Approaches, Beside};
pub use area::Moments;
pub use bounds::Bounds;
pub use cross::Crossings;
pub use degree::Reduced;
pub use export::{Contour, Spline};
pub use length::Lengths;
pub use meet::{Meeting, Meetings, Overlap};
pub use nearest::Nearest;
pub(crate) use nearest::nearest_of_any;
pub use offset::{Offset, OffsetOptions};
pub use resample::Samples;
pub(crate) use resample::Spacing;

use super::curve::{Curve, CurveView, Place};
use crate::error::{Error, Result};
use glam::DVec3;

/// Appends a segment to a curve as long as its control points can be counted in 32 bits.
fn append(curve: &mut Curve, rest: &[DVec3]) -> Result<()> {
    let count = (curve.points.len() + rest.len()) as u64;
    let limit = u64::from(u32::MAX);
    if count > limit {
        return Err(Error::TooLarge { what: "control points", count, limit });
    }
    curve.push(rest)
}

impl CurveView<'_> {
    /// That there is such a place on the curve; `index` counts the places given.
    fn check_place(&self, index: usize, place: Place) -> Result<()> {
        if (place.segment as usize) < self.len() && (0.0..=1.0).contains(&place.t) {
            return Ok(());
        }
        Err(Error::NoSuchPlace { index: index as u32, segment: place.segment, t: place.t })
    }

    /// That the curve has a point at all.
    fn check_not_empty(&self) -> Result<()> {
        if self.points().is_empty() { Err(Error::EmptyCurve) } else { Ok(()) }
    }

    /// That the curve lies in the plane z = 0.
    fn check_plane(&self) -> Result<()> {
        match self.points().iter().position(|p| p.z != 0.0) {
            Some(point) => Err(Error::CurveNotPlane { point: point as u32 }),
            None => Ok(()),
        }
    }
}
