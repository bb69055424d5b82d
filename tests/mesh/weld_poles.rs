//! Welding of nodes of longitudes and latitudes.

use crate::common::{Soup, edge_counts, euler, faces_of};
use crate::weld::{ALL, welded};
use gusset::repair::weld::Options;

/// Nodes of longitudes and latitudes: the seam and both poles close, although the edges at the poles
/// have lengths of 1e-17.
#[test]
fn collapse_closes_the_poles_of_a_sphere() {
    for (unit, shift, from) in [(1.0, 0.0, -180.5), (6371.0, 0.0, 0.25), (1e-3, 0.0, 3.0), (1.0, 40.0, 0.0)] {
        let (rows, columns) = (19_u32, 37_u32);
        let node = |k: u32| {
            let (lat, lon) = (10.0 * f64::from(k / columns) - 90.0, from + 10.0 * f64::from(k % columns));
            let (lat, lon) = (lat.to_radians(), lon.to_radians());
            [lat.cos() * lon.cos(), lat.cos() * lon.sin(), lat.sin()].map(|x| unit * (x + shift))
        };
        let quads: Vec<[u32; 4]> = (0..(rows - 1) * (columns - 1))
            .map(|q| q / (columns - 1) * columns + q % (columns - 1))
            .map(|a| [a, a + 1, a + columns + 1, a + columns])
            .collect();
        let soup =
            Soup::new((0..rows * columns).map(node).collect(), &quads.iter().map(|quad| &quad[..]).collect::<Vec<_>>());
        let done = welded(&soup, &Options { collapse: true, remove_unused: true, ..ALL });
        assert_eq!((done.mesh.positions.len(), done.dropped_faces), (614, 0), "{unit} {shift}");
        assert_eq!(euler(faces_of(&done.mesh)), 2);
        assert!(edge_counts(faces_of(&done.mesh)).values().all(|&(a, b)| a == 1 && b == 1));
    }
}
