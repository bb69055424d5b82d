//! Options of the search for boundary loops.

use gusset_base::choices;

/// What a boundary does at an edge with three or more faces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum NonManifold {
    /// Each face at such an edge has a border of its own there: loops run along it and are always
    /// closed.
    #[default]
    Cut,
    /// Only edges with exactly one face belong to loops; a walk that meets such an edge ends there,
    /// as an open chain.
    Stop,
}

choices! { for NonManifold:
    Cut => "Cut", "Each face has its own border there, so loops are always closed.";
    Stop => "Stop", "Loops end there, as open chains.";
}

/// How closely the mesh is looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Survey {
    /// Every edge: all that is wrong or unusual in the mesh is reported, and flagged on the loops.
    #[default]
    WholeMesh,
    /// As little as will give the loops, which is many times faster. Where the boundary itself is
    /// odd (open, touching itself, badly oriented, with three faces on an edge) the whole mesh is
    /// looked at after all, and everything reported. But what is away from the boundary is not
    /// reported, nor an edge with as many faces one way as the other, two or more each, and loops
    /// are not cut there.
    BoundaryOnly,
}

/// How loops are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Options {
    /// At edges with three or more faces.
    pub non_manifold: NonManifold,
    /// How closely the mesh is looked at.
    pub survey: Survey,
}
