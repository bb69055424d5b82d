//! Memory, errors, jobs, threads and vectors, which nearly every file of surfaces uses.

pub(super) use crate::alloc;
pub(super) use crate::error::{Element, Error, Result};
pub(super) use crate::job::Job;
pub(super) use crate::par;
pub(super) use glam::{DVec2, DVec3};
