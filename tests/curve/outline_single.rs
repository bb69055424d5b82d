//! Single curves through points: they move with their points, and keep their guides, tangents and seams.

use crate::outline_data::{Line, arc, blob, check, foot_half, sine, size, solve, solve_with};
use glam::DVec3;
use gusset::curve::{Constraint, CurveKind, FitStatus, Lock, Options, PointConstraint, PointStatus};

#[test]
fn single_curves_move_with_the_points() {
    for line in [arc(8), sine(9)] {
        let options = Options { curve: CurveKind::Single, lock: Lock::DataGuide, ..Options::default() };
        let plain = solve(&line, &options);
        assert_eq!(plain.reports()[0].status, FitStatus::Ok);
        let far = |a: &[DVec3], b: &[DVec3]| a.iter().zip(b).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max);
        let (sin, cos) = 0.7f64.sin_cos();
        let turn = |p: DVec3| DVec3::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y, p.z) * 1e5;
        let turned = Line { points: line.points.iter().map(|&p| turn(p)).collect(), ..line.clone() };
        let wanted: Vec<DVec3> = plain.points().iter().map(|&p| turn(p)).collect();
        let found = far(solve(&turned, &options).points(), &wanted) / size(&turned);
        assert!(found <= 1e-11, "turned: {found:e}");
        let mut backwards = line.clone();
        backwards.points.reverse();
        let wanted: Vec<DVec3> = plain.points().iter().rev().copied().collect();
        let found = far(solve(&backwards, &options).points(), &wanted) / size(&line);
        assert!(found <= 1e-11, "backwards: {found:e}");
    }
}

#[test]
fn single_curves_keep_their_guides() {
    let options = Options { curve: CurveKind::Single, lock: Lock::DataGuide, ..Options::default() };
    let mut most = 0;
    for n in [2, 3, 4, 5, 6, 8, 10, 12, 15, 20] {
        let mut lines = vec![arc(n + 1), sine(n + 1)];
        lines.extend((0..20).filter_map(|k| foot_half(k, n)));
        for line in lines {
            let fit = solve(&line, &options);
            let report = fit.reports()[0];
            assert_eq!(fit.curve(0).len(), 1, "{} {n} {report:?}", line.name);
            check(&line, &fit, "single");
            assert!(report.max_residual <= 1e-14, "{} {n} {report:?}", line.name);
            most = most.max(report.iterations);
            let controls = fit.curve(0).segment(0);
            let far = (1..n).map(|i| controls[i].distance(line.points[i])).fold(0.0, f64::max) / size(&line);
            let wanted = if far > 2.0 { FitStatus::IllConditioned } else { FitStatus::Ok };
            assert_eq!(report.status, wanted, "{} {n}: {far}", line.name);
            for (i, control) in controls.iter().enumerate().take(n).skip(1) {
                let [a, p, c] = [line.points[i - 1], line.points[i], line.points[i + 1]];
                let guide = ((a - p).normalize() - (c - p).normalize()).normalize();
                // The guide is across the difference of the legs' directions.
                let aside = (control - p).dot(guide).abs();
                assert!(aside <= 1e-13 * size(&line) * far.max(1.0), "{} {n} {i}: {aside:e}", line.name);
            }
            assert!(fit.parameters().windows(2).all(|pair| pair[0] < pair[1]));
        }
    }
    println!("single curves: at most {most} iterations");
    assert!(most <= 8);
}

#[test]
fn single_curves_by_parameters() {
    for line in [arc(6), sine(9)] {
        let fit = solve(&line, &Options { curve: CurveKind::Single, ..Options::default() });
        check(&line, &fit, "collocation");
        let mut knots = vec![0.0];
        line.points.windows(2).for_each(|pair| knots.push(knots[knots.len() - 1] + pair[0].distance(pair[1]).sqrt()));
        for (t, knot) in fit.parameters().iter().zip(&knots) {
            assert!((t - knot / knots[knots.len() - 1]).abs() < 1e-14);
        }
    }
}

#[test]
fn single_curves_have_their_tangents_and_seams() {
    for lock in [Lock::Parameter, Lock::DataGuide] {
        let options = Options { curve: CurveKind::Single, lock, ..Options::default() };
        let line = sine(7);
        let tangent = DVec3::new(1.0, 2.0, 0.0);
        let constraints = [
            Constraint { point: 0, kind: PointConstraint::Tangent(tangent) },
            Constraint { point: 6, kind: PointConstraint::Tangent(DVec3::X) },
        ];
        let fit = solve_with(&line, &options, &constraints);
        check(&line, &fit, "tangents");
        let controls = fit.curve(0).segment(0);
        assert_eq!((fit.curve(0).len(), controls.len()), (1, 9));
        let legs = [(controls[1] - controls[0]).normalize(), (controls[8] - controls[7]).normalize()];
        assert!(legs[0].distance(tangent.normalize()) < 1e-14 && legs[1].distance(DVec3::X) < 1e-14, "{legs:?}");
        // Closed: smooth where it begins.
        for n in [3, 5, 7] {
            let line = blob(n, 0.0);
            let fit = solve(&line, &options);
            check(&line, &fit, "closed");
            let controls = fit.curve(0).segment(0);
            assert_eq!((fit.curve(0).len(), controls.len(), fit.curve(0).is_closed()), (1, n + 3, true));
            let (first, last) = (controls[1] - controls[0], controls[n + 2] - controls[n + 1]);
            assert!(first.normalize().distance(last.normalize()) < 1e-13, "{first} {last}");
            assert!(first.dot(line.points[1] - line.points[n - 1]) > 0.0, "{first}");
        }
    }
    let line = blob(80, 0.0);
    let fit = solve(&line, &Options { curve: CurveKind::Single, ..Options::default() });
    check(&line, &fit, "many");
    assert_eq!((fit.reports()[0].status, fit.curve(0).len()), (FitStatus::DegreeTooHigh, 80));
    assert!(fit.statuses().iter().all(|&status| status == PointStatus::CompositeInstead));
}
