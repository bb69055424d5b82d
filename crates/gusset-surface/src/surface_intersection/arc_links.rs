//! The successor of each arc, and the chains that follow from it.

use gusset_base::alloc;
use gusset_base::error::Result;

/// Arcs in order along a curve.
#[derive(Debug)]
pub(super) struct ArcChain {
    pub(super) arcs: Vec<u32>,
    pub(super) closed: bool,
}

pub(super) const NO_LINKED_ARC: u32 = u32::MAX;

/// The predecessor and the successor of each arc.
pub(super) struct ArcLinks {
    predecessors: Vec<u32>,
    pub(super) successors: Vec<u32>,
}

impl ArcLinks {
    /// Creates links without any joints.
    pub(super) fn new(count: usize) -> Result<Self> {
        Ok(ArcLinks {
            predecessors: alloc::filled(NO_LINKED_ARC, count)?,
            successors: alloc::filled(NO_LINKED_ARC, count)?,
        })
    }

    /// Joins arcs that are not dropped. `joints` holds (distance, end, start), the closest pairs
    /// first.
    pub(super) fn from_joints(joints: &[(f64, u32, u32)], dropped: &[bool]) -> Result<Self> {
        let mut links = Self::new(dropped.len())?;
        let is_kept = |arc: u32| !dropped[arc as usize];
        let kept = joints.iter().filter(|&&(_, end, start)| is_kept(end) && is_kept(start));
        kept.for_each(|&(_, end, start)| links.join_arcs(end, start));
        Ok(links)
    }

    /// Joins the end of an arc to the start of another, if both are free.
    pub(super) fn join_arcs(&mut self, end: u32, start: u32) {
        if self.can_arc_follow(end, start) {
            (self.successors[end as usize], self.predecessors[start as usize]) = (start, end);
        }
    }

    /// Whether arc `end` lacks a successor, and arc `start` a predecessor.
    pub(super) fn can_arc_follow(&self, end: u32, start: u32) -> bool {
        self.successors[end as usize] == NO_LINKED_ARC && self.predecessors[start as usize] == NO_LINKED_ARC
    }

    /// The chains, ordered by their first arcs.
    pub(super) fn build_chains(&self, dropped: &[bool]) -> Result<Vec<ArcChain>> {
        let mut used = alloc::copied(dropped)?;
        let mut chains = Vec::new();
        for k in 0..dropped.len() as u32 {
            if used[k as usize] {
                continue;
            }
            // Walks back to the beginning, or around to the current arc.
            let mut first = k;
            while self.predecessors[first as usize] != NO_LINKED_ARC && self.predecessors[first as usize] != k {
                first = self.predecessors[first as usize];
            }
            let closed = self.predecessors[first as usize] == k;
            let mut chain = ArcChain { arcs: Vec::new(), closed };
            let mut at = if closed { k } else { first };
            while at != NO_LINKED_ARC && !used[at as usize] {
                used[at as usize] = true;
                alloc::push(&mut chain.arcs, at)?;
                at = self.successors[at as usize];
            }
            alloc::push(&mut chains, chain)?;
        }
        Ok(chains)
    }
}
