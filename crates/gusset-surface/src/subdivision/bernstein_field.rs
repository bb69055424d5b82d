//! A scalar field over a patch in Bernstein form, such as the height above a plane or an angle.

use gusset_base::geom::bernstein::{halves, value_and_slope_by_differences};

/// Coefficients `c[a][b]` of degree N - 1 in u and in v, over 0 <= u, v <= 1. All values of the
/// field lie between the smallest and the largest coefficient.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BernsteinField<const N: usize> {
    pub(crate) coefficients: [[f64; N]; N],
}

/// Value and partial derivatives at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FieldJet {
    pub(crate) value: f64,
    pub(crate) u: f64,
    pub(crate) v: f64,
}

impl<const N: usize> BernsteinField<N> {
    /// The smallest and the largest coefficient.
    #[inline]
    pub(crate) fn coefficient_range(&self) -> [f64; 2] {
        // Comparisons instead of f64::min: they vectorise, and may skip NaN.
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for &x in self.coefficients.as_flattened() {
            low = if x < low { x } else { low };
            high = if x > high { x } else { high };
        }
        [low, high]
    }

    /// Returns a * self + b * other.
    #[inline]
    pub(crate) fn linear_combination(&self, a: f64, other: &BernsteinField<N>, b: f64) -> BernsteinField<N> {
        let mut c = self.coefficients;
        for (row, others) in c.iter_mut().zip(&other.coefficients) {
            row.iter_mut().zip(others).for_each(|(x, &y)| *x = a * *x + b * y);
        }
        BernsteinField { coefficients: c }
    }

    /// Evaluates the field and its derivatives at (u, v).
    pub(crate) fn evaluate_jet(&self, u: f64, v: f64) -> FieldJet {
        let (mut values, mut slopes) = ([0.0; N], [0.0; N]);
        for (a, row) in self.coefficients.iter().enumerate() {
            [values[a], slopes[a]] = value_and_slope_by_differences(row, v);
        }
        let [value, along_u] = value_and_slope_by_differences(&values, u);
        FieldJet { value, u: along_u, v: value_and_slope_by_differences(&slopes, u)[0] }
    }

    /// The smallest and the largest coefficient of the derivative by u, and of the derivative by v.
    #[inline]
    pub(crate) fn derivative_ranges(&self) -> [[f64; 2]; 2] {
        let mut ranges = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        let mut add = |k: usize, x: f64| {
            let [low, high] = &mut ranges[k];
            *low = if x < *low { x } else { *low };
            *high = if x > *high { x } else { *high };
        };
        for a in 0..N {
            for b in 0..N {
                if a + 1 < N {
                    add(0, self.coefficients[a + 1][b] - self.coefficients[a][b]);
                }
                if b + 1 < N {
                    add(1, self.coefficients[a][b + 1] - self.coefficients[a][b]);
                }
            }
        }
        ranges.map(|range| range.map(|x| x * (N - 1) as f64))
    }

    /// The four quarters: low u and low v, low u and high v, high u and low v, high u and high v.
    pub(crate) fn quarters(&self) -> [BernsteinField<N>; 4] {
        let [low, high] = self.halves();
        let ([a, b], [c, d]) = (low.transposed().halves(), high.transposed().halves());
        [a, b, c, d].map(|field| field.transposed())
    }

    /// The halves at u = 1/2.
    pub(crate) fn halves(&self) -> [BernsteinField<N>; 2] {
        halves(&self.coefficients).map(|c| BernsteinField { coefficients: c })
    }

    /// The field with u and v exchanged.
    pub(crate) fn transposed(&self) -> BernsteinField<N> {
        let mut turned = *self;
        for a in 0..N {
            for b in 0..N {
                turned.coefficients[a][b] = self.coefficients[b][a];
            }
        }
        turned
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_equal_the_whole_field() {
        let mut random = fastrand::Rng::with_seed(1);
        let field = BernsteinField::<4> { coefficients: [[0.0; 4]; 4].map(|row| row.map(|_| random.f64() - 0.5)) };
        let parts = field.quarters();
        for k in 0..25 {
            let (u, v) = (f64::from(k / 5) / 4.0, f64::from(k % 5) / 4.0);
            for (q, part) in parts.iter().enumerate() {
                let (from_u, from_v) = (0.5 * (q / 2) as f64, 0.5 * (q % 2) as f64);
                let (there, whole) = (part.evaluate_jet(u, v), field.evaluate_jet(from_u + 0.5 * u, from_v + 0.5 * v));
                assert!((there.value - whole.value).abs() < 1e-15);
                assert!((there.u - 0.5 * whole.u).abs() < 1e-14 && (there.v - 0.5 * whole.v).abs() < 1e-14);
                let [low, high] = part.coefficient_range();
                assert!(low <= there.value + 1e-15 && there.value <= high + 1e-15);
                let [[low, high], _] = part.derivative_ranges();
                assert!(low <= there.u + 1e-14 && there.u <= high + 1e-14);
            }
        }
    }
}
