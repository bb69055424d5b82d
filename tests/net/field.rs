//! Fields of deformation: each against its own geometry, chains, strengths, gluing, errors.

use crate::common::Silent;
use crate::space::{Gapped, Random, bits, glued_bits_agree, sheet, sphere, torus};
use glam::DVec3;
use gusset::mesh::Scalar;
use gusset::net::analyse::jacobian_by_central_differences;
use gusset::net::field::{self, *};
use gusset::net::transform::{Affine, Axis, RotationSense};
use gusset::net::{Net, Sides, Topology};
use gusset::{Error, Job};
use std::f64::consts::{PI, TAU};

fn whole(field: &dyn Field) -> DeformationStep<'_> {
    DeformationStep { field, strength: 1.0 }
}

/// Where a field takes a point.
fn at(field: &dyn Field, strength: f64, p: DVec3) -> DVec3 {
    let [mut x, mut y, mut z] = p.to_array().map(|v| [v]);
    field.map_points(strength, [&mut x, &mut y, &mut z]);
    DVec3::new(x[0], y[0], z[0])
}

/// One of every kind.
fn all_fields() -> Vec<(&'static str, Box<dyn Field>)> {
    let mut random = Random(7);
    let offsets: Vec<DVec3> = (0..3 * 2 * 4).map(|_| 0.2 * random.vector()).collect();
    let lattice = Lattice::new(DVec3::splat(-5.0), DVec3::splat(5.0), [3, 2, 4], &offsets).unwrap();
    vec![
        ("affine", Box::new(Affine::rotation(DVec3::ONE, 0.7, DVec3::X, RotationSense::RightHanded).unwrap())),
        ("twist", Box::new(field::twist(Axis::Z, 0.8, 0.1).unwrap())),
        ("taper", Box::new(field::taper(Axis::X, 0.1, -0.3).unwrap())),
        ("bend", Box::new(field::bend(Axis::Y, 0.15, -1.0, 2.0).unwrap())),
        ("shear", Box::new(field::shear(Axis::X, Axis::Z, 0.3).unwrap())),
        ("spherify", Box::new(field::spherify(DVec3::new(0.1, 0.2, 0.3), 2.0).unwrap())),
        ("cylinder", Box::new(field::cylinder_wrap(Axis::Z, 2.0).unwrap())),
        ("torus", Box::new(field::torus_wrap(Axis::X, 9.0, 6.0).unwrap())),
        ("cone", Box::new(field::cone_wrap(Axis::Y, 2.0, 0.6).unwrap())),
        ("sphere", Box::new(field::sphere_wrap(Axis::Y, 3.0).unwrap())),
        ("lattice", Box::new(lattice)),
        (
            "perspective",
            Box::new(field::perspective_projection(DVec3::new(0.0, 0.0, 9.0), DVec3::ZERO, DVec3::Z).unwrap()),
        ),
    ]
}

#[test]
fn every_field_keeps_glued_nodes_equal_and_is_the_same_on_all_threads() {
    for (name, field) in all_fields() {
        for scalar in [Scalar::F32, Scalar::F64] {
            for net in [sphere(33, 65, scalar), torus(65, 129, scalar)] {
                for strength in [1.0, 0.37] {
                    let step = [DeformationStep { field: &*field, strength }];
                    let mut moved = net.copied().unwrap();
                    deform(&mut moved, &step, &Job::new(1, &Silent)).unwrap();
                    assert!(glued_bits_agree(&moved), "{name}");
                    assert_ne!(bits(&moved), bits(&net), "{name}");
                    let mut again = net.copied().unwrap();
                    deform(&mut again, &step, &Job::new(3, &Silent)).unwrap();
                    assert_eq!(bits(&again), bits(&moved), "{name}");
                    // One node at a time, without vectors.
                    for (i, j) in [(0, 0), (7, 3), (32, 64)] {
                        let expected = at(&*field, strength, net.get(i, j));
                        let expected = if scalar == Scalar::F32 { expected.as_vec3().as_dvec3() } else { expected };
                        assert_eq!(moved.get(i, j), expected, "{name}");
                    }
                }
            }
        }
    }
}

#[test]
fn strength_0_is_the_identity_to_the_bit_and_strength_1_the_whole() {
    for (name, field) in all_fields() {
        let before = torus(9, 13, Scalar::F32);
        let mut after = before.copied().unwrap();
        deform(&mut after, &[DeformationStep { field: &*field, strength: 0.0 }], &Job::default()).unwrap();
        assert_eq!(bits(&after), bits(&before), "{name}");
        // Small strengths move little, and continuously.
        let p = DVec3::new(1.1, -0.7, 0.9);
        assert!(at(&*field, 1e-9, p).distance(p) < 1e-7, "{name}");
        assert!(at(&*field, 1.0 - 1e-12, p).distance(at(&*field, 1.0, p)) < 1e-9, "{name}");
    }
}

#[test]
fn a_chain_is_its_fields_one_after_the_other() {
    let fields = all_fields();
    let steps: Vec<_> = fields.iter().map(|(_, field)| DeformationStep { field: &**field, strength: 0.5 }).collect();
    let before = torus(21, 33, Scalar::F64);
    let (mut at_once, mut in_turn) = (before.copied().unwrap(), before.copied().unwrap());
    deform(&mut at_once, &steps, &Job::default()).unwrap();
    for step in &steps {
        deform(&mut in_turn, &[*step], &Job::default()).unwrap();
    }
    assert_eq!(bits(&at_once), bits(&in_turn));
}

#[test]
fn twists_tapers_shears_and_wraps_have_the_volumes_that_their_formulas_say() {
    let mut random = Random(11);
    for _ in 0..200 {
        let p = 2.0 * random.vector();
        let det = |field: &dyn Field| jacobian_by_central_differences(p, 0.1, &[whole(field)]).0.determinant();
        let close = |a: f64, b: f64| (a - b).abs() < 1e-7 * (1.0 + b.abs());
        for (axis, w) in [(Axis::X, p.x), (Axis::Y, p.y), (Axis::Z, p.z)] {
            assert!(close(det(&field::twist(axis, 0.7, 0.2).unwrap()), 1.0));
            assert!(close(det(&field::taper(axis, 0.2, -0.1).unwrap()), (1.0 + 0.2 * (w + 0.1)).powi(2)));
            // Lengths grow with the distance from the centre of curvature, which lies on the next
            // axis.
            let u = [p.y, p.z, p.x][axis.index()];
            let bent = det(&field::bend(axis, 0.3, -9.0, f64::INFINITY).unwrap());
            assert!(close(bent, 1.0 - 0.3 * u), "{axis:?} {bent}");
            let v = [p.z, p.x, p.y][axis.index()];
            assert!(close(det(&field::cylinder_wrap(axis, 3.0).unwrap()), (3.0 + v) / 3.0));
            let ratio = (5.0 + (2.0 + w) * (v / 2.0).cos()) / 5.0 * (2.0 + w) / 2.0;
            assert!(close(det(&field::torus_wrap(axis, 5.0, 2.0).unwrap()), ratio));
        }
        assert!(close(det(&field::shear(Axis::Y, Axis::X, 0.7).unwrap()), 1.0));
        let ratio = 2.0 / p.length();
        assert!(close(det(&field::spherify(DVec3::ZERO, 2.0).unwrap()), 0.0 * ratio), "all of a ray is one point");
    }
}

#[test]
fn a_twist_turns_and_a_bend_keeps_the_length_of_its_axis() {
    let twist = field::twist(Axis::Z, PI / 2.0, 1.0).unwrap();
    assert!(at(&twist, 1.0, DVec3::new(1.0, 0.0, 2.0)).distance(DVec3::new(0.0, 1.0, 2.0)) < 1e-15);
    assert!(at(&twist, 0.5, DVec3::new(1.0, 0.0, 3.0)).distance(DVec3::new(0.0, 1.0, 3.0)) < 1e-15);
    assert!(
        at(&field::twist(Axis::X, PI / 2.0, 0.0).unwrap(), 1.0, DVec3::new(1.0, 1.0, 0.0))
            .distance(DVec3::new(1.0, 0.0, 1.0))
            < 1e-15
    );
    // A bend to a half turn, from z = 1 to z = 1 + pi.
    let bend = field::bend(Axis::Z, 1.0, 1.0, 1.0 + PI).unwrap();
    let axis = |w: f64| at(&bend, 1.0, DVec3::new(0.0, 0.0, w));
    assert_eq!(axis(0.5), DVec3::new(0.0, 0.0, 0.5));
    assert!(axis(1.0 + PI / 2.0).distance(DVec3::new(1.0, 0.0, 2.0)) < 1e-15);
    assert!(axis(1.0 + PI).distance(DVec3::new(2.0, 0.0, 1.0)) < 1e-15);
    assert!(axis(2.0 + PI).distance(DVec3::new(2.0, 0.0, 0.0)) < 1e-15, "straight on");
    // A quarter turn, and on in the direction that it has then; beside the axis, the same from the
    // arc beside it.
    let quarter = field::bend(Axis::Z, 1.0, 1.0, 1.0 + PI / 2.0).unwrap();
    let end = 1.0 + PI / 2.0 + 2.0;
    assert!(at(&quarter, 1.0, DVec3::new(0.0, 7.0, end)).distance(DVec3::new(3.0, 7.0, 2.0)) < 1e-15);
    assert!(at(&quarter, 1.0, DVec3::new(0.5, 0.0, end)).distance(DVec3::new(3.0, 0.0, 1.5)) < 1e-15);
    let length: f64 = (0..5000u32).map(|k| axis(f64::from(k) * 1e-3).distance(axis(f64::from(k + 1) * 1e-3))).sum();
    assert!((length - 5.0).abs() < 1e-5);
}

#[test]
fn a_lattice_moves_what_its_control_points_say() {
    let mut random = Random(5);
    let (low, high) = (DVec3::new(-1.0, 0.0, 1.0), DVec3::new(2.0, 1.0, 5.0));
    let counts = [4, 3, 2];
    let zeros = vec![DVec3::ZERO; 24];
    let p = DVec3::new(0.3, 0.4, 2.0);
    assert_eq!(at(&Lattice::new(low, high, counts, &zeros).unwrap(), 1.0, p), p);
    // Offsets that are an affine map of the grid make that map (Bernstein polynomials reproduce
    // it).
    let map = |p: DVec3| DVec3::new(0.1 * p.x - 0.3 * p.z, 0.2 + p.y, p.x);
    let place = |k: usize| DVec3::new((k % 4) as f64 / 3.0, (k / 4 % 3) as f64 / 2.0, (k / 12) as f64);
    let offsets: Vec<DVec3> = (0..24).map(|k| map(low + place(k) * (high - low))).collect();
    let lattice = Lattice::new(low, high, counts, &offsets).unwrap();
    for _ in 0..100 {
        let p = low + (0.5 + 0.5 * random.vector()) * (high - low);
        assert!(at(&lattice, 0.5, p).distance(p + 0.5 * map(p)) < 1e-14);
    }
    assert_eq!(at(&lattice, 1.0, high + 0.1), high + 0.1, "outside nothing moves");
    assert!(matches!(
        Lattice::new(low, high, [1, 2, 2], &zeros),
        Err(Error::OptionOutOfRange { option: "counts", .. })
    ));
    assert!(matches!(Lattice::new(low, high, [9, 2, 2], &zeros), Err(Error::ArrayTooShort { .. })));
    assert!(Lattice::new(high, low, counts, &zeros).is_err());
}

#[test]
fn projections_put_points_on_the_plane_along_the_lines_they_should() {
    let mut random = Random(9);
    for _ in 0..200 {
        let (q, n, d, eye, p) =
            (random.vector(), random.vector(), random.vector(), 5.0 * random.vector(), random.vector());
        let parallel = at(&field::parallel_projection(q, n, d).unwrap(), 1.0, p);
        let scale = 1.0 / n.dot(d).abs();
        assert!((parallel - q).dot(n).abs() < 1e-13 * scale && (parallel - p).cross(d).length() < 1e-13 * scale);
        let seen = at(&field::perspective_projection(eye, q, n).unwrap(), 1.0, p);
        let scale = 1.0 / n.dot(p - eye).abs();
        assert!((seen - q).dot(n).abs() < 1e-12 * scale.max(1.0), "on the plane");
        assert!((seen - eye).cross(p - eye).length() < 1e-11 * scale.max(1.0), "on the ray");
    }
    assert!(field::parallel_projection(DVec3::ZERO, DVec3::Z, DVec3::X).is_err());
    assert!(field::perspective_projection(DVec3::X, DVec3::ZERO, DVec3::Z).is_err());
}

#[test]
fn where_a_field_is_undefined_the_node_is_named_and_nothing_changes() {
    // The eye at height 3: row 3 of the sheet is level with it.
    let mut net = sheet(90, 70, Scalar::F32);
    net.coordinates_mut().set(2, 1, DVec3::NAN);
    let before = bits(&net);
    let project = field::perspective_projection(DVec3::new(0.5, 3.0, 7.0), DVec3::ZERO, DVec3::Y).unwrap();
    let shift = Affine::translation(DVec3::new(1.0, 0.0, 0.0)).unwrap();
    let steps = [whole(&shift), whole(&project)];
    assert_eq!(deform(&mut net, &steps, &Job::default()), Err(Error::FieldUndefined { node: 3 * 70 }));
    assert_eq!(bits(&net), before);
    let spherify = field::spherify(DVec3::new(5.0, 80.0, 0.0), 1.0).unwrap();
    assert_eq!(
        deform(&mut net, &[whole(&spherify)], &Job::default()),
        Err(Error::FieldUndefined { node: 80 * 70 + 5 })
    );
    assert_eq!(bits(&net), before);
    let nan = [DeformationStep { field: &shift, strength: f64::NAN }];
    assert!(matches!(deform(&mut net, &nan, &Job::default()), Err(Error::OptionOutOfRange { option: "strength", .. })));
}

#[test]
fn gaps_between_rows_are_left_alone() {
    let net = torus(301, 117, Scalar::F64);
    let twist = field::twist(Axis::Y, 0.5, 0.0).unwrap();
    let mut expected = net.copied().unwrap();
    deform(&mut expected, &[whole(&twist)], &Job::default()).unwrap();
    let mut gapped = Gapped::from_net(&net, 5);
    let mut borrowed = gapped.net(net.topology().clone());
    deform(&mut borrowed, &[whole(&twist)], &Job::default()).unwrap();
    assert_eq!(bits(&borrowed), bits(&expected));
    drop(borrowed);
    assert!(gapped.gaps_are_whole());
}

#[test]
fn the_host_s_function_is_called_for_every_node_once_and_the_result_is_snapped() {
    for (scalar, rows, columns) in [(Scalar::F32, 131, 67), (Scalar::F64, 5, 9001)] {
        let before = torus(rows, columns, scalar);
        let mut net = before.copied().unwrap();
        let mut next = 0;
        // Depends on the node, so that glued nodes come apart.
        let map = |first: usize, nodes: RowsMut<'_>| {
            assert_eq!(first, next);
            match nodes {
                RowsMut::F32([x, y, z]) => {
                    assert!(x.len() == y.len() && y.len() == z.len());
                    x.iter_mut().zip(first..).for_each(|(x, node)| *x += node as f32);
                    next += x.len();
                }
                RowsMut::F64([x, ..]) => {
                    x.iter_mut().zip(first..).for_each(|(x, node)| *x += node as f64);
                    next += x.len();
                }
            }
            Ok(())
        };
        deform_by_callback(&mut net, map, &Job::default()).unwrap();
        assert_eq!(next, rows * columns);
        assert!(glued_bits_agree(&net));
        let node = (rows - 2) * columns + 1;
        let expected = before.get(rows - 2, 1).x + node as f64;
        assert!((net.get(rows - 2, 1).x - expected).abs() <= 1e-7 * expected);
        let fail = |_: usize, _: RowsMut<'_>| Err(Error::Cancelled);
        assert_eq!(deform_by_callback(&mut net, fail, &Job::default()), Err(Error::Cancelled));
    }
}

#[test]
fn snap_gives_members_the_bits_of_their_representative() {
    let mut net = sphere(9, 13, Scalar::F64);
    assert_eq!(snap_glued_nodes(&mut net).unwrap(), 0);
    net.coordinates_mut().set(4, 12, DVec3::NAN);
    net.coordinates_mut().set(0, 5, DVec3::new(-0.0, 0.0, -1.0));
    assert_eq!(snap_glued_nodes(&mut net).unwrap(), 2, "a zero with a sign is other bits");
    assert!(glued_bits_agree(&net));
    assert_eq!(net.get(4, 12), net.get(4, 0));
}

#[test]
fn displacement_along_normals_makes_a_larger_sphere() {
    for reversed in [false, true] {
        let mut net = sphere(33, 65, Scalar::F64);
        let topology: Topology = net.topology().clone().with_reversed(reversed);
        net.set_topology(topology);
        displace_along_normals(&mut net, 0.5, &Job::default()).unwrap();
        let radius = if reversed { 0.5 } else { 1.5 };
        for i in 0..33 {
            for j in 0..65 {
                assert!((net.get(i, j).length() - radius).abs() < 1e-12);
            }
        }
        assert!(glued_bits_agree(&net));
    }
    assert!(displace_along_normals(&mut sphere(9, 9, Scalar::F32), f64::NAN, &Job::default()).is_err());
}

#[test]
fn a_sheet_rolls_up_to_a_torus() {
    let mut net = sheet(13, 25, Scalar::F64);
    let fit = Affine::stretching(DVec3::new(TAU * 3.0 / 24.0, TAU / 12.0, 1.0)).unwrap();
    deform(&mut net, &[whole(&fit), whole(&field::torus_wrap(Axis::Z, 3.0, 1.0).unwrap())], &Job::default()).unwrap();
    net.set_topology(Topology::from_sides(net.shape(), Sides::TORUS));
    let expected: Net<'_> = torus(13, 25, Scalar::F64);
    for i in 0..13 {
        for j in 0..25 {
            assert!(net.get(i, j).distance(expected.get(i, j)) < 1e-14);
        }
    }
}

#[test]
fn strengths_follow_their_keys() {
    let keys = [[1.0, 0.0], [2.0, 1.0], [4.0, -3.0]];
    let linear = TimedStrength::new(&keys, Easing::Linear).unwrap();
    let smooth = TimedStrength::new(&keys, Easing::Smooth).unwrap();
    let hold = TimedStrength::new(&keys, Easing::Hold).unwrap();
    for timed in [linear, smooth, hold] {
        for [time, strength] in keys {
            assert_eq!(timed.strength_at(time), strength);
        }
        assert_eq!((timed.strength_at(-9.0), timed.strength_at(9.0)), (0.0, -3.0));
    }
    assert_eq!((linear.strength_at(1.25), smooth.strength_at(1.5), hold.strength_at(1.99)), (0.25, 0.5, 0.0));
    assert_eq!(linear.strength_at(3.0), -1.0);
    assert!(smooth.strength_at(1.1) < 0.1 && smooth.strength_at(1.9) > 0.9);
    assert!(TimedStrength::new(&[], Easing::Linear).is_err());
    assert!(TimedStrength::new(&[[1.0, 0.0], [1.0, 1.0]], Easing::Linear).is_err());
    assert!(TimedStrength::new(&[[f64::NAN, 0.0]], Easing::Linear).is_err());
}

#[test]
fn projections_through_an_eye_are_as_exact_far_from_the_origin() {
    let offset = DVec3::new(5e5 + 0.3, 5e6 + 0.7, 123.4);
    let normal = DVec3::new(0.3, 0.5, 1.0).normalize();
    let eye = offset + 50.1 * normal;
    let project = field::perspective_projection(eye, offset, normal).unwrap();
    let p = offset + DVec3::new(3.3, 7.1, 3.3);
    let expected = eye + (p - eye) * (normal.dot(offset - eye) / normal.dot(p - eye));
    assert!(at(&project, 1.0, p).distance(expected) < 1e-8);
    assert!(normal.dot(at(&project, 1.0, p) - offset).abs() < 1e-8, "on the plane");
    assert!(at(&project, 0.25, p).distance(p + 0.25 * (expected - p)) < 1e-8, "a part of the straight way");
    assert!(field::perspective_projection(DVec3::NAN, offset, normal).is_err());
}

#[test]
fn what_overflows_the_type_of_the_net_is_undefined() {
    // In single precision the node that is nearly level with the eye goes further than there are
    // numbers.
    let mut net = sheet(4, 5, Scalar::F32);
    net.coordinates_mut().set(2, 3, DVec3::new(3.0, 2.0, 1.0 - f64::from(f32::EPSILON) / 2.0));
    let before = bits(&net);
    let project = field::perspective_projection(DVec3::Z, DVec3::new(0.0, 0.0, -1e35), DVec3::Z).unwrap();
    assert_eq!(deform(&mut net, &[whole(&project)], &Job::default()), Err(Error::FieldUndefined { node: 13 }));
    assert_eq!(bits(&net), before);
    // Squares of distances that are NaN do no harm.
    let spherify = field::spherify(DVec3::ZERO, 2.0).unwrap();
    for length in [1e155, 1e300, 1e-170, 1e-300] {
        let moved = at(&spherify, 1.0, length * DVec3::new(3.0, 0.0, -4.0));
        assert!(moved.distance(DVec3::new(1.2, 0.0, -1.6)) < 1e-15, "{length} {moved}");
    }
}
