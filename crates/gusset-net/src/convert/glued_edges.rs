//! Edges that the diagonals of quads must avoid: a diagonal along an edge of the mesh would give
//! the edge four faces.
//!
//! Only edges with a glued end matter, because two single nodes have at most one edge.

use crate::shape::{Shape, sorted_pair};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use std::collections::HashSet;

/// The edges with at least one glued end.
pub(super) struct GluedEdges {
    /// For each node whether its class has others.
    is_glued: Vec<bool>,
    /// The edges of the net's links, and the diagonals chosen so far.
    edges: HashSet<[u32; 2]>,
}

impl GluedEdges {
    /// Returns the edges of the links. O(nodes).
    pub(super) fn new(shape: Shape, classes: &[u32], job: &Job<'_>, stage: &'static str) -> Result<Self> {
        let mut is_glued = alloc::filled(false, classes.len())?;
        job.sub_job(0.0, 0.3).work_in_ranges(stage, classes.len(), |range| {
            for node in range.filter(|&node| node != classes[node] as usize) {
                (is_glued[node], is_glued[classes[node] as usize]) = (true, true);
            }
            Ok(())
        })?;
        let mut used = GluedEdges { is_glued, edges: HashSet::new() };
        job.sub_job(0.3, 1.0).work_in_ranges(stage, 2 * classes.len(), |range| {
            for link in range.map(|link| link as u32).filter(|&link| shape.joins_neighbours(link)) {
                let ends = shape.ends_of_link(link);
                if used.has_glued_end(ends) {
                    used.add_edge(ends.map(|node| classes[node as usize]))?;
                }
            }
            Ok(())
        })?;
        Ok(used)
    }

    /// Returns true if an edge joins two classes.
    pub(super) fn contains(&self, ends: [u32; 2]) -> bool {
        self.has_glued_end(ends) && self.edges.contains(&sorted_pair(ends))
    }

    /// Adds an edge between two classes.
    pub(super) fn add_edge(&mut self, ends: [u32; 2]) -> Result<()> {
        if self.has_glued_end(ends) {
            let bytes = size_of::<[u32; 2]>() as u64 * (self.edges.len() as u64 + 1);
            self.edges.try_reserve(1).map_err(|_| Error::OutOfMemory { bytes })?;
            self.edges.insert(sorted_pair(ends));
        }
        Ok(())
    }

    fn has_glued_end(&self, ends: [u32; 2]) -> bool {
        ends.iter().any(|&node| self.is_glued[node as usize])
    }
}
