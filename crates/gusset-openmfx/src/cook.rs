//! Cooks an effect: runs a filter on meshes and parameters of the host, and returns its output to
//! the host.

use super::effects::{EffectParameter, FilterEffect, ParameterKind, SUIT_INPUTS_NAME};
use super::host_meshes::{self, HostMeshData, PolygonFaces};
use super::ofx_abi::{HostHandle, MAIN_OUTPUT, MESSAGE_ERROR, MESSAGE_LOG, OfxStatus, PROP_TIME};
use super::suites::{EffectFault, HostMesh, HostParameters, HostSuites};
use gusset::capi::guard::catch_panic;
use gusset::capi::status::{Failure, gusset_status};
use gusset::error::Error;
use gusset::filters::data::{Curves, Input, InputKind, Output};
use gusset::job::{Job, Progress};
use gusset_base::alloc;
use std::ffi::c_int;
use std::ops::ControlFlow;

/// Asks the host whether to continue.
struct HostProgress<'a> {
    suites: &'a HostSuites,
    instance: HostHandle,
}

impl Progress for HostProgress<'_> {
    fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
        if self.suites.is_aborted(self.instance) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    fn note(&self, message: &str) {
        self.suites.show_message(self.instance, MESSAGE_LOG, message);
    }
}

/// Runs the action `OfxMeshEffectActionCook`.
pub(super) fn run_cook_action(
    effect: &FilterEffect,
    suites: &HostSuites,
    instance: HostHandle,
    in_args: HostHandle,
) -> Result<(), OfxStatus> {
    let time = suites.property_set_of(in_args).get_double(PROP_TIME).unwrap_or(0.0);
    catch_panic(|| run_filter(effect, suites, instance, time)).map_err(|fault| match fault {
        EffectFault::Host(status) => status,
        EffectFault::Ours(Failure { status: gusset_status::GUSSET_ERROR_OUT_OF_MEMORY, .. }) => OfxStatus::MEMORY,
        // The host itself asked to stop, so it gets no message.
        EffectFault::Ours(Failure { status: gusset_status::GUSSET_ERROR_CANCELLED, .. }) => OfxStatus::FAILED,
        EffectFault::Ours(failure) => {
            suites.show_message(instance, MESSAGE_ERROR, &failure.message);
            OfxStatus::FAILED
        }
    })
}

/// An input, with the data that it must own.
enum OwnedInput<'a> {
    Mesh(&'a HostMeshData<'a>, PolygonFaces),
    Curves(Curves),
}

fn run_filter(effect: &FilterEffect, suites: &HostSuites, instance: HostHandle, time: f64) -> Result<(), EffectFault> {
    let watch = HostProgress { suites, instance };
    let job = Job::new(0, &watch);
    let hosts = open_inputs(effect, suites, instance, time)?;
    let mut read: Vec<(InputKind, HostMeshData<'_>)> = Vec::new();
    for (number, (kind, mesh)) in hosts.iter().enumerate() {
        match HostMeshData::new(mesh, &job.sub_job(0.0, 0.0))? {
            Some(mut mesh) => {
                if let Some((_, first)) = read.first() {
                    mesh.transform_to_space_of(first)?;
                }
                read.push((*kind, mesh));
            }
            None if number < effect.filter.min_inputs => return Err(Error::EmptyMesh { what: "faces" }.into()),
            None => {}
        }
    }
    let given = alloc::try_collect(read.iter().map(|(kind, mesh)| {
        Ok::<_, Error>(match kind {
            InputKind::Mesh => OwnedInput::Mesh(mesh, mesh.faces_without_loose_edges()?),
            InputKind::Curves => OwnedInput::Curves(mesh.to_curves()?),
        })
    }))?;
    let inputs = alloc::try_collect(given.iter().map(|given| match given {
        OwnedInput::Mesh(mesh, polygons) => mesh.to_mesh_input(polygons, &job.sub_job(0.0, 0.05)),
        OwnedInput::Curves(curves) => Ok(Input::Curves(curves)),
    }))?;
    let values = read_parameter_values(effect, &suites.parameters_of_effect(instance)?, time, &inputs)?;
    let outputs = effect.filter.run(&inputs, &values, &job.sub_job(0.05, 1.0))?;
    for output in &outputs {
        if let Output::Text(text) = output {
            suites.show_message(instance, MESSAGE_LOG, text);
        }
    }
    let to = suites.open_input_mesh(instance, MAIN_OUTPUT, time)?.ok_or(OfxStatus::FAILED)?;
    match (effect.output.and_then(|place| outputs.get(place)), read.first()) {
        (Some(Output::Mesh(mesh, _)), _) => host_meshes::write_mesh(&to, mesh),
        (Some(Output::Curves(curves)), _) => host_meshes::write_curves(&to, curves),
        (_, Some((_, first))) => first.write_unchanged(&to),
        (_, None) => host_meshes::write_curves(&to, &Curves::default()),
    }
}

/// Opens the host's meshes. Optional inputs that are not available are skipped.
fn open_inputs<'a>(
    effect: &FilterEffect,
    suites: &'a HostSuites,
    instance: HostHandle,
    time: f64,
) -> Result<Vec<(InputKind, HostMesh<'a>)>, EffectFault> {
    let mut hosts = Vec::new();
    for (number, slot) in effect.inputs.iter().enumerate() {
        match suites.open_input_mesh(instance, &slot.name, time) {
            Ok(Some(mesh)) => hosts.push((slot.kind, mesh)),
            Ok(None) if number < effect.filter.min_inputs => return Err(Error::EmptyMesh { what: "faces" }.into()),
            Err(status) if number < effect.filter.min_inputs => return Err(status.into()),
            Ok(None) | Err(_) => {}
        }
    }
    Ok(hosts)
}

/// Reads the values of all parameters. If requested, values that equal their defaults are replaced
/// by values suggested for the inputs.
fn read_parameter_values(
    effect: &FilterEffect,
    parameters: &HostParameters<'_>,
    time: f64,
    inputs: &[Input<'_>],
) -> Result<Vec<f64>, OfxStatus> {
    let mut values = effect.filter.plain_defaults();
    for knob in &effect.knobs {
        read_parameter(parameters, knob, time, &mut values[knob.first_value..])?;
    }
    if effect.filter.has_suggestions() {
        let mut suit = 1;
        parameters.read_value(SUIT_INPUTS_NAME, time, &mut suit)?;
        if suit != 0 {
            let plain = effect.filter.plain_defaults();
            let better = effect.filter.defaults(inputs);
            for (value, (plain, better)) in values.iter_mut().zip(plain.into_iter().zip(better)) {
                if *value == plain {
                    *value = better;
                }
            }
        }
    }
    Ok(values)
}

/// Reads the values of a parameter, starting from its defaults.
fn read_parameter(
    parameters: &HostParameters<'_>,
    parameter: &EffectParameter,
    time: f64,
    values: &mut [f64],
) -> Result<(), OfxStatus> {
    match parameter.kind {
        ParameterKind::Boolean | ParameterKind::Integer | ParameterKind::Choice => {
            let mut value = values[0] as c_int;
            parameters.read_value(&parameter.name, time, &mut value)?;
            values[0] =
                if parameter.kind == ParameterKind::Boolean { f64::from(u8::from(value != 0)) } else { value.into() };
        }
        ParameterKind::Double => parameters.read_value(&parameter.name, time, &mut values[0])?,
        ParameterKind::Angle => {
            // The conversion of a default to degrees and back may round.
            let shown = values[0].to_degrees();
            let mut value = shown;
            parameters.read_value(&parameter.name, time, &mut value)?;
            values[0] = if value == shown { values[0] } else { clamp_rounding(value.to_radians(), parameter) };
        }
        ParameterKind::Vector => {
            let mut vector = [values[0], values[1], values[2]];
            parameters.read_double_3d(&parameter.name, time, &mut vector)?;
            values[..3].copy_from_slice(&vector);
        }
    }
    Ok(())
}

/// Clamps a value that left its range only by rounding.
fn clamp_rounding(value: f64, knob: &EffectParameter) -> f64 {
    let nearest = value.clamp(knob.param.min, knob.param.max);
    if (nearest - value).abs() <= 4.0 * f64::EPSILON * value.abs() { nearest } else { value }
}
