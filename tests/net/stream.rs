//! Streams of nets: what comes back, how small they are, and what becomes of damaged ones.

use crate::common::Silent;
use glam::DVec3;
use gusset::Error;
use gusset::job::Job;
use gusset::mesh::Scalar;
use gusset::net::stream::{StreamDecoder, StreamInfo, StreamMode, StreamOptions, decode, encode};
use gusset::net::topology::{ContractedLinks, LinkMatrix, SeamRun};
use gusset::net::{
    Bridge, BridgeKind, BridgeMode, BridgeProperties, Coordinates, Direction, JoinOptions, Net, NodeClasses, Seam,
    Shape, Sides, Topology, XyzMatrices, concatenate,
};
use proptest::prelude::*;

pub(crate) const MODES: [StreamMode; 3] = [StreamMode::Raw, StreamMode::Lossless, StreamMode::Quantised { bits: 14 }];

pub(crate) fn job() -> Job<'static> {
    Job::default()
}

/// The bits of all coordinates, matrix after matrix.
pub(crate) fn bits(net: &Net<'_>) -> Vec<u64> {
    let shape = net.shape();
    let nodes = || (0..shape.rows()).flat_map(|i| (0..shape.columns()).map(move |j| (i, j)));
    match net.coordinates() {
        Coordinates::F32(planes) => {
            (0..3).flat_map(|k| nodes().map(move |(i, j)| u64::from(planes.row(i)[k][j].to_bits()))).collect()
        }
        Coordinates::F64(planes) => {
            (0..3).flat_map(|k| nodes().map(move |(i, j)| planes.row(i)[k][j].to_bits())).collect()
        }
    }
}

pub(crate) fn assert_same(a: &Net<'_>, b: &Net<'_>) {
    assert_eq!(a.topology(), b.topology());
    assert_eq!(a.bridges(), b.bridges());
    assert_eq!(a.coordinates().scalar(), b.coordinates().scalar());
    assert_eq!(bits(a), bits(b));
}

/// The quantised net by the definition, node by node from the header.
fn assert_quantised(net: &Net<'_>, back: &Net<'_>, info: &StreamInfo) {
    let StreamMode::Quantised { bits: levels } = info.mode else { panic!("{info:?}") };
    let classes = NodeClasses::new(net.topology()).unwrap();
    let round = |value: f64| match net.coordinates().scalar() {
        Scalar::F32 => f64::from(value as f32),
        Scalar::F64 => value,
    };
    for node in 0..net.shape().node_count() as u32 {
        let (i, j) = net.shape().row_and_column(node);
        let (a, b) = net.shape().row_and_column(classes.representative(node));
        let (given, found) = (net.get(a, b), back.get(i, j));
        assert_eq!(given.is_finite(), found.is_finite(), "node {node}");
        assert!(given.is_finite() || found.is_nan(), "node {node}: {found}");
        for axis in (0..3).filter(|_| given.is_finite()) {
            let (origin, step) = (info.origin[axis], info.step[axis]);
            let level = ((found[axis] - origin) / step).round();
            assert!((0.0..f64::from(1u32 << levels)).contains(&level), "node {node}");
            assert_eq!(found[axis], round(origin + level * step), "node {node}: exactly a level");
            let slack = if net.coordinates().scalar() == Scalar::F32 { 6.1e-8 } else { 2.3e-16 };
            let allowed = step / 2.0 * (1.0 + 1e-9) + slack * given[axis].abs().max(origin.abs());
            assert!((found[axis] - given[axis]).abs() <= allowed, "node {node}: {given} {found}");
        }
    }
    assert_eq!(net.topology(), back.topology());
    assert_eq!(net.bridges(), back.bridges());
}

/// A hash as a source of numbers: the same everywhere.
pub(crate) fn noise(seed: u64, k: u64) -> f64 {
    let mut x = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ k.wrapping_mul(0xd1b5_4a32_d192_ed03);
    x = (x ^ x >> 31).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    ((x ^ x >> 29) >> 11) as f64 / (1u64 << 53) as f64
}

pub(crate) fn torus(h: usize, w: usize, scalar: Scalar, rough: f64) -> Net<'static> {
    let topology = Topology::from_sides(Shape::new(h, w).unwrap(), Sides::TORUS);
    let angle = |k: usize, n: usize| std::f64::consts::TAU * (k % (n - 1)) as f64 / (n - 1) as f64;
    Net::from_fn(topology, scalar, |i, j| {
        let (u, v) = (angle(i, h), angle(j, w));
        let r = 1.0 + 0.05 * (7.0 * u).sin() + rough * noise(1, ((i % (h - 1)) * w + j % (w - 1)) as u64);
        DVec3::new((3.0 + r * u.cos()) * v.cos(), (3.0 + r * u.cos()) * v.sin(), r * u.sin())
    })
    .unwrap()
}

/// Nets of odd kinds: seams, matrices, bridges, gaps, numbers of every sort.
pub(crate) fn odd_nets() -> Vec<Net<'static>> {
    let shape = Shape::new(7, 9).unwrap();
    let seam = |a, b, count| Seam { a, b, count };
    let moebius = [seam(SeamRun::along_column(0, 0, 1), SeamRun::along_column(6, 8, -1), 7)];
    let mut matrix = LinkMatrix::empty(shape).unwrap();
    [0, 2, 4, 17, 23, 60, 88].into_iter().for_each(|link| matrix.set_contracted(link, true));
    let topologies = [
        Topology::from_sides(shape, Sides::TWO_POLES),
        Topology::from_sides(shape, Sides::ONE_POLE).with_reversed(true),
        Topology::new(shape, ContractedLinks::Sides(Sides::SHEET), &moebius).unwrap(),
        Topology::new(shape, ContractedLinks::Matrix(matrix), &moebius).unwrap(),
    ];
    let numbers = [0.0, -0.0, 1.0, -1.5, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 5e-324, -3e-310, 1e300, 7e-46];
    let value = |seed: u64, k: usize| numbers[(noise(seed, k as u64) * numbers.len() as f64) as usize];
    let mut nets = Vec::new();
    for (seed, topology) in topologies.into_iter().enumerate() {
        for scalar in [Scalar::F32, Scalar::F64] {
            let wild =
                |i: usize, j: usize| DVec3::from_array([0, 1, 2].map(|k| value(seed as u64, 27 * i + 3 * j + k)));
            nets.push(Net::from_fn(topology.clone(), scalar, wild).unwrap());
            let mut tame = Net::from_fn(topology.clone(), scalar, |i, j| {
                let gap = if (i + 2 * j) % 11 == 3 { f64::NAN } else { 0.0 };
                DVec3::new(j as f64, i as f64 + gap, (i * j) as f64 * 0.1)
            })
            .unwrap();
            let properties = BridgeProperties { tension: 0.5, elasticity: -0.0, stiffness: f64::INFINITY, user: 77 };
            let mut tube = Bridge::new(Direction::Right, 4, 7, BridgeKind::Tube, BridgeMode::Hide);
            let mut thread = Bridge::new(Direction::Down, 6, 9, BridgeKind::Thread, BridgeMode::Weld);
            tube.properties = properties;
            (thread.start, thread.end) = (3, 5);
            *tame.bridges_mut() = vec![tube, thread];
            nets.push(tame);
        }
    }
    // NaN with bits of their own, signalling ones too.
    let mut planes = XyzMatrices::<f32>::zeroed(shape).unwrap();
    for (k, matrix) in planes.matrices_mut().into_iter().enumerate() {
        for (at, number) in matrix.iter_mut().enumerate() {
            let payload = [0x7f80_0001, 0x7fc0_1234, 0xffff_ffff, 0x0000_0001, 0x8000_0000, 0x3f80_0000];
            *number = f32::from_bits(payload[(noise(9, (3 * at + k) as u64) * 6.0) as usize]);
        }
    }
    nets.push(Net::new(Coordinates::F32(planes), Topology::from_sides(shape, Sides::SHEET)));
    nets
}

#[test]
fn every_bit_comes_back() {
    for net in odd_nets() {
        for mode in [StreamMode::Raw, StreamMode::Lossless] {
            for rows_per_block in [0, 1, 2, 5] {
                let options = StreamOptions { rows_per_block, ..StreamOptions::new(mode) };
                let stream = encode(&net, &options, &job()).unwrap();
                assert_same(&decode(&stream, &job()).unwrap(), &net);
            }
        }
    }
}

#[test]
fn quantised_nets_are_what_the_header_says() {
    let mut nets = odd_nets();
    // Numbers near the largest cannot be subtracted.
    nets.retain(|net| bits(net).iter().all(|&bits| f64::from_bits(bits).abs() < 1e299 || bits < 1 << 32));
    nets.extend([torus(33, 40, Scalar::F32, 0.0), torus(40, 33, Scalar::F64, 0.01)]);
    assert!(nets.len() > 8);
    for net in &nets {
        for bits in [8, 13, 24] {
            for per_axis in [false, true] {
                let options =
                    StreamOptions { per_axis, rows_per_block: 6, ..StreamOptions::new(StreamMode::Quantised { bits }) };
                let stream = encode(net, &options, &job()).unwrap();
                let back = decode(&stream, &job()).unwrap();
                assert_quantised(net, &back, &StreamInfo::read(&stream).unwrap());
                // Levels do not change.
                let again = encode(&back, &StreamOptions::new(StreamMode::Lossless), &job()).unwrap();
                assert_same(&decode(&again, &job()).unwrap(), &back);
            }
        }
    }
}

#[test]
fn coordinates_with_steps_of_their_own_keep_them() {
    // Height in whole metres over a grid of 90 m; rounded to 10 bits, the step would be 3.5 m.
    let topology = Topology::from_sides(Shape::new(40, 41).unwrap(), Sides::SHEET);
    let position = |i: usize, j: usize| {
        DVec3::new(90.0 * j as f64, 90.0 * i as f64, 500.0 + 10.0 * (30.0 * noise(3, (i * 41 + j) as u64)).floor())
    };
    let net = Net::from_fn(topology, Scalar::F32, position).unwrap();
    let stream = encode(&net, &StreamOptions::new(StreamMode::Quantised { bits: 10 }), &job()).unwrap();
    let info = StreamInfo::read(&stream).unwrap();
    assert_eq!((info.step, info.origin), ([90.0, 90.0, 10.0], [0.0, 0.0, 500.0]));
    assert_same(&decode(&stream, &job()).unwrap(), &net);
}

#[test]
fn the_same_bytes_for_any_number_of_threads() {
    let net = torus(200, 150, Scalar::F32, 0.001);
    for mode in MODES {
        let options = StreamOptions { rows_per_block: 16, ..StreamOptions::new(mode) };
        let one = encode(&net, &options, &Job::new(1, &Silent)).unwrap();
        for threads in [2, 3, 7] {
            assert_eq!(encode(&net, &options, &Job::new(threads, &Silent)).unwrap(), one);
            assert_same(
                &decode(&one, &Job::new(threads, &Silent)).unwrap(),
                &decode(&one, &Job::new(1, &Silent)).unwrap(),
            );
        }
    }
}

#[test]
fn rows_come_as_their_blocks_do() {
    let net = torus(60, 50, Scalar::F64, 0.001);
    for mode in MODES {
        let options = StreamOptions { rows_per_block: 7, ..StreamOptions::new(mode) };
        let stream = encode(&net, &options, &job()).unwrap();
        let whole = decode(&stream, &job()).unwrap();
        let mut decoder = StreamDecoder::new(1 << 20);
        let mut rows = 0;
        for piece in stream.chunks(97) {
            let done = decoder.decode_next_bytes(piece).unwrap();
            if done > rows {
                let preview = decoder.net_of_complete_rows(&Job::default()).unwrap();
                let Coordinates::F64(planes) = preview.coordinates() else { panic!("another type") };
                let Coordinates::F64(expected) = whole.coordinates() else { panic!("another type") };
                assert!((rows..done).all(|i| planes.row(i) == expected.row(i)));
            }
            assert!(done >= rows && (done.is_multiple_of(7) || done == 60));
            rows = done;
        }
        assert_eq!(rows, 60);
        assert_same(&decoder.finish().unwrap(), &whole);

        let mut cut = StreamDecoder::new(1 << 20);
        cut.decode_next_bytes(&stream[..stream.len() - 1]).unwrap();
        assert!(matches!(cut.finish(), Err(Error::BadStream { .. })));
        let mut small = StreamDecoder::new(2999);
        assert!(matches!(small.decode_next_bytes(&stream), Err(Error::TooLarge { count: 3000, .. })));
        assert!(matches!(small.decode_next_bytes(&[]), Err(Error::TooLarge { .. })), "an error stays");
        let mut long = StreamDecoder::new(1 << 20);
        long.decode_next_bytes(&stream).unwrap();
        assert!(matches!(long.decode_next_bytes(&[0]), Err(Error::BadStream { .. })));
    }
}

#[test]
fn raw_streams_can_be_mapped() {
    let net = torus(9, 11, Scalar::F32, 0.01);
    let stream = encode(&net, &StreamOptions::new(StreamMode::Raw), &job()).unwrap();
    let start = StreamInfo::read(&stream).unwrap().prelude_size as usize;
    assert_eq!(start % 64, 0);
    let Coordinates::F32(planes) = net.coordinates() else { panic!("another type") };
    let plane = (9 * 11 * 4usize).next_multiple_of(64);
    for (axis, matrix) in planes.matrices().into_iter().enumerate() {
        let bytes = &stream[start + axis * plane..][..9 * 11 * 4];
        assert!(bytes.chunks_exact(4).zip(matrix).all(|(b, x)| b == x.to_le_bytes()));
    }
}

#[test]
fn much_of_nothing_is_small_and_comes_back() {
    // All nodes are one point, or missing: the stream has the least length that the reader demands
    // for this many nodes.
    let shape = Shape::new(3000, 1000).unwrap();
    let sides = Sides { pole_left: true, ..Sides::TWO_POLES };
    let net = Net::from_fn(Topology::from_sides(shape, sides), Scalar::F32, |_, _| DVec3::NAN).unwrap();
    for mode in [StreamMode::Lossless, StreamMode::Quantised { bits: 16 }] {
        let stream = encode(&net, &StreamOptions::new(mode), &job()).unwrap();
        assert!(stream.len() < 10_000, "{}", stream.len());
        let back = decode(&stream, &job()).unwrap();
        assert!((0..3000).all(|i| back.get(i, i % 1000).is_nan()));
    }
}

#[test]
fn options_are_checked() {
    let net = torus(4, 4, Scalar::F64, 0.0);
    for bits in [0, 7, 25, u32::MAX] {
        let options = StreamOptions::new(StreamMode::Quantised { bits });
        assert!(matches!(encode(&net, &options, &job()), Err(Error::OptionOutOfRange { option: "bits", .. })));
    }
    let far = Net::from_fn(net.topology().clone(), Scalar::F64, |i, _| DVec3::splat(i as f64 * 5e307)).unwrap();
    let options = StreamOptions::new(StreamMode::Quantised { bits: 14 });
    assert!(matches!(encode(&far, &options, &job()), Err(Error::OptionOutOfRange { option: "coordinates", .. })));
    assert!(encode(&far, &StreamOptions::new(StreamMode::Lossless), &job()).is_ok());
}

/// The grids of points of the data folder.
fn real_nets() -> Vec<(&'static str, Net<'static>)> {
    let files = [
        ("bun000_range_214x313", Scalar::F32),
        ("bun045_range_221x296", Scalar::F32),
        ("depthcam_table_scene_mug_stereo_textured_240x320", Scalar::F32),
        ("comb_i0_25x33", Scalar::F64),
        ("comb_k0_33x57", Scalar::F64),
    ];
    let net = |(name, scalar): (&'static str, Scalar)| {
        let (size, numbers) = crate::grids::npz(&format!("{name}.npz"), "xyz")?;
        let topology = Topology::from_sides(Shape::new(size[0], size[1]).unwrap(), Sides::SHEET);
        let node = |i: usize, j: usize| DVec3::from_slice(&numbers[3 * (i * size[1] + j)..]);
        Some((name, Net::from_fn(topology, scalar, node).unwrap()))
    };
    files.into_iter().filter_map(net).collect()
}

#[test]
fn real_grids_come_back_and_are_small() {
    // Bits a node that Draco 1.5.7 takes at 14 bits (the better of levels 7 and 10, without the
    // isolated nodes).
    let draco = [("bun000", 10.72), ("bun045", 10.89), ("depthcam", 9.49), ("comb_i0", 11.11), ("comb_k0", 14.89)];
    for (name, net) in real_nets() {
        let shape = net.shape();
        let present = (0..shape.node_count() as u32).filter(|&node| {
            let (i, j) = shape.row_and_column(node);
            net.get(i, j).is_finite()
        });
        let present = present.count() as f64;
        let lossless = encode(&net, &StreamOptions::new(StreamMode::Lossless), &job()).unwrap();
        assert_same(&decode(&lossless, &job()).unwrap(), &net);
        for bits in [14, 16] {
            let stream = encode(&net, &StreamOptions::new(StreamMode::Quantised { bits }), &job()).unwrap();
            assert_quantised(&net, &decode(&stream, &job()).unwrap(), &StreamInfo::read(&stream).unwrap());
            let size = 8.0 * stream.len() as f64 / present;
            let theirs = draco.iter().find(|(start, _)| bits == 14 && name.starts_with(start)).map(|&(_, size)| size);
            let most = theirs.map(|theirs| if present > 2000.0 { 0.75 * theirs } else { 0.8 * theirs });
            println!("{name}: {size:.2} bits a node at {bits} bits");
            assert!(most.is_none_or(|most| size < most), "{name}: {size}");
        }
    }
}

#[test]
fn joined_nets_can_be_taken_apart_after_decoding() {
    let tube = |rows: usize, columns: usize| {
        let topology = Topology::from_sides(Shape::new(rows, columns).unwrap(), Sides::TUBE);
        Net::from_fn(topology, Scalar::F64, |i, j| {
            let angle = std::f64::consts::TAU * (j % (columns - 1)) as f64 / (columns - 1) as f64;
            DVec3::new(angle.cos(), angle.sin(), i as f64)
        })
        .unwrap()
    };
    // Twice, so that there are accounts within accounts: the second net is replicated and turned.
    let options = JoinOptions { twist: 2, ..JoinOptions::new(Direction::Down) };
    let pair = concatenate(&tube(5, 9), &tube(6, 7), &options, &job()).unwrap();
    let whole = concatenate(&tube(4, 11), &pair, &options, &job()).unwrap();
    for mode in [StreamMode::Raw, StreamMode::Lossless] {
        let stream = encode(&whole, &StreamOptions::new(mode), &job()).unwrap();
        let back = decode(&stream, &job()).unwrap();
        assert_same(&back, &whole);
        let [first, second] = back.split(back.bridges().len() - 1, &job()).unwrap();
        assert_same(&first, &tube(4, 11));
        assert_same(&second, &pair);
        let [first, second] = second.split(0, &job()).unwrap();
        assert_same(&first, &tube(5, 9));
        assert_same(&second, &tube(6, 7));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn any_net_comes_back(
        rows in 2usize..24, columns in 2usize..24, bits_of_sides in 0u32..64, double in any::<bool>(),
        rows_per_block in 0usize..9, levels in 8u32..=24, per_axis in any::<bool>(), seed in any::<u64>(),
        gaps in 0.0..0.6, size in -30i32..30,
    ) {
        let on = |k: u32| bits_of_sides >> k & 1 == 1;
        let sides = Sides {
            rows_closed: on(0), columns_closed: on(1),
            pole_top: on(2), pole_bottom: on(3), pole_left: on(4), pole_right: on(5),
        };
        let topology = Topology::from_sides(Shape::new(rows, columns).unwrap(), sides);
        let scalar = if double { Scalar::F64 } else { Scalar::F32 };
        let net = Net::from_fn(topology, scalar, |i, j| {
            let at = 3 * (i * columns + j) as u64;
            if noise(seed, at + 9999) < gaps {
                return DVec3::NAN;
            }
            let number = |k: u64| (noise(seed, at + k) + (i * j) as f64 * 0.1) * 2f64.powi(size);
            DVec3::new(number(0), number(1), number(2))
        }).unwrap();
        for mode in [StreamMode::Raw, StreamMode::Lossless, StreamMode::Quantised { bits: levels }] {
            let options = StreamOptions { mode, per_axis, rows_per_block, levels: None };
            let stream = encode(&net, &options, &job()).unwrap();
            let back = decode(&stream, &job()).unwrap();
            match mode {
                StreamMode::Quantised { .. } => assert_quantised(&net, &back, &StreamInfo::read(&stream).unwrap()),
                _ => assert_same(&back, &net),
            }
        }
    }
}
