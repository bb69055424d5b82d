//! See `src/targets/develop.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| gusset_fuzz::run("develop", bytes));
