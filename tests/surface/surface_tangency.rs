//! Where surfaces touch: points of contact, and points where branches cross.

use crate::pairs::{ball, check, length, meet, one, summary, surface, turn};
use crate::shapes::{Random, Shape};
use glam::{DVec2, DVec3};
use gusset::Job;
use gusset::surface::surface_intersection::Options;
use gusset::surface::{Contact, ContactKind, Patches, Paths, Sheet, Surface};
use std::f64::consts::TAU;

/// The one contact of two surfaces, of which all is resolved.
fn only(paths: &Paths) -> Contact {
    assert!(paths.contacts.len() == 1, "{} {:?}", summary(paths), paths.contacts);
    assert!(paths.unresolved.is_empty(), "{} {:?}", summary(paths), paths.unresolved);
    paths.contacts[0]
}

/// The Bernstein coefficient n of (2 t - 1)^k, of degree 4: the mean of the products of k of the
/// arguments of its blossom.
fn power(k: usize, n: usize) -> f64 {
    let ends: Vec<f64> = (0..4).map(|i| if i < n { 1.0 } else { -1.0 }).collect();
    let (mut sum, mut count) = (0.0, 0.0);
    for mask in (0u32..16).filter(|mask| mask.count_ones() as usize == k) {
        sum += (0..4).filter(|i| mask >> i & 1 == 1).map(|i| ends[i]).product::<f64>();
        count += 1.0;
    }
    sum / count
}

/// The patch z = f(x, y) over [-1, 1]^2, moved: f by its coefficients of x^2, xy, y^2, x^3, y^4 and
/// 1.
fn height([xx, xy, yy, xxx, yyyy, constant]: [f64; 6], motion: impl Fn(DVec3) -> DVec3) -> Surface<'static> {
    let points: Vec<DVec3> = (0..25)
        .map(|k| {
            let (a, b) = (k / 5, k % 5);
            let z = xx * power(2, a) + xy * power(1, a) * power(1, b) + yy * power(2, b);
            let z = z + xxx * power(3, a) + yyyy * power(4, b) + constant;
            motion(DVec3::new(power(1, a), power(1, b), z))
        })
        .collect();
    one(Sheet::High(Patches::new(&points, [4, 4], 1, 1).unwrap()))
}

#[test]
fn balls_that_touch_do_so_in_a_point() {
    // At nodes.
    let shape = ball(12, 24);
    for axis in [DVec3::X, -DVec3::Y] {
        let a = surface(&shape, |p| p);
        for size in [1.0, 0.5, 3.0] {
            let b = surface(&shape, |p| size * p + (1.0 + size) * axis);
            for (a, b) in [(&a, &b), (&b, &a)] {
                let paths = meet(a, b);
                let contact = only(&paths);
                assert!(paths.is_empty() && contact.kind == ContactKind::Point, "{}", summary(&paths));
                assert!(contact.gap.abs() < 1e-12 && contact.radius < 1e-3);
                assert!(a.jet(contact.place).point.distance(axis) < 1e-12);
                assert!(b.jet(contact.other).point.distance(axis) < 1e-12);
            }
        }
    }
}

#[test]
fn definite_contacts_by_their_gap() {
    // z = a x^2 + b x y + c y^2 + ... against z = -d (x^2 + y^2) + gap, turned at random.
    let mut random = Random(3);
    for k in 0..12 {
        let (turn, shift) = (turn(&mut random), random.point(2.0));
        let motion = |p: DVec3| turn * p + shift;
        let form = [1.0 + random.next(), 0.5 * random.next(), 0.7, 0.2, 0.3, 0.0];
        let a = height(form, motion);
        let tolerance = a.tolerance();
        for gap in [0.0, 0.4, -0.4, 1.6, 30.0, -30.0, -1e3, -1e5, -1e7].map(|factor| factor * tolerance) {
            let b = height([-0.3, 0.0, -0.4, 0.0, 0.0, -gap], motion);
            let paths = meet(&a, &b);
            assert!(paths.unresolved.is_empty(), "{k} {gap}: {} {:?}", summary(&paths), paths.unresolved);
            if gap.abs() < tolerance {
                let contact = only(&paths);
                assert!(paths.is_empty() && contact.kind == ContactKind::Point, "{k} {gap}: {}", summary(&paths));
                assert!(a.jet(contact.place).point.distance(shift) < 1e-7, "{k} {gap}");
                assert!((contact.gap - gap).abs() < 1e-3 * tolerance, "{k} {gap} {}", contact.gap);
                continue;
            }
            assert!(paths.contacts.is_empty());
            if gap > 0.0 {
                assert!(paths.is_empty(), "{k} {gap}: {}", summary(&paths));
                continue;
            }
            // One loop round the middle, as long as an ellipse of these axes.
            assert!(paths.len() == 1 && paths.closed[0], "{k} {gap}: {}", summary(&paths));
            let inverse = turn.transpose();
            let flat: Vec<DVec2> = paths.points.iter().map(|p| (inverse * (*p - shift)).truncate()).collect();
            let around: f64 = (0..flat.len()).map(|n| flat[n].angle_to(flat[(n + 1) % flat.len()])).sum();
            assert!((around.abs() - TAU).abs() < 1e-6, "{k} {gap}: {around}");
        }
    }
}

#[test]
fn saddles_by_their_gap() {
    let mut random = Random(4);
    for k in 0..2 {
        let (turn, shift) = (turn(&mut random), random.point(2.0));
        let motion = |p: DVec3| turn * p + shift;
        let form = [1.0 + random.next(), 0.5 * random.next(), -0.7, 0.2, 0.0, 0.0];
        let a = height(form, motion);
        let tolerance = a.tolerance();
        for gap in [0.0, 0.4, -0.4, 1.6, -1.6, 30.0, -30.0, 1e3, -1e5, 1e6].map(|factor| factor * tolerance) {
            let b = height([0.2, 0.0, 0.1, 0.0, 0.0, gap], motion);
            for (a, b) in [(&a, &b), (&b, &a)] {
                let paths = meet(a, b);
                assert!(paths.unresolved.is_empty(), "{k} {gap}: {} {:?}", summary(&paths), paths.unresolved);
                // Two paths in any case; through the crossing or past the middle, on the sides that
                // the gap says.
                assert!(paths.len() == 2 && paths.closed == [false, false], "{k} {gap}: {}", summary(&paths));
                let inverse = turn.transpose();
                let own = |n: usize| -> Vec<DVec2> {
                    paths.points_of(n).iter().map(|p| (inverse * (*p - shift)).truncate()).collect()
                };
                if gap.abs() < tolerance {
                    let contact = only(&paths);
                    assert_eq!(contact.kind, ContactKind::Crossing);
                    for n in 0..2 {
                        let near = if gap == 0.0 { 1e-7 } else { 1e-3 };
                        assert!(own(n).iter().any(|p| p.length() < near), "{k} {gap}: path {n}");
                    }
                    continue;
                }
                assert!(paths.contacts.is_empty());
                for n in 0..2 {
                    // Where a is above b by a form that is positive in x, paths cross y = 0 if the gap
                    // is positive, and x = 0 else.
                    let across = |p: &DVec2| if gap > 0.0 { p.y } else { p.x };
                    let along = |p: &DVec2| if gap > 0.0 { p.x } else { p.y };
                    let points = own(n);
                    assert!(points.iter().any(|p| across(p) < 0.0) && points.iter().any(|p| across(p) > 0.0));
                    let sides = [points.iter().all(|p| along(p) < 0.0), points.iter().all(|p| along(p) > 0.0)];
                    assert!(sides[0] || sides[1] || form[1].abs() > 0.0, "{k} {gap}");
                }
            }
        }
    }
}

/// The tube of radius 1 about the line x = 1, y = 0.
fn tube(cells: [usize; 2], radius: f64) -> Surface<'static> {
    let shape = Shape {
        name: "tube",
        cells,
        closed: [false, true],
        point: |u, v| DVec3::new((TAU * v).cos(), (TAU * v).sin(), 5.0 * u - 2.5),
    };
    surface(&shape, |p| DVec3::new(1.0 + radius * p.x, radius * p.y, p.z))
}

#[test]
fn vivianis_curve() {
    // With the poles away from the curve.
    let sphere = surface(&ball(24, 48), |p| 2.0 * DVec3::new(p.x, p.z, -p.y));
    // Its length, by chords.
    let viviani = |t: f64| DVec3::new(1.0 + t.cos(), t.sin(), 2.0 * (0.5 * t).sin());
    let step = 2.0 * TAU / 1e5;
    let exact: f64 =
        (0..100_000).map(|k| viviani(step * f64::from(k)).distance(viviani(step * f64::from(k + 1)))).sum();
    for cells in [[8, 24], [9, 23], [16, 32]] {
        let tube = tube(cells, 1.0);
        for paths in [meet(&sphere, &tube), meet(&tube, &sphere)] {
            let contact = only(&paths);
            assert!(contact.kind == ContactKind::Crossing, "{contact:?}");
            // Two loops through the double point, above and below.
            assert!(paths.len() == 2 && paths.closed == [true, true], "{cells:?}: {}", summary(&paths));
            assert!((length(&paths) / exact - 1.0).abs() < 1e-3, "{} {exact}", length(&paths));
            for n in 0..2 {
                let points = paths.points_of(n);
                assert_eq!(points.iter().filter(|p| p.distance(2.0 * DVec3::X) < 1e-12).count(), 1);
                assert!(points.iter().all(|p| p.z > -1e-9) || points.iter().all(|p| p.z < 1e-9));
            }
        }
    }
}

#[test]
fn vivianis_curve_perturbed() {
    // A tube inside the sphere at the double point gives two loops, and one that pierces it there
    // gives one.
    let sphere = surface(&ball(24, 48), |p| 2.0 * DVec3::new(p.x, p.z, -p.y));
    for by in [1e-3, 1e-5, 1e-7] {
        for (radius, count) in [(1.0 - by, 2), (1.0 + by, 1)] {
            let tube = tube([9, 32], radius);
            for paths in [meet(&sphere, &tube), meet(&tube, &sphere)] {
                assert!(paths.unresolved.is_empty() && paths.contacts.is_empty(), "{by} {radius}: {}", summary(&paths));
                assert!(paths.len() == count && paths.closed.iter().all(|c| *c), "{by} {radius}: {}", summary(&paths));
            }
        }
    }
}

#[test]
fn balls_that_overlap_by_little_have_one_loop() {
    let shape = ball(12, 24);
    let a = surface(&shape, |p| p);
    for by in [1e-3, 1e-5, 1e-7] {
        for axis in [DVec3::X, -DVec3::Y] {
            let b = surface(&shape, |p| p + (2.0 - by) * axis);
            let paths = meet(&a, &b);
            assert!(paths.len() == 1 && paths.closed[0], "{by}: {}", summary(&paths));
            assert!(paths.unresolved.is_empty() && paths.contacts.is_empty(), "{by}: {}", summary(&paths));
            let radius = (1.0 - (1.0 - 0.5 * by) * (1.0 - 0.5 * by)).sqrt();
            // Interpolants have not quite the curvature of balls.
            assert!((length(&paths) / (TAU * radius) - 1.0).abs() < 0.15, "{by}: {}", length(&paths));
        }
    }
}

#[test]
fn a_wider_tolerance_touches_more() {
    let shape = ball(12, 24);
    let a = surface(&shape, |p| p);
    for gap in [3e-5, -3e-5] {
        let b = surface(&shape, |p| p + (2.0 + gap) * DVec3::X);
        let options = Options { tolerance: Some(1e-4), ..Options::default() };
        let paths = a.meet(&b, &options, &Job::default()).unwrap();
        check(&paths, &a, &b);
        let contact = only(&paths);
        assert!(paths.is_empty() && contact.kind == ContactKind::Point, "{}", summary(&paths));
        // The second ball's normals at that side look the other way.
        assert!((contact.gap + gap).abs() < 1e-9, "{}", contact.gap);
    }
}

/// The saddle of three valleys against its plane, one cell each: three lines through a contact that
/// no second form decides. Unresolved cells are there; elsewhere the lines are found.
#[test]
fn branches_beside_a_contact_of_higher_order_are_found() {
    let points: Vec<DVec3> = (0..25)
        .map(|k| {
            let (a, b) = (k / 5, k % 5);
            DVec3::new(power(1, a), power(1, b), power(3, a) - 3.0 * power(1, a) * power(2, b))
        })
        .collect();
    let saddle = one(Sheet::High(Patches::new(&points, [4, 4], 1, 1).unwrap()));
    let plane = height([0.0; 6], |p| DVec3::new(1.25 * p.x - 0.05, 1.2 * p.y + 0.05, 0.0));
    let paths = meet(&saddle, &plane);
    let expected = 2.0 + 4.0 * (4.0f64 / 3.0).sqrt();
    let found = length(&paths);
    assert!((found / expected - 1.0).abs() < 0.01, "{found} {expected} {}", summary(&paths));
}
