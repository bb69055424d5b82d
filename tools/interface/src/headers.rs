//! The headers: declarations as cbindgen writes them, in the order of the sources, each with its
//! comment.

use crate::comment::{Cause, Comment};
use crate::source::{Field, Item, Kind, Source, Type};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::Path;

/// Columns of a header.
const WIDTH: usize = 120;

/// The declarations of cbindgen without comments, by name.
///
/// # Errors
///
/// The error of cbindgen.
pub fn declarations(root: &Path, folder: &str, config: &str) -> Result<BTreeMap<String, String>, String> {
    let config = cbindgen::Config::from_file(root.join(config)).map_err(|error| error.to_string())?;
    let builder = cbindgen::Builder::new().with_src(root.join(folder).join("mod.rs")).with_config(config);
    let mut written = Vec::new();
    builder.generate().map_err(|error| error.to_string())?.write(&mut written);
    let text = String::from_utf8(written).map_err(|error| error.to_string())?;
    // Without the conditions that it repeats.
    let text =
        text.lines().map(|line| line.split_once(" // ").map_or(line, |(code, _)| code)).collect::<Vec<_>>().join("\n");
    Ok(text
        .split("\n\n")
        .filter_map(|block| declared(block).map(|name| (name, block.trim_matches('\n').to_owned())))
        .collect())
}

/// The text above the declarations of the first header: export macros, and the version.
pub fn prelude(version: &str) -> String {
    let mut numbers = version.splitn(3, '.');
    let mut part = || numbers.next().unwrap_or("0");
    let (major, minor, patch) = (part(), part(), part());
    format!(
        "#include <stddef.h>\n#include <stdint.h>\n\n#if defined(_WIN32) && defined(GUSSET_SHARED)\n#define GUSSET_API __declspec(dllimport)\n#elif defined(__GNUC__)\n\
         #define GUSSET_API __attribute__((visibility(\"default\")))\n#else\n#define GUSSET_API\n#endif\n\n\
         #if defined(__GNUC__)\n#define GUSSET_MUST_USE __attribute__((warn_unused_result))\n#else\n#define GUSSET_MUST_USE\n#endif\n\n\
         /// Version of this header; compare gusset_version().\n\
         #define GUSSET_VERSION_MAJOR {major}\n#define GUSSET_VERSION_MINOR {minor}\n#define GUSSET_VERSION_PATCH {patch}\n\
         #define GUSSET_VERSION_STRING \"{version}\"\n"
    )
}

/// The name that a declaration declares; none for declarations of others.
fn declared(block: &str) -> Option<String> {
    let block = block.trim();
    let ours = |word: &str| word.to_ascii_lowercase().starts_with("gusset_");
    let name = if let Some(rest) = block.strip_prefix("#define ") {
        words(rest).next()?
    } else if let Some(rest) = block.strip_prefix("enum ") {
        words(rest).next()?
    } else if block.starts_with("typedef") {
        match block.split_once("(*") {
            Some((_, rest)) if !block.contains('{') => words(rest).next()?,
            _ => words(block).last()?,
        }
    } else {
        let before = block.split_once('(')?.0;
        words(before).last()?
    };
    ours(name).then(|| name.to_owned())
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').filter(|word| !word.is_empty())
}

/// How a header is written.
pub trait Style {
    /// The comment of an item.
    fn comment(&self, source: &Source, item: &Item) -> Comment;
    /// The heading of the items of a file.
    fn heading(&self, source: &Source) -> String;
    /// The comment of a field, if it needs one; `type_brief` is the comment of its type.
    fn field(&self, field: &Field, type_brief: Option<&str>) -> Option<Comment>;
}

/// The declarations of a header.
pub struct Body {
    /// Its name without the ending.
    pub header: String,
    /// Lines that include others.
    pub includes: String,
    /// The declarations with their comments.
    pub text: String,
}

/// The headers that programs include.
pub struct Plain;

/// The comment without the tags that only generators read.
fn for_readers(comment: &Comment) -> Comment {
    let mut comment = comment.clone();
    comment.tags.retain(|(name, _)| !["flag", "shape", "option", "choice"].contains(&name.as_str()));
    comment
}

/// Shortens the comment of a function by what its declaration or the first page of gusset.h says.
fn shorten_function(item: &Item, params: &[Field]) -> Comment {
    let mut comment = item.comment.clone();
    let takes = |name: &str| params.iter().any(|param| param.name.contains(name) || param.kind.name == name);
    comment.errors.retain(|cause| match cause.status.as_str() {
        "WRONG_HANDLE" | "TOO_LARGE" => !cause.when.is_empty(),
        "BUFFER_TOO_SMALL" => !cause.when.is_empty() || !takes("capacity"),
        "as gusset_mesh_view" => !takes("gusset_mesh_view"),
        _ => true,
    });
    comment.tags.retain(|(name, text)| !(name == "complexity" && text == "O(1)."));
    comment.params = comment.params.into_iter().filter_map(without_receives).collect();
    let frees = item.name.ends_with("_destroy");
    let lends = item.name.contains("_get_") && comment.brief.starts_with("Lends ");
    if (frees || lends) && comment.is_plain() && comment.params.is_empty() && comment.errors.is_empty() {
        comment = Comment::default();
    }
    comment
}

/// The text of a parameter without "receives the"; none if a single word is left.
fn without_receives((name, text): (String, String)) -> Option<(String, String)> {
    let Some(rest) = text.strip_prefix("receives ") else { return Some((name, text)) };
    let rest = rest.strip_prefix("the ").unwrap_or(rest);
    rest.contains(' ').then(|| (name, rest.to_owned()))
}

/// True if the name of an item, its values or the function below it say what its comment says.
fn is_obvious(item: &Item) -> bool {
    let brief = &item.comment.brief;
    let said = match &item.kind {
        Kind::Struct(_) => brief.starts_with("Lent ") || brief.starts_with("Options of gusset_"),
        Kind::Choice(_) => true,
        _ => false,
    };
    said && item.comment.is_plain()
}

impl Style for Plain {
    fn comment(&self, _: &Source, item: &Item) -> Comment {
        match &item.kind {
            Kind::Function(params, _) => shorten_function(item, params),
            _ if is_obvious(item) => Comment::default(),
            _ => item.comment.clone(),
        }
    }

    fn field(&self, field: &Field, type_brief: Option<&str>) -> Option<Comment> {
        let Field { name, comment, .. } = field;
        // The first page of gusset.h says some once; a type says some; and a count needs no more
        // than its name.
        let begins = |words: &str| comment.is_plain() && comment.brief.starts_with(words);
        let counts = name.contains("count") && begins("Number of") || name.ends_with("stride") && begins("Stride of");
        let usual = ["struct_size", "reserved"].contains(&name.as_str());
        let said = usual || counts || type_brief == Some(&comment.brief) && comment.is_brief();
        (!said).then(|| for_readers(comment))
    }

    fn heading(&self, source: &Source) -> String {
        let title = source.comment.brief.split_once(": ").map_or(&*source.comment.brief, |(title, _)| title);
        let text = match source.comment.detail.as_str() {
            "" => title.to_owned(),
            detail => format!("{title}. {detail}"),
        };
        let lines = wrapped(&text, "", WIDTH - 8);
        lines.iter().map(|line| format!("/*** {line} */")).collect::<Vec<_>>().join("\n")
    }
}

/// The declarations of each header, in the order in which they include each other.
///
/// # Errors
///
/// A sentence about a missing declaration, or one that a header needs of a later header.
pub fn bodies(
    sources: &[Source],
    declarations: &BTreeMap<String, String>,
    style: &dyn Style,
) -> Result<Vec<Body>, String> {
    let sources = in_order(sources)?;
    let mut order: Vec<&str> = Vec::new();
    for source in &sources {
        if !order.contains(&source.header.as_str()) {
            order.push(&source.header);
        }
    }
    let home: BTreeMap<&str, usize> = sources
        .iter()
        .flat_map(|source| source.items.iter().map(|item| (item.name.as_str(), source.header.as_str())))
        .filter_map(|(name, header)| Some((name, order.iter().position(|other| *other == header)?)))
        .collect();
    let choices = sources.iter().flat_map(|source| &source.items).filter(|item| matches!(item.kind, Kind::Choice(_)));
    let briefs: BTreeMap<&str, &str> = choices.map(|item| (item.name.as_str(), item.comment.brief.as_str())).collect();
    let mut known = BTreeSet::new();
    let mut made = Vec::new();
    for (number, header) in order.iter().enumerate() {
        let (mut includes, mut tags) = (BTreeSet::new(), BTreeSet::new());
        let mut body = String::new();
        let own = || sources.iter().filter(|source| source.header == *header);
        for source in own() {
            if !source.comment.brief.is_empty() {
                let _ = writeln!(body, "\n{}", style.heading(source));
            }
            let mut last = "";
            for item in &source.items {
                let declaration =
                    declarations.get(&item.name).ok_or_else(|| format!("cbindgen does not declare {}", item.name))?;
                let mut ahead = BTreeSet::new();
                for (word, tag) in needs(item) {
                    if home.contains_key(word) && word != item.name && !known.contains(word) {
                        if !tag {
                            return Err(format!("{} needs {word}, which is declared after it", item.name));
                        }
                        ahead.insert(word);
                    } else if let Some(&place) = home.get(word).filter(|place| **place < number) {
                        includes.insert(order[place]);
                    }
                }
                for word in ahead.into_iter().filter(|word| tags.insert(*word)) {
                    let _ = writeln!(body, "\nstruct {word};");
                }
                // The values of a choice stand together.
                let family = if let Kind::Constant(kind, _) = &item.kind { kind.name.as_str() } else { "" };
                if family.is_empty() || family != last {
                    body.push('\n');
                }
                last = if let Kind::Choice(_) = item.kind { item.name.as_str() } else { family };
                body += &documented(source, item, declaration, &briefs, style);
                known.insert(item.name.as_str());
            }
        }
        let includes: String =
            order.iter().filter(|name| includes.contains(**name)).fold(String::new(), |mut text, name| {
                let _ = writeln!(text, "#include \"{name}.h\"");
                text
            });
        made.push(Body { header: (*header).to_owned(), includes, text: body });
    }
    Ok(made)
}

/// The names that an item needs, each with whether a declaration of its tag suffices.
fn needs(item: &Item) -> Vec<(&str, bool)> {
    match &item.kind {
        Kind::Struct(fields) => {
            fields.iter().flat_map(|field| field.called_with.iter().chain([&field.kind])).map(need).collect()
        }
        Kind::Callback(fields, result) | Kind::Function(fields, result) => {
            fields.iter().map(|field| need(&field.kind)).chain(result.as_ref().map(need)).collect()
        }
        Kind::Constant(kind, _) | Kind::Choice(kind) => vec![need(kind)],
        Kind::Handle | Kind::Enum(_) => Vec::new(),
    }
}

fn need(kind: &Type) -> (&str, bool) {
    (kind.name.as_str(), !kind.pointers.is_empty())
}

/// The files as they are listed, except that headers and files stand after those that they need.
fn in_order(sources: &[Source]) -> Result<Vec<&Source>, String> {
    let items = || sources.iter().flat_map(|source| &source.items);
    let by_tag =
        |name: &str| items().any(|item| item.name == name && matches!(item.kind, Kind::Struct(_) | Kind::Handle));
    let home = |name: &str| sources.iter().position(|source| source.items.iter().any(|item| item.name == name));
    // For each file the files that declare the types that it needs complete.
    let needed = |source: &Source| -> Vec<usize> {
        let names = source.items.iter().flat_map(needs).filter(|&(name, pointed)| !(pointed && by_tag(name)));
        names.filter_map(|(name, _)| home(name)).collect()
    };
    let needed: Vec<Vec<usize>> = sources.iter().map(needed).collect();
    let mut headers: Vec<&str> = sources.iter().map(|source| source.header.as_str()).collect();
    headers.dedup();
    let number = |file: usize| headers.iter().position(|header| *header == sources[file].header);
    let between: Vec<Vec<usize>> = (0..headers.len())
        .map(|header| {
            let own = (0..sources.len()).filter(|&file| number(file) == Some(header));
            own.flat_map(|file| &needed[file])
                .filter_map(|&file| number(file))
                .filter(|&other| other != header)
                .collect()
        })
        .collect();
    let mut order = Vec::new();
    for header in sorted(&between).map_err(|at| format!("{}.h needs a header that needs it", headers[at]))? {
        let own: Vec<usize> = (0..sources.len()).filter(|&file| number(file) == Some(header)).collect();
        let within: Vec<Vec<usize>> = own
            .iter()
            .map(|&file| {
                needed[file]
                    .iter()
                    .filter(|&&other| other != file)
                    .filter_map(|other| own.iter().position(|file| file == other))
                    .collect()
            })
            .collect();
        let files =
            sorted(&within).map_err(|at| format!("src/capi/{} needs a file that needs it", sources[own[at]].path))?;
        order.extend(files.into_iter().map(|file| &sources[own[file]]));
    }
    Ok(order)
}

/// An order in which each file follows the files that it needs, and otherwise keeps its number; or
/// a file that needs itself.
pub(crate) fn sorted(needed: &[Vec<usize>]) -> Result<Vec<usize>, usize> {
    fn visit(at: usize, needed: &[Vec<usize>], open: &mut Vec<usize>, order: &mut Vec<usize>) -> Result<(), usize> {
        if order.contains(&at) {
            return Ok(());
        }
        if open.contains(&at) {
            return Err(at);
        }
        open.push(at);
        for &other in &needed[at] {
            visit(other, needed, open, order)?;
        }
        open.pop();
        order.push(at);
        Ok(())
    }
    let mut order = Vec::new();
    for at in 0..needed.len() {
        visit(at, needed, &mut Vec::new(), &mut order)?;
    }
    Ok(order)
}

/// The text around the declarations of a header.
pub struct Frame<'a> {
    /// Its opening comment.
    pub opening: &'a str,
    /// The macro that keeps it from being read twice.
    pub guard: &'a str,
    /// Lines above the declarations: includes, macros.
    pub above: &'a str,
}

/// A whole header.
pub fn framed(frame: &Frame<'_>, body: &str) -> String {
    let Frame { opening, guard, above } = frame;
    format!(
        "{opening}\n\n#ifndef {guard}\n#define {guard}\n{above}\n#ifdef __cplusplus\nextern \"C\" {{\n#endif\n{body}\n\
         #ifdef __cplusplus\n}}\n#endif\n#endif\n"
    )
}

/// A declaration with its comment before it, and the comments of its fields or values within.
fn documented(
    source: &Source,
    item: &Item,
    declaration: &str,
    briefs: &BTreeMap<&str, &str>,
    style: &dyn Style,
) -> String {
    let mut text = comment_lines(&style.comment(source, item), "");
    let inner: Vec<(&str, Option<Comment>)> = match &item.kind {
        Kind::Struct(fields) => {
            let comment = |field: &Field| style.field(field, briefs.get(field.kind.name.as_str()).copied());
            fields.iter().map(|field| (field.name.as_str(), comment(field))).collect()
        }
        Kind::Enum(values) => values.iter().map(|(name, _, comment)| (name.as_str(), Some(comment.clone()))).collect(),
        _ => Vec::new(),
    };
    if let Kind::Function(..) = item.kind {
        // Lines end after a parameter.
        let words: Vec<&str> = declaration.split_whitespace().collect();
        let declaration = words.join(" ").replace(' ', "\u{a0}").replace(",\u{a0}", ", ");
        for line in wrapped(&declaration, "    ", WIDTH) {
            text += &line.replace('\u{a0}', " ");
            text.push('\n');
        }
        return text;
    }
    let mut inner = inner.into_iter().peekable();
    for line in declaration.lines() {
        let indent = &line[..line.len() - line.trim_start().len()];
        if let Some((_, comment)) =
            inner.next_if(|(name, _)| !indent.is_empty() && words(line).any(|word| word == *name))
        {
            text += &comment.map(|comment| comment_lines(&comment, indent)).unwrap_or_default();
        }
        text += line;
        text.push('\n');
    }
    text
}

pub(crate) fn comment_lines(comment: &Comment, indent: &str) -> String {
    let mut text = String::new();
    let mut paragraph = |words: &str, hanging: &str| {
        for line in wrapped(words, hanging, WIDTH - 4 - indent.len()) {
            let _ = writeln!(text, "{indent}/// {line}");
        }
    };
    paragraph(&format!("{} {}", comment.brief, comment.detail), "");
    for words in &comment.text {
        let hanging = if words.starts_with("- ") { "  " } else { "" };
        paragraph(words, hanging);
    }
    for (name, words) in &comment.params {
        paragraph(&format!("@param {name} {words}"), "    ");
    }
    if !comment.errors.is_empty() {
        let causes: Vec<_> = comment.errors.iter().map(Cause::to_string).collect();
        paragraph(&format!("@errors {}", causes.join(", ")), "    ");
    }
    for (name, words) in &comment.tags {
        let mut lines = words.split('\n');
        paragraph(format!("@{name} {}", lines.next().unwrap_or_default()).trim_end(), "    ");
        lines.for_each(|line| paragraph(line, ""));
    }
    text
}

/// Lines of at most `width` characters, all but the first after `hanging`.
fn wrapped(text: &str, hanging: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ').filter(|word| !word.is_empty()) {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= width => {
                line.push(' ');
                line.push_str(word);
            }
            Some(_) => lines.push(format!("{hanging}{word}")),
            None => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The comment of a function of a list of numbers, as headers have it.
    fn shortened(name: &str, text: &str) -> String {
        let comment = Comment::parse(&text.lines().map(str::to_owned).collect::<Vec<_>>()).unwrap();
        let kind = Type { name: "size_t".to_owned(), pointers: Vec::new(), sizes: Vec::new() };
        let capacity =
            Field { name: "capacity".to_owned(), kind, comment: Comment::default(), called_with: Vec::new() };
        let item = Item { name: name.to_owned(), kind: Kind::Function(Vec::new(), None), comment };
        comment_lines(&shorten_function(&item, &[capacity]), "")
    }

    #[test]
    fn functions_leave_out_what_holds_for_all() {
        let text = "Lists nodes.\n@param out receives the nodes of a net.\n@param ends receives ends.\n\
                    @errors BUFFER_TOO_SMALL, TOO_LARGE, NO_GRID (face)\n@complexity O(1).";
        let expected = "/// Lists nodes.\n/// @param out nodes of a net.\n/// @errors NO_GRID (face)\n";
        assert_eq!(shortened("gusset_net_list", text), expected);
        assert_eq!(shortened("gusset_net_destroy", "Destroys a net."), "");
        assert_eq!(shortened("gusset_net_get_view", "Lends the nodes."), "");
        assert_eq!(
            shortened("gusset_net_get_view", "Lends the nodes.\n@complexity O(nodes)."),
            "/// Lends the nodes.\n/// @complexity O(nodes).\n"
        );
    }
}
