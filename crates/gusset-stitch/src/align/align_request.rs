//! Options, results, and why a piece is not trusted.

use super::pose::Pose;

/// Where the pieces are to begin with.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Start<'a> {
    /// Where their positions say.
    #[default]
    AsGiven,
    /// Moved by these, one for each piece.
    Poses(&'a [Pose]),
    /// Each with its principal axes on those of the first piece, in the one of the four ways to do
    /// so that fits best. For pieces that show the same object whole.
    PrincipalAxes,
    /// By rims that run alike: for pieces of one surface that was cut or broken. See
    /// [`Overlap`] for what holds such pieces.
    Rims,
}

/// How to align.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options<'a> {
    /// Where the pieces begin.
    pub start: Start<'a>,
    /// Points that are farther than this from another piece are no pair with it, in the unit of the
    /// positions; `None`: a tenth of the diagonal of the largest piece's box.
    pub max_distance: Option<f64>,
    /// So many points of each piece are looked for on the others; 0: 2,000.
    pub samples: u32,
    /// Rounds at the most; 0: 100.
    pub max_rounds: u32,
}

/// Why a piece is not trusted to lie right.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// It is: it fits pieces that are trusted, up to the first one. A smooth surface that lies within
    /// a mean edge of another passes for it.
    Trusted,
    /// It has no faces, or lies on no other piece, or on too little of one.
    NoOverlap,
    /// Where it overlaps others, too much of it lies off them.
    PoorFit,
    /// The overlaps leave it free to slide or turn, as between planes, spheres or cylinders.
    Undetermined,
    /// Most of what lies on other pieces faces the other way: it is inside out, or mirrored.
    FacesOtherWay,
    /// It lies on no other piece, and is more than fifty times as large or as small as the first: a
    /// different unit of length, most likely.
    OtherSize,
    /// It fits pieces that are not trusted only.
    TrustedByNone,
}

/// What two pieces have in common, in the end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overlap {
    /// The pieces, the smaller number first.
    pub pieces: [u32; 2],
    /// The share of each piece's points that lie on the other, from 0 to 1.
    pub shares: [f64; 2],
    /// The pairs of points.
    pub count: u32,
    /// The mean distance of a point of one piece from the other's surface, by the plane of both
    /// normals, in the unit of the positions; and the root of the mean square.
    pub mean: f64,
    /// See above.
    pub rms: f64,
    /// The share of the points near the other piece that lie on it.
    pub fit: f64,
    /// They fit: see [`Alignment`].
    pub trusted: bool,
}

/// One piece, aligned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Aligned {
    /// Takes the piece's positions to their new place.
    pub pose: Pose,
    /// Whether it is trusted, and if not, why.
    pub reason: Reason,
    /// How well the overlaps hold it: how much the most yielding of its six motions changes the
    /// distances, as the root of the mean square of the change over the length of the motion; 0 to
    /// 1. Of the first piece, which stays, 1.
    pub hold: f64,
}

/// Where the pieces lie, and what is known of it.
///
/// Two pieces fit if at least 30 points lie on each other's surface, and two thirds of the points
/// near it do.
#[derive(Debug, Clone, PartialEq)]
pub struct Alignment {
    /// The pieces, in their order.
    pub pieces: Vec<Aligned>,
    /// The pairs with anything in common, by their pieces.
    pub overlaps: Vec<Overlap>,
    /// Rounds that were done.
    pub rounds: u32,
    /// Nothing moved any more in the end; otherwise the rounds were not enough.
    pub converged: bool,
}
