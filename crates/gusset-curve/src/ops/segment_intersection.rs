//! Intersections of two plane segments, by subdivision with proofs.
//!
//! The longer part of a pair is halved until the pair satisfies one of these:
//!
//! - It is separated: the boxes are disjoint, along the axes or along either chord (the fat line of
//!   Sederberg and Nishita, 1990). By the convex hull property no points are lost.
//! - It crosses at most once: every leg of one control polygon turns to the same side of every leg
//!   of the other. Two common points would give both parts the same chord, which is a positive sum
//!   of legs of each, so its cross product with itself would not be 0. Newton's method then finds
//!   the crossing; otherwise the halving continues.
//! - It is so short and straight that all its points are within [`MAX_COMMON_DISTANCE`] of the
//!   other part unless the hulls are separated. The parts then touch, or cross at an angle below
//!   rounding, and the search looks for that place. Shortness alone would not suffice: beside a
//!   long segment a whole curve is short.
//!
//! Overlapping segments would be halved forever and are detected beforehand. Polynomial segments of
//! degrees n and m with more than n m common points lie on the same curve (Bézout). The common part
//! then begins and ends at ends of segments.
//!
//! Source: Hanniel and Elber, 2007, for halving that ends once at most one solution is proven.
//! Cost: at most [`MAX_PAIRS`] pairs of parts, O(degree^2) each.

use super::nearest::nearest_on;
use super::part::{Part, chord, halve, separates};
use crate::curve::segment::{self, SegmentBuffer, point_and_derivatives};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::Aabb;
use gusset_base::geom::subdivision::{BoxTest, Limits, Stack, Subdivision, subdivide};
use gusset_base::sort;

/// In a frame of size 1, boxes closer than this count as touching.
pub(super) const BOX_SLACK: f64 = 1.0 / (1u64 << 46) as f64;
/// Points closer than this count as common.
pub(super) const MAX_COMMON_DISTANCE: f64 = 1e-12;
/// Straight parts smaller than this are not halved.
const MIN_PART_SIZE: f64 = 1.0 / (1u64 << 20) as f64;
/// The largest distance of the control points of a straight part from its chord. If the hulls of
/// two such parts are not separated, their nearest points are common.
const MAX_SAGITTA: f64 = 0.25 * MAX_COMMON_DISTANCE;
/// Intersections whose parameters both differ by less count as one.
pub(super) const SAME_PARAMETER: f64 = 1e-6;
/// Touches that are farther apart than this in the parameters are distinct.
const MAX_TOUCH_PARAMETER: f64 = 1e-3;
/// The maximum number of examined pairs of parts, divided by the product of the degrees.
const MAX_PAIRS: usize = 100_000;
/// The range to which that limit is clamped.
const MAX_PAIRS_RANGE: (usize, usize) = (1_000, 20_000);
/// The number of undecided pairs of segments after which further pairs get only the effort of
/// simple crossings.
const MAX_GIVEN_UP: u32 = 32;
/// The maximum number of examined pairs of parts for each further pair of segments. Simple
/// crossings need fewer.
const MAX_PART_PAIRS_AFTER_GIVING_UP: usize = 300;

/// The joints between two segments, which do not count as intersections.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Joined {
    /// The first segment ends where the second begins.
    pub(super) after: bool,
    /// The first segment begins where the second ends.
    pub(super) before: bool,
}

/// The intersections of two segments, as parameters.
#[derive(Default)]
pub(super) struct SegmentIntersections {
    pub(super) at: Vec<[f64; 2]>,
    /// The ends of each overlap on both segments, in the direction of the first.
    pub(super) overlaps: Vec<[[f64; 2]; 2]>,
    pub(super) undecided: bool,
    /// The number of undecided pairs of segments so far.
    given_up: u32,
}

/// Finds the intersections of two segments in a frame of size 1.
pub(super) fn intersect(a: &[DVec3], b: &[DVec3], joined: Joined, found: &mut SegmentIntersections) -> Result<()> {
    found.at.clear();
    found.overlaps.clear();
    found.undecided = false;
    find_overlaps(a, b, &mut found.overlaps)?;
    let degrees = (a.len() - 1) * (b.len() - 1);
    let max_pairs = if found.given_up < MAX_GIVEN_UP {
        (MAX_PAIRS / degrees).clamp(MAX_PAIRS_RANGE.0, MAX_PAIRS_RANGE.1)
    } else {
        MAX_PART_PAIRS_AFTER_GIVING_UP
    };
    let first = [a, b].map(|controls| Part::whole(SegmentBuffer::new(controls)));
    let limits = Limits { max_depth: u32::MAX, max_boxes: usize::MAX };
    subdivide(&mut PairSearch { whole: [a, b], joined, pairs_left: max_pairs, found }, first, &mut Vec::new(), limits)?;
    found.given_up += u32::from(found.undecided);
    let overlaps = &found.overlaps;
    found.at.retain(|&[s, t]| {
        let at_joint = (joined.after && s > 1.0 - SAME_PARAMETER && t < SAME_PARAMETER)
            || (joined.before && s < SAME_PARAMETER && t > 1.0 - SAME_PARAMETER);
        let in_overlap = |o: &[[f64; 2]; 2]| is_inside(o[0], s, s) && is_inside(o[1], t, t);
        !at_joint && !overlaps.iter().any(in_overlap)
    });
    found.merge(a, b);
    Ok(())
}

struct PairSearch<'a> {
    whole: [&'a [DVec3]; 2],
    joined: Joined,
    pairs_left: usize,
    found: &'a mut SegmentIntersections,
}

impl Subdivision<[Part; 2], 2> for PairSearch<'_> {
    type Solution = [f64; 2];
    /// The index of the part to halve.
    type Split = usize;
    type Stop = Error;

    fn classify(&mut self, [p, q]: &[Part; 2]) -> Result<BoxTest<[f64; 2], usize>> {
        let Some(pairs_left) = self.pairs_left.checked_sub(1) else {
            self.found.undecided = true;
            return Ok(BoxTest::Empty);
        };
        self.pairs_left = pairs_left;
        if are_separated(&p.controls, &q.controls) || self.found.covers(p, q) {
            return Ok(BoxTest::Empty);
        }
        let Joined { after, before } = self.joined;
        let joint = (after && p.to == 1.0 && q.from == 0.0) || (before && p.from == 0.0 && q.to == 1.0);
        let once = crosses_once(&p.controls, &q.controls);
        if joint && (once || continues(&p.controls, &q.controls)) {
            return Ok(BoxTest::Empty);
        }
        let [a, b] = self.whole;
        if once && let Some(at) = newton(a, b, p, q) {
            return Ok(BoxTest::Unique(at));
        }
        let sizes = [p, q].map(Part::size);
        if sizes[0].max(sizes[1]) > MIN_PART_SIZE || ![p, q].into_iter().all(is_straight) {
            return Ok(BoxTest::Undecided(usize::from(sizes[0] < sizes[1])));
        }
        if joint {
            return Ok(BoxTest::Empty);
        }
        Ok(touch(a, b, p, q).map_or(BoxTest::Unresolved, BoxTest::Unique))
    }

    fn accept(&mut self, _: [Part; 2], at: [f64; 2]) -> Result<()> {
        self.found.add(at)
    }

    fn give_up(&mut self, _: [Part; 2], _: bool) -> Result<()> {
        self.found.undecided = true;
        Ok(())
    }

    fn split(&mut self, pair: [Part; 2], number: usize) -> [[Part; 2]; 2] {
        halve(pair, number)
    }

    fn reserve(stack: &mut Stack<[Part; 2]>) -> Result<()> {
        alloc::reserve(stack, 2)
    }
}

/// Returns true if one range of parameters lies in another, in either direction, within a
/// tolerance.
fn is_inside(range: [f64; 2], from: f64, to: f64) -> bool {
    range[0].min(range[1]) - 4.0 * SAME_PARAMETER <= from && to <= range[0].max(range[1]) + 4.0 * SAME_PARAMETER
}

impl SegmentIntersections {
    fn covers(&self, p: &Part, q: &Part) -> bool {
        self.overlaps.iter().any(|o| is_inside(o[0], p.from, p.to) && is_inside(o[1], q.from, q.to))
    }

    fn add(&mut self, at: [f64; 2]) -> Result<()> {
        let same =
            |old: &[f64; 2]| (old[0] - at[0]).abs() <= SAME_PARAMETER && (old[1] - at[1]).abs() <= SAME_PARAMETER;
        if self.at.iter().any(same) { Ok(()) } else { alloc::push(&mut self.at, at) }
    }

    /// Merges intersections between which the segments stay together, because they touch too
    /// closely to resolve. Keeps the middle one.
    fn merge(&mut self, a: &[DVec3], b: &[DVec3]) {
        sort::stable(&mut self.at, &|x, y| x[0].total_cmp(&y[0]));
        let together = |x: [f64; 2], y: [f64; 2]| {
            let middle = segment::point_at(a, 0.5 * (x[0] + y[0]));
            (x[0] - y[0]).abs().max((x[1] - y[1]).abs()) <= MAX_TOUCH_PARAMETER
                && nearest_on(b, middle).1 <= MAX_COMMON_DISTANCE * MAX_COMMON_DISTANCE
        };
        let mut kept = 0;
        let mut rest = 0..self.at.len();
        while let Some(i) = rest.next() {
            let first = self.at[i];
            let mut last = first;
            while !rest.is_empty() && together(last, self.at[rest.start]) {
                last = self.at[rest.start];
                rest.start += 1;
            }
            self.at[kept] = [0.5 * (first[0] + last[0]), 0.5 * (first[1] + last[1])];
            if first != last {
                self.at[kept][1] = snap(nearest_on(b, segment::point_at(a, self.at[kept][0])).0);
            }
            kept += 1;
        }
        self.at.truncate(kept);
    }
}

/// Returns true if the hulls are separated along an axis, or along or across a chord.
fn are_separated(a: &[DVec3], b: &[DVec3]) -> bool {
    if !Aabb::from_points(a).is_within(&Aabb::from_points(b), BOX_SLACK) {
        return true;
    }
    [chord(a), chord(b)].into_iter().any(|chord| {
        let across = DVec3::new(-chord.y, chord.x, 0.0);
        chord != DVec3::ZERO && (separates(chord, a, b, BOX_SLACK) || separates(across, a, b, BOX_SLACK))
    })
}

/// Returns true if a part deviates from its chord by at most [`MAX_SAGITTA`].
fn is_straight(part: &Part) -> bool {
    let controls = &part.controls;
    let (first, along) = (controls[0], controls[controls.len() - 1] - controls[0]);
    controls.iter().all(|&p| {
        let t = ((p - first).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        // NaN if the ends coincide.
        let near = if t.is_nan() { first } else { first + along * t };
        p.distance(near) <= MAX_SAGITTA
    })
}

/// Returns the non-zero legs of a control polygon.
fn legs(controls: &[DVec3]) -> impl Iterator<Item = DVec3> + Clone {
    controls.windows(2).map(|pair| pair[1] - pair[0]).filter(|&leg| leg != DVec3::ZERO)
}

/// Returns true if all legs of `b` turn to the same side of all legs of `a`.
fn crosses_once(a: &[DVec3], b: &[DVec3]) -> bool {
    let mut side = 0.0;
    for u in legs(a) {
        for v in legs(b) {
            let turn = cross_z(u, v);
            if turn.abs() <= 1e-14 * u.length() * v.length() || turn * side < 0.0 {
                return false;
            }
            side = turn;
        }
    }
    side != 0.0
}

/// Returns true if some direction increases along all legs of both. One part then continues the
/// other, and they meet only in their joint.
fn continues(a: &[DVec3], b: &[DVec3]) -> bool {
    let along = chord(a) + chord(b);
    legs(a).chain(legs(b)).all(|leg| leg.dot(along) > 0.0)
}

fn cross_z(u: DVec3, v: DVec3) -> f64 {
    u.x * v.y - u.y * v.x
}

/// Returns the solution (s, t) of two linear equations, if it exists.
fn solve(rows: [[f64; 2]; 2], right: [f64; 2]) -> Option<[f64; 2]> {
    let [[a, b], [c, d]] = rows;
    let determinant = a * d - b * c;
    let x = [(right[0] * d - b * right[1]) / determinant, (a * right[1] - right[0] * c) / determinant];
    x.iter().all(|x| x.is_finite()).then_some(x)
}

/// Returns the crossing of two parts, by Newton's method for A(s) = B(t) from the middle. Returns
/// `None` if it leads outside the parts.
fn newton(a: &[DVec3], b: &[DVec3], p: &Part, q: &Part) -> Option<[f64; 2]> {
    let (mut s, mut t) = (p.middle(), q.middle());
    for _ in 0..30 {
        let ([at, u, _], [bt, v, _]) = (point_and_derivatives::<3>(a, s), point_and_derivatives::<3>(b, t));
        let gap = bt - at;
        let [ds, dt] = solve([[u.x, -v.x], [u.y, -v.y]], [gap.x, gap.y])?;
        let (next_s, next_t) = ((s + ds).clamp(p.from, p.to), (t + dt).clamp(q.from, q.to));
        let moved = (next_s - s).abs().max((next_t - t).abs());
        (s, t) = (next_s, next_t);
        if moved <= 2.0 * f64::EPSILON {
            break;
        }
    }
    let near = segment::point_at(a, s).distance(segment::point_at(b, t)) <= 4.0 * BOX_SLACK;
    near.then(|| [s, t].map(snap))
}

/// Snaps a parameter to 0 or 1 within rounding.
fn snap(t: f64) -> f64 {
    if t < 1e-14 {
        0.0
    } else if t > 1.0 - 1e-14 {
        1.0
    } else {
        t
    }
}

/// Returns the place where two short parts touch. Applies Newton's method to A' x B' = 0 and (A -
/// B) . A' = 0, or else alternates between nearest points of both.
fn touch(a: &[DVec3], b: &[DVec3], p: &Part, q: &Part) -> Option<[f64; 2]> {
    let start = [p.middle(), q.middle()];
    let reach = 8.0 * (p.to - p.from).max(q.to - q.from);
    let common = |s: f64, t: f64| segment::point_at(a, s).distance(segment::point_at(b, t)) <= MAX_COMMON_DISTANCE;
    let [mut s, mut t] = start;
    for _ in 0..8 {
        let ([at, u, u2], [bt, v, v2]) = (point_and_derivatives::<3>(a, s), point_and_derivatives::<3>(b, t));
        let gap = at - bt;
        let rows = [[cross_z(u2, v), cross_z(u, v2)], [u.dot(u) + gap.dot(u2), -v.dot(u)]];
        let Some([ds, dt]) = solve(rows, [-cross_z(u, v), -gap.dot(u)]) else { break };
        (s, t) = ((s + ds).clamp(0.0, 1.0), (t + dt).clamp(0.0, 1.0));
    }
    if (s - start[0]).abs().max((t - start[1]).abs()) <= reach && common(s, t) {
        return Some([snap(s), snap(t)]);
    }
    let [mut s, mut t] = start;
    for _ in 0..4 {
        t = nearest_on(b, segment::point_at(a, s)).0;
        s = nearest_on(a, segment::point_at(b, t)).0;
    }
    let stays = (s - start[0]).abs().max((t - start[1]).abs()) <= reach;
    (stays && common(s, t)).then(|| [snap(s), snap(t)])
}

/// Finds the common parts of segments that lie on the same curve.
fn find_overlaps(a: &[DVec3], b: &[DVec3], found: &mut Vec<[[f64; 2]; 2]>) -> Result<()> {
    let common = |controls: &[DVec3], p: DVec3| {
        let (t, squared) = nearest_on(controls, p);
        (squared <= MAX_COMMON_DISTANCE * MAX_COMMON_DISTANCE).then_some(t)
    };
    let candidates = [
        common(a, b[0]).map(|s| [s, 0.0]),
        common(a, b[b.len() - 1]).map(|s| [s, 1.0]),
        common(b, a[0]).map(|t| [0.0, t]),
        common(b, a[a.len() - 1]).map(|t| [1.0, t]),
    ];
    let (mut ends, mut count) = ([[0.0; 2]; 4], 0);
    for at in candidates.into_iter().flatten() {
        ends[count] = at;
        count += 1;
    }
    let ends = &mut ends[..count];
    sort::stable(ends, &|x, y| x[0].total_cmp(&y[0]));
    // More than n m common points prove it; 64 samples are taken as enough.
    let samples = ((a.len() - 1) * (b.len() - 1)).min(64) + 1;
    for pair in ends.windows(2) {
        let ([s, t], [s1, t1]) = (pair[0], pair[1]);
        if s1 - s <= 4.0 * SAME_PARAMETER {
            continue;
        }
        let between = |k: usize| segment::point_at(a, s + (s1 - s) * k as f64 / (samples + 1) as f64);
        if (1..=samples).all(|k| common(b, between(k)).is_some()) {
            alloc::push(found, [[s, s1], [t, t1]])?;
        }
    }
    Ok(())
}

/// Returns true if no two points of the segment coincide: all legs of its control polygon advance
/// along its chord.
pub(super) fn advances(controls: &[DVec3]) -> bool {
    let chord = controls[controls.len() - 1] - controls[0];
    legs(controls).all(|leg| leg.dot(chord) > 0.0)
}
