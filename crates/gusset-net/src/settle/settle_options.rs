//! The options of [`settle`](super::settle()).

use crate::Net;

/// The options of [`settle`](super::settle()): the movable parts, the reference shape and the
/// limits.
#[derive(Debug, Clone, Copy, Default)]
pub struct SettleOptions<'a> {
    /// The displacement below which a step is the last, relative to the diagonal of the net's
    /// bounding box; 0 means 1e-12.
    pub tolerance: f64,
    /// The maximum number of steps; 0 means 1000.
    pub max_iterations: u32,
    /// Rest lengths as a multiple of the reference's lengths, above 0; 0 means 1.
    pub rest_ratio: f64,
    /// The net at rest, of the same size. It determines rest lengths and the shape of rigid
    /// bridges. `None` means the net itself.
    pub reference: Option<&'a Net<'a>>,
    /// Marks the parts that move, each as a rigid body, in order along the direction of the
    /// bridges. If empty, all parts are held.
    pub free: &'a [bool],
}
