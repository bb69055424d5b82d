//! Words and numbers in text: reading with the place of each, and writing with the fewest digits.

use crate::error::{Place, ReadError, quoted};
use std::io::{self, Write};

/// Reads words of lines. A comment lasts from its character to the end of the line.
pub(crate) struct Scanner<'a> {
    bytes: &'a [u8],
    offset: usize,
    line: u64,
    comment: Option<u8>,
}

impl<'a> Scanner<'a> {
    pub(crate) fn new(bytes: &'a [u8], comment: Option<u8>) -> Self {
        Self { bytes, offset: 0, line: 1, comment }
    }

    /// Starts within a file: at a byte and the line that it is in.
    pub(crate) fn new_at(bytes: &'a [u8], place: usize, line: u64, comment: Option<u8>) -> Self {
        Self { bytes, offset: place.min(bytes.len()), line, comment }
    }

    /// Returns the number of the current line, from 1.
    pub(crate) fn line(&self) -> u64 {
        self.line
    }

    /// Returns the index of the next byte.
    pub(crate) fn place(&self) -> usize {
        self.offset
    }

    /// Returns the number of bytes that follow.
    pub(crate) fn remaining(&self) -> usize {
        self.bytes.len() - self.offset
    }

    /// Returns the next word of this line, or `None` at its end, which it does not pass.
    pub(crate) fn word_in_line(&mut self) -> Option<&'a [u8]> {
        loop {
            let &byte = self.bytes.get(self.offset)?;
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
            self.offset += 1;
        }
        let rest = &self.bytes[self.offset..];
        let length = rest
            .iter()
            .position(|&byte| is_blank(byte) || byte == b'\n' || Some(byte) == self.comment)
            .unwrap_or(rest.len());
        self.offset += length;
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
        let start = self.offset;
        self.skip_to_line_end();
        let rest = &self.bytes[start..self.offset];
        let end = self.comment.and_then(|comment| rest.iter().position(|&byte| byte == comment)).unwrap_or(rest.len());
        rest[..end].trim_ascii()
    }

    /// Goes to the start of the next line. Returns false at the end of the file.
    pub(crate) fn next_line(&mut self) -> bool {
        self.skip_to_line_end();
        if self.offset == self.bytes.len() {
            return false;
        }
        self.offset += 1;
        self.line += 1;
        true
    }

    fn skip_to_line_end(&mut self) {
        let rest = &self.bytes[self.offset..];
        self.offset += rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len());
    }

    /// Passes blanks, comments and ends of lines. Returns whether a word follows.
    fn seek_word(&mut self) -> bool {
        while let Some(&byte) = self.bytes.get(self.offset) {
            if byte == b'\n' {
                self.line += 1;
            } else if Some(byte) == self.comment {
                self.skip_to_line_end();
                continue;
            } else if !is_blank(byte) {
                return true;
            }
            self.offset += 1;
        }
        false
    }

    /// Returns whether no byte of a word follows.
    fn is_word_end(&self, place: usize) -> bool {
        self.bytes.get(place).is_none_or(|&byte| is_blank(byte) || byte == b'\n' || Some(byte) == self.comment)
    }

    /// Reads the next word of the file as a number. If it is not a number, or the file ends, returns `None` before that word.
    #[inline]
    pub(crate) fn next_number<T: fast_float2::FastFloat>(&mut self) -> Option<T> {
        if !self.seek_word() {
            return None;
        }
        if let Ok((value, length)) = fast_float2::parse_partial(&self.bytes[self.offset..])
            && self.is_word_end(self.offset + length)
        {
            self.offset += length;
            return Some(value);
        }
        let [place, line] = [self.offset as u64, self.line];
        let value = self.word().and_then(parsed);
        if value.is_none() {
            self.offset = place as usize;
            self.line = line;
        }
        value
    }

    /// Reads the next word of the file as an integer of at most 9 digits without sign. If it is anything else, or the file ends,
    /// returns `None` before that word.
    #[inline]
    pub(crate) fn next_index(&mut self) -> Option<u32> {
        const MAX_DIGITS: usize = 9;
        if !self.seek_word() {
            return None;
        }
        let mut value = 0;
        let mut length = 0;
        while let Some(digit) = self.bytes.get(self.offset + length).filter(|byte| byte.is_ascii_digit()) {
            if length == MAX_DIGITS {
                return None;
            }
            value = 10 * value + u32::from(digit - b'0');
            length += 1;
        }
        if length == 0 || !self.is_word_end(self.offset + length) {
            return None;
        }
        self.offset += length;
        Some(value)
    }

    /// Makes an error at the current line.
    pub(crate) fn error(&self, message: impl Into<String>) -> ReadError {
        ReadError::malformed(Place::Line(self.line), message)
    }

    /// Reads the next word of the file as a number. `element` names what it belongs to: `vertex 2`.
    pub(crate) fn number(&mut self, element: impl Fn() -> String) -> Result<f64, ReadError> {
        if let Some(value) = self.next_number() {
            return Ok(value);
        }
        Err(match self.word() {
            Some(word) => self.error(format!("{}: {} is not a number", element(), quoted(word))),
            None => self.error(format!("{}: the file ends before its numbers", element())),
        })
    }
}

fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\r' | 0x0b | 0x0c)
}

/// Returns the number that a word is: decimal, with or without sign and exponent, `nan` or `inf`.
pub(crate) fn number(word: &[u8]) -> Option<f64> {
    parsed(word)
}

fn parsed<T: fast_float2::FastFloat>(word: &[u8]) -> Option<T> {
    let unsigned = word.strip_prefix(b"+").filter(|rest| !rest.starts_with(b"-")).unwrap_or(word);
    fast_float2::parse(unsigned).or_else(|error| microsoft_word(unsigned).map_or(Err(error), fast_float2::parse)).ok()
}

/// Returns the usual word for what Microsoft's C library writes for NaN and infinity: `-nan(ind)`, `1.#QNAN`, `-1.#INF`.
fn microsoft_word(word: &[u8]) -> Option<&'static str> {
    const MAX_LENGTH: usize = 16;
    let lower = word.get(..word.len().min(MAX_LENGTH))?.to_ascii_lowercase();
    let unsigned = lower.strip_prefix(b"-").unwrap_or(&lower);
    match unsigned.strip_prefix(b"1.#") {
        Some(rest) if rest.starts_with(b"inf") => Some(if lower[0] == b'-' { "-inf" } else { "inf" }),
        Some(rest) if rest.starts_with(b"ind") || rest.starts_with(b"qnan") || rest.starts_with(b"snan") => Some("nan"),
        None if unsigned.starts_with(b"nan(") => Some("nan"),
        _ => None,
    }
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

/// Largest number of digits of an integer of 64 bits.
const MAX_DIGITS: usize = 20;

/// `00` to `99`.
const PAIRS_OF_DIGITS: [[u8; 2]; 100] = {
    let mut pairs = [[b'0'; 2]; 100];
    let mut number = 0;
    while number < 100 {
        pairs[number] = [b'0' + (number / 10) as u8, b'0' + (number % 10) as u8];
        number += 1;
    }
    pairs
};

/// Bytes that a writer holds before it passes them on.
const BUFFER_BYTES: usize = 1 << 16;

impl<'a> TextWriter<'a> {
    pub(crate) fn new(out: &'a mut dyn Write) -> io::Result<Self> {
        let mut buffer = Vec::new();
        buffer.try_reserve_exact(BUFFER_BYTES + 256).map_err(|_| io::ErrorKind::OutOfMemory)?;
        Ok(Self { out, buffer })
    }

    /// Appends bytes.
    #[inline]
    pub(crate) fn bytes(&mut self, bytes: &[u8]) -> io::Result<()> {
        if self.buffer.len() + bytes.len() > BUFFER_BYTES {
            return self.bytes_beyond_buffer(bytes);
        }
        self.buffer.extend_from_slice(bytes);
        Ok(())
    }

    #[cold]
    fn bytes_beyond_buffer(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.flush_buffer()?;
        if bytes.len() > BUFFER_BYTES {
            return self.out.write_all(bytes);
        }
        self.buffer.extend_from_slice(bytes);
        Ok(())
    }

    /// Appends text.
    #[inline]
    pub(crate) fn text(&mut self, text: &str) -> io::Result<()> {
        self.bytes(text.as_bytes())
    }

    /// Appends an integer.
    #[inline]
    pub(crate) fn integer(&mut self, value: u64) -> io::Result<()> {
        if self.buffer.len() + MAX_DIGITS > BUFFER_BYTES {
            self.flush_buffer()?;
        }
        let mut digits = [b'0'; 2 * MAX_DIGITS];
        let mut start = MAX_DIGITS;
        let mut rest = value;
        while rest > u64::from(u32::MAX) {
            start -= 2;
            digits[start..start + 2].copy_from_slice(&PAIRS_OF_DIGITS[(rest % 100) as usize]);
            rest /= 100;
        }
        // Divisions of 32 bits are faster.
        let mut rest = rest as u32;
        while rest >= 10 {
            start -= 2;
            digits[start..start + 2].copy_from_slice(&PAIRS_OF_DIGITS[(rest % 100) as usize]);
            rest /= 100;
        }
        if rest > 0 || start == MAX_DIGITS {
            start -= 1;
            digits[start] = b'0' + rest as u8;
        }
        // A copy of constant length is several times as fast as one of a few bytes.
        let end = self.buffer.len() + MAX_DIGITS - start;
        if let Some(digits) = digits[start..].first_chunk::<MAX_DIGITS>() {
            self.buffer.extend_from_slice(digits);
        }
        self.buffer.truncate(end);
        Ok(())
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
        self.bytes(digits.strip_suffix(".0").unwrap_or(digits).as_bytes())
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
