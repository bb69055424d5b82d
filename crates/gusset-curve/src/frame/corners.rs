//! The corners of sections, as a deck has at its edges, and which of them belong together along a
//! body.
//!
//! A point is a corner where the polygon of a section turns sharply, far more than it does usually,
//! and than at the points beside it: so a smooth section of few points has none. Corners that all
//! sections have are landmarks: each gets a node, and the curves across turn sharply there.

use super::frame_options::FrameOptions;
use crate::identify::{Constraint, Options, Outlines, PointConstraint};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::{Aabb, scale::distance};
use gusset_base::job::Job;
use gusset_base::sort;
use std::f64::consts::PI;

/// A corner turns by this angle at least, in radians, ...
const MIN_TURN: f64 = 0.7;
/// ... by so many times what half of the points do, ...
const MIN_CONTRAST: f64 = 3.0;
/// ... and by so many times what the points beside it do; one of them if it turns by SHARP, as two
/// edges of a deck without points between them.
const MIN_LEAD: f64 = 2.0;
const SHARP: f64 = 1.2;
/// A section with more corners than this is jagged: it has none in common with others.
const MAX_SHARED: usize = 128;
/// Of one part, when parts are apportioned.
const STEPS: f64 = (1 << 30) as f64;

/// Of each section the numbers of its corners among its points, ascending: those that the caller
/// has, and those by [`FrameOptions::across`] or, if that has none, by the rule above; but for points
/// with another constraint, and the ends of open sections.
pub(super) fn corners(sections: &Outlines<'_>, rows: usize, options: &FrameOptions<'_>) -> Result<Vec<Vec<u32>>> {
    let mut all = alloc::with_capacity(rows)?;
    for k in 0..rows {
        let span = sections.span(k);
        let place = |point: usize| sections.constraints.partition_point(|c| (c.point as usize) < point);
        let constraints = &sections.constraints[place(span.start)..place(span.end)];
        let mut own = Vec::new();
        if !options.smooth_corners {
            let points = span.clone().map(|i| sections.points.get(i));
            let turns = turns(points, sections.closed, options.across.repeat_tolerance)?;
            let found = of_turns(&turns, sections.closed, options.across.corner_angle)?;
            let is_free = |i: &u32| constraints.iter().all(|c| c.point as usize != span.start + *i as usize);
            own = alloc::gather(found.into_iter().filter(is_free))?;
        }
        let given = constraints.iter().filter(|c| c.kind == PointConstraint::Corner);
        let given = alloc::gather(given.map(|c| (c.point as usize - span.start) as u32))?;
        alloc::append(&mut own, &given)?;
        if !sections.closed {
            let at = |i: usize| sections.points.get(span.start + i);
            own.retain(|&i| ![0, span.len() - 1].iter().any(|&end| at(end) == at(i as usize)));
        }
        own.sort_unstable();
        own.dedup();
        all.push(own);
    }
    Ok(all)
}

/// The corners among the points of a row of nodes by an angle.
pub(super) fn sharp_nodes(row: &[DVec3], closed: bool, options: &Options) -> Result<Vec<u32>> {
    let turns = turns(row.iter().copied(), closed, options.repeat_tolerance)?;
    if options.corner_angle < PI { of_turns(&turns, closed, options.corner_angle) } else { Ok(Vec::new()) }
}

/// The points that turn by more than an angle, or, if it is pi, that stand out.
fn of_turns(turns: &[(u32, f64)], closed: bool, angle: f64) -> Result<Vec<u32>> {
    let found = if angle < PI { sharper(turns, angle)? } else { outstanding(turns, closed)? };
    alloc::collect(found.into_iter().map(|at| turns[at].0))
}

/// Of each inner point that is not at the place of the one before, within `tolerance` parts of the
/// section's size: its number, and the angle by which the polygon turns.
fn turns(points: impl Iterator<Item = DVec3> + Clone, closed: bool, tolerance: f64) -> Result<Vec<(u32, f64)>> {
    let near = tolerance * Aabb::from_points(points.clone()).diagonal();
    let is_same = |p: DVec3, q: DVec3| p == q || distance(p, q) <= near;
    let mut distinct: Vec<(u32, DVec3)> = Vec::new();
    for (i, p) in (0..).zip(points) {
        if distinct.last().is_none_or(|&(_, last)| !is_same(last, p)) {
            alloc::push(&mut distinct, (i, p))?;
        }
    }
    while closed && distinct.len() > 1 && is_same(distinct[0].1, distinct[distinct.len() - 1].1) {
        distinct.pop();
    }
    let n = distinct.len();
    let size = distinct.iter().map(|&(_, p)| p.abs().max_element()).fold(f64::MIN_POSITIVE, f64::max);
    let at = |k: usize| distinct[k % n].1 / size;
    let inner = if n < 3 {
        0..0
    } else if closed {
        0..n
    } else {
        1..n - 1
    };
    alloc::collect(inner.map(|k| {
        let (u, v) = (at(k) - at(k + n - 1), at(k + 1) - at(k));
        (distinct[k].0, libm::atan2(u.cross(v).length(), u.dot(v)))
    }))
}

fn sharper(turns: &[(u32, f64)], angle: f64) -> Result<Vec<usize>> {
    alloc::gather((0..turns.len()).filter(|&k| turns[k].1 > angle))
}

fn outstanding(turns: &[(u32, f64)], closed: bool) -> Result<Vec<usize>> {
    let n = turns.len();
    let mut sorted = alloc::collect(turns.iter().map(|&(_, turn)| turn))?;
    sorted.sort_unstable_by(f64::total_cmp);
    let usual = sorted.get(n.saturating_sub(1) / 2).copied().unwrap_or(0.0);
    let beside = |k: usize, by: usize| {
        let other = k + n + by - 1;
        if closed || (n..2 * n).contains(&other) { turns[other % n].1 } else { 0.0 }
    };
    alloc::gather((0..n).filter(|&k| {
        let turn = turns[k].1;
        let [before, after] = [beside(k, 0), beside(k, 2)];
        let others = if turn >= SHARP { before.min(after) } else { before.max(after) };
        turn >= MIN_TURN && turn >= MIN_CONTRAST * usual && turn >= MIN_LEAD * others
    }))
}

/// The constraints of the sections, with their corners among them.
pub(super) fn constrained(sections: &Outlines<'_>, corners: &[Vec<u32>]) -> Result<Vec<Constraint>> {
    let mut all = alloc::copied(sections.constraints)?;
    for (k, own) in corners.iter().enumerate() {
        let first = sections.span(k).start as u32;
        for &corner in own {
            let point = first + corner;
            if sections.constraints.binary_search_by_key(&point, |c| c.point).is_err() {
                alloc::push(&mut all, Constraint { point, kind: PointConstraint::Corner })?;
            }
        }
    }
    sort::stable(&mut all, &|a, b| a.point.cmp(&b.point));
    Ok(all)
}

/// Of each section as many of its corners, in order as the sections run, those that belong together
/// at the same places of the lists; empty if a section has none.
///
/// The section with the fewest corners keeps all of them; from there on each next one keeps those
/// that are nearest to its neighbour's, in the same order round the body. None are kept where that
/// would be more than `most`. `at`: where a corner of a section is, from the section's own centre, in
/// a unit that keeps squares in range. `closed`: any corner may be the first.
pub(super) fn matched(
    corners: &[Vec<u32>],
    closed: bool,
    most: usize,
    at: &dyn Fn(usize, u32) -> DVec3,
    job: &Job<'_>,
) -> Result<Vec<Vec<u32>>> {
    let mut chosen = alloc::collect(corners.iter().map(|_| Vec::new()))?;
    let fewest = (0..corners.len()).min_by_key(|&k| corners[k].len());
    let is_jagged = corners.iter().any(|own| own.len() > MAX_SHARED);
    let Some(fewest) = fewest.filter(|&k| corners[k].len() <= most && !is_jagged) else {
        return Ok(chosen);
    };
    chosen[fewest] = alloc::copied(&corners[fewest])?;
    let ways = (fewest + 1..corners.len()).map(|k| (k, k - 1)).chain((0..fewest).rev().map(|k| (k, k + 1)));
    for (done, (k, neighbour)) in ways.enumerate() {
        job.step(done as f64 / corners.len() as f64, "finding nodes")?;
        let distance = |i: usize, c: u32| at(neighbour, chosen[neighbour][i]).distance_squared(at(k, c));
        chosen[k] = nearest(&corners[k], chosen[neighbour].len(), closed, &distance)?;
    }
    Ok(chosen)
}

/// So many of a section's corners in order, the sum of their squared distances being least. O(n^2
/// count) for a closed section of n.
fn nearest(own: &[u32], count: usize, closed: bool, distance: &dyn Fn(usize, u32) -> f64) -> Result<Vec<u32>> {
    let n = own.len();
    let mut best = (f64::INFINITY, Vec::new());
    if count == 0 {
        return Ok(best.1);
    }
    for first in 0..if closed { n } else { 1 } {
        let corner = |j: usize| own[(first + j) % n];
        // At (i, j): the least sum for the first i with the first j corners; whether j is taken.
        let mut cells = alloc::filled((f64::INFINITY, false), (count + 1) * (n + 1))?;
        let cell = |i: usize, j: usize| i * (n + 1) + j;
        (0..=n).for_each(|j| cells[cell(0, j)].0 = 0.0);
        for i in 1..=count {
            for j in i..=n {
                let taken = cells[cell(i - 1, j - 1)].0 + distance(i - 1, corner(j - 1));
                let left = cells[cell(i, j - 1)].0;
                cells[cell(i, j)] = if taken < left { (taken, true) } else { (left, false) };
            }
        }
        let sum = cells[cell(count, n)].0;
        if sum < best.0 {
            let (mut i, mut j, mut chosen) = (count, n, alloc::with_capacity(count)?);
            while i > 0 {
                if cells[cell(i, j)].1 {
                    chosen.push(corner(j - 1));
                    i -= 1;
                }
                j -= 1;
            }
            chosen.reverse();
            best = (sum, chosen);
        }
    }
    Ok(best.1)
}

/// How many of `parts` parts each interval gets, at least one each: as its share of the length says,
/// the largest remainders first.
pub(super) fn apportioned(shares: &[f64], parts: usize) -> Result<Vec<usize>> {
    let whole: f64 = shares.iter().sum();
    let free = (parts - shares.len()) as f64;
    // In steps of which round-off makes no difference.
    let exact = |k: usize| (STEPS * free * shares[k] / whole).round() / STEPS;
    let mut counts = alloc::collect((0..shares.len()).map(|k| 1 + exact(k).floor() as usize))?;
    let mut order = alloc::collect(0..shares.len())?;
    sort::stable(&mut order, &|&j, &k| exact(k).fract().total_cmp(&exact(j).fract()).then(j.cmp(&k)));
    let left = parts.saturating_sub(counts.iter().sum());
    order.into_iter().take(left).for_each(|k| counts[k] += 1);
    Ok(counts)
}
