//! Pairs of free edges that coincide only beyond the tolerance: the hint which tolerance sews them.
//!
//! A vertex that coincides with no other has a near partner if both are mutually nearest among such
//! vertices, and nearer than a tenth of the shortest edge at either. Two free
//! edges are near if their ends are partners. The criterion is our own.

use super::sew_edges::free_edges;
use super::weld_tolerance::shortest_edge_lengths;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::geom::scale::overflow_safe_distance;
use gusset_base::job::Job;
use gusset_mesh::{MeshView, NONE, Topology};

/// Largest distance between near vertices, relative to the shortest edge at either.
const MAX_NEAR_TO_EDGE_RATIO: f64 = 0.1;

/// Number of vertices between two progress reports.
const VERTICES_PER_REPORT: usize = 1 << 12;

const STAGE: &str = "looking for borders beyond the tolerance";

/// Free edges that a larger tolerance would sew.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct NearBorders {
    /// The number of pairs of free edges.
    pub edge_pairs: u32,
    /// The tolerance that covers all of them, with two significant digits; 0 without such edges.
    pub tolerance: f64,
}

impl NearBorders {
    /// Finds the near edges between `members` that are alone in their clusters.
    ///
    /// O(H + B log B) for H half-edges and B such members; O(B) if there are none.
    pub(super) fn find(
        mesh: &MeshView<'_>,
        topology: &Topology,
        members: &[u32],
        clusters: &[u32],
        job: &Job<'_>,
    ) -> Result<Self> {
        let mut has_company = alloc::filled(false, clusters.len())?;
        for &v in members.iter().filter(|&&v| clusters[v as usize] != v) {
            has_company[clusters[v as usize] as usize] = true;
        }
        let alone = members.iter().copied().filter(|&v| clusters[v as usize] == v && !has_company[v as usize]);
        let alone = alloc::gather(alone)?;
        if alone.len() < 4 {
            return Ok(NearBorders::default());
        }
        let partner = find_near_partners(mesh, &alone, MAX_NEAR_TO_EDGE_RATIO, &job.sub_job(0.0, 0.8))?;
        if alone.iter().all(|&v| partner[v as usize] == NONE) {
            return Ok(NearBorders::default());
        }
        let ordered = |[u, v]: [u32; 2]| [u.min(v), u.max(v)];
        let partners = |ends: [u32; 2]| ends.map(|v| partner[v as usize]);
        let with_partners = free_edges(mesh, topology).filter(|&(_, ends)| !partners(ends).contains(&NONE));
        let mut edges = alloc::gather(with_partners.map(|(_, ends)| ordered(ends)))?;
        job.step(0.9, STAGE)?;
        edges.sort_unstable();
        let mut near = NearBorders::default();
        let mut largest = 0.0f64;
        for &edge in &edges {
            let other = ordered(partners(edge));
            if edge < other && edges.binary_search(&other).is_ok() {
                near.edge_pairs += 1;
                let apart =
                    |v: u32| overflow_safe_distance(mesh.positions().get(v), mesh.positions().get(partner[v as usize]));
                largest = edge.into_iter().map(apart).fold(largest, f64::max);
            }
        }
        near.tolerance = round_up(largest);
        Ok(near)
    }

    /// Reports the hint, if there is one.
    pub(super) fn note_hint(&self, job: &Job<'_>) {
        if let Some(hint) = self.hint() {
            job.note(&hint);
        }
    }

    /// Returns a sentence with the tolerance; `None` without near edges.
    pub fn hint(&self) -> Option<String> {
        let (pairs, verb) = match self.edge_pairs {
            0 => return None,
            1 => ("pair of boundary edges coincides", "sews it"),
            _ => ("pairs of boundary edges coincide", "sews them"),
        };
        let tolerance = self.tolerance;
        Some(format!("{} {pairs} within {tolerance:e}: tolerance {tolerance:e} {verb}", self.edge_pairs))
    }
}

/// Returns the near partner of each vertex of the mesh, or [`NONE`]. Partners are mutually nearest among
/// the vertices `alone`, and at most `max_ratio` times the shortest edge at either apart.
pub(crate) fn find_near_partners(
    mesh: &MeshView<'_>,
    alone: &[u32],
    max_ratio: f64,
    job: &Job<'_>,
) -> Result<Vec<u32>> {
    let shortest = shortest_edge_lengths(mesh, alone, 0.0, &job.sub_job(0.0, 0.2))?;
    let points = alloc::collect(alone.iter().map(|&v| mesh.positions().get(v)))?;
    let tree = KdTree::new(&points, &job.sub_job(0.2, 0.4), STAGE)?;
    let limit = |i: usize| max_ratio * shortest[alone[i] as usize];
    let mut nearest = alloc::with_capacity(alone.len())?;
    for (i, &p) in points.iter().enumerate() {
        job.sub_job(0.4, 1.0).step_every(VERTICES_PER_REPORT, i, points.len(), STAGE)?;
        let found = tree.nearest(p, limit(i) * limit(i), |j| j as usize != i);
        nearest.push(found.map_or(NONE, |(_, j)| j));
    }
    let mut partner = alloc::filled(NONE, mesh.positions().len())?;
    for (i, &j) in nearest.iter().enumerate() {
        if j != NONE && nearest[j as usize] as usize == i {
            partner[alone[i] as usize] = alone[j as usize];
        }
    }
    Ok(partner)
}

/// Rounds a length up to two significant digits, with a margin for the rounding of the result.
fn round_up(length: f64) -> f64 {
    if length <= 0.0 || !length.is_normal() {
        return length;
    }
    let exponent = libm::log10(length).floor() as i32 - 1;
    let digits = libm::ceil(length / 10f64.powi(exponent) - 1e-9).max(1.0);
    let written: f64 = format!("{digits}e{exponent}").parse().unwrap_or(length);
    if written < length { (digits + 1.0) * 10f64.powi(exponent) } else { written }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_rounded_up() {
        for (length, rounded) in
            [(1e-4, 1e-4), (0.9e-4, 9e-5), (1.01e-4, 1.1e-4), (0.0314, 0.032), (99.5, 100.0), (0.0, 0.0)]
        {
            assert_eq!(round_up(length), rounded, "{length}");
        }
        let mut random = fastrand::Rng::with_seed(1);
        for _ in 0..100_000 {
            let length = 10f64.powf(40.0 * random.f64() - 20.0);
            let rounded = round_up(length);
            assert!(length <= rounded && rounded <= 1.12 * length, "{length} {rounded}");
        }
    }
}
