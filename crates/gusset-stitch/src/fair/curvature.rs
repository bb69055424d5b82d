//! The curvature of a patch at each vertex, without the detail of its triangles.

use super::one_rings::{LaplacianWeights, OneRings};
use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use std::ops::{Add, Mul};

/// Number of vertices between two progress reports.
const VERTICES_PER_REPORT: usize = 1 << 14;

/// Number of smoothing passes over the normals.
const NORMAL_SMOOTHING_PASSES: u32 = 2;

/// Returns the Laplacian of the surface at each vertex: twice its mean curvature times its normal,
/// both smoothed over a few edges.
///
/// Smoothing removes the ridges of a polyhedron, and keeps the bend of the whole. The Laplacians
/// are not averaged as vectors, because the mean is too short where normals turn. The normals are
/// averaged only in [`NORMAL_SMOOTHING_PASSES`] passes, because around a thin tube their mean
/// vanishes. Vertices whose one-ring is not `closed` get the values of their neighbours.
///
/// `points` are in a unit of about their size; the result is in the reciprocal of that unit. Each
/// of the `passes` averages over all neighbours, weighted by area; together they reach about 2
/// sqrt(passes) edges. O(passes * T) for T triangles.
pub(crate) fn mean_curvature(
    points: &[DVec3],
    triangles: &[[u32; 3]],
    closed: &dyn Fn(usize) -> bool,
    passes: u32,
    job: &Job<'_>,
) -> Result<Vec<DVec3>> {
    let rings = OneRings::new(points, triangles, LaplacianWeights::Cotangent, &job.sub_job(0.0, 0.0))?;
    let mut area_vectors = alloc::filled(DVec3::ZERO, points.len())?;
    for &corners in triangles {
        let [a, b, c] = corners.map(|v| points[v as usize]);
        corners.iter().for_each(|&v| area_vectors[v as usize] += (b - a).cross(c - a) / 6.0);
    }
    // The Laplacian along the normal, times the area, and the area, of vertices with a Laplacian.
    let mut sums = alloc::filled(DVec2::ZERO, points.len())?;
    for (v, sum) in sums.iter_mut().enumerate().filter(|&(v, _)| closed(v)) {
        let laplacian: DVec3 = rings.ring(v).iter().map(|&(w, weight)| weight * (points[w as usize] - points[v])).sum();
        *sum = DVec2::new(laplacian.dot(area_vectors[v].normalize_or_zero()), 1.0 / rings.energy_scale(v));
    }
    average_over_rings(&rings, &mut area_vectors, passes.min(NORMAL_SMOOTHING_PASSES), &job.sub_job(0.0, 0.5))?;
    average_over_rings(&rings, &mut sums, passes, &job.sub_job(0.5, 1.0))?;
    let mean = |(sum, area_vector): (DVec2, DVec3)| {
        if sum.y > 0.0 { sum.x / sum.y * area_vector.normalize_or_zero() } else { DVec3::ZERO }
    };
    alloc::collect(sums.into_iter().zip(area_vectors).map(mean))
}

/// Replaces the value of each vertex by the mean of its value and its neighbours' values, `passes`
/// times.
fn average_over_rings<T>(rings: &OneRings, values: &mut Vec<T>, passes: u32, job: &Job<'_>) -> Result<()>
where
    T: Copy + Add<Output = T>,
    f64: Mul<T, Output = T>,
{
    let mut next = alloc::copied(values)?;
    for pass in 0..passes {
        let share = job.sub_job_of_item(pass as usize, passes as usize);
        for (v, mean) in next.iter_mut().enumerate() {
            share.step_every(VERTICES_PER_REPORT, v, values.len(), "refining")?;
            let ring = rings.ring(v);
            let sum = ring.iter().fold(values[v], |sum, &(w, _)| sum + values[w as usize]);
            *mean = 1.0 / (1.0 + ring.len() as f64) * sum;
        }
        std::mem::swap(values, &mut next);
    }
    Ok(())
}
