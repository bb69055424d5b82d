//! Curves and lines where rounding decides, against the roots that the curves are made from.

use glam::DVec3;
use gusset::Job;
use gusset::curve::CurveView;

/// The control points of y = f(x) over 0 <= x <= 1, by the Bernstein coefficients of f.
fn graph(coefficients: &[f64]) -> Vec<DVec3> {
    let n = (coefficients.len() - 1) as f64;
    coefficients.iter().enumerate().map(|(i, &y)| DVec3::new(i as f64 / n, y, 0.0)).collect()
}

/// The product of two polynomials in Bernstein form.
fn product(f: &[f64], g: &[f64]) -> Vec<f64> {
    let binomial = |n: usize, k: usize| (0..k).fold(1.0, |b, i| b * (n - i) as f64 / (i + 1) as f64);
    let (n, m) = (f.len() - 1, g.len() - 1);
    let term = |i: usize, j: usize| binomial(n, i) * f[i] * binomial(m, j) * g[j] / binomial(n + m, i + j);
    (0..=n + m).map(|k| (k.saturating_sub(m)..=k.min(n)).map(|i| term(i, k - i)).sum()).collect()
}

/// Where a graph meets y = 0.
fn zeros(points: &[DVec3]) -> Vec<f64> {
    let ends = [0, points.len() as u32 - 1];
    let curve = CurveView::new(points, &ends, false).unwrap();
    let found = curve.intersect_line(DVec3::ZERO, DVec3::X, &Job::default()).unwrap();
    assert!(found.inside.is_empty());
    found.places.iter().map(|place| place.t).collect()
}

/// Curves that touch the line, lifted by less than what still counts as touching, 1.4e-14 of their
/// size: every touch is found, once. Lifted away by more there is none.
#[test]
fn every_touch_is_found_and_no_other() {
    let factors: [&[f64]; 5] = [&[1.0], &[-0.3, 0.7], &[0.7, -0.3], &[0.35, -0.1, 0.25], &[1.0, 0.2, 0.3, 1.0]];
    for (k, factor) in factors.iter().enumerate() {
        for i in 1..600 {
            let a = f64::from(i) / 600.0 + 1e-4 * (f64::from(i) * 0.7).sin();
            let away = factor.iter().enumerate().fold(0.0, |y, (j, c)| {
                let (n, mut b) = (factor.len() - 1, 1.0);
                (0..j).for_each(|i| b = b * (n - i) as f64 / (i + 1) as f64);
                y + c * b * a.powi(j as i32) * (1.0 - a).powi((n - j) as i32)
            });
            if away.abs() < 0.05 {
                continue;
            }
            let square = [a * a, -a * (1.0 - a), (1.0 - a) * (1.0 - a)];
            for (lift, touches) in [(0.0, 1), (5e-15, 1), (-5e-15, 1), (1e-13, 0)] {
                let y: Vec<f64> = product(&square, factor).iter().map(|y| y + lift * away.signum()).collect();
                let found = zeros(&graph(&y));
                let near = found.iter().filter(|&&t| (t - a).abs() < 1e-5).count();
                assert_eq!(near, touches, "factor {k}, touch at {a}, lifted by {lift}: {found:?}");
            }
        }
    }
}

#[test]
fn touches_that_rounding_turned_either_way() {
    let y = [-0.089_011_281_553_259_71, 0.125_572_047_884_136_95, -0.147_675_161_521_046_48, 0.091_247_090_231_189_99];
    let found = zeros(&graph(&y));
    assert!(found.len() == 2 && (found[0] - 0.334_875_299_67).abs() < 1e-7, "{found:?}");
}

/// A line or a plane is the same whichever of its points is given, however far away.
#[test]
fn a_far_point_of_the_line_changes_nothing() {
    let segment = [DVec3::new(0.0, 3e-4, 0.0), DVec3::new(1.0, 3e-4, 0.0)];
    let arch = graph(&[-0.25, 1.0, -0.25]);
    let (arch_ends, ends) = ([0, 2], [0, 1]);
    let arch = CurveView::new(&arch, &arch_ends, false).unwrap();
    let near = arch.intersect_line(DVec3::ZERO, DVec3::new(4.0, 3.0, 0.0), &Job::default()).unwrap();
    assert_eq!(near.places.len(), 2);
    for far in [1.0, 1e6, 1e9, 1e12, 1e15, 2f64.powi(80), 2f64.powi(200)] {
        let curve = CurveView::new(&segment, &ends, false).unwrap();
        let found = curve.intersect_line(DVec3::new(far, 0.0, 0.0), DVec3::X, &Job::default()).unwrap();
        assert!(found.places.is_empty() && found.inside.is_empty(), "{far}: {found:?}");
        // Aslant, with a point that is exactly on the line.
        let found = arch
            .intersect_line(far.floor() * DVec3::new(4.0, 3.0, 0.0), DVec3::new(4.0, 3.0, 0.0), &Job::default())
            .unwrap();
        assert_eq!(found, near, "{far}");
    }
}
