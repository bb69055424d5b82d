//! The search for the nearest points of two sides: pairs of pieces by rising lower bounds.
//!
//! The bound of a pair is the distance between the hulls of its pieces. If a pair may contain
//! closer points, its coarser piece is divided. A pair of nets also yields closer points by
//! descent. It is settled if the distance is a convex function of the parameters. Invariant: no
//! points are closer than the best pair so far less the tolerance, than `least_settled_bound`, or than the
//! bound of the first waiting pair.
//!
//! If all points of two pieces are equally far, as on concentric spheres, bounds cannot separate
//! pairs. The search then ends without proof at [`MAX_EXAMINED_PAIRS`] pairs or
//! [`MAX_STORED_CONTROL_POINTS`] control points. It ends at [`MIN_EXAMINED_PAIRS`] if the last gain
//! is long past and little is left to gain. If it has no points by then, as of a surface in one
//! point, it divides pieces into nets only.

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
    piece_of_a: usize,
    piece_of_b: usize,
    start: PairParameters,
}

/// A point on each side.
#[derive(Debug, Clone, Copy)]
pub(super) struct NearestPair {
    pub(super) distance: f64,
    pub(super) position_on_a: PiecePosition,
    pub(super) position_on_b: PiecePosition,
}

/// The search, in the scaled coordinates of the views.
pub(super) struct DistanceSearch<'a> {
    pub(super) side_a: SidePieces<'a>,
    pub(super) side_b: SidePieces<'a>,
    /// The length to which the distance is proven, and the rounding of distances.
    pub(super) tolerance: f64,
    pub(super) distance_rounding: f64,
    pub(super) job: &'a Job<'a>,
    pub(super) nearest_pair: Option<NearestPair>,
    /// The pair of pieces of `nearest_pair`, and its place there.
    pieces_and_jet_of_nearest: Option<(PiecePair, DistanceJet)>,
    /// The smallest bound of settled pairs.
    pub(super) least_settled_bound: f64,
    pub(super) examined_pairs: usize,
    examined_pairs_at_last_gain: usize,
    frontier: Frontier<PiecePair, (u32, usize, usize)>,
    depth: u32,
}

impl<'a> DistanceSearch<'a> {
    pub(super) fn new(sides: [SidePieces<'a>; 2], tolerance: f64, rounding: f64, job: &'a Job<'a>) -> Self {
        let [a, b] = sides;
        DistanceSearch {
            side_a: a,
            side_b: b,
            tolerance,
            distance_rounding: rounding,
            job,
            nearest_pair: None,
            pieces_and_jet_of_nearest: None,
            least_settled_bound: f64::INFINITY,
            examined_pairs: 0,
            examined_pairs_at_last_gain: 0,
            frontier: Frontier::default(),
            depth: 0,
        }
    }

    /// Searches for the nearest points. Returns a lower bound of the distance.
    pub(super) fn find_nearest_pair(&mut self) -> Result<f64> {
        self.consider_pair(0, 0)?;
        let left = self.search_best_first()?.unwrap_or(f64::INFINITY);
        self.descend_from_best_pair();
        Ok(left.min(self.least_settled_bound).min(self.best_distance()))
    }

    /// Descends from the best points to a local minimum in their pieces. If the pair was settled
    /// without a descent, the distance is within the tolerance, but the points may be beside the
    /// nearest ones.
    fn descend_from_best_pair(&mut self) {
        let Some((pair, value)) = self.pieces_and_jet_of_nearest else { return };
        let (Some(a), Some(b)) = (self.side_a.control_net(pair.piece_of_a), self.side_b.control_net(pair.piece_of_b))
        else {
            return;
        };
        let value = NetPair { net_of_a: a, net_of_b: b }.minimise_distance(value, MAX_DESCENT_STEPS);
        self.record_pair_if_closer(&pair, &value);
    }

    pub(super) fn best_distance(&self) -> f64 {
        self.nearest_pair.map_or(f64::INFINITY, |best| best.distance)
    }

    /// Pairs with at least this bound need not be examined. Half of the tolerance is reserved for
    /// sums of rounding errors.
    fn prune_bound(&self) -> f64 {
        self.best_distance() - 0.5 * self.tolerance
    }

    fn record_lower_bound(&mut self, bound: f64) {
        self.least_settled_bound = self.least_settled_bound.min(bound);
    }

    /// Settles a pair by its bound, or adds it to the frontier.
    fn consider_pair(&mut self, a: usize, b: usize) -> Result<()> {
        let limit = self.prune_bound();
        let apart = self.side_a.bounding_box(a).distance(self.side_b.bounding_box(b)) - self.distance_rounding;
        if apart >= limit {
            self.record_lower_bound(apart);
            return Ok(());
        }
        let found = hull_distance(
            self.side_a.hull_points(a),
            self.side_b.hull_points(b),
            limit + self.distance_rounding,
            0.1 * self.tolerance,
        );
        let bound = (found.lower_bound - self.distance_rounding).max(apart).max(0.0);
        if bound >= limit {
            self.record_lower_bound(bound);
            return Ok(());
        }
        let corners = &found.corners[..found.corner_count];
        let ([u, v], [s, t]) = (
            self.side_a.start_parameters(a, corners, |corner| corner.point_of_a),
            self.side_b.start_parameters(b, corners, |corner| corner.point_of_b),
        );
        let pair = PiecePair { piece_of_a: a, piece_of_b: b, start: [u, v, s, t] };
        // Among equal bounds, the latest pair comes first: where hulls meet, this leads straight to
        // points that meet.
        self.depth = self.depth.saturating_add(1);
        self.frontier.push(bound, (u32::MAX - self.depth, a, b), pair)
    }

    /// Records a point on each side, if it is closer than the best pair.
    fn record_pair_if_closer(&mut self, pair: &PiecePair, value: &DistanceJet) {
        let [u, v, s, t] = value.parameters;
        let nearest_pair = NearestPair {
            distance: value.distance,
            position_on_a: self.side_a.position_at(pair.piece_of_a, [u, v]),
            position_on_b: self.side_b.position_at(pair.piece_of_b, [s, t]),
        };
        let key = |nearest: &NearestPair| (nearest.distance, nearest.position_on_a, nearest.position_on_b);
        if self.nearest_pair.is_none_or(|best| key(&nearest_pair) < key(&best)) {
            if nearest_pair.distance < self.best_distance() * (1.0 - MIN_RELATIVE_DISTANCE_GAIN) {
                self.examined_pairs_at_last_gain = self.examined_pairs;
            }
            (self.nearest_pair, self.pieces_and_jet_of_nearest) = (Some(nearest_pair), Some((*pair, *value)));
        }
    }

    /// Examines a pair of nets. Returns its bound, which may be better than the known one.
    fn examine_net_pair(&mut self, pair: &PiecePair, bound: f64) -> f64 {
        let balls = [self.side_a.net_balls(pair.piece_of_a), self.side_b.net_balls(pair.piece_of_b)];
        let (Some(a), Some(b)) = (self.side_a.control_net(pair.piece_of_a), self.side_b.control_net(pair.piece_of_b))
        else {
            return bound;
        };
        let nets = NetPair { net_of_a: a, net_of_b: b };
        let start = nets.distance_jet_at(pair.start);
        let is_fresh = self.side_a.is_whole_cell_or_segment(pair.piece_of_a)
            && self.side_b.is_whole_cell_or_segment(pair.piece_of_b);
        let (value, proven) = if nets.is_distance_convex([&balls[0], &balls[1]]) {
            let value = nets.minimise_distance(start, MAX_DESCENT_STEPS);
            (value, value.min_distance_if_convex() - self.distance_rounding)
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
        let (of_a, of_b) = (
            self.side_a.gain_and_parameter_of_division(pair.piece_of_a),
            self.side_b.gain_and_parameter_of_division(pair.piece_of_b),
        );
        let has_net =
            [self.side_a.control_net(pair.piece_of_a).is_some(), self.side_b.control_net(pair.piece_of_b).is_some()];
        // Only two nets yield points, without which no search ends.
        let needs_nets = has_net.contains(&false)
            && self.examined_pairs >= MIN_EXAMINED_PAIRS
            && self.best_distance() == f64::INFINITY;
        // A smaller gain may be rounding, which division does not reduce.
        let least_gain = (1e-3 * self.tolerance).max(self.distance_rounding);
        if of_a.0.max(of_b.0) > least_gain && !needs_nets {
            return if of_a.0 >= of_b.0 { (true, of_a.1) } else { (false, of_b.1) };
        }
        if has_net.contains(&false) {
            return (!has_net[0], 0);
        }
        let (of_a, of_b) = (
            self.side_a.length_and_longer_parameter_of_flat_net(pair.piece_of_a),
            self.side_b.length_and_longer_parameter_of_flat_net(pair.piece_of_b),
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
        let is_long = self.examined_pairs >= MIN_EXAMINED_PAIRS
            && self.examined_pairs - self.examined_pairs_at_last_gain >= self.examined_pairs / 2;
        let is_spent = self.examined_pairs >= MAX_EXAMINED_PAIRS
            || self.side_a.point_count() + self.side_b.point_count() >= MAX_STORED_CONTROL_POINTS
            || (is_long && distance - bound <= SMALL_RELATIVE_GAP * distance);
        bound < self.prune_bound() && distance > self.distance_rounding && !(is_spent && distance.is_finite())
    }

    fn branch_task(&mut self, bound: f64, pair: PiecePair) -> Result<()> {
        self.examined_pairs += 1;
        if self.examined_pairs.is_multiple_of(PAIRS_PER_REPORT) {
            self.job.step(self.examined_pairs as f64 / (2 * MAX_EXAMINED_PAIRS) as f64, PROGRESS_STAGE)?;
        }
        let are_nets =
            self.side_a.control_net(pair.piece_of_a).is_some() && self.side_b.control_net(pair.piece_of_b).is_some();
        if are_nets {
            let bound = self.examine_net_pair(&pair, bound);
            let is_least = self.side_a.parameter_size(pair.piece_of_a).max(self.side_b.parameter_size(pair.piece_of_b))
                <= MIN_DIVIDED_PART_SIZE;
            if bound >= self.prune_bound() || is_least {
                self.record_lower_bound(bound);
                return Ok(());
            }
        }
        let (of_a, parameter) = self.choose_division(&pair);
        if of_a {
            for part in self.side_a.divide_piece(pair.piece_of_a, parameter)? {
                self.consider_pair(part, pair.piece_of_b)?;
            }
        } else {
            for part in self.side_b.divide_piece(pair.piece_of_b, parameter)? {
                self.consider_pair(pair.piece_of_a, part)?;
            }
        }
        Ok(())
    }
}
