//! The axis for correspondence by angle, straight or bent.
//!
//! Source: W. Wang, B. Juettler, D. Zheng, Y. Liu, *Computation of rotation minimizing frames*
//! (2008). Two reflections transport a direction from one point of a curve to the next, so that it
//! follows the curve without rotating about it.

use super::frame_options::Axis;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::scale::overflow_safe_distance;

/// The sine of the smallest angle between an axis and the reference.
const MIN_AXIS_TO_REFERENCE_SINE: f64 = 1e-9;

/// For each section the point of its axis and three perpendicular directions: along the axis,
/// towards the reference, and perpendicular to both. If `ring`, the first section follows the last,
/// and the rotation that remains after one round is spread evenly.
pub(super) fn axis_frames(
    axis: Axis<'_>,
    reference: DVec3,
    sections: usize,
    ring: bool,
) -> Result<Vec<(DVec3, [DVec3; 3])>> {
    let points = match axis {
        Axis::Line { point, direction } => {
            return alloc::filled(
                (point, orthonormal_axes(normalise_option_vector(direction, "axis")?, reference)?),
                sections,
            );
        }
        Axis::Points(points) => points,
    };
    let n = sections;
    Error::require(points.len() == n, "axis_points", points.len() as f64, n as f64..=n as f64)?;
    // With fewer sections, the frame fails on their number.
    if n < if ring { 3 } else { 2 } {
        return Ok(Vec::new());
    }
    let bad = points.iter().flat_map(DVec3::to_array).find(|x| !x.is_finite());
    bad.map_or(Ok(()), |x| Error::require(false, "axis_points", x, "finite"))?;
    // Halve the points first, because their difference may overflow.
    let half = |k: usize| points[k % n] * 0.5;
    let chord = |k: usize| {
        Ok((
            normalise_option_vector(half(k + 1) - half(k), "axis_points")?,
            overflow_safe_distance(half(k), half(k + 1)),
        ))
    };
    let chords = alloc::try_collect((0..if ring { n } else { n - 1 }).map(chord))?;
    let tangents = alloc::try_collect((0..n).map(|k| circle_tangent_at(&chords, k, ring)))?;
    let [along, start, second] = orthonormal_axes(tangents[0], reference)?;
    let (mut first, mut frames) = (start, alloc::with_capacity(n + 1)?);
    frames.push((points[0], [along, first, second]));
    for (k, &(chord, _)) in chords.iter().enumerate() {
        let (from, to) = (tangents[k], tangents[(k + 1) % n]);
        let reflected = |v: DVec3, normal: DVec3| v - 2.0 * v.dot(normal) * normal;
        let over = (to - reflected(from, chord)).normalize_or_zero();
        first = reflected(reflected(first, chord), over);
        // Round-off would accumulate.
        first = (first - to * to.dot(first)).normalize_or_zero();
        frames.push((points[(k + 1) % n], [to, first, to.cross(first)]));
    }
    if ring {
        frames.pop();
        let over = libm::atan2(first.dot(second), first.dot(start));
        for (k, (_, [_, first, second])) in frames.iter_mut().enumerate() {
            let (sin, cos) = libm::sincos(over * k as f64 / n as f64);
            (*first, *second) = (*first * cos - *second * sin, *second * cos + *first * sin);
        }
    }
    Ok(frames)
}

/// Returns the unit tangent at point k, of the circle through the point and its neighbours. At an
/// end it is the tangent of the circle through the last three points. `chords` are the directions
/// and distances from point to point.
fn circle_tangent_at(chords: &[(DVec3, f64)], k: usize, ring: bool) -> Result<DVec3> {
    let count = chords.len();
    let middle = |[(arrives, before), (leaves, after)]: [(DVec3, f64); 2]| {
        let longer = before.max(after);
        normalise_option_vector(arrives * (after / longer) + leaves * (before / longer), "axis_points")
    };
    // An arc makes equal angles with its chord at both ends.
    let mirrored = |v: DVec3, chord: DVec3| 2.0 * v.dot(chord) * chord - v;
    Ok(match k {
        k if ring => middle([chords[(k + count - 1) % count], chords[k]])?,
        _ if count == 1 => chords[0].0,
        0 => mirrored(middle([chords[0], chords[1]])?, chords[0].0),
        k if k == count => mirrored(middle([chords[k - 2], chords[k - 1]])?, chords[k - 1].0),
        k => middle([chords[k - 1], chords[k]])?,
    })
}

fn normalise_option_vector(v: DVec3, option: &'static str) -> Result<DVec3> {
    let largest = v.abs().max_element();
    Error::require(v.is_finite() && largest > 0.0, option, largest, "a finite vector other than 0")?;
    Ok((v / largest).normalize())
}

/// Three perpendicular directions: a unit vector along the axis, towards the reference, and
/// perpendicular to both.
fn orthonormal_axes(along: DVec3, reference: DVec3) -> Result<[DVec3; 3]> {
    let reference = normalise_option_vector(reference, "reference")?;
    let across = reference - along * reference.dot(along);
    Error::require(
        across.length() >= MIN_AXIS_TO_REFERENCE_SINE,
        "reference",
        across.length(),
        "at an angle to the axis",
    )?;
    let first = across.normalize();
    Ok([along, first, along.cross(first)])
}
