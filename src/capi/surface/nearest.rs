//! Nearest points: Nearest points and local minima of the distance.

use crate::capi::context::{create_handle, guard_changing_call, gusset_context, lend};
use crate::capi::glue::{fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, lend_list};
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::{gusset_surface, gusset_surface_place, surface_of_handle};
use crate::error::Error;
use crate::surface::{Closest, Minima};
use glam::DVec3;
use gusset_base::alloc;

/// Properties of a nearest point.
/// @bits
pub type gusset_nearest_flags = u32;
/// A point was found. Else none is within the limit; distance and bound are infinite, the rest 0.
pub const GUSSET_NEAREST_FOUND: gusset_nearest_flags = 1;
/// `bound` is within the tolerance of the distance, or rounding. Else the proof takes too long, as
/// near centres of curvature; `bound` holds.
pub const GUSSET_NEAREST_PROVEN: gusset_nearest_flags = 2;
/// A point farther away than 1/100 of the distance is equally near within the tolerance.
pub const GUSSET_NEAREST_AMBIGUOUS: gusset_nearest_flags = 4;

/// A surface point near a query.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_surface_nearest_point {
    /// Place on the surface.
    pub place: gusset_surface_place,
    /// x, y, z.
    pub point: [f64; 3],
    /// Unit normal; at a pole its limit; 0 if undefined. The query is on its side if (query -
    /// point) . normal > 0.
    pub normal: [f64; 3],
    /// Distance from the query.
    pub distance: f64,
    /// Lower bound of the distance from the surface (minima: from the piece round the point).
    pub bound: f64,
    /// Properties of a nearest point.
    pub flags: gusset_nearest_flags,
    /// 0.
    pub reserved: u32,
}

/// Limits of a search for near points.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct gusset_nearest_options {
    /// sizeof(gusset_nearest_options).
    pub struct_size: usize,
    /// Largest distance; 0 or INFINITY: no limit.
    pub limit: f64,
    /// Minima: most, nearest first; 0: all.
    pub max_count: usize,
}

/// Points of a surface.
pub struct gusset_surface_points {
    points: Vec<gusset_surface_nearest_point>,
    bound: f64,
    complete: bool,
}

handle! { gusset_surface_points }

/// Lent points.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_surface_points_view {
    /// sizeof(gusset_surface_points_view).
    pub struct_size: usize,
    /// The points, nearest first.
    /// @shape count
    pub points: *const gusset_surface_nearest_point,
    /// Number of points.
    pub count: usize,
    /// No minimum below this distance is missing.
    pub bound: f64,
    /// 0 if the search stopped at `bound`.
    /// @flag
    pub complete: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_nearest_options: 24, gusset_surface_points_view: 40 }
fixed! { gusset_surface_nearest_point: 104 }

impl From<Option<Closest>> for gusset_surface_nearest_point {
    fn from(closest: Option<Closest>) -> Self {
        let Some(found) = closest else {
            let (zero, distance) = (bytemuck::Zeroable::zeroed(), f64::INFINITY);
            return gusset_surface_nearest_point { distance, bound: distance, ..zero };
        };
        let flag = |on: bool, flag: u32| if on { flag } else { 0 };
        gusset_surface_nearest_point {
            place: found.place.into(),
            point: found.point.to_array(),
            normal: found.normal.to_array(),
            distance: found.distance,
            bound: found.bound,
            flags: GUSSET_NEAREST_FOUND
                | flag(found.proven, GUSSET_NEAREST_PROVEN)
                | flag(found.is_ambiguous, GUSSET_NEAREST_AMBIGUOUS),
            reserved: 0,
        }
    }
}

impl gusset_nearest_options {
    /// Returns the limit, or infinity if there is none.
    fn limit_or_infinity(&self) -> f64 {
        if self.limit == 0.0 { f64::INFINITY } else { self.limit }
    }
}

/// Finds the nearest point for each query.
///
/// Gives the first of equally near points by sheet, row, column, independent of other queries.
///
/// @param queries points.
/// @param points receives count answers; after an error, none is found.
/// @errors TOO_LARGE, NOT_FINITE (query), OUT_OF_RANGE (limit, query)
/// @complexity O(log nodes) a query, parallel; near centres of curvature more, but bounded.
/// @source Leus, task a.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_nearest(
    context: *const gusset_context,
    surface: *const gusset_surface,
    queries: *const f64,
    count: usize,
    options: *const gusset_nearest_options,
    points: *mut gusset_surface_nearest_point,
) -> gusset_status {
    let mut out = input::result_buffer(points, count, "points");
    out.iter_mut().for_each(|out| out.fill(None.into()));
    guard_changing_call(context, |job| {
        let (out, limit) = (out?, input::read_versioned_struct(options, true, "options")?.limit_or_infinity());
        let surface = surface_of_handle(surface)?;
        Error::check_count("queries", count as u64, u32::MAX.into())?;
        let queries =
            alloc::collect(input::input_items(queries.cast::<[f64; 3]>(), count, "queries")?.map(DVec3::from_array))?;
        let done = surface.closest_into(&queries, limit, out, gusset_surface_nearest_point::from, job);
        done.and_then(|()| job.finish()).inspect_err(|_| out.fill(None.into())).map_err(Failure::from)
    })
}

/// Finds the local minima of the distance from a query.
///
/// No minimum is missed. If the distance is constant, one point represents all touching cells,
/// GUSSET_NEAREST_AMBIGUOUS but not GUSSET_NEAREST_PROVEN. On borders and creases, no path leads
/// nearer.
///
/// @param query a point.
/// @param points receives the minima.
/// @errors NOT_FINITE, OUT_OF_RANGE (limit, query)
/// @complexity O(cells within the limit, or up to the last of max_count minima).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_minima_create(
    context: *const gusset_context,
    surface: *const gusset_surface,
    query: *const f64,
    options: *const gusset_nearest_options,
    points: *mut *mut gusset_surface_points,
) -> gusset_status {
    create_handle(context, points, "points", |job| {
        let options = input::read_versioned_struct(options, true, "options")?;
        let (surface, query) = (surface_of_handle(surface)?, input::read_vector(query, "query")?);
        let found = surface.local_minima(query, options.limit_or_infinity(), options.max_count, job)?;
        let Minima { points, complete, bound } = found;
        let points = alloc::collect(points.into_iter().map(|point| Some(point).into()))?;
        Ok(gusset_surface_points { points, bound, complete })
    })
}

/// Lends the points.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_points_get_view(
    points: *const gusset_surface_points,
    view: *mut gusset_surface_points_view,
) -> gusset_status {
    lend!(points, view, |found| {
        let (points, count) = (lend_list(&found.points), found.points.len());
        let (bound, complete) = (found.bound, found.complete.into());
        gusset_surface_points_view { struct_size: 0, points, count, bound, complete, reserved: 0 }
    })
}

/// Frees points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_surface_points_destroy(points: *mut gusset_surface_points) {
    handle::destroy(points);
}
