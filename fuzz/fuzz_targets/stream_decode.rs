//! See `src/targets/stream_decode.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| gusset_fuzz::run("stream_decode", bytes));
