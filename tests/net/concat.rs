//! Joining nets and taking them apart.

use crate::nets::{Surface, any_topology, job, numbered, same, shape, sphere, torus};
use crate::space::{has_cell, is_hidden};
use glam::DVec3;
use gusset::mesh::Scalar;
use gusset::net::topology::{ContractedLinks, Gluing};
use gusset::net::{
    BridgeKind, BridgeMode, Direction, JoinOptions, Net, NodeClasses, Replication, Sides, Topology, concatenate,
    concatenate_all,
};
use gusset::{Element, Error};
use proptest::prelude::*;

const DIRECTIONS: [Direction; 2] = [Direction::Right, Direction::Down];

fn any_direction() -> impl Strategy<Value = Direction> {
    prop_oneof![Just(Direction::Right), Just(Direction::Down)]
}

fn options(direction: Direction) -> JoinOptions {
    JoinOptions { turn: true, ..JoinOptions::new(direction) }
}

fn any_mode() -> impl Strategy<Value = BridgeMode> {
    prop_oneof![Just(BridgeMode::Keep), Just(BridgeMode::Hide), Just(BridgeMode::Weld)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]
    #[test]
    fn splitting_undoes_joining(
        a in any_topology(2..6, 2..6),
        b in any_topology(2..6, 2..6),
        c in any_topology(2..6, 2..6),
        directions in [any_direction(), any_direction()],
        modes in [any_mode(), any_mode()],
        rows in [0..3u32, 0..3u32],
    ) {
        let [a, b, c] = [a, b, c].map(|topology| numbered(topology, Scalar::F32));
        let rows = |k: usize| if modes[k] == BridgeMode::Weld { 0 } else { rows[k] };
        let with = |k: usize| {
            JoinOptions { mode: modes[k], tolerance: f64::INFINITY, rows: rows(k), ..options(directions[k]) }
        };
        let once = match concatenate(&a, &b, &with(0), &job()) {
            Err(Error::CrossingCell { .. } | Error::SidesApart { .. }) => return Ok(()),
            once => once.unwrap(),
        };
        let [first, second] = once.split(once.bridges().len() - 1, &job()).unwrap();
        prop_assert!(same(&first, &a), "{:?}\n{:?}", first.topology(), a.topology());
        prop_assert!(same(&second, &b), "{:?}\n{:?}", second.topology(), b.topology());
        // The nets' own classes, and none between them unless they are welded.
        if modes[0] != BridgeMode::Weld {
            let [x, y, z] = [&a, &b, &once].map(|net| NodeClasses::new(net.topology()).unwrap().glued_classes().unwrap());
            if a.shape() == first.shape() && once.shape().node_count() == a.shape().node_count() + b.shape().node_count() {
                prop_assert_eq!(x.len() + y.len(), z.len());
                prop_assert_eq!(x.nodes().len() + y.nodes().len(), z.nodes().len());
            }
        }
        for (p, q, swapped) in [(&once, &c, false), (&c, &once, true)] {
            let twice = match concatenate(p, q, &with(1), &job()) {
                Err(Error::CrossingCell { .. } | Error::SidesApart { .. }) => continue,
                twice => twice.unwrap(),
            };
            let [first, second] = twice.split(twice.bridges().len() - 1, &job()).unwrap();
            let (whole, other) = if swapped { (second, first) } else { (first, second) };
            prop_assert!(same(&whole, &once), "{:?}\n{:?}", whole, once);
            prop_assert!(same(&other, &c));
            let [first, second] = whole.split(whole.bridges().len() - 1, &job()).unwrap();
            prop_assert!(same(&first, &a) && same(&second, &b));
        }
    }

    #[test]
    fn all_at_once(
        topologies in prop::collection::vec(any_topology(2..6, 2..6), 1..6),
        direction in any_direction(),
        hide in any::<bool>(),
        rows in 0..3u32,
    ) {
        let nets: Vec<Net<'_>> = topologies.into_iter().map(|topology| numbered(topology, Scalar::F64)).collect();
        let mode = if hide { BridgeMode::Hide } else { BridgeMode::Keep };
        let options = JoinOptions { mode, rows, ..options(direction) };
        let all = concatenate_all(&nets.iter().collect::<Vec<_>>(), &options, &job()).unwrap();
        let parts = all.split_all(direction, &job()).unwrap();
        prop_assert_eq!(parts.len(), nets.len());
        prop_assert!(parts.iter().zip(&nets).all(|(part, net)| same(part, net)));
        if nets.iter().all(|net| net.shape() == nets[0].shape()) {
            let one_by_one = nets[1..].iter().fold(nets[0].copied().unwrap(), |joined, net| {
                concatenate(&joined, net, &options, &job()).unwrap()
            });
            // Bridges of three nets and more know which was made last.
            prop_assert!(same(&all, &one_by_one) || nets.len() > 2);
            prop_assert_eq!(all.topology(), one_by_one.topology());
        }
    }

    #[test]
    fn turned_sides(sides in crate::nets::any_sides(), twist in 0..12u32, direction in any_direction(), more in 0..4usize) {
        // Closed along the side that is joined, whose last node has the bits of the first.
        let sides = match direction {
            Direction::Right => Sides { columns_closed: true, ..sides },
            Direction::Down => Sides { rows_closed: true, ..sides },
        };
        let (h, w) = (6, 5);
        let b = Net::from_fn(Topology::from_sides(shape(h, w), sides), Scalar::F32, |i, j| {
            let (i, j) = if direction == Direction::Right { (i % (h - 1), j) } else { (i, j % (w - 1)) };
            DVec3::new(i as f64, j as f64, 1.0)
        })
        .unwrap();
        let size = if direction == Direction::Right { shape(h + more, 4) } else { shape(4, w + more) };
        let a = numbered(Topology::from_sides(size, Sides::TORUS), Scalar::F32);
        let joined = concatenate(&a, &b, &JoinOptions { twist, ..options(direction) }, &job()).unwrap();
        if more == 0 {
            let (place, around) = (twist as usize, if direction == Direction::Right { h - 1 } else { w - 1 });
            let (start, expected) = match direction {
                Direction::Right => (joined.get(0, 4), b.get(place % around, 0)),
                Direction::Down => (joined.get(4, 0), b.get(0, place % around)),
            };
            prop_assert_eq!(start, expected);
            prop_assert_eq!(Surface::from_net(&b).counts(), {
                let count = |net: &Net<'_>| Surface::from_net(net).counts();
                let [v, e, f] = count(&joined.split_all(direction, &job()).unwrap()[1]);
                [v, e, f]
            });
        }
        let [first, second] = joined.split(0, &job()).unwrap();
        prop_assert!(same(&first, &a) && same(&second, &b));
    }

    #[test]
    fn turned_sides_of_any_gluing(
        topology in any_topology(2..5, 2..6),
        twist in 0..12u32,
        direction in any_direction(),
        mode in any_mode(),
    ) {
        let shape = topology.shape();
        let (h, w) = (shape.rows(), shape.columns());
        let mut matrix = topology.to_link_matrix().unwrap();
        match direction {
            Direction::Right => (0..w).for_each(|j| matrix.set_contracted(2 * shape.node(h - 1, j) + 1, true)),
            Direction::Down => (0..h).for_each(|i| matrix.set_contracted(2 * shape.node(i, w - 1), true)),
        }
        let Ok(topology) = Topology::new(shape, ContractedLinks::Matrix(matrix), topology.seams()) else { return Ok(()) };
        let b = Net::from_fn(topology, Scalar::F32, |i, j| {
            let (i, j) = if direction == Direction::Right { (i % (h - 1), j) } else { (i, j % (w - 1)) };
            DVec3::new(i as f64, j as f64, 1.0)
        })
        .unwrap();
        let a = numbered(Topology::from_sides(shape, Sides::TORUS), Scalar::F32);
        let options = JoinOptions { twist, mode, tolerance: f64::INFINITY, ..options(direction) };
        let Ok(joined) = concatenate(&a, &b, &options, &job()) else { return Ok(()) };
        if mode != BridgeMode::Weld {
            let [x, y, z] = [&a, &b, &joined].map(|net| NodeClasses::new(net.topology()).unwrap());
            let count = |classes: &NodeClasses| {
                (0..classes.shape().node_count() as u32).filter(|&n| classes.representative(n) == n).count()
            };
            prop_assert_eq!(count(&x) + count(&y), count(&z));
        }
        let [first, second] = joined.split(0, &job()).unwrap();
        prop_assert!(same(&first, &a) && same(&second, &b), "{:?}\n{:?}", second.topology(), b.topology());
    }
}

#[test]
fn spheres_pole_to_pole_hang_on_a_thread() {
    let [a, b] = [0.0, 3.0].map(|z| sphere(9, 17, Scalar::F64, DVec3::new(0.0, 0.0, z)));
    let joined = concatenate(&a, &b, &JoinOptions::new(Direction::Down), &job()).unwrap();
    assert_eq!(joined.bridges()[0].kind, BridgeKind::Thread);
    let surface = Surface::from_net(&joined);
    assert_eq!((surface.euler(), surface.wires.len()), (3, 1));
    assert_eq!(surface.edge_faces().into_iter().collect::<Vec<_>>()[0], (0, 1));
    // Hidden, it is two spheres.
    let mut joined = joined;
    joined.set_bridge_mode(0, BridgeMode::Hide, 0.0).unwrap();
    assert_eq!((Surface::from_net(&joined).euler(), Surface::from_net(&joined).wires.len()), (4, 0));
}

#[test]
fn spheres_side_by_side_have_a_ribbon() {
    let [a, b] = [0.0, 3.0].map(|x| sphere(9, 17, Scalar::F64, DVec3::new(x, 0.0, 0.0)));
    let joined = concatenate(&a, &b, &JoinOptions::new(Direction::Right), &job()).unwrap();
    assert_eq!(joined.bridges()[0].kind, BridgeKind::Ribbon);
    let surface = Surface::from_net(&joined);
    // The ribbon ends on a meridian of each: edges there have three faces.
    assert_eq!(surface.euler(), 3);
    assert_eq!(surface.edge_faces()[&3], 2 * 8);
    assert_eq!(joined.topology().seams().len(), 2);
}

#[test]
fn tubes_make_a_tube() {
    let tube = |z: f64, w: usize| {
        Net::from_fn(Topology::from_sides(shape(4, w), Sides::TUBE), Scalar::F32, |i, j| {
            let angle = std::f64::consts::TAU * (j % (w - 1)) as f64 / (w - 1) as f64;
            DVec3::new(angle.cos(), angle.sin(), z + i as f64)
        })
        .unwrap()
    };
    let joined = concatenate(&tube(0.0, 9), &tube(5.0, 13), &JoinOptions::new(Direction::Down), &job()).unwrap();
    assert_eq!(joined.bridges()[0].kind, BridgeKind::Tube);
    assert_eq!(Surface::from_net(&joined).euler(), 0);
    // Without copies the closure stays one of sides.
    let joined = concatenate(&tube(0.0, 9), &tube(5.0, 9), &JoinOptions::new(Direction::Down), &job()).unwrap();
    assert_eq!(joined.topology().sides(), Some(Sides::TUBE));
    // Welded where they meet.
    let options = JoinOptions { mode: BridgeMode::Weld, tolerance: 1e-6, ..JoinOptions::new(Direction::Down) };
    let welded = concatenate(&tube(0.0, 9), &tube(3.0, 9), &options, &job()).unwrap();
    let surface = Surface::from_net(&welded);
    assert_eq!(surface.counts(), [7 * 8, 2 * 6 * 8 + 8, 6 * 8]);
    let apart = concatenate(&tube(0.0, 9), &tube(3.5, 9), &options, &job()).unwrap_err();
    assert_eq!(apart, Error::SidesApart { place: 0, distance: 0.5 });
    // Kept first, welded later, and back.
    let kept = JoinOptions { mode: BridgeMode::Keep, ..options };
    let mut net = concatenate(&tube(0.0, 9), &tube(3.0, 9), &kept, &job()).unwrap();
    let before = net.copied().unwrap();
    net.set_bridge_mode(0, BridgeMode::Weld, 1e-6).unwrap();
    assert!(same(&net, &welded));
    net.set_bridge_mode(0, BridgeMode::Keep, 0.0).unwrap();
    assert!(same(&net, &before));
}

#[test]
fn refusals() {
    let (a, b) = (sphere(5, 9, Scalar::F32, DVec3::ZERO), torus(6, 9, Scalar::F32, DVec3::ZERO));
    let strict = JoinOptions { equalise: None, ..JoinOptions::new(Direction::Right) };
    let refused = |a: &Net<'_>, b: &Net<'_>, options: &JoinOptions| concatenate(a, b, options, &job()).unwrap_err();
    assert_eq!(refused(&a, &b, &strict), Error::SidesDiffer { a: 5, b: 6 });
    assert_eq!(refused(&a, &sphere(5, 9, Scalar::F64, DVec3::ZERO), &strict), Error::MixedScalars);
    assert_eq!(refused(&a, &a.flipped(Direction::Down, &job()).unwrap(), &strict), Error::NetsOpposed);
    let twist = JoinOptions { twist: 2, ..JoinOptions::new(Direction::Right) };
    assert!(matches!(refused(&a, &a, &twist), Error::OptionOutOfRange { option: "twist", value: 2.0, .. }));
    let weld = JoinOptions { mode: BridgeMode::Weld, tolerance: f64::NAN, ..strict };
    assert!(matches!(refused(&a, &a, &weld), Error::OptionOutOfRange { option: "tolerance", .. }));
    assert_eq!(a.split(0, &job()).unwrap_err(), Error::NoSuch { element: Element::Bridge, index: 0, count: 0 });
    // A bridge within a part of a net only: the other is to be taken apart first.
    let once = concatenate(&a, &a, &strict, &job()).unwrap();
    let wide = sphere(4, 18, Scalar::F32, DVec3::ZERO);
    let twice = concatenate(&once, &wide, &JoinOptions::new(Direction::Down), &job()).unwrap();
    assert_eq!(twice.split(0, &job()).unwrap_err(), Error::NoSuch { element: Element::Bridge, index: 0, count: 2 });
    assert!(!is_hidden(&twice, 2, 8) && has_cell(&twice.bridges()[0], 2, 8) && !has_cell(&twice.bridges()[0], 5, 8));
    assert_eq!(concatenate_all(&[], &strict, &job()).unwrap_err(), Error::EmptyScene);
}

#[test]
fn edits_survive_splitting() {
    // Nets of different sizes, so that copies must be removed; nodes move and gluing changes while
    // they are joined.
    let (a, b) = (sphere(5, 9, Scalar::F64, DVec3::ZERO), torus(8, 9, Scalar::F64, DVec3::ZERO));
    for direction in DIRECTIONS {
        let options = JoinOptions { equalise: Some(Replication::Last), ..JoinOptions::new(direction) };
        let mut joined = concatenate(&a, &b, &options, &job()).unwrap();
        joined.coordinates_mut().set(2, 3, DVec3::splat(7.0));
        let [first, second] = joined.split(0, &job()).unwrap();
        assert_eq!(first.get(2, 3), DVec3::splat(7.0));
        assert_eq!((first.topology(), second.topology()), (a.topology(), b.topology()));
        let mut matrix = joined.topology().to_link_matrix().unwrap();
        matrix.set_contracted(2 * joined.shape().node(2, 3), true);
        let links = ContractedLinks::Matrix(matrix);
        joined.set_topology(Topology::new(joined.shape(), links, joined.topology().seams()).unwrap());
        let [first, second] = joined.split(0, &job()).unwrap();
        assert!(first.topology().is_contracted(2 * first.shape().node(2, 3)));
        assert_eq!((first.shape(), second.topology()), (a.shape(), b.topology()));
    }
}

/// A link between columns that is glued in the last column only, which is the first again.
#[test]
fn turning_keeps_what_the_closing_column_alone_says() {
    let tube = Topology::from_sides(shape(4, 6), Sides::TUBE);
    let glued = tube.glued(&[Gluing::Link(2 * shape(4, 6).node(1, 5) + 1)]).unwrap();
    let [a, b] = [tube, glued]
        .map(|topology| Net::from_fn(topology, Scalar::F64, |i, j| DVec3::new((j % 5) as f64, i as f64, 0.0)).unwrap());
    for twist in 0..7 {
        let joined = concatenate(&a, &b, &JoinOptions { twist, ..options(Direction::Down) }, &job()).unwrap();
        let surface = Surface::from_net(&joined);
        let triangles = surface.polygons.iter().filter(|polygon| polygon.len() == 3).count();
        assert_eq!((surface.counts()[..2].to_vec(), triangles), (vec![39, 74], 2), "twist {twist}");
        let [first, second] = joined.split(0, &job()).unwrap();
        assert!(same(&first, &a) && same(&second, &b));
    }
}
