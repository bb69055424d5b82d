//! Choice of the two loops to stitch if the caller gives none: the pair that is nearest along its
//! whole length.
//!
//! The distance of two loops is the mean distance from the vertices of each to the nearest vertex
//! of the other, the larger of both means. So one close pair of vertices does not make two loops
//! near.

use super::stitch_rim::{Rim, is_usable, shared_vertex};
use crate::boundary::Boundary;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result, Side};
use gusset_base::geom::{Aabb, kd_tree::KdTree};
use gusset_base::job::Job;
use gusset_mesh::MeshView;

/// Number of evenly spaced vertices of a rim that determine its distance from another rim.
const MAX_SAMPLE_VERTICES: usize = 1 << 10;

const STAGE: &str = "pairing the loops";

/// Returns every boundary loop that can carry a strip.
pub(super) fn usable_rims(mesh: &MeshView<'_>, boundary: &Boundary) -> Result<Vec<Rim>> {
    alloc::try_collect(boundary.iter().filter(is_usable).map(|found| Rim::from_loop(mesh, &found)))
}

/// Removes the nearest two rims from the candidates, one from each side, the first of equally near
/// pairs. On one mesh, two rims that share a vertex are not paired; in particular, a rim is not
/// paired with itself.
///
/// Box tests for all pairs, and nearest-point searches for the pairs that the boxes do not exclude.
pub(super) fn remove_nearest_pair(
    mut a: Vec<Rim>,
    mut b: Vec<Rim>,
    one_mesh: bool,
    job: &Job<'_>,
) -> Result<(Rim, Rim)> {
    let boxes = alloc::collect(b.iter().map(|rim| Aabb::from_points(&rim.points)))?;
    let mut best = (f64::INFINITY, None);
    for (i, p) in a.iter().enumerate() {
        let job = job.sub_job_of_item(i, a.len());
        job.step(0.0, STAGE)?;
        let (around, tree_p) = (Aabb::from_points(&p.points), build_tree(&p.points, &job.sub_job(0.0, 0.1))?);
        let job = job.sub_job(0.1, 1.0);
        for (j, q) in b.iter().enumerate() {
            // The distance of the boxes is a lower bound.
            if around.distance(&boxes[j]) >= best.0 {
                continue;
            }
            // Test the direction that reuses a tree first.
            let there = mean_distance(&q.points, &tree_p);
            if there >= best.0 {
                continue;
            }
            let distance =
                there.max(mean_distance(&p.points, &build_tree(&q.points, &job.sub_job_of_item(j, b.len()))?));
            if distance < best.0 && !(one_mesh && shared_vertex(p, q)?.is_some()) {
                best = (distance, Some((i, j)));
            }
        }
    }
    let (i, j) = best.1.ok_or(match one_mesh {
        true => Error::NoPairOfLoops { count: a.len().max(b.len()) as u32 },
        false => Error::NoLoop { side: if a.is_empty() { Side::A } else { Side::B } },
    })?;
    Ok((a.swap_remove(i), b.swap_remove(j)))
}

fn build_tree<'a>(points: &'a [DVec3], job: &Job<'_>) -> Result<KdTree<'a>> {
    KdTree::new(points, job, STAGE)
}

/// Returns the larger of the two mean distances from the vertices of one rim to the nearest vertex
/// of the other.
pub fn mean_gap(a: &Rim, b: &Rim, job: &Job<'_>) -> Result<f64> {
    let there = mean_distance(&b.points, &build_tree(&a.points, &job.sub_job(0.0, 0.5))?);
    Ok(there.max(mean_distance(&a.points, &build_tree(&b.points, &job.sub_job(0.5, 1.0))?)))
}

/// Returns the mean distance from the vertices of one rim to the nearest vertex of the other.
/// Samples long rims evenly.
fn mean_distance(from: &[DVec3], to: &KdTree<'_>) -> f64 {
    let asked = from.iter().step_by(from.len().div_ceil(MAX_SAMPLE_VERTICES));
    let count = asked.len() as f64;
    asked.map(|p| to.nearest(*p, f64::INFINITY, |_| true).map_or(0.0, |(squared, _)| squared.sqrt())).sum::<f64>()
        / count
}
