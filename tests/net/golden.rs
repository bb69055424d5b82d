//! Committed streams of every mode, decoded to the nets that they were made of: the format
//! persists, so that a reader of today's streams must stay. Coordinates are integers in all but the
//! wild ones, hence exact in every mode.
//!
//! `GUSSET_UPDATE=1 cargo test --test net golden::` writes those that are missing; none that is
//! there is ever written anew.

use glam::DVec3;
use gusset::Job;
use gusset::mesh::Scalar;
use gusset::net::stream::{StreamDecoder, StreamMode, StreamOptions, decode, encode};
use gusset::net::topology::{ContractedLinks, LinkMatrix, SeamRun};
use gusset::net::{
    Bridge, BridgeKind, BridgeMode, BridgeProperties, Direction, Net, NodeClasses, Seam, Shape, Sides, Topology,
};
use std::path::Path;
use std::{env, fs};

const MODES: [(&str, StreamMode); 3] =
    [("raw", StreamMode::Raw), ("lossless", StreamMode::Lossless), ("quantised", StreamMode::Quantised { bits: 8 })];

/// A net whose glued nodes agree to the bit.
fn net(topology: Topology, scalar: Scalar, place: impl Fn(usize, usize) -> DVec3) -> Net<'static> {
    let classes = NodeClasses::new(&topology).unwrap();
    let shape = topology.shape();
    let first = |i, j| shape.row_and_column(classes.representative(shape.node(i, j)));
    Net::from_fn(topology, scalar, |i, j| {
        let (i, j) = first(i, j);
        place(i, j)
    })
    .unwrap()
}

/// Integers from 0 to 255, both of which occur on some axis: with 256 levels the step is 1.
fn integers(i: usize, j: usize) -> DVec3 {
    let (i, j) = (i as u32, j as u32);
    DVec3::from_array(
        [3 * i + 2 * j, i * i + j, 5 * i * j + 7 * j].map(|sum| f64::from(17 * ((sum + 15 * (i % 2)) % 16))),
    )
}

fn bridges() -> Vec<Bridge> {
    let properties = BridgeProperties { tension: 0.5, elasticity: -0.0, stiffness: f64::INFINITY, user: 77 };
    let mut tube = Bridge::new(Direction::Right, 4, 5, BridgeKind::Tube, BridgeMode::Hide);
    let mut thread = Bridge::new(Direction::Down, 6, 7, BridgeKind::Thread, BridgeMode::Weld);
    tube.properties = properties;
    (thread.start, thread.end) = (3, 5);
    vec![tube, thread]
}

/// A torus, a Möbius strip with links of its own and bridges, and a sheet of numbers of every kind.
fn nets() -> [(&'static str, Net<'static>); 3] {
    let shape = Shape::new(7, 8).unwrap();
    let torus = net(Topology::from_sides(shape, Sides::TORUS), Scalar::F32, integers);
    let mut matrix = LinkMatrix::empty(shape).unwrap();
    [0, 2, 4, 17, 23, 60, 88].into_iter().for_each(|link| matrix.set_contracted(link, true));
    let seam = Seam { a: SeamRun::along_column(0, 0, 1), b: SeamRun::along_column(6, 7, -1), count: 7 };
    let mut strip = net(Topology::new(shape, ContractedLinks::Matrix(matrix), &[seam]).unwrap(), Scalar::F64, integers);
    *strip.bridges_mut() = bridges();
    let numbers = [0.0, -0.0, 1.0, -1.5, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 5e-324, -3e-310, 1e300, 7e-46];
    let wild = |i: usize, j: usize| DVec3::from_array([0, 1, 2].map(|k| numbers[(7 * i + 5 * j + 3 * k) % 11]));
    let wild = net(Topology::from_sides(shape, Sides::SHEET), Scalar::F64, wild);
    [("torus", torus), ("strip", strip), ("wild", wild)]
}

fn assert_same(name: &str, expected: &Net<'_>, found: &Net<'_>) {
    assert_eq!((expected.topology(), expected.bridges()), (found.topology(), found.bridges()), "{name}");
    assert_eq!(expected.coordinates().scalar(), found.coordinates().scalar(), "{name}");
    for node in 0..expected.shape().node_count() as u32 {
        let (i, j) = expected.shape().row_and_column(node);
        let [expected, found] = [expected, found].map(|net| net.get(i, j).to_array().map(f64::to_bits));
        assert_eq!(expected, found, "{name}: node {i}, {j}");
    }
}

#[test]
fn streams_of_the_past_are_read() {
    let job = Job::default();
    let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join("tests/net/golden");
    for (kind, net) in nets() {
        // Numbers that are not finite lack levels.
        for (mode_name, mode) in MODES.into_iter().filter(|(name, _)| kind != "wild" || *name != "quantised") {
            let name = format!("{mode_name}-{kind}.stream");
            let path = folder.join(&name);
            if !path.exists() && env::var_os("GUSSET_UPDATE").is_some() {
                let options = StreamOptions { rows_per_block: 3, ..StreamOptions::new(mode) };
                fs::write(&path, encode(&net, &options, &job).unwrap()).unwrap();
            }
            let bytes = fs::read(&path).unwrap_or_else(|error| panic!("{name}: {error}"));
            assert_same(&name, &net, &decode(&bytes, &job).unwrap());
            let mut decoder = StreamDecoder::new(1 << 20);
            for piece in bytes.chunks(100) {
                decoder.decode_next_bytes(piece).unwrap();
            }
            assert_same(&name, &net, &decoder.finish().unwrap());
        }
    }
}
