//! Filters and their parameters as text.

use crate::commands::MAX_WIDTH;
use crate::plugin::{Filter, ParamKind};
use crate::report::kind_name;
use crate::values::{print_value, slug};

/// Lists filters in columns: id, inputs, outputs, category and name.
pub(crate) fn list_filters(filters: &[Filter]) -> String {
    let rows: Vec<[String; 4]> = filters
        .iter()
        .map(|filter| {
            [
                filter.id().into(),
                input_words(*filter),
                output_words(*filter),
                format!("{}: {}", filter.category(), filter.name()),
            ]
        })
        .collect();
    let widths: Vec<usize> = (0..3).map(|column| rows.iter().map(|row| row[column].len()).max().unwrap_or(0)).collect();
    rows.iter()
        .map(|[id, inputs, outputs, name]| {
            format!("{id:0$}  {inputs:1$}  -> {outputs:2$}  {name}\n", widths[0], widths[1], widths[2])
        })
        .collect()
}

fn input_words(filter: Filter) -> String {
    const MAX_SHOWN: usize = 4;
    let told = filter.min_inputs().max(filter.input_kinds().len());
    let shown = filter.max_inputs().filter(|&most| most <= MAX_SHOWN).unwrap_or(told);
    let words: Vec<String> = (0..shown)
        .map(|place| {
            let word = filter.input_kind(place).word();
            if place < filter.min_inputs() { word.to_owned() } else { format!("[{word}]") }
        })
        .collect();
    let more = if filter.max_inputs().is_none_or(|most| most > shown) { "..." } else { "" };
    if words.is_empty() { "-".into() } else { words.join(", ") + more }
}

fn output_words(filter: Filter) -> String {
    filter.output_kinds().iter().map(|kind| kind.word()).collect::<Vec<_>>().join(", ")
}

/// Describes a filter and its parameters. `suggested` holds the values that suit given inputs.
pub(crate) fn describe_filter(filter: Filter, suggested: Option<&[f64]>) -> String {
    let mut text = format!("{}: {}\n", filter.id(), filter.name());
    wrap(&mut text, "  ", filter.help());
    let replaces = if filter.replaces_input() { "; the first replaces the first input" } else { "" };
    text += &format!(
        "\n  category   {}\n  script     {}\n  inputs     {}\n  outputs    {}{replaces}\n",
        filter.category(),
        filter.script_name(),
        input_words(filter),
        output_words(filter)
    );
    wrap(&mut text, "  reference  ", filter.reference());
    for param in filter.params() {
        text += &format!(
            "\n  -p {}={}\n      {}: {}",
            param.id(),
            print_value(param, param.default_values()),
            param.label(),
            kind_name(param.kind())
        );
        if !matches!(param.kind(), ParamKind::Bool | ParamKind::Choice) {
            let [min, max] = param.range().map(|bound| print_value(param, &vec![bound; param.values().len()]));
            let first = |text: String| text.split(',').next().unwrap_or_default().to_owned();
            text += &format!(", from {} to {}", first(min), first(max));
        }
        text.push('\n');
        if let Some(suggested) = suggested {
            text += &format!("      for these inputs: {}\n", print_value(param, &suggested[param.values()]));
        }
        wrap(&mut text, "      ", param.help());
        for (label, help) in param.choices() {
            wrap(&mut text, &format!("        {}  ", slug(label)), help);
        }
    }
    text
}

/// Appends text in lines of at most [`MAX_WIDTH`] characters after a heading.
fn wrap(text: &mut String, heading: &str, words: &str) {
    let indent = " ".repeat(heading.len());
    let mut line = heading.to_owned();
    let mut is_empty = true;
    for word in words.split_whitespace() {
        if !is_empty && line.len() + 1 + word.len() > MAX_WIDTH {
            *text += &line;
            text.push('\n');
            line.clone_from(&indent);
            is_empty = true;
        }
        if !is_empty {
            line.push(' ');
        }
        line += word;
        is_empty = false;
    }
    *text += line.trim_end();
    text.push('\n');
}
