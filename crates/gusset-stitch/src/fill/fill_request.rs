//! Options and results of filling, and the status of each hole.

pub use crate::fair::Continuity;
use crate::repair::orient::Outward;
use crate::stitch::{self, Intersections, Quality};
use gusset_base::choices;
use gusset_mesh::Mesh;
use std::ops::Range;

/// The criterion for the best triangulation of a rim.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Weight {
    /// The best continuation of the surface around the hole.
    ///
    /// Adds the bends along all edges, including rim edges, to the distance of the triangles from
    /// the likely old surface. The tangent planes at the rim predict this surface. If the rim is
    /// planar, only the area counts.
    #[default]
    Continuation,
    /// The sum of area and bend. The bend of an edge, including rim edges, is its squared length
    /// times 1 - cosine of the angle between its faces.
    AreaAndBend,
    /// The largest angle between neighbouring faces, including the faces beyond the rim, then the
    /// area (Liepa). One unavoidable bend hides all smaller ones.
    BendThenArea,
    /// The area (Barequet and Sharir).
    Area,
}

choices! { for Weight:
    Continuation => "Best continuation", "The bends along edges, and the distance from the surface that the tangent planes at the rim suggest.";
    AreaAndBend => "Area and bend", "The area, and the bends along edges by their squared length.";
    BendThenArea => "Largest bend", "The largest angle between neighbouring faces, then the area.";
    Area => "Area", "The area alone.";
}

/// New vertices inside the holes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Refinement {
    /// No new vertices.
    #[default]
    None,
    /// New vertices as dense as those around the hole.
    ///
    /// The number is an approximate limit per hole; 0 means 50,000. If a hole needs more, its
    /// triangles are larger.
    RimDensity(u32),
}

/// How new vertices are placed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Fairing {
    /// New vertices stay on the triangles of the initial triangulation.
    #[default]
    None,
    /// New vertices minimise the bending energy of a thin plate that is clamped to the surface
    /// around the hole.
    ThinPlate,
}

/// Limits on the size of the loops to fill. Each value is the largest that is filled; `None` sets
/// no limit.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Limits {
    /// Number of edges of the loop.
    pub edges: Option<u32>,
    /// Limit on [`Measures::length`].
    pub length: Option<f64>,
    /// Limit on [`Measures::diameter`].
    pub diameter: Option<f64>,
    /// Limit on [`Measures::area`].
    pub area: Option<f64>,
}

/// The size of a loop.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Measures {
    /// The sum of the edge lengths, in the unit of the positions.
    pub length: f64,
    /// The diagonal of the axis-aligned bounding box.
    pub diameter: f64,
    /// The area of the triangles from the loop's edges to its centroid, in the squared unit of the
    /// positions. Equals the hole's area if the hole is planar and convex, and exceeds it
    /// otherwise.
    pub area: f64,
}

/// Which loops are not holes. Read only with [`LoopSelection::All`].
///
/// Except with [`Keep::None`], a loop also stays open if it runs along a border that coincides with
/// another one; see [`HoleStatus::Unsewn`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Keep {
    /// Leaves the outer border of each sheet open, and the borders of loose faces.
    ///
    /// A component is a sheet if its faces look the same way: its area vector is at least three
    /// quarters as long as its area. Its outer border is the loop whose area vector reaches
    /// farthest along the component's. A bowl is not a sheet: a hemisphere has a ratio of 1/2. A
    /// component is loose if one loop passes all its vertices, like a single face.
    #[default]
    Auto,
    /// Fills every loop.
    None,
    /// Leaves the longest loop open.
    Longest,
    /// Leaves the outer border of each sheet open, because filling it would cover the sheet.
    ///
    /// The area vector of an outer border points along the sheet's own area vector, and its length is
    /// at least half the sheet's area. Shallow bowls count as sheets.
    OuterBorders,
}

choices! { for Keep:
    Auto => "Automatic", "Outer borders of sheets and of loose faces stay open. Bowls are filled.";
    None => "None", "All loops are holes.";
    Longest => "The longest", "The longest loop is the outline of a sheet, and stays open.";
    OuterBorders => "Borders", "Loops around a sheet or a shallow bowl stay open. Loops around holes in it are filled.";
}

/// Which loops share a patch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Together {
    /// Each loop has its own patch.
    #[default]
    Apart,
    /// All filled loops share one patch.
    One,
    /// Loops share a patch if that costs less than separate patches, by the chosen [`Weight`].
    Cheapest,
}

choices! { for Together:
    Apart => "Each by itself", "Each loop gets a patch of its own.";
    One => "All by one patch", "All loops get one patch: a surface without handles between them.";
    Cheapest => "Where it costs less", "Loops share a patch if its weight is less than the weight of separate patches.";
}

/// The loops to fill.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LoopSelection<'a> {
    /// All loops of the mesh.
    #[default]
    All,
    /// The given loops, each as its vertices in order, in either direction.
    Loops(&'a [&'a [u32]]),
    /// The given loops, each with a group number. Loops of one group share a patch, and
    /// [`Options::together`] is not read.
    Groups(&'a [(&'a [u32], u32)]),
}

/// Options of [`fill_holes`](super::fill_holes()).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options {
    /// The criterion for the best triangulation.
    pub weight: Weight,
    /// [`Blend`](stitch::Finish::Blend) refines and fairs the patches; it overrides `refinement`
    /// [`None`](Refinement::None) and `fairing`.
    pub finish: stitch::Finish,
    /// New vertices inside the holes.
    pub refinement: Refinement,
    /// How new vertices are placed. Without new vertices a note reports that this is not read.
    pub fairing: Fairing,
    /// How smoothly faired vertices continue the surface around the hole.
    pub continuity: Continuity,
    /// If true, creases that end at a rim are not continued across the patch.
    pub ignore_creases: bool,
    /// How intersecting faces are treated. [`Intersections::Auto`] looks for them, and avoids them
    /// by other weights and less fairing. The other choices report or ignore them.
    pub intersections: Intersections,
    /// Limits on the size of the loops to fill.
    pub limits: Limits,
    /// Which loops are not holes.
    pub keep: Keep,
    /// Which loops share a patch.
    pub together: Together,
    /// If true, nothing is filled or turned over. The reports tell which loops would be tried, and
    /// with which weight and finish. They do not tell which loops lack a triangulation, or which
    /// loops would share a patch.
    pub plan_only: bool,
    /// The orientation of closed components of the result: kept, or turned outwards as a whole by
    /// [`turn_outwards`].
    ///
    /// [`turn_outwards`]: crate::repair::orient::turn_outwards()
    pub outward: Outward,
}

impl Options {
    /// Returns the options with the refinement and fairing that the finish asks for.
    pub(super) fn with_finish(mut self) -> Options {
        if self.finish == stitch::Finish::Blend {
            self.fairing = Fairing::ThinPlate;
            if self.refinement == Refinement::None {
                self.refinement = Refinement::RimDensity(0);
            }
        }
        self
    }
}

/// The outcome for one loop.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HoleStatus {
    /// Filled; in a plan, to be filled.
    Filled,
    /// The outer border of a sheet, or the longest loop, which [`Options::keep`] leaves open.
    Kept,
    /// The border of loose faces, which [`Keep::Auto`] leaves open: the loop passes all vertices of
    /// its component.
    Loose,
    /// An edge of the loop coincides with another boundary edge. Sewing closes the gap between them;
    /// a patch would have no area there, or lie on another. [`Keep::None`] fills the loop.
    Unsewn,
    /// Larger than one of the [`Limits`].
    TooLarge,
    /// An open chain instead of a closed loop.
    Open,
    /// Runs along an edge with three or more faces.
    NonManifold,
    /// The faces along the loop have inconsistent orientations.
    NotOriented,
    /// A given loop that has fewer than three vertices, or repeats a vertex.
    NotSimple,
    /// A given loop with an edge that does not have exactly one face, or that an earlier loop has
    /// too.
    NotFree,
    /// No triangulation was found. Each one may have an edge between two vertices of one old face.
    /// Or the loops of the group cannot be closed together, for example because two of them share a
    /// vertex.
    NoTriangulation,
}

/// The construction of a patch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Finish {
    /// Triangles between the vertices of the rim.
    Plain,
    /// New vertices on the triangles of the plain patch.
    Refined,
    /// New vertices that are faired.
    Faired,
}

/// The report on one loop.
#[derive(Debug, Clone, PartialEq)]
pub struct Hole {
    /// The outcome.
    pub status: HoleStatus,
    /// The loop's vertices, as a range of [`Filled::rims`], with the surface of the input mesh on
    /// the left. A given loop that is not simple, free or oriented keeps its given order.
    pub rim: Range<usize>,
    /// The patch number, in the order of the faces; `u32::MAX` without a patch. Several loops may
    /// share a patch.
    pub patch: u32,
    /// The patch's faces in the result. Loops that share a patch have equal ranges.
    pub faces: Range<u32>,
    /// The patch's new vertices in the result.
    pub vertices: Range<u32>,
    /// The size of the loop.
    pub measures: Measures,
    /// The weight that the patch minimises: the chosen weight, or another that intersects less.
    pub weight: Weight,
    /// The construction of the patch: the chosen one, or a simpler one that intersects less.
    pub finish: Finish,
}

/// The result of filling.
#[derive(Debug, Clone, PartialEq)]
pub struct Filled {
    /// The old vertices with unchanged bits and indices, then the new vertices; the old faces, then
    /// the new triangles.
    pub mesh: Mesh,
    /// One report for each loop: the given loops in their order, or all loops of the mesh in the
    /// order of [`boundary_loops`](crate::boundary::boundary_loops()).
    pub holes: Vec<Hole>,
    /// The vertices of all rims.
    pub rims: Vec<u32>,
    /// For each new vertex, in order, three vertices of its patch's rims.
    pub parents: Vec<[u32; 3]>,
    /// The weight of each parent, at least 0, with sum 1. They give the nearest point on the plain
    /// triangulation of the rims. It is the vertex itself if the patch is flat, and if the patch is
    /// without fairing and creases.
    pub weights: Vec<[f64; 3]>,
    /// Pairs of intersecting faces of the result, in ascending order; `None` if they were not
    /// looked for. In each pair the first number is larger, and is a new face. Shared vertices and
    /// edges, and coincident ones, do not count.
    pub intersections: Option<Vec<[u32; 2]>>,
    /// The number of boundary edges of the input that coincide with another one. Not looked for, and
    /// 0, for given loops.
    pub coincident_edges: u32,
    /// The faces of the result that [`Options::outward`] turned over, old and new, ascending. A
    /// turned face keeps its first corner, and the order of its other corners is reversed.
    pub turned_outwards: Vec<u32>,
    /// Quality of the new faces, and connectivity of the result.
    pub quality: Quality,
}
