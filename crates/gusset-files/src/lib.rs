//! A C interface to `gusset-io`: one symbol leads to a table of functions that read and write files in memory.
//!
//! It is a library of its own, because hosts in C and C++ have readers of theirs. `table` has the structs and functions, `folder` the
//! files of the host. In WebAssembly, `memory` allocates room for the host's arrays.
#![allow(unsafe_code)]
#![allow(non_camel_case_types)]

mod folder;
mod functions;
// In unit tests always, so that it is tested and linted with the rest.
#[cfg(any(target_family = "wasm", test))]
pub mod memory;
pub mod table;

/// The allocator of the library.
#[cfg(feature = "reserve")]
#[global_allocator]
static ALLOCATOR: gusset_base::reserve::ReserveBackedAllocator = gusset_base::reserve::ReserveBackedAllocator;
