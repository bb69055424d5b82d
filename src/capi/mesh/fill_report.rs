//! Holes: reports: What filling did to each hole.

use crate::capi::glue::{c_enum, fixed, versioned};
use crate::capi::input::{Choice, lent};
use crate::capi::mesh::gusset_indices;
use crate::error::Error;
use crate::fill::{Filled, Finish, Hole, HoleStatus, Weight};
use gusset_base::alloc;

/// The weight that the triangulation of a rim minimises.
pub type gusset_fill_weight = u32;
/// The best continuation of the surface round the hole: the least sum of 2 sin(t / 2) over all edges,
/// the rim's included, t being the angle between the normals on both sides, and over the triangles of
/// the mean square of how far the surface that was there is likely to have been from them, as its
/// tangent planes at the rim say, in units of 1 / 140 of its length. By area alone if it is planar.
pub const GUSSET_WEIGHT_CONTINUATION: gusset_fill_weight = 0;
/// The least sum of areas and, for each edge, the rim's included, squared length times 1 - cosine
/// of the angle between its faces.
pub const GUSSET_WEIGHT_AREA_AND_BEND: gusset_fill_weight = 1;
/// The least largest angle between neighbouring faces, those beyond the rim included, and then the
/// least area, as Liepa has it.
pub const GUSSET_WEIGHT_BEND_THEN_AREA: gusset_fill_weight = 2;
/// The least area, exactly.
pub const GUSSET_WEIGHT_AREA: gusset_fill_weight = 3;

/// The vertices of a patch.
pub type gusset_patch_finish = u32;
/// Triangles between the vertices of the rims.
pub const GUSSET_PATCH_PLAIN: gusset_patch_finish = 0;
/// With new vertices, where the plain triangles are, but for those beside creases that go on.
pub const GUSSET_PATCH_REFINED: gusset_patch_finish = 1;
/// With new vertices, faired.
pub const GUSSET_PATCH_FAIRED: gusset_patch_finish = 2;

/// The outcome for one loop.
pub type gusset_hole_status = u32;
/// Filled; with plan_only, to be filled.
pub const GUSSET_HOLE_FILLED: gusset_hole_status = 0;
/// Left: it is no hole, as keep has it.
pub const GUSSET_HOLE_KEPT: gusset_hole_status = 1;
/// Left: it exceeds max_edges, max_length, max_diameter or max_area.
pub const GUSSET_HOLE_TOO_LARGE: gusset_hole_status = 2;
/// Left: an open chain.
pub const GUSSET_HOLE_OPEN: gusset_hole_status = 3;
/// Left: it runs along an edge with three or more faces.
pub const GUSSET_HOLE_NON_MANIFOLD: gusset_hole_status = 4;
/// Left: the faces along it disagree in orientation.
pub const GUSSET_HOLE_NOT_ORIENTED: gusset_hole_status = 5;
/// Left: a given loop of fewer than three vertices, or one that passes a vertex twice.
pub const GUSSET_HOLE_NOT_SIMPLE: gusset_hole_status = 6;
/// Left: an edge of a given loop does not have exactly one face, or is one of a loop before it.
pub const GUSSET_HOLE_NOT_FREE: gusset_hole_status = 7;
/// Left: every triangulation would have an edge between two vertices of one old face, which is an
/// edge of the mesh or becomes one once its polygons are cut into triangles; or none was found that
/// closes all loops together which are to get one patch, as where two of them share a vertex.
pub const GUSSET_HOLE_NO_TRIANGULATION: gusset_hole_status = 8;

/// The account of one loop.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_hole {
    /// Its vertices are rims.data[rim_first] and on: with the surface on the left as it was before
    /// closed components were turned outwards, or, of a given loop that is not simple, free or
    /// oriented, as given.
    pub rim_first: usize,
    /// How many they are.
    pub rim_count: usize,
    /// Its patch's first face in the result: the faces and the new vertices of a patch of several
    /// loops are in the accounts of all of them.
    pub face_first: usize,
    /// How many faces the patch has.
    pub face_count: usize,
    /// The patch's first new vertex in the result.
    pub vertex_first: usize,
    /// How many new vertices the patch has.
    pub vertex_count: usize,
    /// The sum of its edges' lengths, in the unit of the positions.
    pub length: f64,
    /// The diagonal of the box round it, along the axes.
    pub diameter: f64,
    /// The area of the cone of triangles from its edges to their common centre: that of the hole if
    /// it is planar and convex, more otherwise.
    pub area: f64,
    /// The outcome for one loop.
    pub status: gusset_hole_status,
    /// The weight that the patch's triangulation is best by: the one asked for, or one that
    /// cuts less.
    pub weight: gusset_fill_weight,
    /// What the patch is made of: what was asked for, or less, which cuts less.
    pub finish: gusset_patch_finish,
    /// The number of the patch, from 0 on in the order of the faces; loops with the same number have
    /// one patch. UINT32_MAX if it has none, as all have in a plan.
    pub patch: u32,
}

/// The accounts of all loops. Pointers are valid until the result is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_fill_report {
    /// sizeof(gusset_fill_report), set by the caller.
    pub struct_size: usize,
    /// One for each loop: those given, in their order, or all that the mesh has, as
    /// gusset_boundary_get_loop numbers them. NULL if there are none.
    pub holes: *const gusset_hole,
    /// How many.
    pub hole_count: usize,
    /// The vertices of all rims.
    pub rims: gusset_indices,
    /// Of each new vertex, in their order, three vertices of its patch's rims.
    pub parents: gusset_indices,
    /// How much it has of each of them, three numbers a vertex, at least 0 with sum 1; NULL without
    /// new vertices. They place it at the nearest point of the plain triangulation of the rims,
    /// which it is itself if its patch was neither faired nor creased, or if the hole is flat.
    pub weights: *const f64,
    /// Pairs of faces of the result that cut each other, two numbers a pair, the larger one first,
    /// which is a new face's; ascending. What they share, a vertex or an edge, is no cut, nor are
    /// vertices and edges at the same place; any other touch is. Exact.
    pub intersections: gusset_indices,
    /// Faces of the result, old and new ones, that GUSSET_OUTWARD_CLOSED turned over, ascending.
    /// Each keeps its first corner and has the others in reverse order.
    pub turned_outwards: gusset_indices,
    /// 1 if intersections were looked for, 0 if not.
    pub intersections_known: u32,
    /// 0.
    pub reserved: u32,
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
    }
}

impl gusset_hole {
    pub(crate) fn of(hole: &Hole) -> Self {
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

/// A mesh with holes filled, and the reports of its loops.
pub(crate) struct Fill {
    pub(crate) done: Filled,
    holes: Vec<gusset_hole>,
}

impl Fill {
    pub(crate) fn new(done: Filled) -> Result<Self, Error> {
        let holes = alloc::collect(done.holes.iter().map(gusset_hole::of))?;
        Ok(Fill { done, holes })
    }

    pub(crate) fn report(&self) -> gusset_fill_report {
        let Fill { done, holes } = self;
        gusset_fill_report {
            struct_size: size_of::<gusset_fill_report>(),
            holes: lent(holes),
            hole_count: holes.len(),
            rims: gusset_indices::lend(&done.rims),
            parents: gusset_indices::lend(done.parents.as_flattened()),
            weights: lent(done.weights.as_flattened()),
            intersections: gusset_indices::lend(done.intersections.as_deref().unwrap_or_default().as_flattened()),
            intersections_known: u32::from(done.intersections.is_some()),
            turned_outwards: gusset_indices::lend(&done.turned_outwards),
            reserved: 0,
        }
    }
}
