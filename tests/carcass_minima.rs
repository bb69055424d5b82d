//! Places of locally least distance, and regions of cells, against brute force.

mod surfaces;

use glam::DVec3;
use gusset::Job;
use gusset::carcass::{Carcass, Grid, Sheet};
use surfaces::{Random, SHAPES, grid};

fn carcass(grid: &Grid<'static>) -> Carcass<'static> {
    Carcass::new(vec![Sheet::Grid(grid.clone())], None, &Job::default()).unwrap()
}

/// Points to which steps of alternating search lead from all places of a lattice that are no farther than their neighbours on the surface.
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
        let carcass = carcass(&grid);
        let mut random = Random(5);
        for k in 0..8 {
            let query = random.point(if k % 2 == 0 { 1.2 } else { 4.0 });
            let truth = by_force(&grid, shape.closed, query);
            let minima = carcass.local_minima(query, f64::INFINITY, 0, &Job::default()).unwrap();
            assert!(minima.complete);
            let found: Vec<f64> = minima.points.iter().map(|point| point.distance).collect();
            // Each one of brute force is there; and no others, but that brute force joins those at the same distance.
            for expected in &truth {
                let there = found.iter().any(|distance| (distance - expected).abs() < 1e-8);
                assert!(there, "{} {query}: {expected} of {truth:?} not in {found:?}", shape.name);
            }
            for point in &minima.points {
                assert!(point.proven, "{} {query}: {point:?}", shape.name);
                let there = truth.iter().any(|expected| (point.distance - expected).abs() < 1e-8);
                assert!(there, "{} {query}: {point:?} not in {truth:?}", shape.name);
                assert_eq!(carcass.jet(point.place).point, point.point);
            }
            let nearest = carcass.closest(query, f64::INFINITY).unwrap();
            assert!((found[0] - nearest.distance).abs() < 1e-9);
            // The nearest ones, and those within a limit.
            let two = carcass.local_minima(query, f64::INFINITY, 2, &Job::default()).unwrap();
            assert_eq!(two.points[..], minima.points[..found.len().min(2)]);
            let limit = 0.5 * (found[0] + found[found.len() - 1]);
            let within = carcass.local_minima(query, limit, 0, &Job::default()).unwrap();
            assert_eq!(within.points.len(), found.iter().filter(|&&distance| distance <= limit).count());
        }
    }
}

#[test]
fn a_whole_circle_is_one_open_answer() {
    // From a point of the axis all of the torus' inner circle is as near.
    let carcass = carcass(&grid(&SHAPES[0]));
    let minima = carcass.local_minima(DVec3::new(0.0, 0.0, 0.1), f64::INFINITY, 0, &Job::default()).unwrap();
    assert!(!minima.points.is_empty());
    let [low, high] = carcass.bounds();
    assert!(minima.points.len() < 100, "{}", minima.points.len());
    assert!(minima.points[0].distance < low.distance(high));
}

#[test]
fn regions_by_force() {
    for shape in &SHAPES {
        let grid = grid(shape);
        let carcass = carcass(&grid);
        let [h, w] = grid.cells();
        let mut random = Random(11);
        for _ in 0..6 {
            let query = random.point(1.5);
            let radius = 0.2 + random.next();
            let region = carcass.region(query, radius, &Job::default()).unwrap();
            assert_eq!(region.first, [0, (h * w) as u64]);
            let bits: u32 = region.mask.iter().map(|word| word.count_ones()).sum();
            assert_eq!(bits as usize, region.cells.len());
            for (i, j) in (0..h).flat_map(|i| (0..w).map(move |j| (i, j))) {
                let patch = grid.patch(i, j);
                let places = (0..121).map(|k| (f64::from(k / 11) / 10.0, f64::from(k % 11) / 10.0));
                let distances = places.map(|(u, v)| patch.point(u, v).distance(query));
                let [least, most] = distances.fold([f64::INFINITY, 0.0_f64], |[a, b], x| [a.min(x), b.max(x)]);
                let cell = [0, i as u32, j as u32];
                let at = region.cells.binary_search(&cell);
                assert_eq!(at.is_ok(), region.has((i * w + j) as u64));
                if least <= radius {
                    assert!(at.is_ok(), "{}: {query} {radius}: {i} {j} {least}", shape.name);
                }
                // Samples are no farther than this from the nearest point of the cell.
                let reach =
                    patch.points.as_flattened().iter().map(|p| p.distance(patch.points[0][0])).fold(0.0, f64::max);
                if least > radius + 0.3 * reach + 1e-8 {
                    assert!(at.is_err(), "{}: {query} {radius}: {i} {j} {least}", shape.name);
                }
                if let Ok(at) = at {
                    assert!(!region.whole[at] || most <= radius);
                }
            }
        }
        let everything = carcass.region(DVec3::ZERO, 1e9, &Job::default()).unwrap();
        assert_eq!(everything.cells.len(), h * w);
        assert!(everything.whole.iter().all(|&whole| whole));
        assert!(carcass.region(DVec3::splat(100.0), 1.0, &Job::default()).unwrap().cells.is_empty());
    }
}

#[test]
fn questions_that_are_none() {
    let carcass = carcass(&grid(&SHAPES[2]));
    let job = Job::default();
    assert!(carcass.local_minima(DVec3::splat(f64::NAN), 1.0, 0, &job).is_err());
    assert!(carcass.local_minima(DVec3::ZERO, f64::NAN, 0, &job).is_err());
    assert!(carcass.region(DVec3::INFINITY, 1.0, &job).is_err());
    assert!(carcass.region(DVec3::ZERO, -1.0, &job).is_err());
}
