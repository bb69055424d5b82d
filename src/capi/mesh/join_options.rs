//! Options of joining: Which borders are joined.

use crate::assemble::{Extent, MaxGap, Options, Overlaps, Selector};
use crate::capi::glue::{constants, fixed, versioned};
use crate::capi::input::{self, read_flag};
use crate::capi::mesh::fill::gusset_fill_options;
use crate::capi::mesh::stitch_options::{
    GUSSET_ORIENTATION_FIX, GUSSET_ORIENTATION_KEEP, gusset_orientation, gusset_outward, gusset_stitch_options,
    to_outward,
};
use crate::capi::mesh::trim::gusset_trim_options;
use crate::capi::mesh::weld::gusset_weld_options;
use crate::capi::status::Failure;
use crate::error::Error;
use crate::mesh::MAX_ELEMENTS;
use crate::repair::orient::Outward;
use glam::DVec3;
use gusset_base::alloc;

/// Treatment of coincident borders.
pub type gusset_welding = u32;
/// Sewn as by gusset_sew, with weld_options; edges are split where vertices do not match.
pub const GUSSET_WELDING_SEW: gusset_welding = 0;
/// Nothing is welded.
pub const GUSSET_WELDING_NONE: gusset_welding = 1;
/// Sewn where vertices match, as by gusset_weld.
pub const GUSSET_WELDING_EDGE_TO_EDGE: gusset_welding = 2;

/// Widest gap to close.
pub type gusset_gap = u32;
/// A gap's width is the larger mean distance from either loop to the other's nearest points.
/// - Whole loops: a fifth of the larger component's extent along an axis, or the smaller mean
///   radius (mean distance from the loop's centre) if more. Any gap between the only two loops, on
///   two pieces, unless they lie beside each other.
/// - Whole loops on two pieces that look at each other, with nobody else near: three times that.
///   Among the loops without a partner, each is nearest to three quarters of the other's vertices.
/// - Runs of loops: half the smaller mean radius, and at most 4 mean edges of the coarser loop.
/// - Slits: one mean edge, and half the mean radius unless the slit is narrow.
/// - Gaps between borders that share vertices: the longest edge.
/// - Whole loops that coincide in part: as whole loops, before they are sewn.
/// - Trimmed pieces: 2.5 mean edges of the coarsest, or 4 if a part would be left alone.
pub const GUSSET_GAP_AUTO: gusset_gap = 0;

/// max_gap.
pub const GUSSET_GAP_GIVEN: gusset_gap = 1;

/// Parts of loops that are joined.
pub type gusset_join_extent = u32;
/// Whole loops, and parts of the other loops.
pub const GUSSET_JOIN_LOOPS_AND_PARTS: gusset_join_extent = 0;
/// Whole loops only.
pub const GUSSET_JOIN_WHOLE_LOOPS: gusset_join_extent = 1;
/// Runs of loops and slits only: two sheets side by side never become a closed pocket.
pub const GUSSET_JOIN_PARTS: gusset_join_extent = 2;

/// Treatment of overlapping pieces.
pub type gusset_overlaps = u32;
/// Overlapping pieces stay unchanged.
pub const GUSSET_OVERLAPS_KEEP: gusset_overlaps = 0;

/// One piece of each overlap is kept, as by gusset_trim_create, and gaps are closed. Hole filling
/// replaces strips that would intersect other faces.
pub const GUSSET_OVERLAPS_TRIM: gusset_overlaps = 1;

/// Two loops of the pieces.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_loop_pair {
    /// Piece of each loop.
    pub piece: [u32; 2],
    /// Vertex of the piece on each loop; UINT32_MAX excludes all loops of the piece.
    pub vertex: [u32; 2],
}

/// Options of gusset_join.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_join_options {
    /// sizeof(gusset_join_options).
    pub struct_size: usize,
    /// Treatment of coincident borders.
    pub weld: gusset_welding,
    /// GUSSET_ORIENTATION_FIX reverses the minority of faces in each component, then components
    /// against those that they face. GUSSET_ORIENTATION_KEEP ignores outward and reverses nothing.
    /// @values GUSSET_ORIENTATION_FIX, GUSSET_ORIENTATION_KEEP
    pub orientation: gusset_orientation,
    /// Widest gap to close.
    pub gap: gusset_gap,
    /// Parts of loops that are joined.
    pub extent: gusset_join_extent,
    /// 1 also joins loops of one component that pairs does not name.
    /// @flag
    pub within_components: u32,
    /// 1 fills the remaining holes.
    /// @flag
    pub fill: u32,
    /// Widest gap to close; 0 closes none.
    /// @when gap GUSSET_GAP_GIVEN
    pub max_gap: f64,
    /// Pairs of whole loops to join at any distance, or NULL: two loops, or a slit twice (see
    /// gusset_joint). No loop is in two pairs.
    /// @shape pair_count
    pub pairs: *const gusset_loop_pair,
    /// Number of pairs.
    pub pair_count: usize,
    /// Pairs not to join, or NULL; pairs takes precedence. Vertices on no loop after welding
    /// exclude nothing.
    /// @shape excluded_count
    pub excluded: *const gusset_loop_pair,
    /// Number of excluded pairs.
    pub excluded_count: usize,
    /// Options of welding.
    pub weld_options: *const gusset_weld_options,
    /// Uses meridians, search, start, rows, row_count, cells, fairing, intersections and finish;
    /// all options must be valid.
    pub strip_options: *const gusset_stitch_options,
    /// Ignores groups, and outward and plan_only, which must be valid. With GUSSET_OVERLAPS_TRIM,
    /// GUSSET_KEEP_AUTO acts as GUSSET_KEEP_BORDERS.
    pub fill_options: *const gusset_fill_options,
    /// Open components mostly keep the first piece's orientation.
    pub outward: gusset_outward,
    /// Treatment of overlapping pieces.
    pub overlaps: gusset_overlaps,
    /// Options of trimming.
    /// @when overlaps GUSSET_OVERLAPS_TRIM
    pub trim_options: *const gusset_trim_options,
}

versioned! { gusset_join_options: 104 }
fixed! { gusset_loop_pair: 16 }

/// Reads the caller's pairs.
pub(crate) fn read_loop_pairs(
    data: *const gusset_loop_pair,
    count: usize,
    name: &'static str,
) -> Result<Vec<[Selector; 2]>, Failure> {
    Error::check_count(name, count as u64, MAX_ELEMENTS)?;
    let pair = |[p, q, v, w]: [u32; 4]| [Selector { piece: p, vertex: v }, Selector { piece: q, vertex: w }];
    Ok(alloc::collect(input::input_items(data.cast(), count, name)?.map(pair))?)
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
                Some(input::read_nested_or_default(self.weld_options, "weld_options", gusset_weld_options::checked)?)
            }
            GUSSET_WELDING_NONE => None,
            other => {
                return Err(Failure::unknown_choice(
                    "weld",
                    other,
                    &constants![GUSSET_WELDING_SEW, GUSSET_WELDING_EDGE_TO_EDGE, GUSSET_WELDING_NONE],
                ));
            }
        };
        let keep_orientation = match self.orientation {
            GUSSET_ORIENTATION_FIX => false,
            GUSSET_ORIENTATION_KEEP => true,
            other => {
                return Err(Failure::unknown_choice(
                    "orientation",
                    other,
                    &constants![GUSSET_ORIENTATION_FIX, GUSSET_ORIENTATION_KEEP],
                ));
            }
        };
        let max_gap = match self.gap {
            GUSSET_GAP_AUTO => MaxGap::Auto,
            GUSSET_GAP_GIVEN => MaxGap::Given(self.max_gap),
            other => return Err(Failure::unknown_choice("gap", other, &constants![GUSSET_GAP_AUTO, GUSSET_GAP_GIVEN])),
        };
        let extent = match self.extent {
            GUSSET_JOIN_LOOPS_AND_PARTS => Extent::LoopsAndParts,
            GUSSET_JOIN_WHOLE_LOOPS => Extent::WholeLoops,
            GUSSET_JOIN_PARTS => Extent::Parts,
            other => {
                return Err(Failure::unknown_choice(
                    "extent",
                    other,
                    &constants![GUSSET_JOIN_LOOPS_AND_PARTS, GUSSET_JOIN_WHOLE_LOOPS, GUSSET_JOIN_PARTS],
                ));
            }
        };
        let overlaps = match self.overlaps {
            GUSSET_OVERLAPS_KEEP => Overlaps::Keep,
            GUSSET_OVERLAPS_TRIM => Overlaps::Trim(trim.checked(viewpoints)),
            other => {
                return Err(Failure::unknown_choice(
                    "overlaps",
                    other,
                    &constants![GUSSET_OVERLAPS_KEEP, GUSSET_OVERLAPS_TRIM],
                ));
            }
        };
        let fill = input::read_nested_or_default(self.fill_options, "fill_options", gusset_fill_options::checked)?;
        Ok(Options {
            overlaps,
            weld,
            edge_to_edge: self.weld == GUSSET_WELDING_EDGE_TO_EDGE,
            keep_orientation,
            outward: to_outward(self.outward, Outward::Closed)?,
            max_gap,
            extent,
            within_components: read_flag(self.within_components, "within_components")?,
            pairs,
            excluded,
            strip: input::read_nested_or_default(self.strip_options, "strip_options", gusset_stitch_options::checked)?,
            fill: read_flag(self.fill, "fill")?.then_some(fill),
        })
    }
}
