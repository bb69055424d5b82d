//! See `src/targets/read_stl.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(
    init: gusset_fuzz::write_seeds("read_stl"),
    |bytes: &[u8]| gusset_fuzz::run("read_stl", bytes)
);
