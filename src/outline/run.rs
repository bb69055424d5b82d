//! A run: an outline, or the part of one between two points where it is cut, in coordinates of its own.

use super::consistent::Newton;
use super::curvature::Shares;
use super::curve::Place;
use super::request::PointStatus;
use super::single::Single;
use crate::alloc;
use crate::error::Result;
use glam::DVec3;

/// The points that one system of equations is about, near the origin and of a size near 1.
#[derive(Clone, Copy)]
pub(super) struct Run<'a> {
    /// No two neighbours are the same. At least 3 if closed, else at least 2.
    pub(super) points: &'a [DVec3],
    pub(super) closed: bool,
    /// Directions, of length 1, in which an open run begins and ends.
    pub(super) tangents: [Option<DVec3>; 2],
    /// The longest side of the outline's box.
    pub(super) size: f64,
}

impl Run<'_> {
    /// The number of sections: one for each point that is no end.
    pub(super) fn sections(&self) -> std::ops::Range<usize> {
        if self.closed { 0..self.points.len() } else { 1..self.points.len() - 1 }
    }

    /// The three points of section `i`.
    #[inline]
    pub(super) fn triple(&self, i: usize) -> [DVec3; 3] {
        let n = self.points.len();
        let before = if i == 0 { n - 1 } else { i - 1 };
        let after = if i + 1 == n { 0 } else { i + 1 };
        [self.points[before], self.points[i], self.points[after]]
    }

    /// The control points next to the ends where tangents are given: a third of the way to the next point along the tangent,
    /// as on a straight line of even speed; a quarter if the next point is the other end and both have tangents, half if
    /// only one has.
    pub(super) fn end_controls(&self) -> [Option<DVec3>; 2] {
        let last = self.points.len() - 1;
        let share = match (last, self.tangents) {
            (1, [Some(_), Some(_)]) => 0.25,
            (1, _) => 0.5,
            _ => 1.0 / 3.0,
        };
        let [start, end] = self.tangents;
        let lengths = [self.points[1].distance(self.points[0]), self.points[last].distance(self.points[last - 1])];
        [
            start.map(|tangent| self.points[0] + tangent * (share * lengths[0])),
            end.map(|tangent| self.points[last] - tangent * (share * lengths[1])),
        ]
    }
}

/// The unknowns of a composite curve and the workspace to find them in: one of each for every point of the run.
#[derive(Default)]
pub(super) struct Solution {
    /// The parameter of each point on its section.
    pub(super) t: Vec<f64>,
    /// The parameter by the data's own triangle, to fall back to.
    pub(super) given: Vec<f64>,
    /// The share beta_i of the joint behind section i; empty if all are 1/2.
    pub(super) beta: Vec<f64>,
    /// The control points B_i.
    pub(super) controls: Vec<DVec3>,
    /// The factors of the elimination.
    pub(super) upper: Vec<f64>,
    /// What a closed run has besides.
    pub(super) across: Vec<f64>,
}

impl Solution {
    /// Reserves memory for `n` points.
    pub(super) fn resize(&mut self, n: usize) -> Result<()> {
        for list in [&mut self.t, &mut self.given, &mut self.upper, &mut self.across] {
            if list.len() < n {
                let more = n - list.len();
                alloc::reserve(list, more)?;
                list.resize(n, 0.0);
            }
        }
        if self.controls.len() < n {
            let more = n - self.controls.len();
            alloc::reserve(&mut self.controls, more)?;
            self.controls.resize(n, DVec3::ZERO);
        }
        Ok(())
    }

    /// beta_i, the share of the joint behind section `i` of a run: 0 and 1 where a section itself begins or ends the run.
    #[inline]
    pub(super) fn share(&self, run: &Run<'_>, i: usize) -> f64 {
        let outer = !run.closed && (i == 0 || i + 2 == run.points.len());
        match (outer, run.tangents) {
            (true, [None, _]) if i == 0 => 0.0,
            (true, [_, None]) if i > 0 || run.points.len() == 2 => 1.0,
            _ if outer || self.beta.is_empty() => 0.5,
            _ => self.beta[i],
        }
    }

    /// J_i, the joint behind section `i` of a run; the ends of an open run are joints too.
    #[inline]
    pub(super) fn joint(&self, run: &Run<'_>, i: usize) -> DVec3 {
        let n = run.points.len();
        let next = if i + 1 == n { 0 } else { i + 1 };
        if !run.closed {
            let last = n - 1;
            if i == 0 && run.tangents[0].is_none() {
                return run.points[0];
            }
            if next == last && run.tangents[1].is_none() {
                return run.points[last];
            }
        }
        let plain = self.beta.is_empty() || (!run.closed && (i == 0 || next == n - 1));
        let beta = if plain { 0.5 } else { self.beta[i] };
        self.controls[i] + (self.controls[next] - self.controls[i]) * beta
    }
}

/// What came of a point.
#[derive(Clone, Copy)]
pub(super) struct Solved {
    pub(super) place: Place,
    pub(super) status: PointStatus,
}

impl Default for Solved {
    fn default() -> Self {
        Solved { place: Place { segment: 0, t: 0.0 }, status: PointStatus::Ok }
    }
}

/// What the solvers work in, used again for each run.
#[derive(Default)]
pub(super) struct Workspace {
    pub(super) solution: Solution,
    /// What the iterations of composite curves need besides.
    pub(super) iteration: Iteration,
    pub(super) flat: Newton<2>,
    pub(super) spatial: Newton<3>,
    pub(super) shares: Shares,
    pub(super) single: Single,
}

/// What the iterations share: one of each for every point of the run.
#[derive(Default)]
pub(super) struct Iteration {
    /// The shares of the joints, the ends of an open run included.
    pub(super) shares: Vec<f64>,
    /// Whether a point has fallen back to the parameter by the data's own triangle.
    pub(super) held: Vec<bool>,
    /// Whether a section did not cross the guide of its point when it was placed last.
    pub(super) lost: Vec<bool>,
    /// The direction of the guide through a point, of length 1; 0 where there is none.
    pub(super) guides: Vec<DVec3>,
    /// The control points before an iteration.
    pub(super) before: Vec<DVec3>,
}

impl Iteration {
    /// Enters the shares of a run, and lets go of all points.
    pub(super) fn begin(&mut self, run: &Run<'_>, solution: &Solution) -> Result<()> {
        let n = run.points.len();
        self.shares.clear();
        alloc::reserve(&mut self.shares, n)?;
        self.shares.extend((0..n).map(|i| solution.share(run, i)));
        for flags in [&mut self.held, &mut self.lost] {
            flags.clear();
            alloc::reserve(flags, n)?;
            flags.resize(n, false);
        }
        self.before.clear();
        alloc::reserve(&mut self.before, n)
    }
}

/// Gives a point a status, unless it has one.
pub(super) fn mark(solved: &mut Solved, status: PointStatus) {
    if solved.status == PointStatus::Ok {
        solved.status = status;
    }
}

/// The curve of an outline while it grows, near the origin.
#[derive(Default)]
pub(super) struct Sketch {
    pub(super) points: Vec<DVec3>,
    /// 0, then the place of the last control point of each segment.
    pub(super) ends: Vec<u32>,
    /// Joints that need not be smooth, by the number of segments before them, in ascending order.
    corners: Vec<u32>,
}

impl Sketch {
    pub(super) fn clear(&mut self) {
        self.points.clear();
        self.ends.clear();
        self.corners.clear();
        self.ends.push(0);
    }

    /// Where the curve begins, unless it has begun.
    pub(super) fn begin(&mut self, point: DVec3) -> Result<()> {
        match self.points.is_empty() {
            true => alloc::push(&mut self.points, point),
            false => Ok(()),
        }
    }

    /// Appends a segment by its control points but the first.
    #[inline]
    pub(super) fn push(&mut self, rest: &[DVec3]) -> Result<()> {
        alloc::append(&mut self.points, rest)?;
        alloc::push(&mut self.ends, (self.points.len() - 1) as u32)
    }

    /// Memory for the control points of `n` quadratic segments that are the whole curve, to be filled in.
    pub(super) fn closed_quadratics(&mut self, n: usize) -> Result<&mut [DVec3]> {
        self.clear();
        alloc::reserve(&mut self.points, 2 * n + 1)?;
        alloc::reserve(&mut self.ends, n)?;
        self.points.resize(2 * n + 1, DVec3::ZERO);
        self.ends.extend((1..=n as u32).map(|k| 2 * k));
        Ok(&mut self.points)
    }

    /// Says that the curve may turn sharply where it ends so far.
    pub(super) fn mark_corner(&mut self) -> Result<()> {
        let at = self.len() as u32;
        alloc::push(&mut self.corners, at)
    }

    /// The number of segments.
    pub(super) fn len(&self) -> usize {
        self.ends.len() - 1
    }

    pub(super) fn is_empty(&self) -> bool {
        self.len() == 0
    }

    pub(super) fn segment(&self, k: usize) -> &[DVec3] {
        &self.points[self.ends[k] as usize..=self.ends[k + 1] as usize]
    }

    pub(super) fn corners(&self) -> &[u32] {
        &self.corners
    }
}
