//! Describes an effect to a host. Labels, hints and ranges that the host does not support are
//! skipped.

use super::effects::{
    EffectParameter, FilterEffect, ParameterKind, SUIT_INPUTS_HINT, SUIT_INPUTS_LABEL, SUIT_INPUTS_NAME,
};
use super::ofx_abi::{
    CONTEXT_FILTER, CONTEXT_GENERAL, CONTEXT_GENERATOR, HostHandle, MAIN_OUTPUT, OfxStatus, PARAM_BOOLEAN,
    PARAM_CHOICE, PARAM_DOUBLE, PARAM_DOUBLE_3D, PARAM_DOUBLE_ANGLE, PARAM_INTEGER, PARAM_PROP_CHOICE,
    PARAM_PROP_DEFAULT, PARAM_PROP_DOUBLE_TYPE, PARAM_PROP_HINT, PARAM_PROP_INCREMENT, PARAM_PROP_MAX, PARAM_PROP_MIN,
    PROP_CONTEXTS, PROP_DESCRIPTION, PROP_LABEL, PROP_REQUEST_TRANSFORM,
};
use super::suites::{HostParameters, HostSuites, PropertySet};
use std::ffi::c_int;

/// Runs the action `OfxActionDescribe`.
pub(super) fn describe_effect(
    effect: &'static FilterEffect,
    suites: &HostSuites,
    descriptor: HostHandle,
) -> Result<(), OfxStatus> {
    if let Some(properties) = suites.effect_properties(descriptor) {
        let context = match effect.inputs.len() {
            0 => CONTEXT_GENERATOR,
            1 => CONTEXT_FILTER,
            _ => CONTEXT_GENERAL,
        };
        let _ = properties.set_text(PROP_LABEL, 0, &effect.label);
        let _ = properties.set_text(PROP_DESCRIPTION, 0, &effect.help);
        let _ = properties.set_text(PROP_CONTEXTS, 0, context);
    }
    for slot in &effect.inputs {
        let input = suites.define_input(descriptor, &slot.name)?;
        let _ = input.set_text(PROP_LABEL, 0, &slot.label);
        if effect.inputs.len() > 1 {
            // With several inputs, meshes at different positions are transformed to a common
            // system.
            let _ = input.set_int(PROP_REQUEST_TRANSFORM, 0, 1);
        }
    }
    let output = suites.define_input(descriptor, MAIN_OUTPUT)?;
    let _ = output.set_text(PROP_LABEL, 0, c"Output");
    let parameters = suites.parameters_of_effect(descriptor)?;
    for parameter in &effect.knobs {
        define_parameter(&parameters, parameter)?;
    }
    if effect.filter.has_suggestions() {
        let properties = parameters.define_parameter(PARAM_BOOLEAN, SUIT_INPUTS_NAME)?;
        let _ = properties.set_text(PROP_LABEL, 0, SUIT_INPUTS_LABEL);
        let _ = properties.set_text(PARAM_PROP_HINT, 0, SUIT_INPUTS_HINT);
        properties.set_int(PARAM_PROP_DEFAULT, 0, 1)?;
    }
    Ok(())
}

fn define_parameter(parameters: &HostParameters<'_>, knob: &'static EffectParameter) -> Result<(), OfxStatus> {
    let kind = match knob.kind {
        ParameterKind::Boolean => PARAM_BOOLEAN,
        ParameterKind::Integer => PARAM_INTEGER,
        ParameterKind::Choice => PARAM_CHOICE,
        ParameterKind::Double | ParameterKind::Angle => PARAM_DOUBLE,
        ParameterKind::Vector => PARAM_DOUBLE_3D,
    };
    let properties = parameters.define_parameter(kind, &knob.name)?;
    let _ = properties.set_text(PROP_LABEL, 0, &knob.label);
    let _ = properties.set_text(PARAM_PROP_HINT, 0, &knob.hint);
    match knob.kind {
        ParameterKind::Boolean | ParameterKind::Integer | ParameterKind::Choice => define_integer(properties, knob),
        ParameterKind::Double | ParameterKind::Angle | ParameterKind::Vector => define_double(properties, knob),
    }
}

fn define_integer(properties: PropertySet, knob: &'static EffectParameter) -> Result<(), OfxStatus> {
    for (place, choice) in knob.choices.iter().enumerate() {
        let _ = properties.set_text(PARAM_PROP_CHOICE, place, choice);
    }
    if knob.kind == ParameterKind::Integer {
        let _ = properties.set_int(PARAM_PROP_MIN, 0, knob.param.min as c_int);
        let _ = properties.set_int(PARAM_PROP_MAX, 0, knob.param.max as c_int);
    }
    properties.set_int(PARAM_PROP_DEFAULT, 0, knob.default[0] as c_int)
}

fn define_double(properties: PropertySet, knob: &EffectParameter) -> Result<(), OfxStatus> {
    let shown = |value: f64| if knob.kind == ParameterKind::Angle { value.to_degrees() } else { value };
    if knob.kind == ParameterKind::Angle {
        let _ = properties.set_text(PARAM_PROP_DOUBLE_TYPE, 0, PARAM_DOUBLE_ANGLE);
    }
    if knob.param.step > 0.0 {
        let _ = properties.set_double(PARAM_PROP_INCREMENT, 0, shown(knob.param.step));
    }
    for (component, &value) in knob.default.iter().enumerate() {
        let _ = properties.set_double(PARAM_PROP_MIN, component, shown(knob.param.min));
        let _ = properties.set_double(PARAM_PROP_MAX, component, shown(knob.param.max));
        properties.set_double(PARAM_PROP_DEFAULT, component, shown(value))?;
    }
    Ok(())
}
