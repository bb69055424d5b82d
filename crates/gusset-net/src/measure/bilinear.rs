//! The area of the bilinear patches of the cells, exact up to rounding.
//!
//! On the patch through a, b, c, d, S(u, v) = a + u (b - a) + v (d - a) + u v e with e = a - b +
//! c - d. The normal S_u x S_v = N0 + u N1 + v N2 is linear in u and v:
//!
//! ```text
//! N0 = (b - a) x (d - a),  N1 = (b - a) x e,  N2 = e x (d - a).
//! ```
//!
//! The area is the integral of the normal's length over the unit square. If |N1| + |N2| is small
//! relative to the length in the middle, the nearest singularity of the integrand is far from the
//! square. A Gauss rule of few nodes is then exact up to rounding.
//!
//! Otherwise the integral over u, which is the mean distance of a segment from the origin, is
//! elementary. The integral over v is divided where the normal is smallest at u = 0 and at u = 1,
//! because the integral over a folded plane cell has kinks there. It is then halved until the
//! halves agree with the whole. O(nodes).

use crate::chunks::lines_per_block;
use crate::hidden_cells::HiddenCells;
use crate::{Net, each};
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_base::par;

/// The area of all patches.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BilinearArea {
    /// The sum of the areas.
    pub area: f64,
    /// A bound of the error: the differences between halves and wholes, and rounding.
    pub error_bound: f64,
}

/// Nodes and weights of Gauss rules on [0, 1], with three and seven nodes.
const GAUSS_RULE_3: [[f64; 2]; 3] =
    [[0.112_701_665_379_258_3, 5.0 / 18.0], [0.5, 4.0 / 9.0], [0.887_298_334_620_741_7, 5.0 / 18.0]];
const GAUSS_RULE_7: [[f64; 2]; 7] = [
    [0.025_446_043_828_620_737, 0.064_742_483_084_434_85],
    [0.129_234_407_200_302_78, 0.139_852_695_744_638_34],
    [0.297_077_424_311_301_4, 0.190_915_025_252_559_47],
    [0.5, 0.208_979_591_836_734_7],
    [0.702_922_575_688_698_6, 0.190_915_025_252_559_47],
    [0.870_765_592_799_697_2, 0.139_852_695_744_638_34],
    [0.974_553_956_171_379_3, 0.064_742_483_084_434_85],
];

/// The largest ratio of |N1| + |N2| to the length of the normal in the middle for three nodes. The
/// singularities are then 127 half sides away, and the error is 254^-6 times the square of the
/// ratio, below rounding.
const MAX_NORMAL_RATIO_3: f64 = 1.0 / 64.0;
/// The largest ratio for seven nodes: singularities are 7 half sides away, and 13.9^-14 = 1e-16.
const MAX_NORMAL_RATIO_7: f64 = 0.25;
/// The maximum depth of halved intervals.
const MAX_INTERVAL_HALVINGS: u32 = 48;
/// The maximum number of halved intervals. Near a kink one of the halves agrees soon, so few
/// intervals are needed.
const MAX_HALVED_INTERVALS: u32 = 1024;
/// The relative rounding error of a patch's area.
const RELATIVE_ROUNDING_ERROR: f64 = 16.0 * f64::EPSILON;

/// Returns the area of the bilinear patches of all existing cells; cells with coincident corners
/// are triangles or less. Every layer of a patch that folds over itself counts. O(nodes), with
/// constant extra memory and about ten times the work of [`measure`](super::measure).
///
/// # Errors
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled).
pub fn bilinear_area(net: &Net<'_>, job: &Job<'_>) -> Result<BilinearArea> {
    let hidden = HiddenCells::new(net)?;
    let (rows, columns) = (net.shape().rows() - 1, net.shape().columns() - 1);
    let parts = par::map_cancellable(job, "measure", par::split_into_ranges(rows, lines_per_block(columns)), |rows| {
        let mut sum = BilinearArea::default();
        for i in rows {
            for j in hidden.visible_runs(i).flatten() {
                let [a, b, c, d] = each!(net.coordinates(), planes => planes.cell_corners(i, j));
                if ((a + c) + (b + d)).is_finite() {
                    sum = sum.add(patch_area([a, b, c, d]));
                }
            }
        }
        sum
    })?;
    Ok(parts.into_iter().fold(BilinearArea::default(), BilinearArea::add))
}

impl BilinearArea {
    fn add(self, other: BilinearArea) -> BilinearArea {
        BilinearArea { area: self.area + other.area, error_bound: self.error_bound + other.error_bound }
    }
}

fn patch_area(corners: [DVec3; 4]) -> BilinearArea {
    let (sides, units) = scale_sides(corners);
    let found = patch_area_from_sides(sides);
    let in_units_of_host = |area: f64| units.iter().fold(area, |area, unit| area * unit * unit);
    BilinearArea { area: in_units_of_host(found.area), error_bound: in_units_of_host(found.error_bound) }
}

/// Returns the vectors b - a, d - a, the twist e and c - b of a patch, divided by two units, so that
/// the eighth powers of lengths are in range. The first unit is at least 2^-900; subnormal sides
/// need the second.
fn scale_sides([a, b, c, d]: [DVec3; 4]) -> ([DVec3; 4], [f64; 2]) {
    let mut sides = [b - a, d - a, (a - b) + (c - d), c - b];
    let units = [(); 2].map(|()| {
        let unit = common_unit(&sides);
        sides = sides.map(|side| side / unit);
        unit
    });
    (sides, units)
}

/// Returns the area of a patch, given its sides at the first corner, its twist, and the vector from
/// the second to the third corner.
fn patch_area_from_sides([p, q, e, other]: [DVec3; 4]) -> BilinearArea {
    let (n0, n1, n2) = (p.cross(q), p.cross(e), e.cross(q));
    let middle = (p + other).cross(q - p).length() / 2.0;
    let change = n1.length() + n2.length();
    let area = if change <= MAX_NORMAL_RATIO_3 * middle {
        integrate_normal_length(&GAUSS_RULE_3, n0, n1, n2)
    } else if change <= MAX_NORMAL_RATIO_7 * middle {
        integrate_normal_length(&GAUSS_RULE_7, n0, n1, n2)
    } else {
        let section = |v: f64| mean_distance_from_origin(n0 + v * n2, n1);
        let scale = middle + change;
        let least = |start: DVec3| (-start.dot(n2) / n2.length_squared()).clamp(0.0, 1.0);
        let kinks = [least(n0), least(n0 + n1)].map(|v| if v.is_nan() { 0.0 } else { v });
        let cuts = [0.0, kinks[0].min(kinks[1]), kinks[0].max(kinks[1]), 1.0];
        let parts = cuts.windows(2).filter(|cut| cut[0] < cut[1]);
        let parts = parts.map(|cut| integrate_adaptively(&section, [cut[0], cut[1]], 4.0 * f64::EPSILON * scale));
        return parts.fold(BilinearArea { area: 0.0, error_bound: RELATIVE_ROUNDING_ERROR * scale }, BilinearArea::add);
    };
    BilinearArea { area, error_bound: RELATIVE_ROUNDING_ERROR * area }
}

/// Returns the integral of |N0 + u N1 + v N2| over the unit square by the tensor product of a rule.
#[inline(always)]
fn integrate_normal_length(rule: &[[f64; 2]], n0: DVec3, n1: DVec3, n2: DVec3) -> f64 {
    let row = |v: f64| rule.iter().map(|&[u, weight]| weight * (n0 + v * n2 + u * n1).length()).sum::<f64>();
    rule.iter().map(|&[v, weight]| weight * row(v)).sum()
}

/// Returns the integral of |p + u q| over u from 0 to 1, the mean distance of a segment from the
/// origin.
///
/// Let h be the distance of its line, and s the coordinate on the line from the foot of h. The
/// integral is the difference of (s sqrt(h^2 + s^2) + h^2 asinh(s / h)) / 2 over |q|, unless that
/// cancels.
fn mean_distance_from_origin(p: DVec3, q: DVec3) -> f64 {
    let length = q.length();
    if (p + 0.5 * q).length() >= 3.5 * length {
        return GAUSS_RULE_7.iter().map(|&[u, weight]| weight * (p + u * q).length()).sum();
    }
    let (h, s) = (p.cross(q).length() / length, p.dot(q) / length);
    let integral = |s: f64| {
        let bent = if h > 1e-300 { h * h * libm::asinh(s / h) } else { 0.0 };
        (s * libm::hypot(h, s) + bent) / 2.0
    };
    (integral(s + length) - integral(s)) / length
}

/// Returns the integral over an interval, by halving until halves and wholes agree within the
/// tolerance twice in a row, because a single agreement may be chance. The error bound covers
/// intervals that do not agree after the maximum number of halvings.
fn integrate_adaptively(f: &dyn Fn(f64) -> f64, [start, end]: [f64; 2], tolerance: f64) -> BilinearArea {
    let gauss = |from: f64, width: f64| {
        width * GAUSS_RULE_7.iter().map(|&[v, weight]| weight * f(from + width * v)).sum::<f64>()
    };
    let mut found = BilinearArea::default();
    // Open intervals, the leftmost on top: start, width, integral, depth, and whether the parent
    // interval agreed.
    let mut open = vec![(start, end - start, gauss(start, end - start), 0, false)];
    let mut halved = 0;
    while let Some((from, width, whole, depth, agreed)) = open.pop() {
        let half = width / 2.0;
        let [left, right] = [from, from + half].map(|from| gauss(from, half));
        let difference = (left + right - whole).abs();
        let agrees = difference <= tolerance;
        let is_last = depth == MAX_INTERVAL_HALVINGS || halved == MAX_HALVED_INTERVALS;
        if (agrees && agreed) || is_last || difference.is_nan() {
            found = found.add(BilinearArea { area: left + right, error_bound: difference });
        } else {
            halved += 1;
            open.extend([(from + half, half, right, depth + 1, agrees), (from, half, left, depth + 1, agrees)]);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::{MAX_HALVED_INTERVALS, integrate_adaptively, patch_area_from_sides, scale_sides};
    use glam::DVec3;
    use std::cell::Cell;

    #[test]
    fn an_integrand_that_never_agrees_ends_the_halving() {
        let calls = Cell::new(0_u32);
        let noise = |v: f64| {
            calls.set(calls.get() + 1);
            (v.to_bits().wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 11) as f64
        };
        let found = integrate_adaptively(&noise, [0.0, 1.0], 0.0);
        // A rule of 7 nodes for both halves of each interval that was open.
        assert!(calls.get() <= 14 * (2 * MAX_HALVED_INTERVALS + 2), "{}", calls.get());
        assert!(found.area.is_finite() && found.error_bound > 0.0);
    }

    #[test]
    fn cells_of_any_size_have_the_sides_of_one_size() {
        let mut state = 60_u64;
        let mut integer = || {
            state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(1);
            (state >> 48) as f64 - 32768.0
        };
        for _ in 0..200 {
            let corners = [(); 4].map(|()| DVec3::new(integer(), integer(), integer()));
            let expected = scale_sides(corners);
            // At 2^-1074 the coordinates are the smallest numbers.
            for exponent in [-1074, -1050, -1000, -900, -500, 0, 500, 900] {
                // In two steps, because the power itself may be subnormal.
                let [half, rest] = [exponent / 2, exponent - exponent / 2].map(|k| 2f64.powi(k));
                let (sides, units) = scale_sides(corners.map(|p| p * half * rest));
                let largest = sides.iter().fold(0.0, |m: f64, side| m.max(side.abs().max_element()));
                assert!((1.0..2.0).contains(&largest), "{exponent}: {largest}");
                assert_eq!(sides, expected.0, "{exponent}");
                assert_eq!(units[0] * units[1], expected.1[0] * half * rest, "{exponent}");
                assert_eq!(patch_area_from_sides(sides), patch_area_from_sides(expected.0));
            }
        }
    }
}
