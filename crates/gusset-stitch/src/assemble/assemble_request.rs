//! Options, results and the report of every join and every loop left.

use super::history::History;
use crate::repair::orient::Outward;
use crate::stitch::{self, IndexMap};
use crate::{fill, repair, trim};
use gusset_mesh::{Mesh, NONE};
use std::ops::Range;

/// How wide a gap may be that is still closed by a strip: the mean distance from the vertices of
/// each loop to the nearest of the other.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum MaxGap {
    /// For whole loops a fifth of the larger component's size, or the mean radius of the smaller
    /// loop (the mean distance of its vertices from their centre) if that is more; for runs of
    /// loops half the smaller radius, and at most four edges of the loop with the longer ones. Two
    /// loops that are the only ones, of two pieces, are joined however far they are.
    ///
    /// For what sewing left of two borders half the loop's radius, and at most one of its mean
    /// edges.
    ///
    /// Between pieces whose overlaps are trimmed, two and a half mean edges of the coarsest, or
    /// four where a part would be left alone.
    #[default]
    Auto,
    /// This, in the unit of the positions, finite and at least 0; 0 leaves all gaps open.
    Given(f64),
}

/// Names loops of the input: the one through a vertex of a piece, or all with a vertex of the
/// piece.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Selector {
    /// The piece.
    pub piece: u32,
    /// Its vertex, or [`NONE`].
    pub vertex: u32,
}

impl Selector {
    /// All loops with a vertex of `piece`.
    pub fn piece(piece: u32) -> Self {
        Selector { piece, vertex: NONE }
    }
}

/// What becomes of pieces that overlap.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Overlaps<'a> {
    /// They stay as they are.
    #[default]
    Keep,
    /// Of each overlap one piece is kept, and the gap between them is closed as others are; see
    /// [`trim`](crate::trim::trim()).
    Trim(trim::Options<'a>),
}

/// How to assemble.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options<'a> {
    /// What becomes of pieces that overlap.
    pub overlaps: Overlaps<'a>,
    /// How coincident borders are sewn; `None`: not at all.
    pub weld: Option<repair::weld::Options>,
    /// Borders are sewn only where they match vertex by vertex. Otherwise free edges are split at
    /// the vertices of other borders; see [`sew`](repair::sew::sew).
    pub edge_to_edge: bool,
    /// The pieces keep their orientation as it is: nothing is turned, nor in the end.
    pub keep_orientation: bool,
    /// The side that closed components of the result face; outwards by default. Each that is inside out is turned over
    /// as a whole in the end, as [`turn_outwards`](repair::orient::turn_outwards()) does.
    pub outward: Outward,
    /// Which gaps are closed.
    pub max_gap: MaxGap,
    /// Only whole loops are joined, no parts of them, nor what sewing left of two borders.
    pub whole_loops_only: bool,
    /// Loops of one component may be joined too. Otherwise only pairs that are given are.
    pub within_components: bool,
    /// Pairs to be joined however wide the gap is; each selector names one loop by a vertex.
    pub pairs: &'a [[Selector; 2]],
    /// Pairs that are not to be joined.
    pub excluded: &'a [[Selector; 2]],
    /// The strips: meridians, search, start, rows, cells, fairing and intersections; the other
    /// fields are not read.
    pub strip: stitch::Options,
    /// How holes that are left are filled; `None`: not at all. Its `outward` is not read.
    pub fill: Option<fill::Options>,
}

impl Default for Options<'_> {
    fn default() -> Self {
        Options {
            overlaps: Overlaps::Keep,
            weld: None,
            edge_to_edge: false,
            keep_orientation: false,
            outward: Outward::Closed,
            max_gap: MaxGap::default(),
            whole_loops_only: false,
            within_components: false,
            pairs: &[],
            excluded: &[],
            strip: stitch::Options::default(),
            fill: None,
        }
    }
}

/// What became of two loops, or runs of loops, that face each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// A strip joins them.
    Joined,
    /// Joining them would make a one-sided surface with what is joined already.
    OrientationConflict,
    /// They pass the same vertex.
    ShareVertex,
    /// Every strip would repeat an edge that the mesh already has.
    NoStrip,
    /// Between pieces that were trimmed, the strip would cut others, and the gap is left to the
    /// holes.
    WouldCut,
}

/// Two loops, or runs of loops, that face each other. Indices are those of the result. What sewing
/// left of two borders is a loop that is joined with itself (`slit`): both sides are on it, and the
/// strip has no interior rows.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// The vertices of each side in order; if joined, side by side from the first meridian on. The
    /// order is that of before closed components were turned outwards.
    pub sides: [Vec<u32>; 2],
    /// Both are whole loops.
    pub whole: bool,
    /// The mean distance from the vertices of one side to the nearest of the other; the larger of
    /// the two means. Of a loop that is joined with itself, to the nearest points of the other
    /// side.
    pub gap: f64,
    /// What became of them.
    pub outcome: Outcome,
    /// What the strip is: a blend that was asked for may have had to give way to the strip.
    pub finish: stitch::Finish,
    /// The strip's new vertices and its faces.
    pub vertices: Range<u32>,
    /// See above.
    pub faces: Range<u32>,
    /// Pairs of faces that cut each other; see
    /// [`Stitch::intersections`](stitch::Stitch::intersections).
    pub intersections: Option<Vec<[u32; 2]>>,
}

/// Why a loop, or part of one, was left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// There is no other loop.
    Alone,
    /// The nearest loop is farther away than is allowed; or the loop is what sewing left of two
    /// borders, and its two sides are.
    TooFar,
    /// All other loops are of its own component, and such are not joined.
    SameComponent,
    /// The nearest loop is near enough, but they do not look at each other along enough of both.
    LooksAway,
    /// The nearest loop is joined with another.
    Taken,
    /// It is not to be joined with the nearest loop.
    Excluded,
    /// It is open, or the faces along it disagree in orientation or are not manifold there.
    NotSimple,
    /// It has fewer than three vertices.
    TooShort,
    /// It faces another loop, but no strip could be made: see the joints that failed.
    NotJoined,
}

/// A loop of the welded pieces that no strip hangs on, before holes are filled.
#[derive(Debug, Clone, PartialEq)]
pub struct LeftLoop {
    /// Its vertices in the result, in order.
    pub vertices: Vec<u32>,
    /// Why it was left.
    pub reason: Reason,
    /// The mean distance from its vertices to the nearest of the loop that is nearest to most of
    /// them, of another component where there is one; infinite if there is none, or if this loop
    /// cannot carry a strip. Of what sewing left of two borders, whose sides are too far from each
    /// other, the mean distance of these.
    pub gap: f64,
    /// How far that loop, or that side, may be to be joined; 0 if there is none.
    pub allowed_gap: f64,
}

/// The assembled mesh and its account.
#[derive(Debug, Clone, PartialEq)]
pub struct Assembly {
    /// Vertices: those of the pieces that are left after welding, in order; then those of the
    /// strips; then those of the patches. Faces in the same way.
    pub mesh: Mesh,
    /// For each piece, its old indices to new ones; [`NONE`] for what welding dropped. Of a face
    /// that was cut, the first part, which the others follow.
    pub maps: Vec<IndexMap>,
    /// Per face of the pieces in the result, whether it runs the other way than it did in its
    /// piece: turned to agree with others, or with its component to face outwards, but not both.
    /// The faces of strips and patches come after them and were nothing before: they run as the
    /// faces of pieces beside them do.
    pub turned: Vec<bool>,
    /// Faces that were trimmed from overlaps.
    pub trimmed_faces: u32,
    /// Vertices that became one with another, and edges sewn.
    pub welded_vertices: u32,
    /// See above.
    pub sewn_edges: u32,
    /// Points at which free edges were split for borders to match.
    pub splits: u32,
    /// Components that cannot be oriented: a face of each.
    pub one_sided: Vec<u32>,
    /// Closed components of the result that enclose no volume, as a piece does that is given twice:
    /// a face of each. Empty where orientation is kept, or `outward` is [`Outward::Keep`].
    pub zero_volume: Vec<u32>,
    /// The pairs that face each other, nearest first, pairs that were given before all others.
    pub joints: Vec<Joint>,
    /// The loops that no strip hangs on; those that were filled in the end are among them.
    pub left: Vec<LeftLoop>,
    /// The holes that were looked at in the end.
    pub holes: Vec<fill::Hole>,
    /// The vertices of their rims, in the order of before closed components were turned outwards.
    pub hole_rims: Vec<u32>,
    /// What the elements of the result were made of.
    pub history: History,
    /// Boundary loops of the result.
    pub loops_left: u32,
    /// Loops that were left although another one is within the gap that is allowed: those that look
    /// away, whose partner is taken, or that no strip could join.
    pub near_loops_left: u32,
    /// Edges of the result with three or more faces.
    pub non_manifold_edges: u32,
}
