//! JSON without recursion: a flat list of values, each of which knows where its text is and where the next value begins.
//!
//! A general JSON tree takes up to 80 times the text's size, and most parsers recurse. A value takes 12 bytes here, and depth is
//! unlimited. Materials need the text of their values anyway.

use crate::error::ReadError;
use crate::text_encoding::{lossy_text, owned_text};
use gusset_base::alloc;
use std::borrow::Cow;
use std::cell::Cell;

/// A value or a key. Its subtree lies between it and `entry_after_subtree`.
struct Entry {
    /// First byte of the text.
    start: u32,
    /// Byte after the text.
    end: u32,
    /// Index of the entry after the subtree. While a container is open: index of the container around it.
    entry_after_subtree: u32,
}

/// Message of [`JsonError`] if memory ran out.
pub(crate) const OUT_OF_MEMORY: &str = "out of memory";

/// The container around the outermost one.
const NO_PARENT: u32 = u32::MAX;

/// A parsed JSON text.
pub(crate) struct Tape<'a> {
    text: &'a [u8],
    entries: Vec<Entry>,
    /// Whether commas precede closing brackets.
    pub(crate) has_trailing_commas: bool,
    /// Whether other text follows the value.
    pub(crate) has_text_after_value: bool,
    /// Whether a text was not decoded because memory ran out.
    pub(crate) is_out_of_memory: Cell<bool>,
}

/// Why a text is not JSON.
pub(crate) struct JsonError {
    /// Byte in the text.
    pub(crate) offset: usize,
    pub(crate) message: &'static str,
}

/// Expectation of the parser.
#[derive(Clone, Copy, PartialEq)]
enum Expected {
    /// A key or the end of the object.
    Key,
    /// A value or the end of the array.
    Item,
    /// The value of a key, or the outermost value.
    Value,
    /// A comma or the end of the container.
    Separator,
}

impl<'a> Tape<'a> {
    /// Parses a text. Accepts a comma before a closing bracket, and text after the value.
    pub(crate) fn parse(text: &'a [u8]) -> Result<Self, JsonError> {
        if text.len() >= u32::MAX as usize {
            return Err(JsonError { offset: 0, message: "the JSON text exceeds 4 gigabytes" });
        }
        // Each entry except the first follows one of these bytes. Exact room keeps the peak low.
        let count = text.iter().filter(|byte| matches!(byte, b'[' | b'{' | b',' | b':')).count() + 1;
        let mut entries = Vec::new();
        if entries.try_reserve_exact(count).is_err() {
            return Err(JsonError { offset: 0, message: OUT_OF_MEMORY });
        }
        let mut parser = Parser {
            tape: Self {
                text,
                entries,
                has_trailing_commas: false,
                has_text_after_value: false,
                is_out_of_memory: Cell::default(),
            },
            offset: 0,
            open_container: NO_PARENT,
            after_comma: false,
        };
        let mut expected = Expected::Value;
        loop {
            parser.skip_blanks();
            if expected == Expected::Separator && parser.open_container == NO_PARENT {
                break;
            }
            expected = parser.parse_next_token(expected)?;
        }
        parser.tape.has_text_after_value = text[parser.offset..].iter().any(|&byte| byte != 0);
        Ok(parser.tape)
    }

    /// Returns the memory of all values in bytes.
    pub(crate) fn bytes(&self) -> u64 {
        (self.entries.capacity() * size_of::<Entry>()) as u64
    }

    /// Fails if a text was not decoded because memory ran out.
    pub(crate) fn check_memory(&self) -> Result<(), ReadError> {
        if self.is_out_of_memory.get() { Err(ReadError::out_of_memory()) } else { Ok(alloc::check_reserve()?) }
    }

    /// Returns the outermost value.
    pub(crate) fn root(&self) -> Value<'_> {
        Value { tape: self, index: 0 }
    }
}

struct Parser<'a> {
    tape: Tape<'a>,
    offset: usize,
    open_container: u32,
    after_comma: bool,
}

impl Parser<'_> {
    fn error(&self, message: &'static str) -> JsonError {
        JsonError { offset: self.offset.min(self.tape.text.len()), message }
    }

    fn skip_blanks(&mut self) {
        let rest = &self.tape.text[self.offset..];
        self.offset += rest.iter().position(|byte| !byte.is_ascii_whitespace()).unwrap_or(rest.len());
    }

    fn push(&mut self, start: usize, end: usize) -> u32 {
        let index = self.tape.entries.len() as u32;
        self.tape.entries.push(Entry { start: start as u32, end: end as u32, entry_after_subtree: index + 1 });
        index
    }

    fn is_in_object(&self) -> bool {
        self.tape
            .entries
            .get(self.open_container as usize)
            .is_some_and(|entry| self.tape.text[entry.start as usize] == b'{')
    }

    /// Returns what follows a comma or an opening bracket.
    fn expected_inside(&self) -> Expected {
        if self.is_in_object() { Expected::Key } else { Expected::Item }
    }

    /// Reads one token.
    fn parse_next_token(&mut self, expected: Expected) -> Result<Expected, JsonError> {
        let Some(&byte) = self.tape.text.get(self.offset) else {
            return Err(self.error("the JSON text ends too early"));
        };
        match (byte, expected) {
            (b'}' | b']', Expected::Key | Expected::Item | Expected::Separator) => self.close_container(byte),
            (b',', Expected::Separator) => {
                self.offset += 1;
                self.after_comma = true;
                Ok(self.expected_inside())
            }
            (_, Expected::Separator) => Err(self.error("a comma or a closing bracket is missing")),
            (b'"', Expected::Key) => {
                self.parse_string()?;
                self.skip_blanks();
                if self.tape.text.get(self.offset) != Some(&b':') {
                    return Err(self.error("a colon is missing"));
                }
                self.offset += 1;
                Ok(Expected::Value)
            }
            (_, Expected::Key) => Err(self.error("a name in quotation marks is missing")),
            (b'{' | b'[', _) => {
                let index = self.push(self.offset, self.offset);
                self.tape.entries[index as usize].entry_after_subtree = self.open_container;
                self.open_container = index;
                self.offset += 1;
                self.after_comma = false;
                Ok(self.expected_inside())
            }
            (b'"', _) => self.parse_string(),
            _ => self.parse_literal(),
        }
    }

    fn close_container(&mut self, byte: u8) -> Result<Expected, JsonError> {
        if self.open_container == NO_PARENT || self.is_in_object() != (byte == b'}') {
            return Err(self.error("a closing bracket does not fit"));
        }
        self.tape.has_trailing_commas |= self.after_comma;
        self.after_comma = false;
        self.offset += 1;
        let next = self.tape.entries.len() as u32;
        let entry = &mut self.tape.entries[self.open_container as usize];
        self.open_container = entry.entry_after_subtree;
        entry.entry_after_subtree = next;
        entry.end = self.offset as u32;
        Ok(Expected::Separator)
    }

    fn parse_string(&mut self) -> Result<Expected, JsonError> {
        let start = self.offset;
        let mut place = start + 1;
        loop {
            match self.tape.text.get(place) {
                None => return Err(self.error("a text lacks its closing quotation mark")),
                Some(b'"') => break,
                Some(b'\\') => place += 2,
                Some(_) => place += 1,
            }
        }
        self.offset = place + 1;
        self.push(start, self.offset);
        self.after_comma = false;
        Ok(Expected::Separator)
    }

    fn parse_literal(&mut self) -> Result<Expected, JsonError> {
        let rest = &self.tape.text[self.offset..];
        let length = rest
            .iter()
            .position(|byte| !byte.is_ascii_alphanumeric() && !matches!(byte, b'+' | b'-' | b'.'))
            .unwrap_or(rest.len());
        let word = &rest[..length];
        let is_known = matches!(word, b"true" | b"false" | b"null") || crate::text::number(word).is_some();
        if !is_known {
            return Err(self.error("a value is neither a number nor a text, list, object, true, false or null"));
        }
        self.push(self.offset, self.offset + length);
        self.offset += length;
        self.after_comma = false;
        Ok(Expected::Separator)
    }
}

/// A value of a parsed text.
#[derive(Clone, Copy)]
pub(crate) struct Value<'t> {
    tape: &'t Tape<'t>,
    index: u32,
}

impl<'t> Value<'t> {
    fn entry(self) -> &'t Entry {
        &self.tape.entries[self.index as usize]
    }

    /// Returns the bytes of the value in the text.
    pub(crate) fn raw_text(self) -> &'t [u8] {
        let entry = self.entry();
        &self.tape.text[entry.start as usize..entry.end as usize]
    }

    fn first_byte(self) -> u8 {
        self.tape.text[self.entry().start as usize]
    }

    pub(crate) fn is_object(self) -> bool {
        self.first_byte() == b'{'
    }

    pub(crate) fn is_array(self) -> bool {
        self.first_byte() == b'['
    }

    pub(crate) fn is_text(self) -> bool {
        self.first_byte() == b'"'
    }

    /// Iterates over the values of an array; over nothing if this is not an array.
    pub(crate) fn items(self) -> impl Iterator<Item = Value<'t>> {
        let end = if self.is_array() { self.entry().entry_after_subtree } else { self.index + 1 };
        let mut index = self.index + 1;
        std::iter::from_fn(move || {
            let item = (index < end).then_some(Value { tape: self.tape, index })?;
            index = item.entry().entry_after_subtree;
            Some(item)
        })
    }

    /// Iterates over the names and values of an object; over nothing if this is not an object.
    pub(crate) fn members(self) -> impl Iterator<Item = (Value<'t>, Value<'t>)> {
        let end = if self.is_object() { self.entry().entry_after_subtree } else { self.index + 1 };
        let mut index = self.index + 1;
        std::iter::from_fn(move || {
            let key = (index < end).then_some(Value { tape: self.tape, index })?;
            let value = Value { tape: self.tape, index: index + 1 };
            index = value.entry().entry_after_subtree;
            Some((key, value))
        })
    }

    /// Lists the items of an array in an object; nothing if it is absent.
    pub(crate) fn list(self, name: &str) -> Result<Vec<Value<'t>>, ReadError> {
        Ok(alloc::gather(self.get(name).into_iter().flat_map(Value::items))?)
    }

    /// Returns the value of a name in an object. `null` counts as absent.
    pub(crate) fn get(self, name: &str) -> Option<Value<'t>> {
        self.members()
            .find(|(key, _)| key.equals_text(name))
            .map(|(_, value)| value)
            .filter(|value| value.raw_text() != b"null")
    }

    /// Returns whether this is a text of these characters.
    pub(crate) fn equals_text(self, text: &str) -> bool {
        let raw = self.raw_text();
        if raw.contains(&b'\\') {
            self.text().is_some_and(|own| own == text)
        } else {
            self.text_between_quotes() == text.as_bytes()
        }
    }

    /// Returns the bytes between the quotation marks.
    fn text_between_quotes(self) -> &'t [u8] {
        let raw = self.raw_text();
        if raw.len() >= 2 && raw[0] == b'"' { &raw[1..raw.len() - 1] } else { &[] }
    }

    /// Returns the text that this is. If memory runs out, returns `None` and marks the tape.
    pub(crate) fn text(self) -> Option<Cow<'t, str>> {
        let inner = self.text_between_quotes();
        let decoded = if inner.contains(&b'\\') { unescaped(inner).map(Cow::Owned) } else { lossy_text(inner) };
        self.tape.is_out_of_memory.set(self.tape.is_out_of_memory.get() | decoded.is_err());
        decoded.ok().filter(|_| self.is_text())
    }

    /// Returns the number that this is.
    pub(crate) fn number(self) -> Option<f64> {
        let raw = self.raw_text();
        matches!(raw.first(), Some(b'0'..=b'9' | b'-' | b'+' | b'.')).then(|| crate::text::number(raw))?
    }

    /// Returns the whole number that this is, if it is at least 0 and below 2^53.
    pub(crate) fn whole_number(self) -> Option<u64> {
        let raw = self.raw_text();
        if raw.len() <= 15 && raw.iter().all(u8::is_ascii_digit) {
            return Some(raw.iter().fold(0, |value, digit| 10 * value + u64::from(digit - b'0')));
        }
        let number = self.number()?;
        (number >= 0.0 && number < (1_u64 << 53) as f64 && number.fract() == 0.0).then_some(number as u64)
    }

    pub(crate) fn is_true(self) -> bool {
        self.raw_text() == b"true"
    }

    /// Returns the `N` numbers of an array of this length.
    pub(crate) fn numbers<const N: usize>(self) -> Option<[f64; N]> {
        let mut made = [0.0; N];
        let mut count = 0;
        for item in self.items() {
            *made.get_mut(count)? = item.number()?;
            count += 1;
        }
        (count == N).then_some(made)
    }
}

/// Resolves backslashes.
fn unescaped(bytes: &[u8]) -> Result<String, ReadError> {
    let mut made: Vec<u8> = alloc::with_capacity(bytes.len())?;
    let mut place = 0;
    while let Some(&byte) = bytes.get(place) {
        place += 1;
        if byte != b'\\' {
            made.push(byte);
            continue;
        }
        let Some(&code) = bytes.get(place) else { break };
        place += 1;
        let replacement = match code {
            b'b' => '\u{8}',
            b'f' => '\u{c}',
            b'n' => '\n',
            b'r' => '\r',
            b't' => '\t',
            b'u' => unicode_escape(bytes, &mut place),
            other => char::from(other),
        };
        made.extend_from_slice(replacement.encode_utf8(&mut [0; 4]).as_bytes());
    }
    String::from_utf8(made).or_else(|error| owned_text(error.as_bytes()))
}

/// Reads the digits after `\u`, and a second half if the first one needs it.
fn unicode_escape(bytes: &[u8], place: &mut usize) -> char {
    let half = |at: usize| {
        let digits = std::str::from_utf8(bytes.get(at..at + 4)?).ok()?;
        u32::from_str_radix(digits, 16).ok()
    };
    let Some(high) = half(*place) else { return char::REPLACEMENT_CHARACTER };
    *place += 4;
    if (0xd800..0xdc00).contains(&high)
        && bytes.get(*place..*place + 2) == Some(b"\\u")
        && let Some(low @ 0xdc00..=0xdfff) = half(*place + 2)
    {
        *place += 6;
        return char::from_u32(0x10000 + ((high - 0xd800) << 10) + (low - 0xdc00))
            .unwrap_or(char::REPLACEMENT_CHARACTER);
    }
    char::from_u32(high).unwrap_or(char::REPLACEMENT_CHARACTER)
}
