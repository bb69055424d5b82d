//! Nodes that are one point stay one, to the bit: after every shape, every affine map, every field.

use glam::DVec3;
use gusset::Job;
use gusset::mesh::Scalar;
use gusset::net::closure::{BoxKind, Cuboid};
use gusset::net::field::{self, DeformationStep, Field, Lattice, deform, displace_along_normals};
use gusset::net::primitive::{Primitive, Request};
use gusset::net::transform::{Affine, Axis, RotationSense, transform};
use gusset::net::{Net, NodeClasses};

fn shapes() -> Vec<Net<'static>> {
    let (radius, height, minor_radius) = (1.3, 2.1, 0.4);
    let cuboid = |kind| Primitive::Cuboid { cuboid: Cuboid { kind, cells: [4, 4, 6] }, size: [1.1, 2.3, 0.7] };
    let primitives = [
        Primitive::Sphere { radius },
        Primitive::OnePoleSphere { radius },
        Primitive::Tube { radius, height },
        Primitive::Cylinder { radius, height },
        Primitive::Prism { sides: 5, radius, height },
        Primitive::Cone { radius, height },
        Primitive::Pyramid { sides: 4, radius, height },
        Primitive::Torus { radius, minor_radius },
        cuboid(BoxKind::Slit),
        cuboid(BoxKind::Cross),
        cuboid(BoxKind::Concentric),
        Primitive::Moebius { radius, width: 0.5 },
        Primitive::Klein { radius, minor_radius },
        Primitive::ProjectivePlane { radius },
        Primitive::Pillow { size: [2.0, 1.0], thickness: 0.5 },
    ];
    let nets = primitives.into_iter().flat_map(|primitive| {
        [Scalar::F32, Scalar::F64].map(|scalar| {
            Request { rows: 14, columns: 23, scalar, ..Request::new(primitive) }.build_net(&Job::default()).unwrap()
        })
    });
    nets.collect()
}

fn check(net: &Net<'_>, what: &str) {
    let classes = NodeClasses::new(net.topology()).unwrap();
    let bits = |node: u32| {
        let (i, j) = net.shape().row_and_column(node);
        net.get(i, j).to_array().map(f64::to_bits)
    };
    for class in classes.glued_classes().unwrap().iter() {
        assert!(class.iter().all(|&node| bits(node) == bits(class[0])), "{what}: {class:?}");
    }
    let findings = net.validate(0.0, &Job::default()).unwrap();
    assert!(!findings.iter().any(|finding| finding.kind.is_violation()), "{what}: {findings:?}");
}

#[test]
fn shapes_and_affine_maps() {
    let third = std::f64::consts::PI / 3.0;
    let axis = DVec3::new(1.0, -0.3, 0.7);
    let maps = [
        ("translation", Affine::translation(DVec3::new(0.1, 1e3, -7.0 / 3.0))),
        ("rotation", Affine::rotation(axis, third, DVec3::ONE, RotationSense::RightHanded)),
        ("rotation as printed", Affine::rotation(axis, third, DVec3::ZERO, RotationSense::AsPrinted)),
        ("scaling", Affine::scaling(-1.0 / 3.0)),
        ("compression", Affine::compression(Axis::Y, 0.1)),
        ("stretching", Affine::stretching(DVec3::new(-1.0, 0.3, 7.0))),
        ("shear", Affine::new([[1.0, 0.1, 0.2, 3.0], [0.0, 1.0, 0.3, 0.0], [0.7, 0.0, 1.0, -1.0]])),
    ];
    for mut net in shapes() {
        check(&net, "shape");
        for (what, map) in &maps {
            transform(&mut net, map.as_ref().unwrap(), &Job::default()).unwrap();
            check(&net, what);
        }
    }
}

#[test]
fn fields() {
    let offsets: Vec<DVec3> =
        (0..27).map(|k| 0.1 * DVec3::new(f64::from(k % 5), f64::from(k % 7), f64::from(k % 3))).collect();
    let eye = DVec3::new(0.0, 0.0, 9.0);
    let fields: Vec<(&str, Box<dyn Field>)> = vec![
        ("twist", Box::new(field::twist(Axis::Z, 0.7, 0.1).unwrap())),
        ("taper", Box::new(field::taper(Axis::X, 0.3, 0.0).unwrap())),
        ("bend", Box::new(field::bend(Axis::Y, 0.4, -0.5, 1.0).unwrap())),
        ("shear", Box::new(field::shear(Axis::X, Axis::Z, 0.3).unwrap())),
        ("spherify", Box::new(field::spherify(DVec3::new(0.01, 0.02, 0.03), 2.0).unwrap())),
        ("cylinder wrap", Box::new(field::cylinder_wrap(Axis::Z, 0.8).unwrap())),
        ("torus wrap", Box::new(field::torus_wrap(Axis::Z, 2.0, 0.5).unwrap())),
        ("cone wrap", Box::new(field::cone_wrap(Axis::Z, 2.0, 0.5).unwrap())),
        ("sphere wrap", Box::new(field::sphere_wrap(Axis::Z, 2.0).unwrap())),
        ("lattice", Box::new(Lattice::new(DVec3::splat(-3.0), DVec3::splat(3.0), [3, 3, 3], &offsets).unwrap())),
        ("perspective", Box::new(field::perspective_projection(eye, DVec3::ZERO, DVec3::Z).unwrap())),
        ("parallel", Box::new(field::parallel_projection(DVec3::ZERO, DVec3::Z, DVec3::new(0.1, 0.2, 1.0)).unwrap())),
    ];
    for net in shapes() {
        for (what, field) in &fields {
            for strength in [1.0, 0.37] {
                let mut moved = net.copied().unwrap();
                deform(&mut moved, &[DeformationStep { field: field.as_ref(), strength }], &Job::default()).unwrap();
                check(&moved, what);
            }
        }
        let mut moved = net.copied().unwrap();
        displace_along_normals(&mut moved, 0.05, &Job::default()).unwrap();
        check(&moved, "displacement");
    }
}
