//! Memory, errors, jobs, threads, vectors and boxes: the imports of files of surfaces.

pub(super) use glam::{DVec2, DVec3};
pub(super) use gusset_base::alloc;
pub(super) use gusset_base::error::{Element, Error, Result};
pub(super) use gusset_base::geom::Aabb;
pub(super) use gusset_base::job::Job;
pub(super) use gusset_base::par;
