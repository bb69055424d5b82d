//! Sections that repeat an earlier one: all their nodes coincide with the corresponding ones.
//!
//! A frame keeps them: the curves along the body merge the repeated points or call them crowded. A
//! surface has no room between two of them, and its slopes there are undefined.

use super::NodeGrid;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::{Aabb, scale::common_unit};

/// Corresponding nodes coincide if they are at most this part of the larger section's size apart.
const REPEAT_TOLERANCE: f64 = 1e-6;

/// A section that repeats an earlier one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RepeatedSection {
    /// The section.
    pub section: u32,
    /// The section with the same nodes.
    pub earlier: u32,
}

/// Finds the sections that repeat the last section before them that repeats none, in ascending
/// order. In a `ring`, the last section also repeats the first one if they coincide.
///
/// Two sections coincide if each node of one is within 10^-6 of the larger one's size from the
/// other's node in the same column. The size is the longest side of the bounding box. If both are
/// points, the size of the largest section counts.
///
/// # Errors
/// [`Error::OutOfMemory`](gusset_base::error::Error::OutOfMemory).
pub fn repeated_sections(grid: &NodeGrid, ring: bool) -> Result<Vec<RepeatedSection>> {
    let unit = common_unit(&grid.nodes);
    let row = |k: usize| grid.nodes[k * grid.columns..(k + 1) * grid.columns].iter().map(|&node| node / unit);
    let size = |k: usize| Aabb::from_points(row(k)).size().max_element();
    let sizes = alloc::collect((0..grid.rows).map(size))?;
    let largest = sizes.iter().copied().fold(0.0, f64::max);
    let coincide = |a: usize, b: usize| {
        let larger = sizes[a].max(sizes[b]);
        let tolerance = REPEAT_TOLERANCE * if larger > 0.0 { larger } else { largest };
        row(a).zip(row(b)).all(|(p, q): (DVec3, DVec3)| p.distance(q) <= tolerance)
    };
    let (mut found, mut distinct) = (Vec::new(), 0);
    for k in 1..grid.rows {
        if coincide(distinct, k) {
            alloc::push(&mut found, RepeatedSection { section: k as u32, earlier: distinct as u32 })?;
        } else {
            distinct = k;
        }
    }
    if ring && distinct > 0 && coincide(0, distinct) {
        let last = distinct as u32;
        // The sections behind the last one repeat the first one too.
        let behind = found.partition_point(|repeat| repeat.section < last);
        found[behind..].iter_mut().for_each(|repeat| repeat.earlier = 0);
        alloc::push(&mut found, RepeatedSection { section: last, earlier: 0 })?;
        found[behind..].rotate_right(1);
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::super::{Correspondence, FrameOptions, frame};
    use super::*;
    use crate::identify::{Outlines, Points};
    use gusset_base::job::Job;
    use std::f64::consts::TAU;

    /// A closed section of 12 points, or a tip if the radius is 0.
    fn ring(radius: f64, z: f64) -> Vec<[f64; 3]> {
        let count = if radius > 0.0 { 12 } else { 1 };
        let angle = |i: usize| TAU * i as f64 / count as f64;
        (0..count).map(|i| [radius * angle(i).cos(), radius * angle(i).sin(), z]).collect()
    }

    /// Pairs of a repeated section and the earlier one, in a frame of circles with these radii and heights.
    fn repeats(circles: &[[f64; 2]], closes: bool, unit: f64) -> Vec<[u32; 2]> {
        let sections: Vec<Vec<[f64; 3]>> = circles.iter().map(|&[radius, z]| ring(radius * unit, z * unit)).collect();
        let mut offsets = vec![0];
        sections.iter().for_each(|section| offsets.push(offsets[offsets.len() - 1] + section.len() as u32));
        let points = sections.concat();
        let outlines =
            Outlines { points: Points::from(&points[..]), offsets: Some(&offsets), closed: true, constraints: &[] };
        let options = FrameOptions { ring: closes, ..FrameOptions::new(Correspondence::ArcLength { columns: 16 }) };
        let made = frame(&outlines, &options, &Job::default()).unwrap();
        repeated_sections(&made.grid, closes).unwrap().iter().map(|found| [found.section, found.earlier]).collect()
    }

    #[test]
    fn sections_repeat_if_all_their_nodes_coincide() {
        // The diameter is 2: nodes 2e-6 apart coincide.
        for unit in [1e-200, 1e-3, 1.0, 1e200] {
            for (circles, expected) in [
                (&[[1.0, 0.0], [1.0, 0.0], [1.0, 1.0]][..], &[[1, 0]][..]),
                (&[[1.0, 0.0], [1.0, 1.0], [1.0, 1.0]], &[[2, 1]]),
                (&[[1.0, 0.0], [1.0, 1e-9], [1.0, 1.0], [1.0, 2.0]], &[[1, 0]]),
                // Sections do not drift: the third is too far from the first, and is kept.
                (&[[1.0, 0.0], [1.0, 1.5e-6], [1.0, 3e-6], [1.0, 1.0]], &[[1, 0]]),
                (&[[1.0, 0.0], [1.0, 0.0], [1.0, 0.0], [1.0, 1.0], [1.0, 1.0]], &[[1, 0], [2, 0], [4, 3]]),
                (&[[1.0, 0.0], [1.0, 3e-6], [1.0, 1.0]], &[]),
                // Different sections in one plane do not coincide.
                (&[[1.0, 0.0], [0.9, 0.0], [0.9, 1.0]], &[]),
                // A section returns: not consecutive.
                (&[[1.0, 0.0], [1.0, 1.0], [1.0, 0.0]], &[]),
                // Tips, and a small section beside a tip.
                (&[[0.0, 0.0], [0.0, 1e-9], [1.0, 1.0]], &[[1, 0]]),
                (&[[0.0, 0.0], [1e-7, 1e-7], [1.0, 1.0]], &[]),
            ] {
                assert_eq!(repeats(circles, false, unit), expected, "{unit}: {circles:?}");
            }
        }
    }

    #[test]
    fn the_last_sections_of_a_ring_may_repeat_the_first() {
        let around = [[1.0, 0.0], [2.0, 1.0], [3.0, 0.0], [2.0, -1.0], [1.0, 0.0], [1.0, 0.0]];
        assert_eq!(repeats(&around, true, 1.0), [[4, 0], [5, 0]]);
        assert_eq!(repeats(&around, false, 1.0), [[5, 4]]);
        assert_eq!(repeats(&around[..4], true, 1.0), [[0; 2]; 0]);
        assert_eq!(repeats(&[around[0]; 3], true, 1.0), [[1, 0], [2, 0]]);
    }
}
