//! Certificates, against a matching of faces written out in full, distances by brute force, and
//! exact integers.

use crate::common::Soup;
use crate::pieces::cube;
use glam::DVec3;
use gusset::Job;
use gusset::certify::{Certificate, certify};
use proptest::prelude::*;

fn certified(inputs: &[Soup], result: &Soup) -> Certificate {
    let views: Vec<_> = inputs.iter().map(Soup::view).collect();
    certify(&views, &result.view(), &Job::default()).unwrap()
}

/// A face as its points.
fn points_of(soup: &Soup, face: &[u32]) -> Vec<[f64; 3]> {
    face.iter().map(|&v| soup.points[v as usize].map(|x| x + 0.0)).collect()
}

fn is_rotation(a: &[[f64; 3]], b: &[[f64; 3]]) -> bool {
    a.len() == b.len() && (0..a.len()).any(|k| (0..a.len()).all(|i| a[(k + i) % a.len()] == b[i]))
}

/// The kept, turned, lost and new faces: each input face searches all result faces that are left.
fn match_by_search(inputs: &[Soup], result: &Soup) -> (u64, Vec<[u32; 2]>, Vec<[u32; 2]>, u32) {
    let mut left: Vec<_> = result.faces().map(|face| points_of(result, face)).collect();
    let mut take = |face: &[[f64; 3]]| {
        let found = left.iter().position(|other| is_rotation(face, other));
        found.map(|k| left.remove(k)).is_some()
    };
    let all = inputs.iter().zip(0..).flat_map(|(soup, piece)| {
        soup.faces().zip(0..).map(move |(face, f)| ([piece, f], points_of(soup, face))).collect::<Vec<_>>()
    });
    let (kept, waiting): (Vec<_>, Vec<_>) = all.partition(|(_, face)| take(face));
    let (turned, lost): (Vec<_>, Vec<_>) = waiting.into_iter().partition(|(_, face)| {
        let reversed: Vec<_> = face.iter().rev().copied().collect();
        take(&reversed)
    });
    let places = |list: Vec<([u32; 2], Vec<[f64; 3]>)>| list.into_iter().map(|(place, _)| place).collect();
    (kept.len() as u64, places(turned), places(lost), left.len() as u32)
}

fn used_points(soup: &Soup) -> Vec<DVec3> {
    soup.corners.iter().map(|&v| DVec3::from_array(soup.points[v as usize])).collect()
}

fn soup_of(points: &[(i8, i8, i8)], faces: &[Vec<u32>]) -> Soup {
    let points = points.iter().map(|&(x, y, z)| [x, y, z].map(f64::from)).collect();
    let mut soup = Soup { points, offsets: vec![0], corners: Vec::new() };
    faces.iter().for_each(|face| soup.face(face));
    soup
}

fn lattice_soup() -> impl Strategy<Value = Soup> {
    let points = prop::collection::vec((0i8..3, 0i8..2, 0i8..2), 9);
    let faces = prop::collection::vec(prop::collection::vec(0u32..9, 3..6), 1..9);
    (points, faces).prop_map(|(points, faces)| soup_of(&points, &faces))
}

proptest! {
    /// Coincident vertices, degenerate and repeated faces are common on a small lattice.
    #[test]
    fn faces_and_vertices_are_matched_as_by_search(
        inputs in prop::collection::vec(lattice_soup(), 0..3),
        mut result in lattice_soup(),
        taken in prop::collection::vec((0usize..3, 0usize..9, any::<bool>()), 0..9),
    ) {
        for (piece, face, reverse) in taken {
            let Some((soup, face)) = inputs.get(piece).and_then(|soup| Some((soup, soup.faces().nth(face)?))) else {
                continue;
            };
            let first = result.points.len() as u32;
            let mut corners: Vec<u32> = (first..first + face.len() as u32).collect();
            result.points.extend(face.iter().map(|&v| soup.points[v as usize]));
            if reverse {
                corners.reverse();
            }
            corners.rotate_left(1);
            result.face(&corners);
        }
        let made = certified(&inputs, &result);
        let (kept, turned, lost, new) = match_by_search(&inputs, &result);
        prop_assert_eq!((made.kept_faces, &made.turned_faces, &made.lost_faces, made.new_faces), (kept, &turned, &lost, new));
        let targets = used_points(&result);
        let gap = |p: &DVec3| targets.iter().map(|q| p.distance(*q)).fold(f64::INFINITY, f64::min);
        let farthest = inputs.iter().flat_map(used_points).map(|p| gap(&p)).fold(0.0, f64::max);
        prop_assert!((made.farthest_vertex.map_or(0.0, |found| found.distance) - farthest).abs() < 1e-12);
        if let Some(found) = made.farthest_vertex {
            let at = DVec3::from_array(inputs[found.piece as usize].points[found.vertex as usize]);
            let to = DVec3::from_array(result.points[found.nearest as usize]);
            prop_assert_eq!(at.distance(to), found.distance);
            prop_assert!(targets.contains(&to));
        }
        let mut used = result.corners.clone();
        used.sort_unstable();
        used.dedup();
        prop_assert_eq!(made.vertices as usize, used.len());
    }

    #[test]
    fn collinear_triangles_are_counted_exactly(points in prop::collection::vec((0i8..4, 0i8..4, 0i8..2), 6), scale in -200i32..200) {
        let faces: Vec<Vec<u32>> = vec![vec![0, 1, 2], vec![3, 4, 5], vec![1, 3, 5], vec![0, 0, 4]];
        let mut soup = soup_of(&points, &faces);
        soup.points.iter_mut().flatten().for_each(|x| *x *= 2f64.powi(scale));
        let at = |v: u32| { let (x, y, z) = points[v as usize]; [x, y, z].map(i32::from) };
        let is_flat = |face: &Vec<u32>| {
            let [a, b, c] = [at(face[0]), at(face[1]), at(face[2])];
            let [u, v] = [b, c].map(|p| [0, 1, 2].map(|k| p[k] - a[k]));
            [(1, 2), (2, 0), (0, 1)].iter().all(|&(i, j)| u[i] * v[j] == u[j] * v[i])
        };
        let expected = faces[..3].iter().filter(|face| is_flat(face)).count();
        prop_assert_eq!(certified(&[], &soup).collinear_triangles as usize, expected);
    }
}

/// A cube at a centre, turned inside out if `inward`.
fn cube_at(centre: f64, size: f64, inward: bool) -> Soup {
    let mut soup = cube(2);
    soup.points.iter_mut().flatten().for_each(|x| *x = *x * size + centre);
    let faces: Vec<Vec<u32>> = soup.faces().map(|face| face.iter().rev().copied().collect()).collect();
    if inward {
        (soup.offsets, soup.corners) = (vec![0], Vec::new());
        faces.iter().for_each(|face| soup.face(face));
    }
    soup
}

#[test]
fn solids_face_outwards_and_cavities_inwards() {
    for inward in [[false, false], [false, true], [true, false], [true, true]] {
        let [outer, inner] = [cube_at(0.0, 4.0, inward[0]), cube_at(0.0, 1.0, inward[1])];
        let made = certified(std::slice::from_ref(&outer), &outer.and(&inner));
        assert_eq!(made.outward, inward == [false, true], "{inward:?}");
        assert!(made.closed);
        assert_eq!((made.components, made.lost_faces.len()), (2, 0));
        let beside = cube_at(20.0, 1.0, inward[1]);
        assert_eq!(certified(&[], &outer.and(&beside)).outward, inward == [false, false], "{inward:?}");
    }
    let crossing = cube_at(0.0, 4.0, false).and(&cube_at(1.0, 4.0, false));
    assert!(!certified(&[], &crossing).outward, "faces intersect");
}

#[test]
fn polygons_come_with_their_triangles() {
    let sheet =
        soup_of(&[(0, 0, 0), (2, 0, 0), (2, 2, 0), (1, 1, 0), (0, 2, 0)], &[vec![0, 1, 2], vec![0, 1, 2, 3, 4]]);
    let triangles = certified(&[], &sheet).polygon_triangles;
    assert_eq!(triangles.len(), 3);
    assert!(triangles.as_flattened().iter().all(|h| (3..8).contains(h)));
}
