//! Distances: Nearest points of a surface and a line, plane, curve or surface.

use crate::capi::context::{answer_into_struct, gusset_context};
use crate::capi::curve::{gusset_curve, gusset_place, view_of_curve};
use crate::capi::glue::{constants, versioned};
use crate::capi::handle;
use crate::capi::input;
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::line_intersection::{gusset_line, read_lines};
use crate::capi::surface::{gusset_surface, gusset_surface_place, surface_of_handle};
use crate::surface::NearestPoints;
use glam::DVec3;

/// Kind of a target.
pub type gusset_target_kind = u32;
/// The line, ray or segment `line`.
pub const GUSSET_TARGET_LINE: gusset_target_kind = 0;
/// The plane through `point` with the normal `normal`.
pub const GUSSET_TARGET_PLANE: gusset_target_kind = 1;
/// The curve `curve`.
pub const GUSSET_TARGET_CURVE: gusset_target_kind = 2;
/// The surface `surface`.
pub const GUSSET_TARGET_SURFACE: gusset_target_kind = 3;

/// An object to measure from. Fields name the kind that reads them, without prefix.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_target {
    /// sizeof(gusset_target).
    pub struct_size: usize,
    /// Kind of a target.
    pub kind: gusset_target_kind,
    /// 0.
    pub reserved: u32,
    /// LINE.
    pub line: gusset_line,
    /// PLANE.
    pub point: [f64; 3],
    /// PLANE.
    pub normal: [f64; 3],
    /// CURVE.
    pub curve: *const gusset_curve,
    /// SURFACE.
    pub surface: *const gusset_surface,
}

/// Properties of a distance.
/// @bits
pub type gusset_distance_flags = u32;
/// `bound` is within the tolerance of the distance, or 2^-45 of the greatest coordinate. Else the
/// proof takes too long; `bound` holds.
pub const GUSSET_DISTANCE_PROVEN: gusset_distance_flags = 1;
/// Surface and target meet up to rounding; the distance is 0.
pub const GUSSET_DISTANCE_MEETS: gusset_distance_flags = 2;

/// Nearest points of a surface and a target.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_distance_report {
    /// sizeof(gusset_distance_report).
    pub struct_size: usize,
    /// Place of the surface's point.
    pub place: gusset_surface_place,
    /// The surface's point.
    pub point: [f64; 3],
    /// Unit normal; at a pole its limit; 0 if undefined.
    pub normal: [f64; 3],
    /// The target's point.
    pub other_point: [f64; 3],
    /// Their distance.
    pub distance: f64,
    /// Proved lower bound of the distance.
    pub bound: f64,
    /// SURFACE: its place; else 0.
    pub other_place: gusset_surface_place,
    /// CURVE: its place; else 0.
    pub curve_place: gusset_place,
    /// LINE: its parameter. PLANE: signed distance, negative opposite to the normal. Else 0.
    pub parameter: f64,
    /// Properties of a distance.
    pub flags: gusset_distance_flags,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_target: 144 reserved, gusset_distance_report: 192 }

impl gusset_distance_report {
    /// Omits the place on the target.
    fn new<T>(found: &NearestPoints<T>) -> Self {
        let flag = |on: bool, flag: u32| if on { flag } else { 0 };
        gusset_distance_report {
            struct_size: 0,
            place: found.place.into(),
            point: found.point.to_array(),
            normal: found.normal.to_array(),
            other_point: found.other_point.to_array(),
            distance: found.distance,
            bound: found.bound,
            other_place: gusset_surface_place::default(),
            curve_place: bytemuck::Zeroable::zeroed(),
            parameter: 0.0,
            flags: flag(found.proven, GUSSET_DISTANCE_PROVEN) | flag(found.meets, GUSSET_DISTANCE_MEETS),
            reserved: 0,
        }
    }
}

/// Finds the nearest points of a surface and a target.
///
/// Among equally near pairs, the choice is deterministic. If much is equally near, the proof may
/// fail. If a plane meets the surface, the points lie on the section.
///
/// @param tolerance length to which the distance is proved; 0: the surface's, or the greater of
///     two.
/// @errors OUT_OF_RANGE (tolerance; line; plane; curve too large), EMPTY_CURVE
/// @complexity About O(log cells), at most 50,000 pairs of pieces.
/// @source Leus, tasks c to e.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_distance(
    context: *const gusset_context,
    surface: *const gusset_surface,
    target: *const gusset_target,
    tolerance: f64,
    report: *mut gusset_distance_report,
) -> gusset_status {
    answer_into_struct(context, (report, "report"), |job| {
        let (surface, target) = (surface_of_handle(surface)?, input::read_versioned_struct(target, false, "target")?);
        let tolerance = (tolerance != 0.0).then_some(tolerance);
        let field = |failure: Failure| failure.with_field("target");
        Ok(match target.kind {
            GUSSET_TARGET_LINE => {
                let found = surface.distance_to_line(&read_lines(&raw const target.line, 1)?[0], tolerance, job)?;
                gusset_distance_report { parameter: found.other, ..gusset_distance_report::new(&found) }
            }
            GUSSET_TARGET_PLANE => {
                let [point, normal] = [target.point, target.normal].map(DVec3::from_array);
                let found = surface.distance_to_plane(point, normal, tolerance, job)?;
                gusset_distance_report { parameter: found.other, ..gusset_distance_report::new(&found) }
            }
            GUSSET_TARGET_CURVE => {
                let found =
                    surface.distance_to_curve(&view_of_curve(target.curve, "curve").map_err(field)?, tolerance, job)?;
                gusset_distance_report { curve_place: found.other.into(), ..gusset_distance_report::new(&found) }
            }
            GUSSET_TARGET_SURFACE => {
                let other = handle::get_object(target.surface, "surface").map_err(field)?;
                let found = surface.distance_to_surface(&other.0, tolerance, job)?;
                gusset_distance_report { other_place: found.other.into(), ..gusset_distance_report::new(&found) }
            }
            other => {
                return Err(Failure::unknown_choice(
                    "kind",
                    other,
                    &constants![GUSSET_TARGET_LINE, GUSSET_TARGET_PLANE, GUSSET_TARGET_CURVE, GUSSET_TARGET_SURFACE],
                ));
            }
        })
    })
}
