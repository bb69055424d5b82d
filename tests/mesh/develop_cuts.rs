//! Cuts of developments: those that are found, those that are given, and darts that lower the distortion.

use crate::common::{Soup, cap, edge_counts, faces_of, sheet, torus};
use crate::develop::{assert_isometric, at, bumps, cube, developed, dome, tetrahedron};
use glam::DVec2;
use gusset::Job;
use gusset::develop::{CutKind, Cuts, Developed, Finish, Options, develop};
use std::f64::consts::{PI, TAU};

#[test]
fn tubes_are_opened_along_the_shortest_path() {
    let (around, rows) = (24usize, 7usize);
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    for i in 0..rows {
        for j in 0..around {
            let angle = TAU * j as f64 / around as f64;
            soup.points.push([angle.cos(), angle.sin(), 0.5 * i as f64]);
        }
    }
    for i in 0..rows - 1 {
        for j in 0..around {
            let [a, b] = [j, (j + 1) % around].map(|j| (i * around + j) as u32);
            soup.face(&[a, b, b + around as u32, a + around as u32]);
        }
    }
    let done = developed(&soup, &Options::default());
    assert_isometric(&soup, &done, 1e-9);
    assert_eq!(done.cut_edges.len(), rows - 1);
    assert!(done.cut_edges.iter().all(|&(_, kind)| kind == CutKind::Opening));
    let high = done.points.iter().fold(DVec2::ZERO, |high, &p| high.max(p));
    let girth = around as f64 * 2.0 * (PI / around as f64).sin();
    assert!((high - DVec2::new(girth, 3.0)).length() < 1e-9, "{high}");
}

#[test]
fn handles_and_spheres_are_opened() {
    let sphere = cap(20, 8, 0.0, 1.0).turned();
    let closed = |soup: &Soup| edge_counts(soup.faces()).values().all(|&pair| pair == (1, 1));
    for soup in [torus(24, 12), torus(5, 4), torus(9, 7).and(&torus(6, 6)), cube(), tetrahedron()] {
        assert!(closed(&soup));
        let done = developed(&soup, &Options::default());
        assert!(!done.cut_edges.is_empty());
        assert!(done.charts.iter().all(|chart| chart.finish != Finish::Folded), "{:?}", done.charts);
    }
    // Two tori that are joined by a tube have two handles and no border.
    developed(&double_torus(), &Options::default());
    developed(&sphere, &Options::default());
    // Plates with holes.
    let full = sheet(12, 9);
    let holes = full.part(|face| {
        let p = full.middle(face);
        !(2.0..4.0).contains(&p.x) || !(2.0..5.0).contains(&p.y)
    });
    let done = developed(&holes, &Options::default());
    assert_isometric(&holes, &done, 1e-9);
}

/// Two tori, each without one quad, and a tube between the quads.
fn double_torus() -> Soup {
    let mut one = torus(12, 8);
    let mut other = torus(12, 8);
    other.points.iter_mut().for_each(|p| p[0] += 8.0);
    let open = |soup: &Soup, gone: usize| {
        let mut rest = Soup { points: soup.points.clone(), offsets: vec![0], ..Soup::default() };
        soup.faces().enumerate().filter(|&(f, _)| f != gone).for_each(|(_, face)| rest.face(face));
        (rest, soup.faces().nth(gone).unwrap().to_vec())
    };
    let (rest, rim) = open(&one, 0);
    one = rest;
    let (rest, mut far) = open(&other, 0);
    let shift = one.points.len() as u32;
    let mut both = one.and(&rest);
    far.iter_mut().for_each(|v| *v += shift);
    far.reverse();
    let n = rim.len();
    for k in 0..n {
        both.face(&[rim[k], rim[(k + 1) % n], far[(k + 1) % n], far[k]]);
    }
    both
}

#[test]
fn cuts_given_are_made() {
    let soup = sheet(10, 10);
    let path = [5u32, 5 + 11 * 4, 8 + 11 * 4];
    let done = developed(&soup, &Options { cuts: Cuts { vertices: &path, offsets: &[] }, ..Options::default() });
    assert_isometric_but_slits(&soup, &done);
    let given = done.cut_edges.iter().filter(|&&(_, kind)| kind == CutKind::Given).count();
    assert_eq!((given, done.cut_edges.len()), (7, 7));
    // Two parts: right across, in two paths.
    let ends = [0u32, 60, 60, 120];
    let done = developed(&soup, &Options { cuts: Cuts { vertices: &ends, offsets: &[0, 2, 4] }, ..Options::default() });
    assert_eq!(done.charts.len(), 2);
}

/// Slits of a plane sheet have both sides at one place.
fn assert_isometric_but_slits(soup: &Soup, done: &Developed) {
    for face in faces_of(&done.mesh) {
        let [a, b] = [face[0], face[1]];
        let flat = done.points[a as usize].distance(done.points[b as usize]);
        let wanted = at(soup, done.vertex_map[a as usize]).distance(at(soup, done.vertex_map[b as usize]));
        assert!((flat - wanted).abs() < 1e-9);
    }
}

#[test]
fn darts_lower_the_distortion() {
    let soup = dome(12, 1.5);
    let mut last = f64::INFINITY;
    for max_darts in [0, 1, 2, 4, 8] {
        let done = developed(&soup, &Options { max_darts, ..Options::default() });
        assert_eq!((done.darts, done.charts.len()), (max_darts, 1));
        let energy = done.charts[0].energy - 4.0;
        assert!(energy < last, "{max_darts}: {energy} after {last}");
        last = energy;
    }
    let some = developed(&soup, &Options { max_darts: 30, max_stretch: Some(1.15), ..Options::default() });
    let [most, least] = some.charts[0].stretch;
    assert!(most <= 1.15 && least >= 1.0 / 1.15 && some.darts > 0 && some.darts < 30, "{} darts", some.darts);
}

/// A slit whose sides touch at first does not block the rest, and a dart without effect is not
/// made.
#[test]
fn darts_never_raise_the_distortion() {
    for soup in [bumps(4), bumps(16)] {
        let mut last = f64::INFINITY;
        for max_darts in 0..6 {
            let done = developed(&soup, &Options { max_darts, ..Options::default() });
            assert!(done.darts <= max_darts && done.charts.iter().all(|chart| chart.overlaps == 0));
            assert_eq!(done.cut_edges.is_empty(), done.darts == 0);
            assert!(
                done.charts[0].energy <= last * (1.0 + 1e-6),
                "{max_darts}: {} after {last}",
                done.charts[0].energy
            );
            last = done.charts[0].energy;
        }
    }
    // As many as one likes end by themselves.
    let done = developed(&dome(4, 1.5), &Options { max_darts: u32::MAX, ..Options::default() });
    assert!(done.darts > 0 && done.charts[0].overlaps == 0);
}

/// Cuts may name a vertex by any of those that are one with it.
#[test]
fn cuts_know_merged_vertices() {
    let points = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let beyond = [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 0.0, 0.0], [2.0, 1.0, 0.0]];
    let soup = Soup::new([points, beyond].concat(), &[&[0, 1, 2, 3], &[4, 6, 7, 5]]);
    let merge: Vec<u8> = [0u32, 1, 2, 3, 1, 2, 6, 7].iter().flat_map(|v| v.to_ne_bytes()).collect();
    let corners = soup.view().merged_corners(&merge, &Job::default()).unwrap();
    let view = soup.view();
    let merged = view.merged(&merge, &corners);
    assert_eq!(develop(&merged, &Options::default(), &Job::default()).unwrap().charts.len(), 1);
    for cut in [[1, 2], [4, 5], [1, 5]] {
        let options = Options { cuts: Cuts { vertices: &cut, offsets: &[] }, ..Options::default() };
        assert_eq!(develop(&merged, &options, &Job::default()).unwrap().charts.len(), 2, "{cut:?}");
    }
}
