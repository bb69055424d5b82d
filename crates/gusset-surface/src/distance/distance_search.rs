//! The search for the nearest points of two sides: pairs of pieces by rising lower bounds.
//!
//! The bound of a pair is the distance between the hulls of its pieces. If a pair may contain
//! closer points, its coarser piece is divided. A pair of nets also yields closer points by
//! descent. It is settled if the distance is a convex function of the parameters. Invariant: no
//! points are closer than the best pair so far less the tolerance, than `settled`, or than the
//! bound of the first waiting pair.
//!
//! If all points of two pieces are equally far, as on concentric spheres, bounds cannot separate
//! pairs. The search then ends without proof at [`MAX_EXAMINED_PAIRS`] pairs or
//! [`MAX_STORED_CONTROL_POINTS`] control points. It ends at [`MIN_EXAMINED_PAIRS`] if the last gain
//! is long past and little is left to gain.

use super::distance_descent::{DistanceJet, NetPair, PairParameters};
use super::side_pieces::{PiecePosition, SidePieces};
use crate::frontier::{BranchAndBound, Frontier};
use gusset_base::error::{Error, Result};
use gusset_base::geom::hull_distance::hull_distance;
use gusset_base::job::Job;

/// Largest number of pairs examined.
const MAX_EXAMINED_PAIRS: usize = 50_000;
/// Number of pairs examined before a search may end without proof. The gap to the lower bound must
/// be a small fraction of the distance, and half of the pairs must have been examined since the
/// last gain.
const MIN_EXAMINED_PAIRS: usize = 1 << 13;
const SMALL_RELATIVE_GAP: f64 = 1e-3;
const MIN_RELATIVE_DISTANCE_GAIN: f64 = 1e-6;
/// Largest number of control points of pieces, 24 bytes each.
const MAX_STORED_CONTROL_POINTS: usize = 1 << 22;
/// Largest number of descent steps if the descent proves the pair, and otherwise.
const MAX_DESCENT_STEPS: usize = 24;
const MAX_DESCENT_STEPS_WITHOUT_PROOF: usize = 8;
/// Parts of cells and segments of this size are not divided.
const MIN_DIVIDED_PART_SIZE: f64 = 1e-12;
/// Number of pairs between two progress reports.
const PAIRS_PER_REPORT: usize = 256;

pub(super) const PROGRESS_STAGE: &str = "distance";

/// A pair of pieces, and a start for the descent.
#[derive(Debug, Clone, Copy)]
pub(super) struct PiecePair {
    a: usize,
    b: usize,
    start: PairParameters,
}

/// A point on each side.
#[derive(Debug, Clone, Copy)]
pub(super) struct NearestPair {
    pub(super) distance: f64,
    pub(super) a: PiecePosition,
    pub(super) b: PiecePosition,
}

/// The search, in the scaled coordinates of the views.
pub(super) struct DistanceSearch<'a> {
    pub(super) a: SidePieces<'a>,
    pub(super) b: SidePieces<'a>,
    /// The length to which the distance is proven, and the rounding of distances.
    pub(super) tolerance: f64,
    pub(super) rounding: f64,
    pub(super) job: &'a Job<'a>,
    pub(super) best: Option<NearestPair>,
    /// The pair of pieces of `best`, and its place there.
    last: Option<(PiecePair, DistanceJet)>,
    /// The smallest bound of settled pairs.
    pub(super) settled: f64,
    pub(super) pairs: usize,
    pairs_at_gain: usize,
    frontier: Frontier<PiecePair, (u32, usize, usize)>,
    depth: u32,
}

impl<'a> DistanceSearch<'a> {
    pub(super) fn new(sides: [SidePieces<'a>; 2], tolerance: f64, rounding: f64, job: &'a Job<'a>) -> Self {
        let [a, b] = sides;
        DistanceSearch {
            a,
            b,
            tolerance,
            rounding,
            job,
            best: None,
            last: None,
            settled: f64::INFINITY,
            pairs: 0,
            pairs_at_gain: 0,
            frontier: Frontier::default(),
            depth: 0,
        }
    }

    /// Searches for the nearest points. Returns a lower bound of the distance.
    pub(super) fn find_nearest_pair(&mut self) -> Result<f64> {
        self.consider_pair(0, 0)?;
        let left = self.search_best_first()?.unwrap_or(f64::INFINITY);
        self.descend_from_best_pair();
        Ok(left.min(self.settled).min(self.best_distance()))
    }

    /// Descends from the best points to a local minimum in their pieces. If the pair was settled
    /// without a descent, the distance is within the tolerance, but the points may be beside the
    /// nearest ones.
    fn descend_from_best_pair(&mut self) {
        let Some((pair, value)) = self.last else { return };
        let (Some(a), Some(b)) = (self.a.control_net(pair.a), self.b.control_net(pair.b)) else { return };
        let value = NetPair { a, b }.minimise_distance(value, MAX_DESCENT_STEPS);
        self.record_pair_if_closer(&pair, &value);
    }

    pub(super) fn best_distance(&self) -> f64 {
        self.best.map_or(f64::INFINITY, |best| best.distance)
    }

    /// Pairs with at least this bound need not be examined. Half of the tolerance is reserved for
    /// sums of rounding errors.
    fn prune_bound(&self) -> f64 {
        self.best_distance() - 0.5 * self.tolerance
    }

    fn record_lower_bound(&mut self, bound: f64) {
        self.settled = self.settled.min(bound);
    }

    /// Settles a pair by its bound, or adds it to the frontier.
    fn consider_pair(&mut self, a: usize, b: usize) -> Result<()> {
        let limit = self.prune_bound();
        let apart = self.a.bounding_box(a).distance(self.b.bounding_box(b)) - self.rounding;
        if apart >= limit {
            self.record_lower_bound(apart);
            return Ok(());
        }
        let found =
            hull_distance(self.a.hull_points(a), self.b.hull_points(b), limit + self.rounding, 0.1 * self.tolerance);
        let bound = (found.bound - self.rounding).max(apart).max(0.0);
        if bound >= limit {
            self.record_lower_bound(bound);
            return Ok(());
        }
        let corners = &found.corners[..found.count];
        let ([u, v], [s, t]) = (
            self.a.start_parameters(a, corners, |corner| corner.a),
            self.b.start_parameters(b, corners, |corner| corner.b),
        );
        let pair = PiecePair { a, b, start: [u, v, s, t] };
        // Among equal bounds, the latest pair comes first: where hulls meet, this leads straight to
        // points that meet.
        self.depth = self.depth.saturating_add(1);
        self.frontier.push(bound, (u32::MAX - self.depth, a, b), pair)
    }

    /// Records a point on each side, if it is closer than the best pair.
    fn record_pair_if_closer(&mut self, pair: &PiecePair, value: &DistanceJet) {
        let [u, v, s, t] = value.at;
        let nearest_pair = NearestPair {
            distance: value.distance,
            a: self.a.position_at(pair.a, [u, v]),
            b: self.b.position_at(pair.b, [s, t]),
        };
        let key = |nearest: &NearestPair| (nearest.distance, nearest.a, nearest.b);
        if self.best.is_none_or(|best| key(&nearest_pair) < key(&best)) {
            if nearest_pair.distance < self.best_distance() * (1.0 - MIN_RELATIVE_DISTANCE_GAIN) {
                self.pairs_at_gain = self.pairs;
            }
            (self.best, self.last) = (Some(nearest_pair), Some((*pair, *value)));
        }
    }

    /// Examines a pair of nets. Returns its bound, which may be better than the known one.
    fn examine_net_pair(&mut self, pair: &PiecePair, bound: f64) -> f64 {
        let balls = [self.a.net_balls(pair.a), self.b.net_balls(pair.b)];
        let (Some(a), Some(b)) = (self.a.control_net(pair.a), self.b.control_net(pair.b)) else { return bound };
        let nets = NetPair { a, b };
        let start = nets.distance_jet_at(pair.start);
        let is_fresh = self.a.is_whole_cell_or_segment(pair.a) && self.b.is_whole_cell_or_segment(pair.b);
        let (value, proven) = if nets.is_distance_convex([&balls[0], &balls[1]]) {
            let value = nets.minimise_distance(start, MAX_DESCENT_STEPS);
            (value, value.min_distance_if_convex() - self.rounding)
        } else if is_fresh || start.distance < self.best_distance() {
            (nets.minimise_distance(start, MAX_DESCENT_STEPS_WITHOUT_PROOF), 0.0)
        } else {
            (start, 0.0)
        };
        self.record_pair_if_closer(pair, &value);
        bound.max(proven)
    }

    /// Selects the piece to divide (true for A), and the parameter to divide it along.
    fn choose_division(&mut self, pair: &PiecePair) -> (bool, usize) {
        let (of_a, of_b) =
            (self.a.gain_and_parameter_of_division(pair.a), self.b.gain_and_parameter_of_division(pair.b));
        if of_a.0.max(of_b.0) > 1e-3 * self.tolerance {
            return if of_a.0 >= of_b.0 { (true, of_a.1) } else { (false, of_b.1) };
        }
        let has_net = [self.a.control_net(pair.a).is_some(), self.b.control_net(pair.b).is_some()];
        if has_net.contains(&false) {
            return (!has_net[0], 0);
        }
        let (of_a, of_b) = (
            self.a.length_and_longer_parameter_of_flat_net(pair.a),
            self.b.length_and_longer_parameter_of_flat_net(pair.b),
        );
        if of_a.0 >= of_b.0 { (true, of_a.1) } else { (false, of_b.1) }
    }
}

impl BranchAndBound for DistanceSearch<'_> {
    type SearchTask = PiecePair;
    type TieBreakKey = (u32, usize, usize);
    type StopReason = Error;

    fn frontier(&mut self) -> &mut Frontier<PiecePair, (u32, usize, usize)> {
        &mut self.frontier
    }

    fn is_bound_wanted(&mut self, bound: f64) -> bool {
        let distance = self.best_distance();
        let is_long = self.pairs >= MIN_EXAMINED_PAIRS && self.pairs - self.pairs_at_gain >= self.pairs / 2;
        let is_spent = self.pairs >= MAX_EXAMINED_PAIRS
            || self.a.point_count() + self.b.point_count() >= MAX_STORED_CONTROL_POINTS
            || (is_long && distance - bound <= SMALL_RELATIVE_GAP * distance);
        bound < self.prune_bound() && distance > self.rounding && !(is_spent && distance.is_finite())
    }

    fn branch_task(&mut self, bound: f64, pair: PiecePair) -> Result<()> {
        self.pairs += 1;
        if self.pairs.is_multiple_of(PAIRS_PER_REPORT) {
            self.job.step(self.pairs as f64 / (2 * MAX_EXAMINED_PAIRS) as f64, PROGRESS_STAGE)?;
        }
        let are_nets = self.a.control_net(pair.a).is_some() && self.b.control_net(pair.b).is_some();
        if are_nets {
            let bound = self.examine_net_pair(&pair, bound);
            let is_least = self.a.parameter_size(pair.a).max(self.b.parameter_size(pair.b)) <= MIN_DIVIDED_PART_SIZE;
            if bound >= self.prune_bound() || is_least {
                self.record_lower_bound(bound);
                return Ok(());
            }
        }
        let (of_a, parameter) = self.choose_division(&pair);
        if of_a {
            for part in self.a.divide_piece(pair.a, parameter)? {
                self.consider_pair(part, pair.b)?;
            }
        } else {
            for part in self.b.divide_piece(pair.b, parameter)? {
                self.consider_pair(pair.a, part)?;
            }
        }
        Ok(())
    }
}
