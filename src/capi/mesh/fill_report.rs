//! Holes: reports: Outcomes of loops.

use crate::capi::glue::{c_enum, fixed, versioned};
use crate::capi::input::{Choice, lend_list};
use crate::capi::mesh::gusset_indices;
use crate::error::Error;
use crate::fill::{Filled, Finish, Hole, HoleStatus, Weight};
use gusset_base::alloc;

/// Weight that the triangulation of a hole minimises.
pub type gusset_fill_weight = u32;
/// Best continuation: the area if the rim is planar, else the sum of
/// - 2 sin(t / 2) over all edges, the rim included, for angles t between normals;
/// - the mean squared distance from the missing surface, estimated from tangent planes at the rim,
///   in units of 1/140 of its length.
pub const GUSSET_WEIGHT_CONTINUATION: gusset_fill_weight = 0;
/// Sum of the areas and, over all edges, the rim included, of squared length * (1 - cos(angle
/// between normals)).
pub const GUSSET_WEIGHT_AREA_AND_BEND: gusset_fill_weight = 1;
/// Largest angle between neighbouring faces, old faces at the rim included; then the area.
pub const GUSSET_WEIGHT_BEND_THEN_AREA: gusset_fill_weight = 2;
/// Area, minimised exactly for a single loop of at most 128 vertices.
pub const GUSSET_WEIGHT_AREA: gusset_fill_weight = 3;

/// Vertices of a patch.
pub type gusset_patch_finish = u32;
/// Rim vertices only.
pub const GUSSET_PATCH_PLAIN: gusset_patch_finish = 0;
/// New vertices on the plain triangles, except beside creases that continue.
pub const GUSSET_PATCH_REFINED: gusset_patch_finish = 1;
/// New vertices, faired.
pub const GUSSET_PATCH_FAIRED: gusset_patch_finish = 2;

/// Outcome for one loop.
pub type gusset_hole_status = u32;
/// Filled; with plan_only, to be filled.
pub const GUSSET_HOLE_FILLED: gusset_hole_status = 0;
/// Left open: the outer border of a sheet, or the longest loop; see keep.
pub const GUSSET_HOLE_KEPT: gusset_hole_status = 1;
/// Left open: it exceeds max_edges, max_length, max_diameter or max_area.
pub const GUSSET_HOLE_TOO_LARGE: gusset_hole_status = 2;
/// Left open: an open chain.
pub const GUSSET_HOLE_OPEN: gusset_hole_status = 3;
/// Left open: it runs along a non-manifold edge.
pub const GUSSET_HOLE_NON_MANIFOLD: gusset_hole_status = 4;
/// Left open: the faces along it disagree in orientation.
pub const GUSSET_HOLE_NOT_ORIENTED: gusset_hole_status = 5;
/// Left open: a given loop has fewer than three vertices, or passes a vertex twice.
pub const GUSSET_HOLE_NOT_SIMPLE: gusset_hole_status = 6;
/// Left open: an edge of a given loop is not a boundary edge, or belongs to an earlier loop.
pub const GUSSET_HOLE_NOT_FREE: gusset_hole_status = 7;
/// Left open: every triangulation joins two vertices of one old face, or no shared patch was found.
pub const GUSSET_HOLE_NO_TRIANGULATION: gusset_hole_status = 8;
/// Left open: loose faces; the loop passes all vertices of its component. See GUSSET_KEEP_AUTO.
pub const GUSSET_HOLE_LOOSE: gusset_hole_status = 9;
/// Left open: an edge coincides with another boundary edge up to rounding, so that a
/// patch would have no area there, or lie on another. GUSSET_KEEP_NONE fills the loop.
pub const GUSSET_HOLE_UNSEWN: gusset_hole_status = 10;

/// Report on one loop.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_hole {
    /// First vertex of the loop in rims, surface on the left before turning components outwards; as
    /// given if not simple, free or oriented.
    pub rim_first: usize,
    /// Number of its vertices.
    pub rim_count: usize,
    /// First face of the patch in the result, equal for loops that share it.
    pub face_first: usize,
    /// Number of its faces.
    pub face_count: usize,
    /// First new vertex of the patch.
    pub vertex_first: usize,
    /// Number of these.
    pub vertex_count: usize,
    /// Length of the loop.
    pub length: f64,
    /// Diagonal of the loop's axis-aligned box.
    pub diameter: f64,
    /// Area of triangles from the loop's edges to the mean of its vertices: exact for a planar
    /// convex hole, else more. Infinite if it overflows.
    pub area: f64,
    /// Outcome for one loop.
    pub status: gusset_hole_status,
    /// Weight that the triangulation of a hole minimises.
    pub weight: gusset_fill_weight,
    /// Vertices of a patch.
    pub finish: gusset_patch_finish,
    /// Patch number, in the order of faces, equal for loops that share it; UINT32_MAX without a
    /// patch, always with plan_only.
    pub patch: u32,
}

/// Reports on all loops.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_fill_report {
    /// sizeof(gusset_fill_report).
    pub struct_size: usize,
    /// Given loops, or all in the order of gusset_boundary_get_loop.
    /// @shape hole_count
    pub holes: *const gusset_hole,
    /// Number of loops.
    pub hole_count: usize,
    /// Vertices of all loops.
    pub rims: gusset_indices,
    /// Three rim vertices for each new vertex.
    /// @shape * 3
    pub parents: gusset_indices,
    /// Weights of the parents, at least 0, sum 1. They give the nearest point on the rims' plain
    /// triangulation: the vertex itself in a flat patch, or without fairing and creases.
    /// @shape parents 3
    pub weights: *const f64,
    /// As in gusset_stitch_report, ascending: first the larger index, a new face.
    /// @shape * 2
    pub intersections: gusset_indices,
    /// Faces that GUSSET_OUTWARD_CLOSED reversed, ascending.
    pub turned_outwards: gusset_indices,
    /// 1 if searched for.
    /// @flag
    pub intersections_known: u32,
    /// Boundary edges of the input that coincide with another; 0, without a search, for given
    /// loops.
    pub coincident_edges: u32,
}

versioned! { gusset_fill_report: 104 }
fixed! { gusset_hole: 88 }

c_enum! {
    weight: Weight {
        GUSSET_WEIGHT_CONTINUATION => Continuation,
        GUSSET_WEIGHT_AREA_AND_BEND => AreaAndBend,
        GUSSET_WEIGHT_BEND_THEN_AREA => BendThenArea,
        GUSSET_WEIGHT_AREA => Area,
    }
    finish: Finish {
        GUSSET_PATCH_PLAIN => Plain,
        GUSSET_PATCH_REFINED => Refined,
        GUSSET_PATCH_FAIRED => Faired,
    }
    status: HoleStatus {
        GUSSET_HOLE_FILLED => Filled,
        GUSSET_HOLE_KEPT => Kept,
        GUSSET_HOLE_TOO_LARGE => TooLarge,
        GUSSET_HOLE_OPEN => Open,
        GUSSET_HOLE_NON_MANIFOLD => NonManifold,
        GUSSET_HOLE_NOT_ORIENTED => NotOriented,
        GUSSET_HOLE_NOT_SIMPLE => NotSimple,
        GUSSET_HOLE_NOT_FREE => NotFree,
        GUSSET_HOLE_NO_TRIANGULATION => NoTriangulation,
        GUSSET_HOLE_LOOSE => Loose,
        GUSSET_HOLE_UNSEWN => Unsewn,
    }
}

impl gusset_hole {
    pub(crate) fn new(hole: &Hole) -> Self {
        gusset_hole {
            rim_first: hole.rim.start,
            rim_count: hole.rim.len(),
            face_first: hole.faces.start as usize,
            face_count: hole.faces.len(),
            vertex_first: hole.vertices.start as usize,
            vertex_count: hole.vertices.len(),
            length: hole.measures.length,
            diameter: hole.measures.diameter,
            area: hole.measures.area,
            status: hole.status.number(),
            weight: hole.weight.number(),
            finish: hole.finish.number(),
            patch: hole.patch,
        }
    }
}

/// A mesh with filled holes, and the reports on its loops.
pub(crate) struct FillResult {
    pub(crate) filled: Filled,
    holes: Vec<gusset_hole>,
}

impl FillResult {
    pub(crate) fn new(done: Filled) -> Result<Self, Error> {
        let holes = alloc::collect(done.holes.iter().map(gusset_hole::new))?;
        Ok(FillResult { filled: done, holes })
    }

    pub(crate) fn fill_report(&self) -> gusset_fill_report {
        let FillResult { filled: done, holes } = self;
        gusset_fill_report {
            struct_size: size_of::<gusset_fill_report>(),
            holes: lend_list(holes),
            hole_count: holes.len(),
            rims: gusset_indices::lend_indices(&done.rims),
            parents: gusset_indices::lend_indices(done.parents.as_flattened()),
            weights: lend_list(done.weights.as_flattened()),
            intersections: gusset_indices::lend_indices(
                done.intersections.as_deref().unwrap_or_default().as_flattened(),
            ),
            intersections_known: u32::from(done.intersections.is_some()),
            turned_outwards: gusset_indices::lend_indices(&done.turned_outwards),
            coincident_edges: done.coincident_edges,
        }
    }
}
