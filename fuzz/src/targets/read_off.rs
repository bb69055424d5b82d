//! Bytes that claim to be an OFF file.

use crate::documents::{Expected, Files, check};
use gusset_io::Format;

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    check(bytes, &Files::default(), Expected { is_exact: true, ..Expected::new(Format::Off) });
}

/// Makes files of all heads, and hostile counts.
pub(crate) fn seeds() -> Vec<Vec<u8>> {
    let texts = [
        "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
        "# a comment\nOFF 3 1 0 # counts\n0 0 0\n\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n",
        "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 0.5 0.5 0 1\n3 2 1 0 7\n",
        "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 1 0 1\n0 1 0 0 0 255 128\n3 0 1 2\n",
        "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n",
        "STOFF\n3 1 0\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n",
        "CNOFF\n3 1 0\n0 0 0 0 0 1 1 0 0 1\n1 0 0 0 0 1 0 1 0 1\n0 1 0 0 0 1 0 0 1 1\n3 0 1 2\n",
        "NCOFF\n3 1 0\n0 0 0 0 0 1 255 0 0 255\n1 0 0 0 0 1 0 255 0 255\n0 1 0 0 0 1 0 0 255 255\n3 0 1 2\n",
        "STCN4OFF\n1 0 0\n0 0 0 1\n",
        "nOFF 3\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
        "OFF\n4000000000 4000000000 0\n0 0 0\n",
        "OFF\n1 1 0\nnan inf 1e999\n4000000000 0\n",
        "OFF\n0 4000000000 0\n",
    ];
    let mut seeds: Vec<Vec<u8>> = texts.iter().map(|text| text.as_bytes().to_vec()).collect();
    let mut binary = b"OFF BINARY\n".to_vec();
    [3, 1, 0].iter().for_each(|count: &u32| binary.extend(count.to_be_bytes()));
    [0, 0, 0, 1, 0, 0, 0, 1, 0_u8].iter().for_each(|&x| binary.extend(f32::from(x).to_be_bytes()));
    [3, 0, 1, 2, 0].iter().for_each(|word: &u32| binary.extend(word.to_be_bytes()));
    seeds.push(binary.clone());
    binary[11..15].fill(0xff);
    seeds.push(binary);
    seeds
}
