//! A line against four boxes at once: the slab test (Kay and Kajiya 1986).
//!
//! Invariant: boxes are entered too early and left too late by what all that is computed of the
//! line may be off, so that no box that the line meets is missed.

use super::boxes::ChildBoxes;
use glam::DVec3;

/// A line for the slab test: where it enters and leaves the space between two parallel planes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slab {
    /// By axis: the line's point of parameter 0, moved so far that boxes are entered too early, or
    /// left too late.
    enter: [f64; 3],
    leave: [f64; 3],
    inverse: [f64; 3],
    /// By axis: true if the line runs towards lesser coordinates.
    falls: [bool; 3],
}

impl Slab {
    /// `foot`: a point of the line, relative to the index's origin; `rounding`: a bound of the
    /// rounding of all that is computed of the line.
    pub(crate) fn new(foot: DVec3, direction: DVec3, rounding: f64) -> Slab {
        let falls = direction.to_array().map(|x| x < 0.0);
        let moved = |axis: usize, by: f64| foot[axis] + if falls[axis] { -by } else { by };
        Slab {
            enter: [0, 1, 2].map(|axis| moved(axis, rounding)),
            leave: [0, 1, 2].map(|axis| moved(axis, -rounding)),
            inverse: direction.to_array().map(|x| if x == 0.0 { f64::INFINITY } else { x.recip() }),
            falls,
        }
    }

    /// The parameters, within `from` to `to`, where the line enters and leaves each box; if the
    /// first is greater, it misses the box.
    #[inline(always)]
    pub(crate) fn through(&self, group: &ChildBoxes, from: f64, to: f64) -> [[f64; 4]; 2] {
        let (mut near, mut far) = ([from; 4], [to; 4]);
        for axis in 0..3 {
            let (low, high) = (&group.low[axis], &group.high[axis]);
            let (first, last) = if self.falls[axis] { (high, low) } else { (low, high) };
            for child in 0..4 {
                // A line in a side of a box gives 0 x infinity here, which is not greater and so
                // does not count.
                let enters = (f64::from(first[child]) - self.enter[axis]) * self.inverse[axis];
                let leaves = (f64::from(last[child]) - self.leave[axis]) * self.inverse[axis];
                near[child] = if enters > near[child] { enters } else { near[child] };
                far[child] = if leaves < far[child] { leaves } else { far[child] };
            }
        }
        [near, far]
    }
}
