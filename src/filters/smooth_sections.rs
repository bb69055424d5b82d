//! The filter `smooth_sections`.

use super::Filter;
use super::data::{Input, InputKind, Output, OutputKind};
use super::extent::{extent_of, put};
use super::param::{Choice, LENGTHS, PLACES, Param, ParamKind, Values};
use super::smooth::{self, CATEGORY, CHORD, REFERENCE, SCHEME};
use crate::error::Result;
use crate::geom::aabb;
use crate::job::Job;
use crate::surface::contour::Planes;
use crate::surface::{Paths, Surface};
use glam::DVec3;

pub(super) const FILTER: Filter = Filter {
    id: "smooth_sections",
    name: "Plane sections of a smooth surface",
    script_name: "smooth_sections",
    category: CATEGORY,
    help: "Cuts the smooth surface through the vertices of a grid of quads by parallel planes, and returns the curves in order. \
           No curve is missed, and points lie on the surface, not on the quads.",
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
    smooth::direction("The direction across the planes."),
    Param::choice(
        "placement",
        "Planes",
        "Where the planes are.",
        &[
            Choice { label: "Even", help: "Evenly over the extent of the surface." },
            Choice { label: "Given", help: "At the offset and, one after the other, at the distance from there." },
        ],
    ),
    Param::new("number", "Number", "The number of planes.", ParamKind::Int, [1.0, 10_000.0], &[10.0]),
    Param::new(
        "offset",
        "Offset",
        "How far the first plane is from the origin, along the direction; for given planes.",
        ParamKind::Length,
        PLACES,
        &[0.0],
    ),
    Param::new(
        "distance",
        "Distance",
        "How far planes are from each other; for given planes.",
        ParamKind::Length,
        LENGTHS,
        &[1.0],
    ),
    CHORD,
];

/// Ten planes across the z axis, as the defaults of the other parameters have it.
fn suggest(inputs: &[Input<'_>], values: &mut [f64]) {
    if let Some(extent) = extent_of(inputs) {
        let height = Some(extent.size().z).filter(|&height| height > 0.0).unwrap_or(extent.diagonal());
        put(PARAMS, values, "offset", &[extent.low.z + 0.05 * height]);
        put(PARAMS, values, "distance", &[0.1 * height]);
    }
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let surface = smooth::surface(inputs[0].mesh()?, values, &job.part(0.0, 0.4))?;
    let paths = cut(&surface, values, &job.part(0.4, 1.0))?;
    Ok(vec![Output::Curves(smooth::polylines(&paths)?), Output::Text(smooth::account(&paths))])
}

fn cut(surface: &Surface<'_>, values: &Values<'_>, job: &Job<'_>) -> Result<Paths> {
    let normal = values.direction("direction")?;
    let number = values.number("number") as usize;
    let [first, distance] = match values.chosen("placement") {
        0 => evenly(surface, normal, number),
        _ => [values.number("offset"), values.number("distance")],
    };
    let mut offsets: Vec<f64> = (0..number).map(|k| first + k as f64 * distance).collect();
    // Planes that rounding makes one, where the surface has no extent, are one.
    offsets.dedup();
    let planes = Planes { point: DVec3::ZERO, normal, offsets: &offsets };
    surface.section(&planes, smooth::chord(surface, values), job)
}

/// The offset of the first plane and the distance of planes: half a distance is left at either end.
fn evenly(surface: &Surface<'_>, normal: DVec3, number: usize) -> [f64; 2] {
    let [low, high] = surface.bounds();
    let corner = |k: usize| DVec3::new([low.x, high.x][k & 1], [low.y, high.y][k >> 1 & 1], [low.z, high.z][k >> 2]);
    let [from, to] = aabb::range((0..8).map(|k| corner(k).dot(normal)));
    let distance = (to - from) / number as f64;
    [from + 0.5 * distance, distance]
}
