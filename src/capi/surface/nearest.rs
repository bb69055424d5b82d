//! Nearest points of surfaces, places where the distance is locally least, regions of cells, as C
//! sees them.

use crate::capi::context::{create, guard_change, gusset_context, lend};
use crate::capi::glue::{fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, flag, lent};
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::{gusset_surface, gusset_surface_place, read};
use crate::error::Error;
use crate::surface::{Closest, Minima, Region};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::geom::strided::Strided;

/// gusset_surface_nearest_point: there is a point; else nothing is within the limit, all numbers
/// are 0 and the distance is infinite.
pub const GUSSET_NEAREST_FOUND: u32 = 1;
/// gusset_surface_nearest_point: its distance is proved: bound is within the tolerance of it, or
/// within the rounding of coordinates. Not set: that would take too long, as it may next to a
/// centre of curvature; bound is right nevertheless.
pub const GUSSET_NEAREST_PROVEN: u32 = 2;
/// gusset_surface_nearest_point: another point, farther from this one than a hundredth of the
/// distance, is as near within the tolerance.
pub const GUSSET_NEAREST_AMBIGUOUS: u32 = 4;

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
    /// GUSSET_NEAREST_...
    pub flags: u32,
    /// 0.
    pub reserved: u32,
}

/// What is looked for.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct gusset_nearest_options {
    /// sizeof(gusset_nearest_options), set by the caller.
    pub struct_size: usize,
    /// No point farther than this is looked for, if limited is 1; a length, at least 0; INFINITY:
    /// no limit.
    pub limit: f64,
    /// Of minima: as many of the nearest; 0: all.
    pub max_count: usize,
    /// 1: limit is read.
    pub limited: u32,
    /// 0.
    pub reserved: u32,
}

/// Points of a surface. Opaque and immutable; it keeps nothing of the surface.
pub struct gusset_surface_points {
    points: Vec<gusset_surface_nearest_point>,
    bound: f64,
    complete: bool,
}

handle! { gusset_surface_points }

/// What was found. Pointers are valid until the handle is destroyed.
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

/// Cells of a surface. Opaque and immutable; it keeps nothing of the surface.
pub struct gusset_surface_region {
    cells: Vec<gusset_surface_cell>,
    mask: Vec<u64>,
    first: Vec<u64>,
}

handle! { gusset_surface_region }

/// A cell of a region.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_surface_cell {
    /// The sheet.
    pub sheet: u32,
    /// The row of the cell.
    pub row: u32,
    /// Its column.
    pub column: u32,
    /// 1 if all of the cell is within the radius.
    pub whole: u32,
}

/// The cells. Pointers are valid until the handle is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_surface_region_view {
    /// sizeof(gusset_surface_region_view), set by the caller.
    pub struct_size: usize,
    /// The cells, rising by sheet, row, column.
    pub cells: *const gusset_surface_cell,
    /// How many.
    pub cell_count: usize,
    /// A bit for each cell of all sheets, 1 for those of the region: that of cell (i, j) of sheet
    /// k, which has c columns, is b = first[k] + i * c + j, which is mask[b / 64] >> (b % 64) & 1.
    pub mask: *const u64,
    /// How many words.
    pub word_count: usize,
    /// By sheet: its first bit; then the number of bits.
    pub first: *const u64,
    /// How many sheets.
    pub sheet_count: usize,
}

versioned! {
    gusset_nearest_options: 32 reserved,
    gusset_surface_points_view: 40,
    gusset_surface_region_view: 56,
}
fixed! { gusset_surface_nearest_point: 104, gusset_surface_cell: 16 }

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
    fn limit(&self) -> Result<f64, Failure> {
        Ok(if flag(self.limited, "limited")? { self.limit } else { f64::INFINITY })
    }
}

/// The caller's points, `stride` bytes apart, 0 for none between; at any alignment.
pub(crate) fn queries(data: *const f64, count: usize, stride: usize) -> Result<Vec<DVec3>, Failure> {
    Error::check_count("queries", count as u64, u32::MAX.into())?;
    let bytes = input::bytes(data.cast(), Strided::span(count, stride, 24, "queries")?, 1, "queries")?;
    let queries = Strided::new(bytes, count, stride, 24, "queries")?;
    Ok(alloc::collect((0..count).map(|k| DVec3::from_array(queries.get(k))))?)
}

/// The nearest points of a surface to queries, one or many.
///
/// Each answer is the same to the bit whether it is asked for alone or among others, in any order,
/// on any number of threads; of several nearest points it is that of the first sheet, row and
/// column. What is proved is relative to the surface as declared: no point of it is nearer than
/// bound.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param surface the surface.
/// @param queries x, y, z of each, at any alignment, `stride` bytes apart (0: packed).
/// @param count see queries.
/// @param stride see queries.
/// @param options NULL for the defaults: no limit.
/// @param[out] points room for count answers, in the order of the queries; none is found on
///     failure: no flags, and infinite distances.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE, BAD_STRIDE,
///     SIZE_OVERFLOW, TOO_LARGE, NOT_FINITE with the query, OUT_OF_RANGE (limit; a query with a
///     coordinate beyond 1e150), UNKNOWN_VALUE, OUT_OF_MEMORY, CANCELLED.
/// @complexity O(log nodes) a query but for queries near centres of curvature, which take bounded
///     work; threads.
/// @source Leus, "Carcasses on smooth surfaces", task a, by branch and bound.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_nearest(
    context: *const gusset_context,
    surface: *const gusset_surface,
    queries: *const f64,
    count: usize,
    stride: usize,
    options: *const gusset_nearest_options,
    points: *mut gusset_surface_nearest_point,
) -> gusset_status {
    let mut out = input::results(points, count, "points");
    out.iter_mut().for_each(|out| out.fill(None.into()));
    guard_change(context, |job| {
        let (out, limit) = (out?, input::read(options, true, "options")?.limit()?);
        let (surface, queries) = (read(surface)?, self::queries(queries, count, stride)?);
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
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param surface the surface.
/// @param query x, y, z, up to 1e150, at any alignment.
/// @param options NULL for the defaults: all.
/// @param[out] points receives the result, the nearest first, for gusset_surface_points_destroy;
///     NULL on failure.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE, NOT_FINITE,
///     OUT_OF_RANGE (limit; a coordinate beyond 1e150), UNKNOWN_VALUE, OUT_OF_MEMORY, CANCELLED.
/// @complexity O(cells within the limit); with max_count, those no farther than the last.
/// @since 0.1
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
        let found = surface.local_minima(query, options.limit()?, options.max_count, job)?;
        let Minima { points, complete, bound } = found;
        let points = alloc::collect(points.into_iter().map(|point| Some(point).into()))?;
        Ok(gusset_surface_points { points, bound, complete })
    })
}

/// The points, lent until they are destroyed.
///
/// @param points the points.
/// @param[out] parts struct_size set by the caller; all else is overwritten.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
/// @complexity O(1).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_points_get_view(
    points: *const gusset_surface_points,
    parts: *mut gusset_surface_points_view,
) -> gusset_status {
    lend!(points, parts, |found| {
        let (points, count) = (lent(&found.points), found.points.len());
        let (bound, complete) = (found.bound, found.complete.into());
        gusset_surface_points_view { struct_size: 0, points, count, bound, complete, reserved: 0 }
    })
}

/// Frees points; NULL is allowed.
///
/// @param[in,out] points the handle; NULL is allowed.
/// @since 0.1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_surface_points_destroy(points: *mut gusset_surface_points) {
    handle::destroy(points);
}

/// The cells that have a point within a radius of a query: the paper's region, with its logical
/// scale.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param surface the surface.
/// @param query x, y, z, up to 1e150, at any alignment.
/// @param radius at least 0; INFINITY: all cells.
/// @param[out] region receives all cells that have such a point, and no others but such as come
///     within the tolerance of the radius or could not be decided in bounded work; for
///     gusset_surface_region_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, NOT_FINITE, OUT_OF_RANGE
///     (radius; a coordinate beyond 1e150), OUT_OF_MEMORY, CANCELLED.
/// @complexity O(cells found, and one bit a cell).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_region_create(
    context: *const gusset_context,
    surface: *const gusset_surface,
    query: *const f64,
    radius: f64,
    region: *mut *mut gusset_surface_region,
) -> gusset_status {
    create(context, region, "region", |job| {
        let (surface, query) = (read(surface)?, input::vector(query, "query")?);
        let Region { cells, whole, mask, first } = surface.region(query, radius, job)?;
        let cell = |([sheet, row, column], whole): ([u32; 3], bool)| gusset_surface_cell {
            sheet,
            row,
            column,
            whole: whole.into(),
        };
        Ok(gusset_surface_region { cells: alloc::collect(cells.into_iter().zip(whole).map(cell))?, mask, first })
    })
}

/// The cells, lent until they are destroyed.
///
/// @param region the region.
/// @param[out] parts struct_size set by the caller; all else is overwritten.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
/// @complexity O(1).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_region_get_view(
    region: *const gusset_surface_region,
    parts: *mut gusset_surface_region_view,
) -> gusset_status {
    lend!(region, parts, |region| gusset_surface_region_view {
        struct_size: 0,
        cells: lent(&region.cells),
        cell_count: region.cells.len(),
        mask: lent(&region.mask),
        word_count: region.mask.len(),
        first: lent(&region.first),
        sheet_count: region.first.len() - 1,
    })
}

/// Frees a region; NULL is allowed.
///
/// @param[in,out] region the handle; NULL is allowed.
/// @since 0.1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_surface_region_destroy(region: *mut gusset_surface_region) {
    handle::destroy(region);
}
