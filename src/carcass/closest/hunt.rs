//! What is known while the nearest point is looked for.

use super::cell::Found;
use super::search::Entry;
use crate::carcass::Place;
use glam::DVec3;

/// Patches and parts that are looked at before all but what must be nearer is dropped, and before the search ends.
const MUCH: usize = 64;
const MOST: usize = 2048;
/// Blocks that are looked at at most.
const LEAVES: usize = 1 << 14;

/// A nearest point of a cell.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Answer {
    pub(crate) found: Found,
    pub(crate) sheet: u32,
    pub(crate) cell: [u32; 2],
}

impl Answer {
    /// The nearer one, or at the same distance the first.
    fn precedes(&self, other: &Answer) -> bool {
        let key = |answer: &Answer| (answer.found.distance, answer.sheet, answer.cell);
        key(self) < key(other)
    }

    pub(crate) fn place(&self) -> Place {
        Place { sheet: self.sheet, cell: self.cell, u: self.found.place.x, v: self.found.place.y }
    }
}

/// A search for the nearest point of all sheets. Nothing is dropped that may be within `tolerance` of the nearest: so the answer does not depend on
/// the order in which blocks are looked at, and other places at the same distance are seen.
///
/// If there are too many of those (the query is a focus), whatever cannot be nearer by more than the tolerance is dropped; in the end the
/// search gives up, and the bound says what is not proven.
#[derive(Debug)]
pub(crate) struct Hunt {
    pub(super) query: DVec3,
    /// To which distances are proved: what rounding allows at least.
    pub(super) tolerance: f64,
    /// The nearest that was found, at a corner or in a cell, or the limit of the question.
    reach: f64,
    /// Answers within the tolerance of the nearest.
    near: Vec<Answer>,
    direction: DVec3,
    /// A bound of whatever was dropped without being farther.
    dropped: f64,
    pub(super) work: usize,
    pub(super) leaves: usize,
    /// Blocks that wait.
    pub(super) stack: Vec<Entry>,
}

impl Hunt {
    pub(crate) fn new() -> Hunt {
        Hunt {
            query: DVec3::ZERO,
            tolerance: 0.0,
            reach: f64::INFINITY,
            near: Vec::new(),
            direction: DVec3::ZERO,
            dropped: f64::INFINITY,
            work: 0,
            leaves: 0,
            stack: Vec::new(),
        }
    }

    /// Begins a new search.
    pub(crate) fn begin(&mut self, query: DVec3, limit: f64, tolerance: f64) {
        self.near.clear();
        self.direction = DVec3::ZERO;
        (self.query, self.reach, self.tolerance) = (query, limit, tolerance);
        (self.dropped, self.work, self.leaves) = (f64::INFINITY, 0, 0);
    }

    /// What is farther than this need not be looked at.
    #[inline(always)]
    pub(super) fn limit(&self) -> f64 {
        if !self.is_tired() {
            self.reach + self.tolerance
        } else if self.work < MOST && self.leaves < LEAVES {
            (self.reach - self.tolerance).max(0.0)
        } else {
            f64::NEG_INFINITY
        }
    }

    /// Takes note that something with a lower bound of its distance is not looked at.
    #[inline(always)]
    pub(super) fn drop(&mut self, bound: impl FnOnce() -> f64) {
        // What was farther than the limit of a search that takes its time is farther than the nearest point.
        if self.is_tired() {
            self.dropped = self.dropped.min(bound().max(0.0));
        }
    }

    #[inline(always)]
    fn is_tired(&self) -> bool {
        self.work >= MUCH || self.leaves >= LEAVES
    }

    /// The unit vector from the nearest point found in a cell to the query; 0 as long as there is none.
    #[inline(always)]
    pub(super) fn direction(&self) -> DVec3 {
        self.direction
    }

    /// There is a point at this distance.
    #[inline(always)]
    pub(super) fn reaches(&mut self, distance: f64) {
        self.reach = self.reach.min(distance);
    }

    /// The nearest point of a cell was found.
    pub(super) fn add(&mut self, answer: Answer) {
        if answer.found.distance <= self.reach || self.direction == DVec3::ZERO {
            self.direction = (self.query - answer.found.point).normalize_or_zero();
        }
        self.reaches(answer.found.distance);
        let limit = self.reach + self.tolerance;
        // What may be nearer, but is not proved to be farther, counts for the bound.
        self.near.retain(|other| other.found.bound <= limit);
        if answer.found.bound <= limit {
            self.near.push(answer);
        }
    }

    /// The nearest answer, a lower bound of all distances, and whether there is another point as near elsewhere.
    pub(crate) fn end(&self, limit: f64) -> Option<(Answer, f64, bool)> {
        let mut answers = self.near.iter().filter(|answer| answer.found.distance <= limit);
        let first = *answers.next()?;
        let best = answers.fold(first, |best, &other| if other.precedes(&best) { other } else { best });
        let within = best.found.distance + self.tolerance;
        let near = || self.near.iter().filter(|other| other.found.bound <= within);
        let bound = near().map(|other| other.found.bound).fold(self.dropped.min(best.found.distance), f64::min);
        // Round a nearest point on a plane, all within this is as near.
        let alike = (2.0 * best.found.distance * self.tolerance).sqrt();
        let apart = (0.01 * best.found.distance).max(8.0 * alike);
        let many =
            near().any(|other| other.found.distance <= within && other.found.point.distance(best.found.point) > apart);
        Some((best, bound, many))
    }
}
