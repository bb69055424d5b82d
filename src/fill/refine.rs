//! Refinement: new vertices inside a patch, as dense as those round the hole.
//!
//! Source: P. Liepa (2003), section 4, after R. Pfeifle, H.-P. Seidel. Every rim vertex has a
//! scale, the mean length of the old edges at it. A triangle is split at its centroid, whose scale
//! is the mean of its corners', if that is farther from each corner than its own scale and the
//! corner's, and edges are flipped to Delaunay's rule, until nothing changes.

use super::patch_mesh::PatchMesh;
use crate::alloc;
use crate::error::Result;
use crate::geom::triangle::double_area;
use crate::job::Job;
use glam::DVec3;
use std::f64::consts::SQRT_2;

/// Passes over all edges in which flips may follow from flips.
const MAX_PASSES: usize = 30;
/// An edge is not flipped where the new one would bend by more than the old one did and more than
/// this: 1 - cosine of 60 degrees.
const MAX_BEND: f64 = 0.5;
/// Angles whose sum exceeds half a turn by less than this are left alone: the sine.
const COCIRCULAR: f64 = 1e-9;
/// No flip makes a triangle whose doubled area is less than this part of its sides' squares.
const FLAT: f64 = 1e-6;

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
    relax(mesh, rim, taken);
    for pass in 1u32.. {
        job.step(1.0 - 1.0 / f64::from(pass), "refining holes")?;
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
                    relax_side(mesh, rim, taken, part, 0);
                }
            }
        }
        if mesh.triangles.len() == before {
            break;
        }
        relax(mesh, rim, taken);
    }
    Ok(())
}

/// What all scales must be multiplied by to keep the number of vertices below `limit`, taking one
/// for each two equilateral triangles of a side of its scale.
fn growth(mesh: &PatchMesh, scale: &[f64], limit: u32) -> f64 {
    let needed = |t: usize| {
        let [a, b, c] = mesh.corners(t);
        let mean = mesh.triangles[t].iter().map(|&v| scale[v as usize]).sum::<f64>() / 3.0;
        double_area(a, b, c) / (3f64.sqrt() * mean * mean)
    };
    let needed: f64 = (0..mesh.triangles.len()).map(needed).sum();
    (needed / f64::from(limit)).sqrt().max(1.0)
}

/// Flips edges until all keep Delaunay's rule, or the passes are used up.
pub(super) fn relax(mesh: &mut PatchMesh, rim: usize, taken: &impl Fn(u32, u32) -> bool) {
    for _ in 0..MAX_PASSES {
        let mut flipped = false;
        for t in 0..mesh.triangles.len() {
            for k in 0..3 {
                flipped |= relax_side(mesh, rim, taken, t, k);
            }
        }
        if !flipped {
            break;
        }
    }
}

/// Flips side `k` of triangle `t` if the angles opposite to it are more than half a turn together;
/// true if it did.
fn relax_side(mesh: &mut PatchMesh, rim: usize, taken: &impl Fn(u32, u32) -> bool, t: usize, k: usize) -> bool {
    let Some((s, j)) = mesh.beyond(t, k) else {
        return false;
    };
    let [u, v] = [mesh.triangles[t][(k + 2) % 3], mesh.triangles[s][(j + 2) % 3]];
    let [p, q] = [mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]].map(|v| mesh.points[v as usize]);
    let [c, d] = [u, v].map(|v| mesh.points[v as usize]);
    // sin(alpha + beta), up to a positive factor, negative beyond half a turn.
    let legs = [p - c, q - c, p - d, q - d];
    let (sine, other_sine) = (legs[0].cross(legs[1]).length(), legs[2].cross(legs[3]).length());
    let sum = sine * legs[2].dot(legs[3]) + other_sine * legs[0].dot(legs[1]);
    let size = legs.iter().map(|leg| leg.length()).product::<f64>();
    if sum >= -COCIRCULAR * size {
        return false;
    }
    let rims = (u as usize) < rim && (v as usize) < rim;
    if rims && taken(u, v) || mesh.has_edge(t, (k + 2) % 3, v) {
        return false;
    }
    let new_normals = [(d - p).cross(c - p), (q - d).cross(c - d)];
    if new_normals.iter().any(|normal| normal.length() <= FLAT * size.sqrt()) {
        return false;
    }
    let bend = |a: DVec3, b: DVec3| 1.0 - a.normalize_or_zero().dot(b.normalize_or_zero());
    let old = bend((q - p).cross(c - p), (d - p).cross(q - p));
    let new = bend(new_normals[0], new_normals[1]);
    if new > old && new > MAX_BEND {
        return false;
    }
    mesh.flip((t, k), (s, j));
    true
}
