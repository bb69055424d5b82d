//! The nearest places on a set of triangles, in barycentric coordinates.

use super::Aabb;
use super::box_tree::{BoxTree, spatial_order};
use super::triangle::nearest_weights;
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use glam::DVec3;

/// Places between two progress reports.
const REPORT_INTERVAL: usize = 1 << 12;

/// For each of `places` the corners of the triangle nearest to it and the barycentric coordinates
/// of its nearest point: at least 0, with sum 1. There must be a triangle if there are places.
/// O(n log n).
pub(crate) fn nearest_places(
    points: &[DVec3],
    triangles: &[[u32; 3]],
    places: &[DVec3],
    stage: &'static str,
    job: &Job<'_>,
) -> Result<Vec<([u32; 3], [f64; 3])>> {
    if places.is_empty() {
        return Ok(Vec::new());
    }
    let corners = |t: u32| triangles[t as usize].map(|v| points[v as usize]);
    let boxes = alloc::collect((0..triangles.len() as u32).map(|t| Aabb::of(corners(t))))?;
    let order = spatial_order(&boxes, 1, &job.part(0.0, 0.1), stage)?;
    let job = job.part(0.1, 1.0);
    let tree = BoxTree::new(order.iter().map(|&t| boxes[t as usize]))?;
    alloc::try_collect(places.iter().enumerate().map(|(k, &p)| {
        job.step_every(REPORT_INTERVAL, k, places.len(), stage)?;
        let mut best = (f64::INFINITY, 0, [1.0, 0.0, 0.0]);
        tree.nearest(p, f64::INFINITY, &mut |leaf| {
            if let Some(&t) = order.get(leaf) {
                let weights = nearest_weights(corners(t), p);
                let place: DVec3 = corners(t).into_iter().zip(weights).map(|(corner, weight)| corner * weight).sum();
                let found = (place.distance_squared(p), t, weights);
                if found.0 < best.0 {
                    best = found;
                }
            }
            best.0
        });
        Ok((triangles[best.1 as usize], best.2))
    }))
}
