//! The filter `smooth_curve`.

use super::Filter;
use super::curve::{self, BETWEEN};
use super::data::{Curves, Input, InputKind, Output, OutputKind};
use super::param::Values;
use super::smooth::{self, CATEGORY, REFERENCE, SCHEME};
use crate::error::{Error, Result};
use crate::job::Job;
use crate::surface::line_intersection::HitSelection;
use std::fmt::Write;

/// Hits that the report lists one by one.
const LISTED: usize = 1000;

pub(super) const FILTER: Filter = Filter {
    id: "smooth_curve",
    name: "Curves through a smooth surface",
    script_name: "smooth_curve",
    category: CATEGORY,
    help: "Finds where curves meet the smooth surface through the vertices of a grid of quads: a curve of one point for each hit. No hit \
           is missed.",
    reference: REFERENCE,
    inputs: &[InputKind::Mesh, InputKind::Curves],
    min_inputs: 2,
    max_inputs: 2,
    outputs: &[OutputKind::Curves, OutputKind::Text],
    replaces: false,
    params: &[SCHEME, BETWEEN],
    suggest: None,
    run,
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let curves = curve::curves(inputs[1].curves()?, values, &job.part(0.0, 0.2))?;
    let surface = smooth::surface(inputs[0].mesh()?, values, &job.part(0.2, 0.6))?;
    let (mut points, mut text) = (Curves::none(), String::new());
    let job = job.part(0.6, 1.0);
    for (c, curve) in curves.iter().enumerate().filter(|(_, curve)| !curve.view().is_empty()) {
        let part = job.share(c, curves.len());
        let hits = surface.curve(&curve.view(), HitSelection::All, &part).map_err(|error| match error {
            Error::OptionOutOfRange { .. } => Error::InputUnfit { input: 1, why: "coordinates up to 1e150 are needed" },
            error => error,
        })?;
        for hit in hits {
            points.add([hit.point].into_iter(), false)?;
            if points.closed.len() <= LISTED {
                let [x, y, z] = hit.point.to_array();
                let touches = if hit.tangent { ", touches" } else { "" };
                // Writing to a string cannot fail.
                let _ = writeln!(text, "curve {c} at {} + {}: ({x} {y} {z}){touches}", hit.at.segment, hit.at.t);
            }
        }
    }
    let _ = writeln!(text, "{} hits", points.closed.len());
    Ok(vec![Output::Curves(points), Output::Text(text)])
}
