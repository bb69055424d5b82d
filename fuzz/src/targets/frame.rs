//! Sections of any points made a frame: an error, or finite nodes of the size that was asked for, on which both
//! families of curves pass.

use crate::agree::agreed;
use crate::input::{self, Cloud, places};
use glam::DVec3;
use gusset::curve::frame::{Axis, Correspondence, FrameOptions, frame};
use gusset::curve::{Outlines, Points};

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some(input) = input::taken::<(Cloud, [u8; 4], [bool; 4])>(bytes) else { return };
    let (points, [sections, columns, kind, choice], [closed, ring, starts, smooth]) = input;
    let count = 2 + usize::from(sections % 4);
    let each = points.len().min(48) / count;
    let points: Vec<[f64; 3]> = places(&points[..each * count])
        .iter()
        .zip(0..)
        .map(|(&p, k)| (p + DVec3::Z * (300 * (k / each)) as f64).to_array())
        .collect();
    let offsets: Vec<u32> = (0..=count).map(|k| (k * each) as u32).collect();
    let outlines = Outlines { points: Points::from(&points[..]), offsets: Some(&offsets), closed, constraints: &[] };
    let columns = usize::from(columns % 8);
    let axis = Axis::Line { point: DVec3::ZERO, direction: DVec3::Z };
    let correspondence = match kind % 3 {
        0 => Correspondence::Given,
        1 => Correspondence::ArcLength { columns },
        _ => Correspondence::Angle { columns, axis, reference: DVec3::X },
    };
    let options =
        FrameOptions { ring, given_starts: starts, smooth_corners: smooth, ..FrameOptions::new(correspondence) };
    let Ok(made) = agreed(choice, |job| frame(&outlines, &options, job)) else { return };
    assert_eq!(made.grid.nodes.len(), made.grid.rows * made.grid.columns);
    assert!(made.grid.rows == count && made.grid.nodes.iter().all(|node| node.is_finite()));
    assert!(made.across.points().iter().chain(made.along.points()).all(|point| point.is_finite()));
}
