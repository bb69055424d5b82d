//! Loops, winged-edge tables and the check of any faces: both ways of looking find the same edges.

use crate::input;
use crate::input::Soup;
use gusset::Job;
use gusset::boundary::{NonManifold, Options, Survey, boundary_loops};
use gusset::check::check;

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some(soup) = input::taken::<Soup>(bytes) else { return };
    soup.visit(|mesh| {
        let job = Job::default();
        check(mesh, &job).expect("any mesh can be checked");
        for non_manifold in [NonManifold::Cut, NonManifold::Stop] {
            let found = [Survey::WholeMesh, Survey::BoundaryOnly].map(|survey| {
                boundary_loops(mesh, &Options { non_manifold, survey }, &job).expect("any mesh has loops or none")
            });
            assert!(found[1].edge_count() <= found[0].edge_count());
            for one in found[0].iter() {
                assert!(one.vertices.iter().all(|&v| (v as usize) < mesh.positions().len()));
            }
        }
    });
}
