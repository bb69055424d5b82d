//! The tables behind the one symbol, made once of [`FILTERS`] and never freed, and the functions in
//! them by which filters are found and run. Texts get their closing NUL here.

use super::attributes::ATTRIBUTES;
use super::descriptor::*;
use super::inputs::{self, Given};
use super::outcome::{Fault, gusset_outputs};
use super::outputs;
use crate::capi::glue::c_enum;
use crate::capi::guard::caught;
use crate::capi::handle;
use crate::capi::host::{Host, Watch};
use crate::capi::input::{self, Choice};
use crate::capi::status::{Failure, gusset_status};
use crate::error::{Error, Side};
use crate::filters::data::{Input, InputKind, Output, OutputKind};
use crate::filters::param::{Param, ParamKind};
use crate::filters::{FILTERS, Filter};
use crate::job::Job;
use std::ffi::{CStr, CString, c_char, c_void};
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
            version: crate::capi::version::gusset_version(),
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
            flags: if of.replaces { GUSSET_FILTER_REPLACES } else { 0 }
                | if of.has_origins { GUSSET_FILTER_ORIGINS } else { 0 },
            param_count: of.params.len() as u32,
            value_count,
            reserved: 0,
            param: param_at,
            suggest,
            run,
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
    entry(of).and_then(|(entry, _)| entry.params.get(index as usize)).map_or(ptr::null(), ptr::from_ref)
}

static VALUES: gusset_plugin_values = gusset_plugin_values {
    struct_size: size_of::<gusset_plugin_values>(),
    count: outputs::value_count,
    name: outputs::value_name,
    value: outputs::value,
};

unsafe extern "C" fn extension(name: *const c_char) -> *const c_void {
    if name.is_null() {
        return ptr::null();
    }
    // SAFETY: not NULL; that it points to a text with a closing NUL is the host's promise.
    match unsafe { CStr::from_ptr(name) }.to_bytes() {
        b"values/1" => (&raw const VALUES).cast(),
        b"attributes/1" => (&raw const ATTRIBUTES).cast(),
        _ => ptr::null(),
    }
}

/// As the descriptor says of `run`.
unsafe extern "C" fn run(
    filter: *const gusset_filter,
    host: *const gusset_host,
    given: *const gusset_input,
    input_count: u32,
    values: *const f64,
    value_count: u32,
    outputs: *mut *mut gusset_outputs,
) -> i32 {
    let slot = match input::output(outputs, ptr::null_mut(), "outputs") {
        Ok(slot) => slot,
        Err(failure) => return failure.status as i32,
    };
    let outcome: Result<_, Fault> = caught(|| {
        let filter = meant(filter)?;
        let (threads, callbacks) = inputs::host(host)?;
        let traced = inputs::wants_origins(host)?;
        let watch = Watch::default();
        let host = Host::new(&watch, callbacks);
        let job = Job::new(threads, &host);
        // Before the inputs are looked at: a host that has stopped waiting waits no longer.
        job.step(0.0, "reading inputs")?;
        let given = inputs::inputs(filter, given, input_count, &job.part(0.0, 0.05))?;
        let given: Vec<Input<'_>> = given.iter().map(Given::lend).collect();
        // No more of them are read than the filter has.
        filter.check_value_count(value_count as usize)?;
        let values = input::list(values, value_count as usize, "values")?;
        let outputs = answer(filter, &given, &values, traced, &job.part(0.05, 1.0))?;
        let outputs = handle::boxed(gusset_outputs::of(outputs)?);
        job.finish()?;
        Ok(outputs)
    });
    match outcome {
        Ok(outputs) => {
            *slot = handle::give(outputs);
            GUSSET_PLUGIN_DONE
        }
        Err(fault) => {
            let status = fault.failure.status as i32;
            if let Ok(failed) = caught(|| Ok::<_, Failure>(handle::boxed(gusset_outputs::failed(fault)))) {
                *slot = handle::give(failed);
            }
            status
        }
    }
}

/// As the descriptor says of `suggest`.
unsafe extern "C" fn suggest(
    filter: *const gusset_filter,
    given: *const gusset_input,
    input_count: u32,
    values: *mut f64,
) -> i32 {
    let outcome: Result<_, Fault> = caught(|| {
        let filter = meant(filter)?;
        let plain = filter.plain_defaults();
        let out = input::results(values, plain.len(), "values")?;
        out.copy_from_slice(&plain);
        let given = inputs::inputs(filter, given, input_count, &Job::default())?;
        let given: Vec<Input<'_>> = given.iter().map(Given::lend).collect();
        out.copy_from_slice(&filter.defaults(&given));
        Ok(())
    });
    outcome.map_or_else(|fault| fault.failure.status as i32, |()| GUSSET_PLUGIN_DONE)
}

/// What a host means by a pointer into the tables.
fn entry(of: *const gusset_filter) -> Option<(&'static Entry, &'static Filter)> {
    get().filters.iter().zip(FILTERS).find(|(entry, _)| ptr::eq(&raw const entry.filter, of))
}

fn meant(filter: *const gusset_filter) -> Result<&'static Filter, Failure> {
    if filter.is_null() {
        return Err(Failure::null("filter"));
    }
    let unknown = || Failure::new(gusset_status::GUSSET_ERROR_NO_SUCH_ELEMENT, "this filter is none of the plugin's");
    entry(filter).map(|(_, filter)| filter).ok_or_else(unknown)
}

fn answer(
    filter: &Filter,
    given: &[Input<'_>],
    values: &[f64],
    traced: bool,
    job: &Job<'_>,
) -> Result<Vec<Output>, Fault> {
    let outcome = if traced { filter.run_traced(given, values, job) } else { filter.run(given, values, job) };
    outcome.map_err(|error| {
        let param = match error {
            Error::OptionOutOfRange { option, .. } => filter.params.iter().position(|param| param.id == option),
            _ => None,
        };
        let unfit = if let Error::InputUnfit { input, .. } = error { Some(input) } else { None };
        let (side, fault) = (error.side(), Fault::from(error));
        // An element may be one of any input, unless there is one only, or the error says of which
        // of two it is.
        let input = match (given.len(), side) {
            _ if unfit.is_some() => unfit,
            (1, _) => fault.input.map(|_| 0),
            (2, Some(side)) => Some(u32::from(side == Side::B)),
            _ => None,
        };
        Fault { input, param: param.map(|place| place as u32), ..fault }
    })
}
