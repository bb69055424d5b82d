//! The origins of an assembly's elements.

use crate::repair::corner_origins::CornerOrigins;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_mesh::MeshView;

/// The origins of an assembly's elements, as far as its maps do not give them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct History {
    /// The number of corners of each piece.
    pub corner_counts: Vec<usize>,
    /// For each face of the pieces in the result, its original face, counted through all pieces;
    /// `None` if all faces remain.
    pub face_origin: Option<Vec<u32>>,
    /// For each corner of these faces in their original orientation, its original corner, counted
    /// through all pieces; `None` if all corners remain.
    pub corner_origins: Option<CornerOrigins>,
    /// Three parents of each vertex that is not from a piece; these vertices come last. The parents
    /// are earlier vertices of the result. For a split edge of a piece, they are its ends, the
    /// second one twice. Otherwise they are rim vertices of the strip or patch.
    pub parents: Vec<[u32; 3]>,
    /// The weight of each parent, at least 0, with sum 1.
    pub weights: Vec<[f64; 3]>,
}

impl History {
    /// Creates the history of pieces side by side.
    pub(super) fn new(pieces: &[MeshView<'_>]) -> Result<Self> {
        let corner_counts = alloc::collect(pieces.iter().map(|piece| piece.faces().half_edge_count()))?;
        Ok(History { corner_counts, ..History::default() })
    }

    /// Composes this history with the trimming before it. `faces` and `corners` are the origins of
    /// the elements that trimming kept.
    pub(super) fn compose_with_trimming(&mut self, faces: Vec<u32>, corners: Vec<u32>) {
        match &mut self.face_origin {
            Some(origin) => origin.iter_mut().for_each(|f| *f = faces[*f as usize]),
            None => self.face_origin = Some(faces),
        }
        self.corner_origins = Some(match self.corner_origins.take() {
            Some(origins) => origins.composed_with_earlier(Some(&corners)),
            None => CornerOrigins { corners, on_edges: Vec::new() },
        });
    }

    /// Adds the parents of new vertices.
    pub(super) fn add_parents(&mut self, new: impl ExactSizeIterator<Item = ([u32; 3], [f64; 3])>) -> Result<()> {
        for (parents, weights) in new {
            alloc::push(&mut self.parents, parents)?;
            alloc::push(&mut self.weights, weights)?;
        }
        Ok(())
    }
}
