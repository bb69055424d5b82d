//! The functions of the table.

use crate::folder::{Folder, given_bytes};
use crate::table::descriptor::*;
use crate::table::outcome::gusset_file;
use gusset_io::packed::{Packed, pack, unpack};
use gusset_io::{
    Document, Format, Loss, MemoryFile, ReadError, ReadErrorKind, ReadOptions, Target, WriteError, WriteErrorKind,
    WriteOptions,
};
use std::ffi::{CStr, CString, c_char};
use std::io::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr;

/// A status, and the sentence for the user.
struct Refusal {
    status: i32,
    message: String,
}

impl Refusal {
    fn argument(message: impl Into<String>) -> Self {
        Self { status: GUSSET_FILES_BAD_ARGUMENT, message: message.into() }
    }
}

impl From<ReadError> for Refusal {
    fn from(error: ReadError) -> Self {
        let is_full = error.kind == ReadErrorKind::OutOfMemory;
        Self {
            status: if is_full { GUSSET_FILES_OUT_OF_MEMORY } else { GUSSET_FILES_BAD_FILE },
            message: error.to_string(),
        }
    }
}

impl From<WriteError> for Refusal {
    fn from(error: WriteError) -> Self {
        let is_full = error.kind == WriteErrorKind::OutOfMemory;
        Self {
            status: if is_full { GUSSET_FILES_OUT_OF_MEMORY } else { GUSSET_FILES_BAD_FILE },
            message: error.to_string(),
        }
    }
}

/// Names and bytes of a result.
type Parts = Vec<(CString, Vec<u8>)>;

/// Gives the host a result, or the reason of a failure.
///
/// # Safety
/// `result` is NULL or valid for a write.
unsafe fn store_parts_or_refusal(result: *mut *mut gusset_file, body: impl FnOnce() -> Result<Parts, Refusal>) -> i32 {
    if result.is_null() {
        return GUSSET_FILES_BAD_ARGUMENT;
    }
    let outcome = catch_unwind(AssertUnwindSafe(body));
    let outcome = outcome.unwrap_or_else(|_| {
        Err(Refusal { status: GUSSET_FILES_INTERNAL, message: "internal error: please report it with the file".into() })
    });
    let outcome = outcome.and_then(|parts| {
        gusset_base::alloc::check_reserve().map_err(|_| ReadError::out_of_memory())?;
        Ok(parts)
    });
    let (status, made) = match outcome {
        Ok(parts) => (GUSSET_FILES_DONE, gusset_file { parts, message: CString::default() }),
        Err(Refusal { status, message }) => (
            status,
            gusset_file { parts: Vec::new(), message: CString::new(message.replace('\0', " ")).unwrap_or_default() },
        ),
    };
    let made = Box::new(made);
    // Nothing that the host keeps may be in the reserve of memory.
    let (made, status) = match gusset_base::alloc::check_reserve() {
        Ok(()) => (Box::into_raw(made), status),
        Err(_) => (ptr::null_mut(), GUSSET_FILES_OUT_OF_MEMORY),
    };
    // SAFETY: the caller's promise.
    unsafe { result.write(made) };
    status
}

/// # Safety
/// `text` is NULL or a C string.
unsafe fn given_text<'a>(text: *const c_char, name: &str) -> Result<&'a str, Refusal> {
    if text.is_null() {
        return Err(Refusal::argument(format!("{name} is NULL; it must not be")));
    }
    // SAFETY: the caller's promise.
    unsafe { CStr::from_ptr(text) }
        .to_str()
        .map_err(|_| Refusal::argument(format!("{name} is not valid UTF-8; encode it as UTF-8")))
}

fn check_flags(flags: u32, known: u32) -> Result<(), Refusal> {
    if flags & !known == 0 {
        Ok(())
    } else {
        Err(Refusal::argument(format!("flags is {flags}; it must be a sum of the flags of this call, at most {known}")))
    }
}

fn named_format(name: &str) -> Result<Format, Refusal> {
    Format::from_name(name).ok_or_else(|| {
        let known: Vec<String> = Format::ALL.iter().map(|(format, _)| format!(".{}", format.extension())).collect();
        Refusal { status: GUSSET_FILES_BAD_FILE, message: format!("the format is unknown; use {}", known.join(", ")) }
    })
}

/// Implements `read` of the descriptor.
pub(crate) unsafe extern "C" fn read(
    name: *const c_char,
    bytes: *const u8,
    size: usize,
    folder: *const gusset_files_folder,
    flags: u32,
    result: *mut *mut gusset_file,
) -> i32 {
    // SAFETY: the host promises that its arguments are as the descriptor says.
    unsafe {
        store_parts_or_refusal(result, || {
            let format = named_format(given_text(name, "name")?)?;
            let bytes = given_bytes(bytes, size).ok_or_else(|| Refusal::argument("bytes is NULL; it must not be"))?;
            check_flags(flags, GUSSET_FILES_JOINED | GUSSET_FILES_UNMERGED)?;
            let options = ReadOptions { merge_repeated: flags & GUSSET_FILES_UNMERGED == 0, ..ReadOptions::default() };
            let document = gusset_io::read(bytes, format, &Folder::new(folder), &options)?;
            let size = bytes.len() as u64;
            let document =
                if flags & GUSSET_FILES_JOINED != 0 { join_meshes_within_limit(document, size)? } else { document };
            let Packed { description, arrays } = pack(&document)?;
            Ok(vec![(c"document".into(), description.into_bytes()), (c"arrays".into(), arrays)])
        })
    }
}

/// Joins all meshes of a scene. Copies of meshes are limited by the size of the file in bytes.
fn join_meshes_within_limit(document: Document, size: u64) -> Result<Document, ReadError> {
    /// Number of points and corners that the meshes of any scene may have in all their copies.
    const MIN_SCENE_ELEMENTS: u64 = 1 << 22;
    if document.placements.is_empty() { Ok(document) } else { document.into_joined(size.max(MIN_SCENE_ELEMENTS)) }
}

/// Implements `write` of the descriptor.
pub(crate) unsafe extern "C" fn write(
    name: *const c_char,
    document: *const c_char,
    arrays: *const u8,
    size: usize,
    folder: *const gusset_files_folder,
    flags: u32,
    result: *mut *mut gusset_file,
) -> i32 {
    // SAFETY: the host promises that its arguments are as the descriptor says.
    unsafe {
        store_parts_or_refusal(result, || {
            let name = given_text(name, "name")?;
            check_flags(flags, GUSSET_FILES_TEXT | GUSSET_FILES_LOSSY)?;
            let arrays =
                given_bytes(arrays, size).ok_or_else(|| Refusal::argument("arrays is NULL; it must not be"))?;
            let document = unpack(given_text(document, "document")?, arrays)?;
            encode_document(name, &document, &Folder::new(folder), flags)
        })
    }
}

/// Encodes a document in memory, in the format that the name's extension tells. Returns the losses, the file, and the
/// files beside it. `resources` provides the files that the document refers to.
fn encode_document(name: &str, document: &Document, resources: &Folder, flags: u32) -> Result<Parts, Refusal> {
    let format = named_format(name)?;
    let options = WriteOptions {
        text: flags & GUSSET_FILES_TEXT != 0,
        lossy: flags & GUSSET_FILES_LOSSY != 0,
        ..WriteOptions::default()
    };
    let (mut main, mut beside) = (MemoryFile::default(), Parts::new());
    let mut add = |name: &str, bytes: &[u8]| {
        let mut file = MemoryFile::default();
        file.write_all(bytes)?;
        beside.push((CString::new(name).unwrap_or_default(), file.into_bytes()));
        Ok(())
    };
    let stem = name.rsplit('/').next().and_then(|name| name.rsplit_once('.')).map_or("mesh", |(stem, _)| stem);
    let mut target = Target { main_file: &mut main, stem, beside: &mut add, resources };
    let losses = gusset_io::write(document, format, &mut target, &options)?;
    let losses: Vec<String> = losses.into_iter().map(|Loss(what)| what).collect();
    let losses = serde_json::json!(losses).to_string().into_bytes();
    Ok([(c"losses".into(), losses), (c"file".into(), main.into_bytes())].into_iter().chain(beside).collect())
}

unsafe fn part_at<'a>(result: *const gusset_file, which: u32) -> Option<&'a (CString, Vec<u8>)> {
    // SAFETY: the host promises that the result is NULL or alive.
    unsafe { result.as_ref() }?.parts.get(which as usize)
}

pub(crate) unsafe extern "C" fn part_count(result: *const gusset_file) -> u32 {
    // SAFETY: the host promises that the result is NULL or alive.
    unsafe { result.as_ref() }.map_or(0, |result| result.parts.len() as u32)
}

pub(crate) unsafe extern "C" fn part_name(result: *const gusset_file, which: u32) -> *const c_char {
    // SAFETY: as above.
    unsafe { part_at(result, which) }.map_or(ptr::null(), |(name, _)| name.as_ptr())
}

pub(crate) unsafe extern "C" fn part_bytes(result: *const gusset_file, which: u32, size: *mut usize) -> *const u8 {
    // SAFETY: as above; `size` is NULL or valid for a write.
    unsafe {
        let bytes = part_at(result, which).map_or(&[][..], |(_, bytes)| bytes);
        if let Some(size) = size.as_mut() {
            *size = bytes.len();
        }
        if bytes.is_empty() { ptr::null() } else { bytes.as_ptr() }
    }
}

pub(crate) unsafe extern "C" fn message(result: *const gusset_file) -> *const c_char {
    // SAFETY: as above.
    unsafe { result.as_ref() }.map_or(c"out of memory".as_ptr(), |result| result.message.as_ptr())
}

pub(crate) unsafe extern "C" fn free(result: *mut gusset_file) {
    if !result.is_null() {
        // SAFETY: the host promises that the result came from `read` or `write`, and is freed once.
        drop(unsafe { Box::from_raw(result) });
    }
}
