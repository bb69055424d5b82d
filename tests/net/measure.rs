//! Areas, volumes, moments, boxes, planarity: exact on cubes, second order on smooth shapes,
//! without missing nodes.

use crate::common::Silent;
use crate::space::{Random, sheet, sphere, torus};
use glam::{DMat3, DVec3};
use gusset::mesh::Scalar;
use gusset::net::field::{DeformationStep, deform};
use gusset::net::measure::{measure, moments, planarity};
use gusset::net::transform::{Affine, Axis, RotationSense, transform};
use gusset::net::*;
use gusset::{Error, Job};
use std::f64::consts::PI;

/// The box from the origin to `size`, as a tube of 4 n columns with a pole in the middle of its
/// floor and its roof.
fn cube(n: usize, size: DVec3, scalar: Scalar) -> Net<'static> {
    let (rows, columns) = (n + 3, 4 * n + 1);
    let topology = Topology::from_sides(Shape::new(rows, columns).unwrap(), Sides::TWO_POLES);
    Net::from_fn(topology, scalar, |i, j| {
        let k = j % (4 * n);
        let t = (k % n) as f64 / n as f64;
        let (x, y) = match k / n {
            0 => (t, 0.0),
            1 => (1.0, t),
            2 => (1.0 - t, 1.0),
            _ => (0.0, 1.0 - t),
        };
        match i {
            0 => DVec3::new(0.5, 0.5, 0.0) * size,
            i if i + 1 == rows => DVec3::new(0.5, 0.5, 1.0) * size,
            i => DVec3::new(x, y, (i - 1) as f64 / n as f64) * size,
        }
    })
    .unwrap()
}

#[test]
fn cubes_are_exact() {
    for n in [1, 2, 4, 8, 16] {
        for scalar in [Scalar::F32, Scalar::F64] {
            let net = cube(n, DVec3::splat(n as f64), scalar);
            let side = n as f64;
            let found = measure(&net, &Job::default()).unwrap();
            assert_eq!((found.area, found.volume), (6.0 * side * side, side.powi(3)), "{n} {scalar:?}");
            assert_eq!((found.area_vector, found.low, found.high), (DVec3::ZERO, DVec3::ZERO, DVec3::splat(side)));
        }
    }
}

#[test]
fn spheres_and_tori_converge_with_the_square_of_the_size_of_their_cells() {
    let error = |net: Net<'_>, area: f64, volume: f64| {
        let found = measure(&net, &Job::default()).unwrap();
        assert!(found.area_vector.length() < 1e-12);
        [found.area / area - 1.0, found.volume / volume - 1.0].map(f64::abs)
    };
    for (coarse, fine) in [
        (
            error(sphere(33, 65, Scalar::F64), 4.0 * PI, 4.0 / 3.0 * PI),
            error(sphere(65, 129, Scalar::F64), 4.0 * PI, 4.0 / 3.0 * PI),
        ),
        (
            error(torus(33, 65, Scalar::F64), 12.0 * PI * PI, 6.0 * PI * PI),
            error(torus(65, 129, Scalar::F64), 12.0 * PI * PI, 6.0 * PI * PI),
        ),
    ] {
        for k in 0..2 {
            assert!(coarse[k] < 0.01 && (coarse[k] / fine[k] - 4.0).abs() < 0.1, "{} {}", coarse[k], fine[k]);
        }
    }
}

#[test]
fn crooked_cells_have_the_volume_of_their_bilinear_patches() {
    // A box with a roof that is one crooked cell: below it lies the mean of the corners' heights.
    let mut net = cube(1, DVec3::ONE, Scalar::F64);
    // Without the pole: the roof's four triangles become flat ones at the first corner.
    let heights = [1.0, 1.7, 0.9, 1.4];
    for j in 0..5 {
        let p = net.get(2, j);
        net.coordinates_mut().set(2, j, p.with_z(heights[j % 4]));
    }
    let mut roof = sheet(2, 2, Scalar::F64);
    for ((i, j), k) in [(0, 0), (0, 1), (1, 1), (1, 0)].into_iter().zip(0..) {
        let p = roof.get(i, j);
        roof.coordinates_mut().set(i, j, p.with_z(heights[k]));
    }
    // The volume of the cone to the first node, by integration over the unit square: n = (-z_x,
    // -z_y, 1).
    let n = 400u32;
    let (a, b, c, d) = (heights[0], heights[1], heights[2], heights[3]);
    let mut cone = 0.0;
    for k in 0..n * n {
        let (u, v) = ((f64::from(k % n) + 0.5) / f64::from(n), (f64::from(k / n) + 0.5) / f64::from(n));
        let z = a * (1.0 - u) * (1.0 - v) + b * u * (1.0 - v) + c * u * v + d * (1.0 - u) * v;
        let (zu, zv) = ((b - a) * (1.0 - v) + (c - d) * v, (d - a) * (1.0 - u) + (c - b) * u);
        cone += (-zu * u - zv * v + (z - a)) / 3.0 / f64::from(n * n);
    }
    let found = measure(&roof, &Job::default()).unwrap();
    assert!((found.volume - cone).abs() < 1e-6, "{} {cone}", found.volume);
    assert!((moments(&roof, &Job::default()).unwrap().volume - cone).abs() < 1e-6);
}

#[test]
fn moments_of_a_box_are_those_of_mechanics() {
    let mut random = Random(6);
    for _ in 0..20 {
        let size = DVec3::new(1.5, 2.0, 1.0) + random.vector().abs();
        let mut net = cube(3, size, Scalar::F64);
        let axis = random.vector();
        let turn = Affine::rotation(axis, 1.0, DVec3::ZERO, RotationSense::RightHanded).unwrap();
        let shift = Affine::translation(100.0 * random.vector()).unwrap();
        let place = turn.then(&shift).unwrap();
        transform(&mut net, &place, &Job::default()).unwrap();
        let found = moments(&net, &Job::default()).unwrap();
        let volume = size.element_product();
        let sq = size * size;
        let diagonal = volume / 12.0 * DVec3::new(sq.y + sq.z, sq.z + sq.x, sq.x + sq.y);
        let r: DMat3 = DMat3::from_cols_array_2d(&turn.rows().map(|[a, b, c, _]| [a, b, c])).transpose();
        let expected = r * DMat3::from_diagonal(diagonal) * r.transpose();
        assert!((found.volume - volume).abs() < 1e-11 * volume);
        assert!(found.centroid.distance(place.apply(size / 2.0)) < 1e-11);
        assert!(
            (found.inertia - expected).abs().to_cols_array().iter().all(|&e| e < 1e-10),
            "{} {expected}",
            found.inertia
        );
    }
    // A reversed net encloses the same body.
    let mut net = cube(3, DVec3::ONE, Scalar::F64);
    transform(&mut net, &Affine::scaling(-1.0).unwrap(), &Job::default()).unwrap();
    let found = moments(&net, &Job::default()).unwrap();
    assert!((found.volume - 1.0).abs() < 1e-14 && (found.inertia.x_axis.x - 1.0 / 6.0).abs() < 1e-14);
    assert!((measure(&net, &Job::default()).unwrap().volume - 1.0).abs() < 1e-15);
}

#[test]
fn distant_bodies_keep_their_volume() {
    let near = sphere(33, 65, Scalar::F64);
    let far = Net::from_fn(near.topology().clone(), Scalar::F64, |i, j| near.get(i, j) + DVec3::splat(1e6)).unwrap();
    let [a, b] = [near, far].map(|net| measure(&net, &Job::default()).unwrap().volume);
    assert!((a - b).abs() < 1e-9, "{a} {b}");
}

#[test]
fn what_is_missing_or_hidden_is_not_measured() {
    let mut net = sheet(70, 131, Scalar::F32);
    net.coordinates_mut().set(30, 40, DVec3::new(40.0, f64::NAN, 0.0));
    net.coordinates_mut().set(0, 0, DVec3::new(0.0, 0.0, f64::INFINITY));
    net.coordinates_mut().set(69, 130, DVec3::NAN);
    let cells = 69.0 * 130.0;
    let found = measure(&net, &Job::default()).unwrap();
    assert_eq!((found.area, found.area_vector, found.volume), (cells - 6.0, (cells - 6.0) * DVec3::Z, 0.0));
    assert_eq!((found.low, found.high), (DVec3::ZERO, DVec3::new(130.0, 69.0, 0.0)));
    for (direction, at) in [(Direction::Right, 9), (Direction::Right, 100), (Direction::Down, 4)] {
        let count = if direction == Direction::Right { 70 } else { 131 };
        net.bridges_mut().push(Bridge::new(direction, at, count, BridgeKind::Ribbon, BridgeMode::Hide));
    }
    assert_eq!(measure(&net, &Job::default()).unwrap().area, cells - 6.0 - 2.0 * 69.0 - 130.0 + 2.0);
    let plane = planarity(&net, 0.0, &Job::default()).unwrap();
    assert_eq!(plane.cells.iter().filter(|off| !off.is_nan()).count() as f64, cells - 6.0 - 2.0 * 69.0 - 130.0 + 2.0);
    assert_eq!((plane.worst.unwrap().0, plane.mean, plane.above), (0.0, 0.0, 0));
    // Nothing at all.
    let nothing = Net::from_fn(net.topology().clone(), Scalar::F64, |_, _| DVec3::NAN).unwrap();
    let found = measure(&nothing, &Job::default()).unwrap();
    assert!(found.area == 0.0 && found.volume == 0.0 && found.low.x > found.high.x);
    assert_eq!(planarity(&nothing, 0.0, &Job::default()).unwrap().worst, None);
}

#[test]
fn the_same_on_all_threads() {
    let net = torus(301, 517, Scalar::F32);
    let one = measure(&net, &Job::new(1, &Silent)).unwrap();
    for threads in [2, 5] {
        assert_eq!(measure(&net, &Job::new(threads, &Silent)).unwrap(), one);
    }
}

#[test]
fn planarity_is_the_distance_of_the_corners_from_their_plane() {
    let mut net = sheet(2, 3, Scalar::F64);
    // Corners at heights 0, h, 0, h: h / 2 from the plane between them.
    net.coordinates_mut().set(0, 1, DVec3::new(1.0, 0.0, 0.2));
    net.coordinates_mut().set(1, 0, DVec3::new(0.0, 1.0, 0.2));
    net.coordinates_mut().set(0, 2, DVec3::new(2.0, 0.0, 0.4));
    net.coordinates_mut().set(1, 2, DVec3::new(2.0, 1.0, 0.2));
    let found = planarity(&net, 0.01, &Job::default()).unwrap();
    assert!((found.cells[0] - 0.1 / 2f64.sqrt()).abs() < 1e-15 && found.cells[1] < 1e-15);
    assert_eq!((found.worst.unwrap().1, found.above), (0, 1));
    assert!((found.mean - found.cells[0] / 2.0).abs() < 1e-15);
    // Spheres by latitude and longitude have plane cells; twisted ones have not.
    let mut ball = sphere(17, 33, Scalar::F64);
    assert!(planarity(&ball, 1e-12, &Job::default()).unwrap().above == 0);
    deform(
        &mut ball,
        &[DeformationStep { field: &field::twist(Axis::Z, 1.0, 0.0).unwrap(), strength: 1.0 }],
        &Job::default(),
    )
    .unwrap();
    assert!(planarity(&ball, 1e-3, &Job::default()).unwrap().above > 200);
    assert!(matches!(planarity(&ball, -1.0, &Job::default()), Err(Error::OptionOutOfRange { .. })));
}
