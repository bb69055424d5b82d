//! Intersections of curves: Intersections, tangency points and samples.

use crate::capi::context::{create_handle, gusset_context, lend};
use crate::capi::curve::{gusset_curve, gusset_place, view_of_curve};
use crate::capi::glue::{constants, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, lend_list};
use crate::capi::mesh::gusset_indices;
use crate::capi::status::{Failure, gusset_status};
use crate::curve::ops::{NearMisses, Overlap, PlaneIntersections, SampleSpacing, TangentAngles};
use crate::curve::{CurveView, Place};
use crate::error::Error;
use crate::job::Job;
use glam::DVec3;
use gusset_base::alloc;

/// Places on one or two curves.
#[derive(Default)]
pub struct gusset_places {
    places: Vec<gusset_place>,
    others: Vec<gusset_place>,
    points: Vec<DVec3>,
    overlaps: Vec<[gusset_place; 4]>,
    inside: Vec<u32>,
    undecided: bool,
}

handle! { gusset_places }

/// Lent places.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_places_view {
    /// sizeof(gusset_places_view).
    pub struct_size: usize,
    /// Places, ordered along the first curve.
    /// @shape count
    pub places: *const gusset_place,
    /// Number of places.
    pub count: usize,
    /// Points at the places.
    /// @shape count 3
    pub points: *const f64,
    /// Intersections: places on the second curve, or later on the same. Else NULL.
    /// @shape count
    pub others: *const gusset_place,
    /// Common parts, four places each: start and end on the first curve, then on the second
    /// (tangent angles: the first).
    /// @shape overlap_count 4
    pub overlaps: *const gusset_place,
    /// Number of overlaps.
    pub overlap_count: usize,
    /// Segments in the plane or line.
    pub inside: gusset_indices,
    /// 1: segments that agree within rounding over long parts were not resolved.
    /// @flag
    pub undecided: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_places_view: 80 }

/// Spacing of samples.
pub type gusset_sample_rule = u32;
/// `amount` points at equal arc lengths.
pub const GUSSET_SAMPLE_COUNT: gusset_sample_rule = 0;
/// A point every `amount` of arc length, and the end of an open curve.
pub const GUSSET_SAMPLE_STEP: gusset_sample_rule = 1;
/// Chords within `amount` of the curve. Segments are halved at most 20 times, to 1e-12 of their
/// size.
pub const GUSSET_SAMPLE_CHORD: gusset_sample_rule = 2;

fn to_c_places(places: impl ExactSizeIterator<Item = Place>) -> Result<Vec<gusset_place>, Error> {
    alloc::collect(places.map(gusset_place::from))
}

impl gusset_places {
    fn from_plane_intersections(
        found: PlaneIntersections,
        curve: &CurveView<'_>,
        job: &Job<'_>,
    ) -> Result<Self, Failure> {
        let points = curve.points_at(&found.places, job)?;
        let places = to_c_places(found.places.into_iter())?;
        Ok(gusset_places { places, points, inside: found.inside, ..Self::default() })
    }

    fn from_tangent_angles(found: TangentAngles, curve: &CurveView<'_>, job: &Job<'_>) -> Result<Self, Failure> {
        let points = curve.points_at(&found.places, job)?;
        let part = |[from, to]: [Place; 2]| [from, to, from, to].map(gusset_place::from);
        let overlaps = alloc::collect(found.intervals.into_iter().map(part))?;
        Ok(gusset_places { places: to_c_places(found.places.into_iter())?, points, overlaps, ..Self::default() })
    }

    /// Places on `curve` and on another curve.
    pub(crate) fn from_near_misses(found: &NearMisses, curve: &CurveView<'_>, job: &Job<'_>) -> Result<Self, Failure> {
        let NearMisses { places, overlaps, undecided } = found;
        let at = alloc::collect(places.iter().map(|near| near.a))?;
        let ends = |part: &Overlap| [part.a[0], part.a[1], part.b[0], part.b[1]].map(gusset_place::from);
        Ok(gusset_places {
            places: to_c_places(at.iter().copied())?,
            others: to_c_places(places.iter().map(|near| near.b))?,
            points: curve.points_at(&at, job)?,
            overlaps: alloc::collect(overlaps.iter().map(ends))?,
            inside: Vec::new(),
            undecided: *undecided,
        })
    }
}

/// Finds where a curve crosses or touches a plane.
///
/// For a line along (x, y) in z = 0, the normal is (-y, x, 0).
///
/// @param point of the plane.
/// @param normal of the plane.
/// @errors OUT_OF_RANGE (normal), NOT_FINITE
/// @complexity O(points + degree^2 crossings).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_intersect_plane_create(
    context: *const gusset_context,
    curve: *const gusset_curve,
    point: *const f64,
    normal: *const f64,
    places: *mut *mut gusset_places,
) -> gusset_status {
    create_handle(context, places, "places", |job| {
        let (view, point, normal) = (
            view_of_curve(curve, "curve")?,
            input::read_vector(point, "point")?,
            input::read_vector(normal, "normal")?,
        );
        gusset_places::from_plane_intersections(
            view.intersect_plane(point, normal, &job.sub_job(0.0, 0.9))?,
            &view,
            &job.sub_job(0.9, 1.0),
        )
    })
}

/// Finds where two curves meet or come within a distance, or a plane curve meets itself.
///
/// The result has local minima of the distance, or, if within is 0 and both curves are plane,
/// crossings and touches, each once. Joints are not self-intersections.
///
/// @param other NULL: self-intersections.
/// @param within largest distance, 0 if other is NULL; in space raised to 1e-12 of the curves'
///     size.
/// @param places overlaps stay within the distance, or cannot be separated.
/// @errors OUT_OF_RANGE (within), CURVE_NOT_PLANE (other is NULL), EMPTY_CURVE (in space, or within
///     is not 0)
/// @complexity Bounded for pairs of segments whose boxes are within the distance.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_intersect_create(
    context: *const gusset_context,
    curve: *const gusset_curve,
    other: *const gusset_curve,
    within: f64,
    places: *mut *mut gusset_places,
) -> gusset_status {
    create_handle(context, places, "places", |job| {
        let one = view_of_curve(curve, "curve")?;
        let other = (!other.is_null()).then(|| view_of_curve(other, "other")).transpose()?;
        let found = one.intersections_or_near_misses(other.as_ref(), within, &job.sub_job(0.0, 0.9))?;
        gusset_places::from_near_misses(&found, &one, &job.sub_job(0.9, 1.0))
    })
}

/// Finds where a curve's tangent makes an angle with a direction.
///
/// Each point is found once. At a cusp, tangents on both sides count, to 1e-6; at a joint, of both
/// segments, not between. Angles within 1e-7 of 0, pi/2 and pi snap to them; parallel and opposite
/// tangents are so to 1e-9.
///
/// @param direction a vector.
/// @param angle 0 to pi.
/// @param places overlaps have a constant angle.
/// @errors OUT_OF_RANGE (direction, angle), NOT_FINITE (direction)
/// @complexity O(points + degree^2 places).
/// @source Leus, task b, for curves.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_tangent_angle_create(
    context: *const gusset_context,
    curve: *const gusset_curve,
    direction: *const f64,
    angle: f64,
    places: *mut *mut gusset_places,
) -> gusset_status {
    create_handle(context, places, "places", |job| {
        let (view, direction) = (view_of_curve(curve, "curve")?, input::read_vector(direction, "direction")?);
        gusset_places::from_tangent_angles(
            view.tangents_at_angle(direction, angle, &job.sub_job(0.0, 0.9))?,
            &view,
            &job.sub_job(0.9, 1.0),
        )
    })
}

/// Samples points along a curve. A closed curve's start is not repeated.
///
/// @param amount a whole number (at least 1, for an open curve 2), or a length above 0.
/// @errors EMPTY_CURVE, OUT_OF_RANGE (amount), TOO_LARGE
/// @complexity O(points + samples).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_sample_create(
    context: *const gusset_context,
    curve: *const gusset_curve,
    rule: gusset_sample_rule,
    amount: f64,
    places: *mut *mut gusset_places,
) -> gusset_status {
    create_handle(context, places, "places", |job| {
        let view = view_of_curve(curve, "curve")?;
        let spacing = match rule {
            GUSSET_SAMPLE_COUNT if amount.fract() == 0.0 && amount >= 0.0 => SampleSpacing::Count(amount as usize),
            GUSSET_SAMPLE_COUNT => {
                return Err(Error::OptionOutOfRange {
                    option: "amount",
                    value: amount,
                    allowed: "a whole number of at least 1".into(),
                }
                .into());
            }
            GUSSET_SAMPLE_STEP => SampleSpacing::Step(amount),
            GUSSET_SAMPLE_CHORD => SampleSpacing::Chord(amount),
            other => {
                return Err(Failure::unknown_choice(
                    "rule",
                    other,
                    &constants![GUSSET_SAMPLE_COUNT, GUSSET_SAMPLE_STEP, GUSSET_SAMPLE_CHORD],
                ));
            }
        };
        let found = view.sample_points(spacing, job)?;
        let places = to_c_places(found.places.into_iter())?;
        Ok(gusset_places { places, points: found.points, ..Default::default() })
    })
}

/// Frees places.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_places_destroy(places: *mut gusset_places) {
    handle::destroy(places);
}

/// Lends the places.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_places_get_view(
    places: *const gusset_places,
    view: *mut gusset_places_view,
) -> gusset_status {
    lend!(places, view, |found| gusset_places_view {
        struct_size: size_of::<gusset_places_view>(),
        places: lend_list(&found.places),
        count: found.places.len(),
        points: lend_list(&found.points).cast(),
        others: lend_list(&found.others),
        overlaps: lend_list(found.overlaps.as_flattened()),
        overlap_count: found.overlaps.len(),
        inside: gusset_indices::lend_indices(&found.inside),
        undecided: found.undecided.into(),
        reserved: 0,
    })
}
