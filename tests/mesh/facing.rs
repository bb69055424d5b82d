//! Algorithm 2: which vertices of two loops face each other, on the cases where the printed text
//! works and where it cannot.

use crate::common::Soup;
use glam::{DMat3, DVec3};
use gusset::stitch::facing::{self, Arc, Centres, Facing, Planes, Run, centre, squareness};
use gusset::stitch::{Extent, Options, Request, stitch};
use gusset::{Component, Element, Error, Job, Side};
use std::f64::consts::{PI, TAU};

fn facing(a: &[DVec3], b: &[DVec3], tolerance: Option<f64>, run: Run) -> Result<Facing, Error> {
    facing::facing(a, b, &facing::Options { run, tolerance, ..facing::Options::default() }, &Job::default())
}

/// A circle of `n` vertices in the plane z = 0, the first at angle `phase`.
fn circle(n: usize, radius: f64, phase: f64, at: DVec3) -> Vec<DVec3> {
    let angle = |i| phase + TAU * i as f64 / n as f64;
    (0..n).map(|i| at + radius * DVec3::new(f64::cos(angle(i)), f64::sin(angle(i)), 0.0)).collect()
}

/// The paper's steps 4 and 5 as printed: the sign alone.
fn printed(points: &[DVec3], own: DVec3, other: DVec3) -> Vec<bool> {
    points.iter().map(|&p| (p - own).dot(other - own) > 0.0).collect()
}

fn runs(flags: &[bool]) -> usize {
    (0..flags.len()).filter(|&i| flags[i] && !flags[(i + flags.len() - 1) % flags.len()]).count()
}

#[test]
fn side_by_side() {
    // Figure 3: half of each circle, in one run. No vertex lies on a plane.
    let (a, b) = (circle(60, 1.0, TAU / 120.0, DVec3::ZERO), circle(40, 0.7, TAU / 80.0, DVec3::X * 3.0));
    let found = facing(&a, &b, Some(1e-12), Run::Closest).unwrap();
    assert_eq!((found.runs[0].len(), found.runs[1].len()), (1, 1));
    // A's right half: vertices -15 .. 14 round angle 0; B's left half: 10 .. 29.
    assert_eq!(found.taken, [Arc { first: 45, count: 30 }, Arc { first: 10, count: 20 }]);
    assert!((found.planes.centres[1] - DVec3::X * 3.0).length() < 1e-15);
    assert_eq!(found.planes.normals[0], -found.planes.normals[1]);
    for (i, p) in a.iter().enumerate() {
        let taken = found.taken[0].places(60).any(|k| k == i);
        assert_eq!(taken, p.x > 0.0);
        assert!((found.planes.distance(Side::A, *p) - p.x).abs() < 1e-14);
    }
    // With vertices exactly on the planes round-off decides nothing: they are left out.
    let (a, b) = (circle(60, 1.0, 0.0, DVec3::ZERO), circle(40, 0.7, 0.0, DVec3::X * 3.0));
    let found = facing(&a, &b, Some(1e-12), Run::Closest).unwrap();
    assert_eq!(found.taken, [Arc { first: 46, count: 29 }, Arc { first: 11, count: 19 }]);
}

#[test]
fn a_tolerance_narrows_the_arc() {
    let (a, b) = (circle(60, 1.0, TAU / 120.0, DVec3::ZERO), circle(60, 1.0, TAU / 120.0, DVec3::X * 3.0));
    let found = facing(&a, &b, Some(0.5), Run::Closest).unwrap();
    assert_eq!(found.taken[0].count, a.iter().filter(|p| p.x > 0.5).count());
    assert_eq!(facing(&a, &b, Some(1.0), Run::Closest), Err(Error::PlanesUndecided { side: Side::A }));
}

#[test]
fn coaxial_rims_lie_in_their_planes() {
    // Erratum 6: the printed sign is round-off, in runs without meaning; here the answer is that
    // there is none.
    let (a, b) = (circle(60, 1.0, 0.0, DVec3::ZERO), circle(40, 1.0, 0.3, DVec3::Z * 2.0));
    assert_eq!(facing(&a, &b, Some(1e-12), Run::Closest), Err(Error::PlanesUndecided { side: Side::A }));
    let tilt = DMat3::from_rotation_y(0.7) * DMat3::from_rotation_x(1.1);
    let turned = |points: &[DVec3]| points.iter().map(|&p| tilt * p).collect::<Vec<_>>();
    let (a, b) = (turned(&a), turned(&b));
    assert_eq!(facing(&a, &b, Some(1e-12), Run::Closest), Err(Error::PlanesUndecided { side: Side::A }));
    let (own, other) = (centre(&a), centre(&b));
    let noise = printed(&a, own, other);
    assert!(noise.contains(&true) && noise.contains(&false), "the printed rule selects some");
    assert!(a.iter().all(|&p| (p - own).dot((other - own).normalize()).abs() < 1e-15), "of vertices all on the plane");
}

#[test]
fn concentric_rims_have_no_direction() {
    let (a, b) = (circle(60, 2.0, 0.0, DVec3::ZERO), circle(40, 1.0, 0.3, DVec3::ZERO));
    assert_eq!(facing(&a, &b, Some(1e-12), Run::Longest), Err(Error::PlanesUndecided { side: Side::A }));
    assert_eq!(squareness(&a, &Planes::new(&a, &a, Centres::Vertices)), 0.0);
}

/// A thick letter C, open towards +x, of `n` steps along each side.
fn letter_c(n: usize) -> Vec<DVec3> {
    let at = |r: f64, t: f64| r * DVec3::new(t.cos(), t.sin(), 0.0);
    let angle = |i: usize| 0.5 + (TAU - 1.0) * i as f64 / (n - 1) as f64;
    (0..n).map(|i| at(2.0, angle(i))).chain((0..n).rev().map(|i| at(1.5, angle(i)))).collect()
}

#[test]
fn a_letter_c_has_two_runs() {
    let c = letter_c(60);
    let b = circle(40, 0.5, TAU / 80.0, DVec3::X * 3.0 + DVec3::Y * 1.2);
    let own = centre(&c);
    let flags = printed(&c, own, centre(&b));
    assert_eq!(runs(&flags), 2, "the printed rule gives no polyline");
    let [closest, longest] = [Run::Closest, Run::Longest].map(|run| facing(&c, &b, Some(1e-12), run).unwrap());
    assert_eq!(closest.runs[0].len(), 2);
    assert_eq!(closest.runs[0].iter().map(|run| run.count).sum::<usize>(), flags.iter().filter(|&&f| f).count());
    // B is beside the upper arm: the run with the closest pair lies there.
    assert!(closest.taken[0].places(c.len()).all(|i| c[i].y > -0.5));
    let count = longest.runs[0].iter().map(|run| run.count).max();
    assert_eq!(Some(longest.taken[0].count), count);
}

/// A flat ring of faces between a rim and the same rim grown, so that the rim is its inner loop; or
/// a tube.
fn piece(rim: &[DVec3], away: DVec3, grow: f64) -> Soup {
    let n = rim.len() as u32;
    let middle = centre(rim);
    let outer = rim.iter().map(|&p| middle + (p - middle) * grow + away);
    let points = rim.iter().copied().chain(outer).map(|p| p.to_array()).collect();
    let mut soup = Soup { points, offsets: vec![0], corners: Vec::new() };
    for i in 0..n {
        let j = (i + 1) % n;
        soup.face(&[i, j, n + j, n + i]);
    }
    soup
}

#[test]
fn auto_chooses_by_geometry() {
    let names = |n: usize| (0..n as u32).collect::<Vec<_>>();
    let auto = |a: &[DVec3], away_a: DVec3, b: &[DVec3], away_b: DVec3| {
        let (p, q) = (piece(a, away_a, 1.0), piece(b, away_b, 1.0));
        let (loop_a, loop_b) = (names(a.len()), names(b.len()));
        let (p, q) = (p.view(), q.view());
        let request = Request { a: &p, loop_a: Some(&loop_a), b: Some(&q), loop_b: Some(&loop_b) };
        stitch(&request, &Options { extent: Extent::Auto, ..Options::default() }, &Job::default()).unwrap()
    };
    let (low, high) = (circle(60, 1.0, 0.0, DVec3::ZERO), circle(40, 1.0, 0.3, DVec3::Z * 2.0));
    assert!(auto(&low, -DVec3::Z, &high, DVec3::Z).closed, "coaxial");
    let tilt = DMat3::from_rotation_x(PI / 6.0);
    let tilted: Vec<_> = high.iter().map(|&p| tilt * p).collect();
    assert!(auto(&low, -DVec3::Z, &tilted, DVec3::Z).closed, "tilted");
    let inner = circle(40, 0.5, 0.3, DVec3::ZERO);
    assert!(auto(&low, -DVec3::Z, &inner, -DVec3::Z).closed, "concentric");
    let beside = circle(40, 0.7, 0.3, DVec3::X * 3.0);
    let joined = auto(&low, -DVec3::Z, &beside, -DVec3::Z);
    assert!(!joined.closed, "side by side");
    assert_eq!(joined.rims.each_ref().map(Vec::len), [29, 20]);
    assert_eq!((joined.quality.orientation_conflicts, joined.quality.non_manifold_edges), (0, 0));
    let c = auto(&letter_c(60), -DVec3::Z, &beside, -DVec3::Z);
    assert!(!c.closed, "C-shape");
}

#[test]
fn open_arcs_that_cannot_be_told_are_an_error() {
    let (low, high) = (circle(60, 1.0, 0.0, DVec3::ZERO), circle(40, 1.0, 0.3, DVec3::Z * 2.0));
    let (p, q) = (piece(&low, -DVec3::Z, 1.0), piece(&high, DVec3::Z, 1.0));
    let (p, q) = (p.view(), q.view());
    let names = |n: u32| (0..n).collect::<Vec<_>>();
    let (loop_a, loop_b) = (names(60), names(40));
    let request = Request { a: &p, loop_a: Some(&loop_a), b: Some(&q), loop_b: Some(&loop_b) };
    let options = Options { extent: Extent::OpenArcs, ..Options::default() };
    assert_eq!(stitch(&request, &options, &Job::default()), Err(Error::PlanesUndecided { side: Side::A }));
    for tolerance in [f64::NAN, -1.0, f64::INFINITY] {
        let options = Options { tolerance: Some(tolerance), ..options };
        let refused = stitch(&request, &options, &Job::default());
        assert!(matches!(refused, Err(Error::OptionOutOfRange { option: "tolerance", .. })));
    }
}

#[test]
fn any_unit_will_do_and_bad_numbers_are_refused() {
    let (a, b) = (circle(60, 1.0, TAU / 120.0, DVec3::ZERO), circle(40, 0.7, TAU / 80.0, DVec3::X * 3.0));
    let expected = facing(&a, &b, None, Run::Closest).unwrap();
    for exponent in [-900, -300, 300, 900] {
        let unit = 2f64.powi(exponent);
        let scaled = |points: &[DVec3]| points.iter().map(|&p| p * unit).collect::<Vec<_>>();
        let found = facing(&scaled(&a), &scaled(&b), None, Run::Closest).unwrap();
        assert_eq!((&found.runs, found.taken), (&expected.runs, expected.taken));
        assert_eq!(found.planes.normals[0], expected.planes.normals[0] * unit);
        assert_eq!(found.distances[1][7], expected.distances[1][7] * unit);
    }
    assert_eq!(facing(&a, &[], None, Run::Closest), Err(Error::LoopTooShort { side: Side::B, count: 0 }));
    let mut bad = b.clone();
    bad[3].y = f64::INFINITY;
    assert_eq!(
        facing(&a, &bad, None, Run::Closest),
        Err(Error::NotFinite {
            element: Element::LoopPoint(Side::B),
            index: 3,
            component: Component::Y,
            value: f64::INFINITY
        })
    );
    let refused = facing(&a, &b, Some(-1.0), Run::Closest);
    assert!(matches!(refused, Err(Error::OptionOutOfRange { option: "tolerance", value: -1.0, .. })));
}

#[test]
fn the_first_of_equally_long_runs_is_taken() {
    // A cross: two arms of equal length reach over to the other loop.
    let arm = |y: f64| [[2.0, y - 0.5, 0.0], [2.0, y, 0.0], [2.0, y + 0.5, 0.0]].map(DVec3::from_array);
    let gap = |y: f64| [DVec3::new(-2.0, y, 0.0)];
    let a = [&arm(-2.0)[..], &gap(0.0), &arm(2.0), &gap(2.6), &gap(-2.6)].concat();
    let b = circle(12, 1.0, 0.1, DVec3::X * 8.0);
    let found = facing(&a, &b, None, Run::Longest).unwrap();
    assert_eq!(found.runs[0], [Arc { first: 0, count: 3 }, Arc { first: 4, count: 3 }]);
    assert_eq!(found.taken[0], Arc { first: 0, count: 3 });
}

#[test]
fn wavy_coaxial_rims_are_joined_whole() {
    // Their vertices lie well off the planes, on both sides by turns: only the loops' normals tell.
    let wavy = |n: usize, z: f64| -> Vec<DVec3> {
        let lift = |i: usize| DVec3::Z * (z + if i.is_multiple_of(2) { 0.2 } else { -0.2 });
        circle(n, 1.0, 0.0, DVec3::ZERO).into_iter().enumerate().map(|(i, p)| p + lift(i)).collect()
    };
    let (low, high) = (wavy(24, 0.0), wavy(30, 2.0));
    assert_eq!(facing(&low, &high, None, Run::Longest).unwrap().runs[0].len(), 12);
    let (p, q) = (piece(&low, -DVec3::Z, 1.0), piece(&high, DVec3::Z, 1.0));
    let (p, q) = (p.view(), q.view());
    let names = |n: u32| (0..n).collect::<Vec<_>>();
    let (loop_a, loop_b) = (names(24), names(30));
    let request = Request { a: &p, loop_a: Some(&loop_a), b: Some(&q), loop_b: Some(&loop_b) };
    let options = Options { extent: Extent::Auto, ..Options::default() };
    let joined = stitch(&request, &options, &Job::default()).unwrap();
    assert!(joined.closed);
    assert_eq!(joined.rims.each_ref().map(Vec::len), [24, 30]);
}

#[test]
fn a_centre_by_length_is_not_drawn_to_crowded_vertices() {
    // Half of the circle has ten times as many vertices as the other half.
    let angles = (0..200).map(|i| PI * f64::from(i) / 200.0).chain((0..20).map(|i| PI + PI * f64::from(i) / 20.0));
    let crowded: Vec<_> = angles.map(|t| DVec3::new(t.cos(), t.sin(), 0.0)).collect();
    let other = circle(64, 1.0, 0.0, DVec3::new(3.0, 0.0, 0.0));
    let planes = |centres| Planes::new(&crowded, &other, centres);
    assert!(planes(Centres::Vertices).centres[0].y > 0.4);
    // The polygon is 1 / 400 thinner on the coarse side, no more.
    assert!(planes(Centres::Length).centres[0].length() < 0.01);
    let options = facing::Options { centres: Centres::Length, ..facing::Options::default() };
    let found = facing::facing(&crowded, &other, &options, &Job::default()).unwrap();
    assert_eq!(found.planes, planes(Centres::Length));
    assert!(found.runs.iter().all(|runs| runs.len() == 1));
}
