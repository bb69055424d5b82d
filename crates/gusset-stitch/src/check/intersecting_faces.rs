//! Faces that intersect each other.

use crate::intersect::{TriangleSoup, intersecting_pairs_where};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use gusset_mesh::{FaceTriangles, MeshView};

/// Returns the pairs of faces that intersect, the smaller number first, in ascending order.
///
/// Common vertices and edges do not count, nor do their coincident copies. Every other common point
/// counts, also where faces only touch. Faces are split as [`FaceTriangles`] does. Triangles of one
/// face are not compared, and triangles that repeat a vertex are skipped.
///
/// O(n log n + overlapping pairs of boxes) for n triangles, at worst O(n^2); extra memory about 200
/// bytes per triangle, and 8 bytes per pair.
///
/// # Errors
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled).
pub fn find_intersecting_faces(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Vec<[u32; 2]>> {
    let FaceTriangles { corners: mut triangles, mut faces, .. } =
        FaceTriangles::from_mesh(mesh, &job.sub_job(0.0, 0.1))?;
    let repeats = |&[a, b, c]: &[u32; 3]| a == b || b == c || c == a;
    let mut is_kept = triangles.iter().map(|triangle| !repeats(triangle));
    faces.retain(|_| is_kept.next() != Some(false));
    triangles.retain(|triangle| !repeats(triangle));
    let at = |v: u32| mesh.positions().get(v);
    let largest = triangles.as_flattened().iter().map(|&v| at(v).abs().max_element()).fold(0.0, f64::max);
    let unit = common_unit(&[DVec3::splat(largest)]);
    let soup = TriangleSoup { position_of_vertex: |v| at(v) / unit, new_triangles: &triangles, old_triangles: &[] };
    let wanted = |s: u32, t: u32| faces[s as usize] != faces[t as usize];
    let pairs = intersecting_pairs_where(&soup, &wanted, &|_, _| true, &job.sub_job(0.1, 1.0))?;
    // Triangles are in the order of their faces.
    let mut pairs = alloc::collect(pairs.iter().map(|pair| pair.map(|t| faces[t as usize])))?;
    sort_distinct(&mut pairs);
    Ok(pairs)
}
