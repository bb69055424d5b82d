//! Memory, errors, jobs, threads, vectors and boxes: the imports of files of surfaces.

pub(super) use crate::alloc;
pub(super) use crate::error::{Element, Error, Result};
pub(super) use crate::geom::Aabb;
pub(super) use crate::job::Job;
pub(super) use crate::par;
pub(super) use glam::{DVec2, DVec3};
