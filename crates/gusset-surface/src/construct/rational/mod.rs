//! Converts rational splines to polynomial patches of degree 7 in the same parameters.
//!
//! The spans of the spline are cut, whole rows and columns at a time, until the piece of every cell
//! is within the tolerance. [`piece_fit`] computes the pieces. [`difference_bound`] proves their
//! distance for all parameters. The bound includes the rounding of the cells' control points, of
//! the bound itself, and of the result. Errors decrease with the eighth power of the size of cells.

mod difference_bound;
mod piece_fit;

use self::difference_bound::HomogeneousDifference;
use self::piece_fit::{ExactBorderPoints, FitMatrices};
use super::spline::{PieceNet, Spline, SplineInterval, SplineOptions, SplinePiece, knots_at_cell_borders};
use crate::patches::SplineOrigin;
use crate::{Patch, Patches};
use glam::DVec3;
use glam::DVec4;
use gusset_base::error::{Allowed, Error, Result};
use gusset_base::geom::Aabb;
use gusset_base::geom::scale::{common_unit, floor_to_power_of_two};
use gusset_base::job::Job;
use gusset_base::{alloc, par};

/// Default for the largest number of cells.
const DEFAULT_MAX_CELLS: usize = 1 << 20;

/// Default tolerance, relative to the diagonal of the bounding box of the control points.
const DEFAULT_RELATIVE_TOLERANCE: f64 = 1e-12;

/// Smallest weight relative to the largest one. Products of larger weights do not underflow
/// noticeably.
const MIN_RELATIVE_WEIGHT: f64 = 1.183_052_186_166_774e-271;

/// The relative rounding error of one operation, 2^-53.
const UNIT_ROUNDING_ERROR: f64 = 0.5 * f64::EPSILON;

/// Largest number of parts that an interval is cut into in one pass.
const MAX_PARTS_PER_INTERVAL: f64 = 16.0;

/// Number of cells that a thread computes in one task, which takes some milliseconds.
const CELLS_PER_TASK: usize = 64;
/// Number of cells copied between two progress reports, 1.5 KB each.
const CELLS_PER_REPORT: usize = 1 << 12;
const PROGRESS_STAGE: &str = "fitting patches";

/// Whether the spline has weights that differ.
///
/// # Errors
/// [`Error::BadWeight`], [`Error::ArrayTooShort`].
pub(super) fn has_different_weights(spline: &Spline<'_>) -> Result<bool> {
    let Some(given) = spline.weights else { return Ok(false) };
    let count = spline.counts[0] * spline.counts[1];
    let Some(weights) = given.get(..count) else {
        let bytes = |count: usize| 8 * count as u64;
        return Err(Error::ArrayTooShort { what: "weights", needed: bytes(count), given: bytes(given.len()) });
    };
    let bad = |of: &dyn Fn(f64) -> bool| match weights.iter().position(|&weight| of(weight)) {
        Some(index) => Err(Error::BadWeight { index: index as u64, value: weights[index] }),
        None => Ok(()),
    };
    bad(&|weight| !(weight > 0.0 && weight.is_finite()))?;
    let greatest = weights.iter().fold(0.0, |greatest: f64, &weight| greatest.max(weight));
    bad(&|weight| weight / greatest < MIN_RELATIVE_WEIGHT)?;
    Ok(weights.iter().any(|&weight| weight != weights[0]))
}

/// A spline in a scaled and shifted system in which its coordinates are about 1 or less.
struct ScaledRationalSpline<'a> {
    spline: &'a Spline<'a>,
    /// The scale, a power of two.
    unit: f64,
    /// The centre of the bounding box of the control points, in this scale.
    box_centre: DVec3,
    /// Homogeneous coordinates w x, w y, w z and w of the control points.
    homogeneous: Vec<DVec4>,
    fit_matrices: FitMatrices,
    /// Largest permitted bound of a cell, in this scale.
    max_cell_bound: f64,
    /// Rounding to add to the bounds.
    rounding: f64,
    /// The largest distance of a control point from the centre.
    radius: f64,
}

/// The fitted cell.
#[derive(Clone, Copy)]
struct FittedCell {
    patch: Patch<8>,
    /// Bound of the distance from the rational surface, without rounding.
    distance_bound: f64,
    /// Number of parts that the cell should be cut into in u and in v.
    parts: [u8; 2],
}

/// Computes patches within the tolerance of the spline, over intervals that cover all its spans.
pub(super) fn fit_patches(
    spline: &Spline<'_>,
    mut intervals: [Vec<SplineInterval>; 2],
    options: &SplineOptions,
    job: &Job<'_>,
) -> Result<Patches<8>> {
    let rational = ScaledRationalSpline::new(spline, options)?;
    let limit = options.max_cells.unwrap_or(DEFAULT_MAX_CELLS) as u64;
    // All cells ever computed, by task so that they do not move, and the index of each grid cell.
    let mut tasks: Vec<Vec<FittedCell>> = Vec::new();
    let mut grid: Vec<usize> = Vec::new();
    // For each row and each column, its index in the grid of the previous pass, if it was not cut.
    let mut kept: [Vec<Option<usize>>; 2] = Default::default();
    let mut width = 0;
    for pass in 0.. {
        let counts = [intervals[0].len(), intervals[1].len()];
        Error::check_count("cells", counts[0] as u64 * counts[1] as u64, limit)?;
        // Progress increases monotonically for any number of passes.
        let part = job.sub_job(1.0 - 0.5_f64.powi(pass), 1.0 - 0.5_f64.powi(pass + 1));
        let [u, v] = spline.bezier_pieces_by_direction(&intervals)?;
        let known = |i: usize, j: usize| -> Option<usize> {
            let (row, column) = (*kept[0].get(i)?, *kept[1].get(j)?);
            grid.get(row? * width + column?).copied()
        };
        let (mut now, mut new) = (alloc::with_capacity(counts[0] * counts[1])?, Vec::new());
        for i in 0..counts[0] {
            part.step(0.0, PROGRESS_STAGE)?;
            for j in 0..counts[1] {
                let next = tasks.len() * CELLS_PER_TASK + new.len();
                let cell = known(i, j).unwrap_or(next);
                now.push(cell);
                if cell == next {
                    alloc::push(&mut new, [i, j])?;
                }
            }
        }
        let made = par::map_cancellable(&part, PROGRESS_STAGE, new.chunks(CELLS_PER_TASK), |some| {
            alloc::collect(some.iter().map(|&[i, j]| rational.fit_cell(&u[i], &v[j])))
        })?;
        alloc::reserve(&mut tasks, made.len())?;
        for made in made {
            tasks.push(made?);
        }
        (grid, width) = (now, counts[1]);
        let mut parts = [alloc::filled(1_u8, counts[0])?, alloc::filled(1_u8, counts[1])?];
        for (k, &cell) in grid.iter().enumerate() {
            for (parts, (place, wanted)) in
                parts.iter_mut().zip([k / width, k % width].into_iter().zip(cell_by_index(&tasks, cell).parts))
            {
                parts[place] = parts[place].max(wanted);
            }
        }
        if parts.iter().flatten().all(|&parts| parts == 1) {
            break;
        }
        for d in 0..2 {
            (intervals[d], kept[d]) = cut_intervals(&intervals[d], &parts[d], d as u32)?;
        }
    }
    let mut patches = alloc::with_capacity(grid.len())?;
    let mut deviation = 0.0_f64;
    for (k, &cell) in grid.iter().enumerate() {
        job.sub_job(1.0, 1.0).step_every(CELLS_PER_REPORT, k, grid.len(), PROGRESS_STAGE)?;
        let cell = cell_by_index(&tasks, cell);
        deviation = deviation.max(cell.distance_bound);
        patches.push(cell.patch);
    }
    let origin = SplineOrigin {
        deviation: (deviation + rational.rounding) * rational.unit,
        knots: knots_at_cell_borders(&intervals)?,
    };
    Ok(Patches::from_patches(patches, intervals[0].len(), intervals[1].len()).with_spline_origin(origin))
}

/// The cell with the given index.
fn cell_by_index(tasks: &[Vec<FittedCell>], number: usize) -> &FittedCell {
    &tasks[number / CELLS_PER_TASK][number % CELLS_PER_TASK]
}

/// Cuts intervals into equal parts. Also returns the previous index of each interval that was not
/// cut.
fn cut_intervals(
    intervals: &[SplineInterval],
    parts: &[u8],
    direction: u32,
) -> Result<(Vec<SplineInterval>, Vec<Option<usize>>)> {
    let count = parts.iter().map(|&parts| usize::from(parts)).sum();
    let (mut parts_of_intervals, mut kept) = (alloc::with_capacity(count)?, alloc::with_capacity(count)?);
    for (k, (interval, &parts)) in intervals.iter().zip(parts).enumerate() {
        let [from, to] = interval.end_parameters;
        let at = |part: u8| if part == parts { to } else { from + (to - from) * (f64::from(part) / f64::from(parts)) };
        for part in 0..parts {
            let ends = [at(part), at(part + 1)];
            if ends[0] >= ends[1] {
                return Err(Error::BadKnot { direction, knot: interval.knot as u32, value: from });
            }
            parts_of_intervals.push(SplineInterval { end_parameters: ends, ..*interval });
            kept.push((parts == 1).then_some(k));
        }
    }
    Ok((parts_of_intervals, kept))
}

impl<'a> ScaledRationalSpline<'a> {
    fn new(spline: &'a Spline<'a>, options: &SplineOptions) -> Result<Self> {
        let count = spline.counts[0] * spline.counts[1];
        let (given, weights) = (&spline.points[..count], spline.weights.unwrap_or_default());
        let unit = common_unit(given);
        let greatest = floor_to_power_of_two(weights.iter().fold(0.0, |greatest, &weight| weight.max(greatest)));
        let bounds = Aabb::from_points(given.iter().map(|&point| point / unit));
        let (middle, diagonal) = (0.5 * (bounds.low + bounds.high), bounds.diagonal());
        let local = given.iter().zip(weights).map(|(&point, &weight)| {
            let w = weight / greatest;
            ((point / unit - middle) * w).extend(w)
        });
        let homogeneous = alloc::collect(local)?;
        let radius = given.iter().map(|&point| (point / unit).distance(middle)).fold(0.0, f64::max);
        let degrees = [0, 1].map(|d| spline.axes[d].degree);
        // Rounding of the cells' control points: p + q steps of blossoms with 6 roundings each,
        // sums of p + 1 and q + 1 terms, products by weights and the subtraction of the centre,
        // both in P and in w. Then rounding in N, from the terms w A and P, and of the result, A +
        // centre. All count per coordinate, of which a vector has three.
        let [p, q] = degrees.map(|degree| degree as f64);
        let (control, product) = (2.0 * (7.0 * (p + q) + 8.0), 2.0 * ((p + 1.0) * (q + 1.0) + 5.0));
        let largest = bounds.low.abs().max(bounds.high.abs()).max_element();
        let rounding = 2.0 * UNIT_ROUNDING_ERROR * (radius * (control + 1.5 * product) + 2.0 * largest);
        let tolerance = match options.tolerance {
            Some(given) => {
                Error::require(given > 0.0 && given.is_finite(), "tolerance", given, "finite and above 0")?;
                Error::require(
                    given / unit >= 2.0 * rounding,
                    "tolerance",
                    given,
                    Allowed::AtLeast(2.0 * rounding * unit),
                )?;
                given / unit
            }
            None => (DEFAULT_RELATIVE_TOLERANCE * diagonal).max(2.0 * rounding),
        };
        let target = tolerance - rounding;
        Ok(ScaledRationalSpline {
            spline,
            unit,
            box_centre: middle,
            homogeneous,
            fit_matrices: FitMatrices::new(degrees)?,
            max_cell_bound: target,
            rounding,
            radius,
        })
    }

    fn fit_cell(&self, rows: &SplinePiece, columns: &SplinePiece) -> FittedCell {
        let homogeneous: PieceNet<DVec4> = self.spline.piece_control_net(&self.homogeneous, rows, columns);
        let exact = self.exact_border_points(rows, columns);
        let known = exact.map_points(|point| point / self.unit - self.box_centre);
        let piece = self.fit_matrices.fit_piece(&homogeneous, &known);
        let degrees = [0, 1].map(|d| self.spline.axes[d].degree);
        let bound =
            HomogeneousDifference::new(&piece.points, &homogeneous, degrees).distance_bound(self.max_cell_bound);
        let mut parts = [1, 1];
        if bound > self.max_cell_bound {
            parts = self.parts_to_meet_tolerance(self.fit_matrices.max_errors_by_direction(&piece, &homogeneous));
        }
        let mut patch =
            Patch { points: piece.points.map(|row| row.map(|point| (point + self.box_centre) * self.unit)) };
        exact.overwrite_exact_points(&mut patch.points);
        FittedCell { patch, distance_bound: bound, parts }
    }

    /// Number of parts to cut a cell with these errors in u and in v into, so that each error is at
    /// most 5/13 of the target. The bound is up to 1.3 times the sum of both errors.
    fn parts_to_meet_tolerance(&self, errors: [f64; 2]) -> [u8; 2] {
        let parts = errors.map(|error| match 2.6 * error / self.max_cell_bound {
            // Errors this large do not yet decrease with the eighth power.
            _ if error >= 1e-3 * self.radius => 2,
            excess if excess <= 1.0 => 1,
            excess => libm::pow(excess, 0.125).ceil().min(MAX_PARTS_PER_INTERVAL) as u8,
        });
        match parts {
            [1, 1] if errors[0] >= errors[1] => [2, 1],
            [1, 1] => [1, 2],
            _ => parts,
        }
    }

    /// Points that are known exactly, because all control points that they depend on are equal:
    /// corners of clamped splines, and sides that are poles.
    fn exact_border_points(&self, rows: &SplinePiece, columns: &SplinePiece) -> ExactBorderPoints {
        let [p, q] = [0, 1].map(|d| self.spline.axes[d].degree);
        let one = |in_u: Option<usize>, in_v: Option<usize>| {
            let counts = |piece: &SplinePiece, point: Option<usize>, k: usize| {
                point.is_none_or(|at| piece.weights[at][k] != 0.0)
            };
            let places = (0..=p)
                .filter(|&a| counts(rows, in_u, a))
                .flat_map(|a| (0..=q).filter(|&b| counts(columns, in_v, b)).map(move |b| (a, b)));
            let mut points =
                places.map(|(a, b)| self.spline.points[self.spline.control_point_index(rows, columns, a, b)]);
            let first = points.next()?;
            points.all(|point| point == first).then_some(first)
        };
        let (us, vs) = ([Some(0), Some(p)], [Some(0), Some(q)]);
        ExactBorderPoints {
            points_of_sides: [us.map(|u| one(u, None)), vs.map(|v| one(None, v))],
            corners: us.map(|u| vs.map(|v| one(u, v))),
        }
    }
}
