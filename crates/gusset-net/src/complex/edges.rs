//! Edges and vertices at glued nodes: the sides and corners that the pass over the rows collected,
//! grouped by edge and by vertex. O(s log s) for s sides at most.

use super::boundary::FanEnds;
use super::quotient::Complex;
use super::row_scan::{FaceCorner, FaceSide, IrregularElements, SideDirection};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::sort::{sort_by_bucket, sort_distinct};

/// Groups sides of faces to edges, and adds boundary edges to the scan's.
pub(super) fn group_sides_into_edges(scan: &mut IrregularElements<'_>, complex: &mut Complex) -> Result<()> {
    let count = scan.node_count();
    sort_by_bucket(&mut scan.sides, count, |side| side.edge[0])?;
    for sides in scan.sides.chunk_by(|a, b| a.edge == b.edge) {
        complex.edges += 1;
        let [min, max] = sides[0].edge;
        match sides_that_belong_to_faces(sides) {
            [] => alloc::push(&mut complex.wires, [min, max])?,
            [one] if one.sense == SideDirection::Up => alloc::push(&mut scan.rim, [min, max])?,
            [_] => alloc::push(&mut scan.rim, [max, min])?,
            [a, b] if a.sense != b.sense => {}
            [_, _] => alloc::push(&mut complex.conflicts, [min, max])?,
            _ => alloc::push(&mut complex.branches, [min, max])?,
        }
    }
    Ok(())
}

/// Returns the sides of an edge that belong to faces, given all of them in order.
pub(super) fn sides_that_belong_to_faces(sides: &[FaceSide]) -> &[FaceSide] {
    &sides[..sides.partition_point(|side| side.sense != SideDirection::None)]
}

/// Groups the corners at each vertex into fans, sequences of adjacent faces around it. A vertex
/// with several fans is a pinch, and the boundary edges of each fan are added to the scan's.
pub(super) fn group_corners_into_fans(scan: &mut IrregularElements<'_>, complex: &mut Complex) -> Result<()> {
    let count = scan.node_count();
    sort_by_bucket(&mut scan.corners, count, |corner| corner[0])?;
    let mut link = LinkOfVertex::default();
    for corners in scan.corners.chunk_by(|a, b| a[0] == b[0]) {
        if link.count_fans(corners, &mut scan.fan_ends)? > 1 {
            alloc::push(&mut complex.pinches, corners[0][0])?;
        }
    }
    complex.pinches.sort_unstable();
    Ok(())
}

/// The link of a vertex: its points are the edges that meet there, and each face joins two of them.
/// The memory is reused for each vertex.
#[derive(Default)]
struct LinkOfVertex {
    /// The other ends of the edges, in order.
    points: Vec<u32>,
    /// The connected components of these points.
    components: DisjointSets,
    /// The number of faces at each point.
    degrees: Vec<u32>,
    /// The points with one face, each with the root of its component.
    points_with_one_face: Vec<(u32, u32)>,
}

impl LinkOfVertex {
    /// Returns the number of components of the link. Appends the two ends of each open component to
    /// `ends`.
    fn count_fans(&mut self, corners: &[FaceCorner], ends: &mut Vec<FanEnds>) -> Result<usize> {
        self.points.clear();
        alloc::extend(&mut self.points, corners.iter().flat_map(|&[_, before, after]| [before, after]))?;
        sort_distinct(&mut self.points);
        let count = self.points.len();
        alloc::reset(&mut self.degrees, count, 0)?;
        self.components.reset(count)?;
        for &[_, before, after] in corners {
            let [a, b] = [before, after].map(|point| self.points.partition_point(|&other| other < point));
            self.degrees[a] += 1;
            self.degrees[b] += 1;
            self.components.union(a as u32, b as u32);
        }
        self.points_with_one_face.clear();
        for point in 0..count {
            if self.degrees[point] == 1 {
                let root = self.components.find(point as u32);
                alloc::push(&mut self.points_with_one_face, (root, self.points[point]))?;
            }
        }
        self.points_with_one_face.sort_unstable();
        for component in self.points_with_one_face.chunk_by(|a, b| a.0 == b.0) {
            // More than two only where a fan branches; an odd end terminates a chain of the
            // boundary.
            for pair in component.chunks_exact(2) {
                alloc::push(ends, [corners[0][0], pair[0].1, pair[1].1])?;
            }
        }
        Ok(self.components.roots().count())
    }
}
