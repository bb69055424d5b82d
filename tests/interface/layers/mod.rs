//! The order of the library's modules: each uses those of its own layer and of the layers below,
//! and no two files use each other, be it by a way round.

mod source;

use source::{Arrows, Crate};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// From the bottom up.
const LAYERS: [&[&str]; 12] = [
    &["error", "alloc", "choice", "job", "par", "reserve", "simd", "testing", "threads"],
    &["sort", "geom"],
    &["mesh"],
    &["intersect", "fair", "remesh", "blend", "boundary", "winged", "check"],
    &["align", "trim"],
    &["repair", "fill", "stitch", "develop"],
    &["outline"],
    &["net"],
    &["surface"],
    &["attributes"],
    &["filters"],
    &["ffi"],
];

fn layer(file: &str) -> usize {
    let module = file.split('/').next().and_then(|name| name.split('.').next()).unwrap_or_default();
    let found = LAYERS.iter().position(|layer| layer.contains(&module));
    found.unwrap_or_else(|| panic!("{file} is in no layer"))
}

/// Arrows to a layer above.
fn upward(arrows: &Arrows) -> Vec<String> {
    let up = arrows.iter().filter(|((from, to), _)| layer(from) < layer(to));
    up.map(|((from, to), name)| format!("{from} uses {to} ({name}), of a layer above")).collect()
}

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

#[test]
fn no_file_uses_a_layer_above_or_is_on_a_circle() {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join("src");
    let library = Crate::read(&|file| fs::read_to_string(root.join(file)).ok());
    assert_eq!(library.unresolved(), Vec::<String>::new());
    let arrows = library.arrows();
    assert!(arrows.len() > 1000, "{}", arrows.len());
    let circles = circles(&arrows);
    let circles = circles.iter().map(|circle| described(circle, &arrows));
    let faults: Vec<_> = upward(&arrows).into_iter().chain(circles).collect();
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
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
    assert_eq!(upward(&arrows), Vec::<String>::new());
}

#[test]
fn planted_arrows_upwards_are_found() {
    let arrows = planted(&[
        ("lib.rs", "mod geom; mod net; mod stitch; pub use net::Net;"),
        ("geom/mod.rs", "/// Of [`crate::net::Net`].\nmod grid; #[cfg(test)] mod tests { use crate::stitch::stitch; }"),
        (
            "geom/grid.rs",
            "pub(in crate::geom) fn cell() { use crate::{stitch as sewing, net::{self as nets}}; assert!(sewing::stitch()); }",
        ),
        ("net.rs", "pub struct Net;"),
        ("stitch.rs", "pub fn stitch() -> bool { matches!(crate::Net, crate::Net) }"),
    ]);
    let expected = [
        "geom/grid.rs uses stitch.rs (sewing::stitch), of a layer above",
        "stitch.rs uses net.rs (crate::Net), of a layer above",
    ];
    assert_eq!(upward(&arrows), expected);
    assert_eq!(circles(&arrows).len(), 0);
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
