//! See `src/targets/weld_orient.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| gusset_fuzz::run("weld_orient", bytes));
