//! Origins of the corners of a repaired mesh.

use gusset_base::alloc;
use gusset_base::error::Result;

/// A corner that was inserted on an edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CornerOnEdge {
    /// The corner of the new mesh.
    pub corner: u32,
    /// The old corner at the edge's end. The corner at its start is in [`CornerOrigins::corners`].
    pub end_corner: u32,
    /// The position along the edge, from 0 to 1.
    pub edge_parameter: f64,
}

/// The origin of each corner of a repaired mesh.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CornerOrigins {
    /// For each corner of the new mesh, the old corner; for an inserted corner, the old corner at
    /// the start of its edge.
    pub corners: Vec<u32>,
    /// The corners that were inserted on edges, ascending.
    pub on_edges: Vec<CornerOnEdge>,
}

impl CornerOrigins {
    /// Appends the origin of the next corner.
    pub(crate) fn push(&mut self, origin: CornerOrigin) -> Result<()> {
        if origin.at > 0.0 {
            let corner = self.corners.len() as u32;
            alloc::push(
                &mut self.on_edges,
                CornerOnEdge { corner, end_corner: origin.end, edge_parameter: origin.at },
            )?;
        }
        alloc::push(&mut self.corners, origin.start)
    }

    /// Selects the origins of the corners `left` of an intermediate mesh; `None` keeps all.
    pub(super) fn select_corners(self, left: Option<&[u32]>) -> Result<CornerOrigins> {
        let Some(left) = left else { return Ok(self) };
        let mut all = CornerOrigins { corners: alloc::with_capacity(left.len())?, on_edges: Vec::new() };
        for &corner in left {
            all.push(self.origin_of_corner(corner))?;
        }
        Ok(all)
    }

    /// Replaces old corners by their own origins `left`; `None` keeps them.
    pub(crate) fn composed_with_earlier(mut self, left: Option<&[u32]>) -> CornerOrigins {
        if let Some(left) = left {
            self.corners.iter_mut().for_each(|corner| *corner = left[*corner as usize]);
            self.on_edges.iter_mut().for_each(|on| on.end_corner = left[on.end_corner as usize]);
        }
        self
    }

    /// Returns the origin of a corner. O(log n) for n inserted corners.
    pub(crate) fn origin_of_corner(&self, corner: u32) -> CornerOrigin {
        let start = self.corners[corner as usize];
        match self.on_edges.binary_search_by_key(&corner, |on| on.corner) {
            Ok(k) => CornerOrigin { start, end: self.on_edges[k].end_corner, at: self.on_edges[k].edge_parameter },
            Err(_) => CornerOrigin { start, end: start, at: 0.0 },
        }
    }
}

/// An old corner, or a point on the edge from it to the next corner of its face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CornerOrigin {
    pub(crate) start: u32,
    pub(crate) end: u32,
    pub(crate) at: f64,
}
