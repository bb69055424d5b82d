//! Reads the Rust sources of the C interface, and writes what follows from them.
//!
//! | module | purpose |
//! |---|---|
//! | [`comment`] | parses comments: the grammar of their tags |
//! | [`cpp`] | writes the choices as enums of C++ |
//! | [`cpp_options`] | writes the structs of options as structs of C++ |
//! | [`source`] | reads the items that C sees |
//! | [`headers`] | writes the headers, by cbindgen and in the order of the sources |
//! | [`description`] | writes the description that other generators read |
//! | [`doxygen`] | writes the headers with the additions of the reference to each comment |
//! | [`texts`] | writes the texts of statuses and choices that programs show |

pub mod comment;
pub mod cpp;
pub mod cpp_options;
pub mod description;
pub mod doxygen;
pub mod headers;
pub mod source;
pub mod texts;

use std::path::Path;

/// Folder of the interface.
pub const FOLDER: &str = "src/capi";
/// Folder of the table of files.
const FILES_FOLDER: &str = "crates/gusset-files/src/table";
/// The enums of C++.
const CHOICES: &str = "include/gusset/choices.hpp";

/// A generated file: its path in the repository, and its text.
pub type Generated = (String, String);

/// The generated headers of the library: the C headers, choices and options of C++, and the
/// plugin's.
///
/// # Errors
///
/// A sentence about an error in the sources, or of cbindgen.
pub fn library_headers(root: &Path, version: &str) -> Result<Vec<Generated>, String> {
    let sources = sources(root)?;
    let mut made = written(root, version, &sources, &headers::Plain)?;
    made.push((CHOICES.to_owned(), cpp::choices(&sources, false)));
    made.extend(cpp_options::options(&sources)?);
    made.push(plugin_header(root)?);
    made.push(files_header(root)?);
    Ok(made)
}

/// The same headers, as doxygen reads them.
///
/// # Errors
///
/// As [`library_headers`].
pub fn reference_headers(root: &Path, version: &str) -> Result<Vec<Generated>, String> {
    let sources = sources(root)?;
    let examples = doxygen::examples(&root.join("examples/reference"))?;
    let mut made = written(root, version, &sources, &doxygen::Reference { sources: &sources, examples: &examples })?;
    made.push((CHOICES.to_owned(), cpp::choices(&sources, true)));
    let mut plugin = plugin_sources(root)?;
    for source in &mut plugin {
        source.path = format!("plugin/{}", source.path).trim_end_matches('/').to_owned();
    }
    made.push(plugin_of(root, &plugin, &doxygen::Reference { sources: &plugin, examples: &examples })?);
    Ok(made)
}

/// The functions and structs of the library that C sees.
///
/// # Errors
///
/// As [`library_headers`].
pub fn sources(root: &Path) -> Result<Vec<source::Source>, String> {
    source::read(&root.join(FOLDER), &["plugin"])
}

fn written(
    root: &Path,
    version: &str,
    sources: &[source::Source],
    style: &dyn headers::Style,
) -> Result<Vec<Generated>, String> {
    let declarations = headers::declarations(root, FOLDER, "cbindgen.toml")?;
    let bodies = headers::bodies(sources, &declarations, style)?;
    let header = |body: headers::Body| {
        let guard = format!("GUSSET_{}_H", body.header.to_uppercase());
        let above = if body.header == source::BASE { headers::prelude(version) } else { body.includes };
        let opening = "/* Generated from src/capi; see gusset.h. */";
        let text = headers::framed(&headers::Frame { opening, guard: &guard, above: &above }, &body.text);
        (format!("include/gusset/{}.h", body.header), text)
    };
    Ok(bodies.into_iter().map(header).collect())
}

/// The header of the plugin's table, for its hosts.
///
/// # Errors
///
/// As [`library_headers`].
pub fn plugin_header(root: &Path) -> Result<Generated, String> {
    plugin_of(root, &plugin_sources(root)?, &headers::Plain)
}

fn plugin_sources(root: &Path) -> Result<Vec<source::Source>, String> {
    source::read(&root.join(FOLDER).join("plugin"), &["memory"])
}

fn plugin_of(root: &Path, sources: &[source::Source], style: &dyn headers::Style) -> Result<Generated, String> {
    let folder = format!("{FOLDER}/plugin");
    let table = Table { name: "plugin", folder: &folder, opening: include_str!("plugin.h") };
    table_header(root, &table, sources, style)
}

/// The header of the table of files.
///
/// # Errors
///
/// As [`library_headers`].
pub fn files_header(root: &Path) -> Result<Generated, String> {
    let table = Table { name: "files", folder: FILES_FOLDER, opening: include_str!("files.h") };
    table_header(root, &table, &files_sources(root)?, &headers::Plain)
}

fn files_sources(root: &Path) -> Result<Vec<source::Source>, String> {
    source::read(&root.join(FILES_FOLDER), &[])
}

/// A header of its own: `gusset_<name>.h`.
struct Table<'a> {
    name: &'a str,
    folder: &'a str,
    /// The text above the declarations.
    opening: &'a str,
}

fn table_header(
    root: &Path,
    table: &Table<'_>,
    sources: &[source::Source],
    style: &dyn headers::Style,
) -> Result<Generated, String> {
    let declarations = headers::declarations(root, table.folder, &format!("cbindgen_{}.toml", table.name))?;
    let bodies = headers::bodies(sources, &declarations, style)?;
    let body: String = bodies.iter().map(|body| body.text.as_str()).collect();
    let (opening, above) = table.opening.split_once("\n\n").unwrap_or_default();
    let guard = format!("GUSSET_{}_H", table.name.to_uppercase());
    let frame = headers::Frame { opening, guard: &guard, above };
    Ok((format!("include/gusset_{}.h", table.name), headers::framed(&frame, &body)))
}

/// The texts of statuses and choices as Rust source: the first sentence of each comment.
///
/// # Errors
///
/// As [`library_headers`].
pub fn library_texts(root: &Path) -> Result<Vec<Generated>, String> {
    let sources = sources(root)?;
    let file = |name: &str, text: String| (format!("{FOLDER}/{name}.rs"), text);
    let choices = texts::choices(&sources).into_iter().map(|(name, text)| file(&format!("choice_text/{name}"), text));
    Ok([file("status_text", texts::statuses(&sources))].into_iter().chain(choices).collect())
}

/// The description as JSON, an item a line.
///
/// # Errors
///
/// As [`library_headers`].
pub fn library_description(root: &Path, version: &str) -> Result<String, String> {
    let (library, plugin, files) = (sources(root)?, plugin_sources(root)?, files_sources(root)?);
    Ok(description::lines(&description::describe(&library, &plugin, &files, version)))
}
