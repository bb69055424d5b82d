//! Reports as JSON.

use crate::failure::Failure;
use crate::pieces::attribute_names;
use crate::plugin::{Filter, Geometry, NamedValue, Param, ParamKind, ValueKind};
use crate::values::{degrees, slug};
use gusset_io::{Curves, Mesh};
use serde_json::{Map, Value, json};

/// Returns a number, as an integer where it is one; `null` for NaN and infinities.
pub(crate) fn number(value: f64) -> Value {
    const MAX_EXACT_INTEGER: f64 = 9_007_199_254_740_992.0;
    if value.fract() == 0.0 && value.abs() <= MAX_EXACT_INTEGER {
        return json!(value as i64);
    }
    json!(value)
}

pub(crate) fn describe_mesh(path: &str, mesh: &Mesh) -> Value {
    json!({
        "file": path,
        "kind": "mesh",
        "vertices": mesh.positions.len(),
        "faces": mesh.face_count(),
        "attributes": attribute_names(mesh),
    })
}

pub(crate) fn describe_curves(path: &str, curves: &Curves) -> Value {
    json!({ "file": path, "kind": "curves", "points": curves.positions.len(), "curves": curves.closed.len() })
}

pub(crate) fn describe_geometry(path: &str, geometry: &Geometry) -> Value {
    match geometry {
        Geometry::Mesh(piece) => {
            let mut made = describe_mesh(path, &piece.mesh);
            made["notes"] = json!(piece.notes);
            made
        }
        Geometry::Curves(curves) => describe_curves(path, curves),
    }
}

pub(crate) fn describe_failure(failure: &Failure) -> Value {
    let mut made = json!({ "message": failure.message, "exit": failure.exit as u8 });
    let refusal = &failure.refusal;
    if let Some(status) = refusal.status {
        made["status"] = json!(status);
    }
    if let Some(parameter) = &refusal.parameter {
        made["parameter"] = json!(parameter);
    }
    if let Some(input) = refusal.input {
        made["input"] = json!(input);
    }
    if let Some((element, index)) = refusal.element {
        made["element"] = json!(element);
        made["index"] = json!(index);
    }
    made
}

/// Returns the values of a filter's parameters by their ids; angles in degrees.
pub(crate) fn describe_values(filter: Filter, values: &[f64]) -> Value {
    let named = filter
        .params()
        .into_iter()
        .map(|param| (param.id().to_owned(), describe_value(param, &values[param.values()])));
    Value::Object(named.collect())
}

fn describe_value(param: Param, values: &[f64]) -> Value {
    let component = |value: f64| number(if param.kind() == ParamKind::Angle { degrees(value) } else { value });
    match param.kind() {
        ParamKind::Bool => json!(values[0] != 0.0),
        ParamKind::Choice => {
            param.choices().get(values[0] as usize).map_or_else(|| number(values[0]), |(label, _)| json!(slug(label)))
        }
        _ if values.len() == 1 => component(values[0]),
        _ => values.iter().copied().map(component).collect(),
    }
}

/// Returns a number of a report: a flag as true or false, an angle in degrees.
pub(crate) fn describe_named_value(value: &NamedValue<'_>) -> Value {
    match value.kind {
        ValueKind::Flag => json!(value.number != 0.0),
        ValueKind::Angle => number(degrees(value.number)),
        ValueKind::Number => number(value.number),
    }
}

/// Describes a filter; with its parameters, and the values that suit the inputs, if `suggested` is there.
pub(crate) fn describe_filter(filter: Filter, in_full: bool, suggested: Option<&[f64]>) -> Value {
    let words = |kinds: Vec<crate::plugin::OutputKind>| {
        kinds.into_iter().map(crate::plugin::OutputKind::word).collect::<Vec<_>>()
    };
    let mut made = json!({
        "id": filter.id(),
        "name": filter.name(),
        "category": filter.category(),
        "inputs": words(filter.input_kinds()),
        "min_inputs": filter.min_inputs(),
        "max_inputs": filter.max_inputs(),
        "outputs": words(filter.output_kinds()),
    });
    if in_full {
        made["script"] = json!(filter.script_name());
        made["help"] = json!(filter.help());
        made["reference"] = json!(filter.reference());
        let defaults = filter.default_values();
        made["parameters"] =
            filter.params().into_iter().map(|param| describe_param(param, &defaults, suggested)).collect();
    }
    made
}

fn describe_param(param: Param, defaults: &[f64], suggested: Option<&[f64]>) -> Value {
    let mut made = Map::new();
    made.insert("id".into(), json!(param.id()));
    made.insert("label".into(), json!(param.label()));
    made.insert("help".into(), json!(param.help()));
    made.insert("kind".into(), json!(kind_name(param.kind())));
    if let Some(unit) = unit(param.kind()) {
        made.insert("unit".into(), json!(unit));
    }
    made.insert("default".into(), describe_value(param, &defaults[param.values()]));
    if let Some(suggested) = suggested {
        made.insert("suggested".into(), describe_value(param, &suggested[param.values()]));
    }
    if !matches!(param.kind(), ParamKind::Bool | ParamKind::Choice) {
        let [min, max] =
            param.range().map(|bound| number(if param.kind() == ParamKind::Angle { degrees(bound) } else { bound }));
        made.insert("min".into(), min);
        made.insert("max".into(), max);
    }
    let choices = param.choices();
    if !choices.is_empty() {
        let choices =
            choices.into_iter().map(|(label, help)| json!({ "name": slug(label), "label": label, "help": help }));
        made.insert("choices".into(), choices.collect());
    }
    Value::Object(made)
}

/// Returns the word for a kind of parameter.
pub(crate) fn kind_name(kind: ParamKind) -> &'static str {
    match kind {
        ParamKind::Bool => "true or false",
        ParamKind::Integer => "whole number",
        ParamKind::Real => "number",
        ParamKind::Choice => "choice",
        ParamKind::Length => "length",
        ParamKind::Angle => "angle in degrees",
        ParamKind::Point => "point x,y,z",
        ParamKind::Direction => "direction x,y,z",
        ParamKind::Plane => "plane a,b,c,d: a x + b y + c z = d",
        ParamKind::Unknown => "unknown",
    }
}

fn unit(kind: ParamKind) -> Option<&'static str> {
    match kind {
        ParamKind::Angle => Some("degree"),
        ParamKind::Length | ParamKind::Point => Some("unit of the file"),
        _ => None,
    }
}
