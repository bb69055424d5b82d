//! See `src/targets/boundary_check.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| gusset_fuzz::run("boundary_check", bytes));
