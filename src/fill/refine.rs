//! Refinement: new vertices inside a patch, as dense as those round the hole.
//!
//! Source: P. Liepa (2003), section 4, after R. Pfeifle, H.-P. Seidel. Every rim vertex has a
//! scale, the mean length of the old edges at it. A triangle is split at its centroid, whose scale
//! is the mean of its corners', if that is farther from each corner than its own scale and the
//! corner's, and edges are flipped to Delaunay's rule, until nothing changes.

use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::remesh::{PatchMesh, growth};
use std::f64::consts::SQRT_2;

/// Refines `mesh`, whose first vertices are the rim's. `scale`: of each rim vertex. `taken`: true
/// of two rim vertices that must not get an edge. There will be about `limit` new vertices at the
/// most: where more would be needed, all scales grow.
///
/// O(passes * triangles).
pub(super) fn refine(
    mesh: &mut PatchMesh,
    mut scale: Vec<f64>,
    limit: u32,
    taken: &impl Fn(u32, u32) -> bool,
    job: &Job<'_>,
) -> Result<()> {
    let rim = scale.len();
    let grown = growth(mesh, &scale, limit);
    scale.iter_mut().for_each(|s| *s *= grown);
    for pass in 1u32.. {
        let part = job.part(1.0 - 1.0 / f64::from(pass), 1.0 - 1.0 / f64::from(pass + 1));
        mesh.relax(rim, taken, &part)?;
        let before = mesh.triangles.len();
        for t in 0..before {
            let corners = mesh.corners(t);
            let centre = (corners[0] + corners[1] + corners[2]) / 3.0;
            let scales = mesh.triangles[t].map(|v| scale[v as usize]);
            let own = scales.iter().sum::<f64>() / 3.0;
            let far = |k: usize| SQRT_2 * centre.distance(corners[k]) > own.max(scales[k]);
            // Twice the estimate: for shapes that it does not fit.
            if (0..3).all(far) && mesh.points.len() - rim < 2 * limit as usize {
                alloc::push(&mut scale, own)?;
                for part in mesh.split(t, centre)? {
                    mesh.relax_side(rim, taken, part, 0);
                }
            }
        }
        if mesh.triangles.len() == before {
            break;
        }
    }
    Ok(())
}
