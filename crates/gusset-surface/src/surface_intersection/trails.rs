//! Arcs of self-intersections, joined to paths.
//!
//! An arc is of two pieces of one surface, of which neither is the first: N_A x N_B points one way
//! or the other, as the two are called. So arcs have ends, and neither a start nor a goal; which
//! end is joined with which follows from the place, the direction, and the two tangent planes.
//!
//! Invariant: an end is joined with one other end at most. Cost: O(n log n) for n arcs.

use super::intersection_chain::{REACH, near_pairs, repeated};
use super::links::NONE;
use super::solve::Arc;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort;

/// Arcs whose ends are as unlike as this go different ways.
const MAX_COST: f64 = 0.75;
/// Ends as alike as this may be those of one arc, found twice.
const REPEATED_COST: f64 = 1e-6;

/// An arc of a path.
#[derive(Debug, Clone, Copy)]
pub(super) struct Step {
    pub(super) arc: u32,
    /// Whether it is run through from its last point to the first.
    pub(super) reversed: bool,
    /// Whether the second of its places is on the piece that the path calls the first.
    pub(super) swapped: bool,
}

/// Arcs each of which goes on where the one before ends.
#[derive(Debug)]
pub(super) struct Trail {
    pub(super) steps: Vec<Step>,
    pub(super) closed: bool,
}

/// How unlike the tangent planes of two ends are, and whether the first of the one is the second of
/// the other.
fn unlike(a: &[DVec3; 2], b: &[DVec3; 2]) -> (f64, bool) {
    let cost = |p: usize, q: usize| 2.0 - a[0].dot(b[p]).abs() - a[1].dot(b[q]).abs();
    let (same, swapped) = (cost(0, 1), cost(1, 0));
    if same <= swapped { (same, false) } else { (swapped, true) }
}

/// Arcs with the normals of both pieces at their ends: those of arc k at 2 k and 2 k + 1.
pub(super) struct Trails<'a> {
    pub(super) arcs: &'a [Arc],
    pub(super) normals: &'a [[DVec3; 2]],
    /// How exactly ends are known.
    pub(super) resolution: f64,
}

impl Trails<'_> {
    /// The paths, by their first arcs.
    pub(super) fn run(&self, job: &Job<'_>) -> Result<Vec<Trail>> {
        let (mates, dropped) = self.mates(job)?;
        let mut done = dropped;
        let mut trails = Vec::new();
        // First those that have an end, from there.
        for ends in [true, false] {
            for k in 0..self.arcs.len() as u32 {
                let first = [0, 1].into_iter().find(|end| mates[(2 * k + end) as usize] == NONE);
                if done[k as usize] || ends && first.is_none() {
                    continue;
                }
                alloc::push(&mut trails, self.trail(2 * k + first.unwrap_or(0), &mates, &mut done)?)?;
            }
        }
        sort::stable(&mut trails, &|a, b| a.steps[0].arc.cmp(&b.steps[0].arc));
        Ok(trails)
    }

    /// The path from an end on.
    fn trail(&self, first: u32, mates: &[u32], done: &mut [bool]) -> Result<Trail> {
        let mut trail = Trail { steps: Vec::new(), closed: false };
        let (mut at, mut swapped) = (first, first % 2 == 1);
        loop {
            let arc = at / 2;
            done[arc as usize] = true;
            alloc::push(&mut trail.steps, Step { arc, reversed: at % 2 == 1, swapped })?;
            let (last, next) = (at ^ 1, mates[(at ^ 1) as usize]);
            if next == NONE || done[next as usize / 2] {
                trail.closed = next == first;
                return Ok(trail);
            }
            swapped ^= unlike(&self.normals[last as usize], &self.normals[next as usize]).1;
            at = next;
        }
    }

    /// The end that each end is joined with, and which arcs are others once more.
    fn mates(&self, job: &Job<'_>) -> Result<(Vec<u32>, Vec<bool>)> {
        let arcs = self.arcs;
        let ends = alloc::collect((0..2 * arcs.len()).map(|k| arcs[k / 2].ends[k % 2]))?;
        let near = near_pairs(&ends, REACH * self.resolution, job)?;
        let alike = |p: u32, q: u32| unlike(&self.normals[p as usize], &self.normals[q as usize]).0;
        let same = alloc::gather(near.iter().copied().filter(|&(_, p, q)| alike(p, q) <= REPEATED_COST))?;
        let dropped = repeated(arcs, &same, true, self.resolution)?;
        let mut joints = Vec::new();
        // The directions in which arcs go on beyond their ends.
        let outwards = |end: u32| {
            let direction = arcs[end as usize / 2].directions[end as usize % 2];
            if end % 2 == 1 { direction } else { -direction }
        };
        for &(_, p, q) in &near {
            let (one, other) = (p as usize / 2, q as usize / 2);
            let usable = one != other || arcs[one].is_closed;
            let cost = alike(p, q) + 1.0 + outwards(p).dot(outwards(q));
            if usable && !dropped[one] && !dropped[other] && cost <= MAX_COST {
                alloc::push(&mut joints, (cost, p, q))?;
            }
        }
        sort::stable(&mut joints, &|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
        let mut mates = alloc::filled(NONE, 2 * arcs.len())?;
        for (_, p, q) in joints {
            if mates[p as usize] == NONE && mates[q as usize] == NONE {
                (mates[p as usize], mates[q as usize]) = (q, p);
            }
        }
        Ok((mates, dropped))
    }
}
