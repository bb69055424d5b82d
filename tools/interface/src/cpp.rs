//! The choices of the C interface as enums of C++.

use crate::source::{Kind, Source};
use std::fmt::Write;

/// Keywords of C++, and the words of the enums in their place.
const KEYWORDS: [(&str, &str); 1] = [("auto", "automatic")];
/// Columns of a header.
const WIDTH: usize = 120;
/// The function that gives the texts of all choices.
const TEXT: &str = "/// Describes a value of a choice in a sentence. See ::gusset_choice_text.
template <class Choice>
auto text(Choice value) -> decltype(choice_name(value)) {
    return gusset_choice_text(choice_name(value), static_cast<uint32_t>(value));
}
";

/// The names and values of the constants of a choice.
pub fn enumerators<'a>(sources: &'a [Source], choice: &'a str) -> impl Iterator<Item = (&'a str, &'a str)> {
    sources.iter().flat_map(|source| &source.items).filter_map(move |item| match &item.kind {
        Kind::Constant(kind, value) if kind.name == choice => Some((item.name.as_str(), value.as_str())),
        _ => None,
    })
}

/// The enumerators of a choice in C++, with their values.
pub fn words(sources: &[Source], choice: &str) -> Vec<(String, String)> {
    let (names, values): (Vec<&str>, Vec<&str>) = enumerators(sources, choice).unzip();
    let shared = shared_prefix(&names);
    names.iter().map(|name| word(&name[shared..])).zip(values.into_iter().map(str::to_owned)).collect()
}

/// The text of `gusset/choices.hpp`: an enum and its texts for each choice, except sets of bits. For the reference each enumerator refers to
/// its constant.
pub fn choices(sources: &[Source], for_reference: bool) -> String {
    let items = || sources.iter().flat_map(|source| &source.items);
    let mut text = String::from(
        "/// @file\n/// The choices of gusset.h as enums. Generated from src/capi; do not edit. Include gusset.hpp, not this.\n\
         #ifndef GUSSET_CHOICES_HPP\n#define GUSSET_CHOICES_HPP\n\n#include <gusset.h>\n\nnamespace gusset {\n",
    );
    let mut names_of_types = String::new();
    for item in items() {
        let Kind::Choice(_) = item.kind else { continue };
        if item.comment.tag("bits").is_some() {
            continue;
        }
        let names = enumerators(sources, &item.name).map(|(name, _)| name);
        let said = |name: &str| if for_reference { format!("/** See ::{name}. */ ") } else { String::new() };
        let values: Vec<String> = names
            .zip(words(sources, &item.name))
            .map(|(name, (word, _))| format!("{}{word} = {name}", said(name)))
            .collect();
        let _ = write!(text, "\n/// {} See ::{}.\n", item.comment.brief, item.name);
        let name = camel_case(&item.name);
        let head = format!("enum class {name} : uint32_t {{");
        let line = format!("{head} {} }};", values.join(", "));
        if line.len() <= WIDTH {
            let _ = writeln!(text, "{line}");
        } else {
            let _ = writeln!(text, "{head}\n    {}\n}};", values.join(",\n    "));
        }
        let _ = writeln!(names_of_types, "constexpr const char *choice_name({name}) {{ return \"{}\"; }}", item.name);
    }
    let _ = write!(text, "\n/// @cond\n{names_of_types}/// @endcond\n\n{TEXT}\n}} // namespace gusset\n\n#endif\n");
    text
}

/// The length of what all names begin with, up to an underscore.
pub fn shared_prefix(names: &[&str]) -> usize {
    let Some(first) = names.first() else { return 0 };
    let ends = first.match_indices('_').map(|(at, _)| at + 1);
    ends.filter(|&end| names.iter().all(|name| name.len() > end && name.starts_with(&first[..end]))).max().unwrap_or(0)
}

fn word(name: &str) -> String {
    let lower = name.to_lowercase();
    KEYWORDS.iter().find(|(keyword, _)| *keyword == lower).map_or(lower, |(_, word)| (*word).to_owned())
}

/// `FacingRun` of `gusset_facing_run`.
pub fn camel_case(name: &str) -> String {
    let parts = name.trim_start_matches("gusset_").split('_');
    parts.map(|part| part[..1].to_uppercase() + &part[1..]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_lose_what_all_share() {
        assert_eq!(shared_prefix(&["GUSSET_GAP_AUTO", "GUSSET_GAP_GIVEN"]), "GUSSET_GAP_".len());
        assert_eq!(shared_prefix(&["GUSSET_F32", "GUSSET_F64"]), "GUSSET_".len());
        assert_eq!(shared_prefix(&["GUSSET_JOIN_WELD", "GUSSET_JOIN_WELD_ALL"]), "GUSSET_JOIN_".len());
        assert_eq!((camel_case("gusset_facing_run"), word("AUTO")), ("FacingRun".to_owned(), "automatic".to_owned()));
    }
}
