//! Entry: One symbol leads to the functions.

pub mod descriptor;
pub mod outcome;

use descriptor::{GUSSET_FILES_ABI, gusset_files};
use std::ptr;

static FILES: gusset_files = gusset_files {
    struct_size: size_of::<gusset_files>(),
    read: outcome::read,
    write: outcome::write,
    part_count: outcome::part_count,
    part_name: outcome::part_name,
    part_bytes: outcome::part_bytes,
    message: outcome::message,
    free: outcome::free,
};

/// Returns the functions, or NULL if the library cannot serve host_abi, the host's GUSSET_FILES_ABI.
#[unsafe(no_mangle)]
#[must_use]
pub extern "C" fn gusset_files_entry(host_abi: u32) -> *const gusset_files {
    if host_abi == GUSSET_FILES_ABI { &raw const FILES } else { ptr::null() }
}
