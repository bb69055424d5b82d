//! What is known while the nearest point is looked for.

use super::leaf::Candidate;
use super::search::Entry;
use super::wait::Waiting;
use crate::surface::Place;
use glam::{DVec2, DVec3};
use std::collections::BinaryHeap;

/// Patches and blocks that are looked at before the rest waits for its turn, by lower bounds.
const MUCH: usize = 64;
const LEAVES: usize = 1 << 10;
/// What is looked at at least, and without a nearer answer, before the search ends without proof, if what there is to gain is little; and
/// what is looked at at most.
const ENOUGH: usize = 1 << 12;
const MOST: usize = 100_000;
/// Which part of the distance is little to gain. Below it are the foci of coarse surfaces: their parts do not tell near from nearest.
const LITTLE: f64 = 1e-3;
/// Which part of the distance an answer must gain to be worth going on.
const WORTH: f64 = 1e-6;
/// Answers elsewhere that are kept beside the nearest.
const KEPT: usize = 64;

/// A point of the surface that may be the nearest.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Answer {
    pub(crate) point: DVec3,
    /// The unit normal, or 0 where the patch is not regular.
    pub(crate) normal: DVec3,
    pub(crate) distance: f64,
    pub(crate) sheet: u32,
    pub(crate) cell: [u32; 2],
    pub(crate) parameters: DVec2,
}

impl Answer {
    /// The nearer one, or at the same distance the first.
    fn precedes(&self, other: &Answer) -> bool {
        let key = |answer: &Answer| (answer.distance, answer.sheet, answer.cell);
        key(self) < key(other)
    }

    pub(crate) fn place(&self) -> Place {
        Place { sheet: self.sheet, cell: self.cell, u: self.parameters.x, v: self.parameters.y }
    }
}

/// A search for the nearest point of all sheets. Nothing is passed over that may be within `tolerance` of the nearest: so the answer does
/// not depend on the order in which blocks are looked at, and other places at the same distance are seen.
///
/// Blocks are looked at in depth, which is fast, until there were many; what is left then waits and is looked at by its lower bounds, the
/// least first. So whenever the search ends, the least of those that wait is what is proved.
#[derive(Debug)]
pub(crate) struct Hunt {
    pub(super) query: DVec3,
    /// To which distances are proved: what rounding allows at least.
    pub(super) tolerance: f64,
    /// There is a point this near, an answer or a corner; or the limit of the question.
    reach: f64,
    best: Option<Answer>,
    /// Answers within the tolerance of the nearest, or not much farther.
    near: Vec<Answer>,
    direction: DVec3,
    /// The least bound of what is done with.
    least: f64,
    work: usize,
    /// The work done when the nearest answer last got nearer by what is worth it.
    gained: usize,
    leaves: usize,
    /// Blocks that are next, in depth.
    pub(super) stack: Vec<Entry>,
    /// Cells that are next.
    pub(super) candidates: Vec<Candidate>,
    waiting: BinaryHeap<Waiting>,
}

impl Hunt {
    pub(crate) fn new() -> Hunt {
        Hunt {
            query: DVec3::ZERO,
            tolerance: 0.0,
            reach: f64::INFINITY,
            best: None,
            near: Vec::new(),
            direction: DVec3::ZERO,
            least: f64::INFINITY,
            work: 0,
            gained: 0,
            leaves: 0,
            stack: Vec::new(),
            candidates: Vec::new(),
            waiting: BinaryHeap::new(),
        }
    }

    /// Begins a new search.
    pub(crate) fn begin(&mut self, query: DVec3, limit: f64, tolerance: f64) {
        self.near.clear();
        self.candidates.clear();
        self.waiting.clear();
        (self.best, self.direction) = (None, DVec3::ZERO);
        (self.query, self.reach, self.tolerance) = (query, limit, tolerance);
        (self.least, self.work, self.gained, self.leaves) = (f64::INFINITY, 0, 0, 0);
    }

    /// No nearer point is known than at this distance.
    pub(super) fn reach(&self) -> f64 {
        self.reach
    }

    /// What is farther than this need not be looked at.
    #[inline(always)]
    pub(super) fn limit(&self) -> f64 {
        self.reach + self.tolerance
    }

    /// The distance of the nearest answer.
    #[inline(always)]
    pub(super) fn distance(&self) -> f64 {
        self.best.map_or(f64::INFINITY, |best| best.distance)
    }

    /// The unit vector from the nearest answer to the query; 0 as long as there is none.
    #[inline(always)]
    pub(super) fn direction(&self) -> DVec3 {
        self.direction
    }

    /// There is a point at this distance, or nearer.
    #[inline(always)]
    pub(super) fn reaches(&mut self, distance: f64) {
        self.reach = self.reach.min(distance);
    }

    /// True if something this near is worth a look before its turn.
    pub(super) fn is_worth(&self, distance: f64) -> bool {
        distance < self.distance() * (1.0 - WORTH)
    }

    /// The nearest answer so far.
    pub(super) fn best(&self) -> Option<Answer> {
        self.best
    }

    /// A patch or a part of one is looked at.
    #[inline(always)]
    pub(super) fn work(&mut self) {
        self.work += 1;
    }

    /// A block of cells is looked at.
    #[inline(always)]
    pub(super) fn leaf(&mut self) {
        self.leaves += 1;
    }

    /// True once so much was looked at that what is left shall wait.
    #[inline(always)]
    pub(super) fn is_long(&self) -> bool {
        self.work >= MUCH || self.leaves >= LEAVES
    }

    /// A point of the surface was found.
    pub(super) fn add(&mut self, answer: Answer) {
        let distance = self.distance();
        self.reaches(answer.distance);
        if self.is_worth(answer.distance) {
            self.gained = self.work;
        }
        if self.best.is_none_or(|best| answer.precedes(&best)) {
            self.best = Some(answer);
            self.direction = (self.query - answer.point).normalize_or_zero();
            if answer.distance < distance - self.tolerance {
                self.near.clear();
            }
        }
        if answer.distance <= self.limit() && self.near.len() < KEPT {
            // Of a pole, which is in many cells, one answer does.
            let same = 0.1 * self.apart();
            if self.near.iter().all(|other| other.point.distance(answer.point) > same) {
                self.near.push(answer);
            }
        }
    }

    /// Points farther apart than this are not the same nearest point.
    fn apart(&self) -> f64 {
        let distance = self.distance();
        // Round a nearest point on a plane, all within this is as near.
        let alike = (2.0 * distance * self.tolerance).sqrt();
        (0.01 * distance).max(8.0 * alike)
    }

    /// Something is done with: no point of it is nearer than this.
    #[inline(always)]
    pub(super) fn proved(&mut self, bound: f64) {
        self.least = self.least.min(bound);
    }

    /// Lets something wait. What there is no memory for is done with.
    pub(super) fn wait(&mut self, waiting: Waiting) {
        if waiting.bound <= self.limit() {
            match self.waiting.try_reserve(1) {
                Ok(()) => self.waiting.push(waiting),
                Err(_) => self.proved(waiting.bound),
            }
        }
    }

    /// What is to be looked at next, of all that waits: that with the least bound.
    pub(super) fn next(&mut self) -> Option<Waiting> {
        let next = self.waiting.pop()?;
        if next.bound > self.limit() || self.is_enough(next.bound) {
            self.proved(next.bound);
            return None;
        }
        self.work();
        Some(next)
    }

    /// True if it is time to end, though nothing is known of the surface but that it is not nearer than `bound`.
    fn is_enough(&self, bound: f64) -> bool {
        let gain = self.distance() - bound;
        let idle = self.work >= ENOUGH && self.work - self.gained >= ENOUGH / 2;
        self.work >= MOST || (idle && gain <= (LITTLE * self.distance()).max(self.tolerance))
    }

    /// The nearest answer, if it is not proved to be that.
    pub(super) fn unproven(&self) -> Option<Answer> {
        self.best.filter(|best| self.least < best.distance - self.tolerance)
    }

    /// The nearest answer, a lower bound of all distances, and whether there is another point as near elsewhere.
    pub(crate) fn end(&self, limit: f64) -> Option<(Answer, f64, bool)> {
        let best = self.best.filter(|best| best.distance <= limit)?;
        let within = best.distance + self.tolerance;
        let mut near = self.near.iter().filter(|other| other.distance <= within);
        let many = near.any(|other| other.point.distance(best.point) > self.apart());
        Some((best, self.least.min(best.distance), many))
    }
}
