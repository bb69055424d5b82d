//! Group codes and values, on a line each.

use crate::error::{Place, ReadError, quoted};
use crate::text::integer;

/// A group code and its value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pair<'a> {
    pub(super) code: i32,
    pub(super) value: &'a [u8],
}

/// Reads pairs.
#[derive(Clone)]
pub(super) struct PairReader<'a> {
    text: &'a [u8],
    offset: usize,
    line: u64,
}

impl<'a> PairReader<'a> {
    pub(super) fn new(text: &'a [u8]) -> Self {
        Self { text, offset: 0, line: 1 }
    }

    /// Returns the number of the next line, from 1.
    pub(super) fn line(&self) -> u64 {
        self.line
    }

    /// Returns the index of the next byte.
    pub(super) fn place(&self) -> usize {
        self.offset
    }

    fn next_line(&mut self) -> Option<&'a [u8]> {
        let rest = self.text.get(self.offset..).filter(|rest| !rest.is_empty())?;
        let length = rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len());
        self.offset += length + 1;
        self.line += 1;
        Some(rest[..length].trim_ascii())
    }

    /// Returns the next pair, or `None` at the end of the file.
    pub(super) fn next(&mut self) -> Result<Option<Pair<'a>>, ReadError> {
        let Some(word) = self.next_line() else { return Ok(None) };
        if word.is_empty() && self.text[self.offset.min(self.text.len())..].trim_ascii().is_empty() {
            return Ok(None);
        }
        let code = integer(word).and_then(|code| i32::try_from(code).ok());
        let Some(code) = code else {
            let message = format!("{} is not a group code", quoted(word));
            return Err(ReadError::malformed(Place::Line(self.line - 1), message));
        };
        let value = self.next_line().unwrap_or(&[]);
        Ok(Some(Pair { code, value }))
    }
}
