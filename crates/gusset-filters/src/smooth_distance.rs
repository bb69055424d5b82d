use super::data::with_positions;
use super::data::{Input, Output};
use super::deform::moved_output;
use super::filter::Filter;
use super::param::{Param, Values};
use super::report::{VERTEX, distances};
use super::signatures::{TO_MESH_TEXT, TWO_MESHES};
use super::smooth::{self, CATEGORY, REFERENCE, SCHEME};
use gusset_base::alloc;
use gusset_base::error::Element;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::PositionBuffer;

pub(super) const FILTER: Filter = Filter {
    id: "smooth_distance",
    name: "Distance from a smooth surface",
    category: CATEGORY,
    help: "Measures the distances of the vertices of a mesh from the smooth surface through the vertices of a quad grid, the second \
           mesh, and moves them towards their nearest points on it.",
    reference: REFERENCE,
    replaces: true,
    has_origins: true,
    params: &[
        SCHEME,
        Param::real("strength", "Strength", [0.0, 1.0], &[1.0])
            .with_help("The fraction of the way that vertices are moved: 0 leaves them, 1 puts them on the surface."),
    ],
    ..Filter::new(TWO_MESHES, TO_MESH_TEXT, run)
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let mesh = inputs[0].mesh()?;
    let surface = smooth::surface(inputs[1].mesh()?, values, &job.part(0.0, 0.3))?;
    let positions = mesh.positions();
    let from = alloc::collect((0..positions.len()).map(|v| positions.get(v as u32)))?;
    let nearest = smooth::nearest(&surface, &from, Element::Vertex, &job.part(0.3, 1.0))?;
    let strength = values.number("strength");
    job.step(1.0, "moving vertices")?;
    let mut moved = PositionBuffer::with_capacity(positions.scalar(), positions.len())?;
    moved.extend(from.iter().zip(&nearest).map(|(from, to)| from.lerp(to.point, strength)))?;
    job.step(1.0, "moving vertices")?;
    let report = distances(VERTEX, from.iter().zip(&nearest).map(|(from, to)| from.distance(to.point)));
    job.step(1.0, "moving vertices")?;
    let moved = moved_output(with_positions(mesh, moved)?, inputs, values, job)?;
    Ok(vec![moved, Output::Text(report)])
}
