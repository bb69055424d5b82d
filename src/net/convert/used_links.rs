//! Edges that diagonals of quads must avoid: a diagonal along an edge of the mesh would give it
//! four faces.
//!
//! Only edges with a glued end matter: between two single nodes no second edge exists.

use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use crate::net::shape::{Shape, sorted_pair};
use std::collections::HashSet;

/// The edges with at least one glued end.
pub(super) struct UsedLinks {
    /// For each class whether it has several nodes.
    is_glued: Vec<bool>,
    /// The edges of the net's links, in order.
    links: Vec<[u32; 2]>,
    /// The diagonals chosen so far.
    diagonals: HashSet<[u32; 2]>,
}

impl UsedLinks {
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
                    alloc::push(&mut links, sorted_pair(ends.map(|node| classes[node as usize])))?;
                }
            }
            Ok(())
        })?;
        links.sort_unstable();
        links.dedup();
        Ok(UsedLinks { is_glued, links, diagonals: HashSet::new() })
    }

    /// True if two classes are joined by an edge.
    pub(super) fn contains(&self, ends: [u32; 2]) -> bool {
        let edge = sorted_pair(ends);
        self.has_glued_end(ends) && (self.links.binary_search(&edge).is_ok() || self.diagonals.contains(&edge))
    }

    /// Adds a diagonal.
    pub(super) fn add(&mut self, ends: [u32; 2]) -> Result<()> {
        if self.has_glued_end(ends) {
            let bytes = size_of::<[u32; 2]>() as u64 * (self.diagonals.len() as u64 + 1);
            self.diagonals.try_reserve(1).map_err(|_| Error::OutOfMemory { bytes })?;
            self.diagonals.insert(sorted_pair(ends));
        }
        Ok(())
    }

    fn has_glued_end(&self, ends: [u32; 2]) -> bool {
        ends.iter().any(|&class| self.is_glued[class as usize])
    }
}
