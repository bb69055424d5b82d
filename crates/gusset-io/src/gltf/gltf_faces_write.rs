//! Faces as triangles, from which polygons can be restored.
//!
//! A polygon is a fan from one of its corners, and the next face begins at another vertex: `FB_ngon_encoding`. A polygon that no fan
//! covers is triangulated otherwise and listed in the primitive's `extras`.

use crate::error::ReadError;
use crate::mesh::Mesh;
use crate::polygons::triangulate_face;
use std::fmt::Write;

/// Triangles of a primitive.
#[derive(Default)]
pub(super) struct Triangles {
    pub(super) indices: Vec<u32>,
    /// Entries of `gusset_polygons` without the outer brackets; empty if there are none.
    pub(super) polygons: String,
    /// First vertex of the last triangle.
    last_first: Option<u32>,
    triangles: Vec<[u32; 3]>,
}

impl Triangles {
    /// Appends a face of at least 3 corners. `corners` are the vertices of the file.
    pub(super) fn push_face(&mut self, mesh: &Mesh, face: usize, corners: &[u32]) -> Result<(), ReadError> {
        self.indices.try_reserve(3 * (corners.len() - 2))?;
        match fan_start(mesh, face, corners, self.last_first) {
            Some(start) => {
                let degree = corners.len();
                let corner = |place: usize| corners[(start + place) % degree];
                for place in 1..degree - 1 {
                    self.indices.extend([corner(0), corner(place), corner(place + 1)]);
                }
                self.last_first = Some(corner(0));
                Ok(())
            }
            None => self.push_and_list_polygon(mesh, face, corners),
        }
    }

    /// Appends a polygon that no fan covers.
    fn push_and_list_polygon(&mut self, mesh: &Mesh, face: usize, corners: &[u32]) -> Result<(), ReadError> {
        let mut triangles = std::mem::take(&mut self.triangles);
        triangulate_face(mesh, face, &mut triangles)?;
        if triangles.is_empty() {
            triangles.extend((1..corners.len() as u32 - 1).map(|place| [0, place, place + 1]));
        }
        let first = self.indices.len() / 3;
        for triangle in &triangles {
            let vertices = triangle.map(|place| corners[place as usize]);
            // Another first vertex than the one before: readers would join the triangles otherwise.
            let turn = (0..3).find(|&turn| Some(vertices[turn]) != self.last_first).unwrap_or(0);
            let vertices: [u32; 3] = std::array::from_fn(|place| vertices[(turn + place) % 3]);
            self.indices.extend(vertices);
            self.last_first = Some(vertices[0]);
        }
        self.polygons.try_reserve(11 * (corners.len() + 3))?;
        if !self.polygons.is_empty() {
            self.polygons.push(',');
        }
        // Writing to a string cannot fail.
        let _ = write!(self.polygons, "[{first},{}", triangles.len());
        for corner in corners {
            let _ = write!(self.polygons, ",{corner}");
        }
        self.polygons.push(']');
        self.triangles = triangles;
        Ok(())
    }
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Longest polygon of which all corners are tried as the start of a fan. Takes quadratic time.
const MAX_TRIED_CORNERS: usize = 64;

/// Least area of a triangle of a fan, relative to the polygon.
const MIN_AREA: f64 = 1e-9;

/// Returns a corner from which a fan covers the polygon, and whose vertex is not `avoided`.
fn fan_start(mesh: &Mesh, face: usize, corners: &[u32], avoided: Option<u32>) -> Option<usize> {
    let allowed = |start: usize| Some(corners[start]) != avoided;
    let degree = corners.len();
    if degree == 3 {
        return (0..3).find(|&start| allowed(start)).or(Some(0));
    }
    let vertices = mesh.face(face);
    let point = |place: usize| mesh.positions.get(vertices[place % degree] as usize);
    let area = |a: usize, b: usize, c: usize| cross(minus(point(b), point(a)), minus(point(c), point(a)));
    let mut whole = [0.0; 3];
    for place in 1..degree - 1 {
        let part = area(0, place, place + 1);
        whole = std::array::from_fn(|axis| whole[axis] + part[axis]);
    }
    // A triangle without area has an edge along several edges of the polygon, which a neighbour may have too.
    let least = MIN_AREA * dot(whole, whole);
    let covers =
        |start: usize| (1..degree - 1).all(|place| dot(area(start, start + place, start + place + 1), whole) >= least);
    let tried = if degree <= MAX_TRIED_CORNERS { degree } else { 2 };
    (0..tried).find(|&start| allowed(start) && covers(start))
}

#[cfg(test)]
mod tests {
    use super::Triangles;
    use crate::mesh::{Mesh, Positions};
    use std::collections::BTreeMap;

    #[test]
    fn a_vertex_on_a_straight_edge_makes_no_common_diagonal() {
        // Two polygons on either side of the edges 0-1 and 1-2, which are on a line.
        let points = vec![
            [0.0, 5.0, 0.0],
            [5.0, 5.0, 0.0],
            [10.0, 5.0, 0.0],
            [0.0, 0.0, 0.0],
            [10.0, 0.0, 0.0],
            [10.0, 9.0, 0.0],
            [0.0, 9.0, 0.0],
        ];
        let corners = vec![2, 1, 0, 3, 4, 0, 1, 2, 5, 6];
        let mesh = Mesh { positions: Positions::F64(points), face_offsets: vec![0, 5, 10], corners, ..Mesh::default() };
        let mut triangles = Triangles::default();
        for face in 0..2 {
            triangles.push_face(&mesh, face, mesh.face(face)).expect("it fits");
        }
        let mut uses = BTreeMap::new();
        for triangle in triangles.indices.as_chunks::<3>().0 {
            for (a, b) in [(0, 1), (1, 2), (2, 0)].map(|(a, b)| (triangle[a], triangle[b])) {
                *uses.entry((a.min(b), a.max(b))).or_insert(0) += 1;
            }
        }
        assert_eq!(triangles.indices.len(), 3 * 6);
        assert_eq!(uses.values().filter(|&&count| count == 1).count(), 6, "{uses:?}");
        assert!(uses.values().all(|&count| count <= 2), "{uses:?}");
    }
}
