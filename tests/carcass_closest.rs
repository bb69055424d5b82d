//! The nearest point against brute force, and the lower bounds that are returned.

use glam::DVec3;
use gusset::Job;
use gusset::carcass::{Carcass, Grid, Nodes, Scheme, Sheet};
use std::f64::consts::TAU;

/// Numbers from 0 to 1.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn point(&mut self, size: f64) -> DVec3 {
        size * (2.0 * DVec3::new(self.next(), self.next(), self.next()) - 1.0)
    }
}

struct Shape {
    name: &'static str,
    cells: [usize; 2],
    closed: [bool; 2],
    point: fn(f64, f64) -> DVec3,
}

fn torus(u: f64, v: f64, bumps: f64) -> DVec3 {
    let (u, v) = (TAU * u, TAU * v);
    let r = 0.4 * (1.0 + bumps * (5.0 * u).sin() * (7.0 * v).cos());
    let ring = 1.0 + r * u.cos();
    DVec3::new(ring * v.cos(), ring * v.sin(), r * u.sin())
}

const SHAPES: [Shape; 4] = [
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

fn grid(shape: &Shape) -> Grid<'static> {
    let [h, w] = shape.cells;
    let at = |k: usize, n: usize, closed: bool| (if closed { k % n } else { k }) as f64 / n as f64;
    let mut data = Vec::new();
    for (i, j) in (0..=h).flat_map(|i| (0..=w).map(move |j| (i, j))) {
        data.extend((shape.point)(at(i, h, shape.closed[0]), at(j, w, shape.closed[1])).to_array());
    }
    let nodes = Nodes::strided(data, h + 1, w + 1, 0, 0).unwrap();
    Grid::new(nodes, shape.closed, Scheme::SixTap).unwrap()
}

/// The smallest distance of many points of every cell, each improved by steps of alternating search: an upper bound, near the truth.
fn by_force(grid: &Grid<'_>, query: DVec3) -> f64 {
    let [h, w] = grid.cells();
    let mut best = f64::INFINITY;
    for (i, j) in (0..h).flat_map(|i| (0..w).map(move |j| (i, j))) {
        let patch = grid.patch(i, j);
        let distance = |u: f64, v: f64| patch.point(u, v).distance(query);
        let places = (0..25).map(|k| (f64::from(k / 5) / 4.0, f64::from(k % 5) / 4.0));
        let (mut u, mut v) = places.min_by(|a, b| distance(a.0, a.1).total_cmp(&distance(b.0, b.1))).unwrap();
        let mut value = distance(u, v);
        if value > best + 0.2 {
            continue;
        }
        let mut step = 0.25;
        while step > 1e-9 {
            let around = [
                (step, 0.0),
                (-step, 0.0),
                (0.0, step),
                (0.0, -step),
                (step, step),
                (-step, -step),
                (step, -step),
                (-step, step),
            ];
            let tries = around.map(|(x, y)| ((u + x).clamp(0.0, 1.0), (v + y).clamp(0.0, 1.0)));
            match tries.into_iter().find(|&(x, y)| distance(x, y) < value) {
                Some((x, y)) => (u, v, value) = (x, y, distance(x, y)),
                None => step *= 0.5,
            }
        }
        best = best.min(value);
    }
    best
}

#[test]
fn nearest_points_by_force() {
    for shape in &SHAPES {
        let grid = grid(shape);
        let carcass = Carcass::new(vec![Sheet::Grid(grid.clone())], None, &Job::default()).unwrap();
        let mut random = Random(7);
        for k in 0..60 {
            let query = match k % 3 {
                // Anywhere, far away, and close to the surface.
                0 => random.point(1.5),
                1 => random.point(20.0),
                _ => (shape.point)(random.next(), random.next()) + random.point(0.02),
            };
            let found = carcass.closest(query, f64::INFINITY).unwrap();
            let truth = by_force(&grid, query);
            assert!(found.distance <= truth + 1e-9, "{}: {query} {found:?} {truth}", shape.name);
            // Lower bounds hold but for the rounding of distances.
            assert!(
                found.bound <= truth + 1e-14 * (1.0 + query.length()) && found.bound <= found.distance,
                "{}: {query} {found:?} {truth}",
                shape.name
            );
            assert!(found.bound >= found.distance - 1e-8, "{}: no proof: {query} {found:?}", shape.name);
            assert_eq!(carcass.jet(found.place).point.distance(query), found.distance);
        }
    }
}
