//! Pairs of free edges that coincide only beyond the tolerance: the hint which tolerance sews them.
//!
//! Two vertices are near if their distance is at most a tenth of the shortest edge at either. Near
//! vertices form sets: where several faces of a soup meet, each has a corner of its own. Two free
//! edges are near if they join the same two sets. The criterion is our own.

use super::sew_edges::free_edges;
use super::weld_tolerance::shortest_edge_lengths;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::geom::scale::overflow_safe_distance;
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use gusset_mesh::{MeshView, NONE, Topology};

/// Largest distance between near vertices, relative to the shortest edge at either.
const MAX_NEAR_TO_EDGE_RATIO: f64 = 0.1;

/// Largest number of rounds that join sets. Each round joins every set that has a near place with
/// another one.
const MAX_ROUNDS: usize = 16;

/// Larger sets are measured by their box.
const MAX_MEASURED_PLACES: usize = 64;

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
    /// Finds the near edges among the free edges that the `clusters` of the `members` leave single.
    /// `clusters` maps each vertex to the representative of its cluster, and `sewn_edges` is the number
    /// of pairs of free edges that coincide.
    ///
    /// O(H + B log B) for H half-edges and B members; O(H) if no free edge is left.
    pub(super) fn find(
        mesh: &MeshView<'_>,
        topology: &Topology,
        members: &[u32],
        clusters: &[u32],
        sewn_edges: u32,
        job: &Job<'_>,
    ) -> Result<Self> {
        if free_edges(mesh, topology).count() as u64 == 2 * u64::from(sewn_edges) {
            return Ok(NearBorders::default());
        }
        let places = alloc::gather(members.iter().copied().filter(|&v| clusters[v as usize] == v))?;
        let edges = edges_left(mesh, topology, clusters)?;
        if places.len() < 3 || edges.len() < 2 {
            return Ok(NearBorders::default());
        }
        let sets = NearSets::find(mesh, &places, members, clusters, &job.sub_job(0.0, 0.9))?;
        let mut keyed = alloc::gather(edges.iter().filter_map(|&ends| {
            let [u, v] = ends.map(|v| sets.set_of_place[v as usize]);
            (u != v && u != NONE && v != NONE).then_some([u.min(v), u.max(v)])
        }))?;
        job.step(0.9, STAGE)?;
        keyed.sort_unstable();
        let mut near = NearBorders::default();
        let mut involved = Vec::new();
        for group in keyed.chunk_by(|x, y| x == y).filter(|group| group.len() > 1) {
            near.edge_pairs += group.len() as u32 / 2;
            alloc::extend(&mut involved, group[0])?;
        }
        sort_distinct(&mut involved);
        near.tolerance = round_up(sets.largest_diameter(mesh, &places, &involved)?);
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

/// Returns the free edges, each as the representatives of its ends, whose ends no other free edge
/// shares.
fn edges_left(mesh: &MeshView<'_>, topology: &Topology, clusters: &[u32]) -> Result<Vec<[u32; 2]>> {
    let named = free_edges(mesh, topology).map(|(_, ends)| ends.map(|v| clusters[v as usize]));
    let mut edges = alloc::gather(named.filter(|[u, v]| u != v).map(|[u, v]| [u.min(v), u.max(v)]))?;
    edges.sort_unstable();
    alloc::gather(edges.chunk_by(|x, y| x == y).filter(|group| group.len() == 1).map(|group| group[0]))
}

/// Sets of near vertices.
struct NearSets {
    /// For each vertex that represents a cluster, the number of its set; otherwise [`NONE`].
    set_of_place: Vec<u32>,
}

impl NearSets {
    /// Finds the sets of `places`, the representatives of clusters of `members`: near places are
    /// joined until none are left, or [`MAX_ROUNDS`] are over.
    fn find(mesh: &MeshView<'_>, places: &[u32], members: &[u32], clusters: &[u32], job: &Job<'_>) -> Result<Self> {
        let mut shortest = shortest_edge_lengths(mesh, members, 0.0, &job.sub_job(0.0, 0.1))?;
        for &v in members {
            let place = clusters[v as usize] as usize;
            shortest[place] = shortest[place].min(shortest[v as usize]);
        }
        let points = alloc::collect(places.iter().map(|&v| mesh.positions().get(v)))?;
        let limit = |i: usize| MAX_NEAR_TO_EDGE_RATIO * shortest[places[i] as usize];
        let tree = KdTree::new(&points, &job.sub_job(0.1, 0.2), STAGE)?;
        let mut sets = DisjointSets::new(places.len())?;
        let mut roots = alloc::collect(0..places.len() as u32)?;
        let mut asking = alloc::collect(0..places.len())?;
        for round in 0..MAX_ROUNDS {
            let part = job.sub_job(0.2, 1.0).sub_job_of_item(round, MAX_ROUNDS);
            let mut joined = Vec::new();
            for (k, &i) in asking.iter().enumerate() {
                part.step_every(VERTICES_PER_REPORT, k, asking.len(), STAGE)?;
                let is_near = |j: u32| {
                    roots[j as usize] != roots[i]
                        && points[i].distance_squared(points[j as usize]) <= limit(j as usize).powi(2)
                };
                if let Some((_, j)) = tree.nearest(points[i], limit(i).powi(2), is_near) {
                    sets.union(i as u32, j);
                    alloc::push(&mut joined, i)?;
                }
            }
            if joined.is_empty() {
                break;
            }
            asking = joined;
            roots.iter_mut().zip(0u32..).for_each(|(root, i)| *root = sets.find(i));
        }
        let mut set_of_place = alloc::filled(NONE, mesh.positions().len())?;
        places.iter().zip(&roots).for_each(|(&v, &root)| set_of_place[v as usize] = root);
        Ok(NearSets { set_of_place })
    }

    /// Returns the largest diameter of the sets `involved`, which ascend. A set of more than
    /// [`MAX_MEASURED_PLACES`] has the diagonal of its box.
    fn largest_diameter(&self, mesh: &MeshView<'_>, places: &[u32], involved: &[u32]) -> Result<f64> {
        let set = |v: u32| self.set_of_place[v as usize];
        let mut of_sets =
            alloc::gather(places.iter().map(|&v| (set(v), v)).filter(|(of, _)| involved.binary_search(of).is_ok()))?;
        of_sets.sort_unstable();
        let position = |&(_, v): &(u32, u32)| mesh.positions().get(v);
        let diameter = |set: &[(u32, u32)]| {
            if set.len() > MAX_MEASURED_PLACES {
                let Aabb { low, high } = Aabb::from_points(set.iter().map(position));
                return overflow_safe_distance(low, high);
            }
            let pairs = set.iter().enumerate().flat_map(|(k, p)| set[k + 1..].iter().map(move |q| (p, q)));
            pairs.map(|(p, q)| overflow_safe_distance(position(p), position(q))).fold(0.0, f64::max)
        };
        Ok(of_sets.chunk_by(|x, y| x.0 == y.0).map(diameter).fold(0.0, f64::max))
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
