//! The curve along which a crease goes on.

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;

/// Pieces in which the length of a curve is measured.
const PIECES: usize = 16;

/// The angle between two vectors, in radians; 0 if one is 0.
pub(super) fn angle(u: DVec3, v: DVec3) -> f64 {
    libm::atan2(u.cross(v).length(), u.dot(v))
}

/// The unit tangent in `at` of the circle through three points, towards the last one.
pub(super) fn tangent(before: DVec3, at: DVec3, to: DVec3) -> DVec3 {
    let (arrives, leaves) = (at - before, to - at);
    (arrives.normalize_or_zero() * leaves.length() + leaves.normalize_or_zero() * arrives.length()).normalize_or_zero()
}

/// A cubic Bezier curve.
pub(super) struct Curve([DVec3; 4]);

impl Curve {
    /// Between two points, with unit tangents there that point along the curve from either end. With
    /// equal angles to the chord its middle is that of the circle's arc.
    pub(super) fn new([p, q]: [DVec3; 2], tangents: [DVec3; 2]) -> Curve {
        let (length, chord) = (p.distance(q), (q - p).normalize_or_zero());
        let handle =
            |tangent: DVec3, chord: DVec3| tangent * (length * (2.0 / 3.0) / (1.0 + tangent.dot(chord).max(0.0)));
        Curve([p, p + handle(tangents[0], chord), q + handle(tangents[1], -chord), q])
    }

    /// With a tangent at the first point only: symmetric.
    pub(super) fn arc([p, q]: [DVec3; 2], tangent: DVec3) -> Curve {
        let chord = (q - p).normalize_or_zero();
        Curve::new([p, q], [tangent, tangent - 2.0 * tangent.dot(chord) * chord])
    }

    fn at(&self, t: f64) -> DVec3 {
        let Curve([p, q, r, s]) = *self;
        let u = 1.0 - t;
        p * (u * u * u) + q * (3.0 * u * u * t) + r * (3.0 * u * t * t) + s * (t * t * t)
    }

    fn points(&self, pieces: usize) -> impl Iterator<Item = DVec3> + '_ {
        (0..=pieces).map(move |k| self.at(k as f64 / pieces as f64))
    }

    pub(super) fn length(&self) -> f64 {
        self.points(PIECES).zip(self.points(PIECES).skip(1)).map(|(p, q)| p.distance(q)).sum()
    }

    /// How far it is from its chord, in chords.
    pub(super) fn sag(&self) -> f64 {
        let Curve([p, _, _, q]) = *self;
        let chord = q - p;
        let off = |r: DVec3| (r - p).cross(chord).length() / chord.length_squared();
        self.points(PIECES).map(off).fold(0.0, f64::max)
    }

    /// The points between so many pieces.
    pub(super) fn inner(&self, pieces: usize) -> Result<Vec<DVec3>> {
        alloc::collect((1..pieces).map(|k| self.at(k as f64 / pieces as f64)))
    }
}
