//! See `src/targets/read_ply.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(
    init: gusset_fuzz::write_seeds("read_ply"),
    |bytes: &[u8]| gusset_fuzz::run("read_ply", bytes)
);
