use super::data::{Input, Output};
use super::filter::Filter;
use super::param::{Param, Values};
use super::report::CURVE;
use super::report::{counted, push_line};
use super::signatures::{MESH, TO_CURVES_TEXT};
use super::smooth::{self, CATEGORY, CHORD_ERROR, REFERENCE, SCHEME};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::{alloc, choices};
use std::f64::consts::{FRAC_PI_2, PI};

pub(super) const FILTER: Filter = Filter {
    id: "smooth_isophotes",
    name: "Isophotes of a smooth surface",
    category: CATEGORY,
    help: "Draws isophotes of the smooth surface through the vertices of a quad grid: the curves on which its normals make one of \
           several equally spaced angles with a direction. Where isophotes are not smooth the surface is not fair.",
    reference: REFERENCE,
    params: &[
        SCHEME,
        Param::direction("direction", "Direction").with_help("The direction that the light comes from."),
        Param::int("number", "Number", [1.0, 10_000.0], &[12.0]).with_help("The number of angles."),
        Param::choice("sides", "Sides", SIDES.texts).with_help("The range of the angles."),
        CHORD_ERROR,
    ],
    ..Filter::new(MESH, TO_CURVES_TEXT, run)
};

choices! {
    /// Whether normals and their opposites count as equal.
    SIDES: bool =
        false => "Both", "From 0 to pi: lit and dark sides.";
        true => "Alike", "From 0 to pi / 2: normals and their opposites count as equal.";
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let direction = values.direction("direction")?;
    let surface = smooth::surface(inputs[0].mesh()?, values, &job.part(0.0, 0.4))?;
    let (number, unsigned) = (values.number("number") as usize, values.choice("sides", SIDES));
    let most = if unsigned { FRAC_PI_2 } else { PI };
    // Half a step is left at either end.
    let angles = alloc::collect((0..number).map(|k| most * (k as f64 + 0.5) / number as f64))?;
    let paths =
        surface.isophotes(direction, &angles, unsigned, smooth::chord(&surface, values), &job.part(0.4, 1.0))?;
    let mut text = smooth::summary(&paths);
    let mut counts = alloc::filled(0, number)?;
    paths.levels.iter().for_each(|&level| counts[level as usize] += 1);
    for (angle, count) in angles.iter().zip(counts) {
        push_line!(text, "{:.4} degrees: {}", angle.to_degrees(), counted(count, CURVE));
    }
    Ok(vec![Output::Curves(smooth::polylines(&paths)?), Output::Text(text.into())])
}
