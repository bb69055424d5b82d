//! Gaps that assembly closes: between whole loops, round twisted rings and between pipes.

use crate::assemble::{assert_closed, filling, run, sides, volume_of, with_gaps};
use crate::common::{Soup, euler, faces_of, sheet, torus, volume};
use crate::pieces::{around, cube, cut, shrunk, sphere};
use gusset::Job;
use gusset::assemble::{MaxGap, Options, Outcome};
use gusset::check::check;
use gusset::stitch::{self, Fairing, Rows};
use std::f64::consts::TAU;

#[test]
fn gaps_between_whole_loops_are_closed() {
    let rows = stitch::Options { rows: Rows::Count(2), fairing: Fairing::ThinPlate, ..stitch::Options::default() };
    for (pieces, chi, gaps) in with_gaps() {
        for strip in [stitch::Options::default(), rows] {
            let done = run(&pieces, &Options { strip, ..Options::default() });
            assert_closed(&done, chi);
            assert_eq!(done.joints.len(), gaps);
            assert!(done.joints.iter().all(|joint| joint.whole && joint.outcome == Outcome::Joined));
            assert!(done.left.is_empty() && volume_of(&done) > 0.0 && !done.turned.contains(&true));
            assert!(done.joints.windows(2).all(|pair| pair[0].gap <= pair[1].gap), "nearest first");
            assert!(done.joints.iter().all(|joint| joint.intersections.as_deref().unwrap_or_default().is_empty()));
        }
    }
}

#[test]
fn gaps_that_meet_in_corners_are_closed_and_filled() {
    let octants = |p: [f64; 3]| Some((0..3).map(|k| usize::from(p[k] > 0.0) << k).sum());
    let sixths = |p: [f64; 3]| Some((around(p) * 3.0) as usize + 3 * usize::from(p[2] > 0.0));
    for (whole, pieces) in [
        (cube(8), cut(&cube(8), octants)),
        (sphere(24, 15), cut(&sphere(24, 15), octants)),
        (sphere(24, 15), cut(&sphere(24, 15), sixths)),
        (torus(24, 16), cut(&torus(24, 16), sixths)),
    ] {
        let pieces = shrunk(pieces, 0.04);
        let open = run(&pieces, &Options::default());
        assert!(open.joints.iter().all(|joint| !joint.whole && joint.outcome == Outcome::Joined));
        let done = run(&pieces, &filling());
        assert_closed(&done, euler(whole.faces()));
        let (before, after) = (volume(|v| whole.points[v as usize], whole.faces()), volume_of(&done));
        assert!((after / before - 1.0).abs() < 0.2, "{before} {after}");
        // Turned pieces agree with the first one here too.
        let turned: Vec<Soup> =
            pieces.iter().enumerate().map(|(k, p)| if k % 3 == 1 { p.turned() } else { p.clone() }).collect();
        assert_eq!(sides(&run(&turned, &Options::default())), sides(&open), "the same arcs, turned or not");
        let again = run(&turned, &filling());
        assert_closed(&again, euler(whole.faces()));
        assert!((volume_of(&again) / after - 1.0).abs() < 0.02);
    }
}

/// `n` bands of w x l cells round a ring, which is twisted by `half_turns` on the way, with gaps of
/// `gap` of their length.
fn twisted_ring(n: u32, half_turns: u32, gap: f64) -> Vec<Soup> {
    let (w, l) = (4, 4);
    let piece = |k: u32| {
        let mut soup = sheet(l, w);
        for p in &mut soup.points {
            let along = (f64::from(k) + (1.0 - gap) * p[0] / f64::from(l)) / f64::from(n);
            let (t, twist) = (TAU * along, 0.5 * TAU * f64::from(half_turns) * along);
            let across = (p[1] / f64::from(w) - 0.5) * 0.8;
            let radius = 2.0 + across * twist.cos();
            *p = [radius * t.cos(), radius * t.sin(), across * twist.sin()];
        }
        soup
    };
    (0..n).map(piece).collect()
}

#[test]
fn a_ring_with_a_twist_keeps_one_gap() {
    for n in [3, 6, 9] {
        for half_turns in 0..4 {
            let pieces = twisted_ring(n, half_turns, 0.05);
            for k in 0..pieces.len() {
                let mut given = pieces.clone();
                given[k] = given[k].turned();
                let done = run(&given, &Options::default());
                assert_eq!(done.joints.len(), n as usize, "{n} {half_turns}");
                let refused = done.joints.iter().filter(|j| j.outcome == Outcome::OrientationConflict).count();
                assert_eq!(refused, half_turns as usize % 2, "{n} {half_turns} {k}");
                let found = check(&done.mesh.view(&Job::default()).unwrap(), &Job::default()).unwrap();
                assert!(found.manifold && found.oriented && found.components == 1);
                // A band is an annulus, and with one gap left a disc.
                assert_eq!(found.euler, i64::from(half_turns % 2));
            }
        }
    }
}

/// A pipe, or half of one: `n` x 6 quads round `span` of the circle of radius `r` about the
/// x-shifted z-axis, outside out.
fn pipe(n: u32, span: std::ops::Range<f64>, r: f64, shift: f64, z: std::ops::Range<f64>) -> Soup {
    let closed = span.end - span.start > TAU - 1e-9;
    let columns = if closed { n } else { n + 1 };
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    for k in 0..7 {
        for i in 0..columns {
            let t = span.start + (span.end - span.start) * f64::from(i) / f64::from(n);
            soup.points.push([shift + r * t.cos(), r * t.sin(), z.start + (z.end - z.start) * f64::from(k) / 6.0]);
        }
    }
    let at = |k: u32, i: u32| k * columns + i % columns;
    for k in 0..6 {
        (0..n).for_each(|i| soup.face(&[at(k, i), at(k, i + 1), at(k + 1, i + 1), at(k + 1, i)]));
    }
    soup
}

#[test]
fn pieces_side_by_side_are_joined_along_the_gap_only() {
    let mut beside = sheet(10, 10);
    beside.points.iter_mut().for_each(|p| p[0] += 10.5);
    for max_gap in [MaxGap::Auto, MaxGap::Given(0.6), MaxGap::Given(100.0)] {
        let done = run(&[sheet(10, 10), beside.clone()], &Options { max_gap, ..Options::default() });
        assert_eq!(done.joints.len(), 1);
        assert!(!done.joints[0].whole && done.turned.iter().all(|&turned| !turned));
        assert_eq!(done.joints[0].sides.each_ref().map(Vec::len), [11, 11]);
        assert_eq!((euler(faces_of(&done.mesh)), done.loops_left), (1, 1));
    }

    // However coarse they are, although then all vertices are about as far from the other piece.
    for size in [2, 3, 4] {
        let mut beside = sheet(size, size);
        beside.points.iter_mut().for_each(|p| p[0] += 1.05 * f64::from(size));
        let done = run(&[sheet(size, size), beside], &Options::default());
        assert_eq!(done.joints.iter().map(|joint| joint.whole).collect::<Vec<_>>(), [false], "{size}");
        assert_eq!((euler(faces_of(&done.mesh)), done.loops_left), (1, 1), "{size}");
    }

    // Two halves of a pipe make a pipe: one gap on each side.
    let halves = [0.0, std::f64::consts::PI].map(|t| pipe(20, t + 0.02..t + 3.12, 1.0, 0.0, 0.0..3.0));
    let done = run(&halves, &Options { max_gap: MaxGap::Given(0.05), ..Options::default() });
    assert_eq!(
        done.joints.iter().map(|joint| (joint.whole, joint.outcome)).collect::<Vec<_>>(),
        [(false, Outcome::Joined), (false, Outcome::Joined)]
    );
    assert_eq!((euler(faces_of(&done.mesh)), done.loops_left), (0, 2));
}

#[test]
fn a_thin_pipe_in_a_wide_one_beside_its_axis_is_joined_all_round() {
    // Between nearest vertices the gap is 0.04 to 1.2 wide, more than ten times as wide on one side
    // as on the other.
    let (wide, thin) = (pipe(50, 0.0..TAU, 1.0, 0.0, -3.0..0.0), pipe(7, 0.0..TAU, 0.4, 0.57, 0.02..2.0));
    let done = run(&[wide, thin], &Options { max_gap: MaxGap::Given(0.9), ..Options::default() });
    assert_eq!(done.joints.len(), 1);
    assert!(done.joints[0].whole);
    assert_eq!(done.joints[0].sides.each_ref().map(Vec::len), [50, 7]);
    assert_eq!((euler(faces_of(&done.mesh)), done.loops_left), (0, 2));
}
