//! Options, results and the status of each hole.

pub use crate::fair::Continuity;
use crate::repair::orient::Outward;
use crate::stitch::{Intersections, Quality};
use gusset_base::choices;
use gusset_mesh::Mesh;
use std::ops::Range;

/// What makes one triangulation of a rim better than another.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Weight {
    /// The best continuation of the surface round the hole: the bends along all edges, those of the
    /// rim included, and how far the surface that was there is likely to have been from the
    /// triangles, as its tangent planes at the rim say. By area alone if the rim is planar.
    #[default]
    Continuation,
    /// The area, and for each edge, those of the rim included, its squared length times 1 - cosine
    /// of the angle between its faces.
    AreaAndBend,
    /// The largest angle between neighbouring faces, those beyond the rim included, and then the
    /// area, as Liepa has it. One bend that cannot be avoided hides all smaller ones.
    BendThenArea,
    /// The area, as Barequet and Sharir have it.
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
    /// None.
    #[default]
    None,
    /// As dense as the vertices round the hole. About so many a hole at the most, 0 for 50,000:
    /// where more would be needed, the triangles are larger.
    RimDensity(u32),
}

/// Where new vertices go.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Fairing {
    /// They stay on the triangles of the first triangulation.
    #[default]
    None,
    /// To where a thin plate clamped to the surface round the hole would bend least.
    ThinPlate,
}

/// Which loops are too large to be filled. Each limit is the largest value that is filled; `None`
/// for no limit.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Limits {
    /// Edges of the loop.
    pub edges: Option<u32>,
    /// [`Measures::length`].
    pub length: Option<f64>,
    /// [`Measures::diameter`].
    pub diameter: Option<f64>,
    /// [`Measures::area`].
    pub area: Option<f64>,
}

/// How large a loop is.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Measures {
    /// The sum of its edges' lengths, in the unit of the positions.
    pub length: f64,
    /// The diagonal of the box round it, along the axes.
    pub diameter: f64,
    /// The area of the cone of triangles from its edges to their common centre, in the square of the
    /// unit: that of the hole if it is planar and convex, more otherwise.
    pub area: f64,
}

/// Which loops are no holes; only asked if all loops are to be filled.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Keep {
    /// All are holes.
    #[default]
    None,
    /// The longest loop is none.
    Longest,
    /// Those are none that go round a sheet rather than a hole in it: a patch would lie on the sheet.
    /// The area vector of such a loop points as the sheet's own, and is at least half as long as the
    /// sheet's area.
    Borders,
}

choices! { for Keep:
    None => "None", "All loops are holes.";
    Longest => "The longest", "The longest loop is the outline of a sheet, and stays open.";
    Borders => "Borders", "Loops around a sheet stay open. Loops around holes in it are filled.";
}

/// Which loops get one patch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Together {
    /// Each has a patch of its own.
    #[default]
    Apart,
    /// All that are filled have one patch.
    One,
    /// Those have one patch that cost less together than apart, by the weight asked for.
    Cheapest,
}

choices! { for Together:
    Apart => "Each by itself", "Each loop gets a patch of its own.";
    One => "All by one patch", "All loops get one patch: a surface without handles between them.";
    Cheapest => "Where it costs less", "Loops share a patch if its weight is less than the weight of separate patches.";
}

/// The loops to fill.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Selection<'a> {
    /// All that the mesh has.
    #[default]
    All,
    /// These: the vertices of each in order, in either direction.
    Loops(&'a [&'a [u32]]),
    /// These, each with a number: those with the same number get one patch, whatever
    /// [`Options::together`] says.
    Groups(&'a [(&'a [u32], u32)]),
}

/// How holes are filled.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options {
    /// Which triangulation is best.
    pub weight: Weight,
    /// New vertices inside the holes.
    pub refinement: Refinement,
    /// Where they go; if none are asked for, a note says that this is not read.
    pub fairing: Fairing,
    /// How smoothly faired vertices go on the surface round the hole.
    pub continuity: Continuity,
    /// Creases of the old surface that end at a rim end there: no patch goes on with them.
    pub ignore_creases: bool,
    /// Whether cuts are looked for, and avoided by other weights and less fairing
    /// ([`Intersections::Auto`]), reported only, or ignored.
    pub intersections: Intersections,
    /// Which loops are left alone.
    pub limits: Limits,
    /// Which loops are no holes.
    pub keep: Keep,
    /// Which loops get one patch.
    pub together: Together,
    /// Nothing is filled or turned over: the accounts say which loops would be tried, and with which
    /// weight and finish; not which of them turn out to have no triangulation, nor which get one patch.
    pub plan_only: bool,
    /// What becomes of closed components of the result: they stay as they are, or those that are
    /// inside out are turned over, each as a whole, as [`turn_outwards`] does.
    ///
    /// [`turn_outwards`]: crate::repair::orient::turn_outwards()
    pub outward: Outward,
}

/// What became of a loop.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HoleStatus {
    /// Filled; in a plan, to be filled.
    Filled,
    /// It is no hole, as [`Options::keep`] has it.
    Kept,
    /// It exceeds one of the [`Limits`].
    TooLarge,
    /// No closed loop: an open chain.
    Open,
    /// It runs along an edge with three or more faces.
    NonManifold,
    /// The faces along it disagree in orientation.
    NotOriented,
    /// A given loop has fewer than three vertices, or passes one twice.
    NotSimple,
    /// An edge of a given loop is no edge with exactly one face, or is one of a loop before it.
    NotFree,
    /// Every triangulation would have an edge between two vertices of one old face; or none was found
    /// that closes all loops together which are to get one patch, as where two of them share a vertex.
    NoTriangulation,
}

/// What a patch is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Finish {
    /// Triangles between the vertices of the rim.
    Plain,
    /// With new vertices, where the plain triangles are.
    Refined,
    /// With new vertices, faired.
    Faired,
}

/// The account of one loop.
#[derive(Debug, Clone, PartialEq)]
pub struct Hole {
    /// What became of it.
    pub status: HoleStatus,
    /// Its vertices, in [`Filled::rims`]: with the surface of the mesh that was given on the left,
    /// or, of a given loop that is not simple, free or oriented, as given.
    pub rim: Range<usize>,
    /// The number of its patch, which several loops may have, in the order of the faces; `u32::MAX` if
    /// it has none.
    pub patch: u32,
    /// The patch's faces in the result: the same for all loops of the patch.
    pub faces: Range<u32>,
    /// The patch's new vertices in the result.
    pub vertices: Range<u32>,
    /// How large it is.
    pub measures: Measures,
    /// The weight that the patch's triangulation is best by: the one asked for, or one that cuts less.
    pub weight: Weight,
    /// What the patch is made of: what was asked for, or less, which cuts less.
    pub finish: Finish,
}

/// The result of filling.
#[derive(Debug, Clone, PartialEq)]
pub struct Filled {
    /// The old vertices with their bits and indices, then the new ones; the old faces, then the new
    /// ones, all triangles.
    pub mesh: Mesh,
    /// One account for each loop: those given, in their order, or all that the mesh has, in the
    /// order of [`boundary_loops`](crate::boundary::boundary_loops()).
    pub holes: Vec<Hole>,
    /// The vertices of all rims.
    pub rims: Vec<u32>,
    /// Of each new vertex, in their order, three vertices of its patch's rims.
    pub parents: Vec<[u32; 3]>,
    /// How much it has of each of them; at least 0, with sum 1. They place it at the nearest point
    /// of the plain triangulation of the rims, which it is itself if its patch was neither faired nor
    /// creased, or if the hole is flat.
    pub weights: Vec<[f64; 3]>,
    /// Pairs of faces of the result that cut each other, the larger number first, which is a new
    /// face's; ascending. What they share, a vertex or an edge, is no cut, nor are vertices and edges
    /// at the same place. `None` if they were not looked for.
    pub intersections: Option<Vec<[u32; 2]>>,
    /// Faces of the result, old and new ones, that [`Options::outward`] had turned over, ascending.
    /// Each keeps its first corner and has the others in reverse order.
    pub turned_outwards: Vec<u32>,
    /// Measures of the new faces, and of the result's connectivity.
    pub quality: Quality,
}
