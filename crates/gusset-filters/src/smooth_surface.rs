use super::data::{Input, Output};
use super::filter::{Body, Filter};
use super::signatures::{MESH, TO_MESH_TEXT};
use super::smooth::{self, CATEGORY, DEVIATION, PARTS, REFERENCE, SCHEME, TRIANGLES};
use super::typed::{Values, params};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_surface::Scheme;

pub(super) const FILTER: Filter = Filter {
    id: "smooth_surface",
    name: "Smooth surface through a quad grid",
    category: CATEGORY,
    help: "Draws a smooth surface through the vertices of a quad grid, and returns it as a finer mesh. Its vertices lie on the \
           surface, and its faces deviate from it at most as requested.",
    reference: REFERENCE,
    ..Filter::new(MESH, TO_MESH_TEXT, &Body(run))
};

params! {
    scheme: Scheme = SCHEME;
    deviation: f64 = DEVIATION;
    parts: u32 = PARTS;
    triangles: bool = TRIANGLES;
}

fn run(inputs: &[Input<'_>], values: &Values<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let surface = smooth::surface(inputs[0].mesh()?, values.scheme, &job.part(0.0, 0.4))?;
    let (mesh, report) =
        smooth::meshed(&surface, (values.deviation, values.parts, values.triangles), &job.part(0.4, 1.0))?;
    Ok(vec![Output::Mesh(mesh, None), Output::Text(report)])
}
