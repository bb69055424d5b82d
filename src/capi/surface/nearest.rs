//! Nearest points: Nearest points, local minima of the distance, regions of cells.

use crate::capi::context::{create, guard_change, gusset_context, lend};
use crate::capi::glue::{fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, lent};
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::{gusset_surface, gusset_surface_place, read};
use crate::error::Error;
use crate::surface::{Closest, Minima};
use glam::DVec3;
use gusset_base::alloc;

/// Bits of gusset_surface_nearest_point.
/// @bits
pub type gusset_nearest_flags = u32;
/// There is a point; else nothing is within the limit, all numbers are 0 and the distance is
/// infinite.
pub const GUSSET_NEAREST_FOUND: gusset_nearest_flags = 1;
/// The distance is proved: bound is within the tolerance of it, or within the rounding of
/// coordinates. Not set: the proof would take too long, as it may next to a centre of curvature.
/// `bound` is right nevertheless.
pub const GUSSET_NEAREST_PROVEN: gusset_nearest_flags = 2;
/// Another point, farther from this one than a hundredth of the distance, is as near within the
/// tolerance.
pub const GUSSET_NEAREST_AMBIGUOUS: gusset_nearest_flags = 4;

/// A point of a surface that was found for a query.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_surface_nearest_point {
    /// Where it is on the surface.
    pub place: gusset_surface_place,
    /// x, y, z.
    pub point: [f64; 3],
    /// The unit normal there, or its limit at a pole; 0 where there is none. The query is on its
    /// side if (query - point) . normal > 0.
    pub normal: [f64; 3],
    /// The distance from the query.
    pub distance: f64,
    /// No point of the surface is nearer than this; of minima: none of the piece of surface round
    /// the point.
    pub bound: f64,
    /// Bits of gusset_surface_nearest_point.
    pub flags: gusset_nearest_flags,
    /// 0.
    pub reserved: u32,
}

/// The points that are looked for.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct gusset_nearest_options {
    /// sizeof(gusset_nearest_options), set by the caller.
    pub struct_size: usize,
    /// No point farther than this is looked for; a length, at least 0; 0 or INFINITY: no limit.
    pub limit: f64,
    /// For minima: the number of the nearest that are wanted; 0: all.
    pub max_count: usize,
}

/// Points of a surface. Opaque and immutable; it keeps nothing of the surface.
pub struct gusset_surface_points {
    points: Vec<gusset_surface_nearest_point>,
    bound: f64,
    complete: bool,
}

handle! { gusset_surface_points }

/// The points that were found. Pointers are valid until the handle is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_surface_points_view {
    /// sizeof(gusset_surface_points_view), set by the caller.
    pub struct_size: usize,
    /// The points, the nearest first.
    pub points: *const gusset_surface_nearest_point,
    /// How many.
    pub count: usize,
    /// None is missing that is nearer than this.
    pub bound: f64,
    /// 1, or 0 if the search gave up at that distance, as it may where the distance is the same all
    /// over the surface.
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
    /// The limit, or infinity.
    fn limit(&self) -> f64 {
        if self.limit == 0.0 { f64::INFINITY } else { self.limit }
    }
}

/// The nearest points of a surface to queries, one or many.
///
/// Each answer is the same to the bit whether it is asked for alone or among others, in any order,
/// on any number of threads; of several nearest points it is that of the first sheet, row and
/// column. Proofs are relative to the surface as declared: no point of it is nearer than
/// bound.
///
/// @param queries x, y, z of each, packed, at any alignment.
/// @param count see queries.
/// @param options NULL for the defaults: no limit.
/// @param points room for count answers, in the order of the queries; none is found on failure: no
///     flags, and infinite distances.
/// @errors TOO_LARGE, NOT_FINITE (with the query), OUT_OF_RANGE (limit; a query with a coordinate
///     beyond 1e150)
/// @complexity O(log nodes) a query but for queries near centres of curvature, which take bounded
///     work; threads.
/// @source Leus, "Carcasses on smooth surfaces", task a, by branch and bound.
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
    let mut out = input::results(points, count, "points");
    out.iter_mut().for_each(|out| out.fill(None.into()));
    guard_change(context, |job| {
        let (out, limit) = (out?, input::read(options, true, "options")?.limit());
        let surface = read(surface)?;
        Error::check_count("queries", count as u64, u32::MAX.into())?;
        let queries =
            alloc::collect(input::items(queries.cast::<[f64; 3]>(), count, "queries")?.map(DVec3::from_array))?;
        let done = surface.closest_into(&queries, limit, out, gusset_surface_nearest_point::from, job);
        done.and_then(|()| job.memory()).inspect_err(|_| out.fill(None.into())).map_err(Failure::from)
    })
}

/// The places where the distance from a query is locally least: all, those within a limit, or the
/// nearest ones.
///
/// None is missed: where it cannot be proved whether there is one (the distance is the same all
/// round, as at a focus), one point is given for all cells that touch, without
/// GUSSET_NEAREST_PROVEN and with GUSSET_NEAREST_AMBIGUOUS. On open borders and creases, places
/// count from which no way on the surface leads nearer.
///
/// @param query x, y, z, up to 1e150, at any alignment.
/// @param options NULL for the defaults: all.
/// @param points receives the result, the nearest first, for gusset_surface_points_destroy; NULL on
///     failure.
/// @errors NOT_FINITE, OUT_OF_RANGE (limit; a coordinate beyond 1e150)
/// @complexity O(cells within the limit); with max_count, those no farther than the last.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_minima_create(
    context: *const gusset_context,
    surface: *const gusset_surface,
    query: *const f64,
    options: *const gusset_nearest_options,
    points: *mut *mut gusset_surface_points,
) -> gusset_status {
    create(context, points, "points", |job| {
        let options = input::read(options, true, "options")?;
        let (surface, query) = (read(surface)?, input::vector(query, "query")?);
        let found = surface.local_minima(query, options.limit(), options.max_count, job)?;
        let Minima { points, complete, bound } = found;
        let points = alloc::collect(points.into_iter().map(|point| Some(point).into()))?;
        Ok(gusset_surface_points { points, bound, complete })
    })
}

/// The points, lent until they are destroyed.
///
/// @param view struct_size set by the caller; all else is overwritten.
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_points_get_view(
    points: *const gusset_surface_points,
    view: *mut gusset_surface_points_view,
) -> gusset_status {
    lend!(points, view, |found| {
        let (points, count) = (lent(&found.points), found.points.len());
        let (bound, complete) = (found.bound, found.complete.into());
        gusset_surface_points_view { struct_size: 0, points, count, bound, complete, reserved: 0 }
    })
}

/// Frees points; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_surface_points_destroy(points: *mut gusset_surface_points) {
    handle::destroy(points);
}
