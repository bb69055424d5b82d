//! The filter `smooth_silhouette`.

use super::Filter;
use super::data::{Input, InputKind, Output, OutputKind};
use super::param::{Param, ParamKind, Values};
use super::smooth::{self, CATEGORY, CHORD, REFERENCE, SCHEME};
use crate::error::Result;
use crate::job::Job;
use std::f64::consts::{FRAC_PI_2, PI};

pub(super) const FILTER: Filter = Filter {
    id: "smooth_silhouette",
    name: "Silhouettes of a smooth surface",
    script_name: "smooth_silhouette",
    category: CATEGORY,
    help: "Finds where the normals of the smooth surface through the vertices of a grid of quads make an angle with a direction: at \
           a quarter turn the silhouettes seen along it, else lines of equal slope.",
    reference: REFERENCE,
    inputs: &[InputKind::Mesh],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Curves, OutputKind::Text],
    replaces: false,
    params: &[
        SCHEME,
        smooth::direction("The direction that is looked along."),
        Param {
            id: "angle",
            label: "Angle",
            help: "The angle between normals and the direction.",
            kind: ParamKind::Angle,
            min: 0.0,
            max: PI,
            default: &[FRAC_PI_2],
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
    let (direction, angles) = (values.vector("direction"), [values.number("angle")]);
    let between = smooth::chord(&surface, values);
    let paths = surface.isophotes(direction, &angles, false, between, &job.part(0.4, 1.0))?;
    Ok(vec![Output::Curves(smooth::polylines(&paths)?), Output::Text(smooth::account(&paths))])
}
