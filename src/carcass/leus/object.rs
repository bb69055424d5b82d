//! What distances are measured from.

use super::diameter::Diameters;
use super::search::{Found, Options, search};
use crate::carcass::Sheet;
use crate::carcass::line::Line;
use crate::error::{Error, Result};
use crate::job::Job;
use glam::DVec3;

/// A point, a plane or a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Object {
    /// A point.
    Point(DVec3),
    /// The plane through a point, across a direction.
    Plane {
        /// A point of the plane.
        point: DVec3,
        /// Of any length but 0.
        normal: DVec3,
    },
    /// A line, ray or segment.
    Line(Line),
}

impl Object {
    /// The same with a unit normal or direction.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for what is not finite, or has no direction.
    pub fn normalized(self) -> Result<Self> {
        let bad = |option, value| Error::OptionOutOfRange { option, value };
        let finite = |x: DVec3, option| if x.is_finite() { Ok(x) } else { Err(bad(option, f64::NAN)) };
        let unit = |x: DVec3, option| finite(x, option)?.try_normalize().ok_or(bad(option, x.length()));
        match self {
            Object::Point(point) => Ok(Object::Point(finite(point, "point")?)),
            Object::Plane { point, normal } => {
                Ok(Object::Plane { point: finite(point, "point")?, normal: unit(normal, "normal")? })
            }
            Object::Line(Line { origin, direction, from, to }) => {
                if from.is_nan() || to.is_nan() || from > to {
                    return Err(bad("from", from));
                }
                let unit = unit(direction, "direction")?;
                let [from, to] = [from, to].map(|t| t * direction.length());
                Ok(Object::Line(Line { origin: finite(origin, "origin")?, direction: unit, from, to }))
            }
        }
    }

    /// The distance of a point, rounded down, from an object as [`Object::normalized`] gives it.
    pub fn distance(&self, from: DVec3) -> f64 {
        let (distance, scale) = match *self {
            Object::Point(point) => return point.distance(from),
            Object::Plane { point, normal } => ((from - point).dot(normal).abs(), (from - point).length()),
            Object::Line(Line { origin, direction, from: first, to: last }) => {
                let (along, nearest) = ((from - origin).dot(direction), from - origin);
                let t = along.max(first).min(last);
                ((nearest - t * direction).length(), nearest.length() + t.abs())
            }
        };
        (distance - 8.0 * f64::EPSILON * scale).max(0.0)
    }
}

/// The cells that may have a point within a distance of an object, or the nearest one, by the corrected search.
///
/// # Errors
/// Those of [`Object::normalized`] and [`search`].
pub fn incidence(
    sheet: &Sheet<'_>,
    diameters: &Diameters,
    object: Object,
    options: &Options,
    job: &Job<'_>,
) -> Result<Found> {
    let object = object.normalized()?;
    search(&diameters.euclidean, |[i, j]| object.distance(sheet.corner(i, j)), options, job)
}
