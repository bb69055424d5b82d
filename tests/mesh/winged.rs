//! Winged-edge tables: Baumgart's rules for every record, and algorithm 1 on them against the loops
//! of the fast path.

use crate::common::{Soup, cap, edge_counts, sheet};
use gusset::boundary::{Options, boundary_loops};
use gusset::mesh::NONE;
use gusset::winged::{EdgeMarks, Winding, WingedEdge, WingedEdges, WingedFaces, faces, free_loops};
use gusset::{Error, Job, Result};
use proptest::prelude::*;

fn tables(soup: &Soup, winding: Winding) -> WingedEdges {
    WingedEdges::new(&soup.view(), winding, &Job::default()).unwrap()
}

/// The vertices of a face, walked through the tables: forwards over b and e, or backwards over d
/// and c.
fn cycle(tables: &WingedEdges, face: u32, forwards: bool) -> Vec<u32> {
    let first = tables.edge_of_face()[face as usize];
    let mut at = first;
    let mut right = tables.edges()[at as usize].right == face;
    let mut vertices = Vec::new();
    loop {
        let edge = &tables.edges()[at as usize];
        assert_eq!(if right { edge.right } else { edge.left }, face);
        // As R the face runs M to N, as L from N to M.
        let (from, to) = if right { (edge.m, edge.n) } else { (edge.n, edge.m) };
        vertices.push(from);
        assert!(vertices.len() < 1000, "the cycle does not close");
        let next = match (forwards, right) {
            (true, true) => edge.b,
            (true, false) => edge.e,
            (false, true) => edge.d,
            (false, false) => edge.c,
        };
        let joint = if forwards { to } else { from };
        let edge = &tables.edges()[next as usize];
        // For a face on both sides of an edge: the side that continues from here.
        let as_right = edge.right == face && joint == if forwards { edge.m } else { edge.n };
        let as_left = edge.left == face && joint == if forwards { edge.n } else { edge.m };
        assert!(as_right || as_left, "face {face}: edge {next} does not go on from vertex {joint}");
        (at, right) = (next, as_right);
        if at == first {
            return vertices;
        }
    }
}

fn check_invariants(soup: &Soup, winding: Winding) -> WingedEdges {
    let tables = tables(soup, winding);
    let mut sides = vec![0; soup.offsets.len() - 1];
    for (i, edge) in tables.edges().iter().enumerate() {
        let WingedEdge { m, n, b, c, d, e, left, right, marks } = *edge;
        assert!(left != NONE || right != NONE, "edge {i} has no face");
        assert_eq!([b == NONE, d == NONE], [right == NONE; 2]);
        assert_eq!([c == NONE, e == NONE], [left == NONE; 2]);
        assert!(marks == 0 || left == NONE || right == NONE, "marked records have one face");
        [left, right].iter().filter(|&&f| f != NONE).for_each(|&f| sides[f as usize] += 1);
        assert!([m, n].iter().all(|&v| tables.edge_of_vertex()[v as usize] <= i as u32));
    }
    for (f, face) in soup.faces().enumerate() {
        assert_eq!(sides[f], face.len(), "each side of face {f} once");
        let mut expected = face.to_vec();
        if winding == Winding::CounterClockwise {
            expected.reverse();
        }
        let simple = face.iter().all(|v| face.iter().filter(|u| *u == v).count() == 1);
        if simple {
            let mut forwards = cycle(&tables, f as u32, true);
            let mut backwards = cycle(&tables, f as u32, false);
            let first = |list: &[u32]| list.iter().position(|&v| v == expected[0]).unwrap();
            let shift = first(&forwards);
            forwards.rotate_left(shift);
            assert_eq!(forwards, expected, "face {f}");
            backwards.reverse();
            let shift = first(&backwards);
            backwards.rotate_left(shift);
            assert_eq!(backwards, expected, "face {f}");
        }
    }
    for (h, &edge) in tables.edge_of_half_edge().iter().enumerate() {
        let edge = &tables.edges()[edge as usize];
        assert!([edge.m, edge.n].contains(&soup.corners[h]));
    }
    // And back: corner for corner, and without the first edges as the same cycles.
    let back = read(tables.edges(), soup.points.len(), Some(tables.edge_of_face()), winding).unwrap();
    assert_eq!(back.offsets, soup.offsets);
    assert_eq!(back.corners, soup.corners);
    assert_eq!(back.edges, tables.edge_of_half_edge());
    let turned = read(tables.edges(), soup.points.len(), None, winding).unwrap();
    assert_eq!(turned.offsets, soup.offsets);
    for face in 0..soup.offsets.len() - 1 {
        let range = soup.offsets[face] as usize..soup.offsets[face + 1] as usize;
        let doubled = soup.corners[range.clone()].repeat(2);
        assert!(doubled.windows(range.len()).any(|w| w == &turned.corners[range.clone()]), "face {face}");
    }
    tables
}

fn read(edges: &[WingedEdge], vertices: usize, first: Option<&[u32]>, winding: Winding) -> Result<WingedFaces> {
    faces(edges, vertices, first, winding, &Job::default())
}

/// Both ways to the loops give the same ones.
fn check_loops(soup: &Soup, tables: &WingedEdges) {
    let fast = boundary_loops(&soup.view(), &Options::default(), &Job::default()).unwrap();
    let slow = free_loops(tables, &Job::default()).unwrap();
    let by_tables: Vec<_> = slow.iter().map(|(vertices, _)| vertices.to_vec()).collect();
    let by_fans: Vec<_> = fast.iter().map(|l| l.vertices.to_vec()).collect();
    assert_eq!(by_tables, by_fans);
    for ((_, edges), found) in slow.iter().zip(fast.iter()) {
        let of_half_edges: Vec<_> = found.half_edges.iter().map(|&h| tables.edge_of_half_edge()[h as usize]).collect();
        assert_eq!(edges, of_half_edges);
    }
}

#[test]
fn a_quad_by_hand() {
    // One quad, counter-clockwise 0 1 2 3: edge 0 runs from 0 to 1 with the face on its left.
    let quad = Soup::flat(4, &[&[0, 1, 2, 3]]);
    let none = NONE;
    let edge = |m, n, c, e| WingedEdge { m, n, b: none, c, d: none, e, left: 0, right: none, marks: 0 };
    // L runs N to M: in the clockwise cycle 1 0 3 2, edge 1 comes before edge 0, and edge 3 after.
    let expected = [edge(0, 1, 1, 3), edge(1, 2, 2, 0), edge(2, 3, 3, 1), edge(3, 0, 0, 2)];
    assert_eq!(tables(&quad, Winding::CounterClockwise).edges(), expected);
    // The same stored clockwise: the face is R, d before and b after.
    let edge = |m, n, d, b| WingedEdge { m, n, b, c: none, d, e: none, left: none, right: 0, marks: 0 };
    let expected = [edge(0, 1, 3, 1), edge(1, 2, 0, 2), edge(2, 3, 1, 3), edge(3, 0, 2, 0)];
    assert_eq!(tables(&quad, Winding::Clockwise).edges(), expected);
}

#[test]
fn shapes_and_odd_cases() {
    let cases = [
        sheet(4, 3),
        cap(7, 3, 0.2, 1.0),
        cap(7, 3, 0.2, 1.0).and(&sheet(2, 2)),
        // Two triangles that share a vertex; two holes that touch; three faces on an edge;
        // zero-length corners.
        Soup::flat(5, &[&[0, 1, 2], &[2, 3, 4]]),
        Soup::flat(7, &[&[0, 1, 2], &[2, 3, 4], &[4, 5, 2], &[2, 6, 0]]),
        Soup::flat(5, &[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4]]),
        Soup::flat(5, &[&[0, 1, 1, 2], &[2, 1, 3], &[3, 4, 3], &[3, 4, 2]]),
    ];
    for soup in &cases {
        for winding in [Winding::CounterClockwise, Winding::Clockwise] {
            let tables = check_invariants(soup, winding);
            let edges = edge_counts(soup.faces());
            if tables.edges().iter().all(|e| e.marks == 0) {
                assert_eq!(tables.edges().len(), edges.len());
            }
        }
        check_loops(soup, &tables(soup, Winding::CounterClockwise));
    }
    let three = tables(&cases[5], Winding::CounterClockwise);
    assert_eq!(three.edges().iter().filter(|e| e.marks == EdgeMarks::NON_MANIFOLD).count(), 3);
}

#[test]
fn a_flipped_face_makes_marked_records() {
    let mut soup = sheet(3, 3);
    soup.corners[16..20].reverse();
    let tables = check_invariants(&soup, Winding::CounterClockwise);
    assert_eq!(tables.edges().iter().filter(|e| e.marks == EdgeMarks::NOT_ORIENTED).count(), 8);
}

#[test]
fn stored_clockwise_is_the_turned_mesh() {
    let soup = cap(9, 4, 0.3, 1.0);
    let free = |tables: &WingedEdges| free_loops(tables, &Job::default()).unwrap().vertices.len();
    let (a, b) = (tables(&soup, Winding::CounterClockwise), tables(&soup.turned(), Winding::Clockwise));
    assert_eq!((a.edges().len(), free(&a)), (b.edges().len(), free(&b)));
    // The same faces clockwise from outside: the same face on the right of the same directed edge.
    let right = |tables: &WingedEdges| {
        let mut list: Vec<_> = tables.edges().iter().flat_map(|e| [(e.m, e.n, e.right), (e.n, e.m, e.left)]).collect();
        list.sort_unstable();
        list
    };
    assert_eq!(right(&a), right(&b));
}

#[test]
fn faces_of_a_table_by_hand() {
    // A tetrahedron, clockwise faces 0 1 2, 0 3 1, 1 3 2, 2 3 0, as Baumgart writes it down.
    let edge = |m, n, left, right, [b, c, d, e]: [u32; 4]| WingedEdge { m, n, b, c, d, e, left, right, marks: 0 };
    let table = [
        edge(0, 1, 1, 0, [1, 4, 2, 3]),
        edge(1, 2, 2, 0, [2, 5, 0, 4]),
        edge(2, 0, 3, 0, [0, 3, 1, 5]),
        edge(0, 3, 3, 1, [4, 5, 0, 2]),
        edge(1, 3, 1, 2, [5, 3, 1, 0]),
        edge(2, 3, 2, 3, [3, 4, 2, 1]),
    ];
    let made = read(&table, 4, None, Winding::Clockwise).unwrap();
    assert_eq!(made.offsets, [0, 3, 6, 9, 12]);
    // Face 1 runs edge 0 backwards: from its end 1 to 0.
    assert_eq!(made.corners, [0, 1, 2, 1, 0, 3, 2, 1, 3, 0, 2, 3]);
    let other = read(&table, 4, None, Winding::CounterClockwise).unwrap();
    assert_eq!(other.corners[..3], [1, 0, 2]);
    assert_eq!(read(&[], 0, None, Winding::Clockwise).unwrap().offsets, [0]);

    let refused = |change: &dyn Fn(&mut [WingedEdge; 6])| {
        let mut wrong = table;
        change(&mut wrong);
        read(&wrong, 4, None, Winding::Clockwise).unwrap_err()
    };
    let wings = |edge| move |error: Error| matches!(error, Error::BadWings { edge: e, .. } if e == edge);
    assert!(wings(3)(refused(&|t| t[3].n = 4)));
    assert!(wings(2)(refused(&|t| t[2].b = 6)));
    assert!(wings(1)(refused(&|t| (t[1].left, t[1].right) = (NONE, NONE))));
    assert!(wings(5)(refused(&|t| t[5].left = NONE)));
    assert!(wings(4)(refused(&|t| t[4].right = 6)));
    // A wing of another face; a record that runs the other way than its sides say.
    assert!(wings(0)(refused(&|t| t[0].b = 4)));
    assert!(matches!(refused(&|t| t[5] = WingedEdge { m: 3, n: 2, ..t[5] }), Error::BadWings { .. }));
    // A number without sides, and a face of two.
    let gap =
        refused(&|t| t.iter_mut().flat_map(|e| [&mut e.left, &mut e.right]).for_each(|f| *f += u32::from(*f == 3)));
    assert_eq!(gap, Error::FaceTooSmall { face: 3, corners: 0 });
    let first = |given: &[u32]| read(&table, 4, Some(given), Winding::Clockwise).map(|made| made.corners);
    assert_eq!(first(&[1, 4, 5, 5]).unwrap()[..6], [1, 2, 0, 3, 1, 0]);
    assert!(matches!(first(&[0, 0, 1]), Err(Error::OptionOutOfRange { value: 3.0, .. })));
    assert!(matches!(first(&[0, 0, 0, 2]), Err(Error::BadWings { edge: 0, .. })));
    assert!(matches!(first(&[0, 0, 1, 6]), Err(Error::BadWings { edge: 6, .. })));
}

#[test]
fn two_cycles_of_one_face_are_refused() {
    // Two triangles whose records name the same face.
    let soup = Soup::flat(6, &[&[0, 1, 2], &[3, 4, 5]]);
    let mut edges = tables(&soup, Winding::CounterClockwise).edges().to_vec();
    edges.iter_mut().for_each(|e| e.left = 0);
    let refused = read(&edges, 6, None, Winding::CounterClockwise);
    assert!(matches!(refused, Err(Error::BadWings { .. })), "{refused:?}");
}

proptest! {
    /// One number of a good table changed: refused, or still faces of which each wing is true.
    #[test]
    fn damage_is_seen(record in 0usize..17, field in 0usize..8, to in prop::sample::select(vec![0, 1, 3, 7, 11, 16, 40, NONE])) {
        let soup = sheet(3, 2);
        let mut edges = tables(&soup, Winding::CounterClockwise).edges().to_vec();
        let e = &mut edges[record];
        let fields = [&mut e.m, &mut e.n, &mut e.b, &mut e.c, &mut e.d, &mut e.e, &mut e.left, &mut e.right];
        let before = std::mem::replace(fields.into_iter().nth(field).unwrap(), to);
        let made = read(&edges, soup.points.len(), None, Winding::CounterClockwise);
        prop_assert_eq!(made.is_ok(), to == before, "{:?}", made);
    }

    #[test]
    fn any_soup_of_faces(faces in prop::collection::vec(prop::collection::vec(0u32..9, 3..6), 1..25)) {
        let list: Vec<&[u32]> = faces.iter().map(Vec::as_slice).collect();
        let soup = Soup::flat(9, &list);
        for winding in [Winding::CounterClockwise, Winding::Clockwise] {
            let tables = check_invariants(&soup, winding);
            if tables.edges().iter().all(|e| e.marks & EdgeMarks::NOT_ORIENTED == 0)
                && winding == Winding::CounterClockwise
            {
                check_loops(&soup, &tables);
            }
        }
    }
}
