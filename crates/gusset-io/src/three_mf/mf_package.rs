//! The ZIP package: its parts by name, decompressed while they are read, within a limit.

use crate::error::{Place, ReadError, ReadErrorKind};
use crate::foreign_files::refuse_foreign_file;
use crate::text_encoding::lossy_text;
use gusset_base::alloc;
use rawzip::{CompressionMethod, ZipArchive, ZipArchiveEntryWayfinder, ZipSliceArchive};
use std::cell::Cell;
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Read};
use std::rc::Rc;

/// Largest total size of decompressed parts, as a multiple of the file's size. Files of slicers reach 10 to 40.
const MAX_EXPANSION: u64 = 256;

/// Decompressed bytes that every file may have, however small it is.
const MIN_EXPANDED_BYTES: u64 = if cfg!(test) { 20 << 20 } else { 64 << 20 };

/// Longest tag or text in bytes, which is in memory as a whole.
pub(super) const MAX_TOKEN_BYTES: u64 = 4 << 20;

/// An open package.
pub(super) struct Package<'a> {
    archive: ZipSliceArchive<&'a [u8]>,
    /// Parts by their names in small letters without a slash in front.
    parts: BTreeMap<String, (ZipArchiveEntryWayfinder, CompressionMethod)>,
    left_bytes: Rc<Cell<u64>>,
}

/// Returns the name by which a part is found.
pub(super) fn part_key(name: &str) -> String {
    name.trim_start_matches('/').replace('\\', "/").to_ascii_lowercase()
}

impl<'a> Package<'a> {
    pub(super) fn open(bytes: &'a [u8]) -> Result<Self, ReadError> {
        let archive = ZipArchive::from_slice(bytes).map_err(|_| not_a_package(bytes))?;
        let mut parts = BTreeMap::new();
        let mut entries = archive.entries();
        loop {
            match entries.next_entry() {
                Ok(None) => break,
                Ok(Some(entry)) => {
                    let path = entry.file_path();
                    let name = part_key(&lossy_text(path.as_ref())?);
                    alloc::check_reserve()?;
                    parts.entry(name).or_insert((entry.wayfinder(), entry.compression_method()));
                }
                Err(error) => {
                    return Err(ReadError::malformed(Place::Whole, format!("the ZIP directory is damaged: {error}")));
                }
            }
        }
        let left = (bytes.len() as u64).saturating_mul(MAX_EXPANSION).max(MIN_EXPANDED_BYTES);
        Ok(Self { archive, parts, left_bytes: Rc::new(Cell::new(left)) })
    }

    /// Returns the names of all parts.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.parts.keys().map(String::as_str)
    }

    pub(super) fn has(&self, name: &str) -> bool {
        self.parts.contains_key(name)
    }

    /// Opens a part for reading.
    pub(super) fn part(&self, name: &str) -> Result<PartReader<'_>, ReadError> {
        let damaged = |why: String| ReadError::malformed(Place::Whole, format!("the part {name} {why}"));
        let Some((place, method)) = self.parts.get(name) else { return Err(damaged("is missing".into())) };
        let entry = self.archive.get_entry(*place).map_err(|error| damaged(format!("is damaged: {error}")))?;
        let bytes: Box<dyn Read + '_> = match *method {
            CompressionMethod::STORE => Box::new(entry.verifying_reader(entry.data())),
            CompressionMethod::DEFLATE => {
                Box::new(entry.verifying_reader(flate2::bufread::DeflateDecoder::new(entry.data())))
            }
            _ => {
                let message = format!("the part {name} is not compressed by deflate; pack the file again with zip");
                return Err(ReadError::unsupported(message));
            }
        };
        let limits = Limits {
            left_bytes: self.left_bytes.clone(),
            token: Rc::new(Cell::new(MAX_TOKEN_BYTES)),
            reached_limit: Rc::default(),
        };
        let limited = LimitedReader { bytes, limits: limits.clone() };
        Ok(PartReader { name: name.to_owned(), bytes: Box::new(BufReader::with_capacity(1 << 16, limited)), limits })
    }
}

fn not_a_package(bytes: &[u8]) -> ReadError {
    let message = match bytes {
        [] => "the file is empty",
        [b'P', b'K', ..] => "the ZIP package is cut off or damaged: its directory is missing",
        [b'<', b'?' | b'm', ..] => "this is XML; a 3MF file is a ZIP package of it",
        _ => {
            return refuse_foreign_file(bytes).unwrap_or_else(|| {
                ReadError::malformed(Place::Whole, "this is not a 3MF file, which is a ZIP package")
            });
        }
    };
    ReadError::malformed(Place::Whole, message)
}

/// Bytes that a reader of a part may still read.
#[derive(Clone)]
struct Limits {
    left_bytes: Rc<Cell<u64>>,
    token: Rc<Cell<u64>>,
    reached_limit: Rc<Cell<Option<&'static str>>>,
}

/// A part that is being read.
pub(super) struct PartReader<'p> {
    pub(super) name: String,
    bytes: Box<dyn BufRead + 'p>,
    limits: Limits,
}

impl<'p> PartReader<'p> {
    /// Returns the bytes, and the limits for [`next_token`].
    pub(super) fn split(self) -> (Box<dyn BufRead + 'p>, TokenLimit, String) {
        (self.bytes, TokenLimit(self.limits), self.name)
    }

    /// Reads the whole part.
    pub(super) fn read_all(mut self, max_bytes: u64) -> Result<Vec<u8>, ReadError> {
        let mut made = Vec::new();
        self.limits.token.set(u64::MAX);
        let mut bytes = Read::by_ref(&mut self.bytes).take(max_bytes);
        loop {
            let part = match std::io::BufRead::fill_buf(&mut bytes) {
                Ok(part) => part,
                Err(error) if error.kind() == std::io::ErrorKind::Interrupted => continue,
                Err(error) => return Err(TokenLimit(self.limits).error(&self.name, &error.to_string())),
            };
            if part.is_empty() {
                return Ok(made);
            }
            alloc::append(&mut made, part)?;
            let count = part.len();
            std::io::BufRead::consume(&mut bytes, count);
        }
    }
}

/// The limit of the length of a tag or text.
pub(super) struct TokenLimit(Limits);

impl TokenLimit {
    /// Permits another tag or text of the largest length.
    pub(super) fn next_token(&self) {
        self.0.token.set(MAX_TOKEN_BYTES);
    }

    /// Makes the error of a part that could not be read.
    pub(super) fn error(&self, part: &str, why: &str) -> ReadError {
        match self.0.reached_limit.get() {
            Some(limit) => ReadError::new(ReadErrorKind::TooLarge, format!("the part {part} {limit}")),
            None => ReadError::malformed(Place::Whole, format!("the part {part} is damaged: {why}")),
        }
    }
}

struct LimitedReader<'p> {
    bytes: Box<dyn Read + 'p>,
    limits: Limits,
}

impl Read for LimitedReader<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let count = self.bytes.read(buffer)?;
        let limits = &self.limits;
        let (left, token) =
            (limits.left_bytes.get().checked_sub(count as u64), limits.token.get().checked_sub(count as u64));
        let (Some(left), Some(token)) = (left, token) else {
            let message = if left.is_none() {
                "expands to more than 256 times the file's size"
            } else {
                "has a tag or text of more than 4 megabytes"
            };
            limits.reached_limit.set(Some(message));
            return Err(std::io::Error::other(message));
        };
        limits.left_bytes.set(left);
        limits.token.set(token);
        Ok(count)
    }
}
