//! Joins pieces, some of them twice: an error, or a valid mesh whose report agrees with the check.

use crate::agree::agreed;
use crate::input::{self, Soup};
use gusset::Job;
use gusset::assemble::{Extent, Options, assemble};
use gusset::check::check;
use gusset::mesh::MeshView;
use gusset::repair::orient::Outward;
use gusset::repair::weld;

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some((a, b, choices)) = input::taken::<(Soup, Soup, [u8; 3])>(bytes) else { return };
    a.visit(|a| {
        b.visit(|b| {
            let pieces: &[MeshView<'_>] = match choices[0] % 4 {
                0 => &[*a, *a],
                1 => &[*a, *b, *a],
                _ => &[*a, *b],
            };
            put_together(pieces, choices);
        });
    });
}

fn put_together(pieces: &[MeshView<'_>], [_, flags, choice]: [u8; 3]) {
    let flag = |bit: u8| flags >> bit & 1 != 0;
    let options = Options {
        weld: flag(0).then(weld::Options::default),
        edge_to_edge: flag(1),
        keep_orientation: flag(2),
        outward: if flag(3) { Outward::Keep } else { Outward::Closed },
        extent: [Extent::LoopsAndParts, Extent::WholeLoops, Extent::Parts][usize::from(flag(4)) + usize::from(flag(7))],
        within_components: flag(5),
        fill: flag(6).then(gusset::fill::Options::default),
        ..Options::default()
    };
    let Ok(made) = agreed(choice, |job| assemble(pieces, &options, job)) else { return };
    let job = Job::default();
    let found = made.mesh.view(&job).map(|view| check(&view, &job).expect("any mesh can be checked"));
    input::expect_valid(&made.mesh, |_| {});
    assert_eq!(made.maps.len(), pieces.len());
    for (map, piece) in made.maps.iter().zip(pieces) {
        assert_eq!(map.faces.len(), piece.faces().len());
        assert_eq!(map.vertices.len(), piece.positions().len());
    }
    assert_eq!(made.non_manifold_edges as usize, found.map_or(0, |found| found.non_manifold_edges.len()));
}
