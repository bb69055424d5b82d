//! Alignment: Finds the rigid poses at which overlapping pieces fit.
//!
//! @source P. Besl and N. McKay (1992); Y. Chen and G. Medioni (1992); G. Turk and M. Levoy
//!     (1994); P. Neugebauer (1997); S. Rusinkiewicz (2019).

use crate::align::{Aligned, Alignment, Options, Overlap, Pose, Reason, Start, align};
use crate::capi::context::{create, gusset_context, lend};
use crate::capi::glue::{c_enum, fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, Choice};
use crate::capi::mesh::{self, GivenMesh, gusset_mesh_view};
use crate::capi::status::{Failure, gusset_status};
use crate::capi::transform::gusset_transform;
use crate::error::Error;
use glam::{DMat3, DVec3};
use gusset_base::alloc;

/// The poses in which pieces begin.
pub type gusset_alignment_start = u32;
/// The pieces begin where their positions say, or where poses move them if these are given.
pub const GUSSET_ALIGN_AS_GIVEN: gusset_alignment_start = 0;
/// Each piece begins with its principal axes on those of the first one, in the one of the four ways
/// to do so after which most of it lies on the first. For pieces that show the same object whole.
pub const GUSSET_ALIGN_PRINCIPAL_AXES: gusset_alignment_start = 1;
/// The pieces are put together by rims that run alike, and it is their rims that hold them then:
/// for pieces of one surface that was cut or broken and do not overlap.
pub const GUSSET_ALIGN_RIMS: gusset_alignment_start = 2;

/// Whether the pose of a piece can be trusted, and if not why.
pub type gusset_aligned_reason = u32;
/// It can be trusted to lie right: it fits pieces that can be trusted, up to the first one. What
/// fits is judged by mean edges: a smooth surface that lies within one of another, as a slightly
/// scaled one or its mirror image may, passes for it. The rms of its overlaps, and converged, say
/// more.
/// Pieces that hold each other fast, but could slide together along the rest, pass, too.
pub const GUSSET_ALIGNED_TRUSTED: gusset_aligned_reason = 0;
/// It has no faces with an area, or too little of it lies on other pieces.
pub const GUSSET_ALIGNED_NO_OVERLAP: gusset_aligned_reason = 1;
/// Where it is near others, too much of it lies off them.
pub const GUSSET_ALIGNED_POOR_FIT: gusset_aligned_reason = 2;
/// The overlaps leave it free to slide or to turn, as planes, spheres or cylinders do.
pub const GUSSET_ALIGNED_UNDETERMINED: gusset_aligned_reason = 3;
/// Most of what lies on other pieces faces the other way: it is inside out, or mirrored.
pub const GUSSET_ALIGNED_FACES_OTHER_WAY: gusset_aligned_reason = 4;
/// It lies on no other piece, and is more than fifty times as large or small as the first one: its
/// unit of length is another, most likely.
pub const GUSSET_ALIGNED_OTHER_SIZE: gusset_aligned_reason = 5;
/// It fits pieces that cannot be trusted only.
pub const GUSSET_ALIGNED_TRUSTED_BY_NONE: gusset_aligned_reason = 6;

/// How pieces are aligned; all zero is the default.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_alignment_options {
    /// sizeof(gusset_alignment_options), set by the caller.
    pub struct_size: usize,
    /// Where the pieces begin.
    pub start: gusset_alignment_start,
    /// So many points of each piece are looked for on the others; 0: 2,000.
    pub samples: u32,
    /// Read for GUSSET_ALIGN_AS_GIVEN: motions of the pieces, rotations and translations, or NULL.
    pub poses: *const gusset_transform,
    /// Their number: that of the pieces, or 0.
    pub pose_count: usize,
    /// Points that are farther than this from another piece are no pair with it, in the unit of the
    /// positions, finite and at least 0; 0: a tenth of the diagonal of the largest piece's box.
    /// Pieces may begin that far from where they belong, or a little less.
    pub max_distance: f64,
    /// Rounds at the most, in each of two stages; 0: 100.
    pub max_rounds: u32,
    /// 0.
    pub reserved: u32,
}

/// One piece, aligned.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_aligned_piece {
    /// Takes the piece's positions to their new places: a rotation and a translation.
    pub pose: gusset_transform,
    /// How well the overlaps hold it, from 0 to 1: by how much the motion of length 1 that changes
    /// the distances of pairs least changes them, as a root of a mean square; turns count in radii
    /// of the piece. Of the first piece 1.
    pub hold: f64,
    /// Whether the pose of a piece can be trusted, and if not why.
    pub reason: gusset_aligned_reason,
    /// 0.
    pub reserved: u32,
}

/// What two pieces have in common where they lie in the end.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_overlap {
    /// The pieces, the smaller number first.
    pub pieces: [u32; 2],
    /// The shares of their points that lie on the other, within a mean edge of it; 0 to 1.
    pub shares: [f64; 2],
    /// The mean distance of these from the other's surface, in the unit of the positions.
    pub mean: f64,
    /// The root of the mean square.
    pub rms: f64,
    /// The share of the points within eight mean edges of the other piece that lie on it, 0 to 1.
    pub fit: f64,
    /// Of how many points this is known.
    pub count: u32,
    /// 1: they fit, as at least 30 points lie on each other and fit is at least two thirds. 0 or 1.
    pub trusted: u32,
}

/// Where pieces lie. Pointers are valid until it is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_alignment_view {
    /// sizeof(gusset_alignment_view), set by the caller.
    pub struct_size: usize,
    /// The pieces, in their order.
    pub pieces: *const gusset_aligned_piece,
    /// How many.
    pub piece_count: usize,
    /// The pairs with anything in common.
    pub overlaps: *const gusset_overlap,
    /// How many.
    pub overlap_count: usize,
    /// Rounds that were done.
    pub rounds: u32,
    /// 1: nothing moved any more in the end; 0: the rounds were not enough.
    pub converged: u32,
}

/// Where pieces that overlap belong. Opaque and immutable; it keeps nothing of them.
pub struct gusset_alignment {
    pieces: Vec<gusset_aligned_piece>,
    overlaps: Vec<gusset_overlap>,
    rounds: u32,
    converged: bool,
}

handle! { gusset_alignment }

versioned! { gusset_alignment_options: 48 reserved, gusset_alignment_view: 48 }
fixed! { gusset_aligned_piece: 112, gusset_overlap: 56 }

c_enum! {
    reason: Reason {
        GUSSET_ALIGNED_TRUSTED => Trusted,
        GUSSET_ALIGNED_NO_OVERLAP => NoOverlap,
        GUSSET_ALIGNED_POOR_FIT => PoorFit,
        GUSSET_ALIGNED_UNDETERMINED => Undetermined,
        GUSSET_ALIGNED_FACES_OTHER_WAY => FacesOtherWay,
        GUSSET_ALIGNED_OTHER_SIZE => OtherSize,
        GUSSET_ALIGNED_TRUSTED_BY_NONE => TrustedByNone,
    }
}

fn pose(given: gusset_transform) -> Pose {
    let row = |k: usize| DVec3::from_slice(&given.rows[4 * k..]);
    let translation = DVec3::new(given.rows[3], given.rows[7], given.rows[11]);
    Pose { rotation: DMat3::from_cols(row(0), row(1), row(2)).transpose(), translation }
}

fn transform(pose: &Pose) -> gusset_transform {
    let [x, y, z] = [0, 1, 2].map(|k| pose.rotation.row(k));
    let t = pose.translation;
    gusset_transform { rows: [x.x, x.y, x.z, t.x, y.x, y.y, y.z, t.y, z.x, z.y, z.z, t.z] }
}

impl gusset_alignment {
    fn new(done: &Alignment) -> Result<Self, Error> {
        let piece = |piece: &Aligned| gusset_aligned_piece {
            pose: transform(&piece.pose),
            hold: piece.hold,
            reason: piece.reason.number(),
            reserved: 0,
        };
        let overlap = |overlap: &Overlap| gusset_overlap {
            pieces: overlap.pieces,
            shares: overlap.shares,
            mean: overlap.mean,
            rms: overlap.rms,
            fit: overlap.fit,
            count: overlap.count,
            trusted: overlap.trusted.into(),
        };
        Ok(gusset_alignment {
            pieces: alloc::collect(done.pieces.iter().map(piece))?,
            overlaps: alloc::collect(done.overlaps.iter().map(overlap))?,
            rounds: done.rounds,
            converged: done.converged,
        })
    }
}

/// Finds where pieces that overlap belong: rigid motions after which they fit, all at once, so that
/// no error adds up round a ring of them. The first piece stays.
///
/// Points of each piece look for the nearest ones on the others, those beyond a border of the other
/// apart and those whose normals differ by more than 45 degrees; the motions that bring pairs onto
/// the planes of their normals, with less weight for those far off, are found in one system of
/// equations; and so on until nothing moves. Pieces have to begin within max_distance of where they
/// belong, see start. A piece that lies on no other stays where it begins; where
/// overlaps leave it free it may slide.
///
/// What is not known is no failure, but said for each piece: a piece is trusted if it fits others,
/// overlaps hold it in all six directions by more than the noise of normals, and pieces lead from
/// it to the first one by pairs that fit.
///
/// @param pieces piece_count mesh views one after another, each as large as the first one's
///     struct_size says, at least one.
/// @param piece_count see pieces.
/// @errors as gusset_mesh_view (the report's input is the piece), EMPTY_MESH (without pieces),
///     OUT_OF_RANGE (max_distance; or a pose that is no rotation and translation, whose number is
///     the report's index), COUNT_DIFFERS (fewer poses than pieces), TOO_LARGE
/// @complexity O(V log V) for V vertices of a piece, and O(samples log V) for each piece and each
///     one near it in each round, of which 10 to 30 are common; with GUSSET_ALIGN_RIMS 512^2 for
///     each two pieces. Linear extra memory.
/// @source P. Besl and N. McKay (1992); Y. Chen and G. Medioni (1992); G. Turk and M. Levoy (1994);
///     P. Neugebauer (1997); S. Rusinkiewicz, A symmetric objective function for ICP (2019).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_alignment_create(
    context: *const gusset_context,
    pieces: *const gusset_mesh_view,
    piece_count: usize,
    options: *const gusset_alignment_options,
    alignment: *mut *mut gusset_alignment,
) -> gusset_status {
    create(context, alignment, "alignment", |job| {
        let options = input::read(options, true, "options")?;
        let poses = alloc::collect(input::items(options.poses, options.pose_count, "poses")?.map(pose))?;
        let start = match options.start {
            GUSSET_ALIGN_AS_GIVEN if poses.is_empty() => Start::AsGiven,
            GUSSET_ALIGN_AS_GIVEN => Start::Poses(&poses),
            GUSSET_ALIGN_PRINCIPAL_AXES => Start::PrincipalAxes,
            GUSSET_ALIGN_RIMS => Start::Rims,
            other => return Err(Failure::unknown("start", other.into())),
        };
        let max_distance = (options.max_distance != 0.0).then_some(options.max_distance);
        let how = Options { start, max_distance, samples: options.samples, max_rounds: options.max_rounds };
        let given_meshes = mesh::meshes(pieces, piece_count, &job.part(0.0, 0.1))?;
        let views = alloc::collect(given_meshes.iter().map(GivenMesh::view))?;
        Ok(gusset_alignment::new(&align(&views, &how, &job.part(0.1, 1.0))?)?)
    })
}

/// Destroys an alignment; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_alignment_destroy(alignment: *mut gusset_alignment) {
    handle::destroy(alignment);
}

/// Lends the poses and what is known of them.
///
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_alignment_get_view(
    alignment: *const gusset_alignment,
    view: *mut gusset_alignment_view,
) -> gusset_status {
    lend!(alignment, view, |alignment| gusset_alignment_view {
        struct_size: size_of::<gusset_alignment_view>(),
        pieces: input::lent(&alignment.pieces),
        piece_count: alignment.pieces.len(),
        overlaps: input::lent(&alignment.overlaps),
        overlap_count: alignment.overlaps.len(),
        rounds: alignment.rounds,
        converged: alignment.converged.into(),
    })
}
