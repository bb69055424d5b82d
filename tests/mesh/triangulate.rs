//! Faces as triangles, against volumes, areas and edge counts of prisms with concave ends.

use crate::common::{Soup, Steady, edge_counts, faces_of, sheet, volume};
use glam::DVec3;
use gusset::attributes::{Domain, Origins};
use gusset::check::find_intersecting_faces;
use gusset::mesh::{TriangulatedMesh, triangulate};
use gusset::{Error, Job, Progress};
use proptest::prelude::*;
use std::ops::ControlFlow;

/// Half a prism's height.
const HALF: f64 = 0.5;

fn triangulated(soup: &Soup) -> TriangulatedMesh {
    triangulate(&soup.view(), &Job::default()).unwrap()
}

/// A closed prism over a polygon. An edge that the polygon passes both ways has no side.
fn prism(points: &[[f64; 2]], polygon: &[u32]) -> Soup {
    let n = points.len() as u32;
    let at = |z: f64| points.iter().map(move |&[x, y]| [x, y, z]);
    let mut soup = Soup { points: at(-HALF).chain(at(HALF)).collect(), offsets: vec![0], corners: Vec::new() };
    let base: Vec<u32> = polygon.iter().rev().copied().collect();
    let top: Vec<u32> = polygon.iter().map(|v| v + n).collect();
    soup.face(&base);
    soup.face(&top);
    let edges: Vec<[u32; 2]> = (0..polygon.len()).map(|k| [polygon[k], polygon[(k + 1) % polygon.len()]]).collect();
    for &[u, v] in edges.iter().filter(|&&[u, v]| !edges.contains(&[v, u])) {
        soup.face(&[u, v, v + n, u + n]);
    }
    soup
}

/// The area that triangles cover, each counted without sign.
fn covered_area(done: &TriangulatedMesh, faces: std::ops::Range<u32>) -> f64 {
    let at = |v: u32| done.mesh.positions.get(v);
    let of = |[a, b, c]: [u32; 3]| (at(b) - at(a)).cross(at(c) - at(a)).length() / 2.0;
    let triangles = faces_of(&done.mesh).zip(&done.faces).filter(|(_, face)| faces.contains(face));
    triangles.map(|(triangle, _)| of([triangle[0], triangle[1], triangle[2]])).sum()
}

/// The triangles use each corner of their faces, close what was closed, and keep the volume. Their
/// areas add up to `ends` at both ends together.
fn assert_prism(soup: &Soup, ends: f64) {
    let done = triangulated(soup);
    let corners: usize = soup.faces().map(|face| face.len() - 2).sum();
    assert_eq!(done.faces.len(), corners);
    assert!(edge_counts(faces_of(&done.mesh)).values().all(|&(there, back)| there == back));
    let inside = volume(|v| done.mesh.positions.get(v).to_array(), faces_of(&done.mesh));
    assert!((inside - ends * HALF).abs() < 1e-9 * ends, "{inside}");
    let area = covered_area(&done, 0..2);
    assert!((area - ends).abs() < 1e-9 * ends, "{area} instead of {ends}");
    let mut is_used = vec![false; soup.corners.len()];
    for (triangle, [face, corners]) in faces_of(&done.mesh)
        .zip(done.faces.iter().zip(done.corners.chunks(3)).map(|(&face, own)| [vec![face], own.to_vec()]))
    {
        let range = soup.offsets[face[0] as usize]..soup.offsets[face[0] as usize + 1];
        for (&vertex, &corner) in triangle.iter().zip(&corners) {
            assert!(range.contains(&corner) && soup.corners[corner as usize] == vertex);
            is_used[corner as usize] = true;
        }
    }
    assert!(is_used.iter().all(|&used| used));
}

#[test]
fn profiles_and_walls_with_windows() {
    let u = [[0.0, 0.0], [5.0, 0.0], [5.0, 4.0], [4.0, 4.0], [4.0, 1.0], [1.0, 1.0], [1.0, 4.0], [0.0, 4.0]];
    assert_prism(&prism(&u, &[0, 1, 2, 3, 4, 5, 6, 7]), 22.0);
    // A wall of 6 x 4 with a window of 2 x 1, which the bridge from vertex 0 to vertex 4 reaches.
    let wall = [[0.0, 0.0], [6.0, 0.0], [6.0, 4.0], [0.0, 4.0], [1.0, 1.0], [1.0, 2.0], [3.0, 2.0], [3.0, 1.0]];
    assert_prism(&prism(&wall, &[0, 1, 2, 3, 0, 4, 5, 6, 7, 4]), 44.0);
}

#[test]
fn a_bar_in_the_notch_of_a_u_meets_nothing() {
    let u = [[0.0, 0.0], [5.0, 0.0], [5.0, 4.0], [4.0, 4.0], [4.0, 1.0], [1.0, 1.0], [1.0, 4.0], [0.0, 4.0]];
    let bar = [[2.0, 2.0], [3.0, 2.0], [3.0, 3.0], [2.0, 3.0]];
    let long = |soup: Soup| Soup { points: soup.points.iter().map(|&[x, y, z]| [x, y, 3.0 * z]).collect(), ..soup };
    let both = prism(&u, &[0, 1, 2, 3, 4, 5, 6, 7]).and(&long(prism(&bar, &[0, 1, 2, 3])));
    assert!(find_intersecting_faces(&both.view(), &Job::default()).unwrap().is_empty());
    let inside = bar.map(|[x, y]| [x, y - 2.2]);
    let both = prism(&u, &[0, 1, 2, 3, 4, 5, 6, 7]).and(&long(prism(&inside, &[0, 1, 2, 3])));
    assert!(!find_intersecting_faces(&both.view(), &Job::default()).unwrap().is_empty());
}

#[test]
fn origins_name_the_old_elements() {
    let soup = sheet(3, 2);
    let done = triangulated(&soup);
    let origins = Origins::from_triangulated(&done, &Job::default()).unwrap();
    assert_eq!(origins.inputs()[0].corners, soup.corners.len());
    assert_eq!(origins.inputs()[0].faces, soup.faces().count());
    for (t, &face) in done.faces.iter().enumerate() {
        assert_eq!(origins.table(Domain::Faces).row(t).0, [face]);
    }
    for (k, &corner) in done.corners.iter().enumerate() {
        assert_eq!(origins.table(Domain::Corners).row(k).0, [corner]);
    }
}

/// Counts calls, and cancels from one call on.
struct CancelAfter(std::cell::Cell<usize>, usize);

impl Progress for CancelAfter {
    fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
        self.0.set(self.0.get() + 1);
        if self.0.get() > self.1 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

#[test]
fn progress_goes_on_within_a_face_and_never_back() {
    // All corners of the last two faces lie on a line, which no rule but the weakest splits.
    let mut soup = sheet(100, 100);
    let n = 1000u32;
    for _ in 0..2 {
        let first = soup.points.len() as u32;
        soup.points.extend((0..n).map(|k| [f64::from(k.min(n - k)), -1.0, 0.0]));
        soup.face(&(first..first + n).collect::<Vec<u32>>());
    }
    triangulate(&soup.view(), &Job::new(1, &Steady::default())).unwrap();
    find_intersecting_faces(&sheet(20, 20).and(&soup).view(), &Job::new(1, &Steady::default())).unwrap();
    let all = CancelAfter(0.into(), usize::MAX);
    triangulate(&soup.view(), &Job::new(1, &all)).unwrap();
    let count = all.0.get();
    assert!(count > 20, "{count}");
    for calls in [0, 1, count / 2, count - 1] {
        let some = CancelAfter(0.into(), calls);
        assert!(matches!(triangulate(&soup.view(), &Job::new(1, &some)), Err(Error::Cancelled)), "{calls}");
        assert_eq!(some.0.get(), calls + 1);
    }
}

proptest! {
    /// Prisms over stars, in any place and unit.
    #[test]
    fn prisms_over_stars_keep_volume_and_area(
        radii in prop::collection::vec(0.1..1.0, 5..30),
        exponent in -100i32..100,
        first in 0usize..30,
    ) {
        let n = radii.len();
        let unit = 2f64.powi(exponent);
        let at = |k: usize| {
            let (sin, cos) = (std::f64::consts::TAU * k as f64 / n as f64).sin_cos();
            [radii[k] * cos, radii[k] * sin]
        };
        let points: Vec<[f64; 2]> = (0..n).map(at).collect();
        let mut polygon: Vec<u32> = (0..n as u32).collect();
        polygon.rotate_left(first % n);
        let shoelace: f64 = (0..n).map(|k| {
            let ([a, b], [c, d]) = (points[k], points[(k + 1) % n]);
            a * d - b * c
        }).sum();
        let soup = prism(&points, &polygon);
        assert_prism(&soup, shoelace);
        let scaled: Vec<[f64; 3]> = soup.points.iter().map(|&p| (DVec3::from(p) * unit).to_array()).collect();
        let far = triangulated(&Soup { points: scaled, offsets: soup.offsets.clone(), corners: soup.corners.clone() });
        prop_assert_eq!(far.corners, triangulated(&soup).corners);
    }
}
