//! Nearest points of curves with singular points, and near misses of curves, against samples.

use crate::curves::Given;
use crate::plane::casteljau;
use glam::DVec3;
use gusset::Job;
use gusset::curve::CurveView;

fn view(points: &[DVec3]) -> Given {
    Given::one(points)
}

fn random_points(random: &mut fastrand::Rng, count: usize) -> Vec<DVec3> {
    (0..count).map(|_| DVec3::from_array([(); 3].map(|()| 2.0 * random.f64() - 1.0))).collect()
}

/// The least distance of a curve from a point, by samples and the golden section about the least of
/// them.
fn least_distance(controls: &[DVec3], q: DVec3) -> f64 {
    const SAMPLES: usize = 400;
    let at = |k: usize| k.min(SAMPLES) as f64 / SAMPLES as f64;
    let distance = |t: f64| casteljau(controls, t).distance(q);
    let sampled: Vec<f64> = (0..=SAMPLES).map(|k| distance(at(k))).collect();
    let mut best = f64::INFINITY;
    for k in 0..=SAMPLES {
        if sampled[k] <= sampled[k.saturating_sub(1)] && sampled[k] <= sampled[(k + 1).min(SAMPLES)] {
            let (mut low, mut high) = (at(k.saturating_sub(1)), at(k + 1));
            for _ in 0..90 {
                let (x, y) = (high - 0.618_034 * (high - low), low + 0.618_034 * (high - low));
                if distance(x) < distance(y) { high = y } else { low = x }
            }
            best = best.min(sampled[k]).min(distance(0.5 * (low + high)));
        }
    }
    best
}

/// x = t^n: the point (d, 0) is on it, at the n-th root of d.
#[test]
fn points_on_a_curve_beside_its_singular_point() {
    for n in [3, 4, 5, 9, 16, 32] {
        let mut points = vec![DVec3::ZERO; n];
        points.push(DVec3::X);
        for d in [1e-3f64, 1e-6, 1e-8, 1e-9, 1e-10, 1e-12] {
            let found =
                view(&points).view().nearest_to_each_query(&[DVec3::new(d, 0.0, 0.0)], &Job::default()).unwrap()[0];
            assert!(found.distance <= 1e-15, "t^{n}, {d}: {found:?}");
            let t = d.powf(1.0 / n as f64);
            assert!((found.place.t / t - 1.0).abs() < 1e-3, "t^{n}, {d}: {found:?}, not {t}");
        }
    }
}

#[test]
fn nearest_points_of_nets_with_coincident_points() {
    let mut random = fastrand::Rng::with_seed(3);
    for k in 0..600 {
        let n = random.usize(2..9);
        let mut points = random_points(&mut random, n + 1);
        for i in 1..n {
            match k % 3 {
                0 if random.bool() => points[i] = points[i - 1],
                1 => points[i] = if i % 2 == 0 { points[0] } else { points[n] },
                2 if i == n / 2 => points[i] = points[i - 1],
                _ => {}
            }
        }
        // On the curve, beside it, and anywhere.
        let on = casteljau(&points, random.f64());
        let anywhere = random_points(&mut random, 1)[0];
        for q in [on, on + 1e-9 * anywhere, 1.5 * anywhere] {
            let found = view(&points).view().nearest_to_each_query(&[q], &Job::default()).unwrap()[0];
            let excess = found.distance - least_distance(&points, q);
            assert!(excess < 1e-13, "{k}: {excess:e} {found:?} of {points:?} to {q:?}");
        }
    }
}

/// Every place reported is a least distance among its neighbourhood, and every one that samples
/// show is reported or within an overlap.
#[test]
fn near_misses_are_the_least_distances() {
    const SAMPLES: usize = 100;
    let within = 0.3;
    let mut random = fastrand::Rng::with_seed(21);
    let (mut minima, mut overlaps, mut undecided) = (0, 0, 0);
    for k in 0..300 {
        let flat = DVec3::new(1.0, 1.0, [1.0, 0.05, 1e-3][k % 3]);
        let mut points = || -> Vec<DVec3> {
            let count = random.usize(2..6);
            random_points(&mut random, count).into_iter().map(|p| p * flat).collect()
        };
        let (a, b) = (points(), points());
        let (given_a, given_b) = (view(&a), view(&b));
        let (va, vb): (CurveView<'_>, CurveView<'_>) = (given_a.view(), given_b.view());
        let found = va.near_misses(&vb, within, &Job::default()).unwrap();
        let distance = |s: f64, t: f64| casteljau(&a, s).distance(casteljau(&b, t));
        for place in &found.places {
            let (s, t) = (place.a.t, place.b.t);
            assert!((place.distance - distance(s, t)).abs() < 1e-12 && place.distance <= within);
            for h in [1e-3, 1e-4, 1e-5] {
                for (x, y) in (0..16).map(|i| std::f64::consts::TAU * f64::from(i) / 16.0).map(f64::sin_cos) {
                    let (u, v) = (s + h * x, t + h * y);
                    let inside = (0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v);
                    let lower = place.distance - distance(u.clamp(0.0, 1.0), v.clamp(0.0, 1.0));
                    assert!(!inside || lower < 1e-10, "{k}: {place:?} is no minimum: {lower:e} {found:?}");
                }
            }
        }
        for (i, place) in found.places.iter().enumerate() {
            let same = |x: f64, y: f64| (x - y).abs() < 1e-6;
            assert!(!found.places[..i].iter().any(|other| same(other.a.t, place.a.t) && same(other.b.t, place.b.t)));
        }
        let at = |i: usize| i as f64 / SAMPLES as f64;
        let rows: Vec<DVec3> = (0..=SAMPLES).map(|i| casteljau(&a, at(i))).collect();
        let columns: Vec<DVec3> = (0..=SAMPLES).map(|i| casteljau(&b, at(i))).collect();
        let sampled = |i: usize, j: usize| rows[i].distance(columns[j]);
        for i in 0..=SAMPLES {
            for j in 0..=SAMPLES {
                let least = sampled(i, j);
                let around = |i: usize| i.saturating_sub(4)..=(i + 4).min(SAMPLES);
                if least > 0.9 * within || around(i).any(|x| around(j).any(|y| sampled(x, y) < least)) {
                    continue;
                }
                // Down to where it ends, if that is near.
                let (mut s, mut t, mut lowest, mut h) = (at(i), at(j), least, 1.0 / SAMPLES as f64);
                while h > 1e-9 {
                    let before = lowest;
                    for (x, y) in (0..25).map(|n| (f64::from(n % 5 - 2) * h, f64::from(n / 5 - 2) * h)) {
                        let (u, v) = ((s + x).clamp(0.0, 1.0), (t + y).clamp(0.0, 1.0));
                        if distance(u, v) < lowest {
                            (s, t, lowest) = (u, v, distance(u, v));
                        }
                    }
                    if lowest == before {
                        h *= 0.5;
                    }
                }
                if (s - at(i)).abs().max((t - at(j)).abs()) > 0.05 {
                    continue;
                }
                minima += 1;
                let near = |m: &gusset::curve::ops::NearMiss| (m.a.t - s).abs() < 2e-3 && (m.b.t - t).abs() < 2e-3;
                let inside = |o: &gusset::curve::ops::Overlap| {
                    let holds =
                        |ends: [gusset::curve::Place; 2], x: f64| ends[0].t - 1e-3 <= x && x <= ends[1].t + 1e-3;
                    holds(o.a, s) && holds(o.b, t)
                };
                let reported = found.places.iter().any(near) || found.overlaps.iter().any(inside) || found.undecided;
                assert!(reported, "{k}: ({s}, {t}) at {lowest} is missing: {found:?}");
            }
        }
        overlaps += found.overlaps.len();
        undecided += u32::from(found.undecided);
    }
    assert!(minima > 250 && overlaps < 20 && undecided <= 3, "{minima} {overlaps} {undecided}");
}

/// Any distance that is a number, and curves of any size, the smallest numbers too.
#[test]
fn near_misses_at_the_ends_of_the_numbers() {
    let random = &mut fastrand::Rng::with_seed(23);
    for size in [1e-310, 1e-200, 0.1, 1.0, 1e200, 1e308] {
        for within in [0.0, f64::MIN_POSITIVE, 1e-310, 1e-3, 1e300, f64::MAX] {
            let [a, b] = [(); 2].map(|()| random_points(random, 4).into_iter().map(|p| p * size).collect::<Vec<_>>());
            let (a, b) = (view(&a), view(&b));
            let near = a.view().near_misses(&b.view(), within, &Job::default()).unwrap();
            assert!(near.places.iter().all(|place| place.distance <= within.max(1e-11 * size)), "{size} {within}");
            // Two curves apart have a place where they are nearest.
            assert!(within < 4.0 * size || !near.places.is_empty(), "{size} {within}");
            let own = a.view().near_misses(&a.view(), within, &Job::default()).unwrap();
            assert!(!own.overlaps.is_empty() || own.undecided || !own.places.is_empty());
        }
    }
}
