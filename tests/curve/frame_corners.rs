//! Corners of sections in frames of outlines: they keep their edges, and they belong together.

use crate::outline_frame::{CUBIC, Sections, assert_meets, circle, options};
use glam::DVec3;
use gusset::curve::frame::{Correspondence, FrameOptions, Measure, frame};
use gusset::curve::{Constraint, Options, Outlines, PointConstraint, Points};
use gusset::{Allowed, Error, Job};

/// The frames of a ship of 10 by 2 by 1: below the deck a parabola, pointed at the keel; `n` points
/// from edge to edge and `m` more across the deck.
fn ship(n: usize, m: usize, random: &mut fastrand::Rng) -> Sections {
    Sections::from_sections((0..11).map(|k| {
        let x = f64::from(k) - 5.0;
        let half = 1.0 - 0.03 * x * x;
        let below = (0..n).map(|i| 2.0 * i as f64 / (n - 1) as f64 - 1.0).map(|s| [x, half * s, s * s]);
        let across = (1..=m).map(|i| 1.0 - 2.0 * i as f64 / (m + 1) as f64).map(|s| [x, half * s, 1.0]);
        let mut points: Vec<[f64; 3]> = below.chain(across).collect();
        let n = points.len();
        points.rotate_left(random.usize(..n));
        points
    }))
}

#[test]
fn decks_keep_their_edges() {
    let mut random = fastrand::Rng::with_seed(9);
    for (n, m) in [(9, 0), (9, 3), (15, 5), (30, 1)] {
        let sections = ship(n, m, &mut random);
        for (correspondence, columns) in
            [(Correspondence::ArcLength { columns: 20 }, 20), (Correspondence::ArcLength { columns: 31 }, 31)]
        {
            let made = sections.make(true, &options(correspondence)).unwrap();
            assert_meets(&made);
            // At the ends, the keel may be a corner too.
            let node = |corner: &u32| made.grid.nodes[*corner as usize];
            let (deck, keels): (Vec<u32>, Vec<u32>) = made.grid.corners.iter().partition(|corner| node(corner).z > 0.5);
            assert!(keels.iter().all(|keel| node(keel).x.abs() == 5.0 && node(keel).y.abs() < 1e-12), "{n} {m}");
            assert_eq!((made.grid.columns, deck.len()), (columns, 22), "{n} {m}");
            for (k, pair) in deck.chunks(2).enumerate() {
                let x = k as f64 - 5.0;
                let half = 1.0 - 0.03 * x * x;
                for &node in pair {
                    let p = made.grid.nodes[node as usize];
                    assert!((p.x - x).abs() < 1e-12 && (p.y.abs() - half).abs() < 1e-12 && p.z == 1.0, "{p}");
                }
                // Its area, which the paper has for a parabola and a line, at every section.
                let area = Measure::from_curve(made.across.curve(k)).unwrap().area;
                assert!((area / (4.0 / 3.0 * half) - 1.0).abs() < 0.01, "{n} {m} {k}: {area}");
            }
            // Smooth, they are fuller.
            let smooth =
                sections.make(true, &FrameOptions { smooth_corners: true, ..options(correspondence) }).unwrap();
            assert!(smooth.grid.corners.is_empty());
        }
    }
    // One section is smooth, and one has another shape: the other sections keep their corners.
    let mut sections = ship(9, 3, &mut random);
    let from = sections.offsets[4] as usize;
    (from..sections.offsets[5] as usize).for_each(|i| sections.points[i][2] *= sections.points[i][2]);
    let round = circle(0.0, 40, 0.0, false).into_iter().map(|[y, z, _]| [6.0, 0.1 * y, 0.5 + 0.1 * z]);
    sections.points.extend(round);
    sections.offsets.push(sections.points.len() as u32);
    let made = sections.make(true, &options(Correspondence::ArcLength { columns: 20 })).unwrap();
    assert_meets(&made);
    let deck = made.grid.corners.iter().filter(|&&node| (made.grid.nodes[node as usize].z - 1.0).abs() < 1e-12);
    assert_eq!((made.grid.columns, deck.count()), (20, 22));
    assert!(made.grid.max_twist < 0.5, "{}", made.grid.max_twist);
}

#[test]
fn open_sections_keep_their_chines() {
    let sections = Sections::from_sections((0..5).map(|k| {
        let x = f64::from(k);
        // Differently many points, and a chine at y = 1.
        let below = (0..6 + k).map(move |i| f64::from(i) / f64::from(6 + k)).map(move |s| [x, s, 0.1 * s * s]);
        let above = (0..=4).map(|i| f64::from(i) / 4.0).map(move |s| [x, 1.0 + 0.1 * s * s, 0.1 + s]);
        below.chain(above).collect()
    }));
    let made = sections.make(false, &options(Correspondence::ArcLength { columns: 12 })).unwrap();
    assert_meets(&made);
    assert_eq!(made.grid.corners.len(), 5);
    for (k, &node) in made.grid.corners.iter().enumerate() {
        assert_eq!(made.grid.nodes[node as usize], DVec3::new(k as f64, 1.0, 0.1));
    }
    assert_eq!(made.grid.max_twist, 0.0);
    for columns in [0, 1] {
        let refused = sections.make(false, &options(Correspondence::ArcLength { columns })).unwrap_err();
        let allowed = Allowed::AtLeast(2.0);
        assert_eq!(refused, Error::OptionOutOfRange { option: "columns", value: columns as f64, allowed });
    }
    // A column more than requested, for the chine.
    let made = sections.make(false, &options(Correspondence::ArcLength { columns: 2 })).unwrap();
    assert_eq!((made.grid.columns, made.grid.corners.len()), (3, 5));
}

#[test]
fn a_point_that_is_repeated_but_for_round_off_is_no_corner() {
    let mut random = fastrand::Rng::with_seed(6);
    for case in 0..200 {
        let sections = Sections::from_sections((0..4).map(|k| {
            let n = 24 + 8 * (case % 4);
            let mut points = circle(0.2 * f64::from(k), n, 0.4 + random.f64(), false);
            let noise = || 1e-14 * (2.0 * fastrand::Rng::with_seed(case as u64).f64() - 1.0);
            points.push(points[0].map(|x| x + noise()));
            points
        }));
        let made = sections.make(true, &options(Correspondence::ArcLength { columns: 16 })).unwrap();
        assert!(made.grid.corners.is_empty() && made.grid.max_twist < 0.1, "{case}: {}", made.grid.max_twist);
        // Once round.
        for k in 0..4 {
            let row = &made.grid.nodes[16 * k..16 * (k + 1)];
            assert!((0..16).all(|i| row[i].distance(row[(i + 8) % 16]) > 1.0), "{case}");
        }
    }
}

#[test]
fn corners_belong_together_at_any_scale() {
    for scale in [1e-300, 1e-170, 1e-20, 1.0, 1e100, 1e150] {
        let mut random = fastrand::Rng::with_seed(3);
        let mut sections = ship(15, 5, &mut random);
        sections.points.iter_mut().flatten().for_each(|x| *x *= scale);
        let made = sections.make(true, &options(Correspondence::ArcLength { columns: 20 })).unwrap();
        assert_eq!(made.grid.corners.len(), 22, "{scale:e}");
        assert!(made.grid.max_twist < 0.1, "{scale:e} {}", made.grid.max_twist);
    }
}

#[test]
fn corners_that_the_caller_knows() {
    let square = |z: f64| {
        (0..16).map(move |i| {
            let t = f64::from(i % 4) / 4.0;
            let [x, y] = [[t, 0.0], [1.0, t], [1.0 - t, 1.0], [0.0, 1.0 - t]][i as usize / 4];
            [x, y, z]
        })
    };
    let points: Vec<[f64; 3]> = (0..3).flat_map(|k| square(f64::from(k))).collect();
    let make = |constraints: &[Constraint], options: &FrameOptions<'_>| {
        let offsets = [0, 16, 32, 48];
        let points = Points::from(&points[..]);
        let outlines = Outlines { points, offsets: Some(&offsets), closed: true, constraints };
        frame(&outlines, options, &Job::default()).unwrap().grid.corners
    };
    let given = options(Correspondence::Given);
    assert_eq!(make(&[], &given).len(), 12);
    // A tangent there says that it is none.
    let tangent = Constraint { point: 16, kind: PointConstraint::Tangent(DVec3::X) };
    assert_eq!(make(&[tangent], &given).len(), 11);
    let smooth = FrameOptions { smooth_corners: true, ..given };
    assert!(make(&[], &smooth).is_empty());
    let sharp = Options { corner_angle: 0.6, ..CUBIC };
    assert!(make(&[], &FrameOptions { across: sharp, ..smooth }).is_empty());
    let corner = Constraint { point: 20, kind: PointConstraint::Corner };
    assert_eq!(make(&[corner], &smooth), [20]);
    assert_eq!(make(&[], &FrameOptions { across: sharp, ..given }).len(), 12);
}
