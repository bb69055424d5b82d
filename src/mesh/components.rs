//! Which faces hang together.

use super::view::MeshView;
use crate::alloc;
use crate::error::Result;

/// A union-find structure over vertices; the vertices of a face are in one set.
pub(crate) struct Components(Vec<u32>);

impl Components {
    /// Nearly linear in the number of corners; extra memory 4 bytes a vertex.
    pub(crate) fn of(mesh: &MeshView<'_>) -> Result<Self> {
        let mut sets = Components(alloc::collect((0..mesh.positions().len()).map(|v| v as u32))?);
        for f in 0..mesh.faces().len() {
            let mut corners = mesh.face(f);
            let Some(first) = corners.next() else {
                continue;
            };
            let mut root = sets.root(first);
            for v in corners {
                let other = sets.root(v);
                // The smaller index becomes the root: the same sets and roots for any order of the faces.
                let (low, high) = (root.min(other), root.max(other));
                sets.0[high as usize] = low;
                root = low;
            }
        }
        Ok(sets)
    }

    /// The smallest vertex of the set of `v`.
    pub(crate) fn root(&mut self, mut v: u32) -> u32 {
        while self.0[v as usize] != v {
            // Path halving.
            let up = self.0[self.0[v as usize] as usize];
            self.0[v as usize] = up;
            v = up;
        }
        v
    }
}
