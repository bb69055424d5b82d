//! Nets whose shapes are known, made without the library's own primitives, and an independent
//! random source.
#![allow(dead_code, unreachable_pub, reason = "each test program uses a part")]

use glam::DVec3;
use gusset::mesh::Scalar;
use gusset::net::{Bridge, Coordinates, Direction, Net, Shape, Sides, Topology, XyzMatrices};
use std::f64::consts::{PI, TAU};

/// The sine and cosine of k of n parts of a full turn, with equal bits for k = 0 and k = n.
fn turn(k: usize, n: usize) -> (f64, f64) {
    ((k % n) as f64 * TAU / n as f64).sin_cos()
}

/// True if the cell at (i, j) belongs to the bridge.
pub fn has_cell(bridge: &Bridge, i: usize, j: usize) -> bool {
    let (across, along) = if bridge.direction == Direction::Down { (i, j) } else { (j, i) };
    (bridge.at - bridge.rows - 1..bridge.at).contains(&(across as u32))
        && (bridge.start as usize..bridge.end as usize - 1).contains(&along)
}

/// True if the cell at (i, j) belongs to a hidden bridge.
pub fn is_hidden(net: &Net<'_>, i: usize, j: usize) -> bool {
    net.bridges().iter().any(|bridge| bridge.is_hidden() && has_cell(bridge, i, j))
}

/// True if the cell at (i, j) exists: its four nodes have finite coordinates, and it belongs to no
/// hidden bridge.
pub fn is_present(net: &Net<'_>, i: usize, j: usize) -> bool {
    net.shape().corners_of_cell(i, j).into_iter().all(|node| {
        let (i, j) = net.shape().row_and_column(node);
        net.get(i, j).is_finite()
    }) && !is_hidden(net, i, j)
}

/// A sphere with poles at z = -1 (first row) and z = 1 (last row), its normals outwards.
pub fn sphere(rows: usize, columns: usize, scalar: Scalar) -> Net<'static> {
    let topology = Topology::from_sides(Shape::new(rows, columns).unwrap(), Sides::TWO_POLES);
    Net::from_fn(topology, scalar, |i, j| {
        let (z, radius) = match i {
            0 => (-1.0, 0.0),
            i if i + 1 == rows => (1.0, 0.0),
            i => (-(i as f64 * PI / (rows - 1) as f64).cos(), (i as f64 * PI / (rows - 1) as f64).sin()),
        };
        // Not 0 times a negative cosine at the poles, whose zeros would differ in sign.
        let (sine, cosine) = turn(if radius == 0.0 { 0 } else { j }, columns - 1);
        DVec3::new(radius * cosine, radius * sine, z)
    })
    .unwrap()
}

/// A torus of radii 3 and 1 about the z axis, its normals outwards.
pub fn torus(rows: usize, columns: usize, scalar: Scalar) -> Net<'static> {
    let topology = Topology::from_sides(Shape::new(rows, columns).unwrap(), Sides::TORUS);
    Net::from_fn(topology, scalar, |i, j| {
        let ((tube_sine, tube_cosine), (sine, cosine)) = (turn(i, rows - 1), turn(j, columns - 1));
        let distance = 3.0 + tube_cosine;
        DVec3::new(distance * cosine, distance * sine, tube_sine)
    })
    .unwrap()
}

/// The net before anything is done to it: x is the column, y the row, z is 0.
pub fn sheet(rows: usize, columns: usize, scalar: Scalar) -> Net<'static> {
    let topology = Topology::from_sides(Shape::new(rows, columns).unwrap(), Sides::SHEET);
    Net::from_fn(topology, scalar, |i, j| DVec3::new(j as f64, i as f64, 0.0)).unwrap()
}

/// The same nodes in memory with gaps between the rows.
pub struct Gapped {
    shape: Shape,
    stride: usize,
    matrices: [Vec<f64>; 3],
}

impl Gapped {
    pub const GAP: f64 = 12345.0;

    pub fn from_net(net: &Net<'_>, gap: usize) -> Self {
        let (shape, stride) = (net.shape(), net.shape().columns() + gap);
        let mut matrices = [0, 1, 2].map(|_| vec![Self::GAP; shape.rows() * stride]);
        for i in 0..shape.rows() {
            for j in 0..shape.columns() {
                (0..3).for_each(|axis| matrices[axis][i * stride + j] = net.get(i, j)[axis]);
            }
        }
        Gapped { shape, stride, matrices }
    }

    pub fn net(&mut self, topology: Topology) -> Net<'_> {
        let [x, y, z] = &mut self.matrices;
        let planes = XyzMatrices::borrowed(self.shape, self.stride, [x, y, z]).unwrap();
        Net::new(Coordinates::F64(planes), topology)
    }

    /// True if nothing was written between the rows.
    pub fn gaps_are_whole(&self) -> bool {
        let columns = self.shape.columns();
        let gaps =
            |matrix: &Vec<f64>| matrix.chunks(self.stride).all(|row| row[columns..].iter().all(|&x| x == Self::GAP));
        self.matrices.iter().all(gaps)
    }
}

/// The bits of all coordinates.
pub fn bits(net: &Net<'_>) -> Vec<u64> {
    let shape = net.shape();
    let nodes = (0..shape.rows()).flat_map(|i| (0..shape.columns()).map(move |j| (i, j)));
    nodes.flat_map(|(i, j)| net.get(i, j).to_array().map(f64::to_bits)).collect()
}

/// True if nodes of one class have equal bits.
pub fn glued_bits_agree(net: &Net<'_>) -> bool {
    let (shape, bits) = (net.shape(), bits(net));
    let classes = gusset::net::NodeClasses::new(net.topology()).unwrap();
    (0..shape.node_count() as u32).all(|node| {
        let (a, b) = (3 * node as usize, 3 * classes.representative(node) as usize);
        bits[a..a + 3] == bits[b..b + 3]
    })
}

/// Numbers from -1 to 1 (xorshift).
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    pub fn vector(&mut self) -> DVec3 {
        DVec3::new(self.next(), self.next(), self.next())
    }
}
