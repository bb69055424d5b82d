//! Versions: Versions of the library and its binary interface.

use std::ffi::{CStr, c_char};

/// Returns the version of the library, "major.minor.patch".
///
/// @return a static string, never NULL.
/// @complexity O(1).
#[unsafe(no_mangle)]
pub extern "C" fn gusset_version() -> *const c_char {
    const VERSION_TEXT: &CStr = match CStr::from_bytes_with_nul(concat!(env!("CARGO_PKG_VERSION"), "\0").as_bytes()) {
        Ok(text) => text,
        Err(_) => panic!("the version has no NUL"),
    };
    VERSION_TEXT.as_ptr()
}

/// Returns the number of the binary interface.
///
/// It changes when older programs could break: before 1.0, with each minor version.
///
/// @return the number.
/// @complexity O(1).
#[unsafe(no_mangle)]
pub extern "C" fn gusset_abi() -> u32 {
    1
}
