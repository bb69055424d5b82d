//! Initial maps: least squares conformal maps, and Tutte's map, which never folds.

use super::chart::ChartMesh;
use super::chart_system::ChartSystem;
use super::{STAGE, TRIANGLES_PER_REPORT};
use glam::{DMat2, DVec2};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::NONE;
use std::f64::consts::TAU;

/// Returns the least squares conformal map, scaled to the area of the chart. It minimises half the
/// squared norm of J minus its determinant, summed over the triangles. Two distant vertices of the
/// border are fixed.
pub(super) fn conformal_map(chart: &ChartMesh, system: &mut ChartSystem, job: &Job<'_>) -> Result<Vec<DVec2>> {
    let mut x = alloc::filled(DVec2::ZERO, chart.points.len())?;
    let farthest = |from: u32| {
        let distance = |v: u32| chart.surface_distance(v, from);
        chart.border.iter().fold(from, |far, &[v, _]| if distance(v) > distance(far) { v } else { far })
    };
    let first = farthest(chart.border[0][0]);
    let second = farthest(first);
    x[second as usize].x = chart.surface_distance(first, second).max(chart.total_area().sqrt());
    system.clear_equations(&job.sub_job(0.0, 0.0))?;
    system.fix_vertex(first);
    system.fix_vertex(second);
    for (k, (triangle, shape)) in chart.triangles.iter().zip(&chart.shapes).enumerate() {
        job.sub_job(0.0, 0.1).step_every(TRIANGLES_PER_REPORT, k, chart.triangles.len(), STAGE)?;
        let g = shape.gradients;
        for i in 0..3 {
            let j = (i + 1) % 3;
            let (dot, turn) = (shape.area * g[i].dot(g[j]), shape.area * g[i].perp_dot(g[j]));
            // The determinant couples x of one corner with y of the other.
            let block = DMat2::from_cols(DVec2::new(dot, turn), DVec2::new(-turn, dot));
            system.add_block(triangle[i], triangle[j], block, &x);
            system.add_diagonal_block(
                triangle[i],
                DMat2::from_diagonal(DVec2::splat(shape.area * g[i].length_squared())),
            );
        }
    }
    let mut x = system.solve_positions(&x, &job.sub_job(0.1, 1.0))?;
    job.step(1.0, STAGE)?;
    scale_to_chart_area(chart, &mut x);
    Ok(x)
}

/// Returns Tutte's map: the border lies on a circle, and every other vertex is the mean of its
/// neighbours.
pub(super) fn tutte_map(chart: &ChartMesh, system: &mut ChartSystem, job: &Job<'_>) -> Result<Vec<DVec2>> {
    let mut x = alloc::filled(DVec2::ZERO, chart.points.len())?;
    let mut next = alloc::filled(NONE, chart.points.len())?;
    chart.border.iter().for_each(|&[u, v]| next[u as usize] = v);
    let length = |u: u32| chart.surface_distance(u, next[u as usize]);
    let mean = chart.border.iter().map(|&[u, _]| length(u)).sum::<f64>() / chart.border.len() as f64;
    // Every part of the circle has a positive length, also if the border lies in one point.
    let part = |u: u32| if mean > 0.0 { length(u).max(1e-3 * mean) } else { 1.0 };
    let all: f64 = chart.border.iter().map(|&[u, _]| part(u)).sum();
    let (mut v, mut angle) = (chart.border[0][0], 0.0);
    system.clear_equations(&job.sub_job(0.0, 0.0))?;
    for _ in 0..chart.border.len() {
        system.fix_vertex(v);
        x[v as usize] = DVec2::new(libm::cos(angle), libm::sin(angle));
        angle += TAU * part(v) / all;
        v = next[v as usize];
    }
    for (k, triangle) in chart.triangles.iter().enumerate() {
        job.sub_job(0.0, 0.1).step_every(TRIANGLES_PER_REPORT, k, chart.triangles.len(), STAGE)?;
        for i in 0..3 {
            let [u, v] = [triangle[i], triangle[(i + 1) % 3]];
            system.add_block(u, v, -DMat2::IDENTITY, &x);
            [u, v].iter().for_each(|&v| system.add_diagonal_block(v, DMat2::IDENTITY));
        }
    }
    let mut x = system.solve_positions(&x, &job.sub_job(0.1, 1.0))?;
    job.step(1.0, STAGE)?;
    scale_to_chart_area(chart, &mut x);
    Ok(x)
}

/// Scales the map to the area of the chart.
fn scale_to_chart_area(chart: &ChartMesh, x: &mut [DVec2]) {
    let flat: f64 = (0..chart.triangles.len()).map(|t| chart.signed_double_area(t, x) / 2.0).sum();
    let factor = (chart.total_area() / flat.abs()).sqrt();
    if factor.is_finite() {
        x.iter_mut().for_each(|p| *p *= factor);
    }
}
