//! Stitching as C sees it.

use super::context::gusset_context;
use super::guard::guard;
use super::input::{self, Versioned};
use super::mesh::{self, gusset_indices, gusset_mesh_view};
use super::status::{Failure, gusset_status};
use crate::stitch::{Meridians, Options, Orientation, Request, Stitch, stitch};
use std::ptr;

/// The strip of least area among all closed bands of triangles through the first meridian: exact, O(N M).
pub const GUSSET_MERIDIANS_MIN_AREA: u32 = 0;
/// The paper's rule by index, O(N + M): good for evenly spaced rims.
pub const GUSSET_MERIDIANS_INDEX: u32 = 1;

/// A second piece that is oriented against the first is turned over. Two loops of one connected piece are taken as they are.
pub const GUSSET_ORIENTATION_FIX: u32 = 0;
/// Such a piece is GUSSET_ERROR_ORIENTATION_CONFLICT.
pub const GUSSET_ORIENTATION_REFUSE: u32 = 1;
/// The rims are not compared: the faces are taken to be right as they are.
pub const GUSSET_ORIENTATION_KEEP: u32 = 2;

/// A finished stitch. Opaque and immutable; it keeps nothing of the meshes it was made from.
pub struct gusset_stitch(Stitch);

/// How to stitch; all zero is the default.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_stitch_options {
    /// sizeof(gusset_stitch_options), set by the caller.
    pub struct_size: usize,
    /// GUSSET_MERIDIANS_...
    pub meridians: u32,
    /// GUSSET_ORIENTATION_...
    pub orientation: u32,
    /// The first meridian joins the closest pair; with a twist, the vertex of rim B so many places later, counted in the
    /// direction in which rim A runs (negative: earlier). Any value; taken modulo the length of rim B.
    pub twist: i64,
}

/// The parts of a stitch. Pointers are valid until it is destroyed. Index 0 is the first mesh, 1 the second.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_stitch_parts {
    /// sizeof(gusset_stitch_parts), set by the caller.
    pub struct_size: usize,
    /// Per old vertex of each mesh, its index in the result; empty for the second if there was only one mesh.
    pub vertex_map: [gusset_indices; 2],
    /// Per old face, its index in the result.
    pub face_map: [gusset_indices; 2],
    /// The vertices of each rim, by their indices in the result, from the first meridian on, side by side: rim 0 has its
    /// surface on the left, rim 1 on the right. They are also the strip's own vertices in order: rim 0, then rim 1.
    pub rim: [gusset_indices; 2],
    /// The meridians as places on the rims, i and j by turns: meridian k is (data[2 k], data[2 k + 1]), from (0, 0) to (N, M)
    /// for rims of N and M vertices, where place N is place 0 again; count is twice the number of meridians.
    pub meridians: gusset_indices,
    /// The first of the strip's faces in the result; they are the last ones.
    pub strip_face_first: usize,
    /// How many there are: N + M.
    pub strip_face_count: usize,
    /// 1 if the second piece was turned over, else 0.
    pub turned: u32,
    /// 0.
    pub reserved: u32,
}

/// Measures of a strip, and of the whole result's connectivity.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_quality {
    /// sizeof(gusset_quality), set by the caller.
    pub struct_size: usize,
    /// The smallest angle of the strip's triangles, in radians; 0 if one is degenerate.
    pub min_angle: f64,
    /// The largest aspect ratio of the strip's triangles: longest side / (2 sqrt(3) inscribed radius), 1 for an equilateral
    /// triangle, infinite for a degenerate one.
    pub max_aspect: f64,
    /// The longest edge of the strip, in the unit of the positions.
    pub max_edge: f64,
    /// The strip's area, in the square of that unit.
    pub area: f64,
    /// Triangles of the strip without area.
    pub degenerate_faces: u32,
    /// Boundary loops of the result; 0 if it is closed.
    pub loops_left: u32,
    /// Edges of the result with three or more faces.
    pub non_manifold_edges: u32,
    /// Edges of the result whose two faces disagree in orientation.
    pub orientation_conflicts: u32,
}

// SAFETY: repr(C), size first, plain numbers.
unsafe impl Versioned for gusset_stitch_options {
    const LEAST_SIZE: usize = 24;
}
// SAFETY: repr(C), size first, pointers and plain numbers.
unsafe impl Versioned for gusset_stitch_parts {
    const LEAST_SIZE: usize = 144;
}
// SAFETY: repr(C), size first, plain numbers.
unsafe impl Versioned for gusset_quality {
    const LEAST_SIZE: usize = 56;
}
const _: () = assert!(
    size_of::<usize>() != 8
        || (size_of::<gusset_stitch_options>() == 24
            && size_of::<gusset_stitch_parts>() == 144
            && size_of::<gusset_quality>() == 56)
);

impl gusset_stitch_options {
    fn checked(self) -> Result<Options, Failure> {
        let meridians = match self.meridians {
            GUSSET_MERIDIANS_MIN_AREA => Meridians::MinArea,
            GUSSET_MERIDIANS_INDEX => Meridians::Index,
            other => return Err(Failure::unknown("meridians", other.into())),
        };
        let orientation = match self.orientation {
            GUSSET_ORIENTATION_FIX => Orientation::Fix,
            GUSSET_ORIENTATION_REFUSE => Orientation::Refuse,
            GUSSET_ORIENTATION_KEEP => Orientation::Keep,
            other => return Err(Failure::unknown("orientation", other.into())),
        };
        Ok(Options { meridians, orientation, twist: self.twist })
    }
}

/// Joins two boundary loops by a closed band of triangles: loops of two meshes, or of one.
///
/// mesh_b: NULL if both loops are of mesh_a. loop_a, loop_b: the vertices of each loop in order, in either direction, each
/// consecutive pair (and the last with the first) an edge with exactly one face; NULL leaves the choice open, and the
/// loops that lie nearest to each other are taken. options: NULL for the defaults. stitch: receives the result, for
/// gusset_stitch_destroy; NULL on failure.
///
/// The result has the vertices of A, then of B; the faces of A, then of B, then the strip. Positions are of the scalar type
/// of A and keep their bits. No vertex is added, and every face is kept.
///
/// Errors: those of gusset_mesh_view, UNKNOWN_VALUE, NO_LOOP, LOOP_TOO_SHORT, LOOP_REPEATS_VERTEX, LOOP_EDGE_NOT_FREE,
/// LOOP_NOT_ORIENTED, LOOPS_SHARE_VERTEX, ORIENTATION_CONFLICT, NO_STRIP, MIXED_SCALARS (A has f32 and B f64 positions),
/// TOO_LARGE, OUT_OF_MEMORY, CANCELLED. O(H log d) for H half-edges and at most d edges at a vertex, plus O(N M) or O(N + M) by
/// the choice of meridians; linear extra memory, and for MIN_AREA one byte for each of the N M pairs, at most 64 MiB.
/// Source: Nesterenko, for whole loops, which repeat their start: N + 1 and M + 1 points.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_stitch_create(
    context: *const gusset_context,
    mesh_a: *const gusset_mesh_view,
    loop_a: *const gusset_indices,
    mesh_b: *const gusset_mesh_view,
    loop_b: *const gusset_indices,
    options: *const gusset_stitch_options,
    stitch: *mut *mut gusset_stitch,
) -> gusset_status {
    guard(context, |job| {
        let out = input::output(stitch, ptr::null_mut(), "stitch")?;
        let options = input::read(options, true, "options")?.checked()?;
        let a = mesh::mesh(mesh_a, 0, &job.part(0.0, 0.1))?;
        let b = match mesh_b.is_null() {
            true => None,
            false => Some(mesh::mesh(mesh_b, 1, &job.part(0.1, 0.2))?),
        };
        let loop_a = mesh::indices(loop_a, "loop_a")?;
        let loop_b = mesh::indices(loop_b, "loop_b").map_err(|failure| failure.of_input(1))?;
        let request = Request { a: &a, loop_a: loop_a.as_deref(), b: b.as_ref(), loop_b: loop_b.as_deref() };
        let done = self::stitch(&request, &options, &job.part(0.2, 1.0))?;
        *out = Box::into_raw(Box::new(gusset_stitch(done)));
        Ok(())
    })
}

/// Destroys a stitch; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_stitch_destroy(stitch: *mut gusset_stitch) {
    input::destroy(stitch);
}

/// Lends the whole result, valid until the stitch is destroyed. Errors: NULL_ARGUMENT, MISALIGNED_ARGUMENT,
/// BAD_STRUCT_SIZE. O(1). From any thread.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_stitch_mesh(
    stitch: *const gusset_stitch,
    view: *mut gusset_mesh_view,
) -> gusset_status {
    guard(ptr::null(), |_| {
        let out = input::output_struct(view, "view")?;
        out.write(mesh::lend(&input::reference(stitch, "stitch")?.0.mesh));
        Ok(())
    })
}

/// Lends the strip alone: the vertices of the two rims and the triangles between them. Errors and validity as for
/// gusset_stitch_mesh.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_stitch_strip(
    stitch: *const gusset_stitch,
    view: *mut gusset_mesh_view,
) -> gusset_status {
    guard(ptr::null(), |_| {
        let out = input::output_struct(view, "view")?;
        out.write(mesh::lend(&input::reference(stitch, "stitch")?.0.strip));
        Ok(())
    })
}

/// Lends the maps, rims and meridians. Errors and validity as for gusset_stitch_mesh.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_stitch_view(
    stitch: *const gusset_stitch,
    parts: *mut gusset_stitch_parts,
) -> gusset_status {
    guard(ptr::null(), |_| {
        let out = input::output_struct(parts, "parts")?;
        let done = &input::reference(stitch, "stitch")?.0;
        out.write(gusset_stitch_parts {
            struct_size: size_of::<gusset_stitch_parts>(),
            vertex_map: done.maps.each_ref().map(|map| gusset_indices::lend(&map.vertices)),
            face_map: done.maps.each_ref().map(|map| gusset_indices::lend(&map.faces)),
            rim: done.rims.each_ref().map(|rim| gusset_indices::lend(rim)),
            meridians: gusset_indices::lend(done.meridians.as_flattened()),
            strip_face_first: done.strip_faces.start as usize,
            strip_face_count: done.strip_faces.len(),
            turned: done.turned.into(),
            reserved: 0,
        });
        Ok(())
    })
}

/// Measures of the strip and of the result. Errors: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE. O(1). From any
/// thread.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_stitch_quality(
    stitch: *const gusset_stitch,
    quality: *mut gusset_quality,
) -> gusset_status {
    guard(ptr::null(), |_| {
        let out = input::output_struct(quality, "quality")?;
        let q = &input::reference(stitch, "stitch")?.0.quality;
        out.write(gusset_quality {
            struct_size: size_of::<gusset_quality>(),
            min_angle: q.min_angle,
            max_aspect: q.max_aspect,
            max_edge: q.max_edge,
            area: q.area,
            degenerate_faces: q.degenerate_faces,
            loops_left: q.loops_left,
            non_manifold_edges: q.non_manifold_edges,
            orientation_conflicts: q.orientation_conflicts,
        });
        Ok(())
    })
}
