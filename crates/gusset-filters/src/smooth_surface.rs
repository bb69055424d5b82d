use super::data::{Input, Output};
use super::filter::Filter;
use super::param::Values;
use super::signatures::{MESH, TO_MESH_TEXT};
use super::smooth::{self, CATEGORY, FINENESS, REFERENCE, SCHEME};
use gusset_base::error::Result;
use gusset_base::job::Job;

pub(super) const FILTER: Filter = Filter {
    id: "smooth_surface",
    name: "Smooth surface through a quad grid",
    category: CATEGORY,
    help: "Draws a smooth surface through the vertices of a quad grid and returns it as a finer mesh, whose vertices lie on the \
           surface and whose faces are within the deviation of it.",
    reference: REFERENCE,
    params: &[SCHEME, FINENESS[0], FINENESS[1], FINENESS[2]],
    ..Filter::new(MESH, TO_MESH_TEXT, run)
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let surface = smooth::surface(inputs[0].mesh()?, values, &job.part(0.0, 0.4))?;
    let (mesh, report) = smooth::meshed(&surface, values, &job.part(0.4, 1.0))?;
    Ok(vec![Output::Mesh(mesh, None), Output::Text(report)])
}
