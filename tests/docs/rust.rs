//! The examples of `docs/guides/rust.md`: each is compiled here, and its own test runs it.

#[path = "../../examples/rust/holes.rs"]
mod holes;
#[path = "../../examples/rust/job.rs"]
mod job;
#[path = "../../examples/rust/join.rs"]
mod join;
#[path = "../../examples/rust/nearest.rs"]
mod nearest;
#[path = "../../examples/rust/net.rs"]
mod net;
#[path = "../../examples/rust/outline.rs"]
mod outline;

use gusset::Error;
use gusset::mesh::{Mesh, MeshView};
use gusset::surface::Surface;
use std::fs;
use std::path::Path;

/// The manifest that the guide shows names crates of this workspace.
#[test]
fn the_manifest_of_the_guide_fits_the_workspace() {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
    let shown = fs::read_to_string(root.join("examples/rust/dependencies.toml")).unwrap();
    let mut folders = 0;
    for folder in shown.lines().filter_map(|line| line.split_once("\"../gusset")?.1.strip_suffix("\" }")) {
        assert!(
            root.join(folder.trim_start_matches('/')).join("Cargo.toml").exists(),
            "there is no package in {folder}"
        );
        folders += 1;
    }
    assert_eq!(folders, 4);
}

#[test]
fn threads_share_what_the_guide_says() {
    fn shared<T: Send + Sync>() {}
    shared::<MeshView<'_>>();
    shared::<Mesh>();
    shared::<Surface<'_>>();
    shared::<Error>();
}
