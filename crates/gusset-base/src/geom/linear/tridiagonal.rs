//! Tridiagonal systems whose unknowns are points, open and cyclic, by elimination without pivoting
//! (Thomas's algorithm). Elimination is stable if the rows are diagonally dominant. In a cyclic
//! system, the last unknown's coefficient is carried from row to row until it fades below rounding.
//! O(n).

use glam::DVec3;

/// Smaller pivots make the system singular, in rows whose coefficients are near 1.
const MIN_PIVOT_MAGNITUDE: f64 = 1e-14;

/// Smaller coefficients of the last unknown of a cyclic system are dropped.
const MAX_NEGLIGIBLE_COEFFICIENT: f64 = 1e-24;

/// Solves for `unknowns[1..n - 1]`; the caller sets the first and the last. `row(i)` returns the
/// coefficients of unknowns i - 1, i and i + 1, and `known(i)` the right side. `upper` is workspace
/// for n factors. Returns false if the system is singular.
pub fn solve(
    unknowns: &mut [DVec3],
    upper: &mut [f64],
    row: impl Fn(usize) -> [f64; 3],
    known: impl Fn(usize) -> DVec3,
) -> bool {
    let last = unknowns.len() - 1;
    let mut sound = true;
    let (mut before, mut ratio) = (unknowns[0], 0.0);
    for i in 1..last {
        let [lower, diagonal, above] = row(i);
        let diagonal = diagonal - lower * ratio;
        sound &= diagonal.abs() > MIN_PIVOT_MAGNITUDE;
        let scale = 1.0 / diagonal;
        before = (known(i) - before * lower) * scale;
        ratio = above * scale;
        unknowns[i] = before;
        upper[i] = ratio;
    }
    let mut after = unknowns[last];
    for i in (1..last).rev() {
        after = unknowns[i] - after * upper[i];
        unknowns[i] = after;
    }
    sound
}

/// One end of a cyclic system while its rows are eliminated towards the middle. The unknown reached
/// last equals `constant` - `next_coefficient` * (next unknown) - `last_coefficient` * (last unknown).
struct EliminationFront {
    constant: DVec3,
    next_coefficient: f64,
    last_coefficient: f64,
    /// The coefficient of the next unknown in the last row.
    coefficient_in_last_row: f64,
}

impl EliminationFront {
    /// Starts before any row, at the last unknown itself.
    fn new(far: f64) -> Self {
        EliminationFront {
            constant: DVec3::ZERO,
            next_coefficient: 0.0,
            last_coefficient: -1.0,
            coefficient_in_last_row: far,
        }
    }

    /// Eliminates the next row, given the coefficients of the unknown reached, the next one and the
    /// one after. Returns the pivot and the multiplier.
    #[inline]
    fn eliminate_row(&mut self, [behind, diagonal, ahead]: [f64; 3], known: DVec3) -> [f64; 2] {
        let pivot = diagonal - behind * self.next_coefficient;
        let scale = 1.0 / pivot;
        self.constant = (known - self.constant * behind) * scale;
        self.next_coefficient = ahead * scale;
        [pivot, behind * scale]
    }

    /// Eliminates the next row like [`eliminate_row`](Self::eliminate_row), and carries the last
    /// unknown along in this row and in the last row. Returns the pivot.
    #[inline]
    fn eliminate_row_with_last(&mut self, row: [f64; 3], known: DVec3, last: &mut (f64, DVec3)) -> f64 {
        let [pivot, taken] = self.eliminate_row(row, known);
        self.last_coefficient *= -taken;
        last.0 -= self.coefficient_in_last_row * self.last_coefficient;
        last.1 -= self.constant * self.coefficient_in_last_row;
        self.coefficient_in_last_row *= -self.next_coefficient;
        pivot
    }

    /// Returns true if the coefficients of the last unknown are negligible.
    fn is_decoupled_from_last(&self) -> bool {
        self.last_coefficient.abs() <= MAX_NEGLIGIBLE_COEFFICIENT
            && self.coefficient_in_last_row.abs() <= MAX_NEGLIGIBLE_COEFFICIENT
    }
}

/// Solves a cyclic system of n >= 3 unknowns. `row(i, before)` returns the coefficients of unknowns
/// `before` (cyclically i - 1), i and i + 1, and `known(i)` the right side. `next_coefficients` and
/// `last_coefficients` are workspace for n factors each. Returns false if the system is singular.
///
/// Eliminates from both ends at once, which keeps a processor busy while it divides. The rows next
/// to the last unknown carry it along until its coefficient has faded.
pub fn solve_cyclic(
    unknowns: &mut [DVec3],
    next_coefficients: &mut [f64],
    last_coefficients: &mut [f64],
    row: impl Fn(usize, usize) -> [f64; 3],
    known: impl Fn(usize) -> DVec3,
) -> bool {
    let n = unknowns.len();
    let (next_coefficients, last_coefficients) = (&mut next_coefficients[..n], &mut last_coefficients[..n]);
    let forth = |i: usize| row(i, if i == 0 { n - 1 } else { i - 1 });
    let back = |i: usize| {
        let [behind, diagonal, ahead] = row(i, i - 1);
        [ahead, diagonal, behind]
    };
    let [lower, diagonal, above] = row(n - 1, n - 2);
    let mut last = (diagonal, known(n - 1));
    let (mut first_end, mut last_end) = (EliminationFront::new(above), EliminationFront::new(lower));
    let mut least = f64::INFINITY;
    // Eliminate rows 0 to n - 2, except the middle row, in pairs. If their number is odd, row 0
    // comes first.
    let (pairs, alone) = ((n - 2) / 2, n % 2);
    let middle = pairs + alone;
    if alone == 1 {
        least = first_end.eliminate_row_with_last(forth(0), known(0), &mut last).abs();
        (unknowns[0], next_coefficients[0], last_coefficients[0]) =
            (first_end.constant, first_end.next_coefficient, first_end.last_coefficient);
    }
    let mut carried = 0;
    while carried < pairs && !(first_end.is_decoupled_from_last() && last_end.is_decoupled_from_last()) {
        let (i, j) = (alone + carried, n - 2 - carried);
        let pivots = [
            first_end.eliminate_row_with_last(forth(i), known(i), &mut last),
            last_end.eliminate_row_with_last(back(j), known(j), &mut last),
        ];
        least = least.min(pivots[0].abs()).min(pivots[1].abs());
        (unknowns[i], next_coefficients[i], last_coefficients[i]) =
            (first_end.constant, first_end.next_coefficient, first_end.last_coefficient);
        (unknowns[j], next_coefficients[j], last_coefficients[j]) =
            (last_end.constant, last_end.next_coefficient, last_end.last_coefficient);
        carried += 1;
    }
    for k in carried..pairs {
        let (i, j) = (alone + k, n - 2 - k);
        let [[p, _], [q, _]] = [first_end.eliminate_row(forth(i), known(i)), last_end.eliminate_row(back(j), known(j))];
        least = least.min(p.abs()).min(q.abs());
        (unknowns[i], next_coefficients[i]) = (first_end.constant, first_end.next_coefficient);
        (unknowns[j], next_coefficients[j]) = (last_end.constant, last_end.next_coefficient);
    }
    // The middle row and the last row form a system of two unknowns.
    let [lower, diagonal, above] = forth(middle);
    let pivot = diagonal - lower * first_end.next_coefficient - above * last_end.next_coefficient;
    let scale = 1.0 / pivot;
    let own = (known(middle) - first_end.constant * lower - last_end.constant * above) * scale;
    let share = -(lower * first_end.last_coefficient + above * last_end.last_coefficient) * scale;
    let far = first_end.coefficient_in_last_row + last_end.coefficient_in_last_row;
    let last_pivot = last.0 - far * share;
    let end = (last.1 - own * far) / last_pivot;
    let centre = own - end * share;
    (unknowns[n - 1], unknowns[middle]) = (end, centre);
    let (mut after, mut before) = (centre, centre);
    for k in (0..pairs).rev() {
        let (i, j) = (alone + k, n - 2 - k);
        after = unknowns[i] - after * next_coefficients[i];
        before = unknowns[j] - before * next_coefficients[j];
        if k < carried {
            after -= end * last_coefficients[i];
            before -= end * last_coefficients[j];
        }
        (unknowns[i], unknowns[j]) = (after, before);
    }
    if alone == 1 {
        unknowns[0] = unknowns[0] - after * next_coefficients[0] - end * last_coefficients[0];
    }
    least.min(pivot.abs()).min(last_pivot.abs()) > MIN_PIVOT_MAGNITUDE
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Substitutes the solution into the rows, for long systems and for the shortest.
        #[test]
        fn solutions_satisfy_all_rows(
            rows in prop::collection::vec((-1.0f64..1.0, 0.1f64..3.0, -1.0f64..1.0, -9.0f64..9.0), 3..90),
        ) {
            let n = rows.len();
            let row = |i: usize| { let (l, d, u, _) = rows[i]; [l, l.abs() + u.abs() + d, u] };
            let known = |i: usize| DVec3::new(rows[i].3, 1.0, -rows[i].3);
            let (mut unknowns, mut upper, mut across) = (vec![DVec3::ZERO; n], vec![0.0; n], vec![0.0; n]);
            prop_assert!(solve_cyclic(&mut unknowns, &mut upper, &mut across, |i, _| row(i), known));
            for i in 0..n {
                let [l, d, u] = row(i);
                let left = unknowns[(i + n - 1) % n] * l + unknowns[i] * d + unknowns[(i + 1) % n] * u;
                prop_assert!((left - known(i)).length() < 1e-12, "{i} of {n}");
            }
            unknowns[0] = DVec3::X;
            unknowns[n - 1] = DVec3::Y;
            prop_assert!(solve(&mut unknowns, &mut upper, row, known));
            for i in 1..n - 1 {
                let [l, d, u] = row(i);
                let left = unknowns[i - 1] * l + unknowns[i] * d + unknowns[i + 1] * u;
                prop_assert!((left - known(i)).length() < 1e-12, "{i} of {n}");
            }
            prop_assert_eq!((unknowns[0], unknowns[n - 1]), (DVec3::X, DVec3::Y));
        }
    }

    #[test]
    fn singular_systems_are_detected() {
        let (mut unknowns, mut upper, mut across) = ([DVec3::ONE; 4], [0.0; 4], [0.0; 4]);
        assert!(!solve(&mut unknowns, &mut upper, |_| [1.0, 0.0, 1.0], |_| DVec3::ZERO));
        assert!(!solve_cyclic(&mut unknowns, &mut upper, &mut across, |_, _| [-1.0, 2.0, -1.0], |_| DVec3::ZERO));
    }
}
