use super::data::{Input, Output, mesh_with_positions};
use super::filter::{Filter, FilterBody};
use super::moving::{STRENGTH, output_of_moved_mesh};
use super::report::{VERTEX, distance_report};
use super::signatures::{TO_MESH_TEXT, TWO_MESHES};
use super::smooth::{self, CATEGORY, REFERENCE, SCHEME};
use super::typed_param::{ParamValues, params};
use gusset_base::alloc;
use gusset_base::error::{Element, Result};
use gusset_base::job::Job;
use gusset_mesh::PositionBuffer;
use gusset_surface::Scheme;

pub(super) const FILTER: Filter = Filter {
    id: "smooth_distance",
    name: "Distance from a smooth surface",
    category: CATEGORY,
    help: "Measures the distances of the vertices of a mesh from a smooth surface, and moves them towards their nearest points \
           on it. The surface passes through the vertices of a quad grid, the second mesh.",
    reference: REFERENCE,
    replaces: true,
    has_origins: true,
    ..Filter::new(TWO_MESHES, TO_MESH_TEXT, &FilterBody(run))
};

params! {
    scheme: Scheme = SCHEME;
    strength: f64 = STRENGTH;
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let mesh = inputs[0].mesh()?;
    let surface = smooth::surface_through_mesh(inputs[1].mesh()?, values.scheme, &job.sub_job(0.0, 0.3))?;
    let positions = mesh.positions();
    let from = alloc::collect((0..positions.len()).map(|v| positions.get(v as u32)))?;
    let nearest = smooth::nearest_surface_points(&surface, &from, Element::Vertex, &job.sub_job(0.3, 1.0))?;
    job.step(1.0, "moving vertices")?;
    let mut moved = PositionBuffer::with_capacity(positions.scalar(), positions.len())?;
    moved.extend(from.iter().zip(&nearest).map(|(from, to)| from.lerp(to.point, values.strength)))?;
    job.step(1.0, "moving vertices")?;
    let report = distance_report(VERTEX, from.iter().zip(&nearest).map(|(from, to)| from.distance(to.point)));
    job.step(1.0, "moving vertices")?;
    let moved = output_of_moved_mesh(mesh_with_positions(mesh, moved)?, inputs, values, job)?;
    Ok(vec![moved, Output::Text(report)])
}
