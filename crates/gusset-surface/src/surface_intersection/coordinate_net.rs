//! A patch stored by coordinates, so that operations on rows of control points work on rows of
//! numbers.

use crate::Patch;
use crate::subdivision::BernsteinField;
use glam::DVec3;
use gusset_base::geom::bernstein::bernstein_values_and_slopes;

/// The fields of x, y and z.
#[derive(Debug, Clone)]
pub(super) struct CoordinateNet<const N: usize>([BernsteinField<N>; 3]);

/// The weighted sum of rows.
#[inline(always)]
fn weighted_row_sum<const N: usize>(rows: &[[f64; N]; N], weights: &[f64; N]) -> [f64; N] {
    let mut sum = [0.0; N];
    for (row, weight) in rows.iter().zip(weights) {
        sum.iter_mut().zip(row).for_each(|(sum, x)| *sum += weight * x);
    }
    sum
}

#[inline(always)]
fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).fold(0.0, |sum, (x, y)| sum + x * y)
}

impl<const N: usize> CoordinateNet<N> {
    pub(super) const ZERO: Self = CoordinateNet([BernsteinField { coefficients: [[0.0; N]; N] }; 3]);

    /// Creates the net of a patch relative to an origin. Also returns the largest absolute
    /// coordinate before and after the shift.
    pub(super) fn new(patch: &Patch<N>, origin: DVec3) -> (Self, f64) {
        let (mut net, mut largest) = (CoordinateNet::ZERO, DVec3::ZERO);
        let [x, y, z] = &mut net.0;
        for (a, row) in patch.points.iter().enumerate() {
            for (b, &before) in row.iter().enumerate() {
                let point = before - origin;
                (x.coefficients[a][b], y.coefficients[a][b], z.coefficients[a][b]) = (point.x, point.y, point.z);
                largest = largest.max(before.abs()).max(point.abs());
            }
        }
        (net, largest.max_element())
    }

    pub(super) fn to_patch(&self) -> Patch<N> {
        let point = |a: usize, b: usize| DVec3::from_array(std::array::from_fn(|k| self.0[k].coefficients[a][b]));
        Patch { points: std::array::from_fn(|a| std::array::from_fn(|b| point(a, b))) }
    }

    /// Evaluates the point at (u, v).
    #[inline]
    pub(super) fn point_at(&self, u: f64, v: f64) -> DVec3 {
        let ([of_u, _], [of_v, _]) = (bernstein_values_and_slopes::<N>(u), bernstein_values_and_slopes::<N>(v));
        let [x, y, z] = &self.0;
        DVec3::from_array([x, y, z].map(|field| dot(&weighted_row_sum(&field.coefficients, &of_u), &of_v)))
    }

    /// Evaluates the point and the first derivatives.
    #[inline(always)]
    pub(super) fn point_and_tangents(&self, u: f64, v: f64) -> [DVec3; 3] {
        let ([of_u, slope_u], [of_v, slope_v]) =
            (bernstein_values_and_slopes::<N>(u), bernstein_values_and_slopes::<N>(v));
        let mut jet = [DVec3::ZERO; 3];
        for (k, field) in self.0.iter().enumerate() {
            let (values, slopes) =
                (weighted_row_sum(&field.coefficients, &of_u), weighted_row_sum(&field.coefficients, &slope_u));
            jet[0][k] = dot(&values, &of_v);
            jet[1][k] = dot(&slopes, &of_v);
            jet[2][k] = dot(&values, &slope_v);
        }
        jet
    }

    /// The component of the net along a direction.
    #[inline]
    pub(super) fn component_along(&self, axis: DVec3) -> BernsteinField<N> {
        let mut c = self.0[0].coefficients;
        let [_, y, z] = &self.0;
        for (row, (y, z)) in c.iter_mut().zip(y.coefficients.iter().zip(&z.coefficients)) {
            for (x, (y, z)) in row.iter_mut().zip(y.iter().zip(z)) {
                *x = axis.x * *x + axis.y * y + axis.z * z;
            }
        }
        BernsteinField { coefficients: c }
    }

    /// The halves at u = 1/2.
    pub(super) fn halves(&self) -> [Self; 2] {
        let [x, y, z] = [0, 1, 2].map(|k| self.0[k].halves());
        [0, 1].map(|half| CoordinateNet([x[half], y[half], z[half]]))
    }

    /// The net with u and v exchanged.
    pub(super) fn transposed(&self) -> Self {
        CoordinateNet([0, 1, 2].map(|k| self.0[k].transposed()))
    }
}
