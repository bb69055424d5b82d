//! A run of a filter, and the values suggested for one.

use super::descriptor::{GUSSET_PLUGIN_DONE, GUSSET_PLUGIN_NONE, gusset_filter, gusset_host, gusset_input};
use super::inputs::{self, Host};
use super::outputs::gusset_outputs;
use super::table;
use crate::error::{Error, Side};
use crate::ffi::input;
use crate::ffi::status::{Failure, gusset_status};
use crate::filters::Filter;
use crate::filters::data::{Input, Output};
use crate::job::Job;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr;

/// As the descriptor says of `run`.
pub(super) unsafe extern "C" fn run(
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
    let outcome = caught(|| {
        let filter = meant(filter)?;
        let host = Host::new(host)?;
        // Before the inputs are looked at: a host that has stopped waiting waits no longer.
        host.job().step(0.0, "reading inputs")?;
        let given = inputs::inputs(filter, given, input_count, &host.job().part(0.0, 0.05))?;
        let given: Vec<Input<'_>> = given.iter().map(inputs::Given::lend).collect();
        let values = inputs::values(filter, values, value_count)?;
        answer(filter, &given, &values, &host.job().part(0.05, 1.0))
    });
    let status = outcome.as_ref().map_or_else(|fault| fault.failure.status as i32, |_| GUSSET_PLUGIN_DONE);
    // Only texts are copied here: nothing that could fail but memory itself.
    if let Ok(done) = catch_unwind(AssertUnwindSafe(|| Box::new(gusset_outputs::new(outcome)))) {
        *slot = Box::into_raw(done);
    }
    status
}

/// As the descriptor says of `suggest`.
pub(super) unsafe extern "C" fn suggest(
    filter: *const gusset_filter,
    given: *const gusset_input,
    input_count: u32,
    values: *mut f64,
) -> i32 {
    let outcome = caught(|| {
        let filter = meant(filter)?;
        let plain = filter.plain_defaults();
        let out = input::results(values, plain.len(), "values")?;
        out.copy_from_slice(&plain);
        let given = inputs::inputs(filter, given, input_count, &Job::default())?;
        let given: Vec<Input<'_>> = given.iter().map(inputs::Given::lend).collect();
        out.copy_from_slice(&filter.defaults(&given));
        Ok(())
    });
    outcome.map_or_else(|fault| fault.failure.status as i32, |()| GUSSET_PLUGIN_DONE)
}

/// A failure, and the numbers of the parameter and of the input that it is about, or
/// GUSSET_PLUGIN_NONE.
pub(super) struct Fault {
    pub(super) failure: Failure,
    pub(super) param: u32,
    pub(super) input: u32,
}

impl<F: Into<Failure>> From<F> for Fault {
    fn from(failure: F) -> Self {
        let failure = failure.into();
        // Without an element it need not be about an input.
        let names_input = (failure.element != 0 || failure.input != 0) && !is_environment(&failure);
        let input = if names_input { failure.input } else { GUSSET_PLUGIN_NONE };
        Fault { failure, param: GUSSET_PLUGIN_NONE, input }
    }
}

impl Fault {
    /// The same of input `input`, whatever it is about in it.
    pub(super) fn of_input(self, input: u32) -> Self {
        if is_environment(&self.failure) { self } else { Fault { input, ..self } }
    }
}

/// A cancel or a want of memory is no input's fault.
fn is_environment(failure: &Failure) -> bool {
    use gusset_status::{GUSSET_ERROR_CANCELLED, GUSSET_ERROR_OUT_OF_MEMORY};
    matches!(failure.status, GUSSET_ERROR_CANCELLED | GUSSET_ERROR_OUT_OF_MEMORY)
}

fn caught<T>(body: impl FnOnce() -> Result<T, Fault>) -> Result<T, Fault> {
    catch_unwind(AssertUnwindSafe(body)).unwrap_or_else(|panic| {
        // As in `guard`: the payload's own destructor could panic.
        std::mem::forget(panic);
        Err(Failure::new(gusset_status::GUSSET_ERROR_PANIC, "internal error: please report it").into())
    })
}

fn meant(filter: *const gusset_filter) -> Result<&'static Filter, Failure> {
    if filter.is_null() {
        return Err(Failure::null("filter"));
    }
    let unknown = || Failure::new(gusset_status::GUSSET_ERROR_NO_SUCH_ELEMENT, "this filter is none of the plugin's");
    table::meant(filter).ok_or_else(unknown)
}

fn answer(filter: &Filter, given: &[Input<'_>], values: &[f64], job: &Job<'_>) -> Result<Vec<Output>, Fault> {
    filter.run(given, values, job).map_err(|error| {
        let param = match error {
            Error::OptionOutOfRange { option, .. } => filter.params.iter().position(|param| param.id == option),
            _ => None,
        };
        let unfit = if let Error::InputUnfit { input, .. } = error { Some(input) } else { None };
        let (side, fault) = (error.side(), Fault::from(error));
        // An element may be one of any input, unless there is one only, or the error says of which
        // of two it is.
        let input = match (given.len(), side) {
            _ if unfit.is_some() => unfit.unwrap_or(GUSSET_PLUGIN_NONE),
            (1, _) if fault.input != GUSSET_PLUGIN_NONE => 0,
            (2, Some(side)) => u32::from(side == Side::B),
            _ => GUSSET_PLUGIN_NONE,
        };
        Fault { input, param: param.map_or(GUSSET_PLUGIN_NONE, |place| place as u32), ..fault }
    })
}
