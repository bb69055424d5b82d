//! Alignment: Finds rigid poses at which pieces fit.
//!
//! @source P. Besl and N. McKay (1992); Y. Chen and G. Medioni (1992); G. Turk and M. Levoy (1994);
//!     P. Neugebauer (1997); R. Rusu, N. Blodow, M. Beetz (2009); S. Rusinkiewicz (2019); Z. Chen et
//!     al. (2022).

use crate::align::{Aligned, Alignment, Options, Overlap, Pose, Reason, Start, align};
use crate::capi::context::{create_handle, gusset_context, lend};
use crate::capi::glue::{c_enum, constants, fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, Choice};
use crate::capi::mesh::{self, GivenMesh, gusset_mesh_view};
use crate::capi::status::{Failure, gusset_status};
use crate::capi::transform::gusset_transform;
use crate::error::Error;
use glam::{DMat3, DVec3};
use gusset_base::alloc;

/// Initial poses.
pub type gusset_alignment_start = u32;
/// As given, moved by poses if any.
pub const GUSSET_ALIGN_AS_GIVEN: gusset_alignment_start = 0;
/// Principal axes on the first piece's, in the best of four ways. For pieces that show one object
/// whole.
pub const GUSSET_ALIGN_PRINCIPAL_AXES: gusset_alignment_start = 1;
/// Rims of like shape put together, which then hold the pieces. For parts of a cut or broken
/// surface without overlap.
pub const GUSSET_ALIGN_RIMS: gusset_alignment_start = 2;
/// Like features of the surfaces put together, for overlapping pieces in any poses. A piece stays
/// if its pose is uncertain, with the verdict GUSSET_ALIGNED_UNDETERMINED.
pub const GUSSET_ALIGN_FEATURES: gusset_alignment_start = 3;

/// Verdict on the pose of a piece.
pub type gusset_aligned_reason = u32;
/// Trusted: the piece fits trusted pieces, up to the first. It fits to a mean edge: slightly scaled
/// or mirrored smooth surfaces may pass, and pieces that could only slide together.
pub const GUSSET_ALIGNED_TRUSTED: gusset_aligned_reason = 0;
/// The piece lacks faces with area, or overlaps others too little.
pub const GUSSET_ALIGNED_NO_OVERLAP: gusset_aligned_reason = 1;
/// Too much of the piece near others is off their surfaces.
pub const GUSSET_ALIGNED_POOR_FIT: gusset_aligned_reason = 2;
/// Up to the noise of normals, the piece is free to slide or turn. With GUSSET_ALIGN_FEATURES also:
/// the piece overlaps too little, or fits in several ways.
pub const GUSSET_ALIGNED_UNDETERMINED: gusset_aligned_reason = 3;
/// Most of the overlap has opposite normals: the piece is inside out or mirrored.
pub const GUSSET_ALIGNED_FACES_OTHER_WAY: gusset_aligned_reason = 4;
/// The piece overlaps nothing, and is over 50 times larger or smaller than the first: probably in
/// another unit.
pub const GUSSET_ALIGNED_OTHER_SIZE: gusset_aligned_reason = 5;
/// The piece fits untrusted pieces only.
pub const GUSSET_ALIGNED_TRUSTED_BY_NONE: gusset_aligned_reason = 6;

/// Options of gusset_alignment_create.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_alignment_options {
    /// sizeof(gusset_alignment_options).
    pub struct_size: usize,
    /// Initial poses.
    pub start: gusset_alignment_start,
    /// Points of a piece to match; 0: 2,000.
    pub samples: u32,
    /// Rigid motions of the pieces, or NULL.
    /// @when start GUSSET_ALIGN_AS_GIVEN
    /// @shape pose_count
    pub poses: *const gusset_transform,
    /// Number of pieces, or 0.
    pub pose_count: usize,
    /// Largest distance of matched points, and about how far a piece may move. 0: a tenth of the
    /// largest piece's box diagonal.
    pub max_distance: f64,
    /// Most rounds in each of two stages; 0: 100.
    pub max_rounds: u32,
    /// 0.
    pub reserved: u32,
}

/// Pose of one piece.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_aligned_piece {
    /// Rigid motion from the given positions.
    pub pose: gusset_transform,
    /// How firmly overlaps hold the piece, 0 to 1; 1 for the first. RMS change of matched distances
    /// under the unit motion that changes them least, turns in radii of the piece.
    pub hold: f64,
    /// Verdict on the pose of a piece.
    pub reason: gusset_aligned_reason,
    /// 0.
    pub reserved: u32,
}

/// Overlap of two pieces in their final poses.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_overlap {
    /// The pieces, ascending.
    pub pieces: [u32; 2],
    /// Fraction of each piece's points on the other, within a mean edge; 0 to 1.
    pub shares: [f64; 2],
    /// Mean distance of these points from the other surface.
    pub mean: f64,
    /// RMS distance of these points.
    pub rms: f64,
    /// Fraction on the other piece of points within 8 mean edges of it, 0 to 1.
    pub fit: f64,
    /// Number of overlapping points.
    pub count: u32,
    /// 1 if count is at least 30 and fit at least 2/3.
    /// @flag
    pub trusted: u32,
}

/// Poses and overlaps.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_alignment_view {
    /// sizeof(gusset_alignment_view).
    pub struct_size: usize,
    /// Pieces in order.
    /// @shape piece_count
    pub pieces: *const gusset_aligned_piece,
    /// Number of pieces.
    pub piece_count: usize,
    /// Pairs of overlapping pieces.
    /// @shape overlap_count
    pub overlaps: *const gusset_overlap,
    /// Number of overlaps.
    pub overlap_count: usize,
    /// Rounds done.
    pub rounds: u32,
    /// 1 if pieces stopped before the rounds ran out.
    /// @flag
    pub converged: u32,
}

/// Poses of overlapping pieces.
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

fn to_pose(given: gusset_transform) -> Pose {
    let row = |k: usize| DVec3::from_slice(&given.rows[4 * k..]);
    let translation = DVec3::new(given.rows[3], given.rows[7], given.rows[11]);
    Pose { rotation: DMat3::from_cols(row(0), row(1), row(2)).transpose(), translation }
}

fn to_c_transform(pose: &Pose) -> gusset_transform {
    let [x, y, z] = [0, 1, 2].map(|k| pose.rotation.row(k));
    let t = pose.translation;
    gusset_transform { rows: [x.x, x.y, x.z, t.x, y.x, y.y, y.z, t.y, z.x, z.y, z.z, t.z] }
}

impl gusset_alignment {
    fn new(done: &Alignment) -> Result<Self, Error> {
        let piece = |piece: &Aligned| gusset_aligned_piece {
            pose: to_c_transform(&piece.pose),
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

/// Finds rigid motions that fit overlapping pieces, all at once. The first piece stays.
///
/// Points match the nearest points of other pieces, except beyond borders or if normals differ by
/// over 45 degrees. Distant matches weigh less. Pieces without overlap stay at their start;
/// underdetermined pieces may slide.
///
/// @param pieces as for gusset_join.
/// @errors as gusset_mesh_view, EMPTY_MESH, OUT_OF_RANGE (max_distance; a pose that is not rigid,
///     by index), COUNT_DIFFERS (fewer poses than pieces), TOO_LARGE
/// @complexity O(V log V) for V vertices of a piece, and in each of usually 10 to 30 rounds
///     O(samples log V) a piece and neighbour; GUSSET_ALIGN_RIMS: 512^2 for two pieces.
///     GUSSET_ALIGN_FEATURES: O(F) and at most about 2,000^2 for two pieces.
/// @source Besl and McKay 1992; Chen and Medioni 1992; Turk and Levoy 1994; Neugebauer 1997;
///     Rusinkiewicz 2019.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_alignment_create(
    context: *const gusset_context,
    pieces: *const gusset_mesh_view,
    piece_count: usize,
    options: *const gusset_alignment_options,
    alignment: *mut *mut gusset_alignment,
) -> gusset_status {
    create_handle(context, alignment, "alignment", |job| {
        let options = input::read_versioned_struct(options, true, "options")?;
        let poses = alloc::collect(input::input_items(options.poses, options.pose_count, "poses")?.map(to_pose))?;
        let start = match options.start {
            GUSSET_ALIGN_AS_GIVEN if poses.is_empty() => Start::AsGiven,
            GUSSET_ALIGN_AS_GIVEN => Start::Poses(&poses),
            GUSSET_ALIGN_PRINCIPAL_AXES => Start::PrincipalAxes,
            GUSSET_ALIGN_RIMS => Start::Rims,
            GUSSET_ALIGN_FEATURES => Start::Features,
            other => {
                return Err(Failure::unknown_choice(
                    "start",
                    other,
                    &constants![
                        GUSSET_ALIGN_AS_GIVEN,
                        GUSSET_ALIGN_PRINCIPAL_AXES,
                        GUSSET_ALIGN_RIMS,
                        GUSSET_ALIGN_FEATURES
                    ],
                ));
            }
        };
        let max_distance = (options.max_distance != 0.0).then_some(options.max_distance);
        let how = Options { start, max_distance, samples: options.samples, max_rounds: options.max_rounds };
        let given_meshes = mesh::read_meshes(pieces, piece_count, &job.sub_job(0.0, 0.1))?;
        let views = alloc::collect(given_meshes.iter().map(GivenMesh::mesh_view))?;
        Ok(gusset_alignment::new(&align(&views, &how, &job.sub_job(0.1, 1.0))?)?)
    })
}

/// Destroys an alignment.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_alignment_destroy(alignment: *mut gusset_alignment) {
    handle::destroy(alignment);
}

/// Lends poses and overlaps.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_alignment_get_view(
    alignment: *const gusset_alignment,
    view: *mut gusset_alignment_view,
) -> gusset_status {
    lend!(alignment, view, |alignment| gusset_alignment_view {
        struct_size: size_of::<gusset_alignment_view>(),
        pieces: input::lend_list(&alignment.pieces),
        piece_count: alignment.pieces.len(),
        overlaps: input::lend_list(&alignment.overlaps),
        overlap_count: alignment.overlaps.len(),
        rounds: alignment.rounds,
        converged: alignment.converged.into(),
    })
}
