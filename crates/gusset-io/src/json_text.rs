//! JSON as text: strings, numbers, and values of a tape with changes.

use crate::json_tape::Value;

/// Appends a text in quotation marks.
pub(crate) fn push_text(out: &mut String, text: &str) {
    out.push('"');
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            c if c < ' ' => out.push_str(&format!("\\u{:04x}", c as u32)),
            c => out.push(c),
        }
    }
    out.push('"');
}

/// Appends the shortest decimal of a number; 0 if it is not finite.
pub(crate) fn push_number(out: &mut String, value: f64) {
    let value = if value.is_finite() { value } else { 0.0 };
    let mut buffer = ryu::Buffer::new();
    let digits = buffer.format_finite(value);
    out.push_str(digits.strip_suffix(".0").unwrap_or(digits));
}

/// Appends a list of numbers in brackets.
pub(crate) fn push_numbers(out: &mut String, values: &[f64]) {
    out.push('[');
    for (place, &value) in values.iter().enumerate() {
        if place > 0 {
            out.push(',');
        }
        push_number(out, value);
    }
    out.push(']');
}

/// Treatment of a member of an object.
pub(crate) enum Edit {
    Keep,
    Drop,
    Replace(String),
}

/// An open container of [`push_edited`].
struct Open<'t> {
    /// Name that the container has in the one around it.
    name: Option<Value<'t>>,
    values: Box<dyn Iterator<Item = (Option<Value<'t>>, Value<'t>)> + 't>,
    is_object: bool,
    is_empty: bool,
}

/// Largest depth of containers that [`push_edited`] copies.
const MAX_DEPTH: usize = 100;

/// Appends a value without blanks. `edit` receives each member of each object: the name of the object, the name of the member and its
/// value. Returns false, and appends a part, if the value is deeper than 100 containers.
#[must_use]
pub(crate) fn push_edited<'t>(
    out: &mut String,
    root: Value<'t>,
    mut edit: impl FnMut(Option<Value<'t>>, Value<'t>, Value<'t>) -> Edit,
) -> bool {
    let mut open: Vec<Open<'t>> = Vec::new();
    push_start(out, &mut open, None, root);
    while open.len() <= MAX_DEPTH {
        let Some(top) = open.last_mut() else { return true };
        let Some((key, value)) = top.values.next() else {
            out.push(if top.is_object { '}' } else { ']' });
            open.pop();
            continue;
        };
        let change = key.map_or(Edit::Keep, |key| edit(top.name, key, value));
        if matches!(change, Edit::Drop) {
            continue;
        }
        if !std::mem::take(&mut top.is_empty) {
            out.push(',');
        }
        if let Some(key) = key {
            push_text(out, &key.text().unwrap_or_default());
            out.push(':');
        }
        // Values in an array belong to the array's name.
        let name = key.or(top.name);
        match change {
            Edit::Replace(text) => out.push_str(&text),
            _ => push_start(out, &mut open, name, value),
        }
    }
    false
}

/// Appends a plain value, or opens a container.
fn push_start<'t>(out: &mut String, open: &mut Vec<Open<'t>>, name: Option<Value<'t>>, value: Value<'t>) {
    if value.is_object() {
        out.push('{');
        let values = Box::new(value.members().map(|(key, value)| (Some(key), value)));
        open.push(Open { name, values, is_object: true, is_empty: true });
    } else if value.is_array() {
        out.push('[');
        let values = Box::new(value.items().map(|value| (None, value)));
        open.push(Open { name, values, is_object: false, is_empty: true });
    } else if let Some(text) = value.text() {
        push_text(out, &text);
    } else if let Some(number) = value.number() {
        push_literal(out, value.raw_text(), number);
    } else {
        let raw = value.raw_text();
        out.push_str(if raw == b"true" {
            "true"
        } else if raw == b"false" {
            "false"
        } else {
            "null"
        });
    }
}

/// Appends a number as it was written if JSON permits it so.
fn push_literal(out: &mut String, raw: &[u8], number: f64) {
    let digits = raw.strip_prefix(b"-").unwrap_or(raw);
    let is_plain = digits.first().is_some_and(u8::is_ascii_digit)
        && digits.last().is_some_and(u8::is_ascii_digit)
        && (digits[0] != b'0' || digits.len() == 1 || !digits[1].is_ascii_digit())
        && !digits.windows(2).any(|pair| pair[0] == b'.' && !pair[1].is_ascii_digit());
    match std::str::from_utf8(raw) {
        Ok(text) if is_plain && number.is_finite() => out.push_str(text),
        _ => push_number(out, number),
    }
}
