//! The filter `smooth_surface`.

use super::Filter;
use super::data::{Input, InputKind, Output, OutputKind};
use super::param::Values;
use super::smooth::{self, CATEGORY, FINENESS, REFERENCE, SCHEME};
use crate::error::Result;
use crate::job::Job;

pub(super) const FILTER: Filter = Filter {
    id: "smooth_surface",
    name: "Smooth surface through quads",
    script_name: "smooth_surface",
    category: CATEGORY,
    help: "Draws a smooth surface through the vertices of a grid of quads and returns it as a finer mesh, whose vertices lie on the \
           surface and whose faces are as near to it as is asked for.",
    reference: REFERENCE,
    inputs: &[InputKind::Mesh],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Mesh, OutputKind::Text],
    replaces: false,
    params: &[SCHEME, FINENESS[0], FINENESS[1], FINENESS[2]],
    suggest: None,
    run,
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let surface = smooth::surface(inputs[0].mesh()?, values, &job.part(0.0, 0.4))?;
    let (mesh, text) = smooth::meshed(&surface, values, &job.part(0.4, 1.0))?;
    Ok(vec![Output::Mesh(mesh), Output::Text(text)])
}
