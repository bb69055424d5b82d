use super::curve::{CATEGORY, CHORD_ERROR, REFERENCE, sample_curve};
use super::data::{Curves, Input, Output};
use super::filter::{Filter, FilterBody};
use super::report::{POINT, count_with_noun, push_line};
use super::signatures::{CURVES_ONLY, TO_CURVES_TEXT};
use super::typed_param::{Param, ParamValues, params};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_curve::ops::SampleSpacing;
use gusset_curve::{
    CurveKind, Ends, Fit, FitStatus, JointParameter, Lock, Method, Options, Outlines, PointStatus, Points, fit,
};

params! {
    curve: CurveKind = Param::choice("Curve", "The kind of curve that is drawn.", CurveKind::CHOICES);
    method: Method =
        Param::choice("Method", "The line at a point that determines its parameter on its section.", Method::CHOICES);
    lock: Lock = Param::choice("Constraint", "The condition that fixes the section of a point.", Lock::CHOICES);
    joint: JointParameter =
        Param::choice("Joints", "The joints between the sections of a composite curve.", JointParameter::CHOICES);
    ends: Ends = Param::choice("Ends", "The end conditions of open curves.", Ends::CHOICES);
    corner_angle: f64 = Param::angle(
        "Corners",
        "Points where the polyline turns by more than this angle remain corners; pi makes all of them smooth.",
        [0.0, PI], &[PI],
    );
    merge: f64 = Param::real(
        "Merge",
        "Neighbouring points closer than this become one, relative to the size of their polyline. The report counts crowded \
         points, which almost repeat a neighbour, and points in loops that the polyline lacks.",
        [0.0, 0.5], &[1e-12],
    );
    chord_error: f64 = CHORD_ERROR
        .with_help("The largest distance of the polyline from the curve, relative to the size of the curve.");
}
use std::f64::consts::PI;

pub(super) const FILTER: Filter = Filter {
    id: "outline",
    name: "Smooth curves through points",
    category: CATEGORY,
    help: "Draws smooth Bezier curves through all points of polylines, and returns them as finer polylines. By default the curve \
           consists of quadratic sections, one for each point. The bisector, the median or the normal at the point determines the \
           point's parameter on its section; the control point lies near this line. With the constraint Guide it lies on the \
           line, where this is possible.",
    reference: REFERENCE,
    ..Filter::new(CURVES_ONLY, TO_CURVES_TEXT, &FilterBody(run))
};

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let given = inputs[0].curves()?;
    let options = Options {
        curve: values.curve,
        method: values.method,
        lock: values.lock,
        joint: values.joint,
        ends: values.ends,
        corner_angle: values.corner_angle,
        repeat_tolerance: values.merge,
        ..Options::default()
    };
    let (mut drawn, mut text) = (Curves::without_curves(), String::new());
    let curves = given.polylines()?;
    for (c, &(points, closed)) in curves.iter().enumerate() {
        let part = job.sub_job_of_item(c, curves.len());
        let outline = Outlines { points: Points::from(points), offsets: None, closed, constraints: &[] };
        let done = fit(&outline, &options, &part.sub_job(0.0, 0.8))?;
        let chord = (values.chord_error * done.reports()[0].size).max(f64::MIN_POSITIVE);
        let points = sample_curve(&done.curve(0), SampleSpacing::Chord(chord), &part.sub_job(0.8, 1.0))?;
        drawn.add_curve(points.into_iter(), closed)?;
        push_line!(text, "curve {c}: {}", report(&done));
    }
    Ok(vec![Output::Curves(drawn), Output::Text(text.into())])
}

fn report(done: &Fit) -> String {
    let account = &done.reports()[0];
    let what = match account.status {
        FitStatus::Ok => "as requested",
        FitStatus::Partial => "not all points as requested",
        FitStatus::NotConverged => "not converged",
        FitStatus::Diverged => "diverged",
        FitStatus::IllConditioned => "ill conditioned",
        FitStatus::TooFewPoints => "too few points",
        FitStatus::DegreeTooHigh => "too many points for a single curve",
    };
    let count = |status: PointStatus| done.statuses().iter().filter(|&&own| own == status).count();
    format!(
        "{}, {}, {what}; {} with a status of {} own, {} missed, {} in loops, {} crowded; largest miss {:.1e} of the size",
        count_with_noun(done.statuses().len(), POINT),
        count_with_noun(done.curve(0).len(), ["segment", "segments"]),
        count_with_noun(account.not_ok, POINT),
        if account.not_ok == 1 { "its" } else { "their" },
        count(PointStatus::Missed),
        count(PointStatus::Looped),
        count(PointStatus::Crowded),
        account.max_residual
    )
}
