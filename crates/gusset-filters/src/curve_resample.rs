use super::curve::{self, CATEGORY, CHORD_ERROR, INTERPOLATION, REFERENCE};
use super::data::{Curves, Input, Output, OutputKind};
use super::filter::{Filter, FilterBody};
use super::signatures::CURVES_ONLY;
use super::typed_param::{LENGTH_RANGE, Param, ParamValues, params};
use gusset_base::choices;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_curve::CurveKind;
use gusset_curve::ops::SampleSpacing;

pub(super) const FILTER: Filter = Filter {
    id: "curve_resample",
    name: "Resample curves",
    category: CATEGORY,
    help: "Resamples curves: a given number of points, points at a given spacing, or the fewest points that keep the polyline \
           within the chord error of the curve.",
    reference: REFERENCE,
    replaces: true,
    ..Filter::new(CURVES_ONLY, &[OutputKind::Curves], &FilterBody(run))
};

params! {
    between: Option<CurveKind> = INTERPOLATION;
    spacing: MakeSpacing = Param::choice("Spacing", "The rule that places the new points.", SPACINGS);
    number: u32 = Param::int(
        "Number",
        "The number of points of each curve, if it is given. Both ends of an open curve count.",
        [2.0, 1e6], &[100.0],
    );
    step: f64 = Param::length("Step", "The spacing of points along the curve, if it is given.", LENGTH_RANGE, &[0.1])
        .with_size_ratio(0.01);
    chord_error: f64 = CHORD_ERROR;
}

/// The spacing of new points on the given polylines.
type MakeSpacing = fn(&Params, &Curves) -> SampleSpacing;

choices! {
    SPACINGS: MakeSpacing =
        |values, _| SampleSpacing::Count(values.number as usize) => "Number",
            "A given number of points on each curve, at equal arc lengths.";
        |values, _| SampleSpacing::Step(values.step) => "Step", "A given spacing along the curve.";
        |values, given| SampleSpacing::Chord(curve::absolute_chord_error(given, values.chord_error)) => "Chord error",
            "As few points as the chord error allows, more where the curve bends.";
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let given = inputs[0].curves()?;
    let curves = curve::fit_curves(given, values.between, &job.sub_job(0.0, 0.5))?;
    let mut drawn = Curves::without_curves();
    let spacing = (values.spacing)(values, given);
    for (c, curve) in curves.iter().enumerate() {
        let part = job.sub_job(0.5, 1.0).sub_job_of_item(c, curves.len());
        drawn.add_curve(curve::sample_curve(&curve.view(), spacing, &part)?.into_iter(), curve.view().is_closed())?;
    }
    Ok(vec![Output::Curves(drawn)])
}
