//! Polygons as triangles.
//!
//! A face of `n` corners becomes `n - 2` triangles that use all its corners and no new vertex. A closed mesh therefore stays closed,
//! even where a face is degenerate. A quad is split at the shorter diagonal, or at the one inside if the quad is concave. Larger faces
//! are projected along an axis and split by [ear clipping](crate::ear_clipping), which follows keyholes to holes. If triangles of a
//! small face overlap, because it is warped or crosses itself, [`least_overlap`](crate::least_overlap) looks for a better split.

use crate::ear_clipping::clip_ears;
use crate::error::ReadError;
use crate::least_overlap::{MAX_SEARCH_CORNERS, split_with_least_overlap};
use crate::mesh::Mesh;
use gusset_base::alloc;

/// Largest sum of areas of triangles whose signs cancel, relative to the area of the face, that counts as rounding.
const MAX_RELATIVE_OVERLAP: f64 = 1e-9;
/// The second diagonal of a quad must be shorter by this factor, squared, so that rounding does not choose.
const MIN_SQUARED_GAIN: f64 = 1.0 - 1e-6;

/// Splits a face into triangles of its own corners. Returns places of corners in the face, three for each triangle, whose orientation is
/// the face's; nothing for faces of fewer than three corners. Takes time linear in the corners, apart from a factor that is bounded.
pub(crate) fn triangulate_face(mesh: &Mesh, face: usize, triangles: &mut Vec<[u32; 3]>) -> Result<(), ReadError> {
    triangles.clear();
    let vertices = mesh.face(face);
    alloc::reserve(triangles, vertices.len())?;
    match *vertices {
        [] | [_] | [_, _] => {}
        [_, _, _] => triangles.push([0, 1, 2]),
        [a, b, c, d] => {
            let corners = [a, b, c, d].map(|vertex| mesh.positions.get(vertex as usize));
            triangles.extend(if is_split_from_second_corner(&corners) {
                [[1, 2, 3], [1, 3, 0]]
            } else {
                [[0, 1, 2], [0, 2, 3]]
            });
        }
        _ => {
            let points = alloc::collect(vertices.iter().map(|&vertex| mesh.positions.get(vertex as usize)))?;
            split_polygon(&points, triangles)?;
        }
    }
    Ok(())
}

fn split_polygon(points: &[[f64; 3]], triangles: &mut Vec<[u32; 3]>) -> Result<(), ReadError> {
    let normal = newell_normal(points);
    let projected = project_along_axis(points, normal)?;
    clip_ears(&projected, triangles)?;
    if points.len() <= MAX_SEARCH_CORNERS && has_overlap(&projected, triangles) {
        split_with_least_overlap(points, &project_along_normal(points, normal)?, triangles)?;
    }
    Ok(())
}

/// Returns whether the diagonal from corner 1 to corner 3 is the better one.
fn is_split_from_second_corner(corners: &[[f64; 3]; 4]) -> bool {
    let [a, b, c, d] = *corners;
    let (first, second) = (difference(c, a), difference(d, b));
    let normal = cross(first, second);
    let part = |p, q, r| dot(cross(difference(q, p), difference(r, p)), normal);
    let first_part = part(a, b, c).min(part(a, c, d));
    let second_part = part(a, b, d).min(part(b, c, d));
    if first_part > 0.0 && second_part > 0.0 {
        dot(second, second) < dot(first, first) * MIN_SQUARED_GAIN
    } else {
        second_part > first_part
    }
}

/// Returns twice the vector area of a polygon, summed from its first corner for precision far from the origin.
fn newell_normal(points: &[[f64; 3]]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for pair in points[1..].windows(2) {
        let part = cross(difference(pair[0], points[0]), difference(pair[1], points[0]));
        sum = [sum[0] + part[0], sum[1] + part[1], sum[2] + part[2]];
    }
    sum
}

/// Leaves out the coordinate in which the normal is longest. The coordinates that stay are exact, and the polygon runs anticlockwise.
fn project_along_axis(points: &[[f64; 3]], normal: [f64; 3]) -> Result<Vec<[f64; 2]>, ReadError> {
    let axis = (0..3).fold(2, |best, axis| if normal[axis].abs() > normal[best].abs() { axis } else { best });
    let (mut u, mut v) = ((axis + 1) % 3, (axis + 2) % 3);
    if normal[axis] < 0.0 {
        std::mem::swap(&mut u, &mut v);
    }
    Ok(alloc::collect(points.iter().map(|point| [point[u], point[v]]))?)
}

/// Projects onto the plane through the first corner that is normal to `normal`. The polygon runs anticlockwise.
fn project_along_normal(points: &[[f64; 3]], normal: [f64; 3]) -> Result<Vec<[f64; 2]>, ReadError> {
    let unit = unit_vector(normal).unwrap_or([0.0, 0.0, 1.0]);
    let least = (0..3).fold(0, |best, axis| if unit[axis].abs() < unit[best].abs() { axis } else { best });
    let mut axis = [0.0; 3];
    axis[least] = 1.0;
    let u = unit_vector(cross(axis, unit)).unwrap_or([1.0, 0.0, 0.0]);
    let v = cross(unit, u);
    let offsets = points.iter().map(|&point| difference(point, points[0]));
    Ok(alloc::collect(offsets.map(|offset| [dot(offset, u), dot(offset, v)]))?)
}

fn has_overlap(points: &[[f64; 2]], triangles: &[[u32; 3]]) -> bool {
    let (mut signed, mut unsigned) = (0.0, 0.0);
    for triangle in triangles {
        let [a, b, c] = triangle.map(|place| points[place as usize]);
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        signed += area;
        unsigned += area.abs();
    }
    unsigned - signed > MAX_RELATIVE_OVERLAP * unsigned
}

fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit_vector(vector: [f64; 3]) -> Option<[f64; 3]> {
    let length = dot(vector, vector).sqrt();
    (length > 0.0 && length.is_finite()).then(|| vector.map(|part| part / length))
}
