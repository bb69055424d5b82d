//! See `src/targets/read_3mf.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(
    init: gusset_fuzz::write_seeds("read_3mf"),
    |bytes: &[u8]| gusset_fuzz::run("read_3mf", bytes)
);
