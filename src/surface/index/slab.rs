//! A line against four boxes at once.

use super::Group;
use glam::DVec3;

/// A line as boxes see it, for the test of slabs: where it enters and leaves the space between two parallel planes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slab {
    /// By axis: where the line is when its parameter is 0, moved so far that boxes are entered too early, or left too late.
    enter: [f64; 3],
    leave: [f64; 3],
    inverse: [f64; 3],
    /// By axis: true if the line runs towards lesser coordinates.
    falls: [bool; 3],
}

impl Slab {
    /// `foot`: a point of the line, relative to the index's origin; `play`: how far all that is computed of the line may be off.
    pub(crate) fn new(foot: DVec3, direction: DVec3, play: f64) -> Slab {
        let falls = direction.to_array().map(|x| x < 0.0);
        let moved = |axis: usize, by: f64| foot[axis] + if falls[axis] { -by } else { by };
        Slab {
            enter: [0, 1, 2].map(|axis| moved(axis, play)),
            leave: [0, 1, 2].map(|axis| moved(axis, -play)),
            inverse: direction.to_array().map(|x| if x == 0.0 { f64::INFINITY } else { x.recip() }),
            falls,
        }
    }

    /// From where to where the line is in each box, within `from` to `to`; where the first is greater, not at all.
    #[inline(always)]
    pub(crate) fn through(&self, group: &Group, from: f64, to: f64) -> [[f64; 4]; 2] {
        let (mut near, mut far) = ([from; 4], [to; 4]);
        for axis in 0..3 {
            let (low, high) = (&group.low[axis], &group.high[axis]);
            let (first, last) = if self.falls[axis] { (high, low) } else { (low, high) };
            for child in 0..4 {
                // A line in a side of a box gives 0 x infinity here, which is not greater and so does not count.
                let enters = (f64::from(first[child]) - self.enter[axis]) * self.inverse[axis];
                let leaves = (f64::from(last[child]) - self.leave[axis]) * self.inverse[axis];
                near[child] = if enters > near[child] { enters } else { near[child] };
                far[child] = if leaves < far[child] { leaves } else { far[child] };
            }
        }
        [near, far]
    }
}
