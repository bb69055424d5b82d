//! Coarse-to-fine search of large lattices.
//!
//! Rim vertices are removed, those on short edges first, until the lattice is small enough for the
//! exact search. Each path bounds the search on the next finer lattice to a band around it. The
//! band is widened where the path touches its border, and where forbidden meridians close it. The
//! result is nearly optimal, not exact; O(N + M) nodes for each level.

use super::lattice_band::LatticeBand;
use super::rim_pair::{MeridianEnds, RimPair, STAGE};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Lattices with at most this number of nodes are searched exactly.
const MAX_COARSEST_NODES: usize = 1 << 16;

/// Rims with fewer segments are not thinned further.
const MIN_THINNED_SEGMENTS: usize = 32;

/// Half the width of the band around the coarser path.
const HALF_BAND_NODES: usize = 8;

/// Largest half-width of a band that is widened where the path touches its border.
const MAX_HALF_BAND_NODES: usize = 512;

/// The whole band is widened if more than one in this number of path nodes touches the border.
const MAX_NODES_PER_BORDER_NODE: usize = 128;

/// Searches the lattice from coarse to fine. `search` returns the best path within a band, for the
/// given rims or for thinned ones. Time and memory: the search of about (2 HALF_BAND_NODES + 1) (N
/// + M) nodes on the finest level, and half as many on each coarser level.
pub(super) fn search_coarse_to_fine(
    rims: &RimPair<'_>,
    search: &impl Fn(&RimPair<'_>, &LatticeBand, &Job<'_>) -> Result<Option<Vec<MeridianEnds>>>,
    job: &Job<'_>,
) -> Result<Option<Vec<MeridianEnds>>> {
    let (n, m) = (rims.a.len() - 1, rims.b.len() - 1);
    if (n + 1) * (m + 1) <= MAX_COARSEST_NODES || (n < MIN_THINNED_SEGMENTS && m < MIN_THINNED_SEGMENTS) {
        return search(rims, &LatticeBand::whole_lattice(n, m)?, job);
    }
    job.step(0.0, STAGE)?;
    let (kept_a, kept_b) = (thin_out_points(rims.a)?, thin_out_points(rims.b)?);
    job.step(0.0, STAGE)?;
    let points = |all: &[DVec3], kept: &[u32]| alloc::collect(kept.iter().map(|&i| all[i as usize]));
    let (a, b) = (points(rims.a, &kept_a)?, points(rims.b, &kept_b)?);
    let sides = match rims.face_normals_along_rims {
        Some([side_a, side_b]) => {
            Some([mean_normals_of_thinned_edges(side_a, &kept_a)?, mean_normals_of_thinned_edges(side_b, &kept_b)?])
        }
        None => None,
    };
    // Forbidden meridians do not matter on the coarse levels.
    let sides = sides.as_ref().map(|[side_a, side_b]| [side_a.as_slice(), side_b.as_slice()]);
    let coarse =
        RimPair { a: &a, b: &b, closed: rims.closed, forbidden: &[], face_normals_along_rims: sides, penalties: &[] };
    let Some(mut path) = search_coarse_to_fine(&coarse, search, &job.sub_job(0.0, 0.4))? else {
        return Ok(None);
    };
    job.step(0.4, STAGE)?;
    path.iter_mut().for_each(|[i, j]| (*i, *j) = (kept_a[*i as usize], kept_b[*j as usize]));
    let mut band = LatticeBand::around_path(&path, n, m, HALF_BAND_NODES)?;
    let (mut width, mut done) = (HALF_BAND_NODES, 0.4);
    loop {
        let until = (1.0 + done) / 2.0;
        let found = search(rims, &band, &job.sub_job(done, until))?;
        (width, done) = (4 * width, until);
        match found {
            // If the path runs along the border of the band, a better path may lie beyond it.
            Some(found) => {
                let touching = band.border_nodes(&found)?;
                if touching.is_empty() || width > MAX_HALF_BAND_NODES {
                    return Ok(Some(found));
                }
                if touching.len() > found.len() / MAX_NODES_PER_BORDER_NODE {
                    band = LatticeBand::around_path(&found, n, m, width)?;
                } else {
                    band = LatticeBand::around_path(&found, n, m, HALF_BAND_NODES)?;
                    band.widen_at_nodes(&touching, width);
                }
            }
            // Forbidden meridians close the band: the path lies farther out.
            None if !rims.forbidden.is_empty() && width < 4 * n.max(m) => {
                band = LatticeBand::around_path(&path, n, m, width)?;
            }
            None => return Ok(None),
        }
    }
}

/// Returns the points to keep, including the first and the last. Kept points are about two mean
/// edges apart, so that dense runs are thinned and long edges stay. Keeps at most three quarters.
fn thin_out_points(points: &[DVec3]) -> Result<Vec<u32>> {
    let last = points.len() - 1;
    if last < MIN_THINNED_SEGMENTS {
        return alloc::collect((0..points.len()).map(|i| i as u32));
    }
    let edge = |i: usize| points[i].distance(points[i - 1]);
    let mean = (1..=last).map(edge).sum::<f64>() / last as f64;
    let mut reach = 2.000001 * mean;
    loop {
        let mut kept = alloc::with_capacity(points.len())?;
        kept.push(0);
        let mut length = 0.0;
        for i in 1..=last {
            length += edge(i);
            if i == last || length + edge(i + 1) > reach {
                kept.push(i as u32);
                length = 0.0;
            }
        }
        // With edges of length 0, all points are alike.
        if kept.len() <= points.len() / 4 * 3 || mean == 0.0 {
            return Ok(kept);
        }
        reach *= 2.0;
    }
}

/// Returns the mean normals of the edges from each kept point to the next.
fn mean_normals_of_thinned_edges(normals: &[DVec3], kept: &[u32]) -> Result<Vec<DVec3>> {
    let mean = |pair: &[u32]| normals[pair[0] as usize..pair[1] as usize].iter().sum::<DVec3>().normalize_or_zero();
    alloc::collect(kept.windows(2).map(mean))
}
