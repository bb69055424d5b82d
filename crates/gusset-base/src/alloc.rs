//! Fallible allocation. All memory sized by the input is requested here, so that a huge count
//! causes an error instead of an abort.

use crate::error::{Error, Result};
use crate::job::Job;
use crate::reserve;
use std::collections::HashSet;
use std::hash::Hash;

/// Returns an empty vector with room for `capacity` elements.
pub fn with_capacity<T>(capacity: usize) -> Result<Vec<T>> {
    let mut vec = Vec::new();
    reserve(&mut vec, capacity)?;
    Ok(vec)
}

/// Returns a vector of `len` copies of `value`.
pub fn filled<T: Clone>(value: T, len: usize) -> Result<Vec<T>> {
    let mut vec = with_capacity(len)?;
    vec.resize(len, value);
    Ok(vec)
}

/// Returns a vector of `len` zeros. The memory is first touched when it is used, by the thread that
/// uses it.
pub fn zeroed<T: bytemuck::Zeroable>(len: usize) -> Result<Vec<T>> {
    let made = bytemuck::allocation::try_zeroed_vec(len).ok();
    made.filter(|vec: &Vec<T>| !reserve::contains_block(vec.as_ptr())).ok_or_else(|| out_of_memory::<T>(len))
}

/// Collects an iterator whose length is known.
pub fn collect<T>(items: impl ExactSizeIterator<Item = T>) -> Result<Vec<T>> {
    let mut vec = with_capacity(items.len())?;
    vec.extend(items);
    Ok(vec)
}

/// [`collect`] for long iterators: the host can cancel.
pub fn collect_cancellable<T>(
    mut items: impl ExactSizeIterator<Item = T>,
    job: &Job<'_>,
    stage: &'static str,
) -> Result<Vec<T>> {
    let mut vec = with_capacity(items.len())?;
    job.work_in_ranges(stage, items.len(), |range| {
        vec.extend(items.by_ref().take(range.len()));
        Ok(())
    })?;
    Ok(vec)
}

/// Collects an iterator of any length.
pub fn gather<T>(items: impl IntoIterator<Item = T>) -> Result<Vec<T>> {
    try_collect(items.into_iter().map(Ok))
}

/// Collects an iterator of any length, up to the first error.
pub fn try_collect<T, E: From<Error>>(items: impl IntoIterator<Item = Result<T, E>>) -> Result<Vec<T>, E> {
    let items = items.into_iter();
    let mut vec = with_capacity(items.size_hint().0)?;
    for item in items {
        push(&mut vec, item?)?;
    }
    Ok(vec)
}

/// Copies a slice.
pub fn copied<T: Copy>(items: &[T]) -> Result<Vec<T>> {
    let mut vec = Vec::new();
    append(&mut vec, items)?;
    Ok(vec)
}

/// Sets a vector to `len` copies of `value`, reusing its memory.
pub fn reset<T: Clone>(vec: &mut Vec<T>, len: usize, value: T) -> Result<()> {
    vec.clear();
    grow(vec, len, value)
}

/// Appends copies of `value` until the vector has at least `len` elements.
pub fn grow<T: Clone>(vec: &mut Vec<T>, len: usize, value: T) -> Result<()> {
    if vec.len() < len {
        reserve(vec, len - vec.len())?;
        vec.resize(len, value);
    }
    Ok(())
}

/// Reserves room for `additional` more elements.
pub fn reserve<T>(vec: &mut Vec<T>, additional: usize) -> Result<()> {
    if additional <= vec.capacity() - vec.len() { Ok(()) } else { grow_capacity(vec, additional) }
}

/// Grows a vector that lacks room. Only infallible allocations may use the memory reserve, so a
/// vector that lands there moves back to its old block.
#[cold]
#[inline(never)]
fn grow_capacity<T>(vec: &mut Vec<T>, additional: usize) -> Result<()> {
    let capacity = vec.capacity();
    if vec.try_reserve(additional).is_ok() && !reserve::contains_block(vec.as_ptr()) {
        return Ok(());
    }
    vec.shrink_to(capacity);
    Err(out_of_memory::<T>(additional))
}

#[cold]
fn out_of_memory<T>(count: usize) -> Error {
    Error::OutOfMemory { bytes: (count as u64).saturating_mul(size_of::<T>() as u64) }
}

/// Fails if an allocation that cannot fail was served from the memory reserve, which is small. Loops that make such allocations check
/// this in each round, if no [`Job`] does it for them.
pub fn check_reserve() -> Result<()> {
    if reserve::holds_blocks() { Err(out_of_memory::<u8>(0)) } else { Ok(()) }
}

/// Appends a slice.
pub fn append<T: Copy>(vec: &mut Vec<T>, items: &[T]) -> Result<()> {
    reserve(vec, items.len())?;
    vec.extend_from_slice(items);
    Ok(())
}

/// Appends the items of an iterator of any length.
pub fn extend<T>(vec: &mut Vec<T>, items: impl IntoIterator<Item = T>) -> Result<()> {
    let mut items = items.into_iter();
    reserve(vec, items.size_hint().0)?;
    items.try_for_each(|item| push(vec, item))
}

/// Appends the parts in turn, up to the first error.
pub fn append_all<T: Copy>(vec: &mut Vec<T>, parts: impl IntoIterator<Item = Result<Vec<T>>>) -> Result<()> {
    parts.into_iter().try_for_each(|part| append(vec, &part?))
}

/// Inserts items into a set.
pub fn insert_all<T: Eq + Hash>(set: &mut HashSet<T>, items: impl IntoIterator<Item = T>) -> Result<()> {
    for item in items {
        set.try_reserve(1).map_err(|_| out_of_memory::<T>(set.len() + 1))?;
        set.insert(item);
    }
    Ok(())
}

/// Appends one element.
pub fn push<T>(vec: &mut Vec<T>, item: T) -> Result<()> {
    if vec.len() == vec.capacity() {
        reserve(vec, 1)?;
    }
    vec.push(item);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_huge_count_is_an_error() {
        let result = with_capacity::<u64>(usize::MAX / 16);
        assert_eq!(result, Err(Error::OutOfMemory { bytes: (usize::MAX / 16) as u64 * 8 }));
        let result = zeroed::<u64>(usize::MAX / 16);
        assert_eq!(result, Err(Error::OutOfMemory { bytes: (usize::MAX / 16) as u64 * 8 }));
    }
}
