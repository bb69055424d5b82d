//! How smoothly a plate goes on what it is clamped to.

use gusset_base::choices;

/// What a new surface has in common with the old one where they meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Continuity {
    /// The tangent planes: its Laplacian is least.
    #[default]
    C1,
    /// The curvature, too: the gradient of its Laplacian is least. Two rings of old faces have a
    /// say, and with them their noise.
    C2,
}

choices! { for Continuity:
    C1 => "Tangents", "The patch leaves the old surface along its tangent planes.";
    C2 => "Curvature", "The patch also continues the curvature of the old surface, taken from two rings of its faces.";
}
