//! A face with split edges, and its parts.
//!
//! A triangle is cut into fans. The side with the most new vertices is joined to the opposite
//! corner. The first new vertex is joined to the vertices of the side before, and the last one to
//! the side after. No part has three corners on one side, and the number of parts is linear. Larger
//! faces gain corners.

use super::corner_origins::CornerOrigin;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::scale::common_unit;
use gusset_mesh::MeshView;

/// A corner of a face with new vertices: its vertex, and its place on the old face.
pub(crate) type PlacedCorner = (u32, CornerOrigin);

/// A face with new vertices on its edges.
#[derive(Default)]
pub(crate) struct SplitFace {
    /// The old corners and the new ones in cyclic order.
    ring: Vec<PlacedCorner>,
    /// The indices of the old corners in `ring`.
    corners: Vec<usize>,
}

impl SplitFace {
    /// Sets face `f` with vertices on its half-edges. The places are ordered triples of the
    /// half-edge, the position along it, and the vertex.
    pub(crate) fn set_face(
        &mut self,
        mesh: &MeshView<'_>,
        f: usize,
        places: impl Iterator<Item = (u32, f64, u32)>,
    ) -> Result<()> {
        self.ring.clear();
        self.corners.clear();
        let mut places = places.peekable();
        let range = mesh.faces().corner_range(f);
        for h in range.clone() {
            let (start, end) = (h as u32, if h + 1 == range.end { range.start as u32 } else { h as u32 + 1 });
            alloc::push(&mut self.corners, self.ring.len())?;
            alloc::push(&mut self.ring, (mesh.faces().corner(start), CornerOrigin { start, end: start, at: 0.0 }))?;
            while let Some((_, at, v)) = places.next_if(|&(half_edge, ..)| half_edge as usize == h) {
                alloc::push(&mut self.ring, (v, CornerOrigin { start, end, at }))?;
            }
        }
        Ok(())
    }

    /// Calls `emit` with each part.
    pub(crate) fn visit_parts(&self, mut emit: impl FnMut(&[PlacedCorner]) -> Result<()>) -> Result<()> {
        let count = self.ring.len();
        let &[a, b, c] = self.corners.as_slice() else { return emit(&self.ring) };
        // The sides as ranges of the ring, from corner to corner.
        let sides = [[a, b], [b, c], [c, count]];
        let base = (0..3).rev().max_by_key(|&k| sides[k][1] - sides[k][0]).unwrap_or(0);
        let [[first, last], after, before] = [0, 1, 2].map(|k| sides[(base + k) % 3]);
        let at = |place: usize| self.ring[place % count];
        let mut fan = |apex: usize, from: usize, to: usize| {
            (from..to).try_for_each(|place| emit(&[at(apex), at(place), at(place + 1)]))
        };
        if last - first == 1 {
            return fan(before[0], first, last);
        }
        fan(first + 1, before[0], before[1])?;
        fan(before[0], first + 1, last - 1)?;
        fan(last - 1, after[0], after[1])
    }
}

/// Returns true if all parts of a triangle have its orientation; true for larger faces. Old
/// vertices at the new places give the positions.
pub(super) fn has_upright_parts(mesh: &MeshView<'_>, f: usize, split: &SplitFace) -> bool {
    if mesh.faces().corner_range(f).len() != 3 {
        return true;
    }
    let at = |v: u32| mesh.positions().get(v);
    let largest = split.ring.iter().fold(DVec3::ZERO, |largest, &(v, _)| largest.max(at(v).abs()));
    let unit = common_unit(&[largest]);
    let normal = |corners: &[PlacedCorner]| {
        let [p, q, r] = [0, 1, 2].map(|k| at(corners[k].0) / unit);
        (q - p).cross(r - p)
    };
    let [a, b, c] = [0, 1, 2].map(|k| split.ring[split.corners[k]]);
    let whole = normal(&[a, b, c]);
    let mut upright = true;
    let outcome = split.visit_parts(|part| {
        upright &= normal(part).dot(whole) > 0.0;
        Ok(())
    });
    outcome.is_ok() && upright
}
