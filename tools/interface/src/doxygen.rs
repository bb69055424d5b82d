//! Additions of the reference to the comments of the headers: groups, links, the parameters that
//! all functions share, examples.

use crate::comment::Comment;
use crate::headers::Style;
use crate::source::{Field, Item, Kind, Source};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// For each function of C the file and the block of the first example that calls it.
pub type Examples = BTreeMap<String, (String, String)>;

/// Finds the blocks of examples: lines between `//! [name]` and the next such line.
///
/// # Errors
///
/// A folder that cannot be read.
pub fn examples(folder: &Path) -> Result<Examples, String> {
    let failed = |error: std::io::Error| format!("{}: {error}", folder.display());
    let mut paths: Vec<_> =
        fs::read_dir(folder).map_err(failed)?.filter_map(|entry| entry.ok().map(|entry| entry.path())).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "c"));
    paths.sort();
    let mut found = Examples::new();
    for path in paths {
        let file = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let mut block: Option<String> = None;
        for line in fs::read_to_string(&path).map_err(failed)?.lines() {
            if let Some(name) = line.strip_prefix("//! [").and_then(|rest| rest.strip_suffix(']')) {
                block = if block.is_some() { None } else { Some(name.to_owned()) };
            } else if let Some(block) = &block {
                for called in calls(line) {
                    found.entry(called.to_owned()).or_insert_with(|| (file.clone(), block.clone()));
                }
            }
        }
    }
    Ok(found)
}

/// The functions of the library that a line calls.
pub fn calls(line: &str) -> impl Iterator<Item = &str> {
    line.match_indices("gusset_").filter_map(|(at, _)| {
        let begins = !line[..at].ends_with(|c: char| c.is_ascii_alphanumeric() || c == '_');
        let end = line[at..].find(|c: char| !c.is_ascii_alphanumeric() && c != '_').map(|length| at + length)?;
        (begins && line[end..].starts_with('(')).then(|| &line[at..end])
    })
}

/// The style of the reference.
pub struct Reference<'a> {
    /// All files.
    pub sources: &'a [Source],
    /// Where functions are called.
    pub examples: &'a Examples,
}

/// The name of a file's group.
fn group(source: &Source) -> String {
    source.path.replace('/', "_")
}

impl Reference<'_> {
    fn items(&self) -> impl Iterator<Item = &Item> {
        self.sources.iter().flat_map(|source| &source.items)
    }

    fn has_size(&self, name: &str) -> bool {
        let sized = |fields: &[Field]| fields.first().is_some_and(|field| field.name == "struct_size");
        self.items().any(|item| item.name == name && matches!(&item.kind, Kind::Struct(fields) if sized(fields)))
    }

    fn is_handle(&self, name: &str) -> bool {
        self.items().any(|item| item.name == name && matches!(item.kind, Kind::Handle))
    }

    /// The text for a parameter of this name or type in every function, so that comments omit it.
    pub fn usual(&self, param: &Field) -> Option<String> {
        let kind = &param.kind;
        if self.items().any(|item| item.name == kind.name && matches!(item.kind, Kind::Choice(_))) {
            return Some(format!("see {}.", kind.name));
        }
        let counts = param.name.contains("count") || param.name == "capacity";
        if kind.name == "size_t" && kind.pointers.is_empty() && counts {
            return Some("number of elements of the array before it.".to_owned());
        }
        let text = match (param.name.as_str(), kind.pointers.as_slice()) {
            ("context", [_]) => Some("threads, progress, cancellation and error report; NULL for the defaults."),
            ("options", [true]) => Some("NULL for the defaults."),
            ("written", [false]) => Some("receives the number of elements."),
            ("index" | "entry" | "group" | "child", []) => Some("its index."),
            ("size", []) => Some("number of bytes."),
            ("user", [_]) => Some("passed to the callback."),
            (_, [false, false]) if self.is_handle(&kind.name) => Some("receives the handle; NULL after an error."),
            (_, [_]) if self.is_handle(&kind.name) => Some("the handle."),
            (_, [true]) if kind.name == "gusset_mesh_view" => Some("a mesh."),
            (_, [false]) if self.has_size(&kind.name) => Some("receives the struct; set its struct_size."),
            _ => None,
        };
        let is_struct = || self.items().any(|item| item.name == kind.name && matches!(item.kind, Kind::Struct(_)));
        text.map(str::to_owned).or_else(|| is_struct().then(|| format!("see {}.", kind.name)))
    }
}

/// Text in which doxygen sees no commands.
fn escaped(text: &str) -> String {
    text.replace('<', "\\<").replace('>', "\\>").replace('#', "\\#")
}

/// A comment with tags as sentences, and without commands in its text.
fn cleaned(comment: &Comment) -> Comment {
    let mut comment = comment.clone();
    comment.brief = escaped(&comment.brief);
    comment.detail = escaped(&comment.detail);
    comment.text = comment.text.iter().map(|text| escaped(text)).collect();
    let said = |(name, text): &(String, String)| match name.as_str() {
        "when" => text.split_once(' ').map(|(field, values)| format!("Read only if {field} is {values}.")),
        "flag" => Some("0 or 1.".to_owned()),
        "bits" => Some("A sum of constants.".to_owned()),
        "option" => Some(String::new()),
        "values" => Some(format!("Takes {text} only.")),
        "choice" => Some(format!("See {text}.")),
        "shape" => Some(format!("Shape: {}.", text.replace('*', "n").replace(' ', " x "))),
        _ => None,
    };
    let sentences: Vec<String> = comment.tags.iter().filter_map(said).filter(|said| !said.is_empty()).collect();
    comment.detail = format!("{} {}", comment.detail, sentences.join(" ")).trim().to_owned();
    comment.tags.retain(|tag| said(tag).is_none());
    for (_, text) in &mut comment.tags {
        *text = escaped(text);
    }
    comment
}

impl Style for Reference<'_> {
    fn field(&self, field: &Field, _: Option<&str>) -> Option<Comment> {
        Some(cleaned(&field.comment))
    }

    fn comment(&self, source: &Source, item: &Item) -> Comment {
        let mut comment = cleaned(&item.comment);
        if let Kind::Function(params, result) = &item.kind {
            let given = std::mem::take(&mut comment.params);
            let text =
                |param: &Field| given.iter().find(|(name, _)| *name == param.name).map(|(_, text)| escaped(text));
            comment.params = params
                .iter()
                .map(|param| (param.name.clone(), text(param).or_else(|| self.usual(param)).unwrap_or_default()))
                .collect();
            if result.as_ref().is_some_and(|kind| kind.name == "gusset_status") {
                let causes = comment.errors.iter().map(|cause| match cause.status.strip_prefix("as ") {
                    Some(other) => format!("those of {other}"),
                    None => format!("::GUSSET_ERROR_{}", cause.to_string().replace('<', "\\<").replace('>', "\\>")),
                });
                let causes: Vec<_> = causes.chain(["those of every function".to_owned()]).collect();
                comment.tags.insert(0, ("return".into(), format!("::GUSSET_OK, or an error: {}.", causes.join(", "))));
            }
            if let Some((file, block)) = self.examples.get(&item.name) {
                let from =
                    format!("Example\nFrom examples/reference/{file}. MUST: the call succeeds; HOLDS: so it is.");
                comment.tags.push(("par".into(), from));
                comment.tags.push(("snippet".into(), format!("{file} {block}")));
            }
        }
        comment.errors.clear();
        comment.tags.push(("ingroup".into(), group(source)));
        comment
    }

    fn heading(&self, source: &Source) -> String {
        let (title, brief) =
            source.comment.brief.split_once(": ").unwrap_or((source.path.as_str(), source.comment.brief.as_str()));
        let mut lines = vec![format!("@defgroup {} {title}", group(source)), format!("@brief {brief}")];
        if let Some((folder, _)) = source.path.split_once('/') {
            lines.push(format!("@ingroup {folder}"));
        }
        if !source.comment.detail.is_empty() {
            lines.push(String::new());
            lines.push(source.comment.detail.clone());
        }
        if let Some(origin) = source.comment.tag("source") {
            lines.push(format!("@source {origin}"));
        }
        format!(
            "/**\n{}\n */",
            lines.iter().map(|line| format!(" * {line}").trim_end().to_owned()).collect::<Vec<_>>().join("\n")
        )
    }
}
