//! Task c) of the paper: where a line meets the surface.
//!
//! A line is where two planes meet: over a cell its points are the common roots of two fields, of which none is missed (see `solve`).

mod search;

use super::{Carcass, Place, each_sheet};
use crate::error::{Error, Result};
use glam::DVec3;
use search::search;

/// A line, ray or segment: origin + t * direction for t from `from` to `to`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// Where t is 0.
    pub origin: DVec3,
    /// Not 0; of any length.
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

    fn check(&self) -> Result<()> {
        let bad = |value: f64, option| Err(Error::OptionOutOfRange { option, value });
        if !self.origin.is_finite() {
            return bad(f64::NAN, "origin");
        }
        if !(self.direction.is_finite() && self.direction.length_squared() > 0.0) {
            return bad(self.direction.length(), "direction");
        }
        if self.from.is_nan() || self.to.is_nan() || self.from > self.to {
            return bad(self.from, "from");
        }
        Ok(())
    }
}

/// A point that a line and a surface have in common.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// Where on the line.
    pub t: f64,
    /// Where on the surface.
    pub place: Place,
    /// The point of the surface.
    pub point: DVec3,
    /// True if the line touches the surface there, or nearly: it may be one point, two close to each other, or none.
    pub tangent: bool,
}

/// Which hits are wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Which {
    /// All, by rising t.
    #[default]
    All,
    /// The one of least t.
    First,
    /// Any one: whether there is one.
    Any,
}

impl Carcass<'_> {
    /// Where a line meets the surface, by rising t.
    ///
    /// A point on a side between cells is found once. None is missed: where touching or coincidence cannot be resolved, a hit is
    /// given for each such spot and marked tangent.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for a line that is not finite or has no direction.
    pub fn line(&self, line: &Line, which: Which) -> Result<Vec<Hit>> {
        line.check()?;
        let mut hits: Vec<Hit> = Vec::new();
        for k in 0..self.len() {
            let (sheet, index) = self.indexed(k);
            each_sheet!(sheet, cells => search(cells, index, k as u32, line, which, self.tolerance(), &mut hits));
            if which == Which::Any && !hits.is_empty() {
                break;
            }
        }
        hits.sort_by(|a, b| a.t.total_cmp(&b.t));
        if which != Which::All {
            hits.truncate(1);
        }
        Ok(hits)
    }
}
