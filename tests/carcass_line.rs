//! Lines against many starts of Newton's method in every cell, and against parity.

mod surfaces;

use glam::{DMat3, DVec3};
use gusset::Job;
use gusset::carcass::line::{Line, Which};
use gusset::carcass::{Carcass, Grid, Sheet};
use surfaces::{Random, SHAPES, grid};

/// Parameters of all points that Newton's method finds from 7 x 7 starts in every cell.
fn by_force(grid: &Grid<'_>, line: &Line) -> Vec<f64> {
    let [h, w] = grid.cells();
    let mut found: Vec<(f64, DVec3)> = Vec::new();
    for (i, j) in (0..h).flat_map(|i| (0..w).map(move |j| (i, j))) {
        let patch = grid.patch(i, j);
        let middle = patch.point(0.5, 0.5);
        let reach = patch.points.as_flattened().iter().map(|p| p.distance(middle)).fold(0.0, f64::max);
        let across = (middle - line.origin).cross(line.direction).length() / line.direction.length();
        if across > 1.01 * reach {
            continue;
        }
        for k in 0..49 {
            let (mut u, mut v) = (f64::from(k / 7) / 6.0, f64::from(k % 7) / 6.0);
            let mut t = 0.0;
            for _ in 0..30 {
                let jet = patch.jet(u, v);
                t = (jet.point - line.origin).dot(line.direction) / line.direction.length_squared();
                let miss = jet.point - line.origin - t * line.direction;
                let jacobian = DMat3::from_cols(jet.u, jet.v, -line.direction);
                if jacobian.determinant().abs() < 1e-14 {
                    break;
                }
                let step = jacobian.inverse() * miss;
                (u, v) = ((u - step.x).clamp(-0.3, 1.3), (v - step.y).clamp(-0.3, 1.3));
            }
            let miss = (patch.point(u, v) - line.origin - t * line.direction).length();
            let inside = (-1e-12..=1.0 + 1e-12).contains(&u) && (-1e-12..=1.0 + 1e-12).contains(&v);
            if inside && miss < 1e-12 && t >= line.from && t <= line.to {
                let point = patch.point(u, v);
                if !found.iter().any(|(_, other)| other.distance(point) < 1e-8) {
                    found.push((t, point));
                }
            }
        }
    }
    let mut found: Vec<f64> = found.into_iter().map(|(t, _)| t).collect();
    found.sort_by(f64::total_cmp);
    found
}

#[test]
fn hits_by_force_and_parity() {
    for shape in &SHAPES {
        let grid = grid(shape);
        let carcass = Carcass::new(vec![Sheet::Grid(grid.clone())], None, &Job::default()).unwrap();
        let mut random = Random(3);
        let mut total = 0;
        for k in 0..80 {
            let (a, b) = (random.point(1.5), random.point(1.2));
            let line = match k % 3 {
                0 => Line::new(a, b - a),
                1 => Line::ray(a, b - a),
                _ => Line::segment(a, b),
            };
            let hits = carcass.line(&line, Which::All).unwrap();
            let truth = by_force(&grid, &line);
            let found: Vec<f64> = hits.iter().filter(|hit| !hit.tangent).map(|hit| hit.t).collect();
            assert_eq!(found.len(), truth.len(), "{} {k}: {line:?}: {hits:?} {truth:?}", shape.name);
            for ((t, expected), hit) in found.iter().zip(&truth).zip(&hits) {
                assert!((t - expected).abs() < 1e-9, "{} {k}: {found:?} {truth:?}", shape.name);
                assert_eq!(carcass.jet(hit.place).point, hit.point);
            }
            if shape.closed == [true, true] && k % 3 == 0 {
                assert!(hits.len().is_multiple_of(2), "{} {k}: {hits:?}", shape.name);
            }
            let first = carcass.line(&line, Which::First).unwrap();
            assert_eq!(first.first().map(|hit| hit.t), hits.first().map(|hit| hit.t));
            assert_eq!(carcass.line(&line, Which::Any).unwrap().is_empty(), hits.is_empty());
            total += hits.len();
        }
        assert!(total > 30, "{}: {total}", shape.name);
    }
}

#[test]
fn through_nodes_and_along_seams() {
    // A torus: lines through nodes and along the seam circle's plane.
    let shape = &SHAPES[0];
    let carcass = Carcass::new(vec![Sheet::Grid(grid(shape))], None, &Job::default()).unwrap();
    let line = Line::new(DVec3::new(-3.0, 0.0, 0.0), DVec3::X);
    let hits = carcass.line(&line, Which::All).unwrap();
    let expected = [1.6, 2.4, 3.6, 4.4];
    assert_eq!(hits.len(), 4, "{hits:?}");
    for (hit, t) in hits.iter().zip(expected) {
        assert!((hit.t - t).abs() < 2e-4, "{hits:?}");
    }
    // A line that touches the top of the ring.
    let top = carcass.jet(gusset::carcass::Place { sheet: 0, cell: [5, 0], u: 0.0, v: 0.0 }).point;
    let line = Line::new(DVec3::new(top.x, -3.0, top.z), DVec3::Y);
    let hits = carcass.line(&line, Which::All).unwrap();
    assert!(!hits.is_empty() && hits.len() <= 2, "{hits:?}");
}

#[test]
fn lines_that_are_none() {
    let carcass = Carcass::new(vec![Sheet::Grid(grid(&SHAPES[2]))], None, &Job::default()).unwrap();
    for line in [
        Line::new(DVec3::ZERO, DVec3::ZERO),
        Line::new(DVec3::splat(f64::NAN), DVec3::X),
        Line::new(DVec3::ZERO, DVec3::INFINITY),
        Line { from: 1.0, to: 0.0, ..Line::new(DVec3::ZERO, DVec3::X) },
    ] {
        assert!(carcass.line(&line, Which::All).is_err());
    }
}
