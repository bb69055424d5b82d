//! Creases that go on across holes, against the surface that was there: formulas, and a real part.

mod case;
mod part;

use crate::common::some_of;
use case::{Case, options};
use glam::{DMat3, DVec3};
use gusset::fill::{Options, Refinement};
use std::collections::HashMap;
use std::f64::consts::TAU;

/// The cube from 0 to 1 in each axis with n * n cells a side, under a linear map, without the faces
/// round a point of it.
fn block(n: u32, map: DMat3, centre: DVec3, radius: f64) -> Case {
    let mut numbers = HashMap::new();
    let (mut points, mut triangles) = (Vec::new(), Vec::new());
    let mut vertex = |at: [u32; 3]| {
        *numbers.entry(at).or_insert_with(|| {
            points.push(map * (DVec3::from(at.map(f64::from)) / f64::from(n)));
            points.len() as u32 - 1
        })
    };
    for axis in 0..3 {
        for side in [0, n] {
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
                let corner = |i: u32, j: u32| {
                    let mut at = [side; 3];
                    (at[(axis + 1) % 3], at[(axis + 2) % 3]) = (i, j);
                    at
                };
                let mut quad = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
                if side == 0 {
                    quad.reverse();
                }
                let [a, b, c, d] = quad.map(&mut vertex);
                // Diagonals either way.
                triangles.extend(if (i + j) % 3 == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] });
            }
        }
    }
    Case { points, triangles, centre: map * centre, radius, surface: None }
}

/// A solid cylinder of radius 1 from z = -1 to 1, its rim circles of n vertices, without the faces
/// round a point of the upper one.
fn cylinder(n: u32, radius: f64) -> Case {
    let (mut points, mut triangles) = (Vec::new(), Vec::new());
    let step = TAU / f64::from(n);
    let rings = (1.0 / step).round() as u32;
    // Down the caps and the side: (radius, z), the poles left out.
    let caps = |z: f64| (1..rings).map(move |k| (f64::from(k) / f64::from(rings), z));
    let side = (0..=2 * rings).map(|k| (1.0, 1.0 - f64::from(k) / f64::from(rings)));
    let profile: Vec<_> = caps(1.0).chain(side).chain(caps(-1.0).collect::<Vec<_>>().into_iter().rev()).collect();
    for &(r, z) in &profile {
        points.extend((0..n).map(|k| DVec3::new(r * (step * f64::from(k)).cos(), r * (step * f64::from(k)).sin(), z)));
    }
    let at = |row: u32, k: u32| row * n + k % n;
    let rows = profile.len() as u32;
    for (row, k) in (0..rows - 1).flat_map(|row| (0..n).map(move |k| (row, k))) {
        let [a, b, c, d] = [at(row, k), at(row + 1, k), at(row + 1, k + 1), at(row, k + 1)];
        triangles.extend(if (row + k) % 2 == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] });
    }
    let top = points.len() as u32;
    points.extend([DVec3::Z, -DVec3::Z]);
    for k in 0..n {
        triangles.push([top, at(0, k), at(0, k + 1)]);
        triangles.push([top + 1, at(rows - 1, k + 1), at(rows - 1, k)]);
    }
    let surface = |p: DVec3| {
        let flat = p.with_z(0.0);
        let side = flat.normalize_or(DVec3::X) + DVec3::Z * p.z.clamp(-1.0, 1.0);
        let cap = flat.clamp_length_max(1.0) + DVec3::Z * p.z.signum();
        if side.distance(p) <= cap.distance(p) { side } else { cap }
    };
    let centre = DVec3::new(0.6f64.cos(), 0.6f64.sin(), 1.0);
    Case { points, triangles, centre, radius, surface: Some(surface) }
}

/// Turns in no special direction.
fn turns() -> [DMat3; 3] {
    [0.0, 0.7, 2.1]
        .map(|t| DMat3::from_rotation_z(t) * DMat3::from_rotation_x(1.3 * t) * DMat3::from_rotation_y(0.6 * t))
}

fn check(name: &str, case: &Case, fair: bool, limit: f64) {
    let (_, errors) = case.filled(&options(fair));
    println!("{name}, faired {fair}: {errors:.4?}");
    assert!(errors.surface <= limit && errors.missed <= limit && errors.invented <= limit, "{name}: {errors:?}");
}

#[test]
fn an_edge_of_a_cube_goes_on() {
    let cases =
        [8, 13, 24].into_iter().flat_map(|n| turns().into_iter().zip([0.2, 0.3, 0.33]).map(move |case| (n, case)));
    for (n, (turn, radius)) in some_of(4, cases) {
        let case = block(n, DMat3::IDENTITY, DVec3::new(0.5, 0.0, 0.0), radius).turned(turn);
        for fair in [false, true] {
            check(&format!("edge {n} {radius}"), &case, fair, 1e-6);
        }
    }
}

#[test]
fn a_corner_of_a_cube_goes_on() {
    let cases =
        [8, 13, 24].into_iter().flat_map(|n| turns().into_iter().zip([0.3, 0.4, 0.5]).map(move |case| (n, case)));
    for (n, (turn, radius)) in some_of(5, cases) {
        let case = block(n, DMat3::IDENTITY, DVec3::ZERO, radius).turned(turn);
        check(&format!("corner {n} {radius}"), &case, true, 1e-6);
    }
}

#[test]
fn acute_and_blunt_edges_go_on() {
    for (n, angle) in some_of(2, [(12, 0.4f64), (16, 0.8), (16, 2.4), (20, 2.0)].into_iter()) {
        // Angles between two sides, at the z axis.
        let map = DMat3::from_cols(DVec3::X, DVec3::from((angle.cos(), angle.sin(), 0.0)), DVec3::Z);
        let case = block(n, map, DVec3::new(0.0, 0.0, 0.5), 0.25).turned(turns()[1]);
        for fair in [false, true] {
            check(&format!("wedge {n} {angle}"), &case, fair, 1e-6);
        }
    }
}

#[test]
fn the_rim_of_a_cylinder_goes_on() {
    for (n, radius) in [(32, 0.3), (32, 0.5), (48, 0.4), (96, 0.2), (96, 0.5)] {
        check(&format!("cylinder {n} {radius}"), &cylinder(n, radius), true, 0.02);
    }
}

/// The edge is rounded, and only where nothing is refined is it there by chance.
#[test]
fn creases_that_are_ignored_end_at_the_rim() {
    for turn in some_of(2, turns().into_iter()) {
        let case = block(16, DMat3::IDENTITY, DVec3::new(0.5, 0.0, 0.0), 0.33).turned(turn);
        let (_, kept) = case.filled(&options(true));
        let (filled, ignored) = case.filled(&Options { ignore_creases: true, ..options(true) });
        assert_eq!(filled.quality.loops_left, 0);
        assert!(kept.missed < 1e-6 && ignored.missed > 0.02, "{kept:?} {ignored:?}");
    }
}

#[test]
fn few_vertices_are_few_along_creases_too() {
    let case = block(16, DMat3::IDENTITY, DVec3::new(0.5, 0.0, 0.0), 0.33).turned(turns()[1]);
    for limit in [1, 2, 5, 20] {
        let options = Options { refinement: Refinement::RimDensity(limit), ..options(true) };
        let (filled, errors) = case.filled(&options);
        // Twice as many where the estimate does not fit.
        assert!(filled.holes[0].vertices.len() as u32 <= 2 * limit + 2, "{limit}");
        assert!(errors.surface < 1e-6 && errors.missed < 1e-6, "{limit}: {errors:?}");
    }
}

#[test]
fn a_rim_that_follows_an_edge_knows_what_is_beyond() {
    // A hole in one side of a cube that ends at an edge: the disc round a point beyond it.
    for turn in turns() {
        let case = block(12, DMat3::IDENTITY, DVec3::new(0.5, 0.25, -0.02), 0.25).turned(turn);
        for fair in [false, true] {
            check("beside an edge", &case, fair, 1e-6);
        }
    }
}
