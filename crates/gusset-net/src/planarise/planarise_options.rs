//! The options of [`planarise`](super::planarise()).

/// What may be moved, and how far to go.
#[derive(Debug, Clone, Copy, Default)]
pub struct PlanariseOptions<'a> {
    /// The distance of corners from their plane that is plane enough, in diagonals of the net's box;
    /// 0: 1e-10, for nets of single precision the rounding of their coordinates, 4e-7.
    pub tolerance: f64,
    /// The largest number of steps; 0: 100.
    pub max_iterations: u32,
    /// Vertices on the boundary of the surface stay.
    pub keep_boundary: bool,
    /// Nodes that stay, with those that are glued to them: one flag a node, or none at all.
    pub fixed: &'a [bool],
}
