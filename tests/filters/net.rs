//! Filters of nets, held against shapes that are known by formula.

use crate::common::{self, Soup, sheet, torus};
use crate::editor::{lines, mesh, number, radius, run_on, sphere, text, value, values};
use glam::DVec3;
use gusset::Error;
use gusset::filters::data::{Input, Output};
use std::f64::consts::PI;

/// Runs a filter on meshes, with some parameters set.
fn run(id: &str, soups: &[Soup], set: &[(&str, &[f64])]) -> Result<Vec<Output>, Error> {
    let inputs: Vec<_> = soups.iter().map(|soup| Input::Mesh(soup.view())).collect();
    run_on(id, soups, &values(id, &inputs, set))
}

/// Closed, each edge run once either way.
fn is_closed(faces: &[&[u32]]) -> bool {
    common::edge_counts(faces.iter().copied()).values().all(|&count| count == (1, 1))
}

#[test]
fn shapes_are_what_they_are_called() {
    // Shape, Euler characteristic; volume if it has one.
    let prism = 6.0 * 0.5 * (PI / 3.0).sin() * 2.0;
    let cases: [(f64, i64, Option<f64>); 14] = [
        (0.0, 2, Some(4.0 / 3.0 * PI)),
        (1.0, 2, Some(4.0 / 3.0 * PI)),
        (2.0, 1, None),
        (3.0, 0, None),
        (4.0, 2, Some(2.0 * PI)),
        (5.0, 2, Some(2.0 * PI / 3.0)),
        (6.0, 0, Some(2.0 * PI * PI / 16.0)),
        (7.0, 2, Some(8.0)),
        (8.0, 0, None),
        (9.0, 0, None),
        (10.0, 2, Some(prism)),
        (11.0, 2, Some(prism / 3.0)),
        (12.0, 1, None),
        (13.0, 2, None),
    ];
    for (shape, euler, volume) in cases {
        let set: &[(&str, &[f64])] = &[("shape", &[shape]), ("rows", &[33.0]), ("columns", &[97.0])];
        let outputs = run("net_shape", &[], set).unwrap_or_else(|error| panic!("{shape}: {error}"));
        let (points, faces) = mesh(&outputs[0]);
        assert_eq!(common::euler(faces.iter().copied()), euler, "{shape}");
        assert!(text(&outputs[1]).contains(&format!("characteristic {euler},")));
        if let Some(volume) = volume {
            let found = common::volume(|v| points[v as usize], faces.into_iter());
            assert!((found / volume - 1.0).abs() < 0.02, "{shape}: {found} {volume}");
        }
    }
    let bad = |set: &[(&str, &[f64])]| match run("net_shape", &[], set) {
        Err(Error::OptionOutOfRange { option, .. }) => option,
        other => panic!("{:?}", other.err()),
    };
    assert_eq!(bad(&[("shape", &[6.0]), ("minor_radius", &[1.0])]), "minor_radius");
    assert_eq!(bad(&[("shape", &[13.0]), ("columns", &[8.0])]), "columns");
    assert_eq!(bad(&[("shape", &[10.0]), ("sides", &[100.0])]), "columns");
}

#[test]
fn resampled_grids_keep_their_shape() {
    let outputs = run("net_resample", &[sphere(16, 24)], &[("rows", &[41.0]), ("columns", &[61.0])]).unwrap();
    let (points, faces) = mesh(&outputs[0]);
    assert_eq!((points.len(), common::euler(faces.iter().copied())), (39 * 60 + 2, 2));
    assert!(is_closed(&faces));
    // Beyond a pole the splines go on straight: there they are off by an eighth of the square of
    // the distance of rows.
    let off = points.iter().map(|p| (radius(p) - 1.0).abs()).fold(0.0, f64::max);
    assert!(off < (PI / 16.0).powi(2) / 8.0, "{off}");
    assert_eq!(text(&outputs[1]), "17 rows and 25 columns made 41 and 61\n");
    // A plane sheet stays plane and evenly spaced, by either rule.
    for rule in [0.0, 1.0] {
        let set: &[(&str, &[f64])] = &[("rows", &[5.0]), ("columns", &[9.0]), ("interpolation", &[rule])];
        let outputs = run("net_resample", &[sheet(4, 8)], set).unwrap();
        let (points, _) = mesh(&outputs[0]);
        let spaced = |p: &[f64; 3]| {
            let even = |x: f64, step: f64| ((x / step).round() * step - x).abs() < 1e-12;
            p[2] == 0.0 && (even(p[0], 1.0) && even(p[1], 1.0) || even(p[0], 0.5) && even(p[1], 2.0))
        };
        assert!(points.len() == 45 && points.iter().all(spaced), "{points:?}");
    }
    let small = run("net_resample", &[sphere(16, 24)], &[("rows", &[2.0]), ("columns", &[2.0])]);
    assert!(small.is_err() || mesh(&small.unwrap()[0]).1.len() < 5);
}

#[test]
fn thinned_out_grids_stay_near() {
    // Along a cylinder rows are straight: all but the ends may go.
    let tube = run("net_shape", &[], &[("shape", &[3.0])]).unwrap();
    let (points, faces) = mesh(&tube[0]);
    let tube = Soup::new(points, &faces);
    let outputs = run("net_decimate", std::slice::from_ref(&tube), &[("tolerance", &[0.02])]).unwrap();
    let (points, faces) = mesh(&outputs[0]);
    assert_eq!(common::euler(faces.iter().copied()), 0);
    // A chord of a circle of radius 1 is off by at most half the tolerance: 1 - cos(x / 2) <= 0.01
    // for x <= 0.283.
    let columns = points.len() / 2;
    assert!((20..=33).contains(&columns), "{columns}");
    assert!(points.iter().all(|p| tube.points.contains(p)));
    assert!(number(text(&outputs[1]), "deviation") <= 0.02);
}

#[test]
fn joined_grids_are_one() {
    // Two sheets of 4 x 3 quads, one above the other.
    let (first, mut second) = (sheet(4, 3), sheet(4, 3));
    second.points.iter_mut().for_each(|p| p[1] -= 4.0);
    for (direction, joined) in [(0.0, 4), (1.0, 3)] {
        let outputs = run("net_join", &[first.clone(), second.clone()], &[("direction", &[direction])]).unwrap();
        let (points, faces) = mesh(&outputs[0]);
        assert_eq!(common::euler(faces.iter().copied()), 1);
        assert!(faces.len() == 24 + joined || faces.len() == 24 + 7 - joined, "{}", faces.len());
        assert!(first.points.iter().chain(&second.points).all(|p| points.contains(p)));
        let outputs = run("net_join", &[first.clone(), second.clone()], &[("bridge", &[1.0])]).unwrap();
        let (_, faces) = mesh(&outputs[0]);
        assert_eq!((faces.len(), common::euler(faces.iter().copied())), (24, 2));
    }
    // Tubes by a tube; the second one turned does not change what kind of surface it is.
    let tube = |z: f64| {
        let made = run("net_shape", &[], &[("shape", &[3.0]), ("rows", &[5.0]), ("columns", &[13.0])]).unwrap();
        let (mut points, faces) = mesh(&made[0]);
        points.iter_mut().for_each(|p| p[2] += z);
        Soup::new(points, &faces)
    };
    for twist in [0.0, 3.0] {
        let outputs = run("net_join", &[tube(0.0), tube(3.0)], &[("twist", &[twist])]).unwrap();
        let (_, faces) = mesh(&outputs[0]);
        assert_eq!((faces.len(), common::euler(faces.iter().copied())), (9 * 12, 0));
    }
    let outputs = run("net_join", &[tube(0.0), tube(2.0)], &[("bridge", &[2.0]), ("tolerance", &[1e-9])]);
    let faces = outputs.map(|outputs| mesh(&outputs[0]).1.len());
    // Which side of the first tube is last is a matter of its first face: they lie on each other,
    // or are the height of both apart.
    assert!(faces == Ok(8 * 12) || matches!(faces, Err(Error::SidesApart { .. })), "{faces:?}");
    let refused = run("net_join", &[sheet(4, 3), sheet(7, 5)], &[("sizes", &[3.0])]);
    assert!(matches!(refused, Err(Error::SidesDiffer { .. })), "{:?}", refused.err());
}

#[test]
fn measures_of_spheres_tori_and_saddles() {
    let outputs = run("net_measures", &[sphere(64, 96)], &[]).unwrap();
    let report = text(&outputs[0]);
    assert!((number(report, "area") / (4.0 * PI) - 1.0).abs() < 2e-3, "{report}");
    assert!((number(report, "volume") / (4.0 / 3.0 * PI) - 1.0).abs() < 4e-3, "{report}");
    // The inertia of a ball of density 1 is 2/5 m r^2.
    assert!((number(report, "inertia") / (8.0 / 15.0 * PI) - 1.0).abs() < 8e-3, "{report}");
    assert!(report.contains("two-sided, Euler characteristic 2, 0 boundary loops"), "{report}");
    let report = run("net_measures", &[torus(60, 40)], &[]).unwrap();
    assert!((number(text(&report[0]), "volume") / (4.0 * PI * PI) - 1.0).abs() < 1e-2);
    // One crooked quad of two: its corner is lifted by 1 over a diagonal of 3^(1/2).
    let mut two = sheet(2, 1);
    two.points[0][2] = 1.0;
    let report = run("net_measures", std::slice::from_ref(&two), &[("planarity", &[0.1])]).unwrap();
    let report = text(&report[0]);
    assert!(report.contains("1 quad off the plane") && !report.contains("volume"), "{report}");
    // Its corners are |(b - a) + (d - c)| / 4 along the normal from the plane between the
    // diagonals.
    let [a, b, c, d] = [two.points[0], two.points[1], two.points[4], two.points[3]].map(glam::DVec3::from);
    let normal = (c - a).cross(d - b).normalize();
    let off = ((a - b) + (c - d)).dot(normal).abs() / 4.0 / (c - a).length().max((d - b).length());
    assert!((number(report, "most") / off - 1.0).abs() < 1e-3, "{report} {off}");
}

#[test]
fn deformations_are_soft_or_hard() {
    let before = sheet(6, 5);
    let with = |change: fn(&mut [f64; 3])| {
        let mut after = before.clone();
        after.points.iter_mut().for_each(change);
        run("net_analyse", &[before.clone(), after], &[]).unwrap()
    };
    let soft = with(|p| *p = [2.0 * p[0], 3.0 * p[1], p[0]]);
    assert!(text(&soft[1]).starts_with("a soft deformation: 0 edges"), "{}", text(&soft[1]));
    assert!(text(&soft[1]).contains("lengths of edges times 2.23607 to 3, areas"), "{}", text(&soft[1]));
    // Columns 2 and 3 made one: the six links between them are points now.
    let hard = with(|p| p[0] = if p[0] == 3.0 { 2.0 } else { p[0] });
    let edges = lines(&hard[0]);
    assert_eq!(edges.offsets.len() - 1, 6, "{}", text(&hard[1]));
    assert!(
        edges.points.chunks(2).all(|ends| ends[0][1] == ends[1][1] && (ends[0][0] + ends[1][0] - 5.0).abs() < 1e-12)
    );
    assert!(
        text(&hard[1]).starts_with("a hard deformation: 6 edges contracted to points, 0 torn"),
        "{}",
        text(&hard[1])
    );
    // Folded along x = 4: the two last columns of faces lie on others.
    let folded = with(|p| p[0] = if p[0] > 4.0 { 8.0 - p[0] } else { p[0] });
    let report = text(&folded[1]);
    assert!(report.contains("10 faces folded") && report.contains("folded: 4 5 10 11"), "{report}");
    // Torn: a closed ring, one vertex of which cannot come apart, is none; another mesh is refused.
    let refused = run("net_analyse", &[before, sheet(5, 6)], &[]);
    assert!(matches!(refused, Err(Error::InputUnfit { input: 1, .. })), "{refused:?}");
}

#[test]
fn displaced_spheres_are_spheres() {
    let outputs = run("displace", &[sphere(24, 36)], &[("distance", &[0.5])]).unwrap();
    let (points, faces) = mesh(&outputs[0]);
    assert!(is_closed(&faces) && points.len() == sphere(24, 36).points.len());
    assert!(points.iter().all(|p| (radius(p) - 1.5).abs() < 2e-3));
    let inwards = run("displace", &[sphere(24, 36)], &[("distance", &[-0.25])]).unwrap();
    assert!(mesh(&inwards[0]).0.iter().all(|p| (radius(p) - 0.75).abs() < 2e-3));
}

/// The largest distance of the corners of a quad from their mean plane.
fn deviation(points: &[[f64; 3]], face: &[u32]) -> f64 {
    let [a, b, c, d] = [0, 1, 2, 3].map(|k| DVec3::from(points[face[k] as usize]));
    ((a - b) + (c - d)).dot((c - a).cross(d - b).normalize()).abs() / 4.0
}

#[test]
fn planarised_grids_have_planar_faces() {
    let mut wavy = sheet(6, 5);
    wavy.points.iter_mut().for_each(|p| p[2] = 0.3 * (1.1 * p[0]).sin() * (0.9 * p[1] + 0.4).cos());
    let worst =
        |points: &[[f64; 3]], faces: &[&[u32]]| faces.iter().map(|face| deviation(points, face)).fold(0.0, f64::max);
    let old: Vec<&[u32]> = wavy.faces().collect();
    let size = [6.0f64, 5.0, 0.6].iter().fold(0.0, |sum: f64, side| sum.hypot(*side));
    assert!(worst(&wavy.points, &old) > 1e-3);
    for (tolerance, keep) in [(0.0, 0.0), (0.0, 1.0), (1e-4, 0.0)] {
        let set: &[(&str, &[f64])] = &[("tolerance", &[tolerance]), ("keep_boundary", &[keep])];
        let outputs = run("net_planarise", std::slice::from_ref(&wavy), set).unwrap();
        let (points, faces) = mesh(&outputs[0]);
        assert_eq!(faces, old);
        let limit = if tolerance > 0.0 { tolerance } else { 1e-10 } * size;
        let converged = value(&outputs[1], "converged") == 1.0;
        assert!(keep == 1.0 || converged && worst(&points, &faces) <= limit, "{}", text(&outputs[1]));
        assert!((value(&outputs[1], "deviation") - worst(&points, &faces)).abs() < 1e-12);
        let farthest = wavy.points.iter().zip(&points).map(|(p, q)| DVec3::from(*p).distance(DVec3::from(*q)));
        assert!((value(&outputs[1], "largest_displacement") - farthest.fold(0.0, f64::max)).abs() < 1e-12);
        for (p, q) in wavy.points.iter().zip(&points).filter(|_| keep == 1.0) {
            let on_boundary = p[0] % 6.0 == 0.0 || p[1] % 5.0 == 0.0;
            assert!(!on_boundary || p == q, "{p:?} {q:?}");
        }
    }
    // A planar mesh does not change.
    let flat = sheet(4, 3);
    assert_eq!(mesh(&run("net_planarise", std::slice::from_ref(&flat), &[]).unwrap()[0]).0, flat.points);
}

/// A tube of radius 1 whose two rims are at heights `low` and `high`.
fn tube(low: f64, high: f64) -> Soup {
    let set: &[(&str, &[f64])] = &[("shape", &[3.0]), ("rows", &[5.0]), ("columns", &[49.0])];
    let made = run("net_shape", &[], set).unwrap();
    let (mut points, faces) = mesh(&made[0]);
    points.iter_mut().for_each(|p| p[2] = low + (high - low) * 0.5 * (p[2] + 1.0));
    Soup::new(points, &faces)
}

#[test]
fn a_film_between_two_tubes_is_a_catenoid() {
    // The radius of the waist: c cosh(0.4 / c) = 1, the larger of two roots.
    let (mut low, mut high) = (0.5f64, 1.0f64);
    for _ in 0..60 {
        let c = 0.5 * (low + high);
        if c * (0.4 / c).cosh() < 1.0 { low = c } else { high = c }
    }
    let set: &[(&str, &[f64])] = &[("rows", &[15.0]), ("tension", &[1.0]), ("stiffness", &[0.0])];
    let [below, above] = [tube(-2.4, -0.4), tube(0.4, 2.4)];
    // The last row of the first grid is joined to the first row of the second. Which rims these are
    // depends on the order of the faces.
    let joined = [[below.clone(), above.clone()], [above, below]].map(|grids| run("net_settle", &grids, set).unwrap());
    let films = joined.iter().map(|outputs| {
        let film = mesh(&outputs[0]).0.into_iter().filter(|p| p[2].abs() < 0.399).collect::<Vec<_>>();
        (film, outputs)
    });
    let (film, outputs) = films.max_by_key(|(film, _)| film.len()).unwrap();
    assert_eq!(film.len(), 15 * 48, "{}", text(&outputs[1]));
    assert_eq!(value(&outputs[1], "converged"), 1.0, "{}", text(&outputs[1]));
    for p in &film {
        let expected = low * (p[2] / low).cosh();
        assert!((p[0].hypot(p[1]) - expected).abs() < 2e-3, "{p:?} {expected}");
    }
    assert!(value(&outputs[1], "energy") < value(&outputs[1], "energy_before"));
}

#[test]
fn stiff_bridges_leave_sheets_without_a_kink() {
    // Two sheets with a gap of 3 between them, the second one 1 higher.
    let (first, mut second) = (sheet(4, 3), sheet(4, 3));
    second.points.iter_mut().for_each(|p| *p = [p[0] + 7.0, p[1], 1.0]);
    let set: &[(&str, &[f64])] = &[("direction", &[1.0]), ("rows", &[11.0])];
    let outputs = run("net_settle", &[first.clone(), second.clone()], set).unwrap();
    let (points, faces) = mesh(&outputs[0]);
    assert_eq!((faces.len(), common::euler(faces.iter().copied())), (24 + 12 * 3, 1));
    assert!(first.points.iter().chain(&second.points).all(|p| points.contains(p)));
    // A thin beam, clamped at both ends: a cubic polynomial.
    let bridge: Vec<_> = points.iter().filter(|p| p[0] > 4.0 && p[0] < 7.0).collect();
    assert_eq!(bridge.len(), 11 * 4);
    for p in bridge {
        let t = (p[0] - 4.0) / 3.0;
        let height = t * t * (3.0 - 2.0 * t);
        assert!((p[2] - height).abs() < 0.03, "{p:?} {height}");
    }
    // Without a force the bridge is straight.
    let straight = run("net_settle", &[first, second], &[set[0], set[1], ("stiffness", &[0.0])]).unwrap();
    assert_eq!(value(&straight[1], "idle_bridges"), 1.0);
    for p in mesh(&straight[0]).0.iter().filter(|p| p[0] > 4.0 && p[0] < 7.0) {
        assert!((p[2] - (p[0] - 4.0) / 3.0).abs() < 1e-12, "{p:?}");
    }
}
