//! The edges that the mesh has between vertices of its loops: no strip may repeat one.

use crate::stitch::stitch_rim::{Bridges, Rim};
use crate::stitch::strip::Strip;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::sort::sort_distinct;

/// Edges between vertices of loops, each once from either end: which rims they join is asked for
/// the rims of a strip, as an edge between two vertices of many loops joins each of the one with
/// each of the other.
pub(super) struct Edges {
    /// In ascending order.
    pub(super) of: Vec<(u32, u32)>,
    /// Each vertex on a loop with the loop, in ascending order.
    pub(super) places: Vec<(u32, u32)>,
}

impl Edges {
    /// Appends an edge, from either end.
    pub(super) fn enter(&mut self, u: u32, v: u32) -> Result<()> {
        alloc::extend(&mut self.of, [(u, v), (v, u)])
    }

    /// Takes note of the edges of a strip between vertices of its rims: where loops touch, another
    /// strip could use one again.
    pub(super) fn enter_strip(&mut self, strip: &Strip) -> Result<()> {
        let before = self.of.len();
        let rims = strip.rim_count();
        let name = |k: u32| match (k as usize).checked_sub(strip.a.vertices.len()) {
            Some(k) => strip.b.vertices[k],
            None => strip.a.vertices[k as usize],
        };
        let sides = strip.faces.iter().flat_map(|face| face.iter().zip(face.iter().cycle().skip(1)));
        for (&k, &j) in sides.filter(|&(&k, &j)| (k.max(j) as usize) < rims) {
            let [u, v] = [name(k), name(j)];
            if [u, v].iter().all(|&v| entries_of(&self.places, v).len() > 1) {
                self.enter(u, v)?;
            }
        }
        if self.of.len() > before {
            sort_distinct(&mut self.of);
        }
        Ok(())
    }

    /// From a vertex of side A to one of side B, which are of these rims. Side B of a slit lies
    /// between the ends of side A; at the edges there the strip begins and ends. O(log edges) for
    /// each vertex of side A and each edge there, or each vertex of side B if those are fewer.
    pub(super) fn between(&self, rims: [usize; 2], [a, b]: &[Rim; 2]) -> Result<Bridges> {
        let first = |rim: &Rim| rim.vertices[0];
        let last = |rim: &Rim| rim.vertices[rim.vertices.len() - 1];
        let ends = [(first(a), last(b)), (last(a), first(b))];
        let is_slit = rims[0] == rims[1];
        let other = rims[1] as u32;
        let mut edges = Vec::new();
        for &u in &a.vertices {
            let from_u = entries_of(&self.of, u);
            if from_u.len() <= b.vertices.len() {
                let on_other = |v: u32| self.places.binary_search(&(v, other)).is_ok();
                alloc::extend(&mut edges, from_u.iter().copied().filter(|&(_, v)| on_other(v)))?;
            } else {
                let is_edge = |v: u32| from_u.binary_search(&(u, v)).is_ok();
                alloc::extend(&mut edges, b.vertices.iter().filter(|&&v| is_edge(v)).map(|&v| (u, v)))?;
            }
        }
        edges.retain(|edge| !(is_slit && ends.contains(edge)));
        sort_distinct(&mut edges);
        Ok(Bridges::from_edges(edges))
    }
}

/// The entries of `vertex` among places or edges in ascending order.
pub(super) fn entries_of(entries: &[(u32, u32)], vertex: u32) -> &[(u32, u32)] {
    let from = entries.partition_point(|&(v, _)| v < vertex);
    let count = entries[from..].partition_point(|&(v, _)| v == vertex);
    &entries[from..from + count]
}
