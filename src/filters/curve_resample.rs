//! The filter `curve_resample`.

use super::Filter;
use super::curve::{self, BETWEEN, CATEGORY, CHORD, REFERENCE};
use super::data::{Curves, Input, InputKind, Output, OutputKind};
use super::extent::{extent_of, put, rounded};
use super::param::{Choice, LENGTHS, Param, ParamKind, Values};
use crate::error::Result;
use crate::job::Job;
use crate::outline::ops::Spacing;

pub(super) const FILTER: Filter = Filter {
    id: "curve_resample",
    name: "Resample curves",
    script_name: "curve_resample",
    category: CATEGORY,
    help: "Gives curves other points: a number of them at equal distances along the curve, one at every step, or as few as hold the \
           polyline near to the curve.",
    reference: REFERENCE,
    inputs: &[InputKind::Curves],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Curves],
    replaces: true,
    params: PARAMS,
    suggest: Some(suggest),
    run,
};

const PARAMS: &[Param] = &[
    BETWEEN,
    Param::choice(
        "spacing",
        "Spacing",
        "Where the new points are.",
        &[
            Choice { label: "Number", help: "So many on each curve, at equal distances along it." },
            Choice { label: "Step", help: "So far apart, along the curve." },
            Choice { label: "Chord error", help: "Where the curve bends, as many as the chord error asks for." },
        ],
    ),
    Param::new(
        "number",
        "Number",
        "The number of points of each curve, if it is to be given; both ends of an open curve are among them.",
        ParamKind::Int,
        [2.0, 1e6],
        &[100.0],
    ),
    Param::new(
        "step",
        "Step",
        "How far points are from each other along the curve, if that is to be given.",
        ParamKind::Length,
        LENGTHS,
        &[0.1],
    ),
    CHORD,
];

fn suggest(inputs: &[Input<'_>], values: &mut [f64]) {
    if let Some(extent) = extent_of(inputs) {
        put(PARAMS, values, "step", &[rounded(0.01 * extent.diagonal())]);
    }
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let given = inputs[0].curves()?;
    let curves = curve::curves(given, values, &job.part(0.0, 0.5))?;
    let mut drawn = Curves::none();
    let spacing = match values.chosen("spacing") {
        0 => Spacing::Count(values.number("number") as usize),
        1 => Spacing::Step(values.number("step")),
        _ => Spacing::Chord(curve::chord(given, values)),
    };
    for (c, curve) in curves.iter().enumerate() {
        let part = job.part(0.5, 1.0).share(c, curves.len());
        drawn.add(curve::sampled(&curve.view(), spacing, &part)?.into_iter(), curve.view().is_closed())?;
    }
    Ok(vec![Output::Curves(drawn)])
}
