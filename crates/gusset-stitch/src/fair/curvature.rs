//! The curvature of a patch at each vertex, without the detail of its triangles.

use super::one_rings::{LaplacianWeights, OneRings};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Number of vertices between two progress reports.
const VERTICES_PER_REPORT: usize = 1 << 14;

/// Number of smoothing passes over the normals.
const NORMAL_SMOOTHING_PASSES: u32 = 2;

/// Sums over vertices.
#[derive(Clone, Copy)]
struct CurvatureSum {
    /// The Laplacian along the normal, times the area.
    laplacian_times_area: f64,
    /// The area of the vertices with a Laplacian.
    area: f64,
    /// The area vector.
    area_vector: DVec3,
}

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
    let mut sums =
        alloc::filled(CurvatureSum { laplacian_times_area: 0.0, area: 0.0, area_vector: DVec3::ZERO }, points.len())?;
    for &corners in triangles {
        let [a, b, c] = corners.map(|v| points[v as usize]);
        corners.iter().for_each(|&v| sums[v as usize].area_vector += (b - a).cross(c - a) / 6.0);
    }
    for (v, sum) in sums.iter_mut().enumerate().filter(|&(v, _)| closed(v)) {
        let laplacian: DVec3 = rings.ring(v).iter().map(|&(w, weight)| weight * (points[w as usize] - points[v])).sum();
        sum.laplacian_times_area = laplacian.dot(sum.area_vector.normalize_or_zero());
        sum.area = 1.0 / rings.energy_scale(v);
    }
    let mut next = alloc::copied(&sums)?;
    for pass in 0..passes {
        let share = job.sub_job_of_item(pass as usize, passes as usize);
        let count = sums.len();
        for (v, mean) in next.iter_mut().enumerate() {
            share.step_every(VERTICES_PER_REPORT, v, count, "refining")?;
            let share = 1.0 / (1.0 + rings.ring(v).len() as f64);
            let ring = rings.ring(v).iter().map(|&(w, _)| sums[w as usize]);
            *mean = ring.fold(sums[v], |mean, sum| CurvatureSum {
                laplacian_times_area: mean.laplacian_times_area + sum.laplacian_times_area,
                area: mean.area + sum.area,
                area_vector: mean.area_vector + sum.area_vector,
            });
            let normal = if pass < NORMAL_SMOOTHING_PASSES { share * mean.area_vector } else { sums[v].area_vector };
            *mean = CurvatureSum {
                laplacian_times_area: share * mean.laplacian_times_area,
                area: share * mean.area,
                area_vector: normal,
            };
        }
        std::mem::swap(&mut sums, &mut next);
    }
    let mean = |sum: CurvatureSum| {
        if sum.area > 0.0 {
            sum.laplacian_times_area / sum.area * sum.area_vector.normalize_or_zero()
        } else {
            DVec3::ZERO
        }
    };
    alloc::collect(sums.into_iter().map(mean))
}
