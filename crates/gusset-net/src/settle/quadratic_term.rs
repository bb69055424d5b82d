//! Terms of sums of squares.

use glam::DVec3;

/// weight / 2 |sum of factors times points - rest|^2.
#[derive(Clone, Copy)]
pub(super) struct QuadraticTerm {
    pub(super) points: [u32; 3],
    pub(super) factors: [f64; 3],
    pub(super) weight: f64,
    pub(super) rest_value: DVec3,
}

impl QuadraticTerm {
    /// Returns the term of the difference of two points.
    pub(super) fn from_edge(p: u32, q: u32, weight: f64, rest: DVec3) -> Self {
        QuadraticTerm { points: [p, q, q], factors: [1.0, -1.0, 0.0], weight, rest_value: rest }
    }

    pub(super) fn residual(&self, x: &[DVec3]) -> DVec3 {
        let sum = |sum: DVec3, j: usize| {
            if self.factors[j] == 0.0 { sum } else { sum + self.factors[j] * x[self.points[j] as usize] }
        };
        (0..3).fold(DVec3::ZERO, sum) - self.rest_value
    }
}
