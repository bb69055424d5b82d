//! Exported outlines, read back by another library (kurbo): every point is on the path.

use gusset::Job;
use gusset::curve::{CurveKind, Fit, Options, Outlines, Points, fit};
use kurbo::{BezPath, ParamCurve, PathEl, Point};

/// A blob by formula, and the outlines of the data folder.
fn outlines() -> Vec<(String, Vec<[f64; 2]>, bool)> {
    let blob = |i: u32| {
        let t = std::f64::consts::TAU * f64::from(i) / 23.0;
        let r = 3.0 + (3.0 * t).sin() + 0.3 * (7.0 * t).cos();
        [r * t.cos() + 1000.0, r * t.sin() - 1.0 / 3.0]
    };
    let mut all = vec![("blob".to_owned(), (0..23).map(blob).collect::<Vec<_>>(), true)];
    all.extend(crate::plane::data());
    all
}

/// The other library finds each point at its place, within the rounding of the coordinates.
fn assert_on(path: &BezPath, points: &[[f64; 2]], done: &Fit, what: &str) {
    let segments: Vec<_> = path.segments().collect();
    let far = points.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    for (i, &[x, y]) in points.iter().enumerate() {
        let place = done.place(i);
        let distance = segments[place.segment as usize].eval(place.t).distance(Point::new(x, y));
        assert!(distance <= 1e-15 * 4.0 * far, "{what}: point {i} is {distance:e} away");
    }
}

#[test]
fn svg_paths_pass_all_points() {
    for (name, points, closed) in outlines() {
        for curve_kind in [CurveKind::Composite, CurveKind::BlendC1, CurveKind::CubicC2] {
            let given = Outlines { points: Points::from(&points[..]), offsets: None, closed, constraints: &[] };
            let done = fit(&given, &Options { curve: curve_kind, ..Options::default() }, &Job::default()).unwrap();
            let text = done.curve(0).to_svg_path(&Job::default()).unwrap();
            let path = BezPath::from_svg(&text).unwrap();
            assert_eq!(path.segments().count(), done.curve(0).len(), "{name}");
            assert_eq!(text.ends_with('Z'), closed, "{name}");
            assert_on(&path, &points, &done, &format!("{name} {curve_kind:?}"));
            // The numbers read back as the same bits.
            let first = done.curve(0).points()[0];
            assert_eq!(path.elements()[0], PathEl::MoveTo(Point::new(first.x, first.y)));
        }
    }
}

#[test]
fn contours_of_fonts_pass_all_points() {
    for (name, points, closed) in outlines() {
        if !closed {
            continue;
        }
        let given = Outlines { points: Points::from(&points[..]), offsets: None, closed, constraints: &[] };
        let done = fit(&given, &Options::default(), &Job::default()).unwrap();
        let far = points.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
        let contour = done.curve(0).to_truetype_contour(1e-15 * far, &Job::default()).unwrap();
        // No point is stored but the control points: as many as there are points in the outline.
        assert_eq!(contour.points.len(), done.curve(0).len(), "{name}");
        assert!(contour.on_curve.iter().all(|&on| on == 0), "{name}");
        // As a rasteriser reads it: the points on the curve are in the middle.
        let at = |i: usize| {
            let p = contour.points[i % contour.points.len()];
            Point::new(p.x, p.y)
        };
        let mut path = BezPath::new();
        let n = contour.points.len();
        path.move_to(at(n - 1).midpoint(at(0)));
        for i in 0..n {
            path.quad_to(at(i), at(i).midpoint(at(i + 1)));
        }
        path.close_path();
        assert_on(&path, &points, &done, &name);
    }
}
