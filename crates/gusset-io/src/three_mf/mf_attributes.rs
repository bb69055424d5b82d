//! Values of attributes of tags.

use super::mf_model::Matrix;
use crate::error::{Place, ReadError};
use crate::text::number;
use quick_xml::events::BytesStart;

/// Makes the error of a tag that lacks an attribute.
pub(super) fn missing(element: &str, attribute: &str) -> ReadError {
    ReadError::malformed(Place::Whole, format!("{element} lacks the attribute {attribute}, or it is not a number"))
}

/// Longest value of an attribute that is read.
const MAX_VALUE_BYTES: usize = 1 << 15;

/// Returns the value of an attribute; `None` if it is longer than 32 kB.
pub(super) fn attribute(tag: &BytesStart<'_>, name: &str) -> Option<String> {
    tag.attributes()
        .with_checks(false)
        .flatten()
        .find(|attribute| attribute.key.into_inner() == name)
        .and_then(value_text)
}

/// Returns the value of an attribute whose name has a prefix.
pub(super) fn local_attribute(tag: &BytesStart<'_>, name: &str) -> Option<String> {
    tag.attributes()
        .with_checks(false)
        .flatten()
        .find(|attribute| attribute.key.local_name().into_inner() == name)
        .and_then(value_text)
}

#[allow(clippy::needless_pass_by_value)]
fn value_text(attribute: quick_xml::events::attributes::Attribute<'_>) -> Option<String> {
    if attribute.value.len() > MAX_VALUE_BYTES {
        return None;
    }
    Some(match quick_xml::escape::unescape(&attribute.value) {
        Ok(text) => text.into_owned(),
        Err(_) => attribute.value.into_owned(),
    })
}

/// Returns the whole number that is the value of an attribute.
pub(super) fn whole(tag: &BytesStart<'_>, name: &str) -> Option<u32> {
    attribute(tag, name)?.trim().parse().ok()
}

/// Reads a matrix of 12 numbers, column by column.
pub(super) fn matrix(text: &str) -> Option<Matrix> {
    let mut m = [0.0; 12];
    let mut words = text.split_ascii_whitespace();
    for part in &mut m {
        *part = number(words.next()?.as_bytes())?;
    }
    words.next().is_none().then(|| std::array::from_fn(|row| std::array::from_fn(|column| m[3 * column + row])))
}

/// Reads `#rrggbb` or `#rrggbbaa`.
pub(super) fn colour_from_text(text: &str) -> Option<[f32; 4]> {
    let digits = text.trim().strip_prefix('#')?;
    let value = u32::from_str_radix(digits, 16).ok()?;
    let value = match digits.len() {
        6 => (value << 8) | 0xff,
        8 => value,
        _ => return None,
    };
    Some(value.to_be_bytes().map(|part| f32::from(part) / 255.0))
}
