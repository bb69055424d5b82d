//! Common parts of filters that move the vertices of a mesh and keep its faces.

use super::data::{Input, Output, mesh_with_positions};
use super::typed_param::{Param, ParamValues, Parameters, TypedParam};
use gusset_attributes::Origins;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_mesh::{Mesh, MeshView, PositionBuffer};
use gusset_net::field::Field;

pub(super) const CATEGORY: &str = "Deformation";

/// Vertices that are moved at a time.
const VERTICES_PER_CHUNK: usize = 1024;

/// Chunks between two progress reports.
const CHUNKS_PER_REPORT: usize = 64;

/// Sets the fraction of a motion that is carried out.
pub(super) const STRENGTH: TypedParam<f64> = Param::real(
    "Strength",
    "The fraction of the motion: 0 leaves the vertices unchanged, 1 moves them all the way.",
    [0.0, 1.0],
    &[1.0],
);

/// A mesh moved by a field.
///
/// # Errors
/// [`Error::FieldUndefined`], [`Error::OutOfMemory`], [`Error::Cancelled`].
pub(super) fn move_mesh(mesh: &MeshView<'_>, field: &dyn Field, strength: f64, job: &Job<'_>) -> Result<Mesh> {
    let mut moved = copy_mesh(mesh, &job.sub_job(0.0, 0.2))?;
    // At strength 0 the domain of the field does not matter.
    if strength > 0.0 {
        let job = job.sub_job(0.2, 1.0);
        match &mut moved.positions {
            PositionBuffer::F32(points) => move_points(field, strength, points, |x| x as f32, &job)?,
            PositionBuffer::F64(points) => move_points(field, strength, points, |x| x, &job)?,
        }
    }
    Ok(moved)
}

/// A copy of a mesh.
pub(super) fn copy_mesh(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Mesh> {
    job.step(0.0, "copying the mesh")?;
    let positions = mesh.positions();
    let mut buffer = PositionBuffer::with_capacity(positions.scalar(), positions.len())?;
    buffer.append(positions, 0..positions.len())?;
    mesh_with_positions(mesh, buffer)
}

/// Moves points, a chunk at a time. [`Error::FieldUndefined`] names the first point that has no
/// image.
fn move_points<T: Copy + Into<f64>>(
    field: &dyn Field,
    strength: f64,
    points: &mut [[T; 3]],
    round: impl Fn(f64) -> T,
    job: &Job<'_>,
) -> Result<()> {
    let mut scratch = [[0.0; VERTICES_PER_CHUNK]; 3];
    let chunks = points.len().div_ceil(VERTICES_PER_CHUNK);
    for (number, chunk) in points.chunks_mut(VERTICES_PER_CHUNK).enumerate() {
        job.step_every(CHUNKS_PER_REPORT, number, chunks, "moving vertices")?;
        let count = chunk.len();
        for (k, point) in chunk.iter().enumerate() {
            (0..3).for_each(|axis| scratch[axis][k] = point[axis].into());
        }
        let [x, y, z] = &mut scratch;
        field.map_points(strength, [&mut x[..count], &mut y[..count], &mut z[..count]]);
        for (k, point) in chunk.iter_mut().enumerate() {
            let moved = [0, 1, 2].map(|axis| scratch[axis][k]);
            let was_finite = point.iter().all(|&x| x.into().is_finite());
            if was_finite && !moved.iter().all(|x| x.is_finite()) {
                return Err(Error::FieldUndefined { node: (number * VERTICES_PER_CHUNK + k) as u32 });
            }
            *point = moved.map(&round);
        }
    }
    Ok(())
}

/// A mesh with the faces of the first input, as an output.
pub(super) fn output_of_moved_mesh<P: Parameters>(
    mesh: Mesh,
    inputs: &[Input<'_>],
    values: &ParamValues<P>,
    job: &Job<'_>,
) -> Result<Output> {
    let origins = values.trace_origins(|| {
        let meshes = alloc::try_collect(inputs.iter().map(|input| input.mesh().copied()))?;
        Origins::from_moved(&meshes, &job.sub_job(1.0, 1.0))
    })?;
    Ok(Output::Mesh(mesh, origins))
}
