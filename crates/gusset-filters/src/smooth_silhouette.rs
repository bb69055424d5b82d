use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::signatures::{ONE_MESH, TO_CURVES_TEXT};
use super::smooth::{self, CATEGORY, CHORD_ERROR, REFERENCE, SCHEME};
use super::typed_param::{Param, ParamValues, params};
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_surface::Scheme;
use std::f64::consts::{FRAC_PI_2, PI};

pub(super) const FILTER: Filter = Filter {
    id: "smooth_silhouette",
    name: "Silhouettes of a smooth surface",
    category: CATEGORY,
    help: "Finds where the normals of the smooth surface through the vertices of a quad grid make a given angle with a \
           direction. The angle pi / 2 gives the silhouettes seen along the direction; other angles give lines of equal slope.",
    reference: REFERENCE,
    ..Filter::new(ONE_MESH, TO_CURVES_TEXT, &FilterBody(run))
};

params! {
    scheme: Scheme = SCHEME;
    direction: DVec3 = Param::direction("Direction", "The direction of view.");
    angle: f64 = Param::angle("Angle", "The angle between normals and the direction.", [0.0, PI], &[FRAC_PI_2]);
    chord_error: f64 = CHORD_ERROR;
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let surface = smooth::surface_through_mesh(inputs[0].mesh()?, values.scheme, &job.sub_job(0.0, 0.4))?;
    let (direction, angles) = (values.direction, [values.angle]);
    let between = smooth::chord_spacing(&surface, values.chord_error);
    let paths = surface.isophotes(direction, &angles, false, between, &job.sub_job(0.4, 1.0))?;
    Ok(vec![Output::Curves(smooth::paths_to_curves(&paths)?), Output::Text(smooth::paths_summary(&paths).into())])
}
