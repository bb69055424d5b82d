//! The axis that angles are counted about, straight or bent.
//!
//! Source: W. Wang, B. Juettler, D. Zheng, Y. Liu, *Computation of rotation minimizing frames* (2008):
//! two reflections carry a direction from one point of a curve to the next, so that it turns with
//! the curve and not about it.

use super::options::Axis;
use crate::alloc;
use crate::error::{Error, Result};
use glam::DVec3;

/// The sine of the least angle between an axis and the reference.
const MIN_SINE: f64 = 1e-9;

/// For each section the point of its axis, and three directions at right angles: along the axis,
/// towards the reference, and on from there.
pub(super) fn places(axis: Axis<'_>, reference: DVec3, sections: usize) -> Result<Vec<(DVec3, [DVec3; 3])>> {
    let points = match axis {
        Axis::Line { point, direction } => {
            return alloc::filled((point, axes(unit(direction, "axis")?, reference)?), sections);
        }
        Axis::Points(points) => points,
    };
    Error::require(points.len() == sections && sections >= 2, "axis", points.len() as f64)?;
    let bad = points.iter().flat_map(DVec3::to_array).find(|x| !x.is_finite());
    bad.map_or(Ok(()), |x| Error::require(false, "axis", x))?;
    let mut chords = alloc::with_capacity(sections - 1)?;
    for pair in points.windows(2) {
        // Of points whose difference is too large for a number, too.
        chords.push(unit(pair[1] * 0.5 - pair[0] * 0.5, "axis")?);
    }
    let tangents = alloc::try_collect((0..sections).map(|k| tangent(points, &chords, k)))?;
    let [along, mut first, second] = axes(tangents[0], reference)?;
    let mut places = alloc::with_capacity(sections)?;
    places.push((points[0], [along, first, second]));
    for (k, pair) in tangents.windows(2).enumerate() {
        let reflected = |v: DVec3, normal: DVec3| v - 2.0 * v.dot(normal) * normal;
        let over = (pair[1] - reflected(pair[0], chords[k])).normalize_or_zero();
        first = reflected(reflected(first, chords[k]), over);
        // Round-off would add up.
        first = (first - pair[1] * pair[1].dot(first)).normalize_or_zero();
        places.push((points[k + 1], [pair[1], first, pair[1].cross(first)]));
    }
    Ok(places)
}

/// The unit tangent at point k: of the circle through it and those beside it; at an end of that
/// through the last three. `chords`: the directions from point to point.
fn tangent(points: &[DVec3], chords: &[DVec3], k: usize) -> Result<DVec3> {
    let last = points.len() - 1;
    if last == 1 {
        return Ok(chords[0]);
    }
    let inner = k.clamp(1, last - 1);
    let [before, after] = [0, 1].map(|side| points[inner - 1 + side].distance(points[inner + side]));
    let (arrives, leaves) = (chords[inner - 1], chords[inner]);
    // In halves, and by the longer one, so that nothing overflows.
    let longer = before.max(after);
    let middle = unit(arrives * (after / longer) + leaves * (before / longer), "axis")?;
    // An arc makes equal angles with its chord at both ends.
    let mirrored = |chord: DVec3| 2.0 * middle.dot(chord) * chord - middle;
    Ok(match k {
        0 => mirrored(arrives),
        k if k == last => mirrored(leaves),
        _ => middle,
    })
}

fn unit(v: DVec3, option: &'static str) -> Result<DVec3> {
    let largest = v.abs().max_element();
    Error::require(v.is_finite() && largest > 0.0, option, largest)?;
    Ok((v / largest).normalize())
}

/// Three directions at right angles: a unit vector along the axis, towards the reference, and on from
/// there.
fn axes(along: DVec3, reference: DVec3) -> Result<[DVec3; 3]> {
    let reference = unit(reference, "reference")?;
    let across = reference - along * reference.dot(along);
    Error::require(across.length() >= MIN_SINE, "reference", across.length())?;
    let first = across.normalize();
    Ok([along, first, along.cross(first)])
}
