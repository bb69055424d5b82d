//! Frames of sections that lack points: filled points are near the body, given points are kept.

use glam::DVec3;
use gusset::curve::frame::{Correspondence, Frame, FrameOptions, frame};
use gusset::curve::{Outlines, Points};
use gusset::{Element, Error, Job};
use std::f64::consts::TAU;

/// Numbers from 0 to 1.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

const COLUMNS: usize = 20;

fn make(nodes: &[DVec3], rows: usize, ring: bool, missing: &[u32]) -> Result<Frame, Error> {
    let points: Vec<[f64; 3]> = nodes.iter().map(DVec3::to_array).collect();
    let columns = nodes.len() / rows;
    let offsets: Vec<u32> = (0..=rows).map(|k| (k * columns) as u32).collect();
    let points = Points::from(&points[..]);
    let sections = Outlines { points, offsets: Some(&offsets), closed: true, constraints: &[] };
    let options = FrameOptions { ring, missing, ..FrameOptions::new(Correspondence::Given) };
    frame(&sections, &options, &Job::default())
}

/// A body with a waist, bent, its sections ellipses that turn; s from 0 to 1 along it.
fn body(s: f64, column: usize) -> DVec3 {
    let (t, r) = (TAU * column as f64 / COLUMNS as f64 + 0.5 * s, 1.0 + 0.3 * (3.0 * s).sin());
    DVec3::new(r * t.cos() + s * s, 0.7 * r * t.sin(), 3.0 * s + 0.2 * s * s)
}

/// A ring: a torus.
fn torus(s: f64, column: usize) -> DVec3 {
    let (t, a) = (TAU * column as f64 / COLUMNS as f64, TAU * s);
    let r = 2.0 + 0.5 * t.cos();
    DVec3::new(r * a.cos(), r * a.sin(), 0.5 * t.sin())
}

/// The nodes with some of them lost, and which.
fn with_holes(nodes: &[DVec3], rows: usize, ring: bool, seed: u64) -> (Vec<DVec3>, Vec<u32>) {
    let (mut random, mut holed, mut missing) = (Random(seed), nodes.to_vec(), Vec::new());
    for k in 0..nodes.len() {
        let at_end = !ring && (k < COLUMNS || k / COLUMNS == rows - 1);
        // One at a time in a column: longer gaps at random would hide the order.
        let lost = |k: usize| missing.contains(&((k % nodes.len()) as u32));
        let is_next = lost(k + nodes.len() - COLUMNS) || lost(k + COLUMNS);
        if !at_end && !is_next && random.next() < 0.15 {
            holed[k] = DVec3::splat([f64::NAN, f64::INFINITY, 1e300][k % 3]);
            missing.push(k as u32);
        }
    }
    (holed, missing)
}

#[test]
fn missing_nodes_are_near_the_body() {
    for (ring, point) in [(false, body as fn(f64, usize) -> DVec3), (true, torus)] {
        let mut errors = Vec::new();
        for rows in [12, 24, 48] {
            let last = if ring { rows } else { rows - 1 };
            let truth: Vec<DVec3> =
                (0..rows * COLUMNS).map(|k| point((k / COLUMNS) as f64 / last as f64, k % COLUMNS)).collect();
            let (holed, mut missing) = with_holes(&truth, rows, ring, rows as u64);
            // In any order, and twice.
            missing.reverse();
            missing.push(missing[0]);
            let made = make(&holed, rows, ring, &missing).unwrap();
            missing.sort_unstable();
            missing.dedup();
            assert_eq!(made.grid.filled, missing);
            let mut worst = 0.0_f64;
            for (k, (&node, &truth)) in made.grid.nodes.iter().zip(&truth).enumerate() {
                if missing.binary_search(&(k as u32)).is_ok() {
                    worst = worst.max(node.distance(truth));
                } else {
                    assert_eq!(node, truth);
                }
            }
            errors.push(worst);
            // All else is the frame of the filled nodes.
            let mut again = make(&made.grid.nodes, rows, ring, &[]).unwrap();
            assert!(again.grid.filled.is_empty());
            again.grid.filled = missing;
            assert_eq!(made, again);
        }
        println!("ring {ring}: {errors:?}");
        // The error is of third order at least, and small from the first size.
        assert!(errors[0] < 0.1 && errors[0] / errors[1] > 5.0 && errors[1] / errors[2] > 5.0, "{ring}: {errors:?}");
    }
}

#[test]
fn sections_that_follow_a_line_are_filled_exactly() {
    // A prism with unevenly spaced sections, one of which is nearly lost: columns with both nodes
    // give the distance of sections.
    let heights = [0.0_f64, 1.0, 1.5, 4.0, 4.25, 6.0, 7.0];
    let truth: Vec<DVec3> = heights
        .iter()
        .flat_map(|&z| (0..COLUMNS).map(move |k| (TAU * k as f64 / COLUMNS as f64, z)))
        .map(|(t, z)| DVec3::new(t.cos(), t.sin(), z))
        .collect();
    let missing: Vec<u32> = (1..COLUMNS as u32).map(|k| 3 * COLUMNS as u32 + k).collect();
    let mut holed = truth.clone();
    missing.iter().for_each(|&k| holed[k as usize] = DVec3::NAN);
    let made = make(&holed, heights.len(), false, &missing).unwrap();
    for (node, truth) in made.grid.nodes.iter().zip(&truth) {
        // Exact across the line; along it the curve has the speed of centripetal parameters.
        assert!((*node - *truth).truncate().length() < 1e-15, "{node} {truth}");
        assert!((node.z - truth.z).abs() < 0.5, "{node} {truth}");
        assert!(node.z >= 0.0 && node.z <= 7.0);
    }
    // Evenly spaced sections exactly, and a section that is lost as a whole.
    let even: Vec<DVec3> = truth.iter().enumerate().map(|(k, p)| p.with_z((k / COLUMNS) as f64)).collect();
    let missing: Vec<u32> = (0..COLUMNS as u32).map(|k| 3 * COLUMNS as u32 + k).collect();
    let made = make(&even, heights.len(), false, &missing).unwrap();
    made.grid.nodes.iter().zip(&even).for_each(|(node, truth)| assert!(node.distance(*truth) < 1e-14));
}

#[test]
fn nodes_that_cannot_be_filled() {
    let rows = 5;
    let nodes: Vec<DVec3> = (0..rows * COLUMNS).map(|k| body((k / COLUMNS) as f64 / 4.0, k % COLUMNS)).collect();
    let column = |rows: &[u32]| -> Vec<u32> { rows.iter().map(|row| row * COLUMNS as u32 + 7).collect() };
    let failed = |ring: bool, missing: &[u32]| make(&nodes, rows, ring, missing).unwrap_err();
    assert_eq!(failed(false, &column(&[2, 0])), Error::NoNode { section: 0, column: 7 });
    assert_eq!(failed(false, &column(&[3, 4])), Error::NoNode { section: 3, column: 7 });
    assert_eq!(failed(true, &column(&[0, 1, 2, 3, 4])), Error::NoNode { section: 0, column: 7 });
    assert_eq!(failed(true, &column(&[0, 1, 3, 4])), Error::NoNode { section: 0, column: 7 });
    assert!(make(&nodes, rows, true, &column(&[0, 3, 4])).is_ok());
    assert_eq!(failed(false, &[100]), Error::NoSuch { element: Element::Point, index: 100, count: nodes.len() as u64 });
    // Given points must still be finite.
    let mut holed = nodes.clone();
    holed[47].y = f64::NAN;
    let found = make(&holed, rows, false, &[46]).unwrap_err();
    assert!(matches!(found, Error::NotFinite { element: Element::Point, index: 47, .. }), "{found}");
    let points: Vec<[f64; 3]> = nodes.iter().map(DVec3::to_array).collect();
    let offsets: Vec<u32> = (0..=rows).map(|k| (k * COLUMNS) as u32).collect();
    let points = Points::from(&points[..]);
    let sections = Outlines { points, offsets: Some(&offsets), closed: true, constraints: &[] };
    let way = FrameOptions { missing: &[46], ..FrameOptions::new(Correspondence::ArcLength { columns: 9 }) };
    let found = frame(&sections, &way, &Job::default()).unwrap_err();
    assert!(matches!(found, Error::OptionOutOfRange { option: "missing", value: 1.0, .. }));
}
