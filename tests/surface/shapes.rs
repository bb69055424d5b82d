//! Surfaces that tests of surfaces share, with the functions that they are made of.

#![allow(dead_code, unreachable_pub, reason = "shared by several tests, none of which needs all of it")]

use glam::DVec3;
use gusset::surface::{Grid, Jet, Nodes, Scheme};
use std::f64::consts::TAU;

/// Numbers from 0 to 1.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn point(&mut self, size: f64) -> DVec3 {
        size * (2.0 * DVec3::new(self.next(), self.next(), self.next()) - 1.0)
    }
}

/// Mean and Gaussian curvature, for the normal S_u x S_v, by the fundamental forms; `None` where the
/// surface is not regular.
pub fn curvatures(jet: &Jet) -> Option<(f64, f64)> {
    let normal = jet.normal().try_normalize()?;
    let [e, f, g] = [jet.u.dot(jet.u), jet.u.dot(jet.v), jet.v.dot(jet.v)];
    let [l, m, n] = [jet.uu.dot(normal), jet.uv.dot(normal), jet.vv.dot(normal)];
    let area = e * g - f * f;
    (area > 0.0).then(|| ((e * n - 2.0 * f * m + g * l) / (2.0 * area), (l * n - m * m) / area))
}

pub struct Shape {
    pub name: &'static str,
    pub cells: [usize; 2],
    pub closed: [bool; 2],
    pub point: fn(f64, f64) -> DVec3,
}

pub fn torus(u: f64, v: f64, bumps: f64) -> DVec3 {
    let (u, v) = (TAU * u, TAU * v);
    let r = 0.4 * (1.0 + bumps * (5.0 * u).sin() * (7.0 * v).cos());
    let ring = 1.0 + r * u.cos();
    DVec3::new(ring * v.cos(), ring * v.sin(), r * u.sin())
}

pub const SHAPES: [Shape; 4] = [
    Shape { name: "torus", cells: [20, 37], closed: [true, true], point: |u, v| torus(u, v, 0.0) },
    Shape { name: "bumpy torus", cells: [31, 53], closed: [true, true], point: |u, v| torus(u, v, 0.15) },
    Shape {
        name: "wavy sheet",
        cells: [40, 52],
        closed: [false, false],
        point: |u, v| DVec3::new(2.0 * u - 1.0, 2.0 * v - 1.0, 0.2 * (9.0 * u).sin() * (7.0 * v + 1.0).cos()),
    },
    Shape {
        name: "sheet with pole",
        cells: [9, 24],
        closed: [false, true],
        point: |u, v| DVec3::new(u * (TAU * v).cos(), u * (TAU * v).sin(), 0.3 * u * u),
    },
];

pub fn grid(shape: &Shape) -> Grid<'static> {
    let [h, w] = shape.cells;
    let at = |k: usize, n: usize, closed: bool| (if closed { k % n } else { k }) as f64 / n as f64;
    let mut data = Vec::new();
    for (i, j) in (0..=h).flat_map(|i| (0..=w).map(move |j| (i, j))) {
        data.extend((shape.point)(at(i, h, shape.closed[0]), at(j, w, shape.closed[1])).to_array());
    }
    let nodes = Nodes::strided(data, h + 1, w + 1, 0, 0).unwrap();
    Grid::new(nodes, shape.closed, Scheme::SixTap).unwrap()
}

/// The port half of Wigley's hull, whose offsets are y = B/2 (1 - 4 x^2 / L^2) (1 - z^2 / T^2):
/// length L = 1, beam B = 1/10, draught T = 1/16; x forward, z up. Rows are stations from stem to
/// stern, columns waterlines from the keel to the water at z = 0, normals outwards. It is of degree
/// 2 in each parameter, so that grids are the hull itself.
pub const WIGLEY: Shape =
    Shape { name: "hull", cells: [40, 12], closed: [false, false], point: |u, v| wigley(0.5 - u, (v - 1.0) / 16.0) };

/// The port side at station x, -1/2 to 1/2, and waterline z, -1/16 to 0.
pub fn wigley(x: f64, z: f64) -> DVec3 {
    DVec3::new(x, 0.05 * (1.0 - 4.0 * x * x) * (1.0 - 256.0 * z * z), z)
}

/// Both sides of the hull, port first, with normals outwards. They meet at keel, stem and stern.
pub fn wigley_hull() -> [Grid<'static>; 2] {
    let starboard = |u: f64, v: f64| wigley(u - 0.5, (v - 1.0) / 16.0) * DVec3::new(1.0, -1.0, 1.0);
    [grid(&WIGLEY), grid(&Shape { point: starboard, ..WIGLEY })]
}

/// Heights at random over a square that is not quite one: surfaces without any regularity.
pub fn rough(cells: [usize; 2], closed: [bool; 2], scheme: Scheme, seed: u64) -> Grid<'static> {
    let [h, w] = cells;
    let mut random = Random(seed);
    let (a, b) = (if closed[0] { h } else { h + 1 }, if closed[1] { w } else { w + 1 });
    let round = |k: usize, n: usize, closed: bool| {
        let t = k as f64 / n as f64;
        if closed { [(TAU * t).cos(), (TAU * t).sin()] } else { [2.0 * t - 1.0, 0.0] }
    };
    let mut nodes = Vec::new();
    for (i, j) in (0..a).flat_map(|i| (0..b).map(move |j| (i, j))) {
        let ([x, z], [y, s]) = (round(i, h, closed[0]), round(j, w, closed[1]));
        let base = match closed {
            [true, true] => DVec3::new((1.0 + 0.4 * x) * y, (1.0 + 0.4 * x) * s, 0.4 * z),
            _ => DVec3::new(x, y, z + s),
        };
        nodes.push(base + random.point(0.6 / h.min(w) as f64));
    }
    let data: Vec<f64> = (0..=h)
        .flat_map(|i| (0..=w).map(move |j| (i, j)))
        .flat_map(|(i, j)| nodes[i % a * b + j % b].to_array())
        .collect();
    Grid::new(Nodes::strided(data, h + 1, w + 1, 0, 0).unwrap(), closed, scheme).unwrap()
}
