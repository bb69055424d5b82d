//! What a host gives: meshes, curves, values, callbacks.

use super::descriptor::{
    GUSSET_PLUGIN_F32, GUSSET_PLUGIN_F64, gusset_host, gusset_input, gusset_plugin_curves, gusset_plugin_mesh,
};
use super::run::Fault;
use crate::alloc;
use crate::error::{Element, Error};
use crate::ffi::input::{self, choice};
use crate::ffi::mesh::{GUSSET_F32, GUSSET_F64, gusset_mesh_view};
use crate::ffi::status::Failure;
use crate::filters::Filter;
use crate::filters::data::{Curves, Input, InputKind};
use crate::job::{Job, Progress};
use crate::mesh::{MAX_ELEMENTS, MeshView, Positions};
use std::cell::Cell;
use std::ffi::CString;
use std::ops::ControlFlow;

// The plugin's numbers are the library's.
const _: () = assert!(GUSSET_PLUGIN_F32 == GUSSET_F32 && GUSSET_PLUGIN_F64 == GUSSET_F64);

/// An input with what it needs to own: meshes stay in the host's memory, curves are small and
/// copied.
pub(super) enum Given<'a> {
    Mesh(MeshView<'a>),
    Curves(Curves),
}

impl Given<'_> {
    pub(super) fn lend(&self) -> Input<'_> {
        match self {
            Given::Mesh(mesh) => Input::Mesh(*mesh),
            Given::Curves(curves) => Input::Curves(curves),
        }
    }
}

/// All inputs of a call, held to the rules and to what the filter takes: their number before any is
/// read, and each one's kind before its arrays are.
pub(super) fn inputs<'a>(
    filter: &Filter,
    given: *const gusset_input,
    count: u32,
    job: &Job<'_>,
) -> Result<Vec<Given<'a>>, Fault> {
    filter.check_input_count(count as usize)?;
    if count == 0 {
        return Ok(Vec::new());
    }
    let size = input::struct_size(given, "inputs")?;
    input::bytes(given.cast(), count as usize, size, "inputs")?;
    let mut all = alloc::with_capacity(count as usize)?;
    for k in 0..count {
        let part = job.share(k as usize, count as usize);
        let at = given.wrapping_byte_add(k as usize * size);
        all.push(read(filter, at, k, &part).map_err(|fault| fault.of_input(k))?);
    }
    Ok(all)
}

fn read<'a>(filter: &Filter, given: *const gusset_input, place: u32, job: &Job<'_>) -> Result<Given<'a>, Fault> {
    let given = input::read(given, false, "inputs")?;
    let kind = choice(given.kind)?;
    filter.check_input_kind(place as usize, kind)?;
    Ok(match kind {
        InputKind::Mesh => mesh(given.view.cast(), job).map(Given::Mesh)?,
        InputKind::Curves => curves(given.view.cast(), job).map(Given::Curves)?,
    })
}

fn mesh<'a>(view: *const gusset_plugin_mesh, job: &Job<'_>) -> Result<MeshView<'a>, Failure> {
    let view = input::read(view, false, "view")?;
    let same = gusset_mesh_view {
        struct_size: size_of::<gusset_mesh_view>(),
        positions: view.positions,
        position_stride: view.position_stride,
        vertex_count: view.vertex_count,
        face_offsets: view.face_offsets,
        face_corners: view.face_corners,
        face_count: view.face_count,
        scalar: view.scalar,
        index: view.index,
        face_size: view.face_size,
        reserved: view.reserved,
    };
    crate::ffi::mesh::mesh(&raw const same, 0, job)
}

fn curves(view: *const gusset_plugin_curves, job: &Job<'_>) -> Result<Curves, Failure> {
    let view = input::read(view, false, "view")?;
    let scalar = choice(view.scalar)?;
    for (what, count) in [("points", view.point_count), ("curves", view.curve_count)] {
        if count as u64 > MAX_ELEMENTS {
            return Err(Error::TooLarge { what, count: count as u64, limit: MAX_ELEMENTS }.into());
        }
    }
    let size = Positions::bytes_needed(view.point_stride, view.point_count, scalar)?;
    let points = input::bytes(view.points, size, 1, "points")?;
    let points = Positions::strided(points, view.point_stride, view.point_count, scalar)?;
    let mut found = Curves {
        points: alloc::with_capacity(view.point_count)?,
        offsets: vec![0],
        closed: alloc::filled(false, view.curve_count)?,
    };
    for p in 0..view.point_count {
        if p % (1 << 16) == 0 {
            job.step(p as f64 / view.point_count as f64, "reading curves")?;
        }
        let point = points.get(p as u32).to_array();
        if let Some(&value) = point.iter().find(|coordinate| !coordinate.is_finite()) {
            return Err(Error::NotFinite { element: Element::Point, index: p as u64, value }.into());
        }
        found.points.push(point);
    }
    if view.curve_count > 0 {
        found.offsets = input::list(view.offsets.cast(), view.curve_count + 1, "offsets")?;
        if !view.closed.is_null() {
            let closed = input::bytes(view.closed.cast(), view.curve_count, 1, "closed")?;
            if let Some(&other) = closed.iter().find(|&&byte| byte > 1) {
                return Err(Failure::unknown("closed", other.into()));
            }
            found.closed = alloc::collect(closed.iter().map(|&byte| byte == 1))?;
        }
    }
    found.check()?;
    Ok(found)
}

/// The host's values, copied as they may have any alignment; no more of them are read than the
/// filter has.
pub(super) fn values(filter: &Filter, given: *const f64, count: u32) -> Result<Vec<f64>, Failure> {
    filter.check_value_count(count as usize)?;
    input::list(given, count as usize, "values")
}

/// The host's callbacks, as the core calls them.
pub(super) struct Host {
    host: gusset_host,
    /// The greatest part that was reported.
    done: Cell<f64>,
    /// The callback asked to stop: the run is over, whatever it does next.
    stopped: Cell<bool>,
}

impl Host {
    pub(super) fn new(host: *const gusset_host) -> Result<Self, Failure> {
        let host = input::read(host, true, "host")?;
        Ok(Host { host, done: Cell::new(0.0), stopped: Cell::new(false) })
    }

    pub(super) fn job(&self) -> Job<'_> {
        Job::new(self.host.threads as usize, self)
    }
}

impl Progress for Host {
    fn step(&self, fraction: f64, stage: &'static str) -> ControlFlow<()> {
        if let Some(callback) = self.host.progress
            && !self.stopped.get()
        {
            let stage = CString::new(stage).unwrap_or_default();
            let fraction = fraction.max(self.done.get());
            self.done.set(fraction);
            // SAFETY: the host gave this function for this purpose, and the text lives through the
            // call.
            let answer = unsafe { callback(self.host.user, fraction, stage.as_ptr()) };
            self.stopped.set(answer != 0);
        }
        if self.stopped.get() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    fn note(&self, message: &str) {
        if let Some(callback) = self.host.log {
            let message = CString::new(message).unwrap_or_default();
            // SAFETY: as above.
            unsafe { callback(self.host.user, message.as_ptr()) };
        }
    }
}
