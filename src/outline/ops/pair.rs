//! Where two plane segments meet, by halving with proofs.
//!
//! Both are halved, the longer one first, until a pair of parts
//!
//! * is apart: their boxes are, along the axes or along either chord (the fat line of Sederberg and Nishita 1990); by the
//!   convex hull no points are lost;
//! * crosses once at most: every leg of one control polygon turns to the same side of every leg of the other. Two common
//!   points would give both parts the same chord, which is a positive sum of legs of each: its cross product with itself
//!   would not be 0. Newton's method then finds the crossing, or the halving goes on;
//! * is so short that nothing but a touch can be told: it is looked for, and taken if the segments come within rounding.
//!
//! Segments that run together would be halved for ever. They are recognised before: polynomial segments of degrees n and m
//! that have more than n m points in common lie on the same curve (Bézout), and then the common part begins and ends at ends
//! of segments.

use super::super::curve::MAX_DEGREE;
use super::super::segment;
use super::evaluate::derive;
use super::nearest::nearest_on;
use super::split::{Controls, split_segment};
use crate::alloc;
use crate::error::Result;
use crate::geom::Aabb;
use glam::DVec3;

/// Boxes nearer than this are not apart, in a frame of size 1.
pub(super) const SLACK: f64 = 1.0 / (1u64 << 46) as f64;
/// Points nearer than this are common.
pub(super) const COMMON: f64 = 1e-12;
/// Parts smaller than this are not halved.
const SHORT: f64 = 1.0 / (1u64 << 20) as f64;
/// Meetings whose parameters both differ by less are one.
pub(super) const SAME: f64 = 1e-6;
/// Touches farther apart than this, in the parameters, are different ones.
const CLOSE: f64 = 1e-3;
/// Pairs of parts that are looked at before two segments are given up: so many by the product of their degrees, within limits.
const PATIENCE: usize = 100_000;
const PATIENCE_LIMITS: (usize, usize) = (1_000, 20_000);
/// After so many pairs given up the rest is looked at with the patience that plain crossings need.
const GIVEN_UP: u32 = 32;
const LITTLE_PATIENCE: usize = 300;

/// Where the segments have a joint with each other, which does not count as a meeting.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Joined {
    /// The first ends where the second begins.
    pub(super) after: bool,
    /// The first begins where the second ends.
    pub(super) before: bool,
}

/// What was found, in parameters of the segments.
#[derive(Default)]
pub(super) struct Found {
    pub(super) at: Vec<[f64; 2]>,
    /// From where to where on each, running with the first.
    pub(super) overlaps: Vec<[[f64; 2]; 2]>,
    pub(super) undecided: bool,
    /// How many pairs have been given up so far.
    pub(super) given_up: u32,
}

/// A part of a segment.
#[derive(Clone, Copy)]
struct Part {
    controls: Controls,
    len: usize,
    from: f64,
    to: f64,
}

impl Part {
    fn whole(controls: &[DVec3]) -> Self {
        let mut buffer = [DVec3::ZERO; MAX_DEGREE + 1];
        buffer[..controls.len()].copy_from_slice(controls);
        Part { controls: buffer, len: controls.len(), from: 0.0, to: 1.0 }
    }

    fn controls(&self) -> &[DVec3] {
        &self.controls[..self.len]
    }

    fn halves(mut self) -> [Part; 2] {
        let middle = 0.5 * (self.from + self.to);
        let mut before = Part { to: middle, ..self };
        split_segment(&mut self.controls[..self.len], 0.5, &mut before.controls[..self.len]);
        [before, Part { from: middle, ..self }]
    }
}

/// Finds the meetings of two segments in a frame of size 1.
pub(super) fn meet(a: &[DVec3], b: &[DVec3], joined: Joined, found: &mut Found) -> Result<()> {
    found.at.clear();
    found.overlaps.clear();
    found.undecided = false;
    overlaps(a, b, &mut found.overlaps)?;
    let mut waiting = Vec::new();
    alloc::push(&mut waiting, [Part::whole(a), Part::whole(b)])?;
    let degrees = (a.len() - 1) * (b.len() - 1);
    let patience = if found.given_up < GIVEN_UP {
        (PATIENCE / degrees).clamp(PATIENCE_LIMITS.0, PATIENCE_LIMITS.1)
    } else {
        LITTLE_PATIENCE
    };
    let mut looked = 0;
    while let Some([p, q]) = waiting.pop() {
        looked += 1;
        if looked > patience {
            found.undecided = true;
            found.given_up += 1;
            break;
        }
        if apart(p.controls(), q.controls()) || found.covers(&p, &q) {
            continue;
        }
        let joint = (joined.after && p.to == 1.0 && q.from == 0.0) || (joined.before && p.from == 0.0 && q.to == 1.0);
        let once = crosses_once(p.controls(), q.controls());
        if joint && (once || runs_on(p.controls(), q.controls())) {
            continue;
        }
        if once && let Some(at) = newton(a, b, &p, &q) {
            found.add(at)?;
            continue;
        }
        let sizes = [Aabb::of(p.controls()).size().max_element(), Aabb::of(q.controls()).size().max_element()];
        if sizes[0].max(sizes[1]) <= SHORT {
            if !joint && let Some(at) = touch(a, b, &p, &q) {
                found.add(at)?;
            }
        } else if sizes[0] >= sizes[1] {
            alloc::reserve(&mut waiting, 2)?;
            waiting.extend(p.halves().map(|half| [half, q]));
        } else {
            alloc::reserve(&mut waiting, 2)?;
            waiting.extend(q.halves().map(|half| [p, half]));
        }
    }
    let overlaps = &found.overlaps;
    found.at.retain(|&[s, t]| {
        let at_joint = (joined.after && s > 1.0 - SAME && t < SAME) || (joined.before && s < SAME && t > 1.0 - SAME);
        let in_overlap = |o: &[[f64; 2]; 2]| inside(o[0], s, s) && inside(o[1], t, t);
        !at_joint && !overlaps.iter().any(in_overlap)
    });
    found.merge(a, b);
    Ok(())
}

/// Whether a range of parameters lies in another, in either direction, but for a little.
fn inside(range: [f64; 2], from: f64, to: f64) -> bool {
    range[0].min(range[1]) - 4.0 * SAME <= from && to <= range[0].max(range[1]) + 4.0 * SAME
}

impl Found {
    fn covers(&self, p: &Part, q: &Part) -> bool {
        self.overlaps.iter().any(|o| inside(o[0], p.from, p.to) && inside(o[1], q.from, q.to))
    }

    fn add(&mut self, at: [f64; 2]) -> Result<()> {
        let same = |old: &[f64; 2]| (old[0] - at[0]).abs() <= SAME && (old[1] - at[1]).abs() <= SAME;
        if self.at.iter().any(same) { Ok(()) } else { alloc::push(&mut self.at, at) }
    }
}

impl Found {
    /// Makes one meeting of those between which the segments stay together: where they touch so closely that no place can be
    /// told from the next. It is their middle.
    fn merge(&mut self, a: &[DVec3], b: &[DVec3]) {
        self.at.sort_by(|x, y| x[0].total_cmp(&y[0]));
        let together = |x: [f64; 2], y: [f64; 2]| {
            let middle = segment::point(a, 0.5 * (x[0] + y[0]));
            (x[0] - y[0]).abs().max((x[1] - y[1]).abs()) <= CLOSE && nearest_on(b, middle).1 <= COMMON * COMMON
        };
        let mut kept = 0;
        let mut i = 0;
        while i < self.at.len() {
            let first = self.at[i];
            let mut last = first;
            while i + 1 < self.at.len() && together(last, self.at[i + 1]) {
                i += 1;
                last = self.at[i];
            }
            self.at[kept] = [0.5 * (first[0] + last[0]), 0.5 * (first[1] + last[1])];
            if first != last {
                self.at[kept][1] = snap(nearest_on(b, segment::point(a, self.at[kept][0])).0);
            }
            kept += 1;
            i += 1;
        }
        self.at.truncate(kept);
    }
}

/// Whether the hulls are apart along the axes or along or across a chord.
fn apart(a: &[DVec3], b: &[DVec3]) -> bool {
    if !Aabb::of(a).is_within(&Aabb::of(b), SLACK) {
        return true;
    }
    [a, b].into_iter().any(|of| {
        let chord = (of[of.len() - 1] - of[0]).normalize_or_zero();
        chord != DVec3::ZERO && (separates(chord, a, b) || separates(DVec3::new(-chord.y, chord.x, 0.0), a, b))
    })
}

fn separates(axis: DVec3, a: &[DVec3], b: &[DVec3]) -> bool {
    let range = |points: &[DVec3]| {
        let at = points.iter().map(|&p| axis.dot(p - a[0]));
        at.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
    };
    let (a, b) = (range(a), range(b));
    a.0 - b.1 > SLACK || b.0 - a.1 > SLACK
}

fn legs(controls: &[DVec3]) -> impl Iterator<Item = DVec3> + Clone {
    controls.windows(2).map(|pair| pair[1] - pair[0]).filter(|&leg| leg != DVec3::ZERO)
}

/// Whether all legs of `b` turn to the same side from all legs of `a`.
fn crosses_once(a: &[DVec3], b: &[DVec3]) -> bool {
    let mut side = 0.0;
    for u in legs(a) {
        for v in legs(b) {
            let turn = u.perp_dot_xy(v);
            if turn.abs() <= 1e-14 * u.length() * v.length() || turn * side < 0.0 {
                return false;
            }
            side = turn;
        }
    }
    side != 0.0
}

/// Whether some direction increases along all legs of both: then one follows the other, and they have only their joint in
/// common.
fn runs_on(a: &[DVec3], b: &[DVec3]) -> bool {
    let chord = |c: &[DVec3]| (c[c.len() - 1] - c[0]).normalize_or_zero();
    let along = chord(a) + chord(b);
    legs(a).chain(legs(b)).all(|leg| leg.dot(along) > 0.0)
}

trait Plane {
    /// The z of the cross product.
    fn perp_dot_xy(self, other: Self) -> f64;
}

impl Plane for DVec3 {
    fn perp_dot_xy(self, other: DVec3) -> f64 {
        self.x * other.y - self.y * other.x
    }
}

/// The point and the first two derivatives.
fn jet(controls: &[DVec3], t: f64) -> [DVec3; 3] {
    let mut buffer = [DVec3::ZERO; MAX_DEGREE + 1];
    buffer[..controls.len()].copy_from_slice(controls);
    let mut left = controls.len();
    [(); 3].map(|()| {
        let value = segment::point(&buffer[..left], t);
        left = derive(&mut buffer[..left]);
        value
    })
}

/// The solution (s, t) of two linear equations, if there is one.
fn solve(rows: [[f64; 2]; 2], right: [f64; 2]) -> Option<[f64; 2]> {
    let [[a, b], [c, d]] = rows;
    let determinant = a * d - b * c;
    let x = [(right[0] * d - b * right[1]) / determinant, (a * right[1] - right[0] * c) / determinant];
    x.iter().all(|x| x.is_finite()).then_some(x)
}

/// The crossing of two parts, by Newton's method for A(s) = B(t) from the middle; `None` if it leads elsewhere.
fn newton(a: &[DVec3], b: &[DVec3], p: &Part, q: &Part) -> Option<[f64; 2]> {
    let (mut s, mut t) = (0.5 * (p.from + p.to), 0.5 * (q.from + q.to));
    for _ in 0..30 {
        let ([at, u, _], [bt, v, _]) = (jet(a, s), jet(b, t));
        let gap = bt - at;
        let [ds, dt] = solve([[u.x, -v.x], [u.y, -v.y]], [gap.x, gap.y])?;
        let (next_s, next_t) = ((s + ds).clamp(p.from, p.to), (t + dt).clamp(q.from, q.to));
        let moved = (next_s - s).abs().max((next_t - t).abs());
        (s, t) = (next_s, next_t);
        if moved <= 2.0 * f64::EPSILON {
            break;
        }
    }
    let near = segment::point(a, s).distance(segment::point(b, t)) <= 4.0 * SLACK;
    near.then(|| [s, t].map(snap))
}

/// An end, if it is one but for rounding.
fn snap(t: f64) -> f64 {
    if t < 1e-14 {
        0.0
    } else if t > 1.0 - 1e-14 {
        1.0
    } else {
        t
    }
}

/// Where two short parts touch: A' x B' = 0 and (A - B) . A' = 0 by Newton's method, or else the nearest points by turns.
fn touch(a: &[DVec3], b: &[DVec3], p: &Part, q: &Part) -> Option<[f64; 2]> {
    let start = [0.5 * (p.from + p.to), 0.5 * (q.from + q.to)];
    let reach = 8.0 * (p.to - p.from).max(q.to - q.from);
    let common = |s: f64, t: f64| segment::point(a, s).distance(segment::point(b, t)) <= COMMON;
    let [mut s, mut t] = start;
    for _ in 0..8 {
        let ([at, u, u2], [bt, v, v2]) = (jet(a, s), jet(b, t));
        let gap = at - bt;
        let rows = [[u2.perp_dot_xy(v), u.perp_dot_xy(v2)], [u.dot(u) + gap.dot(u2), -v.dot(u)]];
        let Some([ds, dt]) = solve(rows, [-u.perp_dot_xy(v), -gap.dot(u)]) else { break };
        (s, t) = ((s + ds).clamp(0.0, 1.0), (t + dt).clamp(0.0, 1.0));
    }
    if (s - start[0]).abs().max((t - start[1]).abs()) <= reach && common(s, t) {
        return Some([snap(s), snap(t)]);
    }
    let [mut s, mut t] = start;
    for _ in 0..4 {
        t = nearest_on(b, segment::point(a, s)).0;
        s = nearest_on(a, segment::point(b, t)).0;
    }
    let stays = (s - start[0]).abs().max((t - start[1]).abs()) <= reach;
    (stays && common(s, t)).then(|| [snap(s), snap(t)])
}

/// The common parts of segments that lie on the same curve.
fn overlaps(a: &[DVec3], b: &[DVec3], found: &mut Vec<[[f64; 2]; 2]>) -> Result<()> {
    let mut ends = [[0.0; 2]; 4];
    let mut len = 0;
    let mut offer = |s: f64, t: f64| {
        ends[len] = [s, t];
        len += 1;
    };
    for (end, t) in [(b[0], 0.0), (b[b.len() - 1], 1.0)] {
        let (s, squared) = nearest_on(a, end);
        if squared <= COMMON * COMMON {
            offer(s, t);
        }
    }
    for (end, s) in [(a[0], 0.0), (a[a.len() - 1], 1.0)] {
        let (t, squared) = nearest_on(b, end);
        if squared <= COMMON * COMMON {
            offer(s, t);
        }
    }
    let ends = &mut ends[..len];
    ends.sort_by(|x, y| x[0].total_cmp(&y[0]));
    // More than n m points in common; beyond 64 one may well believe it.
    let samples = ((a.len() - 1) * (b.len() - 1)).min(64) + 1;
    for pair in ends.windows(2) {
        let ([s, t], [s1, t1]) = (pair[0], pair[1]);
        if s1 - s <= 4.0 * SAME {
            continue;
        }
        let common = (1..=samples).all(|k| {
            let x = s + (s1 - s) * k as f64 / (samples + 1) as f64;
            nearest_on(b, segment::point(a, x)).1 <= COMMON * COMMON
        });
        if common {
            alloc::push(found, [[s, s1], [t, t1]])?;
        }
    }
    Ok(())
}

/// Whether no two points of the segment coincide: all legs of its control polygon advance along its chord.
pub(super) fn advances(controls: &[DVec3]) -> bool {
    let chord = controls[controls.len() - 1] - controls[0];
    legs(controls).all(|leg| leg.dot(chord) > 0.0)
}
