//! The texts of statuses and choices, for programs that show them.

use crate::source::{Kind, Source};
use std::fmt::Write;

const WRITTEN: &str = "//! Written by `gusset-interface headers`; do not edit.\n\n";

fn head(what: &str) -> String {
    format!("//! The text of each {what}: the first sentence of its comment.\n//!\n{WRITTEN}use std::ffi::CStr;\n\n")
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

/// A table of choices for each header with its name, then `mod`, which searches all tables.
pub fn choices(sources: &[Source]) -> Vec<(String, String)> {
    let mut headers: Vec<&str> =
        sources.iter().filter(|source| has_choice(source)).map(|source| &*source.header).collect();
    headers.sort_unstable();
    headers.dedup();
    let mut files: Vec<_> = headers.iter().map(|header| ((*header).to_owned(), table(sources, header))).collect();
    files.push(("mod".to_owned(), search(&headers)));
    files
}

fn has_choice(source: &Source) -> bool {
    source.items.iter().any(|item| matches!(item.kind, Kind::Choice(_)))
}

/// The table of the choices of a header.
fn table(sources: &[Source], header: &str) -> String {
    let items = || sources.iter().filter(|source| source.header == header).flat_map(|source| &source.items);
    let mut code = format!("//! Choices of gusset/{header}.h.\n//!\n{WRITTEN}use std::ffi::CStr;\n\n");
    code += "/// The name of each choice, and its constants with their texts.\n#[rustfmt::skip]\n";
    code += "pub(super) const CHOICES: &[(&str, &[(u32, &CStr)])] = &[\n";
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

/// The module that searches the tables of headers.
fn search(headers: &[&str]) -> String {
    let mut code = head("constant of a choice");
    for header in headers {
        let _ = writeln!(code, "mod {header};");
    }
    let tables: Vec<_> = headers.iter().map(|header| format!("{header}::CHOICES")).collect();
    let _ = write!(
        code,
        "\n/// The name of a choice, and its constants with their texts.\n\
         type Choice = (&'static str, &'static [(u32, &'static CStr)]);\n\n\
         /// The choices of each header.\n#[rustfmt::skip]\n\
         static TABLES: [&[Choice]; {}] = [\n    {},\n];\n\n\
         /// The text of a constant of a choice; none if either is unknown.\n\
         pub(super) fn choice_text(choice: &str, value: u32) -> Option<&'static CStr> {{\n    \
         let (_, texts) = TABLES.into_iter().flatten().find(|(name, _)| *name == choice)?;\n    \
         texts.iter().find(|(constant, _)| *constant == value).map(|(_, text)| *text)\n}}\n",
        tables.len(),
        tables.join(",\n    "),
    );
    code
}
