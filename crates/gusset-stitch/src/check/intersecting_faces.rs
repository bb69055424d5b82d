//! Faces that intersect each other.

use crate::intersect::{TriangleSoup, intersecting_pairs_where};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use gusset_mesh::MeshView;

/// Number of faces between two progress reports.
const FACES_PER_REPORT: usize = 1 << 16;

const STAGE: &str = "looking for intersections";

/// Returns the pairs of faces that intersect, the smaller number first, in ascending order.
///
/// Common vertices and edges do not count, nor do their coincident copies. Every other common point
/// counts, also where faces only touch. Quads are split along the shorter diagonal, and other
/// polygons as fans from their first corners. Triangles of one face are not compared, and
/// triangles that repeat a vertex are skipped.
///
/// O(n log n + overlapping pairs of boxes) for n triangles, at worst O(n^2); extra memory about 200
/// bytes per triangle, and 8 bytes per pair.
///
/// # Errors
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled).
pub fn find_intersecting_faces(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Vec<[u32; 2]>> {
    let (triangles, faces) = split_faces(mesh, &job.part(0.0, 0.1))?;
    let at = |v: u32| mesh.positions().get(v);
    let largest = triangles.as_flattened().iter().map(|&v| at(v).abs().max_element()).fold(0.0, f64::max);
    let unit = common_unit(&[DVec3::splat(largest)]);
    let soup = TriangleSoup { at: |v| at(v) / unit, new: &triangles, old: &[] };
    let wanted = |s: u32, t: u32| faces[s as usize] != faces[t as usize];
    let pairs = intersecting_pairs_where(&soup, &wanted, &|_, _| true, &job.part(0.1, 1.0))?;
    // Triangles are in the order of their faces.
    let mut pairs = alloc::collect(pairs.iter().map(|pair| pair.map(|t| faces[t as usize])))?;
    sort_distinct(&mut pairs);
    Ok(pairs)
}

/// Returns the triangles of all faces, and the face of each.
fn split_faces(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<(Vec<[u32; 3]>, Vec<u32>)> {
    let at = |v: u32| mesh.positions().get(v);
    let (mut triangles, mut faces, mut face) = (Vec::new(), Vec::new(), Vec::new());
    let count = mesh.faces().len();
    for f in 0..count {
        job.step_every(FACES_PER_REPORT, f, count, STAGE)?;
        face.clear();
        alloc::extend(&mut face, mesh.face(f))?;
        let squared = |p: usize, q: usize| at(face[p]).distance_squared(at(face[q]));
        let first = usize::from(face.len() == 4 && squared(0, 2) > squared(1, 3));
        let corner = |k: usize| face[(first + k) % face.len()];
        for k in 1..face.len() - 1 {
            let [a, b, c] = [corner(0), corner(k), corner(k + 1)];
            if a != b && b != c && c != a {
                alloc::push(&mut triangles, [a, b, c])?;
                alloc::push(&mut faces, f as u32)?;
            }
        }
    }
    Ok((triangles, faces))
}
