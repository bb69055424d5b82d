use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::report::{CURVE, count_with_noun, push_line};
use super::signatures::{ONE_MESH, TO_CURVES_TEXT};
use super::smooth::{self, CATEGORY, CHORD_ERROR, REFERENCE, SCHEME};
use super::typed_param::{Param, ParamValues, params};
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::{alloc, choices};
use gusset_surface::Scheme;
use std::f64::consts::{FRAC_PI_2, PI};

pub(super) const FILTER: Filter = Filter {
    id: "smooth_isophotes",
    name: "Isophotes of a smooth surface",
    category: CATEGORY,
    help: "Draws isophotes of the smooth surface through the vertices of a quad grid: curves on which the normals make one of \
           several equally spaced angles with a direction. Where isophotes are not smooth, the surface is not fair.",
    reference: REFERENCE,
    ..Filter::new(ONE_MESH, TO_CURVES_TEXT, &FilterBody(run))
};

params! {
    scheme: Scheme = SCHEME;
    direction: DVec3 = Param::direction("Direction", "The direction that the light comes from.");
    number: u32 = Param::int("Number", "The number of angles.", [1.0, 10_000.0], &[12.0]);
    sides: bool = Param::choice("Sides", "The range of the angles.", SIDES);
    chord_error: f64 = CHORD_ERROR;
}

choices! {
    /// True if a normal and its opposite count as equal.
    SIDES: bool =
        false => "Both", "From 0 to pi: lit and dark sides.";
        true => "Alike", "From 0 to pi / 2: a normal and its opposite count as equal.";
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let surface = smooth::surface_through_mesh(inputs[0].mesh()?, values.scheme, &job.sub_job(0.0, 0.4))?;
    let (number, unsigned) = (values.number as usize, values.sides);
    let most = if unsigned { FRAC_PI_2 } else { PI };
    // Half a step remains at each end.
    let angles = alloc::collect((0..number).map(|k| most * (k as f64 + 0.5) / number as f64))?;
    let paths = surface.isophotes(
        values.direction,
        &angles,
        unsigned,
        smooth::chord_spacing(&surface, values.chord_error),
        &job.sub_job(0.4, 1.0),
    )?;
    let mut text = smooth::paths_summary(&paths);
    let mut counts = alloc::filled(0, number)?;
    paths.levels.iter().for_each(|&level| counts[level as usize] += 1);
    for (angle, count) in angles.iter().zip(counts) {
        push_line!(text, "{:.4} degrees: {}", angle.to_degrees(), count_with_noun(count, CURVE));
    }
    Ok(vec![Output::Curves(smooth::paths_to_curves(&paths)?), Output::Text(text.into())])
}
