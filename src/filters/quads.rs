//! Common parts of filters of quad grids: the net of a mesh of quads in rows and columns, and back.

use super::prelude::*;
use crate::mesh::{Mesh, MeshView};
use crate::net::Net;
use crate::net::convert::{Diagonal, MeshOptions, net_of_grid};

pub(super) const CATEGORY: &str = "Quad grids";
pub(super) const REFERENCE: &str = "A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks";

/// Cuts quads into triangles.
pub(super) const TRIANGLES: Param =
    Param::flag("triangles", "Triangles").with_help("Cuts quads along their shorter diagonals.");

/// The net whose cells are the faces of a mesh.
///
/// # Errors
/// Those of [`net_of_grid`].
pub(super) fn net(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Net<'static>> {
    net_of_grid(mesh, None, job).map(|found| found.net)
}

/// The mesh of a net, of triangles if [`TRIANGLES`] is set.
///
/// # Errors
/// Those of [`Net::to_mesh`].
pub(super) fn mesh(net: &Net<'_>, values: &Values<'_>, job: &Job<'_>) -> Result<Mesh> {
    let triangles = values.is_set(TRIANGLES.id).then_some(Diagonal::Shorter);
    Ok(net.to_mesh(&MeshOptions { triangles, ..MeshOptions::default() }, job)?.mesh)
}
