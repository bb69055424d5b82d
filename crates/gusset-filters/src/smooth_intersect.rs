use super::data::{Input, Output};
use super::filter::Filter;
use super::param::Values;
use super::signatures::{TO_CURVES_TEXT, TWO_MESHES};
use super::smooth::{self, CATEGORY, CHORD_ERROR, REFERENCE, SCHEME};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_surface::surface_intersection::Options;

pub(super) const FILTER: Filter = Filter {
    id: "smooth_intersect",
    name: "Intersection of smooth surfaces",
    category: CATEGORY,
    help: "Finds the intersection curves of the smooth surfaces through the vertices of two quad grids. No branch is missed; points \
           where the surfaces touch, or branches cross, are resolved; cells where they touch along a curve or coincide are counted as unresolved.",
    reference: REFERENCE,
    params: &[SCHEME, CHORD_ERROR],
    ..Filter::new(TWO_MESHES, TO_CURVES_TEXT, run)
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let a = smooth::surface(inputs[0].mesh()?, values, &job.part(0.0, 0.2))?;
    let b = smooth::surface(inputs[1].mesh()?, values, &job.part(0.2, 0.4))?;
    let size = |[low, high]: [glam::DVec3; 2]| low.distance(high);
    let chord = values.number(CHORD_ERROR.id) * size(a.bounds()).min(size(b.bounds()));
    let options = Options { chord: Some(chord.max(f64::MIN_POSITIVE)), ..Options::default() };
    let paths = a.meet(&b, &options, &job.part(0.4, 1.0))?;
    Ok(vec![Output::Curves(smooth::polylines(&paths)?), Output::Text(smooth::summary(&paths).into())])
}
