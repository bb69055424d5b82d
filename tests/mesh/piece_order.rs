//! A strip or a blend does not depend on the order of the pieces.

use crate::adversarial::{P, bits, generic, join, shell, up, ways};
use crate::common::faces_of;
use glam::DVec3;
use gusset::mesh::Mesh;
use gusset::stitch::facing::Arc;
use gusset::stitch::{Extent, Fairing, Finish, Options, Rows, Stitch};
use std::collections::BTreeSet;

/// The faces of a mesh by their positions, each from its least corner on.
fn faces_by_position(mesh: &Mesh) -> BTreeSet<Vec<[u64; 3]>> {
    let all = bits(&mesh.positions);
    let by_position = |face: &[u32]| {
        let mut corners: Vec<[u64; 3]> = face.iter().map(|&v| all[v as usize]).collect();
        let first = (0..corners.len()).min_by_key(|&k| corners[k]).unwrap();
        corners.rotate_left(first);
        corners
    };
    faces_of(mesh).map(by_position).collect()
}

#[test]
fn exchanged_pieces_give_the_same_faces() {
    let (a, b) = generic();
    // The faces of both rims run the same way around, so that no piece is turned over.
    let rim: Vec<P> = b.rim.iter().rev().map(|&v| b.soup.points[v as usize]).collect();
    let b = shell(&rim, up, true);
    let [on_a, on_b] = [Arc { first: 4, count: 19 }, Arc { first: 14, count: 15 }];
    for (extent, exchanged) in
        [(Extent::WholeLoops, Extent::WholeLoops), (Extent::Arcs([on_a, on_b]), Extent::Arcs([on_b, on_a]))]
    {
        for finish in [Finish::Strip, Finish::Blend] {
            for options in ways().filter(|options| finish == Finish::Strip || options.rows == Rows::Count(0)) {
                let options = Options { finish, extent, ..options };
                let (given, other) = (join(&a, &b, &options), join(&b, &a, &Options { extent: exchanged, ..options }));
                let what = format!("{finish:?} {extent:?} {:?} {:?}", options.meridians, options.rows);
                assert!(!given.turned && !other.turned);
                // The other matrix P is read from its end.
                let matrix = |joined: &Stitch| -> Vec<DVec3> {
                    joined.matrix.iter().map(|&v| joined.mesh.positions.get(v)).collect()
                };
                let mut reversed = matrix(&other);
                reversed.reverse();
                if options.fairing == Fairing::None {
                    assert!(faces_by_position(&given.mesh) == faces_by_position(&other.mesh), "{what}");
                    assert!(matrix(&given) == reversed, "{what}");
                } else {
                    // The sums of the solver have another order.
                    let off = matrix(&given).iter().zip(&reversed).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max);
                    assert!(off < 1e-12, "{what}: {off}");
                }
            }
        }
    }
}
