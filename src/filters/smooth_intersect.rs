//! The filter `smooth_intersect`.

use super::Filter;
use super::data::{Input, InputKind, Output, OutputKind};
use super::param::Values;
use super::smooth::{self, CATEGORY, CHORD, REFERENCE, SCHEME};
use crate::error::Result;
use crate::job::Job;
use crate::surface::surface_intersection::Options;

pub(super) const FILTER: Filter = Filter {
    id: "smooth_intersect",
    name: "Intersection of smooth surfaces",
    script_name: "smooth_intersect",
    category: CATEGORY,
    help: "Finds the curves in which the smooth surfaces through the vertices of two grids of quads meet. No branch is missed; where the \
           surfaces touch or coincide, the places are counted as unresolved.",
    reference: REFERENCE,
    inputs: &[InputKind::Mesh, InputKind::Mesh],
    min_inputs: 2,
    max_inputs: 2,
    outputs: &[OutputKind::Curves, OutputKind::Text],
    replaces: false,
    params: &[SCHEME, CHORD],
    suggest: None,
    run,
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let a = smooth::surface(inputs[0].mesh()?, values, &job.part(0.0, 0.2))?;
    let b = smooth::surface(inputs[1].mesh()?, values, &job.part(0.2, 0.4))?;
    let size = |[low, high]: [glam::DVec3; 2]| low.distance(high);
    let chord = values.number(CHORD.id) * size(a.bounds()).min(size(b.bounds()));
    let options = Options { chord: Some(chord.max(f64::MIN_POSITIVE)), ..Options::default() };
    let paths = a.meet(&b, &options, &job.part(0.4, 1.0))?;
    Ok(vec![Output::Curves(smooth::polylines(&paths)?), Output::Text(smooth::account(&paths))])
}
