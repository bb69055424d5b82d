//! Primitives: gluing, exact duplicates, area and volume.

use crate::complexes::{area_and_volume, check_gauss_bonnet};
use glam::DVec3;
use gusset::mesh::Scalar;
use gusset::net::closure::{BoxKind, Cuboid};
use gusset::net::complex::Complex;
use gusset::net::primitive::{Primitive, Request};
use gusset::net::{Net, NodeClasses, detect_gluing};
use gusset::{Error, Job};
use std::f64::consts::PI;

/// A vase: open above, on the axis below.
const VASE: [[f64; 2]; 5] = [[0.0, 0.0], [1.0, 0.0], [1.5, 1.0], [0.5, 2.0], [0.75, 2.5]];
/// Two balls that touch.
const HOURGLASS: [[f64; 2]; 5] = [[0.0, -2.0], [1.0, -1.0], [0.0, 0.0], [1.0, 1.0], [0.0, 2.0]];
/// A ring with a square section, clockwise, so that faces must be turned.
const RING: [[f64; 2]; 5] = [[2.0, 0.0], [1.0, 0.0], [1.0, 1.0], [2.0, 1.0], [2.0, 0.0]];

fn net(primitive: Primitive<'_>, rows: usize, columns: usize, scalar: Scalar) -> Net<'static> {
    Request { primitive, rows, columns, scalar }.build_net(&Job::default()).unwrap()
}

/// All kinds, with Euler's characteristic, boundary loops, and whether they have an inside.
fn all() -> Vec<(Primitive<'static>, i64, usize, bool)> {
    let (radius, height, minor_radius) = (1.25, 2.0, 0.375);
    let cuboid = |kind, cells| Primitive::Cuboid { cuboid: Cuboid { kind, cells }, size: [1.0, 2.5, 0.75] };
    vec![
        (Primitive::Plane { size: [2.0, 3.0] }, 1, 1, false),
        (Primitive::Sphere { radius }, 2, 0, true),
        (Primitive::OnePoleSphere { radius }, 2, 0, true),
        (Primitive::Tube { radius, height }, 0, 2, false),
        (Primitive::Cylinder { radius, height }, 2, 0, true),
        (Primitive::Prism { sides: 5, radius, height }, 2, 0, true),
        (Primitive::Cone { radius, height }, 2, 0, true),
        (Primitive::Pyramid { sides: 4, radius, height }, 2, 0, true),
        (Primitive::Lathe { profile: &VASE }, 1, 1, false),
        (Primitive::Lathe { profile: &RING }, 0, 0, true),
        (Primitive::Torus { radius, minor_radius }, 0, 0, true),
        (cuboid(BoxKind::Slit, [3, 4, 5]), 2, 0, true),
        (cuboid(BoxKind::Cross, [3, 4, 5]), 2, 0, true),
        (cuboid(BoxKind::Concentric, [3, 4, 5]), 2, 0, true),
        (Primitive::Moebius { radius, width: 0.5 }, 0, 1, false),
        (Primitive::Klein { radius, minor_radius }, 0, 0, false),
        (Primitive::ProjectivePlane { radius }, 1, 0, false),
        (Primitive::Pillow { size: [2.0, 1.0], thickness: 0.5 }, 2, 0, true),
    ]
}

#[test]
fn every_primitive_is_what_it_is() {
    let job = Job::default();
    for (primitive, chi, loops, solid) in all() {
        for (scalar, rows, columns) in [(Scalar::F64, 9, 13), (Scalar::F32, 12, 17), (Scalar::F64, 0, 0)] {
            let net = net(primitive, rows, columns, scalar);
            let complex = Complex::from_topology(net.topology(), &job).unwrap();
            assert_eq!((complex.euler_characteristic(), complex.boundary.len()), (chi, loops), "{primitive:?}");
            assert!(complex.is_manifold());
            if loops == 0 {
                check_gauss_bonnet(net.topology(), &complex);
            }
            check_duplicates(&net);
            assert_eq!(net.validate(0.0, &job).unwrap(), [], "{primitive:?}");
            let (_, volume) = area_and_volume(net.shape(), |i, j| net.get(i, j));
            let turned = net.topology().is_reversed();
            assert!(!solid || (volume > 0.0) != turned, "{primitive:?}: faces from outside");
            // Coincident nodes are exactly the glued nodes.
            for tolerance in [0.0, 1e-6] {
                let derived = detect_gluing(net.coordinates(), tolerance, &job).unwrap();
                let expected = net.topology().canonical_form().unwrap().with_reversed(false);
                assert_eq!(derived, expected, "{primitive:?}");
            }
        }
    }
}

fn check_duplicates(net: &Net<'_>) {
    let bits = |node: u32| {
        let (i, j) = net.shape().row_and_column(node);
        net.get(i, j).to_array().map(f64::to_bits)
    };
    for class in NodeClasses::new(net.topology()).unwrap().glued_classes().unwrap().iter() {
        assert!(class.iter().all(|&node| bits(node) == bits(class[0])));
    }
    let zero = (0..net.shape().node_count() as u32).flat_map(bits).any(|bits| bits == (-0f64).to_bits());
    assert!(!zero, "zeros have no sign");
}

#[test]
fn volumes_of_prisms_and_pyramids() {
    for sides in 3..9u32 {
        for columns in [sides as usize + 1, 11, 24, 37] {
            let (radius, height) = (1.5, 2.0);
            let k = f64::from(sides);
            let base = k / 2.0 * radius * radius * (2.0 * PI / k).sin();
            let volume = |primitive| {
                let net = net(primitive, 11, columns, Scalar::F64);
                // All vertices are nodes.
                for side in 0..sides {
                    let angle = 2.0 * PI * f64::from(side) / k;
                    let corner = DVec3::new(radius * angle.cos(), radius * angle.sin(), -height / 2.0);
                    let nodes = (0..11).flat_map(|i| (0..columns).map(move |j| (i, j)));
                    assert!(nodes.into_iter().any(|(i, j)| (net.get(i, j) - corner).length() < 1e-14));
                }
                area_and_volume(net.shape(), |i, j| net.get(i, j)).1 / 6.0
            };
            let (prism, pyramid) = (base * height, base * height / 3.0);
            assert!((volume(Primitive::Prism { sides, radius, height }) / prism - 1.0).abs() < 1e-13);
            assert!((volume(Primitive::Pyramid { sides, radius, height }) / pyramid - 1.0).abs() < 1e-13);
        }
    }
}

/// Halving the cells divides the errors by four.
#[test]
fn spheres_and_tori_converge() {
    let (radius, minor_radius) = (1.5, 0.5);
    let sphere = (4.0 * PI * radius * radius, 4.0 / 3.0 * PI * radius.powi(3));
    let torus = (4.0 * PI * PI * radius * minor_radius, 2.0 * PI * PI * radius * minor_radius * minor_radius);
    let cases = [
        (Primitive::Sphere { radius }, sphere),
        (Primitive::OnePoleSphere { radius }, sphere),
        (Primitive::Torus { radius, minor_radius }, torus),
    ];
    for (primitive, (area, volume)) in cases {
        let errors = |n: usize| {
            let net = net(primitive, n + 1, 2 * n + 1, Scalar::F64);
            let (a, v) = area_and_volume(net.shape(), |i, j| net.get(i, j));
            [a / 2.0 / area - 1.0, v / 6.0 / volume - 1.0].map(f64::abs)
        };
        let (coarse, fine) = (errors(64), errors(128));
        for k in 0..2 {
            let ratio = coarse[k] / fine[k];
            assert!((3.6..4.4).contains(&ratio) && fine[k] < 1e-2, "{primitive:?}: {coarse:?} {fine:?}");
        }
    }
}

#[test]
fn boxes_have_exact_measures() {
    for kind in [BoxKind::Slit, BoxKind::Cross, BoxKind::Concentric] {
        for n in [1u32, 2, 3, 8, 13] {
            let cuboid = Cuboid::cube(kind, n);
            let n = f64::from(n);
            for scalar in [Scalar::F32, Scalar::F64] {
                let net = net(Primitive::Cuboid { cuboid, size: [n; 3] }, 0, 0, scalar);
                let measured = area_and_volume(net.shape(), |i, j| net.get(i, j));
                assert_eq!(measured, (12.0 * n * n, 6.0 * n.powi(3)));
            }
        }
    }
}

/// Seams copy coordinates; that the formulas agree there shows in cells that are no longer across
/// the seam than beside it.
#[test]
fn immersions_have_no_jump_at_their_seams() {
    for (primitive, h, w) in [
        (Primitive::Moebius { radius: 2.0, width: 1.0 }, 33, 129),
        (Primitive::Klein { radius: 2.0, minor_radius: 0.5 }, 65, 129),
        (Primitive::ProjectivePlane { radius: 1.0 }, 129, 129),
    ] {
        let net = net(primitive, h, w, Scalar::F64);
        let length = |a: (usize, usize), b: (usize, usize)| (net.get(a.0, a.1) - net.get(b.0, b.1)).length();
        let mut longest = [[0f64; 2]; 2];
        for (i, j) in (0..h).flat_map(|i| (0..w).map(move |j| (i, j))) {
            if j + 1 < w {
                let at_seam = usize::from(j == 0 || j + 2 == w);
                longest[0][at_seam] = longest[0][at_seam].max(length((i, j), (i, j + 1)));
            }
            if i + 1 < h {
                let at_seam = usize::from(i == 0 || i + 2 == h);
                longest[1][at_seam] = longest[1][at_seam].max(length((i, j), (i + 1, j)));
            }
        }
        assert!(longest.iter().all(|[inside, seam]| *seam < 1.2 * inside), "{primitive:?}: {longest:?}");
    }
}

#[test]
fn lathes() {
    let job = Job::default();
    let hourglass = net(Primitive::Lathe { profile: &HOURGLASS }, 0, 9, Scalar::F64);
    let complex = Complex::from_topology(hourglass.topology(), &job).unwrap();
    assert_eq!((complex.euler_characteristic(), complex.components), (3, 1));
    assert_eq!(complex.pinches, [18], "the row on the axis");
    assert!(complex.is_closed() && !complex.is_manifold());
    check_duplicates(&hourglass);
    assert_eq!(hourglass.validate(0.0, &job).unwrap(), []);
    // The other way round, and as the paper has it: the volume of faces taken the other way round
    // is positive too.
    let ring = net(Primitive::Lathe { profile: &RING }, 0, 33, Scalar::F64);
    assert!(ring.topology().is_reversed());
    let turned: Vec<_> = RING.iter().rev().copied().collect();
    assert!(!net(Primitive::Lathe { profile: &turned }, 0, 33, Scalar::F64).topology().is_reversed());
}

#[test]
fn what_makes_no_sense_is_refused() {
    let job = Job::default();
    let refused = |primitive, rows, columns, option: &str| {
        let request = Request { primitive, rows, columns, scalar: Scalar::F32 };
        match request.build_net(&job) {
            Err(Error::OptionOutOfRange { option: found, .. }) => assert_eq!(found, option),
            other => panic!("{other:?}"),
        }
    };
    for radius in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e300, 1e-300] {
        refused(Primitive::Sphere { radius }, 0, 0, "radius");
    }
    refused(Primitive::Sphere { radius: 1.0 }, 2, 0, "rows");
    refused(Primitive::Sphere { radius: 1.0 }, 0, 3, "columns");
    refused(Primitive::Torus { radius: 1.0, minor_radius: 1.0 }, 0, 0, "minor_radius");
    refused(Primitive::Prism { sides: 2, radius: 1.0, height: 1.0 }, 0, 0, "sides");
    refused(Primitive::Prism { sides: 7, radius: 1.0, height: 1.0 }, 0, 7, "columns");
    refused(Primitive::Prism { sides: u32::MAX, radius: 1.0, height: 1.0 }, 0, 7, "columns");
    refused(Primitive::Pillow { size: [1.0; 2], thickness: 1.0 }, 0, 6, "columns");
    refused(Primitive::Lathe { profile: &[[-1.0, 0.0], [1.0, 0.0]] }, 0, 0, "profile");
    refused(Primitive::Lathe { profile: &[[1.0, f64::NAN], [1.0, 0.0]] }, 0, 0, "profile");
    refused(Primitive::Lathe { profile: &[] }, 0, 0, "rows");
    let cuboid = Cuboid { kind: BoxKind::Slit, cells: [1, 0, 1] };
    refused(Primitive::Cuboid { cuboid, size: [1.0; 3] }, 0, 0, "cells");
    let huge = Request { rows: usize::MAX, columns: usize::MAX, ..Request::new(Primitive::Plane { size: [1.0; 2] }) };
    assert!(matches!(huge.build_net(&job), Err(Error::TooLarge { .. })));
}

#[test]
fn zeros_have_no_sign_even_where_small_numbers_round_to_them() {
    for radius in [1e-30, 1e-37] {
        let net = net(Primitive::ProjectivePlane { radius }, 33, 65, Scalar::F32);
        let nodes = (0..33).flat_map(|i| (0..65).map(move |j| (i, j)));
        let mut numbers = nodes.flat_map(|(i, j)| net.get(i, j).to_array());
        assert!(numbers.all(|value| value != 0.0 || value.is_sign_positive()), "{radius}");
    }
}
