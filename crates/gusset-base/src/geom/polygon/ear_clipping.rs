//! Ear clipping of a polygon in the plane.
//!
//! An ear is a convex corner whose triangle with its neighbours holds no other part of the polygon;
//! every simple polygon of four or more corners has two ears (G. Meisters, *Polygons have ears*,
//! 1975). The shortest ear is cut off first, so that `n` corners always give `n - 2` triangles.
//! Signs are exact (J. Shewchuk, *Adaptive precision floating-point arithmetic*, 1997). Corners at
//! equal positions are allowed, and so are edges that are passed twice: a keyhole. Where no ear is
//! left, because the polygon crosses itself or has no area, weaker rules choose a corner.
//!
//! Only corners that are not convex can lie in an ear; a grid finds them. Tests are limited to a
//! number for each corner. If they run out, the rest of the polygon is cut without tests.

use super::reflex_grid::ReflexGrid;
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use glam::{DVec2, DVec3};
use robust::{Coord, orient2d};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Tests of a corner against a corner or a row of cells, for each corner of the polygon, before the
/// rest is cut without tests.
const MAX_TESTS_PER_CORNER: u64 = 1000;
/// Largest height of a triangle, relative to its longest side, that may come from rounding.
const MAX_THIN_HEIGHT: f64 = 1e-9;
/// Tests between two progress reports.
const TESTS_PER_REPORT: u64 = 1 << 16;

/// Rules for the next corner, from the one that keeps triangles apart to the one that any corner
/// fulfils.
#[derive(Clone, Copy, PartialEq)]
enum EarRule {
    /// The corner is convex and its triangle is not thin. No other part of the polygon is in the
    /// triangle, on its border, or so near that rounding may have moved it out. Or the corner repeats
    /// a neighbour, so that nothing changes without it.
    Clear,
    /// The corner is convex, and no other part of the polygon is in its triangle or on the
    /// triangle's border.
    Apart,
    /// The corner is convex, and nothing is inside its triangle.
    Touching,
    /// The corner is on a line with its neighbours.
    Flat,
    /// The corner is convex.
    Convex,
    /// Any corner.
    Any,
}

impl EarRule {
    fn weakened(self) -> Option<Self> {
        match self {
            Self::Clear => Some(Self::Apart),
            Self::Apart => Some(Self::Touching),
            Self::Touching => Some(Self::Flat),
            Self::Flat => Some(Self::Convex),
            Self::Convex => Some(Self::Any),
            Self::Any => None,
        }
    }
}

/// Triangulates a polygon. `flat` are its corners projected to a plane, anticlockwise; the lengths
/// of diagonals are measured between `points`. Skips each diagonal (u, v) with `is_taken(u, v)`. Returns
/// `None` if every remaining ear has a taken edge, or if there are fewer than three corners.
///
/// O(n log n) for n corners, plus at most a fixed number of tests a corner; linear memory, about
/// 150 bytes a corner.
///
/// # Errors
/// [`Error::OutOfMemory`](crate::Error::OutOfMemory), [`Error::Cancelled`](crate::Error::Cancelled).
pub fn clip_ears(
    points: &[DVec3],
    flat: &[DVec2],
    is_taken: &dyn Fn(u32, u32) -> bool,
    job: &Job<'_>,
) -> Result<Option<Vec<[u32; 3]>>> {
    let n = flat.len();
    if n < 3 {
        return Ok(None);
    }
    let mut clipper = EarClipper::new(points, flat)?;
    let mut triangles = alloc::with_capacity(n - 2)?;
    // Shortest ear first. Outdated entries are skipped when they are popped.
    let mut ears = BinaryHeap::from(alloc::with_capacity(4 * n)?);
    let mut rule = EarRule::Clear;
    let max_tests = MAX_TESTS_PER_CORNER * n as u64;
    let mut next_report = TESTS_PER_REPORT;
    while triangles.len() + 3 < n {
        ears.clear();
        ears.extend((0..n as u32).filter(|&v| clipper.is_in_ring(v)).map(|v| Reverse(clipper.ear_with_size(v))));
        clipper.tests += (n - triangles.len()) as u64;
        let before = triangles.len();
        while let (Some(Reverse((_, ear))), true) = (ears.pop(), triangles.len() + 3 < n) {
            if clipper.tests >= next_report {
                next_report = clipper.tests + TESTS_PER_REPORT;
                job.step(triangles.len() as f64 / n as f64, "triangulating")?;
            }
            if clipper.tests >= max_tests && rule != EarRule::Any {
                break;
            }
            clipper.tests += 1;
            let [a, b, c] = ear;
            let stale = !clipper.is_in_ring(b) || clipper.ear(b) != ear;
            if stale || is_taken(a, c) || !clipper.fulfils(ear, rule) {
                continue;
            }
            triangles.push(ear);
            clipper.cut_off(ear);
            if rule != EarRule::Clear && clipper.tests < max_tests {
                break;
            }
            ears.extend([a, c].map(|v| Reverse(clipper.ear_with_size(v))));
        }
        rule = if clipper.tests >= max_tests && rule != EarRule::Any {
            EarRule::Any
        } else if triangles.len() > before {
            EarRule::Clear
        } else if let Some(weaker) = rule.weakened() {
            weaker
        } else {
            return Ok(None);
        };
    }
    let last = (0..n as u32).find(|&v| clipper.is_in_ring(v));
    triangles.extend(last.map(|v| clipper.ear(v)));
    Ok(Some(triangles))
}

fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    let [a, b, c] = [a, b, c].map(|point| Coord { x: point.x, y: point.y });
    orient2d(a, b, c)
}

pub(super) fn longest_squared_side([a, b, c]: [DVec2; 3]) -> f64 {
    a.distance_squared(b).max(b.distance_squared(c)).max(c.distance_squared(a))
}

/// Returns whether a triangle runs anticlockwise and is not thin.
pub(super) fn is_clearly_convex([a, b, c]: [DVec2; 3], longest: f64) -> bool {
    turn(a, b, c) > MAX_THIN_HEIGHT * longest
}

/// Remaining corners as a ring, and the reflex corners among them.
struct EarClipper<'a> {
    points: &'a [DVec3],
    flat: &'a [DVec2],
    previous: Vec<u32>,
    /// A corner that was cut off is its own successor.
    next: Vec<u32>,
    /// True for remaining corners that are not clearly convex.
    is_reflex: Vec<bool>,
    grid: ReflexGrid,
    /// The number of tests so far.
    tests: u64,
}

impl<'a> EarClipper<'a> {
    fn new(points: &'a [DVec3], flat: &'a [DVec2]) -> Result<Self> {
        let n = flat.len();
        let previous = alloc::collect((0..n).map(|v| ((v + n - 1) % n) as u32))?;
        let next = alloc::collect((0..n).map(|v| ((v + 1) % n) as u32))?;
        let is_reflex = alloc::collect((0..n).map(|v| {
            let corners = [flat[(v + n - 1) % n], flat[v], flat[(v + 1) % n]];
            !is_clearly_convex(corners, longest_squared_side(corners))
        }))?;
        let grid = ReflexGrid::new(flat, &is_reflex)?;
        Ok(Self { points, flat, previous, next, is_reflex, grid, tests: 0 })
    }

    fn is_in_ring(&self, v: u32) -> bool {
        self.next[v as usize] != v
    }

    /// Returns a corner between its neighbours.
    fn ear(&self, v: u32) -> [u32; 3] {
        [self.previous[v as usize], v, self.next[v as usize]]
    }

    /// Returns the ear at `v` after the bits of its squared length, which sort like the lengths.
    fn ear_with_size(&self, v: u32) -> (u64, [u32; 3]) {
        let ear = self.ear(v);
        (self.points[ear[0] as usize].distance_squared(self.points[ear[2] as usize]).to_bits(), ear)
    }

    fn corners(&self, ear: [u32; 3]) -> [DVec2; 3] {
        ear.map(|v| self.flat[v as usize])
    }

    fn fulfils(&mut self, ear: [u32; 3], rule: EarRule) -> bool {
        let [a, b, c] = self.corners(ear);
        match rule {
            EarRule::Clear => {
                let longest = longest_squared_side([a, b, c]);
                let is_ear = is_clearly_convex([a, b, c], longest)
                    && !self.is_blocked(ear, |turn| turn >= -MAX_THIN_HEIGHT * longest);
                a == b || b == c || is_ear
            }
            EarRule::Apart => turn(a, b, c) > 0.0 && !self.is_blocked(ear, |turn| turn >= 0.0),
            EarRule::Touching => turn(a, b, c) > 0.0 && !self.is_blocked(ear, |turn| turn > 0.0),
            EarRule::Flat => turn(a, b, c) == 0.0,
            EarRule::Convex => turn(a, b, c) > 0.0,
            EarRule::Any => true,
        }
    }

    /// Returns whether a part of the polygon is in an ear: on the inner side of all edges, by
    /// `is_inside` of the turns.
    fn is_blocked(&mut self, ear: [u32; 3], is_inside: impl Fn(f64) -> bool) -> bool {
        let corners = self.corners(ear);
        let [a, b, c] = corners;
        let margin = MAX_THIN_HEIGHT * longest_squared_side(corners).sqrt();
        let (low, high) = (a.min(b).min(c) - margin, a.max(b).max(c) + margin);
        let mut tests = 0;
        let mut rows = self.grid.rows_between(low.y, high.y);
        let found = rows.any(|row| {
            let near = self.grid.corners_in_row(row, corners);
            tests += 1 + near.len();
            near.iter().any(|&other| {
                let point = self.flat[other as usize];
                self.is_reflex[other as usize]
                    && point.cmpge(low).all()
                    && point.cmple(high).all()
                    && self.blocks(other, ear, &is_inside)
            })
        });
        self.tests += tests as u64;
        found
    }

    fn blocks(&self, other: u32, ear: [u32; 3], is_inside: impl Fn(f64) -> bool) -> bool {
        let ([a, tip, b], point) = (self.corners(ear), self.flat[other as usize]);
        if point == a || point == b {
            // An edge from there into the triangle ends at a corner inside.
            return false;
        }
        if point == tip {
            // The edges from there may cross the triangle without a corner inside.
            return other != ear[1]
                && [self.previous[other as usize], self.next[other as usize]].iter().any(|&end| {
                    let end = self.flat[end as usize];
                    turn(a, tip, end) > 0.0 && turn(tip, b, end) > 0.0
                });
        }
        is_inside(turn(a, tip, point)) && is_inside(turn(tip, b, point)) && is_inside(turn(b, a, point))
    }

    /// Takes the tip of an ear out of the ring.
    fn cut_off(&mut self, [a, tip, b]: [u32; 3]) {
        self.next[a as usize] = b;
        self.previous[b as usize] = a;
        self.next[tip as usize] = tip;
        self.is_reflex[tip as usize] = false;
        for neighbour in [a, b] {
            if self.is_reflex[neighbour as usize] {
                let corners = self.corners(self.ear(neighbour));
                self.is_reflex[neighbour as usize] = !is_clearly_convex(corners, longest_squared_side(corners));
            }
        }
    }
}
