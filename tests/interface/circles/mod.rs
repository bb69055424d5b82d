//! Circles of files: no two files of a crate use each other, directly or through others. Cargo
//! holds the order of the crates.

pub(super) mod source;

use source::{Arrows, Crate};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// All files that one uses, directly or not.
fn reached<'a>(uses: &BTreeMap<&'a str, Vec<&'a str>>, from: &str) -> BTreeSet<&'a str> {
    let (mut seen, mut open) = (BTreeSet::new(), uses[from].clone());
    while let Some(file) = open.pop() {
        if seen.insert(file) {
            open.extend(uses.get(file).into_iter().flatten());
        }
    }
    seen
}

/// Groups of files each of which uses all others of its group, directly or not.
fn circles(arrows: &Arrows) -> Vec<BTreeSet<&str>> {
    let mut uses = BTreeMap::<&str, Vec<&str>>::new();
    for (from, to) in arrows.keys() {
        uses.entry(from).or_default().push(to);
    }
    let reach: BTreeMap<_, _> = uses.keys().map(|&file| (file, reached(&uses, file))).collect();
    let mutual = |a: &str, b: &str| reach[a].contains(b) && reach.get(b).is_some_and(|back| back.contains(a));
    let mut found = Vec::<BTreeSet<_>>::new();
    for &file in reach.keys().filter(|file| reach[**file].contains(**file)) {
        if !found.iter().any(|circle| circle.contains(file)) {
            found.push(reach.keys().copied().filter(|&other| mutual(file, other)).collect());
        }
    }
    found
}

/// A circle with its arrows.
fn described(circle: &BTreeSet<&str>, arrows: &Arrows) -> String {
    let within = arrows.iter().filter(|((from, to), _)| circle.contains(from.as_str()) && circle.contains(to.as_str()));
    let lines: Vec<_> = within.map(|((from, to), name)| format!("    {from} uses {to} ({name})")).collect();
    format!("{} files use each other:\n{}", circle.len(), lines.join("\n"))
}

/// The folders of the sources of all crates.
fn crates() -> Vec<PathBuf> {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
    let below = fs::read_dir(root.join("crates")).unwrap().map(|entry| entry.unwrap().path().join("src"));
    below.chain([root.join("src")]).collect()
}

#[test]
fn no_file_is_on_a_circle() {
    let mut arrow_count = 0;
    for folder in crates() {
        let library = Crate::read(&|file| fs::read_to_string(folder.join(file)).ok());
        assert_eq!(library.unresolved(), Vec::<String>::new());
        let arrows = library.arrows();
        arrow_count += arrows.len();
        let circles: Vec<_> = circles(&arrows).iter().map(|circle| described(circle, &arrows)).collect();
        assert!(circles.is_empty(), "{}:\n{}", folder.display(), circles.join("\n"));
    }
    assert!(arrow_count > 1000, "{arrow_count}");
}

/// Arrows of a crate of the files given.
fn planted(files: &[(&str, &str)]) -> Arrows {
    let library = Crate::read(&|file| files.iter().find(|(name, _)| *name == file).map(|(_, text)| (*text).to_owned()));
    assert_eq!(library.unresolved(), Vec::<String>::new());
    library.arrows()
}

#[test]
fn planted_circles_are_found() {
    let arrows = planted(&[
        ("lib.rs", "pub mod mesh; mod geom;"),
        ("geom/mod.rs", "pub mod triangle; pub const fn dot() {}"),
        ("geom/triangle.rs", "use super::dot; pub fn area() { dot() }"),
        ("mesh/mod.rs", "mod view; mod owned; mod walk; pub use view::View; use crate::geom::triangle;"),
        ("mesh/view.rs", "pub struct View(fn() -> super::owned::Mesh);"),
        ("mesh/owned.rs", "use super::walk; pub struct Mesh; fn start() { walk::walk(); }"),
        ("mesh/walk.rs", "pub(super) fn walk() { let seen: Vec<super::View> = vec![]; }"),
    ]);
    let expected = [("geom/triangle.rs", "geom/mod.rs"), ("mesh/owned.rs", "mesh/walk.rs")];
    for (from, to) in expected.into_iter().chain([("mesh/view.rs", "mesh/owned.rs"), ("mesh/walk.rs", "mesh/view.rs")])
    {
        assert!(arrows.contains_key(&(from.to_owned(), to.to_owned())), "{from} {to}");
    }
    assert_eq!(arrows.len(), 4);
    assert_eq!(circles(&arrows), [BTreeSet::from(["mesh/owned.rs", "mesh/view.rs", "mesh/walk.rs"])]);
}

#[test]
fn comments_tests_and_paths_to_other_crates_are_no_arrows() {
    let arrows = planted(&[
        ("lib.rs", "mod geom; mod net; mod stitch; pub use net::Net; pub use gusset_mesh as mesh;"),
        (
            "geom/mod.rs",
            "/// See [`crate::net::Net`].\nmod grid; #[cfg(test)] mod tests { use crate::stitch::stitch; }",
        ),
        (
            "geom/grid.rs",
            "pub(in crate::geom) fn cell() { use crate::{stitch as sewing, net::{self as nets}}; assert!(sewing::stitch()); }",
        ),
        ("net.rs", "use crate::mesh::Mesh; pub struct Net;"),
        ("stitch.rs", "pub fn stitch() -> bool { matches!(crate::Net, crate::Net) }"),
    ]);
    let found: Vec<_> = arrows.iter().map(|((from, to), name)| format!("{from} {to} {name}")).collect();
    assert_eq!(found, ["geom/grid.rs stitch.rs sewing::stitch", "stitch.rs net.rs crate::Net"]);
}

#[test]
fn imports_that_are_only_lent_are_no_arrows() {
    let arrows = planted(&[
        ("lib.rs", "mod mesh;"),
        ("mesh/mod.rs", "mod view; mod owned; pub(crate) use view::{View, look}; pub use owned::*; fn at() { look() }"),
        ("mesh/view.rs", "pub struct View; pub fn look() {}"),
        ("mesh/owned.rs", "pub struct Mesh(super::View);"),
    ]);
    let files: Vec<_> = arrows.keys().map(|(from, to)| (from.as_str(), to.as_str())).collect();
    assert_eq!(files, [("mesh/mod.rs", "mesh/view.rs"), ("mesh/owned.rs", "mesh/view.rs")]);
}

#[test]
fn names_from_a_prelude_are_arrows() {
    let arrows = planted(&[
        ("lib.rs", "mod ffi;"),
        ("ffi/mod.rs", "mod prelude { pub(crate) use super::guard::guard; } mod guard; mod view;"),
        ("ffi/guard.rs", "use super::view::View; pub fn guard(view: View) {}"),
        ("ffi/view.rs", "use super::prelude::*; pub struct View; fn look() { guard(View) }"),
    ]);
    assert_eq!(circles(&arrows), [BTreeSet::from(["ffi/guard.rs", "ffi/view.rs"])]);
}
