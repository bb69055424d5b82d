//! Measures of curves: Derivatives, lengths, nearest points, bounds and moments.

use crate::capi::context::{answer_into_struct, guard_call, gusset_context};
use crate::capi::curve::{gusset_curve, gusset_place, read_places, read_points, view_of_curve, write_points};
use crate::capi::glue::{fixed, versioned};
use crate::capi::input;
use crate::capi::status::{Failure, gusset_status};
use crate::curve::ops::{MeasureSelection, Measures};
use crate::curve::{CurveView, Place};
use crate::job::Job;
use glam::DVec3;

/// Places measured between two progress reports.
const PLACES_PER_REPORT: usize = 1 << 8;

/// Nearest point of a curve.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_curve_nearest_point {
    /// Place on the curve.
    pub place: gusset_place,
    /// x, y, z.
    pub point: [f64; 3],
    /// Distance; infinite if it overflows.
    pub distance: f64,
}

/// Measures of a curve.
/// @bits
pub type gusset_curve_measure_flags = u32;
/// `length`.
pub const GUSSET_CURVE_MEASURE_LENGTH: gusset_curve_measure_flags = 1;
/// `low` and `high`; undefined without points.
pub const GUSSET_CURVE_MEASURE_BOUNDS: gusset_curve_measure_flags = 2;
/// `centre`; undefined without points.
pub const GUSSET_CURVE_MEASURE_CENTRE: gusset_curve_measure_flags = 4;
/// `area_vector` and `area`.
pub const GUSSET_CURVE_MEASURE_AREA: gusset_curve_measure_flags = 8;
/// `centroid` and `second`; only for a curve with points in the plane z = 0, and unless they
/// overflow.
pub const GUSSET_CURVE_MEASURE_MOMENTS: gusset_curve_measure_flags = 16;

/// Measures of a curve. A chord closes open curves.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_curve_measures {
    /// sizeof(gusset_curve_measures).
    pub struct_size: usize,
    /// Present measures; all else is 0.
    pub defined: gusset_curve_measure_flags,
    /// 0.
    pub reserved: u32,
    /// Arc length without the chord.
    pub length: f64,
    /// Low corner of the bounding box.
    pub low: [f64; 3],
    /// High corner.
    pub high: [f64; 3],
    /// Mean of the points by arc length.
    pub centre: [f64; 3],
    /// Half the integral of r x dr; in the plane z = 0, (0, 0, signed area), negative if clockwise.
    pub area_vector: [f64; 3],
    /// Length of area_vector: area of the largest shadow.
    pub area: f64,
    /// Centroid of the region, or the start if the area is 0.
    pub centroid: [f64; 2],
    /// Integrals of x x, x y and y y about it, with the area's sign.
    pub second: [f64; 3],
}

versioned! { gusset_curve_measures: 168 }
fixed! { gusset_curve_nearest_point: 48 }

/// Computes a value at many places of a curve.
fn compute_at_places(
    context: *const gusset_context,
    curve: *const gusset_curve,
    (places, count): (*const gusset_place, usize),
    answer: impl FnOnce(&CurveView<'_>, &[Place], &Job<'_>) -> Result<(), Failure>,
) -> gusset_status {
    guard_call(context, |job| {
        answer(&view_of_curve(curve, "curve")?, &self::read_places(places, count, "places")?, job)
    })
}

/// Pairs a result with the caller's buffer for it.
fn with_result_buffer<'a, T>(
    out: *mut f64,
    (count, each): (usize, usize),
    name: &'static str,
    made: T,
) -> Result<(T, &'a mut [f64]), Failure> {
    Ok((made, input::result_buffer(out, input::checked_product(count, each, name)?, name)?))
}

/// Computes points, derivatives, tangents and curvatures at places.
///
/// NULL outputs are not computed. After an error, nothing is written.
///
/// @param order highest derivative, 0 to 64, for `derivatives`.
/// @param derivatives receives 3 (order + 1) count numbers: for each place the point, then
///     derivatives by t, 0 beyond the degree.
/// @param tangents receives count unit tangents; 0 on a segment without extent.
/// @param curvatures receives count numbers, 1 / radius; positive if a plane segment turns from x
///     to y, infinite where the first derivative is 0.
/// @errors NO_SUCH_ELEMENT (place), OUT_OF_RANGE (order)
/// @complexity O(degree^2) a place and output.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_evaluate(
    context: *const gusset_context,
    curve: *const gusset_curve,
    places: *const gusset_place,
    count: usize,
    order: u32,
    derivatives: *mut f64,
    tangents: *mut f64,
    curvatures: *mut f64,
) -> gusset_status {
    compute_at_places(context, curve, (places, count), |curve, places, job| {
        let asked = [derivatives, tangents, curvatures].map(|out| !out.is_null());
        let parts = asked.iter().filter(|&&asked| asked).count();
        let share = |k: usize| {
            let before = asked[..k].iter().filter(|&&asked| asked).count();
            asked[k].then(|| job.sub_job_of_item(before, parts))
        };
        let points = share(0).map(|job| curve.derivatives_at(places, order as usize, &job)).transpose()?;
        let directions = share(1).map(|job| curve.tangents_at(places, &job)).transpose()?;
        let bends = share(2).map(|job| curve.curvatures_at(places, &job)).transpose()?;
        // Check all outputs before writing any.
        let points = points
            .map(|points| with_result_buffer(derivatives, (points.len(), 3), "derivatives", points))
            .transpose()?;
        let directions =
            directions.map(|made| with_result_buffer(tangents, (count, 3), "tangents", made)).transpose()?;
        if let Some((bends, out)) =
            bends.map(|made| with_result_buffer(curvatures, (count, 1), "curvatures", made)).transpose()?
        {
            out.copy_from_slice(&bends);
        }
        points.into_iter().chain(directions).for_each(|(made, out)| write_points(&made, out));
        Ok(())
    })
}

/// Finds the nearest point for each query.
///
/// @param points x, y, z each.
/// @param out receives count answers.
/// @errors EMPTY_CURVE, NOT_FINITE, TOO_LARGE
/// @complexity About O(log segments + degree^2) a point, parallel.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_nearest(
    context: *const gusset_context,
    curve: *const gusset_curve,
    points: *const f64,
    count: usize,
    out: *mut gusset_curve_nearest_point,
) -> gusset_status {
    guard_call(context, |job| {
        let (view, points) = (view_of_curve(curve, "curve")?, self::read_points(points, count, 3)?);
        let out = input::result_buffer(out, count, "out")?;
        for (to, n) in out.iter_mut().zip(view.nearest_to_each_query(&points, job)?) {
            *to = gusset_curve_nearest_point { place: n.place.into(), point: n.point.to_array(), distance: n.distance };
        }
        Ok(())
    })
}

/// Computes arc lengths from the start to places.
///
/// @param out receives count lengths.
/// @errors NO_SUCH_ELEMENT (place)
/// @complexity O(points) in all.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_lengths_at(
    context: *const gusset_context,
    curve: *const gusset_curve,
    places: *const gusset_place,
    count: usize,
    out: *mut f64,
) -> gusset_status {
    compute_at_places(context, curve, (places, count), |curve, places, job| {
        let out = input::result_buffer(out, count, "out")?;
        let lengths = curve.arc_lengths(&job.sub_job(0.0, 0.5))?;
        let job = job.sub_job(0.5, 1.0);
        for (k, (to, &place)) in out.iter_mut().zip(places).enumerate() {
            job.step_every(PLACES_PER_REPORT, k, count, "lengths at places")?;
            *to = lengths.length_to(place)?;
        }
        Ok(())
    })
}

/// Finds the places at arc lengths from the start, clamped to the ends.
///
/// @param out receives count places.
/// @param lengths arc lengths.
/// @errors EMPTY_CURVE, OUT_OF_RANGE (NaN)
/// @complexity O(points + count log segments).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_places_at(
    context: *const gusset_context,
    curve: *const gusset_curve,
    lengths: *const f64,
    count: usize,
    out: *mut gusset_place,
) -> gusset_status {
    guard_call(context, |job| {
        let measured = view_of_curve(curve, "curve")?.arc_lengths(&job.sub_job(0.0, 0.5))?;
        let (lengths, job) = (input::copy_input_items(lengths, count, "lengths")?, job.sub_job(0.5, 1.0));
        for (k, (to, length)) in input::result_buffer(out, count, "out")?.iter_mut().zip(lengths).enumerate() {
            job.step_every(PLACES_PER_REPORT, k, count, "places at lengths")?;
            *to = measured.place_at_length(length)?.into();
        }
        Ok(())
    })
}

/// Measures a curve.
///
/// The length is accurate to 1e-13, the centre comes from 16 chords a segment. Else, and lengths up
/// to degree 2, measures are exact up to rounding.
///
/// @param flags 0: all.
/// @errors OUT_OF_RANGE (a measure overflows: the largest coordinate)
/// @complexity O(points) for length and bounds, else O(sum of degree^2).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_measure(
    context: *const gusset_context,
    curve: *const gusset_curve,
    flags: gusset_curve_measure_flags,
    measures: *mut gusset_curve_measures,
) -> gusset_status {
    answer_into_struct(context, (measures, "measures"), |job| {
        Ok(view_of_curve(curve, "curve")?.measures(measure_selection(flags)?, job)?.into())
    })
}

fn measure_selection(flags: gusset_curve_measure_flags) -> Result<MeasureSelection, Failure> {
    if flags > 2 * GUSSET_CURVE_MEASURE_MOMENTS - 1 {
        return Err(Failure::unknown_value("flags", flags.into(), "a sum of GUSSET_CURVE_MEASURE_ constants"));
    }
    let has = |flag| flags == 0 || flags & flag != 0;
    Ok(MeasureSelection {
        length: has(GUSSET_CURVE_MEASURE_LENGTH),
        bounds: has(GUSSET_CURVE_MEASURE_BOUNDS),
        centre: has(GUSSET_CURVE_MEASURE_CENTRE),
        area: has(GUSSET_CURVE_MEASURE_AREA),
        moments: has(GUSSET_CURVE_MEASURE_MOMENTS),
    })
}

impl From<Measures> for gusset_curve_measures {
    fn from(measures: Measures) -> Self {
        let Measures { length, bounds, centre, area_vector, moments } = measures;
        let has = |has: bool, flag| if has { flag } else { 0 };
        let point = |point: Option<DVec3>| point.unwrap_or_default().to_array();
        gusset_curve_measures {
            struct_size: 0,
            defined: has(length.is_some(), GUSSET_CURVE_MEASURE_LENGTH)
                | has(bounds.is_some(), GUSSET_CURVE_MEASURE_BOUNDS)
                | has(centre.is_some(), GUSSET_CURVE_MEASURE_CENTRE)
                | has(area_vector.is_some(), GUSSET_CURVE_MEASURE_AREA)
                | has(moments.is_some(), GUSSET_CURVE_MEASURE_MOMENTS),
            reserved: 0,
            length: length.unwrap_or_default(),
            low: point(bounds.map(|bounds| bounds.low)),
            high: point(bounds.map(|bounds| bounds.high)),
            centre: point(centre),
            area_vector: point(area_vector),
            area: measures.area(),
            centroid: moments.map_or([0.0; 2], |moments| [moments.centroid.x, moments.centroid.y]),
            second: moments.map_or([0.0; 3], |moments| moments.second),
        }
    }
}
