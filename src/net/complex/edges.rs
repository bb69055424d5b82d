//! Edges and vertices where nodes are glued: what the pass over the rows has left to be brought together.

use super::scan::{Corner, FanEnds, Scan, Sense, Side};
use super::{Complex, group};
use crate::alloc;
use crate::error::Result;

/// Brings the sides of faces together to edges; their boundary is added to the scan's. A sort of the sides.
pub(super) fn edges(scan: &mut Scan<'_>, complex: &mut Complex) -> Result<()> {
    let count = scan.node_count();
    group::sort(&mut scan.sides, count, |side| side.edge[0])?;
    for sides in scan.sides.chunk_by(|a, b| a.edge == b.edge) {
        complex.edges += 1;
        let [least, greatest] = sides[0].edge;
        match faces(sides) {
            [] => alloc::push(&mut complex.wires, [least, greatest])?,
            [one] if one.sense == Sense::Up => alloc::push(&mut scan.rim, [least, greatest])?,
            [_] => alloc::push(&mut scan.rim, [greatest, least])?,
            [a, b] if a.sense != b.sense => {}
            [_, _] => alloc::push(&mut complex.conflicts, [least, greatest])?,
            _ => alloc::push(&mut complex.branches, [least, greatest])?,
        }
    }
    Ok(())
}

/// Those of the sides of an edge, which are in order, that belong to faces.
pub(super) fn faces(sides: &[Side]) -> &[Side] {
    &sides[..sides.partition_point(|side| side.sense != Sense::None)]
}

/// Brings the corners at each vertex together to fans: faces one after the other round it. More than one of them is a
/// pinch; the boundary edges of each are added to the scan's. A sort of the corners.
pub(super) fn fans(scan: &mut Scan<'_>, complex: &mut Complex) -> Result<()> {
    let count = scan.node_count();
    group::sort(&mut scan.corners, count, |corner| corner[0])?;
    let mut link = Link::default();
    for corners in scan.corners.chunk_by(|a, b| a[0] == b[0]) {
        if link.fans(corners, &mut scan.fan_ends)? > 1 {
            alloc::push(&mut complex.pinches, corners[0][0])?;
        }
    }
    complex.pinches.sort_unstable();
    Ok(())
}

/// The link of a vertex: the edges that meet there are its points, and each face joins two of them. The space is used
/// again for each vertex.
#[derive(Default)]
struct Link {
    /// The other ends of the edges, in order.
    points: Vec<u32>,
    /// Of each, one that it is joined to, or itself.
    parents: Vec<usize>,
    /// The number of faces of each.
    degrees: Vec<u32>,
    /// The points with one face, with the root of what they belong to.
    ends: Vec<(usize, u32)>,
}

impl Link {
    /// The number of pieces of the link; the two ends of each that has some are given to `ends`.
    fn fans(&mut self, corners: &[Corner], ends: &mut Vec<FanEnds>) -> Result<usize> {
        refill(&mut self.points, corners.iter().flat_map(|&[_, before, after]| [before, after]), 2 * corners.len())?;
        self.points.sort_unstable();
        self.points.dedup();
        let count = self.points.len();
        refill(&mut self.degrees, std::iter::repeat_n(0, count), count)?;
        refill(&mut self.parents, 0..count, count)?;
        for &[_, before, after] in corners {
            let [a, b] = [before, after].map(|point| self.points.partition_point(|&other| other < point));
            self.degrees[a] += 1;
            self.degrees[b] += 1;
            let (a, b) = (self.root(a), self.root(b));
            self.parents[a.max(b)] = a.min(b);
        }
        self.ends.clear();
        for point in 0..count {
            if self.degrees[point] == 1 {
                let root = self.root(point);
                alloc::push(&mut self.ends, (root, self.points[point]))?;
            }
        }
        self.ends.sort_unstable();
        for piece in self.ends.chunk_by(|a, b| a.0 == b.0) {
            // More than two only where a fan branches; what is left over ends a chain of the boundary.
            for pair in piece.chunks_exact(2) {
                alloc::push(ends, [corners[0][0], pair[0].1, pair[1].1])?;
            }
        }
        Ok((0..count).filter(|&point| self.parents[point] == point).count())
    }

    fn root(&mut self, mut point: usize) -> usize {
        while self.parents[point] != point {
            self.parents[point] = self.parents[self.parents[point]];
            point = self.parents[point];
        }
        point
    }
}

/// `count` new items in place of the old ones.
fn refill<T>(list: &mut Vec<T>, items: impl Iterator<Item = T>, count: usize) -> Result<()> {
    list.clear();
    alloc::reserve(list, count)?;
    list.extend(items);
    Ok(())
}
