//! The grammar of comments of the C interface.
//!
//! A comment is a brief (its first sentence), paragraphs of text, and tags. A tag begins a line
//! with `@`, and lasts until the next tag. Programs read the tags; nobody reads the text but
//! people. A line that begins with `- ` is an item of a list.
//!
//! | tag | of | content |
//! |---|---|---|
//! | `@param name text` | functions | shape, unit and range of a parameter |
//! | `@errors A (when), as gusset_f, B` | functions, structs | statuses without `GUSSET_ERROR_`;
//! `as`: the errors of another function or struct |
//! | `@return text` | functions without a status | the result |
//! | `@complexity text` | functions | time and memory |
//! | `@threads text` | functions | which threads may call it |
//! | `@source text` | functions, files | paper, section, equation |
//! | `@when neighbour A, B` | fields, parameters | it is read only if a neighbour has one of these values |
//! | `@values A, B` | fields | the only constants of its choice that it takes |
//! | `@flag` | fields, parameters | 0 or 1, or an array of these |
//! | `@option` | fields | an option in a struct of other inputs |
//! | `@choice name` | fields | its numbers are constants of a choice that its type does not name |
//! | `@shape count 3` | fields | the sizes of an array, from the outside in: see [`size_field`] |
//! | `@bits` | choices | values are bits, which may be combined |

use serde::Serialize;
use std::fmt;

/// A status that a function returns, and the case.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Cause {
    /// The status without its prefix, or, after `as `, a function or struct.
    pub status: String,
    /// When it is returned, if the status alone does not say it.
    pub when: String,
}

impl fmt::Display for Cause {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.when.as_str() {
            "" => out.write_str(&self.status),
            when => write!(out, "{} ({when})", self.status),
        }
    }
}

/// A parsed comment.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
pub struct Comment {
    /// The first sentence.
    pub brief: String,
    /// The rest of the first paragraph.
    pub detail: String,
    /// All later paragraphs and items of lists.
    pub text: Vec<String>,
    /// Names and texts of parameters.
    #[serde(skip)]
    pub params: Vec<(String, String)>,
    /// The errors of a function besides the errors of every function.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub errors: Vec<Cause>,
    /// All other tags with their contents, in their order.
    #[serde(skip)]
    pub tags: Vec<(String, String)>,
}

/// Tags with free contents.
const TAGS: [&str; 11] =
    ["return", "complexity", "threads", "source", "when", "flag", "bits", "values", "choice", "shape", "option"];

impl Comment {
    /// Parses the lines of a comment.
    ///
    /// # Errors
    ///
    /// A sentence about the first line that the grammar does not allow.
    pub fn parse(lines: &[String]) -> Result<Self, String> {
        let mut comment = Comment::default();
        let mut paragraphs = vec![String::new()];
        let mut tags: Vec<(String, String)> = Vec::new();
        for line in lines.iter().map(|line| line.trim()) {
            if line.starts_with('|') {
                // A table is for readers of the sources.
            } else if let Some(tag) = line.strip_prefix('@') {
                let (name, content) = tag.split_once(' ').unwrap_or((tag, ""));
                tags.push((name.to_owned(), content.trim().to_owned()));
            } else if let Some((_, content)) = tags.last_mut() {
                append(content, line);
            } else if line.is_empty() {
                paragraphs.push(String::new());
            } else if line.starts_with("- ") {
                paragraphs.push(line.to_owned());
            } else if let Some(paragraph) = paragraphs.last_mut() {
                append(paragraph, line);
            }
        }
        paragraphs.retain(|paragraph| !paragraph.is_empty());
        if let Some(first) = paragraphs.first() {
            let end = first_sentence(first);
            comment.brief = first[..end].trim().to_owned();
            comment.detail = first[end..].trim().to_owned();
        }
        comment.text = paragraphs.into_iter().skip(1).collect();
        for (name, content) in tags {
            match name.as_str() {
                "param" | "param[out]" | "param[in,out]" => {
                    let (param, text) =
                        content.split_once(' ').ok_or_else(|| format!("@param {content} has no text"))?;
                    comment.params.push((param.to_owned(), text.trim().to_owned()));
                }
                "errors" => comment.errors = causes(&content)?,
                _ if TAGS.contains(&name.as_str()) => {
                    if name == "shape" {
                        content.split(' ').try_for_each(|size| size_field(size).map(drop))?;
                    }
                    comment.tags.push((name, content));
                }
                _ => return Err(format!("@{name} is not a tag of the grammar")),
            }
        }
        Ok(comment)
    }

    /// True if there is nothing but a brief.
    pub fn is_brief(&self) -> bool {
        self.detail.is_empty() && self.text.is_empty() && self.tags.is_empty()
    }

    /// True if there is nothing but a short brief.
    pub fn is_plain(&self) -> bool {
        self.is_brief() && self.brief.split(' ').count() <= 5
    }

    /// The content of a tag.
    pub fn tag(&self, name: &str) -> Option<&str> {
        self.tags.iter().find(|(tag, _)| tag == name).map(|(_, content)| content.as_str())
    }
}

/// The field that a size of `@shape` refers to.
///
/// A size is a number, a field of the struct, a field plus or divided by a number, or `*`, the size
/// that follows from the number of elements. The name of an array means its length; a field of
/// several numbers has one for each of several arrays. Options may refer to a parameter of their
/// function.
///
/// # Errors
///
/// A sentence about a size that is none of these.
pub fn size_field(size: &str) -> Result<Option<&str>, String> {
    let is_number = |text: &str| !text.is_empty() && text.bytes().all(|digit| digit.is_ascii_digit());
    let is_name = |text: &str| {
        text.starts_with(|c: char| c.is_ascii_lowercase())
            && text.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
    };
    let (name, number) = size.split_once(['+', '/']).unwrap_or((size, "1"));
    if size == "*" || is_number(size) {
        Ok(None)
    } else if is_name(name) && is_number(number) {
        Ok(Some(name))
    } else {
        Err(format!("@shape: {size:?} is not a size"))
    }
}

fn append(text: &mut String, line: &str) {
    if !text.is_empty() && !line.is_empty() {
        text.push(' ');
    }
    text.push_str(line);
}

/// Where the first sentence of a paragraph ends.
fn first_sentence(paragraph: &str) -> usize {
    let ends = paragraph.match_indices(['.', ';']).filter(|&(at, end)| {
        let rest = &paragraph[at + end.len()..];
        end == "." && rest.starts_with(' ') && rest[1..].starts_with(|c: char| !c.is_lowercase())
    });
    // A dot after a single letter is an initial's.
    let initial =
        |at: usize| at < 2 || paragraph[..at].ends_with(char::is_uppercase) && paragraph[..at - 1].ends_with(' ');
    ends.map(|(at, _)| at).find(|&at| !initial(at)).map_or(paragraph.len(), |at| at + 1)
}

/// The entries of a list of errors.
fn causes(content: &str) -> Result<Vec<Cause>, String> {
    let mut entries = vec![String::new()];
    let mut depth = 0_usize;
    for letter in content.trim_end_matches('.').chars() {
        match letter {
            '(' => depth += 1,
            ')' => {
                depth = depth.checked_sub(1).ok_or_else(|| format!("@errors {content}: a bracket closes nothing"))?;
            }
            ',' if depth == 0 => {
                entries.push(String::new());
                continue;
            }
            _ => {}
        }
        entries.last_mut().unwrap_or(&mut String::new()).push(letter);
    }
    entries.iter().map(|entry| cause(entry.trim())).collect()
}

fn cause(entry: &str) -> Result<Cause, String> {
    let (status, when) = match entry.split_once(" (") {
        Some((status, when)) => {
            (status, when.strip_suffix(')').ok_or_else(|| format!("@errors: {entry}: text after the bracket"))?)
        }
        None => (entry, ""),
    };
    let name = status.strip_prefix("as ").unwrap_or(status);
    let plain = !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    let (status, when) = (status.to_owned(), when.to_owned());
    if plain { Ok(Cause { status, when }) } else { Err(format!("@errors: {entry:?} is not a status")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Result<Comment, String> {
        Comment::parse(&text.lines().map(str::to_owned).collect::<Vec<_>>())
    }

    #[test]
    fn a_comment_has_a_brief_text_and_tags() {
        let comment = parse("Joins two loops, after\nG. Turk. More of it.\n\nA paragraph.\n@param a rows x 3\n  numbers.\n@flag\n@errors A, B (if x, y), as gusset_f").unwrap();
        assert_eq!(comment.brief, "Joins two loops, after G. Turk.");
        assert_eq!((comment.detail.as_str(), &comment.text[..]), ("More of it.", &["A paragraph.".to_owned()][..]));
        assert_eq!(comment.params, [("a".to_owned(), "rows x 3 numbers.".to_owned())]);
        assert_eq!(comment.tag("flag"), Some(""));
        let errors: Vec<_> = comment.errors.iter().map(|cause| (cause.status.as_str(), cause.when.as_str())).collect();
        assert_eq!(errors, [("A", ""), ("B", "if x, y"), ("as gusset_f", "")]);
    }

    #[test]
    fn sizes_are_numbers_or_refer_to_fields() {
        assert_eq!(parse("A.\n@shape rows+1 *").unwrap().tag("shape"), Some("rows+1 *"));
        let fields = ["*", "3", "rows", "rows+1", "on_curve_count/3"].map(|size| size_field(size).unwrap());
        assert_eq!(fields, [None, None, Some("rows"), Some("rows"), Some("on_curve_count")]);
    }

    #[test]
    fn the_grammar_refuses_the_rest() {
        for text in [
            "@since 0.1",
            "@param a",
            "@errors A, of B",
            "@errors A (b) c",
            "@errors A)",
            "@errors",
            "@shape",
            "@shape a*2",
            "@shape N",
            "@shape +1",
        ] {
            assert!(parse(text).is_err(), "{text}");
        }
    }
}
