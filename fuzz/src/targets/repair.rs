//! Repairs meshes: an error, or a valid mesh with origins in range, which a second repair keeps.

use crate::agree::agreed;
use crate::input::{self, Soup};
use gusset::Job;
use gusset::attributes::Origins;
use gusset::mesh::NONE;
use gusset::solid::{Options, repair};

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some((soup, tolerance, flags, choice)) = input::taken::<(Soup, Option<u8>, [bool; 8], u8)>(bytes) else {
        return;
    };
    soup.visit(|mesh| {
        let [
            leave_borders,
            leave_flat_faces,
            leave_duplicates,
            leave_non_manifold,
            leave_holes,
            leave_orientation,
            leave_fins,
            leave_intersections,
        ] = flags;
        let options = Options {
            tolerance: tolerance.map(|tolerance| f64::from(tolerance) / 64.0),
            leave_borders,
            leave_flat_faces,
            leave_duplicates,
            leave_non_manifold,
            leave_holes,
            leave_orientation,
            leave_fins,
            leave_intersections,
            ..Options::default()
        };
        let Ok(done) = agreed(choice, |job| repair(mesh, &options, job)) else { return };
        input::expect_valid(&done.mesh, |_| {});
        assert_eq!(done.vertex_origin.len(), done.mesh.positions.len());
        assert_eq!(done.face_origin.len(), done.mesh.face_count());
        assert_eq!(done.turned.len(), done.mesh.face_count());
        for (v, &origin) in done.vertex_origin.iter().enumerate().filter(|&(_, &origin)| origin != NONE) {
            assert_eq!(done.mesh.positions.get(v as u32), mesh.positions().get(origin));
        }
        // Each face of the input is there, or listed.
        let mut is_listed = vec![false; mesh.faces().len()];
        done.dropped.iter().for_each(|dropped| is_listed[dropped.face as usize] = true);
        for &f in done.face_origin.iter().filter(|&&f| f != NONE) {
            assert!(!is_listed[f as usize]);
        }
        done.face_origin.iter().filter(|&&f| f != NONE).for_each(|&f| is_listed[f as usize] = true);
        assert!(is_listed.iter().all(|&is_listed| is_listed));
        Origins::from_repaired(&done, &Job::default()).unwrap();
        if done.is_valid() {
            let view = done.mesh.view(&Job::default()).unwrap();
            assert_eq!(repair(&view, &options, &Job::default()).unwrap().mesh, done.mesh);
        }
    });
}
