//! Results: The parts of a file that was read or written.

use std::ffi::CString;

/// Parts of a file that was read or written, or the reason of a failure.
pub struct gusset_file {
    /// Names and bytes.
    pub(crate) parts: Vec<(CString, Vec<u8>)>,
    pub(crate) message: CString,
}
