//! Gluing: classes, reduced cells, and the forms that topologies are kept in.

use gusset::net::topology::{Links, Matrix, Run};
use gusset::net::{Classes, Seam, Shape, Sides, Topology};

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
        let links = (0..2 * shape.node_count() as u32).filter(|&link| contracted(link)).map(|link| shape.ends(link));
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
            let topology = Topology::of_sides(shape, sides);
            let classes = Classes::of(&topology).unwrap();
            let expected = classes_by_force(shape, |link| sides.contracts(shape, link), &[]);
            assert_eq!(classes.table().unwrap(), expected, "{h} x {w}, {sides:?}");
            let mut members: Vec<u32> = Vec::new();
            for class in classes.groups().unwrap().iter() {
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
        let matrix = Matrix::of_sides(shape, sides).unwrap();
        let bytes = matrix.to_bytes(shape).unwrap();
        assert_eq!(Matrix::from_bytes(shape, &bytes).unwrap(), matrix);
        let topology = Topology::new(shape, Links::Matrix(matrix), &[]).unwrap();
        assert_eq!(topology.sides(), Some(sides), "a matrix that sides describe is kept as sides");
    }
    // A seam from the last column to the first is what closed rows say.
    let seam = Seam { a: Run::along_column(3, 5, -1), b: Run::along_column(3, 0, -1), count: 4 };
    let tube = Topology::new(shape, Links::Sides(Sides::SHEET), &[seam]).unwrap();
    assert_eq!(tube, Topology::of_sides(shape, Sides::TUBE));
    // Turned round, it is a Möbius strip, and all four ways to write it are one.
    let ways = [
        (Run::along_column(0, 5, 1), Run::along_column(3, 0, -1)),
        (Run::along_column(3, 0, -1), Run::along_column(0, 5, 1)),
        (Run::along_column(3, 5, -1), Run::along_column(0, 0, 1)),
        (Run::along_column(0, 0, 1), Run::along_column(3, 5, -1)),
    ];
    let strips =
        ways.map(|(a, b)| Topology::new(shape, Links::Sides(Sides::SHEET), &[Seam { a, b, count: 4 }]).unwrap());
    assert!(strips.iter().all(|strip| *strip == strips[0] && strip.seams().len() == 1));
}

#[test]
fn ones_of_the_paper_s_closures() {
    // The study's counts: two poles H + 2W - 2, torus H + W.
    let shape = Shape::new(9, 13).unwrap();
    let ones = |sides| Matrix::of_sides(shape, sides).unwrap().links().count();
    assert_eq!(ones(Sides::TWO_POLES), 33);
    assert_eq!(ones(Sides::TORUS), 22);
    assert_eq!(ones(Sides::ONE_POLE), 2 * 12 + 2 * 8);
}
