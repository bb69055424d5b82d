//! The meridian to begin with: the closest pair of vertices.
//!
//! The paper leaves the pairing of the rims' starts open. On the study's real rims the closest pair was the exact optimum
//! over all starts, while the arrays' own starts gave strips of eight times the area.

use super::rim::{Bridges, Rim};
use crate::error::Result;
use crate::geom::kd_tree::KdTree;
use crate::job::Job;

/// Vertices between two progress reports.
const STEP: usize = 1 << 10;

/// The places (i, j) of the closest vertices of the two rims that are not joined by an edge already; of equally close
/// pairs the smallest i, then j. `None` if every pair is joined. O((N + M) log M).
pub(super) fn closest_pair(a: &Rim, b: &Rim, bridges: &Bridges, job: &Job<'_>) -> Result<Option<(usize, usize)>> {
    let tree = KdTree::new(&b.points)?;
    let mut best = (f64::INFINITY, None);
    for (i, (&p, &u)) in a.points.iter().zip(&a.vertices).enumerate() {
        if i % STEP == 0 {
            job.step(i as f64 / a.points.len() as f64, "looking for the closest pair")?;
        }
        let found = tree.nearest(p, best.0, |j| !bridges.has(u, b.vertices[j as usize]));
        if let Some((distance, j)) = found
            && (distance < best.0 || best.1.is_none())
        {
            best = (distance, Some((i, j as usize)));
        }
    }
    Ok(best.1)
}
