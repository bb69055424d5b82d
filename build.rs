//! Writes the texts of statuses into OUT_DIR, and sets what the linker must know.

use std::{env, fmt::Write, fs, path::PathBuf};

fn main() {
    println!("cargo:rerun-if-changed=src/capi/status.rs");
    println!("cargo:rerun-if-changed=build.rs");
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR").expect("set by cargo"));
    let out = PathBuf::from(env::var("OUT_DIR").expect("set by cargo"));
    let part = |name: &str| env::var(format!("CARGO_PKG_VERSION_{name}")).expect("set by cargo");
    let (major, minor) = (part("MAJOR"), part("MINOR"));

    let statuses = fs::read_to_string(root.join("src/capi/status.rs")).expect("the list of statuses can be read");
    fs::write(out.join("status_text.rs"), status_text(&statuses)).expect("OUT_DIR can be written to");

    if env::var("TARGET").is_ok_and(|target| target == "wasm32-unknown-unknown") {
        // Hosts call the plugin's functions through their table, and add callbacks of their own to
        // it. The stack is that of a helping thread elsewhere.
        for argument in ["--export-table", "--growable-table", "-z", "stack-size=2097152"] {
            println!("cargo:rustc-cdylib-link-arg={argument}");
        }
    }
    if env::var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os == "linux") {
        // Threads that still run when a host closes the library would run into unmapped code: never
        // unmap it.
        println!("cargo:rustc-cdylib-link-arg=-Wl,-z,nodelete");
        if env::var_os("CARGO_FEATURE_CAPI").is_none() {
            println!("cargo:rustc-cdylib-link-arg=-Wl,-soname,libgusset.so.{major}.{minor}");
        }
    }
}

/// A function from each number of the enum `gusset_status` to the first sentence of its comment.
fn status_text(source: &str) -> String {
    let listed = source.split_once("pub enum gusset_status {").expect("the enum is in the file").1;
    let (mut code, mut text) = (String::new(), String::new());
    for line in listed.split_once("\n}").expect("the enum ends").0.lines().map(str::trim) {
        if let Some(comment) = line.strip_prefix("/// ") {
            text = if text.is_empty() { comment.to_owned() } else { format!("{text} {comment}") };
        } else if let Some((_, number)) = line.split_once(" = ") {
            let sentence = text.split(". ").next().expect("a part").trim_end_matches('.').to_owned();
            text.clear();
            let (first, rest) = sentence.split_at(1);
            let number = number.trim_end_matches(',');
            writeln!(code, "        {number} => c\"{}{rest}\",", first.to_lowercase()).expect("a String takes all");
        }
    }
    format!(
        "fn status_text(status: i32) -> &'static std::ffi::CStr {{\n    match status {{\n{code}        _ => c\"unknown status\",\n    }}\n}}\n"
    )
}
