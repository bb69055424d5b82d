//! Rational splines: within the distance that they state of what they are, by formulas of solids
//! and by the recursion of Cox and de Boor; smooth where these are; the same bits where they must
//! be.

use crate::construct::basis;
use crate::shapes::Random;
use glam::DVec3;
use gusset::surface::construct::{Spline, SplineAxis, SplineOptions};
use gusset::surface::contour::{Planes, PointSpacing};
use gusset::surface::line_intersection::{HitSelection, Line};
use gusset::surface::{Patches, Sheet, Surface};
use gusset::{Error, Job, Progress};
use std::f64::consts::{FRAC_1_SQRT_2, TAU};
use std::ops::ControlFlow;

/// A rational spline with what it owns.
#[derive(Clone)]
struct Nurbs {
    points: Vec<DVec3>,
    weights: Vec<f64>,
    counts: [usize; 2],
    degrees: [usize; 2],
    knots: [Vec<f64>; 2],
    closed: [bool; 2],
}

impl Nurbs {
    fn sheet_with(&self, options: &SplineOptions, job: &Job<'_>) -> Result<Sheet<'static>, Error> {
        let axes =
            [0, 1].map(|d| SplineAxis { degree: self.degrees[d], knots: &self.knots[d], closed: self.closed[d] });
        let spline = Spline { points: &self.points, weights: Some(&self.weights), counts: self.counts, axes };
        Sheet::from_spline(&spline, options, job)
    }

    fn sheet(&self, tolerance: Option<f64>) -> Sheet<'static> {
        self.sheet_with(&SplineOptions { tolerance, max_cells: None }, &Job::default()).unwrap()
    }

    /// The factors of the control points in a direction, by the recursion, of a closed one with its
    /// knots and points carried round.
    fn factors(&self, d: usize, t: f64) -> Vec<f64> {
        let (n, p, knots) = (self.counts[d], self.degrees[d], &self.knots[d]);
        if !self.closed[d] {
            return (0..n).map(|k| basis(knots, p, k, t)).collect();
        }
        let (count, period) = (n as isize, knots[n] - knots[0]);
        let knot = |k: isize| knots[k.rem_euclid(count) as usize] + k.div_euclid(count) as f64 * period;
        let all: Vec<f64> = (0..n + 2 * p + 1).map(|k| knot(k as isize - p as isize)).collect();
        let mut factors = vec![0.0; n];
        for k in 0..n + p {
            factors[(k + n - p) % n] += basis(&all, p, k, t);
        }
        factors
    }

    /// The point at parameters, the last ones of a direction not among them.
    fn point(&self, u: f64, v: f64) -> DVec3 {
        let (us, vs) = (self.factors(0, u), self.factors(1, v));
        let (mut sum, mut weight) = (DVec3::ZERO, 0.0);
        for (k, (&point, &w)) in self.points.iter().zip(&self.weights).enumerate() {
            let factor = us[k / self.counts[1]] * vs[k % self.counts[1]] * w;
            (sum, weight) = (sum + factor * point, weight + factor);
        }
        sum / weight
    }
}

/// What a section drawn in a half-plane, (radius, height), makes when it turns round the z axis once
/// in four quarters of degree 2.
fn revolved(section: &[(f64, f64, f64)], degree: usize, knots: Vec<f64>) -> Nurbs {
    let ring = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)];
    let (mut points, mut weights) = (Vec::new(), Vec::new());
    for &(radius, height, weight) in section {
        for (k, (x, y)) in ring.into_iter().enumerate() {
            points.push(DVec3::new(radius * f64::from(x), radius * f64::from(y), height));
            weights.push(weight * if k % 2 == 1 { FRAC_1_SQRT_2 } else { 1.0 });
        }
    }
    let round = vec![0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0];
    Nurbs {
        points,
        weights,
        counts: [section.len(), 9],
        degrees: [degree, 2],
        knots: [knots, round],
        closed: [false, false],
    }
}

/// A half circle from pole to pole, turned.
fn sphere() -> Nurbs {
    let s = FRAC_1_SQRT_2;
    let arc = [(0.0, -1.0, 1.0), (1.0, -1.0, s), (1.0, 0.0, 1.0), (1.0, 1.0, s), (0.0, 1.0, 1.0)];
    revolved(&arc, 2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0])
}

fn torus() -> Nurbs {
    let s = FRAC_1_SQRT_2;
    let ring = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)];
    let at = |k: usize| 1.0 + 0.4 * f64::from(ring[k].0);
    let arc: Vec<_> = (0..9).map(|k| (at(k), 0.4 * f64::from(ring[k].1), if k % 2 == 1 { s } else { 1.0 })).collect();
    revolved(&arc, 2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0, 4.0, 4.0])
}

/// One eighth of the sphere, its quarter circles as patches that share nothing with the whole.
fn octant(signs: DVec3) -> Nurbs {
    let s = FRAC_1_SQRT_2;
    let arc = [(1.0, 0.0, 1.0), (1.0, 1.0, s), (0.0, 1.0, 1.0)];
    let ring = [(1.0, 0.0, 1.0), (1.0, 1.0, s), (0.0, 1.0, 1.0)];
    let all = || arc.into_iter().flat_map(|a| ring.map(|b| (a, b)));
    let knots = vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0];
    Nurbs {
        points: all().map(|(a, b)| signs * DVec3::new(a.0 * b.0, a.0 * b.1, a.1)).collect(),
        weights: all().map(|(a, b)| a.2 * b.2).collect(),
        counts: [3, 3],
        degrees: [2, 2],
        knots: [knots.clone(), knots],
        closed: [false, false],
    }
}

/// Shapes with their distance functions.
fn solids() -> Vec<(&'static str, Nurbs, fn(DVec3) -> f64)> {
    let line = vec![0.0, 0.0, 1.0, 1.0];
    let from_sphere: fn(DVec3) -> f64 = |p| (p.length() - 1.0).abs();
    let mut all: Vec<(&str, Nurbs, fn(DVec3) -> f64)> = vec![
        ("sphere", sphere(), from_sphere),
        ("cylinder", revolved(&[(1.0, 0.0, 1.0), (1.0, 3.0, 1.0)], 1, line.clone()), |p| (p.x.hypot(p.y) - 1.0).abs()),
        ("cone", revolved(&[(0.0, 0.0, 1.0), (2.0, 2.0, 1.0)], 1, line), |p| {
            (p.x.hypot(p.y) - p.z).abs() * FRAC_1_SQRT_2
        }),
        ("torus", torus(), |p| ((p.x.hypot(p.y) - 1.0).hypot(p.z) - 0.4).abs()),
    ];
    for k in 0..8 {
        let sign = |bit: i32| if k >> bit & 1 == 0 { 1.0 } else { -1.0 };
        all.push(("octant", octant(DVec3::new(sign(0), sign(1), sign(2))), from_sphere));
    }
    all
}

fn diagonal(points: &[DVec3]) -> f64 {
    let (low, high) = points.iter().fold((points[0], points[0]), |(a, b), &p| (a.min(p), b.max(p)));
    low.distance(high)
}

/// The largest distance from the truth at equal parameters, at `n` x `n` places of every cell, and
/// the checks that hold for any sheet of a spline: shared sides, knots that rise.
fn compare(nurbs: &Nurbs, sheet: &Sheet<'_>, n: usize) -> f64 {
    let ([h, w], [us, vs]) = (sheet.cells(), sheet.knots().unwrap());
    assert_eq!((us.len(), vs.len()), (h + 1, w + 1));
    assert!(us.windows(2).chain(vs.windows(2)).all(|pair| pair[0] < pair[1]));
    let mut worst = 0.0_f64;
    for (i, j) in (0..h).flat_map(|i| (0..w).map(move |j| (i, j))) {
        for (s, t) in (0..n * n).map(|k| ((k / n) as f64 / n as f64, (k % n) as f64 / n as f64)) {
            let truth = nurbs.point(us[i] + s * (us[i + 1] - us[i]), vs[j] + t * (vs[j + 1] - vs[j]));
            worst = worst.max(sheet.jet(i, j, s, t).point.distance(truth));
            if s == 0.0 && i > 0 {
                assert_eq!(sheet.jet(i - 1, j, 1.0, t).point, sheet.jet(i, j, 0.0, t).point, "{i} {j} {t}");
            }
            if t == 0.0 && j > 0 {
                assert_eq!(sheet.jet(i, j - 1, s, 1.0).point, sheet.jet(i, j, s, 0.0).point, "{i} {j} {s}");
            }
        }
    }
    worst
}

#[test]
fn solids_are_within_what_is_proven() {
    for (name, nurbs, distance) in solids() {
        let size = diagonal(&nurbs.points);
        for tolerance in [None, Some(1e-10), Some(1e-7), Some(1e-4)] {
            let sheet = nurbs.sheet(tolerance);
            let (allowed, deviation) = (tolerance.unwrap_or(1e-12 * size), sheet.deviation());
            assert!(deviation > 0.0 && deviation <= allowed, "{name}: {deviation:e} {allowed:e}");
            let [h, w] = sheet.cells();
            let mut off = 0.0_f64;
            for (i, j) in (0..h).flat_map(|i| (0..w).map(move |j| (i, j))) {
                for (s, t) in (0..64).map(|k| (f64::from(k / 8) / 7.0, f64::from(k % 8) / 7.0)) {
                    off = off.max(distance(sheet.jet(i, j, s, t).point));
                }
            }
            // What is left is the rounding of the distance itself.
            let same = compare(&nurbs, &sheet, 4);
            println!(
                "{name:9} {allowed:8.1e}: {h} x {w} cells, proven {deviation:.2e}, at equal parameters {same:.2e}, off {off:.2e}"
            );
            assert!(off <= deviation + 1e-15 * size && same <= deviation + 4e-15 * size, "{name}: {off:e} {same:e}");
            assert!(sheet.crease(&Job::default()).unwrap() < 1e-3 * (allowed / size).powf(0.25) + 1e-6, "{name}");
        }
    }
}
