//! Polygons as triangles.
//!
//! A polygon of `n` corners becomes `n - 2` triangles that use all its corners and no new vertex. A
//! closed mesh therefore stays closed, even where a face is degenerate.
//!
//! - A quad is split by its shorter diagonal, or by the diagonal inside if it is concave.
//! - A larger polygon becomes a fan if its first corner sees all others, as in a convex polygon.
//! - Any other polygon is projected along a coordinate axis and split by [`clip_ears`], which
//!   follows keyholes into holes.
//! - If the triangles overlap because the polygon is warped or crosses itself, a better split is
//!   searched in the projection along the polygon's mean normal. A polygon that crosses itself has
//!   no split without overlaps; its triangles cover the least area twice.

mod ear_clipping;
mod least_overlap;
mod reflex_grid;

pub use ear_clipping::clip_ears;

use super::scale::common_unit;
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use ear_clipping::{is_clearly_convex, longest_squared_side};
use glam::{DVec2, DVec3};
use least_overlap::{MAX_SEARCH_CORNERS, split_with_least_overlap};

/// Largest difference between the sums of unsigned and signed areas, relative to the area, that
/// counts as rounding.
const MAX_RELATIVE_OVERLAP: f64 = 1e-9;
/// The second diagonal of a quad must be shorter by this factor, squared, so that rounding does not
/// choose.
const MIN_SQUARED_GAIN: f64 = 1.0 - 1e-6;

/// Splits a polygon into triangles of its own corners, which replace `triangles`.
///
/// A triangle holds three indices of `points` and keeps the orientation of the polygon. Fewer than
/// three points give no triangle. Points may repeat, lie on a line, or leave a plane. Coordinates
/// that are not finite give some triangles.
///
/// O(n) for a convex polygon; O(n log n), times a bounded number of tests a corner, for any other.
///
/// # Errors
/// [`Error::OutOfMemory`](crate::Error::OutOfMemory), [`Error::Cancelled`](crate::Error::Cancelled).
pub fn triangulate_polygon(points: &[DVec3], triangles: &mut Vec<[u32; 3]>, job: &Job<'_>) -> Result<()> {
    triangles.clear();
    alloc::reserve(triangles, points.len().saturating_sub(2))?;
    match *points {
        [] | [_] | [_, _] => {}
        [_, _, _] => triangles.push([0, 1, 2]),
        [a, b, c, d] if is_split_from_second_corner([a, b, c, d]) => triangles.extend([[1, 2, 3], [1, 3, 0]]),
        [_, _, _, _] => triangles.extend([[0, 1, 2], [0, 2, 3]]),
        _ => split_large_polygon(points, triangles, job)?,
    }
    Ok(())
}

/// Returns whether the diagonal from corner 1 to corner 3 is the better one.
fn is_split_from_second_corner(corners: [DVec3; 4]) -> bool {
    let scale = 1.0 / common_unit(&corners);
    let [a, b, c, d] = corners.map(|corner| corner * scale);
    let (first, second) = (c - a, d - b);
    let normal = first.cross(second);
    let part = |p: DVec3, q: DVec3, r: DVec3| (q - p).cross(r - p).dot(normal);
    let first_part = part(a, b, c).min(part(a, c, d));
    let second_part = part(a, b, d).min(part(b, c, d));
    if first_part > 0.0 && second_part > 0.0 {
        second.length_squared() < first.length_squared() * MIN_SQUARED_GAIN
    } else {
        second_part > first_part
    }
}

fn split_large_polygon(points: &[DVec3], triangles: &mut Vec<[u32; 3]>, job: &Job<'_>) -> Result<()> {
    let scale = 1.0 / common_unit(points);
    let normal = double_area_vector(points, scale);
    let along_axis = axis_projection(normal);
    let project = |k: usize| along_axis(points[k] * scale);
    if is_fan(points.len(), project) {
        triangles.extend((1..points.len() as u32 - 1).map(|k| [0, k, k + 1]));
        return Ok(());
    }
    let flat = alloc::collect((0..points.len()).map(project))?;
    clip_all_ears(points, &flat, triangles, job)?;
    let overlap = relative_overlap(&flat, triangles);
    if overlap > MAX_RELATIVE_OVERLAP {
        let flat = project_along_normal(points, normal, scale)?;
        if points.len() <= MAX_SEARCH_CORNERS {
            return split_with_least_overlap(&flat, triangles);
        }
        let mut others = Vec::new();
        clip_all_ears(points, &flat, &mut others, job)?;
        if relative_overlap(&flat, &others) < overlap {
            *triangles = others;
        }
    }
    Ok(())
}

fn clip_all_ears(points: &[DVec3], flat: &[DVec2], triangles: &mut Vec<[u32; 3]>, job: &Job<'_>) -> Result<()> {
    // Without taken edges, ears are always found.
    if let Some(ears) = clip_ears(points, flat, &|_, _| false, job)? {
        *triangles = ears;
    }
    Ok(())
}

/// Returns whether all triangles at corner 0 run anticlockwise and are not thin.
fn is_fan(count: usize, at: impl Fn(usize) -> DVec2) -> bool {
    let first = at(0);
    let mut before = at(1);
    (2..count).all(|k| {
        let here = at(k);
        let triangle = [first, before, here];
        before = here;
        is_clearly_convex(triangle, longest_squared_side(triangle))
    })
}

/// Returns twice the area vector of a polygon by Newell's formula, summed from its first corner for
/// precision far from the origin.
fn double_area_vector(points: &[DVec3], scale: f64) -> DVec3 {
    let offsets = points.iter().map(|&point| (point - points[0]) * scale);
    offsets.clone().zip(offsets.skip(1)).map(|(here, next)| here.cross(next)).sum()
}

/// Returns the projection that leaves out the coordinate in which the normal is longest. The other
/// coordinates stay exact, and the polygon runs anticlockwise.
fn axis_projection(normal: DVec3) -> impl Fn(DVec3) -> DVec2 {
    let size = normal.abs();
    let axis = if size.x > size.y && size.x > size.z { 0 } else { 1 + usize::from(size.y <= size.z) };
    let (mut u, mut v) = ((axis + 1) % 3, (axis + 2) % 3);
    if normal[axis] < 0.0 {
        std::mem::swap(&mut u, &mut v);
    }
    move |point| DVec2::new(point[u], point[v])
}

/// Projects onto the plane through the first corner that is normal to `normal`. The polygon runs
/// anticlockwise.
fn project_along_normal(points: &[DVec3], normal: DVec3, scale: f64) -> Result<Vec<DVec2>> {
    let unit = normal.try_normalize().unwrap_or(DVec3::Z);
    let x = unit.any_orthonormal_vector();
    let y = unit.cross(x);
    let offsets = points.iter().map(|&point| (point - points[0]) * scale);
    alloc::collect(offsets.map(|offset| DVec2::new(offset.dot(x), offset.dot(y))))
}

/// Returns the area that triangles cover more than once or turn over, relative to their total area.
fn relative_overlap(flat: &[DVec2], triangles: &[[u32; 3]]) -> f64 {
    let (mut signed, mut unsigned) = (0.0, 0.0);
    for triangle in triangles {
        let [a, b, c] = triangle.map(|corner| flat[corner as usize]);
        let area = (b - a).perp_dot(c - a);
        signed += area;
        unsigned += area.abs();
    }
    if unsigned > 0.0 { (unsigned - signed) / unsigned } else { 0.0 }
}

#[cfg(test)]
mod tests;
