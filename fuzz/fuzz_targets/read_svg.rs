//! See `src/targets/read_svg.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(
    init: gusset_fuzz::write_seeds("read_svg"),
    |bytes: &[u8]| gusset_fuzz::run("read_svg", bytes)
);
