//! What filters of nets have in common: the net that a mesh of quads in rows and columns is, and
//! the mesh of a net.

use super::param::{Param, Values};
use crate::error::Result;
use crate::job::Job;
use crate::mesh::{Mesh, MeshView};
use crate::net::Net;
use crate::net::convert::{Diagonal, MeshOptions, net_of_grid};

pub(super) const CATEGORY: &str = "Nets";
pub(super) const REFERENCE: &str = "A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks";

/// Whether quads are cut.
pub(super) const TRIANGLES: Param =
    Param::flag("triangles", "Triangles", "Quads are cut along their shorter diagonals.");

/// The net whose cells are the faces of a mesh.
///
/// # Errors
/// Those of [`net_of_grid`].
pub(super) fn net(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Net<'static>> {
    net_of_grid(mesh, None, job).map(|found| found.net)
}

/// The mesh of a net, of triangles if [`TRIANGLES`] says so.
///
/// # Errors
/// Those of [`Net::to_mesh`].
pub(super) fn mesh(net: &Net<'_>, values: &Values<'_>, job: &Job<'_>) -> Result<Mesh> {
    let triangles = values.is_set(TRIANGLES.id).then_some(Diagonal::Shorter);
    Ok(net.to_mesh(&MeshOptions { triangles, ..MeshOptions::default() }, job)?.mesh)
}
