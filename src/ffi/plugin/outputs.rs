//! What a run leaves, and how a host reads it.

use super::descriptor::{
    GUSSET_KIND_CURVES, GUSSET_KIND_MESH, GUSSET_KIND_TEXT, GUSSET_PLUGIN_DONE, GUSSET_PLUGIN_F64, GUSSET_PLUGIN_NONE,
    gusset_failure, gusset_plugin_curves, gusset_plugin_mesh,
};
use super::run::Fault;
use crate::ffi::input;
use crate::ffi::mesh::lend;
use crate::ffi::status::{Failure, gusset_status};
use crate::filters::data::{Curves, Output};
use crate::mesh::Mesh;
use libc::c_char;
use std::ffi::CString;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr;

/// What a run left: its outputs, or why there are none. Opaque; may be read from many threads at
/// once.
pub struct gusset_outputs {
    outputs: Vec<Held>,
    status: i32,
    message: CString,
    fault: Option<Fault>,
}

enum Held {
    Mesh(Mesh),
    Curves(Curves),
    Text(CString),
}

impl gusset_outputs {
    pub(super) fn new(outcome: Result<Vec<Output>, Fault>) -> Self {
        match outcome {
            Ok(outputs) => {
                let outputs = outputs.into_iter().map(Held::from).collect();
                gusset_outputs { outputs, status: GUSSET_PLUGIN_DONE, message: CString::default(), fault: None }
            }
            Err(fault) => gusset_outputs {
                outputs: Vec::new(),
                status: fault.failure.status as i32,
                message: CString::new(fault.failure.message.as_bytes()).unwrap_or_default(),
                fault: Some(fault),
            },
        }
    }
}

impl From<Output> for Held {
    fn from(output: Output) -> Self {
        match output {
            Output::Mesh(mesh) => Held::Mesh(mesh),
            Output::Curves(mut curves) => {
                // A host may read the first offset even where there are no curves.
                if curves.offsets.is_empty() {
                    curves.offsets = vec![0];
                }
                Held::Curves(curves)
            }
            Output::Text(text) => Held::Text(CString::new(text).unwrap_or_default()),
        }
    }
}

/// Output `index`, if there is one.
fn held<'a>(outputs: *const gusset_outputs, index: u32) -> Result<&'a Held, Failure> {
    let outputs: &gusset_outputs = input::reference(outputs, "outputs")?;
    outputs.outputs.get(index as usize).ok_or_else(|| Failure::no_such("output", index as usize))
}

fn status(outcome: std::thread::Result<Result<(), Failure>>) -> i32 {
    match outcome {
        Ok(Ok(())) => GUSSET_PLUGIN_DONE,
        Ok(Err(failure)) => failure.status as i32,
        Err(panic) => {
            std::mem::forget(panic);
            gusset_status::GUSSET_ERROR_PANIC as i32
        }
    }
}

pub(super) unsafe extern "C" fn count(outputs: *const gusset_outputs) -> u32 {
    input::reference(outputs, "outputs").map_or(0, |outputs: &gusset_outputs| outputs.outputs.len() as u32)
}

pub(super) unsafe extern "C" fn kind(outputs: *const gusset_outputs, index: u32) -> u32 {
    held(outputs, index).map_or(0, |held| match held {
        Held::Mesh(_) => GUSSET_KIND_MESH,
        Held::Curves(_) => GUSSET_KIND_CURVES,
        Held::Text(_) => GUSSET_KIND_TEXT,
    })
}

pub(super) unsafe extern "C" fn mesh(outputs: *const gusset_outputs, index: u32, mesh: *mut gusset_plugin_mesh) -> i32 {
    status(catch_unwind(AssertUnwindSafe(|| {
        let out = input::output_struct(mesh, "mesh")?;
        let Held::Mesh(mesh) = held(outputs, index)? else {
            return Err(Failure::no_such("mesh", index as usize));
        };
        let view = lend(mesh);
        out.write(gusset_plugin_mesh {
            struct_size: size_of::<gusset_plugin_mesh>(),
            positions: view.positions,
            position_stride: view.position_stride,
            vertex_count: view.vertex_count,
            face_offsets: view.face_offsets,
            face_corners: view.face_corners,
            face_count: view.face_count,
            scalar: view.scalar,
            index: view.index,
            face_size: view.face_size,
            reserved: 0,
        });
        Ok(())
    })))
}

pub(super) unsafe extern "C" fn curves(
    outputs: *const gusset_outputs,
    index: u32,
    curves: *mut gusset_plugin_curves,
) -> i32 {
    status(catch_unwind(AssertUnwindSafe(|| {
        let out = input::output_struct(curves, "curves")?;
        let Held::Curves(curves) = held(outputs, index)? else {
            return Err(Failure::no_such("set of curves", index as usize));
        };
        out.write(gusset_plugin_curves {
            struct_size: size_of::<gusset_plugin_curves>(),
            points: curves.points.as_ptr().cast(),
            point_stride: size_of::<[f64; 3]>(),
            point_count: curves.points.len(),
            offsets: curves.offsets.as_ptr().cast(),
            // A bool is a byte of 0 or 1.
            closed: curves.closed.as_ptr().cast(),
            curve_count: curves.closed.len(),
            scalar: GUSSET_PLUGIN_F64,
            reserved: 0,
        });
        Ok(())
    })))
}

pub(super) unsafe extern "C" fn text(outputs: *const gusset_outputs, index: u32) -> *const c_char {
    match held(outputs, index) {
        Ok(Held::Text(text)) => text.as_ptr(),
        _ => ptr::null(),
    }
}

pub(super) unsafe extern "C" fn failure(outputs: *const gusset_outputs, failure: *mut gusset_failure) -> i32 {
    status(catch_unwind(AssertUnwindSafe(|| {
        let out = input::output_struct(failure, "failure")?;
        let outputs: &gusset_outputs = input::reference(outputs, "outputs")?;
        let mut report = gusset_failure {
            struct_size: size_of::<gusset_failure>(),
            message: outputs.message.as_ptr(),
            status: outputs.status,
            param: GUSSET_PLUGIN_NONE,
            input: GUSSET_PLUGIN_NONE,
            element: 0,
            index: 0,
            value: 0.0,
        };
        if let Some(Fault { failure, param, input }) = &outputs.fault {
            (report.param, report.input) = (*param, *input);
            (report.element, report.index, report.value) = (failure.element, failure.index, failure.value);
        }
        out.write(report);
        Ok(())
    })))
}

pub(super) unsafe extern "C" fn free(outputs: *mut gusset_outputs) {
    input::destroy(outputs);
}
