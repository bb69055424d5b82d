//! The equation A(s, t) = B(u, v) over a pair of cells: its values and derivatives, and Newton's method.

use crate::carcass::Patch;
use glam::{DVec3, DVec4};

/// Two patches. Parameters are those of the cells: (s, t) of A, then (u, v) of B.
pub(super) struct Equation<const N: usize, const M: usize> {
    pub(super) a: Patch<N>,
    pub(super) b: Patch<M>,
}

/// A - B at some parameters, and its derivatives.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    /// A - B.
    pub(super) miss: DVec3,
    /// A_s, A_t, -B_u, -B_v.
    pub(super) columns: [DVec3; 4],
}

/// The other three of four.
pub(super) const OTHERS: [[usize; 3]; 4] = [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]];

/// Steps of Newton's method.
const STEPS: usize = 16;

impl Frame {
    /// N_A and N_B, as long as the cells' areas.
    pub(super) fn normals(&self) -> [DVec3; 2] {
        let [a, b, c, d] = self.columns;
        [a.cross(b), c.cross(d)]
    }

    /// The direction in which A = B goes on, by parameters: that of N_A x N_B in space. It solves A_s s' + A_t t' = B_u u' + B_v v', as
    /// (A_s x A_t) x N_B = A_t (A_s . N_B) - A_s (A_t . N_B).
    pub(super) fn tangent(&self) -> DVec4 {
        let ([a, b], [s, t, u, v]) = (self.normals(), self.columns);
        DVec4::new(-t.dot(b), s.dot(b), -v.dot(a), u.dot(a))
    }

    /// The direction in space, N_A x N_B.
    pub(super) fn direction(&self) -> DVec3 {
        let [a, b] = self.normals();
        a.cross(b)
    }

    /// Newton's step with one of the parameters fixed.
    fn step(&self, fixed: usize) -> DVec4 {
        let [i, j, k] = OTHERS[fixed];
        let [x, y, z] = [i, j, k].map(|n| self.columns[n]);
        let (yz, zx, xy) = (y.cross(z), z.cross(x), x.cross(y));
        let factor = 1.0 / x.dot(yz);
        let mut step = DVec4::ZERO;
        step[i] = self.miss.dot(yz) * factor;
        step[j] = self.miss.dot(zx) * factor;
        step[k] = self.miss.dot(xy) * factor;
        step
    }
}

/// The Bernstein polynomials of degree N - 1 at t, and their derivatives.
#[inline(always)]
fn weights<const N: usize>(t: f64) -> [[f64; N]; 2] {
    let (mut value, mut slope) = ([0.0; N], [0.0; N]);
    value[0] = 1.0;
    for degree in 1..N {
        if degree == N - 1 {
            for k in 0..N {
                let before = if k > 0 { value[k - 1] } else { 0.0 };
                slope[k] = degree as f64 * (before - value[k]);
            }
        }
        for k in (1..=degree).rev() {
            value[k] = (1.0 - t) * value[k] + t * value[k - 1];
        }
        value[0] *= 1.0 - t;
    }
    [value, slope]
}

/// Point and first derivatives.
#[inline(always)]
fn tangents<const N: usize>(patch: &Patch<N>, u: f64, v: f64) -> [DVec3; 3] {
    let ([along_u, slope_u], [along_v, slope_v]) = (weights::<N>(u), weights::<N>(v));
    let mut sums = [DVec3::ZERO; 3];
    for (a, row) in patch.points.iter().enumerate() {
        let (mut value, mut slope) = (DVec3::ZERO, DVec3::ZERO);
        for (b, &point) in row.iter().enumerate() {
            value += along_v[b] * point;
            slope += slope_v[b] * point;
        }
        sums[0] += along_u[a] * value;
        sums[1] += slope_u[a] * value;
        sums[2] += along_u[a] * slope;
    }
    sums
}

impl<const N: usize, const M: usize> Equation<N, M> {
    pub(super) fn frame(&self, x: DVec4) -> Frame {
        let ([p, s, t], [q, u, v]) = (tangents(&self.a, x.x, x.y), tangents(&self.b, x.z, x.w));
        Frame { miss: p - q, columns: [s, t, -u, -v] }
    }

    /// The solution near `start` with parameter `fixed` as it is there, and the derivatives next to it; `None` if Newton's method does not
    /// converge.
    pub(super) fn solve(&self, start: DVec4, fixed: usize) -> Option<(DVec4, Frame)> {
        let (mut x, mut last) = (start, f64::INFINITY);
        for _ in 0..STEPS {
            let frame = self.frame(x);
            let step = frame.step(fixed);
            let length = step.abs().max_element();
            // Far outside the cells the polynomials say nothing.
            if !(length < 4.0) {
                return None;
            }
            x -= step;
            // The step after this one would be about the square of it, or rounding.
            if length < 1e-9 || (length < 1e-7 && length > 0.25 * last) {
                return Some((x, frame));
            }
            last = length;
        }
        None
    }

    /// The point of A, between A and B where they differ by rounding.
    pub(super) fn point(&self, x: DVec4) -> DVec3 {
        tangents(&self.a, x.x, x.y)[0]
    }
}
