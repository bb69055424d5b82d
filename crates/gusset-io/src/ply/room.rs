//! Room in arrays whose size is not known in advance.

use crate::error::ReadError;

/// Makes room for `count` more values. Grows by a quarter at least, so that appending takes linear time and little memory.
#[inline]
pub(super) fn make_room<T>(values: &mut Vec<T>, count: usize) -> Result<(), ReadError> {
    if values.capacity() - values.len() < count {
        values.try_reserve_exact(count.max(values.len() / 4))?;
    }
    Ok(())
}
