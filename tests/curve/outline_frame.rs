//! The frame of outlines, on bodies by formula.

use glam::DVec3;
use gusset::curve::frame::{Axis, Correspondence, Frame, FrameOptions, Measure, frame, slice};
use gusset::curve::{CurveKind, Options, Outlines, Points};
use gusset::{Element, Error, Job};
use std::f64::consts::{PI, TAU};

pub(crate) const CUBIC: Options = Options {
    curve: CurveKind::CubicC2,
    method: gusset::curve::Method::Bisector,
    lock: gusset::curve::Lock::Parameter,
    joint: gusset::curve::JointParameter::Half,
    solver: gusset::curve::Solver::Fast,
    ends: gusset::curve::Ends::Free,
    parameter_limit: None,
    repeat_tolerance: 1e-12,
    corner_angle: PI,
    tolerance: 1e-12,
    max_sweeps: 200,
    max_steps: 20_000,
    first_step: 0.1,
    step_divisor: 10.0,
    history: false,
};

/// Sections one after another, each from its own points.
#[derive(Default)]
pub(crate) struct Sections {
    pub(crate) points: Vec<[f64; 3]>,
    pub(crate) offsets: Vec<u32>,
}

impl Sections {
    pub(crate) fn from_sections(sections: impl IntoIterator<Item = Vec<[f64; 3]>>) -> Self {
        let mut all = Sections { points: Vec::new(), offsets: vec![0] };
        for section in sections {
            all.points.extend(section);
            all.offsets.push(all.points.len() as u32);
        }
        all
    }

    pub(crate) fn make(&self, closed: bool, options: &FrameOptions<'_>) -> Result<Frame, Error> {
        let points = Points::from(&self.points[..]);
        let outlines = Outlines { points, offsets: Some(&self.offsets), closed, constraints: &[] };
        frame(&outlines, options, &Job::default())
    }
}

pub(crate) fn options(correspondence: Correspondence<'_>) -> FrameOptions<'_> {
    FrameOptions { across: CUBIC, along: CUBIC, ..FrameOptions::new(correspondence) }
}

pub(crate) fn straight(point: DVec3, direction: DVec3) -> Axis<'static> {
    Axis::Line { point, direction }
}

/// The circle of a ball of radius 2 at height z, of n points from angle `from` on, forwards or
/// backwards.
pub(crate) fn circle(z: f64, n: usize, from: f64, backwards: bool) -> Vec<[f64; 3]> {
    let r = (4.0 - z * z).sqrt();
    (0..n)
        .map(|i| {
            let t = from + TAU * i as f64 / n as f64 * if backwards { -1.0 } else { 1.0 };
            [r * t.cos(), r * t.sin(), z]
        })
        .collect()
}

pub(crate) fn heights() -> impl Iterator<Item = f64> {
    (0..9).map(|k| -1.6 + 0.4 * f64::from(k))
}

pub(crate) fn assert_meets(made: &Frame) {
    let grid = &made.grid;
    assert_eq!(grid.nodes.len(), grid.rows * grid.columns);
    assert_eq!((grid.across.len(), grid.along.len()), (grid.nodes.len(), grid.nodes.len()));
    assert_eq!((made.across.len(), made.along.len()), (grid.rows, grid.columns));
    assert!(grid.max_gap < 1e-15, "{:e}", grid.max_gap);
    for k in 0..grid.rows {
        for i in 0..grid.columns {
            let node = grid.nodes[k * grid.columns + i];
            let (across, along) = (made.across.curve(k), made.along.curve(i));
            assert!(across.point(made.across.place(k * grid.columns + i)).unwrap().distance(node) < 1e-14);
            assert!(along.point(made.along.place(i * grid.rows + k)).unwrap().distance(node) < 1e-14);
        }
    }
}

#[test]
fn a_ball_by_angles_and_by_arc_lengths() {
    // Differently many points, from different starts, some backwards.
    let sections =
        Sections::from_sections(heights().enumerate().map(|(k, z)| circle(z, 20 + 3 * k, 0.3 * k as f64, k % 2 == 1)));
    let by_angle =
        Correspondence::Angle { columns: 12, axis: straight(DVec3::ZERO, DVec3::Z * 5.0), reference: DVec3::X };
    let made = sections.make(true, &options(by_angle)).unwrap();
    assert_meets(&made);
    assert!(made.grid.ambiguous.is_empty());
    for (node, &p) in made.grid.nodes.iter().enumerate() {
        let angle = TAU * (node % 12) as f64 / 12.0;
        assert!((p.normalize() * 2.0).distance(p) < 2e-4, "on the ball: {}", p.length());
        assert!(p.y.atan2(p.x).sin() * angle.cos() - p.y.atan2(p.x).cos() * angle.sin() < 1e-12);
        // The curves across run counter-clockwise, those along upwards and on the ball.
        assert!((made.grid.across[node] - DVec3::new(-angle.sin(), angle.cos(), 0.0)).length() < 1e-3);
        assert!(made.grid.along[node].z > 0.0 && made.grid.along[node].dot(p).abs() < 0.1);
    }
    assert!(made.grid.min_sine > 0.99);

    let sections = Sections::from_sections(heights().enumerate().map(|(k, z)| circle(z, 24 + k, 0.5, k % 3 == 1)));
    let from_first = FrameOptions { given_starts: true, ..options(Correspondence::ArcLength { columns: 10 }) };
    let made = sections.make(true, &from_first).unwrap();
    assert_meets(&made);
    for k in 0..9 {
        assert_eq!(made.grid.turned[k], u8::from(k % 3 == 1));
        for i in 0..10 {
            let (p, t) = (made.grid.nodes[10 * k + i], 0.5 + TAU * i as f64 / 10.0);
            let expected = DVec3::new(t.cos(), t.sin(), 0.0);
            assert!((p - p.project_onto(DVec3::Z)).normalize().distance(expected) < 1e-3, "row {k} column {i} {p}");
        }
    }
}

#[test]
fn new_sections_of_a_ball_have_its_girths_and_areas() {
    let sections = Sections::from_sections(heights().map(|z| circle(z, 32, 0.0, false)));
    let made = sections.make(true, &options(Correspondence::Given)).unwrap();
    assert_meets(&made);
    // Across the axis, and aslant; not far from given sections, as the ball's poles are not there.
    for (point, normal) in [
        (DVec3::new(0.0, 0.0, 0.13), DVec3::Z),
        (DVec3::new(0.0, 0.0, -0.9), DVec3::Z * 1e-3),
        (DVec3::new(0.0, 0.0, 0.2), DVec3::new(0.3, 0.1, 1.0)),
    ] {
        let cut = slice(&made.along, point, normal, true, &CUBIC, &Job::default()).unwrap();
        let away = point.dot(normal.normalize());
        let radius = (4.0 - away * away).sqrt();
        let measure = Measure::from_curve(cut.curve.curve(0)).unwrap();
        assert!((measure.girth / (TAU * radius) - 1.0).abs() < 1e-3, "{} {}", measure.girth, TAU * radius);
        assert!((measure.area / (PI * radius * radius) - 1.0).abs() < 2e-3, "{}", measure.area);
        assert!(measure.centre.distance(normal.normalize() * away) < 5e-3, "{}", measure.centre);
        assert!(cut.ambiguous.is_empty());
        for &place in &cut.places {
            assert!((0.0..=1.0).contains(&place.t));
        }
    }
    let planes: Vec<DVec3> = (0..7).map(|k| DVec3::Z * (0.4 * f64::from(k) - 1.2)).collect();
    for plane in &planes {
        let cut = slice(&made.along, *plane, DVec3::Z, true, &CUBIC, &Job::default()).unwrap();
        let measure = Measure::from_curve(cut.curve.curve(0)).unwrap();
        assert!((measure.area / (PI * (4.0 - plane.z * plane.z)) - 1.0).abs() < 1e-4);
    }
    let beyond = slice(&made.along, DVec3::Z * 3.0, DVec3::Z, true, &CUBIC, &Job::default());
    assert_eq!(beyond.unwrap_err(), Error::NoNode { section: 0, column: 0 });
}

#[test]
fn landmarks_belong_together() {
    // Squares that turn on their way up, of 4 x 3, 4 x 4, ... points that begin at some corner: the
    // corners are landmarks.
    let mut landmarks = Vec::new();
    let sections = Sections::from_sections((0..5usize).map(|k| {
        let (n, first) = (3 + k, k % 4);
        let corner = |i: usize| {
            let t = 0.2 * k as f64 + TAU * (i % 4) as f64 / 4.0;
            DVec3::new(t.cos(), t.sin(), k as f64)
        };
        landmarks.extend((0..4).map(|i| ((i + 4 - first) % 4 * n) as u32));
        (0..4 * n)
            .map(|i| corner(first + i / n).lerp(corner(first + i / n + 1), (i % n) as f64 / n as f64).to_array())
            .collect()
    }));
    let polygon = Options { corner_angle: 0.5, ..Options::default() };
    let correspondence = Correspondence::Landmarks { points: &landmarks, parts: 2 };
    let made = sections
        .make(true, &FrameOptions { across: polygon, along: CUBIC, ..FrameOptions::new(correspondence) })
        .unwrap();
    assert_meets(&made);
    assert_eq!((made.grid.rows, made.grid.columns), (5, 8));
    for k in 0..5 {
        for i in 0..4 {
            let t = 0.2 * k as f64 + TAU * i as f64 / 4.0;
            let (corner, middle) = (made.grid.nodes[8 * k + 2 * i], made.grid.nodes[8 * k + 2 * i + 1]);
            assert!(corner.distance(DVec3::new(t.cos(), t.sin(), k as f64)) < 1e-14);
            assert!((middle.truncate().length() - (0.5f64).sqrt()).abs() < 1e-14, "{middle}");
        }
    }
    // Not in order; not there; not as many for each.
    for (wrong, place) in [(&[0u32, 6, 3, 9][..], 2.0), (&[0, 3, 6, 90], 3.0), (&[0, 3, 6, 9, 0, 3], 22.0)] {
        let mut points = landmarks.clone();
        points.splice(0..4, wrong.iter().copied());
        let correspondence = Correspondence::Landmarks { points: &points, parts: 2 };
        let error = sections.make(true, &options(correspondence)).unwrap_err();
        assert!(matches!(error, Error::OptionOutOfRange { option: "landmarks", value, .. } if value == place));
    }
}

#[test]
fn a_ring_goes_round() {
    let sections = Sections::from_sections((0..12).map(|k| {
        let (sin, cos) = (TAU * f64::from(k) / 12.0).sin_cos();
        (0..9)
            .map(|i| {
                let t = TAU * f64::from(i) / 9.0;
                let r = 3.0 + t.cos();
                [r * cos, r * sin, t.sin()]
            })
            .collect()
    }));
    let made = sections.make(true, &FrameOptions { ring: true, ..options(Correspondence::Given) }).unwrap();
    assert_meets(&made);
    assert!((0..9).all(|i| made.along.curve(i).is_closed()));
    assert!(made.grid.min_sine > 1.0 - 1e-6);
    // Each curve along crosses a plane through the axis twice; the first crossing is taken and
    // reported.
    let cut = slice(&made.along, DVec3::ZERO, DVec3::Y, true, &CUBIC, &Job::default()).unwrap();
    assert_eq!(cut.ambiguous.len(), 9);
}

#[test]
fn what_makes_no_frame_is_refused() {
    let two = Sections::from_sections([circle(0.0, 6, 0.0, false), circle(1.0, 7, 0.0, false)]);
    assert_eq!(
        two.make(true, &options(Correspondence::Given)).unwrap_err(),
        Error::SectionsDiffer { section: 1, count: 7, expected: 6 }
    );
    let angle =
        |point, direction, reference| Correspondence::Angle { columns: 5, axis: straight(point, direction), reference };
    let refused = |correspondence| two.make(true, &options(correspondence)).unwrap_err();
    assert!(matches!(
        refused(angle(DVec3::ZERO, DVec3::ZERO, DVec3::X)),
        Error::OptionOutOfRange { option: "axis", .. }
    ));
    assert!(matches!(
        refused(angle(DVec3::ZERO, DVec3::Z, DVec3::Z)),
        Error::OptionOutOfRange { option: "reference", .. }
    ));
    // From an axis outside some half-planes meet nothing.
    assert!(matches!(refused(angle(DVec3::X * 9.0, DVec3::Z, DVec3::X)), Error::NoNode { section: 0, column: 0 }));
    assert!(matches!(
        refused(Correspondence::ArcLength { columns: 2 }),
        Error::OptionOutOfRange { option: "columns", .. }
    ));
    assert!(matches!(refused(Correspondence::ArcLength { columns: usize::MAX }), Error::TooLarge { .. }));
    let one = Sections::from_sections([circle(0.0, 6, 0.0, false)]);
    assert!(matches!(
        one.make(true, &options(Correspondence::Given)).unwrap_err(),
        Error::OptionOutOfRange { option: "sections", .. }
    ));
    let none = Sections::from_sections([]);
    assert!(none.make(true, &options(Correspondence::Given)).is_err());
    let point = Sections::from_sections([vec![[0.0; 3]; 5], circle(1.0, 5, 0.0, false)]);
    let points = Sections::from_sections([vec![[0.0; 3]; 5], vec![[0.0, 0.0, 1.0]]]);
    let error = points.make(true, &options(Correspondence::ArcLength { columns: 5 })).unwrap_err();
    assert_eq!(error, Error::OnlyTips);
    // A pole is a section like others.
    let made = point.make(true, &options(Correspondence::ArcLength { columns: 5 })).unwrap();
    assert!(made.grid.nodes[..5].iter().all(|&node| node == DVec3::ZERO));
    assert_eq!((made.grid.columns, made.grid.max_gap), (5, 0.0));
    let made = point.make(true, &options(Correspondence::Given)).unwrap();
    assert_eq!(made.grid.max_gap, 0.0);
    // NaN in the plane of a cut.
    let cut = slice(&made.along, DVec3::NAN, DVec3::Z, true, &CUBIC, &Job::default());
    assert!(matches!(cut.unwrap_err(), Error::NotFinite { element: Element::Point, .. }));
}

#[test]
fn landmarks_at_one_place_have_nothing_between_them() {
    // Point 3 comes twice, and the first one at the end once more.
    let mut points = circle(0.0, 12, 0.0, false);
    points.insert(4, points[3]);
    points.push(points[0]);
    let sections = Sections::from_sections([points.clone(), points]);
    let landmarks = [0, 3, 4, 8, 13, 0, 3, 4, 8, 13];
    let correspondence = Correspondence::Landmarks { points: &landmarks, parts: 2 };
    let made = sections.make(true, &options(correspondence)).unwrap();
    let angle = |i: usize| made.grid.nodes[i].y.atan2(made.grid.nodes[i].x).rem_euclid(TAU).to_degrees();
    for (i, expected) in [0.0, 45.0, 90.0, 90.0, 90.0, 150.0, 210.0, 285.0, 360.0, 360.0].into_iter().enumerate() {
        let off = (angle(i) - expected).rem_euclid(360.0);
        assert!(off.min(360.0 - off) < 0.1, "node {i}: {} instead of {expected}", angle(i));
    }
}

#[test]
fn sections_are_turned_at_any_scale() {
    for scale in [1e-300, 1e-200, 1e-82, 1.0, 1e100, 1e200] {
        let ring = |z: f64, backwards| -> Vec<[f64; 3]> {
            circle(z, 16, 0.1, backwards)
                .into_iter()
                .map(|p| [p[0] * scale, p[1] * scale, (p[2] + 0.3 * p[0]) * scale])
                .collect()
        };
        let sections = Sections::from_sections([ring(0.0, false), ring(0.5, true), ring(1.0, false)]);
        let made = sections.make(true, &options(Correspondence::ArcLength { columns: 12 })).unwrap();
        assert_eq!(made.grid.turned, [0, 1, 0], "{scale:e}");
        let measure = Measure::from_curve(made.across.curve(1)).unwrap();
        assert!(
            measure.centre.is_finite() && (measure.centre.z / scale - 0.5).abs() < 1e-2,
            "{scale:e} {}",
            measure.centre
        );
    }
}

/// Sections of a bent body, points at uneven steps, some backwards; each list begins somewhere.
fn rolled(random: &mut fastrand::Rng) -> Sections {
    Sections::from_sections((0..9).map(|k| {
        let z = f64::from(k);
        let n = 24 + 5 * (k as usize % 3);
        let mut points: Vec<[f64; 3]> = (0..n)
            .map(|i| {
                let t = TAU * (i as f64 + 0.3 * (7.0 * i as f64).sin()) / n as f64;
                let r = 1.0 + 0.25 * (2.0 * t + 0.1 * z).cos() + 0.1 * (t - 0.2).sin() + 0.05 * (3.0 * t).cos();
                [r * t.cos() + 0.2 * (0.5 * z).sin(), 0.8 * r * t.sin(), z + 0.2 * r * t.cos()]
            })
            .collect();
        points.rotate_left(random.usize(..n));
        if random.bool() {
            points.reverse();
        }
        points
    }))
}

#[test]
fn where_lists_begin_and_which_way_they_run_does_not_matter() {
    let mut random = fastrand::Rng::with_seed(4);
    let way = options(Correspondence::ArcLength { columns: 24 });
    for ring in [false, true] {
        let way = FrameOptions { ring, ..way };
        let make = |random: &mut fastrand::Rng| {
            let sections = rolled(random);
            // All have the direction of the first.
            let turn = |p: &[[f64; 3]]| {
                p.iter().zip(p.iter().cycle().skip(1)).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>()
            };
            let first = &sections.points[..sections.offsets[1] as usize];
            (turn(first) > 0.0, sections.make(true, &way).unwrap().grid)
        };
        let mut before: [Option<Vec<DVec3>>; 2] = [None, None];
        for _ in 0..200 {
            let (forwards, grid) = make(&mut random);
            assert!(grid.max_twist < if ring { 0.2 } else { 0.06 }, "{}", grid.max_twist);
            let known = before[usize::from(forwards)].get_or_insert_with(|| grid.nodes.clone());
            let off = known.iter().zip(&grid.nodes).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max);
            assert!(off < 1e-9 * 8.0, "{off:e}");
        }
    }
    // Correspondence by first points twists the body, and the report says so.
    let wrung = rolled(&mut random).make(true, &FrameOptions { given_starts: true, ..way }).unwrap();
    assert!(wrung.grid.max_twist > 1.0, "{}", wrung.grid.max_twist);
}

#[test]
fn angles_about_a_bent_axis() {
    // A helix of radius 4 with a wire of radius 0.5 about it; the sections begin anywhere.
    let (radius, rise, wire) = (4.0, 0.6, 0.5);
    let at = |t: f64| DVec3::new(radius * t.cos(), radius * t.sin(), rise * t);
    let tangent = |t: f64| DVec3::new(-radius * t.sin(), radius * t.cos(), rise).normalize();
    let (count, columns) = (25, 16);
    let turns = |k: usize| 0.15 * k as f64;
    let sections = Sections::from_sections((0..count).map(|k| {
        let (centre, along) = (at(turns(k)), tangent(turns(k)));
        let first = along.any_orthonormal_vector();
        let on = |i: usize| {
            let angle = TAU * i as f64 / 40.0 + k as f64;
            (centre + wire * (first * angle.cos() + along.cross(first) * angle.sin())).to_array()
        };
        (0..40).map(on).collect()
    }));
    let axis: Vec<DVec3> = (0..count).map(|k| at(turns(k))).collect();
    fn about(axis: Axis<'_>, reference: DVec3) -> Correspondence<'_> {
        Correspondence::Angle { columns: 16, axis, reference }
    }
    let made = sections.make(true, &options(about(Axis::Points(&axis), DVec3::Z))).unwrap();
    assert_meets(&made);
    let node = |k: usize, i: usize| made.grid.nodes[k * columns + i] - axis[k];
    // Column 0 begins towards z. Relative to the helix's normal, which points to the z axis, it
    // turns back by the torsion.
    let speed = radius.hypot(rise);
    let torsion = rise / (speed * speed);
    for k in 0..count {
        let along = tangent(turns(k));
        let normal = -DVec3::new(turns(k).cos(), turns(k).sin(), 0.0);
        let start = DVec3::Z - along * along.z;
        let expected_start = {
            let (n, b) = (normal, along.cross(normal));
            start.dot(b).atan2(start.dot(n))
        };
        let expected = expected_start - torsion * speed * turns(k);
        for i in 0..columns {
            let p = node(k, i);
            assert!((p.length() - wire).abs() < 1e-4 && p.dot(along).abs() < 2e-3 * wire, "{k} {i}");
            let angle = p.dot(along.cross(normal)).atan2(p.dot(normal));
            let off = angle - (expected + TAU * i as f64 / columns as f64);
            assert!(off.sin().abs() < 2e-3, "{k} {i}: {off}");
        }
    }
    // Not as many points as sections; two at one place; a reference along the axis; no number.
    let refused = |axis: &[DVec3], reference| {
        let error = sections.make(true, &options(about(Axis::Points(axis), reference))).unwrap_err();
        let Error::OptionOutOfRange { option, .. } = error else { panic!("{error}") };
        option
    };
    assert_eq!(refused(&axis[1..], DVec3::Z), "axis_points");
    let mut wrong = axis.clone();
    wrong[3] = wrong[2];
    assert_eq!(refused(&wrong, DVec3::Z), "axis_points");
    wrong[3].x = f64::NAN;
    assert_eq!(refused(&wrong, DVec3::Z), "axis_points");
    let straight: Vec<DVec3> = (0..count).map(|k| DVec3::Z * k as f64).collect();
    assert_eq!(refused(&straight, DVec3::Z), "reference");
}

/// The torus of [`a_ring_goes_round`], or a part of it, by arc length: no section is backwards.
#[test]
fn bent_bodies_keep_their_direction() {
    let torus = |count: u32, part: f64, random: &mut fastrand::Rng| {
        Sections::from_sections((0..count).map(|k| {
            let (sin, cos) = (part * f64::from(k) / f64::from(count)).sin_cos();
            let on = |i: u32| {
                let t = TAU * f64::from(i) / 20.0;
                let r = 3.0 + t.cos();
                [r * cos, r * sin, 0.7 * t.sin()]
            };
            let mut points: Vec<[f64; 3]> = (0..20).map(on).collect();
            points.rotate_left(random.usize(..20));
            points
        }))
    };
    let mut random = fastrand::Rng::with_seed(2);
    for (count, part, ring) in [(16, TAU, true), (9, 3.0, false), (30, 2.0 * TAU, false)] {
        let way = FrameOptions { ring, ..options(Correspondence::ArcLength { columns: 24 }) };
        let grid = torus(count, part, &mut random).make(true, &way).unwrap().grid;
        assert!(grid.turned.iter().all(|&turned| turned == 0), "{:?}", grid.turned);
        assert!(grid.max_twist < 0.05, "{}", grid.max_twist);
        // Each column stays at its own height.
        for i in 0..24 {
            let z = grid.nodes[i].z;
            assert!((0..grid.rows).all(|k| (grid.nodes[24 * k + i].z - z).abs() < 1e-9), "{i}");
        }
    }
}
