//! Plugins: their tables of filters, runs and results, behind safe types.
//!
//! This folder alone is unsafe. It trusts a plugin to follow `gusset_plugin.h`, as every host does.
#![allow(unsafe_code)]

mod certificates;
mod filter;
mod host;
mod inputs;
mod library;
mod outputs;

pub(crate) use certificates::Certificate;
pub(crate) use filter::{Filter, OutputKind, Param, ParamKind};
pub(crate) use host::Watcher;
pub(crate) use inputs::{Geometry, Inputs};
pub(crate) use library::Plugin;
pub(crate) use outputs::{Channel, Domain, NamedValue, Origins, Outputs, Rule, RunError, ValueKind};

use std::ffi::{CStr, c_char};

/// Returns a text of the plugin's tables, which live as long as the plugin.
fn static_text(text: *const c_char) -> &'static str {
    // SAFETY: the plugin promises C strings.
    unsafe { table_text(text) }
}

/// Returns a text of the plugin.
///
/// # Safety
/// `text` is NULL or a C string that lives as long as the plugin.
unsafe fn table_text(text: *const c_char) -> &'static str {
    if text.is_null() {
        return "";
    }
    // SAFETY: as above.
    unsafe { CStr::from_ptr(text) }.to_str().unwrap_or("?")
}
