//! The unknowns of a piecewise curve, one of each for every point of a subcurve, and the memory to
//! solve for them in.

use super::subcurve::Subcurve;
use crate::alloc;
use crate::error::Result;
use glam::DVec3;

/// Parameters, joint parameters and control points of a composite curve; other curves use the lists
/// for their own unknowns.
#[derive(Default)]
pub(super) struct Solution {
    /// The parameter of each point on its section.
    pub(super) t: Vec<f64>,
    /// The parameter by the data's own triangle, to fall back to.
    pub(super) data_t: Vec<f64>,
    /// The joint parameter beta_i behind section i; empty if all are 1/2.
    pub(super) beta: Vec<f64>,
    /// The control points B_i.
    pub(super) controls: Vec<DVec3>,
    /// The factors of the elimination.
    pub(super) upper: Vec<f64>,
    /// Those of the last unknown, in a cyclic system.
    pub(super) across: Vec<f64>,
}

impl Solution {
    /// Makes room for `n` points.
    pub(super) fn resize(&mut self, n: usize) -> Result<()> {
        for list in [&mut self.t, &mut self.data_t, &mut self.upper, &mut self.across] {
            alloc::grow(list, n, 0.0)?;
        }
        alloc::grow(&mut self.controls, n, DVec3::ZERO)
    }

    /// Sets all joint parameters to 1/2.
    pub(super) fn reset_joints(&mut self, n: usize) -> Result<()> {
        alloc::reset(&mut self.beta, n, 0.5)
    }

    /// beta_i, the joint parameter behind section `i`: 0 and 1 where a section itself begins or
    /// ends the subcurve.
    #[inline]
    pub(super) fn joint_parameter(&self, sub: &Subcurve<'_>, i: usize) -> f64 {
        let outer = !sub.closed && (i == 0 || i + 2 == sub.len());
        match (outer, sub.tangents) {
            (true, [None, _]) if i == 0 => 0.0,
            (true, [_, None]) if i > 0 || sub.len() == 2 => 1.0,
            _ if outer || self.beta.is_empty() => 0.5,
            _ => self.beta[i],
        }
    }

    /// J_i, the joint behind section `i`; the ends of an open subcurve are joints too.
    #[inline]
    pub(super) fn joint(&self, sub: &Subcurve<'_>, i: usize) -> DVec3 {
        let (last, next) = (sub.len() - 1, sub.next(i));
        if !sub.closed {
            if i == 0 && sub.tangents[0].is_none() {
                return sub.points[0];
            }
            if next == last && sub.tangents[1].is_none() {
                return sub.points[last];
            }
        }
        let half = self.beta.is_empty() || (!sub.closed && (i == 0 || next == last));
        let beta = if half { 0.5 } else { self.beta[i] };
        self.controls[i] + (self.controls[next] - self.controls[i]) * beta
    }
}
