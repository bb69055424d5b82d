//! Scenes: groups, instances, flattening.

use crate::nets::{Surface, any_topology, job, numbered, same, shape, sphere, torus};
use glam::{DAffine3, DVec3};
use gusset::mesh::Scalar;
use gusset::net::scene::{EntryChanges, Instance, MAX_INSTANCES, Scene};
use gusset::net::{BridgeMode, Direction, JoinOptions, Net, Sides, Topology, concatenate};
use gusset::{Element, Error};
use proptest::prelude::*;
use std::sync::Arc;

fn hidden(direction: Direction) -> JoinOptions {
    JoinOptions { mode: BridgeMode::Hide, ..JoinOptions::new(direction) }
}

fn along_x(x: f64) -> DAffine3 {
    DAffine3::from_translation(DVec3::new(x, 0.0, 0.0))
}

/// The nets that are entries, each once, in order of their indices.
fn nets(scene: &Scene) -> Vec<&Net<'static>> {
    (0..scene.len() as u32).filter_map(|entry| scene.net(entry).ok()).map(|net| &**net).collect()
}

/// True if `entry` is below `group`, by force.
fn is_below(scene: &Scene, group: u32, entry: u32) -> bool {
    let children = scene.children(group).unwrap_or_default();
    children.iter().any(|&child| child == entry || is_below(scene, child, entry))
}

proptest! {
    #[test]
    fn cycles_are_refused_and_nothing_else(edges in prop::collection::vec((0..9u32, 0..9u32, any::<bool>()), 0..60)) {
        let mut scene = Scene::new();
        (0..9).for_each(|k| assert_eq!(scene.add_group(), Ok(k)));
        for (group, child, remove) in edges {
            if remove && scene.children(group).unwrap().contains(&child) {
                scene.remove_child(group, child).unwrap();
            }
            let cycle = group == child || is_below(&scene, child, group);
            let done = scene.add_child(group, child);
            prop_assert_eq!(done, if cycle { Err(Error::SceneCycle { entry: child }) } else { Ok(()) });
        }
        let counts = scene.count_elements().unwrap();
        if counts.instances <= 10_000 {
            let instances = scene.instances(&job()).unwrap();
            prop_assert_eq!(instances.len() as u64, counts.instances);
            let level = |at: &Instance| {
                let (mut at, mut level) = (*at, 1);
                while let Some(&parent) = instances.get(at.parent as usize) {
                    assert!(scene.children(parent.entry).unwrap().contains(&at.entry));
                    (at, level) = (parent, level + 1);
                }
                level
            };
            prop_assert_eq!(instances.iter().map(level).max().unwrap_or(0), counts.levels);
        }
    }

    #[test]
    fn flat_scenes_come_apart(
        topologies in prop::collection::vec(any_topology(2..6, 2..6), 1..6),
        right in any::<bool>(),
    ) {
        let direction = if right { Direction::Right } else { Direction::Down };
        let mut scene = Scene::new();
        let group = scene.add_group().unwrap();
        for topology in topologies {
            let net = scene.add_net(Arc::new(numbered(topology, Scalar::F32))).unwrap();
            scene.add_child(group, net).unwrap();
        }
        let flat = scene.flatten(&hidden(direction), &job()).unwrap();
        let back = Scene::from_flat_net(&flat, direction, &job()).unwrap();
        let (before, after) = (nets(&scene), nets(&back));
        prop_assert_eq!(before.len(), after.len());
        prop_assert!(before.iter().zip(&after).all(|(a, b)| same(a, b)));
    }
}

#[test]
fn nets_that_were_joined_before_stay_joined() {
    for direction in [Direction::Right, Direction::Down] {
        let two = [sphere(5, 7, Scalar::F64, DVec3::ZERO), torus(5, 7, Scalar::F64, DVec3::X)];
        let pair = concatenate(&two[0], &two[1], &JoinOptions::new(direction), &job()).unwrap();
        let mut scene = Scene::new();
        let group = scene.add_group().unwrap();
        for net in [pair.copied().unwrap(), sphere(4, 7, Scalar::F64, DVec3::Y), pair.copied().unwrap()] {
            let net = scene.add_net(Arc::new(net)).unwrap();
            scene.add_child(group, net).unwrap();
        }
        let flat = scene.flatten(&hidden(direction), &job()).unwrap();
        let back = Scene::from_flat_net(&flat, direction, &job()).unwrap();
        let nets = nets(&back);
        assert_eq!(nets.len(), 3);
        assert!(same(nets[0], &pair) && same(nets[2], &pair));
        let [a, b] = nets[0].split(0, &job()).unwrap();
        assert!(same(&a, &two[0]) && same(&b, &two[1]));
    }
}

#[test]
fn a_million_levels() {
    for (top_down, levels) in [(true, 1_000_000u32), (false, 200_000)] {
        let mut scene = Scene::new();
        let net = scene.add_net(Arc::new(sphere(3, 5, Scalar::F32, DVec3::ZERO))).unwrap();
        let groups: Vec<u32> = (0..levels).map(|_| scene.add_group().unwrap()).collect();
        for pair in groups.windows(2) {
            let [group, child] = if top_down { [pair[0], pair[1]] } else { [pair[1], pair[0]] };
            scene.add_child(group, child).unwrap();
            scene.set_transform(child, along_x(1.0)).unwrap();
        }
        let (first, last) = if top_down { (0, levels - 1) } else { (levels - 1, 0) };
        let (first, last) = (groups[first as usize], groups[last as usize]);
        scene.add_child(last, net).unwrap();
        assert_eq!(scene.add_child(last, first), Err(Error::SceneCycle { entry: first }));
        let counts = scene.count_elements().unwrap();
        assert_eq!((counts.levels, counts.instances, counts.net_instances), (levels + 1, u64::from(levels) + 1, 1));
        let instances = scene.instances(&job()).unwrap();
        assert_eq!(instances[levels as usize].world, along_x(f64::from(levels - 1)));
        let flat = scene.flatten(&hidden(Direction::Down), &job()).unwrap();
        assert_eq!(flat.get(0, 0), DVec3::new(f64::from(levels - 1), 0.0, -1.0));
        drop(scene);
    }
}

#[test]
fn instances_that_explode_are_counted_and_not_listed() {
    let mut scene = Scene::new();
    let net = scene.add_net(Arc::new(sphere(3, 5, Scalar::F32, DVec3::ZERO))).unwrap();
    let mut below = net;
    for _ in 0..200 {
        let group = scene.add_group().unwrap();
        scene.add_child(group, below).unwrap();
        scene.add_child(group, below).unwrap();
        below = group;
    }
    let too_large = Error::TooLarge { what: "instances", count: u64::MAX, limit: MAX_INSTANCES };
    assert_eq!(scene.count_elements().unwrap().instances, u64::MAX);
    assert_eq!(scene.instances(&job()).unwrap_err(), too_large);
    assert_eq!(scene.flatten(&hidden(Direction::Down), &job()).unwrap_err(), too_large);
}

#[test]
fn mirrors_are_mirrors_at_any_size() {
    for x in [1.0, -1.0] {
        let flat = [1.0, 1e-120, 1e120].map(|size| {
            let mut scene = Scene::new();
            let ball = scene.add_net(Arc::new(sphere(5, 9, Scalar::F64, DVec3::ZERO))).unwrap();
            scene.set_transform(ball, DAffine3::from_scale(size * DVec3::new(x, 1.0, 1.0))).unwrap();
            scene.flatten(&hidden(Direction::Down), &job()).unwrap()
        });
        for net in &flat {
            assert_eq!(net.topology(), flat[0].topology(), "{x}");
        }
        assert!(Surface::from_net(&flat[0]).volume(&flat[0]) > 1.0);
    }
}

#[test]
fn entries_change_as_a_whole() {
    let mut scene = Scene::new();
    let (ball, group) =
        (scene.add_net(Arc::new(sphere(5, 9, Scalar::F64, DVec3::ZERO))).unwrap(), scene.add_group().unwrap());
    let ring = Arc::new(torus(7, 9, Scalar::F64, DVec3::ZERO));
    let all = |x: f64| EntryChanges { net: Some(ring.clone()), transform: Some(along_x(x)), visible: Some(false) };
    let no_such = Error::NoSuch { element: Element::Entry, index: group.into(), count: scene.len() as u64 };
    assert_eq!(scene.set_entry(group, all(1.0)), Err(no_such), "a group has no net");
    assert!(matches!(scene.set_entry(ball, all(f64::NAN)), Err(Error::OptionOutOfRange { .. })));
    for entry in [ball, group] {
        assert!(scene.is_visible(entry).unwrap() && scene.transform(entry).unwrap() == DAffine3::IDENTITY);
    }
    assert_eq!(scene.net(ball).unwrap().shape(), shape(5, 9));
    scene.set_entry(ball, all(1.0)).unwrap();
    scene.set_entry(ball, EntryChanges::default()).unwrap();
    assert!(!scene.is_visible(ball).unwrap() && scene.transform(ball).unwrap() == along_x(1.0));
    assert_eq!(scene.net(ball).unwrap().shape(), shape(7, 9));
    scene.set_entry(group, EntryChanges { visible: Some(false), ..EntryChanges::default() }).unwrap();
    assert!(!scene.is_visible(group).unwrap());
    assert!(scene.set_entry(9, EntryChanges::default()).is_err());
}

#[test]
fn where_things_are() {
    let mut scene = Scene::new();
    let ball = scene.add_net(Arc::new(sphere(5, 9, Scalar::F64, DVec3::ZERO))).unwrap();
    let ring = scene.add_net(Arc::new(torus(7, 9, Scalar::F64, DVec3::ZERO))).unwrap();
    let [pair, left, right, all] = [(); 4].map(|()| scene.add_group().unwrap());
    for (group, child) in [(pair, ball), (pair, ring), (left, pair), (right, pair), (all, left), (all, right)] {
        scene.add_child(group, child).unwrap();
    }
    scene.set_transform(left, along_x(-10.0)).unwrap();
    // A mirror: faces must keep their outside.
    scene.set_transform(right, along_x(10.0) * DAffine3::from_scale(DVec3::new(-1.0, 1.0, 1.0))).unwrap();
    scene.set_transform(ring, DAffine3::from_rotation_z(0.5)).unwrap();
    let counts = scene.count_elements().unwrap();
    assert_eq!((counts.nets, counts.groups, counts.instances, counts.net_instances, counts.levels), (2, 4, 9, 4, 4));
    for direction in [Direction::Down, Direction::Right] {
        let flat = scene.flatten(&hidden(direction), &job()).unwrap();
        let mut instances = scene.instances(&job()).unwrap();
        instances.retain(|instance| scene.net(instance.entry).is_ok());
        let entries: Vec<u32> = instances.iter().map(|instance| instance.entry).collect();
        assert_eq!(entries, [ball, ring, ball, ring]);
        let surface = Surface::from_net(&flat);
        assert_eq!((surface.euler(), surface.edge_faces().into_keys().collect::<Vec<_>>()), (4, vec![2]));
        let volume = |net: &Net<'_>| Surface::from_net(net).volume(net);
        let own = volume(scene.net(ball).unwrap()) + volume(scene.net(ring).unwrap());
        assert!((surface.volume(&flat) - 2.0 * own).abs() < 1e-9, "mirrored nets count as others");
        let back = flat.split_all(direction, &job()).unwrap();
        let nets = entries.iter().map(|&entry| scene.net(entry).unwrap());
        for ((part, net), instance) in back.iter().zip(nets).zip(&instances) {
            let mirrored = instance.world.matrix3.determinant() < 0.0;
            assert_eq!(part.shape(), net.shape());
            assert_eq!(part.topology(), &net.topology().clone().with_reversed(mirrored));
            assert!((part.get(1, 2) - instance.world.transform_point3(net.get(1, 2))).length() < 1e-12);
        }
    }
    scene.set_visible(left, false).unwrap();
    let flat = scene.flatten(&hidden(Direction::Down), &job()).unwrap();
    assert_eq!(flat.split_all(Direction::Down, &job()).unwrap().len(), 2);
    scene.set_visible(all, false).unwrap();
    assert_eq!(scene.flatten(&hidden(Direction::Down), &job()).unwrap_err(), Error::EmptyScene);
    scene.remove(pair).unwrap();
    assert!(scene.children(left).unwrap().is_empty());
    assert_eq!(
        scene.content(pair).unwrap_err(),
        Error::NoSuch { element: Element::Entry, index: pair.into(), count: scene.len() as u64 }
    );
    assert_eq!(scene.count_elements().unwrap().instances, 5);
    assert_eq!(
        scene.net(left).unwrap_err(),
        Error::NoSuch { element: Element::Entry, index: left.into(), count: scene.len() as u64 }
    );
    assert_eq!(
        scene.add_child(ball, ring).unwrap_err(),
        Error::NoSuch { element: Element::Entry, index: ball.into(), count: scene.len() as u64 }
    );
    assert_eq!(
        scene.remove_child(all, ball).unwrap_err(),
        Error::NoSuch { element: Element::Entry, index: ball.into(), count: scene.len() as u64 }
    );
    assert!(scene.set_transform(all, along_x(f64::NAN)).is_err());
}

#[test]
fn a_hundred_thousand_nets() {
    let mut scene = Scene::new();
    for k in 0..100_000u32 {
        let topology = Topology::from_sides(shape(8, 8), Sides::TORUS);
        let net = Net::from_fn(topology, Scalar::F32, |i, j| DVec3::new(k.into(), (i % 7) as f64, (j % 7) as f64));
        scene.add_net(Arc::new(net.unwrap())).unwrap();
    }
    let flat = scene.flatten(&hidden(Direction::Down), &job()).unwrap();
    assert_eq!((flat.shape(), flat.bridges().len()), (shape(800_000, 8), 99_999));
    let back = flat.split_all(Direction::Down, &job()).unwrap();
    assert!(nets(&scene).iter().zip(&back).step_by(997).all(|(a, b)| same(a, b)));
}
