//! Sets the arguments of the linker.

use std::env;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    if env::var("TARGET").is_ok_and(|target| target == "wasm32-unknown-unknown") {
        // Hosts call the functions through the module's table, and add their own callbacks to it.
        for argument in ["--export-table", "--growable-table", "-z", "stack-size=2097152"] {
            println!("cargo:rustc-cdylib-link-arg={argument}");
        }
    }
}
