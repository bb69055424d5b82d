//! Soft and hard deformations: the two counterexamples to the paper's Jacobian criterion, gluings found and absorbed, folds.

mod space;

use glam::DVec3;
use gusset::mesh::Scalar;
use gusset::net::analyse::{absorb, analyse, analyse_field, jacobian};
use gusset::net::field::*;
use gusset::net::transform::{Affine, Axis, Sense};
use gusset::net::*;
use gusset::{Error, Job};
use space::{glued_bits_agree, sheet, sphere, torus};
use std::f64::consts::TAU;

fn whole(field: &dyn Field) -> Step<'_> {
    Step { field, strength: 1.0 }
}

#[test]
fn a_determinant_of_zero_need_not_glue() {
    let net = sheet(9, 9, Scalar::F64);
    let flatten = Affine::stretching(DVec3::new(1.0, 1.0, 0.0)).unwrap();
    let found = analyse_field(&net, &[whole(&flatten)], 1e-9, &Job::default()).unwrap();
    assert!(found.determinants.iter().all(|&det| det == 0.0));
    assert!(found.is_soft() && found.contracted.is_empty());
    let inner = |link: usize| net.shape().is_inner(link as u32);
    assert!(found.links.iter().enumerate().all(|(link, &ratio)| !inner(link) || ratio == 1.0));
}

#[test]
fn a_determinant_that_is_not_zero_can_glue() {
    let net = sheet(9, 9, Scalar::F64);
    let wrap = CylinderWrap::new(Axis::Z, 8.0 / TAU).unwrap();
    // Rolled up about z, the sheet's rows are arcs at different distances.
    let stand = Affine::rotation(DVec3::X, TAU / 4.0, DVec3::ZERO, Sense::RightHanded).unwrap();
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
    let glued = absorb(rolled.topology(), found.contracted.iter().map(|c| c.link)).unwrap();
    assert_eq!(glued.sides(), Some(Sides::TUBE));
    rolled.set_topology(glued);
    assert!(!glued_bits_agree(&rolled), "2 pi has no exact sine");
    snap(&mut rolled).unwrap();
    assert!(glued_bits_agree(&rolled));
    // With the unit pitch of the study's case the determinant is the pitch.
    let unit = Affine::stretching(DVec3::new(TAU / 8.0, 1.0, 1.0)).unwrap();
    let point = DVec3::new(3.0, 0.0, 0.0);
    let det = jacobian(point, 1.0, &[whole(&unit), whole(&CylinderWrap::new(Axis::Z, 1.0).unwrap())]).determinant();
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
    // The row's closing link is contracted too, so that every star of the row is glued east and west.
    assert!((0..6).all(|j| type_at(2 * shape.node(0, j)) == Some(6)));
    // The corners of the cell: east and south, south and west, north and east.
    assert_eq!(type_at(2 * shape.node(2, 2)), Some(2));
    assert_eq!(type_at(2 * shape.node(2, 2) + 1), Some(2));
    assert_eq!(type_at(2 * shape.node(2, 3) + 1), Some(3));
    assert_eq!(type_at(2 * shape.node(3, 2)), Some(5));
    assert_eq!(found.contracted.len(), 6 + 4);
    assert_eq!(found.cells[shape.cell(2, 2) as usize], 0.0);
    // Once absorbed nothing is new.
    let glued = absorb(net.topology(), found.contracted.iter().map(|c| c.link)).unwrap();
    let classes = Classes::of(&glued).unwrap();
    assert_eq!(classes.representative(shape.node(3, 3)), shape.node(2, 2));
    let mut again = net.copied().unwrap();
    again.set_topology(glued);
    assert!(analyse(&again, &after, 0.0, &Job::default()).unwrap().contracted.is_empty());
    assert_eq!(absorb(net.topology(), [60]).unwrap_err(), Error::NoSuchLink { link: 60 });
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
        let twist = Twist::new(Axis::Z, 0.3, 0.0).unwrap();
        let bend = Bend::new(Axis::X, 0.02, -1.0, 40.0).unwrap();
        let found = analyse_field(&net, &[whole(&twist), whole(&bend)], 1e-6, &Job::default()).unwrap();
        assert!(found.is_soft(), "{:?}", net.topology().sides());
        let scale = Affine::scaling(-3.0).unwrap();
        let found = analyse_field(&net, &[whole(&scale)], 1e-6, &Job::default()).unwrap();
        assert!(found.is_soft(), "all of space is mirrored, which folds nothing");
        assert!(found.cells.iter().all(|&ratio| ratio.is_nan() || (ratio + 9.0).abs() < 1e-4));
        assert!(found.determinants.iter().all(|&det| (det + 27.0).abs() < 1e-5));
        // Half a turn is no fold, with the field or without.
        let mut turned = net.copied().unwrap();
        let turn = Affine::rotation(DVec3::X, 3.0, DVec3::ZERO, Sense::RightHanded).unwrap();
        deform(&mut turned, &[whole(&turn)], &Job::default()).unwrap();
        assert!(analyse(&net, &turned, 1e-6, &Job::default()).unwrap().is_soft());
    }
}

/// Space folded over at x = 20.
struct Fold;
impl Field for Fold {
    fn map(&self, _: f64, [x, ..]: Points<'_>) {
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
