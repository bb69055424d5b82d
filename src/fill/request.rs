//! Options, results and the status of each hole.

use crate::choice::choices;
use crate::mesh::Mesh;
use crate::repair::orient::Outward;
use crate::stitch::Quality;
use std::ops::Range;

/// What makes one triangulation of a rim better than another.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Weight {
    /// The area, and for each edge, those of the rim included, its squared length times 1 - cosine
    /// of the angle between its faces: the patch goes on as the surface does where that costs
    /// little. By area alone if the rim is planar.
    #[default]
    AreaAndBend,
    /// The largest angle between neighbouring faces, those beyond the rim included, and then the
    /// area, as Liepa has it. One bend that cannot be avoided hides all smaller ones.
    BendThenArea,
    /// The area, as Barequet and Sharir have it.
    Area,
}

choices! { for Weight:
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
    /// The sum of their lengths, in the unit of the positions.
    pub length: Option<f64>,
    /// The diagonal of the box round the loop, along the axes.
    pub diameter: Option<f64>,
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
    /// Which loops are left alone.
    pub limits: Limits,
    /// The longest loop is left alone too: the outline of an open sheet is no hole. Only if all
    /// loops are asked for.
    pub keep_longest: bool,
    /// What becomes of closed components of the result: they stay as they are, or those that are
    /// inside out are turned over, each as a whole, as [`turn_outwards`] does.
    ///
    /// [`turn_outwards`]: crate::repair::orient::turn_outwards()
    pub outward: Outward,
}

/// What became of a hole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HoleStatus {
    /// Filled.
    Filled,
    /// It is the longest loop, which was to be kept.
    Longest,
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
    /// Every triangulation would repeat an edge that the mesh already has.
    NoTriangulation,
}

/// The account of one loop.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Hole {
    /// What became of it.
    pub status: HoleStatus,
    /// Its vertices, in [`Filled::rims`]: with the surface of the mesh that was given on the left,
    /// or, of a given loop that is not simple, free or oriented, as given.
    pub rim: Range<usize>,
    /// Its faces in the result.
    pub faces: Range<u32>,
    /// Its new vertices in the result.
    pub vertices: Range<u32>,
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
    /// Faces of the result, old and new ones, that [`Options::outward`] had turned over, ascending.
    /// Each keeps its first corner and has the others in reverse order.
    pub turned_outwards: Vec<u32>,
    /// Measures of the new faces, and of the result's connectivity.
    pub quality: Quality,
}
