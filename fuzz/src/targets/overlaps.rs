//! Pieces that overlap, moved by something: aligned, trimmed and joined. An error, or motions that are rigid, faces
//! that are kept once, and a valid mesh.

use crate::agree::agreed;
use crate::input::{self, Soup};
use glam::DVec3;
use gusset::Job;
use gusset::align::{self, Pose, Start, align};
use gusset::assemble::{self, Overlaps, assemble};
use gusset::fill;
use gusset::mesh::{Faces, MeshView, Positions};
use gusset::trim::{self, trim};

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some((a, b, shift, choices)) = input::taken::<(Soup, Soup, [i8; 3], [u8; 3])>(bytes) else { return };
    a.visit(|a| {
        b.visit(|b| {
            // The first piece once more, a little off.
            let off = DVec3::from_array(shift.map(f64::from)) / 32.0;
            let points: Vec<[f64; 3]> =
                (0..a.positions().len()).map(|v| (a.positions().get(v as u32) + off).to_array()).collect();
            let (offsets, corners) = arrays(a);
            let Ok(faces) = Faces::polygons(&offsets, &corners) else { return };
            let Ok(again) = MeshView::new(Positions::from(&points[..]), faces, &Job::default()) else { return };
            let pieces: &[MeshView<'_>] = match choices[0] % 4 {
                0 => &[*a, again],
                1 => &[*b, *a, again],
                2 => &[*a, *b, *a],
                _ => &[*a, *b],
            };
            aligned(pieces, choices);
            joined(pieces, choices);
        });
    });
}

fn arrays(mesh: &MeshView<'_>) -> (Vec<u32>, Vec<u32>) {
    let (mut offsets, mut corners) = (vec![0], Vec::new());
    for f in 0..mesh.faces().len() {
        corners.extend(mesh.face(f));
        offsets.push(corners.len() as u32);
    }
    (offsets, corners)
}

fn aligned(pieces: &[MeshView<'_>], [_, flags, choice]: [u8; 3]) {
    let start = [Start::AsGiven, Start::PrincipalAxes, Start::Rims, Start::Features][usize::from(flags) % 4];
    let options = align::Options { start, max_rounds: 10, ..align::Options::default() };
    let Ok(found) = agreed(choice, |job| align(pieces, &options, job)) else { return };
    assert_eq!(found.pieces.len(), pieces.len());
    assert_eq!(found.pieces[0].pose, Pose::IDENTITY);
    for piece in &found.pieces {
        let pose = piece.pose;
        assert!(pose.translation.is_finite() && (0.0..=1.0).contains(&piece.hold), "{piece:?}");
        let product = pose.rotation.transpose() * pose.rotation;
        assert!(product.abs_diff_eq(glam::DMat3::IDENTITY, 1e-12) && pose.rotation.determinant() > 0.0, "{pose:?}");
    }
    for overlap in &found.overlaps {
        assert!(overlap.pieces[0] < overlap.pieces[1] && (overlap.pieces[1] as usize) < pieces.len());
        assert!(overlap.shares.iter().chain([&overlap.fit]).all(|share| (0.0..=1.0).contains(share)), "{overlap:?}");
        assert!(overlap.mean >= 0.0 && overlap.rms >= overlap.mean * (1.0 - 1e-12), "{overlap:?}");
    }
}

fn joined(pieces: &[MeshView<'_>], [_, flags, choice]: [u8; 3]) {
    let how = trim::Options { min_faces: u32::from(flags % 8), ..trim::Options::default() };
    let Ok(kept) = agreed(choice, |job| trim(pieces, &how, job)) else { return };
    for (kept, piece) in kept.kept.iter().zip(pieces) {
        assert!(kept.windows(2).all(|pair| pair[0] < pair[1]));
        assert!(kept.last().is_none_or(|&f| (f as usize) < piece.faces().len()));
    }
    let options = assemble::Options {
        overlaps: Overlaps::Trim(how),
        fill: (flags & 16 != 0).then(fill::Options::default),
        ..assemble::Options::default()
    };
    let Ok(made) = agreed(choice, |job| assemble(pieces, &options, job)) else { return };
    input::expect_valid(&made.mesh, |_| {});
    for (map, piece) in made.maps.iter().zip(pieces) {
        assert_eq!((map.faces.len(), map.vertices.len()), (piece.faces().len(), piece.positions().len()));
    }
}
