//! Validation, topology from coordinates, and ungluing with a gap.

use crate::complexes::Dice;
use glam::DVec3;
use gusset::mesh::Scalar;
use gusset::net::primitive::{Primitive, Request};
use gusset::net::topology::{CellDiagonal, ContractedLinks, Gluing, LinkMatrix, SeamRun};
use gusset::net::{FindingKind, Net, NodeClasses, Seam, Shape, Sides, Topology, closure, detect_gluing};
use gusset::{Element, Error, Job};

fn sphere() -> Net<'static> {
    Request { rows: 7, columns: 9, ..Request::new(Primitive::Sphere { radius: 1.0 }) }
        .build_net(&Job::default())
        .unwrap()
}

fn sheet(shape: Shape) -> Net<'static> {
    let place = |i: usize, j: usize| DVec3::new(j as f64, i as f64, 0.0);
    Net::from_fn(Topology::from_sides(shape, Sides::SHEET), Scalar::F64, place).unwrap()
}

fn kinds(net: &Net<'_>, tolerance: f64) -> Vec<(FindingKind, [u32; 2])> {
    net.validate(tolerance, &Job::default()).unwrap().iter().map(|finding| (finding.kind, finding.nodes)).collect()
}

#[test]
fn a_moved_node_and_a_missing_one_are_found() {
    let mut net = sphere();
    let seam = net.get(3, 8);
    net.coordinates_mut().set(3, 8, seam + DVec3::X * 0.5);
    assert_eq!(kinds(&net, 0.0), [(FindingKind::LinkApart, [35, 27])]);
    // Near the poles links are shorter than these tolerances.
    let violations = |net: &Net<'_>, tolerance| {
        kinds(net, tolerance).into_iter().filter(|found| found.0.is_violation()).collect::<Vec<_>>()
    };
    assert_eq!(violations(&net, 0.25), [(FindingKind::LinkApart, [35, 27])]);
    assert_eq!(violations(&net, 0.5), []);
    let finding = net.validate(0.0, &Job::default()).unwrap()[0];
    assert!(finding.distance == 0.5 && finding.element == 70 && finding.kind.is_violation());
    // Missing on one side only.
    net.coordinates_mut().set(3, 8, DVec3::new(0.0, f64::NAN, 0.0));
    assert_eq!(kinds(&net, 1e9)[0], (FindingKind::LinkApart, [35, 27]));
    // On both.
    net.coordinates_mut().set(3, 0, DVec3::new(f64::INFINITY, 0.0, 0.0));
    assert_eq!(kinds(&net, 0.0), []);
    // Zeros lack a sign here.
    net.coordinates_mut().set(3, 0, DVec3::new(0.0, 1.0, 0.0));
    net.coordinates_mut().set(3, 8, DVec3::new(-0.0, 1.0, 0.0));
    assert_eq!(kinds(&net, 0.0), []);
    for tolerance in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(net.validate(tolerance, &Job::default()), Err(Error::OptionOutOfRange { .. })));
        assert!(matches!(
            detect_gluing(net.coordinates(), tolerance, &Job::default()),
            Err(Error::OptionOutOfRange { .. })
        ));
    }
}

#[test]
fn seams_and_warnings() {
    let shape = Shape::new(4, 6).unwrap();
    let mut net = sheet(shape);
    // A Möbius strip whose ends are not brought together.
    net.set_topology(closure::moebius(shape).unwrap());
    assert_eq!(kinds(&net, 0.0).iter().filter(|f| f.0 == FindingKind::SeamApart).count(), 4);
    // Neighbours that lie together and are not glued.
    let mut net = sheet(shape);
    net.coordinates_mut().set(2, 3, DVec3::new(2.0, 2.0, 0.0));
    assert_eq!(kinds(&net, 0.0), [(FindingKind::ZeroLength, [14, 15])]);
    net.glue(&[Gluing::Link(2 * 14)]).unwrap();
    assert_eq!(kinds(&net, 0.0), []);
    // Rows that end where they begin.
    let mut net = sheet(shape);
    net.coordinates_mut().set(1, 5, DVec3::new(0.0, 1.0, 0.0));
    assert_eq!(kinds(&net, 0.0), [(FindingKind::ZeroLength, [11, 6])]);
    // Three links of a cell contracted: the fourth is a loop.
    let mut net = sheet(shape);
    net.glue(&[Gluing::Cell { cell: 6, mask: 7 }]).unwrap();
    let loops: Vec<_> = kinds(&net, 9.0).into_iter().filter(|f| f.0 == FindingKind::Loop).collect();
    assert_eq!(loops, [(FindingKind::Loop, [7, 13])]);
    // A tube of two cells round.
    let place = |i: usize, j: usize| DVec3::new([0.0, 1.0, 0.0][j], i as f64, 0.0);
    let narrow = Topology::from_sides(Shape::new(4, 3).unwrap(), Sides::TUBE);
    let net = Net::from_fn(narrow, Scalar::F32, place).unwrap();
    assert_eq!(kinds(&net, 0.0), [(FindingKind::FewNodes, [2, 0])]);
}

/// Coordinates made to coincide where a random gluing of neighbours says so give that gluing again.
#[test]
fn derived_from_classes() {
    let mut dice = Dice(7);
    for _ in 0..400 {
        let shape = Shape::new(2 + dice.below(5) as usize, 2 + dice.below(5) as usize).unwrap();
        let mut matrix = LinkMatrix::empty(shape).unwrap();
        let count = dice.below(shape.node_count() as u64);
        for _ in 0..count {
            let link = dice.below(2 * shape.node_count() as u64) as u32;
            matrix.set_contracted(link, shape.joins_neighbours(link));
        }
        let topology = Topology::new(shape, ContractedLinks::Matrix(matrix), &[]).unwrap();
        let classes = NodeClasses::new(&topology).unwrap();
        let place = |i: usize, j: usize| {
            let k = f64::from(classes.representative(shape.node(i, j)));
            DVec3::new((k * 0.7).sin(), (k * 1.3).cos(), k)
        };
        let net = Net::from_fn(topology.clone(), Scalar::F64, place).unwrap();
        assert_eq!(net.validate(0.0, &Job::default()).unwrap().iter().filter(|f| f.kind.is_violation()).count(), 0);
        let derived = detect_gluing(net.coordinates(), 0.0, &Job::default()).unwrap();
        // Rims that are glued through the inside may be known as seams besides: the classes count.
        assert_eq!(NodeClasses::new(&derived).unwrap().representatives().unwrap(), classes.representatives().unwrap());
        assert_eq!(derived.contracted_link_set(), topology.canonical_form().unwrap().contracted_link_set());
    }
    // In the plane nothing crosses. Both diagonals: refused by name.
    let shape = Shape::new(2, 2).unwrap();
    let cross = |i: usize, j: usize| DVec3::X * ((i + j) % 2) as f64;
    let net = Net::from_fn(Topology::from_sides(shape, Sides::SHEET), Scalar::F64, cross).unwrap();
    assert_eq!(detect_gluing(net.coordinates(), 0.0, &Job::default()), Err(Error::CrossingCell { cell: 0 }));
}

#[test]
fn batches_are_done_as_a_whole_or_not_at_all() {
    let mut net = sheet(Shape::new(4, 6).unwrap());
    let seam = |count| Gluing::Seam(Seam { a: SeamRun::along_row(0, 0, 1), b: SeamRun::along_row(3, 5, -1), count });
    let diagonal = |diagonal| Gluing::CellDiagonal { cell: 3, diagonal };
    let before = net.topology().clone();
    let bad = [
        (Gluing::Link(48), Error::NoSuch { element: Element::Link, index: 48, count: 48 }),
        (Gluing::Star { node: 24, mask: 1 }, Error::NoSuch { element: Element::Node, index: 24, count: 24 }),
        (
            Gluing::Star { node: 0, mask: 16 },
            Error::OptionOutOfRange { option: "mask", value: 16.0, allowed: (0.0..=15.0).into() },
        ),
        (Gluing::Cell { cell: 15, mask: 1 }, Error::NoSuch { element: Element::Cell, index: 15, count: 15 }),
        (
            Gluing::CellDiagonal { cell: 15, diagonal: CellDiagonal::Rising },
            Error::NoSuch { element: Element::Cell, index: 15, count: 15 },
        ),
        (seam(7), Error::BadSeam { seam: 1 }),
        (diagonal(CellDiagonal::Rising), Error::CrossingCell { cell: 3 }),
    ];
    for (gluing, error) in bad {
        assert_eq!(net.glue(&[diagonal(CellDiagonal::Falling), gluing]), Err(error));
        assert_eq!(*net.topology(), before);
        if !matches!(error, Error::CrossingCell { .. }) {
            assert_eq!(net.unglue(&[gluing, gluing], 0.0).is_err(), !matches!(error, Error::CrossingCell { .. }));
        }
    }
    assert!(matches!(net.unglue(&[], -1.0), Err(Error::OptionOutOfRange { .. })));
}

#[test]
fn gluing_and_ungluing_undo_each_other() {
    let mut dice = Dice(3);
    let shape = Shape::new(5, 7).unwrap();
    for _ in 0..500 {
        let start = Topology::from_sides(shape, [Sides::SHEET, Sides::TUBE, Sides::TORUS][dice.below(3) as usize]);
        let gluing = match dice.below(4) {
            0 => Gluing::Link(2 * dice.below(35) as u32),
            1 => Gluing::Star { node: dice.below(35) as u32, mask: dice.below(16) as u8 },
            2 => Gluing::Cell { cell: dice.below(24) as u32, mask: dice.below(16) as u8 },
            _ => {
                let (row, step) = (1 + dice.below(2) as u32, if dice.below(2) == 0 { 1 } else { -1 });
                let column = if step == 1 { 0 } else { 4 };
                Gluing::Seam(Seam {
                    a: SeamRun::along_row(row, 1, 1),
                    b: SeamRun::along_row(row + 2, column + 1, step),
                    count: 4,
                })
            }
        };
        let Ok(glued) = start.glued(&[gluing]) else { continue };
        let free = glued.unglued(&[gluing]).unwrap();
        // Nodes glued before and named again are free now.
        let expected = start.unglued(&[gluing]).unwrap();
        assert_eq!(free, expected);
    }
    // A part of a seam.
    let whole = closure::moebius(shape).unwrap();
    let part = Seam { a: SeamRun::along_column(2, 6, 1), b: SeamRun::along_column(2, 0, -1), count: 1 };
    let cut = whole.unglued(&[Gluing::Seam(part)]).unwrap();
    assert_eq!(cut.seams().iter().map(|seam| seam.count).collect::<Vec<_>>(), [2, 2]);
    assert_eq!(NodeClasses::new(&cut).unwrap().glued_classes().unwrap().len(), 4);
}

#[test]
fn a_cut_opens() {
    // A torus, cut along its last column: both rims retreat along the rows.
    let torus = Primitive::Torus { radius: 2.0, minor_radius: 0.5 };
    let mut net = Request { rows: 9, columns: 17, ..Request::new(torus) }.build_net(&Job::default()).unwrap();
    let before: Vec<_> = (0..9).map(|i| net.get(i, 0)).collect();
    let links: Vec<_> = (0..9).map(|i| Gluing::Link(2 * (i * 17 + 16))).collect();
    assert_eq!(net.unglue(&links, 0.02).unwrap(), 16);
    assert_eq!(net.topology().sides(), Some(Sides { columns_closed: true, ..Sides::SHEET }));
    for (i, &old) in before.iter().enumerate() {
        let (first, last) = (net.get(i, 0), net.get(i, 16));
        assert!(((first - old).length() - 0.01).abs() < 1e-12 && ((last - old).length() - 0.01).abs() < 1e-12);
        let (along, back) = ((net.get(i, 1) - old).normalize(), (net.get(i, 15) - old).normalize());
        assert!((first - old).normalize().dot(along) > 1.0 - 1e-9 && (last - old).normalize().dot(back) > 1.0 - 1e-9);
        assert!((first - last).length() > 0.018, "apart by nearly the separation");
    }
    assert_eq!(net.get(0, 16), net.get(8, 16), "what is glued still moves together");
    assert_eq!(net.validate(0.0, &Job::default()).unwrap(), []);
    // A pole becomes a rim.
    let mut net = sphere();
    let pole: Vec<_> = (0..8).map(|j| Gluing::Link(2 * j)).collect();
    assert_eq!(net.unglue(&pole, 0.1).unwrap(), 8);
    assert!((0..8).all(|j| ((net.get(0, j) + DVec3::Z).length() - 0.05).abs() < 1e-12));
    assert_eq!(net.validate(0.0, &Job::default()).unwrap(), []);
    // Without a gap nothing moves.
    let mut net = sphere();
    let before: Vec<_> = (0..9).map(|j| net.get(0, j)).collect();
    assert_eq!(net.unglue(&pole, 0.0).unwrap(), 0);
    assert!((0..9).all(|j| net.get(0, j) == before[j]));
}

/// The whole rim folded about a corner: runs turn corners, now on the one side and now on the
/// other.
#[test]
fn a_rim_folded_about_a_corner_is_derived() {
    for (h, w) in [(4, 9), (9, 4), (5, 5), (3, 8)] {
        let shape = Shape::new(h, w).unwrap();
        let n = 2 * (h + w) - 4;
        // The number of a rim node, clockwise from the first corner.
        let rim = |i: usize, j: usize| match (i, j) {
            (0, j) => Some(j),
            (i, j) if j + 1 == w => Some(w - 1 + i),
            (i, j) if i + 1 == h => Some(w + h - 2 + (w - 1 - j)),
            (i, 0) => Some(n - i),
            _ => None,
        };
        let place = |i: usize, j: usize| {
            let k = rim(i, j).map_or(n + w * i + j, |k| k.min(n - k)) as f64;
            DVec3::new((k * 0.7).sin(), (k * 1.3).cos(), k * 0.1)
        };
        let sheet = Topology::from_sides(shape, Sides::SHEET);
        let net = Net::from_fn(sheet, Scalar::F32, place).unwrap();
        for tolerance in [0.0, 1e-6] {
            let derived = detect_gluing(net.coordinates(), tolerance, &Job::default()).unwrap();
            let classes = NodeClasses::new(&derived).unwrap();
            let nodes = || (0..h).flat_map(|i| (0..w).map(move |j| (i, j)));
            for ((a, b), (c, d)) in nodes().flat_map(|p| nodes().map(move |q| (p, q))) {
                let one = classes.representative(shape.node(a, b)) == classes.representative(shape.node(c, d));
                assert_eq!(one, place(a, b) == place(c, d), "{h} x {w}: {:?}", [(a, b), (c, d)]);
            }
        }
    }
}

/// A long rim whose nodes are level in many directions: minutes, if pairs of them were compared.
#[test]
fn long_level_rims_are_derived() {
    let shape = Shape::new(2, 20_000).unwrap();
    let topology = Topology::from_sides(shape, Sides::SHEET);
    let [along, across] = [DVec3::new(0.618_033_99, -0.577_350_27, 0.0), DVec3::new(0.0, 0.533_751_17, -0.618_033_99)];
    let net = Net::from_fn(topology, Scalar::F64, |i, j| along * j as f64 + across * i as f64).unwrap();
    for tolerance in [0.0, 1e-6] {
        assert_eq!(&detect_gluing(net.coordinates(), tolerance, &Job::default()).unwrap(), net.topology());
    }
}
