//! Cells that a level crosses once, as their corners show: what nearly all cells of a fine net are.
//!
//! The coefficients of the field are within a slack P of those of the bilinear field through the
//! corners. So a difference of neighbouring coefficients along u is within 2 P of a third of what
//! is between the steps from corner to corner: where these have one sign and are greater than 6 P,
//! the field is monotone in u. The zero set is then a graph, as in `cell`, and the sides show where
//! it enters and leaves: one that is monotone too is crossed once at most, as the signs of its ends
//! say, and one whose ends are farther than P from 0 and of one sign is not crossed. Neither the
//! field nor the patch is needed.

use super::cell::{CORNERS, SIDES};
use super::side::positive;
use gusset_base::simd::{self, Kernel};

/// How a level is in such a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum CornerCrossing {
    /// Not at all.
    Misses,
    /// As one arc.
    Crosses {
        /// The sides where it enters and where it leaves.
        sides: [usize; 2],
        /// The parameter, u (0) or v (1), that it is a graph over.
        over: usize,
        /// The least slope of the field in the other parameter.
        slope: f64,
    },
}

/// Classifies a cell by the values at its corners 2 u + v, if they suffice. Coefficients are within
/// `slack` of the bilinear ones; values up to `rounding_error` may be 0.
#[inline]
pub(super) fn crossing_by_corners(corners: [f64; 4], slack: f64, rounding_error: f64) -> Option<CornerCrossing> {
    let [c00, c01, c10, c11] = corners;
    // Of steps that have one sign the lesser, else 0.
    let min = |a: f64, b: f64| if (a > 0.0) == (b > 0.0) { a.abs().min(b.abs()) } else { 0.0 };
    let steps = [min(c10 - c00, c11 - c01), min(c01 - c00, c11 - c10)];
    let over = usize::from(steps[0] > steps[1]);
    let monotone = 6.0 * (slack + rounding_error);
    let slope = steps[1 - over] - monotone;
    if slope <= 0.0 || slope.is_nan() || corners.iter().any(|x| x.is_nan()) {
        return None;
    }
    // As `snapped` has them.
    let signs = corners.map(|x| positive(x + rounding_error));
    let mut sides = [SIDES; 2];
    for (side, [start, end]) in CORNERS.into_iter().enumerate() {
        let (rise, near) = ((corners[end] - corners[start]).abs(), corners[start].abs().min(corners[end].abs()));
        if signs[start] == signs[end] {
            if rise <= monotone && near <= slack + rounding_error {
                return None;
            }
        } else if rise <= STEEP * (slack + rounding_error) {
            return None;
        } else {
            let rising = signs[end];
            sides[usize::from(rising != (side >= 2))] = side;
        }
    }
    match sides {
        [SIDES, SIDES] => Some(CornerCrossing::Misses),
        [SIDES, _] | [_, SIDES] => None,
        _ => Some(CornerCrossing::Crosses { sides, over, slope }),
    }
}

/// Where a side's chord is 0, by the values at the corners.
#[inline]
pub(super) fn chord_root(corners: [f64; 4], side: usize) -> f64 {
    let [start, end] = CORNERS[side].map(|corner| corners[corner]);
    (start / (start - end)).clamp(0.0, 1.0)
}

/// How many times its slack a side that is crossed must rise by, for [`roots`].
///
/// With a rise of d >= 24 P its slope is from 3/4 d to 5/4 d, and its second derivative no greater
/// than 24 P <= d. The chord's root is no farther than P / (3/4 d) <= 1/18 from the polynomial's,
/// and a step of Newton's method leaves of an error e no more than 2/3 e^2: 3e-3, 3e-6, 5e-12,
/// 2e-23.
const STEEP: f64 = 24.0;
/// Steps of Newton's method.
const NEWTON: usize = 4;

/// Sides whose roots are found together.
pub(super) const LANES: usize = 8;

/// The roots of polynomials of degree 3 along sides that [`crossing_by_corners`] has found to be
/// crossed.
pub(super) fn roots(sides: &[[f64; 4]], found: &mut Vec<f64>) {
    simd::run(Roots { sides, found });
}

struct Roots<'a> {
    sides: &'a [[f64; 4]],
    found: &'a mut Vec<f64>,
}

impl Kernel for Roots<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        for sides in self.sides.chunks(LANES) {
            let mut c = [[0.0; LANES]; 4];
            for lane in 0..LANES {
                let side = &sides[lane.min(sides.len() - 1)];
                (0..4).for_each(|k| c[k][lane] = side[k]);
            }
            let mut t = [0.0; LANES];
            newton(&c, &mut t);
            self.found.extend_from_slice(&t[..sides.len()]);
        }
    }
}

#[inline(always)]
fn newton(c: &[[f64; LANES]; 4], t: &mut [f64; LANES]) {
    let clamped = |x: f64| {
        let x = if x > 0.0 { x } else { 0.0 };
        if x < 1.0 { x } else { 1.0 }
    };
    for lane in 0..LANES {
        t[lane] = clamped(c[0][lane] / (c[0][lane] - c[3][lane]));
    }
    for _ in 0..NEWTON {
        for lane in 0..LANES {
            let [a, b, d, e] = [c[0][lane], c[1][lane], c[2][lane], c[3][lane]];
            let at = t[lane];
            // De Casteljau's scheme.
            let (ab, bd, de) = (a + at * (b - a), b + at * (d - b), d + at * (e - d));
            let (low, high) = (ab + at * (bd - ab), bd + at * (de - bd));
            let rise = high - low;
            t[lane] = clamped(at - (low + at * rise) / (3.0 * rise));
        }
    }
    for lane in 0..LANES {
        // 0 at an end is positive: the sign changes there.
        let start = if c[0][lane] == 0.0 { 0.0 } else { t[lane] };
        t[lane] = if c[3][lane] == 0.0 { 1.0 } else { start };
    }
}
