//! Options and results of a development.

use glam::DVec2;
use gusset_base::choices;
use gusset_mesh::Mesh;
use std::ops::Range;

/// The distortion to minimise.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Distortion {
    /// Distortion of lengths and areas, with compression and stretch penalised alike. It is the
    /// symmetric Dirichlet energy: the mean of s^2 + 1/s^2 over the singular values s of the map
    /// from the surface to the plane.
    #[default]
    Symmetric,
    /// Distortion of lengths, measured by (s - 1)^2: as rigid as possible.
    Rigid,
    /// Distortion of angles: a least squares conformal map, which may stretch areas.
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
    /// The vertices of the paths, path by path. Consecutive vertices without a common edge are
    /// connected by the shortest path along edges.
    pub vertices: &'a [u32],
    /// The start of each path in `vertices`, and the end of the last; empty for a single path.
    pub offsets: &'a [u32],
}

/// Options of [`develop`](super::develop()).
#[derive(Debug, Clone, Copy, Default)]
pub struct Options<'a> {
    /// The distortion to minimise.
    pub distortion: Distortion,
    /// The given cuts. A component that is not a disc after these is opened by the shortest further
    /// cuts.
    pub cuts: Cuts<'a>,
    /// Largest number of darts, which are cuts from the border to a place of high curvature.
    pub max_darts: u32,
    /// Stops adding darts once no length changes by a larger factor, above 1; `None` allows all
    /// darts.
    pub max_stretch: Option<f64>,
    /// Largest number of steps of each descent; 0 means 200. A chart whose border would intersect
    /// itself takes several descents, and so does [`Distortion::Rigid`].
    pub max_iterations: u32,
}

/// The construction of a chart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Finish {
    /// Unfolding about edges: every edge keeps its length.
    Exact,
    /// Descent until the energy no longer decreased.
    Converged,
    /// Descent until the limit on steps.
    IterationLimit,
    /// Descent until no further step was possible: the border would intersect itself, or round-off
    /// hides the decrease. Cuts or darts may help.
    Stalled,
    /// The requested conformal map.
    Conformal,
    /// The conformal map folds or overlaps: the chart minimises the symmetric distortion instead.
    NotConformal,
    /// No map without folds was found: some triangles of the chart are turned over.
    Folded,
}

/// The reason why an edge is cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CutKind {
    /// It lies on a given path.
    Given,
    /// It opens a component to a disc.
    Opening,
    /// It belongs to a dart.
    Dart,
}

/// A connected component of the development.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// The chart's vertices in the result.
    pub vertices: Range<u32>,
    /// The number of the chart's faces.
    pub faces: u32,
    /// The construction of the chart.
    pub finish: Finish,
    /// The number of steps of all descents.
    pub iterations: u32,
    /// The number of pairs of border edges that intersect in the plane, without neighbours; 0 for
    /// an injective map. It is positive only with [`Finish::Exact`] or [`Finish::Folded`].
    pub overlaps: u32,
    /// The number of triangles that are turned over; 0 except with [`Finish::Folded`].
    pub folds: u32,
    /// The mean symmetric Dirichlet energy over the area. The minimum is 4, for an isometry. It is
    /// infinite if a triangle is turned over or flat in the plane, up to rounding.
    pub energy: f64,
    /// The largest factor by which a length changes, and the smallest.
    pub stretch: [f64; 2],
    /// The area on the surface, in the squared unit of the positions.
    pub area: f64,
    /// The area in the plane.
    pub flat_area: f64,
}

/// A development.
#[derive(Debug, Clone, PartialEq)]
pub struct Developed {
    /// The flat mesh: z is 0, and all faces are counter-clockwise. It has the faces of the surface
    /// in their order, each from its own first corner; its vertices are ordered by chart. Positions
    /// have the surface's scalar type.
    pub mesh: Mesh,
    /// The vertices in double precision, in the unit of the positions. The charts lie side by side
    /// along x.
    pub points: Vec<DVec2>,
    /// For each vertex, the vertex of the surface. A surface vertex on a cut has several copies.
    pub vertex_map: Vec<u32>,
    /// The number of vertices of the surface.
    pub old_vertices: usize,
    /// For each face, its chart.
    pub face_charts: Vec<u32>,
    /// For each face, the largest factor by which lengths in it change, and the smallest; for a
    /// polygon, over all its triangles.
    pub stretches: Vec<[f64; 2]>,
    /// The charts in the order of their first faces.
    pub charts: Vec<Chart>,
    /// The cut edges, each once as a pair of vertices of the surface: first the given ones, then
    /// those that open components, then darts.
    pub cut_edges: Vec<([u32; 2], CutKind)>,
    /// The number of darts.
    pub darts: u32,
}
