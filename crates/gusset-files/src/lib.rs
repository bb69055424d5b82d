//! A C interface to `gusset-io`: one symbol leads to a table of functions that read and write files in memory.
//!
//! It is a library of its own, because hosts in C and C++ have readers of theirs, and because it has no reserve of memory: if a small
//! allocation is refused, the process ends. `table` has the structs and functions, `folder` the files of the host; `memory_file` receives
//! written files. In WebAssembly, `memory` allocates room for the host's arrays.
#![allow(unsafe_code)]
#![allow(non_camel_case_types)]

mod memory_file;
mod folder;
mod functions;
// In unit tests always, so that it is tested and linted with the rest.
#[cfg(any(target_family = "wasm", test))]
pub mod memory;
pub mod table;
