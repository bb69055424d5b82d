//! Trimming: Keeps one piece of each overlap.
//!
//! @source The idea is of G. Turk and M. Levoy, Zippered polygon meshes from range images
//!     (1994).

use crate::capi::context::{create, gusset_context, lend};
use crate::capi::glue::{fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input;
use crate::capi::mesh::{self, GivenMesh, gusset_indices, gusset_mesh_view};
use crate::capi::status::{Failure, gusset_status};
use crate::trim::{Options, Trimmed, trim};
use glam::DVec3;
use gusset_base::alloc;

/// How pieces that overlap are trimmed; all zero is the default.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_trim_options {
    /// sizeof(gusset_trim_options), set by the caller.
    pub struct_size: usize,
    /// Surfaces that are no farther apart than this are one, in the unit of the positions, finite
    /// and at least 0; 0: four mean edges of the coarser of two pieces.
    pub max_distance: f64,
    /// Surfaces whose normals differ by more are two, in radians, from 0 and below pi / 2; 0: 60
    /// degrees.
    pub max_angle: f64,
    /// x, y, z of the place that each piece was seen from, in the unit of the positions, or NULL:
    /// what was seen under a flat angle counts for less.
    pub viewpoints: *const f64,
    /// Their number: that of the pieces, or 0.
    pub viewpoint_count: usize,
    /// What has fewer faces is no surface; 0: 30. Parts of twenty times as many go where others
    /// show the same, and as small holes do not come about.
    pub min_faces: u32,
    /// 0.
    pub reserved: u32,
}

/// The faces of a piece that are kept.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_trimmed_piece {
    /// Ascending.
    pub kept: gusset_indices,
    /// How many of the piece's vertices lie on another piece.
    pub covered_vertices: usize,
}

/// What is left of pieces. Pointers are valid until it is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_trim_view {
    /// sizeof(gusset_trim_view), set by the caller.
    pub struct_size: usize,
    /// One for each piece.
    pub pieces: *const gusset_trimmed_piece,
    /// How many.
    pub piece_count: usize,
    /// Faces that cut some of an earlier piece after all else; they went, with those round them.
    pub crossings: u32,
    /// 0.
    pub reserved: u32,
}

/// What is left of pieces that overlap. Opaque and immutable; it keeps nothing of them.
pub struct gusset_trim {
    done: Trimmed,
    pieces: Vec<gusset_trimmed_piece>,
}

handle! { gusset_trim }

versioned! { gusset_trim_options: 48 reserved, gusset_trim_view: 32 }
fixed! { gusset_trimmed_piece: 24 }

impl gusset_trim_options {
    /// `viewpoints`: those of [`gusset_trim_options::viewpoints`].
    pub(crate) fn checked(self, viewpoints: &[DVec3]) -> Options<'_> {
        Options {
            max_distance: (self.max_distance != 0.0).then_some(self.max_distance),
            max_angle: self.max_angle,
            viewpoints,
            min_faces: self.min_faces,
        }
    }

    pub(crate) fn viewpoints(&self) -> Result<Vec<DVec3>, Failure> {
        let given = input::items(self.viewpoints.cast::<[f64; 3]>(), self.viewpoint_count, "viewpoints")?;
        Ok(alloc::collect(given.map(DVec3::from_array))?)
    }
}

/// Chooses what is kept of pieces that overlap: of each overlap one piece, with a narrow gap to the
/// others, which gusset_join closes; see GUSSET_OVERLAPS_TRIM there for both at once.
///
/// The pieces are cut along lines on which both are equally good. A vertex is the better the
/// farther it is from the borders of its piece, in mean edges of it, so that the finer of two
/// pieces counts for more, and the less flat the angle it was seen under, if viewpoints are given;
/// loops of fewer than 32 vertices are small holes and no borders in that sense. A vertex lies on
/// another piece if the nearest place there is near, faces the same way, and is on no border. Where
/// two are equally good but for noise, the earlier one is kept. No vertex moves, and no face is
/// cut. What would be thinner than two faces goes, so do small islands, faces that hang on others
/// by one vertex, and faces that cut those of an earlier piece.
///
/// @param pieces piece_count mesh views one after another, each as large as the first one's
///     struct_size says, at least one, all in one coordinate system; see gusset_alignment_create.
/// @param piece_count see pieces.
/// @errors as gusset_mesh_view (the report's input is the piece), EMPTY_MESH (without pieces),
///     OUT_OF_RANGE (max_distance, max_angle), NOT_FINITE (a viewpoint), COUNT_DIFFERS (fewer
///     viewpoints than pieces), TOO_LARGE
/// @complexity O(V log F) for V vertices of a piece and F faces of each piece near it, and up to
///     the square of the number of faces that lie in one place; linear extra memory.
/// @source The idea is that of G. Turk and M. Levoy, Zippered polygon meshes from range images
///     (1994), who clip one mesh at the other's border.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_trim_create(
    context: *const gusset_context,
    pieces: *const gusset_mesh_view,
    piece_count: usize,
    options: *const gusset_trim_options,
    trim: *mut *mut gusset_trim,
) -> gusset_status {
    create(context, trim, "trim", |job| {
        let options = input::read(options, true, "options")?;
        let viewpoints = options.viewpoints()?;
        let given_meshes = mesh::meshes(pieces, piece_count, &job.part(0.0, 0.1))?;
        let views = alloc::collect(given_meshes.iter().map(GivenMesh::view))?;
        let done = self::trim(&views, &options.checked(&viewpoints), &job.part(0.1, 1.0))?;
        // The lists that these point to lie on the heap and stay where they are.
        let pieces = done.kept.iter().zip(&done.covered).map(|(kept, &covered)| gusset_trimmed_piece {
            kept: gusset_indices::lend(kept),
            covered_vertices: covered as usize,
        });
        Ok(gusset_trim { pieces: alloc::collect(pieces)?, done })
    })
}

/// Destroys what is left of pieces; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_trim_destroy(trim: *mut gusset_trim) {
    handle::destroy(trim);
}

/// Lends which faces are kept.
///
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_trim_get_view(trim: *const gusset_trim, view: *mut gusset_trim_view) -> gusset_status {
    lend!(trim, view, |trim| gusset_trim_view {
        struct_size: size_of::<gusset_trim_view>(),
        pieces: input::lent(&trim.pieces),
        piece_count: trim.pieces.len(),
        crossings: trim.done.crossings,
        reserved: 0,
    })
}
