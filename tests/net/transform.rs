//! Spatial operations: the paper's formulas, bits, reflections.

use crate::common::Silent;
use crate::space::{Gapped, Random, bits, glued_bits_agree, sphere, torus};
use glam::DVec3;
use gusset::job::Progress;
use gusset::mesh::Scalar;
use gusset::net::Net;
use gusset::net::transform::{Affine, Axis, RotationSense, transform};
use gusset::{Error, Job};
use std::ops::ControlFlow;

/// Rotates about a unit axis by the right hand: the component along the axis stays, the rest
/// rotates in its plane.
fn turned(p: DVec3, axis: DVec3, angle: f64) -> DVec3 {
    let along = p.dot(axis) * axis;
    let across = p - along;
    along + angle.cos() * across + angle.sin() * axis.cross(across)
}

/// The paper's R(V, alpha), as printed.
fn printed(p: DVec3, v: DVec3, alpha: f64) -> DVec3 {
    let (s, c) = alpha.sin_cos();
    DVec3::new(
        p.x * (c + (1.0 - c) * v.x * v.x)
            + p.y * ((1.0 - c) * v.y * v.x + s * v.z)
            + p.z * ((1.0 - c) * v.z * v.x - s * v.y),
        p.x * ((1.0 - c) * v.x * v.y - s * v.z)
            + p.y * (c + (1.0 - c) * v.y * v.y)
            + p.z * ((1.0 - c) * v.z * v.y + s * v.x),
        p.x * ((1.0 - c) * v.x * v.z + s * v.y)
            + p.y * ((1.0 - c) * v.y * v.z - s * v.x)
            + p.z * (c + (1.0 - c) * v.z * v.z),
    )
}

#[test]
fn rotations_turn_by_the_right_hand_and_the_printed_one_by_the_left() {
    let mut random = Random(1);
    for _ in 0..1000 {
        let (axis, angle, p) = (random.vector(), 4.0 * random.next(), random.vector());
        let unit = axis.normalize();
        let right = Affine::rotation(axis, angle, DVec3::ZERO, RotationSense::RightHanded).unwrap();
        let paper = Affine::rotation(axis, angle, DVec3::ZERO, RotationSense::AsPrinted).unwrap();
        assert!(right.apply(p).distance(turned(p, unit, angle)) < 1e-14);
        assert!(paper.apply(p).distance(printed(p, unit, angle)) < 1e-14);
        assert!(paper.apply(p).distance(turned(p, unit, -angle)) < 1e-14, "the printed formula turns the other way");
        assert!((right.determinant() - 1.0).abs() < 1e-14);
        // About a pivot, the pivot stays.
        let pivot = random.vector();
        let about = Affine::rotation(axis, angle, pivot, RotationSense::RightHanded).unwrap();
        assert!(about.apply(pivot).distance(pivot) < 1e-14);
        assert!(about.apply(p).distance(pivot + turned(p - pivot, unit, angle)) < 1e-14);
    }
    let quarter =
        Affine::rotation(DVec3::Z, std::f64::consts::FRAC_PI_2, DVec3::ZERO, RotationSense::AsPrinted).unwrap();
    assert!(quarter.apply(DVec3::X).distance(-DVec3::Y) < 1e-15);
    // The length of the axis does not matter, even if huge or tiny.
    for scale in [1e-300, 1e300] {
        let scaled =
            Affine::rotation(scale * DVec3::new(1.0, 2.0, 2.0), 1.0, DVec3::ZERO, RotationSense::RightHanded).unwrap();
        assert!(scaled.apply(DVec3::X).distance(turned(DVec3::X, DVec3::new(1.0, 2.0, 2.0) / 3.0, 1.0)) < 1e-15);
    }
    for axis in [DVec3::ZERO, DVec3::NAN, DVec3::INFINITY] {
        let bad = Affine::rotation(axis, 1.0, DVec3::ZERO, RotationSense::RightHanded);
        assert!(matches!(bad, Err(Error::OptionOutOfRange { option: "axis", .. })));
    }
}

#[test]
fn scalings_and_compressions_are_what_their_formulas_say() {
    for k in [-2.0, 0.0, 0.5, 1.0, 3.0f64] {
        assert_eq!(Affine::scaling(k).unwrap().determinant(), k.powi(3));
        for axis in [Axis::X, Axis::Y, Axis::Z] {
            let compression = Affine::compression(axis, k).unwrap();
            assert_eq!(compression.determinant(), k * k, "two coordinates, so that none mirrors");
            let mut expected = DVec3::new(1.0, 2.0, 3.0) * k;
            expected[axis.index()] = [1.0, 2.0, 3.0][axis.index()];
            assert_eq!(compression.apply(DVec3::new(1.0, 2.0, 3.0)), expected);
        }
    }
    assert_eq!(Affine::scaling(1.0).unwrap(), Affine::IDENTITY);
    assert!(Affine::scaling(f64::NAN).is_err() && Affine::translation(DVec3::INFINITY).is_err());
    assert!(Affine::scaling(1e300).unwrap().then(&Affine::scaling(1e300).unwrap()).is_err(), "overflow");
}

fn chain(random: &mut Random) -> Affine {
    let parts = [
        Affine::translation(random.vector()),
        Affine::rotation(random.vector(), 3.0 * random.next(), random.vector(), RotationSense::RightHanded),
        Affine::scaling(1.0 + 0.5 * random.next()),
        Affine::compression(Axis::Y, 1.0 + 0.5 * random.next()),
        Affine::stretching(DVec3::ONE + 0.5 * random.vector()),
    ];
    parts.into_iter().fold(Affine::IDENTITY, |chain, part| chain.then(&part.unwrap()).unwrap())
}

#[test]
fn chains_are_one_map_and_every_node_goes_where_the_map_says() {
    let mut random = Random(2);
    // Odd widths, so that vectors have remainders; more nodes than one thread's block.
    for (scalar, tolerance) in [(Scalar::F64, 1e-14), (Scalar::F32, 1e-5)] {
        for (rows, columns) in [(5, 7), (301, 517)] {
            let affine = chain(&mut random);
            let before = torus(rows, columns, scalar);
            let mut after = before.copied().unwrap();
            transform(&mut after, &affine, &Job::new(2, &Silent)).unwrap();
            for i in 0..rows {
                for j in 0..columns {
                    assert!(after.get(i, j).distance(affine.apply(before.get(i, j))) < tolerance * 10.0);
                }
            }
            assert!(glued_bits_agree(&after));
            for threads in [1, 3, 16] {
                let mut again = before.copied().unwrap();
                transform(&mut again, &affine, &Job::new(threads, &Silent)).unwrap();
                assert_eq!(bits(&again), bits(&after));
            }
        }
    }
}

#[test]
fn memory_of_the_host_is_changed_in_place_and_gaps_are_not() {
    let net = torus(301, 117, Scalar::F64);
    let affine = chain(&mut Random(3));
    let mut gapped = Gapped::from_net(&net, 3);
    let mut expected = net.copied().unwrap();
    transform(&mut expected, &affine, &Job::default()).unwrap();
    let mut borrowed = gapped.net(net.topology().clone());
    transform(&mut borrowed, &affine, &Job::default()).unwrap();
    assert_eq!(bits(&borrowed), bits(&expected));
    drop(borrowed);
    assert!(gapped.gaps_are_whole());
}

/// Six times the volume of the tetrahedra from the origin to the cells' halves.
fn volume(net: &Net<'_>) -> f64 {
    let shape = net.shape();
    let cells = (0..shape.rows() - 1).flat_map(|i| (0..shape.columns() - 1).map(move |j| (i, j)));
    let sum: f64 = cells
        .map(|(i, j)| {
            let [a, b, c, d] = [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)].map(|(i, j)| net.get(i, j));
            a.dot(b.cross(c)) + a.dot(c.cross(d))
        })
        .sum();
    if net.topology().is_reversed() { -sum } else { sum }
}

#[test]
fn mirrored_nets_are_reversed_and_look_outwards_still() {
    let mut net = sphere(9, 13, Scalar::F64);
    let before = volume(&net);
    for (affine, reversed) in [
        (Affine::scaling(-1.0), true),
        (Affine::compression(Axis::X, -1.0), true),
        (Affine::stretching(DVec3::new(1.0, 1.0, -1.0)), false),
    ] {
        transform(&mut net, &affine.unwrap(), &Job::default()).unwrap();
        assert_eq!(net.topology().is_reversed(), reversed);
        assert!((volume(&net) - before).abs() < 1e-12, "a volume that is positive stays so");
    }
}

struct Never;
impl Progress for Never {
    fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
        ControlFlow::Break(())
    }
}

#[test]
fn missing_nodes_stay_missing_and_a_cancel_changes_nothing() {
    let mut net = torus(9, 13, Scalar::F32);
    for (k, missing) in
        [DVec3::NAN, DVec3::new(f64::NAN, 0.0, 0.0), DVec3::new(0.0, f64::INFINITY, 0.0)].into_iter().enumerate()
    {
        net.coordinates_mut().set(2 + k, 3, missing);
    }
    let before = bits(&net);
    let affine = chain(&mut Random(4));
    assert_eq!(transform(&mut net, &affine, &Job::new(1, &Never)), Err(Error::Cancelled));
    assert_eq!(bits(&net), before);
    transform(&mut net, &affine, &Job::default()).unwrap();
    for i in 0..9 {
        for j in 0..13 {
            assert_eq!(net.get(i, j).is_finite(), !((2..5).contains(&i) && j == 3));
        }
    }
}

#[test]
fn maps_mirror_whatever_becomes_of_the_volume() {
    for k in [1e-300, 1e-110, 1.0, 1e110, 1e300] {
        for (ratios, mirrors) in
            [([-k, -k, -k], true), ([k, k, k], false), ([k, -1.0, k], true), ([-k, -1.0, 1.0 / k], false)]
        {
            let map = Affine::stretching(DVec3::from_array(ratios)).unwrap();
            assert_eq!(map.is_mirroring(), mirrors, "{ratios:?}");
            let mut net = torus(5, 7, Scalar::F64);
            transform(&mut net, &map, &Job::default()).unwrap();
            assert_eq!(net.topology().is_reversed(), mirrors);
        }
    }
    assert!(
        !Affine::scaling(0.0).unwrap().is_mirroring() && !Affine::compression(Axis::Z, -0.0).unwrap().is_mirroring()
    );
}
