//! Sets the arguments of the linker.

use std::env;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    let part = |name: &str| env::var(format!("CARGO_PKG_VERSION_{name}")).expect("set by cargo");
    let (major, minor) = (part("MAJOR"), part("MINOR"));

    if env::var("TARGET").is_ok_and(|target| target == "wasm32-unknown-unknown") {
        // Hosts call the plugin's functions through their table, and add their own callbacks to it.
        // The stack has the size of a helper thread's stack on other platforms.
        for argument in ["--export-table", "--growable-table", "-z", "stack-size=2097152"] {
            println!("cargo:rustc-cdylib-link-arg={argument}");
        }
    }
    if env::var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os == "linux") {
        // If a host closed the library, threads that still run would execute unmapped code, so
        // never unmap it.
        println!("cargo:rustc-cdylib-link-arg=-Wl,-z,nodelete");
        if env::var_os("CARGO_FEATURE_CAPI").is_none() {
            println!("cargo:rustc-cdylib-link-arg=-Wl,-soname,libgusset.so.{major}.{minor}");
        }
    }
}
