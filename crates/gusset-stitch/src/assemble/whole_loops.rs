//! Which loops are joined as wholes: the best one-to-one choice among those that look at each other.
//!
//! A vertex of a loop looks along its **conormal**, off the surface. Loop R looks at loop K by the
//! mean cosine, over R's length, of the angle between the conormal and the way to the nearest point
//! of K: near 1 across a cut, near 0 for loops side by side, negative for one that lies behind.
//! Two loops that are not too far apart may be joined
//!
//! * if they look at each other, and nearly all vertices of each that have any loop before them have
//!   the other not much farther away than the nearest of those, or
//! * if nearly all vertices of each have their nearest vertex on the other, and these nearest points
//!   wind once round the other loop, or the distances are alike: but not of two loops that lie beside
//!   each other, from which the ways run all in one direction, while conormals look all round.
//!
//! Of these, pairs are chosen so that the sum of what each saves is greatest (see
//! [`assignment`](super::assignment)): the nearer, the better they look at each other and the more
//! alike they are in length, the more.
//!
//! Bounds and weights are ours, from pairs that were known: of 91 across slabs cut out of
//! closed meshes (one seed of `make bench ONLY=truth`) the worse look is above 0.16, the sum of both
//! above 0.9, and the gap at most 0.19 of the mesh's size; of 124 wrong pairs few look like that.

use super::assignment::{Match, best_matches};
use super::candidates::{Candidate, Facing, FacingSearch, STAGE};
use crate::stitch::polyline;
use crate::stitch::stitch_rim::Rim;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;

/// The least that either loop may look at the other.
const MIN_LOOK: f64 = 0.1;

/// The least that both may together.
const MIN_SUM_OF_LOOKS: f64 = 0.8;

/// A loop lies before a vertex within 45 degrees of its conormal.
const MIN_COSINE_AHEAD: f64 = 0.7;

/// Share of the vertices that have any loop before them, for whom the other one is hardly farther.
const MIN_SHARE_BEFORE: f64 = 0.8;

/// Hardly farther: at most so many times as far.
const HARDLY_FARTHER: f64 = 3.0;

/// Share of all vertices whose nearest vertex is on the other, for loops round each other.
const MIN_SHARE_NEAR: f64 = 0.9;

/// Distances are alike if the greatest is at most so many times the least, or the spacing.
const MAX_DISTANCE_RATIO: f64 = 4.0;

/// Ways run in one direction if the mean of their unit vectors is longer than this.
const MIN_ONE_WAY: f64 = 0.5;

/// And a loop lies beside another if it looks there, or away from there, by less than so much of that
/// mean.
const MAX_LOOK_ASIDE: f64 = 0.5;

/// The widest gap that is closed by itself, as a part of the size of the larger component.
const MAX_PART_OF_SIZE: f64 = 0.2;

/// So many vertices of a loop are asked how it looks at another, evenly chosen from all.
const SAMPLE_VERTICES: usize = 1 << 10;

/// And so many, which loops there are before it.
const CANDIDATE_SAMPLES: usize = 1 << 7;

/// What a pair saves at least for its gap and for its look, next to the best there can be.
const LEAST_GAIN: f64 = 0.2;

/// What a pair of loops of one piece saves, next to one of two pieces.
const SAME_PIECE: f64 = 0.5;

/// How one loop sees another.
#[derive(Clone, Copy)]
struct Look {
    /// The mean distance from its vertices to the nearest point of the other.
    gap: f64,
    /// The mean cosine between its conormals and the way there.
    cosine: f64,
    /// Its distances are alike, or its nearest points wind once round the other.
    round: bool,
    /// It lies beside the other.
    beside: bool,
}

/// The nearest loop before a vertex of a loop.
struct Ahead {
    place: u32,
    rim: u32,
    distance: f64,
}

/// How many vertices of one loop have another nearest to them.
#[derive(Clone, Copy)]
pub(super) struct Seen {
    /// Who sees whom.
    pub(super) rims: [u32; 2],
    pub(super) share: f64,
}

impl FacingSearch<'_> {
    /// The greatest distance between loops `r` and `k`, if they are joined as wholes.
    pub(super) fn limit(&self, r: usize, k: usize) -> f64 {
        let [r, k] = [&self.candidates[r], &self.candidates[k]];
        self.max_gap.unwrap_or_else(|| r.radius.min(k.radius).max(MAX_PART_OF_SIZE * r.size.max(k.size)))
    }

    /// The pairs that are joined as wholes; `near`: of which loop each has its nearest vertices, in
    /// ascending order.
    ///
    /// O(V log V) for V vertices on loops, and for each two loops before one another the time of
    /// their nearest points.
    pub(super) fn whole_loops(&self, near: &[Seen], job: &Job<'_>) -> Result<Vec<Facing>> {
        let (building, job) = (job.part(0.0, 0.1), job.part(0.1, 1.0));
        let mut trees = alloc::with_capacity(self.rims.len())?;
        for (r, rim) in self.rims.iter().enumerate() {
            trees.push(KdTree::new(&rim.points, &building.share(r, self.rims.len()), STAGE)?);
        }
        let lengths = alloc::try_collect(self.rims.iter().map(|rim| polyline::lengths(&rim.points, true)))?;
        let conormals = alloc::try_collect(self.rims.iter().map(conormals))?;
        let before = self.loops_before(&conormals, &job.part(0.0, 0.5))?;
        let mut pairs = alloc::gather(near.iter().map(|seen| seen.rims))?;
        for (of_loop, r) in before.iter().zip(0u32..) {
            alloc::extend(&mut pairs, of_loop.iter().map(|ahead| [r, ahead.rim]))?;
        }
        pairs.iter_mut().for_each(|rims| rims.sort_unstable());
        sort_distinct(&mut pairs);
        let (mut matches, mut gaps) = (Vec::new(), Vec::new());
        for (number, &[r, k]) in pairs.iter().enumerate() {
            job.step(0.5 + 0.5 * number as f64 / pairs.len() as f64, STAGE)?;
            let near = share(near, [r, k]).min(share(near, [k, r]));
            let [r, k] = [r as usize, k as usize];
            let hardly_farther = |r: usize, k: usize| share_before(&before[r], &self.rims[r], &trees[k]);
            let before = hardly_farther(r, k).min(hardly_farther(k, r));
            if before < MIN_SHARE_BEFORE && near < MIN_SHARE_NEAR {
                continue;
            }
            let there = look(&self.rims[r], &conormals[r], &self.rims[k], &lengths[k], &trees[k])?;
            let back = look(&self.rims[k], &conormals[k], &self.rims[r], &lengths[r], &trees[r])?;
            let (gap, limit) = (there.gap.max(back.gap), self.limit(r, k));
            let looks = there.cosine + back.cosine;
            let face =
                before >= MIN_SHARE_BEFORE && there.cosine.min(back.cosine) >= MIN_LOOK && looks >= MIN_SUM_OF_LOOKS;
            // Rims that overlap, as hem and waist do, look away from each other.
            let round = near >= MIN_SHARE_NEAR && there.round && back.round && !(there.beside && back.beside);
            if gap <= limit && (face || round) {
                let [first, second] = [&self.candidates[r], &self.candidates[k]];
                let nearness = 1.0 - (1.0 - LEAST_GAIN) * if limit > 0.0 { gap / limit } else { 0.0 };
                let alike = first.length.min(second.length) / first.length.max(second.length);
                let piece = if first.piece == second.piece { SAME_PIECE } else { 1.0 };
                let gain = nearness * (0.5 * looks).max(LEAST_GAIN) * (0.5 + 0.5 * alike) * piece;
                alloc::push(&mut matches, Match { ends: [r as u32, k as u32], gain })?;
                alloc::push(&mut gaps, gap)?;
            }
        }
        let chosen = best_matches(&matches, &job.part(1.0, 1.0))?;
        alloc::collect(chosen.into_iter().map(|number| Facing {
            rims: matches[number].ends.map(|r| r as usize),
            arcs: None,
            gap: gaps[number],
        }))
    }

    /// Of some vertices of each loop, the nearest loop before them, where there is any.
    fn loops_before(&self, conormals: &[Vec<DVec3>], job: &Job<'_>) -> Result<Vec<Vec<Ahead>>> {
        let loops = self.all_vertices()?;
        let tree = KdTree::with_groups(&loops.points, &loops.groups, &job.part(0.0, 0.0), STAGE)?;
        let mut before = alloc::with_capacity(self.rims.len())?;
        for (r, rim) in self.rims.iter().enumerate() {
            job.step(r as f64 / self.rims.len() as f64, STAGE)?;
            let own = loops.groups[loops.firsts[r] as usize];
            let widest = self.max_gap.unwrap_or(self.candidates[r].radius.max(MAX_PART_OF_SIZE * self.largest()));
            let mut of_loop = Vec::new();
            let asked = if self.used[r] { 0 } else { rim.points.len() };
            for i in (0..asked).step_by(rim.points.len().div_ceil(CANDIDATE_SAMPLES)) {
                let (p, ahead) = (rim.points[i], conormals[r][i]);
                let accept = |v: u32| {
                    let k = loops.owners[v as usize] as usize;
                    let way = loops.points[v as usize] - p;
                    k != r && self.may_join(r, k) && way.dot(ahead) >= MIN_COSINE_AHEAD * way.length()
                };
                // A gap in the mean may be wider in places.
                if let Some((squared, v)) = tree.nearest_in_other_groups(p, 4.0 * widest * widest, own, accept) {
                    let rim = loops.owners[v as usize];
                    alloc::push(&mut of_loop, Ahead { place: i as u32, rim, distance: squared.sqrt() })?;
                }
            }
            before.push(of_loop);
        }
        Ok(before)
    }

    /// The size of the largest component.
    fn largest(&self) -> f64 {
        self.candidates.iter().map(|candidate: &Candidate| candidate.size).fold(0.0, f64::max)
    }
}

/// Adds what loop `r` sees: `others`, each as often as it is seen by one of `asked` vertices.
pub(super) fn add_shares(r: u32, mut others: Vec<u32>, asked: usize, seen: &mut Vec<Seen>) -> Result<()> {
    others.sort_unstable();
    let groups = others.chunk_by(|x, y| x == y);
    let shares = groups.map(|group| Seen { rims: [r, group[0]], share: group.len() as f64 / asked as f64 });
    shares.into_iter().try_for_each(|share| alloc::push(seen, share))
}

/// The share of a loop's vertices with any loop before them that have another one, whose vertices
/// are in `tree`, hardly farther away.
fn share_before(of_loop: &[Ahead], rim: &Rim, tree: &KdTree<'_>) -> f64 {
    let is_near = |ahead: &&Ahead| {
        let limit = HARDLY_FARTHER * ahead.distance;
        tree.nearest(rim.points[ahead.place as usize], limit * limit, |_| true).is_some()
    };
    of_loop.iter().filter(is_near).count() as f64 / of_loop.len().max(1) as f64
}

/// The share of vertices of the first loop that see the second.
fn share(seen: &[Seen], rims: [u32; 2]) -> f64 {
    seen.binary_search_by_key(&rims, |seen| seen.rims).map_or(0.0, |at| seen[at].share)
}

/// The conormals at a loop's vertices: square to the surface's border, in the surface, off it.
pub(super) fn conormals(rim: &Rim) -> Result<Vec<DVec3>> {
    let n = rim.points.len();
    let of_edge = |i: usize| {
        let along = (rim.points[(i + 1) % n] - rim.points[i]).normalize_or_zero();
        // The surface is on the left, normal x along.
        along.cross(rim.normals[i])
    };
    alloc::collect((0..n).map(|i| (of_edge((i + n - 1) % n) + of_edge(i)).normalize_or_zero()))
}

/// How `from` sees `to`, whose vertices are in `tree` and lie at `lengths` along it; by length. What
/// lies upon the other is taken to look at it.
fn look(from: &Rim, conormals: &[DVec3], to: &Rim, lengths: &[f64], tree: &KdTree<'_>) -> Result<Look> {
    let n = from.points.len();
    let edge = |i: usize| from.points[i].distance(from.points[(i + 1) % n]);
    let around = lengths.last().copied().unwrap_or_default();
    let shorter = |by: f64| if around > 0.0 { by - around * (by / around).round() } else { 0.0 };
    let (mut sum, mut gap, mut cosine, mut one_way) = (0.0, 0.0, 0.0, DVec3::ZERO);
    let (mut turned, mut first, mut last) = (0.0, None, 0.0);
    let mut distances = alloc::with_capacity(n.min(SAMPLE_VERTICES))?;
    for i in (0..n).step_by(n.div_ceil(SAMPLE_VERTICES)) {
        let p = from.points[i];
        let Some((_, v)) = tree.nearest(p, f64::INFINITY, |_| true) else {
            continue;
        };
        let way = polyline::nearest_beside(&to.points, true, v as usize, p) - p;
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
    let alike = low.zip(high).is_some_and(|(low, high)| *high <= MAX_DISTANCE_RATIO * low.max(spacing));
    let one_way = if sum > 0.0 { one_way.length() / sum } else { 0.0 };
    let beside = !winds && one_way > MIN_ONE_WAY && cosine.abs() < MAX_LOOK_ASIDE * one_way * sum;
    let round = alike || winds;
    Ok(if sum > 0.0 {
        Look { gap: gap / sum, cosine: cosine / sum, round, beside }
    } else {
        Look { gap: 0.0, cosine: 1.0, round, beside }
    })
}
