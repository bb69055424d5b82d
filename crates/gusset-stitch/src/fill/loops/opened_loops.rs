//! Loops cut open along bridges into one polygon.
//!
//! A bridge is a chord between two loops. A surface of genus 0 that k loops bound has k - 1 bridges
//! that join the loops into a tree. Cut open along them it is a disc. The polygon around the disc
//! passes each bridge twice, once in each direction. It passes a vertex once, and once more for
//! each bridge that ends there. The triangulations of the polygon are the triangulations of the
//! surface with these bridges, except those that repeat an edge between different copies of its
//! ends.

use super::super::triangulation_cost::Polygon;
use super::numbered_rims::NumberedRims;
use crate::remesh::PatchMesh;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use std::ops::Range;

/// A polygon through the vertices of several loops.
pub(super) struct OpenedLoops {
    /// The vertex at each place.
    pub(super) vertex_at_place: Vec<u32>,
    /// True for places whose edge to the next place is a bridge.
    pub(super) is_bridge: Vec<bool>,
}

impl OpenedLoops {
    /// Creates the polygon of one loop with these vertices.
    pub(super) fn from_loop(range: Range<u32>) -> Result<OpenedLoops> {
        let bridges = alloc::filled(false, range.len())?;
        Ok(OpenedLoops { vertex_at_place: alloc::collect(range)?, is_bridge: bridges })
    }

    /// Adds the loop with the vertices `range` by a bridge from a place to its vertex `v`. The
    /// bridge becomes the last edge.
    pub(super) fn extended_by_loop(&self, place: usize, range: Range<u32>, v: u32) -> Result<OpenedLoops> {
        let n = self.vertex_at_place.len() + range.len() + 2;
        let (mut order, mut bridges) = (alloc::with_capacity(n)?, alloc::with_capacity(n)?);
        order.extend((v..range.end).chain(range.start..=v));
        bridges.extend(range.map(|_| false).chain([true]));
        order.extend(&self.vertex_at_place[place..]);
        bridges.extend(&self.is_bridge[place..]);
        order.extend(&self.vertex_at_place[..=place]);
        bridges.extend(self.is_bridge[..place].iter().chain(&[true]));
        Ok(OpenedLoops { vertex_at_place: order, is_bridge: bridges })
    }

    pub(super) fn len(&self) -> usize {
        self.vertex_at_place.len()
    }

    pub(super) fn build_polygon(&self, rims: &NumberedRims) -> Result<Polygon> {
        let at = |of: &[DVec3]| alloc::collect(self.vertex_at_place.iter().map(|&v| of[v as usize]));
        // The surface across a bridge is not known yet.
        let across = self.vertex_at_place.iter().zip(&self.is_bridge);
        let across = across
            .map(|(&v, &bridge)| if bridge { DVec3::ZERO } else { rims.all_vertices.normals_across_edges[v as usize] });
        Ok(Polygon::new(at(&rims.all_vertices.points)?, alloc::collect(across)?, at(&rims.all_vertices.normals)?))
    }

    /// Returns the ends of each bridge, the smaller first, and the two places where the polygon
    /// passes it.
    pub(super) fn bridge_tree(&self) -> Result<Vec<([u32; 2], [usize; 2])>> {
        let n = self.len();
        let passes = (0..n).filter(|&p| self.is_bridge[p]).map(|p| {
            let (u, v) = (self.vertex_at_place[p], self.vertex_at_place[(p + 1) % n]);
            ([u.min(v), u.max(v)], p)
        });
        let mut passes = alloc::gather(passes)?;
        passes.sort_unstable();
        alloc::gather(passes.chunks_exact(2).map(|pair| (pair[0].0, [pair[0].1, pair[1].1])))
    }

    /// Converts triangles of places to triangles of vertices.
    pub(super) fn places_to_vertices(&self, triangles: &[[u32; 3]]) -> Result<Vec<[u32; 3]>> {
        alloc::collect(triangles.iter().map(|triangle| triangle.map(|place| self.vertex_at_place[place as usize])))
    }

    /// Returns the polygon of finer loops with the same bridges, and the new place of each old
    /// place. `kept` lists the vertices of these loops in the finer loops.
    pub(super) fn refined_loops(&self, rims: &NumberedRims, kept: &[u32]) -> Result<(OpenedLoops, Vec<u32>)> {
        let mut finer = OpenedLoops { vertex_at_place: Vec::new(), is_bridge: Vec::new() };
        let mut places = alloc::with_capacity(self.len())?;
        for p in 0..self.len() {
            let [v, end] = [p, (p + 1) % self.len()].map(|p| kept[self.vertex_at_place[p] as usize]);
            places.push(finer.len() as u32);
            alloc::push(&mut finer.vertex_at_place, v)?;
            alloc::push(&mut finer.is_bridge, self.is_bridge[p])?;
            let mut between = if self.is_bridge[p] { end } else { rims.next_vertex(v) };
            while between != end {
                alloc::push(&mut finer.vertex_at_place, between)?;
                alloc::push(&mut finer.is_bridge, false)?;
                between = rims.next_vertex(between);
            }
        }
        Ok((finer, places))
    }

    /// Returns pairs of chords with equal ends in a triangulation of the polygon, ascending. The
    /// triangles are (i, m, k) of places, i < m < k.
    pub(super) fn repeated_chords(&self, triangles: &[[u32; 3]], is_copied: &[bool]) -> Result<Vec<[[u32; 2]; 2]>> {
        let chords = triangles.iter().map(|&[i, _, k]| {
            let [u, v] = [i, k].map(|place| self.vertex_at_place[place as usize]);
            ([u.min(v), u.max(v)], [i, k])
        });
        let mut chords = alloc::gather(chords.filter(|([u, v], _)| is_copied[*u as usize] || is_copied[*v as usize]))?;
        chords.sort_unstable();
        let pairs = chords.windows(2).filter(|pair| pair[0].0 == pair[1].0);
        alloc::gather(pairs.map(|pair| [pair[0].1, pair[1].1]))
    }
}

/// Cuts the surface of `triangles` open along a tree of its sides. The triangles index the vertices
/// of all loops, and are returned as ascending places. Returns `None` if the result is not a disc.
///
/// O(n log n).
pub(super) fn cut_open_along_tree(
    rims: &NumberedRims,
    triangles: &[[u32; 3]],
    tree: &[[u32; 2]],
) -> Result<Option<(OpenedLoops, Vec<[u32; 3]>)>> {
    let mut tree = alloc::copied(tree)?;
    tree.sort_unstable();
    let is_bridge = |u: u32, v: u32| tree.binary_search(&[u.min(v), u.max(v)]).is_ok();
    let mesh = PatchMesh::new(Vec::new(), alloc::copied(triangles)?)?;
    let side = |t: usize, k: usize| [mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]];
    let mut all = (0..triangles.len()).flat_map(|t| (0..3).map(move |k| (t, k)));
    let Some(first) = all.find(|&(t, k)| tree.first().is_some_and(|bridge| side(t, k) == *bridge)) else {
        return Ok(None);
    };
    let n = rims.vertex_count() + 2 * tree.len();
    let (mut order, mut bridges) = (alloc::with_capacity(n)?, alloc::with_capacity(n)?);
    let mut places = alloc::filled([u32::MAX; 3], triangles.len())?;
    let (mut t, mut k) = first;
    while order.len() < n {
        // Rotate around the end of the side, from triangle to triangle, to the next side of the
        // polygon.
        let place = order.len() as u32;
        k = (k + 1) % 3;
        let [v, mut end] = side(t, k);
        while rims.next_vertex(v) != end && !is_bridge(v, end) {
            let Some((s, j)) = mesh.triangle_across(t, k).filter(|_| places[t][k] == u32::MAX) else {
                return Ok(None);
            };
            places[t][k] = place;
            (t, k) = (s, (j + 1) % 3);
            end = side(t, k)[1];
        }
        places[t][k] = place;
        order.push(v);
        bridges.push(rims.next_vertex(v) != end);
    }
    if (t, k) != first || places.as_flattened().contains(&u32::MAX) {
        return Ok(None);
    }
    places.iter_mut().for_each(|triangle| triangle.sort_unstable());
    Ok(Some((OpenedLoops { vertex_at_place: order, is_bridge: bridges }, places)))
}
