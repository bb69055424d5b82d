//! A file in memory, as it is written.

use crate::resources::Output;
use gusset_base::alloc;
use std::io::{Error, ErrorKind, Result, Write};

/// Bytes of a file. Writing fails if memory runs out.
#[derive(Default)]
pub struct MemoryFile {
    /// The written bytes, and room for further ones.
    bytes_and_spare_room: Vec<u8>,
    length: usize,
}

impl MemoryFile {
    /// Returns the bytes.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        &self.bytes_and_spare_room[..self.length]
    }

    /// Returns the bytes.
    #[must_use]
    pub fn into_bytes(mut self) -> Vec<u8> {
        self.bytes_and_spare_room.truncate(self.length);
        self.bytes_and_spare_room
    }
}

impl Output for MemoryFile {
    fn reserve(&mut self, bytes: usize) -> Result<()> {
        self.bytes_and_spare_room.truncate(self.length);
        self.bytes_and_spare_room.try_reserve_exact(bytes).map_err(|_| Error::from(ErrorKind::OutOfMemory))
    }

    /// Makes room whose pages the system maps when they are written, by the thread that writes them.
    fn reserve_in_place(&mut self, bytes: usize) -> Result<()> {
        if self.bytes_and_spare_room.len() - self.length < bytes {
            let mut room = alloc::zeroed(self.length + bytes).map_err(|_| Error::from(ErrorKind::OutOfMemory))?;
            room[..self.length].copy_from_slice(self.bytes());
            self.bytes_and_spare_room = room;
        }
        Ok(())
    }

    fn next_bytes(&mut self, count: usize) -> Option<&mut [u8]> {
        let room = self.bytes_and_spare_room.get_mut(self.length..)?.get_mut(..count)?;
        self.length += count;
        Some(room)
    }
}

impl Write for MemoryFile {
    fn write(&mut self, added: &[u8]) -> Result<usize> {
        if let Some(room) = self.next_bytes(added.len()) {
            room.copy_from_slice(added);
            return Ok(added.len());
        }
        self.bytes_and_spare_room.truncate(self.length);
        // Most growth doubles the memory. Near the end of memory, only the exact size may fit.
        if self.bytes_and_spare_room.try_reserve(added.len()).is_err() {
            self.bytes_and_spare_room
                .try_reserve_exact(added.len())
                .map_err(|_| Error::from(ErrorKind::OutOfMemory))?;
        }
        self.bytes_and_spare_room.extend_from_slice(added);
        self.length = self.bytes_and_spare_room.len();
        Ok(added.len())
    }

    fn flush(&mut self) -> Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::MemoryFile;
    use crate::resources::Output;
    use std::io::Write;

    #[test]
    fn room_is_not_part_of_the_file() {
        let mut file = MemoryFile::default();
        file.write_all(b"ab").expect("it fits");
        file.reserve_in_place(4).expect("it fits");
        file.next_bytes(3).expect("it is reserved").copy_from_slice(b"cde");
        assert!(file.next_bytes(2).is_none());
        file.write_all(b"fgh").expect("it fits");
        file.reserve(100).expect("it fits");
        file.write_all(b"i").expect("it fits");
        assert_eq!(file.bytes(), b"abcdefghi");
        assert_eq!(file.into_bytes(), b"abcdefghi");
    }
}
