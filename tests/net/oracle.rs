//! All 2^18 characteristic matrices of a net of 3 x 3 nodes, and the 18 local gluings, against
//! definitions.

use crate::complexes::Oracle;
use gusset::net::complex::Complex;
use gusset::net::topology::{
    CellDiagonal, ContractedLinks, Gluing, GluingType, LinkMatrix, ReducedCell, classify_cell, classify_node,
    gluing_histogram,
};
use gusset::net::{NodeClasses, Shape, Sides, Topology};
use gusset::{Error, Job};
use std::collections::BTreeSet;

/// The study's table: type, mask of the star, mask of the cell.
const STARS: [(usize, usize); 15] = [
    (0, 1),
    (0, 4),
    (1, 2),
    (1, 8),
    (2, 3),
    (3, 6),
    (4, 12),
    (5, 9),
    (6, 5),
    (7, 10),
    (8, 7),
    (9, 14),
    (10, 13),
    (11, 11),
    (12, 15),
];

fn star(mask: usize) -> Option<usize> {
    STARS.iter().find(|&&(_, m)| m == mask).map(|&(kind, _)| kind)
}

/// The type of a cell, by the classes of its corners.
fn cell([a, b, c, d]: [usize; 4]) -> Option<usize> {
    let (top, right, bottom, left) = (a == b, b == c, c == d, d == a);
    match [top, right, bottom, left].into_iter().filter(|&on| on).count() {
        0 if a == c => Some(16),
        0 if b == d => Some(17),
        0 => None,
        1 if top || bottom => Some(0),
        1 => Some(1),
        2 if top && bottom => Some(13),
        2 if left && right => Some(14),
        // The node between the two: d, a, b, c have their links to the east and south, ... in the
        // cell.
        2 if top && left => Some(2),
        2 if top && right => Some(3),
        2 if right && bottom => Some(4),
        2 => Some(5),
        _ => Some(15),
    }
}

#[test]
fn every_matrix_of_a_small_net() {
    let shape = Shape::new(3, 3).unwrap();
    let chunks: Vec<_> = (0..4u32).map(|part| std::thread::spawn(move || check_matrices(shape, part))).collect();
    let mut seen = BTreeSet::new();
    let mut crossings = 0;
    for chunk in chunks {
        let (types, refused) = chunk.join().unwrap();
        seen.extend(types);
        crossings += refused;
    }
    assert_eq!(seen, (0..18).collect(), "all types occur");
    assert!(crossings > 0, "some cross");
}

/// A quarter of the matrices: the types seen, and how many were refused.
fn check_matrices(shape: Shape, part: u32) -> (BTreeSet<usize>, u64) {
    let (mut seen, mut refused) = (BTreeSet::new(), 0);
    for bits in part << 16..(part + 1) << 16 {
        let mut matrix = LinkMatrix::empty(shape).unwrap();
        (0..18).for_each(|link| matrix.set_contracted(link, bits >> link & 1 == 1));
        let pairs: Vec<_> = (matrix.links()).map(|link| shape.ends_of_link(link).map(|node| node as usize)).collect();
        let oracle = Oracle::new(shape, &pairs, |_, _| true);
        let topology = Topology::new(shape, ContractedLinks::Matrix(matrix), &[]);
        if let Some(cell) = oracle.crossing {
            assert_eq!(topology, Err(Error::CrossingCell { cell: cell as u32 }));
            refused += 1;
            continue;
        }
        let topology = topology.unwrap();
        let complex = Complex::from_topology(&topology, &Job::default()).unwrap();
        oracle.check(&complex);
        check_types(&topology, &oracle.class, &mut seen);
        if bits % 16 == 5 {
            let saturated = topology.canonical_form().unwrap();
            let all = (0..18).all(|link| {
                let [a, b] = shape.ends_of_link(link).map(|node| oracle.class[node as usize]);
                saturated.is_contracted(link) == (a == b)
            });
            assert!(all && saturated.canonical_form().unwrap() == saturated);
            assert_eq!(Complex::from_topology(&saturated, &Job::default()).unwrap(), complex);
        }
    }
    (seen, refused)
}

fn check_types(topology: &Topology, class: &[usize], seen: &mut BTreeSet<usize>) {
    let classes = NodeClasses::new(topology).unwrap();
    let mut count = [[0u64; 18]; 2];
    for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
        for cyclic in [false, true] {
            let here = class[3 * i + j];
            let around = [(j < 2, i, j + 1), (i < 2, i + 1, j), (j > 0, i, j + 2), (i > 0, i + 2, j)];
            let mask = (0..4).filter(|&k| {
                let (inside, i, j) = around[k];
                (inside || cyclic) && class[i % 3 * 3 + j % 3] == here
            });
            let expected = star(mask.map(|k| 1 << k).sum());
            let found = classify_node(&classes, i, j, cyclic).map(GluingType::number);
            assert_eq!(found, expected);
            if let (Some(kind), false) = (found, cyclic) {
                count[0][kind] += 1;
                seen.insert(kind);
            }
        }
        if i < 2 && j < 2 {
            let a = 3 * i + j;
            let found = classify_cell(&classes, i, j).map(GluingType::number);
            assert_eq!(found, cell([a, a + 1, a + 4, a + 3].map(|node| class[node])));
            if let Some(kind) = found {
                count[1][kind] += 1;
                seen.insert(kind);
            }
        }
    }
    let histogram = gluing_histogram(topology, &Job::default()).unwrap();
    assert_eq!([histogram.nodes, histogram.cells], count);
}

/// A partition of some nodes as the set of its classes of two and more, moved to where it is first.
type Partition = BTreeSet<BTreeSet<(i32, i32)>>;

fn normal(classes: impl IntoIterator<Item = BTreeSet<(i32, i32)>>) -> Partition {
    let classes: Partition = classes.into_iter().filter(|class| class.len() > 1).collect();
    let nodes = || classes.iter().flatten();
    let least = (nodes().map(|n| n.0).min().unwrap_or(0), nodes().map(|n| n.1).min().unwrap_or(0));
    classes.iter().map(|class| class.iter().map(|&(i, j)| (i - least.0, j - least.1)).collect()).collect()
}

/// Section 2.4 of the theory: 13 partitions from stars, 11 from cells, 6 in both, 8 orbits under
/// the symmetries of the square.
#[test]
fn there_are_eighteen() {
    let around = [(0, 1), (1, 0), (0, -1), (-1, 0)];
    let stars: BTreeSet<Partition> = (1..16)
        .map(|mask| {
            let glued = (0..4).filter(|k| mask >> k & 1 == 1).map(|k| around[k]);
            normal([glued.chain([(0, 0)]).collect()])
        })
        .collect();
    assert_eq!(stars.len(), 13);
    // All partitions of four corners, as the smallest corner that each is one with: 15, of which
    // one crosses.
    let corners = [(0, 0), (0, 1), (1, 1), (1, 0)];
    let mut all = 0;
    let mut crossing = 0;
    let mut cells: BTreeSet<Partition> = BTreeSet::new();
    for code in 0..256usize {
        let first = [0, 1, 2, 3].map(|k| code >> (2 * k) & 3);
        if !(0..4).all(|k| first[k] <= k && first[first[k]] == first[k]) {
            continue;
        }
        all += 1;
        if first == [0, 1, 0, 1] {
            crossing += 1;
            assert!(matches!(ReducedCell::new([0, 1, 0, 1]), ReducedCell::Crossing(_)));
            continue;
        }
        let partition = normal((0..4).map(|k| (0..4).filter(|&n| first[n] == k).map(|n| corners[n]).collect()));
        if !partition.is_empty() {
            cells.insert(partition);
        }
    }
    assert_eq!((all, crossing, cells.len()), (15, 1, 11));
    assert_eq!(stars.intersection(&cells).count(), 6);
    let types: BTreeSet<Partition> = stars.union(&cells).cloned().collect();
    assert_eq!(types.len(), GluingType::TYPE_COUNT);
    // Each of them, under the eight symmetries.
    let mut orbits: BTreeSet<BTreeSet<Partition>> = BTreeSet::new();
    for partition in &types {
        let image = |k: usize| {
            normal(partition.iter().map(|class| {
                let turn = |&(i, j): &(i32, i32)| {
                    let (i, j) = if k >= 4 { (j, i) } else { (i, j) };
                    [(i, j), (j, -i), (-i, -j), (-j, i)][k % 4]
                };
                class.iter().map(turn).collect()
            }))
        };
        let orbit: BTreeSet<_> = (0..8).map(image).collect();
        assert!(orbit.is_subset(&types));
        orbits.insert(orbit);
    }
    let mut sizes: Vec<_> = orbits.iter().map(BTreeSet::len).collect();
    sizes.sort_unstable();
    assert_eq!(sizes, [1, 1, 2, 2, 2, 2, 4, 4], "the sub-figures of the paper's Fig. 4");
}

/// Each type, glued in the middle of a net, is found again, with the orders and the degenerate
/// cells of the study's table.
#[test]
fn each_type_is_what_its_caption_says() {
    let shape = Shape::new(5, 5).unwrap();
    let sheet = Topology::from_sides(shape, Sides::SHEET);
    // Order of the node, classes, edges lost to others, and cells that become triangle, digon,
    // point, fold.
    let caption = |kind: usize| match kind {
        0 | 1 => (2, 1, [2, 0, 0, 0]),
        2..=5 => (3, 1, [2, 1, 0, 0]),
        6 | 7 => (3, 1, [4, 0, 0, 0]),
        8..=11 => (4, 1, [2, 2, 0, 0]),
        12 => (5, 1, [0, 4, 0, 0]),
        13 | 14 => (2, 2, [2, 1, 0, 0]),
        15 => (4, 1, [4, 0, 1, 0]),
        _ => (2, 1, [0, 0, 0, 1]),
    };
    for kind in (0..GluingType::TYPE_COUNT as u32).filter_map(GluingType::from_number) {
        let number = kind.number();
        let at = if number < 13 { shape.node(2, 2) } else { shape.cell(2, 2) };
        let glued = sheet.glued(&[Gluing::from_type(kind, at)]).unwrap();
        let classes = NodeClasses::new(&glued).unwrap();
        let found = if number < 13 { classify_node(&classes, 2, 2, false) } else { classify_cell(&classes, 2, 2) };
        assert_eq!(found, Some(kind));
        let (order, count, cells) = caption(number);
        let groups = classes.glued_classes().unwrap();
        assert!(groups.len() == count && groups.iter().all(|group| group.len() == order), "{number}");
        let complex = Complex::from_topology(&glued, &Job::default()).unwrap();
        assert_eq!([complex.triangles, complex.digons, complex.points, complex.folds], cells, "{number}");
        assert_eq!((complex.euler_characteristic(), complex.is_closed()), (1, false));
        assert!(complex.is_manifold() && complex.orientable);
        // And undone.
        assert_eq!(glued.unglued(&[Gluing::from_type(kind, at)]).unwrap(), sheet);
    }
    let both = [CellDiagonal::Falling, CellDiagonal::Rising].map(|diagonal| Gluing::CellDiagonal { cell: 5, diagonal });
    assert_eq!(sheet.glued(&both), Err(Error::CrossingCell { cell: 5 }));
}

/// Rows longer than a block of 32 nodes: classes, the canonical form and the histogram agree with
/// the definition.
#[test]
fn long_rows() {
    let mut dice = crate::complexes::Dice(5);
    for (h, w) in [(2, 31), (3, 32), (3, 33), (2, 63), (4, 64), (3, 65), (2, 100), (70, 2), (33, 3)] {
        let shape = Shape::new(h, w).unwrap();
        for share in [1, 3, 6, 9, 10] {
            let mut matrix = LinkMatrix::empty(shape).unwrap();
            (0..2 * shape.node_count() as u32).for_each(|link| matrix.set_contracted(link, dice.below(10) < share));
            let pairs: Vec<_> =
                (matrix.links()).map(|link| shape.ends_of_link(link).map(|node| node as usize)).collect();
            let class = crate::complexes::classes(shape.node_count(), &pairs);
            let crossing = Oracle::new(shape, &pairs, |_, _| true).crossing;
            let topology = Topology::new(shape, ContractedLinks::Matrix(matrix), &[]);
            if let Some(cell) = crossing {
                assert_eq!(topology, Err(Error::CrossingCell { cell: cell as u32 }));
                continue;
            }
            let topology = topology.unwrap();
            let classes = NodeClasses::new(&topology).unwrap();
            assert!(
                classes.representatives().unwrap().iter().zip(&class).all(|(&found, &class)| found as usize == class)
            );
            let saturated = topology.canonical_form().unwrap();
            let (mut nodes, mut cells) = ([0; 18], [0; 18]);
            for node in 0..shape.node_count() as u32 {
                let (i, j) = shape.row_and_column(node);
                for link in [2 * node, 2 * node + 1] {
                    assert_eq!(saturated.is_contracted(link), classes.has_identified_ends(link));
                }
                let types = [
                    classify_node(&classes, i, j, false),
                    if i + 1 < h && j + 1 < w { classify_cell(&classes, i, j) } else { None },
                ];
                types[0].iter().for_each(|kind| nodes[kind.number()] += 1);
                types[1].iter().for_each(|kind| cells[kind.number()] += 1);
            }
            let histogram = gluing_histogram(&topology, &Job::default()).unwrap();
            assert_eq!((histogram.nodes, histogram.cells), (nodes, cells));
        }
    }
}
