//! The options of [`settle`](super::settle()).

use crate::Net;

/// What may move, and from which shape forces are counted.
#[derive(Debug, Clone, Copy, Default)]
pub struct SettleOptions<'a> {
    /// The displacement below which a step is the last, in diagonals of the net's box; 0: 1e-12.
    pub tolerance: f64,
    /// The largest number of steps; 0: 1000.
    pub max_iterations: u32,
    /// Rest lengths as a multiple of those in the reference, above 0; 0: 1.
    pub rest_ratio: f64,
    /// The net at rest, of the same size, which gives rest lengths and the shape of rigid bridges;
    /// `None`: the net as it is given.
    pub reference: Option<&'a Net<'a>>,
    /// The parts that move, each as a rigid body, in order along the direction of the bridges; none
    /// given: all are held.
    pub free: &'a [bool],
}
