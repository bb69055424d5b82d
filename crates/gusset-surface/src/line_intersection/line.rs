//! Lines, rays and segments, and the points that they have in common with surfaces.

use crate::Place;
use crate::checks::finite;
use glam::DVec3;
use gusset_base::error::{Error, Result};

/// Coordinates of lines and curves beyond this are refused: their squares would overflow.
pub(crate) const MAX_COORDINATE: f64 = 1e150;

/// A line, ray or segment: origin + t * direction for t from `from` to `to`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// Where t is 0; coordinates up to 1e150.
    pub origin: DVec3,
    /// Of a length whose square neither vanishes nor overflows, such as any from 1e-150 to 1e150.
    pub direction: DVec3,
    /// The least t: -infinity for lines, 0 for rays and segments.
    pub from: f64,
    /// The greatest t: infinity for lines and rays.
    pub to: f64,
}

impl Line {
    /// A line without ends.
    pub fn new(origin: DVec3, direction: DVec3) -> Self {
        Line { origin, direction, from: f64::NEG_INFINITY, to: f64::INFINITY }
    }

    /// From `origin` on.
    pub fn ray(origin: DVec3, direction: DVec3) -> Self {
        Line { from: 0.0, ..Line::new(origin, direction) }
    }

    /// From `a` (t = 0) to `b` (t = 1).
    pub fn segment(a: DVec3, b: DVec3) -> Self {
        Line { from: 0.0, to: 1.0, ..Line::new(a, b - a) }
    }

    /// That it is finite and has a direction.
    pub(crate) fn check(&self) -> Result<()> {
        self.origin.to_array().into_iter().try_for_each(|x| Error::require(x.abs() <= MAX_COORDINATE, "origin", x))?;
        finite(self.direction, "direction")?;
        // Parameters of points are quotients by the length: they would be infinite.
        let square = self.direction.length_squared();
        let is_usable = square >= f64::MIN_POSITIVE && square.is_finite();
        Error::require(is_usable, "direction", self.direction.abs().max_element())?;
        let is_somewhere = self.from < f64::INFINITY && self.to > f64::NEG_INFINITY;
        Error::require(self.from <= self.to && is_somewhere, "from", self.from)
    }

    /// The unit vector along it and the length of the direction, whatever its size.
    pub(crate) fn along(&self) -> (DVec3, f64) {
        let largest = self.direction.abs().max_element();
        let scaled = self.direction / largest;
        let length = scaled.length();
        (scaled / length, length * largest)
    }
}

/// A point that a line, or a curve, and a surface have in common. `T`: a place on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit<T = f64> {
    /// Where on the line.
    pub at: T,
    /// From where to where the line cannot be told from the surface, within the tolerance: twice
    /// the same where it passes through.
    pub span: [T; 2],
    /// Where on the surface.
    pub place: Place,
    /// The point of the surface.
    pub point: DVec3,
    /// The unit normal there, or its limit at a pole; 0 if there is none.
    pub normal: DVec3,
    /// True if the line touches the surface there, or nearly, or runs in it: it may be one point,
    /// two close to each other, none, or all of the span.
    pub tangent: bool,
    /// How often the hit counts: 1 where the line passes through, 2 where it touches, 0 where it
    /// runs in the surface.
    pub multiplicity: u32,
}

/// Which hits are wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum HitSelection {
    /// All, by rising t.
    #[default]
    All,
    /// The one of least t.
    First,
    /// Any one: whether there is one.
    Any,
}
