//! The continuity of a plate with the surface to which it is clamped.

use gusset_base::choices;

/// The continuity of a new surface with the old one along their common border.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Continuity {
    /// Common tangent planes: minimises the Laplacian.
    #[default]
    C1,
    /// Common curvature too: minimises the gradient of the Laplacian. Depends on two rings of old
    /// faces, and on their noise.
    C2,
}

choices! { for Continuity:
    C1 => "Tangents", "The patch leaves the old surface along its tangent planes.";
    C2 => "Curvature", "The patch also continues the curvature of the old surface, taken from two rings of its faces.";
}
