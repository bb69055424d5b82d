//! Errors, notes and losses, with the place that they are about.

use std::fmt;

/// Where in a file something is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Place {
    /// The whole file.
    #[default]
    Whole,
    /// A line, from 1.
    Line(u64),
    /// A byte, from 0.
    Byte(u64),
}

/// Kinds of errors of readers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReadErrorKind {
    /// The bytes are not a file of this format, or contradict themselves.
    Malformed,
    /// The file needs a feature that the reader lacks.
    Unsupported,
    /// The file, or a file that it refers to, cannot be opened.
    Unreadable,
    /// The content exceeds a limit of the reader or the model.
    TooLarge,
    /// Memory ran out.
    OutOfMemory,
}

/// Why a file was not read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReadError {
    /// Kind.
    pub kind: ReadErrorKind,
    /// Line or byte.
    pub place: Place,
    /// Names the element, the value and the remedy, without control characters.
    pub message: String,
}

impl ReadError {
    /// Makes an error about the whole file. Control characters in the message are replaced.
    #[must_use]
    pub fn new(kind: ReadErrorKind, message: impl Into<String>) -> Self {
        Self { kind, place: Place::Whole, message: printable(&message.into()) }
    }

    /// Makes an error about bytes that are not of this format.
    #[must_use]
    pub fn malformed(place: Place, message: impl Into<String>) -> Self {
        Self { place, ..Self::new(ReadErrorKind::Malformed, message) }
    }

    /// Makes an error about a feature that the reader lacks.
    #[must_use]
    pub fn unsupported(message: impl Into<String>) -> Self {
        Self::new(ReadErrorKind::Unsupported, message)
    }

    /// Makes the error of a refused allocation.
    #[must_use]
    pub fn out_of_memory() -> Self {
        Self::new(ReadErrorKind::OutOfMemory, "out of memory")
    }
}

impl From<std::collections::TryReserveError> for ReadError {
    fn from(_: std::collections::TryReserveError) -> Self {
        Self::out_of_memory()
    }
}

/// The error of a refused allocation, which is the only one that readers and writers take from there.
impl From<gusset_base::Error> for ReadError {
    fn from(_: gusset_base::Error) -> Self {
        Self::out_of_memory()
    }
}

/// Writes `4: message` for line 4, `byte 80: message`, or the message.
impl fmt::Display for ReadError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.place {
            Place::Whole => out.write_str(&self.message),
            Place::Line(line) => write!(out, "{line}: {}", self.message),
            Place::Byte(byte) => write!(out, "byte {byte}: {}", self.message),
        }
    }
}

impl std::error::Error for ReadError {}

/// A deviation from the format that the reader accepted, or content that it left out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// Where it was first.
    pub place: Place,
    /// A sentence without a full stop, without control characters: `1 byte follows the last facet and is ignored`.
    pub text: String,
}

impl Note {
    /// Makes a note. Control characters in the text are replaced.
    #[must_use]
    pub fn new(place: Place, text: impl Into<String>) -> Self {
        Self { place, text: printable(&text.into()) }
    }
}

/// Content that the written format cannot hold: `materials, which PLY files do not hold`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Loss(pub String);

/// Kinds of errors of writers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WriteErrorKind {
    /// The format cannot hold the content.
    Unsupported,
    /// The format would move points by more than a thousandth of the mean edge; `WriteOptions::lossy` permits it.
    Lossy,
    /// The file cannot be written.
    Unwritable,
    /// Memory ran out.
    OutOfMemory,
}

/// Why a file was not written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WriteError {
    /// Kind.
    pub kind: WriteErrorKind,
    /// Names the value and the remedy, without control characters.
    pub message: String,
}

impl WriteError {
    /// Makes an error. Control characters in the message are replaced.
    #[must_use]
    pub fn new(kind: WriteErrorKind, message: impl Into<String>) -> Self {
        Self { kind, message: printable(&message.into()) }
    }
}

impl fmt::Display for WriteError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.message)
    }
}

impl std::error::Error for WriteError {}

impl From<std::io::Error> for WriteError {
    fn from(error: std::io::Error) -> Self {
        let kind = match error.kind() {
            std::io::ErrorKind::OutOfMemory => WriteErrorKind::OutOfMemory,
            std::io::ErrorKind::Unsupported => WriteErrorKind::Unsupported,
            _ => WriteErrorKind::Unwritable,
        };
        Self::new(kind, write_reason(&error))
    }
}

/// Returns why a file cannot be written.
pub(crate) fn write_reason(error: &std::io::Error) -> String {
    use std::io::ErrorKind;
    match error.kind() {
        ErrorKind::NotFound => "the folder does not exist".into(),
        ErrorKind::PermissionDenied => "permission denied".into(),
        ErrorKind::ReadOnlyFilesystem => "the file system is read-only".into(),
        ErrorKind::StorageFull => "no space is left on the disk".into(),
        ErrorKind::OutOfMemory => "out of memory".into(),
        _ => error.to_string(),
    }
}

/// The error of a step that readers and writers share.
impl From<ReadError> for WriteError {
    fn from(error: ReadError) -> Self {
        let is_full = error.kind == ReadErrorKind::OutOfMemory;
        Self::new(if is_full { WriteErrorKind::OutOfMemory } else { WriteErrorKind::Unsupported }, error.message)
    }
}

impl From<gusset_base::Error> for WriteError {
    fn from(_: gusset_base::Error) -> Self {
        Self::new(WriteErrorKind::OutOfMemory, "out of memory")
    }
}

impl From<std::collections::TryReserveError> for WriteError {
    fn from(_: std::collections::TryReserveError) -> Self {
        Self::new(WriteErrorKind::OutOfMemory, "out of memory")
    }
}

/// Longest text of a message.
const MAX_CHARACTERS: usize = 400;

/// Replaces control characters, and shortens texts of more than 400 characters.
#[must_use]
pub fn printable(text: &str) -> String {
    let mut made: String = text
        .chars()
        .take(MAX_CHARACTERS)
        .map(|c| if c.is_control() || is_direction_mark(c) { '\u{fffd}' } else { c })
        .collect();
    if text.chars().nth(MAX_CHARACTERS).is_some() {
        made.push_str("...");
    }
    made
}

/// Decodes UTF-8 and shortens it as [`printable`] does.
pub(crate) fn printable_bytes(text: &[u8]) -> String {
    const MAX_BYTES: usize = 4 * MAX_CHARACTERS + 4;
    printable(String::from_utf8_lossy(&text[..text.len().min(MAX_BYTES)]).trim())
}

/// Characters that make a terminal show text in another order.
fn is_direction_mark(c: char) -> bool {
    matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// Shortens a word of a file for a message.
pub(crate) fn quoted(word: &[u8]) -> String {
    const MAX_BYTES: usize = 40;
    let shown = String::from_utf8_lossy(&word[..word.len().min(MAX_BYTES)]);
    printable(&format!("\"{shown}{}\"", if word.len() > MAX_BYTES { "..." } else { "" }))
}
