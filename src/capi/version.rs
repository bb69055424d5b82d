//! Versions: The version of the library and of its binary interface.

use std::ffi::{CStr, c_char};

/// The library's version, "major.minor.patch".
///
/// Never NULL; static.
///
/// @return a static string, never NULL.
/// @complexity O(1).
#[unsafe(no_mangle)]
pub extern "C" fn gusset_version() -> *const c_char {
    const TEXT: &CStr = match CStr::from_bytes_with_nul(concat!(env!("CARGO_PKG_VERSION"), "\0").as_bytes()) {
        Ok(text) => text,
        Err(_) => panic!("the version has no NUL"),
    };
    TEXT.as_ptr()
}

/// The number of the binary interface.
///
/// It changes whenever a program built against an older header could break; until 1.0 that is when
/// the minor version changes.
///
/// @return the number.
/// @complexity O(1).
#[unsafe(no_mangle)]
pub extern "C" fn gusset_abi() -> u32 {
    1
}
