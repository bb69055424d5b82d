//! Boundary loops against shapes whose boundary is known, and against a count by hashing.

use crate::common::{Silent, Soup, cap, edge_counts, sheet};
use gusset::Job;
use gusset::boundary::{Boundary, EdgeFlags, LoopFlags, NonManifold, Options, Survey, boundary_loops};
use gusset::mesh::Defect;
use proptest::prelude::*;
use std::collections::HashSet;

fn boundary(soup: &Soup) -> Boundary {
    boundary_loops(&soup.view(), &Options::default(), &Job::default()).unwrap()
}

fn loops(boundary: &Boundary) -> Vec<Vec<u32>> {
    boundary.iter().map(|l| l.vertices.to_vec()).collect()
}

/// The fast algorithm gives the loops of the exact one, without the defects that it ignores.
fn check_fast(soup: &Soup) {
    let exact = boundary(soup);
    let options = Options { survey: Survey::BoundaryOnly, ..Options::default() };
    let fast = boundary_loops(&soup.view(), &options, &Job::default()).unwrap();
    let balanced = |&(forward, backward): &(u32, u32)| forward == backward && forward > 1;
    if edge_counts(soup.faces()).values().any(balanced) {
        return;
    }
    assert_eq!(fast.len(), exact.len());
    for (f, e) in fast.iter().zip(exact.iter()) {
        assert_eq!(
            (f.vertices, f.half_edges, f.faces, f.edge_flags),
            (e.vertices, e.half_edges, e.faces, e.edge_flags)
        );
        assert_eq!((f.walk, f.length.to_bits()), (e.walk, e.length.to_bits()));
        // A closed fan that touches the boundary at a vertex is away from it.
        assert_eq!(f.flags.0 | LoopFlags::BOW_TIE, e.flags.0 | LoopFlags::BOW_TIE);
    }
}

/// Checks every boundary: edges exist, each free edge is in exactly one loop, loops are simple.
fn check_invariants(soup: &Soup, found: &Boundary) {
    let counts = edge_counts(soup.faces());
    let mut seen = HashSet::new();
    for l in found.iter() {
        let open = l.flags.any(LoopFlags::OPEN);
        assert_eq!(l.vertices.len(), l.half_edges.len() + usize::from(open));
        assert_eq!(l.vertices.iter().collect::<HashSet<_>>().len(), l.vertices.len(), "a loop passes a vertex twice");
        for (i, (&h, &face)) in l.half_edges.iter().zip(l.faces).enumerate() {
            assert!(seen.insert(h), "half-edge {h} twice");
            let range = soup.offsets[face as usize]..soup.offsets[face as usize + 1];
            assert!(range.contains(&h));
            let next = if h + 1 == range.end { range.start } else { h + 1 };
            let (mut u, mut v) = (soup.corners[h as usize], soup.corners[next as usize]);
            if l.edge_flags[i] & EdgeFlags::REVERSED != 0 {
                (u, v) = (v, u);
            }
            assert_eq!((u, v), (l.vertices[i], l.vertices[(i + 1) % l.vertices.len()]));
            let (forward, backward) = counts[&(u.min(v), u.max(v))];
            let singular = l.edge_flags[i] & EdgeFlags::NON_MANIFOLD != 0;
            assert_eq!(forward + backward == 1, !singular);
            assert_eq!(forward + backward > 2, singular);
        }
    }
    let smallest: Vec<_> = found.iter().map(|l| *l.half_edges.iter().min().unwrap()).collect();
    assert!(smallest.is_sorted(), "loops in the order of their smallest half-edges");
    let mut closed = found.iter().zip(&smallest).filter(|(l, _)| !l.flags.any(LoopFlags::OPEN));
    assert!(closed.all(|(l, &h)| l.half_edges[0] == h), "closed loops start at the smallest half-edge");
    check_fast(soup);
    let free = counts.values().filter(|&&(f, b)| f + b == 1).count();
    let in_loops =
        found.iter().flat_map(|l| l.edge_flags.iter()).filter(|&&f| f & EdgeFlags::NON_MANIFOLD == 0).count();
    assert_eq!(in_loops, free, "free edges in loops");
}

#[test]
fn a_sheet_has_one_loop_with_the_surface_on_its_left() {
    let soup = sheet(3, 2);
    let found = boundary(&soup);
    check_invariants(&soup, &found);
    assert_eq!(loops(&found), [vec![0, 1, 2, 3, 7, 11, 10, 9, 8, 4]]);
    let rim = found.get(0).unwrap();
    assert_eq!((rim.flags, rim.length, rim.walk), (LoopFlags(0), 10.0, 0));
    // Counter-clockwise seen from above, so the sheet is on the left.
    let area: f64 = (0..10)
        .map(|i| {
            let (p, q) = (soup.points[rim.vertices[i] as usize], soup.points[rim.vertices[(i + 1) % 10] as usize]);
            0.5 * (p[0] * q[1] - q[0] * p[1])
        })
        .sum();
    assert_eq!(area, 6.0);
}

#[test]
fn a_closed_mesh_has_none() {
    let tetrahedron = Soup::flat(4, &[&[0, 1, 2], &[0, 3, 1], &[1, 3, 2], &[2, 3, 0]]);
    let found = boundary(&tetrahedron);
    assert!(found.is_empty() && found.defects().is_empty());
}

#[test]
fn two_triangles_sharing_a_vertex() {
    let soup = Soup::flat(5, &[&[0, 1, 2], &[0, 3, 4]]);
    let found = boundary(&soup);
    check_invariants(&soup, &found);
    assert_eq!(loops(&found), [[0, 1, 2], [0, 3, 4]]);
    assert!(found.iter().all(|l| l.flags.0 == LoopFlags::BOW_TIE));
    assert_eq!(found.defects(), [Defect::BowTie { vertex: 0 }]);
    assert_eq!(found.walk_count(), 2);
}

#[test]
fn two_holes_touching_at_a_vertex() {
    let mut soup = sheet(4, 4);
    // Take out the cells (1, 1) and (2, 2): they touch at vertex (2, 2) = 12.
    let faces: Vec<Vec<u32>> = soup.faces().map(<[u32]>::to_vec).collect();
    soup = Soup { points: soup.points, offsets: vec![0], corners: vec![] };
    for (f, face) in faces.iter().enumerate() {
        if f != 5 && f != 10 {
            soup.face(face);
        }
    }
    let found = boundary(&soup);
    check_invariants(&soup, &found);
    let mut sizes: Vec<_> = found.iter().map(|l| l.vertices.len()).collect();
    sizes.sort_unstable();
    assert_eq!(sizes, [4, 4, 16]);
    for hole in found.iter().filter(|l| l.vertices.len() == 4) {
        assert_eq!(hole.flags.0, LoopFlags::BOW_TIE | LoopFlags::SPLIT);
        assert!(hole.vertices.contains(&12));
    }
    assert_eq!(found.walk_count(), 2, "both holes are one walk through vertex 12");
}

#[test]
fn three_faces_on_an_edge() {
    let soup = Soup::flat(5, &[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4]]);
    let found = boundary(&soup);
    check_invariants(&soup, &found);
    assert_eq!(loops(&found), [[0, 1, 2], [1, 0, 3], [0, 1, 4]]);
    assert!(found.iter().all(|l| l.flags.any(LoopFlags::NON_MANIFOLD) && !l.flags.any(LoopFlags::OPEN)));
    assert_eq!(found.defects()[0], Defect::NonManifoldEdge { half_edge: 0, faces: 3 });

    let options = Options { non_manifold: NonManifold::Stop, ..Options::default() };
    let found = boundary_loops(&soup.view(), &options, &Job::default()).unwrap();
    check_invariants(&soup, &found);
    assert_eq!(loops(&found), [[1, 2, 0], [0, 3, 1], [1, 4, 0]]);
    assert!(found.iter().all(|l| l.flags.any(LoopFlags::NON_MANIFOLD) && l.flags.any(LoopFlags::OPEN)));
    assert!(found.iter().all(|l| l.length > 0.0 && l.edge_flags == [0, 0]));
}

#[test]
fn one_flipped_face() {
    let mut soup = sheet(3, 3);
    soup.corners[16..20].reverse(); // the middle face: no loop of its own
    let found = boundary(&soup);
    check_invariants(&soup, &found);
    assert_eq!(found.iter().map(|l| (l.vertices.len(), l.flags.0)).collect::<Vec<_>>(), [(12, 0)]);
    assert_eq!(found.defects().len(), 4);

    let mut soup = sheet(3, 3);
    soup.corners[0..4].reverse(); // a corner face: the loop runs two edges against it
    let found = boundary(&soup);
    check_invariants(&soup, &found);
    let rim = found.get(0).unwrap();
    assert_eq!((found.len(), rim.vertices.len(), rim.flags.0), (1, 12, LoopFlags::NOT_ORIENTED));
    assert_eq!(rim.edge_flags.iter().filter(|&&f| f == EdgeFlags::REVERSED).count(), 2);
    assert_eq!(found.defects().len(), 2);
}

#[test]
fn degenerate_faces_are_bridged_and_reported() {
    // A triangle of no width between two others: their common edge is interior.
    let soup = Soup::flat(4, &[&[0, 1, 2], &[1, 1, 2], &[2, 1, 3]]);
    let found = boundary(&soup);
    assert_eq!(loops(&found), [[0, 1, 3, 2]]);
    assert_eq!(found.defects(), [Defect::DegenerateFace { face: 1, vertex: 1 }]);
    // A quad with a repeated corner is a triangle.
    let soup = Soup::flat(3, &[&[0, 1, 1, 2]]);
    assert_eq!(loops(&boundary(&soup)), [[0, 1, 2]]);
    // A slit inside one face is not a border.
    let soup = Soup::flat(5, &[&[0, 1, 2, 3, 4, 3]]);
    assert_eq!(boundary(&soup).get(0).map(|l| l.vertices.len()), Some(4));
}

#[test]
fn a_moebius_strip_has_one_loop() {
    let n = 9;
    let mut soup = Soup::flat(2 * n, &[]);
    for i in 0..n as u32 {
        let (a, b) = (2 * i, 2 * i + 1);
        let (c, d) = if i + 1 < n as u32 { (a + 2, b + 2) } else { (1, 0) };
        soup.face(&[a, c, d, b]);
    }
    let found = boundary(&soup);
    check_invariants(&soup, &found);
    assert_eq!(found.len(), 1);
    let rim = found.get(0).unwrap();
    assert_eq!((rim.vertices.len(), rim.flags.0), (2 * n, LoopFlags::NOT_ORIENTED));
}

/// A sheet of 30,000 cells with everything wrong somewhere: cells missing, flipped, split, doubled,
/// of five corners, with a corner named twice, and vertices welded to others.
fn odd_sheet() -> Soup {
    let mut full = sheet(200, 150);
    let mut state = 1u64;
    let mut random = |n: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % n
    };
    let vertices = full.points.len();
    for _ in 0..30 {
        let (from, to) = (random(full.corners.len()), random(vertices) as u32);
        full.corners[from] = to;
    }
    let mut soup = Soup { points: full.points.clone(), offsets: vec![0], corners: Vec::new() };
    for face in full.faces() {
        let &[a, b, c, d] = face else { panic!("a sheet has quads") };
        match random(1000) {
            0..5 => {}
            5 => soup.face(&[d, c, b, a]),
            6 => {
                soup.face(face);
                soup.face(face);
            }
            7 => soup.face(&[a, b, b, c, d]),
            8 => soup.face(&[a, b, a]),
            9 => soup.face(&[a, b, random(vertices) as u32, c, d]),
            10..400 => {
                soup.face(&[a, b, c]);
                soup.face(&[a, c, d]);
            }
            _ => soup.face(face),
        }
    }
    soup
}

#[test]
fn the_same_for_any_thread_count() {
    let odd = odd_sheet();
    let kinds: HashSet<_> = boundary(&odd).defects().iter().map(std::mem::discriminant).collect();
    assert_eq!(kinds.len(), 4, "every kind of defect");
    for soup in [cap(400, 300, 0.3, 1.0), odd] {
        for survey in [Survey::WholeMesh, Survey::BoundaryOnly] {
            let all = |threads| {
                let options = Options { survey, ..Options::default() };
                let found = boundary_loops(&soup.view(), &options, &Job::new(threads, &Silent)).unwrap();
                let list: Vec<_> = found.iter().map(|l| format!("{l:?}")).collect();
                (list, found.defects().to_vec(), found.walk_count())
            };
            let one = all(1);
            assert!(!one.0.is_empty());
            for threads in [0, 2, 3, 64] {
                assert!(one == all(threads), "{threads} threads");
            }
        }
    }
}

#[test]
fn many_faces_at_a_vertex_and_on_an_edge() {
    // A book of 100 pages, and a fan of 100 triangles: each vertex in the middle has the smallest
    // number, or the largest.
    for (a, b, shift) in [(0, 1, 2), (100, 101, 0)] {
        let pages: Vec<[u32; 3]> =
            (0..100).map(|i| if i % 3 == 0 { [b, a, i + shift] } else { [a, b, i + shift] }).collect();
        let book = Soup::flat(102, &pages.iter().map(<[u32; 3]>::as_slice).collect::<Vec<_>>());
        let found = boundary(&book);
        check_invariants(&book, &found);
        assert_eq!(found.len(), 100);
        assert_eq!(found.defects()[0], Defect::NonManifoldEdge { half_edge: 0, faces: 100 });

        let blades: Vec<[u32; 3]> = (0..99).map(|i| [a, i + shift, i + 1 + shift]).collect();
        let mut fan = Soup::flat(102, &blades.iter().map(<[u32; 3]>::as_slice).collect::<Vec<_>>());
        let found = boundary(&fan);
        check_invariants(&fan, &found);
        assert_eq!((found.len(), found.edge_count(), found.defects().len()), (1, 101, 0));
        // Turn one blade: two conflicts.
        fan.corners[150..153].reverse();
        let found = boundary(&fan);
        check_invariants(&fan, &found);
        assert_eq!((found.edge_count(), found.defects().len()), (101, 2));
    }
}

proptest! {
    /// Any soup at all: few vertices and many faces give every defect there is.
    #[test]
    fn any_soup(faces in prop::collection::vec(prop::collection::vec(0u32..9, 3..6), 1..14), stop in any::<bool>()) {
        let faces: Vec<Vec<u32>> = faces
            .into_iter()
            .filter(|f| f.iter().collect::<HashSet<_>>().len() == f.len())
            .chain([vec![0, 1, 2]])
            .collect();
        let soup = Soup::flat(9, &faces.iter().map(Vec::as_slice).collect::<Vec<_>>());
        let non_manifold = if stop { NonManifold::Stop } else { NonManifold::Cut };
        let found = boundary_loops(&soup.view(), &Options { non_manifold, ..Options::default() }, &Job::default()).unwrap();
        check_invariants(&soup, &found);
        if !stop {
            prop_assert!(found.iter().all(|l| !l.flags.any(LoopFlags::OPEN)));
        }
    }

    /// Turning all faces over turns every loop round and changes nothing else.
    #[test]
    fn turning_the_faces_turns_the_loops(w in 1u32..6, h in 1u32..6) {
        let soup = sheet(w, h);
        let (one, two) = (boundary(&soup), boundary(&soup.turned()));
        let edges = |b: &Boundary, back: bool| -> HashSet<(u32, u32)> {
            b.iter()
                .flat_map(|l| (0..l.vertices.len()).map(|i| (l.vertices[i], l.vertices[(i + 1) % l.vertices.len()])).collect::<Vec<_>>())
                .map(|(u, v)| if back { (v, u) } else { (u, v) })
                .collect()
        };
        prop_assert_eq!(edges(&one, false), edges(&two, true));
    }

    /// A chessboard on a torus has only bow-ties, and indices in step: the sums at its vertices
    /// must not cancel for that.
    #[test]
    fn chessboards_on_tori(
        w in 2u32..12,
        h in 2u32..12,
        step in prop::sample::select(vec![1u32, 2, 3, 64]),
        filled in prop::collection::vec(any::<u16>(), 0..6),
    ) {
        let (w, h) = (2 * w, 2 * h);
        let at = |i: u32, j: u32| step * (j % h * w + i % w);
        let filled: HashSet<u32> = filled.iter().map(|&k| u32::from(k) % (w * h)).collect();
        let mut soup = Soup::flat((step * w * h) as usize, &[]);
        for (i, j) in (0..h).flat_map(|j| (0..w).map(move |i| (i, j))) {
            if (i + j) % 2 == 0 || filled.contains(&(j * w + i)) {
                soup.face(&[at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
            }
        }
        let found = boundary(&soup);
        check_invariants(&soup, &found);
        let black = (w * h / 2) as usize;
        prop_assert!(found.edge_count() <= 4 * black && found.edge_count() + 4 * filled.len() >= 4 * black);
    }

    /// Sheets with faces taken out, whose boundaries are ordinary for the most part.
    #[test]
    fn any_sheet_with_holes(w in 2u32..12, h in 2u32..12, removed in prop::collection::vec(any::<u16>(), 0..20)) {
        let full = sheet(w, h);
        let mut soup = Soup { points: full.points.clone(), offsets: vec![0], corners: Vec::new() };
        // The first face stays: a mesh has one.
        let gone: HashSet<usize> = removed.iter().map(|&k| k as usize % (w * h) as usize).filter(|&f| f > 0).collect();
        for (_, face) in full.faces().enumerate().filter(|(f, _)| !gone.contains(f)) {
            soup.face(face);
        }
        check_invariants(&soup, &boundary(&soup));
    }
}
