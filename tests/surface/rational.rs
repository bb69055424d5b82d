//! Rational splines: within the stated distance of solids by formula, and of the recursion of Cox
//! and de Boor; smooth where the splines are; equal bits where required.

use crate::common::Silent;
use crate::shapes::Random;
use crate::spline_sheets::basis;
use glam::DVec3;
use gusset::surface::construct::{Spline, SplineAxis, SplineOptions};
use gusset::surface::contour::{Planes, PointSpacing};
use gusset::surface::line_intersection::{HitSelection, Line};
use gusset::surface::{Patches, Sheet, Surface};
use gusset::{Error, Job, Progress};
use std::f64::consts::{FRAC_1_SQRT_2, TAU};
use std::ops::ControlFlow;

/// A rational spline with its arrays.
#[derive(Clone)]
pub(crate) struct Nurbs {
    pub(crate) points: Vec<DVec3>,
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

    pub(crate) fn sheet(&self, tolerance: Option<f64>) -> Sheet<'static> {
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

/// Revolves a section in a half-plane, (radius, height), about the z axis in four quarters of
/// degree 2.
pub(crate) fn revolved(section: &[(f64, f64, f64)], degree: usize, knots: Vec<f64>) -> Nurbs {
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
pub(crate) fn sphere() -> Nurbs {
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

/// A name, a shape, and the distance from it.
type Solid = (&'static str, Nurbs, fn(DVec3) -> f64);

fn solids() -> Vec<Solid> {
    let line = vec![0.0, 0.0, 1.0, 1.0];
    let from_sphere: fn(DVec3) -> f64 = |p| (p.length() - 1.0).abs();
    let mut all: Vec<Solid> = vec![
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

/// Returns the largest distance from the truth at equal parameters, at `n` x `n` places of every
/// cell. Checks any sheet of a spline: shared sides, increasing knots.
fn compare(nurbs: &Nurbs, sheet: &Sheet<'_>, n: usize) -> f64 {
    let ([h, w], [us, vs]) = (sheet.cells(), sheet.knots().unwrap());
    assert_eq!((us.len(), vs.len()), (h + 1, w + 1));
    assert!(us.windows(2).chain(vs.windows(2)).all(|pair| pair[0] < pair[1]));
    let mut worst = 0.0_f64;
    for (i, j) in (0..h).flat_map(|i| (0..w).map(move |j| (i, j))) {
        for (s, t) in (0..n * n).map(|k| ((k / n) as f64 / n as f64, (k % n) as f64 / n as f64)) {
            let (du, dv) = (us[i + 1] - us[i], vs[j + 1] - vs[j]);
            let (u, v) = (us[i] + s * du, vs[j] + t * dv);
            let jet = sheet.jet(i, j, s, t);
            // Where the surface runs fast, rounding of these parameters is seen.
            let rounded = f64::EPSILON * (jet.u.length() / du * u.abs() + jet.v.length() / dv * v.abs());
            worst = worst.max(jet.point.distance(nurbs.point(u, v)) - rounded);
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
            // The rest is the rounding of the distance itself.
            let same = compare(&nurbs, &sheet, 4);
            println!(
                "{name:9} {allowed:8.1e}: {h} x {w} cells, proven {deviation:.2e}, at equal parameters {same:.2e}, off {off:.2e}"
            );
            assert!(off <= deviation + 1e-15 * size && same <= deviation + 4e-15 * size, "{name}: {off:e} {same:e}");
            assert!(
                sheet.largest_crease_angle(&Job::default()).unwrap() < 1e-3 * (allowed / size).powf(0.25) + 1e-6,
                "{name}"
            );
        }
    }
}

#[test]
fn poles_stay_points_and_seams_closed() {
    // Poles at coordinates that weights round.
    let mut nurbs = sphere();
    let place = |p: DVec3| 0.7 * p + DVec3::new(0.1, 0.23, -1.37);
    nurbs.points.iter_mut().for_each(|point| *point = place(*point));
    let sheet = nurbs.sheet(None);
    assert_eq!((sheet.poles_at_sides(), sheet.is_closed()), ([[true, true], [false, false]], [false, true]));
    for (end, pole) in [(0, place(DVec3::NEG_Z)), (sheet.cells()[0], place(DVec3::Z))] {
        (0..=sheet.cells()[1]).for_each(|j| assert_eq!(sheet.corner(end, j), pole));
    }
    let [h, w] = sheet.cells();
    for i in 0..h {
        assert_eq!(sheet.jet(i, w - 1, 0.3, 1.0).point, sheet.jet(i, 0, 0.3, 0.0).point);
    }
    // Normals at poles equal the sphere's.
    for (i, u, z) in [(0, 0.0, -1.0), (h - 1, 1.0, 1.0)] {
        assert!((sheet.normal(i, 0, u, 0.5).z.abs() - z * z).abs() < 1e-9, "{}", sheet.normal(i, 0, u, 0.5));
    }
    assert_eq!(torus().sheet(None).is_closed(), [true, true]);
}

#[test]
fn queries_of_the_sphere_are_those_of_the_sphere() {
    let job = Job::default();
    for tolerance in [None, Some(1e-8)] {
        let sheet = sphere().sheet(tolerance);
        let off = sheet.deviation() + 1e-14;
        let surface = Surface::new(vec![sheet.clone()], Some(0.0), &job).unwrap();
        let mut random = Random(11);
        for _ in 0..100 {
            let query = random.point(2.0);
            let found = surface.closest(query, f64::INFINITY).unwrap();
            assert!((found.distance - (query.length() - 1.0).abs()).abs() <= off, "{query} {found:?}");
            // Tangents of a surface within a distance h of another of curvature 1 may be off by its
            // root; these are nearer.
            let normal = surface.normal(found.place);
            assert!(normal.cross(surface.jet(found.place).point).length() < 4.0 * off.sqrt(), "{query}");
            let (from, to) = (random.point(2.0), random.point(0.5));
            let line = Line::new(from, (to - from).normalize());
            let hits = surface.line(&line, HitSelection::All).unwrap();
            let (b, c) = (from.dot(line.direction), from.length_squared() - 1.0);
            let root = (b * b - c).sqrt();
            assert_eq!(hits.len(), 2, "{line:?}");
            for (hit, truth) in hits.iter().zip([-b - root, -b + root]) {
                assert!((hit.at - truth).abs() <= 2.0 * off / root, "{} {truth}", hit.at);
            }
        }
        let planes = Planes { point: DVec3::ZERO, normal: DVec3::new(1.0, 2.0, 2.0), levels: &[-0.5, 0.1, 0.8] };
        let paths = surface.section(&planes, PointSpacing::Chord(1e-4), &job).unwrap();
        assert_eq!((paths.len(), paths.closed.as_slice()), (3, [true, true, true].as_slice()));
        for (k, offset) in planes.levels.iter().enumerate() {
            let centre = planes.normal / 3.0 * *offset;
            let radius = (1.0 - offset * offset).sqrt();
            let points = paths.points_of(k);
            for point in points {
                assert!((point.distance(centre) - radius).abs() <= 2.0 * off / radius, "{offset}");
            }
            let next = points.iter().cycle().skip(1);
            let length: f64 = points.iter().zip(next).map(|(a, b)| a.distance(*b)).sum();
            assert!((length / (TAU * radius) - 1.0).abs() < 1e-3, "{offset}: {length}");
        }
        // The area by the middles of many small parts: of order two in these.
        let [h, w] = sheet.cells();
        let n = 24;
        let mut area = 0.0;
        for k in 0..h * w * n * n {
            let (cell, part) = (k / (n * n), k % (n * n));
            let at = |part: usize| (part as f64 + 0.5) / n as f64;
            area += sheet.jet(cell / w, cell % w, at(part / n), at(part % n)).normal().length() / (n * n) as f64;
        }
        assert!((area / (2.0 * TAU) - 1.0).abs() < 1e-4, "{area}");
    }
}

/// Knots at random distances, some of them repeated `most` times at most.
fn random_knots(random: &mut Random, degree: usize, count: usize, most: usize, closed: bool) -> Vec<f64> {
    let mut knots = vec![0.0];
    let wanted = if closed { count + 1 } else { count + degree + 1 };
    while knots.len() < wanted {
        let last = knots[knots.len() - 1];
        let next = last + 0.2 + random.next();
        let repeated = if random.next() < 0.4 { 1 + (random.next() * most as f64) as usize } else { 1 };
        knots.extend(std::iter::repeat_n(next, repeated.min(most).min(wanted - knots.len())));
    }
    if closed && knots[count] == knots[count - 1] {
        knots[count] += 0.5;
    }
    knots
}

fn random_nurbs(seed: u64, degrees: [usize; 2], closed: [bool; 2], most: [usize; 2], ratio: f64) -> Nurbs {
    let mut random = Random(seed);
    let counts = [degrees[0] + 4, degrees[1] + 5];
    let knots = [0, 1].map(|d| random_knots(&mut random, degrees[d], counts[d], most[d], closed[d]));
    let points = (0..counts[0] * counts[1]).map(|_| random.point(3.0)).collect();
    let weights = (0..counts[0] * counts[1]).map(|_| ratio.powf(random.next())).collect();
    Nurbs { points, weights, counts, degrees, knots, closed }
}

#[test]
fn any_rational_spline_is_within_what_is_proven() {
    let degrees = [[1, 1], [2, 3], [3, 3], [3, 5], [7, 2], [6, 7], [4, 1]];
    let closures = [[false, false], [true, false], [false, true], [true, true]];
    for (k, degrees) in degrees.into_iter().enumerate() {
        for (c, closed) in closures.into_iter().enumerate() {
            // As many tests as take a second, and more if time does not matter.
            if std::env::var_os("GUSSET_EXHAUSTIVE").is_none() && (k + c) % 4 != 0 {
                continue;
            }
            let nurbs = random_nurbs((4 * k + c) as u64, degrees, closed, degrees, 4.0);
            let size = diagonal(&nurbs.points);
            let sheet = nurbs.sheet(Some(1e-8 * size));
            let worst = compare(&nurbs, &sheet, 3);
            let deviation = sheet.deviation();
            println!("{degrees:?} {closed:?}: {:?} cells, proven {deviation:.1e}, measured {worst:.1e}", sheet.cells());
            assert!(worst <= deviation + 1e-13 && deviation <= 1e-8 * size, "{degrees:?} {closed:?}: {worst:e}");
            assert_eq!(sheet.is_closed(), closed);
            // With simple knots it is smooth where splines of degree 2 and more are.
            if degrees[0].min(degrees[1]) > 1 && k < 4 {
                let smooth = random_nurbs((4 * k + c) as u64, degrees, closed, [1, 1], 4.0);
                let sheet = smooth.sheet(Some(1e-8 * size));
                let ([us, vs], [h, w]) = (sheet.knots().unwrap(), sheet.cells());
                for i in 1..h {
                    let (before, after) = (sheet.jet(i - 1, w / 2, 1.0, 0.37).u, sheet.jet(i, w / 2, 0.0, 0.37).u);
                    let (before, after) = (before / (us[i] - us[i - 1]), after / (us[i + 1] - us[i]));
                    assert!(before.distance(after) < 1e-11 * (1.0 + after.length()), "{i}: {before} {after}");
                }
                for j in 1..w {
                    let (before, after) = (sheet.jet(h / 2, j - 1, 0.37, 1.0).v, sheet.jet(h / 2, j, 0.37, 0.0).v);
                    let (before, after) = (before / (vs[j] - vs[j - 1]), after / (vs[j + 1] - vs[j]));
                    assert!(before.distance(after) < 1e-11 * (1.0 + after.length()), "{j}: {before} {after}");
                }
            }
        }
    }
}

#[test]
fn ratios_of_weights_and_places_far_away() {
    for ratio in [1e3, 1e6, 1e12] {
        let mut nurbs = octant(DVec3::ONE);
        nurbs.weights[4] *= ratio;
        nurbs.weights[0] /= ratio.sqrt();
        let sheet = nurbs.sheet(Some(1e-9));
        let worst = compare(&nurbs, &sheet, 3);
        println!("ratio {ratio:e}: {:?} cells, proven {:.1e}, measured {worst:.1e}", sheet.cells(), sheet.deviation());
        assert!(sheet.deviation() <= 1e-9 && worst <= sheet.deviation() + 1e-14);
    }
    // A unit of any size changes nothing but the unit, and neither does one of weights.
    let plain = octant(DVec3::ONE).sheet(None);
    for unit in [2.0_f64.powi(-90), 2.0_f64.powi(100), 2.0_f64.powi(400)] {
        let mut scaled = octant(DVec3::ONE);
        scaled.points.iter_mut().for_each(|point| *point *= unit);
        scaled.weights.iter_mut().for_each(|weight| *weight *= 1.0 / unit);
        let sheet = scaled.sheet(None);
        assert_eq!(sheet.cells(), plain.cells());
        assert_eq!(sheet.deviation(), plain.deviation() * unit);
        assert_eq!(sheet.jet(3, 4, 0.3, 0.7).point, plain.jet(3, 4, 0.3, 0.7).point * unit);
    }
    // Far from the origin what rounding allows is less, and said.
    let mut far = octant(DVec3::ONE);
    far.points.iter_mut().for_each(|point| *point += 1e6);
    let (sheet, job) = (far.sheet(None), Job::default());
    assert!(sheet.deviation() > 1e-10 && sheet.deviation() < 2e-9, "{:e}", sheet.deviation());
    let asked = SplineOptions { tolerance: Some(1e-12), max_cells: None };
    assert!(matches!(far.sheet_with(&asked, &job), Err(Error::OptionOutOfRange { option: "tolerance", .. })));
}

fn sheet_on_threads(nurbs: &Nurbs, tolerance: Option<f64>, threads: usize) -> Vec<DVec3> {
    let options = SplineOptions { tolerance, max_cells: None };
    control_points(&nurbs.sheet_with(&options, &Job::new(threads, &Silent)).unwrap())
}

fn control_points(sheet: &Sheet<'_>) -> Vec<DVec3> {
    let [h, w] = sheet.cells();
    let of = |patches: &Patches<8>| {
        let all = (0..h * w).map(|k| *patches.get(k / w, k % w));
        all.flat_map(|patch| patch.points.into_iter().flatten()).collect()
    };
    match sheet {
        Sheet::High(patches) => of(patches),
        _ => (0..=h).flat_map(|i| (0..=w).map(move |j| sheet.corner(i, j))).collect(),
    }
}

#[test]
fn weights_that_are_equal_are_none() {
    for degrees in [[2, 3], [5, 2]] {
        let mut nurbs = random_nurbs(3, degrees, [false, true], degrees, 4.0);
        let axes = [0, 1].map(|d| SplineAxis { degree: degrees[d], knots: &nurbs.knots[d], closed: d == 1 });
        let plain = Spline { points: &nurbs.points, weights: None, counts: nurbs.counts, axes };
        let plain = Sheet::from_spline(&plain, &SplineOptions::default(), &Job::default()).unwrap();
        nurbs.weights.fill(0.3);
        let equal = nurbs.sheet(None);
        assert_eq!(equal.deviation(), 0.0);
        assert_eq!((equal.cells(), equal.knots()), (plain.cells(), plain.knots()));
        let [h, w] = plain.cells();
        for (i, j) in (0..h).flat_map(|i| (0..w).map(move |j| (i, j))) {
            assert_eq!(equal.jet(i, j, 0.3, 0.6), plain.jet(i, j, 0.3, 0.6));
        }
    }
    // A common factor changes no more than rounding.
    let (sphere, mut scaled) = (sphere(), sphere());
    scaled.weights.iter_mut().for_each(|weight| *weight *= 0.37);
    let [a, b] = [sphere.sheet(None), scaled.sheet(None)];
    assert_eq!(a.cells(), b.cells());
    for k in 0..a.cells()[0] * a.cells()[1] {
        let (i, j) = (k / a.cells()[1], k % a.cells()[1]);
        assert!(a.jet(i, j, 0.4, 0.9).point.distance(b.jet(i, j, 0.4, 0.9).point) < 1e-14);
    }
    assert_eq!(control_points(&a), sheet_on_threads(&sphere, None, 1));
    assert_eq!(control_points(&a), sheet_on_threads(&sphere, None, 3));
}

/// Cancels after this many reports, and checks that they increase.
struct Stop(std::cell::Cell<(u32, f64)>);

impl Progress for Stop {
    fn step(&self, fraction: f64, _: &'static str) -> ControlFlow<()> {
        let (left, before) = self.0.get();
        assert!(fraction >= before);
        self.0.set((left.saturating_sub(1), fraction));
        if left == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

#[test]
fn rational_splines_that_are_none() {
    let (job, options) = (Job::default(), SplineOptions::default());
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-280] {
        let mut nurbs = sphere();
        nurbs.weights[7] = bad;
        let found = nurbs.sheet_with(&options, &job).unwrap_err();
        assert!(matches!(found, Error::BadWeight { index: 7, .. }), "{found}");
    }
    let mut short = sphere();
    short.weights.pop();
    assert!(matches!(short.sheet_with(&options, &job), Err(Error::ArrayTooShort { what: "weights", .. })));
    let with = |tolerance, max_cells| sphere().sheet_with(&SplineOptions { tolerance, max_cells }, &job).map(|_| ());
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-15] {
        assert!(matches!(with(Some(bad), None), Err(Error::OptionOutOfRange { option: "tolerance", .. })), "{bad}");
    }
    assert_eq!(with(None, Some(647)), Err(Error::TooLarge { what: "cells", count: 648, limit: 647 }));
    assert_eq!(with(None, Some(648)), Ok(()));
    assert_eq!(with(Some(1e-4), Some(8)), Ok(()));
    // A span of one unit in the last place cannot be cut.
    let mut narrow = octant(DVec3::ONE);
    narrow.knots[1] = [[1.0; 3], [1.0_f64.next_up(); 3]].concat();
    assert!(matches!(narrow.sheet_with(&options, &job), Err(Error::BadKnot { direction: 1, knot: 2, .. })));
    let mut reversed = octant(DVec3::ONE);
    reversed.knots[0].reverse();
    assert!(matches!(reversed.sheet_with(&options, &job), Err(Error::BadKnot { direction: 0, knot: 3, .. })));
    // Cancelled at any time, and heard to the end.
    for reports in [0, 1, 5, 1000] {
        let stop = Stop(std::cell::Cell::new((reports, 0.0)));
        let found = torus().sheet_with(&options, &Job::new(1, &stop)).map(|_| ());
        assert_eq!(found, if reports < 1000 { Err(Error::Cancelled) } else { Ok(()) });
    }
}
