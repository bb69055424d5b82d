//! The targets of the fuzzers: each decodes bytes to a case and checks the answers. libFuzzer
//! chooses the bytes in `fuzz_targets`; the tests use fixed seeds.

pub mod agree;
mod documents;
pub mod input;
pub mod memory;
pub mod targets;

use glam::DVec3;
use std::{env, fs, path::Path};
pub use targets::{SEEDS, TARGETS};

/// Runs one case of a target.
///
/// # Panics
/// If an oracle fails, or the target does not exist.
pub fn run(name: &str, bytes: &[u8]) {
    let target = TARGETS.iter().find(|(known, _)| *known == name).expect("a target of the table");
    (target.1)(bytes);
}

/// Returns the first inputs of a target.
#[must_use]
pub fn seeds(name: &str) -> Vec<Vec<u8>> {
    SEEDS.iter().find(|(known, _)| *known == name).map_or_else(Vec::new, |(_, seeds)| seeds())
}

/// Writes the first inputs of a target to the corpus: the first folder among the program's arguments.
///
/// # Panics
/// If a file cannot be written.
pub fn write_seeds(name: &str) {
    let Some(corpus) = env::args().skip(1).find(|argument| Path::new(argument).is_dir()) else { return };
    for (number, bytes) in seeds(name).into_iter().enumerate() {
        fs::write(Path::new(&corpus).join(format!("seed-{number:02}")), bytes).expect("a corpus that can be written");
    }
}

/// Returns a file with a few changes that the number chooses: flipped, cut, repeated and inserted bytes.
#[must_use]
pub fn changed(file: &[u8], number: u64) -> Vec<u8> {
    let choices = seed_bytes(number);
    let mut changed = file.to_vec();
    for choice in choices.chunks_exact(4).take(1 + number as usize % 4) {
        let place = usize::from(u16::from_le_bytes([choice[0], choice[1]])) % (changed.len() + 1);
        let end = (place + usize::from(choice[2] % 32)).min(changed.len());
        match choice[3] % 4 {
            0 => changed[place..end.min(place + 1)].iter_mut().for_each(|byte| *byte ^= choice[2]),
            1 => drop(changed.drain(place..end)),
            2 => changed.extend_from_within(place..end),
            _ => drop(changed.splice(place..place, choices.iter().copied().take(usize::from(choice[2] % 8)))),
        }
    }
    changed
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
