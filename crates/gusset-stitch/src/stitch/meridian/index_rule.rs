//! The paper's rule: every vertex of the longer rim gets one meridian, to the vertex of the other
//! rim that is nearest when both rims are laid out evenly on segments of equal length.
//!
//! Source: section on the intermediate mesh. With n segments on the longer rim and m <= n on the
//! other, vertex i goes to the j that makes D_ij = |m i - n j| least, the later of two equal ones.
//! In closed form j = floor((2 m i + n) / (2 n)). The printed double loop leaves out the last
//! vertex and most other meridians (its bounds and braces are wrong), and its products overflow 32
//! bits from about 46,000 vertices on; the division below is carried from one i to the next,
//! without products.
//!
//! An open polyline of N vertices has N - 1 segments, a closed one N.

use super::rim_pair::Pair;
use gusset_base::alloc;
use gusset_base::error::Result;

/// The j of every i = 0..=n, for 0 <= m <= n.
///
/// # Panics
/// If m > n: exchange the roles, as the paper does.
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

/// The meridians for `n` segments on rim A and `m` on rim B; where m > n the roles are exchanged.
pub(crate) fn index_meridians(n: u32, m: u32) -> Result<Vec<Pair>> {
    if m <= n {
        alloc::collect(index_rule(n, m).enumerate().map(|(i, j)| [i as u32, j]))
    } else {
        alloc::collect(index_rule(m, n).enumerate().map(|(j, i)| [i, j as u32]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gusset_base::testing::cases;

    /// The j with the least |m i - n j|, by trying all, the later of equal ones.
    fn brute_force(n: u64, m: u64, i: u64) -> u64 {
        (0..=m).rev().min_by_key(|&j| (m * i).abs_diff(n * j)).unwrap()
    }

    #[test]
    fn equals_the_least_distance_for_all_counts_to_200() {
        // Segments 0..=200: the open rule for up to 201 vertices and the closed one for up to 200.
        for n in (0..=200u32).rev().step_by(200 / cases(200) as usize) {
            for m in 0..=n {
                let expected = (0..=n).map(|i| brute_force(n.into(), m.into(), i.into()) as u32);
                assert!(index_rule(n, m).eq(expected), "{n} {m}");
            }
        }
    }

    #[test]
    fn equals_the_closed_form_beyond_32_bits() {
        let (n, m) = (3_000_000u32, 2_999_999u32);
        for (i, j) in index_rule(n, m).enumerate() {
            let (n, m, i) = (u128::from(n), u128::from(m), i as u128);
            assert_eq!(u128::from(j), (2 * m * i + n) / (2 * n));
        }
    }

    #[test]
    fn the_papers_example_has_six_meridians() {
        // N = 6, M = 4, open: 1 2 2 3 3 4 counted from 1.
        assert!(index_rule(5, 3).eq([0, 1, 1, 2, 2, 3]));
    }

    #[test]
    fn roles_are_exchanged() {
        let forward = index_meridians(7, 3).unwrap();
        let backward = index_meridians(3, 7).unwrap();
        assert!(forward.iter().map(|&[i, j]| [j, i]).eq(backward));
        assert_eq!((forward[0], forward[7]), ([0, 0], [7, 3]));
    }
}
