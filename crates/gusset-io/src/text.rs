//! Words and numbers in text: reading with the place of each, and writing with the fewest digits.

use crate::error::{Place, ReadError, quoted};
use std::io::{self, Write};

/// Reads words of lines. A comment lasts from its character to the end of the line.
pub(crate) struct Scanner<'a> {
    bytes: &'a [u8],
    place: usize,
    line: u64,
    comment: Option<u8>,
}

impl<'a> Scanner<'a> {
    pub(crate) fn new(bytes: &'a [u8], comment: Option<u8>) -> Self {
        Self { bytes, place: 0, line: 1, comment }
    }

    /// Returns the number of the current line, from 1.
    pub(crate) fn line(&self) -> u64 {
        self.line
    }

    /// Returns the index of the next byte.
    pub(crate) fn place(&self) -> usize {
        self.place
    }

    /// Returns the number of bytes that follow.
    pub(crate) fn remaining(&self) -> usize {
        self.bytes.len() - self.place
    }

    /// Returns the next word of this line, or `None` at its end, which it does not pass.
    pub(crate) fn word_in_line(&mut self) -> Option<&'a [u8]> {
        loop {
            let &byte = self.bytes.get(self.place)?;
            if byte == b'\n' {
                return None;
            }
            if Some(byte) == self.comment {
                self.skip_to_line_end();
                return None;
            }
            if !is_blank(byte) {
                break;
            }
            self.place += 1;
        }
        let rest = &self.bytes[self.place..];
        let length = rest
            .iter()
            .position(|&byte| is_blank(byte) || byte == b'\n' || Some(byte) == self.comment)
            .unwrap_or(rest.len());
        self.place += length;
        Some(&rest[..length])
    }

    /// Returns the next word of the file, or `None` at its end.
    pub(crate) fn word(&mut self) -> Option<&'a [u8]> {
        loop {
            if let Some(word) = self.word_in_line() {
                return Some(word);
            }
            if !self.next_line() {
                return None;
            }
        }
    }

    /// Returns the rest of this line without blanks and comment at its ends.
    pub(crate) fn rest_of_line(&mut self) -> &'a [u8] {
        let start = self.place;
        self.skip_to_line_end();
        let rest = &self.bytes[start..self.place];
        let end = self.comment.and_then(|comment| rest.iter().position(|&byte| byte == comment)).unwrap_or(rest.len());
        rest[..end].trim_ascii()
    }

    /// Goes to the start of the next line. Returns false at the end of the file.
    pub(crate) fn next_line(&mut self) -> bool {
        self.skip_to_line_end();
        if self.place == self.bytes.len() {
            return false;
        }
        self.place += 1;
        self.line += 1;
        true
    }

    fn skip_to_line_end(&mut self) {
        let rest = &self.bytes[self.place..];
        self.place += rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len());
    }

    /// Makes an error at the current line.
    pub(crate) fn error(&self, message: impl Into<String>) -> ReadError {
        ReadError::malformed(Place::Line(self.line), message)
    }

    /// Reads the next word of the file as a number. `element` names what it belongs to: `vertex 2`.
    pub(crate) fn number(&mut self, element: impl Fn() -> String) -> Result<f64, ReadError> {
        let Some(word) = self.word() else {
            return Err(self.error(format!("{}: the file ends before its numbers", element())));
        };
        number(word).ok_or_else(|| self.error(format!("{}: {} is not a number", element(), quoted(word))))
    }
}

fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\r' | 0x0b | 0x0c)
}

/// Returns the number that a word is: decimal, with or without sign and exponent, `nan` or `inf`.
pub(crate) fn number(word: &[u8]) -> Option<f64> {
    fast_float2::parse(word.strip_prefix(b"+").filter(|rest| !rest.starts_with(b"-")).unwrap_or(word)).ok()
}

/// Returns the integer that a word is, with or without sign.
pub(crate) fn integer(word: &[u8]) -> Option<i64> {
    let digits = word.strip_prefix(b"-").or_else(|| word.strip_prefix(b"+")).unwrap_or(word);
    if digits.is_empty() || digits.len() > 18 {
        return None;
    }
    let mut value: i64 = 0;
    for &digit in digits {
        if !digit.is_ascii_digit() {
            return None;
        }
        value = 10 * value + i64::from(digit - b'0');
    }
    Some(if word[0] == b'-' { -value } else { value })
}

/// Writes text and numbers to a buffer that it empties into a file.
pub(crate) struct TextWriter<'a> {
    out: &'a mut dyn Write,
    buffer: Vec<u8>,
}

/// Bytes that a writer holds before it passes them on.
const BUFFER_BYTES: usize = 1 << 16;

impl<'a> TextWriter<'a> {
    pub(crate) fn new(out: &'a mut dyn Write) -> Self {
        Self { out, buffer: Vec::with_capacity(BUFFER_BYTES + 256) }
    }

    /// Appends bytes.
    pub(crate) fn bytes(&mut self, bytes: &[u8]) -> io::Result<()> {
        if self.buffer.len() + bytes.len() > BUFFER_BYTES {
            self.flush_buffer()?;
        }
        if bytes.len() > BUFFER_BYTES {
            return self.out.write_all(bytes);
        }
        self.buffer.extend_from_slice(bytes);
        Ok(())
    }

    /// Appends text.
    pub(crate) fn text(&mut self, text: &str) -> io::Result<()> {
        self.bytes(text.as_bytes())
    }

    /// Appends an integer.
    pub(crate) fn integer(&mut self, value: u64) -> io::Result<()> {
        let mut digits = [0_u8; 20];
        let mut start = digits.len();
        let mut rest = value;
        loop {
            start -= 1;
            digits[start] = b'0' + (rest % 10) as u8;
            rest /= 10;
            if rest == 0 {
                break;
            }
        }
        self.bytes(&digits[start..])
    }

    /// Appends the shortest decimal that reads back as the same number of double precision; `nan` for NaN.
    pub(crate) fn double(&mut self, value: f64) -> io::Result<()> {
        self.decimal(value.is_finite(), value, ryu::Buffer::new().format(value))
    }

    /// Appends the shortest decimal that reads back as the same number of single precision; `nan` for NaN.
    pub(crate) fn single(&mut self, value: f32) -> io::Result<()> {
        self.decimal(value.is_finite(), f64::from(value), ryu::Buffer::new().format(value))
    }

    /// Appends an attribute's number: as [`single`](Self::single) if it has single precision.
    pub(crate) fn attribute(&mut self, value: f64) -> io::Result<()> {
        let rounded = value as f32;
        if f64::from(rounded).to_bits() == value.to_bits() { self.single(rounded) } else { self.double(value) }
    }

    fn decimal(&mut self, is_finite: bool, value: f64, digits: &str) -> io::Result<()> {
        if !is_finite {
            return self.text(if value.is_nan() {
                "nan"
            } else if value > 0.0 {
                "inf"
            } else {
                "-inf"
            });
        }
        self.text(digits.strip_suffix(".0").unwrap_or(digits))
    }

    /// Passes everything on. Must be called last.
    pub(crate) fn finish(mut self) -> io::Result<()> {
        self.flush_buffer()?;
        self.out.flush()
    }

    fn flush_buffer(&mut self) -> io::Result<()> {
        self.out.write_all(&self.buffer)?;
        self.buffer.clear();
        Ok(())
    }
}
