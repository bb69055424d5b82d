//! Rows of a PLY file's elements, as text or binary.

use super::ply_header::{Column, Element, Encoding, Header, Number};
use super::room::make_room;
use crate::error::{Note, Place, ReadError, quoted};
use crate::text::Scanner;

/// Goes through the rows of one element after the other. A row offers its numbers and lists by the index of the column.
pub(super) trait Rows {
    /// Prepares for the rows of an element.
    fn begin(&mut self, element: &Element<'_>) -> Result<(), ReadError>;

    /// Reads the next row.
    fn advance(&mut self, element: &Element<'_>, row: u64) -> Result<(), ReadError>;

    /// Passes all rows of an element.
    fn skip(&mut self, element: &Element<'_>) -> Result<(), ReadError> {
        if !element.columns.is_empty() {
            for row in 0..element.count {
                self.advance(element, row)?;
            }
        }
        Ok(())
    }

    /// Returns the number in a column.
    fn number(&self, column: usize) -> f64;

    /// Returns the number of items of the list that the current row of the file has in a column.
    fn list_length(&self, column: usize) -> usize;

    /// Returns a number of the list in a column.
    fn item(&self, column: usize, place: usize) -> f64;

    /// Appends the list in a column as indices below `count`. Returns the place of the first other number as the error.
    fn append_list_as_indices(&self, column: usize, count: u32, indices: &mut Vec<u32>) -> Result<(), usize> {
        append_whole_numbers((0..self.list_length(column)).map(|place| self.item(column, place)), count, indices)
    }

    /// Returns the number of bytes behind the current row.
    fn remaining(&self) -> usize;

    /// Makes a note of what follows the last row.
    fn note_rest(&mut self) -> Option<Note>;

    /// Returns where the current row is.
    fn place(&self) -> Place;
}

/// Appends numbers as indices below `count`. Returns the place of the first other number as the error.
fn append_whole_numbers(values: impl Iterator<Item = f64>, count: u32, indices: &mut Vec<u32>) -> Result<(), usize> {
    for (place, value) in values.enumerate() {
        if !(value >= 0.0 && value < f64::from(count) && value.fract() == 0.0) {
            return Err(place);
        }
        indices.push(value as u32);
    }
    Ok(())
}

/// Makes the error of a row that the file does not hold completely.
fn truncated(element: &Element<'_>, row: u64, place: Place) -> ReadError {
    ReadError::malformed(
        place,
        format!("the file ends in {}; the header announces {}", element.row_name(row), element.count),
    )
}

/// Makes the error of a list whose length is negative, fractional or beyond the file.
fn wrong_length(element: &Element<'_>, row: u64, column: &Column<'_>, length: f64, place: Place) -> ReadError {
    let name = quoted(column.name);
    let text =
        format!("{}: the list {name} cannot have {length} numbers in the rest of the file", element.row_name(row));
    ReadError::malformed(place, text)
}

#[derive(Clone, Copy)]
struct Cell {
    number: Number,
    /// Bytes from the start of the row.
    offset_in_row: usize,
    length: usize,
}

/// Binary rows, whose most significant byte comes first if `BIG`.
pub(super) struct BinaryRows<'a, const BIG: bool> {
    bytes: &'a [u8],
    /// Start of the current row.
    row_start: usize,
    /// End of the current row.
    row_end: usize,
    cells: Vec<Cell>,
    /// Size of each row; `None` if the rows have lists.
    row_size: Option<usize>,
}

impl<'a, const BIG: bool> BinaryRows<'a, BIG> {
    pub(super) fn new(bytes: &'a [u8], header: &Header<'_>) -> Self {
        Self {
            bytes,
            row_start: header.first_row_offset,
            row_end: header.first_row_offset,
            cells: Vec::new(),
            row_size: Some(0),
        }
    }

    fn bytes_at<const N: usize>(&self, place: usize) -> [u8; N] {
        self.bytes.get(place..).and_then(<[u8]>::first_chunk).copied().unwrap_or([0; N])
    }

    #[inline]
    fn decoded(&self, number: Number, place: usize) -> f64 {
        macro_rules! decode {
            ($type:ty) => {{
                let bytes = self.bytes_at(place);
                if BIG { <$type>::from_be_bytes(bytes) } else { <$type>::from_le_bytes(bytes) }
            }};
        }
        match number {
            Number::I8 => f64::from(decode!(i8)),
            Number::U8 => f64::from(decode!(u8)),
            Number::I16 => f64::from(decode!(i16)),
            Number::U16 => f64::from(decode!(u16)),
            Number::I32 => f64::from(decode!(i32)),
            Number::U32 => f64::from(decode!(u32)),
            Number::I64 => decode!(i64) as f64,
            Number::U64 => decode!(u64) as f64,
            Number::F32 => f64::from(decode!(f32)),
            Number::F64 => decode!(f64),
        }
    }

    /// Returns the length of a list; `None` if it is negative, fractional or beyond the file.
    #[inline]
    fn length_at(&self, number: Number, place: usize) -> Option<usize> {
        if number == Number::U8 {
            return Some(usize::from(self.bytes[place]));
        }
        let value = self.decoded(number, place);
        (value >= 0.0 && value.fract() == 0.0 && value <= self.bytes.len() as f64).then_some(value as usize)
    }

    /// Finds the ends of the lists in the next row.
    #[inline]
    fn measure_row(&mut self, element: &Element<'_>, row: u64) -> Result<(), ReadError> {
        let mut place = self.row_end;
        let here = Place::Byte(self.row_end as u64);
        for (cell, column) in element.columns.iter().enumerate() {
            let mut size = column.number_type.size();
            let mut count = 1;
            if let Some(length) = column.list_length_type {
                if self.bytes.len() - place < length.size() {
                    return Err(truncated(element, row, here));
                }
                let Some(found) = self.length_at(length, place) else {
                    return Err(wrong_length(element, row, column, self.decoded(length, place), here));
                };
                place += length.size();
                count = found;
                size = size.saturating_mul(count);
                if self.bytes.len() - place < size {
                    return Err(wrong_length(element, row, column, count as f64, here));
                }
            } else if self.bytes.len() - place < size {
                return Err(truncated(element, row, here));
            }
            self.cells[cell] = Cell { number: column.number_type, offset_in_row: place - self.row_end, length: count };
            place += size;
        }
        self.row_start = self.row_end;
        self.row_end = place;
        Ok(())
    }
}

impl<const BIG: bool> Rows for BinaryRows<'_, BIG> {
    fn begin(&mut self, element: &Element<'_>) -> Result<(), ReadError> {
        self.cells.clear();
        self.cells.try_reserve_exact(element.columns.len())?;
        let mut start = 0;
        for column in &element.columns {
            self.cells.push(Cell { number: column.number_type, offset_in_row: start, length: 1 });
            start += column.number_type.size();
        }
        self.row_size = (!element.has_lists()).then_some(start);
        Ok(())
    }

    #[inline]
    fn advance(&mut self, element: &Element<'_>, row: u64) -> Result<(), ReadError> {
        let Some(size) = self.row_size else { return self.measure_row(element, row) };
        if self.bytes.len() - self.row_end < size {
            return Err(truncated(element, row, Place::Byte(self.row_end as u64)));
        }
        self.row_start = self.row_end;
        self.row_end += size;
        Ok(())
    }

    #[inline]
    fn number(&self, column: usize) -> f64 {
        let cell = self.cells[column];
        self.decoded(cell.number, self.row_start + cell.offset_in_row)
    }

    fn list_length(&self, column: usize) -> usize {
        self.cells[column].length
    }

    fn item(&self, column: usize, place: usize) -> f64 {
        let cell = self.cells[column];
        self.decoded(cell.number, self.row_start + cell.offset_in_row + place * cell.number.size())
    }

    #[inline]
    fn append_list_as_indices(&self, column: usize, count: u32, indices: &mut Vec<u32>) -> Result<(), usize> {
        let cell = self.cells[column];
        let from = self.row_start + cell.offset_in_row;
        let list = self.bytes.get(from..from + cell.length * cell.number.size()).unwrap_or_default();
        let start = indices.len();
        match cell.number {
            Number::U8 => indices.extend(list.iter().map(|&index| u32::from(index))),
            Number::I32 | Number::U32 => indices.extend(
                list.as_chunks().0.iter().map(|&b| if BIG { u32::from_be_bytes(b) } else { u32::from_le_bytes(b) }),
            ),
            _ => return append_whole_numbers((0..cell.length).map(|place| self.item(column, place)), count, indices),
        }
        // A negative index is above all others as an unsigned one.
        let limit = if cell.number == Number::I32 { count.min(1 << 31) } else { count };
        indices[start..].iter().position(|&index| index >= limit).map_or(Ok(()), Err)
    }

    fn remaining(&self) -> usize {
        self.bytes.len() - self.row_end
    }

    fn note_rest(&mut self) -> Option<Note> {
        let text = match self.remaining() {
            0 => return None,
            1 => "1 byte follows the last row and is ignored".into(),
            count => format!("{count} bytes follow the last row and are ignored"),
        };
        Some(Note::new(Place::Byte(self.row_end as u64), text))
    }

    fn place(&self) -> Place {
        Place::Byte(self.row_start as u64)
    }
}

/// Rows of words. If the file has a line for each row, surplus words of a line are ignored. Otherwise ends of lines mean nothing.
pub(super) struct TextRows<'a> {
    scanner: Scanner<'a>,
    size: usize,
    has_line_for_each_row: bool,
    /// Number of rows with surplus words, and the first of their lines.
    surplus: (u64, u64),
    /// Numbers of the current row.
    numbers: Vec<f64>,
    /// Start and length of each column in `numbers`.
    cells: Vec<[usize; 2]>,
}

impl<'a> TextRows<'a> {
    pub(super) fn new(bytes: &'a [u8], header: &Header<'_>) -> Self {
        let scanner = Scanner::new_at(bytes, header.first_row_offset, header.line, None);
        let rows: u64 = header.elements.iter().map(|element| element.count).fold(0, u64::saturating_add);
        let lines = bytes[header.first_row_offset..].iter().filter(|&&byte| byte == b'\n').count() as u64 + 1;
        Self {
            scanner,
            size: bytes.len(),
            has_line_for_each_row: lines >= rows,
            surplus: (0, 0),
            numbers: Vec::new(),
            cells: Vec::new(),
        }
    }

    /// Skips words that follow a row in its line.
    fn skip_surplus(&mut self) {
        if self.has_line_for_each_row && self.scanner.word_in_line().is_some() {
            self.scanner.rest_of_line();
            if self.surplus.0 == 0 {
                self.surplus.1 = self.scanner.line();
            }
            self.surplus.0 += 1;
        }
    }

    /// Reads a number. Rounds to single precision once only.
    fn next(&mut self, number: Number, element: &Element<'_>, row: u64) -> Result<f64, ReadError> {
        let found = match number {
            Number::F32 => self.scanner.next_number::<f32>().map(f64::from),
            Number::F64 => self.scanner.next_number::<f64>(),
            _ => match self.scanner.next_index() {
                Some(index) => return Ok(f64::from(index)),
                None => self.scanner.next_number::<f64>(),
            },
        };
        if let Some(value) = found {
            return Ok(value);
        }
        Err(match self.scanner.word() {
            Some(word) => self.scanner.error(format!("{}: {} is not a number", element.row_name(row), quoted(word))),
            None => truncated(element, row, Place::Line(self.scanner.line())),
        })
    }
}

impl Rows for TextRows<'_> {
    fn begin(&mut self, element: &Element<'_>) -> Result<(), ReadError> {
        self.cells.clear();
        self.cells.try_reserve_exact(element.columns.len())?;
        self.cells.resize(element.columns.len(), [0; 2]);
        Ok(())
    }

    fn advance(&mut self, element: &Element<'_>, row: u64) -> Result<(), ReadError> {
        self.numbers.clear();
        make_room(&mut self.numbers, element.columns.len())?;
        for (cell, column) in element.columns.iter().enumerate() {
            let mut count = 1;
            if let Some(length) = column.list_length_type {
                let value = self.next(length, element, row)?;
                if !(value >= 0.0 && value.fract() == 0.0 && value <= self.remaining().div_ceil(2) as f64) {
                    let place = Place::Line(self.scanner.line());
                    return Err(wrong_length(element, row, column, value, place));
                }
                count = value as usize;
                make_room(&mut self.numbers, count)?;
            }
            self.cells[cell] = [self.numbers.len(), count];
            for _ in 0..count {
                let value = self.next(column.number_type, element, row)?;
                self.numbers.push(value);
            }
        }
        self.skip_surplus();
        Ok(())
    }

    fn number(&self, column: usize) -> f64 {
        self.numbers[self.cells[column][0]]
    }

    fn list_length(&self, column: usize) -> usize {
        self.cells[column][1]
    }

    fn item(&self, column: usize, place: usize) -> f64 {
        self.numbers[self.cells[column][0] + place]
    }

    fn remaining(&self) -> usize {
        self.size - self.scanner.place()
    }

    fn note_rest(&mut self) -> Option<Note> {
        if self.surplus.0 > 0 {
            let text = format!(
                "{} rows have more words than their element has properties; the words are ignored",
                self.surplus.0
            );
            return Some(Note::new(Place::Line(self.surplus.1), text));
        }
        self.scanner.word()?;
        Some(Note::new(Place::Line(self.scanner.line()), "this line and the rest follow the last row and are ignored"))
    }

    fn place(&self) -> Place {
        Place::Line(self.scanner.line())
    }
}

/// Returns the number of rows that the rest of the file can hold, at most the element's count, if each row has at least `items` numbers
/// in the list `list`.
pub(super) fn believed_count(
    element: &Element<'_>,
    encoding: Encoding,
    remaining: usize,
    list: Option<(usize, usize)>,
) -> usize {
    let item_size =
        |column: usize| if encoding == Encoding::Text { 2 } else { element.columns[column].number_type.size() };
    let list_size = list.map_or(0, |(column, items)| items * item_size(column));
    let size = (element.min_row_size(encoding) + list_size).max(1);
    // The last word of a text needs no blank behind it.
    let most = remaining.saturating_add(1) / size;
    usize::try_from(element.count).map_or(most, |count| count.min(most))
}
