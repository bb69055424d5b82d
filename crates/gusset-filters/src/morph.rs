use super::data::{Input, Output, mesh_with_positions, require_same_faces};
use super::filter::{Filter, FilterBody};
use super::moving::{CATEGORY, output_of_moved_mesh};
use super::signatures::{TO_MESH, TWO_MESHES};
use super::typed_param::{Param, ParamValues, params};
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::{MeshView, PositionBuffer, Scalar};
use gusset_net::{MorphPath, Net, Shape, Sides, Topology};

pub(super) const FILTER: Filter = Filter {
    id: "morph",
    name: "Morph",
    category: CATEGORY,
    help: "Interpolates between two meshes with the same faces, such as a mesh and a deformed copy of it. Vertices correspond \
           by their numbers. Faces and attributes come from the first mesh.",
    reference: "A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks, animation transformations; \
                B. K. P. Horn (1987) for the rotation",
    has_origins: true,
    ..Filter::new(TWO_MESHES, TO_MESH, &FilterBody(run))
};

params! {
    ratio: f64 = Param::real(
        "Ratio",
        "The fraction of the way: 0 gives the first mesh, 1 gives the second.",
        [0.0, 1.0], &[0.5],
    );
    path: MorphPath = Param::choice("Path", "The path of the vertices.", MorphPath::CHOICES);
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let (from, to) = (inputs[0].mesh()?, inputs[1].mesh()?);
    job.step(0.0, "looking for the same faces")?;
    require_same_faces(from, to, 1)?;
    let scalars = [from, to].map(|mesh| mesh.positions().scalar());
    let scalar = if scalars.contains(&Scalar::F64) { Scalar::F64 } else { Scalar::F32 };
    let (a, b) =
        (net_of_vertices(from, scalar, &job.sub_job(0.1, 0.2))?, net_of_vertices(to, scalar, &job.sub_job(0.2, 0.3))?);
    let between = gusset_net::morph(&a, &b, values.ratio, values.path, &job.sub_job(0.3, 0.9))?;
    job.step(0.9, "nodes to vertices")?;
    let mut positions = PositionBuffer::with_capacity(scalar, from.positions().len())?;
    let places = (0..from.positions().len() as u32).map(|v| between.shape().row_and_column(v));
    positions.extend(places.map(|(i, j)| between.get(i, j)))?;
    Ok(vec![output_of_moved_mesh(mesh_with_positions(from, positions)?, inputs, values, job)?])
}

/// The vertices of a mesh in order, as the nodes of a net of two rows. An odd number of vertices
/// leaves nodes at the end, which are missing.
fn net_of_vertices(mesh: &MeshView<'_>, scalar: Scalar, job: &Job<'_>) -> Result<Net<'static>> {
    job.step(0.0, "vertices to nodes")?;
    let positions = mesh.positions();
    let shape = Shape::new(2, positions.len().div_ceil(2).max(2))?;
    let position = |i: usize, j: usize| match shape.node(i, j) {
        v if (v as usize) < positions.len() => positions.get(v),
        _ => DVec3::NAN,
    };
    Net::from_fn(Topology::from_sides(shape, Sides::default()), scalar, position)
}
