//! Entry: One symbol leads to the functions.

pub mod descriptor;
pub mod outcome;

use crate::functions;
use descriptor::{GUSSET_FILES_ABI, gusset_files};
use std::ptr;

static FILES: gusset_files = gusset_files {
    struct_size: size_of::<gusset_files>(),
    read: functions::read,
    write: functions::write,
    part_count: functions::part_count,
    part_name: functions::part_name,
    part_bytes: functions::part_bytes,
    message: functions::message,
    free: functions::free,
};

/// Returns the functions, or NULL if the library cannot serve host_abi, the host's GUSSET_FILES_ABI.
#[unsafe(no_mangle)]
#[must_use]
pub extern "C" fn gusset_files_entry(host_abi: u32) -> *const gusset_files {
    if host_abi == GUSSET_FILES_ABI { &raw const FILES } else { ptr::null() }
}
