//! Task c) of the paper: where a line or a curve meets the surface.
//!
//! A line is where two planes meet: over a cell its points are the common roots of two fields, of which none is missed (see `solve`).
//! What is not resolved by these, lines that touch the surface or run in it, is looked at as a curve, whose parameter tells from where to
//! where it lasts.

mod batch;
mod curve;
mod fan;
mod hits;
mod search;
mod walk;

pub use batch::Lines;
pub use curve::CurveHit;

use super::{Place, Surface, each_sheet};
use crate::error::{Error, Result};
use crate::job::Job;
use crate::outline::ops::Approaches;
use crate::outline::{CurveView, Place as CurvePlace};
use glam::DVec3;
use search::{Workspace, search};

/// Coordinates of lines and curves beyond this are refused: their squares would overflow.
pub(super) const LARGEST: f64 = 1e150;

/// A line, ray or segment: origin + t * direction for t from `from` to `to`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// Where t is 0; coordinates up to 1e150.
    pub origin: DVec3,
    /// Of a length whose square neither vanishes nor overflows: from 1e-150 to 1e150.
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
    fn check(&self) -> Result<()> {
        let bad = |value: f64, option| Err(Error::OptionOutOfRange { option, value });
        if let Some(value) = self.origin.to_array().into_iter().find(|x| x.is_nan() || x.abs() > LARGEST) {
            return bad(value, "origin");
        }
        if let Some(value) = self.direction.to_array().into_iter().find(|x| !x.is_finite()) {
            return bad(value, "direction");
        }
        // Parameters of points are quotients by the length: they would be infinite.
        let square = self.direction.length_squared();
        if !(square >= f64::MIN_POSITIVE && square.is_finite()) {
            return bad(self.direction.abs().max_element(), "direction");
        }
        if self.from.is_nan() || self.to.is_nan() || self.from > self.to {
            return bad(self.from, "from");
        }
        Ok(())
    }

    /// The unit vector along it and the length of the direction, whatever its size.
    fn along(&self) -> (DVec3, f64) {
        let largest = self.direction.abs().max_element();
        let scaled = self.direction / largest;
        let length = scaled.length();
        (scaled / length, length * largest)
    }
}

/// A point that a line and a surface have in common.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// Where on the line.
    pub t: f64,
    /// From where to where the line cannot be told from the surface, within the tolerance: [t, t] where it passes through.
    pub span: [f64; 2],
    /// Where on the surface.
    pub place: Place,
    /// The point of the surface.
    pub point: DVec3,
    /// The unit normal there, or its limit at a pole; 0 if there is none.
    pub normal: DVec3,
    /// True if the line touches the surface there, or nearly, or runs in it: it may be one point, two close to each other, none, or all
    /// of the span.
    pub tangent: bool,
    /// How often the hit counts: 1 where the line passes through, 2 where it touches, 0 where it runs in the surface.
    pub multiplicity: u32,
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

impl Surface<'_> {
    /// Where a line meets the surface, by rising t.
    ///
    /// A point on a side between cells, on a side that sheets share, or at a pole is found once. None is missed: where touching or
    /// coincidence cannot be resolved, a hit is given for each such spot and marked tangent. About O(log cells) and O(1) a hit; bounded for
    /// each cell that a line runs in.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for a line that is not finite or has no direction.
    pub fn line(&self, line: &Line, which: Which) -> Result<Vec<Hit>> {
        line.check()?;
        let mut workspace = Workspace::default();
        self.strike(line, which, &mut workspace)?;
        Ok(workspace.hits)
    }

    /// Leaves the hits of a line that was checked in the workspace, by rising t.
    fn strike(&self, line: &Line, which: Which, workspace: &mut Workspace) -> Result<()> {
        workspace.hits.clear();
        for k in 0..self.len() {
            let (sheet, index) = self.indexed(k);
            each_sheet!(sheet, cells => search(cells, index, k as u32, line, which, self.tolerance(), workspace))?;
            if which == Which::Any && !workspace.hits.is_empty() {
                break;
            }
        }
        self.settle(line, &mut workspace.hits);
        if which == Which::First && workspace.hits.first().is_some_and(|hit| hit.tangent) {
            // What belongs to the spot may begin beyond it.
            self.strike(line, Which::All, workspace)?;
        }
        if which != Which::All {
            workspace.hits.truncate(1);
        }
        Ok(())
    }
}

impl Line {
    /// Where a curve in space comes as near to the line as `within`: as [`CurveView::approaches`] for the curve, with places on the line as the
    /// second ones: segment 0, and the line's parameter as t.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for a line that is not finite or has no direction, and those of curves.
    pub fn approaches(&self, curve: &CurveView<'_>, within: f64, job: &Job<'_>) -> Result<Approaches> {
        self.check()?;
        if !(within >= 0.0 && within.is_finite()) {
            return Err(Error::OptionOutOfRange { option: "within", value: within });
        }
        // No farther than the curve, and what is near it.
        let (along, length) = self.along();
        let parameters = curve.points().iter().map(|&point| (point - self.origin).dot(along));
        let [low, high] = parameters.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)]);
        let play = within + 1e-6 * (high - low);
        let from = ((low - play) / length).max(self.from);
        let to = ((high + play) / length).min(self.to);
        if curve.is_empty() {
            return Err(Error::EmptyCurve);
        }
        if from > to {
            return Ok(Approaches::default());
        }
        let ends = [from, to].map(|t| self.origin + (t * length) * along);
        let mut found = curve.approaches(&CurveView::new(&ends, &[0, 1], false)?, within, job)?;
        let parameter = |place: &mut CurvePlace| place.t = from + (to - from) * place.t;
        found.places.iter_mut().for_each(|found| parameter(&mut found.b));
        found.overlaps.iter_mut().for_each(|found| found.b.iter_mut().for_each(parameter));
        Ok(found)
    }
}
