//! Curves: Curves of Bezier segments, and places on them.
//!
//! @source Textbook properties of Bezier curves: Bernstein bases, de Casteljau, hodographs.

pub mod outline;
pub mod outline_options;
pub mod measure;
pub mod intersect;
pub mod construct;
pub mod export;
pub mod frame;

use crate::capi::context::{create_handle, gusset_context, lend};
use crate::capi::glue::{fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, lend_list, read_flag};
use crate::capi::mesh::gusset_indices;
use crate::capi::status::gusset_status::GUSSET_ERROR_BAD_OFFSETS;
use crate::capi::status::{Failure, gusset_status};
use crate::curve::{Curve, CurveView, Place, Points};
use glam::DVec3;
use gusset_base::alloc;
use std::ffi::c_void;

/// A curve of Bézier segments.
pub struct gusset_curve(pub(crate) Curve);

handle! { gusset_curve }

/// A place on a curve.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_place {
    /// Index of the segment.
    pub segment: u32,
    /// 0.
    pub reserved: u32,
    /// Parameter, from 0 at the segment's start to 1 at its end.
    pub t: f64,
}

/// Lent arrays of a curve.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_curve_view {
    /// sizeof(gusset_curve_view).
    pub struct_size: usize,
    /// Control points; z is 0 for a plane curve.
    /// @shape control_count 3
    pub controls: *const f64,
    /// Number of control points.
    pub control_count: usize,
    /// Segment k has the controls ends[k] to ends[k + 1].
    pub ends: gusset_indices,
    /// 1 if closed.
    /// @flag
    pub closed: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_curve_view: 48 }
fixed! { gusset_place: 16 }
// Points are lent as x, y, z.
const _: () = assert!(size_of::<DVec3>() == 24 && align_of::<DVec3>() == align_of::<f64>());

impl From<Place> for gusset_place {
    fn from(place: Place) -> Self {
        gusset_place { segment: place.segment, reserved: 0, t: place.t }
    }
}

impl gusset_place {
    pub(crate) fn checked(self) -> Result<Place, Failure> {
        match self.reserved {
            0 => Ok(Place { segment: self.segment, t: self.t }),
            other => Err(Failure::not_zero("reserved", other.into())),
        }
    }
}

/// Reads the caller's places, at any alignment.
pub(crate) fn read_places(data: *const gusset_place, count: usize, name: &'static str) -> Result<Vec<Place>, Failure> {
    alloc::try_collect(input::input_items(data, count, name)?.map(gusset_place::checked))
}

/// Reads the caller's packed points: x, y, z of each.
pub(crate) fn read_points(data: *const f64, count: usize, dimension: usize) -> Result<Vec<DVec3>, Failure> {
    read_named_points(data, (count, dimension), "points")
}

/// Reads the caller's packed points of a given dimension.
fn read_named_points(
    data: *const f64,
    (count, dimension): (usize, usize),
    name: &'static str,
) -> Result<Vec<DVec3>, Failure> {
    let needed = Points::bytes_needed(0, count, dimension)?;
    let bytes = input::input_bytes(data.cast::<c_void>(), needed, 1, name)?;
    let points = Points::strided(bytes, 0, count, dimension)?;
    Ok(alloc::collect((0..count).map(|i| points.get(i)))?)
}

/// Returns a view of the caller's curve.
pub(crate) fn view_of_curve<'a>(curve: *const gusset_curve, name: &'static str) -> Result<CurveView<'a>, Failure> {
    Ok(handle::get_object(curve, name)?.0.view())
}

/// Writes points as x, y, z.
pub(crate) fn write_points(points: &[DVec3], out: &mut [f64]) {
    out.chunks_exact_mut(3).zip(points).for_each(|(to, p)| to.copy_from_slice(&p.to_array()));
}

/// Makes a curve from its control points.
///
/// Degrees are 1 to 64.
///
/// @param controls x, y or x, y, z of each.
/// @param control_count at most 2^30; 0: no segments, and ends is {0}.
/// @param dimension 2 or 3.
/// @param ends 0, then the rising index of each segment's last control point, up to control_count -
///     1.
/// @param end_count segments + 1.
/// @param closed 1: the last control point repeats the first.
/// @errors BAD_OFFSETS, OUT_OF_RANGE (dimension, degree), NOT_FINITE, CURVE_NOT_CLOSED, TOO_LARGE
/// @complexity O(points).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_create(
    context: *const gusset_context,
    controls: *const f64,
    control_count: usize,
    dimension: u32,
    ends: *const u32,
    end_count: usize,
    closed: u32,
    curve: *mut *mut gusset_curve,
) -> gusset_status {
    create_handle(context, curve, "curve", |job| {
        let controls = read_named_points(controls, (control_count, dimension as usize), "controls")?;
        if end_count == 0 || end_count > control_count.max(1) {
            let message =
                format!("end_count is {end_count}; {control_count} control points need 1 to {control_count} ends");
            return Err(Failure { value: end_count as f64, ..Failure::new(GUSSET_ERROR_BAD_OFFSETS, message) });
        }
        let ends = input::copy_input_items(ends, end_count, "ends")?;
        Ok(gusset_curve(CurveView::new(&controls, &ends, read_flag(closed, "closed")?)?.to_owned_cancellable(job)?))
    })
}

/// Frees a curve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_curve_destroy(curve: *mut gusset_curve) {
    handle::destroy(curve);
}

/// Lends the control points.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_get_view(
    curve: *const gusset_curve,
    view: *mut gusset_curve_view,
) -> gusset_status {
    lend!(curve, view, |curve| {
        let view = curve.0.view();
        gusset_curve_view {
            struct_size: size_of::<gusset_curve_view>(),
            controls: lend_list(view.points()).cast(),
            control_count: view.points().len(),
            ends: gusset_indices::lend_indices(view.ends()),
            closed: view.is_closed().into(),
            reserved: 0,
        }
    })
}
