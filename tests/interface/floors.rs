//! Compares ARCHITECTURE.md with the tree: crates, modules on their floors, and paths.

use super::circles::source::Crate;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::PathBuf;

/// A file or folder of the repository.
fn in_repository(path: &str) -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join(path)
}

fn page() -> String {
    fs::read_to_string(in_repository("ARCHITECTURE.md")).unwrap()
}

/// The floors drawn of a crate: the line of each module, and the modules after its arrow, if it has one.
struct Floors<'a> {
    line_of: BTreeMap<&'a str, usize>,
    uses: BTreeMap<&'a str, BTreeSet<&'a str>>,
}

/// Reads lines of entries, which three spaces or more divide: `module`, or `module -> others`.
fn read_floors<'a>(drawn: &'a str, modules: &BTreeSet<String>) -> Floors<'a> {
    let (mut line_of, mut uses) = (BTreeMap::new(), BTreeMap::new());
    for (number, line) in drawn.lines().enumerate() {
        for entry in line.split("   ") {
            let (declared, used) = entry.split_once("->").unwrap_or((entry, ""));
            for module in declared.split_whitespace().filter(|word| modules.contains(*word)) {
                assert_eq!(line_of.insert(module, number), None, "{module} is drawn twice");
                if !used.is_empty() {
                    uses.insert(module, used.split_whitespace().collect());
                }
            }
        }
    }
    Floors { line_of, uses }
}

/// Violations of the floors by a crate's modules.
fn violations(drawn: &str, library: &Crate) -> Vec<String> {
    let modules = library.children();
    let floors = read_floors(drawn, &modules);
    let missing = modules.iter().filter(|module| !floors.line_of.contains_key(module.as_str()));
    let mut found: Vec<_> = missing.map(|module| format!("{module} is not drawn")).collect();
    let module_of = |file: &str| file.split(['/', '.']).next().unwrap().to_owned();
    let between: BTreeSet<_> = library
        .arrows()
        .into_keys()
        .map(|(from, to)| (module_of(&from), module_of(&to)))
        .filter(|(a, b)| a != b)
        .collect();
    for (from, to) in &between {
        let [Some(above), Some(below)] = [from, to].map(|module| floors.line_of.get(module.as_str())) else { continue };
        if above >= below || floors.uses.get(from.as_str()).is_some_and(|uses| !uses.contains(to.as_str())) {
            found.push(format!("{from} uses {to}"));
        }
    }
    found
}

#[test]
fn modules_are_on_the_floors_that_are_drawn() {
    let page = page();
    let (_, section) = page.split_once("## The modules").unwrap();
    let (section, _) = section.split_once("\n## ").unwrap();
    let mut drawn = 0;
    for block in section.split("\n`gusset-").skip(1) {
        let (name, rest) = block.split_once('`').unwrap();
        let floors = rest.split("```").nth(1).unwrap();
        let folder = in_repository(&format!("crates/gusset-{name}/src"));
        let library = Crate::read(&|file| fs::read_to_string(folder.join(file)).ok());
        assert_eq!(violations(floors, &library), Vec::<String>::new(), "gusset-{name}");
        drawn += 1;
    }
    assert_eq!(drawn, 5);
}

/// The crates that a manifest lists, without `gusset-` before them.
fn listed(manifest: &str) -> BTreeSet<&str> {
    let (_, rest) = manifest.split_once("[dependencies]").unwrap();
    let dependencies = rest.lines().skip(1).take_while(|line| !line.starts_with('['));
    dependencies.filter_map(|line| line.strip_prefix("gusset-")?.strip_suffix(".workspace = true")).collect()
}

#[test]
fn crates_use_what_is_drawn() {
    let page = page();
    let drawn = page.lines().filter_map(|line| line.strip_prefix(" gusset-")?.split_once("->"));
    let drawn: BTreeMap<_, _> = drawn.map(|(name, uses)| (name.trim(), uses.trim())).collect();
    assert_eq!(drawn.len(), 8);
    for (name, uses) in &drawn {
        let uses = uses.split("   ").next().unwrap().split(", ").filter(|used| drawn.contains_key(used));
        let manifest = fs::read_to_string(in_repository(&format!("crates/gusset-{name}/Cargo.toml"))).unwrap();
        assert_eq!(uses.collect::<BTreeSet<_>>(), listed(&manifest), "gusset-{name}");
    }
}

#[test]
fn planted_violations_are_found() {
    let files = [
        ("lib.rs", "mod fill; mod stitch; mod mesh; mod fair;"),
        ("fill.rs", "use crate::stitch::strip; fn fill() { strip(); crate::mesh::view(); }"),
        ("stitch.rs", "pub fn strip() {}"),
        ("mesh.rs", "pub fn view() { crate::stitch::strip(); }"),
        ("fair.rs", ""),
    ];
    let read = |file: &str| files.iter().find(|(name, _)| *name == file).map(|(_, text)| (*text).to_owned());
    let drawn = " fill -> mesh     stitch\n mesh\n";
    let found = violations(drawn, &Crate::read(&read));
    assert_eq!(found, ["fair is not drawn", "fill uses stitch", "mesh uses stitch"]);
}

#[test]
fn paths_exist() {
    let page = page();
    let roots = ["crates/", "src/", "include/", "tests/", "cpp_tests/", "tools", "docs/", "python", "wasm"];
    let quoted = page.split('`').skip(1).step_by(2).filter(|path| !path.contains(char::is_whitespace));
    let paths: Vec<_> = quoted.filter(|path| roots.iter().any(|root| path.starts_with(root))).collect();
    assert!(paths.len() > 60, "{}", paths.len());
    let lost: Vec<_> = paths.into_iter().filter(|path| !in_repository(path).exists()).collect();
    assert!(lost.is_empty(), "not there: {lost:?}");
}
