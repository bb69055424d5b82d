//! A tolerance of one's own, however wide: branches where the surfaces cross clearly are found as
//! by default.

use crate::common::some_of;
use crate::pairs::{check, distance};
use glam::DVec3;
use gusset::Job;
use gusset::surface::surface_intersection::Options;
use gusset::surface::{Contact, ContactKind, Grid, Nodes, Patches, Paths, Scheme, Sheet, Surface};
use std::f64::consts::TAU;

/// From far below the cells to far above them.
const TOLERANCES: [f64; 8] = [1e-6, 1e-4, 1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.3];

/// A sheet of `cells` cells a side over [0, 1]^2.
fn sheet(cells: usize, at: impl Fn(f64, f64) -> DVec3) -> Surface<'static> {
    let count = cells + 1;
    let share = |k: usize| k as f64 / cells as f64;
    let data: Vec<f64> = (0..count * count).flat_map(|k| at(share(k / count), share(k % count)).to_array()).collect();
    let nodes = Nodes::strided(data, count, count, 0, 0).unwrap();
    Surface::new(vec![Sheet::Grid(Grid::new(nodes, [false, false], Scheme::SixTap).unwrap())], None, &Job::default())
        .unwrap()
}

/// One cell of degrees (2, 2): z = f(x, y) = x^2 + y^2 - r^2 over [-1, 1]^2, moved.
fn bowl(radius: f64, by: DVec3) -> Surface<'static> {
    let points: Vec<DVec3> = (0..9)
        .map(|k| {
            let squares = [1.0, -1.0, 1.0];
            let (x, y) = ((k / 3) as f64 - 1.0, (k % 3) as f64 - 1.0);
            DVec3::new(x, y, squares[k / 3] + squares[k % 3] - radius * radius) + by
        })
        .collect();
    Surface::new(vec![Sheet::Cubic(Patches::new(&points, [2, 2], 1, 1).unwrap())], None, &Job::default()).unwrap()
}

fn options(tolerance: f64) -> Options {
    Options { tolerance: Some(tolerance), ..Options::default() }
}

fn meet(a: &Surface<'_>, b: &Surface<'_>, tolerance: f64) -> Paths {
    let paths = a.meet(b, &options(tolerance), &Job::default()).unwrap();
    check(&paths, a, b);
    paths
}

fn length(paths: &Paths) -> f64 {
    let of = |k: usize| paths.points_of(k).windows(2).map(|pair| pair[0].distance(pair[1])).sum::<f64>();
    (0..paths.len()).map(of).sum()
}

/// The length of the chords of closed paths too.
fn length_round(paths: &Paths) -> f64 {
    let closing = |k: usize| {
        let points = paths.points_of(k);
        points[0].distance(points[points.len() - 1])
    };
    length(paths) + (0..paths.len()).filter(|&k| paths.closed[k]).map(closing).sum::<f64>()
}

/// Planes at several angles: one straight path from border to border.
#[test]
fn planes_of_small_cells_meet_in_one_line() {
    for (cells, slope) in [(1, 1.0), (20, 1.0), (50, 0.1), (200, 1.0)] {
        let flat = sheet(cells.max(5), |x, y| DVec3::new(x, y, 0.0));
        let tilted = sheet(7, |x, y| {
            DVec3::new(2.0 * x - 0.5, 2.0 * y - 0.5, slope * (2.0 * x - 0.5 - 0.31 - 0.37 * (2.0 * y - 0.5)))
        });
        // x = 0.31 + 0.37 y.
        let expected = 1.0f64.hypot(0.37);
        for tolerance in TOLERANCES {
            let paths = meet(&flat, &tilted, tolerance);
            let found = length(&paths);
            let what =
                format!("{cells} cells, slope {slope}, {tolerance}: {found} of {expected}, {} paths", paths.len());
            assert!(paths.len() == 1 && (found - expected).abs() < 1e-9, "{what}");
            assert!(paths.unresolved.is_empty() && paths.contacts.is_empty(), "{what}");
        }
    }
}

/// A circle over one cell, and beside and through sides of small ones.
#[test]
fn circles_are_closed() {
    let radius = 0.4;
    for by in [DVec3::ZERO, DVec3::new(0.013, -0.07, 0.0), DVec3::new(0.1, 0.05, 0.0), DVec3::new(0.05, 0.1, 0.0)] {
        let bowl = bowl(radius, by);
        for cells in [5, 20, 60] {
            let flat = sheet(cells, |x, y| DVec3::new(2.0 * x - 1.0, 2.0 * y - 1.0, 0.0));
            for tolerance in TOLERANCES {
                let paths = meet(&bowl, &flat, tolerance);
                let share = length_round(&paths) / (TAU * radius);
                let what = format!("{by} {cells} {tolerance}: {share}, {} paths", paths.len());
                assert!(paths.len() == 1 && paths.closed[0] && (share - 1.0).abs() < 5e-3, "{what}");
                assert!(paths.unresolved.is_empty() && paths.contacts.is_empty(), "{what}");
            }
        }
    }
}

/// The strip (t^2 - 1, t^3 - t) meets itself in the line over t = 1 and t = -1.
#[test]
fn a_strip_meets_itself_in_one_line() {
    for cells in [24, 100] {
        let strip = sheet(cells, |x, y| {
            let t = 3.0 * x - 1.5;
            DVec3::new(t * t - 1.0, t * t * t - t, y + 0.2 * t)
        });
        for tolerance in TOLERANCES {
            let paths = strip.meet_itself(&options(tolerance), &Job::default()).unwrap();
            let found = length(&paths);
            let what =
                format!("{cells} {tolerance}: {found}, {} paths, {} unresolved", paths.len(), paths.unresolved.len());
            assert!(paths.len() == 1 && (found - 0.6).abs() < 1e-3 && paths.unresolved.is_empty(), "{what}");
        }
    }
}

/// Balls of small cells that are apart by half a tolerance touch.
#[test]
fn balls_of_small_cells_touch() {
    for (cells, tolerance) in [(40, 1e-3), (40, 1e-2), (120, 1e-3), (120, 1e-2), (120, 3e-2)] {
        let cap = |x: f64, y: f64| {
            let [x, y] = [1.2 * x - 0.6, 1.2 * y - 0.6];
            DVec3::new(x, y, (1.0 - x * x - y * y).sqrt())
        };
        // The centres are (0.03, -0.02) apart across z.
        let nearest = (4.0f64 - 0.0013).sqrt();
        for gap in [0.5, 0.2, 0.0, -0.2, -0.5] {
            let lower = sheet(cells, cap);
            let upper = sheet(cells, |x, y| {
                let p = cap(x, y);
                DVec3::new(p.x + 0.03, p.y - 0.02, nearest + gap * tolerance - p.z)
            });
            let paths = meet(&lower, &upper, tolerance);
            let what = format!(
                "{cells} {tolerance} {gap}: {} paths {} contacts {} unresolved",
                paths.len(),
                paths.contacts.len(),
                paths.unresolved.len()
            );
            assert!(paths.is_empty() && paths.contacts.len() == 1 && paths.unresolved.is_empty(), "{what}");
            let off = paths.contacts[0].gap.abs() - gap.abs() * tolerance;
            assert!(off.abs() < 1e-5, "{what}: {off}");
        }
    }
}

/// z = x y - rise meets its plane in the branches of a hyperbola. If the branches are nearer than
/// the tolerance, they are a crossing; otherwise both are found.
#[test]
fn branches_that_pass_each_other_within_the_tolerance_cross() {
    for cells in [1, 5, 40] {
        for (tolerance, rise) in [(1e-3, 3e-4), (1e-3, -3e-4), (1e-2, 3e-3), (0.05, 0.02), (0.05, 0.0)] {
            let points = [[0, 0], [0, 1], [1, 0], [1, 1]].map(|[i, j]| {
                let (x, y) = (2.0 * f64::from(i) - 0.9, 2.0 * f64::from(j) - 1.15);
                DVec3::new(x, y, x * y - rise)
            });
            let saddle = Sheet::Cubic(Patches::new(&points, [1, 1], 1, 1).unwrap());
            let saddle = Surface::new(vec![saddle], None, &Job::default()).unwrap();
            let flat = sheet(cells.max(5), |x, y| DVec3::new(3.0 * x - 1.5, 3.0 * y - 1.5, 0.0));
            for (a, b) in [(&saddle, &flat), (&flat, &saddle)] {
                let paths = a.meet(b, &options(tolerance), &Job::default()).unwrap();
                let found = length(&paths);
                let what = format!(
                    "{cells} {tolerance} {rise}: {} paths of {found}, {} contacts, {} unresolved",
                    paths.len(),
                    paths.contacts.len(),
                    paths.unresolved.len()
                );
                assert!(paths.len() == 2 && paths.unresolved.is_empty(), "{what}");
                let [contact] = paths.contacts[..] else { panic!("{what}") };
                assert!(contact.kind == ContactKind::Crossing && contact.radius <= 8.0 * tolerance.sqrt(), "{what}");
                assert!((contact.gap.abs() - rise.abs()).abs() <= 1e-12, "{what}");
                // Branches of a hyperbola are shorter than their asymptotes: 4 in all.
                assert!(found <= 4.0 + 1e-9 && 4.0 - found <= 4.0 * rise.abs().sqrt() + 1e-9, "{what}");
                let at = a.jet(contact.place).point;
                for point in paths.points.iter().filter(|point| point.distance(at) > 1e-12) {
                    assert!((point.x * point.y - rise).abs() <= 1e-9 && point.z.abs() <= 1e-12, "{what} {point}");
                }
                // Both come to the contact, or neither, where they pass it.
                let ends = paths.points.iter().filter(|point| point.distance(at) <= 1e-12).count();
                assert!(ends == 2 || rise != 0.0 && ends == 0, "{what} {ends}");
            }
        }
    }
}

/// A sheet of bumps that no grid of theirs fits.
fn bumps(seed: u64, cells: usize) -> Surface<'static> {
    let mut state = seed;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let waves: Vec<[f64; 4]> =
        (0..4).map(|_| [1.0 + 2.0 * next(), 1.0 + 2.0 * next(), TAU * next(), 0.05 + 0.1 * next()]).collect();
    sheet(cells, |x, y| {
        let height = waves.iter().map(|[u, v, at, high]| high * (TAU * (u * x + v * y) + at).sin()).sum();
        DVec3::new(1.1 * x - 0.05, 1.1 * y - 0.05, height)
    })
}

/// Allowed distance of paths with another tolerance from default paths, whose chords are within
/// 2e-4 of the curve.
const REACH: f64 = 1e-3;

/// Points of the paths that are expected are on those that are found, or within a contact, or in
/// cells that are listed.
fn assert_none_is_lost_silently(paths: &Paths, expected: &Paths, a: &Surface<'_>, what: &str) {
    for (&point, place) in expected.points.iter().zip(&expected.places) {
        let is_of = |contact: &Contact| a.jet(contact.place).point.distance(point) <= contact.radius + REACH;
        let is_listed = || paths.unresolved.iter().any(|other| (other.sheet, other.cell) == (place.sheet, place.cell));
        let is_said = is_listed() || paths.contacts.iter().any(is_of);
        assert!(is_said || distance(paths, point) <= REACH, "{what}: {point} is lost");
    }
}

/// Random sheets: with any tolerance the paths equal the default's, except at contacts and in
/// unresolved cells.
#[test]
fn random_sheets_meet_in_the_same_paths_with_any_tolerance() {
    let (mut same, mut short, mut compared) = (0, 0, 0);
    for seed in some_of(15, 0..60u64) {
        let cells = 6 + (seed as usize * 7) % 35;
        let (a, b) = (bumps(seed, cells), bumps(seed + 1000, 11));
        let expected = a.meet(&b, &Options::default(), &Job::default()).unwrap();
        for tolerance in TOLERANCES {
            let paths = a.meet(&b, &options(tolerance), &Job::default()).unwrap();
            let (found, whole) = (length_round(&paths), length_round(&expected));
            compared += 1;
            if paths.contacts.is_empty() && paths.unresolved.is_empty() && expected.unresolved.is_empty() {
                same += 1;
                let what =
                    format!("{seed} {cells} {tolerance}: {} {} of {} {whole}", paths.len(), found, expected.len());
                assert!(paths.len() == expected.len() && (found - whole).abs() <= 1e-9 * whole, "{what}");
                assert_eq!(paths.closed, expected.closed, "{what}");
            } else {
                let what = format!("{seed} {cells} {tolerance}: {found} of {whole}");
                assert_none_is_lost_silently(&paths, &expected, &a, &what);
                // And nothing else is found.
                assert!(paths.points.iter().all(|&point| distance(&expected, point) <= REACH), "{what}");
                // The sheets are 1 wide, and nearly everywhere within the widest tolerance of each
                // other: branches in listed cells may lack more, but seldom do.
                let off = (found / whole - 1.0).abs();
                assert!(off <= if tolerance < 0.1 { 0.1 } else { 0.3 }, "{what}");
                short += usize::from(off > 0.1);
            }
        }
    }
    assert!(short <= compared / 50, "{short} of {compared}");
    assert!(same >= compared / 3, "{same} of {compared}");
}

/// z = 0.05 sin sin meets a plane in loops that are within the tolerance of each other in corridors
/// from saddle to saddle. Unseparated parts are reported, and no path is lost silently, in either
/// order.
#[test]
fn contacts_are_no_wider_than_their_curvature_allows() {
    let waves = sheet(16, |x, y| {
        let [x, y] = [2.0 * x - 1.0, 2.0 * y - 1.0];
        DVec3::new(x, y, 0.05 * (5.0 * x + 0.3).sin() * (5.0 * y + 0.2).sin())
    });
    for cells in [5, 8] {
        let flat = sheet(cells, |x, y| DVec3::new(2.0 * x - 1.0, 2.0 * y - 1.0, 0.005));
        let expected = length_round(&meet(&waves, &flat, 1e-6));
        for tolerance in [1e-3, 0.0075, 0.015, 0.025, 0.035] {
            for (a, b) in [(&waves, &flat), (&flat, &waves)] {
                let paths = a.meet(b, &options(tolerance), &Job::default()).unwrap();
                let widest = paths.contacts.iter().map(|contact| contact.radius).fold(0.0, f64::max);
                let what = format!("{cells} {tolerance}: {} of {expected}, widest {widest}", length_round(&paths));
                // The difference curves by 1.25 at the saddles and more at the bumps.
                assert!(widest <= 4.5 * (2.0 * (tolerance + 0.005) / 1.2f64).sqrt(), "{what}");
                assert!(!paths.unresolved.is_empty() || length_round(&paths) >= 0.85 * expected, "{what}");
            }
        }
    }
}
