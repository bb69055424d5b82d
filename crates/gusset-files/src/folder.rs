//! Files that the host gives.

use crate::table::descriptor::gusset_files_folder;
use gusset_io::{ReadError, ReadErrorKind, Resources};
use std::ffi::{CStr, CString};
use std::ptr;

/// The host's folder, if it gave one.
pub(crate) struct Folder(Option<gusset_files_folder>);

impl Folder {
    /// # Safety
    /// `folder` is NULL, or the struct is valid during the call.
    pub(crate) unsafe fn new(folder: *const gusset_files_folder) -> Self {
        // SAFETY: the caller's promise.
        let given = unsafe { folder.as_ref() };
        Self(given.copied().filter(|folder| folder.struct_size >= size_of::<gusset_files_folder>()))
    }
}

impl Resources for Folder {
    fn load(&self, name: &str) -> Result<Vec<u8>, ReadError> {
        let missing = || ReadError::new(ReadErrorKind::Unreadable, format!("the file {name} cannot be read"));
        let (folder, c_name) = self.0.zip(CString::new(name).ok()).ok_or_else(missing)?;
        let load = folder.load.ok_or_else(missing)?;
        let (mut bytes, mut size) = (ptr::null(), 0);
        // SAFETY: the host promises that its callback takes these arguments.
        if unsafe { load(folder.user, c_name.as_ptr(), &mut bytes, &mut size) } != 0 {
            return Err(missing());
        }
        // SAFETY: the host promises that the bytes live until the next call.
        let lent = unsafe { given_bytes(bytes, size) }.ok_or_else(missing)?;
        let mut copy = Vec::new();
        copy.try_reserve_exact(lent.len())?;
        copy.extend_from_slice(lent);
        Ok(copy)
    }

    fn written_name(&self, name: &str) -> String {
        let seen_as = self.0.map_or(ptr::null(), |folder| folder.seen_as);
        let is_relative = !name.is_empty() && !name.starts_with(['/', '\\']) && !name.contains(':');
        if seen_as.is_null() || !is_relative {
            return name.to_owned();
        }
        // SAFETY: the host promises that it is a C string during the call.
        let folder = unsafe { CStr::from_ptr(seen_as) }.to_string_lossy();
        format!("{}/{name}", folder.trim_end_matches('/'))
    }
}

/// Returns the host's bytes; `None` if they are NULL or exceed the address space.
///
/// # Safety
/// `bytes` is NULL, or this many bytes are valid.
pub(crate) unsafe fn given_bytes<'a>(bytes: *const u8, size: usize) -> Option<&'a [u8]> {
    if size == 0 {
        return Some(&[]);
    }
    if bytes.is_null() || isize::try_from(size).is_err() {
        return None;
    }
    // SAFETY: the caller's promise.
    Some(unsafe { std::slice::from_raw_parts(bytes, size) })
}
