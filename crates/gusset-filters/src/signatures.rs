//! The inputs and outputs that several filters have in common.

use super::data::{InputKind, OutputKind};

/// One mesh.
pub(super) const ONE_MESH: &[InputKind] = &[InputKind::Mesh];
/// Two meshes.
pub(super) const TWO_MESHES: &[InputKind] = &[InputKind::Mesh; 2];
/// One input of curves.
pub(super) const CURVES_ONLY: &[InputKind] = &[InputKind::Curves];
/// A mesh as output.
pub(super) const TO_MESH: &[OutputKind] = &[OutputKind::Mesh];
/// A mesh and a report as output.
pub(super) const TO_MESH_TEXT: &[OutputKind] = &[OutputKind::Mesh, OutputKind::Text];
/// Curves and a report as output.
pub(super) const TO_CURVES_TEXT: &[OutputKind] = &[OutputKind::Curves, OutputKind::Text];
/// A report as output.
pub(super) const TO_TEXT: &[OutputKind] = &[OutputKind::Text];
