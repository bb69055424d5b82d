//! Random nets and nets by formula, with independently known properties, for the tests of nets.
#![allow(dead_code, unreachable_pub, reason = "each test file uses its own part")]

use crate::space::is_hidden;
use glam::DVec3;
use gusset::mesh::Scalar;
use gusset::net::topology::{ContractedLinks, LinkMatrix, ReducedCell, SeamRun};
use gusset::net::{Net, NodeClasses, Seam, Shape, Sides, Topology};
use gusset::{Error, Job};
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::{PI, TAU};

pub fn shape(h: usize, w: usize) -> Shape {
    Shape::new(h, w).unwrap()
}

pub fn job() -> Job<'static> {
    Job::default()
}

/// A sphere whose glued nodes are the same, bit for bit, counter-clockwise seen from outside.
pub fn sphere(h: usize, w: usize, scalar: Scalar, centre: DVec3) -> Net<'static> {
    let topology = Topology::from_sides(shape(h, w), Sides::TWO_POLES);
    Net::from_fn(topology, scalar, |i, j| {
        let (latitude, longitude) =
            (PI * i as f64 / (h - 1) as f64 - PI / 2.0, TAU * (j % (w - 1)) as f64 / (w - 1) as f64);
        let radius = if i == 0 || i + 1 == h { 0.0 } else { latitude.cos() };
        centre + DVec3::new(radius * longitude.cos(), radius * longitude.sin(), latitude.sin())
    })
    .unwrap()
}

/// A torus, likewise.
pub fn torus(h: usize, w: usize, scalar: Scalar, centre: DVec3) -> Net<'static> {
    let topology = Topology::from_sides(shape(h, w), Sides::TORUS);
    Net::from_fn(topology, scalar, |i, j| {
        let (u, v) = (TAU * (j % (w - 1)) as f64 / (w - 1) as f64, TAU * (i % (h - 1)) as f64 / (h - 1) as f64);
        let radius = 2.0 + v.cos();
        centre + DVec3::new(radius * u.cos(), radius * u.sin(), v.sin())
    })
    .unwrap()
}

/// A net whose nodes all differ, of whatever topology.
pub fn numbered(topology: Topology, scalar: Scalar) -> Net<'static> {
    Net::from_fn(topology, scalar, |i, j| {
        let n = (i * 1000 + j) as f64;
        if (i * 7 + j * 3) % 11 == 5 { DVec3::new(n, f64::NAN, 0.25 * n) } else { DVec3::new(n, -n, 0.5 * n) }
    })
    .unwrap()
}

/// The coordinates' bits and all the rest.
pub fn same(a: &Net<'_>, b: &Net<'_>) -> bool {
    let bits = |net: &Net<'_>| {
        let (h, w) = (net.shape().rows(), net.shape().columns());
        let nodes = (0..h * w).flat_map(move |n| net.get(n / w, n % w).to_array().map(f64::to_bits));
        nodes.collect::<Vec<_>>()
    };
    a.coordinates().scalar() == b.coordinates().scalar()
        && a.topology() == b.topology()
        && a.bridges() == b.bridges()
        && bits(a) == bits(b)
}

/// The surface that is left of a net's cells when classes are points: polygons of classes, each
/// with its first cell, and the edges that no polygon has.
pub struct Surface {
    pub polygons: Vec<Vec<u32>>,
    pub wires: BTreeSet<[u32; 2]>,
    pub classes: Vec<u32>,
}

impl Surface {
    pub fn from_net(net: &Net<'_>) -> Surface {
        let classes = NodeClasses::new(net.topology()).unwrap();
        let (mut polygons, mut edges) = (Vec::new(), BTreeSet::new());
        let mut edge = |a: u32, b: u32| edges.insert([a.min(b), a.max(b)]);
        let (h, w) = (net.shape().rows(), net.shape().columns());
        for (i, j) in (0..h - 1).flat_map(|i| (0..w - 1).map(move |j| (i, j))) {
            if is_hidden(net, i, j) {
                continue;
            }
            match ReducedCell::new(classes.representatives_of_corners(i, j)) {
                ReducedCell::Digon([a, b]) => drop(edge(a, b)),
                ReducedCell::Fold([a, b, d]) => drop((edge(a, b), edge(a, d))),
                reduced => polygons.extend(reduced.polygon().map(<[u32]>::to_vec)),
            }
        }
        let used: BTreeSet<[u32; 2]> =
            polygons.iter().flat_map(|p| sides(p)).map(|[a, b]| [a.min(b), a.max(b)]).collect();
        let wires = edges.difference(&used).copied().collect();
        Surface { polygons, wires, classes: classes.representatives().unwrap() }
    }

    /// Vertices, edges and faces of the complex.
    pub fn counts(&self) -> [usize; 3] {
        let mut edges: BTreeSet<[u32; 2]> = self.wires.clone();
        edges.extend(self.polygons.iter().flat_map(|p| sides(p)).map(|[a, b]| [a.min(b), a.max(b)]));
        let vertices: BTreeSet<u32> = self.classes.iter().copied().collect();
        [vertices.len(), edges.len(), self.polygons.len()]
    }

    pub fn euler(&self) -> i64 {
        let [v, e, f] = self.counts();
        v as i64 - e as i64 + f as i64
    }

    /// The number of edges by their number of faces.
    pub fn edge_faces(&self) -> BTreeMap<usize, usize> {
        let mut faces: BTreeMap<[u32; 2], usize> = self.wires.iter().map(|&wire| (wire, 0)).collect();
        for [a, b] in self.polygons.iter().flat_map(|p| sides(p)) {
            *faces.entry([a.min(b), a.max(b)]).or_default() += 1;
        }
        let mut counts = BTreeMap::new();
        faces.into_values().for_each(|n| *counts.entry(n).or_default() += 1);
        counts
    }

    /// The volume enclosed, by the divergence theorem over fans of triangles.
    pub fn volume(&self, net: &Net<'_>) -> f64 {
        let at = |class: u32| {
            let (i, j) = net.shape().row_and_column(class);
            net.get(i, j)
        };
        let fan =
            |p: &Vec<u32>| (1..p.len() - 1).map(|k| at(p[0]).dot(at(p[k]).cross(at(p[k + 1])))).sum::<f64>() / 6.0;
        self.polygons.iter().map(fan).sum::<f64>() * if net.topology().is_reversed() { -1.0 } else { 1.0 }
    }
}

fn sides(polygon: &[u32]) -> impl Iterator<Item = [u32; 2]> + '_ {
    (0..polygon.len()).map(|k| [polygon[k], polygon[(k + 1) % polygon.len()]])
}

/// Sides at random.
pub fn any_sides() -> impl Strategy<Value = Sides> {
    prop::array::uniform6(any::<bool>()).prop_map(|[a, b, c, d, e, f]| Sides {
        rows_closed: a,
        columns_closed: b,
        pole_top: c,
        pole_bottom: d,
        pole_left: e,
        pole_right: f,
    })
}

/// A topology at random: sides, or a matrix of few ones besides, and a seam or two.
pub fn any_topology(rows: std::ops::Range<usize>, columns: std::ops::Range<usize>) -> impl Strategy<Value = Topology> {
    let seams = prop::collection::vec(any::<[u16; 8]>(), 0..3);
    let links = prop::collection::vec(any::<u16>(), 0..4);
    (rows, columns, any_sides(), links, seams, any::<bool>(), any::<bool>()).prop_filter_map(
        "a gluing that crosses",
        |(h, w, sides, links, seams, plain, reversed)| {
            let shape = shape(h, w);
            if plain {
                return Some(Topology::from_sides(shape, sides).with_reversed(reversed));
            }
            let mut matrix = LinkMatrix::from_sides(shape, sides).unwrap();
            links.iter().for_each(|&link| matrix.set_contracted(u32::from(link) % (2 * h * w) as u32, true));
            let seams: Vec<Seam> = seams.iter().filter_map(|&numbers| seam(shape, numbers)).collect();
            let made = Topology::new(shape, ContractedLinks::Matrix(matrix), &seams);
            match made {
                Ok(topology) => Some(topology.with_reversed(reversed)),
                Err(Error::CrossingCell { .. }) => None,
                Err(error) => panic!("{error}"),
            }
        },
    )
}

/// A seam from numbers, if they fit.
fn seam(shape: Shape, n: [u16; 8]) -> Option<Seam> {
    let (h, w) = (shape.rows() as i32, shape.columns() as i32);
    let step = |n: u16| [(0, 1), (1, 0), (0, -1), (-1, 0), (1, 1), (2, 0)][n as usize % 6];
    let run = |row: u16, column: u16, steps: u16| {
        let (row_step, column_step) = step(steps);
        SeamRun { row: u32::from(row) % h as u32, column: u32::from(column) % w as u32, row_step, column_step }
    };
    let (a, b) = (run(n[0], n[1], n[2]), run(n[3], n[4], n[5]));
    let reach = |run: SeamRun| {
        let room = |at: u32, step: i32, count: i32| match step {
            0 => i32::MAX,
            s if s > 0 => (count - 1 - at as i32) / s + 1,
            s => at as i32 / -s + 1,
        };
        room(run.row, run.row_step, h).min(room(run.column, run.column_step, w))
    };
    let count = 1 + i32::from(n[6]) % reach(a).min(reach(b));
    Some(Seam { a, b, count: count as u32 }).filter(|_| !n[7].is_multiple_of(3))
}
