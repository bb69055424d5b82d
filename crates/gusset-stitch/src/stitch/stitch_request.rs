//! Request, options and result of a stitch.

use super::extent::Extent;
use super::facing::{Centres, Run};
use super::first_meridian::Start;
use super::meridian::{MeridianEnds, MeridianSearch, Meridians};
use super::quality::Quality;
use crate::repair::orient::Outward;
use gusset_base::choices;
use gusset_base::job::Job;
use gusset_mesh::{Mesh, MeshView};
use std::ops::Range;

/// The treatment of a second piece with the opposite orientation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Orientation {
    /// The faces of the piece are turned over. Two loops of one connected piece are not changed,
    /// because turning the piece does not help.
    #[default]
    Fix,
    /// Fails with [`Error::OrientationConflict`](gusset_base::Error::OrientationConflict).
    Refuse,
    /// The rims are not compared, and no face is changed.
    Keep,
}

choices! { for Orientation:
    Fix => "Reverse it", "Its faces are reversed.";
    Refuse => "Refuse", "The filter fails.";
    Keep => "Ignore", "The faces are taken as they are.";
}

/// The number of rows of new vertices between the rims.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Rows {
    /// No rows: every meridian is one edge.
    #[default]
    None,
    /// Divides the meridians into parts of about the mean side of both pieces' faces, as the paper
    /// suggests: max(0, round(mean meridian / mean side) - 1) rows. A note reports if there would be
    /// more than 50,000 new vertices in more than 16 rows: then the rows are wider.
    MeanEdge,
    /// The given number of rows.
    Count(u32),
}

/// The faces of the strip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Cells {
    /// Triangles only; quads are split by their shorter diagonals.
    #[default]
    Triangles,
    /// Quads where four distinct neighbours meet, and triangles where a rim repeats a vertex.
    Quads,
}

choices! { for Cells:
    Triangles => "Triangles", "Quads are split by their shorter diagonals.";
    Quads => "Quads", "Quads where four different neighbours meet, triangles elsewhere.";
}

/// The placement of the new vertices.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Fairing {
    /// Evenly on straight meridians, as in the paper.
    #[default]
    None,
    /// The strip bends like a thin plate and joins both pieces smoothly; see
    /// [`stitch()`](super::stitch()). The rims stay fixed.
    ThinPlate,
}

choices! { for Fairing:
    None => "Straight", "Evenly on straight lines from rim to rim.";
    ThinPlate => "Fair", "The strip bends as a thin plate and joins both pieces smoothly.";
}

/// The surface between the rims, or in a hole.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Finish {
    /// The strip of meridians, with its rows. In a hole: the patch that the other options describe.
    #[default]
    Strip,
    /// The best-looking joint: triangles about as fine as those around the rims, graded between
    /// them, on a surface tangent to both pieces.
    ///
    /// Sharp angles are avoided where the rims allow it. The strip without rows guides the blend,
    /// so that a gap in a tube is bridged by a tube. Between two tubes, across a gap wider than a
    /// radius, arcs from rim to rim replace the strip as the guide. Meridians and matrix describe the strip, and
    /// are not edges of the result. Rows, cells and fairing are not read. The strip stays, and a
    /// note reports it, if every blend would have more intersections than the strip, or would need
    /// too many vertices. Time and memory grow with the number of new triangles.
    ///
    /// In a hole: a patch with new vertices as dense as those around it, faired.
    Blend,
}

choices! { for Finish:
    Strip => "Strip", "The strip of meridians, with its rows; in holes, the patches that the other parameters describe.";
    Blend => "Blend", "Triangles as fine as the faces around them, on a smooth surface: the best-looking result.";
}

/// Whether intersecting faces of the strip are looked for. Shared vertices and edges, and
/// coincident ones, do not count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Intersections {
    /// Finds and avoids intersections.
    ///
    /// Faired rows and blends return towards the unfaired positions until nothing intersects, or no
    /// fairing is left. A strip of triangles without rows by [`Meridians::Continuation`] is
    /// replaced by another one (`avoid`). If the mean meridian is longer than a radius,
    /// [`Meridians::Smooth`] competes: its strip is kept if it has fewer intersections, or as many
    /// and much smaller bends. Rows by [`Meridians::Continuation`] use the meridians of that strip
    /// if the gap is so wide, or if they would intersect. Other strips are not changed.
    #[default]
    Auto,
    /// Does not look for intersections. Rows are fully faired, and the first blend is kept.
    Ignore,
    /// Finds intersections. Faired rows and blends return as in `Auto`, but strips are not
    /// replaced.
    Report,
}

choices! { for Intersections:
    Auto => "Automatic", "They are found, and avoided by faired rows, blends and the best continuation.";
    Ignore => "Ignore", "No search.";
    Report => "Report", "They are found, and avoided by faired rows and blends only.";
}

/// Options of [`stitch()`](super::stitch()).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options {
    /// The choice of meridians.
    pub meridians: Meridians,
    /// The effort of the search for the best meridians.
    pub search: MeridianSearch,
    /// The first meridians to try on a closed band.
    pub start: Start,
    /// The treatment of a second piece with the opposite orientation.
    pub orientation: Orientation,
    /// Shifts the start of rim B by this number of places. The first meridian of a closed band
    /// joins the closest pair of vertices. A twist moves its end on B in the direction in which rim
    /// A runs (negative: backwards), and disables other starts. Must be 0 for arcs.
    pub twist: i64,
    /// Which part of the loops is joined.
    pub extent: Extent,
    /// Which of several runs of facing vertices is selected.
    pub run: Run,
    /// Smallest distance from its own loop's plane at which a vertex faces the other loop, in the
    /// unit of the positions. `None` uses the round-off of the positions.
    pub tolerance: Option<f64>,
    /// The definition of the loops' centres, through which the planes run.
    pub centres: Centres,
    /// The number of interior rows.
    pub rows: Rows,
    /// Triangles or quads.
    pub cells: Cells,
    /// How the rows are faired. Without rows a note reports that this is not read.
    pub fairing: Fairing,
    /// The strip itself, or a blend in place of it.
    pub finish: Finish,
    /// How intersecting faces are treated.
    pub intersections: Intersections,
    /// The orientation of closed components of the result: kept, or turned outwards as a whole by
    /// [`turn_outwards`].
    ///
    /// [`turn_outwards`]: crate::repair::orient::turn_outwards()
    pub outward: Outward,
}

impl Options {
    /// Notes the requested options that are not read.
    pub(crate) fn note_unread_options(&self, job: &Job<'_>) {
        let no_rows = matches!(self.rows, Rows::None | Rows::Count(0));
        if self.finish == Finish::Blend {
            if !no_rows || self.cells == Cells::Quads || self.fairing == Fairing::ThinPlate {
                job.note("a blend ignores rows, cells and fairing: it has no rows or quads, and is always fair");
            }
        } else if self.fairing == Fairing::ThinPlate && no_rows {
            job.note("fairing does nothing without interior rows: request rows");
        }
    }

    /// Returns the options of the strip: for a blend, triangles without rows.
    pub(crate) fn strip_options(&self) -> Options {
        match self.finish {
            Finish::Strip => *self,
            Finish::Blend => Options { rows: Rows::None, cells: Cells::Triangles, fairing: Fairing::None, ..*self },
        }
    }
}

/// The input of a stitch: two loops of two meshes, or of one.
///
/// A loop lists its vertices in order, in either direction. Consecutive vertices, and the last with
/// the first, must span an edge with exactly one face. `None` selects the nearest loops; see
/// [`stitch()`](super::stitch()).
#[derive(Clone, Copy)]
pub struct Request<'a> {
    /// The first piece.
    pub a: &'a MeshView<'a>,
    /// The loop of the first piece.
    pub loop_a: Option<&'a [u32]>,
    /// The second piece; `None` if both loops belong to the first.
    pub b: Option<&'a MeshView<'a>>,
    /// The second loop.
    pub loop_b: Option<&'a [u32]>,
}

/// A map from old indices to new ones.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct IndexMap {
    /// For each old vertex, the new one.
    pub vertices: Vec<u32>,
    /// For each old face, the new one.
    pub faces: Vec<u32>,
}

/// The result of stitching.
#[derive(Debug, Clone, PartialEq)]
pub struct Stitch {
    /// Both pieces and the strip. The order of the vertices is A's, B's, then the new ones; the
    /// order of the faces is A's, B's, then the strip's. Positions have the scalar type of A, and
    /// old ones keep their bits. At a common point of both rims, the vertex of rim A replaces the
    /// vertex of rim B.
    pub mesh: Mesh,
    /// The strip alone: the N vertices of rim A in order, then the M of rim B, then the new
    /// vertices, and the strip's faces. Faces name a common point by its place on rim A.
    pub strip: Mesh,
    /// Maps from old to new indices for each piece; the second is empty if there is only one piece.
    pub maps: [IndexMap; 2],
    /// The strip's faces in [`Stitch::mesh`].
    pub strip_faces: Range<u32>,
    /// The vertices of each rim in [`Stitch::mesh`], side by side from the first meridian. Before
    /// [`Stitch::turned_outwards`] is applied, rim A has its surface on the left, and rim B on the
    /// right.
    pub rims: [Vec<u32>; 2],
    /// True for a closed band between whole loops; false for a strip between arcs.
    pub closed: bool,
    /// The meridians as places (i, j) on the rims: the paper's matrix H. On a closed band they run
    /// from (0, 0) to (N, M), where place N is place 0 again. On an open strip they run to (N - 1,
    /// M - 1).
    pub meridians: Vec<MeridianEnds>,
    /// The paper's matrix P of vertices of [`Stitch::mesh`], row by row from rim A to rim B, with
    /// one column for each meridian.
    pub matrix: Vec<u32>,
    /// The number of interior rows; the matrix has two more.
    pub rows: u32,
    /// For each new vertex, three parents: rim vertices in [`Stitch::mesh`]. In a row, they are the
    /// ends of its meridian, the end on rim B twice. In a blend, they are the corners of the
    /// strip's triangle that it would lie on without fairing.
    pub parents: Vec<[u32; 3]>,
    /// The weight of each parent, at least 0, with sum 1. In row k of r rows the weights are 1 - k
    /// / (r + 1), k / (r + 1) and 0.
    pub weights: Vec<[f64; 3]>,
    /// Pairs of intersecting faces of [`Stitch::mesh`], in ascending order; `None` if they were not
    /// looked for.
    ///
    /// In each pair the first face belongs to the strip, and is the larger one if both do. Faces
    /// are split as [`FaceTriangles`](gusset_mesh::FaceTriangles) does. A polygon that intersects
    /// itself is paired with itself.
    pub intersections: Option<Vec<[u32; 2]>>,
    /// The resulting surface. It is the strip if a requested blend was not possible.
    pub finish: Finish,
    /// The number of rounds that reduced the fairing.
    pub back_offs: u32,
    /// True if the second piece was turned over to agree with the first.
    pub turned: bool,
    /// The faces in [`Stitch::mesh`] that were turned over with the second piece, ascending. Each
    /// keeps its first corner, and the order of its other corners is reversed.
    pub turned_faces: Vec<u32>,
    /// The faces of the result that [`Options::outward`] turned over, including faces of the strip,
    /// ascending. Each keeps its first corner, and the order of its other corners is reversed.
    pub turned_outwards: Vec<u32>,
    /// Quality of the result.
    pub quality: Quality,
}
