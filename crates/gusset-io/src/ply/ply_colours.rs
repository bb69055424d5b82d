//! Colours in PLY files: whole numbers up to 255 or 65535, or parts of 1.

use super::ply_columns::ColourColumns;
use super::ply_header::{Element, Number};
use super::ply_rows::Rows;
use crate::error::{Note, Place};

/// Reads the colours of an element.
pub(super) struct ColourReader {
    columns: ColourColumns,
    numbers: [Number; 4],
}

impl ColourReader {
    pub(super) fn new(element: &Element<'_>, columns: ColourColumns) -> Self {
        let [red, green, blue] = columns.colour_part_columns;
        let numbers =
            [red, green, blue, columns.opacity.unwrap_or(red)].map(|column| element.columns[column].number_type);
        Self { columns, numbers }
    }

    /// Returns the colour of the current row. Numbers of single or double precision may still have to be scaled.
    #[inline]
    pub(super) fn read_colour<R: Rows>(&self, rows: &R) -> [f32; 4] {
        let [red, green, blue] = self.columns.colour_part_columns.map(|column| rows.number(column));
        let opacity = self.columns.opacity.map(|column| rows.number(column));
        let values = [red, green, blue, opacity.unwrap_or(0.0)];
        let mut colour = [0, 1, 2, 3].map(|part| scaled(values[part], self.numbers[part]));
        if opacity.is_none() {
            colour[3] = 1.0;
        }
        colour
    }

    /// Takes numbers with a fractional type as parts of 255 if one of them exceeds 1. Clamps all.
    pub(super) fn finish(&self, colours: &mut [[f32; 4]], notes: &mut Vec<Note>) {
        let mut is_real = self.numbers.map(|number| !number.is_integer());
        is_real[3] &= self.columns.opacity.is_some();
        if is_real == [false; 4] {
            return;
        }
        let exceeds = |part: f32| part > 1.0;
        let is_byte = colours.iter().any(|colour| (0..4).any(|part| is_real[part] && exceeds(colour[part])));
        if is_byte {
            notes.push(Note::new(Place::Whole, "colours above 1 are taken as parts of 255"));
        }
        for colour in colours {
            for part in (0..4).filter(|&part| is_real[part]) {
                let value = if is_byte { colour[part] / 255.0 } else { colour[part] };
                colour[part] = if value > 0.0 { value.min(1.0) } else { 0.0 };
            }
        }
    }
}

fn scaled(value: f64, number: Number) -> f32 {
    let full = match number {
        Number::F32 | Number::F64 => return value as f32,
        Number::U16 => 65535.0,
        // Some writers call bytes signed.
        Number::I8 if value < 0.0 => return ((value + 256.0) / 255.0).clamp(0.0, 1.0) as f32,
        _ => 255.0,
    };
    (value / full).clamp(0.0, 1.0) as f32
}
