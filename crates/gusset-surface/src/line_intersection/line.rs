//! Lines, rays and segments, and their common points with surfaces.

use crate::Place;
use crate::checks::check_finite;
use glam::DVec3;
use gusset_base::error::{Error, Result};

/// Largest absolute coordinate of lines and curves. Squares of larger ones would overflow.
pub(crate) const MAX_LINE_COORDINATE: f64 = 1e150;

/// A line, ray or segment: origin + t * direction for t between `from` and `to`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// The point at t = 0, with coordinates up to 1e150.
    pub origin: DVec3,
    /// The direction. Its squared length must neither underflow nor overflow, as for lengths from
    /// 1e-150 to 1e150.
    pub direction: DVec3,
    /// The smallest t: -infinity for lines, 0 for rays and segments.
    pub from: f64,
    /// The largest t: infinity for lines and rays.
    pub to: f64,
}

impl Line {
    /// Creates an infinite line.
    pub fn new(origin: DVec3, direction: DVec3) -> Self {
        Line { origin, direction, from: f64::NEG_INFINITY, to: f64::INFINITY }
    }

    /// Creates a ray that begins at `origin`.
    pub fn ray(origin: DVec3, direction: DVec3) -> Self {
        Line { from: 0.0, ..Line::new(origin, direction) }
    }

    /// Creates the segment from `a` (t = 0) to `b` (t = 1).
    pub fn segment(a: DVec3, b: DVec3) -> Self {
        Line { from: 0.0, to: 1.0, ..Line::new(a, b - a) }
    }

    /// Checks that the line is finite and has a direction.
    pub(crate) fn check_finite_with_direction(&self) -> Result<()> {
        self.origin.to_array().into_iter().try_for_each(|x| {
            Error::require(x.abs() <= MAX_LINE_COORDINATE, "origin", x, "at most 1e150 in every coordinate")
        })?;
        check_finite(self.direction, "direction")?;
        // Parameters of points are divided by the length, and would be infinite.
        let square = self.direction.length_squared();
        let is_usable = square >= f64::MIN_POSITIVE && square.is_finite();
        Error::require(is_usable, "direction", self.direction.abs().max_element(), "of a length from 1e-150 to 1e150")?;
        let is_somewhere = self.from < f64::INFINITY && self.to > f64::NEG_INFINITY;
        Error::require(self.from <= self.to && is_somewhere, "from", self.from, "at most `to`, and below infinity")
    }

    /// The unit vector along the line, and the length of the direction, at any scale.
    pub(crate) fn direction_and_length(&self) -> (DVec3, f64) {
        let largest = self.direction.abs().max_element();
        let scaled = self.direction / largest;
        let length = scaled.length();
        (scaled / length, length * largest)
    }
}

/// A common point of a surface and a line or curve. `T` is the type of places on the line or curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit<T = f64> {
    /// The place on the line.
    pub at: T,
    /// The range in which the line cannot be distinguished from the surface within the tolerance.
    /// At a crossing, both ends are equal.
    pub span: [T; 2],
    /// The place on the surface.
    pub place: Place,
    /// The point of the surface.
    pub point: DVec3,
    /// The unit normal there, or its limit at a pole; zero if no normal exists.
    pub normal: DVec3,
    /// True if the line touches the surface within the tolerance, or runs in it. There may be one
    /// common point, two close ones, none, or all points of the span.
    pub tangent: bool,
    /// How often the hit counts: 1 for a crossing, 2 for a contact, 0 for a run inside the surface.
    pub multiplicity: u32,
}

/// The hits to find.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum HitSelection {
    /// All hits, by ascending t.
    #[default]
    All,
    /// The hit with the smallest t.
    First,
    /// Any hit, to find out whether there is one.
    Any,
}
