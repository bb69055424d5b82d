//! Cut edges of a surface, and shortest paths along edges.

use super::STAGE;
use super::develop_request::{CutKind, Cuts};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::bit_set::BitSet;
use gusset_base::geom::scale::overflow_safe_distance;
use gusset_base::job::Job;
use gusset_base::sort::Buckets;
use gusset_mesh::{Defect, MeshView, NONE, Opposite, Topology, half_edges};
use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

/// The half-edges of a surface, and the cuts.
pub(super) struct CutSurface<'m, 'a> {
    pub(super) mesh: &'m MeshView<'a>,
    /// The mate of each half-edge; [`NONE`] at borders, at edges with three or more faces, and at
    /// edges whose faces have inconsistent orientations.
    mates: Vec<u32>,
    is_cut: BitSet,
    pub(super) cut_edges: Vec<([u32; 2], CutKind)>,
}

impl<'m, 'a> CutSurface<'m, 'a> {
    /// Creates a surface without cuts. O(H log d).
    pub(super) fn new(mesh: &'m MeshView<'a>, job: &Job<'_>) -> Result<Self> {
        let topology = Topology::new(mesh, &job.sub_job(0.0, 0.8))?;
        // Degenerate faces come first in the list.
        if let Some(&Defect::DegenerateFace { face, vertex }) = topology.defects().first() {
            return Err(Error::RepeatedCorner { face, vertex });
        }
        let count = mesh.faces().half_edge_count();
        let mut mates = alloc::filled(NONE, count)?;
        for f in 0..mesh.faces().len() {
            job.sub_job(0.8, 1.0).step_within_list(f, STAGE)?;
            for (h, u, v) in half_edges(mesh, f) {
                if let Opposite::Mate(mate) = topology.opposite(h)
                    && (mesh.faces().corner(mate), mesh.faces().corner(mesh.faces().next(mate))) == (v, u)
                {
                    mates[h as usize] = mate;
                }
            }
        }
        Ok(CutSurface { mesh, mates, is_cut: BitSet::new(count)?, cut_edges: Vec::new() })
    }

    /// Returns the half-edge across an edge that is not cut, or [`NONE`].
    pub(super) fn mate_across(&self, h: u32) -> u32 {
        if self.is_cut.contains(h) { NONE } else { self.mates[h as usize] }
    }

    pub(super) fn end_vertices(&self, h: u32) -> [u32; 2] {
        [h, self.mesh.faces().next(h)].map(|h| self.mesh.faces().corner(h))
    }

    /// Cuts along an edge if it separates two faces.
    pub(super) fn cut_edge(&mut self, h: u32, kind: CutKind) -> Result<()> {
        let mate = self.mate_across(h);
        if mate != NONE {
            self.is_cut.insert(h);
            self.is_cut.insert(mate);
            let ends = self.end_vertices(h);
            alloc::push(&mut self.cut_edges, (ends, kind))?;
        }
        Ok(())
    }

    /// Undoes the last cuts, along the half-edges of `path`.
    pub(super) fn undo_cuts(&mut self, path: &[u32]) {
        for &h in path {
            self.is_cut.toggle(h);
            self.is_cut.toggle(self.mates[h as usize]);
        }
        self.cut_edges.truncate(self.cut_edges.len() - path.len());
    }

    /// Cuts along the given paths.
    pub(super) fn cut_paths(&mut self, cuts: &Cuts<'_>, job: &Job<'_>) -> Result<()> {
        if cuts.vertices.is_empty() {
            return Ok(());
        }
        let whole = [0, cuts.vertices.len() as u32];
        let offsets = if cuts.offsets.is_empty() { &whole } else { cuts.offsets };
        Error::check_offsets(offsets, cuts.vertices.len())?;
        let count = self.mesh.positions().len();
        let graph = SurfaceGraph::new(self, count, |h| self.mesh.faces().corner(h), job)?;
        let mut search = PathSearch::new(count)?;
        for (number, ends) in (0..).zip(offsets.windows(2)) {
            let mut path = alloc::copied(&cuts.vertices[ends[0] as usize..ends[1] as usize])?;
            for (place, vertex) in (0..).zip(&mut path) {
                if *vertex as usize >= count {
                    return Err(Error::LoopIndexOutOfRange { number, place, vertex: *vertex, count: count as u32 });
                }
                *vertex = self.mesh.faces().merged_vertex(*vertex);
            }
            for (place, step) in (1..).zip(path.windows(2)) {
                let found = search.search_nearest_target(&graph, &[step[0]], |v| v == step[1], job)?;
                if found.is_none() {
                    let vertex = cuts.vertices[ends[0] as usize + place as usize];
                    return Err(Error::CutNotConnected { cut: number, place, vertex });
                }
                for h in search.path_half_edges(step[1])? {
                    self.cut_edge(h, CutKind::Given)?;
                }
            }
        }
        Ok(())
    }
}

/// A graph of edges between vertices of the surface or of its charts.
pub(super) struct SurfaceGraph {
    /// For each vertex, the other end of each edge, a half-edge of it, and its length.
    edges: Buckets<(u32, u32, f64)>,
}

impl SurfaceGraph {
    /// Creates the graph. `name` returns the vertex at the corner where a half-edge starts. O(H).
    pub(super) fn new(
        surface: &CutSurface<'_, '_>,
        count: usize,
        name: impl Fn(u32) -> u32,
        job: &Job<'_>,
    ) -> Result<SurfaceGraph> {
        let mesh = surface.mesh;
        let edge = |h: u32| {
            let [u, v] = surface.end_vertices(h).map(|v| mesh.positions().get(v));
            (name(h), name(mesh.faces().next(h)), overflow_safe_distance(u, v))
        };
        // An edge with two faces gets one direction from each; any other edge gets both from its
        // face.
        let all = (0..2 * mesh.faces().half_edge_count()).filter_map(|k| {
            let h = (k / 2) as u32;
            let (u, v, length) = edge(h);
            let is_back = k % 2 == 1;
            let is_named = u != NONE && v != NONE && !(is_back && surface.mate_across(h) != NONE);
            is_named.then_some(if is_back { (v as usize, (u, h, length)) } else { (u as usize, (v, h, length)) })
        });
        Ok(SurfaceGraph { edges: Buckets::new_cancellable(count, (0, 0, 0.0), all, job, STAGE)? })
    }

    /// Returns the neighbours of a vertex, each with a half-edge between.
    pub(super) fn neighbours(&self, v: u32) -> &[(u32, u32, f64)] {
        self.edges.get(v as usize)
    }
}

/// A reached vertex. Orders by distance, then by index.
#[derive(PartialEq)]
struct ReachedVertex(f64, u32);

impl Eq for ReachedVertex {}

impl Ord for ReachedVertex {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0).then(self.1.cmp(&other.1))
    }
}

impl PartialOrd for ReachedVertex {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// Shortest paths from a set of vertices (E. Dijkstra, 1959).
pub(super) struct PathSearch {
    /// The distance of each vertex; infinity if it was not reached.
    pub(super) distances: Vec<f64>,
    /// The preceding vertex, and the half-edge from it.
    predecessors: Vec<(u32, u32)>,
    touched: Vec<u32>,
}

impl PathSearch {
    pub(super) fn new(count: usize) -> Result<PathSearch> {
        Ok(PathSearch {
            distances: alloc::filled(f64::INFINITY, count)?,
            predecessors: alloc::filled((NONE, NONE), count)?,
            touched: Vec::new(),
        })
    }

    /// Searches from `sources` to the nearest vertex that satisfies `is_target`, and returns it.
    /// O(E log V) for the nearer part of the graph.
    pub(super) fn search_nearest_target(
        &mut self,
        graph: &SurfaceGraph,
        sources: &[u32],
        is_target: impl Fn(u32) -> bool,
        job: &Job<'_>,
    ) -> Result<Option<u32>> {
        for &v in &self.touched {
            (self.distances[v as usize], self.predecessors[v as usize]) = (f64::INFINITY, (NONE, NONE));
        }
        self.touched.clear();
        let mut heap = BinaryHeap::from(alloc::with_capacity(sources.len())?);
        for &v in sources {
            self.record_reached(v, 0.0, (NONE, NONE))?;
            heap.push(Reverse(ReachedVertex(0.0, v)));
        }
        let mut steps = 0;
        while let Some(Reverse(ReachedVertex(distance, v))) = heap.pop() {
            if distance > self.distances[v as usize] {
                continue;
            }
            if is_target(v) {
                return Ok(Some(v));
            }
            job.step_within_heavy_list(16, steps, STAGE)?;
            steps += 1;
            for &(w, h, length) in graph.neighbours(v) {
                let sum = distance + length;
                if sum < self.distances[w as usize] {
                    self.record_reached(w, sum, (v, h))?;
                    heap.try_reserve(1).map_err(|_| Error::OutOfMemory { bytes: 16 })?;
                    heap.push(Reverse(ReachedVertex(sum, w)));
                }
            }
        }
        Ok(None)
    }

    fn record_reached(&mut self, v: u32, distance: f64, before: (u32, u32)) -> Result<()> {
        if self.distances[v as usize] == f64::INFINITY {
            alloc::push(&mut self.touched, v)?;
        }
        (self.distances[v as usize], self.predecessors[v as usize]) = (distance, before);
        Ok(())
    }

    /// Returns the half-edges of the path to a reached vertex, from its end to its source.
    pub(super) fn path_half_edges(&self, mut v: u32) -> Result<Vec<u32>> {
        let mut path = Vec::new();
        while self.predecessors[v as usize].0 != NONE {
            let (u, h) = self.predecessors[v as usize];
            alloc::push(&mut path, h)?;
            v = u;
        }
        Ok(path)
    }

    /// Returns true if the last search started from `v`, or did not reach it.
    pub(super) fn is_source(&self, v: u32) -> bool {
        self.predecessors[v as usize].0 == NONE
    }

    /// Returns true if the path to `v` ends with half-edge `h`, in either direction.
    pub(super) fn path_ends_with(&self, v: u32, h: u32) -> bool {
        self.predecessors[v as usize].1 == h
    }
}
