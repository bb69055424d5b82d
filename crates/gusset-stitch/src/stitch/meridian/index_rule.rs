//! The paper's rule: every vertex of the longer rim gets one meridian. It leads to the nearest
//! vertex of the other rim when both rims are laid out evenly on segments of equal length.
//!
//! Source: section on the intermediate mesh. The longer rim has n segments, and the other m <= n.
//! Vertex i is joined to the j that minimises D_ij = |m i - n j|, the later of two equal ones. In
//! closed form j = floor((2 m i + n) / (2 n)). The printed double loop omits the last vertex and
//! most other meridians, because its bounds and braces are wrong. Its products overflow 32 bits
//! from about 46,000 vertices. The code below carries the division from one i to the next, without
//! products.
//!
//! An open polyline with N vertices has N - 1 segments; a closed one has N.

use super::rim_pair::MeridianEnds;
use gusset_base::alloc;
use gusset_base::error::Result;

/// Returns the j of every i = 0..=n, for 0 <= m <= n.
///
/// # Panics
/// If m > n. Exchange the roles, as the paper does.
pub fn index_rule(n: u32, m: u32) -> impl ExactSizeIterator<Item = u32> {
    assert!(m <= n, "the first polyline must have at least as many segments as the second");
    let (n, m) = (u64::from(n), u64::from(m));
    // 2 m i + n = 2 n j + remainder, 0 <= remainder < 2 n.
    let (mut j, mut remainder) = (0, n);
    (0..n as usize + 1).map(move |i| {
        if i > 0 {
            remainder += 2 * m;
            if remainder >= 2 * n {
                remainder -= 2 * n;
                j += 1;
            }
        }
        j
    })
}

/// Returns the meridians for `n` segments on rim A and `m` on rim B. Exchanges the roles if m > n.
pub(crate) fn meridians_by_index_rule(n: u32, m: u32) -> Result<Vec<MeridianEnds>> {
    if m <= n {
        alloc::collect(index_rule(n, m).enumerate().map(|(i, j)| [i as u32, j]))
    } else {
        alloc::collect(index_rule(m, n).enumerate().map(|(j, i)| [i, j as u32]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gusset_base::testing::case_count;

    /// Returns the j with the least |m i - n j| by enumeration, the later of equals.
    fn nearest_index_by_enumeration(n: u64, m: u64, i: u64) -> u64 {
        (0..=m).rev().min_by_key(|&j| (m * i).abs_diff(n * j)).unwrap()
    }

    #[test]
    fn index_rule_equals_the_least_distance_up_to_200() {
        // The counts 0..=200 cover the open rule up to 201 vertices, and the closed rule up to 200.
        for n in (0..=200u32).rev().step_by(200 / case_count(200) as usize) {
            for m in 0..=n {
                let expected = (0..=n).map(|i| nearest_index_by_enumeration(n.into(), m.into(), i.into()) as u32);
                assert!(index_rule(n, m).eq(expected), "{n} {m}");
            }
        }
    }

    #[test]
    fn index_rule_equals_the_closed_form_beyond_32_bits() {
        let (n, m) = (3_000_000u32, 2_999_999u32);
        for (i, j) in index_rule(n, m).enumerate() {
            let (n, m, i) = (u128::from(n), u128::from(m), i as u128);
            assert_eq!(u128::from(j), (2 * m * i + n) / (2 * n));
        }
    }

    #[test]
    fn the_papers_example_has_six_meridians() {
        // N = 6, M = 4, open: 1 2 2 3 3 4, counted from 1.
        assert!(index_rule(5, 3).eq([0, 1, 1, 2, 2, 3]));
    }

    #[test]
    fn roles_are_exchanged() {
        let forward = meridians_by_index_rule(7, 3).unwrap();
        let backward = meridians_by_index_rule(3, 7).unwrap();
        assert!(forward.iter().map(|&[i, j]| [j, i]).eq(backward));
        assert_eq!((forward[0], forward[7]), ([0, 0], [7, 3]));
    }
}
