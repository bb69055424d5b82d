//! Which loops are joined as wholes: the best one-to-one choice among those that look at each other.
//!
//! A vertex of a loop looks along its **conormal**, off the surface. Loop R looks at loop K by the
//! mean cosine, over R's length, of the angle between the conormal and the way to the nearest point
//! of K: near 1 across a cut, near 0 for loops side by side, negative for one that lies behind.
//! Loops may be joined that look at each other and are not too far apart; of these, pairs are chosen
//! so that the sum of what each saves is greatest (see [`assignment`](super::assignment)): the
//! nearer, the better they look at each other and the more alike they are in length, the more.
//!
//! Bounds and weights are ours, from pairs that were known: of slabs cut out of closed meshes
//! (`make bench ONLY=truth`) the worse look is above 0.16 and the sum of both above 0.9, and the gap
//! at most 0.19 of the mesh's size; of wrong pairs less than one in ten looks like that.

use super::facing_loops::{Candidate, Facing, FacingSearch};
use crate::alloc;
use crate::error::Result;
use crate::geom::kd_tree::KdTree;
use crate::job::Job;
use crate::sort::sort_distinct;
use crate::stitch::assemble::assignment::{Match, best_matches};
use crate::stitch::polyline;
use crate::stitch::rim::Rim;
use glam::DVec3;

/// The least that either loop may look at the other.
const MIN_LOOK: f64 = 0.1;

/// The least that both may together.
const MIN_SUM_OF_LOOKS: f64 = 0.8;

/// The widest gap that is closed by itself, as a part of the size of the larger component.
const MAX_PART_OF_SIZE: f64 = 0.2;

/// So many vertices of a loop are asked how it looks at another, evenly chosen from all.
const SAMPLE_VERTICES: usize = 1 << 10;

/// And so many, which loops there are before it.
const CANDIDATE_SAMPLES: usize = 1 << 7;

/// What a pair saves at least, next to the nearest pair there can be.
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
}

impl FacingSearch<'_> {
    /// The greatest distance between loops `r` and `k`, if they are joined as wholes.
    pub(super) fn limit(&self, r: usize, k: usize) -> f64 {
        let [r, k] = [&self.candidates[r], &self.candidates[k]];
        self.max_gap.unwrap_or_else(|| r.radius.min(k.radius).max(MAX_PART_OF_SIZE * r.size.max(k.size)))
    }

    /// The pairs that are joined as wholes.
    ///
    /// O(V log V) for V vertices on loops, and for each two loops before one another the time of
    /// their nearest points.
    pub(super) fn whole_loops(&self, near: &[[u32; 2]], job: &Job<'_>) -> Result<Vec<Facing>> {
        let trees = alloc::try_collect(self.rims.iter().map(|rim| KdTree::new(&rim.points, &Job::default(), "")))?;
        let conormals = alloc::try_collect(self.rims.iter().map(conormals))?;
        let mut pairs = self.loops_before(&conormals, &job.part(0.0, 0.5))?;
        alloc::extend(&mut pairs, near.iter().copied())?;
        sort_distinct(&mut pairs);
        let (mut matches, mut gaps) = (Vec::new(), Vec::new());
        for (number, &[r, k]) in pairs.iter().enumerate() {
            job.step(0.5 + 0.5 * number as f64 / pairs.len() as f64, "looking for loops that face each other")?;
            let [r, k] = [r as usize, k as usize];
            let there = look(&self.rims[r], &conormals[r], &self.rims[k], &trees[k]);
            let back = look(&self.rims[k], &conormals[k], &self.rims[r], &trees[r]);
            let (gap, limit) = (there.gap.max(back.gap), self.limit(r, k));
            let looks = there.cosine + back.cosine;
            if gap <= limit && there.cosine.min(back.cosine) >= MIN_LOOK && looks >= MIN_SUM_OF_LOOKS {
                let [first, second] = [&self.candidates[r], &self.candidates[k]];
                let nearness = 1.0 - (1.0 - LEAST_GAIN) * if limit > 0.0 { gap / limit } else { 0.0 };
                let alike = first.length.min(second.length) / first.length.max(second.length);
                let piece = if first.piece == second.piece { SAME_PIECE } else { 1.0 };
                let gain = nearness * (0.5 * looks) * (0.5 + 0.5 * alike) * piece;
                alloc::push(&mut matches, Match { ends: [r as u32, k as u32], gain })?;
                alloc::push(&mut gaps, gap)?;
            }
        }
        let chosen = best_matches(&matches)?;
        alloc::collect(chosen.into_iter().map(|number| Facing {
            rims: matches[number].ends.map(|r| r as usize),
            arcs: None,
            gap: gaps[number],
        }))
    }

    /// Pairs (smaller, larger) of loops of which one has the other before it: nearest of all that
    /// lie ahead of a vertex.
    fn loops_before(&self, conormals: &[Vec<DVec3>], job: &Job<'_>) -> Result<Vec<[u32; 2]>> {
        let loops = self.all_vertices()?;
        let tree = KdTree::grouped(&loops.points, &loops.groups)?;
        let mut pairs = Vec::new();
        for (r, rim) in self.rims.iter().enumerate().filter(|&(r, _)| !self.used[r]) {
            job.step(r as f64 / self.rims.len() as f64, "looking for loops that face each other")?;
            let own = loops.groups[loops.firsts[r] as usize];
            let widest = self.max_gap.unwrap_or(self.candidates[r].radius.max(MAX_PART_OF_SIZE * self.largest()));
            for i in (0..rim.points.len()).step_by(rim.points.len().div_ceil(CANDIDATE_SAMPLES)) {
                let (p, ahead) = (rim.points[i], conormals[r][i]);
                let accept = |v: u32| {
                    let k = loops.owners[v as usize] as usize;
                    let way = loops.points[v as usize] - p;
                    k != r && self.may_join(r, k) && way.dot(ahead) >= 0.5 * way.length()
                };
                // A gap in the mean may be wider in places.
                if let Some((_, v)) = tree.nearest_elsewhere(p, 4.0 * widest * widest, own, accept) {
                    let k = loops.owners[v as usize];
                    alloc::push(&mut pairs, [k.min(r as u32), k.max(r as u32)])?;
                }
            }
        }
        Ok(pairs)
    }

    /// The size of the largest component.
    fn largest(&self) -> f64 {
        self.candidates.iter().map(|candidate: &Candidate| candidate.size).fold(0.0, f64::max)
    }
}

/// The conormals at a loop's vertices: square to the surface's border, in the surface, off it.
fn conormals(rim: &Rim) -> Result<Vec<DVec3>> {
    let n = rim.points.len();
    let of_edge = |i: usize| {
        let along = (rim.points[(i + 1) % n] - rim.points[i]).normalize_or_zero();
        // The surface is on the left, normal x along.
        along.cross(rim.normals[i])
    };
    alloc::collect((0..n).map(|i| (of_edge((i + n - 1) % n) + of_edge(i)).normalize_or_zero()))
}

/// How `from` sees `to`, whose vertices are in `tree`; by length. What lies upon the other is taken
/// to look at it.
fn look(from: &Rim, conormals: &[DVec3], to: &Rim, tree: &KdTree<'_>) -> Look {
    let n = from.points.len();
    let edge = |i: usize| from.points[i].distance(from.points[(i + 1) % n]);
    let (mut sum, mut gap, mut cosine) = (0.0, 0.0, 0.0);
    for i in (0..n).step_by(n.div_ceil(SAMPLE_VERTICES)) {
        let p = from.points[i];
        let Some((_, v)) = tree.nearest(p, f64::INFINITY, |_| true) else {
            continue;
        };
        let way = polyline::nearest_beside(&to.points, v as usize, p) - p;
        let (weight, distance) = (edge((i + n - 1) % n) + edge(i), way.length());
        sum += weight;
        gap += weight * distance;
        cosine += weight * if distance > 0.0 { way.dot(conormals[i]) / distance } else { 1.0 };
    }
    if sum > 0.0 { Look { gap: gap / sum, cosine: cosine / sum } } else { Look { gap: 0.0, cosine: 1.0 } }
}
