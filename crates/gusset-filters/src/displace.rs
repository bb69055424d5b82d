use super::data::{Input, Output};
use super::filter::Filter;
use super::param::{COORDINATES, Param, Values};
use super::quads::{self, CATEGORY, REFERENCE, TRIANGLES};
use super::signatures::{MESH, TO_MESH};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_net::field::displace;

pub(super) const FILTER: Filter = Filter {
    id: "displace",
    name: "Displace a quad grid along its normals",
    category: CATEGORY,
    help: "Moves every vertex of a quad grid along the surface normal, at poles and across seams too; glued vertices stay glued.",
    reference: REFERENCE,
    replaces: true,
    has_origins: true,
    params: &[
        Param::length("distance", "Distance", COORDINATES, &[0.01])
            .with_help(
                "The displacement: outwards if positive, inwards if negative; a hundredth of the size is suggested.",
            )
            .with_size_ratio(0.01),
        TRIANGLES,
    ],
    ..Filter::new(MESH, TO_MESH, run)
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let input = inputs[0].mesh()?;
    let mut grid = quads::grid(input, &job.part(0.0, 0.5))?;
    displace(&mut grid.net, values.number("distance"), &job.part(0.5, 0.7))?;
    let all = |count: usize| alloc::collect(0..count);
    let (rows, columns) = (all(grid.net.shape().rows())?, all(grid.net.shape().columns())?);
    Ok(vec![quads::output(&grid.net, (input, &grid), [&rows, &columns], values, &job.part(0.7, 1.0))?])
}
