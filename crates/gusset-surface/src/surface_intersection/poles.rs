//! Proof that a sheet is injective around a pole.
//!
//! At a pole S(0, v) = c, the sheet is S = c + u T(u, v). Let r and a be the radius and the angle
//! of u T in a plane. Their derivatives with respect to s = log u and v are
//!
//! r_s / r = 1 + T . u T_u / T^2, r_v / r = T . T_v / T^2,
//! a_s = T x u T_u / T^2, a_v = T x T_v / T^2.
//!
//! Suppose that min(r_s / r) min(a_v) > max |r_v / r| max |a_s| over all cells around the pole. Two
//! points with equal log r and a are then the same point. This follows from the mean values of
//! these derivatives for differences in (s, v), all of which lie in a convex region. After one
//! turn, a has increased by 2 pi. The sheet is therefore injective over the plane, and so in space.
//!
//! Cost: O(N^3) for each cell and depth.

use super::height_graph::Interval;
use crate::Patch;
use crate::cells::SheetCells;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::bernstein::elevate;
use gusset_base::job::Job;
use std::f64::consts::TAU;

/// Largest number of halvings towards the pole.
const MAX_BAND_HALVINGS: i32 = 8;
/// Number of cells between two progress reports.
const CELLS_PER_REPORT: usize = 1 << 8;
/// Number of pieces of a cell around the pole.
const PIECES_PER_CELL: usize = 8;

/// The patch of cell k along a border, with u running inwards from the border.
pub(super) fn patch_from_border<const N: usize>(
    cells: &impl SheetCells<N>,
    direction: usize,
    side: usize,
    k: usize,
) -> Patch<N> {
    let last = cells.cell_counts()[direction] - 1;
    let at = if side == 0 { 0 } else { last };
    let mut patch = match direction {
        0 => cells.cell_patch(at, k),
        _ => cells.cell_patch(k, at).transposed(),
    };
    if side == 1 {
        patch.points.reverse();
    }
    patch
}

/// T, raised to degree N - 1.
fn pole_quotient_patch<const N: usize>(patch: &Patch<N>) -> Patch<N> {
    let mut points = [[DVec3::ZERO; N]; N];
    for a in 1..N {
        let factor = (N - 1) as f64 / a as f64;
        let rises = patch.points[a].iter().zip(&patch.points[0]).map(|(p, apex)| factor * (p - apex));
        points[a - 1].iter_mut().zip(rises).for_each(|(point, rise)| *point = rise);
    }
    elevate(&mut points, N - 2);
    Patch { points }
}

/// Bounds over pieces.
struct InjectivityBoundsAtPole {
    /// The smallest r_s / r, and the smallest a_v.
    least_radial_and_angular_slope: [f64; 2],
    /// The largest |r_v / r|, and the largest |a_s|.
    greatest_cross_slopes: [f64; 2],
    /// The total angle at the pole, and the largest deviation from it elsewhere.
    total_angle_at_pole: f64,
    max_angle_deviation: f64,
}

impl InjectivityBoundsAtPole {
    /// Adds a piece. Returns `None` if its derivatives cannot be bounded. `normal` is the normal of
    /// the plane.
    fn add_piece<const N: usize>(&mut self, piece: &Patch<N>, normal: DVec3) -> Option<()> {
        let middle = piece.point(0.5, 0.5);
        let x = (middle - normal * middle.dot(normal)).try_normalize()?;
        let axes = [x, normal.cross(x)];
        let degree = (N - 1) as f64;
        let flat = piece.points.map(|row| row.map(|p| axes.map(|axis| p.dot(axis))));
        let mut value = flat[0][0].map(Interval::single_number);
        let (mut by_u, mut by_v) = ([Interval::single_number(0.0); 2], [const { None }; 2]);
        for (a, b, k) in (0..N * N * 2).map(|n| (n / 2 / N, n / 2 % N, n % 2)) {
            value[k] = value[k].extended_to(flat[a][b][k]);
            if a + 1 < N {
                // u T_u, with u from 0 to 1 in the piece's own parameters.
                by_u[k] = by_u[k].extended_to(degree * (flat[a + 1][b][k] - flat[a][b][k]));
            }
            if b + 1 < N {
                let slope = degree * (flat[a][b + 1][k] - flat[a][b][k]) * PIECES_PER_CELL as f64;
                by_v[k] =
                    Some(by_v[k].map_or(Interval::single_number(slope), |range: Interval| range.extended_to(slope)));
            }
        }
        let by_v = [by_v[0]?, by_v[1]?];
        if value[0].low <= 0.0 {
            return None;
        }
        let square = Interval::single_number(0.0).extended_to((value[1].low.abs()).max(value[1].high.abs()).powi(2));
        let inverse = (value[0] * value[0] + square).reciprocal()?;
        let along = |slope: [Interval; 2]| (value[0] * slope[0] + value[1] * slope[1]) * inverse;
        let across = |slope: [Interval; 2]| (value[0] * slope[1] - value[1] * slope[0]) * inverse;
        let size = |range: Interval| range.low.abs().max(range.high.abs());
        self.least_radial_and_angular_slope[0] = self.least_radial_and_angular_slope[0].min(1.0 + along(by_u).low);
        self.least_radial_and_angular_slope[1] = self.least_radial_and_angular_slope[1].min(across(by_v).low);
        self.greatest_cross_slopes[0] = self.greatest_cross_slopes[0].max(size(along(by_v)));
        self.greatest_cross_slopes[1] = self.greatest_cross_slopes[1].max(size(across(by_u)));
        let [from, to] = [flat[0][0], flat[0][N - 1]].map(|[x, y]| libm::atan2(y, x));
        self.total_angle_at_pole += to - from;
        self.max_angle_deviation = self.max_angle_deviation.max(libm::atan(size(value[1]) / value[0].low));
        Some(())
    }

    /// Whether the bounds prove the sheet injective.
    fn prove_injective(&self, is_ring: bool) -> bool {
        let is_finite = [self.least_radial_and_angular_slope, self.greatest_cross_slopes]
            .as_flattened()
            .iter()
            .all(|x| x.is_finite());
        let is_dominant = self.least_radial_and_angular_slope[0] > 0.0
            && self.least_radial_and_angular_slope[1] > 0.0
            && self.least_radial_and_angular_slope[0] * self.least_radial_and_angular_slope[1]
                > (1.0 + 1e-9) * self.greatest_cross_slopes[0] * self.greatest_cross_slopes[1];
        let once = if is_ring {
            self.total_angle_at_pole < 1.5 * TAU
        } else {
            self.total_angle_at_pole + 2.0 * self.max_angle_deviation < TAU
        };
        is_finite && is_dominant && once
    }
}

/// The smallest number of halvings towards a pole after which the sheet is proven injective there.
/// `is_ring` tells whether the last cell around the pole is followed by the first.
pub(super) fn halvings_until_injective_at_pole<const N: usize>(
    cells: &impl SheetCells<N>,
    direction: usize,
    side: usize,
    is_ring: bool,
    job: &Job<'_>,
) -> Result<Option<i32>> {
    let count = cells.cell_counts()[1 - direction];
    let mut quotients =
        alloc::collect((0..count).map(|k| pole_quotient_patch(&patch_from_border(cells, direction, side, k))))?;
    for band in 0..=MAX_BAND_HALVINGS {
        if are_quotients_injective(&quotients, is_ring, job)? {
            return Ok(Some(band));
        }
        quotients.iter_mut().for_each(|patch| *patch = patch.halves()[0]);
    }
    Ok(None)
}

fn are_quotients_injective<const N: usize>(quotients: &[Patch<N>], is_ring: bool, job: &Job<'_>) -> Result<bool> {
    let fan = |patch: &Patch<N>| patch.points[0].windows(2).map(|pair| pair[0].cross(pair[1])).sum::<DVec3>();
    let Some(normal) = quotients.iter().map(fan).sum::<DVec3>().try_normalize() else {
        return Ok(false);
    };
    let mut bounds = InjectivityBoundsAtPole {
        least_radial_and_angular_slope: [f64::INFINITY; 2],
        greatest_cross_slopes: [0.0; 2],
        total_angle_at_pole: 0.0,
        max_angle_deviation: 0.0,
    };
    let pieces = |patch: &Patch<N>| {
        let eighths = |half: Patch<N>| half.halves().map(|quarter| quarter.halves());
        patch.transposed().halves().map(eighths)
    };
    for (k, patch) in quotients.iter().enumerate() {
        if (k + 1).is_multiple_of(CELLS_PER_REPORT) {
            job.step(0.0, "poles")?;
        }
        let pieces = pieces(patch);
        let mut pieces = pieces.as_flattened().as_flattened().iter();
        if !pieces.all(|piece| bounds.add_piece(&piece.transposed(), normal).is_some()) {
            return Ok(false);
        }
    }
    Ok(bounds.prove_injective(is_ring))
}
