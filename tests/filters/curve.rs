//! Filters of curves, held against curves that are known by formula.

use crate::common;
use crate::editor::{
    circle, curve, lines, mesh, number, polylines, radius, run_on, run_on_curves, text, value, values,
};
use gusset::filters::Filter;
use gusset::filters::data::{Curves, Input, Output};
use gusset::{Error, Job};
use std::f64::consts::{PI, TAU};

/// A closed polyline and an open one.
fn curves() -> Curves {
    let points = (0..12).map(|i| {
        let (sin, cos) = (std::f64::consts::TAU * f64::from(i) / 7.0).sin_cos();
        [cos * if i < 7 { 1.0 } else { 2.0 }, sin, 0.0]
    });
    Curves { points: points.collect(), offsets: vec![0, 7, 12], closed: vec![true, false] }
}

#[test]
fn outline_draws_through_the_points() {
    let given = curves();
    let filter = Filter::find("outline").unwrap();
    for curve in 0..5 {
        let outputs = filter.run(&[Input::Curves(&given)], &[f64::from(curve)], &Job::default()).unwrap();
        let [Output::Curves(drawn), Output::Text(text)] = outputs.as_slice() else { panic!("{outputs:?}") };
        assert_eq!((drawn.offsets.len(), drawn.closed.as_slice()), (3, &[true, false][..]), "{text}");
        assert!(text.starts_with("curve 0: 7 points, "), "{text}");
        for p in &given.points {
            // The chord error is 1e-4 of the size, which is at most 4.
            let at = |a: [f64; 3], b: [f64; 3]| {
                let (u, v) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
                let t = ((u[0] * v[0] + u[1] * v[1]) / (u[0] * u[0] + u[1] * u[1])).clamp(0.0, 1.0);
                (v[0] - t * u[0]).hypot(v[1] - t * u[1])
            };
            let nearest = drawn.points.windows(2).map(|pair| at(pair[0], pair[1])).fold(f64::MAX, f64::min);
            assert!(nearest < 4e-4, "{curve}: {nearest}");
        }
    }
    let none = Curves::default();
    let outputs = filter.run(&[Input::Curves(&none)], &[], &Job::default()).unwrap();
    assert_eq!(outputs.len(), 2);
    let wrong = Curves { offsets: vec![0, 9], ..Curves::default() };
    assert!(matches!(filter.run(&[Input::Curves(&wrong)], &[], &Job::default()), Err(Error::BadOffsets { .. })));
    let soups = [common::sheet(2, 2)];
    assert!(run_on("outline", &soups, &[]).is_err());
}

/// The values of a filter of curves: suggestions, and some set.
fn set(id: &str, curves: &Curves, named: &[(&str, &[f64])]) -> Vec<f64> {
    values(id, &[Input::Curves(curves)], named)
}

/// Points in the plane through (1, 2, 3) across (1, 1, 1), from coordinates in it.
fn tilted(points: Vec<[f64; 3]>) -> Vec<[f64; 3]> {
    let (u, v) = ([0.5f64.sqrt(), -(0.5f64.sqrt()), 0.0], [1.0 / 6f64.sqrt(), 1.0 / 6f64.sqrt(), -2.0 / 6f64.sqrt()]);
    let place = |p: [f64; 3]| [0, 1, 2].map(|k| [1.0, 2.0, 3.0][k] + p[0] * u[k] + p[1] * v[k]);
    points.into_iter().map(place).collect()
}

#[test]
fn measures_of_circles_and_squares() {
    let square = vec![[0.0; 3], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0]];
    let curves = polylines(&[(square, true), (tilted(circle(24, 2.0, [0.0; 3])), true), (Vec::new(), false)]);
    let outputs = run_on_curves("curve_measures", std::slice::from_ref(&curves), &[]).unwrap();
    let report = text(&outputs[0]);
    let first = report.lines().next().unwrap();
    assert!(first.contains("closed, length 8, area 4, seen along (0 0 1), box (0 0 0) to (2 2 0)"), "{first}");
    assert!(report.contains("curve 2: open, without points\n3 curves, length"), "{report}");
    let polygon = 24.0 * 2.0 * (PI / 24.0).sin() * 2.0;
    assert!((value(&outputs[0], "length") - 8.0 - polygon).abs() < 1e-12);
    // In words to six digits.
    assert!((number(report.lines().nth(1).unwrap(), "length") / polygon - 1.0).abs() < 5e-6, "{report}");
    // A smooth curve through the points is a circle within a thousandth.
    let outputs = run_on_curves("curve_measures", &[curves], &[1.0]).unwrap();
    let smooth = text(&outputs[0]).lines().nth(1).unwrap();
    assert!((number(smooth, "length") / (2.0 * TAU) - 1.0).abs() < 1e-4, "{smooth}");
    assert!((number(smooth, "area") / (4.0 * PI) - 1.0).abs() < 1e-4, "{smooth}");
}

#[test]
fn resampled_curves_have_points_as_asked() {
    let straight =
        polylines(&[(vec![[0.0; 3], [1.0, 0.0, 0.0], [4.0, 0.0, 0.0]], false), (circle(90, 1.0, [0.0; 3]), true)]);
    let by_number = run_on_curves("curve_resample", std::slice::from_ref(&straight), &[0.0, 0.0, 9.0]).unwrap();
    let found = lines(&by_number[0]);
    assert_eq!((found.offsets.as_slice(), found.closed.as_slice()), (&[0, 9, 18][..], &[false, true][..]));
    assert!(curve(found, 0).iter().enumerate().all(|(k, p)| (p[0] - 0.5 * k as f64).abs() < 1e-9));
    let sides: Vec<f64> = (0..9)
        .map(|k| {
            let (p, q) = (curve(found, 1)[k], curve(found, 1)[(k + 1) % 9]);
            (p[0] - q[0]).hypot(p[1] - q[1])
        })
        .collect();
    assert!(sides.iter().all(|side| (side - sides[0]).abs() < 1e-3), "{sides:?}");
    let by_step = run_on_curves("curve_resample", std::slice::from_ref(&straight), &[0.0, 1.0, 2.0, 1.5]).unwrap();
    let xs: Vec<f64> = curve(lines(&by_step[0]), 0).iter().map(|p| p[0]).collect();
    assert!(xs.iter().zip([0.0, 1.5, 3.0, 4.0]).all(|(x, y)| (x - y).abs() < 1e-9) && xs.len() == 4, "{xs:?}");
    // Few points on a smooth circle, none farther off than asked for.
    let by_chord =
        set("curve_resample", &straight, &[("between", &[1.0]), ("spacing", &[2.0]), ("chord_error", &[1e-3])]);
    let by_chord = run_on_curves("curve_resample", &[straight], &by_chord).unwrap();
    let points = curve(lines(&by_chord[0]), 1);
    let middle = |k: usize| {
        let (p, q) = (points[k], points[(k + 1) % points.len()]);
        radius(&[0, 1, 2].map(|x| (p[x] + q[x]) / 2.0))
    };
    assert!((0..points.len()).all(|k| middle(k) > 1.0 - 6e-3), "{}", points.len());
}

#[test]
fn offsets_of_circles_are_circles() {
    for plane in [false, true] {
        let lay = |points: Vec<[f64; 3]>| if plane { tilted(points) } else { points };
        let curves = polylines(&[(lay(circle(64, 2.0, [0.0; 3])), true)]);
        let named: &[(&str, &[f64])] = &[("between", &[2.0]), ("distance", &[0.5]), ("chord_error", &[1e-5])];
        let outputs =
            run_on_curves("curve_offset", std::slice::from_ref(&curves), &set("curve_offset", &curves, named)).unwrap();
        let centre = if plane { [1.0, 2.0, 3.0] } else { [0.0; 3] };
        let off = |p: &[f64; 3]| radius(&[0, 1, 2].map(|k| p[k] - centre[k]));
        let points = curve(lines(&outputs[0]), 0);
        // To the left of a counter-clockwise circle is its inside; the suggested normal looks up,
        // so that it may be clockwise.
        let radii: Vec<f64> = points.iter().map(off).collect();
        let expected = if radii[0] < 2.0 { 1.5 } else { 2.5 };
        assert!(points.len() > 20 && radii.iter().all(|r| (r - expected).abs() < 1e-4), "{radii:?}");
        assert!(plane || expected == 1.5);
        if plane {
            assert!(points.iter().all(|p| (p.iter().sum::<f64>() - 6.0).abs() < 1e-9));
        }
    }
    // Out of the plane, and too tight.
    let curves = polylines(&[(vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.5], [0.0, 1.0, 0.0]], true)]);
    let refused = run_on_curves(
        "curve_offset",
        std::slice::from_ref(&curves),
        &set("curve_offset", &curves, &[("plane", &[0.0, 0.0, 1.0, 0.0])]),
    );
    assert!(matches!(refused, Err(Error::CurveNotPlane { point: 2, z }) if (z - 0.5).abs() < 1e-12));
    let curves = polylines(&[(circle(64, 2.0, [0.0; 3]), true)]);
    let tight = set("curve_offset", &curves, &[("between", &[2.0]), ("distance", &[3.0])]);
    assert!(text(&run_on_curves("curve_offset", &[curves], &tight).unwrap()[1]).contains("less than the distance"));
}

#[test]
fn curves_meet_where_formulas_say() {
    // A circle and a line at height 0.6, which meet at x = +-0.8; a figure of eight that meets
    // itself; a line that passes the others by.
    let eight = (0..100).map(|k| {
        let (sin, cos) = (TAU * (f64::from(k) + 0.5) / 100.0).sin_cos();
        [10.0 + cos, sin * cos, 0.0]
    });
    let curves = polylines(&[
        (circle(300, 1.0, [0.0; 3]), true),
        (vec![[-3.0, 0.6, 0.0], [3.0, 0.6, 0.0]], false),
        (eight.collect(), true),
        (vec![[0.0, 0.6, 0.25], [0.0, 0.6, 5.0]], false),
    ]);
    let outputs = run_on_curves("curve_meet", std::slice::from_ref(&curves), &[2.0, 0.0]).unwrap();
    let places = lines(&outputs[0]);
    let mut points = places.points.clone();
    points.sort_by(|p, q| p[0].total_cmp(&q[0]));
    assert_eq!(points.len(), 3, "{}", text(&outputs[1]));
    for (p, x) in points.iter().zip([[-0.8, 0.6], [0.8, 0.6], [10.0, 0.0]]) {
        assert!((p[0] - x[0]).hypot(p[1] - x[1]) < 1e-5, "{p:?}");
    }
    // Wider: the two lines, a quarter apart; in the middle between them.
    let outputs = run_on_curves("curve_meet", &[curves], &[0.0, 0.3]).unwrap();
    let near = |p: &&[f64; 3]| p[0].abs() < 1e-9 && (p[2] - 0.125).abs() < 1e-9;
    assert_eq!(lines(&outputs[0]).points.iter().filter(near).count(), 1, "{}", text(&outputs[1]));
}

#[test]
fn nearest_points_are_on_the_rays_from_the_centre() {
    let from = polylines(&[(vec![[3.0, 4.0, 0.0], [0.3, -0.4, 0.0], [0.0, 2.0, 1.0]], false)]);
    let to = polylines(&[(circle(200, 1.0, [0.0; 3]), true), (vec![[0.0, 2.0, 2.0]], false), (Vec::new(), false)]);
    let outputs = run_on_curves("curve_nearest", &[from.clone(), to], &[2.0]).unwrap();
    let ways = lines(&outputs[0]);
    let ends = [[0.6, 0.8, 0.0], [0.6, -0.8, 0.0], [0.0, 2.0, 2.0]];
    for (k, end) in ends.iter().enumerate() {
        let way = curve(ways, k);
        assert!(way[0] == from.points[k] && (0..3).all(|x| (way[1][x] - end[x]).abs() < 1e-6), "{way:?}");
    }
    assert_eq!(text(&outputs[1]), "3 points: largest distance 4, mean 1.83333, root mean square 2.39792\n");
    assert!((value(&outputs[1], "mean_distance") - 5.5 / 3.0).abs() < 1e-6);
    assert!((value(&outputs[1], "root_mean_square_distance") - (17.25f64 / 3.0).sqrt()).abs() < 1e-5);
    let none = run_on_curves("curve_nearest", &[from, Curves::default()], &[]);
    assert_eq!(none, Err(Error::EmptyCurve));
}

#[test]
fn nearest_points_of_many_curves_are_the_nearest_of_all_segments() {
    // Some random walks, of which one is a point, and one runs where the others do not.
    let mut state = 1u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let mut walks: Vec<(Vec<[f64; 3]>, bool)> = Vec::new();
    for k in 0..40 {
        let (count, far) = (1 + k % 17, if k == 7 { 1e3 } else { 0.0 });
        let mut at = [0; 3].map(|_| 4.0 * random() + far);
        let walk = (0..count).map(|_| {
            at = at.map(|x| x + random());
            at
        });
        walks.push((walk.collect(), k % 3 == 0 && count > 2));
    }
    let queries: Vec<[f64; 3]> = (0..500).map(|_| [0; 3].map(|_| 6.0 * random())).collect();
    let given = [polylines(&[(queries.clone(), false)]), polylines(&walks)];
    let outputs = run_on_curves("curve_nearest", &given, &[]).unwrap();
    for (k, query) in queries.iter().enumerate() {
        let q = glam::DVec3::from(*query);
        let segments = walks.iter().flat_map(|(points, closed)| {
            let last = if *closed { points.len() } else { points.len() - 1 };
            let alone = (points.len() == 1).then_some((points[0], points[0]));
            (0..last).map(|i| (points[i], points[(i + 1) % points.len()])).chain(alone)
        });
        let least = segments
            .map(|(a, b)| {
                let (a, along) = (glam::DVec3::from(a), glam::DVec3::from(b) - glam::DVec3::from(a));
                let t = if along.length() > 0.0 { (q - a).dot(along) / along.length_squared() } else { 0.0 };
                (a + t.clamp(0.0, 1.0) * along).distance(q)
            })
            .fold(f64::INFINITY, f64::min);
        let way = curve(lines(&outputs[0]), k);
        assert!(way[0] == *query && (glam::DVec3::from(way[1]).distance(q) - least).abs() < 1e-12, "{k}: {way:?}");
    }
}

#[test]
fn far_curves_do_not_blur_near_ones() {
    let query = [3e-4, 1e-6, 0.0];
    for far in [1e6, 1e10, 1e14, 1e200] {
        let near = vec![[0.0; 3], [1e-3, 0.0, 0.0]];
        let given = [
            polylines(&[(vec![query, [0.5 * far, 0.0, -far], [-16.0 * far, 0.0, 1.0]], false)]),
            polylines(&[(vec![[far, 0.0, 0.0], [far, 1.0, 0.0]], false), (near, false)]),
        ];
        let outputs = run_on_curves("curve_nearest", &given, &[]).unwrap();
        let way = curve(lines(&outputs[0]), 0);
        assert!(way[0] == query && (way[1][0] - 3e-4).abs() < 1e-18 && way[1][1] == 0.0, "{far}: {way:?}");
        // The left end of what lies farthest to the left.
        assert_eq!(curve(lines(&outputs[0]), 2)[1], [0.0; 3], "{far}");
    }
    // The first of equally near curves; without queries a curve is not needed.
    let post = |x: f64| (vec![[x, 0.0, 0.0], [x, 0.0, 1.0]], false);
    let given = [polylines(&[(vec![[0.0; 3]], false)]), polylines(&[post(3.0), post(1.0), post(-1.0)])];
    let outputs = run_on_curves("curve_nearest", &given, &[]).unwrap();
    assert_eq!(curve(lines(&outputs[0]), 0)[1], [1.0, 0.0, 0.0]);
    assert!(run_on_curves("curve_nearest", &[polylines(&[]), polylines(&[])], &[]).is_ok());
}

#[test]
fn svg_paths_are_the_curves() {
    let square = polylines(&[
        (vec![[0.0; 3], [2.0, 0.0, 0.0], [2.0, 1.5, 0.0]], true),
        (vec![[0.0; 3], [1.0, 1.0, 0.0]], false),
    ]);
    let outputs = run_on_curves("curve_svg", std::slice::from_ref(&square), &[]).unwrap();
    assert_eq!(text(&outputs[0]), "M 0 0 L 2 0 L 2 1.5 L 0 0 Z\nM 0 0 L 1 1\n");
    let down = set("curve_svg", &square, &[("downwards", &[1.0])]);
    assert_eq!(
        text(&run_on_curves("curve_svg", &[square], &down).unwrap()[0]),
        "M 0 0 L 2 0 L 2 -1.5 L 0 0 Z\nM 0 0 L 1 -1\n"
    );
    // Read by another library: the area of a smooth circle.
    let round = polylines(&[(tilted(circle(40, 3.0, [0.0; 3])), true)]);
    for (between, letter) in [(1.0, 'Q'), (2.0, 'C')] {
        let path = run_on_curves(
            "curve_svg",
            std::slice::from_ref(&round),
            &set("curve_svg", &round, &[("between", &[between])]),
        )
        .unwrap();
        let path = text(&path[0]);
        assert!(path.contains(letter), "{path}");
        let area = kurbo::Shape::area(&kurbo::BezPath::from_svg(path).unwrap()).abs();
        assert!((area / (9.0 * PI) - 1.0).abs() < 1e-4, "{area}");
    }
}

#[test]
fn a_turned_line_is_a_cone_and_a_turned_circle_a_torus() {
    let line = polylines(&[(vec![[0.0; 3], [3.0, 0.0, 4.0]], false)]);
    let named: &[(&str, &[f64])] = &[("columns", &[500.0]), ("point", &[0.0; 3]), ("direction", &[0.0, 0.0, 1.0])];
    let (points, faces) = {
        let outputs = run_on_curves("net_lathe", std::slice::from_ref(&line), &set("net_lathe", &line, named)).unwrap();
        let (points, faces) = mesh(&outputs[0]);
        (points, faces.into_iter().map(<[u32]>::to_vec).collect::<Vec<_>>())
    };
    assert_eq!((points.len(), faces.len()), (501, 500));
    assert!(points.iter().all(|p| (p[0].hypot(p[1]) - 0.75 * p[2]).abs() < 1e-12));
    // About the line x = 5, y = 0 along z.
    let ring = polylines(&[(circle(100, 1.0, [8.0, 0.0, 2.0]).iter().map(|p| [p[0], 0.0, p[1]]).collect(), true)]);
    let named: &[(&str, &[f64])] =
        &[("columns", &[300.0]), ("point", &[5.0, 0.0, 7.0]), ("direction", &[0.0, 0.0, 2.0])];
    let outputs = run_on_curves("net_lathe", std::slice::from_ref(&ring), &set("net_lathe", &ring, named)).unwrap();
    let (points, faces) = mesh(&outputs[0]);
    assert_eq!(common::euler(faces.iter().copied()), 0);
    assert!(common::edge_counts(faces.iter().copied()).values().all(|&count| count == (1, 1)));
    // Pappus: 2 pi R times the area.
    let volume = common::volume(|v| points[v as usize], faces.into_iter()).abs();
    assert!((volume / (TAU * 3.0 * PI) - 1.0).abs() < 2e-3, "{volume}");
    let empty = run_on_curves("net_lathe", &[polylines(&[(Vec::new(), false)])], &[]);
    assert_eq!(empty, Err(Error::EmptyCurve));
    // In rows of equal length, from pole to pole, through smooth points.
    let half = (0..21).map(|k| (PI * f64::from(k) / 20.0).sin_cos()).map(|(sin, cos)| [sin, 0.0, cos]).collect();
    let half = polylines(&[(half, false)]);
    let named: &[(&str, &[f64])] = &[("rows", &[31.0]), ("between", &[2.0]), ("columns", &[40.0])];
    let outputs = run_on_curves("net_lathe", std::slice::from_ref(&half), &set("net_lathe", &half, named)).unwrap();
    let (points, faces) = mesh(&outputs[0]);
    assert_eq!((points.len(), common::euler(faces.iter().copied())), (29 * 40 + 2, 2));
    assert!(points.iter().all(|p| (radius(p) - 1.0).abs() < 1e-3));
}
