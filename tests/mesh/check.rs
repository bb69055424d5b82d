//! The check, against surfaces whose properties are known and against brute force.

use crate::common::{Soup, cap, edge_counts, euler, sheet};
use glam::DVec3;
use gusset::Job;
use gusset::check::{Check, check, find_intersecting_faces};
use gusset::mesh::{Faces, MeshView, Positions};
use proptest::prelude::*;
use std::collections::{HashMap, HashSet};

fn checked(soup: &Soup) -> Check {
    check(&soup.view(), &Job::default()).unwrap()
}

/// A w x h sheet with glued left and right sides, twisted if `twisted`. If `closed`, top and bottom
/// are glued, too: tube, Moebius strip, torus, Klein bottle.
fn glued(w: u32, h: u32, twisted: bool, closed: bool) -> Soup {
    let rows = if closed { h } else { h + 1 };
    let at = |i: u32, j: u32| {
        let j = if i == w && twisted { (h - j) % rows } else { j % rows };
        j * w + i % w
    };
    let points = (0..w * rows).map(|k| [f64::from(k % w), f64::from(k / w), f64::from(k * k % 7)]).collect();
    let mut soup = Soup { points, offsets: vec![0], corners: Vec::new() };
    for j in 0..h {
        for i in 0..w {
            soup.face(&[at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    soup
}

#[test]
fn surfaces_of_every_kind() {
    // euler, boundary walks, closed, orientable, genus
    let cases = [
        (sheet(4, 3), (1, 1, false, true, Some(0))),
        (glued(8, 3, false, false), (0, 2, false, true, Some(0))),
        (glued(8, 3, true, false), (0, 1, false, false, None)),
        (glued(8, 5, false, true), (0, 0, true, true, Some(1))),
        (glued(8, 5, true, true), (0, 0, true, false, None)),
        (glued(8, 5, false, true).and(&sheet(1, 1)), (1, 1, false, true, Some(1))),
        (glued(8, 5, false, true).and(&glued(5, 4, false, true)), (0, 0, true, true, Some(2))),
    ];
    for (i, (soup, expected)) in cases.iter().enumerate() {
        let c = checked(soup);
        assert_eq!((c.euler, c.boundary_walks, c.closed, c.orientable, c.genus), *expected, "case {i}: {c:?}");
        assert!(c.manifold && c.non_manifold_vertices.is_empty() && c.duplicate_faces.is_empty());
        assert_eq!(c.euler, euler(soup.faces()));
        assert_eq!(c.oriented, c.orientable);
    }
    assert_eq!(checked(&cases[5].0).components, 2);
    let sphere = checked(&cap(8, 3, 0.4, 1.0));
    assert_eq!((sphere.euler, sphere.genus, sphere.components), (1, Some(0), 1));
}

#[test]
fn quads_of_a_slice_are_those_of_offsets() {
    let box_points: Vec<_> = (0..8).map(|k| [k & 1, k >> 1 & 1, k >> 2].map(f64::from)).collect();
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let job = Job::default();
    let view = MeshView::new(Positions::from(&box_points[..]), Faces::quads(&quads).unwrap(), &job).unwrap();
    let of_slice = check(&view, &job).unwrap();
    let offsets = (0..=6).map(|f| 4 * f).collect();
    let of_offsets = checked(&Soup { points: box_points, offsets, corners: quads.concat() });
    assert_eq!((of_slice.euler, of_slice.closed, of_slice.genus), (2, true, Some(0)));
    assert_eq!(of_slice, of_offsets);
}

#[test]
fn a_flipped_face_is_orientable_but_not_oriented() {
    let mut soup = glued(8, 5, false, true);
    soup.corners[0..4].reverse();
    let c = checked(&soup);
    assert!(!c.oriented && c.orientable && c.manifold && c.closed);
    assert_eq!((c.orientation_conflicts.len(), c.genus), (4, Some(1)));
}

#[test]
fn each_defect_is_listed() {
    // A triangle twice, once from another corner and once backwards, and a quad with the same
    // vertices in another order.
    let c = checked(&Soup::flat(4, &[&[0, 1, 2, 3], &[0, 2, 1, 3], &[2, 3, 0, 1], &[1, 0, 3, 2]]));
    assert_eq!(c.duplicate_faces, [2, 3]);
    // Two cones that touch at their tips, closed below: a bow-tie without any boundary.
    let mut points = vec![[0.0; 3]];
    let mut faces: Vec<Vec<u32>> = Vec::new();
    for (k, z) in [(0, 1.0), (1, -1.0)] {
        let first = points.len() as u32;
        points.extend([[1.0, 0.0, z], [-1.0, 1.0, z], [-1.0, -1.0, z]]);
        let ring = [first, first + 1 + k, first + 2 - k];
        faces.extend((0..3).map(|i| vec![0, ring[i], ring[(i + 1) % 3]]));
        faces.push(ring.into_iter().rev().collect());
    }
    let list: Vec<&[u32]> = faces.iter().map(Vec::as_slice).collect();
    let c = checked(&Soup::new(points, &list));
    assert_eq!((c.bow_ties.as_slice(), c.non_manifold_vertices.as_slice()), (&[0][..], &[0][..]));
    assert!(c.closed && !c.manifold && c.genus.is_none() && c.non_manifold_edges.is_empty() && c.components == 2);
    // Three faces on an edge; a vertex nobody uses; a face that repeats a vertex, and touches
    // another there.
    let c = checked(&Soup::flat(8, &[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4], &[4, 5, 4, 7]]));
    assert_eq!((c.non_manifold_edges.as_slice(), c.non_manifold_vertices.as_slice()), (&[0][..], &[0, 1, 4][..]));
    assert_eq!((c.unused_vertices.as_slice(), c.degenerate_faces.as_slice(), c.closed), (&[6][..], &[3][..], false));
    let thin = Soup::new(vec![[0.1; 3], [0.2; 3], [0.7; 3], [0.0, 0.0, 1e-9]], &[&[0, 1, 2], &[0, 1, 3]]);
    assert_eq!(checked(&thin).zero_area_faces, [0]);
    let far = Soup::new(vec![[1e8, 0.0, 0.0], [1e8 + 1.0, 0.0, 0.0], [1e8, 1.0, 0.0]], &[&[0, 1, 2]]);
    assert!(checked(&far).zero_area_faces.is_empty());
}

/// A set of lists up to rotation and reversal.
fn canonical(face: &[u32]) -> Vec<u32> {
    let n = face.len();
    let all = (0..n).flat_map(|s| [1, n - 1].map(|step| (0..n).map(|i| face[(s + i * step) % n]).collect::<Vec<_>>()));
    all.min().unwrap()
}

fn is_simple(face: &[u32]) -> bool {
    face.iter().collect::<HashSet<_>>().len() == face.len()
}

proptest! {
    #[test]
    fn any_simple_faces(faces in prop::collection::vec(prop::collection::vec(0u32..8, 3..5), 1..20)) {
        let faces: Vec<Vec<u32>> = faces.into_iter().filter(|f| is_simple(f)).chain([vec![0, 1, 2]]).collect();
        let list: Vec<&[u32]> = faces.iter().map(Vec::as_slice).collect();
        let soup = Soup::flat(8, &list);
        let c = checked(&soup);
        let counts = edge_counts(soup.faces());
        prop_assert_eq!(c.edges as usize, counts.len());
        let with = |wanted: &dyn Fn(u32, u32) -> bool| counts.values().filter(|&&(a, b)| wanted(a, b)).count();
        prop_assert_eq!(c.boundary_edges.len(), with(&|a, b| a + b == 1));
        prop_assert_eq!(c.non_manifold_edges.len(), with(&|a, b| a + b > 2));
        prop_assert_eq!(c.orientation_conflicts.len(), with(&|a, b| a + b == 2 && a != b));
        prop_assert_eq!(c.euler, euler(soup.faces()));

        let mut seen = HashSet::new();
        let twins: Vec<u32> = (0..).zip(&faces).filter(|(_, f)| !seen.insert(canonical(f))).map(|(i, _)| i).collect();
        prop_assert_eq!(&c.duplicate_faces, &twins);

        // Fans by flooding: faces at v, joined where they share an edge at v that has exactly two
        // faces.
        let mut ties = Vec::new();
        for v in 0..8u32 {
            let at: Vec<usize> = (0..faces.len()).filter(|&f| faces[f].contains(&v)).collect();
            let mut group: HashMap<usize, usize> = at.iter().map(|&f| (f, f)).collect();
            for _ in 0..at.len() {
                for &f in &at {
                    for &g in &at {
                        let shared = (0..8u32).any(|u| {
                            let two = counts.get(&(u.min(v), u.max(v))).is_some_and(|&(a, b)| a + b == 2);
                            two && [f, g].iter().all(|&k| edge_counts(std::iter::once(faces[k].as_slice()))
                                .contains_key(&(u.min(v), u.max(v))))
                        });
                        if shared {
                            let low = group[&f].min(group[&g]);
                            group.insert(f, low);
                            group.insert(g, low);
                        }
                    }
                }
            }
            if group.values().collect::<HashSet<_>>().len() > 1 {
                ties.push(v);
            }
        }
        prop_assert_eq!(&c.bow_ties, &ties);
    }
}

#[test]
fn degenerate_faces_have_no_edges_and_close_nothing() {
    let c = checked(&Soup::flat(3, &[&[0, 1, 1]]));
    assert_eq!((c.edges, c.degenerate_faces.as_slice(), c.closed), (0, &[0][..], false));
    // They do not open a closed mesh: a tetrahedron with all of its faces, or without one.
    let faces: [&[u32]; 5] = [&[0, 1, 1], &[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]];
    for (faces, edges, closed) in [(&faces[..], 6, true), (&faces[..4], 6, false)] {
        let c = checked(&Soup::flat(4, faces));
        assert_eq!((c.edges, c.degenerate_faces.as_slice(), c.closed), (edges, &[0][..], closed));
    }
}

fn intersections(soup: &Soup) -> Vec<[u32; 2]> {
    find_intersecting_faces(&soup.view(), &Job::default()).unwrap()
}

#[test]
fn intersecting_faces_of_any_size() {
    // A sheet; an upright quad through the cells 0 and 1; a quad above that touches the cell 5 with a corner.
    let clean = sheet(3, 2);
    assert_eq!(intersections(&clean), [[0; 2]; 0]);
    let mut soup = clean;
    soup.points.extend([[0.25, 0.5, -1.0], [1.75, 0.5, -1.0], [1.75, 0.5, 1.0], [0.25, 0.5, 1.0]]);
    soup.face(&[12, 13, 14, 15]);
    soup.points.extend([[2.5, 1.25, 0.0], [3.0, 1.25, 1.0], [3.0, 1.75, 2.0], [2.5, 1.75, 1.0]]);
    soup.face(&[16, 17, 18, 19]);
    // A face with a repeated vertex, and an unused vertex.
    soup.face(&[12, 12, 14]);
    soup.points.push([f64::NAN; 3]);
    for size in [1.0, 1e-200, 1e200] {
        let scaled = Soup { points: soup.points.iter().map(|p| p.map(|x| x * size)).collect(), ..soup.clone() };
        assert_eq!(intersections(&scaled), [[0, 6], [1, 6], [5, 7]], "{size}");
    }
    // The same face twice.
    let mut twice = sheet(1, 1);
    twice.face(&[1, 3, 2, 0]);
    assert_eq!(intersections(&twice), [[0, 1]]);
}

proptest! {
    #[test]
    fn intersecting_faces_agree_with_brute_force(
        given in proptest::collection::vec(proptest::array::uniform9(0.0..1.0f64), 2..24),
    ) {
        let triangles: Vec<[DVec3; 3]> =
            given.iter().map(|x| [0, 3, 6].map(|k| DVec3::new(x[k], x[k + 1], x[k + 2]))).collect();
        let mut soup = Soup { offsets: vec![0], ..Soup::default() };
        for triangle in &triangles {
            let first = soup.points.len() as u32;
            soup.points.extend(triangle.map(|p| p.to_array()));
            soup.face(&[first, first + 1, first + 2]);
        }
        // In general position two triangles meet if an edge of one passes through the other.
        let volume = |p: DVec3, q: DVec3, r: DVec3, s: DVec3| (q - p).cross(r - p).dot(s - p);
        let passes = |[a, b, c]: [DVec3; 3], p: DVec3, q: DVec3| {
            let turns = [volume(p, q, a, b), volume(p, q, b, c), volume(p, q, c, a)].map(|v| v > 0.0);
            (volume(a, b, c, p) > 0.0) != (volume(a, b, c, q) > 0.0) && turns[0] == turns[1] && turns[1] == turns[2]
        };
        let one_way = |t: [DVec3; 3], u: [DVec3; 3]| (0..3).any(|k| passes(t, u[k], u[(k + 1) % 3]));
        let mut wanted = Vec::new();
        for (g, &u) in triangles.iter().enumerate() {
            for (f, &t) in triangles[..g].iter().enumerate() {
                if one_way(t, u) || one_way(u, t) {
                    wanted.push([f as u32, g as u32]);
                }
            }
        }
        wanted.sort_unstable();
        prop_assert_eq!(intersections(&soup), wanted);
    }
}
