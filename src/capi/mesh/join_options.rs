//! Options of joining: Which borders are joined, and how.

use crate::assemble::{MaxGap, Options, Overlaps, Selector};
use crate::capi::glue::{fixed, versioned};
use crate::capi::input::{self, flag};
use crate::capi::mesh::fill::gusset_fill_options;
use crate::capi::mesh::stitch_options::{
    GUSSET_ORIENTATION_FIX, GUSSET_ORIENTATION_KEEP, gusset_orientation, gusset_outward, gusset_stitch_options, outward,
};
use crate::capi::mesh::trim::gusset_trim_options;
use crate::capi::mesh::weld::gusset_weld_options;
use crate::capi::status::Failure;
use crate::error::Error;
use crate::mesh::MAX_ELEMENTS;
use crate::repair::orient::Outward;
use glam::DVec3;
use gusset_base::alloc;

/// The treatment of coincident borders of pieces.
pub type gusset_welding = u32;
/// Coincident borders are sewn, by default up to what rounding can have done; see
/// gusset_weld_options. Where their vertices do not match, edges are split; see gusset_sew.
pub const GUSSET_WELDING_SEW: gusset_welding = 0;
/// Nothing is welded.
pub const GUSSET_WELDING_NONE: gusset_welding = 1;
/// Coincident borders are sewn where they match vertex by vertex; see gusset_weld.
pub const GUSSET_WELDING_EDGE_TO_EDGE: gusset_welding = 2;

/// The widest gap that is closed.
pub type gusset_gap = u32;
/// Whole loops are joined if the mean width of the gap is at most a fifth of the larger component's
/// size along an axis, or the mean radius of the smaller loop (the mean distance of its vertices
/// from their centre) if that is more; two loops that are the only ones, of two pieces, whatever it
/// is. Runs of loops are joined where the gap is at most half that radius wide, and four edges of
/// the loop with the longer ones. The width is the mean distance from each loop to the nearest
/// points of the other, the larger of the two. Loops must look at each other, or lie round each
/// other: of all that do, the best one-to-one choice is joined. What sewing left of two borders is
/// joined with itself if it is at most one of its mean edges wide, and half its radius; wider it
/// may be a hole that the seam crosses.
/// Between pieces whose overlaps are trimmed, the gap is at most two and a half mean edges of the
/// coarsest wide, or four where a part would be left alone.
pub const GUSSET_GAP_AUTO: gusset_gap = 0;

/// Gaps are closed up to max_gap.
pub const GUSSET_GAP_GIVEN: gusset_gap = 1;

/// The treatment of pieces that overlap.
pub type gusset_overlaps = u32;
/// Pieces that overlap stay as they are.
pub const GUSSET_OVERLAPS_KEEP: gusset_overlaps = 0;

/// Of each overlap one piece is kept, as gusset_trim_create chooses, and the gaps that this leaves
/// are closed as others are. Strips that would cut other faces are left to the holes.
pub const GUSSET_OVERLAPS_TRIM: gusset_overlaps = 1;

/// Two loops of the input.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_loop_pair {
    /// The piece of each.
    pub piece: [u32; 2],
    /// A vertex of each piece that the loop passes; UINT32_MAX for all loops of the piece, in
    /// exclusions only.
    pub vertex: [u32; 2],
}

/// How pieces are joined; all zero is the default.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_join_options {
    /// sizeof(gusset_join_options), set by the caller.
    pub struct_size: usize,
    /// The treatment of coincident borders of pieces.
    pub weld: gusset_welding,
    /// GUSSET_ORIENTATION_FIX: within each component the minority of faces is turned over, and
    /// components that face each other are made to agree. GUSSET_ORIENTATION_KEEP: nothing is
    /// turned, nor in the end.
    pub orientation: gusset_orientation,
    /// The widest gap that is closed.
    pub gap: gusset_gap,
    /// 1: only whole loops are joined, no parts of them, nor what sewing left of two borders. 0 or
    /// 1.
    /// @flag
    pub whole_loops_only: u32,
    /// 1: loops of one component may be joined without being asked for. 0 or 1.
    /// @flag
    pub within_components: u32,
    /// 1: holes that are left in the end are filled. 0 or 1.
    /// @flag
    pub fill: u32,
    /// Read for GUSSET_GAP_GIVEN: the widest gap that is closed, in the unit of the positions,
    /// finite and at least 0; 0 leaves all open.
    /// @when gap GUSSET_GAP_GIVEN
    pub max_gap: f64,
    /// Pairs of loops to be joined however wide the gap is, as wholes, or NULL. Each names two
    /// different loops, or the same one twice if sewing left it of two borders (see gusset_joint),
    /// and none is named in two pairs. Errors name a pair by its number from 0, and say what is
    /// wrong with it.
    pub pairs: *const gusset_loop_pair,
    /// How many.
    pub pair_count: usize,
    /// Pairs that are not to be joined, or NULL. A pair that is given above is joined all the same,
    /// and a vertex that no loop passes, as it was welded, excludes nothing.
    pub excluded: *const gusset_loop_pair,
    /// How many.
    pub excluded_count: usize,
    /// How to weld; NULL for the defaults.
    pub weld_options: *const gusset_weld_options,
    /// The strips, NULL for the defaults: meridians, search, start, rows, row_count, cells,
    /// fairing, intersections and finish are read; the other fields must be valid too.
    pub strip_options: *const gusset_stitch_options,
    /// How to fill, NULL for the defaults. groups, outward and plan_only are not read, but the last
    /// two must be valid too; intersections REPORT is as IGNORE.
    pub fill_options: *const gusset_fill_options,
    /// The side that closed components of the result face; outwards by default. The wall of
    /// a cavity within another component is turned too. A result that is not turned is
    /// mostly as the first piece has it.
    pub outward: gusset_outward,
    /// GUSSET_OVERLAPS_KEEP or GUSSET_OVERLAPS_TRIM.
    pub overlaps: gusset_overlaps,
    /// Read for GUSSET_OVERLAPS_TRIM: how to trim; NULL for the defaults.
    /// @when overlaps GUSSET_OVERLAPS_TRIM
    pub trim_options: *const gusset_trim_options,
}

versioned! { gusset_join_options: 104 }
fixed! { gusset_loop_pair: 16 }

/// The caller's pairs.
pub(crate) fn pairs(
    data: *const gusset_loop_pair,
    count: usize,
    name: &'static str,
) -> Result<Vec<[Selector; 2]>, Failure> {
    Error::check_count(name, count as u64, MAX_ELEMENTS)?;
    let pair = |[p, q, v, w]: [u32; 4]| [Selector { piece: p, vertex: v }, Selector { piece: q, vertex: w }];
    Ok(alloc::collect(input::items(data.cast(), count, name)?.map(pair))?)
}

impl gusset_join_options {
    pub(crate) fn checked<'a>(
        &self,
        [pairs, excluded]: [&'a [[Selector; 2]]; 2],
        trim: gusset_trim_options,
        viewpoints: &'a [DVec3],
    ) -> Result<Options<'a>, Failure> {
        let weld = match self.weld {
            GUSSET_WELDING_SEW | GUSSET_WELDING_EDGE_TO_EDGE => {
                Some(input::nested(self.weld_options, "weld_options", gusset_weld_options::checked)?)
            }
            GUSSET_WELDING_NONE => None,
            other => return Err(Failure::unknown("weld", other.into())),
        };
        let keep_orientation = match self.orientation {
            GUSSET_ORIENTATION_FIX => false,
            GUSSET_ORIENTATION_KEEP => true,
            other => return Err(Failure::unknown("orientation", other.into())),
        };
        let max_gap = match self.gap {
            GUSSET_GAP_AUTO => MaxGap::Auto,
            GUSSET_GAP_GIVEN => MaxGap::Given(self.max_gap),
            other => return Err(Failure::unknown("gap", other.into())),
        };
        let overlaps = match self.overlaps {
            GUSSET_OVERLAPS_KEEP => Overlaps::Keep,
            GUSSET_OVERLAPS_TRIM => Overlaps::Trim(trim.checked(viewpoints)),
            other => return Err(Failure::unknown("overlaps", other.into())),
        };
        let fill = input::nested(self.fill_options, "fill_options", gusset_fill_options::checked)?;
        Ok(Options {
            overlaps,
            weld,
            edge_to_edge: self.weld == GUSSET_WELDING_EDGE_TO_EDGE,
            keep_orientation,
            outward: outward(self.outward, Outward::Closed)?,
            max_gap,
            whole_loops_only: flag(self.whole_loops_only, "whole_loops_only")?,
            within_components: flag(self.within_components, "within_components")?,
            pairs,
            excluded,
            strip: input::nested(self.strip_options, "strip_options", gusset_stitch_options::checked)?,
            fill: flag(self.fill, "fill")?.then_some(fill),
        })
    }
}
