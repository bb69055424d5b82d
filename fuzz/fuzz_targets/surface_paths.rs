//! See `src/targets/surface_paths.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| gusset_fuzz::run("surface_paths", bytes));
