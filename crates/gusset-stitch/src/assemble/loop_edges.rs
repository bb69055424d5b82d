//! The mesh's edges between vertices of its loops, which no strip may repeat.

use crate::stitch::existing_edges::ExistingEdges;
use crate::stitch::stitch_rim::Rim;
use crate::stitch::strip::Strip;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::sort::sort_distinct;
use gusset_mesh::Mesh;

/// Edges between vertices of loops, each listed from both ends. The rims of an edge are looked up
/// on demand: an edge between two vertices of many loops would join each pair of them.
pub(super) struct LoopEdges {
    /// The edges, in ascending order.
    pub(super) edges: Vec<(u32, u32)>,
    /// Pairs of a vertex and a loop through it, in ascending order.
    pub(super) vertex_loop_pairs: Vec<(u32, u32)>,
}

impl LoopEdges {
    /// Collects the edges of `mesh` between the vertices of `vertex_loop_pairs`, which are ascending.
    pub(super) fn new(mesh: &Mesh, vertex_loop_pairs: Vec<(u32, u32)>) -> Result<Self> {
        let mut on_rim = alloc::filled(false, mesh.positions.len())?;
        vertex_loop_pairs.iter().for_each(|&(v, _)| on_rim[v as usize] = true);
        let mut edges = LoopEdges { edges: Vec::new(), vertex_loop_pairs };
        for face in mesh.faces() {
            for (k, &u) in face.iter().enumerate() {
                let v = face[(k + 1) % face.len()];
                if on_rim[u as usize] && on_rim[v as usize] {
                    edges.add_edge(u, v)?;
                }
            }
        }
        sort_distinct(&mut edges.edges);
        Ok(edges)
    }

    /// Appends an edge from both ends.
    pub(super) fn add_edge(&mut self, u: u32, v: u32) -> Result<()> {
        alloc::extend(&mut self.edges, [(u, v), (v, u)])
    }

    /// Adds the edges of a strip between vertices of its rims: where loops touch, another strip
    /// could repeat them.
    pub(super) fn add_strip_edges(&mut self, strip: &Strip) -> Result<()> {
        let before = self.edges.len();
        let rims = strip.rim_count();
        let name = |k: u32| match (k as usize).checked_sub(strip.a.vertices.len()) {
            Some(k) => strip.b.vertices[k],
            None => strip.a.vertices[k as usize],
        };
        let sides = strip.faces.iter().flat_map(|face| face.iter().zip(face.iter().cycle().skip(1)));
        for (&k, &j) in sides.filter(|&(&k, &j)| (k.max(j) as usize) < rims) {
            let [u, v] = [name(k), name(j)];
            if [u, v].iter().all(|&v| entries_of_vertex(&self.vertex_loop_pairs, v).len() > 1) {
                self.add_edge(u, v)?;
            }
        }
        if self.edges.len() > before {
            sort_distinct(&mut self.edges);
        }
        Ok(())
    }

    /// Returns the edges from a vertex of side A to a vertex of side B, on the given rims.
    ///
    /// Side B of a slit lies between the ends of side A, and the edges at these ends bound the
    /// strip. O(log edges) per vertex of side A and per edge there, or per vertex of side B if
    /// those are fewer.
    pub(super) fn existing_edges_between(&self, rims: [usize; 2], [a, b]: &[Rim; 2]) -> Result<ExistingEdges> {
        let first = |rim: &Rim| rim.vertices[0];
        let last = |rim: &Rim| rim.vertices[rim.vertices.len() - 1];
        let ends = [(first(a), last(b)), (last(a), first(b))];
        let is_slit = rims[0] == rims[1];
        let other = rims[1] as u32;
        let mut edges = Vec::new();
        for &u in &a.vertices {
            let from_u = entries_of_vertex(&self.edges, u);
            if from_u.len() <= b.vertices.len() {
                let on_other = |v: u32| self.vertex_loop_pairs.binary_search(&(v, other)).is_ok();
                alloc::extend(&mut edges, from_u.iter().copied().filter(|&(_, v)| on_other(v)))?;
            } else {
                let is_edge = |v: u32| from_u.binary_search(&(u, v)).is_ok();
                alloc::extend(&mut edges, b.vertices.iter().filter(|&&v| is_edge(v)).map(|&v| (u, v)))?;
            }
        }
        edges.retain(|edge| !(is_slit && ends.contains(edge)));
        sort_distinct(&mut edges);
        Ok(ExistingEdges::from_edges(edges))
    }
}

/// Returns the entries of `vertex` in an ascending list of places or edges.
pub(super) fn entries_of_vertex(entries: &[(u32, u32)], vertex: u32) -> &[(u32, u32)] {
    let from = entries.partition_point(|&(v, _)| v < vertex);
    let count = entries[from..].partition_point(|&(v, _)| v == vertex);
    &entries[from..from + count]
}
