//! Choices of reading and writing.

use std::fmt;
use std::sync::Arc;

/// Limits of readers.
#[derive(Clone, Debug)]
pub struct ReadOptions {
    /// Opens files that the file names outside of its own folder.
    pub follow_outside: bool,
    /// Merges the vertices of formats that repeat them for each face (STL) if their positions are equal. Without it, reading a large
    /// STL file takes a fraction of the time, and each face has vertices of its own.
    pub merge_repeated: bool,
}

impl Default for ReadOptions {
    fn default() -> Self {
        Self { follow_outside: false, merge_repeated: true }
    }
}

/// Choices of writers.
#[derive(Clone, Default)]
pub struct WriteOptions {
    /// Writes PLY and STL files as text.
    pub text: bool,
    /// Permits single precision that moves points by more than a thousandth of the mean edge.
    pub lossy: bool,
    /// Returns true to stop writing a file, which then stays as it was.
    pub stop: Option<Arc<dyn Fn() -> bool + Send + Sync>>,
}

impl fmt::Debug for WriteOptions {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("WriteOptions").field("text", &self.text).field("lossy", &self.lossy).finish_non_exhaustive()
    }
}
