use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::quads::{self, CATEGORY, REFERENCE, TRIANGLES};
use super::signatures::{ONE_MESH, TO_MESH};
use super::typed_param::{COORDINATE_RANGE, Param, ParamValues, params};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_net::field::displace_along_normals;

pub(super) const FILTER: Filter = Filter {
    id: "displace",
    name: "Displace a quad grid along its normals",
    category: CATEGORY,
    help: "Moves every vertex of a quad grid along the surface normal. Poles and seams stay closed.",
    reference: REFERENCE,
    replaces: true,
    has_origins: true,
    ..Filter::new(ONE_MESH, TO_MESH, &FilterBody(run))
};

params! {
    distance: f64 = Param::length(
        "Distance",
        "The displacement, outwards if positive and inwards if negative. A hundredth of the size is suggested.",
        COORDINATE_RANGE, &[0.01],
    ).with_size_ratio(0.01);
    triangles: bool = TRIANGLES;
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let input = inputs[0].mesh()?;
    let mut grid = quads::recognise_grid(input, &job.sub_job(0.0, 0.5))?;
    displace_along_normals(&mut grid.net, values.distance, &job.sub_job(0.5, 0.7))?;
    let all = |count: usize| alloc::collect(0..count);
    let (rows, columns) = (all(grid.net.shape().rows())?, all(grid.net.shape().columns())?);
    Ok(vec![quads::output_of_resampled_grid(
        &grid.net,
        (input, &grid),
        [&rows, &columns],
        (values, values.triangles),
        &job.sub_job(0.7, 1.0),
    )?])
}
