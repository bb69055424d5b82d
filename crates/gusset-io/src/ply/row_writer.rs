//! Numbers of PLY rows, as text or binary.

use crate::mesh::NumberKind;
use crate::text::TextWriter;
use std::io;

/// Writes rows. Binary numbers have the least significant byte first.
pub(super) struct RowWriter<'a> {
    pub(super) out: TextWriter<'a>,
    is_text: bool,
    is_row_start: bool,
}

impl<'a> RowWriter<'a> {
    pub(super) fn new(out: TextWriter<'a>, is_text: bool) -> Self {
        Self { out, is_text, is_row_start: true }
    }

    /// Writes the blank between two words.
    fn separate(&mut self) -> io::Result<()> {
        if std::mem::take(&mut self.is_row_start) { Ok(()) } else { self.out.bytes(b" ") }
    }

    /// Writes a number of single or double precision.
    pub(super) fn real(&mut self, value: f64, is_single: bool) -> io::Result<()> {
        if self.is_text {
            self.separate()?;
            return if is_single { self.out.single(value as f32) } else { self.out.double(value) };
        }
        if is_single { self.out.bytes(&(value as f32).to_le_bytes()) } else { self.out.bytes(&value.to_le_bytes()) }
    }

    /// Writes a number of a vector that may be missing: 0 for NaN.
    pub(super) fn present(&mut self, value: f64, is_single: bool) -> io::Result<()> {
        self.real(if value.is_nan() { 0.0 } else { value }, is_single)
    }

    pub(super) fn byte(&mut self, value: u8) -> io::Result<()> {
        if self.is_text {
            self.separate()?;
            return self.out.integer(u64::from(value));
        }
        self.out.bytes(&[value])
    }

    pub(super) fn index(&mut self, value: u32) -> io::Result<()> {
        if self.is_text {
            self.separate()?;
            return self.out.integer(u64::from(value));
        }
        self.out.bytes(&value.to_le_bytes())
    }

    /// Writes the length of a list: one byte if all lists are short.
    pub(super) fn length(&mut self, length: usize, is_short: bool) -> io::Result<()> {
        if is_short { self.byte(length as u8) } else { self.index(length as u32) }
    }

    /// Writes a number as its type has it: the nearest that it can hold.
    pub(super) fn number(&mut self, value: f64, kind: NumberKind) -> io::Result<()> {
        let rounded = value.round_ties_even();
        // Casts clamp, and make 0 of NaN.
        match kind {
            NumberKind::F32 | NumberKind::F64 => self.real(value, kind == NumberKind::F32),
            NumberKind::U8 => self.byte(rounded as u8),
            NumberKind::U32 => self.index(rounded as u32),
            NumberKind::I8 => self.integer(i64::from(rounded as i8), 1),
            NumberKind::I16 => self.integer(i64::from(rounded as i16), 2),
            NumberKind::U16 => self.integer(i64::from(rounded as u16), 2),
            NumberKind::I32 => self.integer(i64::from(rounded as i32), 4),
        }
    }

    /// Writes the lower bytes of an integer, or its digits.
    pub(super) fn integer(&mut self, value: i64, size: usize) -> io::Result<()> {
        if !self.is_text {
            return self.out.bytes(&value.to_le_bytes()[..size]);
        }
        self.separate()?;
        if value < 0 {
            self.out.bytes(b"-")?;
        }
        self.out.integer(value.unsigned_abs())
    }

    pub(super) fn end_row(&mut self) -> io::Result<()> {
        self.is_row_start = true;
        if self.is_text { self.out.bytes(b"\n") } else { Ok(()) }
    }
}
