//! Trimming: Keeps one piece of each overlap.
//!
//! @source The idea is of G. Turk and M. Levoy, Zippered polygon meshes from range images
//!     (1994).

use crate::capi::context::{create_handle, gusset_context, lend};
use crate::capi::glue::{fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input;
use crate::capi::mesh::{self, GivenMesh, gusset_indices, gusset_mesh_view};
use crate::capi::status::{Failure, gusset_status};
use crate::trim::{KeptFacesOfPieces, Options, trim};
use glam::DVec3;
use gusset_base::alloc;

/// Options of gusset_trim_create.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_trim_options {
    /// sizeof(gusset_trim_options).
    pub struct_size: usize,
    /// Largest distance of surfaces that count as one. 0: 4 mean edges of the coarser piece.
    pub max_distance: f64,
    /// Largest angle between their normals, at least 0, below pi / 2; 0: 60 degrees.
    pub max_angle: f64,
    /// A point for each piece, or NULL. Parts seen at flat angles weigh less.
    /// @shape viewpoint_count 3
    pub viewpoints: *const f64,
    /// Number of pieces, or 0.
    pub viewpoint_count: usize,
    /// Islands of fewer faces are removed; 0: 30. The limit is 20 times that for islands that other
    /// pieces also show. Smaller holes are not made.
    pub min_faces: u32,
    /// 0.
    pub reserved: u32,
}

/// Kept faces of a piece.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_trimmed_piece {
    /// Indices of the faces, ascending.
    pub kept: gusset_indices,
    /// Vertices that lie on another piece.
    pub covered_vertices: usize,
}

/// Result of trimming.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_trim_view {
    /// sizeof(gusset_trim_view).
    pub struct_size: usize,
    /// Kept faces of each piece.
    /// @shape piece_count
    pub pieces: *const gusset_trimmed_piece,
    /// Number of pieces.
    pub piece_count: usize,
    /// Faces removed, with neighbours, for intersecting an earlier piece.
    pub crossings: u32,
    /// 0.
    pub reserved: u32,
}

/// Result of trimming.
pub struct gusset_trim {
    kept_faces: KeptFacesOfPieces,
    pieces: Vec<gusset_trimmed_piece>,
}

handle! { gusset_trim }

versioned! { gusset_trim_options: 48 reserved, gusset_trim_view: 32 }
fixed! { gusset_trimmed_piece: 24 }

impl gusset_trim_options {
    /// Converts the options; `viewpoints` come from [`gusset_trim_options::read_viewpoints`].
    pub(crate) fn checked(self, viewpoints: &[DVec3]) -> Options<'_> {
        Options {
            max_distance: (self.max_distance != 0.0).then_some(self.max_distance),
            max_angle: self.max_angle,
            viewpoints,
            min_faces: self.min_faces,
        }
    }

    pub(crate) fn read_viewpoints(&self) -> Result<Vec<DVec3>, Failure> {
        let given = input::input_items(self.viewpoints.cast::<[f64; 3]>(), self.viewpoint_count, "viewpoints")?;
        Ok(alloc::collect(given.map(DVec3::from_array))?)
    }
}

/// Keeps one piece of each overlap, with a narrow gap that gusset_join closes; see
/// GUSSET_OVERLAPS_TRIM.
///
/// Cuts run where two pieces are equally good; up to noise, the earlier piece stays. Vertices are
/// better farther from borders, in mean edges, and seen less flat from the viewpoint. Loops of
/// under 32 vertices are not borders. A vertex lies on another piece if the nearest point is close,
/// faces the same way, and is not on a border. No vertex moves, and no face is split. Parts thinner
/// than two faces, small islands, and faces attached by one vertex or intersecting an earlier piece
/// are removed.
///
/// @param pieces as for gusset_join, in one coordinate system.
/// @errors as gusset_mesh_view, EMPTY_MESH, OUT_OF_RANGE (max_distance, max_angle), NOT_FINITE (a
///     viewpoint), COUNT_DIFFERS (fewer viewpoints than pieces), TOO_LARGE
/// @complexity O(V log F) for V vertices of a piece and F faces of each near piece, up to quadratic
///     in the faces at one place.
/// @source After Turk and Levoy 1994.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_trim_create(
    context: *const gusset_context,
    pieces: *const gusset_mesh_view,
    piece_count: usize,
    options: *const gusset_trim_options,
    trim: *mut *mut gusset_trim,
) -> gusset_status {
    create_handle(context, trim, "trim", |job| {
        let options = input::read_versioned_struct(options, true, "options")?;
        let viewpoints = options.read_viewpoints()?;
        let given_meshes = mesh::read_meshes(pieces, piece_count, &job.sub_job(0.0, 0.1))?;
        let views = alloc::collect(given_meshes.iter().map(GivenMesh::mesh_view))?;
        let done = self::trim(&views, &options.checked(&viewpoints), &job.sub_job(0.1, 1.0))?;
        // The lists behind these pointers lie on the heap and do not move.
        let pieces = done.kept.iter().zip(&done.covered).map(|(kept, &covered)| gusset_trimmed_piece {
            kept: gusset_indices::lend_indices(kept),
            covered_vertices: covered as usize,
        });
        Ok(gusset_trim { pieces: alloc::collect(pieces)?, kept_faces: done })
    })
}

/// Destroys a trim.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_trim_destroy(trim: *mut gusset_trim) {
    handle::destroy(trim);
}

/// Lends the kept faces.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_trim_get_view(trim: *const gusset_trim, view: *mut gusset_trim_view) -> gusset_status {
    lend!(trim, view, |trim| gusset_trim_view {
        struct_size: size_of::<gusset_trim_view>(),
        pieces: input::lend_list(&trim.pieces),
        piece_count: trim.pieces.len(),
        crossings: trim.kept_faces.crossings,
        reserved: 0,
    })
}
