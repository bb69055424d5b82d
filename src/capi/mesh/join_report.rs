//! Joining: reports: What became of each joint and each loop.

use crate::assemble::{Assembly, Joint, LeftLoop, Outcome, Reason};
use crate::capi::glue::{c_enum, fixed, versioned};
use crate::capi::input::{Choice, lent};
use crate::capi::mesh::fill_report::gusset_hole;
use crate::capi::mesh::gusset_indices;
use crate::capi::mesh::stitch_options::gusset_finish;
use crate::error::Error;
use crate::stitch::IndexMap;
use gusset_base::alloc;

/// The outcome for two loops that face each other.
pub type gusset_joint_outcome = u32;
/// A strip joins them.
pub const GUSSET_JOINT_JOINED: gusset_joint_outcome = 0;

/// Left: joining them would make a one-sided surface with what is joined already.
pub const GUSSET_JOINT_ORIENTATION_CONFLICT: gusset_joint_outcome = 1;

/// Left: they pass the same vertex.
pub const GUSSET_JOINT_SHARE_VERTEX: gusset_joint_outcome = 2;

/// Left: every strip would repeat an edge that the mesh already has.
pub const GUSSET_JOINT_NO_STRIP: gusset_joint_outcome = 3;

/// Left: between pieces whose overlaps were trimmed, as every strip would cut other faces. It is a
/// part of a hole then.
pub const GUSSET_JOINT_WOULD_CUT: gusset_joint_outcome = 4;

/// The reason why a loop has no strip.
pub type gusset_left_reason = u32;
/// There is no other loop.
pub const GUSSET_LEFT_ALONE: gusset_left_reason = 0;

/// It is open, or the faces along it disagree in orientation or are not manifold there.
pub const GUSSET_LEFT_NOT_SIMPLE: gusset_left_reason = 1;

/// It has fewer than three vertices.
pub const GUSSET_LEFT_TOO_SHORT: gusset_left_reason = 2;

/// It faces another loop, but no strip could be made: see the joints.
pub const GUSSET_LEFT_NOT_JOINED: gusset_left_reason = 3;

/// The nearest loop is farther away than is allowed; or the loop is what sewing left of two
/// borders, and its two sides are. See gap and allowed_gap.
pub const GUSSET_LEFT_TOO_FAR: gusset_left_reason = 4;

/// All other loops are of its own component, and within_components is not set.
pub const GUSSET_LEFT_SAME_COMPONENT: gusset_left_reason = 5;

/// The nearest loop is near enough, but they do not look at each other along enough of both.
pub const GUSSET_LEFT_LOOKS_AWAY: gusset_left_reason = 6;

/// The nearest loop is joined with another.
pub const GUSSET_LEFT_TAKEN: gusset_left_reason = 7;

/// It is not to be joined with the nearest loop.
pub const GUSSET_LEFT_EXCLUDED: gusset_left_reason = 8;

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
    /// Pairs of faces that cut each other, as in gusset_stitch_report.
    pub intersections: gusset_indices,
    /// 1 if they were looked for.
    pub intersections_known: u32,
    /// The outcome for two loops that face each other.
    pub outcome: gusset_joint_outcome,
    /// 1 if both sides are whole loops.
    pub whole: u32,
    /// What the strip is. A blend that was asked for may have had to give way to the strip.
    pub finish: gusset_finish,
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
    /// The reason why a loop has no strip.
    pub reason: gusset_left_reason,
    /// 0.
    pub reserved: u32,
}

/// The report of a join. Pointers are valid until the result is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_join_report {
    /// sizeof(gusset_join_report), set by the caller.
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
    /// piece does that is given twice. Empty with GUSSET_ORIENTATION_KEEP or GUSSET_OUTWARD_KEEP.
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

/// Joined pieces, and the reports on them.
pub(crate) struct Join {
    pub(crate) done: Assembly,
    pieces: Vec<gusset_piece_map>,
    joints: Vec<gusset_joint>,
    left: Vec<gusset_left_loop>,
    holes: Vec<gusset_hole>,
    turned: Vec<u32>,
}

versioned! { gusset_join_report: 168 reserved }

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

impl Join {
    pub(crate) fn new(done: Assembly) -> Result<Self, Error> {
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
        Ok(Join {
            pieces: alloc::collect(done.maps.iter().map(map))?,
            joints: alloc::collect(done.joints.iter().map(joint))?,
            left: alloc::collect(done.left.iter().map(left))?,
            holes: alloc::collect(done.holes.iter().map(gusset_hole::of))?,
            turned,
            done,
        })
    }

    pub(crate) fn report(&self) -> gusset_join_report {
        gusset_join_report {
            struct_size: size_of::<gusset_join_report>(),
            pieces: lent(&self.pieces),
            piece_count: self.pieces.len(),
            joints: lent(&self.joints),
            joint_count: self.joints.len(),
            left: lent(&self.left),
            left_count: self.left.len(),
            holes: lent(&self.holes),
            hole_count: self.holes.len(),
            hole_rims: gusset_indices::lend(&self.done.hole_rims),
            turned: gusset_indices::lend(&self.turned),
            one_sided: gusset_indices::lend(&self.done.one_sided),
            zero_volume: gusset_indices::lend(&self.done.zero_volume),
            welded_vertices: self.done.welded_vertices,
            sewn_edges: self.done.sewn_edges,
            loops_left: self.done.loops_left,
            non_manifold_edges: self.done.non_manifold_edges,
            splits: self.done.splits,
            near_loops_left: self.done.near_loops_left,
            trimmed_faces: self.done.trimmed_faces,
            reserved: 0,
        }
    }
}
