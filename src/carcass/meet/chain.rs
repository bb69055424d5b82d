//! From arcs to paths: what was found twice is left out, and ends that are one point are joined.

use super::solve::{Arc, Spot};
use crate::alloc;
use crate::error::Result;
use glam::DVec3;

/// Neighbours of a point that are looked at: more than that can only be the same point again and again.
const NEIGHBOURS: usize = 32;

/// Arcs in their order along a curve.
#[derive(Debug)]
pub(super) struct Chain {
    pub(super) arcs: Vec<u32>,
    pub(super) closed: bool,
}

const NONE: u32 = u32::MAX;

/// What precedes and what follows each arc.
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
            let next = self.order[at + 1..].iter().take(NEIGHBOURS).take_while(move |next| next.0 - key <= within);
            next.filter_map(move |&(_, n)| {
                let distance = self.points[k as usize].distance(self.points[n as usize]);
                (distance <= within).then_some((distance, k, n))
            })
        })
    }
}

/// Chains of arcs, each of which goes on where the one before ends, to `tolerance`; and for each spot whether it is explained by a joint.
pub(super) fn chains(arcs: &[Arc], spots: &[Spot], tolerance: f64) -> Result<(Vec<Chain>, Vec<bool>)> {
    let dropped = repeated(arcs, tolerance)?;
    let mut links = Links { before: alloc::filled(NONE, arcs.len())?, after: alloc::filled(NONE, arcs.len())? };
    // Starts and ends, in turn.
    let points = alloc::collect((0..2 * arcs.len()).map(|k| arcs[k / 2].ends[k % 2]))?;
    let mut joints = Vec::new();
    for (distance, k, n) in Sorted::new(&points)?.pairs(2.0 * tolerance) {
        let (end, start) = if k % 2 == 1 { (k, n) } else { (n, k) };
        let usable = end % 2 == 1 && start % 2 == 0 && end / 2 != start / 2;
        if usable && !dropped[end as usize / 2] && !dropped[start as usize / 2] {
            alloc::push(&mut joints, (distance, end / 2, start / 2))?;
        }
    }
    // The nearest first.
    joints.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    joints.iter().for_each(|&(_, end, start)| links.join(end, start));
    let explained = alloc::collect(spots.iter().map(|spot| {
        let joined =
            |&(_, end, _): &(f64, u32, u32)| arcs[end as usize].ends[1].distance(spot.centre) <= 4.0 * tolerance;
        spot.radius <= tolerance && joints.iter().any(joined)
    }))?;
    bridge(arcs, spots, &dropped, tolerance, &mut links);
    Ok((links.chains(&dropped)?, explained))
}

/// Arcs that are others once more, found from both sides of a side between sheets.
fn repeated(arcs: &[Arc], tolerance: f64) -> Result<Vec<bool>> {
    let mut dropped = alloc::filled(false, arcs.len())?;
    let starts = alloc::collect(arcs.iter().map(|arc| arc.ends[0]))?;
    for (_, k, n) in Sorted::new(&starts)?.pairs(tolerance) {
        let (one, other) = (&arcs[k as usize], &arcs[n as usize]);
        let parallel = |e: usize| one.directions[e].distance(other.directions[e]) <= 1e-5;
        if one.pair != other.pair && one.ends[1].distance(other.ends[1]) <= tolerance && parallel(0) && parallel(1) {
            dropped[k.max(n) as usize] = true;
        }
    }
    Ok(dropped)
}

/// Joins loose ends across spots that could not be resolved: as straight as can be.
fn bridge(arcs: &[Arc], spots: &[Spot], dropped: &[bool], tolerance: f64, links: &mut Links) {
    let loose = |link: &[u32]| -> Vec<u32> {
        (0..arcs.len() as u32).filter(|&k| link[k as usize] == NONE && !dropped[k as usize]).collect()
    };
    let (ends, starts) = (loose(&links.after), loose(&links.before));
    if ends.is_empty() || (ends.len() + starts.len()).saturating_mul(spots.len()) > 1 << 24 {
        return;
    }
    for spot in spots {
        let near = |point: DVec3| point.distance(spot.centre) <= 2.0 * spot.radius + 4.0 * tolerance;
        let mut pairs: Vec<(f64, u32, u32)> = Vec::new();
        for &end in ends.iter().filter(|&&end| near(arcs[end as usize].ends[1])) {
            for &start in starts.iter().filter(|&&start| near(arcs[start as usize].ends[0])) {
                let turn = arcs[end as usize].directions[1].dot(arcs[start as usize].directions[0]);
                if turn > 0.0 && pairs.len() < 1 << 12 {
                    pairs.push((-turn, end, start));
                }
            }
        }
        pairs.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
        pairs.into_iter().for_each(|(_, end, start)| links.join(end, start));
    }
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
