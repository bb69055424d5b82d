//! Loops cut open along bridges: one polygon.
//!
//! A bridge is a chord between two loops. A surface of genus 0 that k loops bound has bridges that
//! join them to a tree, k - 1 in number; cut open along them it is a disc, round which a polygon
//! runs that passes each bridge twice, once each way, and the end of a bridge once more for each
//! that ends there. Its triangulations are those of the surface that have these bridges, but for
//! those that have an edge twice, between other copies of its ends.

use super::super::weigh::Polygon;
use super::numbered_rims::Rims;
use crate::remesh::PatchMesh;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use std::ops::Range;

/// A polygon of the vertices of several loops.
pub(super) struct Opened {
    /// The vertex at each place.
    pub(super) order: Vec<u32>,
    /// True of the places whose edge to the next one is a bridge.
    pub(super) bridges: Vec<bool>,
}

impl Opened {
    /// One loop, of these vertices.
    pub(super) fn loop_of(range: Range<u32>) -> Result<Opened> {
        let bridges = alloc::filled(false, range.len())?;
        Ok(Opened { order: alloc::collect(range)?, bridges })
    }

    /// With a bridge from a place to a vertex of another loop, of vertices `range`. It is the
    /// last edge.
    pub(super) fn joined(&self, place: usize, range: Range<u32>, v: u32) -> Result<Opened> {
        let n = self.order.len() + range.len() + 2;
        let (mut order, mut bridges) = (alloc::with_capacity(n)?, alloc::with_capacity(n)?);
        order.extend((v..range.end).chain(range.start..=v));
        bridges.extend(range.map(|_| false).chain([true]));
        order.extend(&self.order[place..]);
        bridges.extend(&self.bridges[place..]);
        order.extend(&self.order[..=place]);
        bridges.extend(self.bridges[..place].iter().chain(&[true]));
        Ok(Opened { order, bridges })
    }

    pub(super) fn len(&self) -> usize {
        self.order.len()
    }

    pub(super) fn polygon(&self, rims: &Rims) -> Result<Polygon> {
        let at = |of: &[DVec3]| alloc::collect(self.order.iter().map(|&v| of[v as usize]));
        // What lies across a bridge is not known yet.
        let across = self.order.iter().zip(&self.bridges);
        let across = across.map(|(&v, &bridge)| if bridge { DVec3::ZERO } else { rims.all.across[v as usize] });
        Ok(Polygon::new(at(&rims.all.points)?, alloc::collect(across)?, at(&rims.all.normals)?))
    }

    /// The bridges: their ends, the smaller first, and the two places where the polygon passes
    /// them.
    pub(super) fn tree(&self) -> Result<Vec<([u32; 2], [usize; 2])>> {
        let n = self.len();
        let passes = (0..n).filter(|&p| self.bridges[p]).map(|p| {
            let (u, v) = (self.order[p], self.order[(p + 1) % n]);
            ([u.min(v), u.max(v)], p)
        });
        let mut passes = alloc::gather(passes)?;
        passes.sort_unstable();
        alloc::gather(passes.chunks_exact(2).map(|pair| (pair[0].0, [pair[0].1, pair[1].1])))
    }

    /// Triangles of places as such of vertices.
    pub(super) fn named(&self, triangles: &[[u32; 3]]) -> Result<Vec<[u32; 3]>> {
        alloc::collect(triangles.iter().map(|triangle| triangle.map(|place| self.order[place as usize])))
    }

    /// The polygon of finer loops with the same bridges, `kept` being the vertices of these loops
    /// there; and of each place where it is then.
    pub(super) fn finer(&self, rims: &Rims, kept: &[u32]) -> Result<(Opened, Vec<u32>)> {
        let mut finer = Opened { order: Vec::new(), bridges: Vec::new() };
        let mut places = alloc::with_capacity(self.len())?;
        for p in 0..self.len() {
            let [v, end] = [p, (p + 1) % self.len()].map(|p| kept[self.order[p] as usize]);
            places.push(finer.len() as u32);
            alloc::push(&mut finer.order, v)?;
            alloc::push(&mut finer.bridges, self.bridges[p])?;
            let mut between = if self.bridges[p] { end } else { rims.next(v) };
            while between != end {
                alloc::push(&mut finer.order, between)?;
                alloc::push(&mut finer.bridges, false)?;
                between = rims.next(between);
            }
        }
        Ok((finer, places))
    }

    /// Pairs of chords of a triangulation of the polygon that have the same ends, ascending.
    /// Triangles (i, m, k) of places, i < m < k.
    pub(super) fn repeated(&self, triangles: &[[u32; 3]], is_copied: &[bool]) -> Result<Vec<[[u32; 2]; 2]>> {
        let chords = triangles.iter().map(|&[i, _, k]| {
            let [u, v] = [i, k].map(|place| self.order[place as usize]);
            ([u.min(v), u.max(v)], [i, k])
        });
        let mut chords = alloc::gather(chords.filter(|([u, v], _)| is_copied[*u as usize] || is_copied[*v as usize]))?;
        chords.sort_unstable();
        let pairs = chords.windows(2).filter(|pair| pair[0].0 == pair[1].0);
        alloc::gather(pairs.map(|pair| [pair[0].1, pair[1].1]))
    }
}

/// The surface of `triangles` over the vertices of all loops, cut open along a tree of its sides;
/// the triangles come as places, ascending. `None` if that makes no disc.
///
/// O(n log n).
pub(super) fn cut_open(
    rims: &Rims,
    triangles: &[[u32; 3]],
    tree: &[[u32; 2]],
) -> Result<Option<(Opened, Vec<[u32; 3]>)>> {
    let mut tree = alloc::copied(tree)?;
    tree.sort_unstable();
    let is_bridge = |u: u32, v: u32| tree.binary_search(&[u.min(v), u.max(v)]).is_ok();
    let mesh = PatchMesh::new(Vec::new(), alloc::copied(triangles)?)?;
    let side = |t: usize, k: usize| [mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]];
    let mut all = (0..triangles.len()).flat_map(|t| (0..3).map(move |k| (t, k)));
    let Some(first) = all.find(|&(t, k)| tree.first().is_some_and(|bridge| side(t, k) == *bridge)) else {
        return Ok(None);
    };
    let n = rims.count() + 2 * tree.len();
    let (mut order, mut bridges) = (alloc::with_capacity(n)?, alloc::with_capacity(n)?);
    let mut places = alloc::filled([u32::MAX; 3], triangles.len())?;
    let (mut t, mut k) = first;
    while order.len() < n {
        // Round the end of the side, from triangle to triangle, to the next side of the polygon.
        let place = order.len() as u32;
        k = (k + 1) % 3;
        let [v, mut end] = side(t, k);
        while rims.next(v) != end && !is_bridge(v, end) {
            let Some((s, j)) = mesh.beyond(t, k).filter(|_| places[t][k] == u32::MAX) else {
                return Ok(None);
            };
            places[t][k] = place;
            (t, k) = (s, (j + 1) % 3);
            end = side(t, k)[1];
        }
        places[t][k] = place;
        order.push(v);
        bridges.push(rims.next(v) != end);
    }
    if (t, k) != first || places.as_flattened().contains(&u32::MAX) {
        return Ok(None);
    }
    places.iter_mut().for_each(|triangle| triangle.sort_unstable());
    Ok(Some((Opened { order, bridges }, places)))
}
