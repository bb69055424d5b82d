//! Common parts of filters of quad grids: the net of a mesh of quads in rows and columns, and back.

use super::data::Output;
use super::typed_param::{Param, ParamValues, Parameters, TypedParam};
use gusset_attributes::Origins;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::{Mesh, MeshView};
use gusset_net::Net;
use gusset_net::convert::{Diagonal, MeshOptions, NetMesh, RecognisedNet, net_of_grid};

pub(super) const CATEGORY: &str = "Quad grids";
pub(super) const REFERENCE: &str = "A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks";

/// Cuts quads into triangles.
pub(super) const TRIANGLES: TypedParam<bool> = Param::flag("Triangles", "Cuts quads along their shorter diagonals.");

/// The net whose cells are the faces of a mesh.
///
/// # Errors
/// The errors of [`net_of_grid`].
pub(super) fn recognise_net(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Net<'static>> {
    recognise_grid(mesh, job).map(|found| found.net)
}

/// The net whose cells are the faces of a mesh. It tells the vertex of each node and the face of each
/// cell.
///
/// # Errors
/// The errors of [`net_of_grid`].
pub(super) fn recognise_grid(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<RecognisedNet> {
    net_of_grid(mesh, None, job)
}

/// The mesh of a net, of triangles on request.
///
/// # Errors
/// The errors of [`Net::to_mesh`].
pub(super) fn mesh_of_net(net: &Net<'_>, triangles: bool, job: &Job<'_>) -> Result<Mesh> {
    net_mesh(net, triangles, job).map(|made| made.mesh)
}

/// The mesh of a net, and the nodes and cells that its vertices and faces are.
///
/// # Errors
/// The errors of [`Net::to_mesh`].
fn net_mesh(net: &Net<'_>, triangles: bool, job: &Job<'_>) -> Result<NetMesh> {
    let triangles = triangles.then_some(Diagonal::Shorter);
    net.to_mesh(&MeshOptions { triangles, ..MeshOptions::default() }, job)
}

/// The mesh of a net that has some rows and columns of a grid, as an output. The flag asks for
/// triangles.
///
/// # Errors
/// The errors of [`Net::to_mesh`].
pub(super) fn output_of_resampled_grid<P: Parameters>(
    net: &Net<'_>,
    (input, grid): (&MeshView<'_>, &RecognisedNet),
    lines: [&[usize]; 2],
    (values, triangles): (&ParamValues<P>, bool),
    job: &Job<'_>,
) -> Result<Output> {
    let made = net_mesh(net, triangles, &job.sub_job(0.0, 0.5))?;
    let origins =
        values.trace_origins(|| Origins::from_grid_mesh(input, grid, lines, &made, &job.sub_job(0.5, 1.0)))?;
    Ok(Output::Mesh(made.mesh, origins))
}
