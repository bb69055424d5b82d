//! The filter table, walked: what a host relies on holds for every entry, and every entry runs.

mod common;

use common::{Soup, cap};
use gusset::filters::data::{Curves, Input, InputKind, Output};
use gusset::filters::param::ParamKind;
use gusset::filters::{FILTERS, Filter};
use gusset::mesh::PositionBuffer;
use gusset::{Error, Job};
use std::collections::HashSet;

/// Ids are stable for ever: an entry may be added here, none changed or taken away.
const IDS: &[&str] = &[
    "boundary_loops",
    "stitch",
    "weld",
    "orient",
    "fill_holes",
    "assemble",
    "outline",
    "net_shape",
    "deform",
    "smooth_surface",
    "smooth_sections",
    "smooth_silhouette",
    "smooth_distance",
];

/// Two caps that face each other askew: the inputs of any filter that takes meshes.
fn pieces() -> [Soup; 2] {
    let mut second = cap(9, 4, 0.3, -1.0);
    second.points.iter_mut().for_each(|p| p[0] += 0.6);
    [cap(12, 3, 0.2, 1.0), second]
}

/// Two grids of quads: spheres, whose rows of faces end in fans of triangles at the poles.
fn grids() -> [Soup; 2] {
    [(8, 12), (16, 24)].map(|(rows, columns)| sphere(rows, columns))
}

/// A unit sphere of quads, closed round and seen from outside; `rows` cells from pole to pole.
fn sphere(rows: u32, columns: u32) -> Soup {
    use std::f64::consts::{PI, TAU};
    let mut points = vec![[0.0, 0.0, 1.0]];
    for i in 1..rows {
        let (sin, cos) = (PI * f64::from(i) / f64::from(rows)).sin_cos();
        points.extend((0..columns).map(|j| {
            let (y, x) = (TAU * f64::from(j) / f64::from(columns)).sin_cos();
            [sin * x, sin * y, cos]
        }));
    }
    points.push([0.0, 0.0, -1.0]);
    let south = points.len() as u32 - 1;
    let node = |i: u32, j: u32| 1 + (i - 1) * columns + j % columns;
    let mut soup = Soup::new(points, &[]);
    for j in 0..columns {
        soup.face(&[0, node(1, j), node(1, j + 1)]);
    }
    for (i, j) in (1..rows - 1).flat_map(|i| (0..columns).map(move |j| (i, j))) {
        soup.face(&[node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)]);
    }
    for j in 0..columns {
        soup.face(&[south, node(rows - 1, j + 1), node(rows - 1, j)]);
    }
    soup
}

fn inputs(soups: &[Soup]) -> Vec<Input<'_>> {
    soups.iter().map(|soup| Input::Mesh(soup.view())).collect()
}

/// A closed polyline and an open one.
fn curves() -> Curves {
    let points = (0..12).map(|i| {
        let (sin, cos) = (std::f64::consts::TAU * f64::from(i) / 7.0).sin_cos();
        [cos * if i < 7 { 1.0 } else { 2.0 }, sin, 0.0]
    });
    Curves { points: points.collect(), offsets: vec![0, 7, 12], closed: vec![true, false] }
}

/// What a filter takes, as many as two.
fn inputs_of<'a>(filter: &Filter, [soups, grids]: &'a [[Soup; 2]; 2], curves: &'a Curves) -> Vec<Input<'a>> {
    let soups = if filter.id.starts_with("smooth_") { grids } else { soups };
    match filter.inputs.first() {
        None => Vec::new(),
        Some(InputKind::Mesh) => inputs(&soups[..filter.max_inputs.min(2)]),
        Some(InputKind::Curves) => vec![Input::Curves(curves)],
    }
}

fn is_word(text: &str) -> bool {
    !text.is_empty() && text.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
}

#[test]
fn names_are_unique_stable_and_explained() {
    assert_eq!(FILTERS.iter().map(|f| f.id).collect::<Vec<_>>(), IDS);
    let distinct = |key: fn(&Filter) -> &str| FILTERS.iter().map(key).collect::<HashSet<_>>().len();
    assert_eq!([distinct(|f| f.id), distinct(|f| f.name), distinct(|f| f.script_name)], [FILTERS.len(); 3]);
    for filter in FILTERS {
        assert!(is_word(filter.id) && is_word(filter.script_name), "{}", filter.id);
        assert!(filter.help.len() > 40 && filter.help.ends_with('.') && !filter.help.contains("  "), "{}", filter.help);
        assert!(!filter.reference.is_empty() && !filter.category.is_empty() && !filter.name.is_empty());
        assert!(std::ptr::eq(Filter::find(filter.id).unwrap(), filter));
        assert!(!filter.outputs.is_empty());
        // A filter takes some meshes or curves, or nothing at all.
        assert_eq!(filter.inputs.is_empty(), filter.max_inputs == 0);
        assert_eq!(filter.inputs.is_empty(), filter.min_inputs == 0);
        assert!(filter.min_inputs <= filter.max_inputs);
        let params: HashSet<_> = filter.params.iter().map(|p| p.id).collect();
        assert_eq!(params.len(), filter.params.len(), "{}", filter.id);
    }
    assert!(Filter::find("no such filter").is_none());
}

#[test]
fn parameters_have_defaults_in_range() {
    for param in FILTERS.iter().flat_map(|f| f.params) {
        assert!(is_word(param.id) && !param.label.is_empty(), "{}", param.id);
        assert!(param.help.len() > 20 && param.help.ends_with('.') && !param.help.contains("  "), "{}", param.help);
        assert_eq!(param.default.len(), param.kind.arity(), "{}", param.id);
        assert!(param.min <= param.max && param.default.iter().all(|&v| param.accepts(v)), "{}", param.id);
        assert!(param.step >= 0.0);
        assert_eq!(param.kind == ParamKind::Choice, !param.choices.is_empty(), "{}", param.id);
        if param.kind == ParamKind::Choice {
            assert_eq!((param.min, param.max), (0.0, (param.choices.len() - 1) as f64));
            assert!(param.choices.iter().all(|c| !c.label.is_empty() && c.help.ends_with('.')));
        }
    }
}

#[test]
fn every_filter_runs_with_its_defaults_and_with_every_choice() {
    let (soups, curves) = ([pieces(), grids()], curves());
    for filter in FILTERS {
        let inputs = inputs_of(filter, &soups, &curves);
        let defaults = filter.defaults(&inputs);
        let reference = filter.run(&inputs, &[], &Job::default()).unwrap();
        assert_eq!(reference.iter().map(Output::kind).collect::<Vec<_>>(), filter.outputs, "{}", filter.id);
        assert_eq!(filter.run(&inputs, &defaults, &Job::default()).unwrap(), reference);
        let mut start = 0;
        for param in filter.params {
            for choice in 0..param.choices.len() {
                let mut values = defaults.clone();
                values[start] = choice as f64;
                let outputs = filter.run(&inputs, &values, &Job::default()).unwrap();
                assert_eq!(outputs.len(), reference.len(), "{} {} {choice}", filter.id, param.id);
            }
            start += param.kind.arity();
        }
    }
}

#[test]
fn values_and_inputs_out_of_range_are_refused() {
    let (soups, curves) = ([pieces(), grids()], curves());
    for filter in FILTERS {
        let inputs = inputs_of(filter, &soups, &curves);
        let defaults = filter.defaults(&inputs);
        let mut start = 0;
        for param in filter.params {
            let mut bad = vec![f64::NAN, param.min - 1.0, param.max + 1.0, f64::INFINITY];
            if matches!(param.kind, ParamKind::Bool | ParamKind::Int | ParamKind::Choice) {
                bad.push(0.5);
            }
            for value in bad {
                let mut values = defaults.clone();
                values[start] = value;
                match filter.run(&inputs, &values, &Job::default()) {
                    Err(Error::OptionOutOfRange { option, .. }) => assert_eq!(option, param.id),
                    other => panic!("{} {} {value}: {other:?}", filter.id, param.id),
                }
            }
            start += param.kind.arity();
        }
        let too_many = vec![0.0; defaults.len() + 1];
        assert!(matches!(
            filter.run(&inputs, &too_many, &Job::default()),
            Err(Error::OptionOutOfRange { option: "values", .. })
        ));
        let refused = |inputs: &[Input<'_>]| {
            matches!(filter.run(inputs, &[], &Job::default()), Err(Error::OptionOutOfRange { option: "inputs", .. }))
        };
        let any = Input::Mesh(soups[0][0].view());
        let too_many = vec![*inputs.first().unwrap_or(&any); filter.max_inputs + 1];
        assert!((filter.min_inputs == 0 || refused(&[])) && refused(&too_many), "{}", filter.id);
    }
}

#[test]
fn boundary_loops_gives_the_rim() {
    let soups = pieces();
    let outputs = Filter::find("boundary_loops").unwrap().run(&inputs(&soups[..1]), &[], &Job::default()).unwrap();
    let [Output::Curves(curves), Output::Text(text)] = outputs.as_slice() else { panic!("{outputs:?}") };
    assert_eq!((curves.offsets.as_slice(), curves.closed.as_slice()), (&[0, 12][..], &[true][..]));
    assert!(curves.points.iter().all(|p| (p[2] - 0.2).abs() < 1e-12));
    assert!(text.starts_with("1 boundary loops, 12 edges\n"), "{text}");
}

#[test]
fn stitch_closes_a_sphere_by_loops_found_and_by_loops_given() {
    let soups = pieces();
    let filter = Filter::find("stitch").unwrap();
    let found = filter.run(&inputs(&soups), &[], &Job::default()).unwrap();
    assert_eq!(filter.run(&inputs(&soups), &[0.0, 0.0], &Job::default()).unwrap(), found);
    let Output::Mesh(mesh) = &found[0] else { panic!("{found:?}") };
    let faces = mesh.face_offsets.windows(2).map(|w| &mesh.face_corners[w[0] as usize..w[1] as usize]);
    assert!(common::edge_counts(faces.clone()).values().all(|&n| n == (1, 1)));
    assert_eq!(common::euler(faces), 2);
    let wrong = filter.run(&inputs(&soups), &[0.0, 1.0], &Job::default());
    assert_eq!(wrong, Err(Error::OptionOutOfRange { option: "loop_b", value: 1.0 }));
    let both = soups[0].and(&soups[1]);
    let within = filter.run(&[Input::Mesh(both.view())], &[], &Job::default()).unwrap();
    assert_eq!(within[0], found[0]);
}

#[test]
fn fill_holes_closes_what_it_may() {
    let filter = Filter::find("fill_holes").unwrap();
    let soups = pieces();
    let both = soups[0].and(&soups[1]);
    // Refined and fair; then the second rim is too long, or is the longest.
    for (values, filled) in
        [(&[2.0][..], 2), (&[0.0, 2.0, 10.0], 1), (&[1.0, 0.0, 0.0, 6.05], 1), (&[0.0, 0.0, 0.0, 0.0, 1.0], 1)]
    {
        let outputs = filter.run(&[Input::Mesh(both.view())], values, &Job::default()).unwrap();
        let [Output::Mesh(mesh), Output::Text(text)] = outputs.as_slice() else { panic!("{outputs:?}") };
        assert!(text.starts_with(&format!("filled {filled} of 2 loops")), "{values:?}: {text}");
        let faces = mesh.face_offsets.windows(2).map(|w| &mesh.face_corners[w[0] as usize..w[1] as usize]);
        let open = common::edge_counts(faces).values().filter(|&&n| n != (1, 1)).count();
        assert_eq!(open == 0, filled == 2, "{values:?}");
    }
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
    let soups = pieces();
    assert!(filter.run(&inputs(&soups[..1]), &[], &Job::default()).is_err());
}

/// What a filter gives for a mesh.
fn run_on(id: &str, soups: &[Soup], values: &[f64]) -> Vec<Output> {
    Filter::find(id).unwrap().run(&inputs(soups), values, &Job::default()).unwrap()
}

fn radius(p: &[f64; 3]) -> f64 {
    p[0].hypot(p[1]).hypot(p[2])
}

#[test]
fn smooth_surfaces_are_nearer_to_the_truth_than_quads() {
    let given = sphere(16, 24);
    let outputs = run_on("smooth_surface", std::slice::from_ref(&given), &[0.0, 1e-4, 4.0, 1.0]);
    let [Output::Mesh(mesh), Output::Text(_)] = outputs.as_slice() else { panic!("of other kinds") };
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
    let [Output::Mesh(mesh), Output::Text(text)] = outputs.as_slice() else { panic!("of other kinds") };
    let PositionBuffer::F64(points) = &mesh.positions else { panic!("of another type") };
    assert!(points.iter().all(|p| (radius(p) - 1.0).abs() < 1e-4));
    let largest: f64 = text.split("largest distance ").nth(1).unwrap().split(',').next().unwrap().parse().unwrap();
    assert!((largest - 0.1).abs() < 1e-4, "{text}");
    // Two grids are none.
    let [first, second] = pieces();
    let both = [first.and(&second)];
    let refused = Filter::find("smooth_surface").unwrap().run(&inputs(&both), &[], &Job::default());
    assert!(matches!(refused, Err(Error::NoGrid { .. })));
}
