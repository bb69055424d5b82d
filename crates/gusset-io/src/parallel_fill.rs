//! Large arrays that several threads fill.
//!
//! Filling memory for the first time costs most of the time of a fast reader, because the system maps each page when it is touched.

use crate::error::ReadError;
use bytemuck::Zeroable;

/// Most threads that fill an array.
const MAX_THREADS: usize = 4;
/// Fewest values for each thread: starting a thread takes as long as filling some 100 kB.
pub(crate) const MIN_PART: usize = 1 << 16;

/// Returns the number of threads that share the work on a large array.
pub(crate) fn thread_count() -> usize {
    if cfg!(target_family = "wasm") {
        return 1;
    }
    std::thread::available_parallelism().map_or(1, |threads| threads.get().min(MAX_THREADS))
}

/// Makes a vector whose value at each index is `value(index)`.
pub(crate) fn make_vector<T: Zeroable + Send>(
    count: usize,
    value: impl Fn(usize) -> T + Sync,
) -> Result<Vec<T>, ReadError> {
    let mut values = bytemuck::allocation::try_zeroed_vec(count).map_err(|()| ReadError::out_of_memory())?;
    fill_parts(&mut values, value);
    Ok(values)
}

/// Sets each value to `value(index)`. Each thread fills one part.
pub(crate) fn fill_parts<T: Send>(values: &mut [T], value: impl Fn(usize) -> T + Sync) {
    let part_length = values.len().div_ceil(thread_count()).max(MIN_PART);
    let fill = |part: usize, values: &mut [T]| {
        for (offset, place) in values.iter_mut().enumerate() {
            *place = value(part * part_length + offset);
        }
    };
    if values.len() <= part_length {
        return fill(0, values);
    }
    let mut is_left = Vec::new();
    std::thread::scope(|scope| {
        let fill = &fill;
        let mut parts = values.chunks_mut(part_length).enumerate();
        let first = parts.next();
        for (part, values) in parts {
            if std::thread::Builder::new().spawn_scoped(scope, move || fill(part, values)).is_err() {
                is_left.push(part);
            }
        }
        if let Some((part, values)) = first {
            fill(part, values);
        }
    });
    for part in is_left {
        let start = part * part_length;
        let end = values.len().min(start + part_length);
        fill(part, &mut values[start..end]);
    }
}
