//! The options of [`planarise`](super::planarise()).

/// The progress message.
pub(super) const STAGE: &str = "planarise";

/// The options of [`planarise`](super::planarise()): the movable vertices and the limits.
#[derive(Debug, Clone, Copy, Default)]
pub struct PlanariseOptions<'a> {
    /// The distance of corners from their plane that counts as plane, relative to the diagonal of
    /// the net's bounding box. 0 means 1e-10, and for nets in single precision 4e-7, the rounding
    /// of their coordinates.
    pub tolerance: f64,
    /// The maximum number of steps; 0 means 100.
    pub max_iterations: u32,
    /// Keeps vertices on the boundary of the surface fixed.
    pub keep_boundary: bool,
    /// Marks nodes that stay, together with the nodes glued to them: one flag a node, or empty.
    pub fixed: &'a [bool],
}
