//! Bytes of regular files.

use crate::error::{ReadError, ReadErrorKind};
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// Loads a regular file. Pipes, devices and folders are refused without being opened for reading.
pub(crate) fn load(path: &Path) -> Result<Vec<u8>, ReadError> {
    let unreadable = |why: String| ReadError::new(ReadErrorKind::Unreadable, why);
    let status = std::fs::metadata(path).map_err(|error| unreadable(reason(&error)))?;
    if !status.is_file() {
        return Err(unreadable("this is not a regular file".into()));
    }
    let mut file = File::open(path).map_err(|error| unreadable(reason(&error)))?;
    let size = file.metadata().map_err(|error| unreadable(reason(&error)))?.len();
    let mut bytes = Vec::new();
    let size = usize::try_from(size).map_err(|_| ReadError::out_of_memory())?;
    bytes.try_reserve_exact(size)?;
    Read::take(&mut file, size as u64).read_to_end(&mut bytes).map_err(|error| unreadable(reason(&error)))?;
    Ok(bytes)
}

fn reason(error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::NotFound => "the file does not exist".into(),
        std::io::ErrorKind::PermissionDenied => "permission denied".into(),
        _ => error.to_string(),
    }
}
