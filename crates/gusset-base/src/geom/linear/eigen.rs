//! Eigenvalues and eigenvectors of small symmetric matrices, by Jacobi's rotations.

/// The number of Jacobi sweeps. Each squares the relative size of the off-diagonal entries.
const JACOBI_SWEEPS: usize = 10;

/// Returns the eigenvalues of a symmetric matrix, unsorted, and the matrix whose columns are their
/// orthonormal eigenvectors. O(N^3).
pub fn symmetric_eigen<const N: usize>(mut k: [[f64; N]; N]) -> ([f64; N], [[f64; N]; N]) {
    let mut vectors = [[0.0; N]; N];
    (0..N).for_each(|i| vectors[i][i] = 1.0);
    let pairs = (0..N).flat_map(|p| (p + 1..N).map(move |q| (p, q)));
    for (p, q) in (0..JACOBI_SWEEPS).flat_map(|_| pairs.clone()) {
        if k[p][q] == 0.0 {
            continue;
        }
        let theta = (k[q][q] - k[p][p]) / (2.0 * k[p][q]);
        let tangent = theta.signum() / (theta.abs() + libm::hypot(theta, 1.0));
        let cosine = 1.0 / libm::hypot(tangent, 1.0);
        let sine = tangent * cosine;
        for row in &mut k {
            (row[p], row[q]) = (cosine * row[p] - sine * row[q], sine * row[p] + cosine * row[q]);
        }
        let (first, second) = (k[p], k[q]);
        k[p] = std::array::from_fn(|i| cosine * first[i] - sine * second[i]);
        k[q] = std::array::from_fn(|i| sine * first[i] + cosine * second[i]);
        for row in &mut vectors {
            (row[p], row[q]) = (cosine * row[p] - sine * row[q], sine * row[p] + cosine * row[q]);
        }
    }
    (std::array::from_fn(|i| k[i][i]), vectors)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eigenvectors_reproduce_the_matrix() {
        let mut random = fastrand::Rng::with_seed(3);
        for _ in 0..50 {
            let mut matrix = [[0.0; 6]; 6];
            for (i, j) in (0..6).flat_map(|i| (0..=i).map(move |j| (i, j))) {
                (matrix[i][j], matrix[j][i]) = (random.f64() - 0.5, 0.0);
                matrix[j][i] = matrix[i][j];
            }
            let (values, vectors) = symmetric_eigen(matrix);
            for (i, j) in (0..6).flat_map(|i| (0..6).map(move |j| (i, j))) {
                let again: f64 = (0..6).map(|k| values[k] * vectors[i][k] * vectors[j][k]).sum();
                assert!((again - matrix[i][j]).abs() < 1e-13);
                let product: f64 = (0..6).map(|k| vectors[k][i] * vectors[k][j]).sum();
                assert!((product - f64::from(u8::from(i == j))).abs() < 1e-13);
            }
        }
    }
}
