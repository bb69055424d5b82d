//! Tridiagonal systems whose unknowns are points, open and cyclic, by elimination without exchanges: for rows that are dominant.

use glam::DVec3;

/// A row whose diagonal element comes out smaller than this, of coefficients near 1, makes the system singular.
const SINGULAR: f64 = 1e-14;

/// What the last unknown of a cyclic system contributes is left out below this.
const FAINT: f64 = 1e-40;

/// Solves for `unknowns[1..n - 1]`; the first and the last one are given. `row(i)`: the coefficients of unknowns i - 1, i and i + 1;
/// `known(i)`: the right side. `upper`: room for n factors. False if the system is singular.
///
/// Source: Thomas's algorithm.
pub(super) fn solve(
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
        sound &= diagonal.abs() > SINGULAR;
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

/// A cyclic system of n >= 3 unknowns, and the room to solve it in: n factors of each kind.
pub(super) struct Cyclic<'a> {
    pub(super) unknowns: &'a mut [DVec3],
    pub(super) upper: &'a mut [f64],
    pub(super) across: &'a mut [f64],
}

impl Cyclic<'_> {
    /// Solves it. `row(i, before)`: the coefficients of unknowns `before` (i - 1, round the end), i and i + 1; `known(i)`: the right side.
    /// False if the system is singular.
    ///
    /// As for an open system, with the last unknown carried along: by `across` in the rows from the first one on, and by `far`
    /// in the last row, until both have faded away.
    pub(super) fn solve(self, row: impl Fn(usize, usize) -> [f64; 3], known: impl Fn(usize) -> DVec3) -> bool {
        let Cyclic { unknowns, upper, across } = self;
        let n = unknowns.len();
        let (upper, across) = (&mut upper[..n], &mut across[..n]);
        let [mut far_lower, mut far_diagonal, mut far] = row(n - 1, n - 2);
        let mut far_known = known(n - 1);
        let [lower, diagonal, above] = row(0, n - 1);
        let mut sound = diagonal.abs() > SINGULAR;
        let scale = 1.0 / diagonal;
        upper[0] = above * scale;
        across[0] = lower * scale;
        unknowns[0] = known(0) * scale;
        let mut carried = 1;
        while carried < n - 1 && (across[carried - 1].abs() > FAINT || far.abs() > FAINT) {
            let i = carried;
            far_diagonal -= far * across[i - 1];
            far_known -= unknowns[i - 1] * far;
            far *= -upper[i - 1];
            let [lower, diagonal, above] = row(i, i - 1);
            let diagonal = diagonal - lower * upper[i - 1];
            sound &= diagonal.abs() > SINGULAR;
            let scale = 1.0 / diagonal;
            across[i] = -lower * across[i - 1] * scale;
            upper[i] = above * scale;
            unknowns[i] = (known(i) - unknowns[i - 1] * lower) * scale;
            carried += 1;
        }
        let (mut before, mut ratio) = (unknowns[carried - 1], upper[carried - 1]);
        for i in carried..n - 1 {
            let [lower, diagonal, above] = row(i, i - 1);
            let diagonal = diagonal - lower * ratio;
            sound &= diagonal.abs() > SINGULAR;
            let scale = 1.0 / diagonal;
            before = (known(i) - before * lower) * scale;
            ratio = above * scale;
            unknowns[i] = before;
            upper[i] = ratio;
        }
        // If nothing has faded, the last row meets the one before it in both ways.
        if carried == n - 1 {
            far_lower += far;
            far_diagonal -= far_lower * (upper[n - 2] + across[n - 2]);
        } else {
            far_diagonal -= far_lower * upper[n - 2];
        }
        sound &= far_diagonal.abs() > SINGULAR;
        let last = (far_known - unknowns[n - 2] * far_lower) / far_diagonal;
        unknowns[n - 1] = last;
        let mut after = last;
        for i in (carried..n - 1).rev() {
            after = unknowns[i] - after * upper[i];
            unknowns[i] = after;
        }
        for i in (0..carried).rev() {
            after = unknowns[i] - after * upper[i] - last * across[i];
            unknowns[i] = after;
        }
        sound
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// The rows hold for what comes out, in long systems and in the shortest.
        #[test]
        fn rows_hold(
            rows in prop::collection::vec((-1.0f64..1.0, 0.1f64..3.0, -1.0f64..1.0, -9.0f64..9.0), 3..90),
        ) {
            let n = rows.len();
            let row = |i: usize| { let (l, d, u, _) = rows[i]; [l, l.abs() + u.abs() + d, u] };
            let known = |i: usize| DVec3::new(rows[i].3, 1.0, -rows[i].3);
            let (mut unknowns, mut upper, mut across) = (vec![DVec3::ZERO; n], vec![0.0; n], vec![0.0; n]);
            let system = Cyclic { unknowns: &mut unknowns, upper: &mut upper, across: &mut across };
            prop_assert!(system.solve(|i, _| row(i), known));
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
    fn singular_systems_are_told() {
        let (mut unknowns, mut upper, mut across) = ([DVec3::ONE; 4], [0.0; 4], [0.0; 4]);
        assert!(!solve(&mut unknowns, &mut upper, |_| [1.0, 0.0, 1.0], |_| DVec3::ZERO));
        let system = Cyclic { unknowns: &mut unknowns, upper: &mut upper, across: &mut across };
        assert!(!system.solve(|_, _| [-1.0, 2.0, -1.0], |_| DVec3::ZERO));
    }
}
