//! The sparse factor against dense elimination, on random matrices.

use super::elimination_tree::{elimination_tree_parents, factor_column_counts};
use super::factor::CholeskyFactor;
use super::frontal_matrix::ROWS_PER_BLOCK;
use super::supernodes::Supernodes;
use super::symmetric::SparseSymmetric;
use crate::{Error, Job, Progress};
use glam::DVec3;
use std::cell::Cell;
use std::collections::BTreeMap;
use std::ops::ControlFlow;

type DenseRows = Vec<Vec<f64>>;

/// Returns the sparse form of a dense symmetric matrix: all its non-zero entries.
fn sparse_of_dense(a: &DenseRows) -> SparseSymmetric {
    let mut matrix = SparseSymmetric { column_starts: vec![0], entries: Vec::new(), diagonal: Vec::new() };
    for (k, row) in a.iter().enumerate() {
        matrix.entries.extend((0..k).filter(|&i| row[i] != 0.0).map(|i| (i as u32, row[i])));
        matrix.column_starts.push(matrix.entries.len());
        matrix.diagonal.push(row[k]);
    }
    matrix
}

fn zeros(n: usize) -> DenseRows {
    vec![vec![0.0; n]; n]
}

/// B^T B for a random B with about `entries` entries a row, plus a small diagonal. It resembles the
/// squared Laplacian of a plate.
fn random_definite(n: usize, entries: usize, random: &mut fastrand::Rng) -> DenseRows {
    let mut a = zeros(n);
    for _ in 0..n {
        let row: Vec<_> = (0..entries).map(|_| (random.usize(..n), random.f64() - 0.5)).collect();
        for &(i, p) in &row {
            row.iter().for_each(|&(j, q)| a[i][j] += p * q);
        }
    }
    (0..n).for_each(|k| a[k][k] += 0.01);
    a
}

/// Squared second differences on a grid, row by row, as (row, column, value) with repetitions. They
/// give long separators and fronts of several panels.
fn grid_terms(width: usize, height: usize) -> Vec<(usize, usize, f64)> {
    let at = |x: usize, y: usize| y * width + x;
    let mut terms = Vec::new();
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        let mut row = vec![(at(x, y), 4.5)];
        row.extend((x > 0).then(|| (at(x - 1, y), -1.0)));
        row.extend((x + 1 < width).then(|| (at(x + 1, y), -1.0)));
        row.extend((y > 0).then(|| (at(x, y - 1), -1.0)));
        row.extend((y + 1 < height).then(|| (at(x, y + 1), -1.0)));
        terms.extend(row.iter().flat_map(|&(i, p)| row.iter().map(move |&(j, q)| (i, j, p * q)).collect::<Vec<_>>()));
    }
    terms
}

fn grid_matrix(width: usize, height: usize) -> DenseRows {
    let mut a = zeros(width * height);
    grid_terms(width, height).into_iter().for_each(|(i, j, value)| a[i][j] += value);
    a
}

fn permute_unknowns(a: &DenseRows, order: &[usize]) -> DenseRows {
    order.iter().map(|&i| order.iter().map(|&j| a[i][j]).collect()).collect()
}

fn random_permutation(n: usize, random: &mut fastrand::Rng) -> Vec<usize> {
    let mut order: Vec<_> = (0..n).collect();
    random.shuffle(&mut order);
    order
}

/// Solves by Gaussian elimination without pivoting, on the kept rows and columns; 0 elsewhere.
fn solve_kept_unknowns(a: &DenseRows, b: &[DVec3], kept: &[usize]) -> Vec<DVec3> {
    let mut a = permute_unknowns(a, kept);
    let mut x: Vec<_> = kept.iter().map(|&k| b[k]).collect();
    let n = kept.len();
    for k in 0..n {
        for i in k + 1..n {
            let factor = a[i][k] / a[k][k];
            (k..n).for_each(|j| a[i][j] -= factor * a[k][j]);
            x[i] = x[i] - factor * x[k];
        }
    }
    for k in (0..n).rev() {
        let known: DVec3 = (k + 1..n).map(|j| a[k][j] * x[j]).sum();
        x[k] = (x[k] - known) / a[k][k];
    }
    let mut all = vec![DVec3::ZERO; b.len()];
    kept.iter().zip(x).for_each(|(&k, x)| all[k] = x);
    all
}

fn right_side(n: usize, random: &mut fastrand::Rng) -> Vec<DVec3> {
    (0..n).map(|_| DVec3::new(random.f64(), random.f64(), random.f64()) - 0.5).collect()
}

fn factor(a: &DenseRows) -> CholeskyFactor {
    sparse_of_dense(a).factorise(&Job::default()).unwrap()
}

fn solve(a: &DenseRows, b: &[DVec3]) -> Vec<DVec3> {
    let mut x = b.to_vec();
    factor(a).solve(&mut x, &Job::default()).unwrap();
    x
}

fn assert_close(found: &[DVec3], expected: &[DVec3], tolerance: f64, what: &str) {
    let size = expected.iter().map(|x| x.length()).fold(1e-300, f64::max);
    let off = found.iter().zip(expected).map(|(x, y)| x.distance(*y)).fold(0.0, f64::max);
    assert!(off <= tolerance * size, "{what}: {off} of {size}");
}

/// L as a dense matrix, in the order of elimination.
fn dense_lower_factor(factor: &CholeskyFactor) -> DenseRows {
    let n = factor.inverse_pivots.len();
    let mut lower = zeros(n);
    let mut used = 0;
    for s in 0..factor.supernodes.len() {
        let columns = factor.supernodes.columns(s);
        let rows: Vec<_> =
            columns.clone().chain(factor.supernodes.rows_below(s).iter().map(|&row| row as usize)).collect();
        for (b, count) in factor.column_counts_of_row_blocks(s).enumerate() {
            for (k, lanes) in columns.clone().zip(&factor.entries[used..used + count]) {
                for (&row, &entry) in rows[ROWS_PER_BLOCK * b..].iter().zip(lanes) {
                    assert!(row > k || entry == 0.0, "above the diagonal");
                    lower[row][k] = entry;
                }
            }
            used += count;
        }
    }
    assert_eq!(used, factor.entries.len());
    (0..n).for_each(|k| lower[k][k] = 1.0);
    lower
}

fn test_matrices() -> Vec<(String, DenseRows)> {
    let mut random = fastrand::Rng::with_seed(7);
    let mut cases = Vec::new();
    for n in [1, 2, 3, 7, 8, 9, 24, 25, 33, 64, 100, 150] {
        for entries in [1, 2, 3, 6, n] {
            cases.push((format!("random {n} {entries}"), random_definite(n, entries.min(n), &mut random)));
        }
    }
    for (width, height) in [(40, 2), (13, 13), (16, 16)] {
        let a = grid_matrix(width, height);
        let order = random_permutation(a.len(), &mut random);
        cases.push((format!("shuffled grid {width} {height}"), permute_unknowns(&a, &order)));
        cases.push((format!("grid {width} {height}"), a));
    }
    // An arrow matrix in either order: the factor has no fill-in, or is full.
    let mut arrow = zeros(70);
    for (k, row) in arrow.iter_mut().enumerate() {
        (row[k], row[69]) = (2.0, -1.0 / 9.0);
    }
    arrow[69] = vec![-1.0 / 9.0; 70];
    arrow[69][69] = 70.0;
    let back: Vec<_> = (0..70).rev().collect();
    cases.push(("dense arrow".into(), permute_unknowns(&arrow, &back)));
    cases.push(("arrow".into(), arrow));
    cases
}

#[test]
fn factors_reproduce_the_matrix() {
    for (name, a) in test_matrices() {
        let factor = factor(&a);
        let lower = dense_lower_factor(&factor);
        let order = &factor.supernodes.order;
        let size = a.iter().flatten().fold(0.0, |size: f64, entry| size.max(entry.abs()));
        for i in 0..a.len() {
            for j in 0..=i {
                let product: f64 = (0..=j).map(|k| lower[i][k] * lower[j][k] / factor.inverse_pivots[k]).sum();
                let entry = a[order[i] as usize][order[j] as usize];
                assert!((product - entry).abs() < 1e-13 * size, "{name}: {product} and {entry} at {i} {j}");
            }
        }
    }
}

#[test]
fn solutions_agree_with_dense_elimination() {
    let mut random = fastrand::Rng::with_seed(8);
    for (name, a) in test_matrices() {
        let n = a.len();
        let b = right_side(n, &mut random);
        let all: Vec<_> = (0..n).collect();
        let expected = solve_kept_unknowns(&a, &b, &all);
        assert_close(&solve(&a, &b), &expected, 1e-9, &name);
        // A different numbering gives the same solution.
        let order = random_permutation(n, &mut random);
        let right: Vec<_> = order.iter().map(|&k| b[k]).collect();
        let expected: Vec<_> = order.iter().map(|&k| expected[k]).collect();
        assert_close(&solve(&permute_unknowns(&a, &order), &right), &expected, 1e-9, &name);
    }
    assert!(solve(&zeros(0), &[]).is_empty());
}

/// The order decides which of several dependent unknowns lacks a pivot. In every case the
/// others solve their own equations.
#[test]
fn unknowns_without_a_positive_pivot_are_left_out() {
    let mut random = fastrand::Rng::with_seed(9);
    for n in [2, 5, 20, 30, 60, 120] {
        // Integer Laplacians of random graphs: each component has exactly one unknown too many.
        let mut a = zeros(n);
        for _ in 0..3 * n / 2 {
            let (i, j) = (random.usize(..n), random.usize(..n));
            if i != j && a[i][j] == 0.0 {
                (a[i][j], a[j][i]) = (-1.0, -1.0);
                a[i][i] += 1.0;
                a[j][j] += 1.0;
            }
        }
        let mut component: Vec<_> = (0..n).collect();
        for _ in 0..n {
            for i in 0..n {
                let least = (0..n).filter(|&j| a[i][j] != 0.0).map(|j| component[j]).min();
                component[i] = component[i].min(least.unwrap_or(i));
            }
        }
        let components = (0..n).filter(|&k| component[k] == k).count();
        // Some unknowns are also coupled but not positive.
        let spoilt = [f64::NAN, -3.0, 0.0].map(|value| (random.usize(..n), value));
        for spoils in [&spoilt[..0], &spoilt] {
            let mut a = a.clone();
            spoils.iter().for_each(|&(k, value)| a[k][k] = value);
            let factor = factor(&a);
            let order = &factor.supernodes.order;
            let kept: Vec<_> = (0..n)
                .filter(|&k| factor.inverse_pivots[factor.supernodes.new_number_of_column[k] as usize] != 0.0)
                .collect();
            assert!(spoils.iter().all(|(k, _)| !kept.contains(k)), "{n}");
            if spoils.is_empty() {
                assert_eq!(kept.len() + components, n);
            } else {
                assert!(kept.len() + components + 3 >= n, "{n} {}", kept.len());
            }
            let b = right_side(n, &mut random);
            let mut x = b.clone();
            factor.solve(&mut x, &Job::default()).unwrap();
            assert_close(&x, &solve_kept_unknowns(&a, &b, &kept), 1e-9, "left out");
            assert!((0..n).all(|k| kept.contains(&k) || x[k] == DVec3::ZERO), "{n}");
            assert_eq!(order.len(), n);
        }
    }
    assert_eq!(solve(&vec![vec![0.0]], &[DVec3::ONE]), [DVec3::ZERO]);
    assert_eq!(solve(&vec![vec![4.0]], &[DVec3::ONE]), [DVec3::ONE / 4.0]);
}

/// The entries of the factor according to a naive elimination of the pattern.
#[test]
fn counts_and_groups_agree_with_the_pattern() {
    for (name, a) in test_matrices() {
        let n = a.len();
        let mut pattern: Vec<Vec<bool>> = a.iter().map(|row| row.iter().map(|&entry| entry != 0.0).collect()).collect();
        for k in 0..n {
            for i in k + 1..n {
                if pattern[i][k] {
                    (k + 1..n).for_each(|j| pattern[i][j] |= pattern[k][j] || pattern[j][k]);
                }
            }
        }
        let matrix = sparse_of_dense(&a);
        let below = matrix.entries_below_diagonal(&Job::default()).unwrap();
        let parent = elimination_tree_parents(&matrix, &Job::default()).unwrap();
        let counts = factor_column_counts(&below, &parent, &Job::default()).unwrap();
        for k in 0..n {
            let rows: Vec<_> = (k + 1..n).filter(|&i| pattern[i][k]).collect();
            assert_eq!(counts[k] as usize, 1 + rows.len(), "{name}: column {k}");
            assert_eq!(parent[k], rows.first().map_or(u32::MAX, |&i| i as u32), "{name}: column {k}");
        }
        let groups = Supernodes::new(&matrix, &below, &Job::default()).unwrap();
        let (mut stored, mut next) = (0, 0);
        for s in 0..groups.len() {
            let columns = groups.columns(s);
            assert_eq!(columns.start, next, "{name}");
            next = columns.end;
            assert!(groups.rows_below(s).is_sorted_by(|i, j| i < j), "{name}");
            for k in columns.clone() {
                let has = |row: &usize| columns.contains(row) || groups.rows_below(s).contains(&(*row as u32));
                let old = groups.order[k] as usize;
                let mut rows =
                    (0..n).filter(|&i| i > old && pattern[i][old]).map(|i| groups.new_number_of_column[i] as usize);
                assert!(rows.all(|row| row > k && has(&row)), "{name}: column {k}");
                stored += columns.end - k + groups.rows_below(s).len();
            }
        }
        let entries: usize = counts.iter().map(|&count| count as usize).sum();
        assert_eq!(next, n, "{name}");
        assert!(stored < 2 * entries + 300, "{name}: {stored} for {entries}");
    }
}

/// Cancels after a number of reports, and checks that fractions never decrease.
struct CancelsAfterSteps {
    left: Cell<usize>,
    fraction: Cell<f64>,
}

impl Progress for CancelsAfterSteps {
    fn step(&self, fraction: f64, _: &'static str) -> ControlFlow<()> {
        assert!((self.fraction.get()..=1.0).contains(&fraction), "{fraction} after {}", self.fraction.get());
        self.fraction.set(fraction);
        self.left.set(self.left.get().saturating_sub(1));
        if self.left.get() == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

#[test]
fn progress_is_reported_regularly() {
    let n = if cfg!(debug_assertions) { 72 } else { 120 };
    let mut columns = vec![BTreeMap::<usize, f64>::new(); n * n];
    grid_terms(n, n).into_iter().for_each(|(i, j, value)| *columns[j].entry(i).or_default() += value);
    let mut a = SparseSymmetric { column_starts: vec![0], entries: Vec::new(), diagonal: Vec::new() };
    for (k, column) in columns.iter().enumerate() {
        a.entries.extend(column.range(..k).map(|(&i, &value)| (i as u32, value)));
        a.column_starts.push(a.entries.len());
        a.diagonal.push(column[&k]);
    }
    let run = |left: usize| {
        let patience = CancelsAfterSteps { left: Cell::new(left), fraction: Cell::new(0.0) };
        let job = Job::new(1, &patience);
        let mut x = vec![DVec3::ONE; a.row_count()];
        let done = a.factorise(&job.sub_job(0.0, 0.5)).and_then(|factor| factor.solve(&mut x, &job.sub_job(0.5, 1.0)));
        (done, left - patience.left.get())
    };
    let (done, all) = run(usize::MAX);
    assert_eq!(done, Ok(()));
    assert!(all >= 4, "{all}");
    for left in [1, 2, all / 2, all - 1, all] {
        assert_eq!(run(left), (Err(Error::Cancelled), left));
    }
}
