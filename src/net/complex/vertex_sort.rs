//! Sorting of items by vertex: a counting sort where there are many, comparison sorts elsewhere.
//! O(items + vertices) with few items at each vertex, as on nets but for poles.

use crate::alloc;
use crate::error::Result;

/// Sorts items whose order compares vertices, all below `count`, first.
pub(super) fn sort<T: Ord + Copy>(items: &mut Vec<T>, count: usize, vertex: impl Fn(&T) -> u32) -> Result<()> {
    if items.len() < count / 8 || items.len() < 256 || items.len() > u32::MAX as usize {
        items.sort_unstable();
        return Ok(());
    }
    // Where the items of each vertex start; afterwards, where they end.
    let mut places: Vec<u32> = alloc::zeroed(count + 1)?;
    for item in items.iter() {
        places[vertex(item) as usize + 1] += 1;
    }
    for v in 0..count {
        places[v + 1] += places[v];
    }
    let mut sorted = alloc::copied(items)?;
    for item in items.iter() {
        let place = &mut places[vertex(item) as usize];
        sorted[*place as usize] = *item;
        *place += 1;
    }
    let mut start = 0;
    for &end in &places[..count] {
        sorted[start..end as usize].sort_unstable();
        start = end as usize;
    }
    *items = sorted;
    Ok(())
}
