//! Options and results of an alignment, and reasons not to trust a piece.

use super::pose::Pose;

/// The initial positions of the pieces.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Start<'a> {
    /// The given positions.
    #[default]
    AsGiven,
    /// The given positions moved by these poses, one for each piece.
    Poses(&'a [Pose]),
    /// Each piece's principal axes on the first piece's, in the best of the four possible ways. For
    /// pieces that each show the whole object.
    PrincipalAxes,
    /// Matching rims, for pieces of one surface that was cut or broken. [`Overlap`] then describes
    /// the rims.
    Rims,
    /// Similar features of the surfaces, for overlapping pieces in any positions. The given
    /// positions do not matter. A piece does not move if its pose is uncertain, and is then
    /// [`Reason::Undetermined`].
    Features,
}

/// Options of [`align`](super::align()).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options<'a> {
    /// The initial positions of the pieces.
    pub start: Start<'a>,
    /// The largest distance of a pair of points on two pieces, in the unit of the positions; `None`
    /// means a tenth of the diagonal of the largest piece's box.
    pub max_distance: Option<f64>,
    /// The number of points of each piece to look for on the others; 0 means 2,000.
    pub samples: u32,
    /// The largest number of rounds; 0 means 100.
    pub max_rounds: u32,
}

/// The reason why a piece is not trusted to be aligned.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// The piece is trusted: it fits trusted pieces, in a chain from the first piece. A smooth
    /// surface within a mean edge of another one counts as fitting.
    Trusted,
    /// The piece lacks faces, or its overlaps with other pieces are missing or too small.
    NoOverlap,
    /// Too much of the piece lies off the pieces that it overlaps.
    PoorFit,
    /// The overlaps leave the piece free to slide or turn, as between planes, spheres or cylinders.
    /// With [`Start::Features`] also: no pose is certain, because the piece overlaps too little or
    /// fits in several ways.
    Undetermined,
    /// Most of the overlapping surface faces the opposite side: the piece is inside out, or
    /// mirrored.
    FacesOtherWay,
    /// The piece does not overlap others, and is more than fifty times as large or as small as the
    /// first. Most likely it uses a different unit of length.
    OtherSize,
    /// The piece fits only pieces that are not trusted.
    TrustedByNone,
}

/// The final overlap of two pieces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overlap {
    /// The pieces, the smaller index first.
    pub pieces: [u32; 2],
    /// The share of each piece's points that lie on the other, from 0 to 1.
    pub shares: [f64; 2],
    /// The number of pairs of points.
    pub count: u32,
    /// The mean distance of a point of one piece from the other's surface, in the unit of the
    /// positions. It is measured along the mean of both normals.
    pub mean: f64,
    /// The root mean square of these distances.
    pub rms: f64,
    /// The share of the points near the other piece that lie on it.
    pub fit: f64,
    /// True if the pieces fit; see [`Alignment`].
    pub trusted: bool,
}

/// One aligned piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Aligned {
    /// The pose that takes the piece's positions to their new places.
    pub pose: Pose,
    /// [`Reason::Trusted`], or the reason why the piece is not trusted.
    pub reason: Reason,
    /// How well the overlaps hold the piece, from 0 to 1. It is the root mean square change of the
    /// distances, relative to the length of the motion, for the weakest of the piece's six motions.
    /// The first piece is fixed, and has 1.
    pub hold: f64,
}

/// The poses of the pieces, and an assessment of each.
///
/// Two pieces fit if at least 30 points lie on each other's surface, and at least two thirds of the
/// nearby points do.
#[derive(Debug, Clone, PartialEq)]
pub struct Alignment {
    /// The pieces, in their order.
    pub pieces: Vec<Aligned>,
    /// The pairs of pieces that overlap, ordered by the pieces.
    pub overlaps: Vec<Overlap>,
    /// The number of rounds.
    pub rounds: u32,
    /// True if nothing moved at the end; false if the limit on rounds was reached.
    pub converged: bool,
}
