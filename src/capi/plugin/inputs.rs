//! The inputs of a host: meshes, curves, values, callbacks.

use super::descriptor::{
    GUSSET_PLUGIN_F32, GUSSET_PLUGIN_F64, gusset_host, gusset_input, gusset_plugin_curves, gusset_plugin_mesh,
};
use super::outcome::RunFault;
use crate::capi::glue::laid_out_like;
use crate::capi::host::HostCallbacks;
use crate::capi::input::{self, read_choice};
use crate::capi::mesh::{self, GUSSET_F32, GUSSET_F64, GivenMesh, gusset_mesh_view};
use crate::capi::status::Failure;
use crate::error::{Element, Error};
use crate::filters::Filter;
use crate::filters::data::{Curves, Input, InputKind};
use crate::job::Job;
use crate::mesh::{MAX_ELEMENTS, Positions};
use gusset_base::alloc;

// The plugin's constants equal the library's, and so does its view of a mesh.
const _: () = assert!(GUSSET_PLUGIN_F32 == GUSSET_F32 && GUSSET_PLUGIN_F64 == GUSSET_F64);
laid_out_like! {
    gusset_plugin_mesh: gusset_mesh_view {
        struct_size, positions, position_stride, vertex_count, face_offsets, face_corners, face_count, scalar, index,
        face_size, reserved, merge,
    }
}

/// An input with its owned data. Meshes stay in the host's memory; curves are small and copied.
pub(super) enum GivenInput<'a> {
    Mesh(GivenMesh<'a>),
    Curves(Curves),
}

impl GivenInput<'_> {
    pub(super) fn as_filter_input(&self) -> Input<'_> {
        match self {
            GivenInput::Mesh(mesh) => Input::Mesh(mesh.mesh_view()),
            GivenInput::Curves(curves) => Input::Curves(curves),
        }
    }
}

/// Reads and validates all inputs of a call. It checks their number before reading any, and each
/// input's kind before its arrays.
pub(super) fn read_inputs<'a>(
    filter: &Filter,
    given: *const gusset_input,
    count: u32,
    job: &Job<'_>,
) -> Result<Vec<GivenInput<'a>>, RunFault> {
    filter.check_input_count(count as usize)?;
    let given = input::struct_pointers(given, count as usize, "inputs")?;
    alloc::try_collect(given.enumerate().map(|(k, one)| {
        let part = job.sub_job_of_item(k, count as usize);
        one.map_err(RunFault::from)
            .and_then(|one| read_input(filter, one, k, &part))
            .map_err(|fault| fault.with_input(k as u32))
    }))
}

fn read_input<'a>(
    filter: &Filter,
    given: *const gusset_input,
    place: usize,
    job: &Job<'_>,
) -> Result<GivenInput<'a>, RunFault> {
    let given = input::read_versioned_struct(given, false, "inputs")?;
    let kind = read_choice(given.kind)?;
    filter.check_input_kind(place, kind)?;
    Ok(match kind {
        InputKind::Mesh => GivenInput::Mesh(mesh::read_and_validate_mesh(given.view.cast(), "view", job)?),
        InputKind::Curves => GivenInput::Curves(read_curves(given.view.cast(), job)?),
    })
}

fn read_curves(view: *const gusset_plugin_curves, job: &Job<'_>) -> Result<Curves, Failure> {
    let view = input::read_versioned_struct(view, false, "view")?;
    let scalar = read_choice(view.scalar)?;
    Error::check_count("points", view.point_count as u64, MAX_ELEMENTS)?;
    Error::check_count("curves", view.curve_count as u64, MAX_ELEMENTS)?;
    let size = Positions::bytes_needed(view.point_stride, view.point_count, scalar)?;
    let points = input::input_bytes(view.points, size, 1, "points")?;
    let points = Positions::strided(points, view.point_stride, view.point_count, scalar)?;
    let mut found = Curves {
        points: alloc::with_capacity(view.point_count)?,
        offsets: vec![0],
        closed: alloc::filled(false, view.curve_count)?,
    };
    for p in 0..view.point_count {
        job.step_every(1 << 16, p, view.point_count, "reading curves")?;
        let point = points.get(p as u32);
        Error::check_finite(Element::Point, p as u64, point)?;
        found.points.push(point.to_array());
    }
    if view.curve_count > 0 {
        found.offsets = input::copy_input_items(view.offsets.cast(), view.curve_count + 1, "offsets")?;
        if !view.closed.is_null() {
            let closed = input::input_bytes(view.closed.cast(), view.curve_count, 1, "closed")?;
            if let Some(&other) = closed.iter().find(|&&byte| byte > 1) {
                return Err(Failure::unknown_value("closed", other.into(), "0 or 1"));
            }
            found.closed = alloc::collect(closed.iter().map(|&byte| byte == 1))?;
        }
    }
    found.check()?;
    Ok(found)
}

/// Returns true if the host requests the origins of the outputs' elements.
pub(super) fn wants_origins(host: *const gusset_host) -> Result<bool, Failure> {
    match input::read_versioned_struct(host, true, "host")?.origins {
        0 => Ok(false),
        1 => Ok(true),
        other => Err(Failure::unknown_value("origins", other.into(), "0 or 1")),
    }
}

/// Returns the host's number of threads, and its callbacks.
pub(super) fn read_host(host: *const gusset_host) -> Result<(usize, HostCallbacks), Failure> {
    let gusset_host { user, progress, log, threads, .. } = input::read_versioned_struct(host, true, "host")?;
    Ok((threads as usize, HostCallbacks { progress, progress_user: user, log, log_user: user }))
}
