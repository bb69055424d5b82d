//! Task c) of the paper: common points of a line, or of a curve, and a surface.
//!
//! * `line`: lines and their hits. `line_search`: descent of the index for a line; over a cell its
//!   points are the common roots of two fields, the distances from two planes through it, of which
//!   none is missed (`subdivision::roots`). `hits`: one hit of those that
//!   several cells find. `line_batch`: many lines.
//! * `curve_hits`, `curve_search`: the same for curves. Lines that touch the surface or run in it are
//!   taken as curves too, whose parameter tells from where to where they do.
//! * `winding`: whether a line passes through the surface where tangents jump.
//!
//! Invariant: a box or cell is passed over only where bounds, grown by rounding, exclude it, so no
//! hit is missed. Cost: about O(log cells) and O(1) a hit; bounded for each cell that a line runs
//! in.

mod curve_hits;
mod curve_search;
mod hits;
mod line;
mod line_batch;
mod line_search;
mod winding;

pub use curve_hits::CurveHit;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
pub(crate) use line::MAX_COORDINATE;
pub use line::{Hit, HitSelection, Line};
pub use line_batch::Lines;

use super::{Sheet, Surface};
use gusset_base::geom::Aabb;
use gusset_base::geom::aabb::range;
use gusset_curve::ops::{NearMiss, NearMisses};
use gusset_curve::{CurveView, Place as CurvePlace};
use line_search::{LineSearch, Workspace};

impl Surface<'_> {
    /// Where a line meets the surface, by rising t.
    ///
    /// A point on a side between cells, on a side that sheets share, or at a pole is found once.
    /// None is missed: where touching or coincidence cannot be resolved, a hit is given for each
    /// such place and marked tangent. About O(log cells) and O(1) a hit; bounded for each cell that
    /// a line runs in.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for a line that is not finite or has no direction.
    pub fn line(&self, line: &Line, selection: HitSelection) -> Result<Vec<Hit>> {
        line.check()?;
        let mut workspace = Workspace::default();
        self.find_hits(line, selection, &mut workspace)?;
        Ok(workspace.hits)
    }

    /// Leaves the hits of a line that was checked in the workspace, by rising t.
    fn find_hits(&self, line: &Line, selection: HitSelection, workspace: &mut Workspace) -> Result<()> {
        workspace.hits.clear();
        for k in 0..self.len() {
            let (sheet, index) = self.indexed(k);
            let search = LineSearch { index, sheet: k as u32, line, selection, tolerance: self.tolerance() };
            let Workspace { hits, cubic, high } = workspace;
            match sheet {
                Sheet::Grid(cells) => search.run(cells, cubic, hits)?,
                Sheet::Cubic(cells) => search.run(cells, cubic, hits)?,
                Sheet::High(cells) => search.run(cells, high, hits)?,
            }
            if selection == HitSelection::Any && !workspace.hits.is_empty() {
                break;
            }
        }
        self.merge_hits(line, &mut workspace.hits);
        if selection == HitSelection::First && workspace.hits.first().is_some_and(|hit| hit.tangent) {
            // The unresolved part may begin beyond it.
            self.find_hits(line, HitSelection::All, workspace)?;
        }
        if selection != HitSelection::All {
            workspace.hits.truncate(1);
        }
        Ok(())
    }
}

impl Line {
    /// Finds the places where a curve meets the line or comes as near to it as `within`, as
    /// [`near_misses`](Self::near_misses) has them. If `within` is 0 and both lie in the plane z = 0, the
    /// places are exact, unless a segment of the curve lies in the line.
    ///
    /// # Errors
    /// Those of [`near_misses`](Self::near_misses).
    pub fn meetings(&self, curve: &CurveView<'_>, within: f64, job: &Job<'_>) -> Result<NearMisses> {
        self.check()?;
        if within == 0.0 {
            match curve.intersect_line(self.origin, self.direction, &job.part(0.0, 0.5)) {
                Ok(found) if found.inside.is_empty() && !curve.is_empty() => {
                    return self.exact_meetings(curve, &found.places);
                }
                Ok(_) | Err(Error::CurveNotPlane { .. }) => {}
                Err(error) => return Err(error),
            }
        }
        self.near_misses(curve, within, &job.part(0.5, 1.0))
    }

    /// Keeps the places of the endless line that are on this one, to 1e-12 of the curve's size.
    fn exact_meetings(&self, curve: &CurveView<'_>, places: &[CurvePlace]) -> Result<NearMisses> {
        let (along, length) = self.along();
        let slack = 1e-12 * Aabb::from_points(curve.points()).size().max_element() / length;
        let mut found = NearMisses::default();
        for &a in places {
            let t = (curve.point(a)? - self.origin).dot(along) / length;
            if (self.from - slack..=self.to + slack).contains(&t) {
                let b = CurvePlace { segment: 0, t: t.clamp(self.from, self.to) };
                alloc::push(&mut found.places, NearMiss { a, b, distance: 0.0 })?;
            }
        }
        Ok(found)
    }

    /// Where a curve in space comes as near to the line as `within`: as
    /// [`CurveView::near_misses`](gusset_curve::CurveView::near_misses) for the curve, with
    /// places on the line as the second ones: segment 0, and the line's parameter as t.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for a line that is not finite or has no direction, and those of
    /// curves.
    pub fn near_misses(&self, curve: &CurveView<'_>, within: f64, job: &Job<'_>) -> Result<NearMisses> {
        self.check()?;
        Error::require(within >= 0.0 && within.is_finite(), "within", within)?;
        // No farther than the curve, and what is near it.
        let (along, length) = self.along();
        let parameters = curve.points().iter().map(|&point| (point - self.origin).dot(along));
        let [low, high] = range(parameters);
        // A curve across the line has no extent along it.
        let size = Aabb::from_points(curve.points()).size().max_element();
        let slack = within + 1e-6 * size;
        let from = ((low - slack) / length).max(self.from);
        let to = ((high + slack) / length).min(self.to);
        if curve.is_empty() {
            return Err(Error::EmptyCurve);
        }
        if from > to {
            return Ok(NearMisses::default());
        }
        let ends = [from, to].map(|t| self.origin + (t * length) * along);
        let mut found = curve.near_misses(&CurveView::new(&ends, &[0, 1], false)?, within, job)?;
        let parameter = |place: &mut CurvePlace| place.t = from + (to - from) * place.t;
        found.places.iter_mut().for_each(|found| parameter(&mut found.b));
        found.overlaps.iter_mut().for_each(|found| found.b.iter_mut().for_each(parameter));
        Ok(found)
    }
}
