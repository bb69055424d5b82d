//! The nearest point against brute force, and the lower bounds that are returned.

mod surfaces;

use glam::DVec3;
use gusset::Job;
use gusset::carcass::{Carcass, Grid, Sheet};
use surfaces::{Random, SHAPES, grid};

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
