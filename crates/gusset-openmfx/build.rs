//! Passes arguments to the linker.

use std::env;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    if env::var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os == "linux") {
        // Hosts may close the library while other code still holds pointers into it.
        println!("cargo:rustc-cdylib-link-arg=-Wl,-z,nodelete");
    }
}
