//! Edits scenes beside a plain list of children for each group: equal children, no group within
//! itself, and as many instances as a walk along all paths finds.

use crate::agree::agreed;
use crate::input;
use glam::DVec3;
use gusset::Job;
use gusset::mesh::Scalar;
use gusset::net::scene::{EntryContent, Scene, decode_scene_within, encode_scene};
use gusset::net::stream::{StreamMode, StreamOptions};
use gusset::net::{Net, Shape, Sides, Topology};
use std::sync::Arc;

/// An entry as it should be: a net without children, or a group.
type Model = Vec<Option<Option<Vec<u32>>>>;

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some((edits, choice)) = input::taken::<(Vec<[u8; 3]>, u8)>(bytes) else { return };
    let topology = Topology::from_sides(Shape::new(2, 2).expect("a small shape"), Sides::SHEET);
    let place = |i: usize, j: usize| DVec3::new(i as f64, j as f64, 0.0);
    let net = Arc::new(Net::from_fn(topology, Scalar::F64, place).expect("a small net"));
    let (mut scene, mut model) = (Scene::new(), Model::new());
    for [what, a, b] in edits.into_iter().take(40) {
        let [a, b] = [a, b].map(|k| u32::from(k) % (model.len() as u32 + 1));
        match what % 8 {
            0 => enter(&mut model, scene.add_net(net.clone()).expect("memory"), None),
            1..=2 => enter(&mut model, scene.add_group().expect("memory"), Some(Vec::new())),
            3..=5 => {
                let allowed = children(&model, a).is_some() && is_entry(&model, b) && !reaches(&model, b, a);
                assert_eq!(scene.add_child(a, b).is_ok(), allowed, "{a} {b} {model:?}");
                if allowed {
                    model[a as usize].as_mut().and_then(Option::as_mut).expect("a group").push(b);
                }
            }
            6 => {
                if scene.remove(a).is_ok() {
                    model[a as usize] = None;
                    model.iter_mut().flatten().flatten().for_each(|list| list.retain(|&child| child != a));
                }
            }
            _ => {
                let had = children(&model, a).is_some_and(|list| list.contains(&b));
                assert_eq!(scene.remove_child(a, b).is_ok(), had);
            }
        }
        for (k, entry) in (0..).zip(&mut model) {
            if let (Some(Some(list)), Ok(EntryContent::Group(now))) = (entry, scene.content(k)) {
                // Which of several equal children goes is the scene's choice.
                let sorted = |list: &[u32]| {
                    let mut list = list.to_vec();
                    list.sort_unstable();
                    list
                };
                if what % 8 == 7 && k == a && list.contains(&b) {
                    list.remove(list.iter().position(|&child| child == b).expect("it is there"));
                }
                assert_eq!(sorted(list), sorted(now));
            }
        }
    }
    let encoded = |scene: &Scene| {
        encode_scene(scene, &StreamOptions::new(StreamMode::Lossless), &Job::default()).expect("a scene can be encoded")
    };
    let bytes = encoded(&scene);
    let back = decode_scene_within(&bytes, u64::MAX, &Job::default()).expect("what was encoded can be decoded");
    assert_eq!(encoded(&back), bytes);
    let counts = scene.count_elements().expect("memory");
    assert_eq!(back.count_elements(), Ok(counts));
    if counts.instances < 5000 {
        let listed = agreed(choice, |job| scene.instances(job)).expect("few instances");
        let roots = (0..model.len() as u32).filter(|&k| is_entry(&model, k) && !has_parent(&model, k));
        assert_eq!(listed.len(), roots.map(|k| paths(&model, k)).sum::<usize>());
        assert_eq!(counts.instances, listed.len() as u64);
    }
}

fn enter(model: &mut Model, index: u32, content: Option<Vec<u32>>) {
    let index = index as usize;
    if index == model.len() {
        model.push(None);
    }
    assert!(model[index].is_none(), "an index in use");
    model[index] = Some(content);
}

fn is_entry(model: &Model, k: u32) -> bool {
    matches!(model.get(k as usize), Some(Some(_)))
}

fn children(model: &Model, k: u32) -> Option<&Vec<u32>> {
    model.get(k as usize)?.as_ref()?.as_ref()
}

fn reaches(model: &Model, from: u32, to: u32) -> bool {
    from == to || children(model, from).is_some_and(|list| list.iter().any(|&child| reaches(model, child, to)))
}

fn has_parent(model: &Model, k: u32) -> bool {
    model.iter().flatten().flatten().any(|list| list.contains(&k))
}

fn paths(model: &Model, k: u32) -> usize {
    1 + children(model, k).map_or(0, |list| list.iter().map(|&child| paths(model, child)).sum())
}
