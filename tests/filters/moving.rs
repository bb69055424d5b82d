//! Filters that move vertices: wraps, lattices, morphs, held against formulas for the points.

use crate::common::{Soup, cap, sheet};
use crate::editor::{box_around, mesh, pieces, points, radius, run_on, values};
use glam::{DMat3, DVec3};
use gusset::Error;
use gusset::filters::data::{Input, Output};
use gusset::mesh::{Faces, MeshView, Positions};
use gusset::{Job, Result};
use std::f64::consts::{FRAC_PI_2, TAU};

/// The places of the wraps among the fields of `deform`, and of the x axis among its axes.
const CYLINDER: f64 = 5.0;
const CONE: f64 = 6.0;
const TORUS: f64 = 7.0;
const SPHERE: f64 = 8.0;
const X: f64 = 1.0;

fn run(id: &str, soups: &[Soup], set: &[(&str, &[f64])]) -> Result<Vec<Output>> {
    let inputs: Vec<_> = soups.iter().map(|soup| Input::Mesh(soup.view())).collect();
    run_on(id, soups, &values(id, &inputs, set))
}

fn moved(id: &str, soups: &[Soup], set: &[(&str, &[f64])]) -> Vec<[f64; 3]> {
    let outputs = run(id, soups, set).unwrap_or_else(|error| panic!("{id}: {error}"));
    let (points, faces) = mesh(&outputs[0]);
    assert_eq!(faces, soups[0].faces().collect::<Vec<_>>(), "{id}");
    points
}

#[test]
fn wraps_put_sheets_on_their_surfaces() {
    let flat = sheet(8, 6);
    let wrap = |field: f64, axis: f64| {
        let set: [(&str, &[f64]); 5] =
            [("field", &[field]), ("axis", &[axis]), ("radius", &[10.0]), ("minor_radius", &[3.0]), ("lean", &[0.5])];
        flat.points.clone().into_iter().zip(moved("deform", std::slice::from_ref(&flat), &set)).collect::<Vec<_>>()
    };
    for (p, q) in wrap(CYLINDER, X) {
        // y is the arc, and z, which is 0, the height.
        let (sin, cos) = (p[1] / 10.0).sin_cos();
        assert!((0..3).all(|k| (q[k] - [p[0], 10.0 * sin, 10.0 * cos][k]).abs() < 1e-12), "{p:?} {q:?}");
    }
    for (p, q) in wrap(CONE, X) {
        let (sin, cos) = 0.5f64.sin_cos();
        assert!((q[0] - p[0] * cos).abs() < 1e-12 && (q[1].hypot(q[2]) - (10.0 - p[0] * sin)).abs() < 1e-12, "{q:?}");
    }
    for (p, q) in wrap(TORUS, 0.0) {
        let (around, distance) = (q[1].atan2(q[0]), q[0].hypot(q[1]));
        assert!(((distance - 10.0).hypot(q[2]) - 3.0).abs() < 1e-12, "{q:?}");
        assert!((around - p[0] / 10.0).abs() < 1e-12, "{p:?} {q:?}");
        assert!((q[2].atan2(distance - 10.0) - p[1] / 3.0).abs() < 1e-12, "{p:?} {q:?}");
    }
    for (p, q) in wrap(SPHERE, 0.0) {
        assert!((radius(&q) - 10.0).abs() < 1e-12 && (q[2] - 10.0 * (p[1] / 10.0).sin()).abs() < 1e-12, "{p:?} {q:?}");
    }
}

#[test]
fn half_a_cylinder_wrap_bends_edges_to_chords_of_twice_the_radius() {
    let flat = sheet(2, 6);
    let set: [(&str, &[f64]); 4] = [("field", &[CYLINDER]), ("axis", &[X]), ("radius", &[2.0]), ("strength", &[0.5])];
    let points = moved("deform", std::slice::from_ref(&flat), &set);
    let distance = |a: usize, b: usize| DVec3::from(points[a]).distance(points[b].into());
    for v in 0..points.len() - 3 {
        assert!((distance(v, v + 3) - 8.0 * 0.125f64.sin()).abs() < 1e-12, "{v}");
        assert!(v % 3 == 2 || (distance(v, v + 1) - 1.0).abs() < 1e-12, "{v}");
    }
}

#[test]
fn suggested_radii_close_the_sheet() {
    let flat = sheet(8, 5);
    let vertex = |i: usize, j: usize| 9 * j + i;
    for field in [CYLINDER, TORUS] {
        let points = moved("deform", std::slice::from_ref(&flat), &[("field", &[field])]);
        let apart = |a: usize, b: usize| DVec3::from(points[a]).distance(points[b].into());
        assert!((0..6).all(|j| apart(vertex(0, j), vertex(8, j)) < 1e-12), "{field}");
        assert_eq!((0..9).all(|i| apart(vertex(i, 0), vertex(i, 5)) < 1e-12), field == TORUS);
        // Halfway round is a diameter away.
        let across = 8.0 / TAU + if field == TORUS { 5.0 / TAU } else { 0.0 };
        assert!((apart(0, vertex(4, 0)) - 2.0 * across).abs() < 1e-12, "{field}");
    }
}

/// A mesh with other points.
fn at(soup: &Soup, map: impl Fn(DVec3) -> DVec3) -> Soup {
    Soup { points: soup.points.iter().map(|&p| map(p.into()).to_array()).collect(), ..soup.clone() }
}

#[test]
fn morphs_begin_and_end_with_the_given_meshes() {
    // An odd and an even number of vertices.
    for soup in [cap(5, 3, 0.2, 1.0), sheet(3, 2)] {
        let after = at(&soup, |p| DVec3::new(2.0 * p.x + 0.1, p.y.exp(), p.z - p.x));
        let both = [soup.clone(), after.clone()];
        for path in [0.0, 1.0] {
            let morph = |ratio: f64| moved("morph", &both, &[("ratio", &[ratio]), ("path", &[path])]);
            assert_eq!(morph(0.0), soup.points, "path {path}");
            assert_eq!(morph(1.0), after.points, "path {path}");
        }
        for ((p, q), m) in soup.points.iter().zip(&after.points).zip(moved("morph", &both, &[("ratio", &[0.25])])) {
            assert!((0..3).all(|k| (0.75 * p[k] + 0.25 * q[k] - m[k]).abs() < 1e-15), "{m:?}");
        }
    }
}

#[test]
fn morphs_with_rotation_keep_rigidly_moved_shapes() {
    let (soup, _) = pieces(100).into();
    let (turn, half) = (DMat3::from_rotation_z(FRAC_PI_2), DMat3::from_rotation_z(0.5 * FRAC_PI_2));
    let shift = DVec3::new(3.0, -1.0, 2.0);
    let both = [soup.clone(), at(&soup, |p| turn * p + shift)];
    let middle = moved("morph", &both, &[("path", &[1.0])]);
    // The mean goes straight, and everything turns by half the angle about it.
    let mean: DVec3 = soup.points.iter().map(|&p| DVec3::from(p)).sum::<DVec3>() / soup.points.len() as f64;
    let centre = mean.midpoint(turn * mean + shift);
    for (&p, &q) in soup.points.iter().zip(&middle) {
        assert!((centre + half * (DVec3::from(p) - mean)).distance(q.into()) < 1e-12, "{p:?} {q:?}");
    }
    let straight = moved("morph", &both, &[]);
    assert!(straight.iter().zip(&middle).any(|(p, q)| DVec3::from(*p).distance(DVec3::from(*q)) > 0.1));
}

#[test]
fn morphs_take_any_precision_and_refuse_other_faces() {
    let soup = cap(6, 2, 0.2, 1.0);
    let single: Vec<[f32; 3]> = soup.points.iter().map(|p| p.map(|x| x as f32)).collect();
    let faces = Faces::polygons(&soup.offsets, &soup.corners).unwrap();
    let narrow = MeshView::new(Positions::from(single.as_slice()), faces, &Job::default()).unwrap();
    let morph = |a, b| run_on_views(&[a, b], &[1.0]);
    let Output::Mesh(made, _) = &morph(narrow, soup.view())[0] else { panic!() };
    assert_eq!(points(made), soup.points);
    let Output::Mesh(made, _) = &morph(soup.view(), narrow)[0] else { panic!() };
    assert_eq!(points(made), single.iter().map(|p| p.map(f64::from)).collect::<Vec<_>>());
    // As many faces and corners, but elsewhere.
    for (a, b) in [(sheet(3, 2), sheet(2, 3)), (soup.clone(), soup.turned()), (soup.clone(), cap(7, 2, 0.2, 1.0))] {
        let refused = run_on("morph", &[a, b], &[]);
        assert!(matches!(refused, Err(Error::InputUnfit { input: 1, .. })), "{refused:?}");
    }
}

fn run_on_views(views: &[MeshView<'_>], values: &[f64]) -> Vec<Output> {
    let inputs: Vec<_> = views.iter().map(|&view| Input::Mesh(view)).collect();
    gusset::filters::Filter::find("morph").unwrap().run(&inputs, values, &Job::default()).unwrap()
}

/// The surface of a cube from -1 to 1, with `n` x `n` squares on each side. Sides share no vertices.
fn cube(n: u32) -> Soup {
    let side = at(&sheet(n, n), |p| 2.0 * p / f64::from(n) - DVec3::new(1.0, 1.0, 0.0));
    let sides = (0..3).flat_map(|axis| [-1.0, 1.0].map(|height| (axis, height)));
    let placed = sides.map(|(axis, height)| {
        at(&side, |p| {
            let mut point = DVec3::ZERO;
            (point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3]) = (height, p.x, p.y);
            point
        })
    });
    placed.reduce(|all, side| all.and(&side)).unwrap()
}

#[test]
fn lattices_carry_affine_maps_inside_and_nothing_outside() {
    let mut soup = pieces(100)[0].clone();
    soup.points.push([1.5, 0.0, 0.0]);
    let map = |p: DVec3| DVec3::new(1.2 * p.x + 0.3 * p.y - 0.1, 0.8 * p.y - 0.2 * p.z, p.z + 0.4 * p.x + 0.5);
    // With three squares a side the lattice has inner grid points, on which no vertex lies.
    for n in [1, 2, 3, 5] {
        let rest = cube(n);
        let soups = [soup.clone(), rest.clone(), at(&rest, map)];
        let all = moved("lattice", &soups, &[]);
        let half = moved("lattice", &soups, &[("strength", &[0.5])]);
        for ((&p, q), h) in soup.points.iter().zip(&all).zip(half) {
            let p = DVec3::from(p);
            let expected = if p.abs().max_element() <= 1.0 { map(p) } else { p };
            assert!(expected.distance((*q).into()) < 1e-12, "{n}: {p} {q:?}");
            assert!(p.midpoint(expected).distance(h.into()) < 1e-12, "{n}: {p} {h:?}");
        }
    }
}

#[test]
fn one_moved_control_point_acts_by_its_bernstein_polynomial() {
    let soup = pieces(100)[0].clone();
    let step = DVec3::new(0.3, -0.5, 0.7);
    // Along each axis: a corner, or the middle of three.
    for (n, moved_point) in [(1, DVec3::ONE), (2, DVec3::new(0.0, -1.0, 1.0)), (2, DVec3::new(0.0, 0.0, 1.0))] {
        let rest = cube(n);
        let changed = at(&rest, |p| if p == moved_point { p + step } else { p });
        for (&p, q) in soup.points.iter().zip(moved("lattice", &[soup.clone(), rest, changed], &[])) {
            let p = DVec3::from(p);
            let weight = |axis: usize| {
                let t = 0.5 * (p[axis] + 1.0);
                match (n, moved_point[axis]) {
                    (1, _) => t,
                    (_, 0.0) => 2.0 * t * (1.0 - t),
                    (_, side) => {
                        if side > 0.0 {
                            t * t
                        } else {
                            (1.0 - t) * (1.0 - t)
                        }
                    }
                }
            };
            // The centre of the cube has no vertex: its offset is the mean of those between opposite
            // neighbours, of which only the middle of a side moves.
            let t = 0.5 * (p + 1.0);
            let bump: f64 = (0..3).map(|axis| 2.0 * t[axis] * (1.0 - t[axis])).product();
            let of_centre = if moved_point.length_squared() == 1.0 { bump / 6.0 } else { 0.0 };
            let expected = p + ((0..3).map(weight).product::<f64>() + of_centre) * step;
            assert!(expected.distance(q.into()) < 1e-12, "{moved_point}: {p} {q:?}");
        }
    }
}

#[test]
fn what_is_no_lattice_is_refused() {
    let soup = pieces(100)[0].clone();
    let unfit = |rest: Soup, changed: Soup| match run_on("lattice", &[soup.clone(), rest, changed], &[]) {
        Err(Error::InputUnfit { input, why }) => (input, why),
        other => panic!("{other:?}"),
    };
    let (rest, flat) = (box_around(1.0), sheet(3, 3));
    assert_eq!(unfit(rest.clone(), cube(1)).0, 2);
    assert!(unfit(flat.clone(), flat).1.contains("extent"));
    let askew = at(&rest, |p| if p == DVec3::ONE { DVec3::new(0.7, 1.0, 1.0) } else { p });
    assert!(unfit(askew.clone(), askew).1.contains("uniform grid"));
    let mut one_corner_less = rest.part(|face| !face.contains(&7));
    one_corner_less.points.retain(|p| *p != [1.0; 3]);
    assert!(unfit(one_corner_less.clone(), one_corner_less).1.contains("corners"));
    assert!(unfit(cube(40), cube(40)).1.contains("at most 32"));
}
