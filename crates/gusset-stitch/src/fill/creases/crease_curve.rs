//! The curve that continues a crease.

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;

/// Number of pieces for measuring the length of a curve.
const CURVE_PIECES_FOR_LENGTH: usize = 16;

/// The angle between two vectors, in radians; 0 if one is 0.
pub(super) fn angle_between(u: DVec3, v: DVec3) -> f64 {
    libm::atan2(u.cross(v).length(), u.dot(v))
}

/// Returns the unit tangent at the second of three points of the circle through them, towards the
/// third.
pub(super) fn tangent_of_circle(before: DVec3, point: DVec3, to: DVec3) -> DVec3 {
    let (arrives, leaves) = (point - before, to - point);
    (arrives.normalize_or_zero() * leaves.length() + leaves.normalize_or_zero() * arrives.length()).normalize_or_zero()
}

/// A cubic Bezier curve.
pub(super) struct CubicCurve([DVec3; 4]);

impl CubicCurve {
    /// Creates the curve between two points with unit tangents that point inwards along the curve.
    /// If both tangents make the same angle with the chord, the midpoint lies on the circular arc.
    pub(super) fn new([p, q]: [DVec3; 2], tangents: [DVec3; 2]) -> CubicCurve {
        let (length, chord) = (p.distance(q), (q - p).normalize_or_zero());
        let handle =
            |tangent: DVec3, chord: DVec3| tangent * (length * (2.0 / 3.0) / (1.0 + tangent.dot(chord).max(0.0)));
        CubicCurve([p, p + handle(tangents[0], chord), q + handle(tangents[1], -chord), q])
    }

    /// Creates a symmetric curve from the tangent at the first point.
    pub(super) fn symmetric_arc([p, q]: [DVec3; 2], tangent: DVec3) -> CubicCurve {
        let chord = (q - p).normalize_or_zero();
        CubicCurve::new([p, q], [tangent, tangent - 2.0 * tangent.dot(chord) * chord])
    }

    fn point(&self, t: f64) -> DVec3 {
        let CubicCurve([p, q, r, s]) = *self;
        let u = 1.0 - t;
        p * (u * u * u) + q * (3.0 * u * u * t) + r * (3.0 * u * t * t) + s * (t * t * t)
    }

    fn points(&self, pieces: usize) -> impl Iterator<Item = DVec3> + '_ {
        (0..=pieces).map(move |k| self.point(k as f64 / pieces as f64))
    }

    pub(super) fn length(&self) -> f64 {
        self.points(CURVE_PIECES_FOR_LENGTH)
            .zip(self.points(CURVE_PIECES_FOR_LENGTH).skip(1))
            .map(|(p, q)| p.distance(q))
            .sum()
    }

    /// Returns the largest distance from the chord, relative to the chord's length.
    pub(super) fn relative_sag(&self) -> f64 {
        let CubicCurve([p, _, _, q]) = *self;
        let chord = q - p;
        let off = |r: DVec3| (r - p).cross(chord).length() / chord.length_squared();
        self.points(CURVE_PIECES_FOR_LENGTH).map(off).fold(0.0, f64::max)
    }

    /// Returns the inner points that divide the curve into `pieces`.
    pub(super) fn inner_points(&self, pieces: usize) -> Result<Vec<DVec3>> {
        alloc::collect((1..pieces).map(|k| self.point(k as f64 / pieces as f64)))
    }
}
