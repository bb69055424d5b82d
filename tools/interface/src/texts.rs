//! The texts of statuses and choices, for programs that show them.

use crate::source::{Kind, Source};
use std::fmt::Write;

fn head(what: &str) -> String {
    format!(
        "//! The text of each {what}: the first sentence of its comment.\n//!\n\
         //! Written by `gusset-interface headers`; do not edit.\n\n\
         use std::ffi::CStr;\n\n"
    )
}

/// The function `text(status)`. A text can follow a colon: it begins in lower case, without a dot.
pub fn statuses(sources: &[Source]) -> String {
    let mut code = head("status");
    code += "/// The text of a status, without a dot.\npub(super) fn status_text(status: i32) -> &'static CStr {\n    match status {\n";
    for item in sources.iter().flat_map(|source| &source.items) {
        let Kind::Enum(values) = &item.kind else { continue };
        for (_, number, comment) in values {
            let sentence = comment.brief.trim_end_matches('.');
            let (first, rest) = sentence.split_at(sentence.chars().next().map_or(0, char::len_utf8));
            let _ = writeln!(code, "        {number} => c{:?},", format!("{}{rest}", first.to_lowercase()));
        }
    }
    code += "        _ => c\"unknown status\",\n    }\n}\n";
    code
}

/// The table `TEXTS` of all choices.
pub fn choices(sources: &[Source]) -> String {
    let items = || sources.iter().flat_map(|source| &source.items);
    let mut code = head("constant of a choice");
    code += "/// The constants of a choice, each with its text.\ntype Texts = &'static [(u32, &'static CStr)];\n\n\
             /// The name of each choice, and its texts.\n#[rustfmt::skip]\npub(super) static TEXTS: &[(&str, Texts)] = &[\n";
    for choice in items().filter(|item| matches!(item.kind, Kind::Choice(_))) {
        let _ = writeln!(code, "    ({:?}, &[", choice.name);
        for item in items() {
            if let Kind::Constant(kind, value) = &item.kind
                && kind.name == choice.name
            {
                let _ = writeln!(code, "        ({value}, c{:?}),", item.comment.brief);
            }
        }
        code += "    ]),\n";
    }
    code += "];\n";
    code
}
