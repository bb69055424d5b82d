//! C interface to the assembly of many pieces.

use crate::assemble::{Assembly, Joint, LeftLoop, Outcome, Reason, assemble};
use crate::attributes::KeepSplits;
use crate::capi::context::{create, gusset_context, lend};
use crate::capi::glue::{c_enum, fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, Choice, lent};
use crate::capi::mesh::assembly_options::{gusset_assembly_options, pairs};
use crate::capi::mesh::fill::gusset_hole;
use crate::capi::mesh::{self, GivenMesh, gusset_indices, gusset_mesh_view};
use crate::capi::status::gusset_status;
use crate::error::Error;
use crate::stitch::IndexMap;
use gusset_base::alloc;

/// A strip joins them.
pub const GUSSET_JOINT_JOINED: u32 = 0;

/// Left: joining them would make a one-sided surface with what is joined already.
pub const GUSSET_JOINT_ORIENTATION_CONFLICT: u32 = 1;

/// Left: they pass the same vertex.
pub const GUSSET_JOINT_SHARE_VERTEX: u32 = 2;

/// Left: every strip would repeat an edge that the mesh already has.
pub const GUSSET_JOINT_NO_STRIP: u32 = 3;

/// Left: between pieces whose overlaps were trimmed, as every strip would cut other faces. It is a
/// part of a hole then.
pub const GUSSET_JOINT_WOULD_CUT: u32 = 4;

/// There is no other loop.
pub const GUSSET_LEFT_ALONE: u32 = 0;

/// It is open, or the faces along it disagree in orientation or are not manifold there.
pub const GUSSET_LEFT_NOT_SIMPLE: u32 = 1;

/// It has fewer than three vertices.
pub const GUSSET_LEFT_TOO_SHORT: u32 = 2;

/// It faces another loop, but no strip could be made: see the joints.
pub const GUSSET_LEFT_NOT_JOINED: u32 = 3;

/// The nearest loop is farther away than is allowed; or the loop is what sewing left of two
/// borders, and its two sides are. See gap and allowed_gap.
pub const GUSSET_LEFT_TOO_FAR: u32 = 4;

/// All other loops are of its own component, and within_components is not set.
pub const GUSSET_LEFT_SAME_COMPONENT: u32 = 5;

/// The nearest loop is near enough, but they do not look at each other along enough of both.
pub const GUSSET_LEFT_LOOKS_AWAY: u32 = 6;

/// The nearest loop is joined with another.
pub const GUSSET_LEFT_TAKEN: u32 = 7;

/// It is not to be joined with the nearest loop.
pub const GUSSET_LEFT_EXCLUDED: u32 = 8;

/// Where a piece went.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_piece_map {
    /// Per vertex of the piece, its index in the result; several may have the same. UINT32_MAX if
    /// it was left out.
    pub vertices: gusset_indices,
    /// Per face, its index in the result, or UINT32_MAX; of a triangle that was cut, that of the
    /// first part, which the others follow.
    pub faces: gusset_indices,
}

/// Two loops, or runs of loops, that face each other across a gap.
///
/// Of two borders that coincide along a part only, sewing leaves loops that run along the rest of
/// one and back along the other; they turn at two vertices that sewing made of several. Such a loop
/// may be joined with itself: both sides are on it, one of them with both ends, whole is 0, and the
/// strip has no interior rows whatever the options say.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_joint {
    /// The vertices of each side in the result, in order; if joined, side by side from the first
    /// meridian on. The order is that of before closed components were turned outwards.
    pub side: [gusset_indices; 2],
    /// The mean width of the gap; of a loop that is joined with itself the mean distance of its
    /// sides.
    pub gap: f64,
    /// The strip's first new vertex in the result.
    pub vertex_first: usize,
    /// How many new vertices it has.
    pub vertex_count: usize,
    /// The strip's first face in the result.
    pub face_first: usize,
    /// How many faces it has.
    pub face_count: usize,
    /// Pairs of faces that cut each other, as in gusset_stitch_view.
    pub intersections: gusset_indices,
    /// 1 if they were looked for.
    pub intersections_known: u32,
    /// GUSSET_JOINT_...
    pub outcome: u32,
    /// 1 if both sides are whole loops.
    pub whole: u32,
    /// GUSSET_FINISH_...: what the strip is. A blend that was asked for may have had to give way to
    /// the strip.
    pub finish: u32,
}

/// A boundary loop of the sewn pieces that no strip hangs on. It is listed even if it was filled
/// afterwards: holes says what became of it then.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_left_loop {
    /// Its vertices in the result, in order.
    pub vertices: gusset_indices,
    /// The mean distance from its vertices to the nearest of the loop that is nearest to most of
    /// them, of another component where there is one; infinite if there is none, or if this loop
    /// cannot carry a strip. Of what sewing left of two borders, whose sides are too far from each
    /// other, the mean distance of these.
    pub gap: f64,
    /// How far that loop, or that side, may be to be joined; 0 if there is none.
    pub allowed_gap: f64,
    /// GUSSET_LEFT_...
    pub reason: u32,
    /// 0.
    pub reserved: u32,
}

/// The account of an assembly. Pointers are valid until it is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_assembly_view {
    /// sizeof(gusset_assembly_view), set by the caller.
    pub struct_size: usize,
    /// One for each piece.
    pub pieces: *const gusset_piece_map,
    /// How many.
    pub piece_count: usize,
    /// The pairs that face each other: those that were given, in their order, then the others,
    /// nearest first.
    pub joints: *const gusset_joint,
    /// How many.
    pub joint_count: usize,
    /// The loops that no strip hangs on, by their smallest vertices; those that were filled in the
    /// end are among them. loops_left counts what is open now.
    pub left: *const gusset_left_loop,
    /// How many.
    pub left_count: usize,
    /// The holes that were looked at in the end.
    pub holes: *const gusset_hole,
    /// How many.
    pub hole_count: usize,
    /// The vertices of their rims, in the order of before closed components were turned outwards.
    pub hole_rims: gusset_indices,
    /// Faces of the pieces that run the other way than they did in their pieces, by their indices
    /// in the result: turned to agree with others, or with their component to face outwards, but
    /// not both. Faces of strips and patches were nothing before, and are not listed: they run as
    /// the faces of pieces beside them do.
    pub turned: gusset_indices,
    /// A face of each component that cannot be oriented.
    pub one_sided: gusset_indices,
    /// A face of each closed component of the result that encloses no volume up to rounding, as a
    /// piece does that is given twice. Empty with GUSSET_ORIENTATION_KEEP or keep_inside_out.
    pub zero_volume: gusset_indices,
    /// Vertices that became one with another.
    pub welded_vertices: u32,
    /// Edges that were two free edges.
    pub sewn_edges: u32,
    /// Boundary loops of the result.
    pub loops_left: u32,
    /// Edges of the result with three or more faces.
    pub non_manifold_edges: u32,
    /// Points at which free edges were split for borders to match.
    pub splits: u32,
    /// Entries of left that have another loop within the gap that is allowed: those that look away,
    /// whose partner is taken, or that no strip could join.
    pub near_loops_left: u32,
    /// Faces that were trimmed from overlaps.
    pub trimmed_faces: u32,
    /// 0.
    pub reserved: u32,
}

/// An assembled mesh and its account. Opaque and immutable; it keeps nothing of the pieces.
pub struct gusset_assembly {
    pub(crate) done: Assembly,
    pieces: Vec<gusset_piece_map>,
    joints: Vec<gusset_joint>,
    left: Vec<gusset_left_loop>,
    holes: Vec<gusset_hole>,
    turned: Vec<u32>,
}

handle! { gusset_assembly }

versioned! { gusset_assembly_view: 168 reserved }

fixed! { gusset_joint: 104, gusset_left_loop: 40 }

c_enum! {
    outcome: Outcome {
        GUSSET_JOINT_JOINED => Joined,
        GUSSET_JOINT_ORIENTATION_CONFLICT => OrientationConflict,
        GUSSET_JOINT_SHARE_VERTEX => ShareVertex,
        GUSSET_JOINT_NO_STRIP => NoStrip,
        GUSSET_JOINT_WOULD_CUT => WouldCut,
    }
    reason: Reason {
        GUSSET_LEFT_ALONE => Alone,
        GUSSET_LEFT_NOT_SIMPLE => NotSimple,
        GUSSET_LEFT_TOO_SHORT => TooShort,
        GUSSET_LEFT_NOT_JOINED => NotJoined,
        GUSSET_LEFT_TOO_FAR => TooFar,
        GUSSET_LEFT_SAME_COMPONENT => SameComponent,
        GUSSET_LEFT_LOOKS_AWAY => LooksAway,
        GUSSET_LEFT_TAKEN => Taken,
        GUSSET_LEFT_EXCLUDED => Excluded,
    }
}

impl gusset_assembly {
    fn new(done: Assembly) -> Result<Self, Error> {
        let map = |map: &IndexMap| gusset_piece_map {
            vertices: gusset_indices::lend(&map.vertices),
            faces: gusset_indices::lend(&map.faces),
        };
        let joint = |joint: &Joint| gusset_joint {
            side: joint.sides.each_ref().map(|side| gusset_indices::lend(side)),
            gap: joint.gap,
            vertex_first: joint.vertices.start as usize,
            vertex_count: joint.vertices.len(),
            face_first: joint.faces.start as usize,
            face_count: joint.faces.len(),
            intersections: gusset_indices::lend(joint.intersections.as_deref().unwrap_or_default().as_flattened()),
            intersections_known: joint.intersections.is_some().into(),
            outcome: joint.outcome.number(),
            whole: joint.whole.into(),
            finish: joint.finish.number(),
        };
        let left = |left: &LeftLoop| gusset_left_loop {
            vertices: gusset_indices::lend(&left.vertices),
            gap: left.gap,
            allowed_gap: left.allowed_gap,
            reason: left.reason.number(),
            reserved: 0,
        };
        let turned = alloc::gather((0u32..).zip(&done.turned).filter(|&(_, &turned)| turned).map(|(f, _)| f))?;
        // The lists that these point to lie on the heap and stay where they are.
        Ok(gusset_assembly {
            pieces: alloc::collect(done.maps.iter().map(map))?,
            joints: alloc::collect(done.joints.iter().map(joint))?,
            left: alloc::collect(done.left.iter().map(left))?,
            holes: alloc::collect(done.holes.iter().map(gusset_hole::of))?,
            turned,
            done,
        })
    }
}

/// Assembles open pieces into one mesh: coincident borders are sewn, components oriented alike,
/// loops that face each other across a gap stitched, holes filled, and closed components turned
/// outwards, as the options say.
///
/// That two loops cannot be joined is no failure: each joint has its outcome.
///
/// Loops of different components face each other as wholes if nearly all vertices of each (9/10)
/// are nearest to the other loop, and from similar distances (the ninth decile is at most four
/// times the first, or the spacing of the vertices) or so that the nearest vertices go round the
/// other loop once; else runs of neighbouring vertices that are nearest to each other face each
/// other, and are joined by open strips. What faces nothing is left alone. Pieces that overlap are
/// not cut unless overlaps says so: where two lie on each other, their borders face each other and
/// enclose what is between.
/// Vertices of the result: those of the pieces in order, then those of the strips, then those of
/// the patches; faces in the same way. Positions are of the scalar type of the first piece, and old
/// ones keep their bits.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param pieces piece_count mesh views one after another, each as large as the first one's
///     struct_size says, at least one; each may have several components.
/// @param piece_count see pieces.
/// @param options NULL for the defaults.
/// @param[out] assembly receives the result, for gusset_assembly_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: those of gusset_mesh_view (the report's input is the piece),
///     EMPTY_MESH without pieces, MIXED_SCALARS (a piece has f64 positions and the first one f32),
///     UNKNOWN_VALUE, OUT_OF_RANGE (a tolerance, max_gap, or one of pairs or of excluded: the
///     report's index is its number, its input is 0 or 1 for the first or the second loop, its
///     value the piece that does not exist, else the vertex, and the message says what is wrong:
///     there is no such piece, or no such vertex of it; of pairs also: no vertex is named, no loop
///     that can be joined passes it or several do, it is on the pair's other loop, or its loop is
///     in a pair before), TOO_LARGE, OUT_OF_MEMORY, CANCELLED.
/// @complexity O(H log d) for H half-edges and at most d edges at a vertex, O(V log V) for V
///     vertices on loops, the time of each strip as for gusset_stitch_create, and of each hole as
///     for gusset_fill_create; a pass over all faces for each strip that is faired or tested for
///     intersections. Extra memory is linear in the pieces and the result.
/// @source Nesterenko for a single gap; the rest is our own.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_assembly_create(
    context: *const gusset_context,
    pieces: *const gusset_mesh_view,
    piece_count: usize,
    options: *const gusset_assembly_options,
    assembly: *mut *mut gusset_assembly,
) -> gusset_status {
    create(context, assembly, "assembly", |job| {
        let options = input::read(options, true, "options")?;
        let trim = input::nested(options.trim_options, "trim_options", Ok)?;
        let viewpoints = trim.viewpoints().map_err(|failure| failure.of_field("trim_options"))?;
        let mut given = pairs(options.pairs, options.pair_count, "pairs")?;
        let mut excluded = pairs(options.excluded, options.excluded_count, "excluded")?;
        let given_meshes = mesh::meshes(pieces, piece_count, &job.part(0.0, 0.1))?;
        let views = alloc::collect(given_meshes.iter().map(GivenMesh::view))?;
        for selector in given.iter_mut().chain(&mut excluded).flatten() {
            if let Some(view) = views.get(selector.piece as usize) {
                selector.vertex = view.faces().merge_of(selector.vertex);
            }
        }
        let options = options.checked([&given, &excluded], trim, &viewpoints)?;
        let mut done = assemble(&views, &options, &job.part(0.1, 0.95))?;
        done.keep_splits(&alloc::gather(views.iter())?, &job.part(0.95, 1.0))?;
        Ok(gusset_assembly::new(done)?)
    })
}

/// Destroys an assembly; NULL is allowed.
///
/// @param[in,out] assembly the handle; NULL is allowed.
/// @since 0.1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_assembly_destroy(assembly: *mut gusset_assembly) {
    handle::destroy(assembly);
}

/// Lends the whole result, valid until the assembly is destroyed.
///
/// @param assembly the assembly.
/// @param[out] view receives the view; struct_size is set by the caller.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
/// @complexity O(1).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_assembly_get_mesh(
    assembly: *const gusset_assembly,
    view: *mut gusset_mesh_view,
) -> gusset_status {
    lend!(assembly, view, |assembly| mesh::lend(&assembly.done.mesh))
}

/// Lends the account.
///
/// @param assembly the assembly.
/// @param[out] parts receives the parts; struct_size is set by the caller.
/// @return GUSSET_OK, or an error: those of gusset_assembly_get_mesh.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_assembly_get_view(
    assembly: *const gusset_assembly,
    parts: *mut gusset_assembly_view,
) -> gusset_status {
    lend!(assembly, parts, |all| gusset_assembly_view {
        struct_size: size_of::<gusset_assembly_view>(),
        pieces: lent(&all.pieces),
        piece_count: all.pieces.len(),
        joints: lent(&all.joints),
        joint_count: all.joints.len(),
        left: lent(&all.left),
        left_count: all.left.len(),
        holes: lent(&all.holes),
        hole_count: all.holes.len(),
        hole_rims: gusset_indices::lend(&all.done.hole_rims),
        turned: gusset_indices::lend(&all.turned),
        one_sided: gusset_indices::lend(&all.done.one_sided),
        zero_volume: gusset_indices::lend(&all.done.zero_volume),
        welded_vertices: all.done.welded_vertices,
        sewn_edges: all.done.sewn_edges,
        loops_left: all.done.loops_left,
        non_manifold_edges: all.done.non_manifold_edges,
        splits: all.done.splits,
        near_loops_left: all.done.near_loops_left,
        trimmed_faces: all.done.trimmed_faces,
        reserved: 0,
    })
}
