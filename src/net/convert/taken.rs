//! Edges that a mesh has already: a diagonal that were one of them would make an edge of four faces.

use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use crate::net::Shape;
use std::collections::HashSet;

/// The edges of classes of which one end at least is several nodes: between two nodes that are by themselves there is no second edge.
pub(super) struct Taken {
    /// By class: whether it is several nodes.
    is_glued: Vec<bool>,
    /// Those of the net's links, in order.
    links: Vec<[u32; 2]>,
    /// Those of the diagonals that were chosen.
    diagonals: HashSet<[u32; 2]>,
}

impl Taken {
    /// The edges of the links. O(nodes), and a sort of the edges.
    pub(super) fn new(shape: Shape, classes: &[u32], job: &Job<'_>, stage: &'static str) -> Result<Self> {
        let mut is_glued = alloc::filled(false, classes.len())?;
        job.part(0.0, 0.3).ranges(stage, classes.len(), |range| {
            for node in range.filter(|&node| node != classes[node] as usize) {
                (is_glued[node], is_glued[classes[node] as usize]) = (true, true);
            }
            Ok(())
        })?;
        let mut links = Vec::new();
        job.part(0.3, 1.0).ranges(stage, 2 * classes.len(), |range| {
            for link in range.map(|link| link as u32).filter(|&link| shape.is_inner(link)) {
                let ends = shape.ends(link);
                if ends.iter().any(|&node| is_glued[node as usize]) {
                    alloc::push(&mut links, edge(ends.map(|node| classes[node as usize])))?;
                }
            }
            Ok(())
        })?;
        links.sort_unstable();
        links.dedup();
        Ok(Taken { is_glued, links, diagonals: HashSet::new() })
    }

    /// True if there is such an edge between two classes.
    pub(super) fn has(&self, ends: [u32; 2]) -> bool {
        self.matters(ends) && (self.links.binary_search(&edge(ends)).is_ok() || self.diagonals.contains(&edge(ends)))
    }

    /// Adds a diagonal.
    pub(super) fn add(&mut self, ends: [u32; 2]) -> Result<()> {
        if self.matters(ends) {
            let bytes = size_of::<[u32; 2]>() as u64 * (self.diagonals.len() as u64 + 1);
            self.diagonals.try_reserve(1).map_err(|_| Error::OutOfMemory { bytes })?;
            self.diagonals.insert(edge(ends));
        }
        Ok(())
    }

    fn matters(&self, ends: [u32; 2]) -> bool {
        ends.iter().any(|&class| self.is_glued[class as usize])
    }
}

fn edge([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}
