//! Files of modules: each is compiled, and its name tells it apart within its crate.
//!
//! A file that no module names is not compiled, and its tests do not run.

use std::collections::{BTreeMap, HashSet};
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

/// The Rust files of some folders of the repository.
fn files_of(folders: &[&str]) -> Vec<PathBuf> {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).canonicalize().unwrap();
    let mut files = Vec::new();
    folders.iter().for_each(|folder| rust_files(&root.join(folder), &mut files));
    files
}

/// Names that every crate may have in several folders.
const COMMON_NAMES: [&str; 4] = ["lib.rs", "main.rs", "mod.rs", "tests.rs"];

#[test]
fn names_of_files_are_unique_within_a_crate() {
    let is_root = |folder: &&Path| ["lib.rs", "main.rs"].iter().any(|root| folder.join(root).exists());
    let mut named: BTreeMap<_, Vec<_>> = BTreeMap::new();
    for file in files_of(&["src", "crates", "tests", "fuzz"]) {
        let name = file.file_name().unwrap().to_owned();
        // Files of the C interface are named after their groups in the reference, by folder and file.
        let in_c_interface = file.iter().any(|folder| folder == "capi");
        let Some(root) = file.ancestors().skip(1).find(is_root) else { continue };
        if !in_c_interface && !COMMON_NAMES.iter().any(|common| name == *common) {
            named.entry((root.to_owned(), name)).or_default().push(file);
        }
    }
    assert!(named.len() > 500, "{}", named.len());
    let shared: Vec<_> = named.values().filter(|files| files.len() > 1).collect();
    assert!(shared.is_empty(), "files of one crate share a name: {shared:#?}");
}

#[test]
fn every_file_is_compiled() {
    let files = files_of(&["src", "crates", "tests"]);
    let all: Vec<_> = files.into_iter().map(|file| (file.clone(), fs::read_to_string(file).unwrap())).collect();
    assert!(all.len() > 300, "{}", all.len());
    let is_root =
        |file: &Path| file.file_stem().is_some_and(|stem| ["main", "lib", "build"].iter().any(|root| stem == *root));
    let named = named(&all);
    let forgotten: Vec<_> =
        all.iter().map(|(file, _)| file).filter(|file| !is_root(file) && !named.contains(*file)).collect();
    assert!(forgotten.is_empty(), "no module names {forgotten:#?}");
}
