//! What the elements of an assembly were made of.

use crate::repair::corner_origins::CornerOrigins;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_mesh::MeshView;

/// What the elements of an assembly were made of, as far as its maps do not say.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct History {
    /// The number of corners of each piece.
    pub corner_counts: Vec<usize>,
    /// Per face of the pieces in the result, the old one, counted through all pieces; `None` if all
    /// are left.
    pub face_origin: Option<Vec<u32>>,
    /// Per corner of these faces, the old one, as they ran in their pieces, counted through all
    /// pieces; `None` if all are left.
    pub corner_origins: Option<CornerOrigins>,
    /// Of each vertex that no piece had, and these come last, three vertices of the result before
    /// it that it lies between: ends of an edge of a piece on which it is, the second one twice;
    /// vertices of the rims of its strip or patch.
    pub parents: Vec<[u32; 3]>,
    /// How much each has of its parents; at least 0, with sum 1.
    pub weights: Vec<[f64; 3]>,
}

impl History {
    /// Of pieces side by side.
    pub(super) fn of(pieces: &[MeshView<'_>]) -> Result<Self> {
        let corner_counts = alloc::collect(pieces.iter().map(|piece| piece.faces().half_edge_count()))?;
        Ok(History { corner_counts, ..History::default() })
    }

    /// Makes this, the history of what trimming left, one of the pieces. `faces`, `corners`: what
    /// those that are left were.
    pub(super) fn before_trimming(&mut self, faces: Vec<u32>, corners: Vec<u32>) {
        match &mut self.face_origin {
            Some(origin) => origin.iter_mut().for_each(|f| *f = faces[*f as usize]),
            None => self.face_origin = Some(faces),
        }
        self.corner_origins = Some(match self.corner_origins.take() {
            Some(origins) => origins.after(Some(&corners)),
            None => CornerOrigins { corners, on_edges: Vec::new() },
        });
    }

    /// Adds vertices.
    pub(super) fn enter(&mut self, new: impl ExactSizeIterator<Item = ([u32; 3], [f64; 3])>) -> Result<()> {
        for (parents, weights) in new {
            alloc::push(&mut self.parents, parents)?;
            alloc::push(&mut self.weights, weights)?;
        }
        Ok(())
    }
}
