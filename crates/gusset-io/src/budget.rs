//! A limit of the memory that a reader takes for what it makes of a file.

use crate::MAX_MEMORY_PER_FILE_BYTE;
use crate::error::{ReadError, ReadErrorKind};

/// Memory in bytes that every file may take, however small it is.
const MIN_BUDGET: u64 = 16 << 20;

/// Bytes that a reader may still take. Formats whose elements refer to shared or compressed data need it: a short file can describe
/// an unlimited scene.
pub(crate) struct Budget {
    left_bytes: u64,
    source_bytes: u64,
}

impl Budget {
    /// Makes the budget of a file, whose own bytes count.
    pub(crate) fn new(file_bytes: usize) -> Self {
        let source_bytes = file_bytes as u64;
        Self { left_bytes: allowed_bytes(source_bytes) - source_bytes.min(allowed_bytes(source_bytes)), source_bytes }
    }

    /// Adds a file that the first one refers to.
    pub(crate) fn add_source(&mut self, file_bytes: usize) {
        self.source_bytes = self.source_bytes.saturating_add(file_bytes as u64);
        self.left_bytes =
            self.left_bytes.saturating_add((file_bytes as u64).saturating_mul(MAX_MEMORY_PER_FILE_BYTE - 1));
    }

    /// Returns the bytes that are left.
    pub(crate) fn left_bytes(&self) -> u64 {
        self.left_bytes
    }

    /// Takes memory for `count` elements of type `T`.
    pub(crate) fn take_bytes_of<T>(&mut self, count: u64) -> Result<(), ReadError> {
        let bytes = count.saturating_mul(size_of::<T>() as u64);
        match self.left_bytes.checked_sub(bytes) {
            Some(left) => {
                self.left_bytes = left;
                Ok(())
            }
            None => Err(self.exceeded_error()),
        }
    }

    /// Gives back memory of `count` elements that are no longer needed.
    pub(crate) fn give_back_bytes_of<T>(&mut self, count: u64) {
        self.left_bytes = self.left_bytes.saturating_add(count.saturating_mul(size_of::<T>() as u64));
    }

    /// Makes an empty vector with room for `count` elements.
    pub(crate) fn allocate_vector<T>(&mut self, count: u64) -> Result<Vec<T>, ReadError> {
        self.take_bytes_of::<T>(count)?;
        let mut made = Vec::new();
        made.try_reserve_exact(usize::try_from(count).map_err(|_| ReadError::out_of_memory())?)?;
        Ok(made)
    }

    fn exceeded_error(&self) -> ReadError {
        let allowed = allowed_bytes(self.source_bytes);
        ReadError::new(
            ReadErrorKind::TooLarge,
            format!(
                "the file has {} bytes, and what it describes would take more than {allowed} bytes of memory",
                self.source_bytes
            ),
        )
    }
}

fn allowed_bytes(source_bytes: u64) -> u64 {
    source_bytes.saturating_mul(MAX_MEMORY_PER_FILE_BYTE).max(MIN_BUDGET)
}
