//! The targets of the fuzzers: each decodes bytes to a case and checks the answers. libFuzzer
//! chooses the bytes in `fuzz_targets`; the tests use fixed seeds.

pub mod agree;
pub mod input;
pub mod targets;

use glam::DVec3;
pub use targets::TARGETS;

/// Runs one case of a target.
///
/// # Panics
/// If an oracle fails, or the target does not exist.
pub fn run(name: &str, bytes: &[u8]) {
    let target = TARGETS.iter().find(|(known, _)| *known == name).expect("a target of the table");
    (target.1)(bytes);
}

/// How far two points are apart: at 1e300 too.
#[must_use]
pub fn distance(p: DVec3, q: DVec3) -> f64 {
    let [x, y, z] = (p - q).to_array();
    x.hypot(y).hypot(z)
}

/// The bytes of case `number` of a target, for repeatable runs and first corpora. They are random;
/// some have long runs of equal bytes, which give repeated points and equal copies.
pub fn seed_bytes(number: u64) -> Vec<u8> {
    // SplitMix64, G. Steele, D. Lea and C. Flood, Fast splittable pseudorandom number generators, 2014.
    let mut state = number.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let mut next = || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    };
    let length = 16 + next() as usize % 1000;
    let mut bytes: Vec<u8> = Vec::with_capacity(length);
    while bytes.len() < length {
        match (next() % 8, bytes.len()) {
            // A copy of earlier bytes.
            (0, before @ 16..) => bytes.extend_from_within(before - 16..),
            (1, _) => bytes.extend([0; 8]),
            _ => bytes.extend(next().to_le_bytes()),
        }
    }
    bytes
}
