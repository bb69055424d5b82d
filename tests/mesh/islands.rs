//! Islands of overlapping scans: small parts beside a large one, each shown by one scan or by several.

use crate::common::{Soup, faces_of, sheet, some_of};
use glam::DVec3;
use gusset::Job;
use gusset::assemble::{self, Assembly, Overlaps, assemble};
use gusset::fill::{self, Keep};
use gusset::mesh::{MeshView, NONE};
use gusset::trim;
use std::collections::BTreeSet;

/// A square of cells about a centre, slightly curved.
#[derive(Clone, Copy, Debug)]
struct Island {
    centre: [f64; 2],
    cells: u32,
    /// The scans that show it.
    shown: [bool; 2],
    /// The part that the second scan shows begins at this row and column of the part that the first shows.
    slide: [u32; 2],
}

/// Islands on a grid of places, at least four edges from each other.
fn random_islands(random: &mut fastrand::Rng) -> Vec<Island> {
    (0..random.u32(1..21))
        .map(|k| Island {
            centre: [26.0 * f64::from(k % 5), -18.0 - 26.0 * f64::from(k / 5)],
            cells: random.u32(3..14),
            shown: [[true, true], [true, true], [true, false], [false, true]][random.usize(0..4)],
            slide: [random.u32(0..6), random.u32(0..6)],
        })
        .collect()
}

fn moved(mut soup: Soup, by: [f64; 3]) -> Soup {
    soup.points.iter_mut().for_each(|p| *p = [p[0] + by[0], p[1] + by[1], p[2] + by[2]]);
    soup
}

/// Triangles in place of quads.
fn triangles(soup: &Soup) -> Soup {
    let mut cut = Soup { points: soup.points.clone(), offsets: vec![0], ..Soup::default() };
    for face in soup.faces() {
        cut.face(&[face[0], face[1], face[2]]);
        cut.face(&[face[0], face[2], face[3]]);
    }
    cut
}

/// A scan: its part of a large sheet, and the islands that it shows.
fn scan(islands: &[Island], k: usize, shift: f64) -> Soup {
    let body = sheet(40, 60);
    let left = if k == 0 { 0.0 } else { 30.0 };
    let mut soup = triangles(&moved(body, [left, 10.0, 0.0]));
    for island in islands.iter().filter(|island| island.shown[k]) {
        let half = f64::from(island.cells) / 2.0;
        let [right, up] = if k == 0 { [0.0; 2] } else { island.slide.map(f64::from) };
        let corner = [island.centre[0] - half + right, island.centre[1] - half + up, 0.0];
        let patch = moved(sheet(island.cells, island.cells), corner);
        soup = soup.and(&triangles(&patch));
    }
    let by = shift * k as f64;
    for p in &mut soup.points {
        let [x, y, _] = *p;
        *p = [x + by, y + by, 0.3 * (0.2 * x).sin() * (0.15 * y).cos() + 0.05 * by];
    }
    soup
}

fn run(pieces: &[Soup]) -> Assembly {
    let views: Vec<MeshView<'_>> = pieces.iter().map(Soup::view).collect();
    let options = assemble::Options {
        overlaps: Overlaps::Trim(trim::Options::default()),
        weld: Some(Default::default()),
        fill: Some(fill::Options { keep: Keep::OuterBorders, ..fill::Options::default() }),
        ..Default::default()
    };
    assemble(&views, &options, &Job::default()).unwrap()
}

/// The centres of the faces of the pieces in the result.
fn centres(done: &Assembly) -> Vec<DVec3> {
    let at = |v: u32| done.mesh.positions.get(v);
    let of_pieces = faces_of(&done.mesh).take(done.turned.len());
    of_pieces.map(|face| face.iter().map(|&v| at(v)).sum::<DVec3>() / face.len() as f64).collect()
}

#[test]
fn islands_are_kept_or_covered_and_losses_are_listed() {
    for seed in some_of(20, 0..200) {
        let mut random = fastrand::Rng::with_seed(seed);
        let islands = random_islands(&mut random);
        let shift = 0.1 + 0.3 * random.f64();
        let pieces = [scan(&islands, 0, shift), scan(&islands, 1, shift)];
        let done = run(&pieces);
        let kept = centres(&done);
        let listed: BTreeSet<[u32; 2]> = done.lost_faces.iter().copied().collect();
        assert!(done.lost_faces.is_sorted(), "{seed}");
        // The faces that are dropped, by brute force. In steps, because the search is slow.
        let (mut lost, mut near) = (0, 0);
        for ((piece, map), k) in pieces.iter().zip(&done.maps).zip(0u32..) {
            for ((face, &name), f) in piece.faces().zip(&map.faces).zip(0u32..) {
                let is_listed = listed.contains(&[k, f]);
                assert!(!is_listed || name == NONE, "{seed}: face {f} of piece {k} is listed and kept");
                if name != NONE || (f % 5 != 0 && !is_listed) {
                    continue;
                }
                let centre = piece.middle(face);
                let distance = kept.iter().map(|c| c.distance_squared(centre)).fold(f64::INFINITY, f64::min).sqrt();
                // Centres are at most an edge from the nearest place of their faces.
                assert!(is_listed || distance < 6.5, "{seed}: face {f} of piece {k} is lost, {distance} away");
                assert!(!is_listed || distance > 3.5, "{seed}: face {f} of piece {k} is covered, {distance} away");
                (lost, near) = (lost + usize::from(is_listed), near + usize::from(!is_listed));
            }
        }
        // Whole islands stay, unless they are smaller than the smallest part.
        for island in &islands {
            let faces = 2 * island.cells * island.cells;
            let [x, y] = island.centre;
            let reach = f64::from(island.cells) / 2.0 + 6.5;
            let on_island = |c: &&DVec3| (c.x - x).abs() < reach && (c.y - y).abs() < reach;
            let count = kept.iter().filter(on_island).count();
            assert!(faces < 30 || count * 10 >= faces as usize * 6, "{seed}: {count} of {faces} faces of {island:?}");
        }
        assert!(near > 0, "{seed}: the sheets overlap");
        println!("{seed}: {} islands, {lost} faces lost", islands.len());
    }
}
