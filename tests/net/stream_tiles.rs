//! Tiles of one net that are coded apart: with common levels, their shared nodes stay equal.

use super::stream::{bits, job, noise};
use glam::DVec3;
use gusset::Error;
use gusset::mesh::Scalar;
use gusset::net::stream::{LevelBox, StreamInfo, StreamMode, StreamOptions, decode, encode};
use gusset::net::{Net, Shape, Sides, Topology};

const ROWS: usize = 12;
const WIDTH: usize = 9;

/// Tile `k` of a terrain, whose last column is the first column of the next tile.
fn tile(k: usize, seed: u64, unit: f64, scalar: Scalar) -> Net<'static> {
    let shape = Shape::new(ROWS, WIDTH).unwrap();
    Net::from_fn(Topology::from_sides(shape, Sides::SHEET), scalar, |i, j| {
        let column = k * (WIDTH - 1) + j;
        let height = noise(seed, (column * ROWS + i) as u64);
        unit * DVec3::new(column as f64 + 0.3 * height, i as f64 - 0.2 * height, (3.0 + 0.1 * column as f64) * height)
    })
    .unwrap()
}

fn decoded(net: &Net<'_>, options: &StreamOptions) -> (Net<'static>, StreamInfo) {
    let stream = encode(net, options, &job()).unwrap();
    (decode(&stream, &job()).unwrap(), StreamInfo::read(&stream).unwrap())
}

/// The bits of a column.
fn column(net: &Net<'_>, j: usize) -> Vec<u64> {
    let all = bits(net);
    (0..3 * ROWS).map(|row| all[row * WIDTH + j]).collect()
}

fn number(net: &Net<'_>, bits: u64) -> f64 {
    match net.coordinates().scalar() {
        Scalar::F32 => f32::from_bits(bits as u32).into(),
        Scalar::F64 => f64::from_bits(bits),
    }
}

#[test]
fn tiles_coded_apart_meet_in_equal_nodes() {
    let mut differ_without = 0;
    for seed in 0..200 {
        let unit = 10f64.powf(8.0 * noise(seed, 1 << 40) - 4.0);
        let scalar = if seed % 2 == 0 { Scalar::F64 } else { Scalar::F32 };
        let tiles = [0, 1, 2].map(|k| tile(k, seed, unit, scalar));
        let far = 1.001 * unit;
        let (low, high) = ([-far; 3], [26.0 * far, 13.0 * far, 6.0 * far]);
        let mode = StreamMode::Quantised { bits: 8 + (seed % 13) as u32 };
        let step = (seed % 3 == 0).then_some(0.01 * unit);
        let given = StreamOptions { levels: Some(LevelBox { low, high, step }), ..StreamOptions::new(mode) };
        let coded = tiles.each_ref().map(|tile| decoded(tile, &given));
        for pair in coded.windows(2) {
            assert_eq!(column(&pair[0].0, WIDTH - 1), column(&pair[1].0, 0), "{seed}");
            assert_eq!((pair[0].1.origin, pair[0].1.step), (low, pair[1].1.step), "{seed}");
        }
        for (tile, (back, info)) in tiles.iter().zip(&coded) {
            let half = 0.5 * info.step[0] + 1e-6 * high[0];
            let pairs = bits(tile).into_iter().zip(bits(back));
            assert!(pairs.clone().all(|(x, y)| (number(tile, x) - number(back, y)).abs() <= half), "{seed}");
            if let Some(step) = step {
                assert_eq!((info.step, info.mode), ([step; 3], StreamMode::Quantised { bits: 12 }), "{seed}");
            }
        }
        let alone = tiles.each_ref().map(|tile| decoded(tile, &StreamOptions::new(mode)));
        differ_without += usize::from(column(&alone[0].0, WIDTH - 1) != column(&alone[1].0, 0));
    }
    assert!(differ_without > 150, "tiles with levels of their own mostly differ: {differ_without}");
}

#[test]
fn nodes_outside_the_box_and_bad_boxes_are_refused() {
    let net = tile(0, 7, 1.0, Scalar::F64);
    let coded = |low: [f64; 3], high: [f64; 3], step| {
        let levels = Some(LevelBox { low, high, step });
        let options = StreamOptions { levels, ..StreamOptions::new(StreamMode::Quantised { bits: 16 }) };
        encode(&net, &options, &job()).map(|_| ())
    };
    let (low, high) = ([-1.0; 3], [12.0; 3]);
    assert_eq!(coded(low, high, None), Ok(()));
    // The first node beyond 4 is in column 4 or 5 of the first row.
    let Err(Error::NodeOutsideBox { node }) = coded(low, [4.0, 12.0, 12.0], None) else { panic!("a node is outside") };
    assert!((4..6).contains(&node), "{node}");
    let refused = |low, high, step, option: &str| {
        let found = coded(low, high, step);
        assert!(matches!(&found, Err(Error::OptionOutOfRange { option: name, .. }) if *name == option), "{found:?}");
    };
    refused([f64::NAN, 0.0, 0.0], high, None, "low");
    refused(low, [12.0, f64::INFINITY, 12.0], None, "high");
    refused(low, [12.0, -1.5, 12.0], None, "high");
    for step in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-300, 1e-9] {
        refused(low, high, Some(step), "step");
    }
    // 24 bits reach 2^24 - 1 steps far.
    assert_eq!(coded(low, high, Some(13.0 / 16_777_215.0 * 1.000_001)), Ok(()));
}
