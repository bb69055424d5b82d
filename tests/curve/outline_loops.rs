//! Loops that the points lack, and crowded points: the statuses agree with dense samples of the curve.

use crate::common::some_of;
use crate::outline::{CURVE_KINDS, one};
use glam::{DVec2, DVec3};
use gusset::curve::{CurveKind, CurveView, Fit, JointParameter, Method, Options, PointStatus};
use gusset_oracles::loops::{distances_along, largest_loop, point_of_segment, turn_back};
use std::cmp::Ordering;
use std::f64::consts::TAU;

const SAMPLES: usize = 211;

/// The number of samples that shows loops of a thousandth of a span.
const MANY_SAMPLES: usize = 20 * SAMPLES;

/// Dense samples of span k of a plane outline, densest at its start, its end or neither.
fn samples(fit: &Fit, curve: &CurveView<'_>, [from, to]: [usize; 2], dense: Ordering, count: usize) -> Vec<DVec2> {
    let position = |i: usize| f64::from(fit.segments()[i]) + fit.parameters()[i];
    let (from, mut to) = (position(from), position(to));
    if to <= from {
        to += curve.len() as f64;
    }
    (0..=count)
        .map(|i| {
            let x = i as f64 / count as f64;
            let at = match dense {
                Ordering::Less => x.powi(3),
                Ordering::Equal => x,
                Ordering::Greater => 1.0 - (1.0 - x).powi(3),
            };
            let at = from + (to - from) * at;
            let segment = (at.ceil() - 1.0).max(0.0);
            let controls = curve.segment(segment as usize % curve.len());
            let controls: Vec<DVec2> = controls.iter().map(|p| p.truncate()).collect();
            point_of_segment(&controls, at - segment)
        })
        .collect()
}

/// For each point the largest loop there by brute force, in lengths of the smallest span that takes part.
/// Runs of close points are shorter than one of the spans at their ends, or without `are_runs_short` of any length.
fn loops_by_brute_force(
    fit: &Fit,
    points: &[[f64; 2]],
    samples_per_span: usize,
    are_runs_short: bool,
) -> Vec<Option<f64>> {
    let stops: Vec<usize> = (0..points.len())
        .filter(|&i| !matches!(fit.statuses()[i], PointStatus::Merged | PointStatus::Missed))
        .collect();
    let (count, curve) = (stops.len(), fit.curve(0));
    let mut found = vec![None; points.len()];
    if count < 2 || curve.is_empty() {
        return found;
    }
    let closed = curve.is_closed() && count > 2;
    let spans = if closed { count } else { count - 1 };
    let stop = |k: usize| stops[k % count];
    let sampled = |dense: Ordering| -> Vec<Vec<DVec2>> {
        (0..spans).map(|k| samples(fit, &curve, [stop(k), stop(k + 1)], dense, samples_per_span)).collect()
    };
    let [starts, even, ends] = [Ordering::Less, Ordering::Equal, Ordering::Greater].map(sampled);
    let lengths: Vec<f64> = even.iter().map(|span| distances_along(span)[samples_per_span]).collect();
    let mut enter = |k: usize, size: f64| {
        let own: &mut Option<f64> = &mut found[stop(k)];
        *own = Some(own.map_or(size, |own| own.max(size)));
    };
    for k in 0..spans {
        if let Some(length) = largest_loop(&even[k], &even[k], true) {
            enter(k, length / lengths[k]);
            enter(k + 1, length / lengths[k]);
        }
        let after = if closed { spans.saturating_sub(2) } else { spans - 1 - k };
        if after >= 1 {
            let next = (k + 1) % spans;
            if let Some(length) = largest_loop(&ends[k], &starts[next], false) {
                enter(k + 1, length / lengths[k].min(lengths[next]));
            }
        }
        let line: [DVec2; 4] = std::array::from_fn(|i| DVec2::from_array(points[stop(k + i)]));
        let legs = std::array::from_fn(|i| line[i + 1] - line[i]);
        if after >= 2 && !turn_back(legs, 1e-6) {
            let farther = (k + 2) % spans;
            if let Some(length) = largest_loop(&even[k], &even[farther], false) {
                let size = length / lengths[k].min(lengths[farther]);
                (1..=2).for_each(|by| enter(k + by, size));
            }
        }
        // Across runs of close points.
        let place = |k: usize| DVec2::from_array(points[stop(k)]);
        let leg = |k: usize| place(k + 1) - place(k);
        let most = if closed { spans.saturating_sub(3) } else { spans - 1 - k };
        for by in 3..=most.min(16) {
            let run = (1..by).map(|i| leg(k + i).length()).sum::<f64>();
            let longer = lengths[k].max(lengths[(k + by) % spans]);
            if (run < longer || !are_runs_short)
                && !turn_back([leg(k), place(k + by) - place(k + 1), leg(k + by)], 1e-6)
            {
                let farther = (k + by) % spans;
                if let Some(length) = largest_loop(&ends[k], &starts[farther], false) {
                    let size = length / lengths[k].min(lengths[farther]);
                    (1..=by).for_each(|by| enter(k + by, size));
                }
            }
        }
    }
    found
}

/// Points at random: anywhere, in ascending order of x, walks, on a grid, spirals, walks with near repeats, and walks
/// with runs of close points.
fn random_points(random: &mut fastrand::Rng, kind: usize, count: usize) -> Vec<[f64; 2]> {
    let (mut x, mut place) = (0.0, DVec2::ZERO);
    let (turn, shrink) = (0.3 + 2.5 * random.f64(), 0.8 + 0.19 * random.f64());
    let (far, unit) = (if random.u8(..5) == 0 { 100.0 } else { 0.0 }, 4f64.powi(random.i32(-6..6)));
    let run = 10f64.powf(-1.0 - 3.0 * random.f64());
    let side = |random: &mut fastrand::Rng| 2.0 * random.f64() - 1.0;
    let next = |i: usize| {
        let point = match kind {
            0 => DVec2::new(side(random), side(random)),
            1 => {
                x += if random.bool() { 0.05 + 0.1 * random.f64() } else { 1.0 + random.f64() };
                DVec2::new(x, 1.5 * random.f64())
            }
            2 | 3 => {
                let step = if kind == 3 && random.u8(..3) == 0 { 1e-4 } else { 1.0 };
                place += step * DVec2::new(side(random), side(random));
                place
            }
            4 => DVec2::new(f64::from(random.u8(..4)), f64::from(random.u8(..4))),
            6 => {
                let step = if i % 8 < 5 { run } else { 1.0 };
                place += step * DVec2::new(0.2 + random.f64(), side(random));
                place
            }
            _ => shrink.powi(i as i32) * DVec2::from_angle(turn * i as f64),
        };
        ((point + far) * unit).to_array()
    };
    (0..count).map(next).collect()
}

#[test]
fn loops_agree_with_brute_force() {
    let mut random = fastrand::Rng::with_seed(12);
    let (mut looped, mut calm) = ([0; 7], [0; 7]);
    for case in 0..1400 {
        let (kind, count) = (case % 7, 3 + random.usize(..12));
        let points = random_points(&mut random, kind, count);
        let (curve_kind, joint) = [
            (CurveKind::Composite, JointParameter::Half),
            (CurveKind::CubicC2, JointParameter::Half),
            (CurveKind::BlendC1, JointParameter::Half),
            (CurveKind::BlendC2, JointParameter::Half),
            (CurveKind::Composite, JointParameter::Knot),
            (CurveKind::Composite, JointParameter::G2),
        ][case / 7 % 6];
        let method = [Method::Median, Method::Bisector, Method::Normal, Method::Symmedian][random.usize(..4)];
        let corner_angle = if random.u8(..3) == 0 { 1.2 } else { 9.0 };
        let options = Options { curve: curve_kind, joint, method, corner_angle, ..Options::default() };
        let fit = one(&points, random.bool(), &[], &options);
        let truth = loops_by_brute_force(&fit, &points, SAMPLES, true);
        for (i, (&status, loop_size)) in fit.statuses().iter().zip(truth).enumerate().take(count) {
            let name =
                format!("case {case}, {curve_kind:?}, {joint:?}, {method:?}, point {i}: {status:?}, {loop_size:?}");
            if status == PointStatus::Looped {
                let is_found = |samples: usize, are_runs_short: bool| {
                    loops_by_brute_force(&fit, &points, samples, are_runs_short)[i].is_some()
                };
                let is_small = || is_found(SAMPLES, false) || is_found(MANY_SAMPLES, true);
                assert!(loop_size.is_some() || is_small(), "{name}");
                looped[kind] += 1;
            } else if matches!(status, PointStatus::Ok | PointStatus::ClampedParameter | PointStatus::Crowded) {
                // Loops that are only as large as the distance of two samples are not certain.
                assert!(loop_size.is_none_or(|size| size < 0.05), "{name}");
                calm[kind] += usize::from(loop_size.is_none());
            }
        }
    }
    assert!(looped.iter().all(|&count| count > 0) && calm.iter().all(|&count| count > 500), "{looped:?} {calm:?}");
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
    // The curve crosses itself three spans on.
    let oval = [
        [-0.767534, -0.374092],
        [-0.4634640440763408, -0.498377954773524],
        [-0.4586772167230903, -0.49965922664686124],
        [-0.452216359281194, -0.5013623932600055],
        [-0.4479747657819086, -0.5024643075703029],
        [-0.4477218425870876, -0.5025296099413434],
        [-0.4474233642579532, -0.5026066158703578],
        [0.171143, -0.549656],
        [0.61838, -0.447022],
        [0.961, -0.2],
        [0.5, 0.5],
        [-0.9, 0.3],
    ];
    let fit = one(&oval, true, &[], &Options { method: Method::Median, ..Options::default() });
    assert!(fit.statuses().contains(&PointStatus::Looped));
    assert!(!statuses(Method::Bisector).contains(&PointStatus::Looped));
}

/// Points on an oval in order, of which a few are closer than the others.
fn oval_with_close_points(random: &mut fastrand::Rng) -> Vec<[f64; 2]> {
    let count = 5 + random.usize(..10);
    let mut angles: Vec<f64> = (0..count).map(|k| TAU * (k as f64 + 0.5 * random.f64()) / count as f64).collect();
    let gap = 10f64.powf(-4.0 + 3.0 * random.f64()) * TAU / count as f64;
    let mut angle = angles[random.usize(..count)];
    for _ in 0..random.usize(1..6) {
        angle += gap * (0.2 + random.f64());
        angles.push(angle);
    }
    angles.sort_by(f64::total_cmp);
    let (height, unit) = (0.5 + random.f64(), 4f64.powi(random.i32(-6..6)));
    angles.iter().map(|t| [unit * t.cos(), unit * height * t.sin()]).collect()
}

#[test]
fn curves_through_close_points_have_hardly_any_loops() {
    let mut random = fastrand::Rng::with_seed(31);
    let (mut looped, mut calm) = (0, 0);
    for case in some_of(8, 0..2000) {
        let points = oval_with_close_points(&mut random);
        for joint in [JointParameter::Half, JointParameter::Knot] {
            let closed = case % 3 > 0;
            let fit = one(&points, closed, &[], &Options { joint, ..Options::default() });
            let curve = fit.curve(0);
            let spans = points.len() - usize::from(!closed);
            // All pairs of chords of the whole curve.
            let dense: Vec<DVec2> = (0..spans)
                .flat_map(|k| {
                    let mut span = samples(&fit, &curve, [k, (k + 1) % points.len()], Ordering::Equal, 24);
                    if k + 1 < spans {
                        span.pop();
                    }
                    span
                })
                .collect();
            // The ends of a closed curve meet.
            let dense = &dense[..dense.len() - usize::from(closed)];
            let is_looped = fit.statuses().contains(&PointStatus::Looped);
            let name = format!("case {case}, {joint:?}: {points:?}");
            if largest_loop(dense, dense, true).is_some() {
                assert!(is_looped, "{name}");
            }
            if !is_crowded(&points, closed) {
                (looped, calm) = (looped + usize::from(is_looped), calm + usize::from(!is_looped));
            }
        }
    }
    assert!(300 * looped < calm, "{looped} of {calm}");
}

/// Whether a distance is below a ten-thousandth of one beside it.
fn is_crowded(points: &[[f64; 2]], closed: bool) -> bool {
    let n = points.len();
    let leg = |k: usize| DVec2::from(points[k % n]).distance(DVec2::from(points[(k + 1) % n]));
    let legs = if closed { n } else { n - 1 };
    (0..if closed { n } else { n - 2 })
        .map(|k| [leg(k), leg((k + 1) % legs.max(1))])
        .any(|[u, v]| u.min(v) < 1e-4 * u.max(v))
}

#[test]
fn curves_that_cross_as_their_points_do_have_no_loops() {
    for curve_kind in CURVE_KINDS {
        let options = Options { curve: curve_kind, ..Options::default() };
        let star: Vec<[f64; 2]> = (0..5).map(|k| TAU * 0.4 * f64::from(k)).map(|t| [t.cos(), t.sin()]).collect();
        assert!(!one(&star, true, &[], &options).statuses().contains(&PointStatus::Looped), "{curve_kind:?}");
        for count in 3..40 {
            let t = |k: usize| TAU * k as f64 / count as f64;
            let circle: Vec<[f64; 2]> = (0..count).map(|k| [t(k).cos(), t(k).sin()]).collect();
            let said = one(&circle, true, &[], &options).statuses().to_vec();
            assert!(
                !said.iter().any(|s| matches!(s, PointStatus::Looped | PointStatus::Crowded)),
                "{curve_kind:?} {count} {said:?}"
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
        for curve_kind in [CurveKind::Composite, CurveKind::CubicC2, CurveKind::BlendC1, CurveKind::BlendC2] {
            let fit = one(&points, true, &[], &Options { curve: curve_kind, ..Options::default() });
            let curve = fit.curve(0);
            let off = (0..count)
                .flat_map(|k| samples(&fit, &curve, [k, k + 1], Ordering::Equal, SAMPLES))
                .map(|p| (DVec3::from((p, 0.0)).length() / unit - 1.0).abs())
                .fold(0.0, f64::max);
            let said = (beside..beside + 2).any(|i| fit.statuses()[i] != PointStatus::Ok);
            assert!(off < 1e-3 || said, "{case} {curve_kind:?}: {off} with a gap of {gap}");
            // Merged on request.
            let merging = Options { curve: curve_kind, repeat_tolerance: 0.03, ..Options::default() };
            let merged = one(&points, true, &[], &merging);
            assert_eq!(merged.statuses()[beside + 1], PointStatus::Merged);
        }
    }
}
