//! Normals over a cell as polynomials. N = S_u x S_v has degree 2 n - 1 in each parameter, where n
//! is the degree of the patch. The angle with a direction follows without roots or divisions.
//!
//! The coefficients of a product are sums of products of coefficients, scaled by their binomials
//! (Farouki and Rajan 1988).

use crate::Patch;
use crate::ranges::cross_product_ranges;
use crate::subdivision::BernsteinField;
use glam::DVec3;
use gusset_base::geom::aabb::range_of_values;
use gusset_base::geom::bernstein::binomial_row;

/// Coefficients times their binomials.
type ScaledCoefficients<const M: usize> = [[f64; M]; M];

/// Adds the product a b to `sum`.
fn add_scaled_product<const A: usize, const M: usize>(
    a: &ScaledCoefficients<A>,
    b: &ScaledCoefficients<A>,
    sum: &mut ScaledCoefficients<M>,
) {
    for (i, row) in a.iter().enumerate() {
        for (j, &x) in row.iter().enumerate().filter(|&(_, &x)| x != 0.0) {
            for (sums, others) in sum[i..].iter_mut().zip(b) {
                for (sum, y) in sums[j..].iter_mut().zip(others) {
                    *sum += x * y;
                }
            }
        }
    }
}

/// The field with the given scaled coefficients of degree M - 1.
fn field_from_scaled_coefficients<const M: usize>(scaled: &ScaledCoefficients<M>) -> BernsteinField<M> {
    let by = const { binomial_row::<M>(M - 1) };
    let mut c = *scaled;
    for (row, a) in c.iter_mut().zip(by) {
        row.iter_mut().zip(by).for_each(|(x, b)| *x /= a * b);
    }
    BernsteinField { coefficients: c }
}

/// Coefficients multiplied by factors for rows and columns.
fn scale_coefficients<const N: usize>(
    c: &ScaledCoefficients<N>,
    by_u: &[f64; N],
    by_v: &[f64; N],
) -> ScaledCoefficients<N> {
    let mut scaled = *c;
    for (row, a) in scaled.iter_mut().zip(by_u) {
        row.iter_mut().zip(by_v).for_each(|(x, b)| *x *= a * b);
    }
    scaled
}

/// The control vectors of S_u and S_v of a patch along three directions. The unused last row or
/// column of a derivative is 0.
pub(super) struct Hodographs<const N: usize> {
    u: [[[f64; N]; N]; 3],
    v: [[[f64; N]; N]; 3],
}

impl<const N: usize> Hodographs<N> {
    pub(super) fn new(patch: &Patch<N>, frame: &[DVec3; 3]) -> Self {
        let degree = (N - 1) as f64;
        let p = &patch.points;
        let mut made = Hodographs { u: [[[0.0; N]; N]; 3], v: [[[0.0; N]; N]; 3] };
        for a in 0..N {
            for b in 0..N {
                if a + 1 < N {
                    let step = (p[a + 1][b] - p[a][b]) * degree;
                    (0..3).for_each(|k| made.u[k][a][b] = step.dot(frame[k]));
                }
                if b + 1 < N {
                    let step = (p[a][b + 1] - p[a][b]) * degree;
                    (0..3).for_each(|k| made.v[k][a][b] = step.dot(frame[k]));
                }
            }
        }
        made
    }

    /// Ranges of the three components of the normal, from the ranges of the components of S_u and
    /// S_v.
    pub(super) fn normal_component_ranges(&self) -> [[f64; 2]; 3] {
        let part = |of: &[[f64; N]; N], rows: usize, columns: usize| {
            range_of_values(of[..rows].iter().flat_map(|row| &row[..columns]).copied())
        };
        cross_product_ranges(
            self.u.each_ref().map(|of| part(of, N - 1, N)),
            self.v.each_ref().map(|of| part(of, N, N - 1)),
        )
    }

    /// Upper bounds of the lengths of S_u and S_v, from control vectors.
    pub(super) fn max_speeds(&self) -> [f64; 2] {
        [&self.u, &self.v].map(|of| {
            let square = |a: usize, b: usize| (0..3).map(|k| of[k][a][b] * of[k][a][b]).sum::<f64>();
            (0..N * N).map(|k| square(k / N, k % N)).fold(0.0, f64::max).sqrt()
        })
    }

    /// Component `k` of the normal S_u x S_v, as a field of degree 2 N - 3 for a patch of degree
    /// N - 1.
    pub(super) fn normal_component<const M: usize>(&self, k: usize) -> BernsteinField<M> {
        const { assert!(M == 2 * N - 2) };
        let (lower, full) = const { (binomial_row::<N>(N - 2), binomial_row::<N>(N - 1)) };
        let (k, l) = ((k + 1) % 3, (k + 2) % 3);
        let [uk, ul] = [k, l].map(|k| scale_coefficients(&self.u[k], &lower, &full));
        let [vk, vl] = [k, l].map(|k| scale_coefficients(&self.v[k], &full, &lower));
        let mut sum = [[0.0; M]; M];
        add_derivative_product(&uk, &vl, 1.0, &mut sum);
        add_derivative_product(&ul, &vk, -1.0, &mut sum);
        field_from_scaled_coefficients(&sum)
    }
}

/// [`add_scaled_product`] of a derivative by u and one by v, without their rows and columns of
/// zeros.
fn add_derivative_product<const N: usize, const M: usize>(
    u: &ScaledCoefficients<N>,
    v: &ScaledCoefficients<N>,
    factor: f64,
    sum: &mut ScaledCoefficients<M>,
) {
    for (i, row) in u[..N - 1].iter().enumerate() {
        for (j, &x) in row.iter().enumerate() {
            let x = x * factor;
            for (sums, others) in sum[i..].iter_mut().zip(v) {
                for (sum, y) in sums[j..].iter_mut().zip(&others[..N - 1]) {
                    *sum += x * y;
                }
            }
        }
    }
}

/// The sum of the squares of fields, which has twice their degree.
pub(super) fn sum_of_squared_fields<const H: usize, const M: usize>(fields: &[BernsteinField<H>]) -> BernsteinField<M> {
    const { assert!(M == 2 * H - 1) };
    let by = const { binomial_row::<H>(H - 1) };
    let mut sum = [[0.0; M]; M];
    for field in fields {
        let scaled = scale_coefficients(&field.coefficients, &by, &by);
        add_scaled_product(&scaled, &scaled, &mut sum);
    }
    field_from_scaled_coefficients(&sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normals_are_cross_products() {
        let mut random = fastrand::Rng::with_seed(5);
        let mut vector = || DVec3::from_array([0; 3].map(|_| random.f64() - 0.5));
        let patch = Patch::<4> { points: std::array::from_fn(|_| std::array::from_fn(|_| vector())) };
        let made = Hodographs::new(&patch, &[DVec3::X, DVec3::Y, DVec3::Z]);
        let fields: [BernsteinField<6>; 3] = std::array::from_fn(|k| made.normal_component(k));
        let square: BernsteinField<11> = sum_of_squared_fields(&fields);
        let ranges = made.normal_component_ranges();
        for k in 0..25 {
            let (u, v) = (f64::from(k / 5) / 4.0, f64::from(k % 5) / 4.0);
            let truth = patch.jet(u, v).normal();
            for axis in 0..3 {
                assert!((fields[axis].evaluate_jet(u, v).value - truth[axis]).abs() < 1e-12);
                assert!(ranges[axis][0] <= truth[axis] && truth[axis] <= ranges[axis][1]);
            }
            assert!((square.evaluate_jet(u, v).value - truth.length_squared()).abs() < 1e-11);
        }
    }
}
