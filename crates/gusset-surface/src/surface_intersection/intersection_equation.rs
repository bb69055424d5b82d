//! The equation A(s, t) = B(u, v) over a pair of cells: values, derivatives and Newton's method.
//!
//! Cost: O(N^2 + M^2) for an evaluation.

use super::coordinate_net::CoordinateNet;
use glam::{DVec2, DVec3, DVec4};

/// Two patches. The parameters are (s, t) of A, then (u, v) of B, in their cells.
#[derive(Clone)]
pub(super) struct IntersectionEquation<const N: usize, const M: usize> {
    pub(super) a: CoordinateNet<N>,
    pub(super) b: CoordinateNet<M>,
}

/// A - B at given parameters, and its derivatives.
#[derive(Debug, Clone, Copy)]
pub(super) struct DifferenceFrame {
    /// A - B.
    pub(super) difference: DVec3,
    /// A_s, A_t, -B_u, -B_v.
    pub(super) derivatives: [DVec3; 4],
}

/// For each of the four parameters, the other three.
pub(super) const OTHER_PARAMETERS: [[usize; 3]; 4] = [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]];

/// Largest number of Newton steps.
const MAX_NEWTON_STEPS: usize = 16;
/// A first step shorter than this, in parameters of the cells, marks a good guess.
const MAX_FIRST_STEP_OF_GOOD_GUESS: f64 = 1e-3;

impl DifferenceFrame {
    /// N_A and N_B, not normalised.
    pub(super) fn normals(&self) -> [DVec3; 2] {
        let [a, b, c, d] = self.derivatives;
        [a.cross(b), c.cross(d)]
    }

    /// The direction of the curve A = B in parameters; in space it is N_A x N_B. It solves A_s s' +
    /// A_t t' = B_u u' + B_v v', because (A_s x A_t) x N_B = A_t (A_s . N_B) - A_s (A_t . N_B).
    pub(super) fn parameter_tangent(&self) -> DVec4 {
        let ([a, b], [s, t, u, v]) = (self.normals(), self.derivatives);
        DVec4::new(-t.dot(b), s.dot(b), -v.dot(a), u.dot(a))
    }

    /// The direction N_A x N_B of the curve in space.
    pub(super) fn curve_direction(&self) -> DVec3 {
        let [a, b] = self.normals();
        a.cross(b)
    }

    /// Whether the normals are far from parallel.
    pub(super) fn is_transversal(&self) -> bool {
        let [a, b] = self.normals();
        a.cross(b).length() > 0.3 * a.length() * b.length()
    }

    /// The step to the solution nearest to another point, which is `offset` from A.
    ///
    /// It combines two steps. The first leads to A = B, with the parameter fixed along which the
    /// curve mainly runs. The second leads along the curve as along a line.
    pub(super) fn step_towards_point(&self, offset: DVec3) -> DVec4 {
        let (tangent, direction) = (self.parameter_tangent(), self.curve_direction());
        let fixed = (0..4).fold(0, |best, k| if tangent[k].abs() > tangent[best].abs() { k } else { best });
        let back = newton_step(&self.inverse_with_fixed_parameter(fixed), self.difference, fixed);
        let left = offset + self.derivatives[0] * back.x + self.derivatives[1] * back.y;
        left.dot(direction) / direction.length_squared() * tangent - back
    }

    /// The step of two parameters of one surface, `first_moved` and the next one, that brings it
    /// nearest to the other surface's point.
    pub(super) fn step_to_other_surface(&self, first_moved: usize) -> DVec2 {
        let [p, q] = [self.derivatives[first_moved], self.derivatives[first_moved + 1]];
        let (pp, pq, qq) = (p.length_squared(), p.dot(q), q.length_squared());
        let (f, g) = (self.difference.dot(p), self.difference.dot(q));
        DVec2::new(g * pq - f * qq, f * pq - g * pp) / (pp * qq - pq * pq)
    }

    /// Returns the change of parameter k per length of A - B if parameter `fixed` is constant.
    pub(super) fn parameter_change_per_miss(&self, k: usize, fixed: usize) -> f64 {
        let rows = self.inverse_with_fixed_parameter(fixed);
        OTHER_PARAMETERS[fixed].iter().zip(rows).find(|(other, _)| **other == k).map_or(0.0, |(_, row)| row.length())
    }

    /// Rows of the inverse of the derivatives with respect to the three parameters other than
    /// `fixed`.
    fn inverse_with_fixed_parameter(&self, fixed: usize) -> [DVec3; 3] {
        let [x, y, z] = OTHER_PARAMETERS[fixed].map(|n| self.derivatives[n]);
        let (yz, zx, xy) = (y.cross(z), z.cross(x), x.cross(y));
        let factor = 1.0 / x.dot(yz);
        [factor * yz, factor * zx, factor * xy]
    }
}

/// The Newton step, from the inverse of the derivatives with one parameter fixed.
fn newton_step(inverse: &[DVec3; 3], miss: DVec3, fixed: usize) -> DVec4 {
    let mut step = DVec4::ZERO;
    for (&n, row) in OTHER_PARAMETERS[fixed].iter().zip(inverse) {
        step[n] = miss.dot(*row);
    }
    step
}

impl<const N: usize, const M: usize> IntersectionEquation<N, M> {
    pub(super) fn frame_at(&self, x: DVec4) -> DifferenceFrame {
        let ([p, s, t], [q, u, v]) = (self.a.point_and_tangents(x.x, x.y), self.b.point_and_tangents(x.z, x.w));
        DifferenceFrame { difference: p - q, derivatives: [s, t, -u, -v] }
    }

    /// Solves the equation near `start` with parameter `fixed` held constant. Returns the solution
    /// and the derivatives close to it, or `None` if Newton's method does not converge.
    pub(super) fn solve_with_fixed_parameter(&self, start: DVec4, fixed: usize) -> Option<(DVec4, DifferenceFrame)> {
        let (mut x, mut last) = (start, f64::INFINITY);
        for _ in 0..MAX_NEWTON_STEPS {
            let frame = self.frame_at(x);
            let step = newton_step(&frame.inverse_with_fixed_parameter(fixed), frame.difference, fixed);
            let length = step.abs().max_element();
            // Far outside the cells, the polynomials are meaningless.
            if !step.is_finite() || length > 4.0 {
                return None;
            }
            x -= step;
            // Convergence is quadratic: the next step would be about this one times the squared
            // ratio to the last. Otherwise only rounding remains.
            let ratio = length / last;
            let converged = last < f64::INFINITY && length * ratio * ratio < 1e-15;
            if converged || length < 1e-13 || (length < 1e-9 && ratio > 0.25) {
                return Some((x, frame));
            }
            last = length;
        }
        None
    }

    /// Solves the equation from a good guess. The derivatives hardly change after the first Newton
    /// step, so the second step needs only A - B.
    pub(super) fn refine_good_guess(&self, guess: DVec4, fixed: usize) -> Option<(DVec4, DifferenceFrame)> {
        let frame = self.frame_at(guess);
        let inverse = frame.inverse_with_fixed_parameter(fixed);
        let first = newton_step(&inverse, frame.difference, fixed);
        let length = first.abs().max_element();
        if length < MAX_FIRST_STEP_OF_GOOD_GUESS {
            let x = guess - first;
            let miss = self.a.point_at(x.x, x.y) - self.b.point_at(x.z, x.w);
            let second = newton_step(&inverse, miss, fixed);
            // The error decreases by the same factor in each step.
            let left = second.abs().max_element();
            if 4.0 * left * left <= 1e-15 * length || left < 1e-14 {
                return Some((x - second, frame));
            }
        }
        self.solve_with_fixed_parameter(guess, fixed)
    }

    /// The point of A. At a solution it equals the point of B except for rounding.
    pub(super) fn point_of_first_patch(&self, x: DVec4) -> DVec3 {
        self.a.point_at(x.x, x.y)
    }
}
