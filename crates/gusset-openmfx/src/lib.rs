//! The filters of `gusset` as OpenMfx effects: the entry points by which hosts of Open Mesh Effect
//! load the library.
//!
//! OpenMfx is OpenFX, a plug-in standard for pictures, with meshes in the place of pictures. What
//! is declared here follows version 1 of its mesh effect API and of its property, parameter and
//! message suites, as its documentation of December 2022 describes them
//! (<https://openmesheffect.org>); only what effects need of it is here.
//!
//! | file | what it owns |
//! |---|---|
//! | `abi` | structs, statuses, and the names of suites, actions and properties |
//! | `suites` | what the host offers, behind types that check |
//! | `effects` | the effects, made once of [`gusset::filters::FILTERS`], and their texts |
//! | `describe` | what a host is told of an effect |
//! | `meshes` | meshes of the host, read and written |
//! | `wires` | polylines, which are faces of two corners there |
//! | `cook` | an effect at work |
//!
//! An effect keeps nothing between actions, and the library keeps one thing for each effect: the
//! pointer that its host hands over before anything else, since later calls come without it.

#![allow(unsafe_code, reason = "the border to hosts in C")]

mod abi;
mod cook;
mod describe;
mod effects;
mod meshes;
mod suites;
mod wires;

use abi::{API, API_VERSION, Handle, OfxHost, OfxPlugin, Status};
use effects::Effect;
use gusset::filters::FILTERS;
use std::ffi::{CStr, c_char, c_int, c_uint, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicPtr, Ordering};
use suites::Suites;

/// More effects than there are filters; each needs functions of its own, since no call says which
/// effect is meant.
const ROOM: usize = 64;

const _: () = assert!(FILTERS.len() <= ROOM, "more filters than functions: enlarge the list of numbers");

/// What the host of each effect handed over.
static HOSTS: [AtomicPtr<OfxHost>; ROOM] = [const { AtomicPtr::new(ptr::null_mut()) }; ROOM];

/// How many effects there are.
#[unsafe(no_mangle)]
#[allow(non_snake_case, reason = "the standard names it")]
pub extern "C" fn OfxGetNumberOfPlugins() -> c_int {
    catch_unwind(|| effects::all().len() as c_int).unwrap_or(0)
}

/// An effect, from 0; NULL if there is none of this number. The struct is static.
#[unsafe(no_mangle)]
#[allow(non_snake_case, reason = "the standard names it")]
pub extern "C" fn OfxGetPlugin(nth: c_int) -> *const OfxPlugin {
    let plugin = catch_unwind(|| usize::try_from(nth).ok().and_then(|nth| Plugins::get().0.get(nth)));
    plugin.ok().flatten().map_or(ptr::null(), ptr::from_ref)
}

/// The effects as hosts see them.
struct Plugins(Vec<OfxPlugin>);

// SAFETY: its pointers are to texts and functions that live as long as the library is loaded, and
// never change.
unsafe impl Send for Plugins {}
// SAFETY: as above.
unsafe impl Sync for Plugins {}

impl Plugins {
    fn get() -> &'static Self {
        static PLUGINS: OnceLock<Plugins> = OnceLock::new();
        let version = |part: &str| part.parse::<c_uint>().unwrap_or(0);
        let plugin = |(effect, (set_host, main_entry)): (&Effect, Functions)| OfxPlugin {
            plugin_api: API.as_ptr(),
            api_version: API_VERSION,
            // Never freed, as the effects are not.
            plugin_identifier: effects::text(&format!("gusset.{}", effect.filter.id)).into_raw(),
            plugin_version_major: version(env!("CARGO_PKG_VERSION_MAJOR")),
            plugin_version_minor: version(env!("CARGO_PKG_VERSION_MINOR")),
            set_host,
            main_entry,
        };
        PLUGINS.get_or_init(|| Plugins(effects::all().iter().zip(FUNCTIONS).map(plugin).collect()))
    }
}

/// The functions of the effect of this number.
type Functions =
    (unsafe extern "C" fn(*mut OfxHost), unsafe extern "C" fn(*const c_char, *const c_void, Handle, Handle) -> c_int);

macro_rules! functions {
    ($($number:literal)*) => { [$((set_host::<$number>, main_entry::<$number>)),*] };
}

const FUNCTIONS: [Functions; ROOM] = functions!(
    0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31
    32 33 34 35 36 37 38 39 40 41 42 43 44 45 46 47 48 49 50 51 52 53 54 55 56 57 58 59 60 61 62 63
);

unsafe extern "C" fn set_host<const NUMBER: usize>(host: *mut OfxHost) {
    HOSTS[NUMBER].store(host, Ordering::Release);
}

unsafe extern "C" fn main_entry<const NUMBER: usize>(
    name: *const c_char,
    handle: *const c_void,
    in_args: Handle,
    _: Handle,
) -> c_int {
    let done = catch_unwind(AssertUnwindSafe(|| {
        if name.is_null() {
            return Err(Status::BAD_HANDLE);
        }
        // SAFETY: not NULL; the host gives a text with a closing NUL.
        let name = unsafe { CStr::from_ptr(name) };
        let effect = effects::all().get(NUMBER).ok_or(Status::BAD_HANDLE)?;
        act(effect, HOSTS[NUMBER].load(Ordering::Acquire), name, handle.cast_mut(), in_args)
    }));
    let status = done.unwrap_or_else(|panic| {
        // As in `guard`: the payload's own destructor could panic.
        std::mem::forget(panic);
        Err(Status::FAILED)
    });
    status.unwrap_or_else(|status| status).0
}

fn act(
    effect: &'static Effect,
    host: *mut OfxHost,
    action: &CStr,
    handle: Handle,
    in_args: Handle,
) -> Result<Status, Status> {
    match action.to_bytes() {
        // Nothing is kept for the library or for an instance; what an effect needs of its host is
        // seen when it is described.
        b"OfxActionLoad"
        | b"OfxActionUnload"
        | b"OfxActionCreateInstance"
        | b"OfxActionDestroyInstance"
        | b"OfxMeshEffectActionDescribeInContext" => Ok(Status::OK),
        b"OfxActionDescribe" => describe::describe(effect, &Suites::fetch(host)?, handle).map(|()| Status::OK),
        b"OfxMeshEffectActionCook" => cook::cook(effect, &Suites::fetch(host)?, handle, in_args).map(|()| Status::OK),
        // Whether an effect changes anything (`IsIdentity`) is found by cooking it, so that is left
        // to the default too.
        _ => Ok(Status::REPLY_DEFAULT),
    }
}
