//! Options of the search for boundary loops.

use gusset_base::choices;

/// The treatment of edges with three or more faces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum NonManifold {
    /// Each face at such an edge has its own border there. Loops run along it and are always
    /// closed.
    #[default]
    Cut,
    /// Only edges with exactly one face belong to loops. A walk that meets such an edge ends there,
    /// as an open chain.
    Stop,
}

choices! { for NonManifold:
    Cut => "Cut", "Each face has its own border there, so loops are always closed.";
    Stop => "Stop", "Loops end there, as open chains.";
}

/// How much of the mesh is examined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Survey {
    /// Every edge. All defects of the mesh are reported, and flagged on the loops.
    #[default]
    WholeMesh,
    /// As little as the loops require, which is many times faster.
    ///
    /// If the boundary itself is irregular (open, touching itself, inconsistently oriented, with
    /// three faces at an edge), the whole mesh is examined. Otherwise defects away from the
    /// boundary are not reported, and neither are edges with two or more faces in each direction,
    /// in equal numbers. Loops are not cut at such edges.
    BoundaryOnly,
}

/// Options of [`boundary_loops`](super::boundary_loops()).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Options {
    /// The treatment of edges with three or more faces.
    pub non_manifold: NonManifold,
    /// How much of the mesh is examined.
    pub survey: Survey,
}
