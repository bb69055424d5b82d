//! The nearest points of two curves of a net.
//!
//! Best-first branch and bound: the pair of boxes with the smallest gap is refined next. Invariant:
//! the gap of a pair is a lower bound of the distance of its curves. The search ends at the first
//! pair whose gap is not below the best distance. Cost: about O(log segments), at most
//! [`MAX_SPLIT_PAIRS_OF_PARTS`] splits.

use super::net_curve::{CurvePlace, NetCurve, restrict_segment};
use crate::frontier::{BranchAndBound, Frontier};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::Aabb;
use gusset_base::geom::bernstein::evaluate_with_slope;

/// Largest number of pairs of parts that are split for two curves. Without a limit, curves that
/// coincide would never end.
const MAX_SPLIT_PAIRS_OF_PARTS: usize = 1 << 14;
/// Largest number of halvings of a segment.
const MAX_SUBDIVISION_DEPTH: u32 = 48;
/// Largest number of Newton steps from a start.
const MAX_NEWTON_STEPS: usize = 16;

/// A binary hierarchy of boxes over the segments of a curve.
pub(super) struct SegmentBoxTree {
    levels: Vec<Vec<Aabb>>,
}

impl SegmentBoxTree {
    pub(super) fn from_curve<const N: usize>(net_curve: &NetCurve<N>) -> Result<Self> {
        let mut levels = alloc::with_capacity(32)?;
        let mut level = alloc::collect(net_curve.segments.iter().map(Aabb::from_points))?;
        while level.len() > 1 {
            let joined = |pair: &[Aabb]| pair.iter().fold(Aabb::EMPTY, |whole, part| whole.union(*part));
            let above = alloc::collect(level.chunks(2).map(joined))?;
            levels.push(std::mem::replace(&mut level, above));
        }
        levels.push(level);
        Ok(SegmentBoxTree { levels })
    }

    fn box_at(&self, (level, k): (usize, usize)) -> Aabb {
        self.levels[level][k]
    }

    /// The one or two children of a box.
    fn child_indices(&self, (level, k): (usize, usize)) -> impl Iterator<Item = (usize, usize)> {
        let count = self.levels[level - 1].len();
        (2 * k..(2 * k + 2).min(count)).map(move |child| (level - 1, child))
    }
}

/// The places where two curves are nearest to each other.
#[derive(Debug, Clone, Copy)]
pub(super) struct NearestCurvePlaces {
    pub(super) places: [CurvePlace; 2],
    pub(super) distance: f64,
}

/// A part of a segment of each curve.
struct SegmentPartPair<const N: usize> {
    segments: [usize; 2],
    points: [[DVec3; N]; 2],
    start_parameters: [f64; 2],
    parameter_lengths: [f64; 2],
    depth: u32,
}

/// A pair that may be closer: of boxes over segments, or of parts of segments.
enum CurvePairTask<const N: usize> {
    Boxes([(usize, usize); 2]),
    SegmentPair(Box<SegmentPartPair<N>>),
}

/// Finds the nearest points of two curves. Their distance exceeds the smallest one by at most
/// `slack`.
pub(super) fn nearest_points_of_curves<const N: usize>(
    net_curves: [&NetCurve<N>; 2],
    boxes: [&SegmentBoxTree; 2],
    slack: f64,
) -> Result<NearestCurvePlaces> {
    let best = NearestCurvePlaces { places: [CurvePlace { segment: 0, parameter: 0.0 }; 2], distance: f64::INFINITY };
    let mut search = NearestPointsSearch {
        net_curves,
        boxes,
        slack,
        nearest_places: best,
        frontier: Frontier::default(),
        added: 0,
        splits: 0,
    };
    search.push_task(0.0, CurvePairTask::Boxes(boxes.map(|boxes| (boxes.levels.len() - 1, 0))))?;
    search.search_best_first()?;
    Ok(search.nearest_places)
}

/// The search for the nearest points of two curves.
struct NearestPointsSearch<'a, const N: usize> {
    net_curves: [&'a NetCurve<N>; 2],
    boxes: [&'a SegmentBoxTree; 2],
    slack: f64,
    nearest_places: NearestCurvePlaces,
    /// Among equal gaps, the pair added first comes first.
    frontier: Frontier<CurvePairTask<N>, usize>,
    added: usize,
    splits: usize,
}

impl<const N: usize> BranchAndBound for NearestPointsSearch<'_, N> {
    type SearchTask = CurvePairTask<N>;
    type TieBreakKey = usize;
    type StopReason = Error;

    fn frontier(&mut self) -> &mut Frontier<CurvePairTask<N>, usize> {
        &mut self.frontier
    }

    fn is_bound_wanted(&mut self, gap: f64) -> bool {
        let is_settled = gap >= self.nearest_places.distance - self.slack;
        !is_settled
    }

    fn branch_task(&mut self, gap: f64, task: CurvePairTask<N>) -> Result<()> {
        match task {
            CurvePairTask::Boxes([a, b]) if a.0 == 0 && b.0 == 0 => {
                let of = [a.1, b.1];
                let points = [0, 1].map(|k| self.net_curves[k].segments[of[k]]);
                let whole = SegmentPartPair {
                    segments: of,
                    points,
                    start_parameters: [0.0; 2],
                    parameter_lengths: [1.0; 2],
                    depth: 0,
                };
                self.push_task(gap, CurvePairTask::SegmentPair(Box::new(whole)))
            }
            CurvePairTask::Boxes(pair) => {
                let taller = usize::from(pair[0].0 < pair[1].0);
                let boxes = self.boxes;
                boxes[taller].child_indices(pair[taller]).try_for_each(|child| {
                    let mut pair = pair;
                    pair[taller] = child;
                    let [a, b] = [0, 1].map(|k| boxes[k].box_at(pair[k]));
                    self.push_task(a.distance(&b), CurvePairTask::Boxes(pair))
                })
            }
            CurvePairTask::SegmentPair(parts) => {
                self.improve_best_by_descent(&parts);
                if parts.depth == MAX_SUBDIVISION_DEPTH || self.splits == MAX_SPLIT_PAIRS_OF_PARTS {
                    return Ok(());
                }
                self.splits += 1;
                parts.halve_longer_part().into_iter().try_for_each(|half| {
                    let [a, b] = half.points.map(Aabb::from_points);
                    self.push_task(a.distance(&b), CurvePairTask::SegmentPair(Box::new(half)))
                })
            }
        }
    }
}

impl<const N: usize> NearestPointsSearch<'_, N> {
    fn push_task(&mut self, gap: f64, task: CurvePairTask<N>) -> Result<()> {
        self.added += 1;
        self.frontier.push(gap, self.added, task)
    }

    /// Improves the best places by a descent from the middle of two parts.
    fn improve_best_by_descent(&mut self, parts: &SegmentPartPair<N>) {
        let whole = [0, 1].map(|k| self.net_curves[k].segments[parts.segments[k]]);
        let minimum =
            minimise_distance(&whole, [0, 1].map(|k| parts.start_parameters[k] + 0.5 * parts.parameter_lengths[k]));
        if minimum.1 < self.nearest_places.distance {
            let places = [0, 1].map(|k| CurvePlace { segment: parts.segments[k], parameter: minimum.0[k] });
            self.nearest_places = NearestCurvePlaces { places, distance: minimum.1 };
        }
    }
}

impl<const N: usize> SegmentPartPair<N> {
    /// Halves the longer part, and pairs each half with the other part.
    fn halve_longer_part(&self) -> [SegmentPartPair<N>; 2] {
        let [a, b] = self.points.map(|points| Aabb::from_points(points).size().length_squared());
        let longer = usize::from(b > a);
        [0.0, 0.5].map(|from| {
            let mut half = SegmentPartPair { depth: self.depth + 1, ..*self };
            half.points[longer] = restrict_segment(&self.points[longer], [from, from + 0.5]);
            half.start_parameters[longer] += from * self.parameter_lengths[longer];
            half.parameter_lengths[longer] *= 0.5;
            half
        })
    }
}

/// Descends from parameters of two segments to a local minimum of the distance, with Gauss-Newton
/// steps within 0 to 1. Returns the parameters and the distance.
fn minimise_distance<const N: usize>(segments: &[[DVec3; N]; 2], start: [f64; 2]) -> ([f64; 2], f64) {
    let apart = |at: [f64; 2]| {
        let [[p, pd], [q, qd]] = [0, 1].map(|k| evaluate_with_slope(&segments[k], at[k]));
        (p - q, pd, qd)
    };
    let mut at = start;
    let mut here = apart(at);
    for _ in 0..MAX_NEWTON_STEPS {
        let (from, a, b) = here;
        let slopes = [a.dot(from), -b.dot(from)];
        let held = [0, 1].map(|k| (at[k] <= 0.0 && slopes[k] >= 0.0) || (at[k] >= 1.0 && slopes[k] <= 0.0));
        let [aa, ab, bb] = [a.length_squared(), -a.dot(b), b.length_squared()];
        let determinant = aa * bb - ab * ab;
        let mut step = [slopes[0] / aa, slopes[1] / bb];
        if held == [false, false] && determinant > 1e-12 * aa * bb {
            step = [(bb * slopes[0] - ab * slopes[1]) / determinant, (aa * slopes[1] - ab * slopes[0]) / determinant];
        }
        let mut length = 1.0;
        let next = loop {
            let moved = |k: usize| if held[k] || !step[k].is_finite() { at[k] } else { at[k] - length * step[k] };
            let there = [0, 1].map(|k| moved(k).clamp(0.0, 1.0));
            let reached = apart(there);
            if reached.0.length_squared() < from.length_squared() {
                break Some((there, reached));
            }
            length *= 0.25;
            if length < 1e-3 {
                break None;
            }
        };
        let Some((there, reached)) = next else { break };
        (at, here) = (there, reached);
    }
    (at, here.0.length())
}
