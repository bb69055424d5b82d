//! The filters of `gusset` as OpenMfx effects: the entry points through which hosts of Open Mesh
//! Effect load the library.
//!
//! OpenMfx is OpenFX, a plug-in standard for images, with meshes in the place of images. The
//! declarations follow version 1 of its mesh effect API and of its property, parameter and message
//! suites, as documented in December 2022 (<https://openmesheffect.org>). They are limited to the
//! parts that effects need.
//!
//! | file | contents |
//! |---|---|
//! | `ofx_abi` | structs, statuses, and the names of suites, actions and properties |
//! | `suites` | the suites of the host, behind types that check statuses |
//! | `effects` | the effects, created once from [`gusset::filters::FILTERS`], and their texts |
//! | `describe` | describes an effect to a host |
//! | `host_meshes` | meshes of the host, read and written |
//! | `edge_chains` | polylines, which the standard stores as faces of two corners |
//! | `cook` | runs an effect |
//!
//! Effects keep no state between actions. The library keeps one pointer for each effect: the host
//! passes it before any other call, and later calls lack it.

#![allow(unsafe_code, reason = "the border to hosts in C")]

mod cook;
mod describe;
mod edge_chains;
mod effects;
mod host_meshes;
mod ofx_abi;
mod suites;

use effects::FilterEffect;
use gusset::filters::FILTERS;
use ofx_abi::{API_VERSION, HostHandle, MESH_EFFECT_API_NAME, OfxHost, OfxPlugin, OfxStatus};
use std::ffi::{CStr, c_char, c_int, c_uint, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicPtr, Ordering};
use suites::HostSuites;

/// Largest number of effects. Each effect needs its own functions, because calls do not identify
/// the effect.
const MAX_EFFECTS: usize = 64;

const _: () =
    assert!(FILTERS.len() <= MAX_EFFECTS, "there are more filters than functions: extend FUNCTIONS and MAX_EFFECTS");

/// The pointer that the host of each effect passed.
static HOST_OF_EFFECT: [AtomicPtr<OfxHost>; MAX_EFFECTS] = [const { AtomicPtr::new(ptr::null_mut()) }; MAX_EFFECTS];

/// Returns the number of effects.
#[unsafe(no_mangle)]
#[allow(non_snake_case, reason = "the standard names it")]
pub extern "C" fn OfxGetNumberOfPlugins() -> c_int {
    catch_unwind(|| effects::effects().len() as c_int).unwrap_or(0)
}

/// Returns effect `nth`, counted from 0; NULL if it does not exist. The struct is static.
#[unsafe(no_mangle)]
#[allow(non_snake_case, reason = "the standard names it")]
pub extern "C" fn OfxGetPlugin(nth: c_int) -> *const OfxPlugin {
    let plugin = catch_unwind(|| usize::try_from(nth).ok().and_then(|nth| PluginTable::get().0.get(nth)));
    plugin.ok().flatten().map_or(ptr::null(), ptr::from_ref)
}

/// The effects as hosts see them.
struct PluginTable(Vec<OfxPlugin>);

// SAFETY: its pointers refer to texts and functions that live as long as the library is loaded, and
// never change.
unsafe impl Send for PluginTable {}
// SAFETY: as above.
unsafe impl Sync for PluginTable {}

impl PluginTable {
    fn get() -> &'static Self {
        static PLUGINS: OnceLock<PluginTable> = OnceLock::new();
        let version = |part: &str| part.parse::<c_uint>().unwrap_or(0);
        let plugin = |(effect, (set_host, main_entry)): (&FilterEffect, EffectFunctions)| OfxPlugin {
            plugin_api: MESH_EFFECT_API_NAME.as_ptr(),
            api_version: API_VERSION,
            // Never freed, because the effects are never freed.
            plugin_identifier: effects::to_c_string(&format!("gusset.{}", effect.filter.id)).into_raw(),
            plugin_version_major: version(env!("CARGO_PKG_VERSION_MAJOR")),
            plugin_version_minor: version(env!("CARGO_PKG_VERSION_MINOR")),
            set_host,
            main_entry,
        };
        PLUGINS.get_or_init(|| PluginTable(effects::effects().iter().zip(EFFECT_FUNCTIONS).map(plugin).collect()))
    }
}

/// The functions of one effect.
type EffectFunctions = (
    unsafe extern "C" fn(*mut OfxHost),
    unsafe extern "C" fn(*const c_char, *const c_void, HostHandle, HostHandle) -> c_int,
);

macro_rules! functions {
    ($($number:literal)*) => { [$((set_host::<$number>, main_entry::<$number>)),*] };
}

const EFFECT_FUNCTIONS: [EffectFunctions; MAX_EFFECTS] = functions!(
    0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31
    32 33 34 35 36 37 38 39 40 41 42 43 44 45 46 47 48 49 50 51 52 53 54 55 56 57 58 59 60 61 62 63
);

unsafe extern "C" fn set_host<const NUMBER: usize>(host: *mut OfxHost) {
    HOST_OF_EFFECT[NUMBER].store(host, Ordering::Release);
}

unsafe extern "C" fn main_entry<const NUMBER: usize>(
    name: *const c_char,
    handle: *const c_void,
    in_args: HostHandle,
    _: HostHandle,
) -> c_int {
    let done = catch_unwind(AssertUnwindSafe(|| {
        if name.is_null() {
            return Err(OfxStatus::BAD_HANDLE);
        }
        // SAFETY: the pointer is not NULL, and the host passes a NUL-terminated text.
        let name = unsafe { CStr::from_ptr(name) };
        let effect = effects::effects().get(NUMBER).ok_or(OfxStatus::BAD_HANDLE)?;
        run_action(effect, HOST_OF_EFFECT[NUMBER].load(Ordering::Acquire), name, handle.cast_mut(), in_args)
    }));
    let status = done.unwrap_or_else(|panic| {
        // As in `guard`: the destructor of the payload could panic.
        std::mem::forget(panic);
        Err(OfxStatus::FAILED)
    });
    status.unwrap_or_else(|status| status).0
}

fn run_action(
    effect: &'static FilterEffect,
    host: *mut OfxHost,
    action: &CStr,
    handle: HostHandle,
    in_args: HostHandle,
) -> Result<OfxStatus, OfxStatus> {
    match action.to_bytes() {
        // The library and its instances do not keep state. The suites of the host are checked when
        // an effect is described.
        b"OfxActionLoad"
        | b"OfxActionUnload"
        | b"OfxActionCreateInstance"
        | b"OfxActionDestroyInstance"
        | b"OfxMeshEffectActionDescribeInContext" => Ok(OfxStatus::OK),
        b"OfxActionDescribe" => {
            describe::describe_effect(effect, &HostSuites::fetch_from_host(host)?, handle).map(|()| OfxStatus::OK)
        }
        b"OfxMeshEffectActionCook" => {
            cook::run_cook_action(effect, &HostSuites::fetch_from_host(host)?, handle, in_args).map(|()| OfxStatus::OK)
        }
        // Only cooking tells whether an effect changes anything (`IsIdentity`), so this action is
        // left to the default too.
        _ => Ok(OfxStatus::REPLY_DEFAULT),
    }
}
