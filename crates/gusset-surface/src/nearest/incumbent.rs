//! The best answer so far, with others that are as near, and the upper bound that it gives.
//!
//! Nothing is excluded that may be within the tolerance of the best answer: so the answer does not
//! depend on the order of the search, and other places at the same distance are seen.

use crate::Place;
use glam::{DVec2, DVec3};

/// Least part of the distance by which an answer must be nearer for the search to go on for it.
const MIN_RELATIVE_GAIN: f64 = 1e-6;
/// Answers kept as candidates for ambiguity.
const MAX_TIES: usize = 64;

/// A point of the surface that may be the nearest.
#[derive(Debug, Clone, Copy)]
pub(super) struct Answer {
    pub(super) point: DVec3,
    /// The unit normal, or 0 where the patch is not regular.
    pub(super) normal: DVec3,
    pub(super) distance: f64,
    pub(super) sheet: u32,
    pub(super) cell: [u32; 2],
    pub(super) parameters: DVec2,
}

impl Answer {
    /// The nearer one, or at the same distance the first.
    fn precedes(&self, other: &Answer) -> bool {
        let key = |answer: &Answer| (answer.distance, answer.sheet, answer.cell);
        key(self) < key(other)
    }

    pub(super) fn place(&self) -> Place {
        Place { sheet: self.sheet, cell: self.cell, u: self.parameters.x, v: self.parameters.y }
    }
}

/// An upper bound of the least distance: that of an answer, of a corner, or the limit of the query.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct UpperBound {
    pub(super) distance: f64,
    tolerance: f64,
}

impl UpperBound {
    pub(super) fn new(distance: f64, tolerance: f64) -> Self {
        UpperBound { distance, tolerance }
    }

    /// The distance beyond which nothing need be examined.
    #[inline(always)]
    pub(super) fn prune_bound(&self) -> f64 {
        self.distance + self.tolerance
    }

    /// Takes note of a point at a distance.
    #[inline(always)]
    pub(super) fn lower(&mut self, distance: f64) {
        self.distance = self.distance.min(distance);
    }
}

/// The answers of a search.
#[derive(Debug, Default)]
pub(super) struct Incumbent {
    pub(super) query: DVec3,
    /// The length to which distances are proved: at least what rounding allows.
    pub(super) tolerance: f64,
    pub(super) upper: UpperBound,
    /// The nearest answer so far.
    pub(super) best: Option<Answer>,
    /// Answers within the tolerance of the nearest, or not much farther.
    ties: Vec<Answer>,
    /// The unit vector from the nearest answer to the query; 0 as long as there is none.
    pub(super) direction: DVec3,
}

impl Incumbent {
    pub(super) fn begin(&mut self, query: DVec3, limit: f64, tolerance: f64) {
        self.ties.clear();
        (self.best, self.direction) = (None, DVec3::ZERO);
        (self.query, self.tolerance, self.upper) = (query, tolerance, UpperBound::new(limit, tolerance));
    }

    /// The distance of the nearest answer.
    #[inline(always)]
    pub(super) fn distance(&self) -> f64 {
        self.best.map_or(f64::INFINITY, |best| best.distance)
    }

    /// True if an answer at this distance would be nearer by more than a trifle.
    pub(super) fn is_gain(&self, distance: f64) -> bool {
        distance < self.distance() * (1.0 - MIN_RELATIVE_GAIN)
    }

    /// Adds a point of the surface.
    pub(super) fn add(&mut self, answer: Answer) {
        let distance = self.distance();
        self.upper.lower(answer.distance);
        if self.best.is_none_or(|best| answer.precedes(&best)) {
            self.best = Some(answer);
            self.direction = (self.query - answer.point).normalize_or_zero();
            if answer.distance < distance - self.tolerance {
                self.ties.clear();
            }
        }
        if answer.distance <= self.upper.prune_bound() && self.ties.len() < MAX_TIES {
            // A pole is in many cells: one answer suffices.
            let same = 0.1 * self.separation();
            if self.ties.iter().all(|other| other.point.distance(answer.point) > same) {
                self.ties.push(answer);
            }
        }
    }

    /// The distance beyond which points do not count as the same nearest point.
    fn separation(&self) -> f64 {
        let distance = self.distance();
        // Round a nearest point on a plane, all within this is as near.
        let alike = (2.0 * distance * self.tolerance).sqrt();
        (0.01 * distance).max(8.0 * alike)
    }

    /// True if another answer is as near, at another place.
    pub(super) fn is_ambiguous(&self, best: &Answer) -> bool {
        let within = best.distance + self.tolerance;
        let mut ties = self.ties.iter().filter(|other| other.distance <= within);
        ties.any(|other| other.point.distance(best.point) > self.separation())
    }
}
