//! Inputs that the targets share: small, on a coarse lattice, so that points coincide and faces
//! touch often.

use arbitrary::Arbitrary;
use glam::DVec3;
use gusset::Job;
use gusset::mesh::{Faces, MeshView, Positions, Scalar};
use gusset::net::{Net, Shape, Sides, Topology};

/// Faces of any kind over points of a lattice.
#[derive(Arbitrary, Debug)]
pub struct Soup {
    points: Vec<[i8; 3]>,
    faces: Vec<Vec<u8>>,
    /// Of the unit: a power of two.
    scale: i8,
}

impl Soup {
    /// Calls `visit` with the mesh, if it is one.
    pub fn visit(&self, visit: impl FnOnce(&MeshView<'_>)) {
        if self.points.is_empty() || self.points.len() > 256 {
            return;
        }
        let unit = f64::from(self.scale).exp2();
        let points: Vec<_> = self.points.iter().map(|point| point.map(|x| unit * f64::from(x))).collect();
        let (mut offsets, mut corners) = (vec![0], Vec::new());
        for face in self.faces.iter().filter(|face| face.len() > 2) {
            corners.extend(face.iter().map(|&v| u32::from(v) % points.len() as u32));
            offsets.push(corners.len() as u32);
        }
        let job = Job::default();
        let Ok(faces) = Faces::polygons(&offsets, &corners) else { return };
        if let Ok(mesh) = MeshView::new(Positions::from(&points[..]), faces, &job) {
            visit(&mesh);
        }
    }
}

/// Points, most of them near together.
#[derive(Arbitrary, Debug)]
pub struct Point {
    near: [i16; 3],
    shift: [i8; 3],
    exponent: i8,
}

impl Point {
    /// Where it is.
    pub fn at(&self) -> DVec3 {
        let unit = f64::from(self.exponent / 4).exp2();
        DVec3::from_array([0, 1, 2].map(|k| f64::from(self.shift[k]) + unit * f64::from(self.near[k]) / 32768.0))
    }
}

/// All of them.
pub fn places(points: &[Point]) -> Vec<DVec3> {
    points.iter().map(Point::at).collect()
}

/// A small net, glued along its sides in any way.
#[derive(Arbitrary, Debug)]
pub struct SmallNet {
    size: [u8; 2],
    sides: u8,
    narrow: bool,
    nodes: Vec<Point>,
}

impl SmallNet {
    /// The net, if there is one of this size.
    pub fn net(&self) -> Option<Net<'static>> {
        let [rows, columns] = self.size.map(|size| 2 + usize::from(size % 14));
        let sides = [Sides::SHEET, Sides::TORUS, Sides::ONE_POLE, Sides::TWO_POLES][usize::from(self.sides % 4)];
        let scalar = if self.narrow { Scalar::F32 } else { Scalar::F64 };
        let topology = Topology::of_sides(Shape::new(rows, columns).ok()?, sides);
        let place = |i: usize, j: usize| match self.nodes.len() {
            0 => DVec3::new(i as f64, j as f64, 0.0),
            count => self.nodes[(i * columns + j) % count].at(),
        };
        Net::from_fn(topology, scalar, place).ok()
    }
}
