//! Nets between two nets: ends, gluing, rigid motions, refusals.

use crate::space::{Random, bits, glued_bits_agree, sheet, sphere, torus};
use glam::{DMat3, DVec3};
use gusset::mesh::Scalar;
use gusset::net::field::snap_glued_nodes;
use gusset::net::{MorphPath, Net, Sides, Topology, morph};
use gusset::{Error, Job};

const PATHS: [MorphPath; 2] = [MorphPath::Linear, MorphPath::Rigid];

fn between(a: &Net<'_>, b: &Net<'_>, t: f64, path: MorphPath) -> Net<'static> {
    morph(a, b, t, path, &Job::default()).unwrap()
}

/// The net with its nodes moved by a function, glued ones alike.
fn moved(net: &Net<'_>, mut map: impl FnMut(DVec3) -> DVec3) -> Net<'static> {
    let mut made = Net::from_fn(net.topology().clone(), net.coordinates().scalar(), |i, j| map(net.get(i, j))).unwrap();
    snap_glued_nodes(&mut made).unwrap();
    made
}

#[test]
fn ends_have_the_bits_of_the_nets_and_glued_nodes_stay_equal() {
    let mut random = Random(3);
    for scalar in [Scalar::F32, Scalar::F64] {
        for a in [sphere(9, 13, scalar), torus(9, 13, scalar), sheet(5, 7, scalar)] {
            let b = moved(&a, |p| 2.0 * p + random.vector() - DVec3::new(-0.0, 3.0, 1e3));
            for path in PATHS {
                assert_eq!(bits(&between(&a, &b, 0.0, path)), bits(&a));
                assert_eq!(bits(&between(&a, &b, 1.0, path)), bits(&b));
                for t in [1e-9, 0.3, 0.5, 0.9] {
                    let made = between(&a, &b, t, path);
                    assert!(glued_bits_agree(&made) && made.topology() == a.topology());
                    // Not far from either end, and continuous there.
                    let reach = if t < 1e-6 { 1e-2 } else { 2e3 };
                    assert!(made.get(2, 3).distance(a.get(2, 3)) < reach);
                }
                let almost = between(&a, &b, 1.0 - 1e-9, path);
                assert!(almost.get(2, 3).distance(b.get(2, 3)) < 1e-3);
            }
            let half = between(&a, &b, 0.25, MorphPath::Linear).get(1, 2);
            assert!(half.distance(0.75 * a.get(1, 2) + 0.25 * b.get(1, 2)) < 1e-4 * (1.0 + half.length()));
        }
    }
}

#[test]
fn what_moves_rigidly_keeps_its_shape() {
    let mut random = Random(8);
    for k in 0..40 {
        let a = moved(&sheet(6, 8, Scalar::F64), |p| p + 0.5 * random.vector());
        // Angles up to nearly a half turn; none, and a quarter about an axis of coordinates, too.
        let angle = if k == 0 { 0.0 } else { 3.1 * random.next() };
        let axis = if k == 1 { DVec3::Z } else { random.vector().normalize() };
        let turn = |part: f64| DMat3::from_axis_angle(axis, part * angle);
        let (shift, mean) = (10.0 * random.vector(), mean(&a));
        let b = moved(&a, |p| turn(1.0) * (p - mean) + mean + shift);
        for t in [0.2, 0.5, 0.75] {
            let made = between(&a, &b, t, MorphPath::Rigid);
            for (i, j) in (0..6).flat_map(|i| (0..8).map(move |j| (i, j))) {
                let expected = turn(t) * (a.get(i, j) - mean) + mean + t * shift;
                assert!(made.get(i, j).distance(expected) < 1e-10, "{k} {angle} {t}");
            }
        }
    }
    // In any unit.
    let (a, turn) = (sheet(6, 8, Scalar::F64), |part: f64| DMat3::from_rotation_z(2.0 * part));
    for unit in [1e-300, 1e-160, 1e155, 1e306] {
        let [first, second] = [0.0, 1.0].map(|part| moved(&a, |p| turn(part) * p * unit));
        let (made, mean) = (between(&first, &second, 0.5, MorphPath::Rigid), mean(&a));
        let expected = turn(0.5) * (a.get(2, 3) - mean) + 0.5 * (mean + turn(1.0) * mean);
        assert!((made.get(2, 3) / unit).distance(expected) < 1e-9, "{unit}");
    }
    // A net and its mirror image: the best rotation is none of the reflections.
    let a = moved(&sheet(6, 8, Scalar::F64), |p| p + 0.5 * random.vector());
    let mirrored = moved(&a, |p| DVec3::new(-p.x, p.y, p.z));
    assert!(between(&a, &mirrored, 0.5, MorphPath::Rigid).get(2, 2).is_finite());
}

fn mean(net: &Net<'_>) -> DVec3 {
    let (h, w) = (net.shape().rows(), net.shape().columns());
    (0..h).flat_map(|i| (0..w).map(move |j| net.get(i, j))).sum::<DVec3>() / (h * w) as f64
}

#[test]
fn nets_that_do_not_fit_are_refused_and_missing_nodes_stay_missing() {
    let a = sheet(5, 7, Scalar::F64);
    let refused = |b: &Net<'_>, t: f64| morph(&a, b, t, MorphPath::Rigid, &Job::default()).map(|_| ()).unwrap_err();
    assert_eq!(refused(&sheet(5, 8, Scalar::F64), 0.5), Error::SidesDiffer { a: 7, b: 8 });
    assert_eq!(refused(&sheet(6, 7, Scalar::F64), 0.5), Error::SidesDiffer { a: 5, b: 6 });
    assert_eq!(refused(&sheet(5, 7, Scalar::F32), 0.5), Error::MixedScalars);
    let mut tube = sheet(5, 7, Scalar::F64);
    tube.set_topology(Topology::from_sides(a.shape(), Sides::TUBE));
    assert_eq!(refused(&tube, 0.5), Error::GluingsDiffer { node: 6 });
    let mut reversed = sheet(5, 7, Scalar::F64);
    reversed.set_topology(a.topology().clone().with_reversed(true));
    assert_eq!(refused(&reversed, 0.5), Error::NetsOpposed);
    for t in [-0.1, 1.1, f64::NAN] {
        assert!(matches!(refused(&a, t), Error::OptionOutOfRange { option: "t", .. }));
    }
    let (mut first, mut second) = (a.copied().unwrap(), moved(&a, |p| p + DVec3::Z));
    first.coordinates_mut().set(1, 1, DVec3::NAN);
    second.coordinates_mut().set(2, 2, DVec3::INFINITY);
    for path in PATHS {
        let made = between(&first, &second, 0.5, path);
        assert!(!made.get(1, 1).is_finite() && !made.get(2, 2).is_finite());
        assert!(made.get(3, 3).distance(DVec3::new(3.0, 3.0, 0.5)) < 1e-12);
    }
}
