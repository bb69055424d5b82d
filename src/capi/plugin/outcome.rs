//! Outputs: The results of a run.

use crate::attributes::Origins;
use crate::capi::handle::handle;
use crate::capi::status::{Failure, gusset_status};
use crate::error::Result;
use crate::filters::data::{Curves, Output};
use crate::filters::report::ReportValue;
use crate::mesh::Mesh;
use gusset_base::alloc;
use std::ffi::CString;

/// Outputs of a run, or the reason of its failure.
pub struct gusset_outputs {
    pub(super) outputs: Vec<OutputForHost>,
    pub(super) message: CString,
    pub(super) fault: Option<RunFault>,
}

handle! { gusset_outputs }

/// An output in the form that hosts read.
pub(super) enum OutputForHost {
    Mesh(Mesh, Option<Box<Origins>>),
    Curves(Curves),
    Text(CString, Vec<(CString, ReportValue)>),
}

impl gusset_outputs {
    pub(super) fn from_outputs(outputs: Vec<Output>) -> Result<Self> {
        let outputs = alloc::try_collect(outputs.into_iter().map(OutputForHost::from_output))?;
        Ok(gusset_outputs { outputs, message: CString::default(), fault: None })
    }

    pub(super) fn from_fault(fault: RunFault) -> Self {
        let message = CString::new(fault.failure.message.as_bytes()).unwrap_or_default();
        gusset_outputs { outputs: Vec::new(), message, fault: Some(fault) }
    }
}

impl OutputForHost {
    fn from_output(output: Output) -> Result<Self> {
        Ok(match output {
            Output::Mesh(mesh, origins) => OutputForHost::Mesh(mesh, origins),
            Output::Curves(mut curves) => {
                // A host may read the first offset even without curves.
                if curves.offsets.is_empty() {
                    curves.offsets = alloc::filled(0, 1)?;
                }
                OutputForHost::Curves(curves)
            }
            Output::Text(report) => {
                let named = |&(name, value): &(&str, ReportValue)| Ok((to_c_string(name)?, value));
                OutputForHost::Text(to_c_string(&report)?, alloc::try_collect(report.values().iter().map(named))?)
            }
        })
    }
}

/// Copies a text, which may be long, with a closing NUL.
fn to_c_string(of: &str) -> Result<CString> {
    let mut bytes = alloc::with_capacity(of.len() + 1)?;
    bytes.extend_from_slice(of.as_bytes());
    Ok(CString::new(bytes).unwrap_or_default())
}

/// A failure, and the indices of the parameter and of the input at fault, if known.
pub(super) struct RunFault {
    pub(super) failure: Failure,
    pub(super) param: Option<u32>,
    pub(super) input: Option<u32>,
}

impl<F: Into<Failure>> From<F> for RunFault {
    fn from(failure: F) -> Self {
        let failure = failure.into();
        // Without an element, the failure need not concern an input.
        let names_input = (failure.element != 0 || failure.input != 0) && !is_cancel_or_out_of_memory(&failure);
        RunFault { param: None, input: names_input.then_some(failure.input), failure }
    }
}

impl RunFault {
    /// Attributes the fault to input `input`.
    pub(super) fn with_input(self, input: u32) -> Self {
        if is_cancel_or_out_of_memory(&self.failure) { self } else { RunFault { input: Some(input), ..self } }
    }
}

/// Returns true for a cancel or a lack of memory, which are not an input's fault.
fn is_cancel_or_out_of_memory(failure: &Failure) -> bool {
    use gusset_status::{GUSSET_ERROR_CANCELLED, GUSSET_ERROR_OUT_OF_MEMORY};
    matches!(failure.status, GUSSET_ERROR_CANCELLED | GUSSET_ERROR_OUT_OF_MEMORY)
}
