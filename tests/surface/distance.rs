//! Nearest points of surfaces and lines, planes, curves and other surfaces. They are compared with
//! dense samples and their nearest points, with analytic shapes, and in cases where all points are
//! equally near.

use crate::shapes::{Random, rough, torus};
use glam::{DMat3, DVec3};
use gusset::Job;
use gusset::curve::{Curve, CurveView};
use gusset::surface::line_intersection::Line;
use gusset::surface::{Grid, NearestPoints, Nodes, Patches, Scheme, Sheet, Surface};
use std::time::Instant;

fn surface(sheets: Vec<Sheet<'static>>) -> Surface<'static> {
    Surface::new(sheets, None, &Job::default()).unwrap()
}

/// The surface over a square, or a ring, of nodes.
fn through(cells: [usize; 2], closed: [bool; 2], point: impl Fn(f64, f64) -> DVec3) -> Surface<'static> {
    let [h, w] = cells;
    let nodes: Vec<f64> = (0..=h)
        .flat_map(|i| (0..=w).map(move |j| (i, j)))
        .flat_map(|(i, j)| {
            let at = |k: usize, n: usize, closed: bool| (if closed { k % n } else { k }) as f64 / n as f64;
            point(at(i, h, closed[0]), at(j, w, closed[1])).to_array()
        })
        .collect();
    let nodes = Nodes::strided(nodes, h + 1, w + 1, 0, 0).unwrap();
    surface(vec![Sheet::Grid(Grid::new(nodes, closed, Scheme::SixTap).unwrap())])
}

fn rotation(random: &mut Random) -> DMat3 {
    DMat3::from_euler(glam::EulerRot::XYZ, 7.0 * random.next(), 7.0 * random.next(), 7.0 * random.next())
}

/// Surfaces without any regularity, smooth ones, and patches of high degree, turned and moved.
fn random_surface(random: &mut Random, away: f64) -> Surface<'static> {
    let (turned, moved) = (rotation(random), random.point(away));
    let kind = (6.0 * random.next()) as usize;
    if kind == 5 {
        let points: Vec<DVec3> = (0..36)
            .map(|k| {
                let flat = DVec3::new(f64::from(k / 6) / 2.5 - 1.0, f64::from(k % 6) / 2.5 - 1.0, 0.0);
                turned * (flat + random.point(0.4)) + moved
            })
            .collect();
        return surface(vec![Sheet::High(Patches::new(&points, [5, 5], 1, 1).unwrap())]);
    }
    let cells = [3 + (5.0 * random.next()) as usize, 3 + (9.0 * random.next()) as usize];
    let closed = [[false; 2], [true; 2], [false, true]][kind % 3];
    let cells = [0, 1].map(|k| if closed[k] { cells[k] + 3 } else { cells[k] });
    if kind < 3 {
        let made = Sheet::Grid(rough(cells, closed, Scheme::SixTap, (1e9 * random.next()) as u64));
        return through(cells, closed, |u, v| {
            let [i, j] = [u * cells[0] as f64, v * cells[1] as f64].map(|x| x.round() as usize);
            turned * made.corner(i, j) + moved
        });
    }
    let bumps = 0.3 * random.next();
    through([cells[0] + 4, cells[1] + 4], [true; 2], |u, v| turned * torus(u, v, bumps) + moved)
}

/// Points of every cell.
fn samples(surface: &Surface<'_>, n: usize) -> Vec<DVec3> {
    let mut found = Vec::new();
    for k in 0..surface.len() {
        let [h, w] = surface.sheet(k).cells();
        for (i, j) in (0..h).flat_map(|i| (0..w).map(move |j| (i, j))) {
            for (a, b) in (0..=n).flat_map(|a| (0..=n).map(move |b| (a, b))) {
                let at = |k: usize| k as f64 / n as f64;
                found.push(surface.sheet(k).jet(i, j, at(a), at(b)).point);
            }
        }
    }
    found
}

/// Checks any answer: its points lie on both objects at the reported distance, no sample is nearer
/// than the bound, and no sample is nearer than the answer by more than the tolerance.
fn check<T: std::fmt::Debug>(found: &NearestPoints<T>, surface: &Surface<'_>, least: f64, unit: f64, what: &str) {
    let rounding = 1e-12 * unit;
    assert_eq!(found.point, surface.jet(found.place).point, "{what}");
    assert!((found.point.distance(found.other_point) - found.distance).abs() <= rounding, "{what}: {found:?}");
    assert!(found.bound <= found.distance && found.bound >= 0.0, "{what}: {found:?}");
    assert!(found.meets == (found.distance == 0.0), "{what}: {found:?}");
    assert!(least >= found.bound - rounding, "{what}: a sample at {least} is nearer than {found:?}");
    let tolerance = surface.tolerance().max(1e-9 * unit);
    assert!(found.distance <= least + tolerance || !found.proven, "{what}: {found:?}, a sample at {least}");
    assert!(!found.proven || found.bound >= found.distance - tolerance, "{what}: {found:?}");
}

fn random_curve(random: &mut Random, from: DVec3) -> Curve {
    let degrees = [1, 2, 3, 5, 9].map(|degree| (random.next() < 0.4).then_some(degree));
    let degrees: Vec<u32> = degrees.into_iter().flatten().chain([3]).collect();
    let mut ends = vec![0];
    degrees.iter().for_each(|degree| ends.push(ends.last().unwrap() + degree));
    let mut points = vec![from];
    (0..*ends.last().unwrap()).for_each(|_| points.push(*points.last().unwrap() + random.point(0.5)));
    CurveView::new(&points, &ends, false).unwrap().to_owned().unwrap()
}

fn curve_points(curve: &CurveView<'_>, n: usize) -> Vec<DVec3> {
    let at = |k: usize| gusset::curve::Place { segment: (k / n) as u32, t: (k % n) as f64 / (n - 1) as f64 };
    curve.points_at(&(0..n * curve.len()).map(at).collect::<Vec<_>>(), &Job::default()).unwrap()
}

/// The four kinds: how many cases, of which apart, proved, and seconds of the queries alone.
fn run(cases: usize, seed: u64) {
    let job = Job::default();
    for kind in 0..4 {
        let mut random = Random(seed + kind);
        let (mut apart, mut proven, mut seconds) = (0, 0, 0.0);
        for case in 0..cases {
            let a = random_surface(&mut random, 0.0);
            let own = samples(&a, 4);
            let what = format!("kind {kind}, case {case}");
            let aside = random.point(1.0).normalize() * (0.2 + 2.5 * random.next());
            let begun = Instant::now();
            let (least, distance, meets, is_proven) = match kind {
                0 => {
                    let direction = random.point(1.0);
                    let line = match case % 3 {
                        0 => Line::new(aside, direction),
                        1 => Line::ray(aside, direction),
                        _ => Line::segment(aside, aside + direction),
                    };
                    let found = a.distance_to_line(&line, None, &job).unwrap();
                    seconds += begun.elapsed().as_secs_f64();
                    let at = |p: DVec3| (p - aside).dot(direction) / direction.length_squared();
                    let foot = |p: DVec3| aside + at(p).clamp(line.from, line.to) * direction;
                    let mut least = own.iter().map(|&p| p.distance(foot(p))).fold(f64::INFINITY, f64::min);
                    for k in 0..50 {
                        let t = (-4.0 + 0.16 * f64::from(k)).clamp(line.from, line.to);
                        least = least.min(a.closest(aside + t * direction, f64::INFINITY).unwrap().distance);
                    }
                    assert!(foot(found.point).distance(found.other_point) < 1e-7, "{what}: {found:?}");
                    assert!((aside + found.other * direction).distance(found.other_point) < 1e-12, "{what}");
                    check(&found, &a, least, 4.0, &what);
                    (least, found.distance, found.meets, found.proven)
                }
                1 => {
                    let normal = random.point(1.0);
                    let found = a.distance_to_plane(aside, normal, None, &job).unwrap();
                    seconds += begun.elapsed().as_secs_f64();
                    let unit = normal.normalize();
                    let heights = own.iter().map(|&p| unit.dot(p - aside));
                    let [low, high] =
                        heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], h| [low.min(h), high.max(h)]);
                    let least = if low <= 0.0 && high >= 0.0 { 0.0 } else { low.abs().min(high.abs()) };
                    assert!((found.other - unit.dot(found.point - aside)).abs() < 1e-12, "{what}: {found:?}");
                    assert!(least > 0.0 || found.distance < 1e-12, "{what}: {found:?}");
                    check(&found, &a, least, 4.0, &what);
                    (least, found.distance, found.meets, found.proven)
                }
                2 => {
                    let curve = random_curve(&mut random, aside);
                    let found = a.distance_to_curve(&curve.view(), None, &job).unwrap();
                    seconds += begun.elapsed().as_secs_f64();
                    let points = curve_points(&curve.view(), 24);
                    let nearest = |p: DVec3| a.closest(p, f64::INFINITY).unwrap().distance;
                    let least = points.into_iter().map(nearest).fold(f64::INFINITY, f64::min);
                    assert_eq!(curve.view().point(found.other).unwrap(), found.other_point, "{what}");
                    check(&found, &a, least, 4.0, &what);
                    (least, found.distance, found.meets, found.proven)
                }
                _ => {
                    let b = random_surface(&mut random, 2.0);
                    let begun = Instant::now();
                    let found = a.distance_to_surface(&b, None, &job).unwrap();
                    seconds += begun.elapsed().as_secs_f64();
                    let nearest = |p: DVec3| a.closest(p, f64::INFINITY).unwrap().distance;
                    let least = samples(&b, 2).into_iter().map(nearest).fold(f64::INFINITY, f64::min);
                    assert_eq!(found.other_point, b.jet(found.other).point, "{what}");
                    check(&found, &a, least, 4.0, &what);
                    (least, found.distance, found.meets, found.proven)
                }
            };
            assert!(least >= 0.0 && distance.is_finite());
            apart += usize::from(!meets);
            proven += usize::from(is_proven);
        }
        let name = ["line", "plane", "curve", "surface"][kind as usize];
        println!("{name}: {cases} cases, {apart} apart, {proven} proved, {:.1} us each", 1e6 * seconds / cases as f64);
        assert!(apart * 6 > cases && proven * 100 >= cases * 98, "{name}: {apart} apart, {proven} proved");
    }
}

#[test]
fn no_sample_is_nearer() {
    run(40, 1);
}

/// `cargo test --release -p gusset-tests --test surface -- --ignored --nocapture exhaustive_distance`
#[test]
#[ignore = "long: make exhaustive"]
fn exhaustive_distances() {
    run(10_000, 100);
}

/// z = bend (x^2 + y^2) + height for x and y from -1 to 1, turned: one patch that is this exactly.
fn bowl(bend: f64, height: f64) -> Patches<4> {
    let value = |k: usize, n: usize| [[1.0, -1.0, 1.0][k], 2.0 * k as f64 / (n - 1) as f64 - 1.0];
    let points: Vec<DVec3> = (0..9)
        .map(|k| {
            let ([xx, x], [yy, y]) = (value(k / 3, 3), value(k % 3, 3));
            DVec3::new(x, y, bend * (xx + yy) + height)
        })
        .collect();
    Patches::new(&points, [2, 2], 1, 1).unwrap()
}

fn bowls(bend: f64, height: f64) -> Surface<'static> {
    surface(vec![Sheet::Cubic(bowl(bend, height))])
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12
}

#[test]
fn distances_of_paraboloids_are_known() {
    let job = Job::default();
    let a = bowls(0.5, 0.0);
    // Two that face each other, and their lowest and highest points.
    let found = a.distance_to_surface(&bowls(-0.3, -1.0), None, &job).unwrap();
    assert!(near(found.distance, 1.0) && found.proven && !found.meets, "{found:?}");
    assert!(found.point.length() < 1e-6 && near(found.place.u, 0.5) && near(found.other.v, 0.5), "{found:?}");
    // Planes below, and one that cuts it: on either side of it.
    for (z, up, height) in [(-0.25, 2.0, 0.25), (-0.25, -3.0, -0.25), (1.5, 1.0, -0.5)] {
        let found = a.distance_to_plane(DVec3::new(7.0, 3.0, z), DVec3::Z * up, None, &job).unwrap();
        assert!(near(found.other, height) && near(found.distance, height.abs()) && found.proven, "{found:?}");
    }
    let found = a.distance_to_plane(DVec3::new(7.0, 3.0, 0.4), DVec3::new(0.1, 0.0, 1.0), None, &job).unwrap();
    assert!(found.meets && found.proven && found.distance == 0.0 && found.bound == 0.0, "{found:?}");
    // A line below, a ray that points away, a segment that ends above.
    let below = Line::new(DVec3::new(5.0, 3.0, -0.75), DVec3::new(2.0, 1.2, 0.0));
    let found = a.distance_to_line(&below, None, &job).unwrap();
    assert!(near(found.distance, 0.75) && near(found.other, -2.5) && found.proven, "{found:?}");
    let away = Line::ray(DVec3::new(3.0, 0.0, -0.75), DVec3::new(1.0, 0.0, 0.0));
    let found = a.distance_to_line(&away, None, &job).unwrap();
    let nearest = a.closest(away.origin, f64::INFINITY).unwrap();
    assert!(found.other == 0.0 && near(found.distance, nearest.distance) && found.proven, "{found:?}");
    let ends = Line::segment(DVec3::new(0.2, 0.1, 5.0), DVec3::new(0.3, 0.1, 0.6));
    let found = a.distance_to_line(&ends, None, &job).unwrap();
    let nearest = a.closest(DVec3::new(0.3, 0.1, 0.6), f64::INFINITY).unwrap();
    assert!(found.other == 1.0 && near(found.distance, nearest.distance) && found.proven, "{found:?}");
    // Through it, and a curve through it.
    let found = a.distance_to_line(&Line::new(DVec3::splat(0.1), DVec3::Z), None, &job).unwrap();
    assert!(found.meets && found.point.distance(found.other_point) < 1e-14, "{found:?}");
    let points = [DVec3::new(0.0, 0.0, -1.0), DVec3::new(0.4, 0.4, 3.0), DVec3::new(0.2, 0.0, -1.0)];
    let through = CurveView::new(&points, &[0, 2], false).unwrap();
    assert!(a.distance_to_curve(&through, None, &job).unwrap().meets);
    // A single control point that is repeated is a point.
    let still = CurveView::new(&[DVec3::Z * -2.0; 4], &[0, 3], true).unwrap().to_owned().unwrap();
    let found = a.distance_to_curve(&still.view(), None, &job).unwrap();
    assert!(near(found.distance, 2.0) && found.proven, "{found:?}");
}

/// The best of all sheets, of either side.
#[test]
fn all_sheets_are_searched() {
    let job = Job::default();
    let many = |sign: f64| -> Vec<Sheet<'static>> {
        (0..9).map(|k| Sheet::Cubic(bowl(sign * 0.1, sign * (1.0 + 0.1 * f64::from((k * 5 + 2) % 9))))).collect()
    };
    let (a, b) = (surface(many(1.0)), surface(many(-1.0)));
    let found = a.distance_to_surface(&b, None, &job).unwrap();
    assert!(near(found.distance, 2.0) && found.proven, "{found:?}");
    assert_eq!([found.place.sheet, found.other.sheet], [5; 2]);
}

/// A torus.
fn ring(r: f64) -> Surface<'static> {
    through([24, 40], [true; 2], |u, v| {
        let [u, v] = [u, v].map(|t| std::f64::consts::TAU * t);
        let ring = 1.0 + r * u.cos();
        DVec3::new(ring * v.cos(), ring * v.sin(), r * u.sin())
    })
}

/// Where all is equally near, searches end, say so, and their bounds hold.
#[test]
fn searches_end_where_all_is_equally_near() {
    let job = Job::default();
    let flat = |z: f64| through([30, 30], [false; 2], |u, v| DVec3::new(2.0 * u, 3.0 * v + 0.3 * u * u, z));
    let tube = through([30, 30], [false, true], |u, v| {
        let v = std::f64::consts::TAU * v;
        DVec3::new(v.cos(), v.sin(), 3.0 * u)
    });
    // Parallel planes are proved, however they are parametrised.
    let found = flat(0.0).distance_to_surface(&flat(0.5), None, &job).unwrap();
    assert!(near(found.distance, 0.5) && found.proven, "{found:?}");
    let found = flat(0.0).distance_to_plane(DVec3::NEG_Z, DVec3::Z, None, &job).unwrap();
    assert!(near(found.distance, 1.0) && found.proven, "{found:?}");
    let found = flat(0.0).distance_to_line(&Line::new(DVec3::NEG_Z, DVec3::new(1.0, 2.0, 0.0)), None, &job).unwrap();
    assert!(near(found.distance, 1.0) && found.proven, "{found:?}");
    // Tori one within the other, and a tube and its axis: to the tolerance that is asked for, or
    // less than that without a claim.
    let begun = Instant::now();
    for tolerance in [Some(5e-3), None] {
        let found = ring(0.4).distance_to_surface(&ring(0.2), tolerance, &job).unwrap();
        assert!((found.distance - 0.2).abs() < 1e-3 && found.bound <= found.distance, "{found:?}");
        assert!(found.bound > 0.18 && found.proven == tolerance.is_some(), "{found:?}");
        for line in [Line::new(DVec3::ZERO, DVec3::Z), Line::segment(DVec3::ZERO, DVec3::Z)] {
            let found = tube.distance_to_line(&line, tolerance, &job).unwrap();
            assert!((found.distance - 1.0).abs() < 1e-3 && found.bound > 0.98, "{found:?}");
            assert!(found.proven || tolerance.is_none(), "{found:?}");
        }
        let found = tube.distance_to_plane(DVec3::X * -2.0, DVec3::X, tolerance, &job).unwrap();
        assert!((found.distance - 1.0).abs() < 1e-4 && found.proven, "{found:?}");
    }
    println!("{:?}", begun.elapsed());
}

/// In any unit, and far away.
#[test]
fn any_unit_and_any_distance() {
    let job = Job::default();
    for unit in [1e-25, 1e-6, 1e12, 1e30] {
        let made = |bend: f64, height: f64| {
            through([6, 7], [false; 2], |u, v| {
                let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
                unit * DVec3::new(x, y, bend * (x * x + y * y) + height)
            })
        };
        let a = made(0.5, 0.0);
        let found = a.distance_to_surface(&made(-0.3, -1.0), None, &job).unwrap();
        assert!((found.distance / unit - 1.0).abs() < 1e-9 && found.proven, "{unit}: {found:?}");
        let line = Line::new(DVec3::Z * -unit, DVec3::new(unit, 0.0, 0.0));
        let found = a.distance_to_line(&line, None, &job).unwrap();
        assert!((found.distance / unit - 1.0).abs() < 1e-9 && found.proven, "{unit}: {found:?}");
    }
    let a = bowls(0.5, 0.0);
    let far = Line::segment(DVec3::splat(1e140), DVec3::new(1e140, 2e140, 3e140));
    let found = a.distance_to_line(&far, None, &job).unwrap();
    assert!((found.distance / (3.0_f64.sqrt() * 1e140) - 1.0).abs() < 1e-12 && found.proven, "{found:?}");
    let found = a.distance_to_plane(DVec3::Z * -1e100, DVec3::Z, None, &job).unwrap();
    assert!((found.distance / 1e100 - 1.0).abs() < 1e-12 && found.proven, "{found:?}");
}

#[test]
fn what_cannot_be_asked_is_refused() {
    let (job, a) = (Job::default(), bowls(0.5, 0.0));
    let line = Line::new(DVec3::ZERO, DVec3::X);
    for tolerance in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(a.distance_to_line(&line, Some(tolerance), &job).is_err(), "{tolerance}");
        assert!(a.distance_to_surface(&a, Some(tolerance), &job).is_err(), "{tolerance}");
    }
    for line in [Line { direction: DVec3::ZERO, ..line }, Line { from: 1.0, to: 0.0, ..line }] {
        assert!(a.distance_to_line(&line, None, &job).is_err(), "{line:?}");
    }
    for (point, normal) in [(DVec3::ZERO, DVec3::ZERO), (DVec3::NAN, DVec3::X), (DVec3::X * 1e200, DVec3::X)] {
        assert!(a.distance_to_plane(point, normal, None, &job).is_err(), "{point} {normal}");
    }
    let none = CurveView::new(&[], &[0], false).unwrap();
    assert_eq!(a.distance_to_curve(&none, None, &job).unwrap_err(), gusset::Error::EmptyCurve);
    let large = [DVec3::ZERO, DVec3::X * 1e200];
    assert!(a.distance_to_curve(&CurveView::new(&large, &[0, 1], false).unwrap(), None, &job).is_err());
}

/// Asked to stop, a long search does.
#[test]
fn cancelling_is_heard() {
    struct Stop;
    impl gusset::Progress for Stop {
        fn step(&self, _: f64, _: &'static str) -> std::ops::ControlFlow<()> {
            std::ops::ControlFlow::Break(())
        }
    }
    let found = ring(0.4).distance_to_surface(&ring(0.2), None, &Job::new(1, &Stop));
    assert_eq!(found.unwrap_err(), gusset::Error::Cancelled);
}

/// A surface of no extent, and tolerances beyond all sizes: there is an answer, and soon.
#[test]
fn points_and_wide_tolerances_have_answers() {
    let square = [DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::X + DVec3::Y];
    for (origin, size) in [(DVec3::ZERO, 0.0), (DVec3::splat(1e4), 0.0), (DVec3::ZERO, 1.0)] {
        let points = square.map(|p| origin + size * p);
        let flat = surface(vec![Sheet::Cubic(Patches::new(&points, [1, 1], 1, 1).unwrap())]);
        let ends = [DVec3::new(0.25, 0.5, 5.0), DVec3::new(0.75, 0.5, 6.0)];
        let curve = CurveView::new(&ends, &[0, 1], false).unwrap();
        for tolerance in [None, Some(1e-3), Some(1.0), Some(1e4), Some(1e300)] {
            let found = flat.distance_to_curve(&curve, tolerance, &Job::default()).unwrap();
            let least = if size > 0.0 { 5.0 } else { ends[0].distance(origin).min(ends[1].distance(origin)) };
            let allowed = tolerance.unwrap_or(1e-6).max(1e-6);
            assert!(
                found.bound <= least + 1e-9 && found.distance - least <= allowed,
                "{size} {tolerance:?}: {found:?}"
            );
            let own = flat.distance_to_surface(&flat, tolerance, &Job::default()).unwrap();
            assert!(own.distance <= allowed, "{size} {tolerance:?}: {own:?}");
        }
    }
}
