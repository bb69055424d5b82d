//! See `src/targets/read_dxf.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(
    init: gusset_fuzz::write_seeds("read_dxf"),
    |bytes: &[u8]| gusset_fuzz::run("read_dxf", bytes)
);
