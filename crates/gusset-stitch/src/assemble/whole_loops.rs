//! Pairs of whole loops: the best one-to-one choice among loops that look at each other.
//!
//! A vertex of a loop looks along its **conormal**, off the surface. Loop R looks at loop K by the
//! mean cosine, over R's length, of the angle between the conormal and the direction to the nearest
//! point of K. The look is near 1 across a cut, near 0 for loops side by side, and negative for a
//! loop that lies behind. Two loops within the allowed gap may be joined in two cases:
//!
//! * They look at each other. Nearly all vertices that have any loop ahead of them have the other
//!   loop at most a little farther away than the nearest loop ahead.
//! * Nearly all vertices of each loop have their nearest vertex on the other. In addition, these
//!   nearest points wind once around the other loop, or the distances are similar. The loops must
//!   not lie beside each other: then all directions to the other loop agree, while conormals point
//!   all round.
//!
//! Pairs are chosen to maximise the sum of their gains (see [`assignment`](super::assignment)). The
//! gain grows with the nearness, the looks, and the similarity of the lengths.
//!
//! Bounds and weights are our own, from known pairs. The known pairs are 91 across slabs cut out of
//! closed meshes (one seed of `make bench ONLY=truth`). Their worse look is above 0.16, the sum of
//! both above 0.9, and the gap at most 0.19 of the mesh's size. Few of 124 wrong pairs look like
//! that.

use super::assignment::{PossiblePair, choose_best_pairs};
use super::candidates::{FacingLoops, FacingSearch, LoopMeasures, STAGE};
use crate::stitch::polyline;
use crate::stitch::stitch_rim::Rim;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;

/// Two loops face each other only if the mean cosine between conormal and direction to the other
/// loop is at least this for each loop.
const MIN_FACING_COSINE: f64 = 0.1;

/// Two loops face each other only if the sum of both mean cosines is at least this.
const MIN_FACING_COSINE_SUM: f64 = 0.8;

/// Two loops lie beside each other if one of them does, neither winds around the other, and the sum of both
/// mean cosines is smaller than this.
const MIN_FACING_COSINE_SUM_OF_ONLY_LOOPS: f64 = 0.3;

/// A loop lies ahead of a vertex within 45 degrees of its conormal.
const MIN_COSINE_AHEAD: f64 = 0.7;

/// Smallest fraction of the vertices with any loop ahead for which the other loop is at most a
/// little farther.
const MIN_AHEAD_VERTEX_SHARE: f64 = 0.8;

/// A loop is a little farther if its distance is at most this multiple of the distance of the
/// nearest loop ahead.
const MAX_FARTHER_DISTANCE_RATIO: f64 = 3.0;

/// Smallest fraction of vertices whose nearest vertex is on the other loop, for loops around each
/// other.
const MIN_NEAREST_VERTEX_SHARE: f64 = 0.9;

/// Distances are similar if the largest is at most this many times the smallest, or the spacing.
const MAX_SIMILAR_DISTANCE_RATIO: f64 = 4.0;

/// Directions agree if the mean of their unit vectors is longer than this.
const MIN_MEAN_DIRECTION_LENGTH: f64 = 0.5;

/// A loop lies beside another if directions agree, and its look is smaller than this fraction of
/// their mean.
const MAX_BESIDE_COSINE_RATIO: f64 = 0.5;

/// The widest gap that is closed by default, relative to the size of the larger component.
const DEFAULT_GAP_TO_SIZE_RATIO: f64 = 0.2;

/// Number of evenly spaced vertices of a loop that measure its look at another.
const MAX_FACING_SAMPLES: usize = 1 << 10;

/// Number of evenly spaced vertices of a loop that search for loops ahead.
const MAX_AHEAD_SAMPLES: usize = 1 << 7;

/// Smallest factor of a pair's gain for its gap, and for its look, relative to the best.
const MIN_PAIR_GAIN_FACTOR: f64 = 0.2;

/// Factor of the gain of a pair of loops on one piece.
const SAME_PIECE_GAIN_FACTOR: f64 = 0.5;

/// How one loop sees another.
#[derive(Clone, Copy)]
pub(super) struct FacingMeasures {
    /// The mean distance from its vertices to the nearest point of the other loop.
    pub(super) mean_gap: f64,
    /// The mean cosine between its conormals and the directions to the other loop.
    pub(super) mean_facing_cosine: f64,
    /// True if its nearest points wind once around the other loop.
    winds_around: bool,
    /// True if its distances are similar, or its nearest points wind once around the other loop.
    winds_around_or_is_parallel: bool,
    /// True if it lies beside the other loop.
    lies_beside: bool,
}

impl FacingMeasures {
    /// Returns true if two loops look at each other; `back` is how the other loop sees this one.
    pub(super) fn are_mutual(&self, back: &FacingMeasures) -> bool {
        self.mean_facing_cosine.min(back.mean_facing_cosine) >= MIN_FACING_COSINE
            && self.mean_facing_cosine + back.mean_facing_cosine >= MIN_FACING_COSINE_SUM
            && !(self.lies_beside && back.lies_beside)
    }
}

/// The nearest loop ahead of a vertex.
struct LoopAhead {
    index_on_rim: u32,
    rim: u32,
    distance: f64,
}

/// The fraction of one loop's vertices that have another loop nearest to them.
#[derive(Clone, Copy)]
pub(super) struct NearestLoopShare {
    /// The seeing loop, and the seen loop.
    pub(super) rims: [u32; 2],
    pub(super) vertex_fraction: f64,
}

impl FacingSearch<'_> {
    /// Returns the largest gap across which two loops may be joined whole.
    pub(super) fn max_gap_between_whole_loops(&self, first: usize, second: usize) -> f64 {
        let [a, b] = [first, second].map(|k| &self.candidates[k]);
        self.max_gap.unwrap_or_else(|| {
            let size = a.component_size.max(b.component_size);
            self.whole_loop_gap_factor * a.mean_radius.min(b.mean_radius).max(DEFAULT_GAP_TO_SIZE_RATIO * size)
        })
    }

    /// Returns the pairs of whole loops. `near` lists the loops with the nearest vertices of each
    /// loop, in ascending order.
    ///
    /// O(V log V) for V vertices on loops, plus nearest-point searches for each pair of loops ahead
    /// of each other.
    pub(super) fn pair_whole_loops(&self, near: &[NearestLoopShare], job: &Job<'_>) -> Result<Vec<FacingLoops>> {
        let (building, job) = (job.sub_job(0.0, 0.1), job.sub_job(0.1, 1.0));
        let mut trees = alloc::with_capacity(self.rims.len())?;
        for (r, rim) in self.rims.iter().enumerate() {
            trees.push(KdTree::new(&rim.points, &building.sub_job_of_item(r, self.rims.len()), STAGE)?);
        }
        let lengths = alloc::try_collect(self.rims.iter().map(|rim| polyline::lengths(&rim.points, true)))?;
        let conormals = alloc::try_collect(self.rims.iter().map(rim_conormals))?;
        let before = self.find_loops_ahead(&conormals, &job.sub_job(0.0, 0.5))?;
        let mut pairs = alloc::gather(near.iter().map(|seen| seen.rims))?;
        for (of_loop, r) in before.iter().zip(0u32..) {
            alloc::extend(&mut pairs, of_loop.iter().map(|ahead| [r, ahead.rim]))?;
        }
        pairs.iter_mut().for_each(|rims| rims.sort_unstable());
        sort_distinct(&mut pairs);
        let (mut matches, mut gaps) = (Vec::new(), Vec::new());
        for (number, &[r, k]) in pairs.iter().enumerate() {
            job.step(0.5 + 0.5 * number as f64 / pairs.len() as f64, STAGE)?;
            let near = nearest_share_of_pair(near, [r, k]).min(nearest_share_of_pair(near, [k, r]));
            let [r, k] = [r as usize, k as usize];
            let hardly_farther =
                |r: usize, k: usize| share_of_vertices_with_loop_ahead(&before[r], &self.rims[r], &trees[k]);
            let before = hardly_farther(r, k).min(hardly_farther(k, r));
            if before < MIN_AHEAD_VERTEX_SHARE && near < MIN_NEAREST_VERTEX_SHARE {
                continue;
            }
            let there = measure_loop_facing(&self.rims[r], &conormals[r], &self.rims[k], &lengths[k], &trees[k])?;
            let back = measure_loop_facing(&self.rims[k], &conormals[k], &self.rims[r], &lengths[r], &trees[r])?;
            let (gap, limit) = (there.mean_gap.max(back.mean_gap), self.max_gap_between_whole_loops(r, k));
            let looks = there.mean_facing_cosine + back.mean_facing_cosine;
            let face = before >= MIN_AHEAD_VERTEX_SHARE
                && there.mean_facing_cosine.min(back.mean_facing_cosine) >= MIN_FACING_COSINE
                && looks >= MIN_FACING_COSINE_SUM;
            // Overlapping rims, like hem and waist, look away from each other.
            let round = near >= MIN_NEAREST_VERTEX_SHARE
                && there.winds_around_or_is_parallel
                && back.winds_around_or_is_parallel
                && !(there.lies_beside && back.lies_beside);
            if gap <= limit && (face || round) {
                let [first, second] = [&self.candidates[r], &self.candidates[k]];
                let nearness = 1.0 - (1.0 - MIN_PAIR_GAIN_FACTOR) * if limit > 0.0 { gap / limit } else { 0.0 };
                let alike = first.length.min(second.length) / first.length.max(second.length);
                let piece = if first.piece == second.piece { SAME_PIECE_GAIN_FACTOR } else { 1.0 };
                let gain = nearness * (0.5 * looks).max(MIN_PAIR_GAIN_FACTOR) * (0.5 + 0.5 * alike) * piece;
                alloc::push(&mut matches, PossiblePair { ends: [r as u32, k as u32], gain })?;
                alloc::push(&mut gaps, gap)?;
            }
        }
        let chosen = choose_best_pairs(&matches, &job.sub_job(1.0, 1.0))?;
        alloc::collect(chosen.into_iter().map(|number| FacingLoops {
            rims: matches[number].ends.map(|r| r as usize),
            arcs: None,
            mean_gap: gaps[number],
        }))
    }

    /// Returns true if the loops lie beside each other, like the outlines of two sheets on a table. If
    /// one outline is much longer, directions from it to the other do not agree, but both loops hardly
    /// look at each other.
    pub(super) fn lie_beside_each_other(&self, first: usize, second: usize, job: &Job<'_>) -> Result<bool> {
        let [there, back] = self.measure_facing_of_pair([first, second], job)?;
        let hardly_look = there.mean_facing_cosine + back.mean_facing_cosine < MIN_FACING_COSINE_SUM_OF_ONLY_LOOPS;
        Ok(there.lies_beside && back.lies_beside
            || (there.lies_beside || back.lies_beside) && hardly_look && !there.winds_around && !back.winds_around)
    }

    /// Measures how each of two loops sees the other.
    pub(super) fn measure_facing_of_pair(&self, pair: [usize; 2], job: &Job<'_>) -> Result<[FacingMeasures; 2]> {
        let measure = |[r, k]: [usize; 2]| -> Result<FacingMeasures> {
            let (from, to) = (&self.rims[r], &self.rims[k]);
            let tree = KdTree::new(&to.points, job, STAGE)?;
            let lengths = polyline::lengths(&to.points, true)?;
            measure_loop_facing(from, &rim_conormals(from)?, to, &lengths, &tree)
        };
        let [first, second] = pair;
        Ok([measure([first, second])?, measure([second, first])?])
    }

    /// Returns the nearest loop ahead for some vertices of each loop.
    fn find_loops_ahead(&self, conormals: &[Vec<DVec3>], job: &Job<'_>) -> Result<Vec<Vec<LoopAhead>>> {
        let loops = self.collect_loop_vertices()?;
        let tree = KdTree::with_groups(&loops.points, &loops.groups, &job.sub_job(0.0, 0.0), STAGE)?;
        let mut before = alloc::with_capacity(self.rims.len())?;
        for (r, rim) in self.rims.iter().enumerate() {
            job.step(r as f64 / self.rims.len() as f64, STAGE)?;
            let own = loops.groups[loops.firsts[r] as usize];
            let widest = self.max_gap.unwrap_or_else(|| self.widest_gap_of_loop(r));
            let mut of_loop = Vec::new();
            let asked = if self.is_joined_loop[r] { 0 } else { rim.points.len() };
            for i in (0..asked).step_by(rim.points.len().div_ceil(MAX_AHEAD_SAMPLES)) {
                let (p, ahead) = (rim.points[i], conormals[r][i]);
                let accept = |v: u32| {
                    let k = loops.loop_of_vertex[v as usize] as usize;
                    let way = loops.points[v as usize] - p;
                    k != r && self.may_join_loops(r, k) && way.dot(ahead) >= MIN_COSINE_AHEAD * way.length()
                };
                // A mean gap within the limit may be wider in places.
                if let Some((squared, v)) = tree.nearest_in_other_groups(p, 4.0 * widest * widest, own, accept) {
                    let rim = loops.loop_of_vertex[v as usize];
                    alloc::push(&mut of_loop, LoopAhead { index_on_rim: i as u32, rim, distance: squared.sqrt() })?;
                }
            }
            before.push(of_loop);
        }
        Ok(before)
    }

    /// Returns a bound on the default limits of a loop with any other.
    pub(super) fn widest_gap_of_loop(&self, r: usize) -> f64 {
        self.candidates[r].mean_radius.max(DEFAULT_GAP_TO_SIZE_RATIO * self.largest_component_size())
    }

    /// Returns the size of the largest component.
    fn largest_component_size(&self) -> f64 {
        self.candidates.iter().map(|candidate: &LoopMeasures| candidate.component_size).fold(0.0, f64::max)
    }
}

/// Adds the shares of loop `r`. `others` lists a loop once for each of the `asked` vertices that
/// see it.
pub(super) fn add_nearest_loop_shares(
    r: u32,
    mut others: Vec<u32>,
    asked: usize,
    seen: &mut Vec<NearestLoopShare>,
) -> Result<()> {
    others.sort_unstable();
    let groups = others.chunk_by(|x, y| x == y);
    let shares = groups
        .map(|group| NearestLoopShare { rims: [r, group[0]], vertex_fraction: group.len() as f64 / asked as f64 });
    shares.into_iter().try_for_each(|share| alloc::push(seen, share))
}

/// Returns the fraction of a loop's vertices with any loop ahead that have another loop, whose
/// vertices are in `tree`, at most a little farther away.
fn share_of_vertices_with_loop_ahead(of_loop: &[LoopAhead], rim: &Rim, tree: &KdTree<'_>) -> f64 {
    let is_near = |ahead: &&LoopAhead| {
        let limit = MAX_FARTHER_DISTANCE_RATIO * ahead.distance;
        tree.nearest(rim.points[ahead.index_on_rim as usize], limit * limit, |_| true).is_some()
    };
    of_loop.iter().filter(is_near).count() as f64 / of_loop.len().max(1) as f64
}

/// Returns the fraction of the first loop's vertices that see the second loop.
fn nearest_share_of_pair(seen: &[NearestLoopShare], rims: [u32; 2]) -> f64 {
    seen.binary_search_by_key(&rims, |seen| seen.rims).map_or(0.0, |at| seen[at].vertex_fraction)
}

/// Returns the conormal of edge `i` of a loop. The surface is on the left.
pub(super) fn edge_conormal(rim: &Rim, i: usize) -> DVec3 {
    let along = rim.points[(i + 1) % rim.points.len()] - rim.points[i];
    along.normalize_or_zero().cross(rim.normals[i])
}

/// Returns the conormals at a loop's vertices: perpendicular to the border, in the surface,
/// pointing off it.
pub(super) fn rim_conormals(rim: &Rim) -> Result<Vec<DVec3>> {
    let n = rim.points.len();
    let of_edge = |i: usize| edge_conormal(rim, i);
    alloc::collect((0..n).map(|i| (of_edge((i + n - 1) % n) + of_edge(i)).normalize_or_zero()))
}

/// Measures how `from` sees `to`, weighted by length. The vertices of `to` are in `tree`, at
/// `lengths` along it. A vertex that lies on `to` looks at it.
fn measure_loop_facing(
    from: &Rim,
    conormals: &[DVec3],
    to: &Rim,
    lengths: &[f64],
    tree: &KdTree<'_>,
) -> Result<FacingMeasures> {
    let n = from.points.len();
    let edge = |i: usize| from.points[i].distance(from.points[(i + 1) % n]);
    let around = lengths.last().copied().unwrap_or_default();
    let shorter = |by: f64| if around > 0.0 { by - around * (by / around).round() } else { 0.0 };
    let (mut sum, mut gap, mut cosine, mut one_way) = (0.0, 0.0, 0.0, DVec3::ZERO);
    let (mut turned, mut first, mut last) = (0.0, None, 0.0);
    let mut distances = alloc::with_capacity(n.min(MAX_FACING_SAMPLES))?;
    for i in (0..n).step_by(n.div_ceil(MAX_FACING_SAMPLES)) {
        let p = from.points[i];
        let Some((_, v)) = tree.nearest(p, f64::INFINITY, |_| true) else {
            continue;
        };
        let way = polyline::nearest_point_on_adjacent_edges(&to.points, true, v as usize, p) - p;
        let (weight, distance) = (edge((i + n - 1) % n) + edge(i), way.length());
        sum += weight;
        distances.push(distance);
        gap += weight * distance;
        one_way += weight * way.normalize_or_zero();
        cosine += weight * if distance > 0.0 { way.dot(conormals[i]) / distance } else { 1.0 };
        let place = lengths[v as usize];
        turned += shorter(place - first.map_or(place, |_| last));
        (first, last) = (first.or(Some(place)), place);
    }
    turned += shorter(first.unwrap_or(last) - last);
    let winds = around > 0.0 && (turned.abs() / around - 1.0).abs() < 0.5;
    distances.sort_unstable_by(f64::total_cmp);
    let [low, high] = [1, 9].map(|tenth| distances.get(distances.len().saturating_sub(1) * tenth / 10));
    let spacing = sum / 2.0 / distances.len().max(1) as f64;
    let alike = low.zip(high).is_some_and(|(low, high)| *high <= MAX_SIMILAR_DISTANCE_RATIO * low.max(spacing));
    let one_way = if sum > 0.0 { one_way.length() / sum } else { 0.0 };
    let beside = !winds && one_way > MIN_MEAN_DIRECTION_LENGTH && cosine < MAX_BESIDE_COSINE_RATIO * one_way * sum;
    let round = alike || winds;
    Ok(if sum > 0.0 {
        FacingMeasures {
            mean_gap: gap / sum,
            mean_facing_cosine: cosine / sum,
            winds_around: winds,
            winds_around_or_is_parallel: round,
            lies_beside: beside,
        }
    } else {
        FacingMeasures {
            mean_gap: 0.0,
            mean_facing_cosine: 1.0,
            winds_around: winds,
            winds_around_or_is_parallel: round,
            lies_beside: beside,
        }
    })
}
