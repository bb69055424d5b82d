//! Vertex moves that stop before a triangle folds.

use crate::remesh::PatchMesh;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;

/// A triangle is folded if its normal turns by more than this angle, given as its cosine.
const MIN_UNFOLDED_COSINE: f64 = 0.2;
/// Largest number of times that a vertex returns halfway.
const MAX_MOVE_HALVINGS: u32 = 8;

/// Moves the vertices of `mesh` from `rim` to `places`. Vertices of triangles that would fold move
/// only part of the way. Remaining folds are left to the search for intersections.
pub(super) fn move_without_folds(mesh: &mut PatchMesh, rim: usize, places: &[DVec3]) -> Result<()> {
    let start = alloc::copied(&mesh.points)?;
    let normal = |points: &[DVec3], triangle: [u32; 3]| {
        let [a, b, c] = triangle.map(|v| points[v as usize]);
        (b - a).cross(c - a)
    };
    let mut share = alloc::filled(1.0, places.len())?;
    for _ in 0..MAX_MOVE_HALVINGS {
        for ((point, &from), (&to, &share)) in
            mesh.points[rim..].iter_mut().zip(&start[rim..]).zip(places.iter().zip(&share))
        {
            *point = from.lerp(to, share);
        }
        let mut folds = alloc::filled(false, places.len())?;
        for &triangle in &mesh.triangles {
            let (before, now) = (normal(&start, triangle), normal(&mesh.points, triangle));
            if before.dot(now) < MIN_UNFOLDED_COSINE * before.length() * now.length() {
                triangle.iter().filter_map(|&v| (v as usize).checked_sub(rim)).for_each(|k| folds[k] = true);
            }
        }
        if !folds.contains(&true) {
            break;
        }
        share.iter_mut().zip(folds).filter(|(_, folds)| *folds).for_each(|(share, _)| *share *= 0.5);
    }
    Ok(())
}
