//! Streams of scenes: what comes back, and what becomes of damaged ones.

use crate::stream::{MODES, assert_same, job, noise, torus};
use glam::{DAffine3, DMat3, DVec3};
use gusset::Error;
use gusset::job::Job;
use gusset::mesh::Scalar;
use gusset::net::scene::{EntryContent, Scene, decode_scene_within, encode_scene};
use gusset::net::stream::{StreamMode, StreamOptions};
use gusset::net::{Direction, JoinOptions};
use proptest::prelude::*;
use std::sync::Arc;

const HEADER_SIZE: usize = 40;

fn lossless() -> StreamOptions {
    StreamOptions::new(StreamMode::Lossless)
}

fn decode(bytes: &[u8]) -> Result<Scene, Error> {
    decode_scene_within(bytes, u64::MAX, &job())
}

/// A scene of random edits: nets that entries share, groups, removed entries, hidden ones and transforms.
fn scene_of_edits(edits: &[(u8, u32, u32, f64)]) -> Scene {
    let nets =
        [torus(5, 7, Scalar::F32, 0.1), torus(4, 9, Scalar::F64, 0.3), torus(3, 3, Scalar::F64, 0.0)].map(Arc::new);
    let mut scene = Scene::new();
    for &(edit, a, b, number) in edits {
        let [a, b] = [a, b].map(|k| k % (scene.len() as u32 + 1));
        // Edits of entries that do not exist, and cycles, are refused.
        let _ = match edit % 9 {
            0 | 1 => scene.add_net(Arc::clone(&nets[a as usize % nets.len()])).map(drop),
            2 | 3 => scene.add_group().map(drop),
            4 | 5 => scene.add_child(a, b),
            6 => scene.set_visible(a, number > 0.0),
            7 => {
                let turn = DMat3::from_axis_angle(DVec3::new(0.6, 0.0, 0.8), number);
                scene.set_transform(a, DAffine3::from_mat3_translation(turn, DVec3::new(number, -0.0, 1e300)))
            }
            _ => scene.remove(a),
        };
    }
    scene
}

fn assert_same_scene(a: &Scene, b: &Scene) {
    assert_eq!(a.len(), b.len());
    let mut pairs: Vec<[*const gusset::net::Net<'static>; 2]> = Vec::new();
    for k in 0..a.len() as u32 {
        let (Ok(content), Ok(back)) = (a.content(k), b.content(k)) else {
            assert!(a.content(k).is_err() && b.content(k).is_err(), "entry {k}");
            continue;
        };
        let bits = |scene: &Scene| scene.transform(k).unwrap().to_cols_array().map(f64::to_bits);
        assert_eq!((bits(a), a.is_visible(k)), (bits(b), b.is_visible(k)), "entry {k}");
        match (content, back) {
            (EntryContent::Net(net), EntryContent::Net(back)) => {
                assert_same(net, back);
                pairs.push([Arc::as_ptr(net), Arc::as_ptr(back)]);
            }
            (EntryContent::Group(children), EntryContent::Group(back)) => assert_eq!(children, back),
            other => panic!("entry {k}: {other:?}"),
        }
    }
    // Entries share a net exactly if they shared it before.
    for one in &pairs {
        assert!(pairs.iter().all(|other| (one[0] == other[0]) == (one[1] == other[1])));
    }
    assert_eq!(a.count_elements().unwrap(), b.count_elements().unwrap());
}

proptest! {
    #[test]
    fn scenes_come_back_bit_for_bit(edits in prop::collection::vec((any::<u8>(), 0..40u32, 0..40u32, -4.0..4.0), 0..60)) {
        let scene = scene_of_edits(&edits);
        for mode in [StreamMode::Lossless, StreamMode::Raw] {
            let options = StreamOptions::new(mode);
            let bytes = encode_scene(&scene, &options, &job()).unwrap();
            let mut back = decode(&bytes).unwrap();
            assert_same_scene(&scene, &back);
            prop_assert_eq!(&encode_scene(&back, &options, &job()).unwrap(), &bytes);
            // The groups of an entry come back, too: they keep a group from containing itself.
            for (k, by) in (0..scene.len() as u32).zip(1..) {
                let (refused, as_before) = (back.add_child(by % scene.len() as u32, k), scene_of_edits(&edits).add_child(by % scene.len() as u32, k));
                prop_assert_eq!(refused, as_before);
                if refused.is_ok() { break }
            }
        }
    }
}

/// A wheel on both sides of an axle, and the axle twice.
fn two_axles() -> Scene {
    let (mut scene, wheel) = (Scene::new(), Arc::new(torus(9, 13, Scalar::F64, 0.2)));
    let (car, axle) = (scene.add_group().unwrap(), scene.add_group().unwrap());
    for side in [-1.0, 1.0] {
        let own = scene.add_net(Arc::clone(&wheel)).unwrap();
        scene.set_transform(own, DAffine3::from_translation(DVec3::Z * side)).unwrap();
        scene.add_child(axle, own).unwrap();
    }
    scene.add_child(car, axle).unwrap();
    scene.add_child(car, axle).unwrap();
    scene
}

#[test]
fn shared_nets_have_one_stream() {
    let scene = two_axles();
    for mode in MODES {
        let options = StreamOptions::new(mode);
        let bytes = encode_scene(&scene, &options, &job()).unwrap();
        let alone = gusset::net::stream::encode(scene.net(2).unwrap(), &options, &job()).unwrap();
        assert!(bytes.len() < alone.len() + 500, "{} {}", bytes.len(), alone.len());
        let at = bytes.windows(8).position(|window| window == &alone[..8]).unwrap();
        assert!(at % 64 == 0 && bytes[at..at + alone.len()] == alone[..]);
        let back = decode(&bytes).unwrap();
        assert!(Arc::ptr_eq(back.net(2).unwrap(), back.net(3).unwrap()));
        let flat = |scene: &Scene| scene.flatten(&JoinOptions::new(Direction::Down), &job()).unwrap();
        if mode != (StreamMode::Quantised { bits: 14 }) {
            assert_same(&flat(&scene), &flat(&back));
        }
        // The same bytes for any number of threads.
        for threads in 1..4 {
            let job = Job::new(threads, &crate::common::Silent);
            assert_eq!(encode_scene(&scene, &options, &job).unwrap(), bytes);
            assert_same_scene(&decode_scene_within(&bytes, u64::MAX, &job).unwrap(), &back);
        }
    }
}

#[test]
fn a_chain_of_a_million_groups_comes_back() {
    let mut scene = Scene::new();
    for k in 0..1_000_000u32 {
        scene.add_group().unwrap();
        if k > 0 {
            scene.add_child(k - 1, k).unwrap();
        }
    }
    let bytes = encode_scene(&scene, &lossless(), &job()).unwrap();
    assert!(bytes.len() < 5_100_000, "{}", bytes.len());
    let back = decode(&bytes).unwrap();
    assert_eq!(back.count_elements().unwrap(), scene.count_elements().unwrap());
    let empty = encode_scene(&Scene::new(), &lossless(), &job()).unwrap();
    assert!(decode(&empty).unwrap().is_empty());
}

#[test]
fn limits_hold_for_all_nets_together() {
    let mut scene = two_axles();
    scene.add_net(Arc::new(torus(4, 5, Scalar::F32, 0.0))).unwrap();
    let bytes = encode_scene(&scene, &lossless(), &job()).unwrap();
    let nodes = 9 * 13 + 4 * 5;
    assert!(decode_scene_within(&bytes, nodes, &job()).is_ok());
    let refused = decode_scene_within(&bytes, nodes - 1, &job()).unwrap_err();
    assert_eq!(refused, Error::TooLarge { what: "nodes", count: nodes, limit: nodes - 1 });
}

/// Corrects the checksums of the table and the header.
fn forge(bytes: &mut [u8]) {
    if bytes.len() < HEADER_SIZE {
        return;
    }
    let size = u64::from_le_bytes(bytes[24..32].try_into().unwrap()) as usize;
    if let Some(table) = bytes[HEADER_SIZE..].get(..size) {
        let sum = crc32fast::hash(table);
        bytes[32..36].copy_from_slice(&sum.to_le_bytes());
    }
    let sum = crc32fast::hash(&bytes[..36]);
    bytes[36..40].copy_from_slice(&sum.to_le_bytes());
}

#[test]
fn damaged_streams_are_refused() {
    let bytes = encode_scene(&two_axles(), &lossless(), &job()).unwrap();
    for length in 0..bytes.len() {
        assert!(matches!(decode(&bytes[..length]), Err(Error::BadStream { .. })), "cut at {length}");
    }
    for at in 0..bytes.len() {
        for flip in [1, 0x80, 0xff] {
            let mut bad = bytes.clone();
            bad[at] ^= flip;
            match decode(&bad) {
                Err(Error::BadStream { byte, .. }) => assert!(byte <= bytes.len() as u64),
                other => panic!("byte {at} ^ {flip}: {other:?}"),
            }
        }
    }
    assert!(matches!(decode(&[&bytes[..], &[0; 64]].concat()), Err(Error::BadStream { .. })));
}

#[test]
fn forged_streams_do_no_harm() {
    let bytes = encode_scene(&two_axles(), &lossless(), &job()).unwrap();
    let table = u64::from_le_bytes(bytes[24..32].try_into().unwrap()) as usize;
    let (mut refused, mut taken) = (0, 0);
    for at in 8..HEADER_SIZE + table {
        for k in 0..24 {
            let mut bad = bytes.clone();
            bad[at] = (noise(at as u64, k) * 256.0) as u8;
            forge(&mut bad);
            match decode(&bad) {
                Err(Error::BadStream { .. }) => refused += 1,
                // A different transform, visibility or child.
                Ok(scene) => {
                    scene.count_elements().unwrap();
                    assert_eq!(encode_scene(&scene, &lossless(), &job()).unwrap(), bad, "byte {at}");
                    taken += 1;
                }
                Err(error) => panic!("{error}"),
            }
        }
    }
    assert!(refused > 500 && taken > 100, "{refused} {taken}");
    // Groups that contain each other: the children of the axle, entry 1, become the car.
    let mut scene = two_axles();
    scene.remove(2).unwrap();
    scene.remove(3).unwrap();
    scene.add_child(1, 0).unwrap_err();
    let mut looped = encode_scene(&scene, &lossless(), &job()).unwrap();
    let entries: Vec<u8> = looped[HEADER_SIZE..HEADER_SIZE + 8].to_vec();
    assert_eq!(entries, [7, 2, 1, 1, 7, 0, 0, 0]);
    looped[HEADER_SIZE + 2] = 0;
    forge(&mut looped);
    assert!(matches!(decode(&looped), Err(Error::BadStream { byte: 40, .. })));
}
