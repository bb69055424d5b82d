//! The filter `curve_offset`.

use super::Filter;
use super::curve::{self, BETWEEN, CATEGORY, CHORD, Flat, PLANE};
use super::data::{Curves, Input, InputKind, Output, OutputKind};
use super::extent::{extent_of, put, rounded};
use super::param::{PLACES, Param, ParamKind, Values};
use crate::error::Result;
use crate::job::Job;
use crate::outline::ops::{OffsetOptions, Spacing};
use std::fmt::Write;

/// Segments that an offset may have.
const MOST: usize = 1 << 20;

pub(super) const FILTER: Filter = Filter {
    id: "curve_offset",
    name: "Offset curves",
    script_name: "curve_offset",
    category: CATEGORY,
    help: "Draws plane curves at a distance from given ones, to their left seen against the normal of the plane. Corners are joined \
           by straight segments; where the distance is greater than the radius of a bend the offset crosses itself.",
    reference: "Hermite interpolation of the exact offset, halved until the deviation measured is small enough",
    inputs: &[InputKind::Curves],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Curves, OutputKind::Text],
    replaces: false,
    params: PARAMS,
    suggest: Some(suggest),
    run,
};

const PARAMS: &[Param] = &[
    BETWEEN,
    PLANE,
    Param::new(
        "distance",
        "Distance",
        "How far the new curves are from the old ones: to the left, or to the right if it is negative.",
        ParamKind::Length,
        PLACES,
        &[0.1],
    ),
    CHORD,
];

fn suggest(inputs: &[Input<'_>], values: &mut [f64]) {
    curve::suggest_plane(PARAMS, inputs, values);
    if let Some(extent) = extent_of(inputs) {
        put(PARAMS, values, "distance", &[rounded(0.02 * extent.diagonal())]);
    }
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let (given, flat) = (inputs[0].curves()?, Flat::new(values)?);
    let curves = flat.curves(given, values, &job.part(0.0, 0.3))?;
    let tolerance = curve::chord(given, values);
    let options = OffsetOptions { degree: 3, tolerance: 0.5 * tolerance, max_segments: MOST };
    let (mut drawn, mut text) = (Curves::none(), String::new());
    for (c, curve) in curves.iter().enumerate() {
        let part = job.part(0.3, 1.0).share(c, curves.len());
        part.step(0.0, "offset")?;
        if curve.view().is_empty() {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "curve {c}: left out, without extent");
            continue;
        }
        let offset = curve.view().offset_cancellable(values.number("distance"), &options, &part.part(0.0, 0.8))?;
        let points = curve::sampled(&offset.curve.view(), Spacing::Chord(0.5 * tolerance), &part.part(0.8, 1.0))?;
        drawn.add(points.iter().map(|&point| flat.point(point)), offset.curve.view().is_closed())?;
        let tight = if offset.tight { ", some bends are tighter than the distance" } else { "" };
        let reached = if offset.reached { "" } else { ", which is more than asked for" };
        let _ = writeln!(
            text,
            "curve {c}: {} corners, at most {:.1e} from the true offset{reached}{tight}",
            offset.corners, offset.deviation
        );
    }
    Ok(vec![Output::Curves(drawn), Output::Text(text)])
}
