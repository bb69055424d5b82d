//! Task c) of the paper: common points of a surface and a line or a curve.
//!
//! - `line`: lines and their hits. `line_search`: descent of the index for a line. Over a cell,
//!   hits are the common roots of two fields, the distances from two planes through the line.
//!   `subdivision::field_roots` finds all of them. `hit_merging`: merges hits that several cells
//!   found. `line_batch`: many lines.
//! - `curve_hits`, `curve_search`: the same for curves. A line that touches the surface or runs in
//!   it is treated as a curve, whose parameter yields the range of the contact.
//! - `winding`: whether a line crosses the surface where tangents jump.
//!
//! Invariant: a box or cell is skipped only if bounds, enlarged by rounding, exclude it, so no hit
//! is missed. Cost: about O(log cells) and O(1) for each hit; limited for each cell in which a line
//! runs.

mod curve_hits;
mod curve_search;
mod hit_merging;
mod line;
mod line_batch;
mod line_search;
mod winding;

pub use curve_hits::CurveHit;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
pub(crate) use line::MAX_LINE_COORDINATE;
pub use line::{Hit, HitSelection, Line};
pub use line_batch::Lines;

use super::{Sheet, Surface};
use gusset_base::geom::Aabb;
use gusset_base::geom::aabb::range_of_values;
use gusset_curve::ops::{NearMiss, NearMisses};
use gusset_curve::{CurveView, Place as CurvePlace};
use line_search::{LineWorkspace, SheetLineSearch};

impl Surface<'_> {
    /// Finds the common points of a line and the surface, by ascending t.
    ///
    /// A point on a side between cells, on a side that sheets share, or at a pole is found once. No
    /// point is missed: each place where contact or coincidence cannot be resolved yields a hit
    /// marked as tangent. Costs about O(log cells) and O(1) for each hit, and a limited amount for
    /// each cell in which a line runs.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] if the line is not finite or lacks a direction.
    pub fn line(&self, line: &Line, selection: HitSelection) -> Result<Vec<Hit>> {
        line.check_finite_with_direction()?;
        let mut workspace = LineWorkspace::default();
        self.find_hits(line, selection, &mut workspace)?;
        Ok(workspace.hits)
    }

    /// Stores the hits of a checked line in the workspace, by ascending t.
    fn find_hits(&self, line: &Line, selection: HitSelection, workspace: &mut LineWorkspace) -> Result<()> {
        workspace.hits.clear();
        for k in 0..self.len() {
            let (sheet, index) = self.sheet_and_index(k);
            let search = SheetLineSearch { index, sheet: k as u32, line, selection, tolerance: self.tolerance() };
            let LineWorkspace { hits, cubic_roots: cubic, degree_seven_roots: high } = workspace;
            match sheet {
                Sheet::Grid(cells) => search.search_sheet(cells, cubic, hits)?,
                Sheet::Cubic(cells) => search.search_sheet(cells, cubic, hits)?,
                Sheet::High(cells) => search.search_sheet(cells, high, hits)?,
            }
            if selection == HitSelection::Any && !workspace.hits.is_empty() {
                break;
            }
        }
        self.merge_hits(line, &mut workspace.hits);
        if selection == HitSelection::First && workspace.hits.first().is_some_and(|hit| hit.tangent) {
            // The unresolved part may begin beyond the first hit.
            self.find_hits(line, HitSelection::All, workspace)?;
        }
        if selection != HitSelection::All {
            workspace.hits.truncate(1);
        }
        Ok(())
    }
}

impl Line {
    /// Finds the places where a curve meets the line or comes within `within` of it, like
    /// [`near_misses`](Self::near_misses). If `within` is 0 and both lie in the plane z = 0, the
    /// places are exact, unless a segment of the curve lies in the line.
    ///
    /// # Errors
    /// The errors of [`near_misses`](Self::near_misses).
    pub fn intersections_or_near_misses(
        &self,
        curve: &CurveView<'_>,
        within: f64,
        job: &Job<'_>,
    ) -> Result<NearMisses> {
        self.check_finite_with_direction()?;
        if within == 0.0 {
            match curve.intersect_line(self.origin, self.direction, &job.sub_job(0.0, 0.5)) {
                Ok(found) if found.inside.is_empty() && !curve.is_empty() => {
                    return self.keep_meetings_on_line(curve, &found.places);
                }
                Ok(_) | Err(Error::CurveNotPlane { .. }) => {}
                Err(error) => return Err(error),
            }
        }
        self.near_misses(curve, within, &job.sub_job(0.5, 1.0))
    }

    /// Keeps the places of the infinite line that are on this one, within 1e-12 of the curve's
    /// size.
    fn keep_meetings_on_line(&self, curve: &CurveView<'_>, places: &[CurvePlace]) -> Result<NearMisses> {
        let (along, length) = self.direction_and_length();
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

    /// Finds the places where a curve in space comes within `within` of the line, like
    /// [`CurveView::near_misses`](gusset_curve::CurveView::near_misses) for two curves. The second
    /// places are on the line: segment 0, and the line's parameter as t.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] if the line is not finite or lacks a direction, and the errors
    /// of [`CurveView::near_misses`](gusset_curve::CurveView::near_misses).
    pub fn near_misses(&self, curve: &CurveView<'_>, within: f64, job: &Job<'_>) -> Result<NearMisses> {
        self.check_finite_with_direction()?;
        Error::require(within >= 0.0 && within.is_finite(), "within", within, "finite and at least 0")?;
        // The part of the line beside the curve, and a little more.
        let (along, length) = self.direction_and_length();
        let parameters = curve.points().iter().map(|&point| (point - self.origin).dot(along));
        let [low, high] = range_of_values(parameters);
        // A curve perpendicular to the line lacks extent along it.
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
