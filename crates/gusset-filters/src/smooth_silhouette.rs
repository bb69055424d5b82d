use super::data::{Input, Output};
use super::filter::Filter;
use super::param::{Param, ParamKind, Values};
use super::signatures::{MESH, TO_CURVES_TEXT};
use super::smooth::{self, CATEGORY, CHORD_ERROR, REFERENCE, SCHEME};
use gusset_base::error::Result;
use gusset_base::job::Job;
use std::f64::consts::{FRAC_PI_2, PI};

pub(super) const FILTER: Filter = Filter {
    id: "smooth_silhouette",
    name: "Silhouettes of a smooth surface",
    category: CATEGORY,
    help: "Finds where the normals of the smooth surface through the vertices of a quad grid make an angle with a direction: at pi / 2 \
           the silhouettes seen along it, otherwise lines of equal slope.",
    reference: REFERENCE,
    params: &[
        SCHEME,
        Param::direction("direction", "Direction").with_help("The direction of view."),
        Param::new(ParamKind::Angle, "angle", "Angle", [0.0, PI], &[FRAC_PI_2])
            .with_help("The angle between normals and the direction."),
        CHORD_ERROR,
    ],
    ..Filter::new(MESH, TO_CURVES_TEXT, run)
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let surface = smooth::surface(inputs[0].mesh()?, values, &job.part(0.0, 0.4))?;
    let (direction, angles) = (values.vector("direction"), [values.number("angle")]);
    let between = smooth::chord(&surface, values);
    let paths = surface.isophotes(direction, &angles, false, between, &job.part(0.4, 1.0))?;
    Ok(vec![Output::Curves(smooth::polylines(&paths)?), Output::Text(smooth::summary(&paths).into())])
}
