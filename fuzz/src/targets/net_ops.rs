//! Nets joined, taken apart, turned, coded and measured: what goes back and forth comes back to the
//! bit.

use crate::input;
use crate::input::SmallNet;
use gusset::Job;
use gusset::net::convert::MeshOptions;
use gusset::net::measure::measure;
use gusset::net::normals::normals;
use gusset::net::stream::{StreamMode, StreamOptions, decode, encode};
use gusset::net::{Direction, JoinOptions, Net, concatenate};

fn same(a: &Net<'_>, b: &Net<'_>) -> bool {
    let nodes = || (0..a.shape().rows()).flat_map(|i| (0..a.shape().columns()).map(move |j| (i, j)));
    let bits = |net: &Net<'_>, i, j| net.get(i, j).to_array().map(f64::to_bits);
    a.shape() == b.shape() && a.topology() == b.topology() && nodes().all(|(i, j)| bits(a, i, j) == bits(b, i, j))
}

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some(input) = input::taken::<(SmallNet, SmallNet, u8)>(bytes) else { return };
    let (a, b, tolerance) = input;
    let (Some(a), Some(b), job) = (a.net(), b.net(), Job::default()) else { return };
    let there = a.transposed(&job).expect("any net can be transposed");
    assert!(same(&a, &there.transposed(&job).expect("and back")));
    let _ = (a.validate(f64::from(tolerance), &job), measure(&a, &job), normals(&a, &job));
    if let Ok(made) = a.to_mesh(&MeshOptions::default(), &job) {
        input::expect_valid(&made.mesh, |_| {});
    }
    if let Ok(joined) = concatenate(&a, &b, &JoinOptions::new(Direction::Down), &job) {
        let stream = encode(&joined, &StreamOptions::new(StreamMode::Lossless), &job).expect("a net can be encoded");
        assert!(same(&joined, &decode(&stream, &job).expect("what was encoded can be decoded")));
        let _ = joined.split(0, &job);
    }
}
