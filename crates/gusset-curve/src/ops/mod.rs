//! Operations on curves: what can be asked of a piecewise Bézier curve, and what can be made of it.
//!
//! They are methods of [`CurveView`](super::CurveView), one file for each subject:
//!
//! * evaluate: points, derivatives, tangents and curvatures at places.
//! * split, degree: parts of a curve, its reverse, other degrees.
//! * nearest: the point nearest to a given one.
//! * length, [`Lengths`]: arc length and its inverse. area, [`Moments`]: integrals over the region
//!   that a curve encloses.
//! * bounds: the exact bounding box. measures, [`Measures`]: several measures in one call.
//! * intersect_line: intersections with lines and planes.
//! * tangent_angle: the points whose tangents make an angle with a direction.
//! * intersect, segment_intersection: common points of two plane curves, and of one with itself.
//! * near_misses: where two curves in space come near to each other. meetings: either of the two.
//! * curve_offset: the curve at a distance.
//! * resample, [`Samples`]: points along a curve.
//! * export: SVG paths, TrueType contours, B-splines.
//!
//! They stand on the shared Bernstein module (polynomials on 0 to 1 and their roots), and
//! cubic (the closed form).
//!
//! Every operation measures in a unit frame, in which the curve has about size 1, and is exact, or
//! stops, at an error relative to that size. Lengths of 1e200 and 1e-200 are as good as others;
//! results that f64 cannot hold, such as an area of 1e400, become infinite or 0.

mod area;
mod bounds;
mod cubic;
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
mod part;
mod resample;
mod segment_intersection;
mod split;
mod tangent_angle;

pub use area::Moments;
pub use bounds::Bounds;
pub use curve_offset::{Offset, OffsetOptions};
pub use degree::Reduced;
pub use export::{Contour, Spline};
pub use intersect::{Intersection, Intersections, Overlap};
pub use intersect_line::PlaneIntersections;
pub use length::Lengths;
pub use measures::{MeasureSelection, Measures};
pub use near_misses::{NearMiss, NearMisses};
pub use nearest::Nearest;
pub use nearest::{CurveSearch, nearest_of_any};
pub use resample::{Samples, Spacing};
pub use tangent_angle::TangentAngles;
