use super::curve::{CATEGORY, REFERENCE, sampled};
use super::data::{Curves, Input, Output};
use super::filter::Filter;
use super::param::{Param, ParamKind, Values};
use super::report::POINT;
use super::report::{counted, push_line};
use super::signatures::{CURVES, TO_CURVES_TEXT};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_curve::ops::Spacing;
use gusset_curve::{
    Ends, Fit, FitStatus, JointParameter, Lock, Method, Mode, Options, Outlines, PointStatus, Points, fit,
};
use std::f64::consts::PI;

pub(super) const FILTER: Filter = Filter {
    id: "outline",
    name: "Smooth curves through points",
    category: CATEGORY,
    help: "Draws smooth Bezier curves through all points of polylines, and returns them as finer polylines. Each point is the \
           middle of a quadratic section whose control point lies on the bisector, the median or the normal at the point.",
    reference: REFERENCE,
    params: &[
        Param::choice("curve", "Curve", Mode::CHOICES.texts).with_help("The kind of curve that is drawn."),
        Param::choice("method", "Method", Method::CHOICES.texts)
            .with_help("The line that holds the control point of a section."),
        Param::choice("lock", "Constraint", Lock::CHOICES.texts)
            .with_help("The condition that fixes the section of a point."),
        Param::choice("joint", "Joints", JointParameter::CHOICES.texts)
            .with_help("The joints between the sections of a composite curve."),
        Param::choice("ends", "Ends", Ends::CHOICES.texts).with_help("The end conditions of open curves."),
        Param::new(ParamKind::Angle, "corner_angle", "Corners", [0.0, PI], &[PI])
            .with_help("Points where the polyline turns by more than this angle remain corners; pi for none."),
        Param::relative_error("chord_error", "Chord error")
            .with_help("The largest distance of the polyline from the curve, relative to the size of the curve."),
    ],
    ..Filter::new(CURVES, TO_CURVES_TEXT, run)
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let given = inputs[0].curves()?;
    let options = Options {
        mode: values.choice("curve", Mode::CHOICES),
        method: values.choice("method", Method::CHOICES),
        lock: values.choice("lock", Lock::CHOICES),
        joint: values.choice("joint", JointParameter::CHOICES),
        ends: values.choice("ends", Ends::CHOICES),
        corner_angle: values.number("corner_angle"),
        ..Options::default()
    };
    let (mut drawn, mut text) = (Curves::none(), String::new());
    let curves = given.each()?;
    for (c, &(points, closed)) in curves.iter().enumerate() {
        let part = job.share(c, curves.len());
        let outline = Outlines { points: Points::from(points), offsets: None, closed, constraints: &[] };
        let done = fit(&outline, &options, &part.part(0.0, 0.8))?;
        let chord = (values.number("chord_error") * done.reports()[0].size).max(f64::MIN_POSITIVE);
        let points = sampled(&done.curve(0), Spacing::Chord(chord), &part.part(0.8, 1.0))?;
        drawn.add(points.into_iter(), closed)?;
        push_line!(text, "curve {c}: {}", report(&done));
    }
    Ok(vec![Output::Curves(drawn), Output::Text(text.into())])
}

fn report(done: &Fit) -> String {
    let account = &done.reports()[0];
    let what = match account.status {
        FitStatus::Ok => "as asked",
        FitStatus::Partial => "not all points as asked",
        FitStatus::NotConverged => "not converged",
        FitStatus::Diverged => "diverged",
        FitStatus::IllConditioned => "ill conditioned",
        FitStatus::TooFewPoints => "too few points",
        FitStatus::DegreeTooHigh => "too many points for a single curve",
    };
    let missed = done.statuses().iter().filter(|&&status| status == PointStatus::Missed).count();
    format!(
        "{}, {}, {what}; {} with a status of {} own, {missed} missed; largest miss {:.1e} of the size",
        counted(done.statuses().len(), POINT),
        counted(done.curve(0).len(), ["segment", "segments"]),
        counted(account.not_ok, POINT),
        if account.not_ok == 1 { "its" } else { "their" },
        account.max_residual
    )
}
