//! The tables behind the one symbol, made once of [`FILTERS`] and never freed: texts get their
//! closing NUL here.

use super::descriptor::{
    GUSSET_FILTER_REPLACES, GUSSET_KIND_CURVES, GUSSET_KIND_MESH, GUSSET_KIND_TEXT, GUSSET_PARAM_ANGLE,
    GUSSET_PARAM_BOOL, GUSSET_PARAM_CHOICE, GUSSET_PARAM_DIRECTION, GUSSET_PARAM_INT, GUSSET_PARAM_LENGTH,
    GUSSET_PARAM_PLANE, GUSSET_PARAM_POINT, GUSSET_PARAM_REAL, GUSSET_PLUGIN_ABI, gusset_choice, gusset_filter,
    gusset_param_info, gusset_plugin,
};
use super::{outputs, run};
use crate::ffi::glue::c_enum;
use crate::ffi::input::Choice;
use crate::filters::data::{InputKind, OutputKind};
use crate::filters::param::{Param, ParamKind};
use crate::filters::{FILTERS, Filter};
use libc::{c_char, c_void};
use std::ffi::{CStr, CString};
use std::ptr;
use std::sync::OnceLock;

/// Everything that a host may look at.
pub(super) struct Table {
    pub(super) plugin: gusset_plugin,
    /// In the order of [`FILTERS`].
    filters: Vec<Entry>,
}

/// What a filter becomes.
struct Entry {
    filter: gusset_filter,
    params: Vec<gusset_param_info>,
}

// SAFETY: its pointers are to memory that is never written again and never freed.
unsafe impl Send for Table {}
// SAFETY: as above.
unsafe impl Sync for Table {}

/// The tables; made at the first call.
pub(super) fn get() -> &'static Table {
    static TABLE: OnceLock<Table> = OnceLock::new();
    TABLE.get_or_init(|| Table {
        plugin: gusset_plugin {
            struct_size: size_of::<gusset_plugin>(),
            abi: GUSSET_PLUGIN_ABI,
            filter_count: FILTERS.len() as u32,
            id: c"gusset".as_ptr(),
            name: c"gusset".as_ptr(),
            version: crate::ffi::version::gusset_version(),
            vendor: c"the gusset authors".as_ptr(),
            description: text(env!("CARGO_PKG_DESCRIPTION")),
            license: text(env!("CARGO_PKG_LICENSE")),
            filter,
            find,
            output_count: outputs::count,
            output_kind: outputs::kind,
            output_mesh: outputs::mesh,
            output_curves: outputs::curves,
            output_text: outputs::text,
            output_failure: outputs::failure,
            output_free: outputs::free,
            extension,
        },
        filters: FILTERS.iter().map(Entry::new).collect(),
    })
}

/// The filter that a host means by a pointer into the tables, if it is one.
pub(super) fn meant(filter: *const gusset_filter) -> Option<&'static Filter> {
    let place = get().filters.iter().position(|entry| ptr::eq(&raw const entry.filter, filter))?;
    FILTERS.get(place)
}

/// Never freed: part of the tables.
fn text(of: &str) -> *const c_char {
    // A text with a NUL inside ends there.
    CString::new(of.split('\0').next().unwrap_or_default()).unwrap_or_default().into_raw()
}

/// Never freed: part of the tables.
fn kept<T>(items: Vec<T>) -> *const T {
    if items.is_empty() { ptr::null() } else { Vec::leak(items).as_ptr() }
}

impl Entry {
    fn new(of: &'static Filter) -> Self {
        let mut value_count = 0;
        let params = of.params.iter().map(|of| param(of, &mut value_count)).collect();
        let filter = gusset_filter {
            struct_size: size_of::<gusset_filter>(),
            id: text(of.id),
            name: text(of.name),
            script_name: text(of.script_name()),
            category: text(of.category),
            help: text(of.help),
            reference: text(of.reference),
            input_kinds: kept(of.inputs.iter().map(|&kind| kind.number()).collect()),
            output_kinds: kept(of.outputs.iter().map(|&kind| kind.number()).collect()),
            input_kind_count: of.inputs.len() as u32,
            min_inputs: of.min_inputs as u32,
            max_inputs: u32::try_from(of.max_inputs).unwrap_or(u32::MAX),
            output_count: of.outputs.len() as u32,
            flags: if of.replaces { GUSSET_FILTER_REPLACES } else { 0 },
            param_count: of.params.len() as u32,
            value_count,
            reserved: 0,
            param: param_at,
            suggest: run::suggest,
            run: run::run,
        };
        Entry { filter, params }
    }
}

fn param(of: &'static Param, value_count: &mut u32) -> gusset_param_info {
    let arity = of.kind.arity() as u32;
    let first_value = *value_count;
    *value_count += arity;
    let choices = of.choices.iter().map(|of| gusset_choice { label: text(of.label), help: text(of.help) });
    gusset_param_info {
        struct_size: size_of::<gusset_param_info>(),
        id: text(of.id),
        label: text(of.label),
        help: text(of.help),
        kind: of.kind.number(),
        arity,
        min: of.min,
        max: of.max,
        default_values: of.default.as_ptr(),
        step: of.step,
        choices: kept(choices.collect()),
        choice_count: of.choices.len() as u32,
        first_value,
    }
}

c_enum! {
    kind: ParamKind {
        GUSSET_PARAM_BOOL => Bool,
        GUSSET_PARAM_INT => Int,
        GUSSET_PARAM_REAL => Real,
        GUSSET_PARAM_CHOICE => Choice,
        GUSSET_PARAM_LENGTH => Length,
        GUSSET_PARAM_ANGLE => Angle,
        GUSSET_PARAM_POINT => Point,
        GUSSET_PARAM_DIRECTION => Direction,
        GUSSET_PARAM_PLANE => Plane,
    }
    kind: InputKind { GUSSET_KIND_MESH => Mesh, GUSSET_KIND_CURVES => Curves }
    kind: OutputKind { GUSSET_KIND_MESH => Mesh, GUSSET_KIND_CURVES => Curves, GUSSET_KIND_TEXT => Text }
}

unsafe extern "C" fn filter(index: u32) -> *const gusset_filter {
    get().filters.get(index as usize).map_or(ptr::null(), |entry| &raw const entry.filter)
}

unsafe extern "C" fn find(id: *const c_char) -> *const gusset_filter {
    if id.is_null() {
        return ptr::null();
    }
    // SAFETY: not NULL; that it points to a text with a closing NUL is the host's promise.
    let id = unsafe { CStr::from_ptr(id) };
    let place = FILTERS.iter().position(|filter| filter.id.as_bytes() == id.to_bytes());
    place.map_or(ptr::null(), |place| &raw const get().filters[place].filter)
}

unsafe extern "C" fn param_at(of: *const gusset_filter, index: u32) -> *const gusset_param_info {
    let entry = get().filters.iter().find(|entry| ptr::eq(&raw const entry.filter, of));
    entry.and_then(|entry| entry.params.get(index as usize)).map_or(ptr::null(), ptr::from_ref)
}

unsafe extern "C" fn extension(_: *const c_char) -> *const c_void {
    ptr::null()
}
