//! See `src/targets/read_gltf.rs`.
#![no_main]

libfuzzer_sys::fuzz_target!(
    init: gusset_fuzz::write_seeds("read_gltf"),
    |bytes: &[u8]| gusset_fuzz::run("read_gltf", bytes)
);
