//! Meridians without a search, in O(N + M): by arc length, and by a greedy rule.

use super::rim_pair::{MeridianEnds, RimPair};
use crate::stitch::polyline::lengths;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;

/// Walks both rims at the same pace by relative arc length. The next step is on the rim whose next
/// vertex comes first; on A if both come at once. O(N + M).
pub(super) fn arc_length_meridians(rims: &RimPair<'_>) -> Result<Vec<MeridianEnds>> {
    let (along_a, along_b) = (arc_length_parameters(rims.a)?, arc_length_parameters(rims.b)?);
    walk_lattice(rims, |i, j| along_a[i + 1] <= along_b[j + 1])
}

/// Always steps to the shorter meridian; on A if both are equal. O(N + M).
pub(super) fn greedy_meridians(rims: &RimPair<'_>) -> Result<Vec<MeridianEnds>> {
    let (a, b) = (rims.a, rims.b);
    walk_lattice(rims, |i, j| a[i + 1].distance_squared(b[j]) <= a[i].distance_squared(b[j + 1]))
}

/// Walks from (0, 0) to (N, M). `on_a` decides while both steps are possible.
fn walk_lattice(rims: &RimPair<'_>, on_a: impl Fn(usize, usize) -> bool) -> Result<Vec<MeridianEnds>> {
    let (n, m) = (rims.a.len() - 1, rims.b.len() - 1);
    let mut pairs = alloc::with_capacity(n + m + 1)?;
    let (mut i, mut j) = (0, 0);
    pairs.push([0, 0]);
    while (i, j) != (n, m) {
        if j == m || (i < n && on_a(i, j)) {
            i += 1;
        } else {
            j += 1;
        }
        pairs.push([i as u32, j as u32]);
    }
    Ok(pairs)
}

/// Returns the fraction of the length before each point, or the fraction of the index if the length
/// is 0.
fn arc_length_parameters(points: &[DVec3]) -> Result<Vec<f64>> {
    let mut along = lengths(points, false)?;
    let (length, segments) = (along[points.len() - 1], (points.len() - 1) as f64);
    for (i, t) in along.iter_mut().enumerate() {
        *t = if length > 0.0 { *t / length } else { i as f64 / segments };
    }
    Ok(along)
}
