//! Profiles, which are swept around the axis: points given by distance from the axis and height.
//! O(points).

use super::unit_circle::point_on_unit_circle;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};

/// A point of a profile.
pub(super) type ProfilePoint = [f64; 2];

/// Returns [`Error::OptionOutOfRange`] for a point that is not finite, too far away, or beyond the
/// axis.
pub(super) fn check_profile(profile: &[ProfilePoint], max_distance: f64) -> Result<()> {
    profile.iter().try_for_each(|&[distance, z]| {
        Error::require((0.0..=max_distance).contains(&distance), "profile", distance, 0.0..=max_distance)?;
        Error::require((-max_distance..=max_distance).contains(&z), "profile", z, -max_distance..=max_distance)
    })
}

/// Half a circle from the lowest point to the highest.
pub(super) fn half_circle_profile(radius: f64, rows: usize) -> Result<Vec<ProfilePoint>> {
    alloc::collect((0..rows).map(|i| {
        let [c, s] = point_on_unit_circle(i, 2 * (rows - 1));
        [radius * s, -(radius * c)]
    }))
}

/// Returns a circle round (`distance`, 0), from the point farthest from the axis upwards.
pub(super) fn circle_profile(distance: f64, radius: f64, rows: usize) -> Result<Vec<ProfilePoint>> {
    alloc::collect((0..rows).map(|i| {
        let [c, s] = point_on_unit_circle(i, rows - 1);
        [distance + radius * c, radius * s]
    }))
}

/// Returns a polyline of `rows` points at nearly equal distances, including its corners. Needs a
/// row for each corner.
pub(super) fn subdivide_polyline(corners: &[ProfilePoint], rows: usize) -> Result<Vec<ProfilePoint>> {
    let lengths = corners.windows(2).map(|ends| libm::hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]));
    let mut segments: Vec<(f64, usize)> = alloc::collect(lengths.map(|length| (length, 1)))?;
    // Each further row divides the segment with the widest spacing.
    for _ in segments.len()..rows - 1 {
        let spacing = |&(length, count): &(f64, usize)| length / count as f64;
        if let Some(widest) = segments.iter_mut().reduce(|a, b| if spacing(b) > spacing(a) { b } else { a }) {
            widest.1 += 1;
        }
    }
    let mut points = alloc::with_capacity(rows)?;
    for (ends, &(_, count)) in corners.windows(2).zip(&segments) {
        points.extend((0..count).map(|k| [0, 1].map(|x| lerp(ends[0][x], ends[1][x], k, count))));
    }
    points.extend(corners.last());
    Ok(points)
}

/// Returns the points of a regular polygon with a corner at (1, 0), in `columns` nodes, including
/// its corners. The last node equals the first.
pub(super) fn regular_polygon(sides: usize, columns: usize) -> Result<Vec<ProfilePoint>> {
    let first = |side: usize| side * (columns - 1) / sides;
    let mut points = alloc::with_capacity(columns)?;
    for side in 0..sides {
        let (a, b) = (point_on_unit_circle(side, sides), point_on_unit_circle(side + 1, sides));
        let count = first(side + 1) - first(side);
        points.extend((0..count).map(|k| [0, 1].map(|x| lerp(a[x], b[x], k, count))));
    }
    points.push(point_on_unit_circle(0, sides));
    Ok(points)
}

/// `columns` points of the unit circle. The last point equals the first.
pub(super) fn unit_circle(columns: usize) -> Result<Vec<ProfilePoint>> {
    alloc::collect((0..columns).map(|j| point_on_unit_circle(j, columns - 1)))
}

/// Linear interpolation at k n-ths; exactly `a` for k = 0.
fn lerp(a: f64, b: f64, k: usize, n: usize) -> f64 {
    let t = k as f64 / n as f64;
    a + (b - a) * t
}
