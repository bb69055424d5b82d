//! Exact development: positions in the plane at which every edge keeps its length.
//!
//! Triangles are unfolded about their edges into the plane, one after another. Round-off
//! accumulates, so large charts start from their conformal map, which is the exact unfolding if
//! there is one. Gauss-Newton steps towards the lengths of all edges remove the remaining error: a
//! triangulated disc is rigid in the plane.

use super::chart::ChartMesh;
use super::chart_system::ChartSystem;
use super::{STAGE, TRIANGLES_PER_REPORT};
use glam::{DMat2, DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_mesh::NONE;
use std::collections::VecDeque;

/// Largest relative error of an edge's length.
const MAX_LENGTH_ERROR: f64 = 1e-10;
/// The error of shorter edges is relative to this fraction of the mean edge.
const MIN_RELATIVE_EDGE_LENGTH: f64 = 1e-3;
/// Surfaces with a larger error are curved.
const MAX_RESTORABLE_LENGTH_ERROR: f64 = 1e-3;
/// Largest deficit of a triangle's doubled area, in squared mean edges.
const MAX_RELATIVE_AREA_DEFICIT: f64 = 1e-6;
const MAX_GAUSS_NEWTON_STEPS: usize = 3;
/// Weight that holds vertices in place, relative to 1 for each edge: lengths are invariant under
/// translation.
const RELATIVE_HOLD_WEIGHT: f64 = 1e-9;

/// The lengths of the edges of a chart.
pub(super) struct EdgeLengths<'a> {
    chart: &'a ChartMesh,
    mean_length: f64,
}

impl<'a> EdgeLengths<'a> {
    pub(super) fn new(chart: &'a ChartMesh, job: &Job<'_>) -> Result<Self> {
        let mut lengths = EdgeLengths { chart, mean_length: 0.0 };
        let mut sum = 0.0;
        for (k, [u, v]) in lengths.edge_ends().enumerate() {
            job.step_within_list(k, STAGE)?;
            sum += chart.surface_distance(u, v);
        }
        lengths.mean_length = sum / (3 * chart.triangles.len()) as f64;
        Ok(lengths)
    }

    /// Returns the edges. Edges with two triangles occur twice.
    fn edge_ends(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        (0..3 * self.chart.triangles.len()).map(|k| {
            let triangle = self.chart.triangles[k / 3];
            [triangle[k % 3], triangle[(k + 1) % 3]]
        })
    }

    /// Returns the largest error of an edge in the plane, relative to its length, or to
    /// [`MIN_RELATIVE_EDGE_LENGTH`] mean edges if that is longer. The result is NaN if a vertex
    /// lacks a position.
    fn largest_length_error(&self, x: &[DVec2], job: &Job<'_>) -> Result<f64> {
        let of = |[u, v]: [u32; 2]| {
            let wanted = self.chart.surface_distance(u, v);
            let error = (x[u as usize].distance(x[v as usize]) - wanted).abs();
            // All edges of a chart in one point have length 0.
            if error == 0.0 { 0.0 } else { error / wanted.max(MIN_RELATIVE_EDGE_LENGTH * self.mean_length) }
        };
        let largest = |worst: f64, error: f64| if error > worst || error.is_nan() { error } else { worst };
        let mut worst = 0.0;
        for (k, edge) in self.edge_ends().enumerate() {
            job.step_within_list(k, STAGE)?;
            worst = largest(worst, of(edge));
        }
        Ok(worst)
    }

    /// Returns true if every edge keeps its length, and no triangle is turned over. A degenerate
    /// triangle may lie either way.
    pub(super) fn are_lengths_kept(&self, x: &[DVec2], job: &Job<'_>) -> Result<bool> {
        let stands = |t: usize| {
            let [a, b, c] = self.chart.triangles[t].map(|v| self.chart.points[v as usize]);
            let least = (b - a).cross(c - a).length() - MAX_RELATIVE_AREA_DEFICIT * self.mean_length * self.mean_length;
            self.chart.signed_double_area(t, x) >= least
        };
        let job = job.sub_job(0.0, 0.0);
        let is_long_enough = self.largest_length_error(x, &job)? <= MAX_LENGTH_ERROR;
        for t in 0..self.chart.triangles.len() {
            job.step_within_list(t, STAGE)?;
            if !is_long_enough || !stands(t) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Returns the positions near `x` at which every edge keeps its length; `None` if they are not
    /// found. O(T) for T triangles, and up to three factorisations if `x` is near but not exact.
    pub(super) fn restore_lengths(
        &self,
        system: &mut ChartSystem,
        mut x: Vec<DVec2>,
        job: &Job<'_>,
    ) -> Result<Option<Vec<DVec2>>> {
        for step in 0..MAX_GAUSS_NEWTON_STEPS {
            let job = job.sub_job_of_item(step, MAX_GAUSS_NEWTON_STEPS);
            let error = self.largest_length_error(&x, &job)?;
            if error <= MAX_LENGTH_ERROR || error.is_nan() || error > MAX_RESTORABLE_LENGTH_ERROR {
                break;
            }
            job.step(0.0, STAGE)?;
            x = gauss_newton_step(self.chart, system, &x, &job)?;
            job.step(1.0, STAGE)?;
        }
        Ok(self.are_lengths_kept(&x, &job.sub_job(1.0, 1.0))?.then_some(x))
    }
}

/// Unfolds triangles into the plane, neighbour by neighbour, from the largest one. O(T).
pub(super) fn unfold_triangles(chart: &ChartMesh, job: &Job<'_>) -> Result<Vec<DVec2>> {
    let count = chart.triangles.len();
    let mut x = alloc::filled(DVec2::NAN, chart.points.len())?;
    let mut seen = alloc::filled(false, count)?;
    let mut waiting = VecDeque::new();
    waiting.try_reserve(count).map_err(|_| Error::OutOfMemory { bytes: 8 * count as u64 })?;
    let larger = |best: usize, t: usize| if chart.shapes[t].area > chart.shapes[best].area { t } else { best };
    let largest = (0..count).fold(0, larger);
    let [a, b, _] = chart.triangles[largest];
    (x[a as usize], x[b as usize]) = (DVec2::ZERO, DVec2::new(chart.surface_distance(a, b), 0.0));
    seen[largest] = true;
    waiting.push_back(largest);
    let mut done = 0;
    while let Some(t) = waiting.pop_front() {
        job.step_within_list(done, STAGE)?;
        done += 1;
        for k in 0..3 {
            let [a, b, c] = [k, (k + 1) % 3, (k + 2) % 3].map(|k| chart.triangles[t][k]);
            if x[c as usize].is_nan() && !x[a as usize].is_nan() && !x[b as usize].is_nan() {
                x[c as usize] =
                    third_corner([x[a as usize], x[b as usize]], [a, b, c].map(|v| chart.points[v as usize]));
            }
        }
        for &next in chart.triangles_across_sides[t].iter().filter(|&&next| next != NONE) {
            if !std::mem::replace(&mut seen[next as usize], true) {
                waiting.push_back(next as usize);
            }
        }
    }
    Ok(x)
}

/// Returns the third corner to the left of a side in the plane.
fn third_corner([p, q]: [DVec2; 2], [a, b, c]: [DVec3; 3]) -> DVec2 {
    let side = b - a;
    let square = side.length_squared().max(f64::MIN_POSITIVE);
    let along = (c - a).dot(side) / square;
    let height = side.cross(c - a).length() / square;
    p + along * (q - p) + height * (q - p).perp()
}

/// Returns the positions after one Gauss-Newton step on the squared differences of lengths.
fn gauss_newton_step(chart: &ChartMesh, system: &mut ChartSystem, x: &[DVec2], job: &Job<'_>) -> Result<Vec<DVec2>> {
    let still = alloc::filled(DVec2::ZERO, x.len())?;
    system.clear_equations(&job.sub_job(0.0, 0.0))?;
    for (k, triangle) in chart.triangles.iter().enumerate() {
        job.sub_job(0.0, 0.1).step_every(TRIANGLES_PER_REPORT, k, chart.triangles.len(), STAGE)?;
        for i in 0..3 {
            let [u, v] = [triangle[i], triangle[(i + 1) % 3]];
            let side = x[v as usize] - x[u as usize];
            let along = side.normalize_or_zero();
            let block = DMat2::from_cols(along.x * along, along.y * along);
            system.add_block(u, v, -block, &still);
            let pull = (chart.surface_distance(u, v) - side.length()) * along;
            for (v, pull) in [(u, -pull), (v, pull)] {
                system.add_diagonal_block(v, block + DMat2::from_diagonal(DVec2::splat(RELATIVE_HOLD_WEIGHT)));
                system.add_right_hand_side(v, pull);
            }
        }
    }
    let by = system.solve_positions(&still, &job.sub_job(0.1, 1.0))?;
    alloc::collect(x.iter().zip(by).map(|(&x, by)| x + by))
}
