//! Outlines at the limits: few points, repeated points, large numbers, and arguments that are refused.

use crate::outline::{CURVE_KINDS, assert_passes, one};
use crate::plane::lift;
use glam::DVec3;
use gusset::curve::{
    Constraint, CurveKind, Ends, FitStatus, Method, Options, Outlines, PointConstraint, PointStatus, Points, fit,
};
use gusset::{Element, Error, Job};

#[test]
fn few_points() {
    let corner = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]];
    for curve_kind in CURVE_KINDS {
        let options = Options { curve: curve_kind, ..Options::default() };
        for closed in [false, true] {
            for n in 0..3 {
                let done = one(&corner[..n], closed, &[], &options);
                let enough = n == 2 && !closed;
                assert_eq!(done.reports()[0].status == FitStatus::TooFewPoints, !enough, "{curve_kind:?} {n} {closed}");
                assert_eq!(done.curve(0).is_empty(), n < 2);
                let same = vec![[3.0, 4.0]; n];
                let done = one(&same, closed, &[], &options);
                assert_eq!(done.reports()[0].status, FitStatus::TooFewPoints);
                assert!(done.curve(0).is_empty());
            }
        }
        // Two points give a line; a closing point that repeats the first does no harm.
        assert_passes(&corner[..2], &one(&corner[..2], false, &[], &options), "line");
        let mut again = corner.to_vec();
        again.push([0.0, 0.0]);
        let (plain, closing) = (one(&corner, true, &[], &options), one(&again, true, &[], &options));
        assert_eq!(plain.curve(0).points(), closing.curve(0).points());
        assert_eq!(closing.statuses()[3], PointStatus::Merged);
        assert_eq!(closing.place(3), closing.place(0));
    }
    // Three points of an open outline are one section.
    let done = one(&corner, false, &[], &Options::default());
    let section = Method::Bisector.compute_section(lift(corner[0]), lift(corner[1]), lift(corner[2])).unwrap();
    assert_eq!(done.curve(0).len(), 1);
    assert!(done.curve(0).segment(0)[1].distance(section.control) < 1e-15);
}

#[test]
fn what_is_no_outline_is_refused() {
    let points = [[0.0, 0.0], [1.0, 0.0], [1.0, f64::NAN]];
    fn outlines<'a>(points: &'a [[f64; 2]], offsets: Option<&'a [u32]>, constraints: &'a [Constraint]) -> Outlines<'a> {
        Outlines { points: Points::from(points), offsets, closed: true, constraints }
    }
    let refused = |outlines: Outlines<'_>, options: Options| fit(&outlines, &options, &Job::default()).unwrap_err();
    let plain = Options::default();
    assert!(matches!(
        refused(outlines(&points, None, &[]), plain),
        Error::NotFinite { element: Element::Point, index: 2, .. }
    ));
    for offsets in [&[][..], &[1, 3], &[0, 2], &[0, 4], &[0, 2, 1, 3]] {
        assert!(
            matches!(refused(outlines(&points, Some(offsets), &[]), plain), Error::BadOffsets { .. }),
            "{offsets:?}"
        );
    }
    let corner = |point| Constraint { point, kind: PointConstraint::Corner };
    for constraints in [&[corner(3)][..], &[corner(1), corner(1)], &[corner(1), corner(0)]] {
        assert!(matches!(refused(outlines(&points, None, constraints), plain), Error::BadConstraint { .. }));
    }
    let good = &points[..2];
    let nowhere = [corner(0), Constraint { point: 1, kind: PointConstraint::Tangent(DVec3::NAN) }];
    let error = refused(outlines(good, None, &nowhere), plain);
    assert!(matches!(error, Error::NotFinite { element: Element::Constraint, index: 1, .. }), "{error}");
    for (option, options) in [
        ("alpha", Options { method: Method::Alpha(1.5), ..plain }),
        ("alpha", Options { method: Method::Alpha(f64::NAN), ..plain }),
        ("parameter_limit", Options { parameter_limit: Some(0.5), ..plain }),
        ("repeat_tolerance", Options { repeat_tolerance: -1.0, ..plain }),
        ("corner_angle", Options { corner_angle: f64::NAN, ..plain }),
        ("tolerance", Options { tolerance: f64::INFINITY, ..plain }),
        ("first_step", Options { first_step: 0.0, ..plain }),
        ("step_divisor", Options { step_divisor: 1.0, ..plain }),
        ("max_sweeps", Options { max_sweeps: 0, ..plain }),
        ("max_steps", Options { max_steps: 0, ..plain }),
    ] {
        match refused(outlines(good, None, &[]), options) {
            Error::OptionOutOfRange { option: named, .. } => assert_eq!(named, option),
            other => panic!("{option}: {other}"),
        }
    }
}

#[test]
fn repeats_at_the_end_of_a_closed_outline() {
    // Two points that repeat the first one but not each other; and with corners, which turn the
    // nodes round.
    for curve_kind in
        [CurveKind::Composite, CurveKind::BlendC1, CurveKind::BlendC2, CurveKind::CubicC2, CurveKind::Single]
    {
        for corner in [false, true] {
            let e = 0.7e-12;
            let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, -e], [0.0, e], [e, -0.1 * e]];
            let constraints = [Constraint { point: 2, kind: PointConstraint::Corner }];
            let constraints = if corner { &constraints[..] } else { &[] };
            let done = one(&points, true, constraints, &Options { curve: curve_kind, ..Options::default() });
            assert_passes(&points, &done, "repeats");
            assert_eq!(done.statuses()[4..], [PointStatus::Merged; 3], "{curve_kind:?}");
            assert!((4..7).all(|i| done.place(i) == done.place(0)), "{curve_kind:?}");
        }
    }
}

#[test]
fn statuses_do_not_depend_on_where_an_outline_begins() {
    let ring = [[0.0, 0.0], [1.0, 0.5], [2.0, 0.0], [2.0, 2.0], [1.5, 1.5], [1.0, 1.0], [0.5, 0.5]];
    for shift in 0..7 {
        let points: Vec<[f64; 2]> = (0..7).map(|i| ring[(i + shift) % 7]).collect();
        let at = |corner: usize| ((corner + 7 - shift) % 7) as u32;
        let mut corners = [at(0), at(3)];
        corners.sort_unstable();
        let constraints = corners.map(|point| Constraint { point, kind: PointConstraint::Corner });
        let done = one(&points, true, &constraints, &Options { ends: Ends::Perpendicular, ..Options::default() });
        // The curve leaves the corner upwards and crosses the straight side between points 5 and 6.
        assert_eq!(done.reports()[0].not_ok, 3, "{shift}");
        assert_eq!([0, 3].map(|corner| done.statuses()[at(corner) as usize]), [PointStatus::Collinear; 2], "{shift}");
        assert_eq!(done.statuses()[at(6) as usize], PointStatus::Looped, "{shift}");
    }
}

#[test]
fn curves_beyond_the_largest_number_are_missed() {
    for curve_kind in
        [CurveKind::Composite, CurveKind::BlendC1, CurveKind::BlendC2, CurveKind::CubicC2, CurveKind::Single]
    {
        for s in [1e300, 4e307, 9.1e307, 1.7e308] {
            let points = [[-s, 0.0], [s, 0.0], [0.0, s]];
            let done = one(&points, true, &[], &Options { curve: curve_kind, ..Options::default() });
            assert!(done.curve(0).points().iter().all(|p| p.is_finite()), "{curve_kind:?} {s:e}");
            let missed = done.statuses().contains(&PointStatus::Missed);
            assert_eq!(missed, done.reports()[0].status == FitStatus::Diverged, "{curve_kind:?} {s:e}");
            assert!(s > 1e300 || !missed, "{curve_kind:?}");
        }
    }
}
