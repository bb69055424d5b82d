//! The comments of the C interface: each says what a reader of a function needs, and each function has an example.

use gusset_interface::comment::size_field;
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

/// Programs take the sizes of arrays from tags.
#[test]
fn every_array_that_a_function_lends_or_options_hold_has_a_shape() {
    let sources = sources();
    let items = || sources.iter().flat_map(|source| &source.items);
    let kind = |name: &str| items().find(|item| item.name == name).map(|item| &item.kind);
    let params =
        || items().filter_map(|item| if let Kind::Function(params, _) = &item.kind { Some(params) } else { None });
    let (mut wrong, mut shaped) = (Vec::new(), 0);
    for item in items() {
        let Kind::Struct(fields) = &item.kind else { continue };
        let is_filled = params().flatten().any(|param| param.kind.name == item.name && param.kind.pointers == [false]);
        let taking = params().filter(|params| params.iter().any(|param| param.kind.name == item.name)).flatten();
        let known: BTreeSet<&str> = fields.iter().chain(taking).map(|field| field.name.as_str()).collect();
        for field in fields {
            let name = field.kind.name.as_str();
            let is_array = field.kind.pointers == [true]
                && !["void", "char"].contains(&name)
                && !name.ends_with("_options")
                && !matches!(kind(name), Some(Kind::Handle));
            let shape = field.comment.tag("shape");
            shaped += usize::from(shape.is_some());
            if shape.is_none() && is_array && (is_filled || item.name.ends_with("_options")) {
                wrong.push(format!("{}.{}: @shape", item.name, field.name));
            }
            let sizes =
                shape.into_iter().flat_map(|shape| shape.split(' ')).filter_map(|size| size_field(size).unwrap());
            wrong.extend(
                sizes.filter(|size| !known.contains(size)).map(|size| format!("{}.{}: {size}", item.name, field.name)),
            );
            if let Some(choice) =
                field.comment.tag("choice").filter(|choice| !matches!(kind(choice), Some(Kind::Choice(_))))
            {
                wrong.push(format!("{}.{}: {choice}", item.name, field.name));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(shaped > 80, "{shaped}");
}

/// A guide shows every exported item that the library's headers lack.
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
