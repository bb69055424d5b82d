//! Operations on curves: queries about a piecewise Bézier curve, and curves derived from it.
//!
//! They are methods of [`CurveView`](super::CurveView), with one file for each subject:
//!
//! - evaluate: points, derivatives, tangents and curvatures at places.
//! - split, degree: parts of a curve, its reverse, other degrees.
//! - nearest: the nearest point of a curve.
//! - length, [`ArcLengths`]: arc length and its inverse.
//! - area, [`AreaMoments`]: integrals over the region that a curve encloses.
//! - bounds: the exact bounding box.
//! - measures, [`Measures`]: several measures in one call.
//! - intersect_line: intersections with lines and planes.
//! - tangent_angle: the points whose tangents make a given angle with a direction.
//! - intersect, segment_intersection: intersections of plane curves, and self-intersections.
//! - near_misses: minima of the distance between curves in space. meetings: intersections or near
//!   misses.
//! - curve_offset: the offset curve.
//! - resample, [`SampledPoints`]: points along a curve.
//! - export: SVG paths, TrueType contours, B-splines.
//!
//! They use Bernstein polynomials from gusset-base, and the closed form of cubic.
//!
//! Every operation works in a unit frame, in which the curve has a size of about 1. It is exact, or
//! stops at an error relative to that size. Sizes of 1e200 and 1e-200 are therefore equally
//! accurate. Results that f64 cannot represent, such as an area of 1e400, become infinite or 0.

mod area;
mod bounds;
mod cubic_roots;
mod curve_offset;
mod degree;
mod evaluate;
mod export;
mod intersect;
mod intersect_line;
mod length;
mod measures;
mod meetings;
mod near_miss_bounds;
mod near_misses;
mod nearest;
mod segment_part;
mod resample;
mod segment_intersection;
mod split;
mod tangent_angle;

pub use area::AreaMoments;
pub use bounds::Bounds;
pub use curve_offset::{Offset, OffsetOptions};
pub use degree::CurveOfReducedDegree;
pub use export::{ClampedSpline, TrueTypeContour};
pub use intersect::{Intersection, Intersections, Overlap};
pub use intersect_line::PlaneIntersections;
pub use length::ArcLengths;
pub use measures::{MeasureSelection, Measures};
pub use near_misses::{NearMiss, NearMisses};
pub use nearest::NearestCurvePoint;
pub use nearest::{CurveSearch, nearest_of_any};
pub use resample::{SampleSpacing, SampledPoints};
pub use tangent_angle::TangentAngles;
