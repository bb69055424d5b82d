//! What hangs together: disjoint sets of numbered things.

use super::view::MeshView;
use crate::alloc;
use crate::error::Result;

/// A union-find structure; the root of a set is its smallest element, whatever the order of the unions.
pub(crate) struct Sets(Vec<u32>);

impl Sets {
    /// `count` sets of one element each; 4 bytes an element.
    pub(crate) fn new(count: usize) -> Result<Self> {
        Ok(Sets(alloc::collect((0..count).map(|i| i as u32))?))
    }

    /// The smallest element of the set of `i`. Nearly constant time.
    pub(crate) fn root(&mut self, mut i: u32) -> u32 {
        while self.0[i as usize] != i {
            // Path halving.
            let up = self.0[self.0[i as usize] as usize];
            self.0[i as usize] = up;
            i = up;
        }
        i
    }

    /// Makes one set of two.
    pub(crate) fn join(&mut self, i: u32, j: u32) {
        let (i, j) = (self.root(i), self.root(j));
        self.0[i.max(j) as usize] = i.min(j);
    }

    /// The number of sets.
    pub(crate) fn count(&self) -> usize {
        self.0.iter().enumerate().filter(|&(i, &up)| i as u32 == up).count()
    }

    /// Sets of vertices: those of a face are in one.
    pub(crate) fn of_vertices(mesh: &MeshView<'_>) -> Result<Self> {
        let mut sets = Sets::new(mesh.positions().len())?;
        for f in 0..mesh.faces().len() {
            let mut corners = mesh.face(f);
            if let Some(first) = corners.next() {
                corners.for_each(|v| sets.join(first, v));
            }
        }
        Ok(sets)
    }
}
