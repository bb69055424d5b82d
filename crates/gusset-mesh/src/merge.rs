//! Merge maps: which vertices have equal keys or equal positions.

use super::view::MeshView;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::sort;
use std::cmp::Ordering;

const STAGE: &str = "finding equal vertices";

/// Computes a merge map as [`MeshView::merged_corners`] takes it. The map sends each vertex to the
/// smallest vertex with the same key. Without keys it compares positions, where -0 equals 0 and a
/// vertex whose position is not finite is equal only to itself. O(n log n).
///
/// # Errors
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled).
pub fn map_to_equal_vertices(mesh: &MeshView<'_>, keys: Option<&[u32]>, job: &Job<'_>) -> Result<Vec<u32>> {
    let positions = mesh.positions();
    let mut order = alloc::collect(0..positions.len() as u32)?;
    let place = |v: u32| positions.get(v).to_array();
    let compare = |&u: &u32, &v: &u32| match keys {
        Some(keys) => keys[u as usize].cmp(&keys[v as usize]),
        // A numeric comparison makes 0 and -0 equal; NaN goes to the ends.
        None => place(u)
            .into_iter()
            .zip(place(v))
            .map(|(x, y)| compare_coordinates(x, y))
            .find(|o| o.is_ne())
            .unwrap_or(Ordering::Equal),
    };
    sort(&mut order, |u, v| compare(u, v).then(u.cmp(v)), &job.sub_job(0.0, 0.9), STAGE)?;
    let mut merge = alloc::collect(0..positions.len() as u32)?;
    let is_one = |u: u32, v: u32| compare(&u, &v).is_eq() && (keys.is_some() || positions.get(u).is_finite());
    for (k, pair) in order.windows(2).enumerate() {
        job.sub_job(0.9, 1.0).step_within_list(k, STAGE)?;
        if is_one(pair[0], pair[1]) {
            merge[pair[1] as usize] = merge[pair[0] as usize];
        }
    }
    Ok(merge)
}

fn compare_coordinates(x: f64, y: f64) -> Ordering {
    x.partial_cmp(&y).unwrap_or_else(|| x.total_cmp(&y))
}
