//! Generates the C headers into OUT_DIR (a test compares the committed ones with them) and sets what the linker must know.

use std::{env, path::PathBuf};

fn main() {
    println!("cargo:rerun-if-changed=src");
    println!("cargo:rerun-if-changed=cbindgen.toml");
    println!("cargo:rerun-if-changed=cbindgen_plugin.toml");
    println!("cargo:rerun-if-changed=build.rs");
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR").expect("set by cargo"));
    let out = PathBuf::from(env::var("OUT_DIR").expect("set by cargo"));
    let part = |name: &str| env::var(format!("CARGO_PKG_VERSION_{name}")).expect("set by cargo");
    let (major, minor, patch) = (part("MAJOR"), part("MINOR"), part("PATCH"));

    let mut config = cbindgen::Config::from_file("cbindgen.toml").expect("cbindgen.toml can be read");
    let versions = format!(
        "\n/** Version of this header; compare with gusset_version() of the library loaded. */\n\
         #define GUSSET_VERSION_MAJOR {major}\n#define GUSSET_VERSION_MINOR {minor}\n#define GUSSET_VERSION_PATCH {patch}\n\
         #define GUSSET_VERSION_STRING \"{major}.{minor}.{patch}\"\n"
    );
    config.after_includes = Some(config.after_includes.unwrap_or_default() + &versions);
    // The interfaces alone: C has no use for the constants of the core.
    let plugin = cbindgen::Config::from_file("cbindgen_plugin.toml").expect("cbindgen_plugin.toml can be read");
    for (source, config, name) in [("mod.rs", config, "gusset.h"), ("plugin/mod.rs", plugin, "gusset_plugin.h")] {
        cbindgen::Builder::new()
            .with_src(root.join("src/ffi").join(source))
            .with_config(config)
            .generate()
            .expect("the header can be generated")
            .write_to_file(out.join(name));
    }

    if env::var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os == "linux") {
        // Threads that still run when a host closes the library would run into unmapped code: never unmap it.
        println!("cargo:rustc-cdylib-link-arg=-Wl,-z,nodelete");
        if env::var_os("CARGO_FEATURE_CAPI").is_none() {
            println!("cargo:rustc-cdylib-link-arg=-Wl,-soname,libgusset.so.{major}.{minor}");
        }
    }
}
