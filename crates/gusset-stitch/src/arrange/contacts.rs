//! The common points of two triangles, by the signs of determinants of their corners.

use super::exact_points::{orientation_along, side_of_plane};
use glam::DVec3;

/// A point in which an edge or corner of one triangle meets the other triangle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum ContactPoint {
    /// A given vertex.
    Vertex(u32),
    /// The point in which an edge, from the smaller to the larger vertex, crosses the plane of a
    /// triangle.
    Crossing([u32; 2], u32),
}

/// The common points of two triangles.
#[derive(Default)]
pub(super) struct Contact {
    /// True if the triangles lie in one plane. The points are then not listed.
    pub(super) is_coplanar: bool,
    points: [Option<ContactPoint>; 12],
}

impl Contact {
    pub(super) fn points(&self) -> impl Iterator<Item = ContactPoint> {
        self.points.iter().copied().flatten()
    }

    fn add(&mut self, point: ContactPoint) {
        if let Some(free) = self.points.iter_mut().find(|held| held.is_none_or(|held| held == point)) {
            *free = Some(point);
        }
    }
}

/// Returns an axis along which the projection of the triangle has an area, preferring a large one;
/// `None` for a degenerate triangle.
pub(super) fn projection_axis([a, b, c]: [DVec3; 3]) -> Option<usize> {
    let normal = (b - a).cross(c - a).abs();
    let mut axes = [0, 1, 2];
    axes.sort_by(|&j, &k| normal[k].total_cmp(&normal[j]));
    axes.into_iter().find(|&axis| orientation_along(axis, a, b, c) != 0)
}

/// A triangle with a number, its vertices and their positions.
#[derive(Clone, Copy)]
pub(super) struct TriangleCorners {
    pub(super) triangle: u32,
    pub(super) vertices: [u32; 3],
    pub(super) positions: [DVec3; 3],
}

/// Returns the contact of two triangles that are not degenerate. Equal vertices have equal numbers.
pub(super) fn find_contact(s: &TriangleCorners, t: &TriangleCorners) -> Contact {
    let sides =
        [t.positions.map(|p| side_of_plane(s.positions, p)), s.positions.map(|p| side_of_plane(t.positions, p))];
    let mut made = Contact { is_coplanar: sides[0] == [0; 3], ..Contact::default() };
    if !made.is_coplanar {
        add_points(s, t, sides[0], &mut made);
        add_points(t, s, sides[1], &mut made);
    }
    made
}

/// Adds the points of the border of t on s. `sides` are the sides of s on which the corners of t
/// lie.
fn add_points(s: &TriangleCorners, t: &TriangleCorners, sides: [i32; 3], made: &mut Contact) {
    for i in 0..3 {
        let j = (i + 1) % 3;
        if sides[i] == 0 && (s.vertices.contains(&t.vertices[i]) || is_in_triangle(t.positions[i], s.positions)) {
            made.add(ContactPoint::Vertex(t.vertices[i]));
        }
        if sides[i] * sides[j] < 0 {
            // The line of the edge turns the same way around all edges of s, or meets some.
            let around = [0, 1, 2]
                .map(|k| side_of_plane([t.positions[i], t.positions[j], s.positions[k]], s.positions[(k + 1) % 3]));
            if around.contains(&1) && around.contains(&-1) {
                continue;
            }
            let corner = (0..3).find(|&k| around[k] == 0 && around[(k + 2) % 3] == 0);
            let [p, q] = [t.vertices[i].min(t.vertices[j]), t.vertices[i].max(t.vertices[j])];
            made.add(match corner {
                Some(k) => ContactPoint::Vertex(s.vertices[k]),
                None => ContactPoint::Crossing([p, q], s.triangle),
            });
        }
    }
}

/// Returns true if a point of the triangle's plane lies in the closed triangle.
fn is_in_triangle(p: DVec3, triangle: [DVec3; 3]) -> bool {
    let Some(axis) = projection_axis(triangle) else { return false };
    let turns = [0, 1, 2].map(|k| orientation_along(axis, triangle[k], triangle[(k + 1) % 3], p));
    !(turns.contains(&1) && turns.contains(&-1))
}
