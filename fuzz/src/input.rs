//! Inputs that the targets share: small, on a coarse lattice, so that points coincide and faces
//! touch often.

use arbitrary::{Arbitrary, Result, Unstructured};
use glam::DVec3;
use gusset::attributes::{Domain, Origins};
use gusset::curve::{Curve, CurveView};
use gusset::mesh::{Faces, Mesh, MeshView, Positions, Scalar};
use gusset::net::{Net, Shape, Sides, Topology};
use gusset::surface::{Grid, Nodes, Scheme, Sheet, Surface};
use gusset::{Error, Job};

/// Makes the fields of a structure one after the other, as `derive(Arbitrary)` would. `arbitrary`
/// would enable features of `syn` that the library does not: see tests/interface/features.rs.
macro_rules! in_order {
    ($structure:ident { $($field:ident),+ }) => {
        impl<'a> arbitrary::Arbitrary<'a> for $structure {
            fn arbitrary(u: &mut arbitrary::Unstructured<'a>) -> arbitrary::Result<Self> {
                Ok($structure { $($field: u.arbitrary()?),+ })
            }
        }
    };
}
pub(crate) use in_order;

/// Faces of any kind over points of a lattice: any at all, or tubes and sheets with some of them left out.
#[derive(Debug)]
pub struct Soup {
    points: Vec<[i8; 3]>,
    faces: Vec<Vec<u8>>,
    /// The scale of the unit: a power of two.
    scale: i8,
}

impl<'a> Arbitrary<'a> for Soup {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let [kind, rows, columns, missing, shift, scale] = u.arbitrary::<[u8; 6]>()?;
        let scale = if scale < 224 { 0 } else { scale as i8 };
        if kind.is_multiple_of(4) {
            let points = (0..3 + rows % 20).map(|_| u.arbitrary()).collect::<Result<_>>()?;
            let face = |_| (0..3 + u8::from(missing % 3 == 0)).map(|_| u.arbitrary()).collect();
            let faces = (0..columns % 24).map(face).collect::<Result<_>>()?;
            return Ok(Soup { points, faces, scale });
        }
        let (rows, columns, closed) = (2 + rows % 4, 3 + columns % 6, kind % 4 != 1);
        let mut points = Vec::new();
        for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
            let angle = std::f64::consts::TAU * f64::from(j) / f64::from(columns);
            let [x, y] = if closed { [angle.cos() * 20.0, angle.sin() * 20.0] } else { [8.0 * f64::from(j), 0.0] };
            let off = if kind < 128 { 0 } else { u.arbitrary::<i8>()? / 32 };
            points.push([x as i8 + off, y as i8 - off, 8 * i as i8 + (shift as i8) / 2]);
        }
        let mut faces = Vec::new();
        for (i, j) in (0..rows - 1).flat_map(|i| (0..columns - u8::from(!closed)).map(move |j| (i, j))) {
            let [a, b] = [i * columns + j, i * columns + (j + 1) % columns];
            let quad = [a, b, b + columns, a + columns];
            match (u32::from(missing) >> ((i + j) % 8)) & 1 {
                1 if kind & 64 != 0 => {}
                1 => faces.extend([vec![quad[0], quad[1], quad[2]], vec![quad[0], quad[2], quad[3]]]),
                _ => faces.push(quad.to_vec()),
            }
        }
        Ok(Soup { points, faces, scale })
    }
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
#[derive(Debug)]
pub struct Point {
    near: [i16; 3],
    shift: [i8; 3],
    exponent: i8,
    special: u8,
}

in_order!(Point { near, shift, exponent, special });

/// A number of points; the first byte says how many.
#[derive(Debug)]
pub struct Cloud(Vec<Point>);

impl std::ops::Deref for Cloud {
    type Target = [Point];

    fn deref(&self) -> &[Point] {
        &self.0
    }
}

impl<'a> Arbitrary<'a> for Cloud {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let count = u.arbitrary::<u8>()? % 40;
        Ok(Cloud((0..count).map(|_| u.arbitrary()).collect::<Result<_>>()?))
    }
}

/// Coordinates that are seldom met, by the number of the point that has one.
const SPECIAL: [f64; 8] = [f64::NAN, f64::INFINITY, 1e150, -1e300, 1e-310, -0.0, 1e15, f64::MIN_POSITIVE];

impl Point {
    /// The origin.
    pub fn at(&self) -> DVec3 {
        // Some lie on a line, or in a plane with many others.
        let unit = if self.special.is_multiple_of(4) { 0.0 } else { f64::from(self.exponent / 4).exp2() };
        let usual = [0, 1, 2].map(|k| f64::from(self.shift[k]) + unit * f64::from(self.near[k]) / 32768.0);
        match self.special {
            special @ 248.. => DVec3::new(usual[0], SPECIAL[usize::from(special - 248)], usual[2]),
            240.. => DVec3::ZERO,
            _ => DVec3::from_array(usual),
        }
    }
}

/// All of them, in the plane z = 0.
pub fn flat(points: &[Point]) -> Vec<DVec3> {
    points.iter().map(|point| point.at().with_z(0.0)).collect()
}

/// All of them.
pub fn places(points: &[Point]) -> Vec<DVec3> {
    points.iter().map(Point::at).collect()
}

/// A small net, glued along its sides in any way.
#[derive(Debug)]
pub struct SmallNet {
    size: [u8; 2],
    sides: u8,
    narrow: bool,
    nodes: Cloud,
}

in_order!(SmallNet { size, sides, narrow, nodes });

impl SmallNet {
    /// The net, if there is one of this size.
    pub fn net(&self) -> Option<Net<'static>> {
        let [rows, columns] = self.size.map(|size| 2 + usize::from(size % 14));
        let sides = [Sides::SHEET, Sides::TORUS, Sides::ONE_POLE, Sides::TWO_POLES][usize::from(self.sides % 4)];
        let scalar = if self.narrow { Scalar::F32 } else { Scalar::F64 };
        let topology = Topology::from_sides(Shape::new(rows, columns).ok()?, sides);
        let place = |i: usize, j: usize| match self.nodes.len() {
            0 => DVec3::new(i as f64, j as f64, 0.0),
            count => self.nodes[(i * columns + j) % count].at(),
        };
        Net::from_fn(topology, scalar, place).ok()
    }
}

/// Values decoded from the bytes.
pub fn taken<'a, T: Arbitrary<'a>>(bytes: &'a [u8]) -> Option<T> {
    T::arbitrary_take_rest(Unstructured::new(bytes)).ok()
}

/// A sheet through a few nodes, some of them equal.
#[derive(Debug)]
pub struct SmallSheet {
    size: [u8; 2],
    closed: [bool; 2],
    four: bool,
    nodes: Cloud,
}

in_order!(SmallSheet { size, closed, four, nodes });

impl SmallSheet {
    /// The surface, if there is one.
    pub fn surface(&self) -> Option<Surface<'static>> {
        let [rows, columns] = self.size.map(|size| 2 + usize::from(size % 3));
        if self.nodes.is_empty() {
            return None;
        }
        // Closed directions end where they begin.
        let at = |k: usize, count: usize, closed: bool| if closed && k + 1 == count { 0 } else { k };
        let node = |k: usize| {
            let [i, j] = [at(k / columns, rows, self.closed[0]), at(k % columns, columns, self.closed[1])];
            let shift = DVec3::new(60.0 * i as f64, 60.0 * j as f64, 0.0);
            (self.nodes[(i * columns + j) % self.nodes.len()].at() + shift).to_array()
        };
        let nodes: Vec<f64> = (0..rows * columns).flat_map(node).collect();
        let scheme = if self.four { Scheme::FourPoint } else { Scheme::SixTap };
        let grid = Nodes::strided(nodes, rows, columns, 0, 0).and_then(|nodes| Grid::new(nodes, self.closed, scheme));
        grid.and_then(|grid| Surface::new(vec![Sheet::Grid(grid)], None, &Job::default())).ok()
    }
}

/// A curve of segments of any degree, in the plane z = 0 or in space.
#[derive(Debug)]
pub struct SmallCurve {
    points: Cloud,
    degrees: [u8; 4],
    count: u8,
    closed: bool,
}

in_order!(SmallCurve { points, degrees, count, closed });

impl SmallCurve {
    /// The curve, if there is one.
    pub fn curve(&self, flat: bool) -> Option<Curve> {
        let mut ends = vec![0];
        ends.extend(self.degrees.iter().take(1 + usize::from(self.count % 4)).scan(0, |end, &degree| {
            *end += 1 + u32::from(degree % 5);
            Some(*end)
        }));
        let needed = ends[ends.len() - 1] as usize + 1;
        let all = if flat { self::flat(&self.points) } else { places(&self.points) };
        let mut points: Vec<_> = all.into_iter().cycle().take(needed).collect();
        if points.len() < needed {
            return None;
        }
        if self.closed {
            points[needed - 1] = points[0];
        }
        CurveView::new(&points, &ends, self.closed).and_then(|view| view.to_owned()).ok()
    }
}

/// Looks at a mesh that came out: it is valid, unless nothing is left of it.
///
/// # Panics
/// If it is not.
pub fn expect_valid(mesh: &Mesh, visit: impl FnOnce(&MeshView<'_>)) {
    match mesh.view(&Job::default()) {
        Ok(view) => visit(&view),
        Err(Error::EmptyMesh { .. }) => {}
        Err(error) => panic!("no valid mesh: {error:?}"),
    }
}

/// A row for each element, of sources that there are, with weights of the sum 1.
pub(crate) fn expect_origins(origins: &Origins, mesh: &Mesh) {
    let counts = [mesh.positions.len(), mesh.face_corners.len(), mesh.face_count()];
    for (domain, count) in [Domain::Vertices, Domain::Corners, Domain::Faces].into_iter().zip(counts) {
        let (table, starts) = (origins.table(domain), origins.first_sources_of_inputs(domain));
        assert_eq!((table.len(), starts.len()), (count, origins.inputs().len() + 1));
        for k in 0..count {
            let (sources, weights) = table.row(k);
            assert!(sources.iter().all(|source| Some(source) < starts.last()));
            assert!(weights.iter().all(|&weight| weight > 0.0));
            assert!(sources.is_empty() || (weights.iter().sum::<f64>() - 1.0).abs() < 1e-9);
        }
    }
}
