//! Orientation, against surfaces whose properties are known and against brute force.

use crate::common::{Soup, cap, edge_counts, faces_of, sheet, torus, volume};
use gusset::Job;
use gusset::repair::orient::{OneSided, Options, Oriented, Outward, orient};
use proptest::prelude::*;

const OUTWARDS: Options = Options { outward: Outward::Closed };

fn oriented(soup: &Soup, options: &Options) -> Oriented {
    orient(&soup.view(), options, &Job::default()).unwrap()
}

/// Faces for which `turn` is true are turned over, from their first corners.
fn turned(soup: &Soup, turn: impl Fn(usize) -> bool) -> Soup {
    let mut other = Soup { points: soup.points.clone(), offsets: vec![0], corners: Vec::new() };
    for (f, face) in soup.faces().enumerate() {
        let mut face = face.to_vec();
        if turn(f) {
            face[1..].reverse();
        }
        other.face(&face);
    }
    other
}

fn volume_of(done: &Oriented) -> f64 {
    volume(|v| done.mesh.positions.get(v).to_array(), faces_of(&done.mesh))
}

/// A strip of `n` quads whose ends are glued, turned over on the way.
fn moebius(n: u32) -> Soup {
    let points = (0..2 * n).map(|k| [f64::from(k % n), f64::from(k / n), f64::from(k * k % 7)]).collect();
    let mut soup = Soup { points, offsets: vec![0], corners: Vec::new() };
    for i in 0..n {
        let (low, high) = if i + 1 == n { (n, 0) } else { (i + 1, n + i + 1) };
        soup.face(&[i, low, high, n + i]);
    }
    soup
}

proptest! {
    #[test]
    fn as_few_faces_as_possible_are_turned(
        flips in prop::collection::vec(any::<bool>(), 60),
        (n, m) in (3u32..7, 3u32..7),
    ) {
        // A torus, a sheet, and a closed one more.
        let whole = torus(n, m).and(&sheet(n, 2)).and(&torus(3, 4));
        let sizes = [(n * m) as usize, 2 * n as usize, 12];
        let soup = turned(&whole, |f| flips[f % 60]);
        let done = oriented(&soup, &Options::default());
        prop_assert!(edge_counts(faces_of(&done.mesh)).values().all(|&(a, b)| a <= 1 && b <= 1));
        prop_assert_eq!((done.components, done.inverted_components), (3, 0));
        prop_assert!(done.one_sided.is_empty());
        let mut first = 0;
        let mut total = 0;
        for size in sizes {
            let wrong = (first..first + size).filter(|&f| flips[f % 60]).count();
            let count = done.turned[first..first + size].iter().filter(|&&t| t).count();
            prop_assert_eq!(count, wrong.min(size - wrong));
            prop_assert!(2 * wrong != size || !done.turned[first]);
            first += size;
            total += count;
        }
        prop_assert_eq!(done.turned_faces as usize, total);
        // The flags report the reversed faces, and each face keeps its first corner.
        let again = turned(&soup, |f| done.turned[f]);
        prop_assert_eq!(&again.corners, &done.mesh.face_corners);
        prop_assert_eq!(oriented(&again, &Options::default()).turned_faces, 0);
    }

    #[test]
    fn closed_components_face_away_from_the_solid(
        flips in prop::collection::vec(any::<bool>(), 60),
        exponent in -290i32..290,
        shift in -1e6..1e6,
    ) {
        // One torus within another, wherever it lies and whatever its unit is.
        let mut inner = torus(5, 4);
        inner.points.iter_mut().for_each(|p| {
            let r = (p[0] * p[0] + p[1] * p[1]).sqrt();
            *p = [p[0] / r * (2.0 + (r - 2.0) / 2.0), p[1] / r * (2.0 + (r - 2.0) / 2.0), p[2] / 2.0];
        });
        let mut soup = turned(&torus(6, 5).and(&inner), |f| flips[f % 60]);
        let unit = 2f64.powi(exponent);
        soup.points.iter_mut().flatten().for_each(|x| *x = (*x + shift) * unit);
        let done = oriented(&soup, &OUTWARDS);
        let relative = |v: u32| done.mesh.positions.get(v).to_array().map(|x| x / unit - shift);
        let faces: Vec<_> = faces_of(&done.mesh).collect();
        // The inner torus is a cavity.
        for (shell, side) in [(&faces[..30], 1.0), (&faces[30..], -1.0)] {
            prop_assert!(side * volume(relative, shell.iter().copied()) > 0.0);
            prop_assert!(edge_counts(shell.iter().copied()).values().all(|&count| count == (1, 1)));
        }
        let majority = oriented(&soup, &Options::default());
        let different = |range: std::ops::Range<usize>| done.turned[range.clone()] != majority.turned[range];
        let inverted = u32::from(different(0..30)) + u32::from(different(30..50));
        prop_assert_eq!(done.inverted_components, inverted);
    }
}

#[test]
fn inside_out_is_turned_only_if_asked_and_closed() {
    let inside_out = torus(6, 4).turned();
    assert_eq!(oriented(&inside_out, &Options::default()).turned_faces, 0);
    let done = oriented(&inside_out, &OUTWARDS);
    assert_eq!((done.turned_faces, done.inverted_components), (24, 1));
    assert!(volume_of(&done) > 0.0);
    // An open surface encloses no volume.
    assert_eq!(oriented(&cap(8, 3, 0.2, 1.0).turned(), &OUTWARDS).turned_faces, 0);
    // A doubled sheet encloses no volume.
    let flat = Soup::flat(3, &[&[0, 1, 2], &[0, 2, 1]]);
    assert_eq!(oriented(&flat, &OUTWARDS).turned_faces, 0);
    // A bent one too, whatever round-off makes of its volume: the lower side starts each face
    // elsewhere.
    let mut bent = cap(9, 3, 0.3, 1.0);
    for face in bent.clone().faces() {
        let mut below: Vec<u32> = face.iter().rev().copied().collect();
        below.rotate_left(1);
        bent.face(&below.iter().map(|&v| if v > 18 { v } else { v + 28 }).collect::<Vec<_>>());
    }
    // Vertices 19 to 27 are the rim, which both sides share.
    bent.points.extend_from_within(0..19);
    for soup in [bent.turned(), bent] {
        assert_eq!(oriented(&soup, &OUTWARDS).turned_faces, 0);
    }
    let flat = Soup::flat(3, &[&[0, 1, 2], &[0, 1, 2]]);
    assert_eq!(oriented(&flat, &OUTWARDS).turned, [false, true]);
}

#[test]
fn one_sided_surfaces_stay_and_are_named() {
    let soup = sheet(2, 2).and(&moebius(7)).and(&torus(3, 3)).and(&moebius(5));
    let soup = turned(&soup, |f| f % 3 == 1);
    let done = oriented(&soup, &Options::default());
    assert_eq!(done.components, 4);
    assert_eq!(done.one_sided.iter().map(|found| found.face).collect::<Vec<_>>(), [4, 20]);
    for (found, faces) in done.one_sided.iter().zip([4..11, 20..25]) {
        assert!(faces.contains(&(found.half_edge / 4)));
        for f in faces {
            assert!(!done.turned[f as usize]);
        }
        // Without the face behind it the rest can be oriented.
        let mut rest = Soup { points: soup.points.clone(), offsets: vec![0], corners: Vec::new() };
        soup.faces()
            .enumerate()
            .filter(|&(f, _)| f as u32 != found.half_edge / 4)
            .for_each(|(_, face)| rest.face(face));
        assert_eq!(oriented(&rest, &Options::default()).one_sided.len(), 1);
    }
    assert!(done.turned_faces > 0);
}

#[test]
fn edges_of_three_faces_connect_nothing() {
    // Three triangles on one edge, two of them the same way; and one neighbour.
    let soup = Soup::flat(6, &[&[0, 1, 2], &[0, 1, 3], &[1, 0, 4], &[2, 1, 5]]);
    let done = oriented(&soup, &Options::default());
    assert_eq!((done.components, done.turned_faces), (3, 0));
    // A degenerate face connects no faces and is not reversed; a closed surface with one is closed
    // without it.
    let mut soup = torus(4, 4).turned();
    soup.face(&[0, 0, 1]);
    soup.face(&[2, 3, 2]);
    let done = oriented(&soup, &OUTWARDS);
    assert_eq!((done.components, done.turned_faces, done.inverted_components), (3, 16, 1));
    assert_eq!(done.mesh.face_corners[64..], [0, 0, 1, 2, 3, 2]);
}

#[test]
fn vertices_that_no_face_uses_may_be_anything() {
    let mut soup = torus(4, 3).turned();
    soup.points.push([f64::NAN; 3]);
    let done = oriented(&soup, &OUTWARDS);
    assert_eq!(done.turned_faces, 12);
    assert!(done.mesh.positions.get(12).is_nan());
    // The largest numbers that there are.
    let largest = |x: f64| if x > 0.0 { f64::MAX } else { -f64::MAX };
    let points = [[1.0, 1.0, 1.0], [-1.0, -1.0, 1.0], [-1.0, 1.0, -1.0], [1.0, -1.0, -1.0]].map(|p| p.map(largest));
    let soup = Soup::new(points.to_vec(), &[&[0, 1, 2], &[0, 2, 3], &[0, 3, 1], &[1, 3, 2]]);
    let wrong = soup.turned();
    let (done, other) = (oriented(&soup, &OUTWARDS), oriented(&wrong, &OUTWARDS));
    assert_eq!(done.turned_faces + other.turned_faces, 4);
}

#[test]
fn a_search_is_deterministic() {
    let soup = moebius(9);
    assert_eq!(oriented(&soup, &Options::default()), oriented(&soup, &Options::default()));
    let found = oriented(&soup, &Options::default()).one_sided;
    assert!(matches!(found.as_slice(), [OneSided { face: 0, .. }]));
}
