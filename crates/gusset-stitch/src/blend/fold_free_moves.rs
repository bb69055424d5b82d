//! Vertices moved as far as no triangle folds.

use crate::remesh::PatchMesh;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;

/// A triangle that turns by more is folded: the cosine.
const MIN_TURN: f64 = 0.2;
/// How often a vertex that folds a triangle is taken back halfway.
const MAX_HALVINGS: u32 = 8;

/// Moves the vertices of `mesh` from `rim` on to `places`, those of triangles that would fold only
/// part of the way; what folds then still is left to the search for cuts.
pub(super) fn unfold(mesh: &mut PatchMesh, rim: usize, places: &[DVec3]) -> Result<()> {
    let start = alloc::copied(&mesh.points)?;
    let normal = |points: &[DVec3], triangle: [u32; 3]| {
        let [a, b, c] = triangle.map(|v| points[v as usize]);
        (b - a).cross(c - a)
    };
    let mut share = alloc::filled(1.0, places.len())?;
    for _ in 0..MAX_HALVINGS {
        for ((point, &from), (&to, &share)) in
            mesh.points[rim..].iter_mut().zip(&start[rim..]).zip(places.iter().zip(&share))
        {
            *point = from.lerp(to, share);
        }
        let mut folds = alloc::filled(false, places.len())?;
        for &triangle in &mesh.triangles {
            let (before, now) = (normal(&start, triangle), normal(&mesh.points, triangle));
            if before.dot(now) < MIN_TURN * before.length() * now.length() {
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
