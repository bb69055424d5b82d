//! Meshes: A boundary edge has one face, a non-manifold edge three or more. Tolerances, gaps and
//! distances in options are finite and at least 0. Results keep the bits of old positions;
//! developments flatten them. A reversed face keeps its first corner. Memory is linear unless
//! stated.

pub mod result;
pub mod join;
pub mod join_options;
pub mod join_report;
pub mod stitch;
pub mod stitch_options;
pub mod fill;
pub mod fill_report;
pub mod strip;
pub mod weld;
pub mod sew;
pub mod orient;
pub mod repair;
pub mod repair_report;
pub mod triangulate;
pub mod align;
pub mod trim;
pub mod boundary;
pub mod check;
pub mod certificate;
pub mod develop;
pub mod develop_report;
pub mod facing;
pub mod section;
pub mod origins;
pub mod attributes;

use crate::capi::glue::{c_enum, versioned};
use crate::capi::input::{self, Choice, lend_list, read_choice};
use crate::capi::status::Failure;
use crate::capi::status::gusset_status::GUSSET_ERROR_BAD_FACE_LAYOUT;
use crate::error::Error;
use crate::job::Job;
use crate::mesh::{Faces, MAX_ELEMENTS, Mesh, MeshView, PositionBuffer, Positions, Scalar};
use gusset_base::alloc;
use std::ffi::c_void;

/// Type of coordinates.
pub type gusset_scalar = u32;
/// 32-bit floats.
pub const GUSSET_F32: gusset_scalar = 1;
/// 64-bit floats.
pub const GUSSET_F64: gusset_scalar = 2;
/// Type of indices.
pub type gusset_index = u32;
/// 32-bit unsigned integers.
pub const GUSSET_U32: gusset_index = 0;
/// Reserved: GUSSET_ERROR_UNKNOWN_VALUE.
pub const GUSSET_U64: gusset_index = 1;

/// Array of indices.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_indices {
    /// May be NULL if count is 0.
    pub data: *const u32,
    /// Number of indices.
    pub count: usize,
}

/// Polygon mesh of the caller (input) or of a result (output). Input arrays must not change during
/// the call; their lengths are not checked. Counts are checked before elements. Outputs have packed
/// positions, and face_size 0. Inputs have
/// - a vertex and a face (EMPTY_MESH),
/// - at most 2^32 - 2 vertices, and as many corners (TOO_LARGE),
/// - at least 3 corners a face (FACE_TOO_SMALL),
/// - indices below vertex_count (INDEX_OUT_OF_RANGE),
/// - finite coordinates at vertices of faces (NOT_FINITE),
/// - a valid layout (BAD_STRIDE, BAD_FACE_LAYOUT, BAD_OFFSETS, BAD_MERGE).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_mesh_view {
    /// sizeof(gusset_mesh_view).
    pub struct_size: usize,
    /// x, y, z at each stride.
    pub positions: *const c_void,
    /// Stride in bytes; 0 if packed.
    pub position_stride: usize,
    /// Number of vertices.
    pub vertex_count: usize,
    /// Face f has corners face_offsets[f] to face_offsets[f + 1] - 1. NULL with face_size.
    pub face_offsets: *const c_void,
    /// Vertex of each corner, face by face. Corner h also names the half-edge from it.
    pub face_corners: *const c_void,
    /// Number of faces.
    pub face_count: usize,
    /// Must be set: 0 is invalid.
    pub scalar: gusset_scalar,
    /// Type of indices.
    pub index: gusset_index,
    /// Corners of every face, or 0 with face_offsets.
    pub face_size: u32,
    /// 0.
    pub reserved: u32,
    /// Representative of each vertex, or NULL; see gusset_mesh_find_merge. Vertices with one
    /// representative are one, so texture seams are not borders. A representative represents
    /// itself, and its position counts. Results list representatives; faces keep the given
    /// vertices.
    pub merge: *const c_void,
}

versioned! { gusset_mesh_view: 72 reserved }

/// A mesh of the caller, and the corners of its faces after merging vertices.
pub(crate) struct GivenMesh<'a> {
    mesh: MeshView<'a>,
    merged: Option<(&'a [u8], Vec<u32>)>,
}

impl GivenMesh<'_> {
    pub(crate) fn mesh_view(&self) -> MeshView<'_> {
        self.merged.as_ref().map_or(self.mesh, |(merge, corners)| self.mesh.merged(merge, corners))
    }
}

/// Reads and validates the caller's mesh number `number`.
pub(crate) fn read_numbered_mesh<'a>(
    view: *const gusset_mesh_view,
    number: u32,
    job: &Job<'_>,
) -> Result<GivenMesh<'a>, Failure> {
    read_and_validate_mesh(view, "mesh", job).map_err(|failure| failure.with_input(number))
}

/// Reads and validates the argument `name`, the caller's mesh number `number`.
pub(crate) fn read_named_mesh<'a>(
    view: *const gusset_mesh_view,
    name: &'static str,
    number: u32,
    job: &Job<'_>,
) -> Result<GivenMesh<'a>, Failure> {
    read_and_validate_mesh(view, name, job).map_err(|failure| failure.with_input(number).within(name))
}

/// Reads an array of the caller's meshes, whose structs must be as large as the first one.
pub(crate) fn read_meshes<'a>(
    views: *const gusset_mesh_view,
    count: usize,
    job: &Job<'_>,
) -> Result<Vec<GivenMesh<'a>>, Failure> {
    Error::check_count("pieces", count as u64, MAX_ELEMENTS)?;
    let views = input::struct_pointers(views, count, "pieces")?.enumerate();
    alloc::try_collect(views.map(|(k, view)| {
        let read = |view| read_and_validate_mesh(view, "pieces", &job.sub_job_of_item(k, count));
        view.and_then(read).map_err(|failure| failure.with_input(k as u32).within_item("pieces", k))
    }))
}

/// Validates a mesh of the caller; `name` is the name of its view in errors.
pub(crate) fn read_and_validate_mesh<'a>(
    view: *const gusset_mesh_view,
    name: &'static str,
    job: &Job<'_>,
) -> Result<GivenMesh<'a>, Failure> {
    let view = input::read_versioned_struct(view, false, name)?;
    let scalar = read_choice(view.scalar)?;
    if view.index != GUSSET_U32 {
        return Err(Failure::unknown_value("index", view.index.into(), "GUSSET_U32"));
    }
    // Before the layout, because the arrays of an empty mesh may be NULL.
    for (what, count) in [("vertices", view.vertex_count), ("faces", view.face_count)] {
        if count == 0 {
            return Err(Error::EmptyMesh { what }.into());
        }
    }
    if view.face_offsets.is_null() == (view.face_size == 0) {
        let layouts = if view.face_size == 0 { "neither" } else { "both" };
        let message = format!("{layouts} of face_offsets and face_size are given; give exactly one");
        return Err(Failure::new(GUSSET_ERROR_BAD_FACE_LAYOUT, message));
    }
    // Check all counts before reading any element.
    let position_bytes = Positions::bytes_needed(view.position_stride, view.vertex_count, scalar)?;
    let offset_count = Faces::offset_count(view.face_count)?;
    let positions = input::input_bytes(view.positions, position_bytes, 1, "positions")?;
    let positions = Positions::strided(positions, view.position_stride, view.vertex_count, scalar)?;
    let faces = if view.face_offsets.is_null() {
        let corners = Faces::corner_count(view.face_size, view.face_count)?;
        let corners = input::input_bytes(view.face_corners, corners, 4, "face_corners")?;
        Faces::with_uniform_size(corners, view.face_size, view.face_count)?
    } else {
        let offsets = input::input_bytes(view.face_offsets, offset_count, 4, "face_offsets")?;
        // The offsets first: a wrong last entry would overstate the length of the corners.
        let corners = Faces::check_offsets(offsets, view.face_count, job)?;
        let corners = input::input_bytes(view.face_corners, corners, 4, "face_corners")?;
        Faces::with_offsets(offsets, corners, view.face_count)?
    };
    if view.merge.is_null() {
        return Ok(GivenMesh { mesh: MeshView::new(positions, faces, job)?, merged: None });
    }
    let merge = input::input_bytes(view.merge, view.vertex_count, 4, "merge")?;
    let mesh = MeshView::new(positions, faces, &job.sub_job(0.0, 0.7))?;
    let corners = mesh.merged_corners(merge, &job.sub_job(0.7, 1.0))?;
    Ok(GivenMesh { mesh, merged: Some((merge, corners)) })
}

/// Lends the arrays of `mesh`.
pub(crate) fn lend_mesh(mesh: &Mesh) -> gusset_mesh_view {
    let scalar = mesh.positions.view().scalar();
    gusset_mesh_view {
        struct_size: 0,
        positions: match &mesh.positions {
            PositionBuffer::F32(points) => lend_list(points).cast(),
            PositionBuffer::F64(points) => lend_list(points).cast(),
        },
        position_stride: scalar.position_size(),
        vertex_count: mesh.positions.len(),
        face_offsets: lend_list(&mesh.face_offsets).cast(),
        face_corners: lend_list(&mesh.face_corners).cast(),
        face_count: mesh.face_count(),
        scalar: scalar.number(),
        index: GUSSET_U32,
        face_size: 0,
        reserved: 0,
        merge: lend_list(&mesh.merge).cast(),
    }
}

impl gusset_indices {
    /// Lends a slice; NULL for an empty one.
    pub(crate) fn lend_indices(indices: &[u32]) -> Self {
        gusset_indices { data: lend_list(indices), count: indices.len() }
    }
}

/// Maps vertices to the vertices that they are merged into.
pub(crate) fn map_to_merged_vertices(mesh: &MeshView<'_>, mut vertices: Vec<u32>) -> Vec<u32> {
    vertices.iter_mut().for_each(|v| *v = mesh.faces().merged_vertex(*v));
    vertices
}

/// Copies the caller's indices, which may have any alignment; `None` for a NULL struct.
pub(crate) fn read_indices(given: *const gusset_indices, name: &'static str) -> Result<Option<Vec<u32>>, Failure> {
    if given.is_null() {
        return Ok(None);
    }
    let given = *input::checked_reference(given, name)?;
    Error::check_count("indices", given.count as u64, MAX_ELEMENTS)?;
    input::copy_input_items(given.data, given.count, name).map(Some)
}

c_enum! { scalar: Scalar { GUSSET_F32 => F32, GUSSET_F64 => F64 } }
