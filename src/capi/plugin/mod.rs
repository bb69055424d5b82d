//! Entry: One symbol leads to the tables of filters.
//!
//! | file | what it owns |
//! |---|---|
//! | [`descriptor`] | the structs and constants |
//! | [`channels`] | the extension for attributes |
//! | [`attributes`] | that extension |
//! | [`table`] | the tables, made once of [`crate::filters::FILTERS`], and runs of filters |
//! | [`inputs`] | what a host gives: meshes, curves, callbacks |
//! | [`outcome`] | what a run leaves: outputs, or a failure |
//! | [`outputs`] | how a host reads it |
//! | `memory` | as WebAssembly: room for what a host gives |

mod attributes;
pub mod channels;
pub mod descriptor;
mod inputs;
/// cbindgen:ignore
// In unit tests always, so that it is tested and linted with the rest.
#[cfg(any(target_family = "wasm", test))]
pub mod memory;
pub mod outcome;
mod outputs;
mod table;

use descriptor::{GUSSET_PLUGIN_ABI, gusset_plugin};
use std::panic::catch_unwind;
use std::ptr;

/// Returns the plugin's tables, or NULL if it cannot serve host_abi, the host's GUSSET_PLUGIN_ABI.
/// The first call makes them; any thread may call it. Nothing needs initialisation or release; the
/// library stays loaded after dlclose.
#[unsafe(no_mangle)]
#[must_use]
pub extern "C" fn gusset_plugin_entry(host_abi: u32) -> *const gusset_plugin {
    if host_abi != GUSSET_PLUGIN_ABI {
        return ptr::null();
    }
    catch_unwind(|| ptr::from_ref(&table::plugin_table().plugin)).unwrap_or(ptr::null())
}
