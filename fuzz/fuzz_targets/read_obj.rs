//! See `src/targets/read_obj.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(
    init: gusset_fuzz::write_seeds("read_obj"),
    |bytes: &[u8]| gusset_fuzz::run("read_obj", bytes)
);
