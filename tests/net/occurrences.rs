//! The local gluings of nets as data: letters and orders by counting nodes and links of each.

use crate::common::Steady;
use crate::space::{sheet, sphere};
use gusset::Job;
use gusset::mesh::Scalar;
use gusset::net::topology::{
    Gluing, GluingOccurrence, GluingType, SeamRun, classify_cell, classify_node, find_gluing_occurrences,
    gluing_histogram,
};
use gusset::net::{NodeClasses, Seam, Shape, Sides, Topology};
use std::collections::BTreeMap;

/// A sheet with one local gluing: of the node or of the cell in its middle.
fn with(kind: GluingType, on_cell: bool) -> (Topology, u32) {
    let topology = sheet(7, 7, Scalar::F64).topology().clone();
    // Cell types are glued at cells, and 0 to 5 of cells as their links say.
    let element = if on_cell && kind.number() > 12 { 3 * 6 + 3 } else { 3 * 7 + 3 };
    (topology.glued(&[Gluing::from_type(kind, element)]).unwrap(), element)
}

/// The largest number of links that are not contracted and have the same two ends.
fn most_links_made_one(classes: &NodeClasses) -> usize {
    let shape = classes.shape();
    let mut count = BTreeMap::new();
    for link in (0..2 * shape.node_count() as u32).filter(|&link| {
        let [a, b] = shape.ends_of_link(link).map(|node| shape.row_and_column(node));
        a.0.abs_diff(b.0) + a.1.abs_diff(b.1) == 1 && !classes.has_identified_ends(link)
    }) {
        let mut ends = shape.ends_of_link(link).map(|node| classes.representative(node));
        ends.sort_unstable();
        *count.entry(ends).or_insert(0) += 1;
    }
    count.into_values().max().unwrap()
}

#[test]
fn letters_and_orders_are_those_that_counting_finds() {
    for number in 0..GluingType::TYPE_COUNT as u32 {
        let kind = GluingType::from_number(number).unwrap();
        for on_cell in [false, true] {
            let Some(signature) = (if on_cell { kind.cell_signature() } else { kind.node_signature() }) else {
                assert_eq!(on_cell, (6..=12).contains(&number), "{number}");
                continue;
            };
            let (topology, element) = with(kind, on_cell);
            let classes = NodeClasses::new(&topology).unwrap();
            let largest = classes.glued_classes().unwrap().iter().map(<[u32]>::len).max().unwrap();
            assert_eq!(usize::from(signature.node_order), largest, "{number}");
            assert_eq!(usize::from(signature.link_order), most_links_made_one(&classes), "{number}");
            // The letters, from the contracted links on the way round the node or the cell.
            let all = find_gluing_occurrences(&topology, false, &Job::default()).unwrap();
            let here =
                |o: &&GluingOccurrence| o.kind == kind && o.on_cell == on_cell && (on_cell || o.element == element);
            let found = all.iter().find(here).unwrap_or_else(|| panic!("{number}"));
            assert_eq!((found.signature, found.class_size as usize), (signature, largest));
            let shape = topology.shape();
            let links: Vec<bool> = if on_cell {
                let (i, j) = (found.element as usize / 6, found.element as usize % 6);
                let [a, b, c, d] = classes.representatives_of_corners(i, j);
                vec![a == b, b == c, c == d, d == a]
            } else {
                let (i, j) = shape.row_and_column(found.element);
                let at = |i: usize, j: usize| classes.representative(shape.node(i, j));
                [at(i, j + 1), at(i + 1, j), at(i, j - 1), at(i - 1, j)].map(|other| other == at(i, j)).to_vec()
            };
            let count = links.iter().filter(|&&on| on).count();
            let adjacent = (0..4).any(|k| links[k] && links[(k + 1) % 4]);
            let expected = match (on_cell, count) {
                (true, 0) => (1, Some(2)),
                (true, 4) => (3, None),
                (false, 2) => (2, Some(if adjacent { 1 } else { 2 })),
                (true, 2) => (2, Some(u8::from(!adjacent))),
                (_, count) => (count as u8, None),
            };
            assert_eq!((signature.a, signature.b), expected, "{number} {on_cell}");
        }
    }
}

#[test]
fn all_of_a_net_are_listed_in_order_and_as_often_as_the_histogram_says() {
    let sphere = sphere(9, 13, Scalar::F32);
    let shape = Shape::new(6, 8).unwrap();
    let mixed = Topology::from_sides(shape, Sides { columns_closed: true, pole_left: true, ..Sides::SHEET });
    let mixed = mixed.glued(&[Gluing::from_type(GluingType::from_number(17).unwrap(), 25)]).unwrap();
    for (topology, cyclic) in [(sphere.topology(), false), (sphere.topology(), true), (&mixed, false), (&mixed, true)] {
        let all = find_gluing_occurrences(topology, cyclic, &Job::default()).unwrap();
        assert!(all.windows(2).all(|w| (w[0].on_cell, w[0].element) < (w[1].on_cell, w[1].element)));
        let (classes, shape) = (NodeClasses::new(topology).unwrap(), topology.shape());
        let size = |node: u32| {
            let same = |&other: &u32| classes.representative(other) == classes.representative(node);
            (0..shape.node_count() as u32).filter(same).count() as u32
        };
        let mut counts = [[0; GluingType::TYPE_COUNT]; 2];
        for found in &all {
            counts[usize::from(found.on_cell)][found.kind.number()] += 1;
            let (i, j) = if found.on_cell {
                (found.element as usize / (shape.columns() - 1), found.element as usize % (shape.columns() - 1))
            } else {
                shape.row_and_column(found.element)
            };
            let (kind, class) = if found.on_cell {
                (classify_cell(&classes, i, j), shape.corners_of_cell(i, j).map(size).into_iter().max().unwrap())
            } else {
                (classify_node(&classes, i, j, cyclic), size(found.element))
            };
            assert_eq!((Some(found.kind), found.class_size), (kind, class));
        }
        let expected = gluing_histogram(topology, &Job::default()).unwrap();
        assert_eq!(counts[1], expected.cells);
        assert!(cyclic || counts[0] == expected.nodes);
        assert!(!cyclic || counts[0] != expected.nodes, "closing links count too");
    }
}

/// A finding of the fuzzer `gluing`: the classes took a fifth of the work, and progress then
/// restarted at 0.
#[test]
fn progress_never_falls_back() {
    let seam = Seam { a: SeamRun::along_row(0, 0, 1), b: SeamRun::along_row(6, 0, 1), count: 7 };
    let glued = sheet(7, 7, Scalar::F64).topology().glued(&[Gluing::Seam(seam)]).unwrap();
    find_gluing_occurrences(&glued, false, &Job::new(1, &Steady::default())).unwrap();
}
