//! Normals and their limits, curvatures, parameters, estimates, meshes.

use crate::common::Silent;
use crate::shapes::{Random, SHAPES, Shape, grid, torus};
use glam::DVec3;
use gusset::surface::{
    Grid, Nodes, NormalKind, Patches, Place, Scheme, Sheet, Surface, SurfaceMesh, SurfaceMeshOptions,
};
use gusset::{Element, Error, Job};
use std::collections::HashMap;
use std::f64::consts::TAU;

fn job() -> Job<'static> {
    Job::default()
}

/// A cap or a cone over a disc: rows are circles, row 0 the pole; moved and scaled.
fn cap(rows: usize, columns: usize, shift: DVec3, size: f64, height: impl Fn(f64) -> f64) -> Sheet<'static> {
    let mut data = Vec::new();
    for (i, j) in (0..=rows).flat_map(|i| (0..=columns).map(move |j| (i, j % columns))) {
        let (r, angle) = (i as f64 / rows as f64, TAU * j as f64 / columns as f64);
        data.extend((shift + size * DVec3::new(r * angle.cos(), r * angle.sin(), height(r))).to_array());
    }
    let nodes = Nodes::strided(data, rows + 1, columns + 1, 0, 0).unwrap();
    Sheet::Grid(Grid::new(nodes, [false, true], Scheme::SixTap).unwrap())
}

#[test]
fn limits_at_poles() {
    for (shift, size, noise) in [(DVec3::ZERO, 1.0, 0.0), (DVec3::splat(1e6), 1.0, 1e-6), (DVec3::ZERO, 1e-9, 0.0)] {
        let smooth = cap(12, 32, shift, size, |r| 1.0 - 0.3 * r * r);
        assert_eq!(smooth.poles_at_sides(), [[true, false], [false, false]]);
        for (j, v) in [(0, 0.0), (5, 0.3), (31, 1.0)] {
            let normal = smooth.normal_or_limit(0, j, 0.0, v);
            assert_eq!(normal.kind, NormalKind::Limit);
            assert!(normal.direction.distance(DVec3::Z) < 1e-3 + noise && normal.spread < 2e-3 + noise, "{normal:?}");
            assert_eq!(smooth.normal(0, j, 0.0, v), normal.direction);
        }
        // A little away from it the normal is regular, and nearly the same.
        let near = smooth.normal_or_limit(0, 3, 1e-3, 0.5);
        assert!(near.kind == NormalKind::Regular && near.direction.distance(DVec3::Z) < 2e-3 + noise, "{near:?}");
        // A cone has a normal along each line, and none at the tip: they are 90 degrees apart from
        // one another across.
        let cone = cap(12, 32, shift, size, |r| 1.0 - r);
        let normal = cone.normal_or_limit(0, 0, 0.0, 0.0);
        let along = DVec3::new(1.0, 0.0, 1.0).normalize();
        assert!(normal.direction.distance(along) < 1e-4 + noise, "{normal:?}");
        assert!((normal.spread - TAU / 4.0).abs() < 1e-3 + noise, "{normal:?}");
    }
    // The better the nodes, the nearer the limit: third order at least.
    let error = |n: usize| {
        let cap = cap(n, 2 * n, DVec3::ZERO, 1.0, |r| (1.0 - 0.5 * r * r).cos());
        let off = |v: f64| cap.normal(0, 3, 0.0, v).cross(DVec3::Z).length();
        [0.0, 0.3, 0.5, 0.8].map(off).into_iter().fold(0.0, f64::max)
    };
    let errors = [8, 16, 32].map(error);
    assert!(errors.windows(2).all(|pair| (pair[0] / pair[1]).log2() > 2.7), "{errors:?}");
}

#[test]
fn limits_on_patches() {
    // Two rows of control points in one point: S_u vanishes with S_v, and the limit is in the third
    // coefficient.
    let mut net = [DVec3::ZERO; 16];
    for (k, point) in net.iter_mut().enumerate().skip(8) {
        let (a, b) = ((k / 4) as f64 - 1.0, (k % 4) as f64 / 3.0);
        *point = DVec3::new(a * (1.0 - b), a * b, 0.1 * (a - 1.0));
    }
    let sheet = Sheet::Cubic(Patches::new(&net, [3, 3], 1, 1).unwrap());
    for v in [0.0, 0.4, 1.0] {
        let normal = sheet.normal_or_limit(0, 0, 0.0, v);
        assert_eq!(normal.kind, NormalKind::Limit);
        assert!(normal.direction.distance(sheet.normal(0, 0, 1e-3, v)) < 1e-2, "{normal:?}");
    }
    // The same with the pole at the end of u, in v, and with exchanged sides: the limit agrees with
    // nearby normals.
    let turned = |f: fn(usize, usize) -> usize| {
        let net: Vec<DVec3> = (0..16).map(|k| net[f(k / 4, k % 4)]).collect();
        Sheet::Cubic(Patches::new(&net, [3, 3], 1, 1).unwrap())
    };
    let (down, left, right) =
        (turned(|a, b| 4 * (3 - a) + b), turned(|a, b| 4 * b + a), turned(|a, b| 4 * (3 - b) + a));
    for (sheet, [u, v], [s, t]) in
        [(down, [1.0, 0.4], [0.999, 0.4]), (left, [0.4, 0.0], [0.4, 1e-3]), (right, [0.4, 1.0], [0.4, 0.999])]
    {
        let (limit, near) = (sheet.normal(0, 0, u, v), sheet.normal(0, 0, s, t));
        assert!(limit.distance(near) < 1e-2, "{limit} {near}");
    }
    // A disc from a square: the tangents are parallel in the corner.
    let (a, b) = (DVec3::new(1.0, 1.0, 0.0), DVec3::new(-1.0, -1.0, 0.0));
    let points = [DVec3::ZERO, a, DVec3::X * 2.0, b, DVec3::Z * 0.0 + DVec3::Y * -1.0 + DVec3::X, DVec3::X * 3.0];
    let net = [
        points[0],
        points[1],
        points[2],
        points[3],
        points[4],
        points[5],
        -DVec3::Y * 2.0,
        DVec3::new(1.0, -3.0, 0.0),
        DVec3::new(3.0, -2.0, 0.0),
    ];
    let corner = Sheet::Cubic(Patches::new(&net, [2, 2], 1, 1).unwrap());
    let normal = corner.normal_or_limit(0, 0, 0.0, 0.0);
    assert_eq!(normal.kind, NormalKind::Limit);
    assert!(normal.direction.distance(corner.normal(0, 0, 1e-3, 1e-3)) < 1e-9, "{normal:?}");
    // A line segment lacks normals.
    let line: Vec<DVec3> = (0..4).map(|k| DVec3::X * f64::from(k / 2)).collect();
    let line = Sheet::Cubic(Patches::new(&line, [1, 1], 1, 1).unwrap());
    assert_eq!(line.normal_or_limit(0, 0, 0.3, 0.5).kind, NormalKind::None);
    assert_eq!(line.normal(0, 0, 0.0, 0.0), DVec3::ZERO);
}

#[test]
fn curvatures_of_a_torus() {
    let shape = Shape { cells: [64, 128], ..SHAPES[0] };
    let surface = Surface::new(vec![Sheet::Grid(grid(&shape))], None, &job()).unwrap();
    let mut random = Random(11);
    let places: Vec<Place> = (0..200)
        .map(|_| {
            let (u, v) = (random.next() * 64.0, random.next() * 128.0);
            surface.place(0, [u, v]).unwrap()
        })
        .collect();
    let found = surface.evaluate(&places, &job()).unwrap();
    for (place, local) in places.iter().zip(&found) {
        let [u, v] = place.parameters();
        let (u, v) = (TAU * u / 64.0, TAU * v / 128.0);
        let curvatures = local.curvatures.unwrap();
        // The normal S_u x S_v is inwards or outwards; the surface bends away from the outer one.
        let outer = DVec3::new(u.cos() * v.cos(), u.cos() * v.sin(), u.sin());
        let sign = -local.normal.direction.dot(outer).signum();
        let (tube, ring) = (sign / 0.4, sign * u.cos() / (1.0 + 0.4 * u.cos()));
        let truth = [tube.max(ring), tube.min(ring)];
        assert!(curvatures.principal.iter().zip(truth).all(|(k, t)| (k - t).abs() < 5e-3), "{curvatures:?} {truth:?}");
        assert!((curvatures.mean - 0.5 * (tube + ring)).abs() < 5e-3);
        assert!((curvatures.gaussian - tube * ring).abs() < 1e-2);
        let round = DVec3::new(-v.sin(), v.cos(), 0.0);
        let of_ring =
            if (curvatures.principal[0] - ring).abs() < (curvatures.principal[1] - ring).abs() { 0 } else { 1 };
        assert!(curvatures.directions[of_ring].cross(round).length() < 1e-3);
        assert!(curvatures.directions[0].dot(curvatures.directions[1]).abs() < 1e-12);
        let (mean, gaussian) = crate::shapes::curvatures(&local.jet).unwrap();
        assert!((mean - curvatures.mean).abs() < 1e-9 && (gaussian - curvatures.gaussian).abs() < 1e-9);
        assert_eq!(local.normal.direction, surface.normal(*place));
    }
    // One by one, and on one thread, the same bits.
    let one = surface.evaluate(&places, &Job::new(1, &Silent)).unwrap();
    assert_eq!(one, found);
    assert_eq!(surface.evaluate(&places[7..8], &job()).unwrap()[0], found[7]);
    let mut bad = places.clone();
    bad[3].u = 1.0 + 1e-15;
    assert!(matches!(
        surface.evaluate(&bad, &job()),
        Err(Error::NoSuch { element: Element::Place, index: 3, count: 1 })
    ));
    bad[2].v = f64::NAN;
    assert!(matches!(
        surface.evaluate(&bad, &job()),
        Err(Error::NoSuch { element: Element::Place, index: 2, count: 1 })
    ));
    bad[1].cell[1] = 128;
    assert!(matches!(
        surface.evaluate(&bad, &job()),
        Err(Error::NoSuch { element: Element::Place, index: 1, count: 1 })
    ));
}

#[test]
fn parameters_there_and_back() {
    let sheets = vec![Sheet::Grid(grid(&SHAPES[0])), Sheet::Grid(grid(&SHAPES[2]))];
    let surface = Surface::new(sheets, None, &job()).unwrap();
    for (sheet, [u, v], expected) in [
        (0, [3.25, 36.5], [3.25, 36.5]),
        (0, [-0.5, 37.0], [19.5, 0.0]),
        (0, [45.0, -75.0], [5.0, 36.0]),
        (1, [-3.0, 99.0], [0.0, 52.0]),
        (1, [40.0, 51.999], [40.0, 51.999]),
    ] {
        let place = surface.place(sheet, [u, v]).unwrap();
        assert!(surface.has_place(&place));
        let [a, b] = place.parameters();
        assert!((a - expected[0]).abs() < 1e-12 && (b - expected[1]).abs() < 1e-12, "{place:?}");
    }
    assert!(surface.place(2, [0.0, 0.0]).is_err());
    assert!(surface.place(0, [f64::NAN, 0.0]).is_err() && surface.place(1, [0.0, f64::INFINITY]).is_err());
    // Tiny below 0 of a closed direction: the end of the last cell, or the start of the first.
    let place = surface.place(0, [-1e-18, 0.0]).unwrap();
    assert!(surface.has_place(&place));
}

#[test]
fn estimates_are_near_the_errors() {
    for (k, bumps) in [(0, 0.0), (1, 0.15)] {
        for scheme in [Scheme::SixTap, Scheme::FourPoint] {
            let shape = Shape { cells: [60, 96], ..SHAPES[k] };
            let grid = Grid::new(grid(&shape).nodes().clone(), shape.closed, scheme).unwrap();
            let sheet = Sheet::Grid(grid);
            let estimates = sheet.interpolation_errors(&job()).unwrap();
            let flat = sheet.flatness_bounds_of_cells(&job()).unwrap();
            let (mut most, mut greatest) = (0.0_f64, 0.0_f64);
            for (cell, &estimate) in estimates.iter().enumerate() {
                let (i, j) = (cell / 96, cell % 96);
                let mut worst = 0.0_f64;
                for (s, t) in (0..25).map(|k| (f64::from(k / 5) / 4.0, f64::from(k % 5) / 4.0)) {
                    let truth = torus((i as f64 + s) / 60.0, (j as f64 + t) / 96.0, bumps);
                    let point = sheet.jet(i, j, s, t).point;
                    worst = worst.max(point.distance(truth));
                    // Certified: the bilinear patch and the triangles.
                    let [a, b] = [
                        sheet.corner(i, j).lerp(sheet.corner(i, j + 1), t),
                        sheet.corner(i + 1, j).lerp(sheet.corner(i + 1, j + 1), t),
                    ];
                    assert!(point.distance(a.lerp(b, s)) <= flat[cell][0] + 1e-15);
                    let p = [
                        sheet.corner(i, j),
                        sheet.corner(i + 1, j),
                        sheet.corner(i + 1, j + 1),
                        sheet.corner(i, j + 1),
                    ];
                    let (one, other) = if s >= t { (p[1], s) } else { (p[3], t) };
                    let low = s.min(t);
                    let triangle = p[0] * (1.0 - other) + one * (other - low) + p[2] * low;
                    assert!(point.distance(triangle) <= flat[cell][1] + 1e-15);
                }
                most = most.max(worst);
                greatest = greatest.max(estimate);
                assert!(
                    worst < 2.0 * estimate + 0.05 * greatest.max(most),
                    "{} {i} {j}: {worst} {estimate}",
                    shape.name
                );
            }
            assert!(most < 2.0 * greatest && greatest < 2.0 * most, "{} {scheme:?}: {most} {greatest}", shape.name);
        }
    }
    // Open sides too.
    let sheet = Sheet::Grid(grid(&SHAPES[2]));
    let estimates = sheet.interpolation_errors(&job()).unwrap();
    let [_, w] = sheet.cells();
    for (i, j) in [(0, 20), (39, 31), (17, 0), (0, 0), (39, 51)] {
        let truth = |u: f64, v: f64| (SHAPES[2].point)(u / 40.0, v / 52.0);
        let at = [0.25, 0.5, 0.75];
        let error = |s: f64, t: f64| sheet.jet(i, j, s, t).point.distance(truth(i as f64 + s, j as f64 + t));
        let worst = at.iter().flat_map(|&s| at.map(|t| error(s, t))).fold(0.0, f64::max);
        let estimate = estimates[i * w + j];
        assert!(worst < 2.0 * estimate && estimate < 4.0 * worst, "{i} {j}: {worst} {estimate}");
    }
    // Too few nodes give no estimate, and patches are exact.
    let few = Nodes::strided(vec![1.0; 3 * 4 * 9], 4, 9, 0, 0).unwrap();
    let few = Sheet::Grid(Grid::new(few, [false, false], Scheme::SixTap).unwrap());
    assert!(few.interpolation_errors(&job()).unwrap().iter().all(|&error| error == f64::INFINITY));
    let patch = Sheet::Cubic(Patches::new(&[DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::ONE], [1, 1], 1, 1).unwrap());
    assert_eq!(patch.interpolation_errors(&job()), Ok(vec![0.0]));
    let [bilinear, triangles] = patch.flatness_bounds(0, 0);
    assert!(bilinear < 1e-15 && (triangles - 0.25).abs() < 1e-15);
}

/// The Euler characteristic, and whether each edge has two faces that pass it in opposite
/// directions.
fn topology(made: &SurfaceMesh) -> (i64, bool) {
    let mut edges: HashMap<(u32, u32), i64> = HashMap::new();
    for face in made.mesh.faces() {
        for (k, &a) in face.iter().enumerate() {
            *edges.entry((a, face[(k + 1) % face.len()])).or_default() += 1;
        }
    }
    let closed = edges.iter().all(|(&(a, b), &count)| count == 1 && edges.get(&(b, a)) == Some(&1));
    let pairs = edges.keys().filter(|&&(a, b)| a < b || !edges.contains_key(&(b, a))).count();
    (made.mesh.positions.len() as i64 - pairs as i64 + made.mesh.face_count() as i64, closed)
}

#[test]
fn meshes_are_as_closed_as_sheets_and_as_near_as_they_say() {
    for (shape, euler) in SHAPES.iter().zip([0, 0, 1, 1]) {
        let sheet = Sheet::Grid(grid(shape));
        for (tolerance, least, triangles) in
            [(f64::INFINITY, [1, 1], false), (5e-3, [1, 1], true), (f64::INFINITY, [2, 3], true), (2e-3, [1, 1], false)]
        {
            let options = SurfaceMeshOptions { tolerance, least, triangles };
            let made = sheet.to_mesh(&options, &job()).unwrap();
            assert!(made.deviation <= tolerance, "{}: {}", shape.name, made.deviation);
            let (found, closed) = topology(&made);
            assert_eq!((found, closed), (euler, shape.closed == [true, true]), "{}", shape.name);
            assert!(made.mesh.view(&job()).is_ok());
            // Faces look where the normals do, and triangles are near the surface.
            let surface = Surface::new(vec![sheet.clone()], None, &job()).unwrap();
            for (k, face) in made.mesh.faces().enumerate().step_by(37) {
                let at = |k: usize| made.mesh.positions.get(face[k]);
                let normal = (at(1) - at(0)).cross(at(2) - at(0));
                assert!(normal.dot(made.normals[face[1] as usize]) > 0.0, "{}", shape.name);
                if triangles && k % 5 == 0 {
                    let middle = (at(0) + at(1) + at(2)) / 3.0;
                    assert!(surface.closest(middle, f64::INFINITY).unwrap().distance <= made.deviation);
                }
            }
            for (k, place) in made.places.iter().enumerate().step_by(11) {
                assert_eq!(surface.jet(*place).point, made.mesh.positions.get(k as u32));
                assert!((made.normals[k].length() - 1.0).abs() < 1e-12);
            }
        }
    }
    // A sphere: two poles and a seam make it closed.
    let sphere = Shape {
        name: "sphere",
        cells: [12, 24],
        closed: [false, true],
        point: |u, v| {
            let r = if u == 0.0 || u == 1.0 { 0.0 } else { (0.5 * TAU * u).sin() };
            DVec3::new(r * (TAU * v).cos(), r * (TAU * v).sin(), (0.5 * TAU * u).cos())
        },
    };
    let sheet = Sheet::Grid(grid(&sphere));
    assert_eq!(sheet.poles_at_sides(), [[true, true], [false, false]]);
    let made = sheet.to_mesh(&SurfaceMeshOptions { tolerance: 1e-2, ..Default::default() }, &job()).unwrap();
    assert_eq!(topology(&made), (2, true));
}

#[test]
fn meshes_that_cannot_be() {
    let sheet = Sheet::Grid(grid(&SHAPES[1]));
    let make = |tolerance: f64, least: [u32; 2]| {
        sheet.to_mesh(&SurfaceMeshOptions { tolerance, least, triangles: true }, &job()).map(|made| made.deviation)
    };
    for tolerance in [0.0, -1.0, f64::NAN] {
        assert!(matches!(make(tolerance, [1, 1]), Err(Error::OptionOutOfRange { option: "tolerance", .. })));
    }
    assert!(matches!(make(1.0, [0, 1]), Err(Error::OptionOutOfRange { option: "parts", .. })));
    assert!(matches!(make(1e-300, [1, 1]), Err(Error::TooLarge { .. })));
    assert!(matches!(make(1.0, [u32::MAX, u32::MAX]), Err(Error::TooLarge { .. })));
}

#[test]
fn grids_that_are_none_and_repeated_nodes() {
    let strided = |rows, columns| Nodes::strided(vec![0.0; 3 * 9], rows, columns, 0, 0);
    assert!(matches!(strided(1, 9), Err(Error::NetTooSmall { rows: 1, columns: 9 })));
    assert!(matches!(strided(9, 1), Err(Error::NetTooSmall { .. })));
    let mut data = vec![0.0; 27];
    data[14] = f64::NAN;
    let nodes = Nodes::strided(data, 3, 3, 0, 0).unwrap();
    let found = Grid::new(nodes, [false, false], Scheme::SixTap).map(|_| ());
    assert!(matches!(found, Err(Error::NotFinite { element: Element::Node, index: 4, .. })));
    // A row twice: the surface folds back to a line there; everything still answers.
    let data: Vec<f64> = (0..30).flat_map(|k: i32| [f64::from((k / 5).min(4)), f64::from(k % 5), 0.0]).collect();
    let nodes = Nodes::strided(data, 6, 5, 0, 0).unwrap();
    let sheet = Sheet::Grid(Grid::new(nodes, [false, false], Scheme::SixTap).unwrap());
    let surface = Surface::new(vec![sheet.clone()], None, &job()).unwrap();
    assert!(surface.closest(DVec3::new(2.0, 2.2, 1.0), 10.0).unwrap().distance <= 1.0 + 1e-12);
    assert!(sheet.to_mesh(&Default::default(), &job()).unwrap().mesh.face_count() >= 16);
}
