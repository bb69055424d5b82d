use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::signatures::{ONE_MESH, TO_MESH_TEXT};
use super::smooth::{self, CATEGORY, DEVIATION, MIN_PARTS_PER_SIDE, REFERENCE, SCHEME, TRIANGLES};
use super::typed_param::{ParamValues, params};
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
    ..Filter::new(ONE_MESH, TO_MESH_TEXT, &FilterBody(run))
};

params! {
    scheme: Scheme = SCHEME;
    deviation: f64 = DEVIATION;
    parts: u32 = MIN_PARTS_PER_SIDE;
    triangles: bool = TRIANGLES;
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let surface = smooth::surface_through_mesh(inputs[0].mesh()?, values.scheme, &job.sub_job(0.0, 0.4))?;
    let (mesh, report) =
        smooth::mesh_surface(&surface, (values.deviation, values.parts, values.triangles), &job.sub_job(0.4, 1.0))?;
    Ok(vec![Output::Mesh(mesh, None), Output::Text(report)])
}
