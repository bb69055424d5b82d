//! Welds at any tolerance and orients the result: doing it twice changes nothing.

use crate::input;
use crate::input::Soup;
use gusset::Job;
use gusset::repair::orient::{self, orient};
use gusset::repair::weld::{Options, Vertices, weld};

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some(input) = input::taken::<(Soup, Option<u8>, bool, bool)>(bytes) else { return };
    let (soup, tolerance, all, collapse) = input;
    soup.visit(|mesh| {
        let job = Job::default();
        let vertices = if all { Vertices::All } else { Vertices::Boundary };
        let options = Options { vertices, tolerance: tolerance.map(f64::from), collapse, remove_unused: true };
        let Ok(welded) = weld(mesh, &options, &job) else { return };
        let Ok(view) = welded.mesh.view(&job) else {
            return input::expect_valid(&welded.mesh, |_| {});
        };
        let once = orient(&view, &orient::Options::default(), &job).expect("any mesh can be oriented");
        let view = once.mesh.view(&job).expect("a valid mesh");
        let twice = orient(&view, &orient::Options::default(), &job).expect("any mesh can be oriented");
        assert_eq!(twice.turned_faces, 0);
    });
}
