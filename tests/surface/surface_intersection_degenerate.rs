//! Intersections where surfaces touch, coincide, end in poles, or have lines of nodes in common;
//! and sheets of other kinds.

use crate::common::data;
use crate::pairs::{ball, changes, distance, flat, from_torus, grid, length, meet, one, ring, summary, surface, turn};
use crate::shapes::{Random, Shape};
use glam::{DMat3, DVec3};
use gusset::Job;
use gusset::surface::{ContactKind, Patches, Place, Scheme, Sheet, Surface};
use std::f64::consts::TAU;

#[test]
fn equal_tori_that_are_shifted_touch_where_their_curves_cross() {
    // In the mirror plane lies one curve, and others cross it where the surfaces touch.
    let shape = ring(24, 48);
    let a = surface(&shape, |p| p);
    for shift in [0.5, 1.0, 1.5] {
        let b = surface(&shape, |p| p + DVec3::new(shift, 0.0, 0.0));
        let paths = meet(&a, &b);
        assert!(paths.closed.iter().all(|&closed| closed), "{shift}: {}", summary(&paths));
        let mirrored = paths.points.iter().filter(|p| (p.x - 0.5 * shift).abs() < 1e-9).count();
        assert!(mirrored > 10, "{shift}: {}", summary(&paths));
        let own = grid(&shape, Scheme::SixTap, |p| p);
        let truth = changes(&own, 6, |point| from_torus(point - DVec3::new(shift, 0.0, 0.0)));
        let far = truth.iter().map(|&point| distance(&paths, point)).fold(0.0, f64::max);
        assert!(far < 1e-2, "{shift}: {far}");
    }
}

#[test]
fn lines_of_nodes_that_meet_lines_of_nodes() {
    // Two equal tori, one above the other: two circles, which cross all columns of both where they
    // meet each other.
    let shape = ring(24, 48);
    for turn in [DMat3::IDENTITY, DMat3::from_rotation_y(0.6) * DMat3::from_rotation_z(1.0)] {
        for height in [0.02, 0.1, 0.3, 0.7] {
            let (a, b) = (surface(&shape, |p| turn * p), surface(&shape, |p| turn * (p + height * DVec3::Z)));
            let paths = meet(&a, &b);
            assert!(paths.len() == 2 && paths.closed == [true, true], "{height}: {}", summary(&paths));
            assert!(paths.unresolved.is_empty(), "{height}: {}", summary(&paths));
            assert!((length(&paths) / (2.0 * TAU) - 1.0).abs() < 1e-3, "{height}: {}", length(&paths));
            let own = |p: &DVec3| turn.transpose() * *p;
            assert!(
                paths.points.iter().all(|p| (own(p).z - 0.5 * height).abs() < 1e-9 && from_torus(own(p)).abs() < 1e-5)
            );
        }
    }
    // Half a turn of the ring maps columns to columns.
    let half = DMat3::from_rotation_x(0.25 * TAU);
    let (a, b) = (surface(&shape, |p| p), surface(&shape, |p| half * p + 0.5 * DVec3::X));
    let paths = meet(&a, &b);
    assert!(paths.closed.iter().all(|&closed| closed) && paths.len() >= 2, "{}", summary(&paths));
}

#[test]
fn planes_cut_balls_through_poles() {
    let a = surface(&ball(12, 24), |p| p);
    let mut random = Random(11);
    for k in 0..12 {
        // Through both poles, along columns of nodes and between them; through one; anywhere.
        let (turn, height) = match k {
            0..4 => (DMat3::from_rotation_z(0.21 * f64::from(k)) * DMat3::from_rotation_x(0.25 * TAU), 0.0),
            4..6 => (DMat3::from_rotation_z(0.4) * DMat3::from_rotation_x(0.3 + 0.5 * f64::from(k - 4)), f64::NAN),
            _ => (turn(&mut random), random.next() - 0.5),
        };
        let normal = turn * DVec3::Z;
        let height = if height.is_nan() { normal.z } else { height };
        let b = surface(&flat(6, 6), |p| turn * p + height * normal);
        let paths = meet(&a, &b);
        let expected = TAU * (1.0 - height * height).sqrt();
        assert!(paths.len() == 1 && paths.closed[0], "{k}: {} {}", summary(&paths), length(&paths));
        assert!((length(&paths) / expected - 1.0).abs() < 1e-3, "{k}: {} {expected}", length(&paths));
        assert!(paths.unresolved.is_empty(), "{k}: {}", summary(&paths));
    }
}

#[test]
fn what_touches_is_reported() {
    // A paraboloid on a plane, in the middle of cells and at corners.
    let bowl = Shape {
        name: "bowl",
        cells: [4, 4],
        closed: [false, false],
        point: |u, v| {
            let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
            DVec3::new(x, y, 0.5 * (x * x + 2.0 * y * y))
        },
    };
    for shift in [DVec3::ZERO, DVec3::new(0.23, 0.11, 0.0)] {
        let a = surface(&bowl, |p| p + shift);
        for plane in [flat(4, 4), flat(5, 7)] {
            let paths = meet(&a, &surface(&plane, |p| p));
            assert!(paths.unresolved.is_empty() && paths.is_empty(), "{}", summary(&paths));
            assert_eq!(paths.contacts.len(), 1);
            let contact = paths.contacts[0];
            assert_eq!(contact.kind, ContactKind::Point);
            assert!(a.jet(contact.place).point.distance(shift) < 1e-9, "{contact:?}");
        }
    }
    // A torus under its top circle.
    let a = surface(&ring(24, 48), |p| p);
    let paths = meet(&a, &surface(&flat(5, 5), |p| p + DVec3::new(0.0, 0.0, 0.4)));
    let rows: std::collections::HashSet<u32> = paths.unresolved.iter().map(|place| place.cell[1]).collect();
    assert_eq!(rows.len(), 48, "{}", summary(&paths));
    assert!(paths.unresolved.iter().all(|place| [5, 6].contains(&place.cell[0])));
}

#[test]
fn what_coincides_is_reported() {
    let shape = ring(16, 32);
    let a = surface(&shape, |p| p);
    let paths = meet(&a, &a);
    let cells: std::collections::HashSet<[u32; 2]> = paths.unresolved.iter().map(|place| place.cell).collect();
    assert!(cells.len() == 16 * 32 && paths.is_empty(), "{}", summary(&paths));
    // Planes in each other, of different cells.
    let (one, other) = (surface(&flat(5, 5), |p| p), surface(&flat(7, 6), |p| p + DVec3::new(0.1, 0.2, 0.0)));
    let paths = meet(&one, &other);
    assert!(paths.is_empty() && paths.unresolved.len() == 25, "{}", summary(&paths));
}

#[test]
fn patches_of_any_degree_and_several_sheets() {
    // A quarter of the plane z = x y as one bilinear patch, raised, against four flat sheets that
    // share sides.
    let corners = [[-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, 1.0]];
    let saddle: Vec<DVec3> = corners.map(|[x, y]: [f64; 2]| DVec3::new(x, y, x * y)).to_vec();
    let (cubic, high) = (Patches::<4>::new(&saddle, [1, 1], 1, 1), Patches::<8>::new(&saddle, [1, 1], 1, 1));
    let quarters = |z: f64| {
        let quarter = |k: usize| {
            let (x, y) = ((k / 2) as f64, (k % 2) as f64);
            let at = |a: f64, b: f64| DVec3::new(2.0 * (x + a) - 2.0, 2.0 * (y + b) - 2.0, z);
            let points = [at(0.0, 0.0), at(0.0, 1.0), at(1.0, 0.0), at(1.0, 1.0)];
            Sheet::Cubic(Patches::new(&points, [1, 1], 1, 1).unwrap())
        };
        Surface::new((0..4).map(quarter).collect(), None, &Job::default()).unwrap()
    };
    // The same saddle in two halves that are turned against each other: their common side is found
    // once.
    let half = |x: f64| {
        let points = [[0.0, -1.0], [0.0, 1.0], [x, -1.0], [x, 1.0]].map(|[x, y]: [f64; 2]| DVec3::new(x, y, x * y));
        Sheet::Cubic(Patches::new(&points, [1, 1], 1, 1).unwrap())
    };
    let halves = Surface::new(vec![half(-1.0), half(1.0)], None, &Job::default()).unwrap();
    let across = surface(&flat(4, 4), |p| DMat3::from_rotation_y(0.25 * TAU) * p);
    let paths = meet(&halves, &across);
    assert!(paths.len() == 1 && (length(&paths) - 2.0).abs() < 1e-12, "{}", summary(&paths));
    for a in [one(Sheet::Cubic(cubic.unwrap())), one(Sheet::High(high.unwrap()))] {
        let paths = meet(&a, &quarters(0.25));
        assert!(paths.len() == 2 && paths.unresolved.is_empty(), "{}", summary(&paths));
        assert!(paths.points.iter().all(|p| (p.x * p.y - 0.25).abs() < 1e-12));
        let spots = [0.25, 1.0].map(|x: f64| DVec3::new(x, 0.25 / x, 0.25));
        assert!(spots.iter().all(|&p| distance(&paths, p) < 1e-3 && distance(&paths, -p.with_z(-0.25)) < 1e-3));
        // Two lines, on the common sides of the sheets: each is found once, though two sheets have
        // it; they cross where the surfaces touch.
        let paths = meet(&a, &quarters(0.0));
        assert!((length(&paths) - 4.0).abs() < 1e-3, "{} {}", summary(&paths), length(&paths));
        let crossing = paths.contacts[0];
        assert!(paths.contacts.len() == 1 && crossing.kind == ContactKind::Crossing, "{:?}", paths.contacts);
        assert!(a.jet(crossing.place).point.length() < 1e-9, "{crossing:?}");
        assert!(paths.unresolved.is_empty(), "{:?}", paths.unresolved);
    }
}

#[test]
fn four_point_sheets_meet_too() {
    let shape = ring(24, 48);
    let a = one(Sheet::Grid(grid(&shape, Scheme::FourPoint, |p| p)));
    let b = one(Sheet::Grid(grid(&shape, Scheme::FourPoint, |p| DMat3::from_rotation_x(1.0) * p + 0.3)));
    let paths = meet(&a, &b);
    assert!(!paths.is_empty() && paths.closed.iter().all(|&closed| closed), "{}", summary(&paths));
    let plane = surface(&flat(4, 4), |p| p);
    let paths = meet(&a, &plane);
    assert!(paths.len() == 2 && paths.closed.iter().all(|&closed| closed), "{}", summary(&paths));
}

#[test]
fn sheets_that_are_no_surfaces() {
    // One point, one line, one node twice as many times: no panic, no endless work.
    let point = Shape { name: "point", cells: [3, 3], closed: [false, false], point: |_, _| DVec3::new(0.1, 0.2, 0.0) };
    let line = Shape { name: "line", cells: [3, 3], closed: [false, false], point: |u, v| DVec3::splat(u + v - 1.0) };
    let plane = surface(&flat(4, 4), |p| p);
    for shape in [&point, &line] {
        let tolerance = Some(1e-6);
        let a =
            Surface::new(vec![Sheet::Grid(grid(shape, Scheme::SixTap, |p| p))], tolerance, &Job::default()).unwrap();
        for paths in [meet(&a, &plane), meet(&plane, &a), meet(&a, &a)] {
            assert!(length(&paths) < 1e-3, "{}: {}", shape.name, summary(&paths));
        }
    }
}

/// Newell's teapot of 32 patches, if the data is there.
fn teapot() -> Option<Surface<'static>> {
    let text = data::text("carcass/teapot_bezier.json")?;
    let data: serde_json::Value = serde_json::from_str(&text).unwrap();
    let numbers = |value: &serde_json::Value| -> Vec<f64> {
        value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
    };
    let vertices: Vec<DVec3> =
        data["vertices"].as_array().unwrap().iter().map(|v| DVec3::from_slice(&numbers(v))).collect();
    let sheet = |patch: &serde_json::Value| {
        let points: Vec<DVec3> = numbers(patch).into_iter().map(|k| vertices[k as usize]).collect();
        Sheet::Cubic(Patches::new(&points, [3, 3], 1, 1).unwrap())
    };
    let sheets = data["patches"].as_array().unwrap().iter().map(sheet).collect();
    Some(Surface::new(sheets, None, &Job::default()).unwrap())
}

#[test]
fn a_teapot_cut_by_planes() {
    let Some(teapot) = teapot() else { return };
    let [low, high] = teapot.bounds();
    let (middle, size) = (0.5 * (low + high), low.distance(high));
    let mut random = Random(21);
    for k in 0..20 {
        let turn = turn(&mut random);
        let shift = middle + random.point(0.05 * size);
        let paths = meet(&teapot, &surface(&flat(9, 7), |p| turn * (0.5 * size * p) + shift));
        let height = |p: DVec3| (p - shift).dot(turn * DVec3::Z);
        let mut crossings = 0;
        for sheet in 0..teapot.len() as u32 {
            let at = |r: i32, c: i32| {
                let (u, v) = (f64::from(r) / 40.0, f64::from(c) / 40.0);
                teapot.jet(Place { sheet, cell: [0, 0], u, v }).point
            };
            for (r, c) in (0..=40).flat_map(|r| (0..40).map(move |c| (r, c))) {
                for [p, q] in [[at(r, c), at(r, c + 1)], [at(c, r), at(c + 1, r)]] {
                    let (f, g) = (height(p), height(q));
                    if f.max(g) > 1e-12 && f.min(g) < -1e-12 {
                        crossings += 1;
                        let far = distance(&paths, p.lerp(q, f / (f - g)));
                        assert!(far < 2e-3 * size, "{k}: {p} {far} {}", summary(&paths));
                    }
                }
            }
        }
        assert!(crossings > 100 && paths.unresolved.is_empty(), "{k}: {crossings} {}", summary(&paths));
    }
}

#[test]
fn sheets_that_are_lines_meet_in_unresolved_cells() {
    let nodes = |axis: usize| -> Vec<f64> {
        (0..36)
            .flat_map(|k| std::array::from_fn::<f64, 3, _>(|n| if n == axis { f64::from(k / 6) - 2.3 } else { 0.0 }))
            .collect()
    };
    let sheet = |axis: usize| {
        let nodes = gusset::surface::Nodes::strided(nodes(axis), 6, 6, 0, 0).unwrap();
        Sheet::Grid(gusset::surface::Grid::new(nodes, [false; 2], Scheme::SixTap).unwrap())
    };
    let [along, across] = [0, 1].map(|axis| Surface::new(vec![sheet(axis)], None, &Job::default()).unwrap());
    for other in [&along, &across] {
        let paths = meet(&along, other);
        // Where they meet is not lost: it is in cells of the third row.
        assert!(paths.is_empty() && paths.unresolved.iter().any(|place| place.cell[0] == 2), "{}", summary(&paths));
    }
}
