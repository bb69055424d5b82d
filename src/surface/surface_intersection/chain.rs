//! From arcs to paths: what was found twice is left out, and ends that are one point are joined.
//!
//! Cost: O(n log n) for n arcs; ends and unresolved balls against each other up to [`MAX_TESTS`].

use super::solve::{Arc, UnresolvedBall};
use crate::geom::disjoint_sets::DisjointSets;
use crate::surface::prelude::*;

/// Neighbours of a point that are compared: more of them can only be the same point again and
/// again.
const MAX_NEIGHBOURS: usize = 32;

/// Tests of an end and a ball; with more of them, balls stay as they are.
const MAX_TESTS: usize = 1 << 24;

/// Arcs in their order along a curve.
#[derive(Debug)]
pub(super) struct Chain {
    pub(super) arcs: Vec<u32>,
    pub(super) closed: bool,
}

const NONE: u32 = u32::MAX;

/// The arcs before and after each arc.
struct Links {
    before: Vec<u32>,
    after: Vec<u32>,
}

/// Points in the order of their places along some direction, so that near ones are near in it.
struct Sorted<'a> {
    points: &'a [DVec3],
    order: Vec<(f64, u32)>,
}

impl<'a> Sorted<'a> {
    fn new(points: &'a [DVec3]) -> Result<Self> {
        // Not along the axes, to which surfaces are often parallel.
        let direction = DVec3::new(0.540_302, 0.612_372, 0.577_35);
        let mut order = alloc::collect(points.iter().enumerate().map(|(k, p)| (p.dot(direction), k as u32)))?;
        order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        Ok(Sorted { points, order })
    }

    /// Pairs of points that are no farther apart than `within`, and how far.
    fn pairs(&self, within: f64) -> impl Iterator<Item = (f64, u32, u32)> {
        self.order.iter().enumerate().flat_map(move |(at, &(key, k))| {
            let next = self.order[at + 1..].iter().take(MAX_NEIGHBOURS).take_while(move |next| next.0 - key <= within);
            next.filter_map(move |&(_, n)| {
                let distance = self.points[k as usize].distance(self.points[n as usize]);
                (distance <= within).then_some((distance, k, n))
            })
        })
    }
}

/// Chains of arcs, each of which goes on where the one before ends, to `tolerance`; and for each
/// unresolved ball whether a joint explains it.
pub(super) fn chains(arcs: &[Arc], unresolved: &[UnresolvedBall], tolerance: f64) -> Result<(Vec<Chain>, Vec<bool>)> {
    // Starts and ends, in turn.
    let points = alloc::collect((0..2 * arcs.len()).map(|k| arcs[k / 2].ends[k % 2]))?;
    let mut near = Vec::new();
    for pair in Sorted::new(&points)?.pairs(2.0 * tolerance) {
        alloc::push(&mut near, pair)?;
    }
    let dropped = repeated(arcs, &near, tolerance)?;
    let mut links = Links { before: alloc::filled(NONE, arcs.len())?, after: alloc::filled(NONE, arcs.len())? };
    let mut joints = Vec::new();
    for (distance, k, n) in near {
        let (end, start) = if k % 2 == 1 { (k, n) } else { (n, k) };
        let usable = end % 2 == 1 && start % 2 == 0 && end / 2 != start / 2;
        if usable && !dropped[end as usize / 2] && !dropped[start as usize / 2] {
            alloc::push(&mut joints, (distance, end / 2, start / 2))?;
        }
    }
    // The nearest first.
    joints.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    joints.iter().for_each(|&(_, end, start)| links.join(end, start));
    let balls = merged_balls(unresolved)?;
    bridge(arcs, &balls, &dropped, tolerance, &mut links);
    let mut chains = links.chains(&dropped)?;
    if chains.len().saturating_mul(balls.len()) <= MAX_TESTS {
        chains.retain(|chain| !is_within_ball(chain, arcs, &balls));
    }
    let explained = alloc::collect(unresolved.iter().map(|ball| is_passed(ball, arcs, &links, tolerance)))?;
    Ok((chains, explained))
}

/// Arcs that are others once more, found from both sides of a side between sheets: by pairs of
/// starts and ends that are near each other. The sheets may be turned against each other, so that
/// such arcs may run in opposite ways.
fn repeated(arcs: &[Arc], near: &[(f64, u32, u32)], tolerance: f64) -> Result<Vec<bool>> {
    let mut dropped = alloc::filled(false, arcs.len())?;
    for &(_, p, q) in near {
        let (one, other) = (&arcs[p as usize / 2], &arcs[q as usize / 2]);
        let (e, f) = (p as usize % 2, q as usize % 2);
        let way = if e == f { 1.0 } else { -1.0 };
        let parallel = [0, 1].map(|k| one.directions[k].distance(way * other.directions[(k + e + f) % 2]) <= 1e-5);
        if one.pair != other.pair
            && one.ends[1 - e].distance(other.ends[1 - f]) <= 2.0 * tolerance
            && parallel == [true, true]
        {
            dropped[p.max(q) as usize / 2] = true;
        }
    }
    Ok(dropped)
}

/// Unresolved balls, those of different cells that touch as one.
fn merged_balls(unresolved: &[UnresolvedBall]) -> Result<Vec<(DVec3, f64)>> {
    let centres = alloc::collect(unresolved.iter().map(|ball| ball.centre))?;
    let widest = unresolved.iter().map(|ball| ball.radius).fold(0.0, f64::max);
    let mut sets = DisjointSets::new(unresolved.len())?;
    for (distance, k, n) in Sorted::new(&centres)?.pairs(2.0 * widest) {
        if distance <= unresolved[k as usize].radius + unresolved[n as usize].radius {
            sets.union(k, n);
        }
    }
    let mut balls = alloc::collect(unresolved.iter().map(|ball| (ball.centre, ball.radius)))?;
    for (k, ball) in unresolved.iter().enumerate() {
        let root = sets.find(k as u32) as usize;
        let (centre, radius) = balls[root];
        balls[root].1 = radius.max(centre.distance(ball.centre) + ball.radius);
    }
    let mut k = 0;
    balls.retain(|_| {
        k += 1;
        sets.parent(k - 1) == k - 1
    });
    Ok(balls)
}

/// Joins loose ends across unresolved balls: as straight as can be. Where two branches cross, N_A x
/// N_B points to the crossing on the one and away from it on the other, so that a path turns from
/// the one into the other.
fn bridge(arcs: &[Arc], balls: &[(DVec3, f64)], dropped: &[bool], tolerance: f64, links: &mut Links) {
    let loose = |link: &[u32]| -> Vec<u32> {
        (0..arcs.len() as u32).filter(|&k| link[k as usize] == NONE && !dropped[k as usize]).collect()
    };
    let (ends, starts) = (loose(&links.after), loose(&links.before));
    if ends.is_empty() || (ends.len() + starts.len()).saturating_mul(balls.len()) > MAX_TESTS {
        return;
    }
    for &(centre, radius) in balls {
        let near = |point: DVec3| point.distance(centre) <= 2.0 * radius + 4.0 * tolerance;
        let mut pairs: Vec<(f64, u32, u32)> = Vec::new();
        for &end in ends.iter().filter(|&&end| near(arcs[end as usize].ends[1])) {
            for &start in starts.iter().filter(|&&start| near(arcs[start as usize].ends[0])) {
                let turn = arcs[end as usize].directions[1].dot(arcs[start as usize].directions[0]);
                if end != start && pairs.len() < 1 << 12 {
                    pairs.push((-turn, end, start));
                }
            }
        }
        pairs.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
        pairs.into_iter().for_each(|(_, end, start)| links.join(end, start));
    }
}

/// True for a ball hardly larger than the tolerance that a chain passes, as at poles: there is
/// nothing more to it.
fn is_passed(ball: &UnresolvedBall, arcs: &[Arc], links: &Links, tolerance: f64) -> bool {
    let near = |arc: &Arc| arc.ends[1].distance(ball.centre) <= 8.0 * tolerance;
    ball.radius <= 4.0 * tolerance && arcs.iter().zip(&links.after).any(|(arc, &after)| after != NONE && near(arc))
}

/// True for a scrap within a ball that is reported as a whole.
fn is_within_ball(chain: &Chain, arcs: &[Arc], balls: &[(DVec3, f64)]) -> bool {
    let ends = || chain.arcs.iter().flat_map(|&k| arcs[k as usize].ends);
    let within = |&(centre, radius): &(DVec3, f64)| ends().all(|end| end.distance(centre) <= radius);
    !chain.closed && chain.arcs.len() < 8 && balls.iter().any(within)
}

impl Links {
    /// Joins two arcs, if neither has a neighbour there.
    fn join(&mut self, end: u32, start: u32) {
        let (after, before) = (&mut self.after[end as usize], &mut self.before[start as usize]);
        if *after == NONE && *before == NONE {
            (*after, *before) = (start, end);
        }
    }

    /// The chains, by their first arcs.
    fn chains(&self, dropped: &[bool]) -> Result<Vec<Chain>> {
        let mut done = alloc::copied(dropped)?;
        let mut chains = Vec::new();
        for k in 0..dropped.len() as u32 {
            if done[k as usize] {
                continue;
            }
            // Back to where it begins, or round to where we are.
            let mut first = k;
            while self.before[first as usize] != NONE && self.before[first as usize] != k {
                first = self.before[first as usize];
            }
            let closed = self.before[first as usize] == k;
            let mut chain = Chain { arcs: Vec::new(), closed };
            let mut at = if closed { k } else { first };
            while at != NONE && !done[at as usize] {
                done[at as usize] = true;
                alloc::push(&mut chain.arcs, at)?;
                at = self.after[at as usize];
            }
            alloc::push(&mut chains, chain)?;
        }
        Ok(chains)
    }
}
