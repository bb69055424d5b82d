//! Filters of smooth surfaces, held against surfaces that are known by formula.

use crate::common::{self, Soup, sheet};
use crate::editor::{circle, curve, given, inputs, lines, mesh, number, polylines, radius, sphere, text, values};
use glam::DVec3;
use gusset::filters::Filter;
use gusset::filters::data::{Curves, Input, Output};
use gusset::mesh::PositionBuffer;
use gusset::{Error, Job};
use std::f64::consts::{PI, TAU};

/// Runs a filter on meshes.
fn run_on(id: &str, soups: &[Soup], values: &[f64]) -> Vec<Output> {
    crate::editor::run_on(id, soups, values).unwrap()
}

/// Runs a filter with some parameters set.
fn run(id: &str, inputs: &[Input<'_>], set: &[(&str, &[f64])]) -> Result<Vec<Output>, Error> {
    Filter::find(id).unwrap().run(inputs, &values(id, inputs, set), &Job::default())
}

#[test]
fn smooth_surfaces_are_nearer_to_the_truth_than_quads() {
    let given = sphere(16, 24);
    let outputs = run_on("smooth_surface", std::slice::from_ref(&given), &[0.0, 1e-4, 4.0, 1.0]);
    let [Output::Mesh(mesh, _), Output::Text(_)] = outputs.as_slice() else { panic!("of other kinds") };
    let PositionBuffer::F64(points) = &mesh.positions else { panic!("of another type") };
    assert!(points.len() > 16 * 24 * 10);
    // The quads' middles are off by a per cent.
    assert!(points.iter().all(|p| (radius(p) - 1.0).abs() < 1e-3));
    assert!(given.points.iter().all(|p| points.iter().any(|q| (0..3).all(|k| (p[k] - q[k]).abs() < 1e-12))));
    let faces = || mesh.face_offsets.windows(2).map(|w| &mesh.face_corners[w[0] as usize..w[1] as usize]);
    assert_eq!(common::euler(faces()), 2);
    // Seen from outside, as the quads are.
    for face in faces() {
        let [a, b, c] = [0, 1, 2].map(|k| glam::DVec3::from_array(points[face[k] as usize]));
        assert!((b - a).cross(c - a).dot(a + b + c) > 0.0);
    }
}

#[test]
fn smooth_sections_are_circles() {
    let given = [sphere(32, 48)];
    let outputs = run_on("smooth_sections", &given, &[0.0, 0.0, 0.0, 1.0, 0.0, 5.0]);
    let [Output::Curves(curves), Output::Text(text)] = outputs.as_slice() else { panic!("{outputs:?}") };
    assert!(text.starts_with("5 curves, 5 of them closed"), "{text}");
    for (k, ends) in curves.offsets.windows(2).enumerate() {
        // The box of the surface is a little larger than the sphere's.
        let points = &curves.points[ends[0] as usize..ends[1] as usize];
        let height = points[0][2];
        assert!((height + 0.8 - 0.4 * k as f64).abs() < 0.01, "{height}");
        for p in points {
            assert!((p[2] - height).abs() < 1e-6 && (radius(p) - 1.0).abs() < 1e-4, "{p:?}");
        }
    }
    // At given places: one cuts, two pass above.
    let outputs = run_on("smooth_sections", &given, &[0.0, 1.0, 0.0, 0.0, 1.0, 3.0, 0.5, 0.75]);
    let [Output::Curves(curves), _] = outputs.as_slice() else { panic!("{outputs:?}") };
    assert_eq!(curves.closed, [true]);
    assert!(curves.points.iter().all(|p| (p[0] - 0.5).abs() < 1e-9));
}

#[test]
fn smooth_silhouettes_are_great_circles() {
    let outputs = run_on("smooth_silhouette", &[sphere(32, 48)], &[0.0, 1.0, 2.0, 3.0]);
    let [Output::Curves(curves), Output::Text(_)] = outputs.as_slice() else { panic!("{outputs:?}") };
    assert!(curves.points.len() > 30);
    for p in &curves.points {
        assert!((p[0] + 2.0 * p[1] + 3.0 * p[2]).abs() < 1e-2 && (radius(p) - 1.0).abs() < 1e-4, "{p:?}");
    }
}

#[test]
fn distances_from_smooth_surfaces() {
    let (mut shifted, grid) = (sphere(8, 12), sphere(32, 48));
    shifted.points.iter_mut().flatten().for_each(|x| *x *= 1.1);
    let outputs = run_on("smooth_distance", &[shifted, grid], &[]);
    let [Output::Mesh(mesh, _), Output::Text(text)] = outputs.as_slice() else { panic!("of other kinds") };
    let PositionBuffer::F64(points) = &mesh.positions else { panic!("of another type") };
    assert!(points.iter().all(|p| (radius(p) - 1.0).abs() < 1e-4));
    let largest: f64 = text.split("largest distance ").nth(1).unwrap().split(',').next().unwrap().parse().unwrap();
    assert!((largest - 0.1).abs() < 1e-4, "{text}");
    // Two grids are none.
    let [first, second] = crate::editor::pieces(100);
    let both = [first.and(&second)];
    let refused = crate::editor::run_on("smooth_surface", &both, &[]);
    assert!(matches!(refused, Err(Error::NoGrid { .. })));
}

#[test]
fn isophotes_of_a_sphere_are_parallels() {
    let soup = sphere(32, 48);
    let ball = [Input::Mesh(soup.view())];
    // Angles 15, 45, 75 and so on from the direction.
    let outputs = run("smooth_isophotes", &ball, &[("number", &[6.0]), ("direction", &[0.0, 3.0, 4.0])]).unwrap();
    let curves = lines(&outputs[0]);
    assert_eq!(curves.closed.len(), 6, "{}", text(&outputs[1]));
    let mut angles = Vec::new();
    for c in 0..6 {
        let cosine = |p: &[f64; 3]| ((0.6 * p[1] + 0.8 * p[2]) / radius(p)).acos().to_degrees();
        let first = cosine(&curve(curves, c)[0]);
        assert!(curve(curves, c).iter().all(|p| (cosine(p) - first).abs() < 0.5), "{first}");
        angles.push(first);
    }
    angles.sort_by(f64::total_cmp);
    assert!(angles.iter().enumerate().all(|(k, angle)| (angle - 15.0 - 30.0 * k as f64).abs() < 0.3), "{angles:?}");
    let alike = run("smooth_isophotes", &ball, &[("number", &[1.0]), ("sides", &[1.0])]).unwrap();
    assert_eq!(lines(&alike[0]).closed.len(), 2);
}

#[test]
fn spheres_meet_in_a_circle() {
    let (first, mut second) = (sphere(24, 36), sphere(20, 40));
    second.points.iter_mut().for_each(|p| p[0] += 1.2);
    let outputs = run("smooth_intersect", &[Input::Mesh(first.view()), Input::Mesh(second.view())], &[]).unwrap();
    let curves = lines(&outputs[0]);
    assert_eq!(curves.closed, [true], "{}", text(&outputs[1]));
    assert!(curves.points.len() > 20);
    assert!(curves.points.iter().all(|p| (p[0] - 0.6).abs() < 1e-3 && (p[1].hypot(p[2]) - 0.8).abs() < 1e-3));
    let mut far = sphere(8, 12);
    far.points.iter_mut().for_each(|p| p[2] += 9.0);
    let apart = run("smooth_intersect", &[Input::Mesh(first.view()), Input::Mesh(far.view())], &[]).unwrap();
    assert!(lines(&apart[0]).closed.is_empty());
}

#[test]
fn lines_hit_a_sphere_twice() {
    let soup = sphere(32, 48);
    let ball = [Input::Mesh(soup.view())];
    for (which, count) in [(0.0, 2), (1.0, 1), (2.0, 1)] {
        let set: &[(&str, &[f64])] =
            &[("point", &[0.1, 0.2, 0.3]), ("direction", &[0.0, 0.0, 5.0]), ("which", &[which])];
        let outputs = run("smooth_line", &ball, set).unwrap();
        let points = &lines(&outputs[0]).points;
        assert_eq!(points.len(), count, "{}", text(&outputs[1]));
        let height = 0.95f64.sqrt();
        let expected = if count == 2 { vec![-height, height] } else { vec![height] };
        for (p, z) in points.iter().zip(expected) {
            assert!((p[0] - 0.1).abs() < 1e-9 && (p[1] - 0.2).abs() < 1e-9 && (p[2] - z).abs() < 1e-4, "{p:?}");
        }
        // The way along the unit vector.
        let last = text(&outputs[1]).lines().last().unwrap();
        assert!((number(&last.replace(':', " "), "at") - (height - 0.3)).abs() < 1e-4, "{last}");
    }
    // Suggested: from below through the middle.
    let outputs = run("smooth_line", &ball, &[("which", &[1.0])]).unwrap();
    assert_eq!(lines(&outputs[0]).points.len(), 2);
}

#[test]
fn curves_hit_a_sphere_and_their_points_have_nearest_ones() {
    let soup = sphere(32, 48);
    let curves = polylines(&[
        (vec![[-2.0, 0.1, 0.2], [2.0, 0.1, 0.2], [2.0, 3.0, 0.2]], false),
        (circle(50, 0.5, [1.0, 0.0, 0.0]), true),
    ]);
    let both = [Input::Mesh(soup.view()), Input::Curves(&curves)];
    let outputs = run("smooth_curve", &both, &[("between", &[0.0])]).unwrap();
    let points = &lines(&outputs[0]).points;
    assert_eq!(points.len(), 4, "{}", text(&outputs[1]));
    assert!(points.iter().all(|p| (radius(p) - 1.0).abs() < 1e-4));
    assert!(points[..2].iter().all(|p| (p[0].abs() - 0.95f64.sqrt()).abs() < 1e-4));
    let outputs = run("smooth_nearest", &both, &[]).unwrap();
    let ways = lines(&outputs[0]);
    assert_eq!(ways.closed.len(), 53);
    for ends in ways.points.chunks(2) {
        let r = radius(&ends[0]);
        assert!(radius(&[0, 1, 2].map(|k| ends[1][k] - ends[0][k] / r)) < 2e-4, "{ends:?}");
    }
    assert!(text(&outputs[1]).contains("0 without proof"), "{}", text(&outputs[1]));
    assert!((number(text(&outputs[1]), "largest distance") - (radius(&[2.0, 3.0, 0.2]) - 1.0)).abs() < 1e-4);
}

/// Parallels of the unit sphere from one height to another.
fn parallels(count: u32, points: u32) -> Curves {
    let ring = |k: u32| {
        let z = -0.9 + 1.8 * f64::from(k) / f64::from(count - 1);
        (circle(points, (1.0 - z * z).sqrt(), [0.0, 0.0, z]), true)
    };
    polylines(&(0..count).map(ring).collect::<Vec<_>>())
}

#[test]
fn surfaces_through_sections_are_those_that_were_cut() {
    let sections = parallels(13, 40);
    for (nodes, through) in [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 2.0)] {
        let set: &[(&str, &[f64])] = &[("nodes", &[nodes]), ("through", &[through]), ("columns", &[40.0])];
        let outputs = run("loft", &[Input::Curves(&sections)], set).unwrap();
        let (points, faces) = mesh(&outputs[0]);
        assert_eq!(common::euler(faces.iter().copied()), 0, "a tube");
        let off = points.iter().map(|p| (radius(p) - 1.0).abs()).fold(0.0, f64::max);
        // Quadratic segments along the body miss a little more at its ends.
        assert!(off < if through == 1.0 { 5e-3 } else { 1e-2 }, "{nodes} {through}: {off}");
        assert!(text(&outputs[1]).contains("13 sections of 40 nodes"), "{}", text(&outputs[1]));
    }
    // Squares with a point behind them are a pyramid: exact, with a closed tip. Smooth corners make it fuller.
    let square = |half: f64, z: f64| {
        ([[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]].map(|[x, y]| [half * x, half * y, z]).to_vec(), true)
    };
    let pyramid = polylines(&[square(1.0, 0.0), square(0.5, 1.0), (vec![[0.0, 0.0, 2.0]], false)]);
    for (corner_angle, exact) in [(-1.0, true), (PI, false)] {
        let outputs = run("loft", &[Input::Curves(&pyramid)], &[("corner_angle", &[corner_angle])]).unwrap();
        let (points, faces) = mesh(&outputs[0]);
        assert_eq!(common::euler(faces.iter().copied()), 1, "open at the base only");
        let off = points.iter().map(|p| (p[0].abs().max(p[1].abs()) - 1.0 + 0.5 * p[2]).abs()).fold(0.0, f64::max);
        assert_eq!(off < 1e-9, exact, "{corner_angle}: {off}");
    }
    // A ring of sections round the z axis is a torus.
    let turned = (0..24).map(|k| {
        let (sin, cos) = (TAU * f64::from(k) / 24.0).sin_cos();
        let place = |p: &[f64; 3]| [(3.0 + p[0]) * cos, (3.0 + p[0]) * sin, p[1]];
        (circle(24, 1.0, [0.0; 3]).iter().map(place).collect(), true)
    });
    let turned = polylines(&turned.collect::<Vec<_>>());
    let outputs = run("loft", &[Input::Curves(&turned)], &[("ring", &[1.0]), ("nodes", &[1.0])]).unwrap();
    let (points, faces) = mesh(&outputs[0]);
    assert_eq!(common::euler(faces.iter().copied()), 0);
    assert!(common::edge_counts(faces.iter().copied()).values().all(|&count| count == (1, 1)));
    let volume = common::volume(|v| points[v as usize], faces.into_iter()).abs();
    assert!((volume / (6.0 * PI * PI) - 1.0).abs() < 5e-3, "{volume}");
    let mixed = polylines(&[(circle(9, 1.0, [0.0; 3]), true), (circle(9, 1.0, [1.0; 3]), false)]);
    let refused = run("loft", &[Input::Curves(&mixed)], &[]);
    assert!(matches!(refused, Err(Error::InputUnfit { input: 0, .. })), "{refused:?}");
    let one = run("loft", &[Input::Curves(&parallels(2, 9))], &[("ring", &[1.0])]);
    let words = one.map_err(|error| error.to_string());
    assert_eq!(words.err().as_deref(), Some("input 0 has 2 curves; the filter needs at least three for a ring"));
}

/// Circles of 16 points with radius 1 round the z axis, at these heights.
fn circles_at(heights: &[f64]) -> Curves {
    polylines(&heights.iter().map(|&z| (circle(16, 1.0, [0.0, 0.0, z]), true)).collect::<Vec<_>>())
}

fn area(points: &[[f64; 3]], faces: &[&[u32]]) -> f64 {
    let at = |v: u32| DVec3::from(points[v as usize]);
    let triangle = |a, b, c| 0.5 * (at(b) - at(a)).cross(at(c) - at(a)).length();
    let face = |face: &&[u32]| face[1..].windows(2).map(|edge| triangle(face[0], edge[0], edge[1])).sum::<f64>();
    faces.iter().map(face).sum()
}

#[test]
fn repeated_sections_are_left_out_and_named() {
    let line = |section, earlier| format!("section {section} repeats section {earlier} and was left out\n");
    // Cylinders of radius 1: the area is 2 pi times the height, less 0.2 per cent for the chords.
    for (heights, height, lines) in [
        (&[0.0, 1.0][..], 1.0, vec![]),
        (&[0.0, 0.0, 1.0], 1.0, vec![line(1, 0)]),
        (&[0.0, 1.0, 1.0], 1.0, vec![line(2, 1)]),
        (&[0.0, 1e-9, 1.0, 2.0], 2.0, vec![line(1, 0)]),
        (&[0.0, 1.0, 1.0 - 1e-9, 2.0], 2.0, vec![line(2, 1)]),
        (&[0.0, 0.0, 0.0, 1.0, 2.0, 2.0], 2.0, vec![line(1, 0), line(2, 0), line(5, 4)]),
    ] {
        let sections = circles_at(heights);
        for set in [&[][..], &[("nodes", &[1.0][..])], &[("through", &[1.0])], &[("through", &[2.0])]] {
            let outputs = run("loft", &[Input::Curves(&sections)], set).unwrap();
            let ((points, faces), report) = (mesh(&outputs[0]), text(&outputs[1]));
            let ratio = area(&points, &faces) / (TAU * height);
            assert!((ratio - 1.0).abs() < 4e-3, "{heights:?} {set:?}: {ratio}");
            let mut edges =
                faces.iter().flat_map(|face| (0..face.len()).map(|i| [face[i], face[(i + 1) % face.len()]]));
            assert!(edges.all(|[a, b]| points[a as usize] != points[b as usize]), "{heights:?}: an edge of no length");
            assert!(report.ends_with(&lines.concat()), "{heights:?}: {report}");
            assert_eq!(report.matches("repeats").count(), lines.len(), "{heights:?}: {report}");
        }
    }
    // Sections that lie apart by a ten-thousandth of their size are not repetitions.
    let sections = circles_at(&[0.0, 1e-4, 1.0, 2.0]);
    let outputs = run("loft", &[Input::Curves(&sections)], &[]).unwrap();
    let ((points, faces), report) = (mesh(&outputs[0]), text(&outputs[1]));
    assert!((area(&points, &faces) / (TAU * 2.0) - 1.0).abs() < 4e-3 && !report.contains("repeats"), "{report}");
    // A ring of sections whose last one is the first one is the same torus as without it.
    let tori = [24, 25].map(|count| {
        let turned = (0..count).map(|k| {
            let (sin, cos) = (TAU * f64::from(k % 24) / 24.0).sin_cos();
            let place = |p: &[f64; 3]| [(3.0 + p[0]) * cos, (3.0 + p[0]) * sin, p[1]];
            (circle(24, 1.0, [0.0; 3]).iter().map(place).collect(), true)
        });
        let outputs = run("loft", &[Input::Curves(&polylines(&turned.collect::<Vec<_>>()))], &[("ring", &[1.0])]);
        let outputs = outputs.unwrap();
        assert_eq!(text(&outputs[1]).contains("section 24 repeats section 0 and was left out"), count == 25);
        mesh(&outputs[0]).0
    });
    assert_eq!(tori[0], tori[1]);
}

#[test]
fn sections_that_make_no_body_are_refused_by_name() {
    let refused = |curves: &Curves, set: &[(&str, &[f64])]| {
        run("loft", &[Input::Curves(curves)], set).map_err(|error| error.to_string()).unwrap_err()
    };
    let repeat = "section 1 repeats section 0; leave one of them out";
    assert_eq!(refused(&circles_at(&[0.0, 0.0]), &[]), repeat);
    assert_eq!(refused(&circles_at(&[0.0, 0.0, 1.0]), &[("ring", &[1.0])]), repeat);
    let tips = polylines(&[0.0, 1.0].map(|z| (vec![[0.0, 0.0, z]], false)));
    for nodes in [0.0, 1.0, 2.0] {
        let why = refused(&tips, &[("nodes", &[nodes])]);
        assert!(why.contains("a body needs at least one section that is a curve"), "{nodes}: {why}");
    }
}

#[test]
fn surfaces_through_nets_of_curves_contain_them() {
    // The saddle z = x y consists of straight lines.
    let line = |a: [f64; 2], b: [f64; 2]| (vec![[a[0], a[1], a[0] * a[1]], [b[0], b[1], b[0] * b[1]]], false);
    let across = polylines(&[-1.0, 0.0, 1.0].map(|x| line([x, -1.0], [x, 1.0])));
    let along = polylines(&[-1.0, 0.5, 1.0].map(|y| line([-1.0, y], [1.0, y])));
    for inputs in [&[Input::Curves(&across), Input::Curves(&along)][..], &[Input::Curves(&across)]] {
        let outputs = run("smooth_net", inputs, &[("parts", &[5.0])]).unwrap();
        let (points, faces) = mesh(&outputs[0]);
        assert_eq!(common::euler(faces.iter().copied()), 1);
        assert!(points.iter().all(|p| (p[2] - p[0] * p[1]).abs() < 1e-9), "{points:?}");
        assert!([-1.0, 1.0].into_iter().all(|x| points.iter().any(|p| p[0] == x && p[1] == -1.0)));
    }
    // A skin over smooth parallels is near to the sphere.
    let rings = parallels(13, 40);
    let outputs = run("smooth_net", &[Input::Curves(&rings)], &[("between", &[2.0])]).unwrap();
    let off = mesh(&outputs[0]).0.iter().map(|p| (radius(p) - 1.0).abs()).fold(0.0, f64::max);
    assert!(off < 5e-3, "{off}");
    let apart = polylines(&[-1.0, 0.5, 1.0].map(|y| (vec![[-1.0, y, 5.0], [1.0, y, 5.0]], false)));
    let refused = run("smooth_net", &[Input::Curves(&across), Input::Curves(&apart)], &[]);
    assert!(matches!(refused, Err(Error::CurvesApart { .. })), "{:?}", refused.err());
    let mixed = polylines(&[(circle(9, 1.0, [0.0; 3]), true), (circle(9, 1.0, [1.0; 3]), false)]);
    let refused = run("smooth_net", &[Input::Curves(&mixed)], &[]);
    assert!(matches!(refused, Err(Error::InputUnfit { input: 0, .. })), "{refused:?}");
}

#[test]
fn open_sheets_are_cut_as_well() {
    let flat = sheet(6, 5);
    let sheets = [Input::Mesh(flat.view())];
    // Five planes across x at 0.5, 1.5 and so on, by the suggestions for them.
    let set: &[(&str, &[f64])] = &[
        ("direction", &[1.0, 0.0, 0.0]),
        ("placement", &[1.0]),
        ("number", &[5.0]),
        ("offset", &[0.5]),
        ("distance", &[1.0]),
    ];
    let outputs = run("smooth_sections", &sheets, set).unwrap();
    let curves = lines(&outputs[0]);
    assert_eq!(curves.closed, [false; 5]);
    for c in 0..5 {
        assert!(curve(curves, c).iter().all(|p| (p[0] - 0.5 - c as f64).abs() < 1e-9));
    }
    let small = given(Filter::find("smooth_sections").unwrap(), 100);
    let inputs = inputs(&small);
    let defaults = Filter::find("smooth_sections").unwrap().defaults(&inputs);
    // The sphere is 2 high: planes every 0.2 from -0.9 on.
    assert!((defaults[6] + 0.9).abs() < 1e-9 && (defaults[7] - 0.2).abs() < 1e-9, "{defaults:?}");
}
