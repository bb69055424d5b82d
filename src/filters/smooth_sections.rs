//! The filter `smooth_sections`.

use super::Filter;
use super::data::{Input, InputKind, Output, OutputKind};
use super::param::{Choice, Param, ParamKind, Values};
use super::smooth::{self, CATEGORY, CHORD, REFERENCE, SCHEME};
use crate::carcass::level::Planes;
use crate::carcass::{Carcass, Paths};
use crate::error::{Error, Result};
use crate::job::Job;
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
    params: &[
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
        Param {
            id: "number",
            label: "Number",
            help: "The number of planes.",
            kind: ParamKind::Int,
            min: 1.0,
            max: 10_000.0,
            default: &[10.0],
            step: 1.0,
            choices: &[],
        },
        Param {
            id: "offset",
            label: "Offset",
            help: "How far the first plane is from the origin, along the direction; for given planes.",
            kind: ParamKind::Length,
            min: -1e9,
            max: 1e9,
            default: &[0.0],
            step: 0.0,
            choices: &[],
        },
        Param {
            id: "distance",
            label: "Distance",
            help: "How far planes are from each other; for given planes.",
            kind: ParamKind::Length,
            min: 1e-9,
            max: 1e9,
            default: &[1.0],
            step: 0.0,
            choices: &[],
        },
        CHORD,
    ],
    suggest: None,
    run,
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let surface = smooth::surface(inputs[0].mesh()?, values, &job.part(0.0, 0.4))?;
    let paths = cut(&surface, values, &job.part(0.4, 1.0))?;
    Ok(vec![Output::Curves(smooth::polylines(&paths)?), Output::Text(smooth::account(&paths))])
}

fn cut(surface: &Carcass<'_>, values: &Values<'_>, job: &Job<'_>) -> Result<Paths> {
    let given = values.vector("direction");
    let bad = Error::OptionOutOfRange { option: "direction", value: given.length() };
    let normal = given.try_normalize().ok_or(bad)?;
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
fn evenly(surface: &Carcass<'_>, normal: DVec3, number: usize) -> [f64; 2] {
    let [low, high] = surface.bounds();
    let corner = |k: usize| DVec3::new([low.x, high.x][k & 1], [low.y, high.y][k >> 1 & 1], [low.z, high.z][k >> 2]);
    let along = || (0..8).map(|k| corner(k).dot(normal));
    let (from, to) = (along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max));
    let distance = (to - from) / number as f64;
    [from + 0.5 * distance, distance]
}
