//! Reachability in the graph of groups by bidirectional search, which keeps groups from containing
//! themselves.
//!
//! Two depth-first searches are interleaved, one down from the ancestor and one up from the
//! descendant. The first to finish decides. A chain of groups built from either end therefore costs
//! O(1) a link, and a query at most the smaller of the two searches. Nothing recurses.

use gusset_base::alloc;
use gusset_base::error::Result;

/// Marks of visited entries, reused by all searches: each search has its own number.
#[derive(Debug, Default)]
pub(super) struct VisitMarks {
    visited: Vec<u32>,
    search: u32,
}

impl VisitMarks {
    /// Adds an entry.
    pub(super) fn add_entry(&mut self) -> Result<()> {
        alloc::push(&mut self.visited, 0)
    }

    /// Numbers for two searches that no earlier search had.
    fn next_two_search_numbers(&mut self) -> [u32; 2] {
        if self.search > u32::MAX - 2 {
            self.visited.fill(0);
            self.search = 0;
        }
        self.search += 2;
        [self.search - 1, self.search]
    }

    /// Returns true if `to` can be reached from `from`. `child` and `parent` return neighbour k of
    /// an entry.
    pub(super) fn is_reachable(
        &mut self,
        from: u32,
        to: u32,
        child: impl Fn(u32, usize) -> Option<u32>,
        parent: impl Fn(u32, usize) -> Option<u32>,
    ) -> Result<bool> {
        if from == to {
            return Ok(true);
        }
        let [down, up] = self.next_two_search_numbers();
        let mut below = DepthFirstSearch::new(from, [down, up])?;
        let mut above = DepthFirstSearch::new(to, [up, down])?;
        loop {
            let Some((at, k)) = below.next_neighbour() else { return Ok(false) };
            let next = child(at, k);
            if next == Some(to) || below.descend_or_backtrack(next, self)? {
                return Ok(true);
            }
            let Some((at, k)) = above.next_neighbour() else { return Ok(false) };
            let next = parent(at, k);
            if next == Some(from) || above.descend_or_backtrack(next, self)? {
                return Ok(true);
            }
        }
    }
}

/// A depth-first search that advances one step at a time.
struct DepthFirstSearch {
    /// The number of this search and of the opposite one.
    own_and_opposite_number: [u32; 2],
    /// Entries on the path, each with the number of its neighbours examined.
    path: Vec<(u32, usize)>,
}

impl DepthFirstSearch {
    fn new(from: u32, numbers: [u32; 2]) -> Result<Self> {
        Ok(DepthFirstSearch { own_and_opposite_number: numbers, path: alloc::filled((from, 0), 1)? })
    }

    /// Returns the entry and the number of its neighbour to examine.
    fn next_neighbour(&mut self) -> Option<(u32, usize)> {
        let (at, next) = self.path.last_mut()?;
        *next += 1;
        Some((*at, *next - 1))
    }

    /// Descends to a neighbour unless it was visited, or backtracks if there is none. Returns true
    /// where the two searches meet.
    fn descend_or_backtrack(&mut self, neighbour: Option<u32>, marks: &mut VisitMarks) -> Result<bool> {
        let [own, opposite] = self.own_and_opposite_number;
        let Some(entry) = neighbour else {
            self.path.pop();
            return Ok(false);
        };
        let visited = std::mem::replace(&mut marks.visited[entry as usize], own);
        if visited != own {
            alloc::push(&mut self.path, (entry, 0))?;
        }
        Ok(visited == opposite)
    }
}
