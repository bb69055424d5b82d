//! A file that no module names is not compiled, and its tests do not run; nobody is told. Here they
//! are.

use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};

/// The files of a folder and its folders.
fn rust_files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            rust_files(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

/// The files that may be modules which files declare, and those that they include by their paths.
fn named(all: &[(PathBuf, String)]) -> HashSet<PathBuf> {
    let mut named = HashSet::new();
    for (path, text) in all {
        let beside = path.parent().unwrap();
        let is_root = ["main.rs", "lib.rs", "mod.rs"].iter().any(|root| path.ends_with(root));
        let folder = if is_root { beside.to_path_buf() } else { path.with_extension("") };
        for line in text.lines().map(str::trim) {
            if let Some((name, _)) = line.split_once("mod ").and_then(|(_, rest)| rest.split_once(';')) {
                named.extend([format!("{name}.rs"), format!("{name}/mod.rs")].map(|file| folder.join(file)));
            } else if let Some(at) = line.strip_prefix("#[path = \"").and_then(|rest| rest.strip_suffix("\"]")) {
                named.extend(beside.join(at).canonicalize());
            }
        }
    }
    named
}

#[test]
fn every_file_is_compiled() {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).canonicalize().unwrap();
    let mut files = Vec::new();
    ["src", "crates", "tests"].iter().for_each(|folder| rust_files(&root.join(folder), &mut files));
    let all: Vec<_> = files.into_iter().map(|file| (file.clone(), fs::read_to_string(file).unwrap())).collect();
    assert!(all.len() > 300, "{}", all.len());
    let is_root =
        |file: &Path| file.file_stem().is_some_and(|stem| ["main", "lib", "build"].iter().any(|root| stem == *root));
    let named = named(&all);
    let forgotten: Vec<_> =
        all.iter().map(|(file, _)| file).filter(|file| !is_root(file) && !named.contains(*file)).collect();
    assert!(forgotten.is_empty(), "no module names {forgotten:#?}");
}
