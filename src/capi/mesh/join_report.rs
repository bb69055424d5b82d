//! Joining: reports: Outcomes of joints and loops.

use crate::assemble::{Assembly, Joint, LeftLoop, Outcome, Reason};
use crate::capi::glue::{c_enum, fixed, versioned};
use crate::capi::input::{Choice, lend_list};
use crate::capi::mesh::fill_report::gusset_hole;
use crate::capi::mesh::gusset_indices;
use crate::capi::mesh::stitch_options::gusset_finish;
use crate::error::Error;
use crate::stitch::IndexMap;
use gusset_base::alloc;

/// Outcome of a joint.
pub type gusset_joint_outcome = u32;
/// A strip joins the two sides.
pub const GUSSET_JOINT_JOINED: gusset_joint_outcome = 0;

/// Left open: the surface would become one-sided.
pub const GUSSET_JOINT_ORIENTATION_CONFLICT: gusset_joint_outcome = 1;

/// Left open: the sides share a vertex.
pub const GUSSET_JOINT_SHARE_VERTEX: gusset_joint_outcome = 2;

/// Left open: every strip would repeat an edge of the mesh.
pub const GUSSET_JOINT_NO_STRIP: gusset_joint_outcome = 3;

/// Left to hole filling: between trimmed pieces, the strip would intersect other faces.
pub const GUSSET_JOINT_WOULD_CUT: gusset_joint_outcome = 4;

/// Reason for the lack of a strip.
pub type gusset_left_reason = u32;
/// It is the only loop.
pub const GUSSET_LEFT_ALONE: gusset_left_reason = 0;

/// The loop is open, non-manifold or not consistently oriented.
pub const GUSSET_LEFT_NOT_SIMPLE: gusset_left_reason = 1;

/// The loop has fewer than 3 vertices.
pub const GUSSET_LEFT_TOO_SHORT: gusset_left_reason = 2;

/// The loop faces another, but lacks a strip; see joints.
pub const GUSSET_LEFT_NOT_JOINED: gusset_left_reason = 3;

/// The nearest loop, or the other side of a slit, is farther than allowed_gap.
pub const GUSSET_LEFT_TOO_FAR: gusset_left_reason = 4;

/// All other loops are on its component, and within_components is 0.
pub const GUSSET_LEFT_SAME_COMPONENT: gusset_left_reason = 5;

/// The nearest loop is close enough, but they face each other too little.
pub const GUSSET_LEFT_LOOKS_AWAY: gusset_left_reason = 6;

/// The nearest loop is joined with another.
pub const GUSSET_LEFT_TAKEN: gusset_left_reason = 7;

/// The pair with the nearest loop is excluded.
pub const GUSSET_LEFT_EXCLUDED: gusset_left_reason = 8;

/// Indices of a piece's elements in the result, UINT32_MAX if removed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_piece_map {
    /// Index of each vertex; several may share one.
    pub vertices: gusset_indices,
    /// Index of each face; a split triangle's first part, which the others follow.
    pub faces: gusset_indices,
}

/// Two loops, or runs of loops, that face each other. Indices are in the result.
///
/// If borders coincide in part, sewing leaves a slit: a loop along the rest of both. In a slit
/// joined with itself, both sides are on it, one with both ends; whole is 0, without rows.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_joint {
    /// Vertices of each side in order, before turning components outwards. If joined, both run from
    /// the first meridian on.
    pub side: [gusset_indices; 2],
    /// Mean width of the gap.
    pub gap: f64,
    /// First new vertex.
    pub vertex_first: usize,
    /// Number of new vertices.
    pub vertex_count: usize,
    /// First face of the strip.
    pub face_first: usize,
    /// Number of faces.
    pub face_count: usize,
    /// As in gusset_stitch_report.
    /// @shape * 2
    pub intersections: gusset_indices,
    /// 1 if searched for.
    /// @flag
    pub intersections_known: u32,
    /// Outcome of a joint.
    pub outcome: gusset_joint_outcome,
    /// 1 if both sides are whole loops.
    /// @flag
    pub whole: u32,
    /// Surface between the rims, or in a hole.
    pub finish: gusset_finish,
}

/// Boundary loop of the sewn pieces without a strip, even if filled.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_left_loop {
    /// Vertices in the result, in order.
    pub vertices: gusset_indices,
    /// Mean distance to the loop nearest to most vertices, on another component if any; infinite
    /// without one, or if this loop cannot carry a strip. Too wide slit: mean distance of sides.
    pub gap: f64,
    /// Largest gap that could be joined; 0 without another loop.
    pub allowed_gap: f64,
    /// Reason for the lack of a strip.
    pub reason: gusset_left_reason,
    /// 1 if hole filling closed the loop.
    /// @flag
    pub filled: u32,
}

/// Report of a join.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_join_report {
    /// sizeof(gusset_join_report).
    pub struct_size: usize,
    /// Indices of each piece in the result.
    /// @shape piece_count
    pub pieces: *const gusset_piece_map,
    /// Number of pieces.
    pub piece_count: usize,
    /// Joints: given pairs in their order, then the others, nearest first.
    /// @shape joint_count
    pub joints: *const gusset_joint,
    /// Number of joints.
    pub joint_count: usize,
    /// Loops without a strip, by smallest vertex.
    /// @shape left_count
    pub left: *const gusset_left_loop,
    /// Number of loops.
    pub left_count: usize,
    /// Holes considered for filling.
    /// @shape hole_count
    pub holes: *const gusset_hole,
    /// Number of holes.
    pub hole_count: usize,
    /// Rim vertices of holes, in order, before turning components outwards.
    pub hole_rims: gusset_indices,
    /// Old faces reversed against their pieces, by index in the result. New faces agree with the
    /// faces beside them.
    pub turned: gusset_indices,
    /// A face of each non-orientable component.
    pub one_sided: gusset_indices,
    /// A face of each closed component of volume 0 up to rounding; none with
    /// GUSSET_ORIENTATION_KEEP or GUSSET_OUTWARD_KEEP.
    pub zero_volume: gusset_indices,
    /// Vertices merged into another.
    pub welded_vertices: u32,
    /// Edges made from two boundary edges.
    pub sewn_edges: u32,
    /// Boundary loops of the result.
    pub loops_left: u32,
    /// Non-manifold edges of the result.
    pub non_manifold_edges: u32,
    /// Points at which boundary edges were split.
    pub splits: u32,
    /// Loops left open by GUSSET_LEFT_LOOKS_AWAY, GUSSET_LEFT_TAKEN or GUSSET_LEFT_NOT_JOINED.
    pub near_loops_left: u32,
    /// Faces removed from overlaps.
    pub trimmed_faces: u32,
    /// As in gusset_weld_report.
    pub near_edge_pairs: u32,
    /// As in gusset_weld_report.
    pub near_tolerance: f64,
    /// Trimmed faces, as (piece, face), ascending, without a kept face within max_distance of the
    /// trimming that faces the same way.
    /// @shape * 2
    pub lost_faces: gusset_indices,
    /// Piece and vertex for each loop in left: the first that a piece has, else UINT32_MAX twice.
    /// @shape * 2
    pub left_origins: gusset_indices,
    /// As intersections of gusset_fill_report.
    /// @shape * 2
    pub hole_intersections: gusset_indices,
    /// Length along which each joint's strip intersects faces.
    /// @shape joint_count
    pub joint_cut_lengths: *const f64,
    /// Length along which each hole's patch intersects faces.
    /// @shape hole_count
    pub hole_cut_lengths: *const f64,
    /// For each joint, 1 if its strip intersects faces and a blend would not, else 0. Tried with
    /// GUSSET_INTERSECTIONS_AUTO on untrimmed pieces.
    /// @shape joint_count
    pub blend_avoids_cuts: *const u32,
    /// 1 if intersections of patches were searched for.
    /// @flag
    pub hole_intersections_known: u32,
    /// Joints whose strips intersect faces.
    pub cutting_joints: u32,
}

/// Joined pieces, and the reports on them.
pub(crate) struct JoinResult {
    pub(crate) assembly: Assembly,
    pieces: Vec<gusset_piece_map>,
    joints: Vec<gusset_joint>,
    left: Vec<gusset_left_loop>,
    holes: Vec<gusset_hole>,
    turned: Vec<u32>,
    left_origins: Vec<[u32; 2]>,
    joint_cut_lengths: Vec<f64>,
    blend_avoids_cuts: Vec<u32>,
}

versioned! { gusset_join_report: 176 }

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

impl JoinResult {
    pub(crate) fn new(done: Assembly) -> Result<Self, Error> {
        let map = |map: &IndexMap| gusset_piece_map {
            vertices: gusset_indices::lend_indices(&map.vertices),
            faces: gusset_indices::lend_indices(&map.faces),
        };
        let joint = |joint: &Joint| gusset_joint {
            side: joint.sides.each_ref().map(|side| gusset_indices::lend_indices(side)),
            gap: joint.gap,
            vertex_first: joint.vertices.start as usize,
            vertex_count: joint.vertices.len(),
            face_first: joint.faces.start as usize,
            face_count: joint.faces.len(),
            intersections: gusset_indices::lend_indices(
                joint.intersections.as_deref().unwrap_or_default().as_flattened(),
            ),
            intersections_known: joint.intersections.is_some().into(),
            outcome: joint.outcome.number(),
            whole: joint.whole.into(),
            finish: joint.finish.number(),
        };
        let left = |left: &LeftLoop| gusset_left_loop {
            vertices: gusset_indices::lend_indices(&left.vertices),
            gap: left.gap,
            allowed_gap: left.allowed_gap,
            reason: left.reason.number(),
            filled: left.filled.into(),
        };
        let turned = alloc::gather((0u32..).zip(&done.turned).filter(|&(_, &turned)| turned).map(|(f, _)| f))?;
        // The lists behind these pointers lie on the heap and do not move.
        Ok(JoinResult {
            pieces: alloc::collect(done.maps.iter().map(map))?,
            joints: alloc::collect(done.joints.iter().map(joint))?,
            left: alloc::collect(done.left.iter().map(left))?,
            holes: alloc::collect(done.holes.iter().map(gusset_hole::new))?,
            turned,
            left_origins: alloc::collect(done.left.iter().map(|left| left.origin))?,
            joint_cut_lengths: alloc::collect(done.joints.iter().map(|joint| joint.cut_length))?,
            blend_avoids_cuts: alloc::collect(done.joints.iter().map(|joint| joint.blend_avoids_cuts.into()))?,
            assembly: done,
        })
    }

    pub(crate) fn join_report(&self) -> gusset_join_report {
        gusset_join_report {
            struct_size: size_of::<gusset_join_report>(),
            pieces: lend_list(&self.pieces),
            piece_count: self.pieces.len(),
            joints: lend_list(&self.joints),
            joint_count: self.joints.len(),
            left: lend_list(&self.left),
            left_count: self.left.len(),
            holes: lend_list(&self.holes),
            hole_count: self.holes.len(),
            hole_rims: gusset_indices::lend_indices(&self.assembly.hole_rims),
            turned: gusset_indices::lend_indices(&self.turned),
            one_sided: gusset_indices::lend_indices(&self.assembly.one_sided),
            zero_volume: gusset_indices::lend_indices(&self.assembly.zero_volume),
            welded_vertices: self.assembly.welded_vertices,
            sewn_edges: self.assembly.sewn_edges,
            loops_left: self.assembly.loops_left,
            non_manifold_edges: self.assembly.non_manifold_edges,
            splits: self.assembly.splits,
            near_loops_left: self.assembly.near_loops_left,
            trimmed_faces: self.assembly.trimmed_faces,
            near_edge_pairs: self.assembly.near.edge_pairs,
            near_tolerance: self.assembly.near.tolerance,
            lost_faces: gusset_indices::lend_indices(self.assembly.lost_faces.as_flattened()),
            left_origins: gusset_indices::lend_indices(self.left_origins.as_flattened()),
            hole_intersections: gusset_indices::lend_indices(
                self.assembly.hole_intersections.as_deref().unwrap_or_default().as_flattened(),
            ),
            joint_cut_lengths: lend_list(&self.joint_cut_lengths),
            hole_cut_lengths: lend_list(&self.assembly.hole_cut_lengths),
            blend_avoids_cuts: lend_list(&self.blend_avoids_cuts),
            hole_intersections_known: self.assembly.hole_intersections.is_some().into(),
            cutting_joints: self.assembly.joints.iter().filter(|joint| joint.has_cuts()).count() as u32,
        }
    }
}
