//! Which loops an assembly joins with nothing set: arrangements whose right pairs are known.

use crate::common::{Soup, euler, faces_of};
use gusset::Job;
use gusset::assemble::{Assembly, Options, Outcome, Reason, assemble};
use gusset::mesh::MeshView;
use std::collections::BTreeSet;
use std::f64::consts::TAU;

type P = [f64; 3];

fn run(pieces: &[Soup]) -> Assembly {
    let views: Vec<MeshView<'_>> = pieces.iter().map(Soup::view).collect();
    assemble(&views, &Options::default(), &Job::default()).unwrap()
}

/// A tube of `rows` x `n` quads about a vertical axis, from `z` upwards, or downwards if `step` is
/// negative. A fan closes its far end, and faces are oriented outwards. `wave` is the amplitude of
/// the open rim.
fn tube(n: u32, centre: [f64; 2], r: f64, z: f64, step: f64, rows: u32, wave: impl Fn(u32) -> f64) -> Soup {
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    for k in 0..=rows {
        for i in 0..n {
            let t = TAU * f64::from(i) / f64::from(n);
            let height = z + step * f64::from(k) + if k == 0 { wave(i) } else { 0.0 };
            soup.points.push([centre[0] + r * t.cos(), centre[1] + r * t.sin(), height]);
        }
    }
    soup.points.push([centre[0], centre[1], z + step * f64::from(rows)]);
    let top = soup.points.len() as u32 - 1;
    let mut face = |corners: &[u32]| {
        let mut corners = corners.to_vec();
        if step < 0.0 {
            corners.reverse();
        }
        soup.face(&corners);
    };
    for k in 0..rows {
        (0..n).for_each(|i| face(&[k * n + i, k * n + (i + 1) % n, (k + 1) * n + (i + 1) % n, (k + 1) * n + i]));
    }
    (0..n).for_each(|i| face(&[rows * n + i, rows * n + (i + 1) % n, top]));
    soup
}

fn flat(_: u32) -> f64 {
    0.0
}

/// Several shells as one piece.
fn together(shells: &[Soup]) -> Soup {
    shells[1..].iter().fold(shells[0].clone(), |whole, shell| whole.and(shell))
}

/// The pairs of joined loops, each by the mean of its vertices, to a tenth.
fn joined(done: &Assembly) -> BTreeSet<[[i64; 3]; 2]> {
    let middle = |side: &Vec<u32>| {
        let sum = side.iter().map(|&v| done.mesh.positions.get(v)).sum::<glam::DVec3>() / side.len() as f64;
        sum.to_array().map(|x| (10.0 * x).round() as i64)
    };
    let made = done.joints.iter().filter(|joint| joint.outcome == Outcome::Joined && joint.whole);
    made.map(|joint| {
        let mut sides = joint.sides.each_ref().map(middle);
        sides.sort_unstable();
        sides
    })
    .collect()
}

fn assert_joined(pieces: &[Soup], pairs: &[[[i64; 3]; 2]], chi: i64) {
    for (unit, shift) in [(1.0, 0.0), (1e-6, 0.0), (1e6, 0.0), (1.0, 37.0)] {
        let scaled = |soup: &Soup| {
            let mut soup = soup.clone();
            soup.points.iter_mut().for_each(|p| *p = p.map(|x| unit * x + shift));
            soup
        };
        let mut scaled: Vec<Soup> = pieces.iter().map(scaled).collect();
        for _ in 0..2 {
            let mut done = run(&scaled);
            let count = done.mesh.positions.len() as u32;
            let points: Vec<P> = (0..count).map(|v| ((done.mesh.positions.get(v) - shift) / unit).to_array()).collect();
            done.mesh.positions = gusset::mesh::PositionBuffer::F64(points);
            assert_eq!(joined(&done), pairs.iter().copied().collect(), "{unit}");
            assert_eq!((euler(faces_of(&done.mesh)), done.loops_left), (chi, 0));
            // The order of the pieces says nothing.
            scaled.reverse();
        }
    }
}

#[test]
fn two_loops_side_by_side_that_face_two_others() {
    // The tubes of one piece are nearer to each other (0.2) than to those they face (0.5).
    let below = [0.0, 2.2].map(|x| tube(24, [x, 0.0], 1.0, 0.0, -0.4, 5, flat));
    let above = [0.0, 2.2].map(|x| tube(24, [x, 0.0], 1.0, 0.5, 0.4, 5, flat));
    let pairs = [[[0, 0, 0], [0, 0, 5]], [[22, 0, 0], [22, 0, 5]]];
    assert_joined(&[together(&below), together(&above)], &pairs, 4);
    // As four pieces, and with one that lacks a partner.
    let [a, b] = below;
    let [c, d] = above;
    assert_joined(&[a.clone(), b.clone(), c.clone(), d], &pairs, 4);
    let done = run(&[a, b, c]);
    assert_eq!((joined(&done), done.loops_left), (BTreeSet::from([pairs[0]]), 1));
    // As a whole the loop beside it is farther than the radius, though it is near in one place.
    assert!(done.left[0].reason == Reason::TooFar && done.left[0].gap > done.left[0].allowed_gap);
}

#[test]
fn a_jagged_loop_and_a_coarser_one() {
    let teeth = |high: f64| move |i: u32| if i.is_multiple_of(3) { high } else { 0.0 };
    let pieces =
        [tube(53, [0.0; 2], 1.0, 0.0, -0.3, 4, teeth(-0.12)), tube(34, [0.0; 2], 1.0, 0.15, 0.3, 4, teeth(0.18))];
    let done = run(&pieces);
    assert_eq!(done.joints.len(), 1);
    assert!(done.joints[0].whole && done.joints[0].sides.each_ref().map(Vec::len) == [53, 34]);
    assert_eq!((euler(faces_of(&done.mesh)), done.loops_left), (2, 0));
    assert_eq!(done.joints[0].intersections, Some(Vec::new()));
}

#[test]
fn bones_of_one_piece_are_not_joined_sideways() {
    // Five bones beside each other, 0.1 apart, open at their upper ends.
    let bones: Vec<Soup> = (0..5).map(|k| tube(16, [2.1 * f64::from(k), 0.0], 1.0, 0.0, -3.0, 6, flat)).collect();
    for pieces in [vec![together(&bones)], bones] {
        let done = run(&pieces);
        assert!(joined(&done).is_empty() && done.loops_left == 5, "{:?}", joined(&done));
        assert!(done.left.iter().all(|left| left.reason == Reason::LooksAway) && done.near_loops_left == 5);
    }
}

#[test]
fn a_body_and_four_legs() {
    // The body is a board with four holes; two legs stand nearer to each other (0.1) than to it (0.6).
    let legs = [[0.0, 0.0], [2.1, 0.0], [9.0, 0.0], [9.0, 5.0]];
    let body: Vec<Soup> = legs.iter().map(|&at| tube(20, at, 1.0, 0.6, 0.5, 3, flat)).collect();
    let feet = legs.map(|at| tube(20, at, 1.0, 0.0, -0.5, 8, flat));
    let mut pieces = vec![together(&body)];
    pieces.extend(feet);
    let at = |[x, y]: [f64; 2], z| [(10.0 * x) as i64, (10.0 * y) as i64, z];
    let pairs = legs.map(|leg| [at(leg, 0), at(leg, 6)]);
    assert_joined(&pieces, &pairs, 8);
}

#[test]
fn far_things_are_left_unless_they_are_the_only_ones() {
    let pair = |gap: f64| [tube(24, [0.0; 2], 1.0, 0.0, -0.4, 5, flat), tube(24, [0.0; 2], 1.0, gap, 0.4, 5, flat)];
    let other = tube(24, [50.0, 0.0], 1.0, 0.0, -0.4, 5, flat);
    let with_other = |gap| {
        let [a, b] = pair(gap);
        run(&[a, b, other.clone()])
    };
    assert_eq!((joined(&with_other(0.9)).len(), joined(&with_other(8.0)).len()), (1, 0));
    assert_eq!(joined(&run(&pair(8.0))).len(), 1, "as stitching two pieces does");
}
