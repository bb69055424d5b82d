//! Files beside the one that is read or written.

use crate::error::{ReadError, ReadErrorKind, WriteError};
use std::io::{BufWriter, Write};

/// Gives the bytes of files that a file refers to: material libraries, buffers, images, scans.
pub trait Resources {
    /// Returns the bytes of the file `name`, which is relative to the folder of the referring file.
    ///
    /// # Errors
    /// `Unreadable` if the file does not exist, is not a regular file or is outside of the folder. `OutOfMemory`.
    fn load(&self, name: &str) -> Result<Vec<u8>, ReadError>;

    /// Returns the name by which a written file refers to the file `name`.
    fn written_name(&self, name: &str) -> String {
        name.to_owned()
    }
}

/// Refuses all names.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoResources;

impl Resources for NoResources {
    fn load(&self, name: &str) -> Result<Vec<u8>, ReadError> {
        Err(ReadError::new(
            ReadErrorKind::Unreadable,
            format!("the file {name} was not given; give it beside this one"),
        ))
    }
}

/// Receives the bytes of a file.
pub trait Output: Write {
    /// Makes room for bytes that will be written, if the output keeps them in memory.
    ///
    /// # Errors
    /// `OutOfMemory`.
    fn reserve(&mut self, _bytes: usize) -> std::io::Result<()> {
        Ok(())
    }

    /// Makes room for bytes that the caller fills in place, if the output keeps them in memory. See [`next_bytes`](Self::next_bytes).
    ///
    /// # Errors
    /// `OutOfMemory`.
    fn reserve_in_place(&mut self, bytes: usize) -> std::io::Result<()> {
        self.reserve(bytes)
    }

    /// Appends bytes that the caller fills. Returns `None` if the output cannot lend them in place.
    fn next_bytes(&mut self, _count: usize) -> Option<&mut [u8]> {
        None
    }
}

impl<W: Write> Output for BufWriter<W> {}

impl Output for Vec<u8> {
    fn reserve(&mut self, bytes: usize) -> std::io::Result<()> {
        Ok(self.try_reserve_exact(bytes)?)
    }
}

/// Receives a written file and the files beside it.
pub struct Target<'a> {
    /// The file.
    pub main_file: &'a mut dyn Output,
    /// Name of the file without folder and extension, from which names of files beside it are made.
    pub stem: &'a str,
    /// Receives files beside it: name and bytes. Returns an error of kind `Unsupported` if there can be none.
    pub beside: &'a mut dyn FnMut(&str, &[u8]) -> std::io::Result<()>,
    /// Gives the images that the document names.
    pub resources: &'a dyn Resources,
}

impl Target<'_> {
    /// Writes a file beside the main one.
    ///
    /// # Errors
    /// `Unwritable`, or `Unsupported` if no file can be beside the main one.
    pub fn write_beside(&mut self, name: &str, bytes: &[u8]) -> Result<(), WriteError> {
        (self.beside)(name, bytes).map_err(WriteError::from)
    }
}
