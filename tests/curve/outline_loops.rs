//! Loops that the points lack, and crowded points: the statuses agree with dense samples of the curve.

use crate::outline::{MODES, one};
use glam::{DVec2, DVec3};
use gusset::curve::{CurveView, Fit, Method, Mode, Options, PointStatus};
use std::f64::consts::TAU;

const SAMPLES: usize = 200;

/// Dense samples of span k of a plane outline, whose points are not merged.
fn samples(fit: &Fit, curve: &CurveView<'_>, k: usize, count: usize) -> Vec<DVec2> {
    let position = |i: usize| f64::from(fit.segments()[i]) + fit.parameters()[i];
    let (from, mut to) = (position(k), position((k + 1) % count));
    if to <= from {
        to += curve.len() as f64;
    }
    (0..=SAMPLES)
        .map(|i| {
            let at = from + (to - from) * i as f64 / SAMPLES as f64;
            let segment = (at.ceil() - 1.0).max(0.0);
            let place = gusset::curve::Place { segment: segment as u32 % curve.len() as u32, t: at - segment };
            curve.point(place).unwrap().truncate()
        })
        .collect()
}

fn cross(p: DVec2, q: DVec2, r: DVec2, s: DVec2) -> bool {
    let side = |a: DVec2, b: DVec2, c: DVec2| (b - a).perp_dot(c - a);
    side(p, q, r) * side(p, q, s) < 0.0 && side(r, s, p) * side(r, s, q) < 0.0
}

/// The length of the longest loop in span k, or between span k and the next one.
fn longest_loop(own: &[DVec2], next: &[DVec2]) -> f64 {
    let whole: Vec<DVec2> = own.iter().chain(&next[1..]).copied().collect();
    let mut longest = 0.0_f64;
    for i in 0..own.len() - 1 {
        for j in i + 2..whole.len() - 1 {
            if cross(whole[i], whole[i + 1], whole[j], whole[j + 1]) {
                longest = longest.max((i..j).map(|k| whole[k].distance(whole[k + 1])).sum());
            }
        }
    }
    longest
}

/// Whether two spans cross that are `apart` places apart, or a span crosses itself.
fn do_cross(a: &[DVec2], b: &[DVec2], apart: usize) -> bool {
    let parts = a.len() - 1;
    (0..parts).any(|i| {
        let first = match apart {
            0 => i + 2,
            1 if i + 1 == parts => 1,
            _ => 0,
        };
        (first..parts).any(|j| cross(a[i], a[i + 1], b[j], b[j + 1]))
    })
}

#[test]
fn loops_have_a_status() {
    let mut random = fastrand::Rng::with_seed(12);
    let (mut looped, mut calm) = (0, 0);
    for case in 0..300 {
        // Points in ascending order of x: their polyline cannot cross itself. Some are crowded.
        let count = 4 + case % 7;
        let mut x = 0.0;
        let points: Vec<[f64; 2]> = (0..count)
            .map(|_| {
                x += if random.bool() { 0.05 + 0.1 * random.f64() } else { 1.0 + random.f64() };
                [x, 1.5 * random.f64()]
            })
            .collect();
        let options = Options {
            mode: [Mode::CubicC2, Mode::Composite, Mode::BlendC2][case % 3],
            method: [Method::Median, Method::Bisector, Method::Normal][case / 3 % 3],
            ..Options::default()
        };
        let fit = one(&points, false, &[], &options);
        let curve = fit.curve(0);
        let spans: Vec<Vec<DVec2>> = (0..count - 1).map(|k| samples(&fit, &curve, k, count)).collect();
        let is_looped = |i: usize| fit.statuses()[i] == PointStatus::Looped;
        for k in 0..count - 1 {
            let next = spans.get(k + 1).map_or(&spans[k][SAMPLES..], |next| next);
            let longest = longest_loop(&spans[k], next);
            let said = (k..(k + 2).min(count)).any(|i| fit.statuses()[i] != PointStatus::Ok);
            // Samples of the search may miss small loops.
            assert!(longest < 0.02 || said, "{case} {k}: {longest} {:?}", fit.statuses());
            looped += usize::from(longest > 0.0);
        }
        let exists = (0..count - 1).any(|k| (k..(k + 3).min(count - 1)).any(|j| do_cross(&spans[k], &spans[j], j - k)));
        assert!(exists || !(0..count).any(is_looped), "{case}: {:?}", fit.statuses());
        calm += usize::from(!exists);
    }
    assert!(looped > 40 && calm > 80, "{looped} {calm}");
}

#[test]
fn waypoints_that_are_crowded() {
    let points = [
        [470.0, 170.0],
        [433.0, 150.0],
        [412.0, 186.0],
        [405.0, 185.0],
        [398.0, 182.0],
        [387.0, 184.0],
        [210.0, 170.0],
    ];
    let statuses = |method: Method| {
        let options = Options { method, ..Options::default() };
        one(&points, false, &[], &options).statuses().to_vec()
    };
    assert!(statuses(Method::Median).contains(&PointStatus::Looped));
    assert!(!statuses(Method::Bisector).contains(&PointStatus::Looped));
}

#[test]
fn curves_that_cross_as_their_points_do_have_no_loops() {
    for mode in MODES {
        let options = Options { mode, ..Options::default() };
        let star: Vec<[f64; 2]> = (0..5).map(|k| TAU * 0.4 * f64::from(k)).map(|t| [t.cos(), t.sin()]).collect();
        assert!(!one(&star, true, &[], &options).statuses().contains(&PointStatus::Looped), "{mode:?}");
        for count in 3..40 {
            let t = |k: usize| TAU * k as f64 / count as f64;
            let circle: Vec<[f64; 2]> = (0..count).map(|k| [t(k).cos(), t(k).sin()]).collect();
            let said = one(&circle, true, &[], &options).statuses().to_vec();
            assert!(
                !said.iter().any(|s| matches!(s, PointStatus::Looped | PointStatus::Crowded)),
                "{mode:?} {count} {said:?}"
            );
        }
    }
    // A screw, whose shadow crosses itself.
    for per_turn in 3..9 {
        let screw: Vec<[f64; 3]> =
            (0..40).map(|k| TAU * f64::from(k) / f64::from(per_turn)).map(|t| [t.cos(), t.sin(), 0.2 * t]).collect();
        let outlines =
            gusset::curve::Outlines { points: (&screw[..]).into(), offsets: None, closed: false, constraints: &[] };
        let fit = gusset::curve::fit(&outlines, &Options::default(), &gusset::Job::default()).unwrap();
        assert!(!fit.statuses().contains(&PointStatus::Looped), "{per_turn}");
    }
}

#[test]
fn points_that_are_almost_repeated() {
    let mut random = fastrand::Rng::with_seed(2);
    for case in 0..200 {
        let (count, unit) = (12 + case % 9, 10f64.powi(case as i32 % 7 - 3));
        let gap = 10f64.powf(-9.0 + 6.0 * random.f64());
        let beside = random.usize(..count);
        let mut angles: Vec<f64> = (0..count).map(|k| TAU * k as f64 / count as f64).collect();
        angles.insert(beside + 1, angles[beside] + gap);
        let direction = TAU * random.f64();
        let points: Vec<[f64; 2]> = (0..=count)
            .map(|k| {
                let off = if k == beside + 1 { gap * DVec2::from_angle(direction) } else { DVec2::ZERO };
                (unit * (DVec2::from_angle(angles[k]) + off)).to_array()
            })
            .collect();
        for mode in [Mode::Composite, Mode::CubicC2, Mode::BlendC1, Mode::BlendC2] {
            let fit = one(&points, true, &[], &Options { mode, ..Options::default() });
            let curve = fit.curve(0);
            let off = (0..count)
                .flat_map(|k| samples(&fit, &curve, k, count + 1))
                .map(|p| (DVec3::from((p, 0.0)).length() / unit - 1.0).abs())
                .fold(0.0, f64::max);
            let said = (beside..beside + 2).any(|i| fit.statuses()[i] != PointStatus::Ok);
            assert!(off < 1e-3 || said, "{case} {mode:?}: {off} with a gap of {gap}");
            // Merged on request.
            let merging = Options { mode, repeat_tolerance: 0.03, ..Options::default() };
            let merged = one(&points, true, &[], &merging);
            assert_eq!(merged.statuses()[beside + 1], PointStatus::Merged);
        }
    }
}
