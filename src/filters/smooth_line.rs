//! The filter `smooth_line`.

use super::Filter;
use super::data::{Curves, Input, InputKind, Output, OutputKind};
use super::extent::{extent_of, put};
use super::param::{Choice, PLACES, Param, ParamKind, Values};
use super::smooth::{self, CATEGORY, REFERENCE, SCHEME};
use crate::error::Result;
use crate::job::Job;
use crate::surface::line_intersection::{HitSelection, Line};
use std::fmt::Write;

pub(super) const FILTER: Filter = Filter {
    id: "smooth_line",
    name: "Line through a smooth surface",
    script_name: "smooth_line",
    category: CATEGORY,
    help: "Finds where a line or a ray meets the smooth surface through the vertices of a grid of quads: a curve of one point for each \
           hit, and for each its distance from the given point and the normal. No hit is missed.",
    reference: REFERENCE,
    inputs: &[InputKind::Mesh],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Curves, OutputKind::Text],
    replaces: false,
    params: PARAMS,
    suggest: Some(suggest),
    run,
};

const PARAMS: &[Param] = &[
    SCHEME,
    Param::new(
        "point",
        "Point",
        "The line passes this point, and a ray begins there; suggested is one below the middle of the mesh.",
        ParamKind::Point,
        PLACES,
        &[0.0, 0.0, -1e3],
    ),
    smooth::direction("The direction of the line."),
    Param::choice(
        "which",
        "Hits",
        "Which hits are wanted.",
        &[
            Choice { label: "All of the line", help: "Before and behind the point." },
            Choice { label: "All of the ray", help: "From the point on." },
            Choice { label: "First of the ray", help: "The one nearest to the point." },
        ],
    ),
];

fn suggest(inputs: &[Input<'_>], values: &mut [f64]) {
    if let Some(extent) = extent_of(inputs) {
        let point = extent.centre().with_z(extent.low.z - 0.1 * extent.diagonal());
        put(PARAMS, values, "point", &point.to_array());
    }
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let (point, direction) = (values.vector("point"), values.direction("direction")?);
    let surface = smooth::surface(inputs[0].mesh()?, values, &job.part(0.0, 0.9))?;
    job.step(0.9, "line")?;
    let (line, which) = match values.chosen("which") {
        0 => (Line::new(point, direction), HitSelection::All),
        1 => (Line::ray(point, direction), HitSelection::All),
        _ => (Line::ray(point, direction), HitSelection::First),
    };
    let hits = surface.line(&line, which)?;
    let (mut points, mut text) = (Curves::none(), format!("{} hits\n", hits.len()));
    for hit in &hits {
        points.add([hit.point].into_iter(), false)?;
        let ([x, y, z], [a, b, c]) = (hit.point.to_array(), hit.normal.to_array());
        let touches = if hit.tangent { ", touches" } else { "" };
        // Writing to a string cannot fail.
        let _ = writeln!(text, "at {}: ({x} {y} {z}), normal ({a} {b} {c}){touches}", hit.t);
    }
    Ok(vec![Output::Curves(points), Output::Text(text)])
}
