//! The options of a section.

use gusset_base::error::{Error, Result};

/// The stage that progress reports name.
pub(super) const STAGE: &str = "cutting by planes";

/// The side of a plane to which vertices in the plane belong.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum InPlane {
    /// They count as above: the section is the limit of sections below the plane.
    #[default]
    Above,
    /// They count as below: the section is the limit of sections above the plane.
    Below,
}

gusset_base::choices! { for InPlane:
    Above => "Above", "Vertices in a plane count as above it: the section is the limit of sections just below the plane.";
    Below => "Below", "Vertices in a plane count as below it: the section is the limit of sections just above the plane.";
}

/// The options of a section.
#[derive(Debug, Clone, Copy, Default)]
pub struct Options {
    /// The side of vertices in a plane.
    pub in_plane: InPlane,
    /// Points are left out while the polyline stays within this distance of them. 0 keeps all
    /// points.
    pub tolerance: f64,
}

impl Options {
    pub(super) fn check(&self) -> Result<()> {
        Error::require(
            self.tolerance >= 0.0 && self.tolerance.is_finite(),
            "tolerance",
            self.tolerance,
            "finite and at least 0",
        )
    }
}
