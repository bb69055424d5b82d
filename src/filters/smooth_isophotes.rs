//! The filter `smooth_isophotes`.

use super::Filter;
use super::data::{Input, InputKind, Output, OutputKind};
use super::param::{Choice, Param, ParamKind, Values};
use super::smooth::{self, CATEGORY, CHORD, REFERENCE, SCHEME};
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt::Write;

pub(super) const FILTER: Filter = Filter {
    id: "smooth_isophotes",
    name: "Lines of equal light",
    script_name: "smooth_isophotes",
    category: CATEGORY,
    help: "Draws lines of equal light on the smooth surface through the vertices of a grid of quads: where its normals make one of several \
           angles, evenly spread, with a direction. Where such lines are not smooth the surface is not fair.",
    reference: REFERENCE,
    inputs: &[InputKind::Mesh],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Curves, OutputKind::Text],
    replaces: false,
    params: &[
        SCHEME,
        smooth::direction("The direction that the light comes from."),
        Param::new("number", "Number", "The number of angles.", ParamKind::Int, [1.0, 10_000.0], &[12.0]),
        Param::choice(
            "sides",
            "Sides",
            "Which angles there are.",
            &[
                Choice { label: "Both", help: "From 0 to half a turn: lit and dark sides." },
                Choice { label: "Alike", help: "From 0 to a quarter turn: normals and their opposites are the same." },
            ],
        ),
        CHORD,
    ],
    suggest: None,
    run,
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let direction = values.direction("direction")?;
    let surface = smooth::surface(inputs[0].mesh()?, values, &job.part(0.0, 0.4))?;
    let (number, unsigned) = (values.number("number") as usize, values.chosen("sides") == 1);
    let most = if unsigned { FRAC_PI_2 } else { PI };
    // Half a step is left at either end.
    let angles = alloc::collect((0..number).map(|k| most * (k as f64 + 0.5) / number as f64))?;
    let paths =
        surface.isophotes(direction, &angles, unsigned, smooth::chord(&surface, values), &job.part(0.4, 1.0))?;
    let mut text = smooth::account(&paths);
    let mut counts = alloc::filled(0, number)?;
    paths.levels.iter().for_each(|&level| counts[level as usize] += 1);
    for (angle, count) in angles.iter().zip(counts) {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{:.4} degrees: {count} curves", angle.to_degrees());
    }
    Ok(vec![Output::Curves(smooth::polylines(&paths)?), Output::Text(text)])
}
