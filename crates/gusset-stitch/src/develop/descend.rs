//! Descent to the least distortion without folding a triangle.
//!
//! Each step replaces the energy by a quadratic proxy with an equal gradient (Rabinovich et al.,
//! section 3). The proxy's minimum gives a direction. The step along it is limited to avoid folds,
//! and is halved until the energy decreases. If the border of the final map intersects itself, the
//! descent restarts from the last map without self-intersections, and then also halves the steps
//! that would cause them.

use super::chart::ChartMesh;
use super::chart_system::ChartSystem;
use super::develop_request::Distortion;
use super::energy::{Jacobian, proxy_weights, stretch_energy};
use super::overlap::count_border_intersections;
use super::{STAGE, TRIANGLES_PER_REPORT};
use glam::{DMat2, DVec2};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Largest fraction of the distance to the first fold that a step may take.
const MAX_STEP_TO_FIRST_FOLD_RATIO: f64 = 0.8;
/// Smallest decrease of the energy relative to the prediction by its gradient (Armijo's rule).
const MIN_ARMIJO_DESCENT_RATIO: f64 = 1e-4;
const MAX_STEP_HALVINGS: u32 = 40;
/// The descent ends if the relative decrease of the energy is at most this.
const MIN_RELATIVE_GAIN: f64 = 1e-9;
/// The end is a minimum if the gradient predicts a relative decrease of at most this.
const MAX_RELATIVE_SLOPE_AT_MINIMUM: f64 = 1e-6;
/// Weight that holds vertices in place, relative to the mean diagonal entry: the energy is
/// invariant under translation.
const RELATIVE_HOLD_WEIGHT: f64 = 1e-9;

/// The reason why a descent ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum DescentOutcome {
    /// The energy no longer decreased.
    Converged,
    /// No step was possible that decreases the energy: the border would intersect itself, or
    /// round-off hides the decrease.
    Stalled,
    /// The limit on steps was reached.
    IterationLimit,
    /// The search found no map without folds to start from.
    Folded,
}

/// The result of a descent.
pub(super) struct Descent {
    pub(super) positions: Vec<DVec2>,
    pub(super) iterations: u32,
    pub(super) outcome: DescentOutcome,
}

/// The treatment of the border in a descent.
pub(super) enum BorderRule<'a> {
    /// The border may intersect itself. The last map on the way without self-intersections is
    /// stored.
    Free(&'a mut Option<Vec<DVec2>>),
    /// The border must not intersect itself. The first map must satisfy this.
    Apart,
}

/// Descends from a map without folds to one with less distortion, without folds. Each step
/// factorises a matrix, O(n^1.5) for n vertices.
pub(super) fn minimise_by_descent(
    chart: &ChartMesh,
    system: &mut ChartSystem,
    distortion: Distortion,
    mut x: Vec<DVec2>,
    mut border: BorderRule<'_>,
    max_iterations: u32,
    job: &Job<'_>,
) -> Result<Descent> {
    let mut value = mean_energy(chart, distortion, &x, &job.sub_job(0.0, 0.0))?;
    for iteration in 0..max_iterations {
        let job = job.sub_job_of_item(iteration as usize, max_iterations as usize);
        let is_apart = |x: &[DVec2], job: &Job<'_>| Ok(count_border_intersections(&chart.border, x, 0.0, 1, job)? == 0);
        if let BorderRule::Free(last) = &mut border
            && is_apart(&x, &job.sub_job(0.0, 0.0))?
        {
            **last = Some(alloc::copied(&x)?);
        }
        let gradient = assemble_proxy_system(chart, system, distortion, &x, &job.sub_job(0.0, 0.1))?;
        let target = system.solve_positions(&x, &job.sub_job(0.1, 0.8))?;
        let late = job.sub_job(0.9, 0.9);
        let way = alloc::collect(target.iter().zip(&x).map(|(&to, &from)| to - from))?;
        let slope: f64 = gradient.iter().zip(&way).map(|(g, d)| g.dot(*d)).sum();
        let mut step = f64::min(1.0, MAX_STEP_TO_FIRST_FOLD_RATIO * first_fold_fraction(chart, &x, &way, &late)?);
        let mut better_step = None;
        for _ in 0..MAX_STEP_HALVINGS {
            let moved = alloc::collect(x.iter().zip(&way).map(|(&p, &d)| p + step * d))?;
            let reached = mean_energy(chart, distortion, &moved, &late)?;
            let falls = reached <= value + MIN_ARMIJO_DESCENT_RATIO * step * slope && reached < value;
            if falls
                && chart.count_folded_triangles(&moved) == 0
                && (matches!(border, BorderRule::Free(_)) || is_apart(&moved, &late)?)
            {
                better_step = Some((moved, reached));
                break;
            }
            step /= 2.0;
        }
        let gain = better_step.as_ref().map_or(0.0, |(_, reached)| value - reached);
        if let Some(better) = better_step {
            (x, value) = better;
        }
        if gain <= MIN_RELATIVE_GAIN * value {
            let end = if slope.abs() <= MAX_RELATIVE_SLOPE_AT_MINIMUM * value {
                DescentOutcome::Converged
            } else {
                DescentOutcome::Stalled
            };
            return Ok(Descent { positions: x, iterations: iteration + 1, outcome: end });
        }
    }
    Ok(Descent { positions: x, iterations: max_iterations, outcome: DescentOutcome::IterationLimit })
}

/// Returns the mean energy over the area.
fn mean_energy(chart: &ChartMesh, distortion: Distortion, x: &[DVec2], job: &Job<'_>) -> Result<f64> {
    let mut sum = 0.0;
    for (k, (triangle, shape)) in chart.triangles.iter().zip(&chart.shapes).enumerate() {
        job.step_every(TRIANGLES_PER_REPORT, k, chart.triangles.len(), STAGE)?;
        let map = Jacobian::new(&shape.gradients, triangle.map(|v| x[v as usize]));
        sum += shape.area * stretch_energy(distortion, map.stretch);
    }
    Ok(sum / chart.total_area())
}

/// Builds the system of the quadratic proxy at `positions`, and returns the gradient of the mean energy.
fn assemble_proxy_system(
    chart: &ChartMesh,
    system: &mut ChartSystem,
    distortion: Distortion,
    positions: &[DVec2],
    job: &Job<'_>,
) -> Result<Vec<DVec2>> {
    let mut gradient = alloc::filled(DVec2::ZERO, positions.len())?;
    let whole = chart.total_area();
    let mut trace = 0.0;
    system.clear_equations(&job.sub_job(0.0, 0.0))?;
    for (k, (triangle, shape)) in chart.triangles.iter().zip(&chart.shapes).enumerate() {
        job.step_every(TRIANGLES_PER_REPORT, k, chart.triangles.len(), STAGE)?;
        let map = Jacobian::new(&shape.gradients, triangle.map(|v| positions[v as usize]));
        let share = shape.area / whole;
        let matrix = share * map.matrix_with_stretches(proxy_weights(distortion, map.stretch));
        // J - R is U diag(s - 1) U^T R.
        let off = matrix * map.matrix_with_stretches(map.stretch.map(|s| s - 1.0)) * map.rotation;
        let target = matrix * map.rotation;
        for i in 0..3 {
            let g = shape.gradients[i];
            gradient[triangle[i] as usize] += 2.0 * (off * g);
            system.add_right_hand_side(triangle[i], target * g);
            let own = g.length_squared() * matrix;
            trace += own.x_axis.x + own.y_axis.y;
            system.add_diagonal_block(triangle[i], own);
            let j = (i + 1) % 3;
            system.add_block(triangle[i], triangle[j], g.dot(shape.gradients[j]) * matrix, positions);
        }
    }
    let hold = RELATIVE_HOLD_WEIGHT * trace / (2 * positions.len()) as f64;
    for (v, &p) in (0..).zip(positions) {
        system.add_diagonal_block(v, DMat2::from_diagonal(DVec2::splat(hold)));
        system.add_right_hand_side(v, hold * p);
    }
    Ok(gradient)
}

/// Returns the fraction of the step at which the first triangle folds; infinity without a fold.
fn first_fold_fraction(chart: &ChartMesh, x: &[DVec2], way: &[DVec2], job: &Job<'_>) -> Result<f64> {
    let mut first = f64::INFINITY;
    for (k, &triangle) in chart.triangles.iter().enumerate() {
        job.step_within_list(k, STAGE)?;
        let [a, b, c] = triangle.map(|v| x[v as usize]);
        let [da, db, dc] = triangle.map(|v| way[v as usize]);
        let (p, q, dp, dq) = (b - a, c - a, db - da, dc - da);
        // The doubled area is d t^2 + 2 h t + e.
        let (d, h, e) = (dp.perp_dot(dq), (p.perp_dot(dq) + dp.perp_dot(q)) / 2.0, p.perp_dot(q));
        let square = h * h - d * e;
        if square >= 0.0 {
            // The smallest positive root, in the form that avoids cancellation.
            let s = -h - h.signum() * square.sqrt();
            for root in [s / d, e / s] {
                if root > 0.0 && root < first {
                    first = root;
                }
            }
        }
    }
    Ok(first)
}
