//! Parts, transposed and flipped nets, quarter turns.

use crate::nets::{Surface, any_topology, job, numbered, same, sphere, torus};
use glam::DVec3;
use gusset::mesh::Scalar;
use gusset::net::{CopyOptions, Direction, GridSymmetry, Net, NodeClasses, Replication};
use gusset::{Allowed, Error};
use proptest::prelude::*;

/// The classes of a net as a partition of places, which `place` takes to places of another net.
fn partition(net: &Net<'_>, place: impl Fn(usize, usize) -> (usize, usize)) -> Vec<Vec<(usize, usize)>> {
    let classes = NodeClasses::new(net.topology()).unwrap();
    let shape = net.shape();
    let mut parts: std::collections::BTreeMap<u32, Vec<(usize, usize)>> = Default::default();
    for node in 0..shape.node_count() as u32 {
        let (i, j) = shape.row_and_column(node);
        parts.entry(classes.representative(node)).or_default().push(place(i, j));
    }
    let mut parts: Vec<Vec<_>> = parts.into_values().collect();
    parts.iter_mut().for_each(|part| part.sort_unstable());
    parts.sort_unstable();
    parts
}

fn bits(p: DVec3) -> [u64; 3] {
    p.to_array().map(f64::to_bits)
}

proptest! {
    #[test]
    fn exchanges_are_their_own_inverses(topology in any_topology(2..7, 2..7)) {
        let net = numbered(topology, Scalar::F32);
        let (h, w) = (net.shape().rows(), net.shape().columns());
        let (rows, columns) = (net.flipped(Direction::Down, &job()).unwrap(), net.flipped(Direction::Right, &job()).unwrap());
        let turned = net.transposed(&job()).unwrap();
        for (other, place) in [
            (&rows, Box::new(move |i, j| (h - 1 - i, j)) as Box<dyn Fn(usize, usize) -> (usize, usize)>),
            (&columns, Box::new(move |i, j| (i, w - 1 - j))),
            (&turned, Box::new(|i, j| (j, i))),
        ] {
            for i in 0..h {
                for j in 0..w {
                    let (p, q) = place(i, j);
                    prop_assert_eq!(bits(net.get(i, j)), bits(other.get(p, q)));
                }
            }
            prop_assert_eq!(partition(&net, place), partition(other, |i, j| (i, j)));
            prop_assert!(other.topology().is_reversed() != net.topology().is_reversed());
        }
        prop_assert!(same(&rows.flipped(Direction::Down, &job()).unwrap(), &net));
        prop_assert!(same(&columns.flipped(Direction::Right, &job()).unwrap(), &net));
        prop_assert!(same(&turned.transposed(&job()).unwrap(), &net));
        let once = net.turned_by_quarters(1, &job()).unwrap();
        prop_assert_eq!(bits(once.get(0, 0)), bits(net.get(0, w - 1)));
        prop_assert!(same(&once.turned_by_quarters(-1, &job()).unwrap(), &net));
        prop_assert!(same(&once.turned_by_quarters(1, &job()).unwrap(), &net.turned_by_quarters(2, &job()).unwrap()));
        prop_assert!(same(&once.turned_by_quarters(2, &job()).unwrap(), &net.turned_by_quarters(3, &job()).unwrap()));
    }

    #[test]
    fn parts_keep_bits_and_what_is_glued_within(topology in any_topology(3..8, 3..8), cut in any::<[u8; 4]>()) {
        let net = numbered(topology, Scalar::F64);
        let range = |count: usize, a: u8, b: u8| {
            let start = a as usize % (count - 1);
            start..start + 2 + b as usize % (count - 1 - start)
        };
        let (rows, columns) = (range(net.shape().rows(), cut[0], cut[1]), range(net.shape().columns(), cut[2], cut[3]));
        let part = match net.sub_net(rows.clone(), columns.clone(), &job()) {
            Err(Error::CrossingCell { .. }) => return Ok(()),
            part => part.unwrap(),
        };
        for (i, row) in rows.clone().enumerate() {
            for (j, column) in columns.clone().enumerate() {
                prop_assert_eq!(bits(part.get(i, j)), bits(net.get(row, column)));
            }
        }
        // By force: classes of the links and pairs with both ends within.
        let inside = |node: u32| {
            let (i, j) = net.shape().row_and_column(node);
            rows.contains(&i) && columns.contains(&j)
        };
        let links = (0..2 * net.shape().node_count() as u32).filter(|&link| net.topology().is_contracted(link));
        let pairs = links.map(|link| net.shape().ends_of_link(link));
        let sewn = net.topology().seams().iter().flat_map(|seam| seam.pairs(net.shape()));
        let pairs: Vec<[u32; 2]> = pairs.chain(sewn).filter(|pair| pair.iter().all(|&node| inside(node))).collect();
        let mut class: Vec<u32> = (0..net.shape().node_count() as u32).collect();
        for _ in 0..class.len() {
            for &[a, b] in &pairs {
                let least = class[a as usize].min(class[b as usize]);
                (class[a as usize], class[b as usize]) = (least, least);
            }
        }
        let classes = NodeClasses::new(part.topology()).unwrap();
        for node in 0..part.shape().node_count() as u32 {
            let (i, j) = part.shape().row_and_column(node);
            let (p, q) = part.shape().row_and_column(classes.representative(node));
            let old = net.shape().node(rows.start + i, columns.start + j);
            prop_assert_eq!(class[old as usize], net.shape().node(rows.start + p, columns.start + q));
        }
    }
}

#[test]
fn a_copy_takes_its_steps_in_order() {
    let net = torus(9, 17, Scalar::F64, DVec3::ZERO);
    let copy = |options: &CopyOptions| net.changed_copy(options, &job()).unwrap();
    assert!(copy(&CopyOptions::default()).is_none());
    assert!(copy(&CopyOptions { scalar: Some(Scalar::F64), ..CopyOptions::default() }).is_none());
    let options = CopyOptions {
        part: Some([2..7, 3..15]),
        compact: true,
        rows: Some(8),
        columns: None,
        replication: [Replication::First, Replication::Uniform],
        turn: GridSymmetry::ThreeQuarters,
        scalar: Some(Scalar::F32),
    };
    let part = net.sub_net(2..7, 3..15, &job()).unwrap().compacted(&job()).unwrap();
    let larger = part.enlarged_to(8, 12, options.replication, &job()).unwrap();
    let expected = larger.turned_by_quarters(3, &job()).unwrap().converted(Scalar::F32).unwrap();
    assert!(same(&copy(&options).unwrap(), &expected));
    // The symmetries are a group: the two exchanges differ by half a turn.
    let turned = |net: &Net<'_>, turn| net.apply_symmetry(turn, &job()).unwrap();
    assert!(same(&turned(&net, GridSymmetry::None), &net));
    assert!(same(
        &turned(&turned(&net, GridSymmetry::Transpose), GridSymmetry::Half),
        &turned(&net, GridSymmetry::Antitranspose)
    ));
    assert!(same(
        &turned(&turned(&net, GridSymmetry::FlipRows), GridSymmetry::FlipColumns),
        &turned(&net, GridSymmetry::Half)
    ));
    assert!(same(&turned(&turned(&net, GridSymmetry::Quarter), GridSymmetry::ThreeQuarters), &net));
    assert!(same(&turned(&turned(&net, GridSymmetry::Antitranspose), GridSymmetry::Antitranspose), &net));
}

#[test]
fn volumes_keep_their_sign() {
    for net in [sphere(9, 17, Scalar::F64, DVec3::ONE), torus(9, 17, Scalar::F64, DVec3::ZERO)] {
        let volume = Surface::from_net(&net).volume(&net);
        assert!(volume > 1.0);
        let turned = [1, 2, 3].map(|quarters| net.turned_by_quarters(quarters, &job()).unwrap());
        let others =
            [net.transposed(&job()), net.flipped(Direction::Down, &job()), net.flipped(Direction::Right, &job())];
        for other in turned.into_iter().chain(others.into_iter().map(Result::unwrap)) {
            assert!((Surface::from_net(&other).volume(&other) - volume).abs() < 1e-12 * volume);
            assert!(other.topology().sides().is_some(), "no matrix where there was none");
        }
    }
}

#[test]
fn parts_beyond_the_net_are_refused() {
    let net = sphere(5, 9, Scalar::F32, DVec3::ZERO);
    assert_eq!(
        net.sub_net(0..6, 0..9, &job()).unwrap_err(),
        Error::OptionOutOfRange { option: "rows", value: 6.0, allowed: Allowed::AtMost(5.0) }
    );
    let backwards = std::ops::Range { start: 5, end: 2 };
    assert_eq!(
        net.sub_net(0..5, backwards, &job()).unwrap_err(),
        Error::OptionOutOfRange { option: "columns", value: 5.0, allowed: Allowed::AtMost(2.0) }
    );
    assert_eq!(net.sub_net(0..5, 3..4, &job()).unwrap_err(), Error::NetTooSmall { rows: 5, columns: 1 });
    assert_eq!(
        net.sub_net(0..3, 0..9, &job()).unwrap().topology().sides().unwrap(),
        gusset::net::Sides { pole_bottom: false, ..gusset::net::Sides::TWO_POLES }
    );
}
