//! How much more confident vertices are than the places of other pieces that they lie on.

use super::layer::Layer;
use crate::alloc;
use crate::error::Result;
use crate::geom::triangle_places::TriangleTree;
use crate::job::Job;
use crate::par;
use glam::DVec3;

const STAGE: &str = "looking for overlaps";
const CHUNK: usize = 1 << 9;

/// When two surfaces are one.
#[derive(Clone, Copy)]
pub(super) struct Same {
    /// The distance; `None`: so many mean edges of the coarser piece.
    pub(super) distance: Option<f64>,
    pub(super) edges: f64,
    pub(super) cosine: f64,
}

impl Same {
    fn distance(&self, a: &Layer, b: &Layer) -> f64 {
        self.distance.unwrap_or(self.edges * a.scan.spacing.max(b.scan.spacing))
    }
}

/// For each vertex of piece `k` its confidence less the greatest of the places that it lies on;
/// infinite of one that lies on none. O(log F) for each vertex and piece near it.
pub(super) fn margins(
    layers: &[Layer],
    trees: &[TriangleTree<'_>],
    k: usize,
    same: &Same,
    job: &Job<'_>,
) -> Result<Vec<f64>> {
    let own = &layers[k];
    let is_near = |j: &usize| {
        let other = &layers[*j];
        let reach = same.distance(own, other);
        *j != k && own.scan.bounds.is_within(&other.scan.bounds, reach) && !other.triangles.is_empty()
    };
    let near = alloc::gather((0..layers.len()).filter(is_near))?;
    let margin = |v: usize| {
        let (p, n) = (own.scan.points[v], own.scan.normals[v]);
        if n == DVec3::ZERO {
            return f64::INFINITY;
        }
        let on = near.iter().filter_map(|&j| confidence_at(&layers[j], &trees[j], p, n, same.distance(own, &layers[j]), same.cosine));
        on.map(|other| own.confidence[v] - other).fold(f64::INFINITY, f64::min)
    };
    let parts = par::map_cancellable(job, STAGE, par::ranges(own.scan.points.len(), CHUNK), |range| {
        alloc::collect(range.map(margin))
    })?;
    let mut all = alloc::with_capacity(own.scan.points.len())?;
    alloc::append_all(&mut all, parts)?;
    Ok(all)
}

/// The confidence of the place on a piece that a point with a normal lies on, if it does.
fn confidence_at(other: &Layer, tree: &TriangleTree<'_>, p: DVec3, n: DVec3, reach: f64, cosine: f64) -> Option<f64> {
    let scan = &other.scan;
    if scan.bounds.distance_squared(p) > reach * reach {
        return None;
    }
    let place = tree.nearest(p, reach * reach)?;
    let corners = other.triangles[place.triangle as usize];
    let with = || corners.into_iter().zip(place.weights).filter(|&(_, weight)| weight > 0.0);
    // Beyond a border the nearest place is on it.
    if with().all(|(v, _)| scan.rim.contains(v)) {
        return None;
    }
    let normal = with().map(|(v, weight)| scan.normals[v as usize] * weight).sum::<DVec3>();
    if normal.dot(n) < cosine * normal.length() {
        return None;
    }
    Some(with().map(|(v, weight)| other.confidence[v as usize] * weight).sum())
}
