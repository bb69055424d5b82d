//! Surfaces through sections: the sections are contained, corners stay, and nothing bulges.

use glam::{DMat3, DVec3};
use gusset::curve::frame::{Correspondence, FrameOptions, frame};
use gusset::curve::{Options, Outlines, Points};
use gusset::surface::Sheet;
use gusset::surface::construct::FrameSurface;
use gusset::{Error, Job};
use std::f64::consts::TAU;

fn loft(sections: &[Vec<DVec3>], closed: bool, columns: usize) -> Sheet<'static> {
    let points: Vec<[f64; 3]> = sections.iter().flatten().map(DVec3::to_array).collect();
    let mut offsets = vec![0];
    sections.iter().for_each(|section| offsets.push(offsets[offsets.len() - 1] + section.len() as u32));
    let outlines = Outlines { points: Points::from(&points[..]), offsets: Some(&offsets), closed, constraints: &[] };
    let curves = Options::default();
    let options =
        FrameOptions { across: curves, along: curves, ..FrameOptions::new(Correspondence::ArcLength { columns }) };
    let made = frame(&outlines, &options, &Job::default()).unwrap();
    Sheet::from_frame(&made, [false, closed], FrameSurface::Sections, &Job::default()).unwrap()
}

/// Points of the rows of cells from `from` to `to`.
fn points(sheet: &Sheet<'_>, from: usize, to: usize) -> Vec<DVec3> {
    let across = sheet.cells()[1];
    let at = |k: usize| f64::from(k as u32 % 9) / 8.0;
    (from..to)
        .flat_map(|i| (0..across).flat_map(move |j| (0..81).map(move |k| (i, j, at(k), at(k / 9)))))
        .map(|(i, j, u, v)| sheet.jet(i, j, u, v).point)
        .collect()
}

/// The area of the closed curve at the start of row i.
fn area(sheet: &Sheet<'_>, i: usize) -> f64 {
    let [rows, across] = sheet.cells();
    let (row, u) = if i == rows { (i - 1, 1.0) } else { (i, 0.0) };
    let ring: Vec<DVec3> = (0..across)
        .flat_map(|j| (0..16).map(move |k| (j, f64::from(k) / 16.0)))
        .map(|(j, v)| sheet.jet(row, j, u, v).point)
        .collect();
    let sum: DVec3 = (1..ring.len() - 1).map(|k| (ring[k] - ring[0]).cross(ring[k + 1] - ring[0])).sum();
    0.5 * sum.length()
}

/// A random rotation, length and shift.
fn placement(random: &mut fastrand::Rng) -> impl Fn(DVec3) -> DVec3 + use<> {
    let axis = DVec3::from_array(std::array::from_fn(|_| random.f64() - 0.5)).normalize();
    let (rotation, unit) = (DMat3::from_axis_angle(axis, TAU * random.f64()), 10f64.powf(6.0 * random.f64() - 3.0));
    let shift = DVec3::from_array(std::array::from_fn(|_| 10.0 * random.f64()));
    move |p| unit * (rotation * p + shift)
}

fn ring(count: usize, from: f64, point: impl Fn(f64) -> DVec3) -> Vec<DVec3> {
    (0..count).map(|k| point(from + TAU * k as f64 / count as f64)).collect()
}

#[test]
fn equal_sections_have_their_cylinder_between_them() {
    let mut random = fastrand::Rng::with_seed(1);
    for case in 0..60 {
        let place = placement(&mut random);
        let unit = place(DVec3::X).distance(place(DVec3::ZERO));
        let (wide, narrow) = (1.0 + random.f64(), 0.2 + 0.5 * random.f64());
        // Two equal sections, a step, and two equal sections.
        let radii = [wide, wide, narrow, narrow];
        let mut height = 0.0;
        let sections: Vec<Vec<DVec3>> = radii
            .iter()
            .map(|r| {
                height += 0.3 + random.f64();
                let count = 16 + random.usize(..20);
                ring(count, TAU * random.f64(), |t| place(DVec3::new(r * t.cos(), r * t.sin(), height)))
            })
            .collect();
        let sheet = loft(&sections, true, 32);
        let axis = (place(DVec3::Z) - place(DVec3::ZERO)).normalize();
        for (rows, radius) in [([0, 1], wide), ([2, 3], narrow)] {
            for p in points(&sheet, rows[0], rows[1]) {
                let off = (p - place(DVec3::ZERO)).reject_from(axis).length() / unit / radius - 1.0;
                assert!(off.abs() < 0.01, "{case}: {off}");
            }
        }
        // The step does not leave the range of the radii.
        for p in points(&sheet, 1, 2) {
            let radius = (p - place(DVec3::ZERO)).reject_from(axis).length() / unit;
            assert!((0.99 * narrow..1.01 * wide).contains(&radius), "{case}: {radius}");
        }
    }
}

#[test]
fn polygons_keep_their_corners_and_areas() {
    let mut random = fastrand::Rng::with_seed(7);
    for case in 0..60 {
        let place = placement(&mut random);
        let unit = place(DVec3::X).distance(place(DVec3::ZERO));
        let sides = 3 + case % 4;
        let sizes = [1.0 + random.f64(), 0.5 + random.f64(), 0.7 + random.f64()];
        let widths = [2.0, 1.5, 1.0];
        let turn = TAU * random.f64();
        // The first two have corners only, and may be wide; the last one has points on its sides too.
        let polygon = |k: usize| {
            let corner = |i: usize| {
                let t = turn + TAU * (i % sides) as f64 / sides as f64;
                place(DVec3::new(widths[k] * sizes[k] * t.cos(), sizes[k] * t.sin(), 2.0 * k as f64))
            };
            let parts = if k == 2 { 4 } else { 1 };
            (0..sides)
                .flat_map(|i| (0..parts).map(move |j| corner(i).lerp(corner(i + 1), f64::from(j) / f64::from(parts))))
                .collect::<Vec<_>>()
        };
        let sections: Vec<Vec<DVec3>> = (0..3).map(polygon).collect();
        let sheet = loft(&sections, true, 32);
        for (k, size) in sizes.iter().enumerate() {
            let exact = 0.5 * sides as f64 * (TAU / sides as f64).sin() * widths[k] * size * size;
            let off = area(&sheet, k) / (unit * unit) / exact - 1.0;
            assert!(off.abs() < 1e-9, "{case} {k}: {off}");
        }
    }
}

#[test]
fn cones_have_closed_tips() {
    let mut random = fastrand::Rng::with_seed(3);
    for case in 0..40 {
        let place = placement(&mut random);
        let unit = place(DVec3::X).distance(place(DVec3::ZERO));
        let (height, lower) = (0.5 + 2.0 * random.f64(), 1 + case % 3);
        let radius = |z: f64| 1.0 - z / height;
        let mut sections: Vec<Vec<DVec3>> = (0..lower)
            .map(|k| height * 0.8 * k as f64 / lower as f64)
            .map(|z| ring(24, TAU * random.f64(), |t| place(DVec3::new(radius(z) * t.cos(), radius(z) * t.sin(), z))))
            .collect();
        sections.push(vec![place(DVec3::Z * height)]);
        if case % 2 == 1 {
            sections.reverse();
        }
        let sheet = loft(&sections, true, 24);
        let axis = (place(DVec3::Z) - place(DVec3::ZERO)).normalize();
        for p in points(&sheet, 0, lower) {
            let from_base = p - place(DVec3::ZERO);
            let (z, r) = (from_base.dot(axis) / unit, from_base.reject_from(axis).length() / unit);
            assert!((r - radius(z)).abs() < 2e-3, "{case}: {r} at {z}");
        }
        let poles = sheet.poles_at_sides()[0];
        assert_eq!(poles, [case % 2 == 1, case % 2 == 0], "{case}");
        // The normal at the tip is defined.
        let [rows, across] = sheet.cells();
        let row = if case % 2 == 1 { 0 } else { rows - 1 };
        for j in 0..across {
            let normal = sheet.normal(row, j, if case % 2 == 1 { 0.0 } else { 1.0 }, 0.5);
            assert!((normal.length() - 1.0).abs() < 1e-9, "{case}: {normal}");
        }
    }
}

#[test]
fn sections_with_and_without_corners_are_all_contained() {
    // A square, a circle, and a square.
    let square =
        |z: f64| [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]].map(|[x, y]| DVec3::new(x, y, z)).to_vec();
    let circle = ring(40, 0.1, |t| DVec3::new(t.cos(), t.sin(), 1.0));
    let sheet = loft(&[square(0.0), circle, square(2.0)], true, 32);
    assert!((area(&sheet, 0) - 4.0).abs() < 1e-12 && (area(&sheet, 2) - 4.0).abs() < 1e-12);
    assert!((area(&sheet, 1) / (0.5 * TAU) - 1.0).abs() < 0.01);
    // Open sections: a chine of some sections only.
    let bent = |z: f64| {
        vec![
            DVec3::new(0.0, 0.0, z),
            DVec3::new(0.5, 0.0, z),
            DVec3::new(1.0, 0.0, z),
            DVec3::new(1.0, 0.5, z),
            DVec3::new(1.0, 1.0, z),
        ]
    };
    let arc =
        (0..=20).map(|k| 0.25 * TAU * f64::from(k) / 20.0).map(|t| DVec3::new(t.sin(), 1.0 - t.cos(), 1.0)).collect();
    let sheet = loft(&[bent(0.0), arc, bent(2.0)], false, 16);
    let chine = points(&sheet, 0, 1)
        .into_iter()
        .filter(|p| p.z == 0.0)
        .map(|p| p.distance(DVec3::X))
        .fold(f64::INFINITY, f64::min);
    assert!(chine < 1e-12, "{chine}");
}

#[test]
fn repeated_sections_are_refused_with_their_indices() {
    let circle = |z: f64| ring(16, 0.0, |t| DVec3::new(t.cos(), t.sin(), z));
    for (heights, expected) in [
        (&[0.0, 0.0, 1.0][..], Some([1, 0])),
        (&[0.0, 1.0, 1.0], Some([2, 1])),
        (&[0.0, 1e-9, 1.0, 2.0], Some([1, 0])),
        (&[0.0, 1e-4, 1.0, 2.0], None),
    ] {
        let sections: Vec<Vec<DVec3>> = heights.iter().map(|&z| circle(z)).collect();
        let points: Vec<[f64; 3]> = sections.iter().flatten().map(DVec3::to_array).collect();
        let offsets: Vec<u32> = (0..=sections.len() as u32).map(|k| 16 * k).collect();
        let outlines =
            Outlines { points: Points::from(&points[..]), offsets: Some(&offsets), closed: true, constraints: &[] };
        let made = frame(&outlines, &FrameOptions::new(Correspondence::Given), &Job::default()).unwrap();
        for kind in [FrameSurface::Sections, FrameSurface::Nodes, FrameSurface::Curves] {
            let refused = Sheet::from_frame(&made, [false, true], kind, &Job::default()).err();
            let error = expected.map(|[section, earlier]| Error::RepeatedSection { section, earlier });
            assert_eq!(refused, error, "{heights:?} {kind:?}");
        }
    }
}
