use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::signatures::{TO_CURVES_TEXT, TWO_MESHES};
use super::smooth::{self, CATEGORY, CHORD_ERROR, REFERENCE, SCHEME};
use super::typed_param::{ParamValues, params};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_surface::Scheme;
use gusset_surface::surface_intersection::Options;

pub(super) const FILTER: Filter = Filter {
    id: "smooth_intersect",
    name: "Intersection of smooth surfaces",
    category: CATEGORY,
    help: "Finds the intersection curves of the smooth surfaces through the vertices of two quad grids. No branch is missed. \
           Points where the surfaces touch or branches cross are resolved. Cells where the surfaces touch along a curve or \
           coincide count as unresolved.",
    reference: REFERENCE,
    ..Filter::new(TWO_MESHES, TO_CURVES_TEXT, &FilterBody(run))
};

params! {
    scheme: Scheme = SCHEME;
    chord_error: f64 = CHORD_ERROR;
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let a = smooth::surface_through_mesh(inputs[0].mesh()?, values.scheme, &job.sub_job(0.0, 0.2))?;
    let b = smooth::surface_through_mesh(inputs[1].mesh()?, values.scheme, &job.sub_job(0.2, 0.4))?;
    let size = |[low, high]: [glam::DVec3; 2]| low.distance(high);
    let chord = values.chord_error * size(a.bounds()).min(size(b.bounds()));
    let options = Options { chord: Some(chord.max(f64::MIN_POSITIVE)), ..Options::default() };
    let paths = a.meet(&b, &options, &job.sub_job(0.4, 1.0))?;
    Ok(vec![Output::Curves(smooth::paths_to_curves(&paths)?), Output::Text(smooth::paths_summary(&paths).into())])
}
