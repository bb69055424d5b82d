//! The container of binary glTF: a header of 12 bytes, and chunks of JSON text and of numbers.

use crate::error::{Note, Place, ReadError};
use crate::foreign_files::refuse_foreign_file;
use crate::text::Scanner;

/// JSON text and binary chunk of a file.
pub(super) struct Parts<'a> {
    pub(super) json: &'a [u8],
    /// Place of the JSON text in the file; `None` if the file is text.
    pub(super) json_offset: Option<usize>,
    pub(super) binary: Option<&'a [u8]>,
}

impl Parts<'_> {
    /// Returns the place of a byte of the JSON text, as a line if the file is text.
    pub(super) fn place(&self, offset: usize) -> Place {
        match self.json_offset {
            Some(start) => Place::Byte((start + offset) as u64),
            None => {
                let mut scanner = Scanner::new(&self.json[..offset.min(self.json.len())], None);
                while scanner.next_line() {}
                Place::Line(scanner.line())
            }
        }
    }
}

const HEADER_BYTES: usize = 12;
const CHUNK_HEADER_BYTES: usize = 8;
const JSON_CHUNK: u32 = 0x4E4F_534A;
const BINARY_CHUNK: u32 = 0x004E_4942;

fn word(bytes: &[u8], place: usize) -> Option<u32> {
    Some(u32::from_le_bytes(bytes.get(place..place + 4)?.try_into().ok()?))
}

/// Splits a file of either kind, which its first bytes tell.
pub(super) fn split_file<'a>(bytes: &'a [u8], notes: &mut Vec<Note>) -> Result<Parts<'a>, ReadError> {
    if !bytes.starts_with(b"glTF") {
        return Ok(Parts { json: text_part(bytes)?, json_offset: None, binary: None });
    }
    match word(bytes, 4) {
        Some(2) => split_glb(bytes, notes),
        Some(1) => Err(ReadError::unsupported(OLD_VERSION)),
        Some(version) => {
            Err(ReadError::unsupported(format!("this is binary glTF of version {version}; version 2 is read")))
        }
        None => {
            Err(ReadError::malformed(Place::Byte(bytes.len() as u64), "the file ends in the header of binary glTF"))
        }
    }
}

pub(super) const OLD_VERSION: &str = "this is glTF 1.0; convert it to version 2 with gltf-pipeline";

/// Returns the JSON text without a byte order mark.
fn text_part(bytes: &[u8]) -> Result<&[u8], ReadError> {
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let first = text.iter().find(|byte| !byte.is_ascii_whitespace());
    if first == Some(&b'{') {
        return Ok(text);
    }
    if let Some(error) = refuse_foreign_file(bytes) {
        return Err(error);
    }
    let message = match bytes {
        [] => "the file is empty",
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => "the text is UTF-16; convert it to UTF-8 with iconv",
        [b'D', b'R', b'A', b'C', b'O', ..] => "this is a Draco file; decode it with draco_decoder",
        _ => "this is neither a glTF file, which begins with {, nor a binary one, which begins with glTF",
    };
    Err(ReadError::malformed(Place::Whole, message))
}

fn split_glb<'a>(bytes: &'a [u8], notes: &mut Vec<Note>) -> Result<Parts<'a>, ReadError> {
    let told = word(bytes, 8).unwrap_or(0) as usize;
    if told != bytes.len() {
        let text = format!("the header tells {told} bytes, and the file has {}", bytes.len());
        notes.push(Note::new(Place::Byte(8), text));
    }
    let mut parts = Parts { json: &[], json_offset: None, binary: None };
    let mut place = HEADER_BYTES;
    while let (Some(length), Some(kind)) = (word(bytes, place), word(bytes, place + 4)) {
        let start = place + CHUNK_HEADER_BYTES;
        let rest = &bytes[start..];
        let chunk = &rest[..rest.len().min(length as usize)];
        if chunk.len() < length as usize {
            let text = format!("a chunk of {length} bytes ends after {}", chunk.len());
            if kind == JSON_CHUNK {
                return Err(ReadError::malformed(Place::Byte(place as u64), text));
            }
            notes.push(Note::new(Place::Byte(place as u64), text));
        }
        if kind == JSON_CHUNK && parts.json_offset.is_none() {
            (parts.json, parts.json_offset) = (chunk, Some(start));
        } else if kind == BINARY_CHUNK && parts.binary.is_none() {
            parts.binary = Some(chunk);
        }
        place = start + chunk.len();
    }
    if parts.json_offset.is_none() {
        return Err(ReadError::malformed(Place::Byte(HEADER_BYTES as u64), "the JSON chunk is missing"));
    }
    Ok(parts)
}
