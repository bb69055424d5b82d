//! Places of locally least distance, and regions of cells, against brute force.

use crate::shapes::{Random, SHAPES, grid};
use glam::DVec3;
use gusset::surface::{Grid, Nodes, Scheme, Sheet, Surface};
use gusset::{Element, Error, Job};

fn surface(grid: &Grid<'static>) -> Surface<'static> {
    Surface::new(vec![Sheet::Grid(grid.clone())], None, &Job::default()).unwrap()
}

/// The results of alternating search from all local minima of a lattice on the surface.
fn by_force(grid: &Grid<'_>, closed: [bool; 2], query: DVec3) -> Vec<f64> {
    let [h, w] = grid.cells();
    let fine = 8;
    let (rows, columns) = (h * fine, w * fine);
    let wrap = |x: f64, n: usize, closed: bool| if closed { x.rem_euclid(n as f64) } else { x.clamp(0.0, n as f64) };
    let distance = |u: f64, v: f64| {
        let (u, v) = (wrap(u, h, closed[0]), wrap(v, w, closed[1]));
        let (i, j) = ((u as usize).min(h - 1), (v as usize).min(w - 1));
        grid.patch(i, j).point(u - i as f64, v - j as f64).distance(query)
    };
    let values: Vec<f64> = (0..=rows)
        .flat_map(|r| (0..=columns).map(move |c| (r, c)))
        .map(|(r, c)| distance(r as f64 / fine as f64, c as f64 / fine as f64))
        .collect();
    let value = |r: isize, c: isize| {
        let place = |k: isize, n: usize, closed: bool| {
            if closed {
                Some(k.rem_euclid(n as isize) as usize)
            } else {
                (0..=n as isize).contains(&k).then_some(k as usize)
            }
        };
        Some(values[place(r, rows, closed[0])? * (columns + 1) + place(c, columns, closed[1])?])
    };
    let mut found: Vec<f64> = Vec::new();
    for r in 0..rows as isize + isize::from(!closed[0]) {
        for c in 0..columns as isize + isize::from(!closed[1]) {
            let here = value(r, c).unwrap();
            let around = (-1..=1).flat_map(|a| (-1..=1).map(move |b| (a, b))).filter(|&around| around != (0, 0));
            if around.filter_map(|(a, b)| value(r + a, c + b)).any(|there| there < here) {
                continue;
            }
            let (mut u, mut v, mut best) = (r as f64 / fine as f64, c as f64 / fine as f64, here);
            let mut step = 0.1;
            while step > 1e-9 {
                let moves = [
                    (1.0, 0.0),
                    (-1.0, 0.0),
                    (0.0, 1.0),
                    (0.0, -1.0),
                    (1.0, 1.0),
                    (-1.0, -1.0),
                    (1.0, -1.0),
                    (-1.0, 1.0),
                ];
                let next = moves.map(|(a, b)| (u + step * a, v + step * b)).into_iter();
                let next = next.map(|(u, v)| (distance(u, v), u, v)).min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
                if next.0 < best {
                    (best, u, v) = next;
                } else {
                    step *= 0.5;
                }
            }
            if !found.iter().any(|other| (other - best).abs() < 1e-9) {
                found.push(best);
            }
        }
    }
    found.sort_by(f64::total_cmp);
    found
}

#[test]
fn minima_by_force() {
    for shape in &SHAPES[..3] {
        let grid = grid(shape);
        let surface = surface(&grid);
        let mut random = Random(5);
        for k in 0..8 {
            let query = random.point(if k % 2 == 0 { 1.2 } else { 4.0 });
            let truth = by_force(&grid, shape.closed, query);
            let minima = surface.local_minima(query, f64::INFINITY, 0, &Job::default()).unwrap();
            assert!(minima.complete);
            let found: Vec<f64> = minima.points.iter().map(|point| point.distance).collect();
            // Each one of brute force is there; and no others, but that brute force joins those at
            // the same distance.
            for expected in &truth {
                let there = found.iter().any(|distance| (distance - expected).abs() < 1e-8);
                assert!(there, "{} {query}: {expected} of {truth:?} not in {found:?}", shape.name);
            }
            for point in &minima.points {
                assert!(point.proven, "{} {query}: {point:?}", shape.name);
                let there = truth.iter().any(|expected| (point.distance - expected).abs() < 1e-8);
                assert!(there, "{} {query}: {point:?} not in {truth:?}", shape.name);
                assert_eq!(surface.jet(point.place).point, point.point);
            }
            let nearest = surface.closest(query, f64::INFINITY).unwrap();
            assert!((found[0] - nearest.distance).abs() < 1e-9);
            // The nearest ones, and those within a limit.
            let two = surface.local_minima(query, f64::INFINITY, 2, &Job::default()).unwrap();
            assert_eq!(two.points[..], minima.points[..found.len().min(2)]);
            let limit = 0.5 * (found[0] + found[found.len() - 1]);
            let within = surface.local_minima(query, limit, 0, &Job::default()).unwrap();
            assert_eq!(within.points.len(), found.iter().filter(|&&distance| distance <= limit).count());
        }
    }
}

#[test]
fn a_whole_circle_is_one_open_answer() {
    // From a point of the axis all of the torus' inner circle is as near.
    let surface = surface(&grid(&SHAPES[0]));
    let minima = surface.local_minima(DVec3::new(0.0, 0.0, 0.1), f64::INFINITY, 0, &Job::default()).unwrap();
    assert!(!minima.points.is_empty());
    let [low, high] = surface.bounds();
    assert!(minima.points.len() < 100, "{}", minima.points.len());
    assert!(minima.points[0].distance < low.distance(high));
}

#[test]
fn regions_by_force() {
    for shape in &SHAPES {
        let grid = grid(shape);
        let surface = surface(&grid);
        let [h, w] = grid.cells();
        let mut random = Random(11);
        for _ in 0..6 {
            let query = random.point(1.5);
            let radius = 0.2 + random.next();
            let region = surface.cells_in_ball(query, radius, &Job::default()).unwrap();
            assert_eq!(region.first_bit_of_sheet, [0, (h * w) as u64]);
            let bits: u32 = region.mask.iter().map(|word| word.count_ones()).sum();
            assert_eq!(bits as usize, region.cells.len());
            for (i, j) in (0..h).flat_map(|i| (0..w).map(move |j| (i, j))) {
                let patch = grid.patch(i, j);
                let places = (0..121).map(|k| (f64::from(k / 11) / 10.0, f64::from(k % 11) / 10.0));
                let distances = places.map(|(u, v)| patch.point(u, v).distance(query));
                let [least, most] = distances.fold([f64::INFINITY, 0.0_f64], |[a, b], x| [a.min(x), b.max(x)]);
                let cell = [0, i as u32, j as u32];
                let at = region.cells.binary_search(&cell);
                assert_eq!(at.is_ok(), region.contains((i * w + j) as u64));
                if least <= radius {
                    assert!(at.is_ok(), "{}: {query} {radius}: {i} {j} {least}", shape.name);
                }
                // Samples are within this distance of the nearest point of the cell.
                let reach =
                    patch.points.as_flattened().iter().map(|p| p.distance(patch.points[0][0])).fold(0.0, f64::max);
                if least > radius + 0.3 * reach + 1e-8 {
                    assert!(at.is_err(), "{}: {query} {radius}: {i} {j} {least}", shape.name);
                }
                if let Ok(at) = at {
                    assert!(!region.is_whole_cell_inside[at] || most <= radius);
                }
            }
        }
        let everything = surface.cells_in_ball(DVec3::ZERO, 1e9, &Job::default()).unwrap();
        assert_eq!(everything.cells.len(), h * w);
        assert!(everything.is_whole_cell_inside.iter().all(|&whole| whole));
        assert!(surface.cells_in_ball(DVec3::splat(100.0), 1.0, &Job::default()).unwrap().cells.is_empty());
    }
}

#[test]
fn questions_that_are_none() {
    let surface = surface(&grid(&SHAPES[2]));
    let job = Job::default();
    assert!(surface.local_minima(DVec3::splat(f64::NAN), 1.0, 0, &job).is_err());
    assert!(surface.local_minima(DVec3::ZERO, f64::NAN, 0, &job).is_err());
    assert!(surface.cells_in_ball(DVec3::INFINITY, 1.0, &job).is_err());
    assert!(surface.cells_in_ball(DVec3::ZERO, -1.0, &job).is_err());
}

/// A surface through rows x columns nodes.
fn through(rows: usize, columns: usize, node: impl Fn(usize, usize) -> [f64; 3]) -> Surface<'static> {
    let data: Vec<f64> = (0..rows * columns).flat_map(|k| node(k / columns, k % columns)).collect();
    let nodes = Nodes::strided(data, rows, columns, 0, 0).unwrap();
    surface(&Grid::new(nodes, [false; 2], Scheme::SixTap).unwrap())
}

#[test]
fn a_fold_that_meets_a_border() {
    // x overshoots between nodes that are alike: S_u = 0 on lines that end on the borders, where
    // the nearest points are.
    let small = through(4, 2, |i, j| [[0.0, 0.0, 1.0, 1.0][i], j as f64, 0.0]);
    let large = through(6, 6, |i, j| [(i / 2) as f64, j as f64, 0.0]);
    let queries = [[3.0, -3.0, 3.0], [-3.0, -3.0, 3.0], [3.0, 8.0, 3.0], [100.0, -100.0, 100.0], [3.0, 0.5, 0.0]];
    for (k, surface) in [&small, &large].into_iter().enumerate() {
        for query in queries.map(DVec3::from_array) {
            let nearest = surface.closest(query, f64::INFINITY).unwrap();
            for most in [0, 1] {
                let minima = surface.local_minima(query, f64::INFINITY, most, &Job::default()).unwrap();
                let first = minima.points.first().unwrap_or_else(|| panic!("{k} {query} {most}: none"));
                assert!((first.distance - nearest.distance).abs() < 1e-9, "{k} {query} {most}: {first:?} {nearest:?}");
            }
        }
    }
    // One that is not the nearest: the far end of the fold, where another sheet is nearer.
    let query = DVec3::new(3.0, -3.0, 3.0);
    let lone = small.closest(query, f64::INFINITY).unwrap();
    let near = through(2, 2, |i, j| [3.0 + i as f64, -3.0 + j as f64, 2.0]);
    let sheets = vec![near.sheet(0).clone(), small.sheet(0).clone()];
    let both = Surface::new(sheets, None, &Job::default()).unwrap();
    let minima = both.local_minima(query, f64::INFINITY, 0, &Job::default()).unwrap();
    assert!(minima.points.iter().any(|point| point.point.distance(lone.point) < 1e-9), "{minima:?}");
}

#[test]
fn the_nearest_point_is_among_the_minima_of_any_surface() {
    let mut random = Random(17);
    for k in 0..24 {
        // Nodes of few values: folds, cusps, sides and sheets without extent.
        let values: Vec<[f64; 3]> = (0..16)
            .map(|_| [0, 1, 2].map(|axis| if axis == k % 4 { 0.0 } else { (2.0 * random.next()).round() }))
            .collect();
        let surface = through(4, 4, |i, j| values[4 * i + j]);
        for _ in 0..4 {
            let query = random.point(6.0);
            let nearest = surface.closest(query, f64::INFINITY).unwrap();
            let minima = surface.local_minima(query, f64::INFINITY, 1, &Job::default()).unwrap();
            let first = minima.points.first().unwrap_or_else(|| panic!("{values:?} {query}: none"));
            assert!((first.distance - nearest.distance).abs() < 1e-6, "{values:?} {query}: {first:?} {nearest:?}");
        }
    }
}

#[test]
fn a_sheet_that_is_a_line_has_one_nearest_point() {
    let surface = through(6, 6, |i, _| [i as f64, 0.0, 0.0]);
    let query = DVec3::new(2.001, 1.0, 0.0);
    let minima = surface.local_minima(query, f64::INFINITY, 0, &Job::default()).unwrap();
    assert_eq!(minima.points.len(), 1, "{minima:?}");
    assert!((minima.points[0].distance - 1.0).abs() < 1e-9);
}

#[test]
fn queries_whose_squares_overflow() {
    let surface = surface(&grid(&SHAPES[2]));
    let job = Job::default();
    let far = DVec3::new(0.0, 2e150, 0.0);
    let refused = |error: Error, at: u32| matches!(error, Error::CoordinateTooLarge { element: Element::Query, index, value, .. } if index == u64::from(at) && value == 2e150);
    assert_eq!(surface.closest(far, f64::INFINITY), None);
    assert!(refused(surface.closest_all(&[DVec3::ZERO, far], f64::INFINITY, &job).unwrap_err(), 1));
    assert!(refused(surface.local_minima(far, f64::INFINITY, 0, &job).unwrap_err(), 0));
    assert!(refused(surface.cells_in_ball(far, 1.0, &job).unwrap_err(), 0));
    let found = surface.closest(DVec3::splat(1e150), f64::INFINITY).unwrap();
    assert!(found.distance.is_finite() && found.proven, "{found:?}");
}

/// Rough sheets of 6 x 6 cells: at corners and sides second derivatives jump, of four-point ones
/// the tangents.
fn rough(random: &mut Random, scheme: Scheme, height: f64) -> Grid<'static> {
    let mut data = Vec::new();
    for k in 0..49 {
        let shift = random.point(1.0);
        data.extend([f64::from(k / 7) + 0.2 * shift.x, f64::from(k % 7) + 0.2 * shift.y, height * shift.z]);
    }
    Grid::new(Nodes::strided(data, 7, 7, 0, 0).unwrap(), [false; 2], scheme).unwrap()
}

#[test]
fn minima_at_corners_and_sides_are_minima_and_all_of_them() {
    let mut random = Random(2);
    let mut checked = 0;
    for (scheme, height) in
        [(Scheme::SixTap, 1.2), (Scheme::SixTap, 0.05), (Scheme::FourPoint, 1.2), (Scheme::SixTap, 1.2)]
    {
        for _ in 0..3 {
            let grid = rough(&mut random, scheme, height);
            let surface = surface(&grid);
            for _ in 0..20 {
                let shift = random.point(1.0);
                let query = DVec3::new(3.0 + 3.5 * shift.x, 3.0 + 3.5 * shift.y, 3.0 * shift.z);
                let distance = |u: f64, v: f64| {
                    let (u, v) = (u.clamp(0.0, 6.0), v.clamp(0.0, 6.0));
                    let (i, j) = ((u as usize).min(5), (v as usize).min(5));
                    grid.patch(i, j).point(u - i as f64, v - j as f64).distance(query)
                };
                let minima = surface.local_minima(query, f64::INFINITY, 0, &Job::default()).unwrap();
                for point in minima.points.iter().filter(|point| point.proven) {
                    let [i, j] = point.place.cell.map(f64::from);
                    let (u, v) = (i + point.place.u, j + point.place.v);
                    let around = (-4..=4).flat_map(|a| (-4..=4).map(move |b| (a, b)));
                    let lowest = around
                        .map(|(a, b)| distance(u + 2.5e-5 * f64::from(a), v + 2.5e-5 * f64::from(b)))
                        .fold(f64::INFINITY, f64::min);
                    assert!(lowest > point.distance - 1e-8, "{query}: {point:?} {lowest}");
                    checked += 1;
                }
                let force = by_force(&grid, [false; 2], query);
                for value in force.iter().filter(|_| minima.complete) {
                    let known = minima.points.iter().any(|point| (point.distance - value).abs() < 1e-6);
                    assert!(known, "{query}: {value} {:?}", minima.points);
                }
            }
        }
    }
    assert!(checked > 500, "{checked}");
}
