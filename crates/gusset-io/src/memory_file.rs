//! A file in memory, as it is written.

use crate::resources::Output;
use std::io::{Error, ErrorKind, Result, Write};

/// Bytes of a file. Writing fails if memory runs out.
#[derive(Default)]
pub struct MemoryFile {
    /// The bytes.
    pub bytes: Vec<u8>,
}

impl Output for MemoryFile {
    fn reserve(&mut self, bytes: usize) -> Result<()> {
        self.bytes.try_reserve_exact(bytes).map_err(|_| Error::from(ErrorKind::OutOfMemory))
    }
}

impl Write for MemoryFile {
    fn write(&mut self, added: &[u8]) -> Result<usize> {
        // Most growth doubles the memory. Near the end of memory, only the exact size may fit.
        if self.bytes.try_reserve(added.len()).is_err() {
            self.bytes.try_reserve_exact(added.len()).map_err(|_| Error::from(ErrorKind::OutOfMemory))?;
        }
        self.bytes.extend_from_slice(added);
        Ok(added.len())
    }

    fn flush(&mut self) -> Result<()> {
        Ok(())
    }
}
