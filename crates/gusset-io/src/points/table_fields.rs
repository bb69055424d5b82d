//! Fields of a row, and the numbers in them.

use crate::error::ReadError;
use crate::text::number;
use gusset_base::alloc;

/// How fields are separated and written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FieldStyle {
    /// A semicolon, a tab, a comma, or a blank for any white space.
    pub(super) separator: u8,
    /// Numbers may have a comma before their decimals.
    pub(super) has_decimal_commas: bool,
}

impl FieldStyle {
    /// The styles in the order in which they are tried on the first row of numbers.
    pub(super) const ALL: [Self; 5] = [
        Self { separator: b';', has_decimal_commas: true },
        Self { separator: b'\t', has_decimal_commas: true },
        Self { separator: b',', has_decimal_commas: false },
        Self { separator: b' ', has_decimal_commas: false },
        Self { separator: b' ', has_decimal_commas: true },
    ];

    /// Splits a line. A separator at the end begins no field.
    pub(super) fn split<'a>(self, line: &'a [u8], fields: &mut Vec<&'a [u8]>) -> Result<(), ReadError> {
        fields.clear();
        if self.separator == b' ' {
            let words = line.split(u8::is_ascii_whitespace).filter(|field| !field.is_empty());
            return Ok(alloc::extend(fields, words.map(unquoted))?);
        }
        let words = line.split(|&byte| byte == self.separator);
        alloc::extend(fields, words.map(|field| unquoted(field.trim_ascii())))?;
        while fields.last().is_some_and(|field| field.is_empty()) {
            fields.pop();
        }
        Ok(())
    }

    /// Returns the number in a field.
    pub(super) fn number(self, field: &[u8]) -> Option<f64> {
        const MAX_DIGITS: usize = 64;
        if self.has_decimal_commas
            && let Some(place) = field.iter().position(|&byte| byte == b',')
        {
            let mut copy = [0; MAX_DIGITS];
            let digits = copy.get_mut(..field.len())?;
            digits.copy_from_slice(field);
            digits[place] = b'.';
            return number(digits);
        }
        number(field)
    }
}

fn unquoted(field: &[u8]) -> &[u8] {
    match field {
        [b'"', inner @ .., b'"'] | [b'\'', inner @ .., b'\''] => inner.trim_ascii(),
        _ => field,
    }
}
