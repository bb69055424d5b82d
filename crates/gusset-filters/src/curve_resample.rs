use super::curve::{self, CATEGORY, CHORD_ERROR, INTERPOLATION, REFERENCE};
use super::data::{Curves, Input, Output, OutputKind};
use super::filter::Filter;
use super::param::{LENGTHS, Param, Values};
use super::signatures::CURVES;
use gusset_base::choice::Choice;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_curve::ops::Spacing;

pub(super) const FILTER: Filter = Filter {
    id: "curve_resample",
    name: "Resample curves",
    category: CATEGORY,
    help: "Resamples curves: a number of points at equal arc lengths, points at a given spacing, or as few points as keep the \
           polyline within a distance of the curve.",
    reference: REFERENCE,
    replaces: true,
    params: &[
        INTERPOLATION,
        Param::choice("spacing", "Spacing", SPACINGS).with_help("The rule that places the new points."),
        Param::int("number", "Number", [2.0, 1e6], &[100.0])
            .with_help("The number of points of each curve, if given; both ends of an open curve are among them."),
        Param::length("step", "Step", LENGTHS, &[0.1])
            .with_help("The spacing of points along the curve, if given.")
            .with_size_ratio(0.01),
        CHORD_ERROR,
    ],
    ..Filter::new(CURVES, &[OutputKind::Curves], run)
};

const SPACINGS: &[Choice] = &[
    Choice::new("Number", "A given number of points on each curve, at equal arc lengths."),
    Choice::new("Step", "A given spacing along the curve."),
    Choice::new("Chord error", "As many points as the chord error requires, where the curve bends."),
];

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let given = inputs[0].curves()?;
    let curves = curve::curves(given, values, &job.part(0.0, 0.5))?;
    let mut drawn = Curves::none();
    let spacing = match values.place("spacing") {
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
