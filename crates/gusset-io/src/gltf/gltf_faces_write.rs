//! Faces as triangles, from which polygons can be restored.
//!
//! A polygon is a fan from one of its corners, and the next face begins at another vertex: `FB_ngon_encoding`. A polygon that no fan
//! covers is triangulated otherwise and listed in the primitive's `extras`.

use crate::mesh::Mesh;
use crate::polygons::triangulate_face;
use std::fmt::Write;
use std::io;

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
    pub(super) fn push_face(&mut self, mesh: &Mesh, face: usize, corners: &[u32]) -> io::Result<()> {
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
    fn push_and_list_polygon(&mut self, mesh: &Mesh, face: usize, corners: &[u32]) -> io::Result<()> {
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
    let covers =
        |start: usize| (1..degree - 1).all(|place| dot(area(start, start + place, start + place + 1), whole) >= 0.0);
    let tried = if degree <= MAX_TRIED_CORNERS { degree } else { 2 };
    (0..tried).find(|&start| allowed(start) && covers(start))
}
