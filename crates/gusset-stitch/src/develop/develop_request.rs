//! What is asked of a development, and what it returns.

use glam::DVec2;
use gusset_base::choices;
use gusset_mesh::Mesh;
use std::ops::Range;

/// Which distortion is least.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Distortion {
    /// Of lengths and areas, compression as bad as stretch: the symmetric Dirichlet energy, the
    /// mean of s^2 + 1/s^2 over the singular values s of the map from the surface to the plane.
    #[default]
    Symmetric,
    /// Of lengths, measured by (s - 1)^2: as rigid as possible.
    Rigid,
    /// Of angles: a least squares conformal map, which may stretch areas.
    Conformal,
}

choices! { for Distortion:
    Symmetric => "Lengths and areas", "Stretch and compression count alike: the symmetric Dirichlet energy.";
    Rigid => "As rigid as possible", "The squared difference of lengths.";
    Conformal => "Angles", "Angles are kept and areas are not: least squares conformal maps.";
}

/// Paths along which the surface is cut.
#[derive(Debug, Clone, Copy, Default)]
pub struct Cuts<'a> {
    /// Vertices of the mesh, path after path. Vertices that follow one another and have no edge in
    /// common are connected by the shortest path along edges.
    pub vertices: &'a [u32],
    /// Where each path begins among them, and the end of the last; empty for one path of all.
    pub offsets: &'a [u32],
}

/// How to develop.
#[derive(Debug, Clone, Copy, Default)]
pub struct Options<'a> {
    /// Which distortion is least.
    pub distortion: Distortion,
    /// Cuts that are given. Where a component is no disc after them, the shortest further cuts are
    /// made.
    pub cuts: Cuts<'a>,
    /// Darts at the most, each a cut from the border to where the curvature is.
    pub max_darts: u32,
    /// No more darts are made once no length changes by a larger factor, above 1; `None`: all darts
    /// are made.
    pub max_stretch: Option<f64>,
    /// Steps of each descent at the most; 0 for 200. A chart whose border would meet itself takes
    /// more than one, and so does one as rigid as possible.
    pub max_iterations: u32,
}

/// How a chart came about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Finish {
    /// By unfolding about edges: every edge has its length.
    Exact,
    /// By descent until nothing was gained.
    Converged,
    /// By descent, ended by the number of steps.
    IterationLimit,
    /// By descent until no step was possible that gains: the border would meet itself, or rounding
    /// hides it. Cuts or darts may help.
    Stalled,
    /// The conformal map that was asked for.
    Conformal,
    /// The conformal map folds or overlaps: the chart has the least symmetric distortion in its
    /// place.
    NotConformal,
    /// No map without folds was found: the chart has triangles that are turned over.
    Folded,
}

/// Why an edge is cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CutKind {
    /// On a path that was given.
    Given,
    /// To make a disc.
    Opening,
    /// For a dart.
    Dart,
}

/// A connected component of the development.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// Its vertices among those of the result.
    pub vertices: Range<u32>,
    /// The number of its faces.
    pub faces: u32,
    /// How it came about.
    pub finish: Finish,
    /// Steps of all its descents.
    pub iterations: u32,
    /// Pairs of edges of its border that meet in the plane, neighbours apart; 0 for a map that is
    /// one to one. Only charts with [`Finish::Exact`] or [`Finish::Folded`] can have some.
    pub overlaps: u32,
    /// Triangles that are turned over; 0 but for [`Finish::Folded`].
    pub folds: u32,
    /// The symmetric Dirichlet energy, mean over the area; 4 for an isometry, which has the least.
    pub energy: f64,
    /// The largest factor by which a length grows, and the least.
    pub stretch: [f64; 2],
    /// The area of the surface, in the squared unit of the positions.
    pub area: f64,
    /// The area in the plane.
    pub flat_area: f64,
}

/// A development.
#[derive(Debug, Clone, PartialEq)]
pub struct Developed {
    /// The flat mesh: z is 0, and all faces are counterclockwise in the plane. The faces are those
    /// of the surface in their order, each from its own first corner; vertices are chart after
    /// chart. Positions have the surface's scalar type.
    pub mesh: Mesh,
    /// The places of the vertices in double precision, in the unit of the positions. Charts lie
    /// beside one another along x.
    pub points: Vec<DVec2>,
    /// Of each vertex, that of the surface that it is; vertices on cuts are several.
    pub vertex_map: Vec<u32>,
    /// The number of the surface's vertices.
    pub old_vertices: usize,
    /// Of each face its chart.
    pub face_charts: Vec<u32>,
    /// Of each face the largest factor by which lengths in it grow, and the least; of a polygon
    /// those of its triangles.
    pub stretches: Vec<[f64; 2]>,
    /// Charts in the order of their first faces.
    pub charts: Vec<Chart>,
    /// The edges that were cut, as pairs of vertices of the surface, each once; first those given,
    /// then those that open, then darts.
    pub cut_edges: Vec<([u32; 2], CutKind)>,
    /// The number of darts.
    pub darts: u32,
}
