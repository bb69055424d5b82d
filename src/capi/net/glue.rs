//! Gluing of nodes: Glues and unglues nodes, and classifies the 18 local gluings.

use crate::capi::context::{guard_change, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::input::{self, flag};
use crate::capi::net::gluing::{gusset_seam, seam};
use crate::capi::net::{edit, gusset_net, read};
use crate::capi::status::{Failure, gusset_status};
use crate::error::Error;
use crate::net::MAX_NODES;
use crate::net::glue::{self, GlueOptions, reglued};
use crate::net::topology::{CellDiagonal, Gluing, GluingType};
use gusset_base::alloc;

/// What a gusset_gluing glues.
pub type gusset_gluing_kind = u32;
/// The two ends of link `element`. Links are numbered by nodes: 2 * node is that to the next node
/// of the row (of the last one to the first), 2 * node + 1 that to the next of the column; node (i,
/// j) is i * columns + j.
pub const GUSSET_GLUING_LINK: gusset_gluing_kind = 0;
/// Node `element` and its neighbours in the directions of the mask: east 1, south 2, west 4, north
/// 8, round the sides of the net.
pub const GUSSET_GLUING_STAR: gusset_gluing_kind = 1;
/// The ends of the links of cell `element` that are in the mask: top 1, right 2, bottom 4, left 8.
/// Cell (i, j) is i * (columns - 1) + j.
pub const GUSSET_GLUING_CELL: gusset_gluing_kind = 2;
/// Opposite corners of cell `element`: mask 1 for the first and the third, 2 for the second and the
/// fourth.
pub const GUSSET_GLUING_DIAGONAL: gusset_gluing_kind = 3;
/// The two runs of nodes of the seam.
pub const GUSSET_GLUING_SEAM: gusset_gluing_kind = 4;
/// The local gluing of type `mask`, one of GUSSET_TYPE_..., at node `element`; at cell `element`
/// from GUSSET_TYPE_TOP_BOTTOM on.
pub const GUSSET_GLUING_TYPE: gusset_gluing_kind = 5;

/// Nodes to be glued, or no longer to be.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_gluing {
    /// What a gusset_gluing glues.
    pub kind: gusset_gluing_kind,
    /// The link, node or cell; 0 for a seam.
    pub element: u32,
    /// See the kinds; 0 where none is said to have one.
    pub mask: u32,
    /// 0.
    pub reserved: u32,
    /// Read for GUSSET_GLUING_SEAM only.
    pub seam: gusset_seam,
}

const _: () = assert!(size_of::<gusset_gluing>() == 56);

/// One of the 18 local gluings (the paper's Fig. 4), or GUSSET_TYPE_NONE.
pub type gusset_gluing_type = u32;
/// Nothing is glued here.
pub const GUSSET_TYPE_NONE: gusset_gluing_type = 0xffff_ffff;
/// n(1): one horizontal link.
pub const GUSSET_TYPE_HORIZONTAL: gusset_gluing_type = 0;
/// n(1): one vertical link.
pub const GUSSET_TYPE_VERTICAL: gusset_gluing_type = 1;
/// n(2,1): the links of a node to the east and the south.
pub const GUSSET_TYPE_EAST_SOUTH: gusset_gluing_type = 2;
/// n(2,1): south and west.
pub const GUSSET_TYPE_SOUTH_WEST: gusset_gluing_type = 3;
/// n(2,1): west and north.
pub const GUSSET_TYPE_WEST_NORTH: gusset_gluing_type = 4;
/// n(2,1): north and east.
pub const GUSSET_TYPE_NORTH_EAST: gusset_gluing_type = 5;
/// n(2,2): east and west.
pub const GUSSET_TYPE_EAST_WEST: gusset_gluing_type = 6;
/// n(2,2): north and south.
pub const GUSSET_TYPE_NORTH_SOUTH: gusset_gluing_type = 7;
/// n(3): all but north.
pub const GUSSET_TYPE_BUT_NORTH: gusset_gluing_type = 8;
/// n(3): all but east.
pub const GUSSET_TYPE_BUT_EAST: gusset_gluing_type = 9;
/// n(3): all but south.
pub const GUSSET_TYPE_BUT_SOUTH: gusset_gluing_type = 10;
/// n(3): all but west.
pub const GUSSET_TYPE_BUT_WEST: gusset_gluing_type = 11;
/// n(4): all four links of a node.
pub const GUSSET_TYPE_ALL: gusset_gluing_type = 12;
/// c(2,1): top and bottom of a cell.
pub const GUSSET_TYPE_TOP_BOTTOM: gusset_gluing_type = 13;
/// c(2,1): right and left of a cell.
pub const GUSSET_TYPE_RIGHT_LEFT: gusset_gluing_type = 14;
/// c(3): a cell is one point.
pub const GUSSET_TYPE_POINT: gusset_gluing_type = 15;
/// c(1,2): the first and the third corner of a cell.
pub const GUSSET_TYPE_FALLING: gusset_gluing_type = 16;
/// c(1,2): the second and the fourth corner of a cell.
pub const GUSSET_TYPE_RISING: gusset_gluing_type = 17;

impl gusset_gluing {
    fn checked(self) -> Result<Gluing, Failure> {
        let has_mask = !matches!(self.kind, GUSSET_GLUING_LINK | GUSSET_GLUING_SEAM);
        if self.reserved != 0 || (!has_mask && self.mask != 0) {
            let (name, value) = if self.reserved != 0 { ("reserved", self.reserved) } else { ("mask", self.mask) };
            return Err(Failure::unknown(name, value.into()));
        }
        let unknown = || Failure::unknown("mask", self.mask.into());
        let mask = u8::try_from(self.mask).map_err(|_| unknown())?;
        Ok(match self.kind {
            GUSSET_GLUING_LINK => Gluing::Link(self.element),
            GUSSET_GLUING_STAR => Gluing::Star { node: self.element, mask },
            GUSSET_GLUING_CELL => Gluing::Cell { cell: self.element, mask },
            GUSSET_GLUING_DIAGONAL => {
                let diagonal =
                    [CellDiagonal::Falling, CellDiagonal::Rising].get(usize::from(mask).wrapping_sub(1)).copied();
                Gluing::CellDiagonal { cell: self.element, diagonal: diagonal.ok_or_else(unknown)? }
            }
            GUSSET_GLUING_SEAM => Gluing::Seam(seam(&self.seam)?),
            GUSSET_GLUING_TYPE => {
                Gluing::of_type(GluingType::from_number(self.mask).ok_or_else(unknown)?, self.element)
            }
            other => return Err(Failure::unknown("kind", other.into())),
        })
    }
}

/// The caller's, at any alignment.
fn gluings(data: *const gusset_gluing, count: usize) -> Result<Vec<Gluing>, Failure> {
    Error::check_count("gluings", count as u64, MAX_NODES)?;
    let given = input::items(data, count, "gluings")?.enumerate();
    alloc::try_collect(given.map(|(k, gluing)| gluing.checked().map_err(|failure| failure.of_item(k))))
}

/// How a net is glued. The steps are taken in the order of the fields; all zeros: none.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_glue_options {
    /// sizeof(gusset_glue_options), set by the caller.
    pub struct_size: usize,
    /// Read if `detect` is 1: the largest distance of nodes that lie together, at least 0 and finite,
    /// in the unit of the coordinates.
    pub tolerance: f64,
    /// Pairs of nodes that are glued, at any alignment.
    pub gluings: *const gusset_gluing,
    /// The number of gluings.
    pub gluing_count: usize,
    /// Links that are contracted, such as those of gusset_net_analysis_view; numbered as for
    /// GUSSET_GLUING_LINK, at any alignment.
    pub links: *const u32,
    /// The number of links.
    pub link_count: usize,
    /// 1: what coordinates tell replaces what was glued, before anything else. Neighbours that lie
    /// together are glued, and runs of two and more nodes of the sides that do, forwards or
    /// backwards. The orientation of faces stays. 0 or 1.
    /// @flag
    pub detect: u32,
    /// 1: every link whose ends are one point already, by way of others, is contracted, and seams
    /// that links then say are dropped. Nets that glue the same neighbours have the same matrix in
    /// this canonical form, which `detect` gives too. 0 or 1.
    /// @flag
    pub saturate: u32,
    /// 1: all nodes that are glued to each other get the position of the first of them, bit for bit.
    /// 0: positions stay.
    /// @flag
    pub snap: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_glue_options: 64 reserved }

/// Glues nodes of a net, and gives glued nodes one position.
///
/// The options are done as a whole or not at all: on failure the net is as it was.
///
/// @param options what is glued.
/// @param moved receives the number of nodes that got other bits; NULL if it is not wanted.
/// @errors UNKNOWN_VALUE (kind, mask, reserved, a flag), OUT_OF_RANGE (tolerance, a mask above 15),
///     NO_SUCH_ELEMENT (the link, node or cell), BAD_SEAM (its place among the gluings),
///     CROSSING_CELL (with the cell (both pairs of opposite corners would be glued: the nineteenth
///     local gluing, which no surface allows)), TOO_LARGE
/// @complexity O(nodes + glued pairs), and a sort of the nodes of the sides for `detect`. For
///     `snap` alone O(rows + columns) if the net is glued along its sides alone, else O(nodes).
/// @source Deryagin, "Local gluings of nodes".
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_glue(
    context: *const gusset_context,
    net: *mut gusset_net,
    options: *const gusset_glue_options,
    moved: *mut u64,
) -> gusset_status {
    let moved = input::optional_output(moved, 0, "moved");
    guard_change(context, |job| {
        let (moved, options) = (moved?, input::read(options, false, "options")?);
        let detect = flag(options.detect, "detect")?.then_some(options.tolerance);
        let (saturate, snap) = (flag(options.saturate, "saturate")?, flag(options.snap, "snap")?);
        let gluings = gluings(options.gluings, options.gluing_count)?;
        Error::check_count("links", options.link_count as u64, 2 * MAX_NODES)?;
        let links = input::list(options.links, options.link_count, "links")?;
        let topology = reglued(read(net)?, &GlueOptions { detect, gluings: &gluings, links: &links, saturate }, job)?;
        input::set(moved, glue::reglue(edit(net, job)?, topology, snap, job)?);
        Ok(())
    })
}

/// Unglues pairs of nodes: their links are free, and seams that have them are cut there.
///
/// Nodes that are still glued by way of others stay one point; pairs that are not glued are left
/// alone.
///
/// On failure the net is as it was.
///
/// @param gluings count of them, done as a whole or not at all; at any alignment.
/// @param count see gluings.
/// @param separation 0, or how far apart what becomes separate is moved, in the unit of the
///     coordinates: each piece of a point that falls apart moves by half of it towards the mean of
///     its neighbours (of those that do not fall apart themselves, if there are any); one without
///     neighbours, or in the middle of them, stays.
/// @param moved receives the number of pieces that moved; NULL if it is not wanted.
/// @errors as gusset_net_glue, OUT_OF_RANGE (a separation that is no finite number from 0 on)
/// @complexity O(nodes), and a sort of the pairs.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_unglue(
    context: *const gusset_context,
    net: *mut gusset_net,
    gluings: *const gusset_gluing,
    count: usize,
    separation: f64,
    moved: *mut u64,
) -> gusset_status {
    let moved = input::optional_output(moved, 0, "moved");
    guard_change(context, |job| {
        let (moved, gluings) = (moved?, self::gluings(gluings, count)?);
        input::set(moved, edit(net, job)?.unglue(&gluings, separation)? as u64);
        Ok(())
    })
}
