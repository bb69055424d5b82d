//! The corners of sections, such as the edges of a deck, and their correspondence along a body.
//!
//! A section is a polygon if it is closed and has at most 6 points, or if each point turns either
//! sharply or hardly. All points of a polygon that turn are corners. In other sections, a corner
//! turns much more sharply than usual and than its neighbours. A smooth section of few points
//! therefore lacks corners. Each corner is a landmark: it gets a node, and the curve across turns
//! sharply there.

use super::frame_options::FrameOptions;
use crate::identify::{Constraint, Options, Outlines, PointConstraint};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::{Aabb, scale::overflow_safe_distance};
use gusset_base::sort;
use std::f64::consts::PI;

/// The smallest turn of a corner, in radians.
const MIN_CORNER_TURN_RADIANS: f64 = 0.7;
/// The smallest ratio of a corner's turn to the median turn.
const MIN_TURN_TO_MEDIAN_RATIO: f64 = 3.0;
/// The smallest ratio of a corner's turn to its neighbours' turns.
const MIN_TURN_TO_NEIGHBOUR_RATIO: f64 = 2.0;
/// From this turn on only the smaller of the neighbours' turns counts, because two edges of a deck
/// may be adjacent points.
const MIN_SHARP_TURN_RADIANS: f64 = 1.2;
/// A closed section of at most this many points is a polygon. Regular polygons of up to 6 sides keep
/// their corners; 7 points on a circle make a round section.
const MAX_POINTS_OF_POLYGON: usize = 6;
/// The smallest turn of a polygon's corners, in radians, if it has more points. The turn of a regular
/// hexagon is 1.05, of a heptagon 0.9.
const MIN_POLYGON_CORNER_RADIANS: f64 = 0.95;
/// The largest turn of points on the sides of a polygon, in radians.
const MAX_POLYGON_SIDE_RADIANS: f64 = 0.1;
/// A section with more corners than this is jagged, and all its corners are drawn smooth.
pub(super) const MAX_CORNERS_PER_SECTION: usize = 128;
/// The resolution of one part when parts are apportioned.
const APPORTIONING_STEPS_PER_PART: f64 = (1 << 30) as f64;

/// For each section the indices of its corners among its points, ascending. They are the caller's
/// corners, and corners by [`FrameOptions::across`] or, if that sets no angle, by the rule above.
/// Points with another constraint and the ends of open sections are excluded.
pub(super) fn find_corners_of_sections(
    sections: &Outlines<'_>,
    rows: usize,
    options: &FrameOptions<'_>,
) -> Result<Vec<Vec<u32>>> {
    let mut all = alloc::with_capacity(rows)?;
    for k in 0..rows {
        let span = sections.point_range(k);
        let place = |point: usize| sections.constraints.partition_point(|c| (c.point as usize) < point);
        let constraints = &sections.constraints[place(span.start)..place(span.end)];
        let mut own = Vec::new();
        if !options.smooth_corners {
            let points = span.clone().map(|i| sections.points.get(i));
            let turns = turn_angles(points, sections.closed, options.across.repeat_tolerance)?;
            let found = points_turning_more_than(&turns, sections.closed, options.across.corner_angle)?;
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

/// Returns the nodes of a row at which the curve turns by more than the options' corner angle.
pub(super) fn nodes_with_sharp_turn(row: &[DVec3], closed: bool, options: &Options) -> Result<Vec<u32>> {
    let turns = turn_angles(row.iter().copied(), closed, options.repeat_tolerance)?;
    if options.corner_angle < PI {
        points_turning_more_than(&turns, closed, options.corner_angle)
    } else {
        Ok(Vec::new())
    }
}

/// Returns the points that turn by more than an angle. If the angle is pi, the corners of a polygon, or
/// the points whose turn stands out.
fn points_turning_more_than(turns: &[(u32, f64)], closed: bool, angle: f64) -> Result<Vec<u32>> {
    let found = if angle < PI {
        indices_of_sharper_turns(turns, angle)?
    } else if is_polygon(turns, closed) {
        indices_of_sharper_turns(turns, MAX_POLYGON_SIDE_RADIANS)?
    } else {
        indices_of_outstanding_turns(turns, closed)?
    };
    alloc::collect(found.into_iter().map(|at| turns[at].0))
}

/// Returns whether a section has few points, or each point turns either sharply or hardly.
fn is_polygon(turns: &[(u32, f64)], closed: bool) -> bool {
    let is_clear = |turn: f64| !(MAX_POLYGON_SIDE_RADIANS..MIN_POLYGON_CORNER_RADIANS).contains(&turn);
    (closed && turns.len() <= MAX_POINTS_OF_POLYGON) || turns.iter().all(|&(_, turn)| is_clear(turn))
}

/// Returns the index and turn of each inner point, in radians. Points within `tolerance` times the
/// section's size of the previous point are skipped.
fn turn_angles(points: impl Iterator<Item = DVec3> + Clone, closed: bool, tolerance: f64) -> Result<Vec<(u32, f64)>> {
    let near = tolerance * Aabb::from_points(points.clone()).diagonal();
    let is_same = |p: DVec3, q: DVec3| p == q || overflow_safe_distance(p, q) <= near;
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

fn indices_of_sharper_turns(turns: &[(u32, f64)], angle: f64) -> Result<Vec<usize>> {
    alloc::gather((0..turns.len()).filter(|&k| turns[k].1 > angle))
}

fn indices_of_outstanding_turns(turns: &[(u32, f64)], closed: bool) -> Result<Vec<usize>> {
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
        let others = if turn >= MIN_SHARP_TURN_RADIANS { before.min(after) } else { before.max(after) };
        turn >= MIN_CORNER_TURN_RADIANS
            && turn >= MIN_TURN_TO_MEDIAN_RATIO * usual
            && turn >= MIN_TURN_TO_NEIGHBOUR_RATIO * others
    }))
}

/// Returns the constraints of the sections, with their corners added.
pub(super) fn point_constraints_with_corners(sections: &Outlines<'_>, corners: &[Vec<u32>]) -> Result<Vec<Constraint>> {
    let mut all = alloc::copied(sections.constraints)?;
    for (k, own) in corners.iter().enumerate() {
        let first = sections.point_range(k).start as u32;
        for &corner in own {
            let point = first + corner;
            if sections.constraints.binary_search_by_key(&point, |c| c.point).is_err() {
                alloc::push(&mut all, Constraint { point, kind: PointConstraint::Corner })?;
            }
        }
    }
    sort::sort_stable(&mut all, &|a, b| a.point.cmp(&b.point));
    Ok(all)
}

/// Chooses `count` of a section's corners, in order, with the least sum of squared distances. O(n^2
/// count) for a closed section of n corners.
pub(super) fn choose_nearest_corners(
    candidates: &[u32],
    count: usize,
    closed: bool,
    distance: &dyn Fn(usize, u32) -> f64,
) -> Result<Vec<u32>> {
    let n = candidates.len();
    let mut best = (f64::INFINITY, Vec::new());
    if count == 0 {
        return Ok(best.1);
    }
    for first in 0..if closed { n } else { 1 } {
        let corner = |j: usize| candidates[(first + j) % n];
        // At (i, j): the least sum that matches the first i with some of the first j corners, and
        // whether corner j is taken.
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

/// Divides `parts` parts among intervals in proportion to their lengths, at least one each. The
/// largest remainders are rounded up first.
pub(super) fn apportion_parts(shares: &[f64], parts: usize) -> Result<Vec<usize>> {
    let whole: f64 = shares.iter().sum();
    let free = (parts - shares.len()) as f64;
    // Quantised, so that round-off does not decide.
    let exact =
        |k: usize| (APPORTIONING_STEPS_PER_PART * free * shares[k] / whole).round() / APPORTIONING_STEPS_PER_PART;
    let mut counts = alloc::collect((0..shares.len()).map(|k| 1 + exact(k).floor() as usize))?;
    let mut order = alloc::collect(0..shares.len())?;
    sort::sort_stable(&mut order, &|&j, &k| exact(k).fract().total_cmp(&exact(j).fract()).then(j.cmp(&k)));
    let left = parts.saturating_sub(counts.iter().sum());
    order.into_iter().take(left).for_each(|k| counts[k] += 1);
    Ok(counts)
}
