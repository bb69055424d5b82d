//! Header of a PLY file: its elements, and the properties of each.

use crate::error::{Note, Place, ReadError, quoted};
use crate::foreign_files::refuse_foreign_file;
use crate::mesh::NumberKind;
use crate::text::integer;
use gusset_base::alloc;

/// How the rows are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    LittleEndian,
    BigEndian,
}

/// Type of a number in the file. 64-bit integers are an extension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Number {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

impl Number {
    /// Returns the size in bytes.
    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    /// Returns whether single precision holds all values.
    pub(super) fn fits_single(self) -> bool {
        matches!(self, Self::I8 | Self::U8 | Self::I16 | Self::U16 | Self::F32)
    }

    pub(super) fn is_integer(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }

    /// Returns the model's type. 64-bit integers become numbers of double precision.
    pub(super) fn kind(self) -> NumberKind {
        match self {
            Self::I8 => NumberKind::I8,
            Self::U8 => NumberKind::U8,
            Self::I16 => NumberKind::I16,
            Self::U16 => NumberKind::U16,
            Self::I32 => NumberKind::I32,
            Self::U32 => NumberKind::U32,
            Self::F32 => NumberKind::F32,
            Self::I64 | Self::U64 | Self::F64 => NumberKind::F64,
        }
    }

    fn from_word(word: &[u8]) -> Option<Self> {
        Some(match &word.to_ascii_lowercase()[..] {
            b"char" | b"int8" => Self::I8,
            b"uchar" | b"uint8" => Self::U8,
            b"short" | b"int16" => Self::I16,
            b"ushort" | b"uint16" => Self::U16,
            b"int" | b"int32" => Self::I32,
            b"uint" | b"uint32" => Self::U32,
            b"int64" => Self::I64,
            b"uint64" => Self::U64,
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => return None,
        })
    }
}

/// A property of an element.
#[derive(Clone, Copy, Debug)]
pub(super) struct Column<'a> {
    pub(super) name: &'a [u8],
    pub(super) number_type: Number,
    /// Type of a list's length; `None` for a single number.
    pub(super) list_length_type: Option<Number>,
}

/// An element: `count` rows with equal columns.
#[derive(Clone, Debug)]
pub(super) struct Element<'a> {
    pub(super) name: &'a [u8],
    pub(super) count: u64,
    pub(super) columns: Vec<Column<'a>>,
}

impl Element<'_> {
    /// Returns the column of the first name that the element has, in capitals or not.
    pub(super) fn find(&self, names: &[&str], is_list: bool) -> Option<usize> {
        names.iter().find_map(|name| {
            self.columns.iter().position(|column| {
                column.list_length_type.is_some() == is_list && column.name.eq_ignore_ascii_case(name.as_bytes())
            })
        })
    }

    /// Returns the columns of the first group of names that the element has completely.
    pub(super) fn find_group<const N: usize>(&self, groups: &[[&str; N]]) -> Option<[usize; N]> {
        groups.iter().find_map(|names| {
            let mut columns = [0; N];
            for (column, name) in columns.iter_mut().zip(names) {
                *column = self.find(&[name], false)?;
            }
            Some(columns)
        })
    }

    pub(super) fn is_named(&self, name: &str) -> bool {
        self.name.eq_ignore_ascii_case(name.as_bytes())
    }

    pub(super) fn has_lists(&self) -> bool {
        self.columns.iter().any(|column| column.list_length_type.is_some())
    }

    /// Returns the smallest size of a row in bytes: 0 without columns.
    pub(super) fn min_row_size(&self, encoding: Encoding) -> usize {
        match encoding {
            Encoding::Text => 2 * self.columns.len(),
            _ => self.columns.iter().map(|column| column.list_length_type.unwrap_or(column.number_type).size()).sum(),
        }
    }

    /// Returns `vertex 17`.
    pub(super) fn row_name(&self, row: u64) -> String {
        format!("{} {row}", String::from_utf8_lossy(&self.name[..self.name.len().min(40)]))
    }
}

/// All that comes before the rows.
pub(super) struct Header<'a> {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element<'a>>,
    /// Names of images.
    pub(super) textures: Vec<&'a [u8]>,
    /// Size of a range image, 0 if the file does not say it.
    pub(super) grid_rows: u64,
    pub(super) grid_columns: u64,
    /// Place of the first row.
    pub(super) first_row_offset: usize,
    /// Line of the first row.
    pub(super) line: u64,
    pub(super) notes: Vec<Note>,
}

/// Most notes about one part of a file.
pub(super) const MAX_NOTES: usize = 16;

/// Lines that end with a line feed, or with a carriage return if the first line does.
struct Lines<'a> {
    bytes: &'a [u8],
    offset: usize,
    line: u64,
    line_end_byte: u8,
}

impl<'a> Lines<'a> {
    fn new(bytes: &'a [u8], place: usize) -> Self {
        let end = match bytes[place..].iter().position(|&byte| byte == b'\r' || byte == b'\n') {
            Some(first) if bytes[place + first] == b'\r' && bytes.get(place + first + 1) != Some(&b'\n') => b'\r',
            _ => b'\n',
        };
        Self { bytes, offset: place, line: 0, line_end_byte: end }
    }

    fn next(&mut self) -> Option<&'a [u8]> {
        let rest = self.bytes.get(self.offset..).filter(|rest| !rest.is_empty())?;
        let length = rest.iter().position(|&byte| byte == self.line_end_byte).unwrap_or(rest.len());
        self.offset = (self.offset + length + 1).min(self.bytes.len());
        self.line += 1;
        Some(rest[..length].trim_ascii())
    }

    fn error(&self, message: impl Into<String>) -> ReadError {
        ReadError::malformed(Place::Line(self.line), message)
    }
}

/// Reads the header.
pub(super) fn read_header(bytes: &[u8]) -> Result<Header<'_>, ReadError> {
    let start = if bytes.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 };
    let mut lines = Lines::new(bytes, start);
    if !lines.next().is_some_and(|line| line.eq_ignore_ascii_case(b"ply")) {
        let error = || ReadError::malformed(Place::Line(1), "the first line is not \"ply\"");
        return Err(refuse_foreign_file(bytes).unwrap_or_else(error));
    }
    let mut header = Header {
        encoding: Encoding::Text,
        elements: Vec::new(),
        textures: Vec::new(),
        grid_rows: 0,
        grid_columns: 0,
        first_row_offset: 0,
        line: 0,
        notes: Vec::new(),
    };
    let mut encoding = None;
    loop {
        let Some(line) = lines.next() else {
            return Err(lines.error("the file ends before \"end_header\""));
        };
        let words = first_words(line);
        match &words[0].to_ascii_lowercase()[..] {
            b"" | b"comment" | b"obj_info" => read_remark(&mut header, line, &words)?,
            b"end_header" => break,
            b"format" => read_format(&mut header, &lines, &mut encoding, &words)?,
            b"element" => alloc::push(&mut header.elements, read_element(&lines, &words)?)?,
            b"property" => {
                let column = read_column(&lines, line, &words)?;
                let element = header.elements.last_mut();
                let element = element.ok_or_else(|| lines.error("a property comes before the first element"))?;
                element.columns.try_reserve(1)?;
                element.columns.push(column);
            }
            // Some programs write remarks without a word before them.
            _ if header.notes.len() < MAX_NOTES => {
                let text = format!("{} is not a word of PLY headers; the line is ignored", quoted(words[0]));
                header.notes.push(Note::new(Place::Line(lines.line), text));
            }
            _ => {}
        }
    }
    header.encoding = encoding.ok_or_else(|| lines.error("the header lacks the line \"format\""))?;
    header.first_row_offset = lines.offset;
    header.line = lines.line + 1;
    Ok(header)
}

/// Returns the first five words of a line; missing words are empty.
fn first_words(line: &[u8]) -> [&[u8]; 5] {
    let mut words = [&line[..0]; 5];
    let all = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    for (word, found) in words.iter_mut().zip(all) {
        *word = found;
    }
    words
}

fn read_format(
    header: &mut Header<'_>,
    lines: &Lines<'_>,
    encoding: &mut Option<Encoding>,
    words: &[&[u8]; 5],
) -> Result<(), ReadError> {
    let found = match &words[1].to_ascii_lowercase()[..] {
        b"ascii" => Encoding::Text,
        b"binary_little_endian" => Encoding::LittleEndian,
        b"binary_big_endian" => Encoding::BigEndian,
        _ => {
            return Err(lines.error(format!(
                "{} is not a format: use ascii, binary_little_endian or binary_big_endian",
                quoted(words[1])
            )));
        }
    };
    if encoding.replace(found).is_some_and(|before| before != found) {
        return Err(lines.error("the header names two formats"));
    }
    if words[2] != b"1.0" && header.notes.is_empty() {
        let text = format!("version {} is read as version 1.0", quoted(words[2]));
        header.notes.push(Note::new(Place::Line(lines.line), text));
    }
    Ok(())
}

fn read_element<'a>(lines: &Lines<'a>, words: &[&'a [u8]; 5]) -> Result<Element<'a>, ReadError> {
    let count = integer(words[2]).and_then(|count| u64::try_from(count).ok());
    let Some(count) = count else {
        return Err(lines.error("an element needs a name and a count: \"element vertex 8\""));
    };
    Ok(Element { name: words[1], count, columns: Vec::new() })
}

fn read_column<'a>(lines: &Lines<'a>, line: &'a [u8], words: &[&'a [u8]; 5]) -> Result<Column<'a>, ReadError> {
    let number = |word: &[u8]| {
        Number::from_word(word).ok_or_else(|| {
            lines.error(format!("{} is not a type: use uchar, int, float, double or another", quoted(word)))
        })
    };
    let is_list = words[1].eq_ignore_ascii_case(b"list");
    if words[if is_list { 4 } else { 2 }].is_empty() {
        return Err(lines.error("a property needs a type and a name: \"property float x\""));
    }
    let name = line.rsplit(u8::is_ascii_whitespace).next().unwrap_or(line);
    let length = if is_list { Some(number(words[2])?) } else { None };
    Ok(Column { name, number_type: number(words[if is_list { 3 } else { 1 }])?, list_length_type: length })
}

/// Reads comments that name images, and the size of a range image.
fn read_remark<'a>(header: &mut Header<'a>, line: &'a [u8], words: &[&'a [u8]; 5]) -> Result<(), ReadError> {
    let count = || integer(words[2]).and_then(|count| u64::try_from(count).ok()).unwrap_or(0);
    if words[0].eq_ignore_ascii_case(b"comment") {
        if words[1].eq_ignore_ascii_case(b"TextureFile") && !words[2].is_empty() {
            let start = line.len() - line.trim_ascii_start().len();
            let rest = line[start + words[0].len()..].trim_ascii_start();
            alloc::push(&mut header.textures, rest[words[1].len()..].trim_ascii())?;
        }
    } else if words[1].eq_ignore_ascii_case(b"num_rows") {
        header.grid_rows = count();
    } else if words[1].eq_ignore_ascii_case(b"num_cols") {
        header.grid_columns = count();
    }
    Ok(())
}
