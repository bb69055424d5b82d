//! See `src/targets/read_points.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(
    init: gusset_fuzz::write_seeds("read_points"),
    |bytes: &[u8]| gusset_fuzz::run("read_points", bytes)
);
