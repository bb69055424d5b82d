//! The best answer so far, other answers at nearly the same distance, and the upper bound.
//!
//! The search excludes nothing that may be within the tolerance of the best answer. The answer
//! therefore does not depend on the order of the search, and other points at the same distance are
//! noticed.

use crate::Place;
use glam::{DVec2, DVec3};

/// Smallest relative decrease of the distance that makes an answer a notable gain.
const MIN_RELATIVE_DISTANCE_GAIN: f64 = 1e-6;
/// Largest number of answers kept to detect ambiguity.
const MAX_KEPT_ANSWERS: usize = 64;

/// A point of the surface that may be the nearest one.
#[derive(Debug, Clone, Copy)]
pub(super) struct NearestPointCandidate {
    pub(super) point: DVec3,
    /// The unit normal; zero where the patch is not regular.
    pub(super) normal: DVec3,
    pub(super) distance: f64,
    pub(super) sheet: u32,
    pub(super) cell: [u32; 2],
    pub(super) parameters: DVec2,
}

impl NearestPointCandidate {
    /// Whether this answer is closer, or at equal distance comes first.
    fn is_preferred_to(&self, other: &NearestPointCandidate) -> bool {
        let key = |answer: &NearestPointCandidate| (answer.distance, answer.sheet, answer.cell);
        key(self) < key(other)
    }

    pub(super) fn place(&self) -> Place {
        Place { sheet: self.sheet, cell: self.cell, u: self.parameters.x, v: self.parameters.y }
    }
}

/// An upper bound of the smallest distance: the distance of an answer or of a corner, or the
/// query's limit.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct DistanceUpperBound {
    pub(super) distance: f64,
    tolerance: f64,
}

impl DistanceUpperBound {
    pub(super) fn new(distance: f64, tolerance: f64) -> Self {
        DistanceUpperBound { distance, tolerance }
    }

    /// The distance beyond which nothing needs to be examined.
    #[inline(always)]
    pub(super) fn max_examined_distance(&self) -> f64 {
        self.distance + self.tolerance
    }

    /// Lowers the bound to the distance of a point.
    #[inline(always)]
    pub(super) fn lower_to_distance(&mut self, distance: f64) {
        self.distance = self.distance.min(distance);
    }
}

/// The answers of a search.
#[derive(Debug, Default)]
pub(super) struct IncumbentAnswers {
    pub(super) query: DVec3,
    /// The length to which distances are proven, at least the rounding error.
    pub(super) tolerance: f64,
    pub(super) distance_upper_bound: DistanceUpperBound,
    /// The nearest answer so far.
    pub(super) nearest_answer: Option<NearestPointCandidate>,
    /// Answers within the tolerance of the nearest one, and a few that are slightly farther.
    ties: Vec<NearestPointCandidate>,
    /// The unit vector from the nearest answer to the query; zero without an answer.
    pub(super) direction: DVec3,
}

impl IncumbentAnswers {
    pub(super) fn begin_query(&mut self, query: DVec3, limit: f64, tolerance: f64) {
        self.ties.clear();
        (self.nearest_answer, self.direction) = (None, DVec3::ZERO);
        (self.query, self.tolerance, self.distance_upper_bound) =
            (query, tolerance, DistanceUpperBound::new(limit, tolerance));
    }

    /// The distance of the nearest answer; infinite without an answer.
    #[inline(always)]
    pub(super) fn nearest_distance(&self) -> f64 {
        self.nearest_answer.map_or(f64::INFINITY, |best| best.distance)
    }

    /// True if an answer at this distance would be notably closer.
    pub(super) fn is_notably_closer(&self, distance: f64) -> bool {
        distance < self.nearest_distance() * (1.0 - MIN_RELATIVE_DISTANCE_GAIN)
    }

    /// Adds a point of the surface.
    pub(super) fn add_answer(&mut self, answer: NearestPointCandidate) {
        let distance = self.nearest_distance();
        self.distance_upper_bound.lower_to_distance(answer.distance);
        if self.nearest_answer.is_none_or(|best| answer.is_preferred_to(&best)) {
            self.nearest_answer = Some(answer);
            self.direction = (self.query - answer.point).normalize_or_zero();
            if answer.distance < distance - self.tolerance {
                self.ties.clear();
            }
        }
        if answer.distance <= self.distance_upper_bound.max_examined_distance() && self.ties.len() < MAX_KEPT_ANSWERS {
            // A pole belongs to many cells, and one answer for it suffices.
            let same = 0.1 * self.min_distance_of_distinct_points();
            if self.ties.iter().all(|other| other.point.distance(answer.point) > same) {
                self.ties.push(answer);
            }
        }
    }

    /// The distance beyond which two nearest points count as different.
    fn min_distance_of_distinct_points(&self) -> f64 {
        let distance = self.nearest_distance();
        // On a plane, all points within this distance of the nearest point are equally close.
        let alike = (2.0 * distance * self.tolerance).sqrt();
        (0.01 * distance).max(8.0 * alike)
    }

    /// True if an answer at another place is equally close.
    pub(super) fn is_ambiguous(&self, best: &NearestPointCandidate) -> bool {
        let within = best.distance + self.tolerance;
        let mut ties = self.ties.iter().filter(|other| other.distance <= within);
        ties.any(|other| other.point.distance(best.point) > self.min_distance_of_distinct_points())
    }
}
