//! The imports of every filter.

pub(super) use super::data::{Curves, Input, InputKind, Output, OutputKind};
pub(super) use super::extent::extent_of;
pub(super) use super::filter::{Defaults, Filter};
pub(super) use super::param::{COORDINATES, LENGTHS, NON_NEGATIVE, Param, ParamKind, Values};
pub(super) use super::report::{Report, counted, push_line, push_more, short, short_point};
pub(super) use crate::error::{Error, Result};
pub(super) use crate::job::Job;
pub(super) use glam::DVec3;
pub(super) use gusset_base::alloc;
pub(super) use gusset_base::choice::Choice;
pub(super) use gusset_base::choices;

/// One mesh.
pub(super) const MESH: &[InputKind] = &[InputKind::Mesh];
/// Two meshes.
pub(super) const TWO_MESHES: &[InputKind] = &[InputKind::Mesh; 2];
/// One input of curves.
pub(super) const CURVES: &[InputKind] = &[InputKind::Curves];
/// A mesh as output.
pub(super) const TO_MESH: &[OutputKind] = &[OutputKind::Mesh];
/// A mesh and a report as output.
pub(super) const TO_MESH_TEXT: &[OutputKind] = &[OutputKind::Mesh, OutputKind::Text];
/// Curves and a report as output.
pub(super) const TO_CURVES_TEXT: &[OutputKind] = &[OutputKind::Curves, OutputKind::Text];
/// A report as output.
pub(super) const TO_TEXT: &[OutputKind] = &[OutputKind::Text];
