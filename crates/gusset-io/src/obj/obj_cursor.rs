//! Statements, numbers and indices in the text of OBJ files.

use crate::text;

/// Kind of a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Keyword {
    Vertex,
    Normal,
    Texcoord,
    Face,
    Polyline,
    Points,
    UseMaterial,
    Library,
    Object,
    Group,
    /// A free-form curve or surface.
    FreeForm,
    /// Content of free-form elements, smoothing groups and display attributes.
    Ignored,
    /// Another file or program.
    Call,
    Unknown,
}

/// Indices of a corner as the file writes them: from 1, or negative from the end.
#[derive(Clone, Copy, Debug)]
pub(super) struct CornerIndices {
    pub(super) vertex: i64,
    pub(super) texcoord: Option<i64>,
    pub(super) normal: Option<i64>,
}

/// A place in the text. A statement ends at a line's end that does not follow a backslash, or at `#`.
#[derive(Clone)]
pub(super) struct Cursor<'a> {
    bytes: &'a [u8],
    offset: usize,
    /// Number of line ends before the place.
    pub(super) line: u64,
}

pub(super) fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\r' | 0x0b | 0x0c)
}

impl<'a> Cursor<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, offset: 0, line: 0 }
    }

    fn peek(&self) -> Option<u8> {
        self.bytes.get(self.offset).copied()
    }

    /// Passes empty lines and comments, and reads a keyword. Returns `None` at the end of the text.
    #[inline]
    pub(super) fn read_keyword(&mut self) -> Option<Keyword> {
        loop {
            let length_and_keyword = match self.bytes.get(self.offset..)? {
                [b'v', b' ' | b'\t', ..] => (1, Keyword::Vertex),
                [b'f', b' ' | b'\t', ..] => (1, Keyword::Face),
                [b'v', b'n', b' ' | b'\t', ..] => (2, Keyword::Normal),
                [b'v', b't', b' ' | b'\t', ..] => (2, Keyword::Texcoord),
                [] => return None,
                [b'\n', ..] => {
                    self.offset += 1;
                    self.line += 1;
                    continue;
                }
                [b'#', ..] => {
                    self.skip_line();
                    continue;
                }
                [byte, ..] if is_blank(*byte) => {
                    self.offset += 1;
                    continue;
                }
                _ => return Some(self.read_rare_keyword()),
            };
            self.offset += length_and_keyword.0;
            return Some(length_and_keyword.1);
        }
    }

    #[cold]
    fn read_rare_keyword(&mut self) -> Keyword {
        const MAX_KEYWORD_BYTES: usize = 10;
        let start = self.offset;
        let word = self.read_word();
        let mut small = [0; MAX_KEYWORD_BYTES];
        let Some(small) = small.get_mut(..word.len()) else { return Keyword::Unknown };
        small.copy_from_slice(word);
        small.make_ascii_lowercase();
        match &*small {
            b"v" => Keyword::Vertex,
            b"vn" => Keyword::Normal,
            b"vt" => Keyword::Texcoord,
            b"f" | b"fo" => Keyword::Face,
            b"l" => Keyword::Polyline,
            b"p" => Keyword::Points,
            b"usemtl" => Keyword::UseMaterial,
            b"mtllib" => Keyword::Library,
            b"o" => Keyword::Object,
            b"g" => Keyword::Group,
            b"curv" | b"curv2" | b"surf" | b"bsp" | b"bzp" | b"cdc" | b"cdp" => Keyword::FreeForm,
            b"call" | b"csh" => Keyword::Call,
            b"s" | b"mg" | b"vp" | b"cstype" | b"deg" | b"bmat" | b"step" | b"parm" | b"trim" | b"hole" | b"scrv"
            | b"sp" | b"end" | b"con" | b"res" | b"bevel" | b"c_interp" | b"d_interp" | b"lod" | b"shadow_obj"
            | b"trace_obj" | b"ctech" | b"stech" | b"usemap" | b"maplib" => Keyword::Ignored,
            _ => {
                self.offset = start;
                Keyword::Unknown
            }
        }
    }

    /// Passes blanks and ends of continued lines.
    #[inline]
    pub(super) fn skip_blanks(&mut self) {
        while let Some(byte) = self.peek() {
            if is_blank(byte) {
                self.offset += 1;
            } else if byte != b'\\' || !self.skip_continuation() {
                break;
            }
        }
    }

    #[cold]
    fn skip_continuation(&mut self) -> bool {
        let rest = &self.bytes[self.offset + 1..];
        let blanks = rest.iter().take_while(|&&byte| is_blank(byte)).count();
        match rest.get(blanks) {
            Some(b'\n') => {
                self.offset += blanks + 2;
                self.line += 1;
                true
            }
            None => {
                self.offset = self.bytes.len();
                true
            }
            Some(_) => false,
        }
    }

    /// Passes blanks and returns whether the statement ends there.
    #[inline]
    pub(super) fn is_at_end(&mut self) -> bool {
        self.skip_blanks();
        matches!(self.peek(), None | Some(b'\n' | b'#'))
    }

    /// Goes to the start of the next line that does not continue this one.
    #[inline]
    pub(super) fn next_statement(&mut self) {
        loop {
            self.skip_blanks();
            match self.peek() {
                None => return,
                Some(b'\n') => {
                    self.offset += 1;
                    self.line += 1;
                    return;
                }
                Some(b'#') => {
                    self.skip_line();
                    return;
                }
                Some(b'\\') => self.offset += 1,
                Some(_) => self.skip_word(),
            }
        }
    }

    fn skip_word(&mut self) {
        let rest = &self.bytes[self.offset..];
        let is_end = |byte: u8| is_blank(byte) || byte == b'\n' || byte == b'\\';
        self.offset += rest.iter().position(|&byte| is_end(byte)).unwrap_or(rest.len());
    }

    fn skip_line(&mut self) {
        let rest = &self.bytes[self.offset..];
        match rest.iter().position(|&byte| byte == b'\n') {
            Some(length) => {
                self.offset += length + 1;
                self.line += 1;
            }
            None => self.offset = self.bytes.len(),
        }
    }

    /// Returns the bytes up to the next blank, line end or continuation.
    pub(super) fn read_word(&mut self) -> &'a [u8] {
        let start = self.offset;
        while let Some(byte) = self.peek() {
            if is_blank(byte) || byte == b'\n' || (byte == b'\\' && self.clone().skip_continuation()) {
                break;
            }
            self.offset += 1;
        }
        &self.bytes[start..self.offset]
    }

    /// Returns the rest of the line without blanks at its ends. A backslash belongs to it.
    pub(super) fn read_name(&mut self) -> &'a [u8] {
        let rest = &self.bytes[self.offset..];
        let length = rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len());
        self.offset += length;
        rest[..length].trim_ascii()
    }

    /// Reads a number. Returns `None` and stays before the next word if the word is not a number, or at the end of the statement.
    #[inline]
    pub(super) fn read_number(&mut self) -> Option<f64> {
        self.skip_blanks();
        if let Ok((value, length)) = fast_float2::parse_partial::<f64, _>(&self.bytes[self.offset..])
            && self.is_word_end(self.offset + length)
        {
            self.offset += length;
            return Some(value);
        }
        self.read_rare_number()
    }

    fn is_word_end(&self, place: usize) -> bool {
        self.bytes.get(place).is_none_or(|&byte| is_blank(byte) || byte == b'\n')
    }

    #[cold]
    fn read_rare_number(&mut self) -> Option<f64> {
        let start = self.offset;
        let word = self.read_word();
        let value = text::number(word).or_else(|| {
            let length = word.iter().position(|&byte| byte == b'#')?;
            self.offset = start + length;
            text::number(&word[..length])
        });
        if value.is_none() {
            self.offset = start;
        }
        value
    }

    /// Reads the indices of a corner: `1`, `1/2`, `1//3` or `1/2/3`, where an empty index is absent. Returns `None` and stays if the word
    /// is something else.
    #[inline]
    pub(super) fn read_corner(&mut self) -> Option<CornerIndices> {
        let start = self.offset;
        let found = self.read_corner_parts();
        if found.is_none() {
            self.offset = start;
        }
        found
    }

    #[inline]
    fn read_corner_parts(&mut self) -> Option<CornerIndices> {
        let vertex = self.read_index()?;
        let mut corner = CornerIndices { vertex, texcoord: None, normal: None };
        if self.peek() == Some(b'/') {
            self.offset += 1;
            corner.texcoord = self.read_index();
            if self.peek() == Some(b'/') {
                self.offset += 1;
                corner.normal = self.read_index();
            }
        }
        let is_whole = match self.peek() {
            None | Some(b'\n' | b'#') => true,
            Some(b'\\') => self.clone().skip_continuation(),
            Some(byte) => is_blank(byte),
        };
        is_whole.then_some(corner)
    }

    /// Reads an integer. Huge ones stay huge, not exact.
    #[inline]
    fn read_index(&mut self) -> Option<i64> {
        const HUGE: i64 = 1 << 50;
        let mut place = self.offset;
        let is_negative = self.bytes.get(place) == Some(&b'-');
        if is_negative || self.bytes.get(place) == Some(&b'+') {
            place += 1;
        }
        let start = place;
        let mut value: i64 = 0;
        while let Some(digit) = self.bytes.get(place).map(|byte| byte.wrapping_sub(b'0')).filter(|&digit| digit < 10) {
            if value < HUGE {
                value = value * 10 + i64::from(digit);
            }
            place += 1;
        }
        if place == start {
            return None;
        }
        self.offset = place;
        Some(if is_negative { -value } else { value })
    }
}
