//! Gluing: classes, reduced cells, and the forms that topologies are kept in.

use crate::nets::any_topology;
use gusset::net::topology::{ContractedLinks, Gluing, LinkMatrix, SeamRun};
use gusset::net::{NodeClasses, Seam, Shape, Sides, Topology, closure};
use proptest::prelude::*;

/// All 64 combinations of sides.
fn all_sides() -> impl Iterator<Item = Sides> {
    (0..64u32).map(|bits| {
        let on = |k: u32| bits >> k & 1 == 1;
        Sides {
            rows_closed: on(0),
            columns_closed: on(1),
            pole_top: on(2),
            pole_bottom: on(3),
            pole_left: on(4),
            pole_right: on(5),
        }
    })
}

/// Classes by repeated relaxation over all contracted links: slow, and independent of ours.
fn classes_by_force(shape: Shape, contracted: impl Fn(u32) -> bool, pairs: &[[u32; 2]]) -> Vec<u32> {
    let mut class: Vec<u32> = (0..shape.node_count() as u32).collect();
    loop {
        let mut changed = false;
        let links =
            (0..2 * shape.node_count() as u32).filter(|&link| contracted(link)).map(|link| shape.ends_of_link(link));
        for [a, b] in links.chain(pairs.iter().copied()) {
            let least = class[a as usize].min(class[b as usize]);
            changed |= class[a as usize] != least || class[b as usize] != least;
            (class[a as usize], class[b as usize]) = (least, least);
        }
        if !changed {
            return class;
        }
    }
}

#[test]
fn classes_of_sides_are_those_of_their_matrix() {
    for (h, w) in [(2, 2), (2, 3), (3, 2), (3, 3), (4, 5), (5, 2), (6, 7)] {
        let shape = Shape::new(h, w).unwrap();
        for sides in all_sides() {
            let topology = Topology::from_sides(shape, sides);
            let classes = NodeClasses::new(&topology).unwrap();
            let expected = classes_by_force(shape, |link| sides.is_contracted(shape, link), &[]);
            assert_eq!(classes.representatives().unwrap(), expected, "{h} x {w}, {sides:?}");
            let mut members: Vec<u32> = Vec::new();
            for class in classes.glued_classes().unwrap().iter() {
                assert!(class.len() > 1 && class.iter().all(|&n| expected[n as usize] == class[0]));
                members.extend(class);
            }
            let glued = (0..expected.len() as u32)
                .filter(|&n| expected.iter().filter(|&&other| other == expected[n as usize]).count() > 1);
            members.sort_unstable();
            assert_eq!(members, glued.collect::<Vec<_>>());
        }
    }
}

#[test]
fn one_form_for_one_gluing() {
    let shape = Shape::new(4, 6).unwrap();
    for sides in all_sides() {
        let matrix = LinkMatrix::from_sides(shape, sides).unwrap();
        let bytes = matrix.to_bytes(shape).unwrap();
        assert_eq!(LinkMatrix::from_bytes(shape, &bytes).unwrap(), matrix);
        let topology = Topology::new(shape, ContractedLinks::Matrix(matrix), &[]).unwrap();
        assert_eq!(topology.sides(), Some(sides), "a matrix that sides describe is kept as sides");
    }
    // A seam from the last column to the first is what closed rows say.
    let seam = Seam { a: SeamRun::along_column(3, 5, -1), b: SeamRun::along_column(3, 0, -1), count: 4 };
    let tube = Topology::new(shape, ContractedLinks::Sides(Sides::SHEET), &[seam]).unwrap();
    assert_eq!(tube, Topology::from_sides(shape, Sides::TUBE));
    // Turned round, it is a Möbius strip, and all four ways to write it are one.
    let ways = [
        (SeamRun::along_column(0, 5, 1), SeamRun::along_column(3, 0, -1)),
        (SeamRun::along_column(3, 0, -1), SeamRun::along_column(0, 5, 1)),
        (SeamRun::along_column(3, 5, -1), SeamRun::along_column(0, 0, 1)),
        (SeamRun::along_column(0, 0, 1), SeamRun::along_column(3, 5, -1)),
    ];
    let strips = ways
        .map(|(a, b)| Topology::new(shape, ContractedLinks::Sides(Sides::SHEET), &[Seam { a, b, count: 4 }]).unwrap());
    assert!(strips.iter().all(|strip| *strip == strips[0] && strip.seams().len() == 1));
}

#[test]
fn ones_of_the_paper_s_closures() {
    // The study's counts: two poles H + 2W - 2, torus H + W.
    let shape = Shape::new(9, 13).unwrap();
    let ones = |sides| LinkMatrix::from_sides(shape, sides).unwrap().links().count();
    assert_eq!(ones(Sides::TWO_POLES), 33);
    assert_eq!(ones(Sides::TORUS), 22);
    assert_eq!(ones(Sides::ONE_POLE), 2 * 12 + 2 * 8);
}

proptest! {
    /// The same classes, told node by node.
    #[test]
    fn saturated_is_one_for_equal_classes(topology in any_topology(2..7, 2..7)) {
        let shape = topology.shape();
        let table = NodeClasses::new(&topology).unwrap().representatives().unwrap();
        let node = |node: u32| {
            let (i, j) = shape.row_and_column(node);
            SeamRun::along_row(i as u32, j as u32, 0)
        };
        let mut seams: Vec<Seam> = (0..).zip(&table).map(|(k, &class)| Seam { a: node(k), b: node(class), count: 1 }).collect();
        let one_by_one = Topology::new(shape, ContractedLinks::Sides(Sides::SHEET), &seams).unwrap();
        // In chains: each node of a class with the one before it.
        for k in 0..table.len() {
            if let Some(before) = (0..k).rev().find(|&before| table[before] == table[k]) {
                seams[k].b = node(before as u32);
            }
        }
        let chains = Topology::new(shape, ContractedLinks::Sides(Sides::SHEET), &seams).unwrap();
        let saturated = topology.canonical_form().unwrap();
        prop_assert_eq!(&NodeClasses::new(&saturated).unwrap().representatives().unwrap(), &table);
        prop_assert_eq!(&saturated.canonical_form().unwrap(), &saturated);
        for other in [one_by_one, chains] {
            prop_assert_eq!(&other.canonical_form().unwrap().with_reversed(saturated.is_reversed()), &saturated);
        }
    }
}

#[test]
fn seams_in_one_form() {
    let shape = Shape::new(4, 9).unwrap();
    let of = |seams: &[Seam]| Topology::new(shape, ContractedLinks::Sides(Sides::SHEET), seams).unwrap();
    let seam = |from: u32, count: u32| Seam {
        a: SeamRun::along_row(0, from, 1),
        b: SeamRun::along_row(3, 8 - from, -1),
        count,
    };
    // One of four pairs and two of two.
    let (whole, halves) = (of(&[seam(0, 4)]), of(&[seam(0, 2), seam(2, 2)]));
    assert_ne!(whole, halves);
    assert_eq!(whole.canonical_form().unwrap(), halves.canonical_form().unwrap());
    assert_eq!(whole.canonical_form().unwrap(), whole);
    // p with q and q with r; p with r and r with q.
    let at = |row: u32, column: u32| SeamRun::along_row(row, column, 0);
    let pair = |a: SeamRun, b: SeamRun| Seam { a, b, count: 1 };
    let [p, q, r] = [at(0, 0), at(2, 4), at(3, 8)];
    let [one, other] = [[pair(p, q), pair(q, r)], [pair(p, r), pair(r, q)]].map(|seams| of(&seams));
    assert_eq!(one.canonical_form().unwrap(), other.canonical_form().unwrap());
    // Repetitions of one pair are not a seam; a run that meets one node is a seam.
    for count in [2, 7, u32::MAX] {
        let repeated = [pair(p, q), Seam { a: p, b: r, count }];
        let refused = Topology::new(shape, ContractedLinks::Sides(Sides::SHEET), &repeated);
        assert_eq!(refused, Err(gusset::Error::BadSeam { seam: 1 }));
        assert_eq!(whole.glued(&repeated.map(Gluing::Seam)), Err(gusset::Error::BadSeam { seam: 1 }));
    }
    assert_eq!(of(&[Seam { a: SeamRun::along_row(0, 0, 1), b: r, count: 9 }]).seams()[0].count, 9);
    // Closures that turn a side round are one seam still.
    for turned in [closure::moebius(shape).unwrap(), closure::klein(shape).unwrap()] {
        assert_eq!(turned.canonical_form().unwrap().seams().len(), 1);
    }
}
