//! The outputs of a run, as a host reads them.

use super::descriptor::{
    GUSSET_KIND_CURVES, GUSSET_KIND_MESH, GUSSET_KIND_TEXT, GUSSET_PLUGIN_DONE, GUSSET_PLUGIN_F64, GUSSET_PLUGIN_NONE,
    GUSSET_VALUE_ANGLE, GUSSET_VALUE_AREA, GUSSET_VALUE_COUNT, GUSSET_VALUE_FLAG, GUSSET_VALUE_LENGTH,
    GUSSET_VALUE_NUMBER, GUSSET_VALUE_VOLUME, gusset_failure, gusset_plugin_curves, gusset_plugin_mesh,
};
use super::outcome::{OutputForHost, RunFault, gusset_outputs};
use crate::capi::context::lend;
use crate::capi::handle;
use crate::capi::input::lend_list;
use crate::capi::mesh::{self, gusset_mesh_view};
use crate::capi::status::Failure;
use crate::filters::report::{ReportValue, ReportValueKind};
use std::ffi::{CStr, CString, c_char};
use std::ptr;

impl gusset_outputs {
    /// Output `index`, if it exists.
    pub(super) fn held_output(&self, index: u32) -> Result<&OutputForHost, Failure> {
        let no_such = || Failure::no_such_element("output", index as usize, self.outputs.len());
        self.outputs.get(index as usize).ok_or_else(no_such)
    }
}

/// Output `index`, if it exists.
pub(super) fn held_output_of_handle<'a>(
    outputs: *const gusset_outputs,
    index: u32,
) -> Result<&'a OutputForHost, Failure> {
    handle::get_object(outputs, "outputs").and_then(|outputs: &gusset_outputs| outputs.held_output(index))
}

pub(super) unsafe extern "C" fn output_count(outputs: *const gusset_outputs) -> u32 {
    handle::get_object(outputs, "outputs").map_or(0, |outputs: &gusset_outputs| outputs.outputs.len() as u32)
}

pub(super) unsafe extern "C" fn output_kind(outputs: *const gusset_outputs, index: u32) -> u32 {
    held_output_of_handle(outputs, index).map_or(0, |held| match held {
        OutputForHost::Mesh(..) => GUSSET_KIND_MESH,
        OutputForHost::Curves(_) => GUSSET_KIND_CURVES,
        OutputForHost::Text(..) => GUSSET_KIND_TEXT,
    })
}

pub(super) unsafe extern "C" fn output_mesh(
    outputs: *const gusset_outputs,
    index: u32,
    mesh: *mut gusset_plugin_mesh,
) -> i32 {
    // The layouts agree, as `inputs` asserts.
    let mesh = mesh.cast::<gusset_mesh_view>();
    let status = lend!(outputs, mesh, |outputs| match outputs.held_output(index)? {
        OutputForHost::Mesh(mesh, _) => mesh::lend_mesh(mesh),
        _ => return Err(Failure::wrong_output(index, "a mesh")),
    });
    status as i32
}

pub(super) unsafe extern "C" fn output_curves(
    outputs: *const gusset_outputs,
    index: u32,
    curves: *mut gusset_plugin_curves,
) -> i32 {
    let status = lend!(outputs, curves, |outputs| match outputs.held_output(index)? {
        OutputForHost::Curves(curves) => gusset_plugin_curves {
            struct_size: 0,
            points: lend_list(&curves.points).cast(),
            point_stride: size_of::<[f64; 3]>(),
            point_count: curves.points.len(),
            offsets: lend_list(&curves.offsets).cast(),
            // A bool is a byte, 0 or 1.
            closed: lend_list(&curves.closed).cast(),
            curve_count: curves.closed.len(),
            scalar: GUSSET_PLUGIN_F64,
            reserved: 0,
        },
        _ => return Err(Failure::wrong_output(index, "a set of curves")),
    });
    status as i32
}

pub(super) unsafe extern "C" fn output_text(outputs: *const gusset_outputs, index: u32) -> *const c_char {
    match held_output_of_handle(outputs, index) {
        Ok(OutputForHost::Text(text, _)) => text.as_ptr(),
        _ => ptr::null(),
    }
}

/// Returns the values of output `index`; empty unless it is a text.
fn values_of_text<'a>(outputs: *const gusset_outputs, index: u32) -> &'a [(CString, ReportValue)] {
    match held_output_of_handle(outputs, index) {
        Ok(OutputForHost::Text(_, values)) => values,
        _ => &[],
    }
}

pub(super) unsafe extern "C" fn output_value_count(outputs: *const gusset_outputs, index: u32) -> u32 {
    values_of_text(outputs, index).len() as u32
}

pub(super) unsafe extern "C" fn output_value_name(
    outputs: *const gusset_outputs,
    index: u32,
    which: u32,
) -> *const c_char {
    values_of_text(outputs, index).get(which as usize).map_or(ptr::null(), |(name, _)| name.as_ptr())
}

pub(super) unsafe extern "C" fn output_value(outputs: *const gusset_outputs, index: u32, which: u32) -> f64 {
    values_of_text(outputs, index).get(which as usize).map_or(f64::NAN, |&(_, value)| value.number)
}

pub(super) unsafe extern "C" fn output_value_kind(outputs: *const gusset_outputs, index: u32, which: u32) -> u32 {
    values_of_text(outputs, index).get(which as usize).map_or(0, |(_, value)| match value.kind {
        ReportValueKind::Count => GUSSET_VALUE_COUNT,
        ReportValueKind::Flag => GUSSET_VALUE_FLAG,
        ReportValueKind::Number => GUSSET_VALUE_NUMBER,
        ReportValueKind::Length => GUSSET_VALUE_LENGTH,
        ReportValueKind::Area => GUSSET_VALUE_AREA,
        ReportValueKind::Volume => GUSSET_VALUE_VOLUME,
        ReportValueKind::Angle => GUSSET_VALUE_ANGLE,
    })
}

pub(super) unsafe extern "C" fn output_failure(outputs: *const gusset_outputs, failure: *mut gusset_failure) -> i32 {
    let status = lend!(outputs, failure, |outputs| failure_report(outputs.fault.as_ref(), &outputs.message));
    status as i32
}

/// Returns the failure that the host receives, or the absence of one.
pub(super) fn failure_report(fault: Option<&RunFault>, message: &CStr) -> gusset_failure {
    let mut report = gusset_failure {
        struct_size: 0,
        message: message.as_ptr(),
        status: GUSSET_PLUGIN_DONE,
        param: GUSSET_PLUGIN_NONE,
        input: GUSSET_PLUGIN_NONE,
        element: 0,
        index: 0,
        value: 0.0,
    };
    if let Some(fault) = fault {
        let failure = &fault.failure;
        report.status = failure.status as i32;
        report.param = fault.param.unwrap_or(GUSSET_PLUGIN_NONE);
        report.input = fault.input.unwrap_or(GUSSET_PLUGIN_NONE);
        (report.element, report.index, report.value) = (failure.element, failure.index, failure.value);
    }
    report
}

pub(super) unsafe extern "C" fn free_outputs(outputs: *mut gusset_outputs) {
    handle::destroy(outputs);
}
