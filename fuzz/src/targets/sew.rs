//! Sews borders: an error, or a valid mesh without new free edges, and with maps between old and
//! new elements.

use crate::agree::agreed;
use crate::input::{self, Soup};
use gusset::mesh::NONE;
use gusset::repair::sew::sew;
use gusset::repair::weld::{Options, Vertices};

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some((soup, tolerance, flags, choice)) = input::taken::<(Soup, Option<u8>, [bool; 3], u8)>(bytes) else {
        return;
    };
    soup.visit(|mesh| {
        let options = Options {
            vertices: if flags[0] { Vertices::All } else { Vertices::Boundary },
            tolerance: tolerance.map(|tolerance| f64::from(tolerance) / 64.0),
            collapse: flags[1],
            remove_unused: flags[2],
        };
        let Ok(sewn) = agreed(choice, |job| sew(mesh, &options, job)) else { return };
        input::expect_valid(&sewn.mesh, |_| {});
        assert_eq!(sewn.vertex_map.len(), mesh.positions().len());
        assert!(sewn.vertex_map.iter().all(|&v| v == NONE || (v as usize) < sewn.mesh.positions.len()));
        assert!(sewn.face_origin.is_sorted() && sewn.face_origin.len() == sewn.mesh.face_count());
        for (old, &new) in (0..).zip(&sewn.face_map) {
            assert!(new == NONE || sewn.face_origin[new as usize] == old);
        }
        let dropped = sewn.face_map.iter().filter(|&&face| face == NONE).count();
        assert_eq!(dropped, sewn.dropped_faces as usize);
    });
}
