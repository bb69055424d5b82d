//! See `src/targets/read_off.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(
    init: gusset_fuzz::write_seeds("read_off"),
    |bytes: &[u8]| gusset_fuzz::run("read_off", bytes)
);
