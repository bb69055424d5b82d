//! The nearest point against brute force, and the lower bounds that are returned.

use crate::common::Silent;
use crate::shapes::{Random, SHAPES, Shape, grid};
use glam::DVec3;
use gusset::surface::construct::{Spline, SplineAxis, SplineOptions};
use gusset::surface::{Grid, Nodes, Patches, Scheme, Sheet, Surface};
use gusset::{Element, Error, Job};
use gusset_oracles::descent::least_value;

/// The smallest distance of many points of every cell, each improved by steps of alternating
/// search: an upper bound, near the truth.
fn by_force(grid: &Grid<'_>, query: DVec3) -> f64 {
    let [h, w] = grid.cells();
    let mut best = f64::INFINITY;
    for (i, j) in (0..h).flat_map(|i| (0..w).map(move |j| (i, j))) {
        let patch = grid.patch(i, j);
        let lowest = least_value(&|u, v| patch.point(u, v).distance(query), best + 0.2);
        best = best.min(lowest.unwrap_or(f64::INFINITY));
    }
    best
}

#[test]
fn nearest_points_by_force() {
    for shape in &SHAPES {
        let grid = grid(shape);
        let surface = Surface::new(vec![Sheet::Grid(grid.clone())], None, &Job::default()).unwrap();
        let mut random = Random(7);
        for k in 0..60 {
            let query = match k % 3 {
                // Anywhere, far away, and close to the surface.
                0 => random.point(1.5),
                1 => random.point(20.0),
                _ => (shape.point)(random.next(), random.next()) + random.point(0.02),
            };
            let found = surface.closest(query, f64::INFINITY).unwrap();
            let truth = by_force(&grid, query);
            assert!(found.distance <= truth + 1e-9, "{}: {query} {found:?} {truth}", shape.name);
            // Lower bounds hold within the rounding of distances.
            assert!(
                found.bound <= truth + 1e-14 * (1.0 + query.length()) && found.bound <= found.distance,
                "{}: {query} {found:?} {truth}",
                shape.name
            );
            assert!(found.bound >= found.distance - 1e-8, "{}: no proof: {query} {found:?}", shape.name);
            assert_eq!(surface.jet(found.place).point.distance(query), found.distance);
        }
    }
}

#[test]
fn answers_depend_on_nothing_but_the_query() {
    for shape in &SHAPES {
        let surface = Surface::new(vec![Sheet::Grid(grid(shape))], None, &Job::default()).unwrap();
        let mut random = Random(31);
        let node = |random: &mut Random| {
            surface.sheet(0).corner((9.0 * random.next()) as usize, (9.0 * random.next()) as usize)
        };
        // Some as near to several cells: at nodes, above them, on the axis.
        let queries: Vec<DVec3> = (0..500)
            .map(|k| match k % 25 {
                0..=6 => random.point(1.5),
                7..=12 => random.point(30.0),
                13..=18 => node(&mut random),
                19..=23 => node(&mut random) + 0.25 * DVec3::Z,
                _ => DVec3::new(0.0, 0.0, random.next()),
            })
            .collect();
        let alone: Vec<_> = queries.iter().map(|&query| surface.closest(query, f64::INFINITY)).collect();
        for threads in [1, 2, 5] {
            let job = Job::new(threads, &Silent);
            assert_eq!(surface.closest_all(&queries, f64::INFINITY, &job).unwrap(), alone);
        }
        let turned: Vec<DVec3> = queries.iter().rev().copied().collect();
        let mut found = surface.closest_all(&turned, f64::INFINITY, &Job::default()).unwrap();
        found.reverse();
        assert_eq!(found, alone);
        // Answers within the limit equal answers without it; omitted answers are beyond.
        let limited = surface.closest_all(&queries, 0.3, &Job::default()).unwrap();
        for (limited, alone) in limited.iter().zip(alone.iter().flatten()) {
            match limited {
                Some(found) => assert!(found.distance <= 0.3 && found.distance <= alone.distance + surface.tolerance()),
                None => assert!(alone.bound > 0.3 - 1e-12 || !alone.proven),
            }
        }
    }
}

/// The unit sphere with poles, scaled and moved.
fn sphere(cells: usize, size: f64, at: DVec3) -> Surface<'static> {
    let angle = |k: usize, n: usize| (k % n) as f64 / n as f64 * std::f64::consts::TAU;
    let mut data = Vec::new();
    for (i, j) in (0..=cells).flat_map(|i| (0..=2 * cells).map(move |j| (i, j))) {
        let (polar, around) = (angle(i, 2 * cells), angle(j, 2 * cells));
        let ring = if i % cells == 0 { 0.0 } else { polar.sin() };
        let point = DVec3::new(ring * around.cos(), ring * around.sin(), polar.cos());
        data.extend((at + size * point).to_array());
    }
    let nodes = Nodes::strided(data, cells + 1, 2 * cells + 1, 0, 0).unwrap();
    let grid = Grid::new(nodes, [false, true], Scheme::SixTap).unwrap();
    Surface::new(vec![Sheet::Grid(grid)], None, &Job::default()).unwrap()
}

#[test]
fn the_centre_of_a_sphere_has_a_tight_bound() {
    for cells in [8, 100] {
        let surface = sphere(cells, 1.0, DVec3::ZERO);
        let found = surface.closest(DVec3::ZERO, f64::INFINITY).unwrap();
        assert!((found.distance - 1.0).abs() < 0.01 && found.bound <= found.distance, "{found:?}");
        assert!(found.bound >= (1.0 - 1e-3) * found.distance, "{found:?}");
        // The surface through the nodes is not a sphere: if one of its cells is nearest, the answer
        // is proven; otherwise it is reported as ambiguous.
        assert!(found.proven || found.bound < found.distance - surface.tolerance());
        let minima = surface.local_minima(DVec3::ZERO, f64::INFINITY, 3, &Job::default()).unwrap();
        assert!(minima.points.len() <= 3 && !minima.points.is_empty());
    }
}

#[test]
fn near_a_centre_the_answer_is_still_the_nearest() {
    // All of the sphere is nearly as near, and no search can prove much: but it goes where the
    // surface is nearest.
    let surface = sphere(500, 1.0, DVec3::ZERO);
    let mut random = Random(11);
    for off in [1e-4, 1e-3, 1e-2, 1e-1] {
        for _ in 0..4 {
            let query = off * random.point(1.0).normalize();
            let found = surface.closest(query, f64::INFINITY).unwrap();
            assert!(found.distance < 1.0 - off + 1e-3 * off + 2e-7, "{off}: {found:?}");
            assert!(found.bound >= (1.0 - 1e-3) * found.distance && found.bound <= 1.0 - off + 1e-9, "{found:?}");
        }
    }
}

#[test]
fn queries_from_afar_are_proved() {
    // Above the crests of waves, many cells are nearly as near before the nearest is known.
    let waves = Shape {
        name: "waves",
        cells: [400, 400],
        closed: [false, false],
        point: |u, v| {
            let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
            DVec3::new(x, y, 0.2 * (5.0 * x).sin() * (4.0 * y).cos())
        },
    };
    let surface = Surface::new(vec![Sheet::Grid(grid(&waves))], None, &Job::default()).unwrap();
    let mut random = Random(5);
    for k in 0..40_000 {
        let query = match k % 2 {
            0 => (1.2 + 4.0 * random.next()) * random.point(1.0).normalize(),
            _ => random.point(1.0) * DVec3::new(1.7, 1.7, 0.35),
        };
        let found = surface.closest(query, f64::INFINITY).unwrap();
        assert!(found.proven, "{query:?} {found:?}");
    }
}

/// One patch of degree 3 a cell, with the control points of a grid's.
fn patches(grid: &Grid<'_>) -> Sheet<'static> {
    let [h, w] = grid.cells();
    let all = (0..h).flat_map(|i| (0..w).map(move |j| (i, j)));
    let points: Vec<DVec3> = all.flat_map(|(i, j)| grid.patch(i, j).points.into_iter().flatten()).collect();
    Sheet::Cubic(Patches::new(&points, [3, 3], h, w).unwrap())
}

/// A B-spline surface of degree 5 by degree 2 that waves.
fn spline() -> Sheet<'static> {
    let [rows, columns] = [14_usize, 11];
    let at = |k: usize, n: usize| 2.0 * k as f64 / (n - 1) as f64 - 1.0;
    let all = (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j)));
    let points: Vec<DVec3> = all
        .map(|(i, j)| {
            let (x, y) = (at(i, rows), at(j, columns));
            DVec3::new(x, y, 0.4 * (4.0 * x).sin() * (3.0 * y + 1.0).cos())
        })
        .collect();
    let knots = |count: usize, degree: usize| -> Vec<f64> {
        (0..=count + degree).map(|k| k.clamp(degree, count) as f64).collect()
    };
    let [u, v] = [knots(rows, 5), knots(columns, 2)];
    let axes = [(5, &u), (2, &v)].map(|(degree, knots)| SplineAxis { degree, knots, closed: false });
    Sheet::from_spline(
        &Spline { points: &points, weights: None, counts: [rows, columns], axes },
        &SplineOptions::default(),
        &Job::default(),
    )
    .unwrap()
}

#[test]
fn a_query_on_the_surface_finds_itself() {
    let mut sheets: Vec<(&str, Sheet<'static>)> = vec![("spline", spline())];
    for shape in &SHAPES {
        sheets.push((shape.name, Sheet::Grid(grid(shape))));
        sheets.push((shape.name, patches(&grid(shape))));
    }
    for (name, sheet) in sheets {
        let [h, w] = sheet.cells();
        let surface = Surface::new(vec![sheet], None, &Job::default()).unwrap();
        let sheet = surface.sheet(0);
        for (i, j) in (0..=h).flat_map(|i| (0..=w).map(move |j| (i, j))) {
            let corner = sheet.corner(i, j);
            let found = surface.closest(corner, f64::INFINITY).unwrap();
            assert!(found.distance <= 1e-14 && found.proven, "{name}: {i} {j} {found:?}");
            // As a limit leaves it.
            let found = surface.closest(corner, 1e-14).unwrap();
            assert!(found.distance <= 1e-14 && found.proven, "{name}: {i} {j} {found:?}");
        }
        let mut random = Random(17);
        for _ in 0..500 {
            let (i, j) = ((random.next() * h as f64) as usize, (random.next() * w as f64) as usize);
            let (u, v) = (random.next(), random.next());
            let point = sheet.jet(i, j, u, v).point;
            let found = surface.closest(point, f64::INFINITY).unwrap();
            assert!(found.distance <= surface.tolerance() && found.proven, "{name}: {i} {j} {found:?}");
        }
    }
}

#[test]
fn two_places_as_near_are_said_to_be_many() {
    // Two plane sheets, the query between them.
    let plane = |z: f64| {
        let data: Vec<f64> = (0..25).flat_map(|k| [f64::from(k / 5), f64::from(k % 5), z]).collect();
        Sheet::Grid(Grid::new(Nodes::strided(data, 5, 5, 0, 0).unwrap(), [false; 2], Scheme::SixTap).unwrap())
    };
    let surface = Surface::new(vec![plane(1.0), plane(-1.0)], None, &Job::default()).unwrap();
    let found = surface.closest(DVec3::new(1.3, 2.6, 0.0), f64::INFINITY).unwrap();
    assert!(found.proven && found.is_ambiguous && found.place.sheet == 0, "{found:?}");
    assert_eq!(found.normal.abs(), DVec3::Z);
    let found = surface.closest(DVec3::new(1.3, 2.6, -0.1), f64::INFINITY).unwrap();
    assert!(found.proven && !found.is_ambiguous && found.place.sheet == 1, "{found:?}");
    let minima = surface.local_minima(DVec3::new(1.3, 2.6, -0.1), f64::INFINITY, 0, &Job::default()).unwrap();
    assert_eq!(minima.points.len(), 2, "{minima:?}");
    assert!((minima.points[1].distance - 1.1).abs() < 1e-12);
}

#[test]
fn any_size_anywhere() {
    let mut random = Random(3);
    let directions: Vec<DVec3> = (0..200).map(|_| random.point(1.0).normalize()).collect();
    for (size, at) in [(1e-9, 0.0), (1.0, 1e6), (1e9, 0.0), (1.0, 0.0), (1e-12, 0.0), (1e12, 1e12)] {
        let at = DVec3::splat(at);
        let surface = sphere(40, size, at);
        for &direction in &directions {
            for far in [0.5, 1.5, 1e3] {
                let query = at + far * size * direction;
                let found = surface.closest(query, f64::INFINITY).unwrap();
                let rounding = 1e-14 * query.abs().max_element();
                let error = (found.distance - (far - 1.0).abs() * size).abs();
                assert!(error < 1e-4 * size + rounding, "{size} {at} {far}: {found:?}");
                assert!(found.proven, "{size} {at} {far} {direction}: {found:?}");
                assert!((found.normal.dot(direction).abs() - 1.0).abs() < 0.02, "{size} {at} {far}: {found:?}");
            }
        }
    }
}

#[test]
fn squares_below_the_normal_range() {
    // In single precision the squares of these distances have no more than a few bits, or none.
    let grid_of = |unit: f64| {
        let shape = &SHAPES[0];
        let [h, w] = shape.cells;
        let nodes = (0..=h).flat_map(|i| (0..=w).map(move |j| [i % h, j % w]));
        let point = |[i, j]: [usize; 2]| unit * (shape.point)(i as f64 / h as f64, j as f64 / w as f64);
        let data: Vec<f64> = nodes.flat_map(|node| point(node).to_array()).collect();
        Grid::new(Nodes::strided(data, h + 1, w + 1, 0, 0).unwrap(), [true; 2], Scheme::SixTap).unwrap()
    };
    let surface_of = |unit: f64| Surface::new(vec![Sheet::Grid(grid_of(unit))], None, &Job::default()).unwrap();
    let whole = surface_of(1.0);
    for exponent in 66..80 {
        // A power of two: nothing else is rounded.
        let unit = 2f64.powi(-exponent);
        let surface = surface_of(unit);
        let mut random = Random(3);
        for _ in 0..40 {
            let query = random.point(1.5);
            let expected = whole.closest(query, f64::INFINITY).unwrap().distance;
            let found = surface.closest(unit * query, f64::INFINITY).unwrap();
            assert!((found.distance / unit - expected).abs() < 1e-8, "{exponent}: {query} {expected} {found:?}");
            assert!(found.bound <= found.distance && found.proven, "{exponent}: {found:?}");
        }
    }
}

#[test]
fn questions_that_are_none() {
    let surface = Surface::new(vec![Sheet::Grid(grid(&SHAPES[2]))], None, &Job::default()).unwrap();
    let job = Job::default();
    let queries = [DVec3::ZERO, DVec3::new(0.0, f64::NAN, 0.0)];
    assert!(matches!(
        surface.closest_all(&queries, 1.0, &job),
        Err(Error::NotFinite { element: Element::Query, index: 1, value, .. }) if value.is_nan()
    ));
    assert!(surface.closest_all(&queries[..1], -1.0, &job).is_err());
    assert!(surface.closest_all(&queries[..1], f64::NAN, &job).is_err());
    assert_eq!(surface.closest(queries[1], 1.0), None);
    assert!(surface.closest_all(&[], 1.0, &job).unwrap().is_empty());
    // As far as numbers go.
    for query in [DVec3::splat(1e150), DVec3::splat(-1e20), DVec3::splat(f64::MAX)] {
        let found = surface.closest(query, f64::INFINITY);
        assert!(found.is_none_or(|found| found.bound <= found.distance), "{found:?}");
    }
}
