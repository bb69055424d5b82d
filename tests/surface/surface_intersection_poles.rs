//! Circles that pass poles closely, and circles along lines of parameters of both surfaces: whole,
//! once, or said to be unresolved.

use crate::common::some_of;
use crate::pairs::distance;
use crate::rational::{Nurbs, revolved, sphere};
use crate::shapes::Random;
use glam::{DMat3, DVec3};
use gusset::Job;
use gusset::surface::surface_intersection::Options;
use gusset::surface::{Patches, Paths, Sheet, Surface};
use std::f64::consts::TAU;

/// A rational surface, moved.
fn solid(mut shape: Nurbs, place: impl Fn(DVec3) -> DVec3) -> Surface<'static> {
    shape.points.iter_mut().for_each(|point| *point = place(*point));
    Surface::new(vec![shape.sheet(None)], None, &Job::default()).unwrap()
}

fn plane(corner: DVec3, [along, across]: [DVec3; 2]) -> Surface<'static> {
    let points = [corner, corner + across, corner + along, corner + along + across];
    Surface::new(vec![Sheet::Cubic(Patches::new(&points, [1, 1], 1, 1).unwrap())], None, &Job::default()).unwrap()
}

fn random_turn(random: &mut Random) -> DMat3 {
    let mut angle = || TAU * random.next();
    DMat3::from_rotation_z(angle()) * DMat3::from_rotation_y(angle()) * DMat3::from_rotation_z(angle())
}

fn meet(a: &Surface<'_>, b: &Surface<'_>) -> Paths {
    a.meet(b, &Options::default(), &Job::default()).unwrap()
}

/// The errors of paths that should form one circle, `at` an angle on it.
fn faults(paths: &Paths, radius: f64, at: impl Fn(f64) -> DVec3) -> Option<String> {
    let of = |k: usize| {
        let points = paths.points_of(k);
        let chords: f64 = points.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
        chords + if paths.closed[k] { points[0].distance(points[points.len() - 1]) } else { 0.0 }
    };
    let lengths: Vec<f64> = (0..paths.len()).map(of).collect();
    let total = lengths.iter().sum::<f64>() / (TAU * radius);
    let off = (0..64).map(|k| distance(paths, at(TAU * f64::from(k) / 64.0))).fold(0.0, f64::max);
    // Chords of 1e-4 of the size are that much shorter.
    let is_whole = (0.998..=1.000_001).contains(&total) && off < 1e-3;
    let is_one = paths.closed == [true];
    (!is_whole || !is_one).then(|| format!("{is_whole} {off:e} {:?} {lengths:?}", paths.closed))
}

#[test]
fn circles_past_poles() {
    let (mut bad, mut unresolved, mut count) = (Vec::new(), 0, 0);
    let mut random = Random(1);
    let distances = [0.0, 1e-12, 3e-10, 1e-9, 2e-9, 5e-9, 1e-8, 2e-8, 3e-8, 1e-7, 1e-6, 1e-4];
    for d in some_of(3, distances.into_iter()) {
        for turn in [DMat3::IDENTITY, random_turn(&mut random), random_turn(&mut random)] {
            let ball = solid(sphere(), |p| turn * p);
            let wall = plane(turn * DVec3::new(d, -2.0, -2.0), [turn * DVec3::Y * 4.0, turn * DVec3::Z * 4.0]);
            let radius = (1.0 - d * d).sqrt();
            let at = |angle: f64| turn * DVec3::new(d, radius * angle.cos(), radius * angle.sin());
            for (paths, order) in [(meet(&ball, &wall), "ball, wall"), (meet(&wall, &ball), "wall, ball")] {
                count += 1;
                let faults = faults(&paths, radius, at);
                match faults {
                    Some(_) if !paths.unresolved.is_empty() => unresolved += 1,
                    Some(fault) => bad.push(format!("{d:e} {order}: {fault}")),
                    None => {}
                }
            }
        }
    }
    assert!(bad.is_empty() && 10 * unresolved <= count, "{unresolved} of {count}\n{}", bad.join("\n"));
}

#[test]
fn circles_along_lines_of_parameters_of_both_surfaces() {
    let mut random = Random(2);
    let (mut bad, mut unresolved) = (Vec::new(), 0);
    for _ in some_of(4, 0..40) {
        let (slope, apex) = (0.4 + 0.8 * random.next(), -0.2 * random.next());
        // From near the apex to beyond the ball: radius = slope (z - apex).
        let section = [0.1, 3.0].map(|z| (slope * (z - apex), z, 1.0));
        let cone = revolved(&section, 1, vec![0.0, 0.0, 1.0, 1.0]);
        let (a, b, c) = (1.0 + slope * slope, -slope * slope * apex, slope * slope * apex * apex - 1.0);
        let z = (-b + (b * b - a * c).sqrt()) / a;
        let radius = slope * (z - apex);
        let turn = random_turn(&mut random);
        let (ball, cone) = (solid(sphere(), |p| turn * p), solid(cone, |p| turn * p));
        for (paths, order) in [(meet(&ball, &cone), "ball, cone"), (meet(&cone, &ball), "cone, ball")] {
            let at = |angle: f64| turn * DVec3::new(radius * angle.cos(), radius * angle.sin(), z);
            match faults(&paths, radius, at) {
                Some(_) if !paths.unresolved.is_empty() => unresolved += 1,
                Some(fault) => bad.push(format!("{slope} {apex} {order}: {fault}")),
                None => {}
            }
        }
    }
    assert!(bad.is_empty() && unresolved <= 1, "{unresolved}\n{}", bad.join("\n"));
}
