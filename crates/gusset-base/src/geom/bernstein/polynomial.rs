//! Scalar polynomials in Bernstein form: values in O(n), binomial coefficients, products and
//! integrals (Farouki and Rajan 1988).

/// The highest degree of a curve segment.
pub const MAX_DEGREE: usize = 64;

/// The largest number of coefficients in a search for roots: (C - q) . C' for a segment C has
/// degree 2 n - 1.
pub const MAX_COEFFICIENTS: usize = 2 * MAX_DEGREE;

/// Evaluates f(t) and f'(t) by a Horner-like scheme. It starts at the nearer end, so that the ratio
/// x of its powers is at most 1 and the terms do not overflow.
pub fn value_and_slope(c: &[f64], t: f64) -> (f64, f64) {
    let n = c.len() - 1;
    let backwards = t > 0.5;
    let (x, s) = if backwards { ((1.0 - t) / t, t) } else { (t / (1.0 - t), 1.0 - t) };
    let at = |i: usize| c[if backwards { n - i } else { i }];
    let step = |i: usize| if backwards { at(i) - at(i + 1) } else { at(i + 1) - at(i) };
    if n == 0 {
        return (c[0], 0.0);
    }
    let (mut value, mut slope) = (at(0), step(0));
    let (mut factor, mut lower, mut scale) = (1.0, 1.0, 1.0);
    for i in 1..=n {
        factor *= x * (n + 1 - i) as f64 / i as f64;
        value += at(i) * factor;
        if i < n {
            lower *= x * (n - i) as f64 / i as f64;
            slope += step(i) * lower;
            scale *= s;
        }
    }
    (value * scale * s, slope * scale * n as f64)
}

/// Returns the binomials C(n, 0), ..., C(n, n). Exact up to 2^53, then rounded.
pub(super) fn binomials(n: usize) -> impl Iterator<Item = f64> + Clone {
    (0..=n).scan(1.0, move |next, i| {
        let now: f64 = *next;
        *next = now * (n - i) as f64 / (i + 1) as f64;
        // Up to 2^53 the quotient is exact.
        Some(now)
    })
}

/// Returns the binomials C(n, 0), ..., C(n, n), padded with zeros; n < M.
pub const fn binomial_row<const M: usize>(n: usize) -> [f64; M] {
    let (mut row, mut k) = ([0.0; M], 0);
    row[0] = 1.0;
    while k < n {
        row[k + 1] = row[k] * (n - k) as f64 / (k + 1) as f64;
        k += 1;
    }
    row
}

/// Adds `factor` times the product of two polynomials to `out`, whose degree is the sum of their
/// degrees: (f g)_k = sum over i + j = k of C(n, i) C(m, j) / C(n + m, k) f_i g_j.
pub fn add_product(f: &[f64], g: &[f64], factor: f64, out: &mut [f64]) {
    let (n, m) = (f.len() - 1, g.len() - 1);
    let mut weights = [0.0; 4 * MAX_DEGREE + 1];
    for (weight, b) in weights.iter_mut().zip(binomials(n + m)) {
        *weight = factor / b;
    }
    for (i, (a, row)) in f.iter().zip(binomials(n)).enumerate() {
        for (j, (b, column)) in g.iter().zip(binomials(m)).enumerate() {
            out[i + j] += row * column * weights[i + j] * a * b;
        }
    }
}

/// Returns the integral over 0 to 1, which is the mean of the coefficients.
#[inline]
pub fn integral(c: &[f64]) -> f64 {
    c.iter().sum::<f64>() / c.len() as f64
}

/// Returns the integral of a product over 0 to 1.
#[inline]
pub fn integral_of_product(f: &[f64], g: &[f64]) -> f64 {
    let mut product = [0.0; 4 * MAX_DEGREE + 1];
    let product = &mut product[..f.len() + g.len() - 1];
    add_product(f, g, 1.0, product);
    integral(product)
}

#[cfg(test)]
mod tests {
    use super::super::casteljau::halve;
    use super::*;

    #[test]
    fn values_products_and_halves_agree_with_closed_forms() {
        // t (1 - t) and 1 - 2 t.
        let (f, g) = ([0.0, 0.5, 0.0], [1.0, -1.0]);
        assert_eq!(integral(&f), 1.0 / 6.0);
        let mut product = [0.0; 4];
        add_product(&f, &g, 2.0, &mut product);
        let (mut left, mut right) = ([0.0; 4], product);
        halve(&mut right, &mut left);
        for k in 0..=8 {
            let t = f64::from(k) / 8.0;
            let (value, slope) = value_and_slope(&product, t);
            assert!((value - 2.0 * t * (1.0 - t) * (1.0 - 2.0 * t)).abs() < 1e-15);
            assert!((slope - 2.0 * (1.0 - 6.0 * t + 6.0 * t * t)).abs() < 1e-14);
            let part = if t <= 0.5 { value_and_slope(&left, 2.0 * t) } else { value_and_slope(&right, 2.0 * t - 1.0) };
            assert!((part.0 - value).abs() < 1e-15);
        }
        assert_eq!(binomials(64).nth(32).map(|b| (b / 1.832_624_140_942_590_5e18 - 1.0).abs() < 1e-14), Some(true));
        assert_eq!(binomial_row::<27>(26)[13], 10_400_600.0);
        for n in 0..20 {
            assert!(binomials(n).eq(binomial_row::<20>(n)[..=n].iter().copied()));
        }
        // Coefficients that are all 1 stay 1 in any degree.
        let ones = [1.0; MAX_COEFFICIENTS];
        assert!((value_and_slope(&ones, 0.3).0 - 1.0).abs() < 1e-13);
    }
}
