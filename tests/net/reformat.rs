//! Reformatting and its inverse.

use crate::nets::{Surface, any_topology, job, numbered, same, shape, sphere, torus};
use glam::DVec3;
use gusset::mesh::Scalar;
use gusset::net::topology::{ContractedLinks, SeamRun};
use gusset::net::{Net, NodeClasses, Replication, Seam, Sides, Topology};
use gusset::{Allowed, Error};
use proptest::prelude::*;

fn any_replication() -> impl Strategy<Value = Replication> {
    prop_oneof![
        Just(Replication::First),
        Just(Replication::Last),
        Just(Replication::Uniform),
        Just(Replication::AtPoles),
        (0..2u32).prop_map(Replication::At),
    ]
}

/// A net whose nodes have the positions of their classes, so that it has a volume.
fn glued(topology: Topology) -> Net<'static> {
    let classes = NodeClasses::new(&topology).unwrap();
    let shape = topology.shape();
    Net::from_fn(topology, Scalar::F64, |i, j| {
        let n = f64::from(classes.representative(shape.node(i, j)));
        DVec3::new((n * 1.7).sin(), (n * 2.3).cos(), (n * 0.9).sin())
    })
    .unwrap()
}

/// True if no row and no column says the same as the one before it, all links between them
/// contracted.
fn has_no_copies(net: &Net<'_>) -> bool {
    let (shape, topology) = (net.shape(), net.topology());
    let (h, w) = (shape.rows(), shape.columns());
    let rows = (0..h - 1).any(|i| (0..w).all(|j| topology.is_contracted(2 * shape.node(i, j) + 1)));
    let columns = (0..w - 1).any(|j| (0..h).all(|i| topology.is_contracted(2 * shape.node(i, j))));
    !rows && !columns
}

/// True if two pairs of its seams are of the same nodes.
fn says_a_pair_twice(net: &Net<'_>) -> bool {
    let mut pairs = std::collections::BTreeSet::new();
    let seams = net.topology().seams().iter();
    !seams.flat_map(|seam| seam.pairs(net.shape())).all(|[a, b]| pairs.insert([a.min(b), a.max(b)]))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]
    #[test]
    fn the_surface_stays_and_compacting_gives_the_net_back(
        topology in any_topology(2..6, 2..6),
        more in (0..5usize, 0..5usize),
        how in [any_replication(), any_replication()],
    ) {
        let net = glued(topology);
        let (h, w) = (net.shape().rows(), net.shape().columns());
        let large = net.enlarged_to(h + more.0, w + more.1, how, &job()).unwrap();
        prop_assert_eq!(large.shape(), shape(h + more.0, w + more.1));
        let (before, after) = (Surface::from_net(&net), Surface::from_net(&large));
        prop_assert_eq!(before.counts(), after.counts());
        prop_assert_eq!(before.edge_faces(), after.edge_faces());
        prop_assert!((before.volume(&net) - after.volume(&large)).abs() < 1e-12);
        // Every node lies where its class does: glued nodes of the large net are glued nodes of the
        // small one.
        let classes = NodeClasses::new(large.topology()).unwrap();
        for node in 0..large.shape().node_count() as u32 {
            let [(i, j), (p, q)] = [node, classes.representative(node)].map(|node| large.shape().row_and_column(node));
            prop_assert_eq!(large.get(i, j), large.get(p, q));
        }
        if has_no_copies(&net) {
            let numbered = numbered(net.topology().clone(), Scalar::F32);
            let large = numbered.enlarged_to(h + more.0, w + more.1, how, &job()).unwrap();
            let back = large.compacted(&job()).unwrap();
            if back.topology() != numbered.topology() {
                // The same gluing, where seams that say a pair twice can be written in shorter
                // ways.
                prop_assert!(says_a_pair_twice(&net), "{:?} {:?}", back.topology(), numbered.topology());
                let representatives = |net: &Net<'_>| NodeClasses::new(net.topology()).unwrap().representatives();
                prop_assert_eq!(representatives(&back), representatives(&net));
            } else {
                prop_assert!(same(&back, &numbered));
            }
        }
    }
}

#[test]
fn closed_nets_stay_closed() {
    for net in [sphere(5, 9, Scalar::F32, DVec3::ZERO), torus(5, 9, Scalar::F32, DVec3::ZERO)] {
        for how in
            [Replication::First, Replication::Last, Replication::At(3), Replication::Uniform, Replication::AtPoles]
        {
            let large = net.enlarged_to(11, 20, [how; 2], &job()).unwrap();
            let surface = Surface::from_net(&large);
            assert_eq!(surface.euler(), Surface::from_net(&net).euler());
            assert_eq!(surface.edge_faces().into_keys().collect::<Vec<_>>(), [2], "{how:?}");
            assert!(same(&large.compacted(&job()).unwrap(), &net), "{how:?}");
        }
    }
    // At poles: the first and the last row, half each.
    let large = sphere(5, 9, Scalar::F32, DVec3::ZERO).enlarged_to(9, 9, [Replication::AtPoles; 2], &job()).unwrap();
    assert!((0..3).all(|i| large.get(i, 4) == large.get(0, 0)) && large.get(3, 4) != large.get(0, 0));
    assert!((6..9).all(|i| large.get(i, 4) == large.get(8, 0)) && large.get(5, 4) != large.get(8, 0));
}

#[test]
fn a_seam_through_copies_is_one_again() {
    // A Möbius strip whose rows are replicated unequally: the seam is cut where its steps change.
    let size = shape(7, 5);
    let seam = Seam { a: SeamRun::along_column(0, 4, 1), b: SeamRun::along_column(6, 0, -1), count: 7 };
    let strip = Topology::new(size, ContractedLinks::Sides(Sides::SHEET), &[seam]).unwrap();
    let net = glued(strip);
    for how in [Replication::First, Replication::Last, Replication::At(2), Replication::Uniform] {
        let large = net.enlarged_to(12, 9, [how; 2], &job()).unwrap();
        assert_eq!(Surface::from_net(&large).counts(), Surface::from_net(&net).counts());
        assert!(same(&large.compacted(&job()).unwrap(), &net), "{how:?}");
    }
}

#[test]
fn refusals() {
    let net = sphere(5, 9, Scalar::F32, DVec3::ZERO);
    let how = [Replication::Uniform; 2];
    let refused = |rows, columns, how| net.enlarged_to(rows, columns, how, &job()).unwrap_err();
    let fewer = |option, value, allowed| Error::OptionOutOfRange { option, value, allowed };
    assert_eq!(refused(4, 9, how), fewer("rows", 4.0, Allowed::AtLeast(5.0)));
    assert_eq!(refused(5, 8, how), fewer("columns", 8.0, Allowed::AtLeast(9.0)));
    let beyond = [Replication::At(5), Replication::Last];
    assert_eq!(refused(6, 9, beyond), fewer("row_index", 5.0, Allowed::IndexBelow(5)));
    assert!(matches!(refused(usize::MAX, 9, how), Error::TooLarge { .. }));
}
