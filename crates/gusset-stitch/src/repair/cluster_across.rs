//! Clusters for a tolerance that is wider than edges of the borders.
//!
//! Within such a tolerance a vertex reaches its neighbours on its own surface. So two vertices are
//! merged only if they are mutually nearest among the vertices **across** from each other: the way
//! between them along edges is longer than [`MAX_WAY_TO_DISTANCE_RATIO`] of their distance. On the
//! two sides of a crack the way leads round its tip. The criterion is our own.

use super::vertex_clusters::VertexClusters;
use super::weld_tolerance::limited_reach;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::job::Job;
use gusset_base::sort::Buckets;
use gusset_mesh::{MeshView, NONE, half_edges};

/// Largest way along edges between vertices that are not merged, relative to their distance.
const MAX_WAY_TO_DISTANCE_RATIO: f64 = 2.0;

/// Number of vertices that are visited from each vertex to measure ways.
const MAX_VERTICES_VISITED: usize = 1 << 10;

/// Number of points between two progress reports.
const POINTS_PER_REPORT: usize = 1 << 8;

const STAGE: &str = "pairing borders";

impl VertexClusters {
    /// Clusters the border vertices `members` for a tolerance that may be wider than edges. Vertices
    /// within a quarter of the edges there are merged first, as for narrower tolerances.
    ///
    /// O(H + B log B + B k) for H half-edges and B members with k vertices within the tolerance.
    pub(super) fn cluster_across_borders(
        mesh: &MeshView<'_>,
        members: &[u32],
        tolerance: f64,
        job: &Job<'_>,
    ) -> Result<Self> {
        let reach = limited_reach(mesh, members, tolerance, false, &job.sub_job(0.0, 0.1))?;
        let mut clusters = Self::cluster_members(mesh, members, &reach, None, &job.sub_job(0.1, 0.4))?;
        if reach.iter().all(|&reach| reach == tolerance) {
            return Ok(clusters);
        }
        let nearest = nearest_across(mesh, members, &clusters.representative, tolerance, &job.sub_job(0.4, 0.9))?;
        let mut merged = alloc::collect((0..clusters.representative.len()).map(|v| v as u32))?;
        for &[v, w] in &nearest {
            if nearest.binary_search(&[w, v]).is_ok() {
                merged[v as usize] = v.min(w);
            }
        }
        members.iter().for_each(|&v| {
            let representative = &mut clusters.representative[v as usize];
            *representative = merged[*representative as usize];
        });
        job.step(1.0, STAGE)?;
        Ok(clusters)
    }
}

/// Returns pairs of a representative of `members` and the nearest one across from it, ascending.
fn nearest_across(
    mesh: &MeshView<'_>,
    members: &[u32],
    clusters: &[u32],
    tolerance: f64,
    job: &Job<'_>,
) -> Result<Vec<[u32; 2]>> {
    let vertices = alloc::gather(members.iter().copied().filter(|&v| clusters[v as usize] == v))?;
    let points = alloc::collect(vertices.iter().map(|&v| mesh.positions().get(v)))?;
    let tree = KdTree::new(&points, &job.sub_job(0.0, 0.1), STAGE)?;
    let mut ways = EdgePathLengths::new(mesh, clusters, &job.sub_job(0.1, 0.2))?;
    let mut nearest = alloc::with_capacity(points.len())?;
    for (i, &p) in points.iter().enumerate() {
        job.sub_job(0.2, 1.0).step_every(POINTS_PER_REPORT, i, points.len(), STAGE)?;
        let known = ways.measure_paths_from(vertices[i], MAX_WAY_TO_DISTANCE_RATIO * tolerance)?;
        let lies_across = |j: u32| {
            let distance = points[j as usize].distance(p);
            let way = ways.path_length_to(vertices[j as usize]).min(known);
            distance <= tolerance && way > MAX_WAY_TO_DISTANCE_RATIO * distance
        };
        if let Some((_, j)) = tree.nearest(p, (1.0 + 1e-9) * tolerance * tolerance, lies_across) {
            nearest.push([vertices[i], vertices[j as usize]]);
        }
    }
    Ok(nearest)
}

/// The lengths of the ways along edges from one vertex.
struct EdgePathLengths<'m> {
    mesh: &'m MeshView<'m>,
    neighbours: Buckets<u32>,
    start_vertex: u32,
    /// For each vertex, the vertex from which it was last reached, and the way from there.
    path_start_and_length: Vec<(u32, f64)>,
    queue: Vec<u32>,
}

impl<'m> EdgePathLengths<'m> {
    fn new(mesh: &'m MeshView<'m>, clusters: &[u32], job: &Job<'_>) -> Result<Self> {
        let ends = (0..mesh.faces().len()).flat_map(|f| half_edges(mesh, f)).flat_map(|(_, u, v)| {
            let [u, v] = [u, v].map(|v| clusters[v as usize]);
            [(u as usize, v), (v as usize, u)]
        });
        Ok(EdgePathLengths {
            mesh,
            neighbours: Buckets::new_cancellable(clusters.len(), 0u32, ends, job, STAGE)?,
            start_vertex: NONE,
            path_start_and_length: alloc::filled((NONE, f64::INFINITY), clusters.len())?,
            queue: Vec::new(),
        })
    }

    /// Measures the ways of at most `longest` from a vertex, in the order of the number of edges.
    /// Returns a length up to which all ways are known.
    fn measure_paths_from(&mut self, from: u32, longest: f64) -> Result<f64> {
        let at = |v: u32| self.mesh.positions().get(v);
        self.start_vertex = from;
        self.path_start_and_length[from as usize] = (from, 0.0);
        self.queue.clear();
        alloc::push(&mut self.queue, from)?;
        let mut done = 0;
        while done < self.queue.len().min(MAX_VERTICES_VISITED) {
            let u = self.queue[done];
            done += 1;
            for &v in self.neighbours.get(u as usize) {
                let way = self.path_start_and_length[u as usize].1 + at(u).distance(at(v));
                if way <= longest && way < self.path_length_to(v) {
                    self.path_start_and_length[v as usize] = (from, way);
                    alloc::push(&mut self.queue, v)?;
                }
            }
        }
        Ok(self.queue[done..].iter().map(|&v| self.path_length_to(v)).fold(f64::INFINITY, f64::min))
    }

    /// Returns the way to a vertex; infinite if it was not reached.
    fn path_length_to(&self, v: u32) -> f64 {
        let (from, way) = self.path_start_and_length[v as usize];
        if from == self.start_vertex { way } else { f64::INFINITY }
    }
}
