//! Rows of one length that several threads make.

use crate::parallel_fill::{MIN_PART, fill_parts, thread_count};
use crate::resources::Output;
use gusset_base::alloc;
use std::io::{Error, ErrorKind, Result};

/// Writes the rows `row(0)` to `row(count - 1)`. An output in memory gets them in place; others get them in blocks.
pub(crate) fn write_rows<const N: usize>(
    out: &mut dyn Output,
    count: usize,
    row: impl Fn(usize) -> [u8; N] + Sync,
) -> Result<()> {
    let full = || Error::from(ErrorKind::OutOfMemory);
    if let Some(room) = out.next_bytes(count.checked_mul(N).ok_or_else(full)?) {
        fill_parts(room.as_chunks_mut().0, row);
        return Ok(());
    }
    let block_rows = count.min(MIN_PART * thread_count()).max(1);
    let mut block: Vec<[u8; N]> = alloc::zeroed(block_rows).map_err(|_| full())?;
    for start in (0..count).step_by(block_rows) {
        let block = &mut block[..block_rows.min(count - start)];
        fill_parts(block, |offset| row(start + offset));
        out.write_all(block.as_flattened())?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::write_rows;
    use crate::memory_file::MemoryFile;
    use crate::parallel_fill::MIN_PART;
    use crate::resources::Output;

    #[test]
    fn rows_in_place_and_in_blocks_are_equal() {
        let row = |index: usize| [index as u8, (index >> 8) as u8, (index >> 16) as u8];
        for count in [0, 1, 1000, MIN_PART + 1, 9 * MIN_PART + 5] {
            let expected: Vec<u8> = (0..count).flat_map(row).collect();
            let (mut blocks, mut file) = (Vec::new(), MemoryFile::default());
            write_rows(&mut blocks, count, row).expect("it fits");
            file.reserve_in_place(3 * count).expect("it fits");
            write_rows(&mut file, count, row).expect("it fits");
            assert!(blocks == expected && file.bytes() == expected, "{count}");
        }
    }
}
