//! Keeping groups from containing themselves.

use super::{Content, Scene};
use crate::alloc;
use crate::error::Result;

/// Which entries a search has seen: those marked with its number.
#[derive(Debug, Default)]
pub(super) struct Marks {
    seen: Vec<u32>,
    search: u32,
}

impl Marks {
    /// Room for one entry more.
    pub(super) fn grow(&mut self) -> Result<()> {
        alloc::push(&mut self.seen, 0)
    }

    /// Numbers for two searches, each unlike all before.
    fn begin(&mut self) -> [u32; 2] {
        if self.search > u32::MAX - 2 {
            self.seen.fill(0);
            self.search = 0;
        }
        self.search += 2;
        [self.search - 1, self.search]
    }
}

impl Scene {
    /// True if `group` is `other`, or in it at whatever depth.
    ///
    /// Two searches take turns, one down from `other` and one up from `group`; the first to come to an end knows. A chain of
    /// groups that is built from either end therefore costs O(1) a link.
    pub(super) fn is_within(&mut self, group: u32, other: u32) -> Result<bool> {
        if group == other {
            return Ok(true);
        }
        let [down, up] = self.marks.begin();
        let mut below = Search::new(other, [down, up])?;
        let mut above = Search::new(group, [up, down])?;
        loop {
            let Some((at, next)) = below.next() else { return Ok(false) };
            let child = self.entries[at as usize].as_ref().and_then(|entry| match &entry.content {
                Content::Group(children) => children.get(next).copied(),
                Content::Net(_) => None,
            });
            if child == Some(group) || below.visit(child, &mut self.marks)? {
                return Ok(true);
            }
            let Some((at, next)) = above.next() else { return Ok(false) };
            let parent = self.entries[at as usize].as_ref().and_then(|entry| entry.parents.get(next).copied());
            if parent == Some(other) || above.visit(parent, &mut self.marks)? {
                return Ok(true);
            }
        }
    }
}

/// A search in depth that goes one step at a time.
struct Search {
    /// Its own number and that of the search that comes to meet it.
    numbers: [u32; 2],
    /// Entries, and how many of their neighbours have been looked at.
    open: Vec<(u32, usize)>,
}

impl Search {
    fn new(from: u32, numbers: [u32; 2]) -> Result<Self> {
        Ok(Search { numbers, open: alloc::filled((from, 0), 1)? })
    }

    /// The entry and the neighbour to look at.
    fn next(&mut self) -> Option<(u32, usize)> {
        let (at, next) = self.open.last_mut()?;
        *next += 1;
        Some((*at, *next - 1))
    }

    /// Goes on to a neighbour unless it was seen, or back if there is none. True where the two searches meet.
    fn visit(&mut self, neighbour: Option<u32>, marks: &mut Marks) -> Result<bool> {
        let [own, others] = self.numbers;
        let Some(entry) = neighbour else {
            self.open.pop();
            return Ok(false);
        };
        let seen = std::mem::replace(&mut marks.seen[entry as usize], own);
        if seen != own {
            alloc::push(&mut self.open, (entry, 0))?;
        }
        Ok(seen == others)
    }
}
