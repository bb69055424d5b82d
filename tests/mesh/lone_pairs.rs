//! Loops across gaps of one to three radii: those with nobody else near are joined, others are left.

use crate::common::{Soup, cap, edge_counts, faces_of};
use glam::{DQuat, DVec3};
use gusset::Job;
use gusset::assemble::{Assembly, MaxGap, Options, Outcome, Reason, Selector, assemble};
use gusset::mesh::{MeshView, NONE};

/// Half balls of radius 1 whose rims have the height 0: above it if `sign` is 1, else below.
fn half_balls(places: &[DVec3], sign: f64, random: &mut fastrand::Rng) -> Soup {
    let mut all = Soup { offsets: vec![0], ..Soup::default() };
    for place in places {
        let mut ball = cap(random.u32(8..40), 6, 0.1, sign);
        ball.points.iter_mut().for_each(|p| *p = (DVec3::from(*p) - 0.1 * sign * DVec3::Z + *place).to_array());
        all = all.and(&ball);
    }
    all
}

/// Two pieces in a random position: half balls above with their rims at `above`, and half balls below.
fn pieces(above: &[DVec3], below: &[DVec3], random: &mut fastrand::Rng) -> [Soup; 2] {
    let mut made = [half_balls(above, 1.0, random), half_balls(below, -1.0, random)];
    let mut any = || random.f64() - 0.5;
    let turn = DQuat::from_xyzw(any(), any(), any(), any()).normalize();
    let (size, shift) = ((10.0 * any()).exp(), DVec3::new(any(), any(), any()));
    for soup in &mut made {
        soup.points.iter_mut().for_each(|p| *p = (size * (turn * (DVec3::from(*p) + shift))).to_array());
    }
    made
}

fn join(pieces: &[Soup], options: &Options<'_>) -> Assembly {
    let views: Vec<MeshView<'_>> = pieces.iter().map(Soup::view).collect();
    assemble(&views, options, &Job::default()).unwrap()
}

fn case_count() -> u64 {
    if crate::common::is_exhaustive() { 1000 } else { 60 }
}

#[test]
fn each_other_s_nearest_are_joined() {
    for seed in 0..case_count() {
        let mut random = fastrand::Rng::with_seed(seed);
        let (count, gap, apart) = (random.usize(2..5), 1.1 + 1.6 * random.f64(), 3.5 + 4.0 * random.f64());
        let below: Vec<DVec3> = (0..count).map(|k| DVec3::new(apart * k as f64, random.f64(), 0.0)).collect();
        let mut aside = || 0.3 * (random.f64() - 0.5);
        let above: Vec<DVec3> = below.iter().map(|p| *p + DVec3::new(aside(), aside(), gap)).collect();
        let name = format!("{seed}: {count}, {gap} wide, {apart} apart");
        let pieces = pieces(&above, &below, &mut random);
        let done = join(&pieces, &Options::default());
        assert!(done.joints.iter().all(|joint| joint.whole && joint.outcome == Outcome::Joined), "{name}");
        assert_eq!((done.joints.len(), done.left.len(), done.loops_left), (count, 0, 0), "{name}");
        assert!(edge_counts(faces_of(&done.mesh)).values().all(|&counts| counts == (1, 1)), "{name}");
        // Ball k is joined with ball k: the vertices of each piece are numbered ball by ball.
        for joint in &done.joints {
            let ball = |piece: usize, v: u32| {
                let place = done.maps[piece].vertices.iter().position(|&w| w == v)?;
                let poles = (0..count).map(|k| pole(&pieces[piece], k));
                poles.rev().position(|pole| pole <= place).map(|back| count - 1 - back)
            };
            let of = |side: usize| ball(0, joint.sides[side][0]).or_else(|| ball(1, joint.sides[side][0])).unwrap();
            assert_eq!(of(0), of(1), "{name}");
        }
    }
}

/// The first vertex of ball `k`: only a pole has triangles alone, as many as a ring has vertices.
fn pole(soup: &Soup, k: usize) -> usize {
    let mut poles: Vec<u32> = soup.faces().filter(|face| face.len() == 3).map(|face| face[0]).collect();
    poles.dedup();
    poles[k] as usize
}

#[test]
fn loops_with_others_near_are_left() {
    for seed in 0..case_count() {
        let mut random = fastrand::Rng::with_seed(seed);
        let (gap, apart) = (1.2 + random.f64(), 4.0 + 4.0 * random.f64());
        let below: Vec<DVec3> = (0..3).map(|k| DVec3::new(apart * f64::from(k), 0.0, 0.0)).collect();
        let above: Vec<DVec3> = below[..2].iter().map(|p| *p + DVec3::new(0.5 * apart, 0.0, gap)).collect();
        let done = join(&pieces(&above, &below, &mut random), &Options::default());
        assert_eq!((done.joints.len(), done.left.len()), (0, 5), "{seed}: {gap} wide, {apart} apart");
        assert!(done.left.iter().all(|left| left.reason == Reason::TooFar), "{seed}");
    }
}

#[test]
fn loops_that_look_away_or_are_farther_are_left() {
    for seed in 0..case_count() {
        let mut random = fastrand::Rng::with_seed(seed);
        let (gap, apart) = (1.2 + random.f64(), 4.0 + 4.0 * random.f64());
        let below: Vec<DVec3> = (0..2).map(|k| DVec3::new(apart * f64::from(k), 0.0, 0.0)).collect();
        let above = |by: DVec3| below.iter().map(|p| *p + by).collect::<Vec<_>>();
        let name = format!("{seed}: {gap} wide, {apart} apart");
        // Back to back, beside each other, and beyond three radii.
        for by in [-DVec3::Z * (2.0 + gap), DVec3::Y * (2.0 + gap), DVec3::Z * (3.2 + gap)] {
            let done = join(&pieces(&above(by), &below, &mut random), &Options::default());
            assert_eq!((done.joints.len(), done.left.len()), (0, 4), "{name}, {by}");
        }
        // A given limit and excluded pairs hold.
        let made = pieces(&above(gap * DVec3::Z), &below, &mut random);
        assert_eq!(join(&made, &Options::default()).joints.len(), 2, "{name}");
        let size = made[0].view().positions().get(0).distance(made[1].view().positions().get(0));
        let given = Options { max_gap: MaxGap::Given(0.1 * size), ..Options::default() };
        assert_eq!(join(&made, &given).joints.len(), 0, "{name}");
        let excluded = [[Selector { piece: 0, vertex: NONE }, Selector { piece: 1, vertex: NONE }]];
        assert_eq!(join(&made, &Options { excluded: &excluded, ..Options::default() }).joints.len(), 0, "{name}");
    }
}
