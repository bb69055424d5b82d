//! Which arc follows which, and the chains that come of it.

use gusset_base::alloc;
use gusset_base::error::Result;

/// Arcs in their order along a curve.
#[derive(Debug)]
pub(super) struct Chain {
    pub(super) arcs: Vec<u32>,
    pub(super) closed: bool,
}

pub(super) const NONE: u32 = u32::MAX;

/// The arcs before and after each arc.
pub(super) struct Links {
    before: Vec<u32>,
    pub(super) after: Vec<u32>,
}

impl Links {
    /// Of arcs none of which follows another.
    pub(super) fn new(count: usize) -> Result<Self> {
        Ok(Links { before: alloc::filled(NONE, count)?, after: alloc::filled(NONE, count)? })
    }

    /// Of arcs some of which are dropped, by (distance, end, start) of those that may be joined,
    /// the nearest first.
    pub(super) fn of(joints: &[(f64, u32, u32)], dropped: &[bool]) -> Result<Self> {
        let mut links = Self::new(dropped.len())?;
        let is_kept = |arc: u32| !dropped[arc as usize];
        let kept = joints.iter().filter(|&&(_, end, start)| is_kept(end) && is_kept(start));
        kept.for_each(|&(_, end, start)| links.join(end, start));
        Ok(links)
    }

    /// Joins two arcs, if neither has a neighbour there.
    pub(super) fn join(&mut self, end: u32, start: u32) {
        if self.are_free(end, start) {
            (self.after[end as usize], self.before[start as usize]) = (start, end);
        }
    }

    /// Whether nothing follows the one arc, and nothing comes before the other.
    pub(super) fn are_free(&self, end: u32, start: u32) -> bool {
        self.after[end as usize] == NONE && self.before[start as usize] == NONE
    }

    /// The chains, by their first arcs.
    pub(super) fn chains(&self, dropped: &[bool]) -> Result<Vec<Chain>> {
        let mut done = alloc::copied(dropped)?;
        let mut chains = Vec::new();
        for k in 0..dropped.len() as u32 {
            if done[k as usize] {
                continue;
            }
            // Back to where it begins, or round to where we are.
            let mut first = k;
            while self.before[first as usize] != NONE && self.before[first as usize] != k {
                first = self.before[first as usize];
            }
            let closed = self.before[first as usize] == k;
            let mut chain = Chain { arcs: Vec::new(), closed };
            let mut at = if closed { k } else { first };
            while at != NONE && !done[at as usize] {
                done[at as usize] = true;
                alloc::push(&mut chain.arcs, at)?;
                at = self.after[at as usize];
            }
            alloc::push(&mut chains, chain)?;
        }
        Ok(chains)
    }
}
