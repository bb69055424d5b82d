//! Normals: analytic shapes, brute force over polygons, rims, holes, scales, bits.

use crate::common::Silent;
use crate::space::{Gapped, Random, is_present, sheet, sphere, torus};
use glam::DVec3;
use gusset::mesh::Scalar;
use gusset::net::normals::{normals, normals_into};
use gusset::net::topology::{ContractedLinks, ReducedCell, SeamRun};
use gusset::net::*;
use gusset::{Error, Job};

fn degrees(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b)).to_degrees()
}

fn compute(net: &Net<'_>) -> (Coordinates<'static>, u64) {
    normals(net, &Job::default()).unwrap()
}

#[test]
fn on_spheres_and_tori_they_point_outwards_seams_and_poles_included() {
    for (scalar, tolerance) in [(Scalar::F32, 1e-4), (Scalar::F64, 2e-6)] {
        let net = sphere(33, 65, scalar);
        let (found, without) = compute(&net);
        assert_eq!(without, 0);
        let net_torus = torus(65, 129, scalar);
        let (torus_found, _) = compute(&net_torus);
        for i in 0..33 {
            for j in 0..65 {
                assert!(degrees(found.get(i, j), net.get(i, j)) < tolerance, "{scalar:?} {i} {j}");
                assert!((found.get(i, j).length() - 1.0).abs() < 1e-6);
            }
        }
        for i in 0..65 {
            for j in 0..129 {
                let p = net_torus.get(i, j);
                let centre = 3.0 * DVec3::new(p.x, p.y, 0.0).normalize();
                assert!(degrees(torus_found.get(i, j), p - centre) < 2.0 * tolerance, "{scalar:?} {i} {j}");
            }
        }
    }
}

/// Corner by corner over the polygons that are left of the cells, for each class; and unit vectors
/// in the end.
fn by_force(net: &Net<'_>) -> Vec<DVec3> {
    let (shape, classes) = (net.shape(), NodeClasses::new(net.topology()).unwrap());
    let mut sums = vec![(DVec3::ZERO, 0.0); shape.node_count()];
    for i in 0..shape.rows() - 1 {
        for j in 0..shape.columns() - 1 {
            if !is_present(net, i, j) {
                continue;
            }
            if let Some(polygon) = ReducedCell::new(classes.representatives_of_corners(i, j)).polygon() {
                let point = |k: usize| {
                    let (i, j) = shape.row_and_column(polygon[k % polygon.len()]);
                    net.get(i, j)
                };
                let n = polygon.len();
                for k in 0..n {
                    let corner = (point(k + 1) - point(k)).cross(point(k + n - 1) - point(k));
                    let (sum, size) = &mut sums[polygon[k] as usize];
                    (*sum, *size) = (*sum + corner, *size + corner.length());
                }
            }
        }
    }
    let sign = if net.topology().is_reversed() { -1.0 } else { 1.0 };
    let normal = |node| {
        let (sum, size) = sums[classes.representative(node) as usize];
        // A sum that cancels except for rounding lacks a direction.
        if sum.length() > 1e-14 * size { sign * sum.normalize() } else { DVec3::ZERO }
    };
    (0..shape.node_count() as u32).map(normal).collect()
}

fn agree(net: &Net<'_>) {
    let (expected, (found, without)) = (by_force(net), compute(net));
    let shape = net.shape();
    for (node, expected) in expected.iter().enumerate() {
        let (i, j) = shape.row_and_column(node as u32);
        let (a, b) = (found.get(i, j), *expected);
        assert!(a.distance(b) < 1e-6, "node ({i}, {j}) of {shape:?}: {a} instead of {b}");
    }
    assert_eq!(without, expected.iter().filter(|&&n| n == DVec3::ZERO).count() as u64);
}

/// A rough surface with the given gluing, its glued nodes in one place.
fn rough(topology: Topology, scalar: Scalar, random: &mut Random) -> Net<'static> {
    let mut net = Net::from_fn(topology, scalar, |i, j| DVec3::new(j as f64, i as f64, 0.0) + random.vector()).unwrap();
    gusset::net::field::snap_glued_nodes(&mut net).unwrap();
    net
}

#[test]
fn they_are_the_sums_over_the_polygons_whatever_is_glued() {
    let mut random = Random(3);
    for (rows, columns) in [(2, 2), (2, 7), (7, 2), (3, 3), (5, 6), (12, 23)] {
        let shape = Shape::new(rows, columns).unwrap();
        for bits in 0..64u32 {
            let on = |k: u32| bits >> k & 1 == 1;
            let sides = Sides {
                rows_closed: on(0),
                columns_closed: on(1),
                pole_top: on(2),
                pole_bottom: on(3),
                pole_left: on(4),
                pole_right: on(5),
            };
            let topology = Topology::from_sides(shape, sides).with_reversed(bits % 3 == 0);
            agree(&rough(topology, Scalar::F64, &mut random));
        }
    }
    // Links and seams anywhere.
    let shape = Shape::new(11, 14).unwrap();
    let mut tried = 0;
    for round in 0..60 {
        let mut matrix = LinkMatrix::empty(shape).unwrap();
        for link in 0..2 * 11 * 14 {
            matrix.set_contracted(link, shape.joins_neighbours(link) && random.next() > 0.6);
        }
        let seam = Seam { a: SeamRun::along_column(0, 0, 1), b: SeamRun::along_column(10, 13, -1), count: 11 };
        let seams = if round % 2 == 0 { vec![seam] } else { vec![] };
        if let Ok(topology) = Topology::new(shape, ContractedLinks::Matrix(matrix), &seams) {
            agree(&rough(topology, Scalar::F64, &mut random));
            tried += 1;
        }
    }
    assert!(tried > 20);
}

#[test]
fn missing_nodes_and_hidden_bridges_leave_the_rest() {
    let mut random = Random(4);
    for _ in 0..30 {
        let mut net =
            rough(Topology::from_sides(Shape::new(20, 31).unwrap(), Sides::TWO_POLES), Scalar::F64, &mut random);
        for _ in 0..12 {
            let (i, j) = ((10.0 + 10.0 * random.next()) as usize, (15.0 + 15.0 * random.next()) as usize);
            net.coordinates_mut().set(i.min(19), j.min(30), DVec3::new(0.0, f64::NAN, 1.0));
        }
        for (direction, at) in [(Direction::Right, 9), (Direction::Down, 4), (Direction::Right, 30)] {
            let count = if direction == Direction::Right { 20 } else { 31 };
            net.bridges_mut().push(Bridge::new(direction, at, count, BridgeKind::Ribbon, BridgeMode::Hide));
        }
        agree(&net);
    }
    // A hole in a plane: the nodes beside it keep the plane's normal, and the missing node has no
    // normal.
    let mut net = sheet(9, 9, Scalar::F32);
    net.coordinates_mut().set(4, 4, DVec3::NAN);
    let (found, without) = compute(&net);
    assert_eq!(without, 1);
    for (i, j) in (0..9).flat_map(|i| (0..9).map(move |j| (i, j))) {
        assert_eq!(found.get(i, j), if (i, j) == (4, 4) { DVec3::ZERO } else { DVec3::Z });
    }
}

#[test]
fn tiny_and_huge_nets_have_normals_too() {
    for (scalar, scales) in
        [(Scalar::F32, vec![1e-18, 1e-12, 1e12, 1e18]), (Scalar::F64, vec![1e-140, 1e-80, 1e80, 1e140])]
    {
        for scale in scales {
            let unit = sphere(17, 33, Scalar::F64);
            let net = Net::from_fn(unit.topology().clone(), scalar, |i, j| scale * unit.get(i, j)).unwrap();
            let (found, without) = compute(&net);
            assert_eq!(without, 0, "{scalar:?} {scale}");
            for (i, j) in (0..17).flat_map(|i| (0..33).map(move |j| (i, j))) {
                assert!(degrees(found.get(i, j), unit.get(i, j)) < 1e-4, "{scalar:?} {scale} {i} {j}");
            }
        }
    }
}

#[test]
fn the_same_on_all_threads_and_in_memory_with_gaps() {
    let net = torus(203, 117, Scalar::F64);
    let one = normals(&net, &Job::new(1, &Silent)).unwrap().0;
    for threads in [2, 7] {
        let many = normals(&net, &Job::new(threads, &Silent)).unwrap().0;
        assert!((0..203).all(|i| (0..117).all(|j| one.get(i, j) == many.get(i, j))));
    }
    let mut gapped = Gapped::from_net(&net, 3);
    let mut out = Gapped::from_net(&net, 2);
    let (from, to) = (gapped.net(net.topology().clone()), out.net(net.topology().clone()));
    let mut to = to;
    assert_eq!(normals_into(&from, to.coordinates_mut(), &Job::default()), Ok(0));
    assert!((0..203).all(|i| (0..117).all(|j| one.get(i, j) == to.get(i, j))));
    drop(to);
    assert!(out.gaps_are_whole());
    let mut other = Coordinates::zeroed(net.shape(), Scalar::F32).unwrap();
    assert_eq!(normals_into(&net, &mut other, &Job::default()), Err(Error::MixedScalars));
    let mut small = Coordinates::zeroed(Shape::new(2, 2).unwrap(), Scalar::F64).unwrap();
    assert!(matches!(normals_into(&net, &mut small, &Job::default()), Err(Error::ArrayTooShort { .. })));
}

#[test]
fn a_missing_node_has_no_normal_in_the_narrowest_nets() {
    for (rows, columns) in [(5, 2), (5, 3), (5, 4), (2, 5), (3, 5), (3, 3), (2, 2), (4, 4)] {
        for (row, column) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
            for scalar in [Scalar::F32, Scalar::F64] {
                let mut net = sheet(rows, columns, scalar);
                net.coordinates_mut().set(row, column, DVec3::NAN);
                let (found, without) = compute(&net);
                assert_eq!(found.get(row, column), DVec3::ZERO, "({row}, {column}) of {rows} x {columns}");
                let zeros = (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j)));
                assert_eq!(without, zeros.filter(|&(i, j)| found.get(i, j) == DVec3::ZERO).count() as u64);
            }
        }
    }
}
