//! Intersects a line with four boxes at once: the slab test (Kay and Kajiya 1986).
//!
//! Invariant: the entry into a box is early, and the exit late, by at least the rounding error of
//! the line. No box that the line meets is missed.

use super::boxes::ChildBoxes;
use glam::DVec3;

/// A line prepared for the slab test, which intersects it with the space between two parallel
/// planes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LineSlabTest {
    /// For each axis, the line's point at parameter 0, shifted so that entries are early (`point_for_early_entry`)
    /// or exits late (`point_for_late_exit`).
    point_for_early_entry: [f64; 3],
    point_for_late_exit: [f64; 3],
    inverse_direction: [f64; 3],
    /// For each axis, true if the line runs towards smaller coordinates.
    is_direction_negative: [bool; 3],
}

impl LineSlabTest {
    /// Prepares a line. `foot` is a point of the line, relative to the index's origin. `rounding`
    /// bounds the rounding error of all quantities computed for the line.
    pub(crate) fn new(foot: DVec3, direction: DVec3, rounding: f64) -> LineSlabTest {
        let falls = direction.to_array().map(|x| x < 0.0);
        let moved = |axis: usize, by: f64| foot[axis] + if falls[axis] { -by } else { by };
        LineSlabTest {
            point_for_early_entry: [0, 1, 2].map(|axis| moved(axis, rounding)),
            point_for_late_exit: [0, 1, 2].map(|axis| moved(axis, -rounding)),
            inverse_direction: direction.to_array().map(|x| if x == 0.0 { f64::INFINITY } else { x.recip() }),
            is_direction_negative: falls,
        }
    }

    /// The parameters, within `from` to `to`, at which the line enters and leaves each box. If the
    /// entry is greater than the exit, the line misses the box.
    #[inline(always)]
    pub(crate) fn entries_and_exits_of_boxes(&self, boxes: &ChildBoxes, from: f64, to: f64) -> [[f64; 4]; 2] {
        let (mut near, mut far) = ([from; 4], [to; 4]);
        for axis in 0..3 {
            let (low, high) = (&boxes.low[axis], &boxes.high[axis]);
            let (first, last) = if self.is_direction_negative[axis] { (high, low) } else { (low, high) };
            for child in 0..4 {
                // A line in a side of a box gives 0 times infinity here. NaN is not greater, so it
                // is ignored.
                let enters =
                    (f64::from(first[child]) - self.point_for_early_entry[axis]) * self.inverse_direction[axis];
                let leaves = (f64::from(last[child]) - self.point_for_late_exit[axis]) * self.inverse_direction[axis];
                near[child] = if enters > near[child] { enters } else { near[child] };
                far[child] = if leaves < far[child] { leaves } else { far[child] };
            }
        }
        [near, far]
    }
}
