//! The state that the iterations of composite curves share.

use crate::alloc;
use crate::error::Result;
use crate::outline::identify::solution::Solution;
use crate::outline::identify::subcurve::Subcurve;
use glam::DVec3;

/// One of each for every point of the subcurve.
#[derive(Default)]
pub(super) struct Iteration {
    /// The joint parameters, the ends of an open subcurve included.
    pub(super) beta: Vec<f64>,
    /// Whether a point has fallen back to the parameter by the data's own triangle.
    pub(super) fell_back: Vec<bool>,
    /// Whether the section did not cross the guide of its point when it was last placed.
    pub(super) missed_guide: Vec<bool>,
    /// The direction of the guide through a point, of length 1; 0 where there is none.
    pub(super) guides: Vec<DVec3>,
    /// The control points before an iteration.
    pub(super) previous: Vec<DVec3>,
}

impl Iteration {
    /// Enters the joint parameters of a subcurve; no point has fallen back.
    pub(super) fn begin(&mut self, sub: &Subcurve<'_>, solution: &Solution) -> Result<()> {
        let n = sub.len();
        self.beta.clear();
        alloc::extend(&mut self.beta, (0..n).map(|i| solution.joint_parameter(sub, i)))?;
        alloc::reset(&mut self.fell_back, n, false)?;
        alloc::reset(&mut self.missed_guide, n, false)?;
        self.previous.clear();
        alloc::reserve(&mut self.previous, n)
    }

    /// Keeps the control points as they are before an iteration.
    pub(super) fn remember(&mut self, sub: &Subcurve<'_>, solution: &Solution) {
        self.previous.clear();
        self.previous.extend_from_slice(&solution.controls[..sub.len()]);
    }

    /// The control point of section `i`, and its first and last joint, seen from its point.
    #[inline(always)]
    pub(super) fn legs(&self, sub: &Subcurve<'_>, solution: &Solution, i: usize) -> [DVec3; 3] {
        let (previous, next) = (sub.previous(i), sub.next(i));
        let p = sub.points[i];
        let [a, b, c] = [previous, i, next].map(|k| solution.controls[k] - p);
        [b, a + (b - a) * self.beta[previous], b + (c - b) * self.beta[i]]
    }
}
