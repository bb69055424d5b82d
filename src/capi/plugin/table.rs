//! The tables behind the entry symbol, built once from [`FILTERS`] and never freed, and the
//! functions in them that find and run filters. Texts get their closing NUL here.

use super::attributes::ATTRIBUTE_FUNCTIONS;
use super::descriptor::*;
use super::inputs::{self, GivenInput};
use super::outcome::{RunFault, gusset_outputs};
use super::outputs;
use crate::capi::glue::c_enum;
use crate::capi::guard::catch_panic;
use crate::capi::handle;
use crate::capi::host::{CallWatch, HostProgress};
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

/// All data that a host may read.
pub(super) struct PluginTable {
    pub(super) plugin: gusset_plugin,
    /// In the order of [`FILTERS`].
    filters: Vec<FilterEntry>,
}

/// The host's view of a filter.
struct FilterEntry {
    filter: gusset_filter,
    params: Vec<gusset_param_info>,
}

// SAFETY: its pointers are to memory that is never written again and never freed.
unsafe impl Send for PluginTable {}
// SAFETY: as above.
unsafe impl Sync for PluginTable {}

/// Returns the tables, which the first call builds.
pub(super) fn plugin_table() -> &'static PluginTable {
    static PLUGIN_TABLE: OnceLock<PluginTable> = OnceLock::new();
    PLUGIN_TABLE.get_or_init(|| PluginTable {
        plugin: gusset_plugin {
            struct_size: size_of::<gusset_plugin>(),
            abi: GUSSET_PLUGIN_ABI,
            filter_count: FILTERS.len() as u32,
            id: c"gusset".as_ptr(),
            name: c"gusset".as_ptr(),
            version: crate::capi::version::gusset_version(),
            vendor: c"the gusset authors".as_ptr(),
            description: leak_text(env!("CARGO_PKG_DESCRIPTION")),
            license: leak_text(env!("CARGO_PKG_LICENSE")),
            filter: filter_at,
            find: find_filter,
            output_count: outputs::output_count,
            output_kind: outputs::output_kind,
            output_mesh: outputs::output_mesh,
            output_curves: outputs::output_curves,
            output_text: outputs::output_text,
            output_failure: outputs::output_failure,
            output_free: outputs::free_outputs,
            extension: find_extension,
        },
        filters: FILTERS.iter().map(FilterEntry::new).collect(),
    })
}

/// Leaks a text, as part of the tables.
fn leak_text(of: &str) -> *const c_char {
    // A text with a NUL inside ends there.
    CString::new(of.split('\0').next().unwrap_or_default()).unwrap_or_default().into_raw()
}

/// Leaks a list, as part of the tables.
fn leak_list<T>(items: Vec<T>) -> *const T {
    if items.is_empty() { ptr::null() } else { Vec::leak(items).as_ptr() }
}

impl FilterEntry {
    fn new(of: &'static Filter) -> Self {
        let mut value_count = 0;
        let params = of.params.iter().map(|of| param_info(of, &mut value_count)).collect();
        let filter = gusset_filter {
            struct_size: size_of::<gusset_filter>(),
            id: leak_text(of.id),
            name: leak_text(of.name),
            script_name: leak_text(of.script_name()),
            category: leak_text(of.category),
            help: leak_text(of.help),
            reference: leak_text(of.reference),
            input_kinds: leak_list(of.inputs.iter().map(|&kind| kind.number()).collect()),
            output_kinds: leak_list(of.outputs.iter().map(|&kind| kind.number()).collect()),
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
            suggest: suggest_values,
            run: run_filter,
        };
        FilterEntry { filter, params }
    }
}

fn param_info(of: &'static Param, value_count: &mut u32) -> gusset_param_info {
    let arity = of.kind.component_count() as u32;
    let first_value = *value_count;
    *value_count += arity;
    let choices = of.choices.iter().map(|of| gusset_choice { label: leak_text(of.label), help: leak_text(of.help) });
    gusset_param_info {
        struct_size: size_of::<gusset_param_info>(),
        id: leak_text(of.id),
        label: leak_text(of.label),
        help: leak_text(of.help),
        kind: of.kind.number(),
        arity,
        min: of.min,
        max: of.max,
        default_values: of.default.as_ptr(),
        step: of.step,
        choices: leak_list(choices.collect()),
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

unsafe extern "C" fn filter_at(index: u32) -> *const gusset_filter {
    plugin_table().filters.get(index as usize).map_or(ptr::null(), |entry| &raw const entry.filter)
}

unsafe extern "C" fn find_filter(id: *const c_char) -> *const gusset_filter {
    if id.is_null() {
        return ptr::null();
    }
    // SAFETY: not NULL; the host promises that it points to a text with a closing NUL.
    let id = unsafe { CStr::from_ptr(id) };
    let place = FILTERS.iter().position(|filter| filter.id.as_bytes() == id.to_bytes());
    place.map_or(ptr::null(), |place| &raw const plugin_table().filters[place].filter)
}

unsafe extern "C" fn param_at(of: *const gusset_filter, index: u32) -> *const gusset_param_info {
    entry_of_pointer(of).and_then(|(entry, _)| entry.params.get(index as usize)).map_or(ptr::null(), ptr::from_ref)
}

static VALUE_FUNCTIONS: gusset_plugin_values = gusset_plugin_values {
    struct_size: size_of::<gusset_plugin_values>(),
    count: outputs::output_value_count,
    name: outputs::output_value_name,
    value: outputs::output_value,
    kind: outputs::output_value_kind,
};

unsafe extern "C" fn find_extension(name: *const c_char) -> *const c_void {
    if name.is_null() {
        return ptr::null();
    }
    // SAFETY: not NULL; the host promises that it points to a text with a closing NUL.
    match unsafe { CStr::from_ptr(name) }.to_bytes() {
        b"values/1" => (&raw const VALUE_FUNCTIONS).cast(),
        b"attributes/1" => (&raw const ATTRIBUTE_FUNCTIONS).cast(),
        _ => ptr::null(),
    }
}

/// Implements `run` of the descriptor.
unsafe extern "C" fn run_filter(
    filter: *const gusset_filter,
    host: *const gusset_host,
    given: *const gusset_input,
    input_count: u32,
    values: *const f64,
    value_count: u32,
    outputs: *mut *mut gusset_outputs,
) -> i32 {
    let slot = match input::cleared_output(outputs, ptr::null_mut(), "outputs") {
        Ok(slot) => slot,
        Err(failure) => return failure.status as i32,
    };
    let outcome: Result<_, RunFault> = catch_panic(|| {
        let filter = filter_of_pointer(filter)?;
        let (threads, callbacks) = inputs::read_host(host)?;
        let traced = inputs::wants_origins(host)?;
        let watch = CallWatch::default();
        let host = HostProgress::new(&watch, callbacks);
        let job = Job::new(threads, &host);
        // Before reading the inputs, so that a host that has cancelled does not wait.
        job.step(0.0, "reading inputs")?;
        let given = inputs::read_inputs(filter, given, input_count, &job.sub_job(0.0, 0.05))?;
        let given: Vec<Input<'_>> = given.iter().map(GivenInput::as_filter_input).collect();
        // Read at most as many values as the filter has.
        filter.check_value_count(value_count as usize)?;
        let values = input::copy_input_items(values, value_count as usize, "values")?;
        let outputs = run_and_locate_fault(filter, &given, &values, traced, &job.sub_job(0.05, 1.0))?;
        let outputs = handle::box_with_kind(gusset_outputs::from_outputs(outputs)?);
        job.finish()?;
        Ok(outputs)
    });
    match outcome {
        Ok(outputs) => {
            *slot = handle::into_handle(outputs);
            GUSSET_PLUGIN_DONE
        }
        Err(fault) => {
            let status = fault.failure.status as i32;
            if let Ok(failed) =
                catch_panic(|| Ok::<_, Failure>(handle::box_with_kind(gusset_outputs::from_fault(fault))))
            {
                *slot = handle::into_handle(failed);
            }
            status
        }
    }
}

/// Implements `suggest` of the descriptor.
unsafe extern "C" fn suggest_values(
    filter: *const gusset_filter,
    given: *const gusset_input,
    input_count: u32,
    values: *mut f64,
) -> i32 {
    let outcome: Result<_, RunFault> = catch_panic(|| {
        let filter = filter_of_pointer(filter)?;
        let plain = filter.plain_defaults();
        let out = input::result_buffer(values, plain.len(), "values")?;
        out.copy_from_slice(&plain);
        let given = inputs::read_inputs(filter, given, input_count, &Job::default())?;
        let given: Vec<Input<'_>> = given.iter().map(GivenInput::as_filter_input).collect();
        out.copy_from_slice(&filter.defaults(&given));
        Ok(())
    });
    outcome.map_or_else(|fault| fault.failure.status as i32, |()| GUSSET_PLUGIN_DONE)
}

/// Resolves a host's pointer into the tables.
fn entry_of_pointer(pointer: *const gusset_filter) -> Option<(&'static FilterEntry, &'static Filter)> {
    plugin_table().filters.iter().zip(FILTERS).find(|(entry, _)| ptr::eq(&raw const entry.filter, pointer))
}

fn filter_of_pointer(filter: *const gusset_filter) -> Result<&'static Filter, Failure> {
    if filter.is_null() {
        return Err(Failure::null_argument("filter"));
    }
    let unknown = || {
        Failure::new(
            gusset_status::GUSSET_ERROR_NO_SUCH_ELEMENT,
            "filter does not belong to the plugin; take it from the plugin's table",
        )
    };
    entry_of_pointer(filter).map(|(_, filter)| filter).ok_or_else(unknown)
}

fn run_and_locate_fault(
    filter: &Filter,
    given: &[Input<'_>],
    values: &[f64],
    traced: bool,
    job: &Job<'_>,
) -> Result<Vec<Output>, RunFault> {
    let outcome = if traced { filter.run_traced(given, values, job) } else { filter.run(given, values, job) };
    outcome.map_err(|error| {
        let param = match error {
            Error::OptionOutOfRange { option, .. } => filter.params.iter().position(|param| param.id == option),
            _ => None,
        };
        let unfit = match error {
            Error::InputUnfit { input, .. } | Error::CurveCount { input, .. } | Error::MeshNotClosed { input, .. } => {
                Some(input)
            }
            _ => None,
        };
        let (side, fault) = (error.side(), RunFault::from(error));
        // An element may belong to any input, unless there is only one, or the error names one of
        // two.
        let input = match (given.len(), side) {
            _ if unfit.is_some() => unfit,
            (1, _) => fault.input.map(|_| 0),
            (2, Some(side)) => Some(u32::from(side == Side::B)),
            _ => None,
        };
        RunFault { input, param: param.map(|place| place as u32), ..fault }
    })
}
