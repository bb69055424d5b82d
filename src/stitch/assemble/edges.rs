//! The edges that the mesh has between vertices of its loops: no strip may repeat one.

use crate::alloc;
use crate::error::Result;
use crate::sort::sort_distinct;
use crate::stitch::rim::{Bridges, Rim};
use crate::stitch::strip::Strip;

/// Edges by the rims that they join.
pub(super) struct Edges {
    /// In ascending order.
    pub(super) of: Vec<([u32; 2], (u32, u32))>,
    pub(super) places: Vec<(u32, u32)>,
    /// Of each rim, whether edges between its own vertices count.
    pub(super) slits: Vec<bool>,
}

impl Edges {
    /// Appends an edge for every two rims that its ends are on, and for every slit.
    pub(super) fn enter(&mut self, u: u32, v: u32) -> Result<()> {
        for &(_, r) in loops_of(&self.places, u) {
            for &(_, s) in loops_of(&self.places, v).iter().filter(|&&(_, s)| s != r || self.slits[s as usize]) {
                alloc::push(&mut self.of, ([r, s], (u, v)))?;
                alloc::push(&mut self.of, ([s, r], (v, u)))?;
            }
        }
        Ok(())
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
            if [u, v].iter().all(|&v| loops_of(&self.places, v).len() > 1) {
                self.enter(u, v)?;
            }
        }
        if self.of.len() > before {
            sort_distinct(&mut self.of);
        }
        Ok(())
    }

    /// From a vertex of side A to one of side B, which are of these rims. Side B of a slit lies
    /// between the ends of side A; at the edges there the strip begins and ends.
    pub(super) fn between(&self, rims: [usize; 2], [a, b]: &[Rim; 2]) -> Result<Bridges> {
        let first = |rim: &Rim| rim.vertices[0];
        let last = |rim: &Rim| rim.vertices[rim.vertices.len() - 1];
        let ends = [(first(a), last(b)), (last(a), first(b))];
        let is_slit = rims[0] == rims[1];
        let rims = rims.map(|r| r as u32);
        let from = self.of.partition_point(|&(pair, _)| pair < rims);
        let edges = self.of[from..].iter().take_while(|&&(pair, _)| pair == rims).map(|&(_, edge)| edge);
        Ok(Bridges::of(alloc::gather(edges.filter(|edge| !(is_slit && ends.contains(edge))))?))
    }
}

/// The entries of `vertex` among places in ascending order.
pub(super) fn loops_of(places: &[(u32, u32)], vertex: u32) -> &[(u32, u32)] {
    let from = places.partition_point(|&(v, _)| v < vertex);
    let count = places[from..].partition_point(|&(v, _)| v == vertex);
    &places[from..from + count]
}
