//! A file that no module names is not compiled, and its tests do not run; nobody is told. Here they
//! are.

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

/// True if a file that may declare the module in `folder` does, or one includes it by its path.
fn is_named(file: &Path, all: &[(PathBuf, String)]) -> bool {
    let is_folder = file.file_stem().is_some_and(|stem| stem == "mod");
    let module = if is_folder { file.parent().unwrap() } else { file };
    let (name, folder) = (module.file_stem().unwrap().to_str().unwrap(), module.parent().unwrap());
    let has_roots = ["main.rs", "lib.rs", "mod.rs"].map(|root| folder.join(root));
    let beside = folder.with_extension("rs");
    all.iter().any(|(path, text)| {
        let declares = (has_roots.contains(path) || *path == beside) && text.contains(&format!("mod {name};"));
        let included = text.lines().filter_map(|line| line.trim().strip_prefix("#[path = \"")?.strip_suffix("\"]"));
        declares
            || included.map(|at| path.parent().unwrap().join(at)).any(|at| at.canonicalize().is_ok_and(|at| at == file))
    })
}

#[test]
fn every_file_is_compiled() {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).canonicalize().unwrap();
    let mut files = Vec::new();
    ["src", "tests"].iter().for_each(|folder| rust_files(&root.join(folder), &mut files));
    let all: Vec<_> = files.into_iter().map(|file| (file.clone(), fs::read_to_string(file).unwrap())).collect();
    assert!(all.len() > 300, "{}", all.len());
    let is_root = |file: &Path| file.file_stem().is_some_and(|stem| stem == "main" || stem == "lib");
    let forgotten: Vec<_> =
        all.iter().map(|(file, _)| file).filter(|file| !is_root(file) && !is_named(file, &all)).collect();
    assert!(forgotten.is_empty(), "no module names {forgotten:#?}");
}
