//! Recognises cells that a level crosses at most once from their corners. Nearly all cells of a
//! fine net are of this kind.
//!
//! The coefficients of the field are within a slack P of the coefficients of the bilinear field
//! through the corners. A difference of neighbouring coefficients along u is therefore within 2 P
//! of a third of a value between the two steps from corner to corner. If both steps have one sign
//! and exceed 6 P, the field is monotone in u. The zero set is then a graph, as in `cell_arcs`, and
//! the sides tell where it enters and leaves. A side that is monotone too is crossed at most once,
//! according to the signs of its ends. A side whose ends have one sign and exceed P is not crossed.
//! The test uses the corners only.

use super::cell_arcs::{CORNERS_OF_SIDES, SIDES_PER_CELL};
use super::side_sign_changes::counts_as_positive;

/// How a level crosses a simple cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum CornerCrossing {
    /// The level does not cross the cell.
    Misses,
    /// The level crosses the cell in one arc.
    Crosses {
        /// The sides where the arc enters and leaves.
        sides: [usize; 2],
        /// The parameter, u (0) or v (1), over which the arc is a graph.
        over: usize,
        /// A lower bound of the field's slope in the other parameter.
        slope: f64,
    },
}

/// Decides from the corner values (index 2 u + v) whether level 0 misses a cell or crosses it in
/// one arc. Returns `None` if the corners do not decide. Each coefficient is at most `slack` away
/// from the bilinear one. The sign of values up to `rounding_error` is unknown.
#[inline]
pub(super) fn decide_crossing_by_corners(corners: [f64; 4], slack: f64, rounding_error: f64) -> Option<CornerCrossing> {
    let [c00, c01, c10, c11] = corners;
    // The smaller of two steps if they have one sign, else 0.
    let min = |a: f64, b: f64| if (a > 0.0) == (b > 0.0) { a.abs().min(b.abs()) } else { 0.0 };
    let steps = [min(c10 - c00, c11 - c01), min(c01 - c00, c11 - c10)];
    let over = usize::from(steps[0] > steps[1]);
    let monotone = 6.0 * (slack + rounding_error);
    let slope = steps[1 - over] - monotone;
    if slope <= 0.0 || slope.is_nan() || corners.iter().any(|x| x.is_nan()) {
        return None;
    }
    // Equivalent to the signs after `snap_to_zero`.
    let signs = corners.map(|x| counts_as_positive(x + rounding_error));
    let mut sides = [SIDES_PER_CELL; 2];
    for (side, [start, end]) in CORNERS_OF_SIDES.into_iter().enumerate() {
        let (rise, near) = ((corners[end] - corners[start]).abs(), corners[start].abs().min(corners[end].abs()));
        if signs[start] == signs[end] {
            if rise <= monotone && near <= slack + rounding_error {
                return None;
            }
        } else if rise <= MIN_SIDE_RISE_IN_SLACKS * (slack + rounding_error) {
            return None;
        } else {
            let rising = signs[end];
            sides[usize::from(rising != (side >= 2))] = side;
        }
    }
    match sides {
        [SIDES_PER_CELL, SIDES_PER_CELL] => Some(CornerCrossing::Misses),
        [SIDES_PER_CELL, _] | [_, SIDES_PER_CELL] => None,
        _ => Some(CornerCrossing::Crosses { sides, over, slope }),
    }
}

/// The zero of a side's chord, from the values at the corners.
#[inline]
pub(super) fn root_of_side_chord(corners: [f64; 4], side: usize) -> f64 {
    let [start, end] = CORNERS_OF_SIDES[side].map(|corner| corners[corner]);
    (start / (start - end)).clamp(0.0, 1.0)
}

/// Smallest rise of a crossed side for `side_roots`, in units of its slack.
///
/// If the rise is d >= 24 P, the slope is between 3/4 d and 5/4 d, and the second derivative at
/// most 24 P <= d. The chord's root is within P / (3/4 d) <= 1/18 of the polynomial's root. A
/// Newton step reduces an error e to at most 2/3 e^2: 3e-3, 3e-6, 5e-12, 2e-23.
const MIN_SIDE_RISE_IN_SLACKS: f64 = 24.0;
