//! Surfaces and frames beside others, held against planes, cylinders, spheres and their definitions.

use crate::common::some_of;
use glam::DVec3;
use gusset::curve::frame::{Correspondence, FrameOptions, OffsetDirection, frame, offset};
use gusset::curve::{Outlines, Points};
use gusset::surface::{Grid, Nodes, Scheme, Sheet};
use gusset::{Error, Job};
use std::f64::consts::{PI, TAU};

fn grid(rows: usize, columns: usize, closed: [bool; 2], at: impl Fn(usize, usize) -> DVec3) -> Sheet<'static> {
    let data: Vec<f64> = (0..rows * columns).flat_map(|k| at(k / columns, k % columns).to_array()).collect();
    Sheet::Grid(Grid::new(Nodes::strided(data, rows, columns, 0, 0).unwrap(), closed, Scheme::SixTap).unwrap())
}

fn corners<'a>(sheet: &'a Sheet<'_>) -> impl Iterator<Item = (usize, usize, DVec3)> + 'a {
    let [rows, columns] = sheet.cells();
    (0..=rows).flat_map(move |i| (0..=columns).map(move |j| (i, j, sheet.corner(i, j))))
}

#[test]
fn planes_cylinders_and_spheres_become_such() {
    let uneven = |k: usize, n: usize| (k as f64 / (n - 1) as f64).powf(1.3);
    let plane = grid(5, 7, [false; 2], |i, j| DVec3::new(uneven(j, 7), 2.0 * uneven(i, 5), 0.3));
    let (beside, deviation) = plane.offset(&[0.7], &Job::default()).unwrap();
    assert!(deviation < 1e-12);
    for (i, j, p) in corners(&beside) {
        // v runs along x and u along y: the normal points down.
        assert!((p - plane.corner(i, j) + 0.7 * DVec3::Z).length() < 1e-14);
    }
    for closed in [false, true] {
        let angle = |j: usize| if closed { TAU * (j % 20) as f64 / 20.0 } else { 3.0 * uneven(j, 21) };
        let cylinder =
            grid(6, 21, [false, closed], |i, j| DVec3::new(2.0 * angle(j).cos(), 2.0 * angle(j).sin(), uneven(i, 6)));
        let (beside, deviation) = cylinder.offset(&[-0.5], &Job::default()).unwrap();
        assert!(beside.is_closed() == [false, closed] && deviation < 1e-3);
        for (i, j, p) in corners(&beside) {
            // The axis crossed with the direction round it points inwards: -0.5 is outwards.
            assert!((p.truncate().length() - 2.5).abs() < 1e-12 && (p.z - cylinder.corner(i, j).z).abs() < 1e-12);
        }
        // A ball from pole to pole, its middle elsewhere.
        let centre = DVec3::new(3.0, -4.0, 5.0);
        let ball = grid(13, 21, [false, closed], |i, j| {
            let a = PI * i as f64 / 12.0;
            let r = if i % 12 == 0 { 0.0 } else { a.sin() };
            centre + DVec3::new(r * angle(j).cos(), r * angle(j).sin(), a.cos())
        });
        let (beside, deviation) = ball.offset(&[0.25], &Job::default()).unwrap();
        for (_, _, p) in corners(&beside) {
            assert!((p.distance(centre) - 1.25).abs() < 1e-12, "{p}");
        }
        assert!(deviation < 1e-2, "{deviation}");
    }
}

/// A line along the body, and a corner, by its own.
#[test]
fn distances_may_vary() {
    let plane = grid(4, 3, [false; 2], |i, j| DVec3::new(j as f64, i as f64, 0.0));
    let (by_line, _) = plane.offset(&[0.0, 0.1, 0.2, 0.3], &Job::default()).unwrap();
    let each: Vec<f64> = (0..12).map(|k| 0.01 * f64::from(k)).collect();
    let (by_corner, _) = plane.offset(&each, &Job::default()).unwrap();
    for (i, j, p) in corners(&by_line) {
        assert!((p.z + 0.1 * i as f64).abs() < 1e-15);
        assert!((by_corner.corner(i, j).z + 0.01 * (3 * i + j) as f64).abs() < 1e-15);
    }
    for wrong in [&[][..], &[1.0; 2], &[1.0; 5], &[1.0; 13]] {
        assert!(matches!(plane.offset(wrong, &Job::default()), Err(Error::ValuesDiffer { .. })));
    }
    for wrong in [f64::NAN, f64::INFINITY] {
        assert!(matches!(plane.offset(&[wrong], &Job::default()), Err(Error::BadValue { index: 0, .. })));
    }
}

/// Patches have normals of their own; a net that repeats nodes and has none somewhere stays there.
#[test]
fn any_surface_has_one_beside_it() {
    for seed in some_of(4, 0..40) {
        let mut random = fastrand::Rng::with_seed(seed);
        let (rows, columns) = (random.usize(2..8), random.usize(2..8));
        let heights: Vec<f64> = (0..rows * columns).map(|_| 0.3 * random.f64()).collect();
        let flat = seed % 3 == 0;
        let sheet = grid(rows, columns, [false; 2], |i, j| {
            let j = if flat && j > 0 { j - 1 } else { j };
            DVec3::new(j as f64, i as f64, heights[i * columns + j])
        });
        let (beside, deviation) = sheet.offset(&[0.1], &Job::default()).unwrap();
        assert!(deviation.is_finite());
        for (i, j, p) in corners(&beside) {
            let moved = p.distance(sheet.corner(i, j));
            assert!((moved - 0.1).abs() < 1e-12 || moved == 0.0, "{moved}");
        }
    }
}

/// Sections of a cone with its top up, the points of each this way or that round.
fn cone(closed: bool, down: bool, back: bool) -> (Vec<[f64; 3]>, Vec<u32>) {
    let (rows, columns) = (5usize, 16usize);
    let mut points = Vec::new();
    for i in 0..rows {
        for j in 0..columns {
            let part = if closed { j as f64 / columns as f64 } else { 0.4 * j as f64 / (columns - 1) as f64 };
            let angle = TAU * if back { 1.0 - part } else { part };
            let (radius, z) = (3.0 - 0.25 * i as f64, if down { -(i as f64) } else { i as f64 });
            points.push([radius * angle.cos(), radius * angle.sin(), z]);
        }
    }
    (points, (0..=rows).map(|k| (k * columns) as u32).collect())
}

#[test]
fn frames_grow_outwards_whichever_way_they_run() {
    for (down, back) in [(false, false), (false, true), (true, false), (true, true)] {
        let (points, offsets) = cone(true, down, back);
        let sections =
            Outlines { points: Points::from(&points[..]), offsets: Some(&offsets), closed: true, constraints: &[] };
        let options = FrameOptions::new(Correspondence::Given);
        let body = frame(&sections, &options, &Job::default()).unwrap();
        let within = offset(&body.grid, true, &[0.4], OffsetDirection::InSection, &options, &Job::default()).unwrap();
        let along = offset(&body.grid, true, &[0.4], OffsetDirection::Normal, &options, &Job::default()).unwrap();
        for (k, ((p, q), n)) in body.grid.nodes.iter().zip(&within.grid.nodes).zip(&along.grid.nodes).enumerate() {
            assert!((q.z - p.z).abs() < 1e-12);
            assert!((q.truncate().length() - p.truncate().length() - 0.4).abs() < 1e-12, "node {k}");
            // The slope of the cone: 1 in 4.
            let radial = p.truncate().normalize().extend(0.0);
            let up = if down { -0.25 } else { 0.25 };
            let normal = (radial + up * DVec3::Z).normalize();
            assert!((*n - *p - 0.4 * normal).length() < 1e-12, "node {k}: {}", *n - *p);
        }
        assert_eq!(within.across.len(), 5);
    }
    // Open sections go away from the chord between their ends.
    let (points, offsets) = cone(false, false, false);
    let sections =
        Outlines { points: Points::from(&points[..]), offsets: Some(&offsets), closed: false, constraints: &[] };
    let options = FrameOptions::new(Correspondence::Given);
    let body = frame(&sections, &options, &Job::default()).unwrap();
    let within = offset(&body.grid, false, &[0.4], OffsetDirection::InSection, &options, &Job::default()).unwrap();
    for (p, q) in body.grid.nodes.iter().zip(&within.grid.nodes) {
        assert!((q.truncate().length() - p.truncate().length() - 0.4).abs() < 1e-12);
    }
}

/// Sections that turn back along the axis, and any size.
#[test]
fn bodies_that_turn_back_and_all_sizes_grow_outwards() {
    let options = FrameOptions::new(Correspondence::Given);
    for (heights, size) in [
        ([0.0, 1.0, 2.0, 3.0, 2.5], 1.0),
        ([0.0, 1.0, 2.0, 1.9, 3.0], 1.0),
        ([0.0, 1.0, 2.0, 3.0, 4.0], 1e-140),
        ([0.0, 1.0, 2.0, 3.0, 4.0], 1e140),
    ] {
        let points: Vec<[f64; 3]> = (0..60)
            .map(|k| {
                let angle = TAU * f64::from(k % 12) / 12.0;
                [size * angle.cos(), size * angle.sin(), size * heights[k as usize / 12]]
            })
            .collect();
        let offsets: Vec<u32> = (0..6).map(|k| 12 * k).collect();
        let sections =
            Outlines { points: Points::from(&points[..]), offsets: Some(&offsets), closed: true, constraints: &[] };
        let body = frame(&sections, &options, &Job::default()).unwrap();
        let moved =
            offset(&body.grid, true, &[0.2 * size], OffsetDirection::Normal, &options, &Job::default()).unwrap();
        for p in &moved.grid.nodes {
            assert!(((*p / size).truncate().length() - 1.2).abs() < 1e-12, "{heights:?} {size} {p}");
        }
    }
}
