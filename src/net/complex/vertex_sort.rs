//! Sorting of items by vertex: a counting sort where there are many, comparison sorts elsewhere.
//! O(items + vertices) with few items at each vertex, as on nets but for poles.

use crate::error::Result;
use crate::sort::Buckets;

/// Sorts items whose order compares vertices, all below `count`, first.
pub(super) fn sort<T: Ord + Copy>(items: &mut Vec<T>, count: usize, vertex: impl Fn(&T) -> u32) -> Result<()> {
    if items.len() < count / 8 || items.len() < 256 || items.len() > u32::MAX as usize {
        items.sort_unstable();
        return Ok(());
    }
    let mut sorted = Buckets::new(count, items[0], items.iter().map(|item| (vertex(item) as usize, *item)))?;
    (0..count).for_each(|v| sorted.get_mut(v).sort_unstable());
    *items = sorted.into_parts().1;
    Ok(())
}
