//! See `src/targets/curve_ops.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| gusset_fuzz::run("curve_ops", bytes));
