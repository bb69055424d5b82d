//! Soft and hard deformations: the two counterexamples to the paper's Jacobian criterion, gluings
//! found and absorbed, folds.

use crate::space::{glued_bits_agree, sheet, sphere, torus};
use glam::DVec3;
use gusset::mesh::Scalar;
use gusset::net::analyse::{analyse, analyse_field, contract_links, jacobian_by_central_differences};
use gusset::net::closure::{BoxKind, Cuboid};
use gusset::net::field::*;
use gusset::net::glue::{GlueOptions, find_gluing, set_gluing};
use gusset::net::primitive::{Primitive, Request};
use gusset::net::transform::{Affine, Axis, RotationSense, transform};
use gusset::net::*;
use gusset::{Element, Error, Job};
use std::f64::consts::TAU;

fn whole(field: &dyn Field) -> DeformationStep<'_> {
    DeformationStep { field, strength: 1.0 }
}

#[test]
fn a_determinant_of_zero_need_not_glue() {
    let net = sheet(9, 9, Scalar::F64);
    let flatten = Affine::stretching(DVec3::new(1.0, 1.0, 0.0)).unwrap();
    let found = analyse_field(&net, &[whole(&flatten)], 1e-9, &Job::default()).unwrap();
    assert!(found.determinants.iter().all(|&det| det == 0.0));
    assert!(found.is_soft() && found.contracted.is_empty());
    let inner = |link: usize| net.shape().joins_neighbours(link as u32);
    assert!(found.links.iter().enumerate().all(|(link, &ratio)| !inner(link) || ratio == 1.0));
}

#[test]
fn a_determinant_that_is_not_zero_can_glue() {
    let net = sheet(9, 9, Scalar::F64);
    let wrap = field::cylinder_wrap(Axis::Z, 8.0 / TAU).unwrap();
    // Rolled up about z, the sheet's rows are arcs at different distances.
    let stand = Affine::rotation(DVec3::X, TAU / 4.0, DVec3::ZERO, RotationSense::RightHanded).unwrap();
    let steps = [whole(&stand), whole(&wrap)];
    let found = analyse_field(&net, &steps, 1e-9, &Job::default()).unwrap();
    assert!(found.determinants.iter().all(|det| (det - 1.0).abs() < 1e-8), "lengths and heights are kept");
    assert!(!found.is_soft() && found.folded.is_empty() && found.torn.is_empty());
    let expected: Vec<u32> = (0..9).map(|i| 2 * net.shape().node(i, 8)).collect();
    assert_eq!(found.contracted.iter().map(|c| c.link).collect::<Vec<_>>(), expected, "9 of 9 closing links");
    // Seen from a node of the last column the contracted link is the one to the east.
    assert!(found.contracted.iter().all(|c| c.star.number() == 0));
    // Made part of the net, and exact.
    let mut rolled = net.copied().unwrap();
    deform(&mut rolled, &steps, &Job::default()).unwrap();
    let glued = contract_links(rolled.topology(), found.contracted.iter().map(|c| c.link), &Job::default()).unwrap();
    assert_eq!(glued.sides(), Some(Sides::TUBE));
    rolled.set_topology(glued);
    assert!(!glued_bits_agree(&rolled), "2 pi has no exact sine");
    // The same in one step, as a whole or not at all.
    let links: Vec<u32> = found.contracted.iter().map(|c| c.link).collect();
    let mut glued = sheet(9, 9, Scalar::F64);
    deform(&mut glued, &steps, &Job::default()).unwrap();
    let refused = GlueOptions { links: &[1, 2 * 81], saturate: true, ..GlueOptions::default() };
    let no_such = Error::NoSuch { element: Element::Link, index: 162, count: 162 };
    assert_eq!(find_gluing(&glued, &refused, &Job::default()).unwrap_err(), no_such);
    assert!(find_gluing(&glued, &GlueOptions::default(), &Job::default()).unwrap().is_none());
    let options = GlueOptions { links: &links, saturate: true, ..GlueOptions::default() };
    let topology = find_gluing(&glued, &options, &Job::default()).unwrap();
    assert_eq!(set_gluing(&mut glued, topology, true, &Job::default()), Ok(9), "the last node of each row moves");
    assert!(glued.topology().sides() == Some(Sides::TUBE) && glued_bits_agree(&glued));
    let detected = GlueOptions { detect: Some(1e-9), ..GlueOptions::default() };
    assert_eq!(find_gluing(&rolled, &detected, &Job::default()).unwrap().as_ref(), Some(glued.topology()));
    snap_glued_nodes(&mut rolled).unwrap();
    assert!(glued_bits_agree(&rolled));
    // With the unit pitch of the study's case the determinant is the pitch.
    let unit = Affine::stretching(DVec3::new(TAU / 8.0, 1.0, 1.0)).unwrap();
    let point = DVec3::new(3.0, 0.0, 0.0);
    let det = jacobian_by_central_differences(
        point,
        1.0,
        &[whole(&unit), whole(&field::cylinder_wrap(Axis::Z, 1.0).unwrap())],
    )
    .0
    .determinant();
    assert!((det - TAU / 8.0).abs() < 1e-8);
}

#[test]
fn poles_and_collapsed_cells_are_found_with_their_types() {
    let net = sheet(5, 6, Scalar::F64);
    // The first row to a point; the cell at (2, 2) to another.
    let after = Net::from_fn(net.topology().clone(), Scalar::F64, |i, j| match (i, j) {
        (0, _) => DVec3::new(2.5, 0.0, 0.0),
        (2..=3, 2..=3) => DVec3::new(2.5, 2.5, 0.0),
        _ => net.get(i, j),
    })
    .unwrap();
    let found = analyse(&net, &after, 0.0, &Job::default()).unwrap();
    let shape = net.shape();
    let type_at = |link: u32| found.contracted.iter().find(|c| c.link == link).map(|c| c.star.number());
    // The row's closing link is contracted too, so that every star of the row is glued east and
    // west.
    assert!((0..6).all(|j| type_at(2 * shape.node(0, j)) == Some(6)));
    // The corners of the cell: east and south, south and west, north and east.
    assert_eq!(type_at(2 * shape.node(2, 2)), Some(2));
    assert_eq!(type_at(2 * shape.node(2, 2) + 1), Some(2));
    assert_eq!(type_at(2 * shape.node(2, 3) + 1), Some(3));
    assert_eq!(type_at(2 * shape.node(3, 2)), Some(5));
    assert_eq!(found.contracted.len(), 6 + 4);
    assert_eq!(found.cells[shape.cell(2, 2) as usize], 0.0);
    // Once absorbed nothing is new.
    let glued = contract_links(net.topology(), found.contracted.iter().map(|c| c.link), &Job::default()).unwrap();
    let classes = NodeClasses::new(&glued).unwrap();
    assert_eq!(classes.representative(shape.node(3, 3)), shape.node(2, 2));
    let mut again = net.copied().unwrap();
    again.set_topology(glued);
    assert!(analyse(&again, &after, 0.0, &Job::default()).unwrap().contracted.is_empty());
    assert_eq!(
        contract_links(net.topology(), [60], &Job::default()).unwrap_err(),
        Error::NoSuch { element: Element::Link, index: 60, count: 60 }
    );
}

#[test]
fn glued_links_that_come_apart_are_torn() {
    let before = sphere(9, 13, Scalar::F64);
    let mut after = before.copied().unwrap();
    after.coordinates_mut().set(4, 12, DVec3::new(2.0, 0.0, 0.0));
    let found = analyse(&before, &after, 1e-9, &Job::default()).unwrap();
    assert_eq!(found.torn, [2 * before.shape().node(4, 12)]);
    assert!(!found.is_soft());
}

#[test]
fn smooth_deformations_are_soft_and_areas_grow_as_they_should() {
    for net in [sphere(17, 33, Scalar::F32), torus(17, 33, Scalar::F64), sheet(17, 33, Scalar::F64)] {
        let twist = field::twist(Axis::Z, 0.3, 0.0).unwrap();
        let bend = field::bend(Axis::X, 0.02, -1.0, 40.0).unwrap();
        let found = analyse_field(&net, &[whole(&twist), whole(&bend)], 1e-6, &Job::default()).unwrap();
        assert!(found.is_soft(), "{:?}", net.topology().sides());
        let scale = Affine::scaling(-3.0).unwrap();
        let found = analyse_field(&net, &[whole(&scale)], 1e-6, &Job::default()).unwrap();
        assert!(found.is_soft(), "all of space is mirrored, which folds nothing");
        assert!(found.cells.iter().all(|&ratio| ratio.is_nan() || (ratio + 9.0).abs() < 1e-4));
        assert!(found.determinants.iter().all(|&det| (det + 27.0).abs() < 1e-5));
        // Half a turn is not a fold, with the field or without.
        let mut turned = net.copied().unwrap();
        let turn = Affine::rotation(DVec3::X, 3.0, DVec3::ZERO, RotationSense::RightHanded).unwrap();
        deform(&mut turned, &[whole(&turn)], &Job::default()).unwrap();
        assert!(analyse(&net, &turned, 1e-6, &Job::default()).unwrap().is_soft());
    }
}

/// Space folded over at x = 20.
struct Fold;
impl Field for Fold {
    fn map_points(&self, _: f64, [x, ..]: PointsMut<'_>) {
        x.iter_mut().for_each(|x| *x = 20.0 - (*x - 20.0).abs());
    }
}

#[test]
fn folds_are_found_with_the_field_and_without() {
    let net = sheet(9, 31, Scalar::F64);
    let found = analyse_field(&net, &[whole(&Fold)], 1e-9, &Job::default()).unwrap();
    let over: Vec<u32> = (0..8).flat_map(|i| (20..30).map(move |j| i * 30 + j)).collect();
    assert_eq!(found.folded, over);
    assert!(found.contracted.is_empty() && !found.is_soft());
    assert!((0..240).all(|cell| found.cells[cell as usize] == if over.contains(&cell) { -1.0 } else { 1.0 }));
    let mut after = net.copied().unwrap();
    deform(&mut after, &[whole(&Fold)], &Job::default()).unwrap();
    let found = analyse(&net, &after, 1e-9, &Job::default()).unwrap();
    assert_eq!(found.folded, over);
    // Where most is turned over, the rest is what differs.
    let mut shifted = net.copied().unwrap();
    let shift = Affine::translation(DVec3::new(12.0, 0.0, 0.0)).unwrap();
    deform(&mut shifted, &[whole(&shift), whole(&Fold)], &Job::default()).unwrap();
    assert_eq!(analyse(&net, &shifted, 1e-9, &Job::default()).unwrap().folded.len(), 8 * 8);
}

#[test]
fn bad_tolerances_and_sizes_are_refused() {
    let (a, b) = (sheet(4, 5, Scalar::F32), sheet(5, 4, Scalar::F32));
    assert!(matches!(analyse(&a, &b, 0.0, &Job::default()), Err(Error::SidesDiffer { .. })));
    for tolerance in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(analyse(&a, &a, tolerance, &Job::default()), Err(Error::OptionOutOfRange { .. })));
    }
    let mut holed = sheet(4, 5, Scalar::F32);
    holed.coordinates_mut().set(1, 1, DVec3::NAN);
    let found = analyse(&holed, &holed, 0.0, &Job::default()).unwrap();
    assert!(found.is_soft() && found.cells[0].is_nan() && found.cells[11] == 1.0);
}

/// Closed and open surfaces, flat and curved.
fn surfaces(scalar: Scalar) -> Vec<Net<'static>> {
    let cube = Cuboid::cube(BoxKind::Slit, 4);
    [
        Primitive::Cuboid { cuboid: cube, size: [1.0; 3] },
        Primitive::Sphere { radius: 1.0 },
        Primitive::OnePoleSphere { radius: 2.0 },
        Primitive::Cylinder { radius: 1.0, height: 3.0 },
        Primitive::Klein { radius: 3.0, minor_radius: 1.0 },
        Primitive::Pillow { size: [2.0, 1.0], thickness: 0.5 },
    ]
    .map(|primitive| Request { primitive, rows: 33, columns: 65, scalar }.build_net(&Job::default()).unwrap())
    .into()
}

fn moved(net: &Net<'_>, by: &Affine) -> Net<'static> {
    let mut after = net.copied().unwrap();
    transform(&mut after, by, &Job::default()).unwrap();
    after
}

#[test]
fn affine_maps_with_an_inverse_fold_nothing() {
    for scalar in [Scalar::F32, Scalar::F64] {
        let tolerance = if scalar == Scalar::F32 { 1e-5 } else { 1e-9 };
        for (k, net) in surfaces(scalar).iter().enumerate() {
            let soft = |a: &Net<'_>, b: &Net<'_>| {
                let found = analyse(a, b, tolerance, &Job::default()).unwrap();
                assert!(found.is_soft(), "{scalar:?} {k}: {} folded", found.folded.len());
                assert!(found.cells.iter().all(|&ratio| ratio.is_nan() || ratio >= 0.0));
            };
            // Rigid motions, between two places too.
            for turn in 1..6 {
                let t = f64::from(turn);
                let axis = DVec3::new(t.sin(), t.cos(), 0.5);
                let rotation = |angle| Affine::rotation(axis, angle, DVec3::ONE, RotationSense::RightHanded).unwrap();
                soft(net, &moved(net, &rotation(t)));
                soft(&moved(net, &rotation(0.7 * t)), &moved(net, &rotation(2.3 * t)));
            }
            for ratios in [[3.0, 1.0, 1.0], [1.0, 1.0, 3.0], [1.0, 1.0, 1.0 / 30.0], [1.0, -0.1, 5.0], [-1.0; 3]] {
                let stretch = Affine::stretching(DVec3::from_array(ratios)).unwrap();
                let shear =
                    Affine::rotation(DVec3::ONE, 1.0, DVec3::ZERO, RotationSense::RightHanded).unwrap().then(&stretch);
                soft(net, &moved(net, &stretch));
                soft(net, &moved(net, &shear.unwrap()));
                assert!(analyse_field(net, &[whole(&stretch)], tolerance, &Job::default()).unwrap().is_soft());
            }
        }
    }
}

#[test]
fn folds_are_found_in_any_plane_and_within_cells() {
    let turn = Affine::rotation(DVec3::new(1.0, 2.0, 0.5), 2.0, DVec3::ZERO, RotationSense::RightHanded).unwrap();
    for scalar in [Scalar::F32, Scalar::F64] {
        let net = sheet(9, 31, scalar);
        let made = |place: &dyn Fn(usize, usize) -> DVec3| {
            let after = Net::from_fn(net.topology().clone(), scalar, place).unwrap();
            analyse(&net, &moved(&after, &turn), 1e-5, &Job::default()).unwrap()
        };
        // A roof is none, and so is one nearly shut; shut it is.
        for (height, count) in [(1.0, 0), (0.01, 0), (0.0, 8 * 10)] {
            let found = made(&|i, j| {
                let past = (j as f64 - 20.0).max(0.0);
                DVec3::new(j as f64 - 2.0 * past, i as f64, height * past)
            });
            assert_eq!(found.folded.len(), count, "{scalar:?} {height}");
        }
        // Row 4 moved past row 3: the cells between them are turned over.
        let found = made(&|i, j| DVec3::new(j as f64, if i == 4 { 2.5 } else { i as f64 }, 0.0));
        assert_eq!(found.folded, (90..120).collect::<Vec<u32>>());
        assert!((90..120).all(|cell| found.cells[cell] < 0.0));
        // A node moved past its neighbour: the sides of two cells cross.
        let found = made(&|i, j| DVec3::new(j as f64, if (i, j) == (4, 7) { 2.5 } else { i as f64 }, 0.0));
        assert!(found.folded.contains(&96) && found.folded.contains(&97), "{:?}", found.folded);
        assert!(!found.is_soft() && found.folded.iter().all(|&cell| (60..120).contains(&cell)));
    }
    // A flattened tube lies on itself; so does a sphere, for any determinant of the field.
    let flat = Affine::stretching(DVec3::new(1.0, 1.0, 0.0)).unwrap();
    let ball = sphere(32, 65, Scalar::F64);
    let found = analyse(&ball, &moved(&ball, &flat), 1e-9, &Job::default()).unwrap();
    assert!(!found.is_soft());
    let ball = sphere(33, 65, Scalar::F64);
    for found in [
        analyse(&ball, &moved(&ball, &flat), 1e-9, &Job::default()).unwrap(),
        analyse_field(&ball, &[whole(&flat)], 1e-9, &Job::default()).unwrap(),
    ] {
        assert_eq!(found.folded.len(), 16 * 64, "one half");
    }
}

#[test]
fn determinants_that_are_rounding_are_no_folds() {
    let normal = DVec3::new(0.3, -0.2, 1.0);
    for scalar in [Scalar::F32, Scalar::F64] {
        let net = sheet(17, 17, scalar);
        for (point, normal) in [(DVec3::ZERO, normal), (DVec3::new(1e3, -7e2, 5.0), normal), (DVec3::ZERO, DVec3::ONE)]
        {
            let project = field::parallel_projection(point, normal, normal).unwrap();
            let found = analyse_field(&net, &[whole(&project)], 1e-9, &Job::default()).unwrap();
            assert!(found.is_soft() && found.determinants.iter().all(|&det| det == 0.0));
            assert!(found.cells.iter().all(|&ratio| ratio > 0.0));
        }
    }
}
