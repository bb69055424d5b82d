//! Options, results, and the report on every joint and every loop left.

use super::origin_history::History;
use crate::repair::near_borders::NearBorders;
use crate::repair::orient::Outward;
use crate::stitch::{self, IndexMap};
use crate::{fill, repair, trim};
use gusset_mesh::{Mesh, NONE};
use std::ops::Range;

/// The widest gap that a strip closes. The gap is the mean distance from the vertices of each loop
/// to the nearest vertex of the other.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum MaxGap {
    /// Derives the limit from the input, for each kind of gap.
    ///
    /// * Whole loops: a fifth of the larger component's size, or the mean radius of the smaller
    ///   loop if that is larger. The radius is the mean distance of the vertices from their centre.
    ///   The only two loops, of two pieces, are joined at any distance, unless they lie beside each
    ///   other.
    /// * Whole loops of two pieces with nobody else near: three times that limit. Among the loops
    ///   without a partner, each of the two is nearest to three quarters of the other's vertices.
    ///   They look at each other.
    /// * Runs of loops: half the smaller radius, and at most four edges of the loop with longer
    ///   edges.
    /// * Slits that sewing left between two borders: one mean edge, and half the loop's radius
    ///   unless the slit is narrow.
    /// * Gaps between borders that share vertices: the longest edge of both sides.
    /// * Whole loops that coincide in part: twice the limit of whole loops, before they are sewn. The
    ///   rest is closed at any gap, with [`Extent::LoopsAndParts`].
    /// * Trimmed pieces: two and a half mean edges of the coarsest piece, or four if a part would
    ///   stay unjoined.
    #[default]
    Auto,
    /// This limit in the unit of the positions, finite and at least 0; 0 leaves all gaps open.
    Given(f64),
}

/// The parts of loops that are joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Extent {
    /// Whole loops, and parts of the other loops.
    #[default]
    LoopsAndParts,
    /// Whole loops only: runs of loops, and slits that sewing left, stay open.
    WholeLoops,
    /// Parts only: runs of loops, and slits that sewing left.
    Parts,
}

/// Selects loops of the input: the loop through a vertex of a piece, or all loops with a vertex of
/// the piece.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Selector {
    /// The piece.
    pub piece: u32,
    /// A vertex of the piece, or [`NONE`] for the whole piece.
    pub vertex: u32,
}

impl Selector {
    /// Selects all loops with a vertex of `piece`.
    pub fn piece(piece: u32) -> Self {
        Selector { piece, vertex: NONE }
    }
}

/// The treatment of pieces that overlap.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Overlaps<'a> {
    /// Overlapping pieces are kept.
    #[default]
    Keep,
    /// One piece of each overlap is kept, and the gap between the pieces is closed like other gaps;
    /// see [`trim`](crate::trim::trim()).
    Trim(trim::Options<'a>),
}

/// Options of [`assemble`](super::assemble()).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options<'a> {
    /// The treatment of pieces that overlap.
    pub overlaps: Overlaps<'a>,
    /// How coincident borders are sewn; `None` disables sewing.
    pub weld: Option<repair::weld::Options>,
    /// If true, borders are sewn only where they match vertex by vertex. Otherwise free edges are
    /// split at the vertices of other borders; see [`sew`](repair::sew::sew).
    pub edge_to_edge: bool,
    /// If true, nothing is turned over, and closed components keep their orientation too.
    pub keep_orientation: bool,
    /// The side that closed components of the result face; outwards by default. A closed component
    /// that is inside out is turned over as a whole by
    /// [`turn_outwards`](repair::orient::turn_outwards()).
    pub outward: Outward,
    /// The widest gap that is closed.
    pub max_gap: MaxGap,
    /// The parts of loops that are joined.
    pub extent: Extent,
    /// If true, loops of one component may be joined. Otherwise only given pairs may lie on one
    /// component.
    pub within_components: bool,
    /// Pairs to join at any distance. Each selector names one loop by a vertex.
    pub pairs: &'a [[Selector; 2]],
    /// Pairs that must not be joined.
    pub excluded: &'a [[Selector; 2]],
    /// Options of the strips: meridians, search, start, rows, cells, fairing and intersections. The
    /// other fields are not read.
    pub strip: stitch::Options,
    /// How remaining holes are filled; `None` disables filling. Its `outward` is not read. If the
    /// strips are blends, so are the patches. If overlaps are trimmed, [`fill::Keep::Auto`] acts as
    /// [`fill::Keep::OuterBorders`]: the outer border of a scan is not a hole.
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
            extent: Extent::default(),
            within_components: false,
            pairs: &[],
            excluded: &[],
            strip: stitch::Options::default(),
            fill: None,
        }
    }
}

/// The outcome for two loops, or runs of loops, that face each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// A strip joins the two sides.
    Joined,
    /// A strip would create a one-sided surface.
    OrientationConflict,
    /// They share a vertex, or have vertices that coincide.
    ShareVertex,
    /// Every strip would repeat an existing edge of the mesh.
    NoStrip,
    /// The strip between trimmed pieces would intersect other faces. The gap becomes a hole.
    WouldCut,
}

/// Two loops, or runs of loops, that face each other, with the indices of the result.
///
/// A slit that sewing left between two borders is joined with itself: both sides lie on one loop,
/// and the strip lacks interior rows.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// The vertices of each side in order; if joined, side by side from the first meridian on. The
    /// order is the one before closed components were turned outwards.
    pub sides: [Vec<u32>; 2],
    /// True if both are whole loops.
    pub whole: bool,
    /// The mean distance from the vertices of one side to the nearest vertex of the other, the
    /// larger of both means. For a slit, or for runs of loops, the distance to the nearest points of
    /// the other side.
    pub gap: f64,
    /// The outcome.
    pub outcome: Outcome,
    /// The resulting surface. It is the strip if a requested blend was not possible.
    pub finish: stitch::Finish,
    /// The new vertices of the strip.
    pub vertices: Range<u32>,
    /// The faces of the strip.
    pub faces: Range<u32>,
    /// Pairs of intersecting faces; see [`Stitch::intersections`](stitch::Stitch::intersections).
    pub intersections: Option<Vec<[u32; 2]>>,
    /// The total length of the segments in which these faces intersect.
    pub cut_length: f64,
    /// True if the strip intersects faces, and a blend would not. Tried only for strips with
    /// [`Intersections::Auto`](stitch::Intersections::Auto) between pieces that are not trimmed.
    pub blend_avoids_cuts: bool,
}

impl Joint {
    /// Returns true if faces of the strip are known to intersect others.
    pub fn has_cuts(&self) -> bool {
        self.intersections.as_ref().is_some_and(|pairs| !pairs.is_empty())
    }
}

/// The reason why a loop, or part of it, was left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// No other loop exists.
    Alone,
    /// The nearest loop is too far away. For a slit that sewing left: its two sides are too far
    /// apart.
    TooFar,
    /// All other loops belong to the same component, and the options exclude such pairs.
    SameComponent,
    /// The nearest loop is near enough, but the loops do not face each other along enough of both.
    LooksAway,
    /// The nearest loop is joined with another loop.
    Taken,
    /// The options exclude a joint with the nearest loop.
    Excluded,
    /// The loop is open, or the faces along it are non-manifold or have inconsistent orientations.
    NotSimple,
    /// The loop has fewer than three vertices.
    TooShort,
    /// The loop faces another loop, but no strip was possible; see the failed joints.
    NotJoined,
}

/// A loop of the welded pieces without a strip, before holes are filled.
#[derive(Debug, Clone, PartialEq)]
pub struct LeftLoop {
    /// The loop's vertices in the result, in order.
    pub vertices: Vec<u32>,
    /// The piece of the loop's first vertex that a piece has, and that vertex of the piece;
    /// [`NONE`] if the loop has only new vertices.
    pub origin: [u32; 2],
    /// The reason why it was left.
    pub reason: Reason,
    /// The mean distance to the loop that is nearest to most of its vertices, measured to the
    /// nearest vertices.
    ///
    /// Loops of other components take precedence. Infinite without other loops, or if this loop
    /// cannot carry a strip. For a slit that sewing left open: the mean distance between its sides.
    pub gap: f64,
    /// The largest gap at which that loop, or that side, would be joined; 0 if there is none.
    pub allowed_gap: f64,
    /// True if hole filling closed the loop afterwards.
    pub filled: bool,
}

/// The assembled mesh and its report.
#[derive(Debug, Clone, PartialEq)]
pub struct Assembly {
    /// The vertices of the pieces that remain after welding, in order, then the strips' new
    /// vertices, then the patches'. The faces have the corresponding order.
    pub mesh: Mesh,
    /// For each piece, the map from old to new indices; [`NONE`] for elements that welding removed.
    /// A face that was cut maps to its first part, which the other parts follow.
    pub maps: Vec<IndexMap>,
    /// For each face of the pieces in the result, whether its orientation changed. A face that was
    /// turned twice, to agree with others and to face outwards, is not marked. The faces of strips
    /// and patches follow, and run like the faces of the pieces beside them.
    pub turned: Vec<bool>,
    /// The number of faces that were trimmed from overlaps.
    pub trimmed_faces: u32,
    /// The trimmed faces that no kept face covers: (piece, face), in ascending order. The kept faces
    /// are farther away than [`trim::Options::max_distance`], or face another side.
    pub lost_faces: Vec<[u32; 2]>,
    /// The number of vertices that were merged into others.
    pub welded_vertices: u32,
    /// The number of edges that were sewn.
    pub sewn_edges: u32,
    /// The number of points at which free edges were split to match other borders.
    pub splits: u32,
    /// Free edges that coincide with others beyond the tolerance of sewing.
    pub near: NearBorders,
    /// One face of each component that is not orientable.
    pub one_sided: Vec<u32>,
    /// One face of each closed component of the result without volume, for example of a piece that
    /// is given twice. Empty if the orientation is kept, or if `outward` is [`Outward::Keep`].
    pub zero_volume: Vec<u32>,
    /// The pairs that face each other, nearest first, after the given pairs.
    pub joints: Vec<Joint>,
    /// The loops without a strip, including those that were filled afterwards.
    pub left: Vec<LeftLoop>,
    /// The holes that were considered for filling.
    pub holes: Vec<fill::Hole>,
    /// Pairs of intersecting faces, the first on a patch, as in
    /// [`Filled::intersections`](fill::Filled::intersections); `None` if they were not looked
    /// for.
    pub hole_intersections: Option<Vec<[u32; 2]>>,
    /// For each hole, the total length of the segments in which its patch intersects other faces.
    pub hole_cut_lengths: Vec<f64>,
    /// The vertices of the holes' rims, in the order before closed components were turned outwards.
    pub hole_rims: Vec<u32>,
    /// The origins of the elements of the result.
    pub history: History,
    /// The number of boundary loops of the result.
    pub loops_left: u32,
    /// The number of loops that stayed open although another loop is within the allowed gap: their
    /// reason is [`Reason::LooksAway`], [`Reason::Taken`] or [`Reason::NotJoined`].
    pub near_loops_left: u32,
    /// The number of edges of the result with three or more faces.
    pub non_manifold_edges: u32,
}
