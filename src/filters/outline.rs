//! The filter `outline`.

use super::Filter;
use super::curve::sampled;
use super::data::{Curves, Input, InputKind, Output, OutputKind};
use super::param::{Choice, Param, ParamKind, Values};
use crate::error::Result;
use crate::job::Job;
use crate::outline::ops::Spacing;
use crate::outline::{
    Ends, Fit, FitStatus, JointParameter, Lock, Method, Mode, Options, Outlines, PointStatus, Points, fit,
};
use std::fmt::Write;

pub(super) const FILTER: Filter = Filter {
    id: "outline",
    name: "Smooth curves through points",
    script_name: "outline",
    category: "Curves",
    help: "Draws smooth Bezier curves through all points of polylines, and returns them as finer polylines. Each point is the \
           middle of a quadratic section whose control point lies on the bisector, the median or the normal at the point.",
    reference: "T. Nadopta, Theoretical foundations of the identification of outline curves, 2008",
    inputs: &[InputKind::Curves],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Curves, OutputKind::Text],
    replaces: false,
    params: &[
        Param::choice(
            "curve",
            "Curve",
            "What kind of curve is drawn.",
            &[
                Choice { label: "Composite", help: "Quadratic segments that meet smoothly, one for each point." },
                Choice { label: "Cubic spline", help: "Cubic segments with continuous curvature." },
                Choice {
                    label: "Blend",
                    help: "Neighbouring sections blended: each point moves its neighbourhood only.",
                },
                Choice { label: "Smooth blend", help: "The same with continuous curvature." },
                Choice { label: "Single", help: "One Bezier curve; for few points." },
            ],
        ),
        Param::choice(
            "method",
            "Method",
            "Where the control point of a section lies.",
            &[
                Choice { label: "Bisector", help: "On the bisector of the angle at the point." },
                Choice { label: "Median", help: "On the median of the triangle with its neighbours." },
                Choice {
                    label: "Normal",
                    help: "On the normal of the chord, where that meets the chord; else on the bisector.",
                },
                Choice { label: "Symmedian", help: "On the symmedian of the triangle." },
            ],
        ),
        Param::choice(
            "lock",
            "Tied to",
            "What the section of a point is tied to.",
            &[
                Choice { label: "Parameter", help: "The parameter that the data's triangle has; always solvable." },
                Choice { label: "Own triangle", help: "The section's own triangle." },
                Choice { label: "Guide", help: "The guide of the data's triangle; plane polylines only." },
            ],
        ),
        Param::choice(
            "joint",
            "Joints",
            "Where the sections of a composite curve meet.",
            &[
                Choice { label: "Halves", help: "In the middle between their control points." },
                Choice { label: "Knots", help: "By the lengths of the chords." },
                Choice { label: "Curvature", help: "Where the curvature is continuous." },
            ],
        ),
        Param::choice(
            "ends",
            "Ends",
            "How open curves begin and end.",
            &[
                Choice { label: "Free", help: "As their sections have it." },
                Choice { label: "Perpendicular", help: "Perpendicular to the first and the last chord." },
            ],
        ),
        Param {
            id: "corner_angle",
            label: "Corners",
            help: "Points where the polyline turns by more than this angle stay corners; half a turn for none.",
            kind: ParamKind::Angle,
            min: 0.0,
            max: std::f64::consts::PI,
            default: &[std::f64::consts::PI],
            step: 0.0,
            choices: &[],
        },
        Param {
            id: "chord_error",
            label: "Chord error",
            help: "How far the polyline that comes out may be from the curve, relative to the size of the curve.",
            kind: ParamKind::Real,
            min: 1e-9,
            max: 1.0,
            default: &[1e-4],
            step: 0.0,
            choices: &[],
        },
    ],
    suggest: None,
    run,
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let given = inputs[0].curves()?;
    let options = Options {
        mode: [Mode::Composite, Mode::CubicC2, Mode::BlendC1, Mode::BlendC2, Mode::Single][values.chosen("curve")],
        method: [Method::Bisector, Method::Median, Method::Normal, Method::Symmedian][values.chosen("method")],
        lock: [Lock::Parameter, Lock::SelfConsistent, Lock::DataGuide][values.chosen("lock")],
        joint: [JointParameter::Half, JointParameter::Knot, JointParameter::G2][values.chosen("joint")],
        ends: [Ends::Free, Ends::Perpendicular][values.chosen("ends")],
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
        // Writing to a string cannot fail.
        let _ = writeln!(text, "curve {c}: {}", report(&done));
    }
    Ok(vec![Output::Curves(drawn), Output::Text(text)])
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
        "{} points, {} segments, {what}; {} points with a status of their own, {missed} missed; largest miss {:.1e} of the size",
        done.statuses().len(),
        done.curve(0).len(),
        account.not_ok,
        account.max_residual
    )
}
