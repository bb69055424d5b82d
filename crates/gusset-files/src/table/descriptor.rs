//! Functions: Constants and structs of the table.

use super::outcome::gusset_file;
use std::ffi::{c_char, c_void};

/// Version of the table.
pub const GUSSET_FILES_ABI: u32 = 1;

/// Success.
pub const GUSSET_FILES_DONE: i32 = 0;
/// An argument is NULL, or a text is not UTF-8.
pub const GUSSET_FILES_BAD_ARGUMENT: i32 = 1;
/// The file or document breaks a rule, or the format is unknown or too narrow.
pub const GUSSET_FILES_BAD_FILE: i32 = 2;
/// Memory ran out.
pub const GUSSET_FILES_OUT_OF_MEMORY: i32 = 3;
/// An internal error.
pub const GUSSET_FILES_INTERNAL: i32 = 4;

/// Flag of read: joins all meshes of a scene into one.
pub const GUSSET_FILES_JOINED: u32 = 1;
/// Flag of read: keeps vertices of STL, DXF and glTF files at equal points apart.
pub const GUSSET_FILES_UNMERGED: u32 = 2;
/// Flag of write: PLY and STL files as text.
pub const GUSSET_FILES_TEXT: u32 = 1;
/// Flag of write: permits moves of over 0.001 mean edges by rounding.
pub const GUSSET_FILES_LOSSY: u32 = 2;

/// Files that a file names: materials, buffers, images, scans.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_files_folder {
    /// sizeof(gusset_files_folder).
    pub struct_size: usize,
    /// First argument of load.
    pub user: *mut c_void,
    /// Gets the bytes of a file beside it, until the next call or the function's end. Nonzero:
    /// none, or not to be read.
    pub load: Option<
        unsafe extern "C" fn(user: *mut c_void, name: *const c_char, bytes: *mut *const u8, size: *mut usize) -> i32,
    >,
    /// Path from a written file's folder to this one, such as "../scans", by which it names images.
    /// NULL: both are one.
    pub seen_as: *const c_char,
}

/// Table of functions, for any thread.
#[repr(C)]
pub struct gusset_files {
    /// sizeof(gusset_files).
    pub struct_size: usize,
    /// Reads a file of size bytes. name: its extension is the format. folder: may be NULL. flags:
    /// GUSSET_FILES_JOINED, GUSSET_FILES_UNMERGED or 0. Part 0 is the document's JSON text, part 1
    /// its arrays; after a failure, *result has the message. O(size) time; memory at most 32 times
    /// all files.
    pub read: unsafe extern "C" fn(
        name: *const c_char,
        bytes: *const u8,
        size: usize,
        folder: *const gusset_files_folder,
        flags: u32,
        result: *mut *mut gusset_file,
    ) -> i32,
    /// Writes a document, whose arrays have size bytes. flags: GUSSET_FILES_TEXT,
    /// GUSSET_FILES_LOSSY or 0. Part 0 is a JSON list of losses, part 1 the file, the rest files
    /// beside it.
    pub write: unsafe extern "C" fn(
        name: *const c_char,
        document: *const c_char,
        arrays: *const u8,
        size: usize,
        folder: *const gusset_files_folder,
        flags: u32,
        result: *mut *mut gusset_file,
    ) -> i32,
    /// Returns the number of parts; 0 after a failure.
    pub part_count: unsafe extern "C" fn(result: *const gusset_file) -> u32,
    /// Returns the name of part which; NULL if it does not exist.
    pub part_name: unsafe extern "C" fn(result: *const gusset_file, which: u32) -> *const c_char,
    /// Lends the bytes of part which; NULL if it does not exist or is empty.
    pub part_bytes: unsafe extern "C" fn(result: *const gusset_file, which: u32, size: *mut usize) -> *const u8,
    /// Returns the reason of a failure; empty after success.
    pub message: unsafe extern "C" fn(result: *const gusset_file) -> *const c_char,
    /// Frees a result; NULL is allowed.
    pub free: unsafe extern "C" fn(result: *mut gusset_file),
}

/// Type of gusset_files_entry, for dlsym.
pub type gusset_files_entry_fn = Option<unsafe extern "C" fn(host_abi: u32) -> *const gusset_files>;
