//! See `src/targets/read_scan_list.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(
    init: gusset_fuzz::write_seeds("read_scan_list"),
    |bytes: &[u8]| gusset_fuzz::run("read_scan_list", bytes)
);
