//! The comments of the C interface: each says what a reader of a function needs, and each function has an example.

use gusset_interface::doxygen::{self, Reference};
use gusset_interface::source::{Kind, Source};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

fn sources() -> Vec<Source> {
    gusset_interface::sources(Path::new(ROOT)).unwrap()
}

#[test]
fn every_function_says_what_its_callers_need() {
    let sources = sources();
    let examples = doxygen::examples(&Path::new(ROOT).join("examples/reference")).unwrap();
    let reference = Reference { sources: &sources, examples: &examples };
    let mut lacks = Vec::new();
    for source in &sources {
        if !source.comment.brief.contains(": ") {
            lacks.push(format!("src/capi/{}: the title of its group, as `Title: sentence.`", source.path));
        }
        for item in &source.items {
            let Kind::Function(params, result) = &item.kind else { continue };
            let mut lack = |what: &str| lacks.push(format!("{}: {what}", item.name));
            if item.comment.brief.is_empty() || !item.comment.brief.ends_with('.') {
                lack("a first sentence");
            }
            for param in
                params.iter().filter(|param| param.comment.brief.is_empty() && reference.usual(param).is_none())
            {
                lack(&format!("@param {}", param.name));
            }
            let status = result.as_ref().is_some_and(|kind| kind.name == "gusset_status");
            if result.is_some() && !status && item.comment.tag("return").is_none() {
                lack("@return");
            }
            let lends = item.name.contains("_get_") || item.name.contains("_set_") || item.name.ends_with("_destroy");
            if status && !lends && item.comment.tag("complexity").is_none() {
                lack("@complexity");
            }
            if !examples.contains_key(&item.name) {
                lack("an example in examples/reference");
            }
        }
    }
    assert!(lacks.is_empty(), "{}", lacks.join("\n"));
}

#[test]
fn every_name_in_a_comment_or_an_example_exists() {
    let sources = sources();
    let items = || sources.iter().flat_map(|source| &source.items);
    let names: BTreeSet<&str> = items().map(|item| item.name.as_str()).collect();
    let statuses: BTreeSet<String> = items()
        .filter_map(|item| match &item.kind {
            Kind::Enum(values) => Some(values.iter().map(|(name, ..)| name.replace("GUSSET_ERROR_", ""))),
            _ => None,
        })
        .flatten()
        .collect();
    let mut wrong = Vec::new();
    for item in items() {
        for cause in &item.comment.errors {
            let known = match cause.status.strip_prefix("as ") {
                Some(other) => names.contains(other),
                None => statuses.contains(&cause.status),
            };
            if !known {
                wrong.push(format!("{}: @errors {}", item.name, cause.status));
            }
        }
    }
    let examples = doxygen::examples(&Path::new(ROOT).join("examples/reference")).unwrap();
    let inline = fs::read_to_string(Path::new(ROOT).join("include/gusset/views.h")).unwrap();
    let inline: BTreeSet<&str> = inline.lines().flat_map(doxygen::calls).collect();
    let known = |name: &str| names.contains(name) || inline.contains(name);
    let unknown = examples.iter().filter(|(name, _)| !known(name));
    wrong.extend(unknown.map(|(name, (file, _))| format!("{file}: {name}")));
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// What is exported and no part of the library's headers is shown in a guide.
#[test]
fn every_exported_name_is_in_an_example() {
    let names: BTreeSet<String> = sources().into_iter().flat_map(|source| source.items).map(|item| item.name).collect();
    let symbols = fs::read_to_string(Path::new(ROOT).join("include/gusset.symbols")).unwrap();
    let guides = fs::read_dir(Path::new(ROOT).join("examples/guides")).unwrap();
    let guides: String = guides.filter_map(|entry| fs::read_to_string(entry.unwrap().path()).ok()).collect();
    for symbol in symbols.lines().filter(|symbol| !names.contains(*symbol)) {
        assert!(guides.contains(symbol), "{symbol}");
    }
}

/// A host of the plugin has no other header to look them up in.
#[test]
fn the_plugin_names_every_kind_of_element() {
    let header = |name: &str| fs::read_to_string(Path::new(ROOT).join("include").join(name)).unwrap();
    let plugin = header("gusset_plugin.h").replace("\n    ///", "");
    let (_, list) = plugin.split_once("Kind of element, GUSSET_ELEMENT_... of gusset.h: ").unwrap();
    let (list, _) = list.split_once(". Later versions").unwrap();
    let base = header("gusset/base.h");
    let kinds: Vec<&str> = base
        .lines()
        .filter_map(|line| Some(line.strip_prefix("#define GUSSET_ELEMENT_")?.split_once(' ')?.1))
        .collect();
    assert!(kinds.len() > 20);
    let listed: Vec<&str> = list.split(", ").filter_map(|entry| Some(entry.split_once(' ')?.0)).collect();
    let missing: Vec<_> = kinds.iter().filter(|kind| !listed.contains(kind)).collect();
    assert!(missing.is_empty(), "{missing:?} are not in {listed:?}");
}
