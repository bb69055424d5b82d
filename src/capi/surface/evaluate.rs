//! Points: Points, normals and curvatures at places of a surface.

use crate::capi::context::{guard_changing_call, gusset_context};
use crate::capi::glue::{c_enum, fixed};
use crate::capi::input::{self, Choice};
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::{gusset_surface, gusset_surface_place, surface_of_handle};
use crate::error::{Element, Error};
use crate::surface::{LocalGeometry, NormalKind, Place};
use gusset_base::alloc;

/// Kind of a normal.
pub type gusset_normal_kind = u32;
/// Undefined: tangents are 0, or parallel along all lines to the point.
pub const GUSSET_NORMAL_NONE: gusset_normal_kind = 0;
/// Normal of the tangent plane.
pub const GUSSET_NORMAL_REGULAR: gusset_normal_kind = 1;
/// Limit along the coordinate line where tangents span no plane, as at poles.
pub const GUSSET_NORMAL_LIMIT: gusset_normal_kind = 2;

/// Point, derivatives by the cell's parameters, normal and curvatures.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_surface_point {
    /// The point.
    pub point: [f64; 3],
    /// S_u.
    pub u: [f64; 3],
    /// S_v.
    pub v: [f64; 3],
    /// S_uu.
    pub uu: [f64; 3],
    /// S_uv.
    pub uv: [f64; 3],
    /// S_vv.
    pub vv: [f64; 3],
    /// Unit normal along S_u x S_v; 0 if undefined.
    pub normal: [f64; 3],
    /// GUSSET_NORMAL_LIMIT: largest angle to limits along other lines.
    pub spread: f64,
    /// Principal curvatures, greater first; positive if bent towards the normal.
    pub principal: [f64; 2],
    /// Principal directions: two unit tangents.
    /// @shape 2 3
    pub directions: [f64; 6],
    /// Mean curvature.
    pub mean: f64,
    /// Gaussian curvature.
    pub gaussian: f64,
    /// Kind of a normal.
    pub normal_kind: gusset_normal_kind,
    /// 0: not regular; curvatures are 0.
    /// @flag
    pub is_curved: u32,
}

fixed! { gusset_surface_point: 264 }

c_enum! { normal_kind: NormalKind { GUSSET_NORMAL_NONE => None, GUSSET_NORMAL_REGULAR => Regular, GUSSET_NORMAL_LIMIT => Limit } }

impl From<LocalGeometry> for gusset_surface_point {
    fn from(local: LocalGeometry) -> Self {
        let LocalGeometry { jet, normal, curvatures } = local;
        let mut point = gusset_surface_point {
            point: jet.point.into(),
            u: jet.u.into(),
            v: jet.v.into(),
            uu: jet.uu.into(),
            uv: jet.uv.into(),
            vv: jet.vv.into(),
            normal: normal.direction.into(),
            spread: normal.spread,
            normal_kind: normal.kind.number(),
            ..bytemuck::Zeroable::zeroed()
        };
        if let Some(curvatures) = curvatures {
            let [[a, b, c], [d, e, f]] = curvatures.directions.map(|direction| direction.to_array());
            point.principal = curvatures.principal;
            point.directions = [a, b, c, d, e, f];
            (point.mean, point.gaussian, point.is_curved) = (curvatures.mean, curvatures.gaussian, 1);
        }
        point
    }
}

/// Places located between two progress reports.
const PLACES_PER_REPORT: usize = 1 << 20;

/// Reads the caller's places on a surface, at any alignment.
pub(crate) fn read_surface_places(data: *const gusset_surface_place, count: usize) -> Result<Vec<Place>, Failure> {
    let place = |(k, given): (usize, gusset_surface_place)| match given.reserved {
        0 => Ok(Place { sheet: given.sheet, cell: [given.row, given.column], u: given.u, v: given.v }),
        other => Err(Failure::not_zero("reserved", other.into()).with_item("places", k)),
    };
    alloc::try_collect(input::input_items(data, count, "places")?.enumerate().map(place))
}

/// Evaluates a surface at places.
///
/// @param results receives count points; 0 after an error.
/// @errors NO_SUCH_ELEMENT (place; also a parameter outside 0 to 1)
/// @complexity O(1) a place, at a pole O(cells round it); parallel.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_evaluate(
    context: *const gusset_context,
    surface: *const gusset_surface,
    places: *const gusset_surface_place,
    count: usize,
    results: *mut gusset_surface_point,
) -> gusset_status {
    let results = input::cleared_result_buffer(results, count, "results");
    guard_changing_call(context, |job| {
        let (results, surface, places) = (results?, surface_of_handle(surface)?, read_surface_places(places, count)?);
        let found = surface.evaluate(&places, job)?;
        job.finish()?;
        results.iter_mut().zip(found).for_each(|(result, local)| *result = local.into());
        Ok(())
    })
}

/// Converts a sheet's parameters to places; node (i, j) has u = i, v = j.
///
/// Parameters wrap round closed directions, and are clamped to open sides.
///
/// @param sheet index.
/// @param parameters u, v of each place.
/// @param places receives count places; 0 after an error.
/// @errors NO_SUCH_ELEMENT (first pair that is not finite; pair 0: no such sheet)
/// @complexity O(1) a place.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_locate(
    context: *const gusset_context,
    surface: *const gusset_surface,
    sheet: u32,
    parameters: *const f64,
    count: usize,
    places: *mut gusset_surface_place,
) -> gusset_status {
    let places = input::cleared_result_buffer(places, count, "places");
    guard_changing_call(context, |job| {
        let (places, surface) = (places?, surface_of_handle(surface)?);
        let bytes =
            input::input_bytes(parameters.cast(), input::checked_product(count, 2, "parameters")?, 8, "parameters")?;
        let mut found = alloc::with_capacity(count)?;
        for (k, pair) in bytes.chunks_exact(16).enumerate() {
            job.step_every(PLACES_PER_REPORT, k, count, "locating")?;
            let place = surface.place(sheet as usize, bytemuck::pod_read_unaligned(pair));
            found.push(gusset_surface_place::from(place.map_err(|_| Error::NoSuch {
                element: Element::Place,
                index: k as u64,
                count: surface.len() as u64,
            })?));
        }
        job.finish()?;
        places.copy_from_slice(&found);
        Ok(())
    })
}
