//! The extension for attributes: transfers values from the inputs' elements to the outputs of a
//! run.

use super::channels::{
    gusset_plugin_attributes, gusset_plugin_channel, gusset_plugin_channel_values, gusset_plugin_origins,
};
use super::descriptor::{GUSSET_PLUGIN_DONE, gusset_failure, gusset_host};
use super::inputs;
use super::outcome::{Fault, Held, gusset_outputs};
use super::outputs::{held, report};
use crate::attributes::Origins;
use crate::capi::context::lend;
use crate::capi::guard::catch_panic;
use crate::capi::host::{Host, Watch};
use crate::capi::input::{self, choice, lent};
use crate::capi::mesh::attributes::{carry_over, gusset_channel};
use crate::capi::status::{self, Failure};
use crate::job::Job;
use std::ffi::c_void;

pub(super) static ATTRIBUTES: gusset_plugin_attributes = gusset_plugin_attributes {
    struct_size: size_of::<gusset_plugin_attributes>(),
    has_origins: output_has_origins,
    origins,
    apply,
};

/// Returns the origins of output `index`.
fn output_origins(held: &Held, index: u32) -> Result<&Origins, Failure> {
    match held {
        Held::Mesh(_, Some(origins)) => Ok(origins),
        _ => Err(Failure::no_such("output with origins", index as usize)),
    }
}

unsafe extern "C" fn output_has_origins(outputs: *const gusset_outputs, index: u32) -> u32 {
    held(outputs, index).and_then(|held| output_origins(held, index)).is_ok().into()
}

unsafe extern "C" fn origins(
    outputs: *const gusset_outputs,
    index: u32,
    domain: u32,
    origins: *mut gusset_plugin_origins,
) -> i32 {
    let status = lend!(outputs, origins, |outputs| {
        let of = output_origins(outputs.get(index)?, index)?;
        let domain = choice(domain)?;
        let (table, starts) = (of.table(domain), of.starts(domain));
        gusset_plugin_origins {
            struct_size: 0,
            count: table.len(),
            offsets: lent(table.offsets()),
            sources: lent(table.source_indices()),
            weights: lent(table.weights()),
            input_count: of.inputs().len(),
            starts: lent(starts),
        }
    });
    status as i32
}

/// Implements `apply` of the descriptor.
unsafe extern "C" fn apply(
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
    let outcome: Result<(), Fault> = catch_panic(|| {
        let (threads, callbacks) = inputs::host(host)?;
        let watch = Watch::default();
        let host = Host::new(&watch, callbacks);
        let job = Job::new(threads, &host);
        let origins = output_origins(held(outputs, index)?, index)?;
        // The layouts agree, as `channels` asserts.
        let channel = input::read(channel.cast::<gusset_channel>(), false, "channel")?;
        let inputs = (values_of_inputs.cast(), input_count as usize);
        carry_over(origins, channel, inputs, (values, count, stride), &job)?;
        Ok(job.finish()?)
    });
    let fault = outcome.err();
    let status = fault.as_ref().map_or(GUSSET_PLUGIN_DONE, |fault| fault.failure.status as i32);
    if let Some(told) = told {
        told.write(report(fault.as_ref(), if fault.is_some() { status::text(status) } else { c"" }));
    }
    status
}
