//! Runs the filters of the plugin's table with any inputs and values: an error, or valid outputs of
//! the declared kinds for any number of threads, and `Cancelled` if cancelled.

use crate::agree::agreed;
use crate::input::{self, Cloud, Point, Soup, places};
use gusset::filters::data::{Curves, Input, InputKind, Output, OutputKind};
use gusset::filters::param::{Param, ParamKind};
use gusset::filters::{FILTERS, Filter};

/// A filter, its inputs and values.
#[derive(Debug)]
struct Case {
    filter: u8,
    choice: u8,
    meshes: [Soup; 2],
    lines: [(Cloud, u8, bool); 3],
    values: [u8; 12],
}

input::in_order!(Case { filter, choice, meshes, lines, values });

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some(case) = input::taken::<Case>(bytes) else { return };
    let filter = &FILTERS[usize::from(case.filter) % FILTERS.len()];
    let curves = case.lines.each_ref().map(|(points, parts, closed)| polylines(points, *parts, *closed));
    case.meshes[0].visit(|a| {
        case.meshes[1].visit(|b| {
            let kinds = (0..filter.min_inputs).map(|k| filter.inputs.get(k).or(filter.inputs.last()));
            let input = |(k, kind): (usize, Option<&InputKind>)| match kind {
                Some(InputKind::Curves) => Input::Curves(&curves[k % 3]),
                _ => Input::Mesh(if k % 2 == 0 { *a } else { *b }),
            };
            let inputs: Vec<_> = kinds.enumerate().map(input).collect();
            answered(filter, &inputs, &case);
        });
    });
}

fn answered(filter: &Filter, inputs: &[Input<'_>], case: &Case) {
    let mut values = filter.defaults(inputs);
    let params = filter.params.iter().flat_map(|param| (0..param.kind.component_count()).map(move |_| param));
    for (k, (value, param)) in values.iter_mut().zip(params).enumerate() {
        *value = chosen(param, *value, case.values[k % 12].rotate_left(k as u32 / 12));
    }
    let Ok(outputs) = agreed(case.choice, |job| filter.run_traced(inputs, &values, job)) else { return };
    assert_eq!(outputs.len(), filter.outputs.len(), "{}", filter.id);
    for (output, kind) in outputs.iter().zip(filter.outputs) {
        match (output, kind) {
            (Output::Mesh(mesh, origins), OutputKind::Mesh) => {
                input::expect_valid(mesh, |_| {});
                assert_eq!(origins.is_some(), filter.has_origins, "{}", filter.id);
                origins.iter().for_each(|origins| input::expect_origins(origins, mesh));
            }
            (Output::Curves(curves), OutputKind::Curves) => {
                curves.check().expect("offsets that fit");
                assert!(curves.points.iter().flatten().all(|x| x.is_finite()), "{}", filter.id);
            }
            (Output::Text(_), OutputKind::Text) => {}
            _ => panic!("{}: {kind:?} was promised", filter.id),
        }
    }
}

/// The default, or another value of the parameter that asks for no more work than a fuzzer has time for.
fn chosen(param: &Param, default: f64, byte: u8) -> f64 {
    let few = f64::from(byte / 4 % 16);
    match (byte % 4, param.kind) {
        // Sections that run to and fro ask for 10^8 vertices at the default.
        _ if param.id == "deviation" => 0.1 * (1.0 + few),
        (0..=1, _) => default,
        (_, ParamKind::Bool | ParamKind::Choice) => (param.min + few % (param.max - param.min + 1.0)).min(param.max),
        (_, ParamKind::Int) => (param.min + few).min(param.max),
        (_, ParamKind::Length) => (default * (few - 4.0).exp2().max(0.25)).clamp(param.min, param.max),
        _ => (default + (few - 8.0) / 4.0).clamp(param.min, param.max),
    }
}

/// The points in a few polylines.
fn polylines(points: &[Point], parts: u8, closed: bool) -> Curves {
    let points: Vec<[f64; 3]> = places(&points[..points.len().min(60)]).iter().map(|p| p.to_array()).collect();
    let parts = 1 + usize::from(parts % 4);
    let offsets = (0..=parts).map(|k| (k * points.len() / parts) as u32).collect();
    Curves { points, offsets, closed: vec![closed; parts] }
}
