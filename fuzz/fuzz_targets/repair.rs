//! See `src/targets/repair.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| gusset_fuzz::run("repair", bytes));
