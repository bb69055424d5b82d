//! Sheets that roll up: lengths at every strength against their own formulas, and closing at 1.

use crate::space::sheet;
use glam::DVec3;
use gusset::Job;
use gusset::mesh::Scalar;
use gusset::net::analyse::{analyse_field, jacobian_by_central_differences};
use gusset::net::complex::Complex;
use gusset::net::field::{self, DeformationStep, Field, deform};
use gusset::net::transform::{Affine, Axis};
use gusset::net::{Net, Sides, Topology, detect_gluing};
use std::f64::consts::{PI, TAU};

const STRENGTHS: [f64; 9] = [-0.3, 1e-9, 0.1, 0.3, 0.5, 0.6, 0.83, 1.0, 1.2];

/// A sheet whose columns run from `low` to `high` in x, and rows in y.
fn fitted(rows: usize, columns: usize, low: [f64; 2], high: [f64; 2]) -> Net<'static> {
    let mut net = sheet(rows, columns, Scalar::F64);
    let step = [(high[0] - low[0]) / (columns - 1) as f64, (high[1] - low[1]) / (rows - 1) as f64];
    let fit = Affine::new([[step[0], 0.0, 0.0, low[0]], [0.0, step[1], 0.0, low[1]], [0.0, 0.0, 1.0, 0.0]]).unwrap();
    deform(&mut net, &[DeformationStep { field: &fit, strength: 1.0 }], &Job::default()).unwrap();
    net
}

fn rolled(net: &Net<'_>, field: &dyn Field, strength: f64) -> Net<'static> {
    let mut moved = net.copied().unwrap();
    deform(&mut moved, &[DeformationStep { field, strength }], &Job::default()).unwrap();
    moved
}

/// The chord of an arc of a length and a curvature.
fn chord(length: f64, curvature: f64) -> f64 {
    if curvature == 0.0 { length } else { (2.0 / curvature * (curvature * length / 2.0).sin()).abs() }
}

/// Asserts the lengths of all links, along rows and along columns, of a net at a strength.
fn check_links(net: &Net<'_>, what: &str, row: impl Fn(usize) -> f64, column: impl Fn(usize) -> f64) {
    let (rows, columns) = (net.shape().rows(), net.shape().columns());
    for i in 0..rows {
        for j in 0..columns {
            if j + 1 < columns {
                let (found, expected) = (net.get(i, j).distance(net.get(i, j + 1)), row(i));
                assert!((found - expected).abs() < 1e-12, "{what}: row {i}: {found}, not {expected}");
            }
            if i + 1 < rows {
                let (found, expected) = (net.get(i, j).distance(net.get(i + 1, j)), column(i));
                assert!((found - expected).abs() < 1e-12, "{what}: column at {i}: {found}, not {expected}");
            }
        }
    }
}

/// The integral of a function over [0, to], by Simpson's rule.
fn integral(to: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (n, h) = (2000, to / 2000.0);
    let weight = |k: usize| if k == 0 || k == n { 1.0 } else { 2.0 + 2.0 * (k % 2) as f64 };
    (0..=n).map(|k| weight(k) * f(k as f64 * h)).sum::<f64>() * h / 3.0
}

#[test]
fn a_sphere_closes_at_1_and_keeps_the_lengths_of_its_roll_before() {
    let (rows, columns, radius) = (33, 65, 1.5);
    let net = fitted(rows, columns, [0.0, -radius * PI / 2.0], [radius * TAU, radius * PI / 2.0]);
    let (du, dv) = (TAU * radius / 64.0, PI * radius / 32.0);
    let wrap = field::sphere_wrap(Axis::Z, radius).unwrap();
    for t in STRENGTHS {
        let moved = rolled(&net, &wrap, t);
        let (s, q) = ((2.0 * t).min(1.0), (2.0 * t - 1.0).max(0.0));
        // The meridian's distance from the axis of the tube, by integrating its slope.
        let inwards = |i: usize| {
            let v = (i as f64 - 16.0) * dv;
            integral(v, |v| (q * v / radius).sin())
        };
        let across = |i: usize| chord(du, s / radius) * if q > 0.0 { 1.0 - inwards(i) / radius } else { 1.0 };
        check_links(&moved, &format!("sphere at {t}"), |i| across(i).abs(), |_| chord(dv, q / radius));
    }
    // At one half: a tube of the meridian's length; all links keep their lengths within 1 %.
    let tube = rolled(&net, &wrap, 0.5);
    let ratios =
        analyse_field(&net, &[DeformationStep { field: &wrap, strength: 0.5 }], 1e-9, &Job::default()).unwrap().links;
    let within = |link: usize| {
        link % 2 == 1 && link / 2 < (rows - 1) * columns || link.is_multiple_of(2) && link / 2 % columns + 1 < columns
    };
    let worst = (0..ratios.len()).filter(|&l| within(l)).map(|l| (ratios[l] - 1.0).abs()).fold(0.0, f64::max);
    assert!(worst < 0.01 && worst > 1e-4, "{worst}");
    let size = TAU * radius;
    assert!((0..rows).all(|i| tube.get(i, 0).distance(tube.get(i, columns - 1)) < 4.0 * f64::EPSILON * size));
    // At 1: a sphere, its last column on its first, its first and last row a point each.
    let mut ball = rolled(&net, &wrap, 1.0);
    let closed = |a: DVec3, b: DVec3| a.distance(b) <= 4.0 * f64::EPSILON * size;
    for i in 0..rows {
        assert!(closed(ball.get(i, 0), ball.get(i, columns - 1)), "row {i}");
        for j in 0..columns {
            let (longitude, latitude) = (j as f64 * TAU / 64.0, (i as f64 - 16.0) * PI / 32.0);
            let (x, y) = (latitude.cos() * longitude.cos(), latitude.cos() * longitude.sin());
            assert!(closed(ball.get(i, j), radius * DVec3::new(x, y, latitude.sin())));
            assert!(i != 0 && i + 1 != rows || closed(ball.get(i, 0), ball.get(i, j)));
        }
    }
    let sphere = detect_gluing(ball.coordinates(), 4.0 * f64::EPSILON * size, &Job::default()).unwrap();
    assert_eq!(sphere.sides(), Some(Sides::TWO_POLES));
    ball.set_topology(sphere);
    field::snap_glued_nodes(&mut ball).unwrap();
    assert_eq!(Complex::from_net(&ball, &Job::default()).unwrap().euler_characteristic(), 2);
    // Before 1 it is open at the poles, and before one half along a meridian.
    let barrel = detect_gluing(rolled(&net, &wrap, 0.9).coordinates(), 1e-9, &Job::default()).unwrap();
    assert_eq!(barrel.sides(), Some(Sides::TUBE));
    let open = detect_gluing(rolled(&net, &wrap, 0.4).coordinates(), 1e-9, &Job::default()).unwrap();
    assert_eq!(open.sides(), Some(Sides::SHEET));
}

#[test]
fn cylinders_and_cones_keep_their_lengths_as_they_roll() {
    // A cylinder about y: z is the arc, x the height. The sheet is turned there.
    let net = fitted(9, 33, [-1.0, 0.0], [TAU * 0.7 - 1.0, 2.0]);
    let (du, dv) = (TAU * 0.7 / 32.0, 0.25);
    let stand = Affine::new([[0.0, 0.0, 1.0, 0.0], [0.0, 1.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0]]).unwrap();
    let upright = rolled(&net, &stand, 1.0);
    let (cylinder, angle) = (field::cylinder_wrap(Axis::Y, 0.7).unwrap(), 0.3);
    let cone = field::cone_wrap(Axis::Y, 0.7, angle).unwrap();
    for t in STRENGTHS {
        let what = format!("at {t}");
        check_links(&rolled(&upright, &cylinder, t), &what, |_| chord(du, t / 0.7), |_| dv);
        // Chords of parallels are in proportion to their distances from the axis.
        let ratio = |i: usize| 1.0 - t / 0.7 * i as f64 * dv * (t * angle).sin();
        check_links(&rolled(&upright, &cone, t), &what, |i| ratio(i).abs() * chord(du, t / 0.7), |_| dv);
    }
    // The whole cone: on its surface, its apex a point, its sides together.
    let (radius, height) = (3.0, 4.0f64);
    let net = fitted(11, 25, [0.0, 0.0], [TAU * radius, 5.0]);
    let lie = Affine::new([[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 1.0, 0.0, 0.0]]).unwrap();
    let cone = field::cone_wrap(Axis::Z, radius, (radius / 5.0).asin()).unwrap();
    let made = rolled(&rolled(&net, &lie, 1.0), &cone, 1.0);
    for i in 0..11 {
        for j in 0..25 {
            let (p, w) = (made.get(i, j), 0.5 * i as f64);
            assert!((p.z - height * w / 5.0).abs() < 1e-14);
            assert!((p.truncate().length() - radius * (1.0 - w / 5.0)).abs() < 1e-14);
        }
    }
    assert!((0..25).all(|j| made.get(10, j).distance(DVec3::new(0.0, 0.0, height)) < 4.0 * f64::EPSILON * 5.0));
    assert!((0..11).all(|i| made.get(i, 0).distance(made.get(i, 24)) < 4.0 * f64::EPSILON * TAU * radius));
    // A cone that does not lean is a cylinder, in part too.
    let upright_cone = field::cone_wrap(Axis::Y, 0.7, 0.0).unwrap();
    for t in STRENGTHS {
        let (a, b) = (rolled(&upright, &cylinder, t), rolled(&upright, &upright_cone, t));
        assert_eq!(crate::space::bits(&a), crate::space::bits(&b));
    }
}

#[test]
fn a_torus_rolls_to_a_tube_and_the_tube_to_a_ring() {
    let (major, minor) = (3.0, 1.0);
    let net = fitted(17, 33, [0.0, 0.0], [TAU * major, TAU * minor]);
    let (du, dv) = (TAU * major / 32.0, TAU * minor / 16.0);
    let wrap = field::torus_wrap(Axis::Z, major, minor).unwrap();
    for t in STRENGTHS {
        let (s, k) = ((2.0 * t).min(1.0), (2.0 * t - 1.0).max(0.0) / major);
        let out = |i: usize| minor * (i as f64 * TAU / 16.0).cos();
        let along = |i: usize| (1.0 + k * out(i)) * chord(du, k);
        check_links(&rolled(&net, &wrap, t), &format!("at {t}"), along, |_| chord(dv, s / minor));
    }
    assert_eq!(
        detect_gluing(rolled(&net, &wrap, 1.0).coordinates(), 1e-14, &Job::default()).unwrap().sides(),
        Some(Sides::TORUS)
    );
    let tube = Sides { columns_closed: true, ..Sides::SHEET };
    assert_eq!(
        detect_gluing(rolled(&net, &wrap, 0.6).coordinates(), 1e-14, &Job::default()).unwrap().sides(),
        Some(tube)
    );
}

#[test]
fn rolls_stretch_space_as_their_curvature_says_and_have_no_jumps() {
    let wraps: [(&str, Box<dyn Field>); 4] = [
        ("cylinder", Box::new(field::cylinder_wrap(Axis::X, 2.0).unwrap())),
        ("cone", Box::new(field::cone_wrap(Axis::Y, 2.0, -0.4).unwrap())),
        ("torus", Box::new(field::torus_wrap(Axis::Z, 3.0, 1.0).unwrap())),
        ("sphere", Box::new(field::sphere_wrap(Axis::X, 1.2).unwrap())),
    ];
    let p = DVec3::new(0.3, 0.7, -0.4);
    let at = |field: &dyn Field, t: f64| rolled(&one(p), field, t).get(0, 0);
    for (name, wrap) in &wraps {
        for t in [0.0, 0.25, 0.5, 0.75, 1.0] {
            let jump =
                at(&**wrap, t).distance(at(&**wrap, t + 1e-9)).max(at(&**wrap, t).distance(at(&**wrap, t - 1e-9)));
            assert!(jump < 1e-7, "{name} at {t}: {jump}");
        }
        assert_eq!(at(&**wrap, 0.0), p);
    }
    // At the height h above a cylinder, lengths change by 1 + curvature h; a cylinder about x has z
    // there.
    let det = |field: &dyn Field, t: f64| {
        jacobian_by_central_differences(p, 0.1, &[DeformationStep { field, strength: t }]).0.determinant()
    };
    for t in [0.2, 0.5, 0.9] {
        assert!((det(&*wraps[0].1, t) - (1.0 + t / 2.0 * p.z)).abs() < 1e-8, "{t}");
        // The first stage of the torus equals the tube with height z.
        assert!((det(&*wraps[2].1, t / 2.0) - (1.0 + t * p.z)).abs() < 1e-8, "{t}");
        // The first stage of the sphere about x, height x.
        assert!((det(&*wraps[3].1, t / 2.0) - (1.0 + t / 1.2 * p.x)).abs() < 1e-8, "{t}");
    }
    assert!(field::sphere_wrap(Axis::Z, 0.0).is_err() && field::sphere_wrap(Axis::Z, f64::INFINITY).is_err());
    assert!(field::cone_wrap(Axis::Z, -1.0, 0.1).is_err() && field::cone_wrap(Axis::Z, f64::NAN, 0.1).is_err());
    assert!(field::cone_wrap(Axis::Z, 1.0, 1.6).is_err() && field::cone_wrap(Axis::Z, 1.0, f64::NAN).is_err());
}

/// A net whose nodes are all one point.
fn one(p: DVec3) -> Net<'static> {
    let topology = Topology::from_sides(sheet(2, 2, Scalar::F64).shape(), Sides::SHEET);
    Net::from_fn(topology, Scalar::F64, |_, _| p).unwrap()
}
