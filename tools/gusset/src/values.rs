//! Values of parameters as words: numbers, choices, vectors, angles in degrees.

use crate::failure::Failure;
use crate::plugin::{Filter, Param, ParamKind};
use std::fmt::Write;

/// Returns a label in the form in which it is typed: small letters and digits, words joined by hyphens.
pub(crate) fn slug(label: &str) -> String {
    let mut made = String::new();
    for c in label.chars() {
        if c.is_ascii_alphanumeric() {
            made.push(c.to_ascii_lowercase());
        } else if !made.is_empty() && !made.ends_with('-') {
            made.push('-');
        }
    }
    made.trim_end_matches('-').to_owned()
}

/// Puts the given parameters, each `name=value`, over the suggested values.
pub(crate) fn parse_values(filter: Filter, mut values: Vec<f64>, given: &[String]) -> Result<Vec<f64>, Failure> {
    let params = filter.params();
    let mut seen: Vec<&str> = Vec::new();
    for one in given {
        let Some((name, text)) = one.split_once('=').filter(|(name, text)| !name.is_empty() && !text.is_empty()) else {
            return Err(Failure::usage(format!("-p takes NAME=VALUE, not \"{one}\"")));
        };
        let id = name.replace('-', "_");
        let Some(&param) = params.iter().find(|param| param.id() == id) else {
            return Err(Failure::usage(unknown_param(filter, name)));
        };
        if seen.contains(&param.id()) {
            return Err(Failure::usage(format!("parameter {name} is given twice")));
        }
        seen.push(param.id());
        let parsed = parse_value(param, text).ok_or_else(|| {
            Failure::usage(format!(
                "parameter {} takes {}, not \"{text}\"{}",
                param.id(),
                form(param),
                hint(param, text)
            ))
        })?;
        values[param.values()].copy_from_slice(&parsed);
    }
    Ok(values)
}

fn unknown_param(filter: Filter, name: &str) -> String {
    let ids: Vec<&str> = filter.params().iter().map(|param| param.id()).collect();
    let near =
        nearest_word(name, ids.iter().copied()).map(|near| format!("; did you mean {near}?")).unwrap_or_default();
    format!("{} has no parameter {name}{near}; 'gusset filters {}' lists its parameters", filter.id(), filter.id())
}

/// Returns the word nearest to a mistyped one, if any is near.
pub(crate) fn nearest_word<'a>(typed: &str, words: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    const MIN_LIKENESS: f64 = 0.7;
    const MIN_PREFIX: usize = 3;
    let is_prefix = |word: &str| typed.len() >= MIN_PREFIX && word.starts_with(typed);
    words
        .map(|word| (if is_prefix(word) { 1.0 } else { likeness(typed, word) }, word))
        .filter(|(likeness, _)| *likeness >= MIN_LIKENESS)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, word)| word)
}

/// 1 less the edit distance over the length of the longer word.
fn likeness(a: &str, b: &str) -> f64 {
    let (a, b): (Vec<char>, Vec<char>) = (a.to_lowercase().chars().collect(), b.to_lowercase().chars().collect());
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.iter().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(x != y);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    1.0 - row[b.len()] as f64 / a.len().max(b.len()).max(1) as f64
}

fn hint(param: Param, text: &str) -> String {
    let slugs: Vec<String> = param.choices().iter().map(|(label, _)| slug(label)).collect();
    nearest_word(&slug(text), slugs.iter().map(String::as_str))
        .map(|near| format!("; did you mean {near}?"))
        .unwrap_or_default()
}

fn parse_value(param: Param, text: &str) -> Option<Vec<f64>> {
    let count = param.values().len();
    if count == 1 {
        return Some(vec![parse_component(param, text)?]);
    }
    let parts: Option<Vec<f64>> = text.split(',').map(|part| parse_component(param, part.trim())).collect();
    parts.filter(|parts| parts.len() == count)
}

fn parse_component(param: Param, text: &str) -> Option<f64> {
    if param.kind() == ParamKind::Bool {
        match text.to_ascii_lowercase().as_str() {
            "true" | "yes" => return Some(1.0),
            "false" | "no" => return Some(0.0),
            _ => {}
        }
    }
    if let Some(choice) = param.choices().iter().position(|(label, _)| slug(label) == slug(text)) {
        return Some(choice as f64);
    }
    let number: f64 = text.parse().ok()?;
    Some(if param.kind() == ParamKind::Angle { radians(number, param.range()) } else { number })
}

/// Converts degrees. A bound of the range that is typed as it is printed gives the bound itself.
fn radians(degrees: f64, range: [f64; 2]) -> f64 {
    range.into_iter().find(|&bound| self::degrees(bound) == degrees).unwrap_or_else(|| degrees.to_radians())
}

/// Returns an angle in degrees, with 12 significant digits.
pub(crate) fn degrees(radians: f64) -> f64 {
    format!("{:.11e}", radians.to_degrees()).parse().unwrap_or(radians.to_degrees())
}

/// Describes the values that a parameter takes.
pub(crate) fn form(param: Param) -> String {
    match param.kind() {
        ParamKind::Bool => "true or false".into(),
        ParamKind::Choice => {
            let slugs: Vec<String> = param.choices().iter().map(|(label, _)| slug(label)).collect();
            match slugs.split_last() {
                Some((last, rest)) if !rest.is_empty() => format!("{} or {last}", rest.join(", ")),
                _ => slugs.concat(),
            }
        }
        ParamKind::Angle => "an angle in degrees".into(),
        ParamKind::Integer => "a whole number".into(),
        _ if param.values().len() == 1 => "a number".into(),
        _ => format!("{} numbers separated by commas", param.values().len()),
    }
}

/// Writes a number with the fewest digits that read back as the same number.
pub(crate) fn print_number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 || (1e-5..1e16).contains(&size) { format!("{value}") } else { format!("{value:e}") }
}

/// Writes the value of a parameter as it is typed.
pub(crate) fn print_value(param: Param, values: &[f64]) -> String {
    if param.kind() == ParamKind::Bool {
        return (values[0] != 0.0).to_string();
    }
    if let Some((label, _)) = param.choices().get(values[0] as usize) {
        return slug(label);
    }
    let mut text = String::new();
    for (place, &value) in values.iter().enumerate() {
        let shown = if param.kind() == ParamKind::Angle { degrees(value) } else { value };
        let _ = write!(text, "{}{}", if place == 0 { "" } else { "," }, print_number(shown));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_become_words_to_type() {
        assert_eq!(slug("By mean edge"), "by-mean-edge");
        assert_eq!(slug("  None (0)  "), "none-0");
    }

    #[test]
    fn degrees_of_bounds_are_round() {
        assert_eq!(degrees(std::f64::consts::PI / 3.0), 60.0);
        assert_eq!(degrees(std::f64::consts::PI), 180.0);
        assert_eq!(radians(180.0, [0.0, std::f64::consts::PI]), std::f64::consts::PI);
        assert_eq!(radians(90.0, [0.0, 1.57]), 90.0_f64.to_radians());
    }

    #[test]
    fn near_words_are_suggested() {
        assert_eq!(nearest_word("stich", ["stitch", "fill"].into_iter()), Some("stitch"));
        assert_eq!(nearest_word("repair", ["stitch", "fill"].into_iter()), None);
    }
}
