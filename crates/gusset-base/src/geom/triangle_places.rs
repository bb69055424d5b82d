//! Nearest places on a set of triangles, in barycentric coordinates.

use super::Aabb;
use super::box_tree::{BoxTree, spatial_order};
use super::triangle::weights_of_nearest_point;
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use glam::DVec3;

/// Queries between two progress reports.
const QUERIES_PER_REPORT: usize = 1 << 12;

/// A place on a set of triangles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrianglePlace {
    pub triangle: u32,
    /// The barycentric coordinates: at least 0, with sum 1.
    pub weights: [f64; 3],
    /// The squared distance to the query point.
    pub squared_distance: f64,
}

/// A set of triangles prepared for nearest-place queries.
pub struct TriangleTree<'a> {
    points: &'a [DVec3],
    triangles: &'a [[u32; 3]],
    order: Vec<u32>,
    tree: BoxTree,
}

impl<'a> TriangleTree<'a> {
    /// Builds the tree. O(n log n).
    #[inline]
    pub fn new(points: &'a [DVec3], triangles: &'a [[u32; 3]], stage: &'static str, job: &Job<'_>) -> Result<Self> {
        let boxes = triangles.iter().map(|t| Aabb::from_points(t.map(|v| points[v as usize])));
        let boxes = alloc::collect_cancellable(boxes, &job.sub_job(0.0, 0.0), stage)?;
        let order = spatial_order(&boxes, 1, job, stage)?;
        let tree = BoxTree::new_cancellable(order.iter().map(|&t| boxes[t as usize]), &job.sub_job(1.0, 1.0), stage)?;
        Ok(TriangleTree { points, triangles, order, tree })
    }

    /// Returns the place nearest to a point, if it is nearer than `limit` (squared). Ties go to the
    /// first place in the order of the tree.
    #[inline]
    pub fn nearest(&self, p: DVec3, limit: f64) -> Option<TrianglePlace> {
        self.nearest_with_guess(p, limit, None)
    }

    /// [`nearest`](Self::nearest), accelerated by `guess`, a triangle near the point such as the
    /// result of a neighbouring query.
    pub fn nearest_with_guess(&self, p: DVec3, limit: f64, guess: Option<u32>) -> Option<TrianglePlace> {
        let mut best = TrianglePlace { triangle: u32::MAX, weights: [1.0, 0.0, 0.0], squared_distance: limit };
        let mut look = |triangle: u32| {
            let corners = self.triangles[triangle as usize].map(|v| self.points[v as usize]);
            let weights = weights_of_nearest_point(corners, p);
            let place: DVec3 = corners.into_iter().zip(weights).map(|(corner, weight)| corner * weight).sum();
            let squared = place.distance_squared(p);
            if squared < best.squared_distance {
                best = TrianglePlace { triangle, weights, squared_distance: squared };
            }
            best.squared_distance
        };
        let limit = guess.map_or(limit, &mut look);
        self.tree.visit_nearest(p, limit, &mut |leaf| self.order.get(leaf).map_or(limit, |&triangle| look(triangle)));
        (best.triangle != u32::MAX).then_some(best)
    }
}

/// Finds, for each of `places`, the nearest triangle's corners and the barycentric coordinates of
/// its nearest point. The coordinates are at least 0 with sum 1. If there are places, there must be
/// a triangle. O(n log n).
pub fn nearest_places(
    points: &[DVec3],
    triangles: &[[u32; 3]],
    places: &[DVec3],
    stage: &'static str,
    job: &Job<'_>,
) -> Result<Vec<([u32; 3], [f64; 3])>> {
    if places.is_empty() {
        return Ok(Vec::new());
    }
    let tree = TriangleTree::new(points, triangles, stage, &job.sub_job(0.0, 0.1))?;
    let job = job.sub_job(0.1, 1.0);
    alloc::try_collect(places.iter().enumerate().map(|(k, &p)| {
        job.step_every(QUERIES_PER_REPORT, k, places.len(), stage)?;
        let found = tree.nearest(p, f64::INFINITY);
        Ok(found.map_or((triangles[0], [1.0, 0.0, 0.0]), |place| (triangles[place.triangle as usize], place.weights)))
    }))
}
