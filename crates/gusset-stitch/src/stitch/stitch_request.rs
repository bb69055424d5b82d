//! Request, options and result of a stitch.

use super::extent::Extent;
use super::facing::{Centres, Run};
use super::first_meridian::Start;
use super::meridian::{Meridians, Pair, Search};
use super::quality::Quality;
use crate::repair::orient::Outward;
use gusset_base::choices;
use gusset_base::job::Job;
use gusset_mesh::{Mesh, MeshView};
use std::ops::Range;

/// What happens if the second piece is oriented against the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Orientation {
    /// Its faces are turned over. Two loops of one connected piece are taken as they are: turning
    /// is no way out there.
    #[default]
    Fix,
    /// [`Error::OrientationConflict`](gusset_base::Error::OrientationConflict).
    Refuse,
    /// The rims are not compared: the faces are taken to be right as they are.
    Keep,
}

choices! { for Orientation:
    Fix => "Reverse it", "Its faces are reversed.";
    Refuse => "Refuse", "The filter fails.";
    Keep => "Ignore", "The faces are taken as they are.";
}

/// How many rows of new vertices lie between the rims.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Rows {
    /// None: every meridian is one edge.
    #[default]
    None,
    /// So many that the parts of a meridian are, in the mean, about as long as the mean side of the
    /// faces of both pieces, as the paper suggests: max(0, round(mean meridian / mean side) - 1).
    MeanEdge,
    /// This many.
    Count(u32),
}

/// What the strip is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Cells {
    /// Triangles throughout; quads are split by their shorter diagonals.
    #[default]
    Triangles,
    /// Quads where four different neighbours meet, and triangles where a rim repeats a vertex.
    Quads,
}

choices! { for Cells:
    Triangles => "Triangles", "Quads are split by their shorter diagonals.";
    Quads => "Quads", "Quads where four different neighbours meet, triangles elsewhere.";
}

/// Whether the new vertices stay on straight meridians.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Fairing {
    /// They divide their meridians evenly, as the paper has it.
    #[default]
    None,
    /// They are moved so that the strip bends as a thin plate does and meets both pieces smoothly:
    /// see [`stitch()`](super::stitch()). The rims stay where they are.
    ThinPlate,
}

choices! { for Fairing:
    None => "Straight", "Evenly on straight lines from rim to rim.";
    ThinPlate => "Fair", "The strip bends as a thin plate and joins both pieces smoothly.";
}

/// What lies between the rims in the end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Finish {
    /// The strip of meridians, with its rows.
    #[default]
    Strip,
    /// The best-looking joint: triangles about as fine as those round the rims, graded between them,
    /// without sharp angles where the rims allow it, on a surface that leaves both pieces along their
    /// tangents. The strip, without rows, says which way it goes: meridians and matrix are its own,
    /// and no edges of the result; rows, cells and fairing are not read. Where every blend would cut
    /// more faces than the strip does, or would need too many vertices, the strip stays, and a note
    /// says so. The surface bends as the strip does as a whole, so that a gap in a tube is bridged by
    /// a tube. Time and memory grow with the number of new triangles.
    Blend,
}

choices! { for Finish:
    Strip => "Strip", "The strip of meridians, with its rows.";
    Blend => "Blend", "Triangles as fine as the faces around them, on a smooth surface: the best-looking joint.";
}

/// Whether faces of the strip that cut others are looked for. What they share, a vertex or an
/// edge, is no cut, nor are vertices and edges at the same place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Intersections {
    /// Always, and they are avoided: faired rows and blends are taken back until nothing cuts, or
    /// nothing is left to take back, and a strip of triangles without rows by
    /// [`Meridians::Continuation`] goes another way where it cuts (`avoid`). Other strips stay as
    /// they are.
    #[default]
    Auto,
    /// Never: rows are faired in full, and the first blend is kept.
    Ignore,
    /// Always. Faired rows and blends are taken back; no strip goes another way.
    Report,
}

choices! { for Intersections:
    Auto => "Automatic", "They are found, and avoided by faired rows, blends and the best continuation.";
    Ignore => "Ignore", "No search.";
    Report => "Report", "They are found, and avoided by faired rows and blends only.";
}

/// How to stitch.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options {
    /// The choice of meridians.
    pub meridians: Meridians,
    /// How hard the best ones are looked for.
    pub search: Search,
    /// Which first meridians of a closed band are tried.
    pub start: Start,
    /// What to do about a second piece that is oriented against the first.
    pub orientation: Orientation,
    /// The first meridian of a closed band joins the closest pair; with a twist, the vertex of rim
    /// B that comes this many places later, counted in the direction in which rim A runs (negative:
    /// earlier), and no other start is tried. Must be 0 if arcs are joined.
    pub twist: i64,
    /// How much of the loops is joined.
    pub extent: Extent,
    /// Which run of facing vertices is taken, where there are several.
    pub run: Run,
    /// How far a vertex must be from its loop's plane to face the other loop, in the unit of the
    /// positions; `None` for what round-off can do.
    pub tolerance: Option<f64>,
    /// The loops' centres, which the planes go through.
    pub centres: Centres,
    /// Interior rows.
    pub rows: Rows,
    /// Triangles or quads.
    pub cells: Cells,
    /// Whether the rows are faired; if none are asked for, a note says that this is not read.
    pub fairing: Fairing,
    /// The strip itself, or a blend in its place.
    pub finish: Finish,
    /// Whether faces that cut each other are looked for.
    pub intersections: Intersections,
    /// What becomes of closed components of the result: they stay as they are, or those that are
    /// inside out are turned over, each as a whole, as [`turn_outwards`] does.
    ///
    /// [`turn_outwards`]: crate::repair::orient::turn_outwards()
    pub outward: Outward,
}

impl Options {
    /// Tells the host of what it asked for that is not read.
    pub(crate) fn note_unread(&self, job: &Job<'_>) {
        let no_rows = matches!(self.rows, Rows::None | Rows::Count(0));
        if self.finish == Finish::Blend {
            if !no_rows || self.cells == Cells::Quads || self.fairing == Fairing::ThinPlate {
                job.note("a blend has no rows or quads and is always fair: rows, cells and fairing are not read");
            }
        } else if self.fairing == Fairing::ThinPlate && no_rows {
            job.note("fairing moves the vertices of interior rows, and none were asked for: it does nothing");
        }
    }

    /// How the strip is made: for a blend, of triangles without rows.
    pub(crate) fn of_strip(&self) -> Options {
        match self.finish {
            Finish::Strip => *self,
            Finish::Blend => Options { rows: Rows::None, cells: Cells::Triangles, fairing: Fairing::None, ..*self },
        }
    }
}

/// What to stitch: two loops of two meshes, or of one.
///
/// A loop is the list of its vertices in order, in either direction, each consecutive pair (and the
/// last with the first) being an edge with exactly one face. `None` leaves the choice open: the
/// nearest loops are taken, see [`stitch()`](super::stitch()).
#[derive(Clone, Copy)]
pub struct Request<'a> {
    /// The first piece.
    pub a: &'a MeshView<'a>,
    /// Its loop.
    pub loop_a: Option<&'a [u32]>,
    /// The second piece; `None` if both loops are of the first.
    pub b: Option<&'a MeshView<'a>>,
    /// The second loop.
    pub loop_b: Option<&'a [u32]>,
}

/// Old indices to new ones.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct IndexMap {
    /// Per old vertex, the new one.
    pub vertices: Vec<u32>,
    /// Per old face, the new one.
    pub faces: Vec<u32>,
}

/// The result of stitching.
#[derive(Debug, Clone, PartialEq)]
pub struct Stitch {
    /// Both pieces and the strip: vertices of A, then of B, then the new ones; faces of A, then of
    /// B, then the strip. Positions are in the scalar type of A, and old ones keep their bits.
    pub mesh: Mesh,
    /// The strip alone: the N vertices of rim A in order, then the M of rim B, then the new ones,
    /// and its faces.
    pub strip: Mesh,
    /// Old indices to new ones, for each piece; the second is empty if there is only one piece.
    pub maps: [IndexMap; 2],
    /// The strip's faces in [`Stitch::mesh`].
    pub strip_faces: Range<u32>,
    /// The vertices of each rim in [`Stitch::mesh`], from the first meridian on, side by side: rim
    /// A has its surface on the left, rim B on the right, as they were before
    /// [`Stitch::turned_outwards`].
    pub rims: [Vec<u32>; 2],
    /// The strip is a closed band between whole loops; else it joins two arcs.
    pub closed: bool,
    /// The meridians as places (i, j) on the rims: the paper's matrix H. From (0, 0) to (N, M),
    /// place N being place 0 again, if the band is closed, else to (N - 1, M - 1).
    pub meridians: Vec<Pair>,
    /// The paper's matrix P, row by row from rim A to rim B, one column for each meridian: vertices
    /// of [`Stitch::mesh`].
    pub matrix: Vec<u32>,
    /// Interior rows; the matrix has two rows more.
    pub rows: u32,
    /// Of each new vertex, three vertices of the rims in [`Stitch::mesh`] that it lies between: in a
    /// row the ends of its meridian, that on rim B twice; of a blend the corners of the triangle of
    /// the strip that it would be on without fairing.
    pub parents: Vec<[u32; 3]>,
    /// How much each new vertex has of its parents; at least 0, with sum 1. In row k of r rows
    /// 1 - k / (r + 1), k / (r + 1) and 0.
    pub weights: Vec<[f64; 3]>,
    /// Pairs of faces of [`Stitch::mesh`] that cut each other, the first one of the strip and the
    /// larger one if both are, in ascending order; `None` if they were not looked for. Polygons are
    /// taken as triangles: quads split by their shorter diagonals, others as fans; a polygon that
    /// cuts itself is paired with itself.
    pub intersections: Option<Vec<[u32; 2]>>,
    /// What the strip is: a blend that was asked for may have had to give way to the strip.
    pub finish: Finish,
    /// How often the fairing had to be taken back in places.
    pub back_offs: u32,
    /// The second piece was turned over, so as to agree with the first one.
    pub turned: bool,
    /// Its faces in [`Stitch::mesh`] if it was, ascending. Each keeps its first corner and has the
    /// others in reverse order.
    pub turned_faces: Vec<u32>,
    /// Faces of the result, those of the strip too, that [`Options::outward`] had turned over in
    /// the end, ascending. Each keeps its first corner and has the others in reverse order.
    pub turned_outwards: Vec<u32>,
    /// Measures of the result.
    pub quality: Quality,
}
