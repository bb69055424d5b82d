//! See `src/targets/net_edit.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| gusset_fuzz::run("net_edit", bytes));
