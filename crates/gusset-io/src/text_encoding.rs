//! Text of unusual encodings as bytes with line feeds.

use crate::error::ReadError;
use std::borrow::Cow;

/// Removes a byte order mark, decodes UTF-16 that has one, and replaces carriage returns if no line feed ends a line. Returns a copy
/// only in the last two cases.
pub(crate) fn decode_text(bytes: &[u8]) -> Result<Cow<'_, [u8]>, ReadError> {
    let text = match bytes {
        [0xef, 0xbb, 0xbf, rest @ ..] => Cow::Borrowed(rest),
        [0xff, 0xfe, rest @ ..] => Cow::Owned(decode_utf16(rest, u16::from_le_bytes)?),
        [0xfe, 0xff, rest @ ..] => Cow::Owned(decode_utf16(rest, u16::from_be_bytes)?),
        _ => Cow::Borrowed(bytes),
    };
    if text.contains(&b'\n') || !text.contains(&b'\r') {
        return Ok(text);
    }
    let mut owned = Vec::new();
    owned.try_reserve_exact(text.len())?;
    owned.extend(text.iter().map(|&byte| if byte == b'\r' { b'\n' } else { byte }));
    Ok(Cow::Owned(owned))
}

fn decode_utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Result<Vec<u8>, ReadError> {
    let units = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]]));
    let mut text = String::new();
    // A unit becomes at most 3 bytes.
    text.try_reserve_exact(bytes.len() / 2 * 3)?;
    text.extend(char::decode_utf16(units).map(|found| found.unwrap_or(char::REPLACEMENT_CHARACTER)));
    Ok(text.into_bytes())
}

/// Decodes UTF-8. Replaces bytes that are not valid.
pub(crate) fn lossy_text(bytes: &[u8]) -> Result<Cow<'_, str>, ReadError> {
    match std::str::from_utf8(bytes) {
        Ok(text) => Ok(Cow::Borrowed(text)),
        Err(_) => owned_text(bytes).map(Cow::Owned),
    }
}

/// Decodes UTF-8 as [`lossy_text`] does, and copies it.
pub(crate) fn owned_text(bytes: &[u8]) -> Result<String, ReadError> {
    let mut made = String::new();
    for part in bytes.utf8_chunks() {
        made.try_reserve(part.valid().len() + char::REPLACEMENT_CHARACTER.len_utf8())?;
        made.push_str(part.valid());
        if !part.invalid().is_empty() {
            made.push(char::REPLACEMENT_CHARACTER);
        }
    }
    Ok(made)
}
