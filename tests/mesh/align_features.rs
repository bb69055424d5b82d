//! Alignment without a start: views of bodies by formula, in any positions.

use crate::common::{Silent, Soup, StopAt, some_of};
use glam::{DMat3, DQuat, DVec3};
use gusset::align::{Alignment, Options, Pose, Reason, Start, align};
use gusset::{Error, Job};
use std::collections::HashMap;

/// A closed surface with one point in each direction, from an octahedron whose edges have `n` parts.
fn body(n: i32, turn: DMat3, point: impl Fn(DVec3) -> DVec3) -> Soup {
    let mut soup = Soup::new(Vec::new(), &[]);
    let mut names: HashMap<[i32; 3], u32> = HashMap::new();
    for signs in 0..8 {
        let sign = [0, 1, 2].map(|k| if signs >> k & 1 == 0 { 1 } else { -1 });
        let is_turned = sign.iter().product::<i32>() < 0;
        let mut triangle = |corners: [[i32; 3]; 3]| {
            let mut face = corners.map(|corner| {
                let key = [0, 1, 2].map(|k| sign[k] * corner[k]);
                *names.entry(key).or_insert_with(|| {
                    let direction = turn * DVec3::from_array(key.map(f64::from)).normalize();
                    soup.points.push(point(direction).to_array());
                    soup.points.len() as u32 - 1
                })
            });
            if is_turned {
                face.reverse();
            }
            soup.face(&face);
        };
        for i in 0..n {
            for j in 0..n - i {
                let k = n - i - j;
                triangle([[i, j, k], [i + 1, j, k - 1], [i, j + 1, k - 1]]);
                if k > 1 {
                    triangle([[i + 1, j, k - 1], [i + 1, j + 1, k - 2], [i, j + 1, k - 1]]);
                }
            }
        }
    }
    soup
}

/// The faces that are turned towards a direction by more than the cosine.
fn view(whole: &Soup, from: DVec3, cosine: f64) -> Soup {
    whole.part(|face| {
        let [p, q, r] = [0, 1, 2].map(|k| DVec3::from_array(whole.points[face[k] as usize]));
        (q - p).cross(r - p).normalize_or_zero().dot(from) > cosine
    })
}

/// A rotation by chance.
fn rotation(random: &mut fastrand::Rng) -> DMat3 {
    let mut number = || (0..12).map(|_| random.f64()).sum::<f64>() - 6.0;
    DMat3::from_quat(DQuat::from_xyzw(number(), number(), number(), number()).normalize())
}

/// A point of a surface with bumps, in a direction.
fn bumpy(bumps: &[(DVec3, f64, f64)]) -> impl Fn(DVec3) -> DVec3 {
    move |direction| {
        let bump = |(centre, height, width): &(DVec3, f64, f64)| height * ((centre.dot(direction) - 1.0) / width).exp();
        direction * (1.0 + bumps.iter().map(bump).sum::<f64>())
    }
}

fn bumps_by_chance(random: &mut fastrand::Rng) -> Vec<(DVec3, f64, f64)> {
    (0..9).map(|_| (rotation(random).x_axis, 0.15 + 0.35 * random.f64(), 0.02 + 0.1 * random.f64())).collect()
}

fn moved(soup: &Soup, pose: &Pose) -> Soup {
    let points = soup.points.iter().map(|&p| pose.transform_point(p.into()).to_array()).collect();
    Soup { points, ..soup.clone() }
}

fn motion(random: &mut fastrand::Rng) -> Pose {
    Pose { rotation: rotation(random), translation: 9.0 * rotation(random).x_axis }
}

fn search(pieces: &[&Soup], job: &Job<'_>) -> gusset::Result<Alignment> {
    let views: Vec<_> = pieces.iter().map(|piece| piece.view()).collect();
    align(&views, &Options { start: Start::Features, ..Options::default() }, job)
}

/// Two views of a body, 30 to 60 degrees apart, each with vertices of its own. A trusted pose is
/// right, and most poses are trusted.
#[test]
fn overlapping_views_are_found_in_any_position() {
    let (mut trusted, mut count) = (0, 0);
    for seed in some_of(10, 0..40) {
        let mut random = fastrand::Rng::with_seed(seed);
        let bumps = bumps_by_chance(&mut random);
        let from = rotation(&mut random);
        let angle = (30.0 + 30.0 * random.f64()).to_radians();
        let [one, two] = [from.x_axis, from.x_axis * angle.cos() + from.y_axis * angle.sin()].map(|from| {
            let turn = rotation(&mut random);
            view(&body(24, turn, bumpy(&bumps)), from, 0.2)
        });
        let away = motion(&mut random);
        let found = search(&[&one, &moved(&two, &away)], &Job::default()).unwrap();
        let back = away.followed_by(&found.pieces[1].pose);
        let worst = two.points.iter().map(|&p| back.transform_point(p.into()).distance(p.into())).fold(0.0, f64::max);
        count += 1;
        match found.pieces[1].reason {
            // The edges are about 0.08 long.
            Reason::Trusted => assert!(worst < 0.08, "{seed}: {worst}"),
            reason => assert_eq!((reason, found.pieces[1].pose), (Reason::Undetermined, Pose::IDENTITY), "{seed}"),
        }
        trusted += i32::from(found.pieces[1].reason == Reason::Trusted);
    }
    println!("{trusted} of {count} views are trusted");
    assert!(4 * trusted >= 3 * count, "{trusted} of {count}");
}

/// A body that fits itself in several ways leaves the pose of a view undetermined.
#[test]
fn views_of_symmetric_bodies_are_undetermined() {
    let sphere = |d: DVec3| d;
    let cylinder = |d: DVec3| d / d.z.abs().max(d.x.hypot(d.y));
    let cube = |d: DVec3| d / d.abs().max_element();
    let brick = |d: DVec3| DVec3::new(1.4, 1.0, 0.8) * d / d.abs().max_element();
    let bodies: [&dyn Fn(DVec3) -> DVec3; 4] = [&sphere, &cylinder, &cube, &brick];
    for (k, point) in bodies.into_iter().enumerate() {
        for seed in some_of(10, 0..10) {
            let mut random = fastrand::Rng::with_seed(seed);
            let from = rotation(&mut random);
            let [one, two] = [from.x_axis, (from.x_axis + from.y_axis).normalize()].map(|from| {
                let turn = rotation(&mut random);
                view(&body(24, turn, point), from, 0.0)
            });
            let found = search(&[&one, &moved(&two, &motion(&mut random))], &Job::default()).unwrap();
            assert_eq!(found.pieces[1].reason, Reason::Undetermined, "body {k}, seed {seed}: {:?}", found.overlaps);
        }
    }
}

/// Views from opposite sides share nothing.
#[test]
fn views_without_overlap_are_undetermined() {
    for seed in some_of(10, 0..20) {
        let mut random = fastrand::Rng::with_seed(seed);
        let bumps = bumps_by_chance(&mut random);
        let from = rotation(&mut random).x_axis;
        let [one, two] = [from, -from].map(|from| {
            let turn = rotation(&mut random);
            view(&body(24, turn, bumpy(&bumps)), from, 0.4)
        });
        let found = search(&[&one, &moved(&two, &motion(&mut random))], &Job::default()).unwrap();
        assert_eq!(found.pieces[1].reason, Reason::Undetermined, "{seed}: {:?}", found.overlaps);
        assert_eq!(found.pieces[1].pose, Pose::IDENTITY, "{seed}");
    }
}

/// The number of threads and the unit change nothing. A cancel at any report is heard. Pieces
/// without area do not overlap.
#[test]
fn a_search_is_deterministic_and_stops() {
    let mut random = fastrand::Rng::with_seed(1);
    let bumps = bumps_by_chance(&mut random);
    let whole = body(16, DMat3::IDENTITY, bumpy(&bumps));
    let views = [DVec3::X, DVec3::new(0.8, 0.6, 0.0), DVec3::new(0.8, 0.0, 0.6)].map(|from| view(&whole, from, 0.0));
    let empty = Soup::new(vec![[1.0, 2.0, 3.0]; 3], &[&[0, 1, 2]]);
    let pieces = [&views[0], &moved(&views[1], &motion(&mut random)), &views[2], &empty];
    let single = search(&pieces, &Job::new(1, &Silent)).unwrap();
    assert!(single.pieces[..3].iter().all(|piece| piece.reason == Reason::Trusted));
    assert_eq!(single.pieces[3].reason, Reason::NoOverlap);
    (2..4).for_each(|threads| assert_eq!(search(&pieces, &Job::new(threads, &Silent)).unwrap(), single));
    for scale in [1e-120, 1e120] {
        let scaled = pieces.map(|piece| {
            let points = piece.points.iter().map(|p| p.map(|x| x * scale)).collect();
            Soup { points, ..piece.clone() }
        });
        let found = search(&[&scaled[0], &scaled[1], &scaled[2], &scaled[3]], &Job::default()).unwrap();
        assert!(found.pieces[..3].iter().all(|piece| piece.reason == Reason::Trusted), "{scale}");
    }
    for reports in [0, 1, 10, 100] {
        let stop = StopAt::new(reports);
        assert!(matches!(search(&pieces, &Job::new(1, &stop)), Err(Error::Cancelled)), "{reports}");
    }
    // All pieces without area: nothing to place, and no number that is not one.
    let found = search(&[&empty, &empty], &Job::default()).unwrap();
    assert!(found.pieces.iter().all(|piece| piece.reason == Reason::NoOverlap && piece.hold.is_finite()));
}
