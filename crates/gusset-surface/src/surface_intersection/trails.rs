//! Joins arcs of self-intersections to paths.
//!
//! The two pieces of surface at an arc are not ordered, so the direction of N_A x N_B is arbitrary.
//! An arc therefore has two equal ends instead of a start and an end. Ends are joined by their
//! positions, directions, and pairs of tangent planes.
//!
//! Invariant: an end is joined to at most one other end. Cost: O(n log n) for n arcs.

use super::arc_links::NO_LINKED_ARC;
use super::intersection_chain::{MAX_JOINT_GAP_IN_RESOLUTIONS, find_near_pairs, find_repeated_arcs};
use super::pair_search::IntersectionArc;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort;

/// Arcs whose ends differ by at least this cost belong to different paths.
const MAX_JOINED_PLANE_COST: f64 = 0.75;
/// Ends whose tangent planes differ by at most this cost may belong to copies of one arc.
const MAX_DUPLICATE_PLANE_COST: f64 = 1e-6;

/// An arc of a path.
#[derive(Debug, Clone, Copy)]
pub(super) struct TrailStep {
    pub(super) arc: u32,
    /// Whether the arc is traversed from its last point to its first.
    pub(super) is_reversed: bool,
    /// Whether the second place of the arc is on the piece that the path calls the first.
    pub(super) are_surfaces_swapped: bool,
}

/// A sequence of arcs, each of which continues where the previous one ends.
#[derive(Debug)]
pub(super) struct ArcTrail {
    pub(super) steps: Vec<TrailStep>,
    pub(super) closed: bool,
}

/// The difference of the tangent planes of two ends, and whether the first plane of one corresponds
/// to the second of the other.
fn tangent_plane_difference(a: &[DVec3; 2], b: &[DVec3; 2]) -> (f64, bool) {
    let cost = |p: usize, q: usize| 2.0 - a[0].dot(b[p]).abs() - a[1].dot(b[q]).abs();
    let (same, swapped) = (cost(0, 1), cost(1, 0));
    if same <= swapped { (same, false) } else { (swapped, true) }
}

/// Arcs, and the normals of both pieces at their ends. Arc k has the ends 2 k and 2 k + 1.
pub(super) struct TrailBuilder<'a> {
    pub(super) arcs: &'a [IntersectionArc],
    pub(super) normals: &'a [[DVec3; 2]],
    /// Accuracy of ends.
    pub(super) resolution: f64,
}

impl TrailBuilder<'_> {
    /// Returns the paths, ordered by their first arcs.
    pub(super) fn build_trails(&self, job: &Job<'_>) -> Result<Vec<ArcTrail>> {
        let (mates, dropped) = self.pair_arc_ends_and_find_duplicates(job)?;
        let mut used = dropped;
        let mut trails = Vec::new();
        // Open paths first, starting at an end.
        for ends in [true, false] {
            for k in 0..self.arcs.len() as u32 {
                let first = [0, 1].into_iter().find(|end| mates[(2 * k + end) as usize] == NO_LINKED_ARC);
                if used[k as usize] || ends && first.is_none() {
                    continue;
                }
                alloc::push(&mut trails, self.trail_from(2 * k + first.unwrap_or(0), &mates, &mut used)?)?;
            }
        }
        sort::sort_stable(&mut trails, &|a, b| a.steps[0].arc.cmp(&b.steps[0].arc));
        Ok(trails)
    }

    /// The path that starts at an end.
    fn trail_from(&self, first: u32, mates: &[u32], done: &mut [bool]) -> Result<ArcTrail> {
        let mut trail = ArcTrail { steps: Vec::new(), closed: false };
        let (mut at, mut swapped) = (first, first % 2 == 1);
        loop {
            let arc = at / 2;
            done[arc as usize] = true;
            alloc::push(&mut trail.steps, TrailStep { arc, is_reversed: at % 2 == 1, are_surfaces_swapped: swapped })?;
            let (last, next) = (at ^ 1, mates[(at ^ 1) as usize]);
            if next == NO_LINKED_ARC || done[next as usize / 2] {
                trail.closed = next == first;
                return Ok(trail);
            }
            swapped ^= tangent_plane_difference(&self.normals[last as usize], &self.normals[next as usize]).1;
            at = next;
        }
    }

    /// For each end, the end that it is joined to, and for each arc, whether it is a duplicate.
    fn pair_arc_ends_and_find_duplicates(&self, job: &Job<'_>) -> Result<(Vec<u32>, Vec<bool>)> {
        let arcs = self.arcs;
        let ends = alloc::collect((0..2 * arcs.len()).map(|k| arcs[k / 2].ends[k % 2]))?;
        let near = find_near_pairs(&ends, MAX_JOINT_GAP_IN_RESOLUTIONS * self.resolution, job)?;
        let alike = |p: u32, q: u32| tangent_plane_difference(&self.normals[p as usize], &self.normals[q as usize]).0;
        let same = alloc::gather(near.iter().copied().filter(|&(_, p, q)| alike(p, q) <= MAX_DUPLICATE_PLANE_COST))?;
        let dropped = find_repeated_arcs(arcs, &same, true, self.resolution)?;
        let mut joints = Vec::new();
        // The directions in which arcs continue beyond their ends.
        let outwards = |end: u32| {
            let direction = arcs[end as usize / 2].directions[end as usize % 2];
            if end % 2 == 1 { direction } else { -direction }
        };
        for &(_, p, q) in &near {
            let (one, other) = (p as usize / 2, q as usize / 2);
            let usable = one != other || arcs[one].is_closed;
            let cost = alike(p, q) + 1.0 + outwards(p).dot(outwards(q));
            if usable && !dropped[one] && !dropped[other] && cost <= MAX_JOINED_PLANE_COST {
                alloc::push(&mut joints, (cost, p, q))?;
            }
        }
        sort::sort_stable(&mut joints, &|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
        let mut mates = alloc::filled(NO_LINKED_ARC, 2 * arcs.len())?;
        for (_, p, q) in joints {
            if mates[p as usize] == NO_LINKED_ARC && mates[q as usize] == NO_LINKED_ARC {
                (mates[p as usize], mates[q as usize]) = (q, p);
            }
        }
        Ok((mates, dropped))
    }
}
