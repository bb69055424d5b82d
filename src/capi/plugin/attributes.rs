//! The extension for attributes: transfers values from the inputs' elements to the outputs of a
//! run.

use super::channels::{
    gusset_plugin_attributes, gusset_plugin_channel, gusset_plugin_channel_values, gusset_plugin_origins,
};
use super::descriptor::{GUSSET_PLUGIN_DONE, gusset_failure, gusset_host};
use super::inputs;
use super::outcome::{OutputForHost, RunFault, gusset_outputs};
use super::outputs::{failure_report, held_output_of_handle};
use crate::attributes::Origins;
use crate::capi::context::lend;
use crate::capi::guard::catch_panic;
use crate::capi::host::{CallWatch, HostProgress};
use crate::capi::input::{self, lend_list, read_choice};
use crate::capi::mesh::attributes::{carry_over_channel, gusset_channel};
use crate::capi::status::{self, Failure};
use crate::job::Job;
use std::ffi::c_void;

pub(super) static ATTRIBUTE_FUNCTIONS: gusset_plugin_attributes = gusset_plugin_attributes {
    struct_size: size_of::<gusset_plugin_attributes>(),
    has_origins: output_has_origins,
    origins: output_origins,
    apply: apply_channel,
};

/// Returns the origins of output `index`.
fn origins_of_output(held: &OutputForHost, index: u32) -> Result<&Origins, Failure> {
    match held {
        OutputForHost::Mesh(_, Some(origins)) => Ok(origins),
        _ => Err(Failure::wrong_output(index, "a mesh with origins; request origins from the run")),
    }
}

unsafe extern "C" fn output_has_origins(outputs: *const gusset_outputs, index: u32) -> u32 {
    held_output_of_handle(outputs, index).and_then(|held| origins_of_output(held, index)).is_ok().into()
}

unsafe extern "C" fn output_origins(
    outputs: *const gusset_outputs,
    index: u32,
    domain: u32,
    origins: *mut gusset_plugin_origins,
) -> i32 {
    let status = lend!(outputs, origins, |outputs| {
        let of = origins_of_output(outputs.held_output(index)?, index)?;
        let domain = read_choice(domain)?;
        let (table, starts) = (of.table(domain), of.first_sources_of_inputs(domain));
        gusset_plugin_origins {
            struct_size: 0,
            count: table.len(),
            offsets: lend_list(table.offsets()),
            sources: lend_list(table.source_indices()),
            weights: lend_list(table.weights()),
            input_count: of.inputs().len(),
            starts: lend_list(starts),
        }
    });
    status as i32
}

/// Implements `apply` of the descriptor.
unsafe extern "C" fn apply_channel(
    outputs: *const gusset_outputs,
    index: u32,
    host: *const gusset_host,
    channel: *const gusset_plugin_channel,
    values_of_inputs: *const gusset_plugin_channel_values,
    input_count: u32,
    values: *mut c_void,
    count: usize,
    stride: usize,
    failure: *mut gusset_failure,
) -> i32 {
    let told = (!failure.is_null()).then(|| input::output_struct(failure, "failure")).transpose();
    let told = match told {
        Ok(told) => told,
        Err(failure) => return failure.status as i32,
    };
    let outcome: Result<(), RunFault> = catch_panic(|| {
        let (threads, callbacks) = inputs::read_host(host)?;
        let watch = CallWatch::default();
        let host = HostProgress::new(&watch, callbacks);
        let job = Job::new(threads, &host);
        let origins = origins_of_output(held_output_of_handle(outputs, index)?, index)?;
        // The layouts agree, as `channels` asserts.
        let channel = input::read_versioned_struct(channel.cast::<gusset_channel>(), false, "channel")?;
        let inputs = (values_of_inputs.cast(), input_count as usize);
        carry_over_channel(origins, channel, inputs, (values, count, stride), &job)?;
        Ok(job.finish()?)
    });
    let fault = outcome.err();
    let status = fault.as_ref().map_or(GUSSET_PLUGIN_DONE, |fault| fault.failure.status as i32);
    if let Some(told) = told {
        told.write_known_fields(failure_report(
            fault.as_ref(),
            if fault.is_some() { status::status_text(status) } else { c"" },
        ));
    }
    status
}
